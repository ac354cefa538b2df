"""Shared code of commands that take a program: compile or load it with the build options."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import rejected
from nscc.options import Options
from nscc.toml.schema import declared
from nscc_cli.options import values_given
from nscc_cli.support import say, waiting

if TYPE_CHECKING:
    from nscc.diagnostics.diagnostic import Diagnostic
    from nscc.pipeline import Compiled
    from nscc.words.container import Container


def compile_program(path: Path, options: Mapping[str, Any], **overrides: Any) -> Compiled:
    """Compile the program at `path` with the options of a command. Raise Rejected if it does not
    compile.

    `overrides` are further fields of `nscc.pipeline.Options`, and `see`, an observer of the
    compiler's passes."""
    from nscc.compiler import compile_file

    see, chosen = overrides.pop("see", None), compile_options(options, **overrides)
    # The output of an observer and a progress line would disturb each other.
    with nullcontext() if see is not None else _compiling(path, chosen):
        return compile_file(path, chosen, see)


def compile_options(options: Mapping[str, Any], **overrides: Any) -> Options:
    """Return the compiler's options that the options of a command set. `overrides` are further
    fields; others keep their defaults."""
    return Options(**values_given(Options, options), **overrides)


def load_program(
    path: Path, options: Mapping[str, Any]
) -> tuple[Container, tuple[Diagnostic, ...]]:
    """Load an .icw file, or compile a program with the options of a command. Return the container
    and the messages.

    If the command has the option `pixels`, all pixels of the container have codes. Raises Rejected
    if the program does not compile, a file cannot be read or codes are invalid, and NS0743 (status
    2) if build options are given for a compiled program."""
    from nscc.containers import is_compiled, load_container, with_pixels

    chosen = compile_options(options)
    keys = declared(Options)
    names = ", ".join(
        keys[name].option for name in values_given(Options, options) if name != "cache"
    )
    if names and is_compiled(path):
        raise rejected(
            "NS0743",
            f"{names} cannot change '{path}', which is compiled already",
            notes=("these options control the compiler",),
            helps=(f"give the .nsl file instead, or leave {names} out",),
        )
    with _compiling(path, chosen):
        container, messages = load_container(path, chosen)
    if "pixels" in options:
        container = with_pixels(container, path, _pixel_codes(options["pixels"], container))
    return container, messages


def loaded(path: Path, options: Mapping[str, Any]) -> Container:
    """Return the container of `load_program`, after printing the messages."""
    container, messages = load_program(path, options)
    say(messages)
    return container


def _pixel_codes(path: Path | None, container: Container) -> Path | Mapping[str, Array] | None:
    """Return what `nscc.containers.with_pixels` takes for `path`, the value of the option --pixels:
    the path of a code file, or for a mask the codes that open its shutters. None (no option) stays
    None."""
    if path is None or not _is_mask(path):
        return path
    from nscc_training.imported_masks import codes_of_mask

    return codes_of_mask(path, container)


def _is_mask(path: Path) -> bool:
    """Return whether the file `path` is a mask: .npy, .mat, or an .npz that contains `mask` alone.
    Another .npz contains codes. A missing or damaged .npz is no mask."""
    if path.suffix.lower() != ".npz" or not path.is_file():
        return path.suffix.lower() in (".npy", ".mat")
    from zipfile import BadZipFile, ZipFile

    try:
        with ZipFile(path) as archive:
            return archive.namelist() == ["mask.npy"]
    except (BadZipFile, OSError):  # the function that reads the codes reports the error
        return False


def _compiling(path: Path, options: Options) -> AbstractContextManager[None]:
    """Return a context that shows in the terminal that the program is being compiled."""
    return waiting(f"compiling {path.name} at -O{options.level}")
