"""Shared code of all commands: common options, messages and progress."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence, Sized
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from threading import Event, Thread
from time import monotonic
from typing import Any, Literal, TypeVar

import click

from nscc.cache.folder import forget_refusal, refusal
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity, rejected
from nscc.diagnostics.suggest import meant
from nscc.files import inputs_kept, reads
from nscc.toml.kinds import LARGEST_INTEGER

Item = TypeVar("Item")
MessageFormat = Literal["human", "short", "json", "github", "sarif"]
FORMATS: tuple[MessageFormat, ...] = ("human", "short", "json", "github", "sarif")

_BAR_DELAY_S = 1.0
_BAR_REFRESH_S = 0.1
_BAR_WIDTH = 30


@dataclass
class Session:
    """How one invocation of nscc prints messages (`message_format`), whether warnings are errors
    (`deny_warnings`), and its command line."""

    message_format: MessageFormat = "human"
    deny_warnings: bool = False
    arguments: Sequence[str] = ()
    """The command line, for reproducers."""
    gathered: list[Diagnostic] = field(default_factory=list)
    """Diagnostics to write at the end, for SARIF, whose log is a single document."""


class NumberRange(click.FloatRange):
    """The click type of a number within limits. It rejects NaN, which click's own type accepts."""

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        """Return `value` as a number. Raise BadParameter if it is outside the range, NaN or other
        text."""
        converted = float(super().convert(value, param, ctx))
        # Only NaN differs from itself.
        if converted != converted:
            self.fail(f"{value!r} is not a number.", param, ctx)
        return converted


