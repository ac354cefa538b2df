"""What a Python call is told whose arguments are of another kind than it takes."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.diagnostics.suggest import meant


class WrongArgument(Rejected, TypeError):
    """A call got an argument that it does not take (NS0785, status 2); a TypeError as well."""


def wrong_argument(
    message: str, *, notes: Sequence[str] = (), helps: Sequence[str] = ()
) -> WrongArgument:
    """The exception for a call's wrong argument, said in one sentence."""
    return WrongArgument(
        Diagnostic("NS0785", message, notes=tuple(notes), helps=tuple(helps)), status=2
    )


def one_of(call: str, name: str, value: object, allowed: Collection[Any]) -> None:
    """Raises WrongArgument unless the call's argument `name` has one of the allowed values."""
    if any(type(value) is type(each) and value == each for each in allowed):
        return
    names = [each for each in allowed if isinstance(each, str)]
    raise wrong_argument(
        f"{call}: {name} is one of {', '.join(map(repr, allowed))}, not {shown(value)}",
        helps=meant(value, names) if isinstance(value, str) else (),
    )


def shown(value: object) -> str:
    """What a value is, in a few words: `an array (64, 64) of float32`, `the text 'abc'`, `a list`.

    Told by what a value has, so that nothing is imported to name somebody else's kinds.
    """
    if value is None or isinstance(value, bool | int | float):
        return repr(value)[:60]
    if isinstance(value, str | bytes):
        kind = "the text" if isinstance(value, str) else "the bytes"
        return f"{kind} {value[:40]!r}" + (" .." if len(value) > 40 else "")
    name, kind_of = type(value).__name__, getattr(value, "dtype", None)
    if kind_of is not None and hasattr(value, "shape"):
        what = "an array" if name == "ndarray" else f"a {name}"
        return f"{what} {tuple(value.shape)} of {str(kind_of).removeprefix('torch.')}"
    return f"{'an' if name[:1].lower() in 'aeiou' else 'a'} {name}"
