"""Names of initial codes and of training methods for codes, without torch."""

from __future__ import annotations

import numpy as np

ORDERED = ("two-phase", "staggered", "cyclic")
"""Names of initial codes with staggered bumps (`nscc_training.encoders.encoder_classes`)."""
SCATTERED = ("poisson-disc", "non-adjacent")
"""Names of initial codes in which equal exposure times are far apart
(`nscc_training.encoders.scattered`)."""
RANKS = np.array([[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]])
"""Bayer matrix: the order of 4 x 4 places."""
STARTS = ("random", "uniform", "quad", *ORDERED, *SCATTERED)

SLOPED = ("straight-through", "sigmoid", "gumbel")
"""Relaxations that pass gradients through the quantisation."""

RELAXATIONS = (*SLOPED, "tried", "search")
"""Methods by which codes are learned.

`straight-through` uses hard shutters in the forward pass and a surrogate slope in the backward
pass. `sigmoid` uses soft shutters in the forward pass, with a temperature that a schedule lowers.
`gumbel` (codebooks; `sigmoid` for other classes) uses soft shapes and a random soft choice of them.
`tried` uses hard shutters without a gradient; the loop tries other codes around them
(`nscc_training.loop.step_loss`). `search` moves many places of a code together; the decoder, which
is not trained meanwhile, compares the results (`nscc_training.loop.searching`)."""