class WholeNumber(click.IntRange):
    """The click type of a whole number within limits. It rejects numbers above 64 bits, which numpy
    cannot hold."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> int:
        """Return `value` as a whole number. Raise BadParameter if it is outside the range, above 64
        bits or other text."""
        converted = int(super().convert(value, param, ctx))
        if converted > LARGEST_INTEGER:
            self.fail(f"{value!r} is too large.", param, ctx)
        return converted


def session() -> Session:
    """Return the session of the running command, or a new session outside of commands."""
    context = click.get_current_context(silent=True)
    return context.find_root().ensure_object(Session) if context else Session()


def use_color() -> bool:
    """Return whether messages are coloured: standard error is a colour terminal, and the variable
    NO_COLOR is not set."""
    return (
        sys.stderr.isatty()
        and not os.environ.get("NO_COLOR")
        and os.environ.get("TERM", "") != "dumb"
    )


def show(diagnostics: Sequence[Diagnostic], of: Session | None = None) -> None:
    """Print diagnostics, if there are any, to standard error in the session's format. For SARIF,
    store them until `show_gathered` prints them.

    `of` is the session; None takes that of the running command."""
    of = of or session()
    if of.message_format == "sarif":
        of.gathered += diagnostics
    elif diagnostics:
        _write(diagnostics, of.message_format)


def show_gathered(of: Session) -> None:
    """Print the stored diagnostics of a session as one SARIF document."""
    if of.message_format == "sarif":
        _write(of.gathered, of.message_format)


def _write(diagnostics: Sequence[Diagnostic], message_format: MessageFormat) -> None:
    """Write diagnostics to standard error in the format `message_format`. Colours are used if the
    terminal has them."""
    if message_format == "github" or message_format == "sarif":
        from nscc.diagnostics.reports import sarif, workflow_commands

        text = (sarif if message_format == "sarif" else workflow_commands)(diagnostics)
    else:
        from nscc.diagnostics.render import render

        text = render(diagnostics, message_format, use_color())
    sys.stderr.write(text if text.endswith("\n") else text + "\n")
    sys.stderr.flush()


def say(diagnostics: Sequence[Diagnostic]) -> None:
    """Print `diagnostics`, warnings and notes of a command, to standard error. Call this before
    writing products.

    With `--deny-warnings`, a warning raises Rejected (status 1) with all warnings turned into
    errors, so that no product is written."""
    now = session()
    diagnostics = [_with_reproducer(diagnostic, now) for diagnostic in diagnostics]
    if now.deny_warnings and any(d.severity is Severity.WARNING for d in diagnostics):
        raise Rejected(tuple(_denied(d) for d in diagnostics))
    show(diagnostics)


def say_done(text: str) -> None:
    """Print what was done to standard error, except with the message formats `json` and `sarif`."""
    if session().message_format not in ("json", "sarif"):
        click.echo(text, err=True)


def say_refused_cache(of: Session) -> None:
    """Print why a command used no cache, if it could not use one and its messages are for people.
    It is to be called once, at the end of a command."""
    if of.message_format == "human" and refusal():
        hint = "NSCC_CACHE_DIR names another folder, NSCC_CACHE=off none"
        click.echo(f"{refusal()} ({hint})", err=True)
    forget_refusal()


def say_compiling(loop: Any, part_name: str) -> None:
    """Tell the user that a loop must first be compiled, which takes a while, unless it is compiled
    already. `part_name` names it in the message, such as "the emulator's loops"."""
    if not loop.is_compiled():
        say_done(loop.compiling(part_name))


def _with_reproducer(diagnostic: Diagnostic, of: Session) -> Diagnostic:
    """Return the diagnostic with a note that names a saved reproducer, if it contains a traceback;
    others stay as they are.

    `of` is the session, whose command line goes into the reproducer."""
    trace = diagnostic.data.get("traceback")
    if trace is None:
        return diagnostic
    from nscc_cli.fault import save_reproducer

    note, help_text = save_reproducer(str(trace), of.arguments)
    helps = (*diagnostic.helps, help_text)
    return replace(diagnostic, notes=(*diagnostic.notes, *note), helps=helps)


def _denied(diagnostic: Diagnostic) -> Diagnostic:
    """Return `diagnostic`, a warning, as an error, for `--deny-warnings`; other diagnostics stay as
    they are."""
    if diagnostic.severity is not Severity.WARNING:
        return diagnostic
    notes = (*diagnostic.notes, "a warning, treated as an error because of --deny-warnings")
    return replace(diagnostic, severity=Severity.ERROR, notes=notes)


class OutPath(click.Path):
    """The click type of an output file's path. `CommonCommand` treats the paths of all other types
    as input files."""

    def __init__(self, path_type: type[Any] = Path) -> None:
        """Take paths of output files; `path_type` is the type of the values, such as Path."""
        super().__init__(path_type=path_type)


class CommonCommand(click.Command):
    """A command with the options that all commands share: `--message-format`, `--deny-warnings`.

    The session stores both; the command's function does not receive them. Files named by other
    parameters are inputs, which products must not overwrite (NS0785)."""

    def __init__(self, *arguments: Any, **settings: Any) -> None:
        """Create the command, with its own options followed by `--message-format` and
        `--deny-warnings`. The arguments are those of `click.Command`."""
        super().__init__(*arguments, **settings)
        self.params += [
            click.Option(
                ["--message-format"],
                type=click.Choice(FORMATS),
                default=None,
                expose_value=False,
                callback=_to_session,
                help="How messages are written to standard error (default: human).",
            ),
            click.Option(
                ["--deny-warnings"],
                is_flag=True,
                expose_value=False,
                callback=_to_session,
                help="Treat warnings as errors.",
            ),
        ]

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Parse the arguments of the command. Every usage error then names the command, so that the
        message can refer to its help."""
        try:
            return super().parse_args(ctx, args)
        except click.UsageError as error:
            error.ctx = error.ctx or ctx
            raise

    def option_sections(self, ctx: click.Context) -> dict[str, list[tuple[str, str]]]:
        """Return the options of the command in `ctx` with their help texts, by the title of their
        section. Options without a section are below "Options"."""
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
        """Run the command of `ctx`. Meanwhile no product can replace a file that the parameters
        name as an input."""
        with inputs_kept():
            for param in self.params:
                if not isinstance(param.type, OutPath):
                    reads(*_paths(ctx.params.get(str(param.name))))
            return super().invoke(ctx)


def common_command(name: str) -> Callable[[Callable[..., Any]], CommonCommand]:
    """Return a decorator that makes a function the command `name`, with the options that all
    commands share."""
    return click.command(name, cls=CommonCommand)


def _paths(value: Any) -> Iterator[Path]:
    """Yield the paths that the value of a parameter contains: itself, or those in a tuple, at any
    depth. Texts count as paths, too. Other values contain none."""
    if isinstance(value, str | Path):
        yield Path(value)
    elif isinstance(value, tuple):
        for item in value:
            yield from _paths(item)


def _to_session(context: click.Context, option: click.Parameter, value: Any) -> None:
    """Store the value of an option in the `Session` of the whole command, under the option's name.
    An option that is not given changes nothing."""
    if value:
        setattr(context.find_root().ensure_object(Session), str(option.name), value)


