"""Names of the starts of codes and of the ways to learn them, without torch."""

from __future__ import annotations

ORDERED = ("two-phase", "staggered", "cyclic")
"""Starts of staggered bumps (`nscc_training.encoders.ordered`)."""
SCATTERED = ("poisson-disc", "non-adjacent")
"""Starts with equal exposures kept apart (`nscc_training.encoders.scattered`)."""
STARTS = ("random", "uniform", "quad", *ORDERED, *SCATTERED)

SLOPED = ("straight-through", "sigmoid", "gumbel")
"""Relaxations that pass gradients through the quantisation."""

RELAXATIONS = (*SLOPED, "tried", "search")
"""How codes are learned.

`straight-through`: hard shutters forward, a surrogate slope backward. `sigmoid`: soft shutters
forward, with a temperature that a schedule lowers. `gumbel` (codebooks; elsewhere as `sigmoid`):
soft shapes and a random soft choice of them. `tried`: hard shutters without a gradient; the loop
tries others around them (`nscc_training.loop.trials`). `search`: many places of a code move
together, and the decoder, which is not trained meanwhile, judges the result
(`nscc_training.loop.searching`).
"""
