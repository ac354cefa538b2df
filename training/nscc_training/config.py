"""Configurations: TOML in, TOML out, every mistake told at once and with its place."""

from __future__ import annotations

import json
import textwrap
import tomllib
from collections.abc import Sequence
from dataclasses import Field, fields, is_dataclass
from math import isfinite
from pathlib import Path
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic, Label, Rejected
from nscc.diagnostics.suggest import closest
from nscc.source import Source
from nscc.toml.text import LARGEST_FILE, NotToml, parsed, shown, span_of
from nscc_training.settings import Settings

_WIDTH = 100


def load_config(path: Path, changes: Sequence[str] = ()) -> Settings:
    """The settings of a file, with `changes`, each SECTION.KEY=VALUE, on top.

    Raises Rejected, status 2: NS0813 for a file that cannot be read or is no TOML, NS0814 for keys
    that are none, NS0815 for wrong values; all that is wrong at once.
    """
    try:
        with open(path, "rb") as file:
            text, values = parsed(file.read(LARGEST_FILE + 1))
    except (OSError, ValueError) as error:
        raise _unreadable(path, getattr(error, "strerror", None) or str(error)) from None
    except NotToml as reason:
        raise _unreadable(path, f"it is no TOML: {reason}") from None
    return _settings(values, Source(str(path), text), changes)


def settings_of(values: dict[str, Any], changes: Sequence[str] = ()) -> Settings:
    """The settings of a dictionary of sections; as `load_config`."""
    return _settings(values, None, changes)


def config_toml(settings: Settings, *, remarks: bool = False) -> str:
    """A complete file that `load_config` reads back; with `remarks`, what each key means."""
    lines: list[str] = []
    if remarks:
        lines = [
            "# A training run of nscc: `nscc train CONFIG.toml --out RUN`.",
            "# Every key has its default here; those that are left out keep it.",
        ]
    for section in fields(settings):
        group = getattr(settings, section.name)
        lines += ["", f"[{section.name}]"] if lines else [f"[{section.name}]"]
        for entry in fields(group):
            if remarks:
                lines += [f"# {part}" for part in textwrap.wrap(_meaning(entry), _WIDTH - 2)]
            lines.append(f"{_key(entry)} = {_written(getattr(group, entry.name))}")
    return "\n".join(lines) + "\n"


def _settings(values: dict[str, Any], source: Source | None, changes: Sequence[str]) -> Settings:
    problems: list[Diagnostic] = []
    sections = {section.name: section for section in fields(Settings)}
    given: dict[str, dict[str, Any]] = {name: {} for name in sections}
    for name, group in values.items():
        if name not in sections:
            problems.append(_unknown(f"section [{name[:60]}]", name, sections, source, "", name))
        elif not isinstance(group, dict):
            problems.append(_wrong(f"[{name}] must be a table, not {shown(group)}", source, "",
                                   name))  # fmt: skip
        else:
            _section(name, group, given[name], problems, source)
    for change in changes:
        _change(change, sections, given, problems)
    if problems:
        raise Rejected(problems, status=2)
    made = {name: _type_of(section)(**given[name]) for name, section in sections.items()}
    return Settings(**made)


def _section(
    name: str, group: dict[str, Any], found: dict[str, Any], problems: list[Diagnostic],
    source: Source | None,
) -> None:  # fmt: skip
    known = _entries(name)
    for key, value in group.items():
        entry = known.get(key)
        if entry is None:
            problems.append(_unknown(f"'{key[:60]}' in [{name}]", key, known, source, name, key))
            continue
        right, checked = _checked(entry, value)
        if right:
            found[entry.name] = checked
        else:
            text = f"{name}.{key} must be {_allowed(entry)}, not {shown(value)}"
            problems.append(_wrong(text, source, name, key, _meaning(entry)))


def _change(
    change: str, sections: dict[str, Field[Any]], given: dict[str, dict[str, Any]],
    problems: list[Diagnostic],
) -> None:  # fmt: skip
    place, equals, text = change.partition("=")
    section, dot, key = place.strip().partition(".")
    if not equals or not dot:
        problems.append(_wrong(f"'{change[:60]}' is not SECTION.KEY=VALUE", None, "", ""))
        return
    if section not in sections:
        name = f"section '{section[:60]}'"
        problems.append(_unknown(name, section, sections, None, "", section))
        return
    try:
        found = tomllib.loads(f"value = {text.strip()}")
    except (ValueError, RecursionError):
        found = {}
    value = found["value"] if found.keys() == {"value"} else text.strip()
    _section(section, {key: value}, given[section], problems, None)


