"""Training on a folder: the settings that its files lead to, and the brightness of exposures."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import OpenEXR
import pytest
import scipy.io
import tifffile
from nscc_command import invoke
from PIL import Image

torch = pytest.importorskip("torch")

from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_runtime.scenes import picture_files  # noqa: E402
from nscc_runtime.scenes.picture_files import read_picture  # noqa: E402
from nscc_training import scene_files  # noqa: E402
from nscc_training.data import ExposureSet, cut_batch, load_scenes  # noqa: E402
from nscc_training.own_folder import folder_settings  # noqa: E402
from nscc_training.scene_files import frame_size, frames_in  # noqa: E402
from nscc_training.settings import DataSettings, load_config  # noqa: E402


def folder(path: Path, ending: str, *sides: int) -> Path:
    """Write pictures of these sides."""
    path.mkdir()
    draw = np.random.default_rng(1)
    for number, side in enumerate(sides):
        picture = cv2.resize(draw.uniform(0, 255, (9, 9, 3)).astype(np.float32), (side + 30, side))
        picture = picture if ending == "hdr" else picture.astype(np.uint8)
        cv2.imwrite(str(path / f"{number}.{ending}"), picture)
    return path


@pytest.mark.parametrize(
    ("ending", "sides", "protocol", "kind", "patch"),
    [
        ("hdr", (300, 140), "hdr-v1", "b", 128),
        ("png", (300, 100), "video-v1", "d", 96),
        ("jpg", (20,), "video-v1", "d", 32),
    ],
)
def test_the_settings_follow_from_the_files(
    tmp_path: Path, ending: str, sides: tuple[int, ...], protocol: str, kind: str, patch: int
) -> None:
    said: list[str] = []
    settings = folder_settings(folder(tmp_path / "f", ending, *sides), tell=said.append)
    assert settings.data.protocol == protocol
    assert settings.shutter.kind == kind
    assert settings.shutter.relaxation == "tried"
    assert settings.data.patch == patch
    assert settings.data.train == str(tmp_path / "f")
    assert settings.data.saturated == ((0.3, 0.6) if kind == "b" else (0.3, 0.3))
    assert settings.data.brightness == ((1.0, 1.0) if kind == "b" else (0.25, 1.0))
    assert f"patches of {patch} x {patch}" in said[0]


FORMATS = ("avif", "bmp", "dng", "exr", "hdr", "heic", "jpg", "mat", "pfm", "png", "tif", "webp")


def write(path: Path) -> None:
    """Write a picture or a clip of 30 x 40 pixels; TIFF with 16 bits, which Pillow cannot open."""
    picture = np.random.default_rng(2).integers(0, 255, (30, 40, 3)).astype(np.uint8)
    match path.suffix:
        case ".heic":
            heif = pytest.importorskip("pillow_heif")
            heif.from_pillow(Image.fromarray(picture)).save(path)
        case ".dng":
            pytest.importorskip("rawpy")
            tags = [
                (50706, "B", 4, (1, 4, 0, 0), True), (50708, "s", 0, "Test", True),
                (33421, "H", 2, (2, 2), True), (33422, "B", 4, (0, 1, 1, 2), True),
            ]  # fmt: skip
            mosaic = np.full((30, 40), 1000, np.uint16)
            tifffile.imwrite(path, mosaic, photometric=32803, extratags=tags, metadata=None)
        case ".exr":  # the picture fills a part of the display window
            corner = np.array([5, 6], np.int32)
            header = {
                "compression": OpenEXR.ZIP_COMPRESSION,
                "type": OpenEXR.scanlineimage,
                "dataWindow": (corner, corner + np.array([19, 9], np.int32)),
                "displayWindow": (0 * corner, np.array([39, 29], np.int32)),
            }
            part = OpenEXR.Part(header, {"RGB": picture[:10, :20].astype(np.float32)})
            OpenEXR.File([part]).write(str(path))
        case ".mat":
            scipy.io.savemat(path, {"orig": np.repeat(picture, 4, axis=2)})
        case ".tif":
            tifffile.imwrite(path, picture.astype(np.uint16), photometric="rgb")
        case ".hdr" | ".pfm":
            cv2.imwrite(str(path), picture.astype(np.float32))
        case _:
            Image.fromarray(picture).save(path)


@pytest.mark.parametrize("ending", FORMATS)
def test_the_size_of_a_picture_is_read_without_decoding_it(
    tmp_path: Path, ending: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / f"a.{ending}"
    write(path)
    read = next(iter(frames_in(path))) if ending == "mat" else read_picture(path)
    assert read.shape[:2] == (30, 40)

    def decoded(*_: object) -> None:
        raise AssertionError("the file is decoded")

    # From here on decoding a file fails the test.
    monkeypatch.setattr(picture_files, "open_pages", decoded)
    monkeypatch.setattr(scene_files, "frames_in", decoded)
    assert frame_size(path) == (30, 40)


@pytest.mark.parametrize("ending", [*FORMATS, "gif", "mp4"])
def test_a_damaged_file_is_refused(tmp_path: Path, ending: str) -> None:
    (tmp_path / f"a.{ending}").write_bytes(b"neither picture nor clip")
    with pytest.raises(Rejected) as refusal:
        folder_settings(tmp_path)
    assert refusal.value.diagnostics[0].code == "NS0732"


def test_films_become_clips_and_changes_come_last(tmp_path: Path) -> None:
    frames = [Image.new("L", (70, 66), 10 * k) for k in range(3)]
    frames[0].save(tmp_path / "f.gif", save_all=True, append_images=frames[1:])
    settings = folder_settings(tmp_path, ["train.steps=7", "data.patch=40"])
    assert settings.data.protocol == "video-v1"
    assert (settings.train.steps, settings.data.patch) == (7, 40)


def test_a_folder_without_pictures_is_refused(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("no picture")
    with pytest.raises(Rejected) as refusal:
        folder_settings(tmp_path)
    assert refusal.value.diagnostics[0].code == "NS0811"


def test_train_takes_a_folder(tmp_path: Path) -> None:
    folder(tmp_path / "photos", "hdr", *[48] * 5)
    small = (
        "shutter.slots=16",
        "train.steps=2",
        "train.batch=1",
        "data.together=1",
        "data.val_items=1",
        "decoder.width=0.25",
    )
    changes = [word for change in small for word in ("--set", change)]
    outcome = invoke(["train", "photos", "--out", "run", *changes], tmp_path)
    assert outcome.status == 0, outcome.err
    assert "5 files of 'photos', as stills of high dynamic range" in outcome.out + outcome.err
    assert load_config(tmp_path / "run/config.resolved.toml").data.patch == 48


@pytest.mark.parametrize("protocol", ["hdr-v1", "video-v1"])
def test_brightness_is_a_factor_on_the_light_of_each_exposure(protocol: str) -> None:
    data = DataSettings(scenes=4, patch=16, protocol=protocol, augment=False)
    scenes = load_scenes(data, protocol == "hdr-v1", 4, 0)

    def batch_of(limits: tuple[float, float]) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
        chosen = replace(data, brightness=limits)
        drawn = ExposureSet(scenes, chosen, slots=4, batch=8, seed=0)[3]
        batch = cut_batch(drawn, chosen, 30000.0, torch.device("cpu"))
        return drawn.brightness, batch.light, batch.peak

    plain, half, tenth = (batch_of((factor, factor)) for factor in (1.0, 0.5, 0.1))
    assert (plain[0] == 1).all()
    # The same draws, apart from the brightness: light and peak scale together.
    for light, other, factor in ((half, tenth, 5.0),):
        assert torch.allclose(light[1], factor * other[1], rtol=1e-5)
        assert torch.allclose(light[2], factor * other[2], rtol=1e-5)
    drawn = batch_of((0.1, 10.0))[0]
    assert len(set(drawn.tolist())) == 8
    assert 0.1 <= float(drawn.min()) < 1 < float(drawn.max()) <= 10
