"""Every format that is written opens in the library that owns it, with the values that went in."""

from __future__ import annotations

import io
from collections.abc import Callable
from pathlib import Path
from typing import Any

import cv2
import imageio.v3 as imageio
import numpy as np
import OpenEXR
import pytest
import tifffile
from nscc_command import RunNscc
from numpy.typing import NDArray
from PIL import Image
from scipy.io import loadmat, savemat

from nscc.diagnostics.diagnostic import Rejected
from nscc.files import Product
from nscc_runtime.formats import FORMATS, Content, check_ending, endings, file_of
from nscc_runtime.pictures.tone import TONES, fitted

Values = NDArray[Any]

RNG = np.random.default_rng(7)
GREY = RNG.lognormal(8, 2, (37, 52)).astype(np.float32)
COLOUR = RNG.lognormal(8, 2, (37, 52, 3)).astype(np.float32)
CLIP = RNG.lognormal(6, 1, (5, 38, 52)).astype(np.float32)
COLOUR_CLIP = RNG.lognormal(6, 1, (5, 38, 52, 3)).astype(np.float32)


def content(light: Values, **more: Any) -> Content:
    moving, colour = len(light) == 5, light.shape[-1] == 3
    name = "video" if moving else "image"
    return Content({name: light}, light, moving, colour, **more)


def written(ending: str, given: Content) -> bytes:
    first, second = (_bytes(file_of(Path("a" + ending), given, "it")) for _ in range(2))
    assert first == second, "the same bytes"
    return first


def _bytes(product: Product) -> bytes:
    if isinstance(product, bytes):
        return product
    stream = io.BytesIO()
    product(stream)
    return stream.getvalue()


def pfm(data: bytes) -> Values:
    """By its own definition: three lines of text, rows from the bottom."""
    kind, size, scale, rest = data.split(b"\n", 3)
    cols, rows = map(int, size.split())
    order = "<" if float(scale) < 0 else ">"
    shape = (rows, cols) if kind == b"Pf" else (rows, cols, 3)
    return np.frombuffer(rest, f"{order}f4").reshape(shape)[::-1]


def exr(data: bytes, folder: Path) -> Values:
    (folder / "a.exr").write_bytes(data)
    with OpenEXR.File(str(folder / "a.exr")) as file:
        (channel,) = file.channels().values()
        return np.array(channel.pixels)


EXACT: dict[str, Callable[[bytes, Path], Values]] = {
    ".npz": lambda data, _: next(iter(np.load(io.BytesIO(data)).values())),
    ".npy": lambda data, _: np.load(io.BytesIO(data)),
    ".tiff": lambda data, _: tifffile.imread(io.BytesIO(data)),
    ".pfm": lambda data, _: pfm(data),
    ".exr": exr,
}
SHOWN: dict[str, Callable[[bytes, Path], Values]] = {
    ".png": lambda data, _: imageio.imread(data, extension=".png"),
    ".gif": lambda data, _: imageio.imread(data, extension=".gif"),
}


@pytest.mark.parametrize("ending", EXACT)
def test_exact_formats_return_the_same_light(ending: str, tmp_path: Path) -> None:
    for light in (GREY, COLOUR, CLIP, COLOUR_CLIP):
        given = content(light)
        if given.lacks(FORMATS[ending].holds) is None:
            assert np.array_equal(EXACT[ending](written(ending, given), tmp_path), light)


def test_radiance_files_keep_light_within_their_mantissa() -> None:
    for light in (GREY, COLOUR):
        data = np.frombuffer(written(".hdr", content(light)), np.uint8)
        found = cv2.imdecode(data, cv2.IMREAD_ANYDEPTH | cv2.IMREAD_COLOR)[..., ::-1]
        colours = light if light.ndim == 3 else np.repeat(light[..., None], 3, -1)
        assert (np.abs(found - colours) <= colours.max(axis=-1, keepdims=True) / 128).all()


