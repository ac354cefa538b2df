"""Programs in the cells of a notebook: `%load_ext nscc`, then

    %%nsl stops --target scamp7
    nsl 1
    frame 256 slots of 125us
    code stop : 1..256
    open when n < stop

shows when shutters are open and what the words cost, and leaves the program as `stops`.
"""

from __future__ import annotations

import argparse
import shlex
import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any, NoReturn, get_args

from nscc.diagnostics.diagnostic import Rejected
from nscc.lower.plan import LOWERINGS
from nscc.pipeline import LEVELS, Options
from nscc.program.program import Codes
from nscc.shutter_program import ShutterProgram, compiled
from nscc.source import Source


class Refused(Rejected):
    """What is wrong with a cell. IPython shows it without the calls that led to it."""

    def _render_traceback_(self) -> list[str]:
        return str(self).splitlines()


class _Usage(Exception):
    """The first line of a cell asks for what there is not."""

    def _render_traceback_(self) -> list[str]:
        return str(self).splitlines()


class _Line(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise _Usage(f"%%nsl: {message}\n{self.format_usage().strip()}")


def _line() -> _Line:
    """The options of `nscc build`, as the first line of a cell has them."""
    found = _Line("%%nsl", add_help=False, allow_abbrev=False)
    found.add_argument("name", nargs="?", metavar="NAME")
    found.add_argument("-O", dest="level", type=int, choices=LEVELS)
    found.add_argument("--codes", choices=get_args(Codes))
    found.add_argument("--lowering", choices=("auto", *LOWERINGS))
    found.add_argument("--target")
    found.add_argument("--max-words-per-slot", type=int)
    return found


def load_ipython_extension(shell: Any) -> None:
    """Add the cell magic `%%nsl` to an IPython shell; `%load_ext nscc` calls this function.

    Parameters
    ----------
    shell : IPython.core.interactiveshell.InteractiveShell
    """

    def nsl(line: str, cell: str) -> ShutterProgram:
        """Compile the cell, show its shutters and costs; NAME, if given, becomes the program."""
        try:
            given = vars(_line().parse_args(shlex.split(line)))
        except ValueError as error:
            raise _Usage(f"%%nsl: {error}") from None
        name = given.pop("name")
        if name is not None and not name.isidentifier():
            raise _Usage(f"%%nsl: {name!r} is no name of a variable")
        options = Options(**{key: value for key, value in given.items() if value is not None})
        text = Source(f"In [{shell.execution_count}]", cell)
        try:
            with warnings.catch_warnings(action="ignore"):  # the card shows them
                program = compiled(text, Path(), options)
        except Rejected as rejected:
            raise Refused(rejected.diagnostics, rejected.status) from None
        if name is None:
            return program
        program = replace(program, name=name)
        shell.push({name: program})
        return program

    shell.register_magic_function(nsl, "cell", "nsl")
