"""What training reads and refuses: by the rules of `nscc run`, each with a sentence."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch

from nscc.diagnostics.diagnostic import Rejected
from nscc_training.data import Scenes, load_scenes
from nscc_training.decoders.guess import clip_guess, still_guess
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.sensor_model import SensorModel, differentiable_capture
from nscc_training.settings import DataSettings

SENSOR = SensorModel(full_well_e=1000.0, electrons_per_lsb=4.0)


def scenes_of(
    folder: Path, still: bool = True, told: list[str] | None = None, **data: Any
) -> Scenes:
    settings = DataSettings(train=str(folder), patch=16, **data)
    tell = [].append if told is None else told.append
    return load_scenes(settings, still, slots=3, seed=0, tell=tell)


def pictures(folder: Path, *extra: np.ndarray) -> None:
    import cv2

    for number, light in enumerate(
        [np.random.default_rng(k).random((32, 32), np.float32) + 0.1 for k in range(5)] + [*extra]
    ):
        cv2.imwrite(str(folder / f"{number}.pfm"), light.astype(np.float32))


@pytest.mark.parametrize("bad", [-5.0, np.inf, np.nan])
def test_light_that_run_refuses_is_refused(tmp_path: Path, bad: float) -> None:
    """A negative, infinite or NaN picture in the folder gives NS0736 with its name, as `nscc run`
    does."""
    light = np.ones((32, 32), np.float32)
    light[:16] = bad
    pictures(tmp_path, light)
    with pytest.raises(Rejected) as caught:
        scenes_of(tmp_path)
    assert caught.value.diagnostics[0].code == "NS0736"
    assert "5.pfm" in caught.value.diagnostics[0].message


def test_small_negative_light_is_reported(tmp_path: Path) -> None:
    light = np.ones((32, 32), np.float32)
    light[0, :3] = -1e-5
    pictures(tmp_path, light)
    told: list[str] = []
    scenes_of(tmp_path, told=told)
    assert any("3 of 1024 pixels" in text for text in told)


@pytest.mark.parametrize(("lit", "refused"), [(0.2, True), (0.4, False)])
def test_scenes_that_are_mostly_dark_are_refused(tmp_path: Path, lit: float, refused: bool) -> None:
    light = np.zeros((32, 32), np.float32)
    light.flat[: int(lit * light.size)] = 1
    pictures(tmp_path, light)
    if not refused:
        assert len(scenes_of(tmp_path).train) == 4
        return
    with pytest.raises(Rejected) as caught:
        scenes_of(tmp_path)
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code == "NS0811"
    assert "dark where it should saturate" in diagnostic.notes[0]


def test_a_single_folder_is_split_and_the_split_is_reported(tmp_path: Path) -> None:
    """Of five pictures the first is for validation, and a line says so. Procedural scenes have
    validation scenes of their own."""
    pictures(tmp_path)
    told: list[str] = []
    found = scenes_of(tmp_path, told=told)
    assert [scene.name for scene in found.val] == ["0.pfm"]
    assert [scene.name for scene in found.train] == [f"{k}.pfm" for k in range(1, 5)]
    assert told == [
        f"validation: 1 of 5 scenes of '{tmp_path}' (0.pfm), every fifth; data.val names a folder "
        "instead"
    ]
    procedural = load_scenes(DataSettings(scenes=2, patch=16), True, 3, 0)
    assert procedural.val[0].name == "procedural-val-0"


def test_pages_and_floats_of_255_are_clips_as_in_run(tmp_path: Path) -> None:
    import tifffile
    from scipy.io import savemat

    clip = np.random.default_rng(0).integers(0, 256, (4, 32, 32)).astype(np.uint8)
    clip[0, 0, 0] = 255
    for number in range(2):
        tifffile.imwrite(tmp_path / f"{number}.tif", clip + number % 1, photometric="minisblack")
    found = scenes_of(tmp_path, False, protocol="video-v1", val="procedural").train
    fraction = clip / 255.0
    light = np.where(fraction <= 0.04045, fraction / 12.92, ((fraction + 0.055) / 1.055) ** 2.4)
    np.testing.assert_allclose(found[0].light, light, rtol=1e-5)
    (tmp_path / "m").mkdir()
    savemat(tmp_path / "m" / "a.mat", {"orig": np.moveaxis(clip, 0, 2).astype(float)})
    savemat(tmp_path / "m" / "b.mat", {"orig": np.moveaxis(clip, 0, 2)})
    floats, bytes_ = scenes_of(tmp_path / "m", False, protocol="video-v1", val="procedural").train
    np.testing.assert_allclose(floats.light, bytes_.light, rtol=1e-5)
    np.testing.assert_allclose(bytes_.light, fraction, rtol=1e-5)


@pytest.mark.parametrize("kind", ["b", "c", "d", "e", "codebook"])
def test_parameters_that_are_not_finite_stand_for_no_code(kind: str) -> None:
    """One NaN among the parameters gives a ValueError, for each class with codes."""
    spec = ShutterSpec(
        kind, 8, (2, 2), length=2 if kind == "c" else None, rows=4 if kind == "codebook" else None
    )
    encoder = make_encoder(spec, "random")
    encoder.codes()
    with torch.no_grad():
        next(iter(encoder.parameters())).view(-1)[0] = torch.nan
    with pytest.raises(ValueError, match="not finite, and stand for no code"):
        encoder.codes()


@pytest.mark.parametrize(
    ("value", "dtype", "words"),
    [
        (-1.0, torch.float32, "1 are negative"),
        (torch.inf, torch.float32, "not finite"),
        (torch.nan, torch.float32, "not finite"),
        (70000.0, torch.float16, "float16 holds numbers up to 65504"),
        (1j, torch.complex64, "complex"),
    ],
)
def test_invalid_light_of_a_differentiable_capture_is_refused(
    value: complex, dtype: torch.dtype, words: str
) -> None:
    light = torch.ones(1, 3, 4, 4, dtype=dtype)
    light[0, 0, 0, 0] = 0
    differentiable_capture(light.real.float(), torch.ones(3, 4, 4), SENSOR)
    light[0, 1, 2, 3] = value
    with pytest.raises(ValueError, match=words):
        differentiable_capture(light, torch.ones(3, 4, 4), SENSOR)


@pytest.mark.parametrize(
    "values", [{"full_well_e": 0.0}, {"electrons_per_lsb": 0.0}, {"full_well_e": np.nan}]
)
def test_sensor_models_refuse_values_that_are_not_finite_and_above_0(
    values: dict[str, float],
) -> None:
    """A full well or gain of 0, or a NaN, gives a ValueError."""
    with pytest.raises(ValueError, match=r"must be finite and above 0|is a finite number, not nan"):
        SensorModel(**{"full_well_e": 1.0, "electrons_per_lsb": 1.0, **values})


def test_guesses_refuse_values_that_are_not_finite() -> None:
    """One NaN in a frame of 256 values is counted in the ValueError. A frame of ones is
    accepted."""
    frame = torch.ones(1, 16, 16)
    still_guess(frame, torch.ones(16, 16))
    frame[0, 3, 4] = torch.nan
    with pytest.raises(ValueError, match="1 of 256 values of the frame are not finite"):
        still_guess(frame, torch.ones(16, 16))
    with pytest.raises(ValueError, match="values of the volume are not finite"):
        clip_guess(frame[None], torch.ones(1, 16, 16))
