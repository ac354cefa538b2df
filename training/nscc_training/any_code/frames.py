"""Conversion of frame files into measurements with their shutters, noise and saturation."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from hashlib import sha256
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Array, Bools, Floats, Floats32
from nscc.containers import is_compiled, load_container, with_pixels
from nscc.diagnostics.diagnostic import Diagnostic, rejected
from nscc.mappings import JsonObject
from nscc.npy import InvalidArrays
from nscc.options import Options
from nscc.words.container import Container
from nscc.words.file import to_bytes
from nscc_runtime.effects.sensor import before_readout_effects
from nscc_runtime.frame_arrays import read_frame_arrays
from nscc_runtime.frame_file import meta
from nscc_runtime.light import Light
from nscc_runtime.request import Request
from nscc_runtime.response import decode_arrays
from nscc_runtime.sensor import Sensor, default_sensor
from nscc_runtime.simulate import Simulated, simulate
from nscc_training.frame_reading import are_lengths, no_frame, number_of, read_dark, undarkened
from nscc_training.measured import Measured
from nscc_training.problems import one_line, why_no_arrays

_TOP = 255
"""The largest converter code, used as saturated if a frame does not mark saturated pixels."""
_WRITE = (
    "`nscc run FILE --scene .. -o FRAME.npz` writes one; a measurement of another camera contains "
    "`meas` and `mask`"
)
_MOST_VALUES = 1 << 28
"""Largest number of slots times pixels of a clip: 4096 slots of 256 x 256 pixels."""


class CodedFrame(NamedTuple):
    """A frame prepared for reconstruction, in electrons. It has B buckets: sums of light that each
    pixel collects under different shutters.

    `value_e` and `variance_e2` (B, rows, cols) are the light of the open slots and its variance.
    `saturated` (B, rows, cols) marks values that are lower limits. `opened` (shutters, B, N)
    contains the shutters, `row` (rows, cols) the index of each pixel's shutter, `slot_us` (N,) the
    slot lengths in microseconds."""

    value_e: Floats32
    variance_e2: Floats32
    saturated: Bools
    opened: Bools
    row: NDArray[np.integer]
    slot_us: Floats

    @property
    def is_still(self) -> bool:
        """Return whether every shutter, in every bucket, is open from the start until some slot
        (class b), or never opens.

        Such frames are decoded as stills: they contain no information about motion."""
        return bool((self.opened[..., :-1] >= self.opened[..., 1:]).all())

    def crop(self, rows: slice, cols: slice) -> CodedFrame:
        """Return the frame cut to these rows and columns. The table of shutters stays whole,
        because pixels refer to it by index."""
        window = (slice(None), rows, cols)
        return CodedFrame(
            self.value_e[window],
            self.variance_e2[window],
            self.saturated[window],
            self.opened,
            self.row[rows, cols],
            self.slot_us,
        )

    def clip(self) -> Measured[Array]:
        """Return the measurement for a clip decoder, with masks of N slots. Light is in electrons
        per slot of mean length; a mask is above 1 for a slot that is longer. Raises ValueError for
        too many slots times pixels."""
        weights = (self.opened * (self.slot_us / self.slot_us.mean())).astype(np.float32)
        return self._measured(weights)

    def still(self) -> Measured[Array]:
        """Return the measurement for a still decoder, with masks of one slot: the open fraction of
        the frame. Light is in electrons over the whole frame."""
        share = self.opened @ (self.slot_us / self.slot_us.sum())
        return self._measured(share[..., None].astype(np.float32))

    def _measured(self, weights: Floats32) -> Measured[Array]:
        """Return the frame as a batch of one measurement. `weights` (shutters, buckets, slots) say
        how much of the light of a slot each shutter collects.

        Raises ValueError if the masks of all pixels would have more than `_MOST_VALUES` values."""
        if weights.shape[2] * self.row.size > _MOST_VALUES:
            raise ValueError(
                f"{weights.shape[2]} slots of {self.row.size} pixels are too many: their product "
                f"may be at most {_MOST_VALUES:,}"
            )
        mask = np.ascontiguousarray(weights[self.row].transpose(2, 3, 0, 1))
        arrays = (self.value_e, mask, self.variance_e2, self.saturated)
        return Measured(*(array[None] for array in arrays))


def read_coded_frames(
    path: Path,
    program: Path | None = None,
    dark: Path | None = None,
    warn: Callable[[Diagnostic], None] = lambda _doubt: None,
) -> tuple[CodedFrame, ...]:
    """Read the frame file `path` that any program wrote. Return one frame, or three (red, green,
    blue) if it was exposed once for each colour.

    Repeated frames are averaged. `program` is the container (a compiled program) or text that
    exposed the frame; it is needed if the file contains no shutters, and checked if it does. `dark`
    is a frame file of the same program without light: each pixel's dark value replaces the mean
    offset of the words. `warn` receives warnings about `dark`. Raises Rejected: NS0819 for an
    invalid file, missing shutters, or a program or dark frame that does not belong to the frame,
    and the errors of loading `program`."""
    try:
        arrays, meta = read_frame_arrays(
            path, lambda name: name == "saturated" or name.startswith("decode_")
        )
    except (InvalidArrays, OSError) as error:
        raise no_frame(path, why_no_arrays(error), _WRITE) from error
    # A program that is named supplies the shutters, if it has exposed this frame.
    if program is not None:
        table = _table_of(path, program, meta)
        pixels, frame_pixels = (
            source[name].shape[-2:] for source, name in ((table, "decode_row"), (arrays, "frame"))
        )
        if pixels != frame_pixels:
            rows, cols = frame_pixels
            sizes = f"{rows} x {cols} pixels, but '{program}' has {pixels[0]} x {pixels[1]}"
            raise no_frame(path, f"it has {sizes}", "name the program that exposed the frame")
        if not _is_exposed_by(program, arrays, meta, table):
            reason = f"it was exposed with other shutters than those of '{program}'"
            raise no_frame(
                path,
                f"{reason} (`program_sha256` of its meta is another)",
                "name the .icw file that exposed it, or leave --program out "
                "if the frame contains its shutters",
            )
        arrays |= table
    if "decode_row" not in arrays:
        raise no_frame(
            path,
            "it does not contain the shutters of its pixels",
            "name the program that exposed it: --program FILE.icw",
        )
    offset = None if dark is None else _dark_of(dark, arrays, meta, warn)
    try:
        # Frames of three colours have one frame and one saturation mark for each colour.
        if "colours" not in meta:
            return (coded_frame(arrays, meta, offset),)
        by_colour = [name for name in ("frame", "saturated") if name in arrays]
        return tuple(
            coded_frame(arrays | {name: arrays[name][k] for name in by_colour}, meta, offset)
            for k in range(len(arrays["frame"]))
        )
    except (KeyError, ValueError, IndexError, TypeError) as error:
        reason = f"its arrays do not match each other: {one_line(error)}"
        raise no_frame(path, reason, _WRITE) from error


def _dark_of(
    path: Path,
    arrays: Mapping[str, Array],
    meta: Mapping[str, Any],
    warn: Callable[[Diagnostic], None],
) -> Floats:
    """Return the dark value (B, rows, cols) of each pixel, in converter codes above the offset,
    from the dark frame in the file `path`.

    `arrays` (with the decode table) and `meta` are those of the frame to be corrected. A large
    picture may be exposed in parts, by several arrays of pixels: then the dark frame may have the
    size of one array. `warn` receives doubts about the dark frame. Raises Rejected (NS0819) for
    another size or program, or a dark frame that contains light."""
    dark_frame = read_dark(path, arrays["decode_shutter"].shape[-2])
    frame_pixels, dark = arrays["frame"].shape[-2:], dark_frame.offset.shape[-2:]
    # A picture that was exposed in parts may end within the last part.
    laid = meta.get("laid")
    needed = [-(-most // side) for most, side in zip(frame_pixels, dark, strict=True)]
    fits = isinstance(laid, dict) and needed == laid.get("arrays")
    # The dark frame may also be repeated a whole number of times.
    if not fits and any(
        most < side or most % side for most, side in zip(frame_pixels, dark, strict=True)
    ):
        sizes = (
            f"{dark[0]} x {dark[1]} pixels, but the frame has {frame_pixels[0]} x {frame_pixels[1]}"
        )
        reason = f"the dark frame has {sizes}"
        raise no_frame(path, reason, "expose the dark frame with the same program")
    for doubt in dark_frame.checked(meta, dark):
        warn(doubt)
    return dark_frame.offset.reshape(-1, *dark)


def exposed_frame(
    container: Container, light: Light, sensor: Sensor, request: Request
) -> CodedFrame:
    """Expose `light` with the program in `container` on the emulated chip. Return the frame with
    its shutters, noise and saturation.

    `light` is in the program's slots, `sensor` is that of the chip. `request` chooses the effects
    and the seed. Raises KeyError if the program's shutters depend on the light, as those of pixels
    that look."""
    return coded_capture(container, light, sensor, simulate(container, light, sensor, request))


def coded_capture(
    container: Container, light: Light, sensor: Sensor, simulated: Simulated
) -> CodedFrame:
    """Convert the `simulated` frame of the program in `container`, exposed to `light`, into the
    form that is reconstructed, with the shutters, noise and saturation that program and `sensor`
    give. Raises KeyError if the program's shutters depend on the light."""
    about = meta(container, light, simulated.frame, simulated.origin)
    table = decode_arrays(container, sensor, about["plan"])
    arrays = {"frame": simulated.frame.frame, "saturated": simulated.frame.saturated}
    return coded_frame(arrays | table, about)


