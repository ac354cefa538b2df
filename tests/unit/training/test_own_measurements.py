"""Measurements of other cameras: files of every version, axes either way, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke

from nscc.diagnostics.diagnostic import Rejected
from nscc_training.reconstruct_any import (
    NoiseModel,
    is_measurement,
    read_measurement,
    reconstruct_measurement,
)

pytest.importorskip("torch")
RNG = np.random.default_rng(0)
ROWS, COLS, SLOTS = 24, 32, 4


def clip_of(count: int = 1) -> np.ndarray:
    """A disk that moves over a gradient, (count * slots, rows, cols), 0..255."""
    row, col = np.mgrid[:ROWS, :COLS]
    frames = []
    for k in range(count * SLOTS):
        disk = np.hypot(row - 12, col - 8 - 2 * k) < 6
        frames.append(40 + 3.0 * col + 100 * disk)
    return np.stack(frames)


MASK = (RNG.random((SLOTS, ROWS, COLS)) < 0.5).astype(float)


def measured(clip: np.ndarray, mask: np.ndarray = MASK) -> np.ndarray:
    """(K, rows, cols)."""
    return (clip.reshape(-1, SLOTS, ROWS, COLS) * mask).sum(axis=1)


def write_v73(path: Path, user_block: int, **arrays: np.ndarray) -> None:
    """As MATLAB does: axes the other way round, a header before the HDF5 file."""
    import h5py

    with h5py.File(path, "w", userblock_size=user_block) as file:
        for name, values in arrays.items():
            file[name] = values.T
            file[name].attrs["MATLAB_class"] = b"double"
        file.create_group("#refs#")


@pytest.mark.parametrize("kind", ["v5.mat", "v73.mat", "bare.mat", "a.npz", "pair.npy"])
@pytest.mark.parametrize("count", [1, 3])
@pytest.mark.parametrize("last", [True, False])
def test_measurements_of_every_format_and_axis_order_are_read(
    tmp_path: Path, kind: str, count: int, last: bool
) -> None:
    from scipy.io import savemat

    truth = measured(clip_of(count))
    mask = np.moveaxis(MASK, 0, 2) if last else MASK
    meas = truth[0] if count == 1 else np.moveaxis(truth, 0, 2) if last else truth
    path, other = tmp_path / kind, None
    if kind == "v5.mat":
        savemat(path, {"mask": mask, "meas": meas})
    elif path.suffix == ".mat":
        write_v73(path, 512 if kind == "v73.mat" else 0, mask=mask, meas=meas)
    elif path.suffix == ".npz":
        np.savez(path, mask=mask.astype(np.float16), meas=meas)
    else:
        other = tmp_path / "m.npy"
        np.save(path, meas)
        np.save(other, mask.astype(bool))
    assert is_measurement(path, other)
    found = read_measurement(path, other)
    np.testing.assert_allclose(found.values, truth)
    np.testing.assert_array_equal(found.mask, MASK)
    assert f"{ROWS} x {COLS} pixels, {SLOTS} slots" in found.axes


def test_fractional_masks_reconstruct_the_clip() -> None:
    """Far better than a still of what each pixel says, whatever the unit; that is kept."""
    from nscc_training.reconstruct_any import Measurement

    truth, mask = clip_of(2), RNG.random((SLOTS, ROWS, COLS))
    for unit in (1.0, 1e-3):
        values = measured(truth * unit, mask)
        found = reconstruct_measurement(Measurement(values, mask, ""), NoiseModel()).light / unit
        assert found.shape == truth.shape
        still = np.repeat(values / unit / mask.sum(axis=0), SLOTS, axis=0)
        assert 4 * np.mean((found - truth) ** 2) < np.mean((still - truth) ** 2)
        assert np.abs(measured(found, mask) - values / unit).mean() < 2


@pytest.mark.parametrize("scale", [0.5, 2.0**-14])
def test_a_dim_mask_gives_the_same_clip(scale: float) -> None:
    from nscc_training.reconstruct_any import Measurement

    found = [
        reconstruct_measurement(
            Measurement(measured(clip_of()) * share, MASK * share, ""), NoiseModel(3.0 * share)
        )
        for share in (1.0, scale)
    ]
    np.testing.assert_array_equal(found[0].light, found[1].light)
    assert found[0].content.tone_text.split()[-1].replace(".", "").isdigit(), "no unit is known"


def test_noise_that_is_stated_is_not_followed() -> None:
    from nscc_training.reconstruct_any import Measurement

    truth = clip_of()
    noisy = measured(truth) + RNG.normal(0, 25, (1, ROWS, COLS))
    errors = [
        np.mean((reconstruct_measurement(Measurement(noisy, MASK, ""), model).light - truth) ** 2)
        for model in (NoiseModel(), NoiseModel(25.0), NoiseModel(0.0, 4.0))
    ]
    assert errors[1] < errors[0]
    assert errors[2] < errors[0]


def test_the_command_states_noise_and_no_psnr(tmp_path: Path) -> None:
    np.savez(tmp_path / "m.npz", mask=MASK, meas=measured(clip_of())[0])
    done = invoke(["reconstruct", "any", "m.npz", "-o", "o.npz"], tmp_path)
    assert done.status == 0, done.err
    assert "noise model: none" in done.err
    assert "dB" not in done.err
    with np.load(tmp_path / "o.npz") as file:
        assert file["video"].shape == (SLOTS, ROWS, COLS)
    done = invoke(["reconstruct", "any", "m.npz", "-o", "p.npz", "--noise", "3,0.5"], tmp_path)
    assert "standard deviation of the readout 3, variance of photons 0.5 times" in done.err
    for more in (["--noise", "x"], ["--noise", "-1"], ["--noise", "1,2,3"], ["--noise", "1e30"]):
        refused = invoke(["reconstruct", "any", "m.npz", "-o", "q.npz", *more], tmp_path)
        assert (refused.status, refused.codes) == (2, ["NS0846"])
    assert (
        invoke(["reconstruct", "any", "m.npz", "-o", "q.npz", "--as", "image"], tmp_path).status
        == 2
    )
    assert not (tmp_path / "q.npz").exists()


@pytest.mark.parametrize(
    ("arrays", "reason"),
    [
        ({"meas": np.ones((ROWS, COLS))}, "array `mask` is missing"),
        ({"mask": MASK, "other": MASK}, "array `meas` is missing"),
        ({"mask": MASK, "meas": np.ones((ROWS, COLS + 1))}, "rows and columns differ"),
        ({"mask": MASK[0], "meas": np.ones((ROWS, COLS))}, "shape (24, 32)"),
        ({"mask": 255 * MASK, "meas": np.ones((ROWS, COLS))}, "0 to 255"),
        ({"mask": MASK - 1, "meas": np.ones((ROWS, COLS))}, "-1 to 0"),
        ({"mask": 0 * MASK, "meas": np.ones((ROWS, COLS))}, "no pixel ever opens"),
        ({"mask": MASK, "meas": np.full((ROWS, COLS), np.nan)}, "not finite"),
        ({"mask": MASK, "meas": np.ones((ROWS, COLS), complex)}, "not real"),
        ({"mask": MASK, "meas": np.ones(5)}, "shape (5,)"),
        ({"mask": MASK * 1e-16, "meas": np.ones((ROWS, COLS))}, "largest value of `mask`"),
    ],
)
def test_unusable_measurements_are_refused(
    tmp_path: Path, arrays: dict[str, np.ndarray], reason: str
) -> None:
    np.savez(tmp_path / "m.npz", **arrays)
    with pytest.raises(Rejected) as caught:
        read_measurement(tmp_path / "m.npz")
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code == "NS0845"
    assert reason in diagnostic.message


def test_damaged_files_are_refused(tmp_path: Path) -> None:
    """Files of the text `nothing`, named `.mat`, `.npz` and `.npy`, give NS0845."""
    for name in ("m.mat", "m.npz", "m.npy"):
        (tmp_path / name).write_bytes(b"nothing")
        with pytest.raises(Rejected, match="NS0845"):
            read_measurement(tmp_path / name, tmp_path / name)


def test_clips_of_matlab_73_are_scenes(tmp_path: Path) -> None:
    from one_scene import load_scene

    from nscc_runtime.scenes import ExposureLevel

    clip = RNG.integers(0, 256, (ROWS, COLS, 5)).astype(float)
    clip[0, 0, 0] = 255
    write_v73(tmp_path / "c.mat", 512, orig=clip)
    light = load_scene(
        str(tmp_path / "c.mat"),
        slot_us=(1.0,) * 5,
        rows=ROWS,
        cols=COLS,
        exposure=ExposureLevel(1.0, 100.0),
    )
    np.testing.assert_allclose(
        light.dense(), np.moveaxis(clip, 2, 0) / clip.sum(axis=2).max(), rtol=1e-5
    )
