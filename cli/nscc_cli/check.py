"""`nscc check`: report errors of programs and whether they fit the chip, without writing files."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from time import sleep
from typing import Any

import click

from nscc.compiler import CHECK, files_of
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.emit.summary import summary
from nscc.mappings import NamedValues
from nscc.pipeline import Compiled
from nscc.program.problems import counted
from nscc_cli.options import PATH, build_options, flag
from nscc_cli.programs import compile_program
from nscc_cli.support import common_command, say, say_done, session, show
from nscc_runtime.device.loaders import loader_notes

_MOST_ROUNDS = 20
"""Most passes of automatic fixes over a file; each pass fixes at least one error."""


@common_command("check")
@click.argument("files", nargs=-1, required=True, metavar="FILE...", type=PATH)
@flag("--fix", "First apply all safe fixes to the files; names are not guessed.")
@flag("--watch", "Check again whenever a file changes, until Ctrl-C.")
@build_options
def command(files: tuple[Path, ...], fix: bool, watch: bool, **options: Any) -> int:
    """Check programs: report errors, whether they fit the chip, and whether their words are right.

    Compiles at -O1 unless -O is given, and proves the result. If only a longer search can tell
    whether a program fits, a note refers to `nscc build`."""
    if options["level"] is None:
        options["level"] = CHECK.level
    if watch:
        return _watch(files, fix, options)
    _check(files, fix, options)
    return 0


def _check(files: tuple[Path, ...], fix: bool, options: NamedValues) -> None:
    """Compile the programs `files` with the command's `options`, by name, and print their messages
    and summaries. With `fix`, first apply safe fixes to the files.

    All programs are checked before Rejected is raised with the errors of all of them."""
    diagnostics: list[Diagnostic] = []
    status = 0
    for path in files:
        try:
            if fix:
                _mend(path, options)
            compiled = compile_program(path, options, unproved_is_error=CHECK.unproved_is_error)
            say([*compiled.diagnostics, *_loader_notes(compiled)])
        except Rejected as rejected:
            diagnostics.extend(rejected.diagnostics)
            status = max(status, rejected.status)
        else:
            click.echo(summary(path.as_posix(), compiled))
    if diagnostics:
        raise Rejected(diagnostics, status)


def _loader_notes(compiled: Compiled) -> list[Diagnostic]:
    """Return notes about loaders that cannot take the program `compiled`; none if it is unknown
    whether it fits the chip."""
    if compiled.container is None:
        return []
    program = compiled.program
    return list(loader_notes(compiled.container, program.source, program.frame.span))


def _watch(files: tuple[Path, ...], fix: bool, options: NamedValues) -> int:
    """Check the programs `files` now and after each change of a file that they consist of, until
    the user presses Ctrl-C. Return the exit status of the last check.

    Raises UsageError for SARIF messages, which are a single document. `fix` and `options` are those
    of the command."""
    if session().message_format == "sarif":
        raise click.UsageError(
            "--watch runs forever, but a SARIF log is a single document: use json"
        )
    status = 0
    try:
        for names in rounds(lambda: set().union(*map(files_of, files))):
            if names:
                say_done(f"\n--- {', '.join(names)} changed ---")
            try:
                _check(files, fix, options)
                status = 0
            except Rejected as rejected:
                show(rejected.diagnostics)
                status = rejected.status
            say_done(f"watching {', '.join(path.as_posix() for path in files)}: Ctrl-C ends it")
    except KeyboardInterrupt:
        say_done("")
    return status


def _mend(path: Path, options: NamedValues) -> None:
    """Apply all safe fixes to the program at `path`, in place. `options` are those of the command.
    Check it again after each round, at most `_MOST_ROUNDS`, because one error may hide another.
    Raises Rejected only if the file cannot be read or written."""
    from nscc.diagnostics.message import with_safe_fixes
    from nscc.files import write_back
    from nscc.syntax.parse import read_source

    count = 0
    for _ in range(_MOST_ROUNDS):
        source = read_source(path)
        try:
            compile_program(path, options, unproved_is_error=CHECK.unproved_is_error)
        except Rejected as rejected:
            better, fixes = with_safe_fixes(source, rejected.diagnostics)
        else:
            break
        if not fixes:
            break
        count += fixes
        write_back(path, better.text.encode())
    if count:
        say_done(f"fixed {path.as_posix()}: {counted(count, 'change')}")


_PAUSE_S = 0.2

State = tuple[int, ...] | None
"""A summary of a file's state that changes with its content; None if the file does not exist."""


def rounds(files: Callable[[], Iterable[Path]]) -> Iterator[list[str]]:
    """Yield an empty list, then after each change the names of the changed files.

    The iterator never ends; it waits while nothing changes. Changes while the caller works are not
    missed. `files` returns the paths to watch. It is called again after each change, because the
    set of files may change. Files may be missing and appear later."""
    known_states = _states(files())
    changed: list[str] = []
    while True:
        yield changed
        now = _states(files())
        # A file that is new in the set counts as unchanged.
        known_states = {path: known_states.get(path, state) for path, state in now.items()}
        while now == known_states:
            sleep(_PAUSE_S)
            now = _states(now)
        changed = sorted(path.as_posix() for path in now if now[path] != known_states[path])
        known_states = now


def _states(files: Iterable[Path]) -> dict[Path, State]:
    """Return the state of each file. Two states differ if the file was written between them."""
    return {path: _state(path) for path in files}


def _state(path: Path) -> State:
    """Return modification time (ns), size (bytes) and inode number of a file, one of which changes
    when it is written. Return None if it is missing."""
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    return status.st_mtime_ns, status.st_size, status.st_ino
