"""Hard case 17: 4096 codes of 255 do not fit 16 bits: integers are summed in more."""

from __future__ import annotations

from pathlib import Path
from statistics import variance

import numpy as np
import pytest
from one_scene import load_scene
from reference_programs import LOWERINGS, program

from nscc_runtime import capture
from nscc_runtime.calibrate import Stack
from nscc_runtime.calibrate.levels import level_of
from nscc_runtime.emulator import expose
from nscc_runtime.light import Light
from nscc_runtime.scenes.exposure import ExposureLevel

SLOTS = 4096
TEXT = f"nsl 1\nframe {SLOTS} slots of 100us\nopen when n < {SLOTS}\n"


def loaded(path: Path, exposure: ExposureLevel | None = None) -> Light:
    return load_scene(
        str(path), slot_us=(100.0,) * SLOTS, rows=1, cols=3, exposure=exposure, transfer="linear"
    )


def test_case_17_sums_in_16_bits_would_overflow() -> None:
    assert np.full(SLOTS, 255, np.uint16).sum(dtype=np.uint16) != SLOTS * 255


@pytest.mark.parametrize("dtype", [np.uint8, np.int16, np.uint16, np.int64, np.uint64])
@pytest.mark.parametrize("ending", [".npz", ".npy", ".mat"])
def test_case_17_light_of_integers_never_overflows(
    dtype: type, ending: str, tmp_path: Path
) -> None:
    from scipy.io import savemat

    values, path = np.full((SLOTS, 1, 3), 255, dtype), tmp_path / f"light{ending}"
    match ending:
        case ".npz":
            np.savez(path, light=values)
        case ".npy":
            np.save(path, values)
        case ".mat":
            savemat(path, {"light": values})
    light = loaded(path)
    np.testing.assert_array_equal(light.total_e(), SLOTS * 255)
    for lowering in LOWERINGS:
        found = expose(program(TEXT, lowering, 1, 3), light).exposure_e
        np.testing.assert_array_equal(np.rint(found), SLOTS * 255)
        np.testing.assert_allclose(found, SLOTS * 255, rtol=1e-12)


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
def test_case_17_scaling_a_clip_of_integers_never_overflows(dtype: type, tmp_path: Path) -> None:
    from scipy.io import savemat

    top = np.iinfo(dtype).max
    clip = np.full((1, 3, SLOTS), top, dtype)
    clip[0, 1] = top // 2
    savemat(tmp_path / "clip.mat", {"orig": clip})
    light = loaded(tmp_path / "clip.mat", ExposureLevel(1e6, 100.0))
    np.testing.assert_allclose(light.total_e(), [[1e6, 1e6 * (top // 2) / top, 1e6]], rtol=1e-6)


def test_case_17_sums_of_calibration_frames_never_overflow() -> None:
    codes = np.random.default_rng(1).integers(253, 256, (SLOTS, 8, 8)).astype(np.uint16)
    codes[:, 1, 1] -= 250
    level = level_of(Stack("flat", codes, np.ones((8, 8), bool)), 255)
    sums = [[sum(codes[:, y, x].tolist()) for x in range(8)] for y in range(8)]
    assert max(map(max, sums)) > 2**16 > sums[1][1]
    np.testing.assert_allclose(level.mean_map * SLOTS, sums, rtol=1e-12)
    assert level.at_top[0, 0] == codes[:, 0, 0].tolist().count(255)
    expected = [[variance(codes[:, y, x].tolist()) for x in range(8)] for y in range(8)]
    np.testing.assert_allclose(level.variance, expected, rtol=0.1)


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.int64])
def test_case_17_planned_frames_of_integers_are_exact(dtype: type) -> None:
    values = np.full((SLOTS, 1, 3), 255, dtype)
    found = capture(program(TEXT, "edges", 1, 3), values, effects="none")
    np.testing.assert_array_equal(found.exposure_e, SLOTS * 255)


@pytest.mark.parametrize("seed", range(6))
def test_case_17_sums_of_whole_electrons_are_right_to_1e_15(seed: int) -> None:
    rng = np.random.default_rng(seed)
    slots = int(rng.integers(2, 200))
    light = rng.integers(0, int(rng.choice([9, 300, 60_000])), (slots, 3, 5))
    stop = int(rng.integers(1, slots + 1))
    text = f"nsl 1\nframe {slots} slots of 100us\nopen when n < {stop}\n"
    exact = np.array([[sum(light[:stop, y, x].tolist()) for x in range(5)] for y in range(3)])
    for lowering in LOWERINGS:
        scene = Light.of_clip(light.astype(np.float32))
        found = expose(program(text, lowering, 3, 5), scene).exposure_e[0]
        assert (np.abs(found - exact) <= 1e-15 * light.sum(axis=0)).all()
