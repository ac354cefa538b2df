"""A target table as plain values: checked into a `Target`, and written from one.

The plain form is what TOML holds: a dict of sections, each a dict of keys (`nscc.target.schema`).
"any" and "none" stand for the None of `Target`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite
from typing import Any

from nscc.diagnostics.suggest import closest
from nscc.operations import ANALOG_WRITE, DIGITAL_WRITE
from nscc.target.schema import CHOICES, KEYS, SECTIONS, Key
from nscc.target.target import Target
from nscc.toml_text import shown

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_.+-]{0,63}")
_LONGEST_TEXT = 400


@dataclass(frozen=True, slots=True)
class Problem:
    """What is wrong with a table, at which key ("" and the section's name for a whole table)."""

    code: str
    section: str
    key: str
    message: str
    help: str | None = None


def target_values(target: Target) -> dict[str, Any]:
    """The plain form of a target: sections of keys, every key present, in the order of a file."""
    values: dict[str, Any] = {}
    for key in KEYS:
        place = values.setdefault(key.section, {}) if key.section else values
        value = getattr(target, key.attribute)
        if value is None:
            value = "any" if key.kind == "limit" else "none"
        place[key.key] = list(value) if isinstance(value, tuple) else value
    return values


def read_values(
    values: Mapping[str, Any], defaults: Target | None
) -> tuple[Target | None, tuple[Problem, ...]]:
    """The target of a plain table, or None and everything that is wrong with it.

    A key that is not required may be missing and takes the value of `defaults`; without
    `defaults` every key must be there. A table without `mask` and `masked` has neither.
    """
    problems = _unknown_keys(values)
    found: dict[str, Any] = {}
    for key in KEYS:
        section = values.get(key.section) if key.section else values
        if not isinstance(section, Mapping):
            section = {}
        if key.key not in section:
            _missing(key, found, defaults, problems)
            continue
        value, wrong = _checked(key, section[key.key])
        if wrong:
            message = f"{key.path} must be {wrong}, not {shown(section[key.key])}"
            problems.append(Problem("NS0235", key.section, key.key, message))
        else:
            found[key.attribute] = value
    problems.extend(_register_problems(found))
    return (None if problems else Target(**found)), tuple(problems)


def _unknown_keys(values: Mapping[str, Any]) -> list[Problem]:
    problems = []
    for name, value in values.items():
        top = [key.key for key in KEYS if not key.section]
        if name in SECTIONS and name:
            if not isinstance(value, Mapping):
                message = f"{name} must be a table of keys (a line `[{name}]`), not {shown(value)}"
                problems.append(Problem("NS0235", "", name, message))
                continue
            known = [key.key for key in KEYS if key.section == name]
            problems.extend(_unknown(name, key, known) for key in value if key not in known)
        elif name not in top:
            problems.append(_unknown("", name, [*top, *(part for part in SECTIONS if part)]))
    return problems


def _unknown(section: str, name: str, known: list[str]) -> Problem:
    where = f"[{section}] of a target" if section else "a target table"
    near = closest(name, known)
    homes = [key.section for key in KEYS if key.key == name and key.section != section]
    elsewhere = None if near else closest(name, [key.key for key in KEYS])
    if elsewhere:
        home = next(key.section for key in KEYS if key.key == elsewhere)
        help_text = f"did you mean `{elsewhere}` under [{home}]?"
    elif homes:
        help_text = f"`{name}` belongs " + (f"under [{homes[0]}]" if homes[0] else "at the top")
    elif near:
        help_text = f"did you mean `{near}`?"
    else:
        help_text = f"the keys here are {', '.join(known)}"
    return Problem("NS0233", section, name, f"{where} has no key {shown(name)}", help_text)


def _missing(
    key: Key, found: dict[str, Any], defaults: Target | None, problems: list[Problem]
) -> None:
    if defaults is None or key.required:
        help_text = "`nscc targets scamp5 --toml` prints a complete file to start from"
        message = f"the key {key.path} is missing: {key.comment}"
        problems.append(Problem("NS0234", key.section, key.key, message, help_text))
    elif key.section == "registers":
        found[key.attribute] = None
    elif key.key == "description":
        found[key.attribute] = ""
    else:
        found[key.attribute] = getattr(defaults, key.attribute)


def _checked(key: Key, value: Any) -> tuple[Any, str | None]:
    """The value as `Target` keeps it, and what it should have been if it is wrong."""
    if key.kind in ("integer", "limit") and _is_integer(value):
        if key.low <= value <= key.high:
            return value, None
        return None, f"{_any(key)}a whole number from {key.low:.0f} to {key.high:.0f}"
    if key.kind == "number" and (_is_integer(value) or isinstance(value, float)):
        return _number(key, value)
    if key.kind == "flag" and isinstance(value, bool):
        return value, None
    if key.kind == "choice" and isinstance(value, str) and value in CHOICES:
        return value, None
    if key.kind == "limit" and value == "any":
        return None, None
    if key.kind == "names" and _is_names(value):
        return tuple(value), None
    if key.kind == "register" and isinstance(value, str):
        return None if value == "none" else value, None
    if key.kind == "name" and isinstance(value, str) and _NAME.fullmatch(value):
        return value, None
    if key.kind == "text" and isinstance(value, str) and _is_line(value):
        return value, None
    return None, _wanted(key)


def _number(key: Key, value: float) -> tuple[float | None, str | None]:
    low = key.low < value if key.low_excluded else key.low <= value
    high = value < key.high if key.high_excluded else value <= key.high
    if low and high and isfinite(value):
        # Adding 0.0 makes -0.0 plain 0.0: one value, one spelling.
        return float(value) + 0.0, None
    left, right = "above" if key.low_excluded else "from", "below" if key.high_excluded else "to"
    return None, f"a number {left} {key.low:g} {right} {key.high:g}"


def _wanted(key: Key) -> str:
    wanted = {
        "name": "a name of letters, digits, `-`, `_`, `.` (64 at most, a letter first)",
        "text": f"one line of text, {_LONGEST_TEXT} characters at most",
        "integer": "a whole number",
        "number": "a number",
        "names": "a list of register names",
        "register": "the name of a register",
        "flag": "true or false",
        "choice": '"no", "yes" or "unknown"',
        "limit": '"any" or a whole number',
    }
    return wanted[key.kind]


def _any(key: Key) -> str:
    return '"any" or ' if key.kind == "limit" else ""


def _is_names(value: Any) -> bool:
    return isinstance(value, list | tuple) and all(isinstance(name, str) for name in value)


def _is_line(value: str) -> bool:
    return value.isprintable() and len(value) <= _LONGEST_TEXT


def _is_integer(value: Any) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)


