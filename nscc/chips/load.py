"""Loading of targets: built-in tables, tables of other packages, and user files.

A name that ends in `.toml` or contains `/` is a file. All keys in a user's file must be known. Keys
whose value the chip's maker has not published are optional; their default is scamp5's value."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import MISSING, replace
from functools import cache
from itertools import islice
from pathlib import Path
from typing import Any

from nscc.chips.target import SCHEMA, Target, schema_of
from nscc.chips.words import words_toml
from nscc.diagnostics.diagnostic import Diagnostic, Label, Rejected, rejected
from nscc.diagnostics.suggest import meant
from nscc.mappings import JsonObject, NamedValues
from nscc.operations import ANALOG_WRITE, DIGITAL_WRITE
from nscc.plugins import added, unusable
from nscc.source import Source, Span
from nscc.toml.kinds import Several
from nscc.toml.schema import Key, KeyValues, file_bytes, file_text, file_values, keys_of
from nscc.toml.toml_text import shown

_MOST_TOLD = 10
"""Most errors reported for each list of registers."""
_MOST_TAPS = 16
"""Most taps of a pixel on a chip whose shutters arrive as a bit stream."""


def contradictions(registers: Mapping[str, Any]) -> Iterator[tuple[str, str, str]]:
    """Yield the contradictions between the keys of section [registers] of a target file.

    `registers` maps the keys without their section to their values; keys that are absent or have
    errors of their own are left out. At most `_MOST_TOLD` are yielded for each list of registers.
    Each result is (key, message, help); the help is "" if there is none."""
    for key, known in (("analog", tuple(ANALOG_WRITE)), ("digital", tuple(DIGITAL_WRITE))):
        for message, help_text in islice(_listed(registers.get(key, ()), known), _MOST_TOLD):
            yield key, f"registers.{key} lists {message}", help_text
    analog, digital = registers.get("analog"), registers.get("digital")
    scratch, mask, masked = map(registers.get, ("analog_scratch", "mask", "masked"))
    if analog is not None and "analog_scratch" in registers and scratch not in analog:
        message = f"analog_scratch is {shown(scratch)}, not in registers.analog"
        yield "analog_scratch", message, "name one of the registers in registers.analog"
    if (mask is None) != (masked is None):
        key_given, absent = ("mask", "masked") if masked is None else ("masked", "mask")
        message = f"registers.{key_given} is given and registers.{absent} is not: "
        message += "give both or neither"
        yield key_given, message, f'name two registers, or write `{key_given} = "none"`'
    elif mask is not None and mask == masked:
        message = f"registers.mask and registers.masked are both {shown(mask)}"
        yield "masked", message, "name two registers"
    for key, name in (("mask", mask), ("masked", masked)):
        if name is not None and digital is not None and name not in digital:
            message = f"registers.{key} is {shown(name)}, not in registers.digital"
            help_text = 'name one of registers.digital, or write "none" for both mask and masked'
            yield key, message, help_text


def tap_contradictions(stream: Mapping[str, Any]) -> Iterator[tuple[str, str, str]]:
    """Yield the contradictions between the keys of section [stream] of a target file, for chips
    with taps.

    `stream` maps the keys without their section to their values, without absent and invalid ones.
    Each result is (key, message, help); the help is "" if there is none."""
    taps, drain, gains = map(stream.get, ("taps", "drain", "tap_gain"))
    if taps is not None and len(set(taps)) < len(taps):
        yield "taps", "stream.taps has a name twice", ""
    elif taps is not None and not 1 <= len(taps) <= _MOST_TAPS:
        message = f"stream.taps lists {len(taps)} taps, but 1 to {_MOST_TAPS} are allowed"
        yield "taps", message, ""
    elif taps is not None and len(taps) == 1 and not drain:
        message = "stream.taps has one tap and no drain, so all light goes to that tap"
        yield "taps", message, "give `drain = true`, or a second tap"
    if taps is not None and gains and len(gains) != len(taps):
        message = f"stream.tap_gain has {len(gains)} gains, but there are {len(taps)} taps"
        yield "tap_gain", message, "give one for each tap, in their order"


def _listed(names: Sequence[str], known: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Yield the errors in `names`, a list of registers, as (end of a message, help).

    A register must not be listed twice, and must be one of `known`, the registers that instruction
    words address."""
    for index, name in enumerate(names):
        if name in names[:index]:
            yield f"{shown(name)} twice", "list each register once"
        elif name not in known:
            # The analog registers are few; the digital ones are numbered.
            known_text = ", ".join(known) if len(known) < 10 else f"{known[0]} to {known[-1]}"
            yield (
                f"{shown(name)}, which an instruction word cannot address",
                meant(name, known, f"instruction words address {known_text}")[0],
            )


