"""Errors for invalid arguments of Python calls."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.diagnostics.render import render


class WrongArgument(Rejected, TypeError, ValueError):
    """The error of an invalid argument of a Python call (NS0789, status 2).

    It is also a ValueError and a TypeError, so that callers can catch what Python code usually
    raises."""


def wrong_argument(
    message: str, *, notes: Sequence[str] = (), helps: Sequence[str] = ()
) -> WrongArgument:
    """Return the exception for an invalid argument, for the caller to raise.

    `message` is one sentence; `notes` are facts and `helps` suggestions, each printed on its own
    line."""
    return WrongArgument(
        Diagnostic("NS0789", message, notes=tuple(notes), helps=tuple(helps)), status=2
    )


def require_type(call: str, name: str, value: object, kind: type, made_by: str) -> None:
    """Raise WrongArgument unless `value`, the argument `name` of the function `call`, is a `kind`.

    `made_by` is the code that makes such an object, for the help."""
    if not isinstance(value, kind):
        raise wrong_argument(
            f"{call} takes {name} of type {kind.__name__}, not {shown(value)}",
            helps=(f"{made_by} makes one",),
        )


def as_array(call: str, name: str, value: object, dtype: type | None = None) -> Array:
    """Return `value`, the argument `name` of the function `call`, as a numpy array.

    `dtype` None keeps its own; the shape is not checked. Raises WrongArgument if numpy cannot
    convert it; the help names the conversion for torch tensors."""
    try:
        return np.asarray(value, dtype)
    except (RuntimeError, TypeError, ValueError) as error:
        raise wrong_argument(
            f"{call}: cannot convert {name} to an array: {shown(value)}",
            notes=(" ".join(str(error).split())[:150],),
            helps=(
                "for a torch tensor x use x.detach().cpu().float().numpy(); gradients flow "
                "through nscc_training.differentiable_capture",
            ),
        ) from error


def warn(diagnostics: Iterable[Diagnostic], stacklevel: int = 3) -> None:
    """Issue the diagnostics of severity WARNING as Python warnings; ignore errors and notes.

    `stacklevel` chooses the line that Python shows: 3 is the caller of the function that calls
    `warn`."""
    for diagnostic in diagnostics:
        if diagnostic.severity is Severity.WARNING:
            warnings.warn(render([diagnostic], "human").rstrip(), stacklevel=stacklevel)


def shown(value: object) -> str:
    """Describe a value in a few words: `an array (64, 64) of float32`, `the text 'abc'`, `a list`.

    Numbers, booleans and None are shown as Python writes them. Texts are cut after 40 characters.
    Arrays are recognised by `shape` and `dtype`, so that no array library is imported."""
    if isinstance(value, np.generic):  # shown like a value of Python
        value = value.item()
    if value is None or isinstance(value, bool | int | float):
        return repr(value)[:60]
    if isinstance(value, str | bytes):
        kind = "the text" if isinstance(value, str) else "the bytes"
        return f"{kind} {value[:40]!r}" + (" .." if len(value) > 40 else "")
    name, kind_of = type(value).__name__, getattr(value, "dtype", None)
    if kind_of is not None and hasattr(value, "shape"):
        kind_text = "an array" if name == "ndarray" else f"a {name}"
        return f"{kind_text} {tuple(value.shape)} of {str(kind_of).removeprefix('torch.')}"
    return f"{'an' if name[:1].lower() in 'aeiou' else 'a'} {name}"


def path_of(call: str, value: object) -> Path:
    """Return `value`, an argument of the function `call`, as a path.

    Raises WrongArgument unless it is a text or a path object without a null character."""
    if isinstance(value, str | os.PathLike):
        path = os.fspath(value)
        if isinstance(path, str) and "\0" not in path:
            return Path(path)
    raise wrong_argument(f"{call} takes a path, not {shown(value)}")
