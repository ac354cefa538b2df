"""What a tile of codes may begin with and how it may be learned: names, without torch."""

from __future__ import annotations

ORDERED = ("two-phase", "staggered", "cyclic")
"""Bumps that begin one after the other (`nscc_training.encoders.ordered`)."""
SCATTERED = ("poisson-disc", "non-adjacent")
"""Exposures that keep away from their like (`nscc_training.encoders.scattered`)."""
STARTS = ("random", "uniform", "quad", *ORDERED, *SCATTERED)

SLOPED = ("straight-through", "sigmoid", "gumbel")
"""Ways for gradients to get past the quantisation."""

RELAXATIONS = (*SLOPED, "tried", "search")
"""How codes are learned.

`straight-through`: hard shutters forward, a stand-in slope backward. `sigmoid`: soft shutters
forward, whose temperature a schedule takes down. `gumbel` (codebooks; elsewhere as `sigmoid`): soft
shapes and a random soft choice of them. `tried`: hard shutters without any gradient; the loop tries
others around them (`nscc_training.loop.trials`). `search`: whole codes with many places moved
together, judged by the decoder, which does not learn meanwhile (`nscc_training.loop.searching`).
"""