DEFAULT_NAME = "scamp5"
_TABLES = Path(__file__).with_name("tables")


def builtin_names() -> tuple[str, ...]:
    """Return the names of the built-in targets, sorted."""
    return tuple(sorted(path.stem for path in _TABLES.glob("*.toml")))


@cache
def builtin_target(name: str) -> Target:
    """Return the built-in target `name`, which must exist (see `builtin_names`).

    Raises ValueError if its table has errors, which is a fault of nscc."""
    values = tomllib.loads((_TABLES / f"{name}.toml").read_text(encoding="utf-8"))
    key_values, problems = schema_of(values.get("kind")).read(values, complete=name == DEFAULT_NAME)
    if problems:
        raise ValueError(f"the builtin target {name} is broken: {problems[0].message}")
    return _target(key_values)


def target_names() -> tuple[str, ...]:
    """Return the names of all targets: first the built-in ones, then those that installed packages
    add."""
    return (*builtin_names(), *added_targets())


@cache
def added_targets() -> dict[str, Target]:
    """Return the targets that installed packages add, by name.

    A package gives a `Target`, TOML text, or the path of a file. They are loaded once. Raises
    Rejected (NS0905) for other objects, for a name of a built-in target, for a name that differs
    from the one in the table, and for an invalid table."""
    return {
        name: _added(name, value) for name, value in added("nscc.targets", builtin_names()).items()
    }


def load_target(
    name_or_path: str,
    base: Path,
    *,
    source: Source | None = None,
    span: Span | None = None,
) -> Target:
    """Return the target that a `target` statement or `--target` names.

    `name_or_path` is a file, relative to the folder `base`, if it ends in `.toml` or contains a
    slash. `source` and `span` are the program text and the place of the name in it, for messages;
    None if the name is an option. Raises Rejected: NS0230 for an unknown name, NS0231 (status 2)
    for an unreadable file, NS0905 for an invalid target of an installed package, NS0232 to NS0236
    for all errors in a file (status 1 if a `source` names it, else 2)."""
    if name_or_path.endswith(".toml") or "/" in name_or_path or "\\" in name_or_path:
        data = read_target(name_or_path, base, source, span)
        return parse_target(data, name_or_path, status=1 if source else 2)
    if name_or_path in builtin_names():
        return builtin_target(name_or_path)
    if name_or_path in added_targets():
        return added_targets()[name_or_path]
    names = target_names()
    raise rejected(
        "NS0230",
        f"unknown target {name_or_path[:60]!a}",
        status=1 if source else 2,
        source=source,
        label=Label(span, "no such target") if source and span else None,
        notes=(f"the targets are {', '.join(names)}",),
        helps=(
            *meant(name_or_path, names),
            "to define your own target, write a .toml file: "
            "`nscc targets scamp5 --toml` prints a complete one",
        ),
        data={"target": name_or_path[:60], "known": list(names)},
    )


def target_dict(target: Target) -> JsonObject:
    """Return the target as JSON values: {section: {key: value}} in the order of a file.

    Every key is present. Keys without a section stand beside the sections."""
    return schema_of(target.kind).plain(_values(target))


def target_from_dict(values: Mapping[str, Any]) -> Target:
    """Return the target that JSON values {section: {key: value}} describe, as `target_dict` returns
    them.

    Raises ValueError with the message of the first error if the values are invalid."""
    key_values, problems = schema_of(values.get("kind")).read(values, complete=True)
    problems += _contradictions(key_values)
    if problems:
        raise ValueError(problems[0].message)
    return _target(key_values)


def target_toml(target: Target) -> str:
    """Return a complete target file with comments, from which `load_target` reads the same
    target."""

    def remark(key: Key) -> str:
        """Return the comment on a key: its meaning and the source of its value."""
        return f"{key.meaning} ({key.source})" if key.source else key.meaning if key.section else ""

    head = (
        "A target of nscc: what the compiler, the checker and the emulator know of a chip.",
        "Keys marked (not public) are this project's defaults; they may be left out.",
    )
    schema = schema_of(target.kind)
    plain = replace(schema, keys=tuple(key for key in schema.keys if key.path != "words"))
    text = file_text(plain, _values(target), remark, head, beside=True)
    return text + "".join(f"{line}\n" for line in words_toml(target.words))


