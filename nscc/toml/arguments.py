"""Arguments of Python calls, checked by the declarations of their options."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from nscc.diagnostics.arguments import shown, wrong_argument
from nscc.diagnostics.suggest import meant
from nscc.mappings import NamedValues
from nscc.toml.kinds import Kind, TextKind
from nscc.toml.schema import Key, declared


def checked(call: str, settings: type, values: Mapping[str, Any]) -> NamedValues:
    """Return those arguments of a Python call that fields of `settings` declare, checked and
    converted.

    `values` are the arguments by name; those without a field are left out. `settings` is a
    dataclass with fields made by `key`; `call` is the function's name in messages. Raises
    WrongArgument (NS0789) for the first invalid argument."""
    keys = declared(settings)
    return {
        name: _checked(call, keys[name], value) for name, value in values.items() if name in keys
    }


def argument(call: str, name: str, kind: Kind, value: Any) -> Any:
    """Return the argument `name` of the Python function `call`, checked and converted by its kind.

    Raises WrongArgument (NS0789) for an invalid value."""
    return _read(f"{call}: {name} is", kind, value)


def _checked(call: str, key: Key, value: Any) -> Any:
    """Return `value`, an argument of the Python function `call`, checked and converted by its
    declaration `key`.

    None is allowed if it is the default. Raises WrongArgument for an invalid value."""
    if value is None and key.default is None:
        return None
    subject = f"{call} takes" if key.required else f"{call}: {key.attribute} is"
    return _read(subject, key.kind, value)


def _read(subject: str, kind: Kind, value: Any) -> Any:
    """Return `value`, an argument, checked and converted by its kind. Numbers of numpy count as
    Python's.

    Raises WrongArgument for an invalid value. The message begins with `subject`, such as "capture:
    seed is", and says what is allowed."""
    plain = value.item() if isinstance(value, np.generic) else value
    try:
        return kind.argument(plain)
    except ValueError:
        choices = kind.choices if isinstance(kind, TextKind) else ()
        similar = meant(plain, choices) if isinstance(plain, str) and choices else ()
        raise wrong_argument(
            f"{subject} {kind.in_python}, not {shown(value)}", helps=(*similar, *kind.helps)
        ) from None
