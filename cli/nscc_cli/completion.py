"""Shell completion: the values that a shell suggests for options and arguments.

A click type suggests its own values, so an option only declares `type=`. The values are computed
when the user presses the completion key, so that commands start fast."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import click
from click.shell_completion import CompletionItem, FishComplete, add_completion_class

Items = list[CompletionItem]


@dataclass(eq=False, repr=False)
class Name(click.types.StringParamType):
    """The click type of a name, for which the shell suggests known names: `further_names`, and
    those in `source`, MODULE:ATTRIBUTE, which is imported when the user asks for suggestions.

    The attribute is a list or a function that returns it, of texts or of objects with a `name`.
    `ending` is added to each of its names. With `files` it suggests files, too. With `several` the
    value is a list separated by commas, in which each name may follow one of the characters
    `signs`. Any text is accepted as a value."""

    name = "text"

    source: str
    further_names: Sequence[str] = ()
    files: bool = False
    several: bool = False
    signs: str = ""
    ending: str = ""

    def names(self) -> Iterator[str]:
        """Yield the further names, then those of the source with their ending."""
        yield from self.further_names
        if self.source:
            module, _, name = self.source.partition(":")
            entries = getattr(import_module(module), name)
            for entry in entries() if callable(entries) else entries:
                yield (entry if isinstance(entry, str) else entry.name) + self.ending

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> Items:
        """Return suggestions that begin with the text that the user has typed, `incomplete`. In a
        list, only the last name is completed; the suggestion repeats the text before it."""
        head, comma, typed = incomplete.rpartition(",") if self.several else ("", "", incomplete)
        sign = typed[:1] if typed[:1] in self.signs else ""
        before, typed = head + comma + sign, typed.removeprefix(sign)
        items = [CompletionItem(before + name) for name in self.names() if name.startswith(typed)]
        # Some shells complete files only if there is no name; they see this one first.
        return [*([CompletionItem(incomplete, type="file")] if self.files else []), *items]


class RunPath(click.Path):
    """The click type of a run folder. The shell suggests folders that contain a run, the runs that
    come with nscc, and further names."""

    def __init__(self, further_names: Sequence[str] = (), path_type: type[Any] = Path) -> None:
        """Suggest run folders, the runs that come with nscc, and `further_names`. `path_type` is
        the type of the parsed value."""
        super().__init__(path_type=path_type)
        self.more = further_names

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> Items:
        """Return suggestions that begin with the text that the user has typed, `incomplete`: any
        folder, then the names of runs, then run folders."""
        from nscc_training.run_files import shipped_runs

        names = [n for n in (*self.more, *shipped_runs()) if n.startswith(incomplete)]
        items = [CompletionItem(name) for name in (*names, *_runs(incomplete))]
        return [CompletionItem(incomplete, type="dir"), *items]


def _runs(typed: str) -> Iterator[str]:
    """Yield the run folders whose paths begin with the text that the user has typed; only the
    folder of the typed path is searched. A folder that cannot be read has none."""
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


TARGET = Name("nscc.chips.load:target_names", files=True)
EFFECT = Name("nscc_runtime.effects:registered")
EFFECTS = Name("nscc_runtime.effects:optional", ("auto", "all", "none"), several=True, signs="+-")
SETTING = Name("nscc_runtime.effects.registry:parameters", ending="=")
MESSAGE = Name("nscc.diagnostics.render:names")
EXAMPLE = Name("nscc.examples:examples")
KEPT = Name("nscc_runtime.frame_file:KEEP", several=True)
PRODUCTS = Name("nscc.emit.products:SUFFIXES", several=True)
PASS = Name("nscc.pipeline:PASSES")
PROTOCOL = Name("nscc_training.protocols:NAMES")
SCENE = Name("", ("builtin:hdr", "builtin:motion", "builtin:flat:", "builtin:dark"), files=True)
RUN = RunPath()
RUN_OR_ANY = RunPath(("any",), path_type=str)


class Fish(FishComplete):
    """Completion for the shell fish. It keeps a completed value that contains commas whole; the
    script that click generates would split it."""

    source_template = FishComplete.source_template.replace(
        'string split ","', "string split --max 1 ,"
    )


add_completion_class(Fish)
