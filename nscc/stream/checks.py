"""Consistency checks between the passes for chips without logic."""

from __future__ import annotations

from math import inf

import numpy as np

from nscc.checks import require
from nscc.stream.passes import Sending

_ROUNDING = 1e-9
"""Relative tolerance for times, which are sums of decimal fractions."""


def check_route(sending: Sending) -> None:
    """Check that in every slot the light of each code goes to the tap of the open bucket.

    Tap b belongs to bucket b. If no bucket is open, the light must go to the drain or to a tap
    without a bucket. Raises Inconsistent, which is a fault of nscc."""
    route, shutters = sending.route, sending.program.table.shutters
    destinations = np.where(route.bits, route.ones, route.zeros)[:, None]
    collected = destinations == np.arange(shutters.shape[1])[:, None]
    require(np.array_equal(collected, shutters), "light goes to the tap of another bucket")


def check_loadings(sending: Sending) -> None:
    """Check that every bit plane is loaded before it takes effect, in its own slot, and before the
    next plane loads. There must be one loading for each slot.

    Raises Inconsistent, which is a fault of nscc; a program whose slots are too short must have
    been refused before."""
    load_us, begin_us = sending.program.target.plane_load_us, 0.0
    ended_us = -inf
    for slot_us, loading in zip(sending.program.frame.slot_us, sending.loadings, strict=True):
        slack = _ROUNDING * max(1.0, begin_us + slot_us)
        require(loading.load_us >= ended_us - slack, "two planes are loaded at once")
        ended_us = loading.load_us + load_us
        require(ended_us <= loading.acts_us + slack, "a plane acts before it is loaded")
        require(begin_us <= loading.acts_us + slack, "a plane acts in an earlier slot")
        begin_us += slot_us
        require(loading.acts_us < begin_us, "a plane acts after its slot")
