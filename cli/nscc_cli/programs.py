"""What commands that take a program share: build's options, and .nsl or .icw to a container."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected

if TYPE_CHECKING:
    from nscc.pipeline import Compiled, Options
    from nscc.words.container import Container

Command = TypeVar("Command", bound=Callable[..., Any])

_SUFFIX = ".icw"


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


def build_options(function: Command) -> Command:
    """Adds the options of BuildChoice, under the names of its fields."""
    options = (
        click.option(
            "-O",
            "level",
            type=click.IntRange(0, 3),
            help="How long to search for fewer words (default: 2; check: 1).",
        ),
        click.option(
            "--codes",
            type=click.Choice(["fixed", "open"]),
            help="Compile for the codes in use, or for every legal one (default: fixed).",
        ),
        click.option(
            "--lowering",
            type=click.Choice(["auto", "accumulate", "latch", "edges"]),
            help="How exposure is gathered (default: auto, the cheapest).",
        ),
        click.option(
            "--target", metavar="NAME|FILE.toml", help="The chip, instead of the program's own."
        ),
        click.option(
            "--cache/--no-cache",
            default=True,
            help="Keep search results of -O2 and -O3 and reuse them (default), or search anew.",
        ),
        click.option(
            "--max-words-per-slot",
            metavar="W",
            type=click.IntRange(min=1),
            help="Reject what executes more words than this in any slot.",
        ),
    )
    for option in reversed(options):
        function = option(function)
    return function


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

    given = {
        "level": choice.level,
        "codes": choice.codes,
        "lowering": choice.lowering,
        "target": choice.target,
        "max_words_per_slot": choice.max_words_per_slot,
    }
    changes: dict[str, Any] = {k: v for k, v in given.items() if v is not None}
    changes["cache"] = choice.cache
    return replace(Options(), **changes, **more)


def load_program(path: Path, choice: BuildChoice) -> tuple[Container, tuple[Diagnostic, ...]]:
    """The container in an .icw file, or of a program that is compiled now; and its messages.

    Raises Rejected where it does not compile or cannot be read, and NS0743 (status 2) for build's
    options beside a compiled program.
    """
    if path.suffix.lower() != _SUFFIX:
        compiled = compile_program(path, choice)
        assert compiled.container is not None  # what does not fit is rejected
        return compiled.container, compiled.diagnostics
    if choice.given():
        names = ", ".join(choice.given())
        raise Rejected(
            Diagnostic(
                "NS0743",
                f"{names} cannot change '{path}': it is compiled already",
                notes=("build's options take effect where a program becomes words",),
                helps=(f"give the .nsl file instead, or leave {names} out",),
            ),
            status=2,
        )
    from nscc.words.file import read_container

    return read_container(path), ()
