"""Masks from elsewhere: the class and tile that hold them, and shutters that are the mask's."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from nscc_command import invoke
from scipy.io import savemat

from nscc.compiler import compile_file
from nscc.diagnostics.diagnostic import Rejected
from nscc_training.array_files import read_mask
from nscc_training.command_settings import Axis
from nscc_training.imported_masks import ImportedMask, import_mask

RNG = np.random.default_rng(0)
N = np.arange(8)


def by_stop(stop: np.ndarray, start: np.ndarray | int = 0) -> np.ndarray:
    """(rows, cols, slots): open from `start` until `stop`."""
    return (np.asarray(start)[..., None] <= N) & (np.asarray(stop)[..., None] > N)


ORDER = RNG.permutation(64).reshape(8, 8)
MASKS = {
    "a": np.ones((4, 4, 8), bool),
    "b": by_stop(1 + ORDER % 8),
    "c": by_stop(ORDER % 6 + 3, ORDER % 6),
    "d": by_stop(np.minimum(ORDER % 6 + 1 + ORDER // 16, 8), ORDER % 6),
    "codebook": RNG.random((4, 8))[ORDER % 4] < 0.5,
    "e": (RNG.permutation(1024)[:256].reshape(16, 16, 1) >> np.arange(10)) & 1,
}


def imported(
    folder: Path, mask: np.ndarray, slots_axis: Axis | None = "last"
) -> tuple[ImportedMask, np.ndarray]:
    """What becomes of a mask, and the shutters (rows, cols, slots) of the compiled program."""
    np.save(folder / "mask.npy", mask)
    found = import_mask(folder / "mask.npy", "p.codes.npz", slots_axis=slots_axis)
    (folder / "p.nsl").write_text(found.text)
    (folder / "p.codes.npz").write_bytes(found.codes)
    container = compile_file(folder / "p.nsl").container
    assert container is not None
    table = container.table
    return found, table.shutters[table.shutter_of_code[container.pixel_codes], 0]


@pytest.mark.parametrize("kind", MASKS)
def test_a_mask_is_imported_with_its_class_and_shutters(tmp_path: Path, kind: str) -> None:
    """Each mask gets its class, but for that of class e, where a list of bits takes no more words.
    Its shutters are the mask, repeated to 256 x 256."""
    mask = MASKS[kind]
    found, shutters = imported(tmp_path, mask)
    if kind == "e":  # for these bits a list of them takes as many words
        more = [reason for reason in found.reasons if "words a slot, not fewer than" in reason]
        assert more == [
            f"class e: {found.words_per_slot:g} words a slot, not fewer than "
            f"{found.words_per_slot:g}"
        ]
    else:
        assert found.kind == kind, found
    repeated = np.tile(mask, (256 // mask.shape[0], 256 // mask.shape[1], 1))
    np.testing.assert_array_equal(shutters, repeated)


def test_the_smallest_tile_of_a_mask_is_found(tmp_path: Path) -> None:
    """The mask covers the array, with the axis of slots first or last; the tile need not divide
    it."""
    tile = by_stop(1 + RNG.permutation(15).reshape(3, 5) % 8)
    mask = np.tile(tile, (86, 52, 1))[:256, :256]
    for stored in (mask, np.moveaxis(mask, 2, 0)):
        found, shutters = imported(tmp_path, stored, None)
        assert (found.kind, found.tile) == ("b", (3, 5))
        np.testing.assert_array_equal(shutters, mask)
    assert any("class c" in reason for reason in found.reasons)


def test_an_open_shutter_is_a_bump_as_long_as_the_frame(tmp_path: Path) -> None:
    """A mask of ones is class a, and the other classes are left only for their words a slot."""
    found, _ = imported(tmp_path, np.ones((2, 3, 8)))
    assert found.kind == "a"
    assert all("words a slot" in reason for reason in found.reasons)


def test_the_axes_of_a_mask_with_a_square_tile_are_found(tmp_path: Path) -> None:
    mask = by_stop(1 + np.arange(16).reshape(4, 4) % 4)
    assert imported(tmp_path, mask, None)[0].axes == "8 slots (the last axis of `mask`)"


@pytest.mark.parametrize("shape", [(16, 8, 8), (8, 8, 8), (4, 8, 16)])
def test_a_tile_that_can_be_read_in_two_ways_is_refused(
    tmp_path: Path, shape: tuple[int, int, int]
) -> None:
    """If both the first and the last axis could be slots, NS0845 names both readings."""
    mask = np.zeros(shape, bool)
    mask[0, 1, 2] = mask[1, 0, 0] = True
    first, middle, last = shape
    with pytest.raises(Rejected) as caught:
        imported(tmp_path, mask, None)
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code == "NS0845"
    assert f"{first} x {middle} pixels, {last} slots" in diagnostic.notes[0]
    assert f"{first} slots, {middle} x {last} pixels" in diagnostic.notes[1]


@pytest.mark.parametrize("axis", ["last", "first"])
def test_the_given_axis_of_a_mask_holds_its_slots(tmp_path: Path, axis: Axis) -> None:
    """A mask of 4 x 8 x 4 can be read in two ways. The given axis decides which values are the
    slots."""
    mask = np.zeros((4, 8, 4), bool)
    mask[0, 1, 2] = mask[1, 0, 0] = True
    stored = mask if axis == "last" else np.moveaxis(mask, 0, 2)
    _, shutters = imported(tmp_path, mask, axis)
    rows, cols, _ = stored.shape
    np.testing.assert_array_equal(shutters, np.tile(stored, (256 // rows, 256 // cols, 1)))


@pytest.mark.parametrize("axis", [0, 1])
def test_a_tile_keeps_a_last_line_that_equals_its_first(tmp_path: Path, axis: int) -> None:
    """Columns 0 1 2 0 repeat as 0 1 2 0 0 1 2 0, not as 0 1 2 0 1 2."""
    stop = np.array([[1, 2, 3, 1]]).repeat(4, axis=0)
    mask = by_stop(stop if axis else stop.T)
    found, shutters = imported(tmp_path, mask)
    assert found.tile == ((1, 4) if axis else (4, 1))
    np.testing.assert_array_equal(shutters, np.tile(mask, (64, 64, 1)))


@pytest.mark.parametrize("suffix", [".npy", ".npz", ".mat"])
def test_an_exported_mask_is_imported_to_the_same_shutters(tmp_path: Path, suffix: str) -> None:
    text = "nsl 1\nframe 8 slots of 1ms\ncode stop : 1..N\nopen when n < stop\n"
    (tmp_path / "p.nsl").write_text(text + "pixels stop = 1 + (x + 3 * y) % N\n")
    for line in (
        f"export-mask p.nsl -o m{suffix}",
        f"import-mask m{suffix} -o q.nsl",
        "export-mask q.nsl -o n.npy",
    ):
        done = invoke(line.split(), tmp_path)
        assert done.status == 0, done.err
    x, y = np.meshgrid(np.arange(256), np.arange(256))
    expected = by_stop(1 + (x + 3 * y) % 8)
    np.testing.assert_array_equal(read_mask(tmp_path / f"m{suffix}"), expected)
    mask = np.load(tmp_path / "n.npy")
    assert mask.dtype == np.uint8
    np.testing.assert_array_equal(mask, expected)


def test_masks_are_exported_by_bucket_and_refused_for_pixels_that_look(tmp_path: Path) -> None:
    examples = ROOT / "examples"
    program = str(examples / "two_buckets.nsl")
    assert invoke(["export-mask", program, "-o", "m.npy"], tmp_path).status == 0
    both = np.load(tmp_path / "m.npy")
    assert (both.ndim, both.dtype) == (4, np.uint8)
    container = compile_file(Path(program)).container
    assert container is not None
    for number, name in enumerate(container.buckets):
        assert (
            invoke(["export-mask", program, "-o", "m.npz", "--bucket", name], tmp_path).status == 0
        )
        np.testing.assert_array_equal(np.load(tmp_path / "m.npz")["mask"], both[number])
    refused = invoke(["export-mask", program, "-o", "m.npz", "--bucket", "x"], tmp_path)
    assert container.buckets[0] in refused.err
    looking = str(examples / "float_pixel.nsl")
    refused = invoke(["export-mask", looking, "-o", "k.npy"], tmp_path)
    assert refused.codes == ["NS0444"]
    assert not (tmp_path / "k.npy").exists()


def test_a_mask_with_a_code_for_every_pixel_is_imported(tmp_path: Path) -> None:
    """A mask whose 256 x 256 pixels have stops of their own is class b with a tile of the whole
    frame."""
    mask = by_stop(RNG.integers(1, 9, (256, 256)))
    found, shutters = imported(tmp_path, mask)
    assert (found.kind, found.tile) == ("b", (256, 256))
    np.testing.assert_array_equal(shutters, mask)


@pytest.mark.parametrize(
    ("mask", "reason"),
    [
        (np.full((4, 4, 8), 0.5), "neither 0 nor 1"),
        (np.ones((300, 4, 8)), "300 x 4"),
        (RNG.random((16, 16, 100)) < 0.5, "no class represents"),
    ],
)
def test_unsuitable_masks_are_refused_with_the_reason(
    tmp_path: Path, mask: np.ndarray, reason: str
) -> None:
    np.save(tmp_path / "m.npy", mask)
    with pytest.raises(Rejected) as caught:
        import_mask(tmp_path / "m.npy", "c.npz")
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code == "NS0847"
    assert reason in diagnostic.message
    if "no class" in reason:
        assert len(diagnostic.notes) >= 3


def test_import_mask_writes_a_program_or_codes_for_one(tmp_path: Path) -> None:
    mask = by_stop(1 + ORDER % 8)
    np.savez(tmp_path / "m.npz", mask=mask)
    done = invoke(["import-mask", "m.npz", "-o", "p.nsl", "--slots-axis", "last"], tmp_path)
    assert done.status == 0, done.err
    assert "class b, a tile of 8 x 8, " in done.err
    assert " axis of `mask`), " in done.err
    assert {path.name for path in tmp_path.iterdir()} == {"m.npz", "p.nsl", "p.codes.npz"}
    text = "nsl 1\nframe 8 slots of 1ms\ncode stop : 1..N\nopen when n < stop\n"
    (tmp_path / "q.nsl").write_text(text)
    line = [
        "run",
        "q.nsl",
        "--scene",
        "builtin:dark",
        "-o",
        "f.npz",
        "--keep",
        "shutter",
        "--pixels",
    ]
    done = invoke([*line, "m.npz", "--codes", "open"], tmp_path)
    assert done.status == 0, done.err
    with np.load(tmp_path / "f.npz") as file:
        shutters = np.unpackbits(file["shutter"], axis=-1, count=8, bitorder="little")
    np.testing.assert_array_equal(shutters[0], np.tile(mask, (32, 32, 1)))
    np.savez(tmp_path / "other.npz", mask=MASKS["c"])
    refused = invoke([*line, "other.npz", "--codes", "open"], tmp_path)
    assert (refused.status, refused.codes) == (2, ["NS0847"])
    (tmp_path / "q.nsl").write_text(text.replace("frame 8", "frame 9"))
    refused = invoke([*line, "m.npz", "--codes", "open"], tmp_path)
    assert "the mask has 8 slots of one bucket, the program has 9 slots" in refused.err


@pytest.mark.parametrize("suffix", [".npz", ".mat"])
def test_the_only_array_of_a_file_is_its_mask(suffix: str, tmp_path: Path) -> None:
    """A single array may have any name; one of several must be named `mask`."""
    mask = MASKS["b"].astype(float)

    def read(**arrays: np.ndarray) -> np.ndarray:
        path = tmp_path / f"a{suffix}"
        if suffix == ".npz":
            np.savez(path, **arrays)
        else:
            savemat(path, arrays)
        return read_mask(path)

    np.testing.assert_array_equal(read(S=mask), mask)
    np.testing.assert_array_equal(read(S=1 - mask, mask=mask), mask)
    with pytest.raises(Rejected, match="NS0845"):
        read(S=mask, T=mask)
