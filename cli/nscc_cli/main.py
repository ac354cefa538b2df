"""The entry point: runs a command and turns its outcome into an exit status.

0 success; 1 program rejected; 2 wrong usage or configuration; 3 device or emulator failed; 70
fault of nscc; 130 interrupted."""

from __future__ import annotations

import atexit
import gc
import os
import signal
import sys
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from io import TextIOWrapper
from typing import TYPE_CHECKING

from nscc import __version__
from nscc_cli.streams import open_streams, output_failure

if TYPE_CHECKING:
    from types import FrameType

    from nscc.diagnostics.diagnostic import Diagnostic
    from nscc_cli.support import Session

DONE = 0
WRONG_USAGE = 2
INTERRUPTED = 130


def main(argv: Sequence[str] | None = None) -> int:
    """Run `nscc` with the arguments `argv` and return the exit status. None takes the arguments of
    the process.

    The status is 0 if the command succeeded, 130 after Ctrl-C, and else 1, 2, 3 or 70, which
    `nscc_cli.fault` names. Only without `argv` are settings of the process changed: streams,
    signals and garbage collection."""
    if argv is None:
        # Imported objects are permanent: searching them for garbage takes a tenth of `check`. The
        # group turns the collector on again when the command's module is imported.
        gc.disable()
        open_streams()
        _write_names_in_utf8()
    arguments = list(sys.argv[1:] if argv is None else argv)
    if arguments == ["--version"]:
        print(f"nscc {__version__}")
        return DONE
    try:
        with _interrupts(of_process=argv is None) as interrupts:
            status = _run(arguments, interrupts)
        if argv is None:
            gc.freeze()  # at exit, Python would search all objects for garbage
        return status
    except KeyboardInterrupt as stop:
        sys.stderr.write(f"\ninterrupted{': ' * bool(stop.args)}{stop}\n")
        if argv is None:
            signal.signal(signal.SIGINT, _leave)
            # When Python ends, it removes handlers, so that Ctrl-C would kill it with another
            # status. Signals that are ignored stay ignored.
            atexit.register(signal.signal, signal.SIGINT, signal.SIG_IGN)
        return INTERRUPTED
    except BrokenPipeError:
        # The reader has closed our output (`nscc disasm x.icw | head`). This is not an error, and
        # the interpreter must not report it again when it flushes the remaining output.
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        return DONE


def _write_names_in_utf8() -> None:
    """Make the standard streams write file names byte by byte if the locale is ASCII (POSIX).
    Otherwise a name with other letters would raise an error."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper) and stream.encoding.lower() in ("ascii", "us-ascii"):
            stream.reconfigure(encoding="utf-8", errors="surrogateescape")


@contextmanager
def _interrupts(*, of_process: bool) -> Iterator[list[int]]:
    """Yield a list to which interrupts (SIGINT) are appended. The first one raises
    KeyboardInterrupt.

    A second one, while the command cleans up, ends the process if it is ours (`of_process`). The
    list is needed because C code may discard the exception, as torch does while it imports numpy,
    and fail later. Outside the main thread, or if another handler is set, nothing is changed and
    the list stays empty."""
    came: list[int] = []

    def remember(number: int, frame: FrameType | None) -> None:
        """Note an interrupt and raise KeyboardInterrupt. A second interrupt ends the process at
        once, if it is ours."""
        if came and of_process:
            os.write(2, b"\ninterrupted\n")
            _leave()
        came.append(number)
        signal.default_int_handler(number, frame)

    in_main = threading.current_thread() is threading.main_thread()
    ours = in_main and signal.getsignal(signal.SIGINT) is signal.default_int_handler
    if ours:
        signal.signal(signal.SIGINT, remember)
    try:
        yield came
    finally:
        if ours:
            signal.signal(signal.SIGINT, signal.default_int_handler)


def _leave(*_signal: object) -> None:
    """End the process at once, without a traceback: an interrupted user does not want to wait."""
    os._exit(INTERRUPTED)


def _run(arguments: list[str], interrupts: Sequence[int]) -> int:
    """Run the command that `arguments` (without `nscc`) name, print its messages, and return the
    exit status.

    Raises KeyboardInterrupt if the command failed with another exception while `interrupts` (see
    `_interrupts`) is not empty, and BrokenPipeError if nobody reads the output any more."""
    import click

    from nscc.diagnostics.diagnostic import Rejected
    from nscc.files import wrote_files
    from nscc_cli.support import Session, say_refused_cache, show, show_gathered

    session = Session(arguments=arguments)
    _preset_format(arguments, session)
    diagnostics: tuple[Diagnostic, ...] = ()
    try:
        try:
            status = _invoke(arguments, session)
        except Exception as error:
            # A library may turn Ctrl-C into an error of its own; it still counts as an interrupt.
            if interrupts:
                raise KeyboardInterrupt from error
            raise
        finally:
            sys.stdout.flush()
        failure = output_failure()
        if failure is not None and not wrote_files():
            raise failure  # the product itself went to standard output
    except Rejected as rejected:
        diagnostics, status = rejected.diagnostics, rejected.status
    except click.ClickException as error:
        from nscc_cli.usage import usage_diagnostic

        diagnostics, status = (usage_diagnostic(error),), WRONG_USAGE
    except BrokenPipeError:
        raise
    except click.Abort as error:
        raise KeyboardInterrupt from error
    except Exception as error:
        from nscc_cli.fault import explain_exception

        diagnostic, status = explain_exception(error, arguments)
        diagnostics = (diagnostic,)
    show(diagnostics, session)
    say_refused_cache(session)
    show_gathered(session)
    return status


def _invoke(arguments: list[str], session: Session) -> int:
    """Run the command that `arguments` name, with `session` as its context, and return its exit
    status. A command that returns None has status 0.

    If a shell asks for completions, print them instead."""
    import click

    from nscc_cli.group import group

    if "_NSCC_COMPLETE" in os.environ:  # set by the shell's completion script
        from click.shell_completion import shell_complete

        return shell_complete(group, {}, "nscc", "_NSCC_COMPLETE", os.environ["_NSCC_COMPLETE"])
    try:
        with group.make_context("nscc", list(arguments), obj=session) as context:
            result = group.invoke(context)
    except click.exceptions.Exit as leave:
        return leave.exit_code
    return result if isinstance(result, int) and not isinstance(result, bool) else DONE


def _preset_format(arguments: list[str], session: Session) -> None:
    """Set `session.message_format` to the value of --message-format in `arguments` before they are
    parsed, if it is valid, so that usage errors have this format, too."""
    from nscc_cli.support import FORMATS

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
