"""Targets by name or from a file: the builtin tables and a user's own.

A name that ends in `.toml` or holds a `/` is a file, anything else one of the builtin tables. In a
user's file every key must be known; keys about what is not public may be left out and then
have scamp5's value.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic, Label, Rejected
from nscc.diagnostics.suggest import closest
from nscc.source import Source, Span
from nscc.target.schema import KEYS, SECTIONS
from nscc.target.target import Target
from nscc.target.values import Problem, read_values, target_values
from nscc.toml.text import LARGEST_FILE, NotToml, parsed, span_of

DEFAULT_NAME = "scamp5"
_TABLES = Path(__file__).with_name("tables")


def builtin_names() -> tuple[str, ...]:
    """The names of the tables that come with nscc, in alphabetical order."""
    return tuple(sorted(path.stem for path in _TABLES.glob("*.toml")))


@lru_cache(maxsize=16)
def builtin_target(name: str) -> Target:
    """The builtin table of that name, which must exist."""
    text = (_TABLES / f"{name}.toml").read_text(encoding="utf-8")
    defaults = None if name == DEFAULT_NAME else builtin_target(DEFAULT_NAME)
    target, problems = read_values(tomllib.loads(text), defaults)
    if target is None:
        raise ValueError(f"the builtin target {name} is broken: {problems[0].message}")
    return target


def load_target(
    name_or_path: str,
    base: Path,
    *,
    source: Source | None = None,
    span: Span | None = None,
) -> Target:
    """The target that a `target` statement or `--target` names; files are relative to `base`.

    `source` and `span` are where the name stands, for messages. Raises Rejected: NS0230 for a name
    that is not known, NS0231 (status 2) for a file that cannot be read, NS0232 to NS0236 for what
    is wrong in it, all at once.
    """
    if name_or_path.endswith(".toml") or "/" in name_or_path or "\\" in name_or_path:
        data = read_target(name_or_path, base, source=source, span=span)
        return parse_target(data, name_or_path)
    names = builtin_names()
    if name_or_path in names:
        return builtin_target(name_or_path)
    near = closest(name_or_path, names)
    shown = ascii(name_or_path[:60])
    raise Rejected(
        Diagnostic(
            "NS0230",
            f"nscc knows no target {shown}",
            source=source,
            label=Label(span, "no such target") if source and span else None,
            notes=(f"the targets are {', '.join(names)}",),
            helps=(
                *((f"did you mean `{near}`?",) if near else ()),
                "a target of your own is a file whose name ends in .toml: "
                "`nscc targets scamp5 --toml` prints one to start from",
            ),
            data={"target": name_or_path[:60], "known": list(names)},
        )
    )


def target_dict(target: Target) -> dict[str, Any]:
    """The target as JSON values: sections of keys, every key present."""
    return target_values(target)


def target_from_dict(values: Mapping[str, Any]) -> Target:
    """The target of `target_dict`'s values; ValueError with the first fault if they are none."""
    target, problems = read_values(values, None)
    if target is None:
        raise ValueError(problems[0].message)
    return target


def target_toml(target: Target) -> str:
    """A complete, commented table that `load_target` reads back as this target."""
    values = target_values(target)
    lines = [
        "# A target of nscc: what the compiler, the checker and the emulator know of a chip.",
        "# Keys marked (not public) are this project's defaults; they may be left out.",
        *(line for key in KEYS if not key.section for line in _key_line(key.key, values)),
    ]
    for section, remark in SECTIONS.items():
        if section:
            header = f"[{section}]"
            lines += ["", f"{header:<42} # {remark}" if remark else header]
            for key in KEYS:
                if key.section == section:
                    lines += _key_line(key.key, values[section], key.comment, key.public)
    return "\n".join(lines) + "\n"


def _key_line(
    name: str, values: Mapping[str, Any], comment: str = "", public: bool = True
) -> list[str]:
    remark = comment if public else f"{comment} (not public)"
    text = f"{name} = {_toml_value(values[name])}"
    if len(text) > 60:
        return [*([f"# {remark}"] if remark else []), text]
    return [f"{text:<42} # {remark}" if remark else text]


def _toml_value(value: Any) -> str:
    if isinstance(value, str):
        import json  # only where a table is printed: keeps start-up short

        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list):
        return "[" + ", ".join(_toml_value(item) for item in value) + "]"
    return repr(value)


def read_target(
    name: str, base: Path, *, source: Source | None = None, span: Span | None = None
) -> bytes:
    """What a user's file holds, for `parse_target`; arguments and NS0231 as of `load_target`."""
    at = Label(span, "this file") if source and span else None
    try:
        with open(base / name, "rb") as file:
            return file.read(LARGEST_FILE + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        shown = ascii(name[:200])
        raise Rejected(
            Diagnostic(
                "NS0231",
                f"the target file {shown} cannot be read: {reason}",
                source=source,
                label=at,
                helps=(
                    "a target file is looked up beside the program that names it; "
                    "the builtin targets need no file: " + ", ".join(builtin_names()),
                ),
            ),
            status=2,
        ) from None


def parse_target(data: bytes, name: str) -> Target:
    """The target of a user's TOML text; `name` is the file's for messages.

    Raises Rejected, NS0232 to NS0236, with everything that is wrong.
    """
    text, values = _parsed(name, data)
    target, problems = read_values(values, builtin_target(DEFAULT_NAME))
    if target is None:
        origin = Source(name, text)
        raise Rejected([_diagnostic(problem, origin) for problem in problems])
    return target


def _parsed(name: str, data: bytes) -> tuple[str, dict[str, Any]]:
    """The text of a target file and its TOML values; raises Rejected (NS0232)."""
    try:
        return parsed(data)
    except NotToml as reason:
        raise Rejected(
            Diagnostic(
                "NS0232",
                f"the target file {name[:200]!a} is not a TOML table: {reason}",
                helps=("`nscc targets scamp5 --toml` prints a complete file to start from",),
            )
        ) from None


def _diagnostic(problem: Problem, source: Source) -> Diagnostic:
    span = span_of(source.text, problem.section, problem.key)
    found = Diagnostic(problem.code, problem.message, source=source, label=Label(span))
    return replace(found, helps=(problem.help,)) if problem.help else found
