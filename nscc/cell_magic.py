"""Notebook cells with programs: after `%load_ext nscc`, the cell

    %%nsl stops --target scamp7
    nsl 1
    frame 256 slots of 125us
    code stop : 1..256
    open when n < stop

shows the open times of shutters and the cost in words, and assigns the program to `stops`."""

from __future__ import annotations

import argparse
import shlex
import warnings
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, NoReturn

from nscc.diagnostics.diagnostic import Rejected
from nscc.options import Options
from nscc.shutter_program import ShutterProgram, compiled
from nscc.source import Source
from nscc.toml.kinds import Flag, Kind
from nscc.toml.schema import keys_of
from nscc.toml.toml_text import spelled_value


class CellRejected(Rejected):
    """Raised for errors in a cell; IPython shows them without a traceback."""

    def _render_traceback_(self) -> list[str]:
        """Return what a notebook shows instead of a Python traceback: the messages."""
        return str(self).splitlines()


class _Usage(Exception):
    """Raised for invalid options in the first line of a cell."""

    def _render_traceback_(self) -> list[str]:
        """Return what a notebook shows instead of a Python traceback: the message."""
        return str(self).splitlines()


class _Line(argparse.ArgumentParser):
    """The parser of the line after `%%nsl`."""

    def error(self, message: str) -> NoReturn:
        """Raise an error with the message and the usage, instead of ending the process."""
        raise _Usage(f"%%nsl: {message}\n{self.format_usage().strip()}")


def _line() -> _Line:
    """Return the parser of a cell's first line: an optional name for the program, and the options
    of `nscc build` that take a value."""
    parser = _Line("%%nsl", add_help=False, allow_abbrev=False)
    parser.add_argument("name", nargs="?", metavar="NAME")
    for key in keys_of(Options):
        if not isinstance(key.kind, Flag):
            parser.add_argument(key.option, dest=key.attribute, type=partial(_read, key.kind))
    return parser


def _read(kind: Kind, text: str) -> Any:
    """Return the value that `text` spells for an option of this kind; quotes around a text are
    optional.

    Raises ArgumentTypeError, with what is allowed, for a text that does not spell such a value."""
    try:
        return kind.read(spelled_value(text))
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not {kind.allowed}") from None


def load_ipython_extension(shell: Any) -> None:
    """Add the cell magic `%%nsl` to an IPython shell; `%load_ext nscc` calls this function.

    Parameters
    ----------
    shell : IPython.core.interactiveshell.InteractiveShell
    """

    def nsl(line: str, cell: str) -> ShutterProgram:
        """Compile a cell and return the program, which a notebook then shows; assign it to NAME if
        one is given.

        `line` is the rest of the cell's first line, `cell` the text below. Raises _Usage for
        invalid options, and CellRejected for errors in the program."""
        try:
            arguments = vars(_line().parse_args(shlex.split(line)))
        except ValueError as error:
            raise _Usage(f"%%nsl: {error}") from None
        name = arguments.pop("name")
        if name is not None and not name.isidentifier():
            raise _Usage(f"%%nsl: {name!r} is not a valid variable name")
        options = Options(**{key: value for key, value in arguments.items() if value is not None})
        text = Source(f"In [{shell.execution_count}]", cell)
        try:
            with warnings.catch_warnings(action="ignore"):  # the notebook's card shows the warnings
                program = compiled(text, Path(), options)
        except Rejected as rejected:
            raise CellRejected(rejected.diagnostics, rejected.status) from None
        if name is None:
            return program
        program = replace(program, name=name)
        shell.push({name: program})
        return program

    shell.register_magic_function(nsl, "cell", "nsl")
