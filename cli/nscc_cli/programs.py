"""What commands that take a program share: from build's options and a file to words."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nscc.diagnostics.rejection import rejected

if TYPE_CHECKING:
    from nscc.diagnostics.diagnostic import Diagnostic
    from nscc.pipeline import Compiled, Options
    from nscc.words.container import Container

_SPELLED = {
    "level": "-O",
    "codes": "--codes",
    "lowering": "--lowering",
    "target": "--target",
    "max_words_per_slot": "--max-words-per-slot",
}
"""Build's options, and how the user spells them; `cache` changes nothing in a product."""


def compile_program(path: Path, options: Mapping[str, Any], **more: Any) -> Compiled:
    """Compiles a program as a command's options say; Rejected where it does not compile.

    `more` are further fields of `nscc.pipeline.Options`, and `see`, an observer of its passes.
    """
    from nscc.compiler import compile_file

    see = more.pop("see", None)
    return compile_file(path, compile_options(options, **more), see)


def compile_options(options: Mapping[str, Any], **more: Any) -> Options:
    """The compiler's options where a command's options give some, its defaults elsewhere."""
    from nscc.pipeline import Options

    return Options(**_given(options, *_SPELLED, "cache"), **more)


def load_program(
    path: Path, options: Mapping[str, Any]
) -> tuple[Container, tuple[Diagnostic, ...]]:
    """The container in an .icw file, or of a program that is compiled now; and its messages.

    A command that has the option `pixels` gets a container whose pixels have codes.

    Raises Rejected as `nscc.containers.load_container` does, and NS0743 (status 2) for build's
    options beside a compiled program.
    """
    from nscc.containers import is_compiled, load_container, with_pixels

    names = ", ".join(_SPELLED[name] for name in _given(options, *_SPELLED))
    if names and is_compiled(path):
        raise rejected(
            "NS0743",
            f"{names} cannot change '{path}': it is compiled already",
            notes=("build's options take effect where a program becomes words",),
            helps=(f"give the .nsl file instead, or leave {names} out",),
        )
    container, messages = load_container(path, compile_options(options))
    if "pixels" in options:
        container = with_pixels(container, path, options["pixels"])
    return container, messages


def _given(options: Mapping[str, Any], *names: str) -> dict[str, Any]:
    return {name: options[name] for name in names if options.get(name) is not None}
