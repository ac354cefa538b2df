"""Plans of programs whose states go on from frame to frame: the promise is for every frame."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import nscc
import nscc_runtime
from nscc.chips.load import builtin_target
from nscc_runtime import capture

_SIDE, _FRAMES = 48, 5
_TEXT = """nsl 2
frame 16 slots of 500us
sense full when exposure > 80% at n == N
sense dim when exposure < 30% at n == N
state stop : 0..4 = 4 kept
state was : 0..4 = 4
next stop = max(stop - 1, 0) if full else min(stop + 1, 4) if dim else stop
next was = stop
open when n < 1 << stop
read was, stop
"""
_CLOSING = """nsl 2
frame 40 slots of 500us
sense bright when light > 30% at n % 5 == 0
state closed_at : 0..8 = 0
next closed_at = looks when bright and closed_at == 0
open when closed_at == 0
read closed_at
"""


@pytest.mark.parametrize("frame_e", [30000.0, 60000.0, 240000.0])
def test_errors_of_later_frames_with_other_states_stay_within_the_tolerance(frame_e: float) -> None:
    # The first frame is full, so that little decides on it; the next ones are open for less.
    program = nscc.compile(_TEXT, target=replace(builtin_target("scamp5"), rows=_SIDE, cols=_SIDE))
    light = np.full((program.slots, _SIDE, _SIDE), frame_e / program.slots)
    given = {"seed": 5, "device_seed": 3, "repeat": _FRAMES}
    planned = capture(program, light, effects="auto", tolerance="5e", **given)
    exact = capture(program, light, effects="all", **given)
    same = np.ones((_FRAMES, _SIDE, _SIDE), np.bool_)
    for name in ("states_stop", "states_was"):
        same &= planned.told[name] == exact.told[name]
    assert same.mean() > 0.99
    square = np.where(same[:, None], (planned.exposure_e - exact.exposure_e) ** 2, 0.0)
    # The tolerance of 5 electrons, with the slack of an audit.
    assert np.sqrt(square.mean(axis=(1, 2, 3))).max() <= 1.1 * 5.0


@pytest.mark.parametrize("scene", range(4))
def test_at_most_allows_for_frames_that_were_not_measured(scene: int) -> None:
    """The plan was measured on other frames than these 24. Their error stays below `bound_e`,
    counted where pixels close at the same slot."""
    program = nscc.compile(_CLOSING, target=replace(builtin_target("scamp5"), rows=50, cols=4))
    total = np.random.default_rng(scene).lognormal(7.0, 2.5, (50, 4))
    light = np.full((program.slots, 1, 1), 1.0 / program.slots) * total
    given = {"seed": scene, "device_seed": 3, "repeat": 24}
    made = nscc_runtime.plan(program, light, tolerance="0.5e", device_seed=3)
    planned = capture(program, light, plan=made, **given)
    exact = capture(program, light, effects="all", **given)
    same = planned.told["states_closed_at"] == exact.told["states_closed_at"]
    square = np.where(same[:, None], (planned.exposure_e - exact.exposure_e) ** 2, 0.0)
    assert np.sqrt(square.mean()) <= planned.plan.bound_e + 1e-9  # rounding