def coded_frame(
    arrays: Mapping[str, Array],
    meta: Mapping[str, Any],
    dark: Floats | None = None,
) -> CodedFrame:
    """Convert the arrays and `meta` of a frame file, which holds one frame or repeated frames
    (averaged).

    `arrays` contains `frame` ([repeats,] B, rows, cols), perhaps `saturated` of the same shape
    (else the largest code marks it), and the decode table (`decode_shutter`, `decode_row`,
    `decode_slot_us`, `decode_gain`, `decode_bias_e`, `decode_variance_e2`). `dark` (B, rows, cols)
    is each pixel's code in the dark above the ADC's offset; None subtracts the bias of the table
    instead. Raises KeyError, ValueError, IndexError or TypeError for arrays that are missing or do
    not match."""
    codes = arrays["frame"]
    codes = codes[None] if codes.ndim == 3 else codes
    saturated = arrays.get("saturated", arrays["frame"] == _TOP)
    saturated = (saturated[None] if saturated.ndim == 3 else saturated).any(axis=0)
    slot_us, row = arrays["decode_slot_us"], arrays["decode_row"]
    opened = np.unpackbits(
        arrays["decode_shutter"], axis=-1, count=len(slot_us), bitorder="little"
    ).astype(bool)
    if not are_lengths(slot_us):
        raise ValueError("`decode_slot_us` are not valid slot lengths")
    if codes.shape[1:] != (opened.shape[1], *row.shape):
        raise ValueError(f"frames of {codes.shape[1:]}, shutters of {opened.shape[1:]}")
    responses = [arrays[f"decode_{name}"] for name in ("gain", "bias_e", "variance_e2")]
    if any(values.shape != opened.shape[:2] or values.dtype.kind != "f" for values in responses):
        raise ValueError(f"responses of other shapes than the shutters, {opened.shape[:2]}")
    gain, bias_e, variance_e2 = (response[row].transpose(2, 0, 1) for response in responses)
    # A variance may be infinite: such a code says nothing about the light.
    largest = np.maximum(np.abs(gain), np.abs(bias_e))
    known = (np.abs(gain) > 1e-15) & (largest < 1e15) & (variance_e2 >= 0)
    if not known.all():
        raise ValueError(
            "the response (`decode_gain`, `decode_bias_e`, `decode_variance_e2`) is not numeric"
        )
    read = codes.mean(axis=0) - number_of(meta, "adc_offset")
    if dark is not None:
        # A dark frame went through the same words, so it contains their bias.
        read, bias_e = undarkened(read, dark), np.zeros_like(bias_e)
    exposure_e = read * number_of(meta, "electrons_per_lsb")
    value_e = (exposure_e - bias_e) / gain
    plan = meta.get("plan")
    kept_effects = (
        [] if plan is None else [e["name"] for e in plan["effects"] if e["decision"] == "kept"]
    )
    if plan is None or "shot" in kept_effects:  # only simulations can lack photon noise
        variance_e2 = variance_e2 + np.maximum(exposure_e, 0)
    variance_e2 = variance_e2 / (len(codes) * gain**2)
    arrays_e = (value_e.astype(np.float32), variance_e2.astype(np.float32))
    return CodedFrame(*arrays_e, saturated, opened, row, slot_us)


