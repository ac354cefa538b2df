"""Frames that the software of a chip's own host saved, as frame files.

Such a host saves one picture for each readout: 8-bit converter codes of an analog register, or the
bits of a digital register. The pictures do not tell how the host turned or cut the array, so the
user states it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256
from io import BytesIO
from pathlib import Path
from typing import Any, Literal

import numpy as np

from nscc.arrays import Array, Bools, Bytes
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.files import read_whole
from nscc.npy import InvalidArrays, npy_array
from nscc.words.container import Container, state_registers
from nscc.words.file import to_bytes
from nscc.words.readout import converter_of
from nscc_runtime.device.device_chip import frame_of_readouts
from nscc_runtime.frame_file import FrameFile, Provenance, check_adc, meta
from nscc_runtime.response import with_decode_arrays
from nscc_runtime.run_kinds import Sent
from nscc_runtime.sensor import Sensor, default_sensor

PICTURES = (".bmp", ".png", ".tif", ".tiff", ".npy", ".csv")
"""Endings of the files that can be imported."""
Flip = Literal["none", "rows", "cols", "both"]


@dataclass(frozen=True)
class Orientation:
    """How the pictures of a host lie on the array.

    Parameters
    ----------
    crop : tuple of int, optional
        Row and column of the picture's pixel that is the array's first pixel; the rest is dropped.
    flip : {"none", "rows", "cols", "both"}
        Reverse the order of rows, of columns, or of both, after `crop`.
    transpose : bool
        Exchange rows and columns, after `flip`.
    """

    crop: tuple[int, int] | None = None
    flip: Flip = "none"
    transpose: bool = False

    def __str__(self) -> str:
        """Return what was cut and turned, as text: "no flip" if nothing."""
        cut = "" if self.crop is None else f"cut from row {self.crop[0]}, column {self.crop[1]}; "
        turned = "no flip" if self.flip == "none" else f"{self.flip} reversed"
        return cut + turned + (", rows and columns exchanged" if self.transpose else "")


def import_frame(
    container: Container,
    files: Sequence[Path] | Mapping[str, Path],
    orientation: Orientation | None = None,
    sensor: Sensor | None = None,
) -> FrameFile:
    """Return the frame file of pictures that a chip's own host saved.

    Parameters
    ----------
    container : Container
        The program that ran on the chip, with pixel codes.
    files : sequence of Path, or mapping of str to Path
        A picture for each name of `readout_names`, in this order or by name. Pictures of converter
        codes are 8-bit grey; pictures of bits have at most two values, of which one is 0.
    orientation : Orientation, optional
        By default, row 0 and column 0 of a picture are those of the array.
    sensor : Sensor, optional
        Converts converter codes to electrons, by default the sensor of the program's target.

    Returns
    -------
    FrameFile
        A frame without seeds, scene and plan. `meta` has "imported": files with their SHA-256
        digests, and the orientation.

    Raises
    ------
    Rejected
        NS0794 (status 2) for missing, superfluous or unsuitable pictures, NS0742 for a converter
        with more than 8 bits.
    """
    orientation = orientation or Orientation()
    analog, digital = readout_names(container)
    named = _by_name(files, [*analog, *digital])
    data = {name: _bytes_of(path) for name, path in named.items()}
    pictures = {name: (str(path), _picture(path, data[name])) for name, path in named.items()}
    about = {
        "files": {
            name: {"file": path.name, "sha256": sha256(data[name]).hexdigest()}
            for name, path in named.items()
        }
    }
    return frame_of_pictures(container, pictures, orientation, sensor, about)


def frame_of_pictures(
    container: Container,
    pictures: Mapping[str, tuple[str, Bytes]],
    orientation: Orientation,
    sensor: Sensor | None,
    about: Mapping[str, Any],
) -> FrameFile:
    """Return the frame file of pictures of a host.

    `container`: the program that ran. `pictures`: for each name of `readout_names` the origin of
    the picture, for messages, and its 8-bit values (rows, cols). `orientation`: how they lie on the
    array. `sensor` converts converter codes to electrons, None for the program's default. `about`:
    what `meta["imported"]` tells beside the orientation. Raises Rejected as `import_frame`."""
    target = container.target
    check_adc(target)
    sensor = sensor or default_sensor(converter_of(container))
    analog, digital = readout_names(container)
    shape = target.rows, target.cols
    laid = {
        name: _laid(picture, origin, shape, orientation)
        for name, (origin, picture) in pictures.items()
    }
    codes = np.zeros((len(analog), *shape), np.uint8)
    for number, name in enumerate(analog):
        largest = int(laid[name].max())
        if largest > target.top_code:
            reason = f"has codes up to {largest}, but the converter ends at {target.top_code}"
            raise _refused(pictures[name][0], f"it {reason}")
        codes[number] = laid[name]
    planes = {register: _bits(pictures[name][0], laid[name]) for name, register in digital.items()}
    frame = frame_of_readouts(codes, None, target, container, Sent(sensor, False, planes))
    digest = sha256(to_bytes(container)).hexdigest()
    origin = Provenance(digest, sensor, seed=None, device_seed=None, fidelity="imported")
    meta_values = meta(container, None, frame, origin)
    meta_values["imported"] = {
        **about,
        "crop": orientation.crop,
        "flip": orientation.flip,
        "transpose": orientation.transpose,
    }
    return with_decode_arrays(FrameFile(frame, meta_values, {}, {}), container)


def readout_names(container: Container) -> tuple[tuple[str, ...], dict[str, str]]:
    """Return the names of the analog readouts of a program, and the registers of digital readouts
    by the names of these, both in the order of readout.

    Analog readouts are buckets, then images. Digital readouts are planes, by their names in the
    program; of a program that reads states they are the registers of the states."""
    registers = state_registers(container)
    pictures = container.pictures
    by_register = {pictures.registers[name]: name for name in pictures.outputs}
    names = {by_register.get(register, register): register for register in registers}
    return (*container.buckets_read, *pictures.images_read), names


def _by_name(files: Sequence[Path] | Mapping[str, Path], names: Sequence[str]) -> dict[str, Path]:
    """Return the file of each of the readouts `names`. `files` are by name, or in the order of
    `names`. Raises Rejected (NS0794) for a missing or superfluous file."""
    listed = ", ".join(names) or "nothing"
    if isinstance(files, Mapping):
        unknown = [name for name in files if name not in names]
        missing = [name for name in names if name not in files]
        if unknown or missing:
            reason = (
                f"the program reads no '{unknown[0][:60]}'"
                if unknown
                else f"the picture of {', '.join(missing)} is missing"
            )
            raise rejected("NS0794", reason, notes=(f"the program reads: {listed}",))
        return {name: files[name] for name in names}
    if len(files) != len(names):
        raise rejected(
            "NS0794",
            f"the program has {len(names)} readouts, but {len(files)} pictures are given",
            notes=(f"the program reads, in this order: {listed}",),
            helps=("give one file for each, in this order or as NAME=FILE",),
        )
    return dict(zip(names, files, strict=True))


def _bytes_of(path: Path) -> bytes:
    """Return the bytes of the picture file `path`. Raises Rejected (NS0794) for an ending not in
    `PICTURES`, or if it cannot be read."""
    if path.suffix.lower() not in PICTURES:
        again = "save the codes without loss, as 8-bit grey values: .png for example"
        raise _refused(path, "its ending is none of " + ", ".join(PICTURES), (again,))
    try:
        return read_whole(path)
    except OSError as error:
        raise _refused(path, (error.strerror or str(error)).lower()) from error
    except ValueError as error:
        raise _refused(path, str(error)) from error


def _picture(path: Path, data: bytes) -> Bytes:
    """Return the 8-bit picture (rows, cols) that the content `data` of file `path` holds. Colour
    with three equal channels counts as grey, and alpha is dropped; true and false are 1 and 0.
    Raises Rejected (NS0794) for other arrays, and for values that are not whole or not 0 to 255."""
    values = _values(path, data)
    if values.ndim == 3 and values.shape[2] in (3, 4):
        grey = values[..., 0]
        if (values[..., 1] != grey).any() or (values[..., 2] != grey).any():
            raise _refused(path, "it is a picture in colour, but a readout is grey")
        values = grey
    if values.ndim != 2 or 0 in values.shape:
        raise _refused(path, f"it holds an array {values.shape}, not (rows, cols)")
    if values.dtype.kind == "b":
        return values.view(np.uint8)
    if values.dtype.kind not in "uif":
        raise _refused(path, f"it holds {values.dtype}, not numbers")
    whole = np.isfinite(values) & (values >= 0) & (values <= 255) & (values == np.trunc(values))
    if not whole.all():
        example = values[~whole].flat[0]
        raise _refused(path, f"it has the value {example:g}, but codes are whole, 0 to 255")
    return values.astype(np.uint8)


def _values(path: Path, data: bytes) -> Array:
    """Return the array of a .npy or .csv file with the content `data`, or of the picture file
    `path`, of any shape and type. A .csv has a row on each line, with commas between numbers.
    Raises Rejected if it cannot be read."""
    suffix = path.suffix.lower()
    if suffix == ".npy":
        try:
            return npy_array(BytesIO(data))
        except (InvalidArrays, OSError) as error:
            raise _refused(path, str(error)) from error
    if suffix == ".csv":
        try:
            rows = data.decode("utf-8-sig").strip().splitlines()
            return np.loadtxt(rows, delimiter=",", ndmin=2)
        except ValueError as error:
            reason = f"it is not a table of numbers separated by commas: {error}"
            raise _refused(path, reason[:200]) from error
    from nscc_runtime.scenes.picture_files import read_picture

    return read_picture(path)


def _laid(picture: Bytes, origin: str, shape: tuple[int, int], orientation: Orientation) -> Bytes:
    """Return `picture` (rows, cols) as it lies on the array of `shape` (rows, cols): cropped, then
    mirrored, then transposed, as `orientation` says.

    `origin` names the file in messages. Raises Rejected (NS0794) if what is left has another size
    than the array."""
    # The transposition comes last: before it the picture has the exchanged size.
    size = shape[::-1] if orientation.transpose else shape
    if orientation.crop is not None:
        row, col = orientation.crop
        picture = picture[row : row + size[0], col : col + size[1]]
    if picture.shape != size:
        cut = " after --crop" if orientation.crop is not None else ""
        helps = ("--crop R,C cuts the array out of a larger picture",)
        if picture.shape == size[::-1]:
            helps = ("--transpose exchanges rows and columns",)
        raise _refused(
            origin,
            f"it has {picture.shape[0]} x {picture.shape[1]} pixels{cut}, but the array has "
            f"{size[0]} x {size[1]}",
            helps,
        )
    # Flipped rows: the file begins with the last row of the array; columns alike.
    if orientation.flip in ("rows", "both"):
        picture = picture[::-1]
    if orientation.flip in ("cols", "both"):
        picture = picture[:, ::-1]
    return np.ascontiguousarray(picture.T if orientation.transpose else picture)


def _bits(origin: str, picture: Bytes) -> Bools:
    """Return the bits (rows, cols) of a `picture`: True where it is not 0. `origin` names it in
    messages. Raises Rejected (NS0794) for more than one value beside 0."""
    values = np.unique(picture)
    if len(values[values > 0]) > 1:
        raise _refused(
            origin, f"it has {len(values)} values, but the bits of a register are 0 and one other"
        )
    return picture > 0


def _refused(origin: Path | str, reason: str, helps: tuple[str, ...] = ()) -> Rejected:
    """Return the error (NS0794) that the picture `origin` is not a readout of the program, for this
    `reason`, with the remedies `helps`."""
    return rejected("NS0794", f"'{origin}' is not a readout of this program: {reason}", helps=helps)
