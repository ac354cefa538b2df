"""The short cuts that plans take with effects that are kept, in the words in which they say so."""

from __future__ import annotations

THINNING = "counts are not spread over the slots of a group"
FORMULA = "counts from a rate of 10 on by formula"
FORMULA_E = 0.015
"""RMS of counts by formula against exact ones: one electron in some five thousand pixels."""
NEIGHBOURS = "neighbours' counts are taken as even over their slots"
BESIDE_NEAR = f"{NEIGHBOURS} by pixels near saturation"
"""Where sums have no neighbours."""
PARTS = "counts are even in slots that pixels near saturation see a part of, and in their levels"
NOISE = "the noise of words as at the mean leakage"
LEAK = "leakage from sums at {rates}"

UNDRAWN = (THINNING, NEIGHBOURS, BESIDE_NEAR, NOISE)
"""Those whose squares are variance that is not drawn."""