def _table_of(path: Path, program: Path, meta: JsonObject) -> dict[str, Array]:
    """Return the decode table that an older frame file at `path` lacks, computed from its `program`
    and its `meta`.

    Raises Rejected (NS0819) for a damaged meta, or if the codes do not determine the shutters, as
    in pixels that look."""
    container = with_pixels(load_container(program)[0], program)
    values = meta.get("sensor", default_sensor(container.target).values)
    try:
        values = {**before_readout_effects(values), **values}
        table = decode_arrays(container, Sensor(values), meta.get("plan"))
    except (KeyError, TypeError, AttributeError) as error:
        raise no_frame(path, f"its meta is damaged: {one_line(error)}", _WRITE) from error
    if not table:
        raise rejected(
            "NS0819",
            f"the codes of '{program}' do not determine the shutters of its pixels",
            notes=("its shutters depend on the light, or its words do not implement shutters",),
            helps=("name the program that exposed the frame",),
        )
    return table


def _is_exposed_by(
    program: Path,
    arrays: Mapping[str, Array],
    meta: Mapping[str, Any],
    table: Mapping[str, Array],
) -> bool:
    """Return whether a frame was exposed with the shutters of a program, whose decode table is
    `table`.

    If the frame's `arrays` contain shutters, these are compared. Otherwise the digest in `meta` is
    compared with the compiled program's at each optimisation level; a frame without a digest
    passes."""
    if "decode_row" in arrays:
        same_slots = np.array_equal(arrays["decode_slot_us"], table["decode_slot_us"])
        opened, table_shutters = (
            source["decode_shutter"][source["decode_row"]] for source in (arrays, table)
        )
        return same_slots and np.array_equal(opened, table_shutters)
    digest = meta.get("program_sha256")
    # A compiled program has one level, and any number reads it; of texts the usual level is first.
    levels = (2,) if is_compiled(program) else (2, 1, 0, 3)
    containers = (load_container(program, Options(level=level))[0] for level in levels)
    return digest is None or any(
        sha256(to_bytes(with_pixels(container, program))).hexdigest() == digest
        for container in containers
    )