def _register_problems(found: Mapping[str, Any]) -> list[Problem]:
    """What is wrong with registers that are each well formed."""
    problems: list[Problem] = []

    def wrong(key: str, message: str, help_text: str | None = None) -> None:
        problems.append(Problem("NS0236", "registers", key, message, help_text))

    for key, attribute, known in (
        ("analog", "analog_registers", tuple(ANALOG_WRITE)),
        ("digital", "digital_registers", tuple(DIGITAL_WRITE)),
    ):
        names = found.get(attribute, ())
        for index, name in enumerate(names):
            if name in names[:index]:
                wrong(key, f"registers.{key} lists {shown(name)} twice")
            elif name not in known:
                near = closest(name, known)
                wrong(
                    key,
                    f"registers.{key} lists {shown(name)}, which no instruction word can name",
                    f"did you mean {near}?" if near else f"words name {_some(known)}",
                )
        if len(names) > 2 * len(known):
            break
    problems = problems[:10]
    analog, digital = found.get("analog_registers"), found.get("digital_registers")
    scratch = found.get("analog_scratch")
    if analog is not None and "analog_scratch" in found and scratch not in analog:
        wrong("analog_scratch", f"analog_scratch is {shown(scratch)}, not in registers.analog")
    mask, masked = found.get("mask_register"), found.get("masked_register")
    if (mask is None) != (masked is None):
        one, other = ("mask", "masked") if masked is None else ("masked", "mask")
        wrong(one, f"registers.{one} is given and registers.{other} is not: give both or neither")
    elif mask is not None and mask == masked:
        wrong("masked", f"registers.mask and registers.masked are both {shown(mask)}")
    for key, name in (("mask", mask), ("masked", masked)):
        if name is not None and digital is not None and name not in digital:
            wrong(key, f"registers.{key} is {shown(name)}, not in registers.digital")
    return problems


def _some(names: tuple[str, ...]) -> str:
    return ", ".join(names) if len(names) < 10 else f"{names[0]} to {names[-1]}"