def read_target(
    name: str, base: Path, source: Source | None = None, span: Span | None = None
) -> bytes:
    """Return the bytes of the target file `name`, a path that is absolute or relative to the folder
    `base`.

    Raises Rejected (NS0231) if it cannot be read. The error marks `span` of `source`, where a
    program names the file; without them it has no place."""
    try:
        return file_bytes(SCHEMA, base / name, name)
    except Rejected as error:
        label = Label(span, "this file") if source and span else None
        looked = (
            "a target file is looked up beside the program that names it; "
            f"the builtin targets need no file: {', '.join(builtin_names())}"
        )
        diagnostic = replace(error.diagnostics[0], source=source, label=label, helps=(looked,))
        raise Rejected(diagnostic, error.status) from None


def parse_target(data: bytes, name: str, *, status: int = 1) -> Target:
    """Return the target that the TOML text `data` describes.

    Keys that may be missing have their default. Messages call the file `name`. Raises Rejected with
    all errors (NS0232 to NS0236) and the exit status `status`."""
    key_values, problems, source = file_values(
        SCHEMA, data, name, status=status, choose=lambda values: schema_of(values.get("kind"))
    )
    problems += _contradictions(key_values, source)
    if problems:
        raise Rejected(problems, status)
    return _target(key_values)


def _target(key_values: KeyValues) -> Target:
    """Return the target with the values `key_values`, {"section.key": value}, which are valid.

    Missing keys have their default. If a key has none, its value is that of scamp5. Chips without
    words ("stream") have no registers: theirs are () and ""."""
    values: NamedValues = {}
    streamed = schema_of(key_values.get("kind")) is not SCHEMA
    for key in keys_of(Target):
        if key.path in key_values:
            values[key.attribute] = key_values[key.path]
        elif key.default is not MISSING:
            continue
        elif streamed and key.section == "registers":
            values[key.attribute] = () if isinstance(key.kind, Several) else ""
        else:
            values[key.attribute] = getattr(builtin_target(DEFAULT_NAME), key.attribute)
    return Target(**values)


def _values(target: Target) -> KeyValues:
    """Return the values of all keys of a target, also those of the other kind of chip, as
    {"section.key": value}."""
    return {key.path: getattr(target, key.attribute) for key in keys_of(Target)}


def _contradictions(key_values: KeyValues, source: Source | None = None) -> list[Diagnostic]:
    """Return an error (NS0236) for each contradiction between valid values.

    `key_values` is {"section.key": value} without the keys that have errors of their own. `source`
    is the text of the target file, for the places in messages; None if there is none."""
    streamed = key_values.get("kind") == "stream"
    section, find_contradictions = (
        ("stream", tap_contradictions) if streamed else ("registers", contradictions)
    )
    begin = f"{section}."
    section_values = {
        path.removeprefix(begin): v for path, v in key_values.items() if path.startswith(begin)
    }
    return [
        SCHEMA.problem("NS0236", message, section, key, source, help_text)
        for key, message, help_text in find_contradictions(section_values)
    ]


def _added(name: str, value: object) -> Target:
    """Return the target `name` that an installed package adds as `value`.

    `value` is a Target, TOML text or the path of a TOML file. Raises Rejected (NS0905, followed by
    the errors of its table) if it is none of them, is invalid, or has another name than `name`."""
    reason = "its table is wrong"
    diagnostics: tuple[Diagnostic, ...] = ()
    try:
        if isinstance(value, Path):
            target = parse_target(file_bytes(SCHEMA, value), str(value))
        elif isinstance(value, str | Target):
            text = value if isinstance(value, str) else target_toml(value)
            target = parse_target(text.encode(), name)
        else:
            raise TypeError(f"expected a target, TOML text or a path, not a {type(value).__name__}")
        if target.name == name:
            return target
        reason = f"the name in its table is {target.name}"
    except Rejected as error:
        diagnostics = error.diagnostics
    except (TypeError, AttributeError) as error:
        reason = str(error)
    refusal = unusable("nscc.targets", name, reason)
    raise Rejected([*refusal.diagnostics, *diagnostics], refusal.status)
