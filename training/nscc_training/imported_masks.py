"""Conversion of masks into programs: the smallest tile, and the cheapest class that
represents it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from nscc.arrays import Bools, Floats, Ints
from nscc.chips.load import load_target
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.program.problems import counted
from nscc.words.container import Container
from nscc_training.array_files import ambiguous_axes, is_square_tile, read_mask
from nscc_training.code_choices import ShutterSpec, over_array
from nscc_training.codes_files import codes_bytes
from nscc_training.command_settings import Axis
from nscc_training.programs import CODES_FILE, MOST_LISTED, Chip, compiled, program, words_per_slot

Codes = dict[str, Ints]
_MOST_BITS = 62
"""Most bits of a code of class e, an int64."""
_MOST_SHAPES = 4096
"""Most different shutters of a mask that become rows of a codebook."""


class ImportedMask(NamedTuple):
    """A program that opens the shutters of a mask.

    `text` is the program, `codes` the content of its code file (empty if not needed), `kind` its
    class of shutters ("a" to "e" or "codebook"), and `tile` the size (rows, cols) of its tile.
    `words_per_slot` counts instruction words. `axes` says how the axes of the mask were read.
    `reasons` explain why the other classes were not chosen."""

    text: str
    codes: bytes
    kind: str
    tile: tuple[int, int]
    words_per_slot: float
    axes: str
    reasons: tuple[str, ...]


def import_mask(
    path: Path,
    codes_name: str,
    *,
    slot_us: float = 125.0,
    target: str = "scamp5",
    slots_axis: Axis | None = None,
) -> ImportedMask:
    """Find the program of a mask.

    Parameters
    ----------
    path : Path
        A .npy, .npz or .mat file of `mask`, (rows, cols, slots) or (slots, rows, cols), of 0 and 1.
        It covers the whole array, or a tile that repeats over it.
    codes_name : str
        The file name of the codes in the program's text.
    slot_us : float
        The length of a slot in microseconds.
    target : str
        The chip, a name or a file.
    slots_axis : {"first", "last"}, optional
        The axis of slots; needed for a tile whose axes can be read in two ways.

    Raises
    ------
    Rejected
        NS0845 for a file without a mask, or with an ambiguous one, NS0847 for a mask that no class
        represents.
    """
    chip = Chip(target, slot_us)
    table = load_target(target, Path())
    array = (table.rows, table.cols)
    stored = read_binary_mask(path)
    axis_name = slots_axis or _slots_axis(path, stored.shape, array)
    mask = _slots_first(stored, axis_name)
    axes = f"{counted(len(mask), 'slot')} (the {axis_name} axis of `mask`)"
    shutters, tile = _tile(mask, array, path)
    reasons: list[str] = []
    fitting: list[ImportedMask] = []
    for spec, codes in _candidates(shutters, tile, reasons):
        files = program(spec, codes, chip, f"Imported from {path.name}.")
        try:
            compiled_program = compiled(files, chip)
        except Rejected as error:
            reasons.append(f"class {spec.kind}: {error.diagnostics[0].message}")
            continue
        container = compiled_program.built
        assert container.pixel_codes is not None
        lanes = container.table.shutter_of_code[container.pixel_codes]
        # Each pair of the program's and the mask's shutter of a pixel is compared once.
        places = over_array(tile, *lanes.shape)
        pairs = np.unique(np.stack([lanes.reshape(-1), places.reshape(-1)]), axis=1)
        if not np.array_equal(container.table.shutters[pairs[0], 0], shutters[pairs[1]]):
            raise ValueError("the program opens other shutters than the mask")
        text = files.text.replace(f'"{CODES_FILE}"', f'"{codes_name}"')
        words = words_per_slot(compiled_program)
        packed = codes_bytes(codes) if codes else b""
        size = (tile.shape[0], tile.shape[1])
        fitting.append(
            ImportedMask(
                text,
                codes=packed,
                kind=spec.kind,
                tile=size,
                words_per_slot=words,
                axes=axes,
                reasons=(),
            )
        )
    if not fitting:
        raise rejected(
            "NS0847",
            f"no class represents the mask of '{path}' on {table.name}",
            notes=tuple(reasons),
            helps=("use fewer slots or fewer different shutters, or a target with more registers",),
        )
    best = min(fitting, key=lambda candidate: candidate.words_per_slot)
    reasons += [
        f"class {candidate.kind}: {candidate.words_per_slot:g} words a slot, not fewer than "
        f"{best.words_per_slot:g}"
        for candidate in fitting
        if candidate is not best
    ]
    return best._replace(reasons=tuple(reasons))


def read_binary_mask(path: Path) -> Floats:
    """Read the mask of three axes in file `path`, with values 0 and 1, float64. Raise Rejected:
    NS0847 for other values, and the errors of `read_mask`."""
    mask = read_mask(path)
    count = int(np.count_nonzero((mask != 0) & (mask != 1)))
    if count:
        raise rejected(
            "NS0847",
            f"{count} of {mask.size} values of the mask in '{path}' are neither 0 nor 1",
            notes=("a shutter is open or closed for a whole slot",),
            helps=("make it binary, `mask > 0.5`, or divide each of its slots into several slots",),
        )
    return mask


def codes_of_mask(path: Path, container: Container) -> Codes:
    """Return the codes of all pixels, int64 (rows, cols) by field, with which a program opens the
    shutters of a mask.

    `path` is the file of the mask, `container` the compiled program.

    Raises
    ------
    Rejected
        NS0845 and NS0847 for the mask, and NS0847 for shutters that the program does not have.
    """
    target, table = container.target, container.table
    stored = read_binary_mask(path)
    axis_name = _slots_axis(path, stored.shape, (target.rows, target.cols), container.slots)
    mask = _slots_first(stored, axis_name)
    known = {
        row.tobytes(): code
        # If several codes have a shutter, the first one is used.
        for code, row in reversed(
            [*enumerate(np.packbits(table.shutters[table.shutter_of_code, 0], axis=-1))]
        )
    }
    shutters, tile = _tile(mask, (target.rows, target.cols), path)
    shutter_codes = [known.get(row.tobytes()) for row in np.packbits(shutters, axis=-1)]
    missing = shutter_codes.count(None)
    fits = shutters.shape[1] == container.slots and len(container.buckets) == 1
    if missing or not fits:
        raise rejected(
            "NS0847",
            f"the program does not have the shutters of the mask in '{path}'",
            notes=(
                f"{missing} of {len(shutter_codes)} shutters of the mask are unknown to it"
                if fits
                else f"the mask has {shutters.shape[1]} slots of one bucket, the program has "
                f"{container.slots} slots; buckets: {', '.join(container.buckets)}",
            ),
            helps=(
                "`nscc import-mask MASK -o P.nsl` writes a program that does; `--codes open` "
                "compiles for every legal code",
            ),
        )
    codes = table.codes[np.array(shutter_codes)[over_array(tile, target.rows, target.cols)]]
    return {name: np.ascontiguousarray(codes[..., k]) for k, name in enumerate(table.fields)}


def _slots_axis(
    path: Path, shape: tuple[int, ...], array: tuple[int, int], slots: int | None = None
) -> Axis:
    """Return the axis of slots ("first" or "last") of a mask with this `shape`.

    The sizes of the `array` (rows, cols) decide if the mask has them, else the number of `slots` of
    the program (None: not known). A square tile decides, too. The documented order has slots last.
    Raises Rejected (NS0845) for the mask of `path` if it can be read in two ways."""
    if shape[:2] == array:
        return "last"
    if shape[1:] == array:
        return "first"
    if slots is not None:
        return "first" if shape[0] == slots != shape[2] else "last"
    if is_square_tile(shape) or shape[0] > array[0] or shape[1] > array[1]:
        return "last"
    raise ambiguous_axes(path, shape)


def _slots_first(mask: Floats, axis: Axis) -> Bools:
    """Return a mask of three axes as booleans (slots, rows, cols), true where it is above 0. `axis`
    says which of its axes are the slots: "first", or "last" as in (rows, cols, slots)."""
    return (np.moveaxis(mask, 2, 0) if axis == "last" else mask) > 0


def _tile(mask: Bools, array: tuple[int, int], path: Path) -> tuple[Bools, Ints]:
    """Return the distinct shutters (K, slots) of a mask (slots, rows, cols), and for each pixel of
    its smallest repeating tile the index of its shutter.

    `array` is the size (rows, cols) of the chip. Raises Rejected (NS0847) for the mask of `path` if
    it is larger."""
    slots, rows, cols = mask.shape
    if rows > array[0] or cols > array[1]:
        raise rejected(
            "NS0847",
            f"the mask in '{path}' is {rows} x {cols}, but the array is {array[0]} x {array[1]}",
            helps=(
                "crop the mask to the array, use a larger --target, or name the axis of slots: "
                "--slots-axis first",
            ),
        )
    packed = np.packbits(mask, axis=0).reshape(-1, rows * cols).T
    _, first, place = np.unique(packed, axis=0, return_index=True, return_inverse=True)
    places = place.reshape(rows, cols)
    down = _period(places, is_whole=rows == array[0])
    across = _period(places.T, is_whole=cols == array[1])
    tile = places[:down, :across]
    if tile.size > MOST_LISTED and tile.shape != array:
        # A file of codes has one code per pixel of the array.
        tile = over_array(tile, *array)
    return np.ascontiguousarray(mask.reshape(slots, -1).T[first]), tile


def _period(places: Ints, is_whole: bool) -> int:
    """Return the smallest period of `places` (rows, cols), numbers of shutters, along their first
    axis: the number of rows after which all rows repeat. Without a period it is the number of rows.

    A tile is repeated as a whole, so its period must divide the number of rows. If the mask covers
    the array (`is_whole`), the last period may be incomplete."""
    count = len(places)
    periods = (n for n in range(1, count) if is_whole or count % n == 0)
    return next((n for n in periods if np.array_equal(places[n:], places[:-n])), count)


def _candidates(
    shutters: Bools, tile: Ints, reasons: list[str]
) -> Iterator[tuple[ShutterSpec, Codes]]:
    """Yield each class of shutters that has all `shutters` (K, slots), with the codes of the tile,
    int64 by field (`book` (K, slots) of a codebook). The order is that of the classes; several may
    fit.

    `tile` (rows, cols) holds the index of each pixel's shutter. For every other class, a sentence
    is appended to `reasons`."""
    count, slots = shutters.shape
    shape = (tile.shape[0], tile.shape[1])
    # argmax finds the first open slot; backwards, it counts the closed slots at the end.
    start, stop = shutters.argmax(axis=1), slots - shutters[:, ::-1].argmax(axis=1)
    lengths = shutters.sum(axis=1)
    bumps = (lengths > 0) & (stop - start == lengths)
    if count == 1 and shutters.all():
        yield ShutterSpec("a", slots, tile=(1, 1)), {}
    if not bumps.all():
        reason = f"{np.count_nonzero(~bumps)} of {count} shutters open more than once, or never"
        reasons.append(f"classes b, c, d: {reason}")
    else:
        if not start.any():
            yield ShutterSpec("b", slots, tile=shape), {"stop": stop[tile]}
        else:
            reasons.append(f"class b: {np.count_nonzero(start)} of {count} shutters open later")
        if len(set(lengths)) == 1:
            length = int(lengths[0])
            yield ShutterSpec("c", slots, tile=shape, length=length), {"start": start[tile]}
        else:
            span = f"{lengths.min()} to {lengths.max()}"
            reasons.append(f"class c: shutters are open for {span} slots, not for one length")
        yield ShutterSpec("d", slots, tile=shape), {"start": start[tile], "stop": stop[tile]}
    if count <= _MOST_SHAPES:
        book = shutters.astype(np.int64)
        yield ShutterSpec("codebook", slots, tile=shape, rows=count), {"id": tile, "book": book}
    else:
        reasons.append(
            f"codebook: {count} different shutters, but at most {_MOST_SHAPES} can be listed"
        )
    if slots <= _MOST_BITS:
        bits = (shutters.astype(np.int64) << np.arange(slots)).sum(axis=1)
        yield ShutterSpec("e", slots, tile=shape), {"bits": bits[tile]}
    else:
        reasons.append(f"class e: {slots} slots, but a code has at most {_MOST_BITS} bits")
