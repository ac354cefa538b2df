"""What a shell offers after an option or for an argument, and how it is told.

A kind of value says so itself, as a click type: options declare it with `type=`, and need no more.
Names are asked for when somebody presses the key, so that commands do not wait for them.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

import click
from click.shell_completion import CompletionItem, FishComplete, add_completion_class

Items = list[CompletionItem]


class Name(click.types.StringParamType):
    """Any text; shells offer `names`, and with `files` what lies in folders, too.

    With `several` the text is a list with commas between; each name may have one of `signs` before
    it.
    """

    name = "text"

    def __init__(
        self, names: Callable[[], Iterable[str]], *, files: bool = False, several: bool = False,
        signs: str = "",
    ) -> None:  # fmt: skip
        self.names, self.files, self.several, self.signs = names, files, several, signs

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> Items:
        """The names that begin as what was typed does."""
        head, comma, typed = incomplete.rpartition(",") if self.several else ("", "", incomplete)
        sign = typed[:1] if typed[:1] and typed[:1] in self.signs else ""
        before, typed = head + comma + sign, typed.removeprefix(sign)
        found = [CompletionItem(before + name) for name in self.names() if name.startswith(typed)]
        # Shells that look at files only where there is no name see this one first.
        return [*([CompletionItem(incomplete, type="file")] if self.files else []), *found]


class RunPath(click.Path):
    """The folder of a run; shells offer those, `names`, and folders on the way to them."""

    def __init__(
        self, names: Callable[[], Iterable[str]] = tuple, path_type: type[Any] = Path
    ) -> None:
        super().__init__(path_type=path_type)
        self.names = names

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> Items:
        """Folders that `nscc train` has written, and the names that begin alike."""
        names = [name for name in self.names() if name.startswith(incomplete)]
        found = [CompletionItem(name) for name in (*names, *_runs(incomplete))]
        return [CompletionItem(incomplete, type="dir"), *found]


def _runs(typed: str) -> Iterator[str]:
    """The run folders whose paths begin as typed."""
    from nscc_training.run_files import CONFIG

    folder, begin = os.path.split(typed)
    try:
        entries = sorted(entry.name for entry in os.scandir(folder or ".") if entry.is_dir())
    except (OSError, ValueError):
        return
    for name in entries:
        path = os.path.join(folder, name)
        if name.startswith(begin) and os.path.isfile(os.path.join(path, CONFIG)):
            yield path


def _targets() -> Iterable[str]:
    from nscc.target.load import target_names

    return target_names()


def _effects() -> Iterable[str]:
    from nscc_runtime.effects import registered

    return [effect.name for effect in registered()]


def _choices_of_effects() -> Iterable[str]:
    from nscc_runtime.effects import optional

    return ("auto", "all", "none", *optional())


def _settings() -> Iterable[str]:
    from nscc_runtime.effects.registry import parameters

    return [f"{parameter.name}=" for parameter in parameters()]


def _codes() -> Iterable[str]:
    from nscc.diagnostics.render import names

    return names()


def _examples() -> Iterable[str]:
    from nscc.examples import examples

    return examples()


def _kept() -> Iterable[str]:
    from nscc_runtime.frame_file import KEEP

    return KEEP


def _products() -> Iterable[str]:
    from nscc.emit.products import SUFFIXES

    return SUFFIXES


def _passes() -> Iterable[str]:
    from nscc.pipeline import PASSES

    return [each.name for each in PASSES]


def _protocols() -> Iterable[str]:
    from nscc_training.protocols import NAMES

    return NAMES


def _shipped_runs() -> Iterable[str]:
    from nscc_training.run_files import shipped_runs

    return shipped_runs()


def _scenes() -> Iterable[str]:
    return "builtin:hdr", "builtin:motion", "builtin:flat:", "builtin:dark"


TARGET = Name(_targets, files=True)
EFFECT = Name(_effects)
EFFECTS = Name(_choices_of_effects, several=True, signs="+-")
SETTING = Name(_settings)
MESSAGE = Name(_codes)
EXAMPLE = Name(_examples)
KEPT = Name(_kept, several=True)
PRODUCTS = Name(_products, several=True)
PASS = Name(_passes)
PROTOCOL = Name(_protocols)
SCENE = Name(_scenes, files=True)
RUN = RunPath(_shipped_runs)
RUN_OR_ANY = RunPath(lambda: ("any", *_shipped_runs()), path_type=str)


class Fish(FishComplete):
    """Click's own script for fish takes the part of a value behind a comma for something else."""

    source_template = FishComplete.source_template.replace(
        'string split ","', "string split --max 1 ,"
    )


add_completion_class(Fish)
