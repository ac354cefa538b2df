"""What every command shares: the common options, messages and progress."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Sequence, Sized
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from threading import Event, Thread
from time import monotonic
from typing import Any, Literal, TypeVar

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.diagnostics.rejection import rejected
from nscc.diagnostics.suggest import meant
from nscc.files import inputs_kept, reads

Item = TypeVar("Item")
MessageFormat = Literal["human", "short", "json", "github", "sarif"]
FORMATS: tuple[MessageFormat, ...] = ("human", "short", "json", "github", "sarif")

_BAR_DELAY_S = 1.0
_BAR_REFRESH_S = 0.1
_BAR_WIDTH = 30


@dataclass
class Session:
    """How one invocation of nscc talks to its user."""

    message_format: MessageFormat = "human"
    deny_warnings: bool = False
    arguments: Sequence[str] = ()
    """The command line, for reproducers."""
    gathered: list[Diagnostic] = field(default_factory=list)
    """What is said when all is done: a SARIF log is one document."""


class NumberRange(click.FloatRange):
    """A number within limits. Comparing tells nothing about NaN, which click lets pass."""

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        """The number; BadParameter for what is none."""
        converted = float(super().convert(value, param, ctx))
        if converted != converted:
            self.fail(f"{value!r} is not a number.", param, ctx)
        return converted


def session() -> Session:
    """The running invocation's session; a fresh one outside of any command."""
    context = click.get_current_context(silent=True)
    return context.find_root().ensure_object(Session) if context else Session()


def use_color() -> bool:
    """Colour only on a terminal that can show it, and never with NO_COLOR."""
    return (
        sys.stderr.isatty()
        and not os.environ.get("NO_COLOR")
        and os.environ.get("TERM", "") != "dumb"
    )


def show(diagnostics: Sequence[Diagnostic], of: Session | None = None) -> None:
    """Render diagnostics to standard error as the session has it: the running one if none is given.

    A SARIF log waits for `show_gathered`.
    """
    of = of or session()
    if of.message_format == "sarif":
        of.gathered += diagnostics
    elif diagnostics:
        _write(diagnostics, of.message_format)


def show_gathered(of: Session) -> None:
    """Write the one document of a session whose format has one."""
    if of.message_format == "sarif":
        _write(of.gathered, of.message_format)


def _write(diagnostics: Sequence[Diagnostic], message_format: MessageFormat) -> None:
    if message_format == "github" or message_format == "sarif":
        from nscc.diagnostics.reports import sarif, workflow_commands

        text = (sarif if message_format == "sarif" else workflow_commands)(diagnostics)
    else:
        from nscc.diagnostics.render import render

        text = render(diagnostics, message_format, use_color())
    sys.stderr.write(text if text.endswith("\n") else text + "\n")
    sys.stderr.flush()


def say(diagnostics: Sequence[Diagnostic]) -> None:
    """Show warnings and notes now.

    Call this before writing products. With `--deny-warnings` a warning among them raises
    Rejected (status 1) with the warnings turned into errors, so that nothing gets written.
    """
    now = session()
    diagnostics = [_with_reproducer(diagnostic, now) for diagnostic in diagnostics]
    if now.deny_warnings and any(d.severity is Severity.WARNING for d in diagnostics):
        raise Rejected(tuple(_denied(d) for d in diagnostics))
    show(diagnostics)


def say_done(text: str) -> None:
    """Tell the user what was done, on standard error; programs (json, sarif) read the files."""
    if session().message_format not in ("json", "sarif"):
        click.echo(text, err=True)


def say_compiling(loop: Any, part_name: str) -> None:
    """Say that a loop has yet to be compiled, where that is so: the user will wait for it."""
    if not loop.is_compiled():
        say_done(loop.compiling(part_name))


def _with_reproducer(diagnostic: Diagnostic, of: Session) -> Diagnostic:
    """The diagnostic with a note that names its reproducer, if it carries a traceback."""
    trace = diagnostic.data.get("traceback")
    if trace is None:
        return diagnostic
    from nscc_cli.fault import save_reproducer

    note, help_text = save_reproducer(str(trace), of.arguments)
    helps = (*diagnostic.helps, help_text)
    return replace(diagnostic, notes=(*diagnostic.notes, *note), helps=helps)


def _denied(diagnostic: Diagnostic) -> Diagnostic:
    if diagnostic.severity is not Severity.WARNING:
        return diagnostic
    notes = (*diagnostic.notes, "a warning, treated as an error because of --deny-warnings")
    return replace(diagnostic, severity=Severity.ERROR, notes=notes)


class OutPath(click.Path):
    """The path of a product: the one kind of path that is no input of its command."""

    def __init__(self, path_type: type[Any] = Path) -> None:
        super().__init__(path_type=path_type)


