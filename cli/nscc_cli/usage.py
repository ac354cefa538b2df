"""Conversion of click's usage errors into diagnostics."""

from __future__ import annotations

import re
from pathlib import Path

import click

from nscc.diagnostics.diagnostic import Diagnostic
from nscc.diagnostics.suggest import did_you_mean, meant
from nscc_cli.support import Subcommands

_KINDS = {
    "integer range": "a whole number",
    "integer": "a whole number",
    "float range": "a number",
    "float": "a number",
}
"""Plain names for click's number types."""


def usage_diagnostic(error: click.ClickException) -> Diagnostic:
    """Convert a usage error of click into a diagnostic.

    NS0780 for a missing or extra argument and every other error, NS0782 for an unknown option,
    NS0783 for an invalid option value, NS0784 for a file that click could not open."""
    context = getattr(error, "ctx", None)
    name = context.command_path if context is not None else "nscc"
    helps: tuple[str, ...] = (f"`{name} --help` lists what it takes",)
    notes = (context.get_usage(),) if context is not None else ()
    if isinstance(error, click.exceptions.NoArgsIsHelpError):
        code, message = "NS0780", f"`{name}` needs a command"
        if context is not None and isinstance(context.command, Subcommands):
            helps = (*context.command.names_help(context), *helps)
    elif isinstance(error, click.NoSuchOption):
        code, message = "NS0782", f"`{name}` has no option {error.option_name}"
        helps = (*meant(error.option_name, _options(context)), *helps)
        if not error.option_name.startswith("--"):  # click reads -name.nsl as the option -n
            longer = (o for o in _options(context) if o.startswith(f"-{error.option_name}"))
            other = "write a file name that begins with - as ./-NAME"
            helps = (*map(did_you_mean, longer), other, helps[-1])
    elif isinstance(error, click.MissingParameter):
        code, message = "NS0780", f"`{name}` needs {_parameter(error) or 'one more argument'}"
        if isinstance(error.param, click.Option) and error.param.help:
            notes = (f"{_parameter(error)}: {error.param.help}", *notes)
    elif isinstance(error, click.BadParameter):
        parameter, text = _parameter(error), _in_lower_case(error.message)
        code, message = "NS0783", f"{parameter}: {text}" if parameter else text
    elif isinstance(error, click.FileError):
        code, message = "NS0784", _in_lower_case(error.format_message())
    else:
        code, message = "NS0780", _in_lower_case(error.format_message())
        helps = (*_scene_meant(context, message), *helps)
    return Diagnostic(code, message, notes=notes, helps=helps)


def _scene_meant(context: click.Context | None, message: str) -> tuple[str, ...]:
    """Return helps for `message`, if it is click's about an extra argument. They suggest `--scene`
    for one that looks like a scene, `-o` for a program where none is read, else quotation marks.
    There are none for other messages and commands without scenes."""
    extra = re.fullmatch(r"got unexpected extra argument \((.*)\)", message)
    if context is None or extra is None or "--scene" not in _options(context):
        return ()
    suffix = Path(extra[1]).suffix.lower()
    if suffix in (".nsl", ".icw"):
        reads_none = not any(isinstance(p, click.Argument) for p in context.command.params)
        return (f"no program is read: -o {extra[1]} names the one to write",) * reads_none
    if suffix or extra[1].startswith("builtin:"):
        return (did_you_mean(f"--scene {extra[1]}"),)
    return ("put a value with blanks in quotation marks",)


def _options(context: click.Context | None) -> list[str]:
    """Return the names (`-o`, `--out`) of all options of the command that `context` belongs to,
    from which suggestions are made; none without a context."""
    if context is None:
        return []
    known = context.command.get_params(context)
    return [text for parameter in known for text in parameter.opts if text.startswith("-")]


def _parameter(error: click.BadParameter) -> str:
    """Return the option or argument that is wrong, as the usage line writes it; "" if the error
    does not name one."""
    if isinstance(error.param, click.Option):
        return error.param.opts[-1]
    if error.param is not None and error.ctx is not None:
        return error.param.make_metavar(error.ctx).strip("[]. ")
    return ""


def _in_lower_case(text: str) -> str:
    """Return `text`, a message of click, in the style of nscc: without a capital at the start and a
    full stop at the end, and with plain words for its types."""
    text = " ".join(text.split()).rstrip(".")
    for kind, plain in _KINDS.items():
        text = text.replace(f"is not a valid {kind}", f"is not {plain}")
    first = text.partition(" ")[0].rstrip(",")
    return text if first.isupper() else text[:1].lower() + text[1:]