@pytest.mark.parametrize("tone", TONES)
def test_pictures_and_clips_are_as_a_screen_shows_them(tone: str, tmp_path: Path) -> None:
    for ending, lights in ((".png", (GREY, COLOUR)), (".gif", (CLIP,))):
        for light in lights:
            found = SHOWN[ending](written(ending, content(light, tone=tone)), tmp_path)
            assert np.array_equal(
                found if found.ndim == light.ndim else found[..., 0], fitted(tone, light)(light)
            )


def test_films_play_as_many_frames_of_their_size(tmp_path: Path) -> None:
    for light in (CLIP, COLOUR_CLIP, CLIP[:, :37, :51]):
        path = tmp_path / "a.mp4"
        path.write_bytes(written(".mp4", content(light)))
        film, frames = cv2.VideoCapture(str(path)), []
        while (read := film.read())[0]:
            frames.append(read[1][..., ::-1])
        found = np.array(frames)[:, : light.shape[1], : light.shape[2]].astype(float)
        shown = np.array([*content(light).shown])
        shown = shown if shown.ndim == 4 else np.repeat(shown[..., None], 3, -1)
        assert found.shape == shown.shape
        assert np.abs(found.mean(axis=(1, 2)) - shown.mean(axis=(1, 2))).max() < 12


def test_a_matlab_clip_has_time_last_and_no_date() -> None:
    turned = {"video": np.moveaxis(CLIP, 0, -1)}
    data = written(".mat", content(CLIP, benchmark=lambda: turned))
    assert np.array_equal(loadmat(io.BytesIO(data))["video"], np.moveaxis(CLIP, 0, -1))


def test_the_tone_curve_is_named_in_the_picture() -> None:
    with Image.open(io.BytesIO(written(".png", content(GREY, tone="mu-law")))) as picture:
        assert picture.text["Description"].startswith("mu-law curve, white ")


def test_tone_curves_have_the_formulas_of_their_names() -> None:
    light = np.array([0.0, 0.002, 0.1, 0.5, 1.0, 3.0]) * 700
    there = np.clip(light / 700, 0, 1)
    linear = fitted("linear", light, 700)(light)
    assert linear.tolist() == np.rint(255 * there).tolist()
    by_hand = np.where(there <= 0.0031308, 12.92 * there, 1.055 * there ** (1 / 2.4) - 0.055)
    assert fitted("srgb", light, 700)(light).tolist() == np.rint(255 * by_hand).tolist()
    mu = np.log(1 + 5000 * there) / np.log(5001)
    assert fitted("mu-law", light, 700)(light).tolist() == np.rint(255 * mu).tolist()
    # A logarithmic curve shows the median at 45 % of white.
    assert abs(int(fitted("log", GREY)(np.median(GREY)[None])[0]) - 0.45 * 255) < 1.5
    for name in TONES:
        levels = fitted(name, GREY)(np.sort(GREY.ravel()))
        assert (np.diff(levels.astype(int)) >= 0).all()
        assert levels[-1] == 255
        assert not fitted(name, np.zeros((4, 4)))(np.zeros((4, 4))).any()


def test_endings_that_are_unknown_or_do_not_suit_the_content_are_refused() -> None:
    """Upper-case endings are accepted, and so is /dev/stdout, which counts as .npz."""
    for name in ("a.jpg", "a.npz.txt", "a.h5"):
        with pytest.raises(Rejected) as raised:
            check_ending(Path(name), endings(), "a frame")
        assert [d.code for d in raised.value.diagnostics] == ["NS0786"]
    assert check_ending(Path("/dev/stdout"), endings(), "a frame") == ".npz"
    assert check_ending(Path("A.PNG"), (".png",), "a picture") == ".png"
    for ending, light in ((".mp4", GREY), (".hdr", CLIP), (".png", CLIP), (".gif", COLOUR)):
        with pytest.raises(Rejected, match="NS0786"):
            file_of(Path("a" + ending), content(light), "it")


