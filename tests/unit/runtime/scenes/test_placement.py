"""Pictures of any size on the array: cut out, scaled, in pieces; in grey and in colours."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from nscc_command import RunNscc
from numpy.typing import NDArray
from one_scene import load_scene
from PIL import Image
from scipy.io import savemat

from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc_runtime.light import Light
from nscc_runtime.scenes import ExposureLevel, PlacedLight, Scene, laid_lights, laid_scene
from nscc_runtime.scenes.colour import srgb_to_linear
from nscc_runtime.scenes.placement import Placement

RNG = np.random.default_rng(11)
SIZE: dict[str, Any] = {"slot_us": (1000.0, 1000.0), "rows": 24, "cols": 32}


@pytest.fixture
def photo(tmp_path: Path) -> Path:
    """100 x 96 in colours that differ."""
    Image.fromarray(RNG.integers(0, 256, (100, 96, 3), np.uint8)).save(tmp_path / "photo.png")
    return tmp_path / "photo.png"


def light_of(path: Path) -> NDArray[np.float64]:
    """Red, green, blue, by the definition of sRGB."""
    return srgb_to_linear(np.asarray(Image.open(path), np.float64) / 255)


def laid(path: Path, **more: Any) -> tuple[PlacedLight, list[Diagnostic]]:
    said: list[Diagnostic] = []
    options = {name: more.pop(name) for name in [*more] if name in vars(Scene)}
    scene = Scene(str(path), exposure=ExposureLevel(5000.0, 50.0), **options)
    found = laid_scene(scene, warn=said.append, **{**SIZE, **more})
    return found, said


def test_scaled_pictures_are_means_of_areas(photo: Path) -> None:
    """100 x 96 on 25 x 24: blocks of 4 x 4, and the median of them has the exposure asked for."""
    found, said = laid(photo, rows=25, fit="scale")
    assert (found.placement.size, found.placement.arrays) == ((25, 24), (1, 1))
    grey = light_of(photo) @ [0.2126, 0.7152, 0.0722]
    means = grey.reshape(25, 4, 24, 4).mean(axis=(1, 3))
    total = found.placement.cut(found.light.total_e())
    assert np.allclose(total, means * 5000 / np.median(means), rtol=1e-5)
    assert [each.code for each in said] == ["NS0773", "NS0773"]
    assert found.colour


def test_pixels_beyond_a_scaled_picture_mirror_it(photo: Path) -> None:
    found, _ = laid(photo, rows=25, fit="scale")
    total = found.light.total_e()
    # Columns 24 to 31 show columns 23 to 16.
    assert np.allclose(total[:, 24:], total[:, 23:15:-1])


def test_pieces_put_together_are_the_picture(photo: Path) -> None:
    """A photo of 100 x 96 needs 5 x 3 arrays of 24 x 32. Joined again they are the photo's
    light."""
    found, _ = laid(photo, fit="tiles")
    where = found.placement
    # 100 x 96 pixels need 5 x 3 arrays of 24 x 32.
    assert (where.size, where.arrays) == ((100, 96), (5, 3))
    pieces = [piece.total_e() for piece in where.pieces(found.light)]
    assert {piece.shape for piece in pieces} == {(24, 32)}
    whole = where.joined(pieces)
    grey = light_of(photo) @ [0.2126, 0.7152, 0.0722]
    assert np.allclose(whole, grey * 5000 / np.median(grey), rtol=1e-5)


def test_small_and_thin_pictures_are_scaled_up(tmp_path: Path) -> None:
    # The aspect is kept, but no side is below a pixel. The array is 24 x 32.
    for shape, size in (((3, 4), (24, 32)), ((1, 200), (1, 32)), ((500, 2), (24, 1))):
        Image.fromarray(np.full(shape, 128, np.uint8)).save(tmp_path / "small.png")
        found, _ = laid(tmp_path / "small.png", fit="scale")
        assert found.placement.size == size
        assert np.allclose(found.light.total_e(), 5000, rtol=1e-6)
    with pytest.raises(Rejected, match="NS0734"):
        laid(tmp_path / "small.png")


def test_cropped_parts_are_reported(photo: Path) -> None:
    """The note says that 0.08 of the picture is exposed. A crop beside tiles is refused with
    NS0739."""
    found, said = laid(photo)
    assert found.placement.fits_one_array
    assert (
        said[0].message
        == f"'{photo}' is 100 x 96, the array 24 x 32: 0.08 of the picture is exposed"
    )
    plain = load_scene(str(photo), exposure=ExposureLevel(5000.0, 50.0), **SIZE)
    assert np.array_equal(found.light.total_e(), plain.total_e())
    with pytest.raises(Rejected, match="NS0739"):
        laid(photo, fit="tiles", crop=(0, 0))


def test_a_clip_may_begin_later_or_be_a_still(tmp_path: Path) -> None:
    """From the third frame on there are two frames for two slots. From the fourth on there are too
    few: NS0735."""
    levels = (10, 50, 90, 200)
    frames = [Image.fromarray(np.full((24, 32), level, np.uint8)) for level in levels]
    frames[0].save(tmp_path / "clip.gif", save_all=True, append_images=frames[1:])
    clip, _ = laid(tmp_path / "clip.gif", first=2)
    means = clip.light.dense().mean(axis=(1, 2))
    assert means[1] / means[0] == pytest.approx(
        srgb_to_linear(np.array(200 / 255)) / srgb_to_linear(np.array(90 / 255))
    )
    with pytest.raises(Rejected, match=r"NS0735.* has 1 frame from frame 3 on, but 2 are needed"):
        laid(tmp_path / "clip.gif", first=3)
    with pytest.raises(Rejected, match="use a smaller --first"):
        laid(tmp_path / "clip.gif", first=9)


@pytest.mark.parametrize("name", ["clip.gif", "folder", "clip.mat"])
def test_any_frame_of_a_clip_may_be_a_still(name: str, tmp_path: Path) -> None:
    """Half of the picture gets brighter from frame to frame, the other half is 200."""
    frames = [np.full((24, 32), level, np.uint8) for level in (10, 50, 90)]
    for frame in frames:
        frame[:, 16:] = 200
    images = [Image.fromarray(frame) for frame in frames]
    images[0].save(tmp_path / "clip.gif", save_all=True, append_images=images[1:])
    (tmp_path / "folder").mkdir()
    for number, image in enumerate(images):
        image.save(tmp_path / "folder" / f"{number}.png")
    savemat(tmp_path / "clip.mat", {"orig": np.stack(frames, axis=-1)})
    for first, level in enumerate((10, 50, 90)):
        found, _ = laid(tmp_path / name, single=True, first=first, transfer="linear")
        assert found.light.kind == "still"
        total = found.light.total_e()
        assert total[0, 0] / total[0, -1] == pytest.approx(level / 200)
    with pytest.raises(Rejected, match=r"NS0735.* has 3 frames, so frame 3"):
        laid(tmp_path / name, single=True, first=3)


PROGRAM = """nsl 1
frame 4 slots of 1ms
code stop : 1..4
open when n < stop
pixels stop = tile [[4, 3, 1], [2, 4, 2], [1, 1, 3]]
"""


def test_a_picture_larger_than_the_array_is_exposed_in_pieces_and_in_colours(
    photo: Path, tmp_path: Path, run_nscc: RunNscc
) -> None:
    """Without effects the exposure of every pixel is the light of its open slots. Each piece has
    the codes of the array."""
    large = np.asarray(Image.open(photo).resize((300, 270)))
    Image.fromarray(large).save(tmp_path / "large.png")
    (tmp_path / "a.nsl").write_text(PROGRAM)
    line = "run a.nsl --scene large.png --exposure 8000@50 --fit tiles --keep truth -o a.npz"
    outcome = run_nscc([*line.split(), "--png", "a.png"], tmp_path)
    assert (outcome.status, outcome.codes) == (0, ["NS0773", "NS0773"])
    with np.load(tmp_path / "a.npz") as file:
        arrays = {name: file[name] for name in ("exposure_e", "truth_e", "meta")}
    y, x = (np.arange(side) % 256 % 3 for side in (270, 300))
    stop = np.array([[4, 3, 1], [2, 4, 2], [1, 1, 3]])[y][:, x]
    assert np.allclose(arrays["exposure_e"][0], arrays["truth_e"] * stop / 4)
    assert json.loads(str(arrays["meta"]))["laid"] == {
        "fit": "tiles",
        "picture": [270, 300],
        "arrays": [2, 2],
    }
    line = line.replace("a.npz", "c.npz").replace("--keep truth", "--color")
    outcome = run_nscc(line.split(), tmp_path)
    assert outcome.status == 0
    assert "3 frames, of red, green and blue light; the red one is described" in outcome.err
    with np.load(tmp_path / "c.npz") as file:
        colours = file["exposure_e"][:, 0]
    grey = np.tensordot([0.2126, 0.7152, 0.0722], colours, 1)
    assert np.allclose(grey, arrays["exposure_e"][0], rtol=1e-4)
    assert not np.allclose(colours[0], colours[1])
    for wrong in ("--repeat 2", "--plan new.json --effects auto"):
        assert "NS0739" in run_nscc([*line.split(), *wrong.split()], tmp_path).codes


def test_grey_scenes_are_exposed_once_although_colours_are_requested(tmp_path: Path) -> None:
    """A grey picture and a builtin scene give one light and the note NS0773."""
    Image.fromarray(RNG.integers(0, 256, (24, 32), np.uint8)).save(tmp_path / "grey.png")
    target = replace(builtin_target("scamp5"), rows=24, cols=32)
    for name in (str(tmp_path / "grey.png"), "builtin:hdr"):
        said: list[Diagnostic] = []
        scene = Scene(name, exposure="5000", color=True)
        assert len(laid_lights(scene, SIZE["slot_us"], target, said.append)) == 1
        assert [each.code for each in said] == ["NS0773"]
        assert "no colours" in said[0].message


def test_pictures_of_16_bits_alpha_and_grey_are_scaled(tmp_path: Path) -> None:
    """16 bits keep their precision when scaled. An alpha of 7 does not darken the picture."""
    deep = RNG.integers(0, 65536, (24, 32), np.uint16)
    cv2.imwrite(str(tmp_path / "deep.png"), deep)
    found, said = laid(tmp_path / "deep.png", transfer="linear", fit="scale")
    assert np.allclose(found.light.total_e(), deep * (5000 / np.median(deep)), rtol=1e-5)
    assert not said
    alpha = np.dstack([RNG.integers(0, 256, (24, 32, 3), np.uint8), np.full((24, 32), 7, np.uint8)])
    Image.fromarray(alpha, "RGBA").save(tmp_path / "alpha.png")
    opaque, _ = laid(tmp_path / "alpha.png")
    grey = srgb_to_linear(alpha[..., :3] / 255.0) @ [0.2126, 0.7152, 0.0722]
    assert np.allclose(opaque.light.total_e(), grey * 5000 / np.median(grey), rtol=1e-5)


def test_the_pieces_of_a_picture_are_numbered_by_rows_and_joined_again() -> None:
    """Piece 1 lies right of piece 0, and piece 3 begins the second row. Joined, they are the
    picture without its last column."""
    picture = np.arange(1, 1 + 2 * 4 * 9, dtype=np.float32).reshape(2, 4, 9)
    placement = Placement("tiles", (4, 8), (4, 8), (2, 3))
    pieces = [piece.dense() for piece in placement.pieces(Light.of_clip(picture))]
    assert np.array_equal(pieces[1], picture[:, :2, 3:6])
    assert np.array_equal(pieces[3], picture[:, 2:, :3])
    assert np.array_equal(placement.joined(pieces), picture[..., :8])
