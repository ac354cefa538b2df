"""The front door: runs a command and turns whatever happens into an exit status.

0 done; 1 the program is rejected; 2 wrong usage or configuration; 3 device or emulator
failure; 70 a fault of nscc itself; 130 interrupted.
"""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING

from nscc import __version__

if TYPE_CHECKING:
    import click

    from nscc.cli.support import Session
    from nscc.diagnostics.model import Diagnostic

DONE = 0
WRONG_USAGE = 2
FAULT = 70
INTERRUPTED = 130


def main(argv: Sequence[str] | None = None) -> int:
    """Run `nscc` with these arguments (default: the process's) and return the exit status."""
    arguments = list(sys.argv[1:] if argv is None else argv)
    if arguments == ["--version"]:
        print(f"nscc {__version__}")
        return DONE
    try:
        return _run(arguments)
    except KeyboardInterrupt:
        _quiet(lambda: sys.stderr.write("\ninterrupted\n"))
        return INTERRUPTED
    except BrokenPipeError:
        # The reader of our output has seen enough (`nscc disasm x.icw | head`).
        _silence_output()
        return DONE


def _run(arguments: list[str]) -> int:
    import click

    from nscc.cli.group import group
    from nscc.cli.support import Session, show
    from nscc.diagnostics.model import Rejected

    session = Session()
    _preset_format(arguments, session)
    if "_NSCC_COMPLETE" in os.environ:
        from click.shell_completion import shell_complete

        return shell_complete(group, {}, "nscc", "_NSCC_COMPLETE", os.environ["_NSCC_COMPLETE"])
    try:
        try:
            status = _invoke(group, arguments, session)
        finally:
            sys.stdout.flush()
    except Rejected as rejected:
        show(rejected.diagnostics, session.message_format)
        return rejected.status
    except click.exceptions.NoArgsIsHelpError as error:
        click.echo(error.ctx.get_help() if error.ctx else "", err=True)
        return WRONG_USAGE
    except click.ClickException as error:
        from nscc.cli.usage import usage_diagnostic

        show([usage_diagnostic(error)], session.message_format)
        return WRONG_USAGE
    except click.Abort as error:
        raise KeyboardInterrupt from error
    except BrokenPipeError:
        raise
    except Exception as error:
        from nscc.cli.fault import explain_exception

        diagnostic, status = explain_exception(error, arguments)
        show([diagnostic], session.message_format)
    return status


def _invoke(group: click.Group, arguments: list[str], session: Session) -> int:
    """Run the command; it may return its exit status, or nothing for 0."""
    import click

    try:
        with group.make_context("nscc", list(arguments), obj=session) as context:
            result = group.invoke(context)
    except click.exceptions.Exit as leave:
        return leave.exit_code
    return result if isinstance(result, int) and not isinstance(result, bool) else DONE


def _preset_format(arguments: list[str], session: Session) -> None:
    """Learn `--message-format` before parsing: wrong usage is reported in that format, too."""
    from nscc.cli.support import FORMATS

    for position, argument in enumerate(arguments):
        name, _, value = argument.partition("=")
        if argument == "--":
            return
        if name != "--message-format":
            continue
        if argument == name and position + 1 < len(arguments):
            value = arguments[position + 1]
        for known in FORMATS:
            if value == known:
                session.message_format = known