def _checked(entry: Field[Any], value: Any) -> tuple[bool, Any]:
    """Whether a value is right, and the value as its type."""
    default, about = entry.default, entry.metadata
    if isinstance(default, tuple):
        kind = type(default[0])
        if not isinstance(value, list) or len(value) != about["count"]:
            return False, None
        parts = [_scalar(part, kind, about) for part in value]
        return all(right for right, _ in parts), tuple(part for _, part in parts)
    return _scalar(value, type(default), about)


def _scalar(value: Any, kind: type, about: Any) -> tuple[bool, Any]:
    if kind is bool or isinstance(value, bool):
        return kind is bool and isinstance(value, bool), value
    if kind is str:
        # Bytes of the command line that are no UTF-8 arrive as halves of characters.
        whole = isinstance(value, str) and not any("\ud800" <= c <= "\udfff" for c in value)
        return whole and (not about["choices"] or value in about["choices"]), value
    if not isinstance(value, (int,) if kind is int else (int, float)):
        return False, None
    if abs(value) > 1e300 or not isfinite(value):
        return False, None
    return about["low"] <= value <= about["high"], kind(value)


def _allowed(entry: Field[Any]) -> str:
    default, about = entry.default, entry.metadata
    kinds = {bool: "true or false", int: "a whole number", float: "a number", str: "a text"}
    if about["choices"]:
        return "one of " + ", ".join(f'"{choice}"' for choice in about["choices"])
    kind = kinds[type(default[0]) if isinstance(default, tuple) else type(default)]
    ranged = "" if about["low"] is None else f" from {about['low']:g} to {about['high']:g}"
    if isinstance(default, tuple):
        return f"a list of {about['count']}, each {kind}{ranged}"
    return kind + ranged


def _meaning(entry: Field[Any]) -> str:
    return f"{entry.metadata['meaning']} ({_allowed(entry)})"


def _entries(section: str) -> dict[str, Field[Any]]:
    kind = _type_of(next(s for s in fields(Settings) if s.name == section))
    return {_key(entry): entry for entry in fields(kind)}


def _type_of(section: Field[Any]) -> Any:
    found = section.default_factory
    assert is_dataclass(found)
    return found


def _key(entry: Field[Any]) -> str:
    return entry.metadata["key"] or entry.name


def _written(value: Any) -> str:
    if isinstance(value, tuple):
        return f"[{', '.join(map(repr, value))}]"
    if isinstance(value, str):
        # JSON writes characters beyond 16 bits as two, which TOML does not read.
        parts = (json.dumps(c)[1:-1] if ord(c) < 1 << 16 else f"\\U{ord(c):08x}" for c in value)
        return f'"{"".join(parts)}"'
    return json.dumps(value) if isinstance(value, bool) else repr(value)


def _unreadable(path: Path, reason: str) -> Rejected:
    return Rejected(
        Diagnostic(
            "NS0813",
            f"the configuration {str(path)[:200]!a} cannot be read: {reason}",
            helps=("`nscc train --schema > config.toml` writes a complete file to start from",),
        ),
        status=2,
    )


def _unknown(
    what: str, name: str, known: Any, source: Source | None, section: str, key: str
) -> Diagnostic:
    near = closest(name, known)
    help_text = f"did you mean `{near}`?" if near else "`nscc train --schema` prints every key"
    return Diagnostic(
        "NS0814",
        f"a configuration has no {what}",
        source=source,
        label=Label(span_of(source.text, section, key)) if source else None,
        helps=(help_text,),
    )


def _wrong(
    message: str, source: Source | None, section: str, key: str, meaning: str = ""
) -> Diagnostic:
    return Diagnostic(
        "NS0815",
        message,
        source=source,
        label=Label(span_of(source.text, section, key)) if source else None,
        notes=(meaning,) if meaning else (),
        helps=("`nscc train --schema` prints every key with what it allows",),
    )
