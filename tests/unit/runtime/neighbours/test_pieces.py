"""Images and planes of pictures in parts, reduced, and in colours, and their picture files."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from nscc_command import RunNscc
from numpy.typing import NDArray

import nscc_runtime
from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.captured import Capture

TEXT = """
nsl 3
frame 2 slots of 1ms
outside 1
open when true
kernel blur = [[1, 2, 1], [2, 4, 2], [1, 2, 1]] / 16
kernel edge = [[0, 0, 0], [1, 0, -1], [0, 0, 0]]
kernel around = [[1, 1, 1], [1, 1, 1], [1, 1, 1]]
kernel line = [[1, 1, 1]]
image strength = abs(edge(blur(exposure)))
plane bright = strength > 3%
plane core = all(bright, line) and bright[1, 0] or any(bright, around) and exposure > 40%
read strength, core
report any bright
report events bright at most 30
report box core
"""
PICTURE = np.random.default_rng(5).uniform(0, 1, (41, 37)).astype(np.float32)


def container_of(text: str, shape: tuple[int, int]) -> Container:
    target = replace(builtin_target("scamp5"), rows=shape[0], cols=shape[1])
    made = run_passes(Source("p.nsl", text), Path(), Options(level=1, target=target, cache=False))
    assert made.container is not None
    return made.container


def captured(
    text: str, shape: tuple[int, int], picture: NDArray[Any], folder: Path, **options: Any
) -> Capture:
    """A capture of a picture on an array of this shape."""
    name = folder / "picture.tiff"
    cv2.imwrite(str(name), picture)
    scene = nscc_runtime.scene(name, exposure="15000@90", transfer="linear", **options)
    return nscc_runtime.capture(container_of(text, shape), scene)


@pytest.mark.parametrize("array", [(16, 16), (20, 40), (64, 17)])
def test_overlapping_parts_of_a_picture_give_the_result_of_one_large_array(
    array: tuple[int, int], tmp_path: Path
) -> None:
    parts = captured(TEXT, array, PICTURE, tmp_path, fit="tiles")
    size = max(array[0], len(PICTURE)), max(array[1], PICTURE.shape[1])
    mirrored = [(0, far - near) for far, near in zip(size, PICTURE.shape, strict=True)]
    frames = np.pad(parts.light.frames, [(0, 0), *mirrored], mode="symmetric")
    whole = nscc_runtime.capture(container_of(TEXT, size), replace(parts.light, frames=frames))
    own = tuple(slice(0, side) for side in PICTURE.shape)
    assert whole.margin is not None
    assert parts.margin is not None
    inside = ~whole.margin[own]
    assert 0.5 < inside.mean() < 1
    assert np.array_equal(~parts.margin, inside)
    strength, core = whole.images["strength"][own], whole.planes["core"][own]
    assert np.allclose(parts.images["strength"][inside], strength[inside], rtol=0, atol=1e-9)
    assert np.array_equal(parts.planes["core"][inside], core[inside])
    assert 0.1 < core.mean() < 0.9
    if size == PICTURE.shape:
        assert parts.reports["box core"] == whole.reports["box core"]
        events = parts.reports["events bright"]
        assert np.array_equal(events, whole.reports["events bright"])
        assert len(events) == 30
    assert parts.container.pictures == container_of(TEXT, array).pictures


def test_reports_of_a_reduced_picture_are_inside_it(tmp_path: Path) -> None:
    """The array shows the mirror image beside the picture; it is not reported."""
    picture = np.zeros((40, 20), np.float32)
    picture[:, 18:] = 1.0
    text = "nsl 3 frame 1 slots of 1ms outside 0 open when true plane p = exposure > 20% read p "
    text += "report any p report box p report events p at most 400"
    frame = captured(text, (20, 20), picture, tmp_path, fit="scale")
    assert frame.planes["p"].shape == (20, 10)
    assert frame.reports["any p"] is True
    assert frame.reports["box p"] == (9, 0, 9, 19)
    assert frame.reports["events p"].tolist() == [[9, row] for row in range(20)]
    repeated = nscc_runtime.capture(
        container_of(text, (20, 20)),
        nscc_runtime.scene(tmp_path / "picture.tiff", exposure=15000, fit="scale"),
        repeat=2,
    )
    assert repeated.reports["box p"] == [(9, 0, 9, 19)] * 2


def test_the_sum_of_an_image_in_parts_is_that_of_the_joined_image(tmp_path: Path) -> None:
    """Also if the program only reports the sum, and does not read the image."""
    image = TEXT.replace("nsl 3", "nsl 4").partition("plane bright")[0]
    text = image + "read strength\nreport sum strength\n"
    parts = captured(text, (16, 16), PICTURE, tmp_path, fit="tiles")
    assert parts.margin is not None
    expected_e = parts.images["strength"][~parts.margin].sum()
    assert parts.reports == {"sum strength": pytest.approx(expected_e)}
    unread = image + "report sum strength\n"
    only_reported = captured(unread, (16, 16), PICTURE, tmp_path, fit="tiles")
    assert only_reported.images == {}
    assert only_reported.reports == parts.reports


def test_colours_are_computed_one_by_one(tmp_path: Path) -> None:
    """The image of a colour picture has three planes, one a colour. The first is that of its
    channel alone, and a report counts each."""
    picture = np.random.default_rng(6).uniform(0, 1, (16, 16, 3)).astype(np.float32)
    frame = captured(TEXT, (16, 16), picture, tmp_path, color=True)
    assert frame.images["strength"].shape == (3, 16, 16)
    red = captured(TEXT, (16, 16), picture[..., 2], tmp_path)
    factor = frame.light.exposure_scale_e / red.light.exposure_scale_e
    assert np.allclose(frame.images["strength"][0], red.images["strength"] * factor, atol=0.01)
    assert len(frame.reports["events bright"]) == 3


def test_codes_that_differ_cannot_continue_across_parts(tmp_path: Path) -> None:
    text = "nsl 3 frame 2 slots of 1ms code stop : 1..2 open when n < stop pixels stop = 1 + x % 2 "
    text += "kernel k = [[1, 1, 1]] / 4 image i = k(exposure) read i"
    with pytest.raises(Rejected, match="NS0542"):
        captured(text, (16, 16), PICTURE, tmp_path, fit="tiles")
    alone = text.replace("k(exposure)", "exposure / 4")
    joined = captured(alone, (16, 16), PICTURE, tmp_path, fit="tiles")
    light_e = joined.light.total_e()
    codes = 1 + np.arange(PICTURE.shape[1]) % 16 % 2
    assert np.allclose(joined.images["i"], light_e * codes / 8)


def test_picture_files_hold_what_the_program_reads(tmp_path: Path, run_nscc: RunNscc) -> None:
    text = "nsl 3\nframe 1 slots of 1ms\nopen when true\nimage half = exposure / 2 - exposure\n"
    text += "plane p = exposure > 50%\nread p, half\n"
    (tmp_path / "a.nsl").write_text(text)
    light = np.random.default_rng(7).uniform(0, 25000, (1, 256, 256))
    np.savez(tmp_path / "light.npz", light=light)
    for name in ("f.npz", "f.tiff", "f.png", "f.npy"):
        assert run_nscc(f"run a.nsl --scene light.npz -o {name}".split(), tmp_path).status == 0
    with np.load(tmp_path / "f.npz") as frame:
        bits, image, codes = frame["plane_p"], frame["image_half"], frame["image_codes_half"]
    electrons = cv2.imread(str(tmp_path / "f.tiff"), cv2.IMREAD_UNCHANGED)
    assert np.array_equal(electrons[:, :256], bits)
    assert np.allclose(electrons[:, 256:], image)
    shown = cv2.imread(str(tmp_path / "f.png"), cv2.IMREAD_UNCHANGED)
    assert np.array_equal(shown, np.concatenate([bits * np.uint8(255), codes], axis=1))
    assert np.array_equal(np.load(tmp_path / "f.npy"), np.stack([bits * np.uint8(255), codes]))
    (tmp_path / "b.nsl").write_text(text.replace("read p, half", "report any p"))
    refused = run_nscc(["run", "b.nsl", "--scene", "light.npz", "-o", "g.png"], tmp_path)
    assert (refused.status, refused.codes) == (2, ["NS0786"])


def test_frame_files_of_images_are_drawn_and_not_reconstructed(
    tmp_path: Path, run_nscc: RunNscc
) -> None:
    (tmp_path / "a.nsl").write_text(TEXT)
    assert (
        run_nscc(
            ["run", "a.nsl", "--scene", "builtin:hdr", "-o", "f.npz", "--png", "direct.png"],
            tmp_path,
        ).status
        == 0
    )
    assert run_nscc(["view", "f.npz", "-o", "view.png"], tmp_path).status == 0
    drawn, direct = (cv2.imread(str(tmp_path / name)) for name in ("view.png", "direct.png"))
    assert drawn.shape[0] > 500
    assert abs(drawn.shape[0] - direct.shape[0]) < 60
    refused = run_nscc(["reconstruct", "any", "f.npz", "-o", "light.npz"], tmp_path)
    assert (refused.status, refused.codes) == (2, ["NS0819"])
    assert "no exposures" in refused.err
    with np.load(tmp_path / "f.npz") as arrays:
        damaged = dict(arrays)
    for key, values in (
        ("report_events_bright", damaged["report_events_bright"] + 300),
        ("image_strength", damaged["image_strength"][:-1]),
        ("plane_core", np.array(True)),
    ):
        np.savez(tmp_path / "d.npz", **{**damaged, key: values})
        broken = run_nscc(["view", "d.npz", "-o", "d.png"], tmp_path)
        assert (broken.status, broken.codes) == (2, ["NS0801"])
        assert key in broken.err
