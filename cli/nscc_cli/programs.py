"""What commands that take a program share: build's choices, and .nsl or .icw to a container."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nscc.diagnostics.rejection import rejected

if TYPE_CHECKING:
    from nscc.diagnostics.diagnostic import Diagnostic
    from nscc.pipeline import Compiled, Options
    from nscc.words.container import Container


@dataclass(frozen=True)
class BuildChoice:
    """Build's options as given; None where the user gave none. `cache`: results may be reused."""

    level: int | None = None
    codes: str | None = None
    lowering: str | None = None
    target: str | None = None
    cache: bool = True
    max_words_per_slot: int | None = None

    @classmethod
    def of(cls, options: Mapping[str, Any]) -> BuildChoice:
        """From a command's options by name."""
        return cls(**{field.name: options[field.name] for field in fields(cls)})

    def given(self) -> list[str]:
        """The options that were given, as the user spells them."""
        named = (
            ("-O", self.level),
            ("--codes", self.codes),
            ("--lowering", self.lowering),
            ("--target", self.target),
            ("--max-words-per-slot", self.max_words_per_slot),
        )
        return [name for name, value in named if value is not None]


def compile_program(path: Path, choice: BuildChoice, **more: Any) -> Compiled:
    """Compiles a program as `choice` says; Rejected where it does not compile.

    `more` are further fields of `nscc.pipeline.Options`, and `see`, an observer of its passes.
    """
    from nscc.compiler import compile_file

    see = more.pop("see", None)
    return compile_file(path, compile_options(choice, **more), see)


def compile_options(choice: BuildChoice, **more: Any) -> Options:
    """The compiler's options where `choice` gives some, its defaults elsewhere."""
    from nscc.pipeline import Options

    given = {name: value for name, value in vars(choice).items() if value is not None}
    return Options(**given, **more)


def load_program(path: Path, choice: BuildChoice) -> tuple[Container, tuple[Diagnostic, ...]]:
    """The container in an .icw file, or of a program that is compiled now; and its messages.

    Raises Rejected as `nscc.containers.load_container` does, and NS0743 (status 2) for build's
    options beside a compiled program.
    """
    from nscc.containers import is_compiled, load_container

    if is_compiled(path) and choice.given():
        names = ", ".join(choice.given())
        raise rejected(
            "NS0743",
            f"{names} cannot change '{path}': it is compiled already",
            notes=("build's options take effect where a program becomes words",),
            helps=(f"give the .nsl file instead, or leave {names} out",),
        )
    return load_container(path, compile_options(choice))
