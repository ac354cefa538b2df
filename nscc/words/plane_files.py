"""Bit planes from files, and the pixel codes of hand-written programs."""

from __future__ import annotations

from collections.abc import Mapping
from hashlib import sha256
from io import BytesIO
from pathlib import Path

import numpy as np

from nscc.arrays import Bools, Ints32
from nscc.chips.target import Target
from nscc.diagnostics.suggest import meant
from nscc.files import reads
from nscc.npy import InvalidArrays, npy_array, npz_arrays
from nscc.words.directives import Faults, PlaneDraft, shown

_LARGEST_FILE = 1 << 28
"""Largest file of arrays that is read, in bytes."""


class _BadPlaneError(Exception):
    """Raised for an invalid plane file; the text is the reason."""


def read_planes(
    drafts: list[PlaneDraft], target: Target, base: Path, faults: Faults
) -> dict[str, Bools]:
    """Return the bit planes of `.plane` lines, bool (rows, cols), by register, in the target's
    order.

    Files are relative to `base`. Unknown registers (NS0712), registers with two planes (NS0719) and
    unusable files (NS0716) are reported in `faults`; the result must then not be used."""
    planes: dict[str, Bools] = {}
    for draft in drafts:
        register = draft.register.text
        if register not in target.digital_registers:
            message = f"{target.name} has no digital register {shown(register)}"
            helps = meant(register, target.digital_registers)
            faults.add("NS0712", message, draft.register.span, helps=helps)
        elif register in planes:
            helps = ("keep one `.plane` line for each register",)
            faults.add("NS0719", f"{register} has two planes", draft.register.span, helps=helps)
        try:
            stated_sha256 = draft.sha256.text if draft.sha256 else None
            shape = (target.rows, target.cols)
            planes[register] = _plane(base / draft.file.text, register, shape, stated_sha256)
        except _BadPlaneError as error:
            message = f"the plane file {shown(draft.file.text)} cannot be used: {error}"
            helps = (f"a plane is a .npy file of {shape[0]} x {shape[1]} values 0 or 1",)
            faults.add("NS0716", message, draft.file.span, helps=helps)
    return {name: planes[name] for name in target.digital_registers if name in planes}


def codes_of_planes(planes: Mapping[str, Bools], target: Target) -> tuple[Bools, Ints32 | None]:
    """Return the distinct register contents of pixels, bool (codes, registers), and each pixel's
    row of them, int32 (rows, cols).

    `planes` are bool (rows, cols) by register; other registers are 0. Without planes there is one
    code with all registers 0, and the second result is None."""
    if not planes:
        return np.zeros((1, len(target.digital_registers)), dtype=np.bool_), None
    pattern = np.zeros((target.rows, target.cols), dtype=np.int64)
    for bit, plane in enumerate(planes.values()):
        pattern |= plane.astype(np.int64) << bit
    distinct, codes = np.unique(pattern, return_inverse=True)
    encoding = np.zeros((len(distinct), len(target.digital_registers)), dtype=np.bool_)
    for bit, register in enumerate(planes):
        encoding[:, target.digital_registers.index(register)] = distinct >> bit & 1
    return encoding, codes.reshape(pattern.shape).astype(np.int32)


def _plane(path: Path, register: str, shape: tuple[int, int], stated_sha256: str | None) -> Bools:
    """Return a bit plane from an .npy or .npz file, bool of this `shape` (rows, cols).

    An .npz file has one array of any name, or several, one of which has the name of `register`.
    Raises _BadPlaneError if the file cannot be read, is too large, has another digest than
    `stated_sha256` (None: any) or another shape, or has values other than 0 and 1."""
    try:
        if not path.is_file():
            raise _BadPlaneError("it is not a file" if path.exists() else "it does not exist")
        reads(path)
        with open(path, "rb") as file:
            data = file.read(_LARGEST_FILE + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or "invalid path"
        raise _BadPlaneError(reason) from None
    if len(data) > _LARGEST_FILE:
        raise _BadPlaneError(f"it has more than {_LARGEST_FILE} bytes")
    actual_sha256 = sha256(data).hexdigest()
    if stated_sha256 is not None and stated_sha256.lower() != actual_sha256:
        raise _BadPlaneError(f"its SHA-256 is {actual_sha256}, not {stated_sha256[:64]!a}")
    stream = BytesIO(data)
    try:
        if data.startswith(b"\x93NUMPY"):
            values = npy_array(stream)
        else:
            _, names = npz_arrays(stream, lambda _: False)
            if register not in names and len(names) != 1:
                count = len(names)
                raise _BadPlaneError(
                    f"none of its {count} arrays has the name of the register, {register}"
                )
            name = register if register in names else names[0]
            values = npz_arrays(stream, name.__eq__)[0][name]
    except (InvalidArrays, MemoryError, OSError) as error:
        raise _BadPlaneError(str(error)) from None
    if values.shape != shape:
        raise _BadPlaneError(f"its shape is {values.shape}, but the array has {shape}")
    if values.dtype.kind not in "biuf":
        raise _BadPlaneError(f"its values are of type {values.dtype}, not numbers")
    if not np.isin(values, (0, 1)).all():
        raise _BadPlaneError("it contains values other than 0 and 1")
    return values.astype(np.bool_)