PROGRAM = """nsl 1
frame 8 slots of 1ms
code bits : bit[8]
open when bits[n]
pixels bits = (37 * x + 91 * y) % 255 + 1
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A program of random bits, and a clip of the benchmark's kind."""
    found = tmp_path_factory.mktemp("sci")
    (found / "bits.nsl").write_text(PROGRAM)
    ground = np.kron(RNG.integers(0, 256, (32, 32)), np.ones((8, 8)))
    orig = np.stack([np.roll(ground, 3 * k, 1) for k in range(8)], 2).astype(np.uint8)
    savemat(found / "clip.mat", {"orig": orig})
    return found


def test_a_frame_in_a_mat_file_is_a_measurement_for_the_benchmark(
    folder: Path, run_nscc: RunNscc
) -> None:
    """The file holds `mask`, `meas` and `orig` with the axes of the benchmark's tools. The sum of
    the masked frames equals the measurement."""
    line = "run bits.nsl --scene clip.mat --exposure 20000 -o meas.mat"
    assert run_nscc(line.split(), folder).status == 0
    found = loadmat(folder / "meas.mat")
    mask, meas, orig = (np.asarray(found[name], float) for name in ("mask", "meas", "orig"))
    assert (mask.shape, meas.shape) == ((256, 256, 8), (256, 256, 1))
    y, x = np.mgrid[:256, :256]
    bits = (37 * x + 91 * y) % 255 + 1
    assert np.array_equal(mask, bits[..., None] >> np.arange(8) & 1)
    assert np.array_equal(orig, loadmat(folder / "clip.mat")["orig"])
    assert np.allclose((mask * orig).sum(axis=2), meas[..., 0], rtol=1e-5)
    outcome = run_nscc(["evaluate", "sci8", "meas.mat", "--method", "adjoint", "--json"], folder)
    assert outcome.status == 0, outcome.err


def test_the_command_shutters_writes_the_same_mask_to_mat_npy_and_npz(
    folder: Path, run_nscc: RunNscc
) -> None:
    for name in ("mask.mat", "mask.npy", "mask.npz"):
        assert run_nscc(["shutters", "bits.nsl", "-o", name], folder).status == 0
    mask = loadmat(folder / "mask.mat")["mask"]
    assert np.array_equal(np.load(folder / "mask.npy")[0], mask)
    with np.load(folder / "mask.npz") as kept:
        opened = np.unpackbits(kept["shutter"], axis=-1, count=8, bitorder="little")
    assert np.array_equal(opened[0], mask)


def test_a_frame_is_written_in_every_format(folder: Path, run_nscc: RunNscc) -> None:
    scene = ["run", "bits.nsl", "--scene", "clip.mat", "--exposure", "20000", "-o"]
    assert run_nscc([*scene, "frame.npz"], folder).status == 0
    with np.load(folder / "frame.npz") as file:
        codes, electrons = file["frame"][0], file["exposure_e"][0].astype(np.float32)
    for ending in FORMATS:
        outcome = run_nscc([*scene, "frame" + ending], folder)
        assert outcome.status == (2 if ending in (".gif", ".mp4") else 0), outcome.err
    assert np.array_equal(imageio.imread(folder / "frame.png"), codes)
    assert np.array_equal(np.load(folder / "frame.npy")[0], codes)
    assert np.array_equal(tifffile.imread(folder / "frame.tiff"), electrons)
    assert run_nscc([*scene, "film.gif", "--repeat", "3", "--effects", "shot"], folder).status == 0
    assert imageio.imread(folder / "film.gif").shape[:3] == (3, 256, 256)
    for product in ("-o frame.jpg", "-o frame.npz --png frame.gif"):
        assert run_nscc([*scene[:-1], *product.split()], folder).codes == ["NS0786"]
