"""Mean charge of the stretches of pixels that run through their words, against sums by numpy."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from plan_cases import case
from reference_programs import sensor_of

from nscc_runtime.effects import everything
from nscc_runtime.effects.crosstalk import smeared
from nscc_runtime.execution.block_scene import prepare_pixels
from nscc_runtime.light import DrawnFrames, Light

SLOTS, ROWS, COLS, DEVICE = 8, 70, 40, 5


def lights() -> dict[str, Light]:
    """Light of every kind: it differs from slot to slot, in one frame or several, or does not; with
    frames that are drawn, and pixels that are NaN in one slot or all."""
    frames = np.random.default_rng(3).exponential(200.0, (SLOTS, ROWS, COLS)).astype(np.float32)
    frames[:, 9, 9] = frames[5, 30, 7] = np.nan
    clip = Light.of_clip(frames)
    drawn = DrawnFrames(frames.shape, lambda numbers, rows: frames[list(numbers), rows])
    # Three frames: slots 2 and 5 contain the end of one and the beginning of the next.
    starts = np.array([0, 1, 2, 4, 5, 6, 8, 9, 10])
    index = np.array([0, 0, 0, 1, 1, 1, 1, 2, 2, 2], np.int32)
    weight = np.array([1.0, 1.0, 0.7, 0.3, 1.0, 1.0, 0.4, 0.6, 1.0, 1.0])
    return {
        "clip": clip,
        "drawn": Light(drawn, clip.row_start, clip.frame_index, clip.weight, "clip"),
        "video": Light(frames[:3], starts, index, weight, "clip"),
        "still": Light.of_still(frames[5], np.full(SLOTS, 1.5)),
        "unlike slots": Light.of_still(frames[5], np.linspace(0.5, 1.5, SLOTS)),
    }


@pytest.mark.parametrize("threads", [1, 3])
@pytest.mark.parametrize("fraction", [0.0, 0.005, 0.1])
@pytest.mark.parametrize("name", ["b edges", "c accumulate", "codebook", "two buckets"])
@pytest.mark.parametrize("kind", lights())
def test_means_of_stretches_are_sums_of_slots_after_crosstalk(
    kind: str, name: str, fraction: float, threads: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("nscc_runtime.light._STRIP_BYTES", 1)  # drawn frames: strips of 64 rows
    container, light = case(name, SLOTS, rows=ROWS, cols=COLS), lights()[kind]
    sensor = sensor_of(container, crosstalk_fraction=fraction)
    chip = container, sensor, light, everything()
    every = np.arange(ROWS * COLS)
    (whole,) = prepare_pixels(*chip, every, DEVICE).kept
    factor, dark_e_per_s = np.empty((2, ROWS * COLS))
    factor[whole.sites.place] = whole.sites.factor
    dark_e_per_s[whole.sites.place] = whole.sites.dark_e_per_s
    some = np.flatnonzero(np.random.default_rng(1).random(len(every)) < 0.3)
    for places in (every, some):
        scene = prepare_pixels(*chip, places, DEVICE, threads)
        (charge,) = scene.kept
        is_nan = np.isnan(light.dense()).any(axis=0).reshape(-1)
        assert set(charge.number[charge.invalid]) == set(np.flatnonzero(is_nan[places]))
        stretches, sites = scene.program.stretches, charge.sites
        slot_s = np.diff(stretches.start_s)
        lit_e = np.nan_to_num(light.dense().reshape(SLOTS, -1) * factor)
        dark_e = slot_s[:, None] * dark_e_per_s
        slots_e = smeared((lit_e + dark_e).reshape(SLOTS, ROWS, COLS), fraction).reshape(SLOTS, -1)
        valid = ~is_nan[sites.place]
        own = valid & (np.arange(len(valid)) < charge.pixels)
        for lanes, chosen in ((sites.counted, valid), (sites.lane, own)):
            for lane in np.unique(lanes[chosen]):
                i = np.flatnonzero(chosen & (lanes == lane))
                bounds = stretches.boundary[stretches.start[lane] : stretches.start[lane + 1]]
                for e, (begin, end) in enumerate(pairwise(bounds)):
                    part = slice(begin, end), sites.place[i]
                    if chosen is valid:
                        np.testing.assert_allclose(charge.means.lit[e, i], lit_e[part].sum(axis=0))
                        wanted_e = dark_e[part].sum(axis=0)
                        np.testing.assert_allclose(charge.means.dark[e, i], wanted_e)
                        continue
                    wanted_e = slots_e[part].sum(axis=0)
                    np.testing.assert_allclose(charge.means.charge[e, i], wanted_e)
                    # The last row is for the words after the last slot.
                    for row, n in ((e, begin), (e + 1, SLOTS - 1))[: 1 + (end == SLOTS)]:
                        pace = slots_e[n, sites.place[i]] / wanted_e / slot_s[n] * 1e-6
                        np.testing.assert_allclose(charge.means.pace[row, i], pace)
