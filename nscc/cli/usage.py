"""Wrong usage as a diagnostic: what was typed, what the command takes."""

from __future__ import annotations

import click

from nscc.diagnostics.model import Diagnostic


def usage_diagnostic(error: click.ClickException) -> Diagnostic:
    """NS0780 for any mistake on the command line, NS0782 for an option that does not exist."""
    context = getattr(error, "ctx", None)
    name = context.command_path if context is not None else "nscc"
    helps = [f"`{name} --help` lists what it takes"]
    code = "NS0780"
    message = error.format_message().rstrip(".")
    if isinstance(error, click.NoSuchOption):
        code = "NS0782"
        message = f"`{name}` has no option {error.option_name}"
        close = error.possibilities or _close(error.option_name, context)
        if close:
            helps.insert(0, f"did you mean {' or '.join(list(close)[:3])}?")
    notes = (context.get_usage(),) if context is not None else ()
    return Diagnostic(code, message[:1].lower() + message[1:], notes=notes, helps=tuple(helps))


def _close(option: str, context: click.Context | None) -> list[str]:
    if context is None:
        return []
    from difflib import get_close_matches

    known = [text for parameter in context.command.params for text in parameter.opts]
    return get_close_matches(option, known, n=1)
