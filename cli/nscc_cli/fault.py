"""Messages for unexpected exceptions: failing files, missing memory, and faults of nscc."""

from __future__ import annotations

import io
import os
import platform
import re
import sys
import traceback
import zipfile
from collections.abc import Sequence
from hashlib import sha256
from pathlib import Path

from nscc import __version__
from nscc.diagnostics.diagnostic import Diagnostic, Rejected

REJECTED = 1
WRONG_USAGE = 2
FAILED = 3
FAULT = 70

_MOST_BYTES = 4 << 20
"""Largest size in bytes of an input file that is copied into a reproducer; larger files are only
named."""


def explain_exception(error: Exception, arguments: Sequence[str]) -> tuple[Diagnostic, int]:
    """Return the diagnostic and exit status for `error`, an exception that no command expects.
    `arguments` are those of the command line.

    NS0784 (status 2) if a file or stream fails, NS0902 (3) if memory runs out, NS0903 (1) if the
    input is nested too deeply, NS0904 (2) if a package is missing, otherwise NS0901 (70), for which
    a reproducer is saved."""
    from nscc_training.problems import is_out_of_memory, one_line

    error_text = one_line(error)
    if is_out_of_memory(error):
        on_gpu = type(error).__name__ == "OutOfMemoryError"
        less = "use fewer slots, codes or repeats, a smaller array, or leave `--keep` out"
        processor = (
            "with CUDA_VISIBLE_DEVICES= before the command it runs on the processor, "
            "which is slower"
        )
        return Diagnostic(
            "NS0902",
            _memory_text(error_text, on_gpu),
            notes=(error_text,) if error_text else (),
            helps=(_LESS.get(arguments[0] if arguments else "", less), *([processor] * on_gpu)),
        ), FAILED
    if isinstance(error, RecursionError):
        deep = "this input is nested too deeply"
        hint = "use fewer parentheses, or name parts of an expression with `let`"
        return Diagnostic("NS0903", deep, helps=(hint,)), REJECTED
    if isinstance(error, ModuleNotFoundError) and not (error.name or "nscc").startswith("nscc"):
        from nscc.requirements import distribution_of, line_for

        name = distribution_of(error.name or "")
        return Diagnostic(
            "NS0904",
            f"the Python package '{name}', which this command needs, is not installed",
            helps=(
                f"install nscc with what this needs: {line_for(error.name or '')}",
                "`nscc doctor` lists installed and missing packages",
            ),
        ), WRONG_USAGE
    if isinstance(error, OSError) and error.errno is not None and not _of_nscc(error.filename):
        file_text = f" '{error.filename}'" if error.filename else ""
        reason = error.strerror or str(error)
        hint = "name another file or folder, or make this one accessible"
        refused = f"cannot read or write{file_text}: {reason}"
        return Diagnostic("NS0784", refused, helps=(hint,)), WRONG_USAGE
    notes, hint = save_reproducer("".join(traceback.format_exception(error)), arguments)
    failed = f"nscc itself failed: {type(error).__name__}: {error_text}"
    return Diagnostic("NS0901", failed, notes=notes, helps=(hint,)), FAULT


_NEEDED = re.compile(r"allocate (?:memory: you tried to allocate )?([\d.]+ (?:[KMGTP]i?B|bytes))")


def _memory_text(error_text: str, on_gpu: bool) -> str:
    """Return a sentence on how much memory was needed and is free, with the numbers that
    `error_text` and the system tell. `on_gpu` means the memory of a GPU, whose free part is
    unknown."""
    needed = _NEEDED.search(error_text)
    asked = f"one array needs {needed[1]}" if needed else "this needs more than is free"
    if on_gpu:
        return f"there is not enough memory on the GPU: {asked}"
    # The size of a page in GiB.
    page = os.sysconf("SC_PAGE_SIZE") / (1 << 30)
    free, total = (os.sysconf(name) * page for name in ("SC_AVPHYS_PAGES", "SC_PHYS_PAGES"))
    return (
        f"there is not enough memory: {asked}, but {free:.1f} of {total:.1f} GiB of memory are free"
    )


_LESS = {
    "train": "reduce train.batch or data.patch, for instance --set train.batch=2; or use fewer "
    "slots, or a narrower decoder (decoder.width)",
    **dict.fromkeys(
        ("reconstruct", "classify", "evaluate"),
        "use a run with a smaller decoder, or fewer files at once",
    ),
}
"""A help for each command on how to reduce its memory use."""


def _of_nscc(filename: object) -> bool:
    """Return whether a file lies in the folder of nscc's packages. If such a file fails, the
    installation is broken."""
    root = os.path.realpath(Path(__file__).parents[1]) + os.sep
    return isinstance(filename, str) and os.path.realpath(filename).startswith(root)


def save_reproducer(trace: str, arguments: Sequence[str]) -> tuple[tuple[str, ...], str]:
    """Save a .zip file with the command line (`arguments`, without `nscc`), its input files, the
    versions and the traceback `trace`.

    Return the notes and the help of the message, which name the file. If it cannot be saved, the
    notes contain the traceback."""
    versions = f"nscc {__version__}\nPython {sys.version}\n{platform.platform()}\n"
    members = {
        "command.txt": "\n".join(["nscc", *arguments, ""]).encode(errors="replace"),
        "traceback.txt": trace.encode(errors="replace"),
        "versions.txt": versions.encode(),
    }
    for number, path in enumerate(_inputs(arguments)):
        members[f"inputs/{number}-{path.name}"] = _content(path)
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            # The earliest date of the format, so that the same fault gives the same file.
            archive.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), content)
    saved = _save(packed.getvalue())
    if saved is None:
        none = "the reproducer could not be saved in the current or the temporary folder"
        return (none, trace), "please report it with the text above and your input"
    return (
        (f"this is a fault of nscc, not of your input; a reproducer saved as '{saved}'",),
        "please check its contents (it includes the input files) and report it",
    )


def _save(data: bytes) -> str | None:
    """Save the reproducer, whose content is `data`, in the current folder, else in the folder for
    temporary files. Return its path, or None if both fail. Its name contains its digest."""
    import tempfile

    from nscc.files import write_whole

    name = f"nscc-fault-{sha256(data).hexdigest()[:12]}.zip"
    for path in (Path(name), Path(tempfile.gettempdir()) / name):
        try:
            write_whole(path, data)
        except Rejected:
            continue
        return str(path)
    return None


def _inputs(arguments: Sequence[str]) -> list[Path]:
    """Return the existing files, each once, that the arguments name, and those that programs (.nsl)
    among them name in quotes."""
    named = [Path(argument) for argument in arguments if _is_file(Path(argument))]
    input_files = list(named)
    for program in named:
        if program.suffix == ".nsl":
            quoted = re.findall(r'"([^"\n]{1,255})"', _content(program).decode(errors="replace"))
            input_files.extend(path for name in quoted if _is_file(path := program.parent / name))
    return list(dict.fromkeys(input_files))


def _is_file(path: Path) -> bool:
    """Return whether the path is a file; False also for paths that the system refuses."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False


def _content(path: Path) -> bytes:
    """Return the content of the file `path` for a fault report, or a line that says why it is not
    copied: above `_MOST_BYTES`, or unreadable."""
    try:
        size = path.stat().st_size
        if size > _MOST_BYTES:
            return f"{path}: {size} bytes, not copied\n".encode(errors="replace")
        return path.read_bytes()
    except OSError as error:
        return f"{path}: {error}\n".encode(errors="replace")