def given_options(names: Iterable[str]) -> list[str]:
    """Return which of the options `names` are on the command line of the running command, as users
    write them (`--slot-us`). `names` are click's names of parameters (`slot_us`). Defaults do not
    count."""
    context = click.get_current_context()
    written = {parameter.name: parameter.opts[-1] for parameter in context.command.params}
    on_command_line = click.core.ParameterSource.COMMANDLINE
    return [written[n] for n in names if context.get_parameter_source(n) is on_command_line]


def refuse_ignored(why: str, *names: str) -> None:
    """Raise UsageError if one of the options `names` is on the command line. They have no effect,
    because of `why`, the end of a sentence such as "no program is named". `names` are click's names
    of parameters (`slot_us`)."""
    for option in given_options(names):
        raise click.UsageError(f"{option} has no effect, because {why}: leave {option} out")


class Subcommands(CommonCommand, click.Group):
    """A command with subcommands.

    Another name than theirs is passed to the subcommand `of` if the class `accepts` it, and
    rejected otherwise (NS0781). So `nscc evaluate RUN` means `nscc evaluate of RUN`."""

    command_class = CommonCommand
    unknown = "command '{group} {name}'"
    """The description of an unknown name in the error message."""
    others: tuple[str, ...] = ()
    """A help line about the names that the subcommand `of` takes."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of the subcommands for the help, without `of`, which need not be
        written."""
        return [name for name in super().list_commands(ctx) if name != "of"]

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the options, then the commands."""
        super().format_options(ctx, formatter)
        self.format_commands(ctx, formatter)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the name of a subcommand, the subcommand, and its arguments, for the arguments
        `args` of the group.

        A name that the class accepts stays the first argument of the subcommand `of`. Raises
        Rejected (NS0781) if the first argument is neither a subcommand nor a name that the class
        accepts."""
        name = args[0]
        if name in self.commands or name.startswith("-"):
            return super().resolve_command(ctx, args)
        if self.accepts(name):
            return "of", self.commands["of"], args
        raise rejected(
            "NS0781",
            f"unknown name: nscc has no {self.unknown.format(group=self.name, name=name[:60])}",
            helps=(
                *meant(name, self.list_commands(ctx), written=f"nscc {self.name} {{}}"),
                *self.names_help(ctx),
            ),
        )

    def accepts(self, name: str) -> bool:
        """Return whether the subcommand `of` takes `name` as its first argument. Classes with such
        a subcommand override this."""
        return False

    def names_help(self, ctx: click.Context) -> tuple[str, ...]:
        """Return help lines about everything that can stand after the group's name: its
        subcommands, then `others`."""
        return f"there is: {', '.join(self.list_commands(ctx))}", *self.others


@contextmanager
def waiting(task: str) -> Iterator[None]:
    """Show on a terminal for how long the block has been running, from the first second on. `task`
    says what it does. The block stands below a `with` statement. Without a terminal nothing is
    shown."""
    if not _draws():
        yield
        return
    over = Event()

    def draw() -> None:
        """Show the time in the terminal's line until the block ends; then remove it. Nothing is
        shown in the first second."""
        begin, pause = monotonic(), _BAR_DELAY_S
        while not over.wait(pause):
            _redraw(f"{task}: {monotonic() - begin:.0f} s")
            pause = _BAR_REFRESH_S
        # Something was drawn.
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
    """Return whether progress is drawn: on a terminal, with messages for people."""
    return sys.stderr.isatty() and session().message_format == "human"


def _redraw(line: str) -> None:
    """Replace the terminal's current line by `line`, cut to the terminal's width; "" clears it."""
    from shutil import get_terminal_size

    sys.stderr.write("\r\x1b[2K" + line[: get_terminal_size().columns - 1])
    sys.stderr.flush()


def progress(iterable: Iterable[Item], label: str, total: int | None = None) -> Iterator[Item]:
    """Yield the items of `iterable`, and draw a progress bar with `label` on standard error.

    `total` is the number of items if `iterable` has no length; None shows a count instead of a bar.
    The bar appears after one second, only on a terminal, and only with the message format `human`.
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
    """Return a progress line, which begins with `label`, after `item_count` of `total` items and
    `elapsed_s` seconds: a bar and the remaining time, or a count if `total` is unknown (None or 0).
    """
    if not total:
        return f"{label}: {item_count}, {elapsed_s:.0f} s"
    share = min(item_count / total, 1.0)
    filled = round(share * _BAR_WIDTH)
    time_left = f", {elapsed_s / share - elapsed_s:.0f} s left" if share > 0 else ""
    return f"{label} [{'#' * filled}{'.' * (_BAR_WIDTH - filled)}] {share:4.0%}{time_left}"
