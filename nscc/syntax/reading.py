"""Reading and decoding of program files."""

from __future__ import annotations

from pathlib import Path

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.diagnostics.rejection import rejected
from nscc.source import Source

MOST_BYTES = 256 * 1024


def read_source(path: Path) -> Source:
    """Read a program file and remove a byte order mark.

    Raises Rejected: NS0101 (status 2) if the file cannot be read, otherwise as `source_of` does.
    Reads at most 256 KiB."""
    name = path.as_posix()
    try:
        with open(path, "rb") as file:
            data = file.read(MOST_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        help_text = "name a shutter program, a text file that ends in .nsl"
        raise rejected("NS0101", f"cannot read '{name}': {reason}", helps=(help_text,)) from None
    return source_of(path, data)


def source_of(path: Path, data: bytes) -> Source:
    """Decode the bytes of a program file and remove a byte order mark.

    Raises Rejected (status 1): NS0103 if it exceeds 256 KiB, NS0102 if it is not UTF-8. The
    diagnostic has the file's name but no text."""
    name = path.as_posix()
    if len(data) > MOST_BYTES:
        raise (
            _not_text(path, f"byte {data.index(0)} is zero")
            if 0 in data
            else Rejected(too_large(name))
        )
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        place = f"byte {error.start} (0x{data[error.start]:02x})"
        raise _not_text(path, f"{place} is not UTF-8") from None
    if "\0" in text:
        raise _not_text(path, f"byte {data.index(0)} is zero")
    return Source(name, text)


def too_large(name: str) -> Diagnostic:
    """Return the error (NS0103) that a program text exceeds the size limit."""
    return Diagnostic(
        "NS0103",
        f"this program is larger than {MOST_BYTES // 1024} KiB, the largest size of a program",
        helps=('store data in a separate file: `pixels from "codes.npz"`',),
        source=Source(name, ""),
    )


def _not_text(path: Path, reason: str) -> Rejected:
    ending = path.suffix.lower()
    message = f"this file is not UTF-8 text: {reason}"
    helps = ("save the program as UTF-8 text; a compiled program ends in .icw",)
    if ending == ".icw":
        helps = (
            "it is compiled already: `nscc run`, `view`, `prove`, `shutters` and `disasm` "
            "accept it; this command needs the .nsl file",
        )
    elif ending != ".nsl":
        helps = ("name a shutter program, a text file that ends in .nsl; `nscc run PROGRAM.nsl "
                 "--scene SCENE` accepts pictures and clips",)  # fmt: skip
    return rejected("NS0102", message, helps=helps, status=1, source=Source(path.as_posix(), ""))