class CommonCommand(click.Command):
    """A command with the options that all commands share: `--message-format`, `--deny-warnings`.

    Both end up in the session; the command's function does not see them. Files that its other
    parameters name are inputs, which no product may replace (NS0785).
    """

    def __init__(self, *arguments: Any, **settings: Any) -> None:
        super().__init__(*arguments, **settings)
        self.params += [
            click.Option(
                ["--message-format"], type=click.Choice(FORMATS), default=None,
                expose_value=False, callback=_to_session,
                help="How messages are written to standard error (default: human).",
            ),
            click.Option(
                ["--deny-warnings"], is_flag=True, expose_value=False, callback=_to_session,
                help="Treat warnings as errors.",
            ),
        ]  # fmt: skip

    def option_sections(self, ctx: click.Context) -> dict[str, list[tuple[str, str]]]:
        """The options and their help texts, by the title of the section that lists them."""
        sections: dict[str, list[tuple[str, str]]] = {}
        for param in self.get_params(ctx):
            record = param.get_help_record(ctx) if isinstance(param, click.Option) else None
            if record is not None:
                sections.setdefault(getattr(param, "section", "Options"), []).append(record)
        return sections

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the options by sections."""
        for title, records in self.option_sections(ctx).items():
            with formatter.section(title):
                formatter.write_dl(records)

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command, its inputs kept from its own products."""
        with inputs_kept():
            for param in self.params:
                if not isinstance(param.type, OutPath):
                    reads(*_paths(ctx.params.get(str(param.name))))
            return super().invoke(ctx)


def _paths(value: Any) -> Iterator[Path]:
    """What of a parameter's value may name files."""
    if isinstance(value, str | Path):
        yield Path(value)
    elif isinstance(value, tuple):
        for item in value:
            yield from _paths(item)


def _to_session(context: click.Context, option: click.Parameter, value: Any) -> None:
    if value:
        setattr(context.find_root().ensure_object(Session), str(option.name), value)


class Subcommands(CommonCommand, click.Group):
    """A command with commands of its own; other names are rejected (NS0781)."""

    unknown = "command '{}'"
    """What a name is called that is none of them."""

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the options, then the commands."""
        super().format_options(ctx, formatter)
        self.format_commands(ctx, formatter)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """The command named first in `args`, and what follows it."""
        name = args[0]
        if name not in self.commands and not name.startswith("-"):
            return self.resolve_unknown(name, args)
        return super().resolve_command(ctx, args)

    def or_else(self) -> Sequence[str]:
        """What may stand in a command's place, for who is told that there is none."""
        return ()

    def resolve_unknown(
        self, name: str, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Resolve a name that is not a command."""
        raise rejected(
            "NS0781",
            f"unknown name: nscc has no {self.unknown.format(name[:60])}",
            helps=(
                *meant(name, self.commands, written=f"nscc {self.name} {{}}"),
                f"there is: {', '.join(self.commands)}",
                *self.or_else(),
            ),
        )


@contextmanager
def waiting(task: str) -> Iterator[None]:
    """Say on a terminal which task is going on and for how long, where nothing can be counted.

    Nothing is drawn in the first second, nor where `progress` would draw nothing.
    """
    if not _draws():
        yield
        return
    over = Event()

    def draw() -> None:
        begin, pause = monotonic(), _BAR_DELAY_S
        while not over.wait(pause):
            _redraw(f"{task}: {monotonic() - begin:.0f} s")
            pause = _BAR_REFRESH_S
        if pause is not _BAR_DELAY_S:
            _redraw("")

    drawing = Thread(target=draw, daemon=True)
    drawing.start()
    try:
        yield
    finally:
        over.set()
        drawing.join()


def _draws() -> bool:
    return sys.stderr.isatty() and session().message_format == "human"


def _redraw(line: str) -> None:
    """Replace the line that stands there; one longer than the terminal is cut, or it would stay."""
    from shutil import get_terminal_size

    sys.stderr.write("\r\x1b[2K" + line[: get_terminal_size().columns - 1])
    sys.stderr.flush()


def progress(iterable: Iterable[Item], label: str, total: int | None = None) -> Iterator[Item]:
    """Hand on the items; draw a bar on standard error if that is a terminal and it takes long.

    `total` is the number of items where it is known and `iterable` has no length. Nothing
    is drawn in the first second, nor with a message format other than human.
    """
    if not _draws():
        yield from iterable
        return
    if total is None and isinstance(iterable, Sized):
        total = len(iterable)
    begin = monotonic()
    next_draw = begin + _BAR_DELAY_S
    drawn = False
    try:
        for item_count, item in enumerate(iterable):
            now = monotonic()
            if now >= next_draw:
                _redraw(bar_line(label, item_count, total, now - begin))
                drawn = True
                next_draw = now + _BAR_REFRESH_S
            yield item
    finally:
        if drawn:
            _redraw("")


def bar_line(label: str, item_count: int, total: int | None, elapsed_s: float) -> str:
    """One line of progress: a bar and the time left if `total` is known, else a count."""
    if not total:
        return f"{label}: {item_count}, {elapsed_s:.0f} s"
    share = min(item_count / total, 1.0)
    filled = round(share * _BAR_WIDTH)
    time_left = f", {elapsed_s / share - elapsed_s:.0f} s left" if share > 0 else ""
    return f"{label} [{'#' * filled}{'.' * (_BAR_WIDTH - filled)}] {share:4.0%}{time_left}"
