"""The schema of a kind of TOML file: one row for each key.

Files with a schema are read with all errors at once, and written completely."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Mapping, Sequence
from dataclasses import MISSING, dataclass, field, fields, replace
from functools import cache, cached_property
from pathlib import Path
from typing import Any, Generic, TypeVar

from nscc.diagnostics.diagnostic import Diagnostic, Label, rejected
from nscc.diagnostics.suggest import closest, did_you_mean, meant
from nscc.files import reads
from nscc.mappings import JsonObject
from nscc.source import Source
from nscc.toml.kinds import Kind, TextKind
from nscc.toml.toml_text import (
    LARGEST_FILE,
    NotToml,
    parsed,
    shown,
    span_of,
    spelled_value,
    written,
)

_FEW = 10
"""Most keys of a table that a message about an unknown key lists."""

KeyValues = dict[str, Any]
"""Python values by the paths of their keys."""


@dataclass(frozen=True, slots=True)
class Key:
    """The declaration of a key of a file, which may also be an option of a command and an argument
    in Python.

    `name` is the key in the table `section` ("" for the top of the file). `meaning` is half a
    sentence. `source` is the origin of the default, empty if it is published. A file lists the key
    under `heading`, by default its section. `attribute` is the name in Python, by default the key's
    name. A `required` key must be in the file. A `later` key was added after the first containers
    (compiled programs) and is left out of containers if it has its default.

    `option` is the option's name, by default `--NAME`; `notation` shows how its value is written;
    `default_text` describes the default in place of the value, and is empty if `meaning` describes
    it. Each of `checks` takes all settings. It returns the reason why they contradict the value of
    this key, or a false value."""

    section: str
    name: str
    kind: Kind
    meaning: str
    default: Any = MISSING
    source: str = ""
    required: bool = False
    heading: str = ""
    attribute: str = ""
    later: bool = False
    option: str = ""
    notation: str = ""
    default_text: str | None = None
    checks: tuple[Callable[[Any], object], ...] = ()

    def __post_init__(self) -> None:
        """Derive option, heading and attribute from the name, unless they are given."""
        object.__setattr__(self, "option", self.option or "--" + self.name.replace("_", "-"))
        object.__setattr__(self, "heading", self.heading or self.section)
        object.__setattr__(self, "attribute", self.attribute or self.name)

    @property
    def path(self) -> str:
        """The section and name, as messages and changes write the key."""
        return f"{self.section}.{self.name}" if self.section else self.name


@dataclass(frozen=True, slots=True)
class FileCodes:
    """The codes of the errors that a kind of file can have, such as `unknown` for an unknown key.
    `unreadable` is the code for a file that cannot be read, `not_toml` for one that is no TOML
    table. `wrong_value` is for an invalid value, and `missing` for a missing key.

    `change` is the code for a change on the command line that is not KEY=VALUE."""

    unreadable: str
    not_toml: str
    unknown: str
    wrong_value: str
    missing: str = ""
    change: str = ""


def key(kind: Kind, meaning: str, default: Any = MISSING, **about: Any) -> Any:
    """Declare a dataclass field as a key of a file or an option.

    `meaning` is half a sentence for help texts; without `default` the field is required. `about`
    are further attributes of `Key`, such as `section` and `required`."""
    return field(default=default, metadata={"kind": kind, "meaning": meaning, **about})


def keys_of(settings: type, section: str = "") -> tuple[Key, ...]:
    """Return the keys that the fields of `settings`, a dataclass, declare, in order.

    Fields without a kind are internal and left out. Keys without a section of their own are in
    `section`."""
    return tuple(
        Key(
            **{
                "section": section,
                "name": member.name,
                "attribute": member.name,
                "default": member.default,
                **member.metadata,
            }
        )
        for member in fields(settings)
        if "kind" in member.metadata
    )


@cache
def declared(settings: type) -> Mapping[str, Key]:
    """Return the keys that the fields of a dataclass declare, by the names of the fields. Fields
    that are not made by `key` are left out."""
    return {key.attribute: key for key in keys_of(settings)}


Row = TypeVar("Row", bound=Key)


@dataclass(frozen=True)
class Schema(Generic[Row]):
    """All keys of a kind of file, which messages call `file_kind`.

    `keys` are in the order of a file, `headings` have a comment each, and `start` is a help for
    starting a file. Messages call a key `noun`; `option` is the option that changes a key,
    `example` an example of a change. Raises ValueError if two keys have the same path, or a key has
    an unknown heading."""

    file_kind: str
    keys: tuple[Row, ...]
    headings: Mapping[str, str]
    codes: FileCodes
    start: str
    noun: str = "key"
    option: str = ""
    example: str = ""

    def __post_init__(self) -> None:
        """Raise ValueError if two keys have one path, or a key has an unknown heading."""
        for index, key in enumerate(self.keys):
            if key.path in (earlier.path for earlier in self.keys[:index]):
                raise ValueError(f"two keys of a {self.file_kind} are {key.path}")
            if key.heading not in self.headings:
                raise ValueError(f"{key.path} has the unknown heading {key.heading!a}")

    @cached_property
    def by_path(self) -> dict[str, Row]:
        """The keys by path (SECTION.NAME)."""
        return {key.path: key for key in self.keys}

    @cached_property
    def sections(self) -> dict[str, tuple[str, ...]]:
        """The names of the keys in each table, by table; those of "" (the top) include the names of
        tables."""
        names_of_table: dict[str, list[str]] = {"": []}
        for key in self.keys:
            names_of_table.setdefault(key.section, []).append(key.name)
        names_of_table[""] += [name for name in names_of_table if name]
        return {name: tuple(names) for name, names in names_of_table.items()}

    @property
    def tables(self) -> tuple[str, ...]:
        """The names of the tables."""
        return tuple(name for name in self.sections if name)

    def read(
        self, values: Mapping[str, Any], source: Source | None = None, *, complete: bool = False
    ) -> tuple[KeyValues, list[Diagnostic]]:
        """Return the valid values of a parsed file by path, and the errors of the invalid ones.

        `values` is {section: {key: value}}; keys without a section stand beside the sections.
        `source` is the file's text, for places in messages. Missing keys are errors if `required`;
        with `complete`, all missing keys are, except `later` keys and lists that are empty by
        default."""
        key_values: KeyValues = {}
        problems: list[Diagnostic | None] = []
        for name, value in values.items():
            if name and name in self.sections and isinstance(value, Mapping):
                problems += (
                    self._add_value(key_values, name, *item, source) for item in value.items()
                )
            else:
                problems.append(self._add_value(key_values, "", name, value, source))
        for key in self.keys:
            table = values.get(key.section, {}) if key.section else values
            # Files written before a `later` key existed lack it.
            needed = key.required or (complete and key.default != () and not key.later)
            if needed and isinstance(table, Mapping) and key.name not in table:
                message = f"the key {key.path} is missing: {key.meaning}"
                missing = self.codes.missing, message, key.section, key.name, source, self.start
                problems.append(self.problem(*missing))
        return key_values, [item for item in problems if item]

    def changed(self, changes: Sequence[str]) -> tuple[KeyValues, list[Diagnostic]]:
        """Return the values of changes KEY=VALUE by path, and the errors of invalid changes.

        KEY is SECTION.NAME, or NAME if the key has no section. The last change of a key counts.
        VALUE is written as in a file, but a text needs no quotes."""
        key_values: KeyValues = {}
        problems: list[Diagnostic] = []
        for change in changes:
            path, equals, spelled = (text.strip() for text in change.partition("="))
            section, _, name = path.rpartition(".") if self.tables else ("", "", path)
            key = self.by_path.get(path)
            # Only the value of a text may be empty.
            if not name or not equals or not (spelled or (key and isinstance(key.kind, TextKind))):
                form = "SECTION.KEY=VALUE" if self.tables else "NAME=VALUE"
                message = f"{self.option} takes {form}, not {change[:60]!a}"
                help_text = f"for instance {self.option} {self.example}"
                problems.append(Diagnostic(self.codes.change, message, helps=(help_text,)))
            elif problem := self._add_value(
                key_values, section, name, spelled_value(spelled), source=None
            ):
                problems.append(replace(problem, message=f"{self.option}: {problem.message}"))
        return key_values, problems

    def plain(self, values: Mapping[str, Any]) -> JsonObject:
        """Return values, keyed by path, as {section: {key: value}} in the order of a file, for TOML
        or JSON.

        `values` must have every key. Keys without a section stand at the top. All keys are present,
        except lists that are empty by default and `later` keys at their default."""
        tables: JsonObject = {}
        for key in self.keys:
            if values[key.path] == key.default and (key.default == () or key.later):
                continue
            table = tables.setdefault(key.section, {}) if key.section else tables
            table[key.name] = key.kind.plain(values[key.path])
        return tables

    def _add_value(
        self, key_values: KeyValues, section: str, name: str, value: Any, source: Source | None
    ) -> Diagnostic | None:
        """Add a valid value to `key_values`; return the error of an invalid value, else None.

        `source` is the text of the file, for the place of the error; None without one. A value is
        valid if the table `section` has the key `name` and its kind allows the value."""
        key = self.by_path.get(f"{section}.{name}" if section else name)
        if key is None or key.section != section:
            known = self.sections.get(section, ())
            tables = self.tables
            if not section and name in tables:
                message = f"{name} must be a table of keys (a line `[{name}]`), not {shown(value)}"
                return self.problem(self.codes.wrong_value, message, section, name, source)
            # The unknown table is the section itself or, at the top, a key whose value is a table.
            table = section if section not in self.sections else name
            if tables and (table == section or (not section and isinstance(value, Mapping))):
                message = f"a {self.file_kind} has no table {shown(table)}"
                [help_text] = meant(table, tables, f"the tables are {', '.join(tables)}")
            else:
                table_text = (
                    f"[{section}] of a {self.file_kind}" if section else f"a {self.file_kind}"
                )
                message = f"{table_text} has no {self.noun} {shown(name)}"
                help_text = self._meant(section, name, known)
            return self.problem(self.codes.unknown, message, section, name, source, help_text)
        try:
            key_values[key.path] = key.kind.read(value)
        except ValueError as reason:
            message = f"{key.path} must be {key.kind.allowed}, not {shown(value)}"
            note = str(reason) or f"{key.path}: {key.meaning}"
            return self.problem(self.codes.wrong_value, message, section, name, source, note=note)
        return None

    def _meant(self, section: str, name: str, known: Sequence[str]) -> str:
        """Return the help for an unknown name in the table `section`, whose names are `known`.

        It names the table that the name belongs to, else the most similar name here or in another
        table, else the known names if they are few, else `start`."""
        homes = {key.name: key.section for key in reversed(self.keys)}
        nearest, elsewhere = closest(name, known), closest(name, homes)
        places = {table: f"under [{table}]" if table else "at the top" for table in self.sections}
        if name in homes:
            return f"`{name}` belongs {places[homes[name]]}"
        if nearest:
            return did_you_mean(nearest)
        if elsewhere:
            return f"did you mean `{elsewhere}` {places[homes[elsewhere]]}?"
        return f"the {self.noun}s here are {', '.join(known)}" if len(known) <= _FEW else self.start

    def problem(
        self,
        code: str,
        message: str,
        section: str,
        name: str,
        source: Source | None,
        help_text: str = "",
        note: str = "",
    ) -> Diagnostic:
        """Return the error `code` with `message` at the key `name` of the table `section`; an empty
        `help_text` or `note` is left out.

        With the section "", `name` may also be a table. `source` is the text of the file, for the
        place; None if there is no file."""
        return Diagnostic(
            code,
            message,
            source=source,
            label=Label(span_of(source.text, section, name)) if source else None,
            notes=(note,) if note else (),
            helps=(help_text,) if help_text else (),
            data={self.noun: name[:60]},
        )


WIDTH = 100
"""Most columns of a comment that stands on its own lines."""
_REMARK_COLUMN = 42
"""Column of a comment that stands beside its key."""


def file_bytes(schema: Schema[Row], path: Path, name: str = "") -> bytes:
    """Return the bytes of a user's file, at most one more than `LARGEST_FILE`.

    `schema` gives the codes and the words of the error. Messages call the file `name`, by default
    its path. Raises Rejected (status 2) if it cannot be read."""
    reads(path)
    try:
        with open(path, "rb") as file:
            # One byte more than allowed is enough for `parsed` to refuse the file.
            return file.read(LARGEST_FILE + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise rejected(
            schema.codes.unreadable,
            f"the {schema.file_kind} file {(name or str(path))[:200]!a} cannot be read: {reason}",
            helps=(schema.start,),
        ) from None


def file_values(
    schema: Schema[Row],
    data: bytes,
    name: str,
    *,
    status: int = 2,
    choose: Callable[[Mapping[str, Any]], Schema[Row]] | None = None,
) -> tuple[KeyValues, list[Diagnostic], Source]:
    """Return the valid values in a file's bytes by path, the errors of the others, and the text.

    Values are by path (SECTION.NAME); the text is a `Source` of this name. Messages call the file
    `name`. `choose` returns the schema for a file's unchecked values; None always uses `schema`.
    Raises Rejected with the exit status `status` if `data` is not TOML."""
    values, source = file_table(schema, data, name, status=status)
    chosen = schema if choose is None else choose(values)
    return *chosen.read(values, source), source


def file_table(
    schema: Schema[Row], data: bytes, name: str, *, status: int = 2
) -> tuple[JsonObject, Source]:
    """Return the values in `data`, a file's bytes, {section: {key: value}} and not yet checked, and
    its text.

    `schema` gives the code of the error. Messages call the file `name`. Raises Rejected with the
    exit status `status` if `data` is not TOML."""
    try:
        text, values = parsed(data)
    except NotToml as reason:
        raise rejected(
            schema.codes.not_toml,
            f"the {schema.file_kind} file {name[:200]!a} is not a TOML table: {reason}",
            helps=(schema.start,),
            status=status,
        ) from None
    return values, Source(name, text)


def file_text(
    schema: Schema[Row],
    values: Mapping[str, Any],
    remark: Callable[[Row], str],
    head: Sequence[str] = (),
    *,
    beside: bool = False,
) -> str:
    """Return the text of a complete file with the given values, which are keyed by path.

    `values` must have every key of the schema. `head` are comment lines at the start. `remark`
    returns the comment of a key, which is written above its line, or with `beside` at its end if
    the line is short."""
    lines = [f"# {line}" for line in head]
    for heading, heading_text in schema.headings.items():
        rows = [key for key in schema.keys if key.heading == heading]
        if heading and rows:
            lines += [""] if lines else []
            title = f"[{heading}]" if rows[0].section else f"## {heading}: {heading_text}"
            lines.append(_beside(title, heading_text if rows[0].section and beside else ""))
        for key in rows:
            line = f"{key.name} = {written(key.kind.plain(values[key.path]))}"
            text = remark(key)
            if beside and len(line) <= 60:
                lines.append(_beside(line, text))
            else:
                # A file with comments beside keys has each comment on one line, however long.
                width = 1000 if beside else WIDTH - 2
                lines += [*(f"# {comment}" for comment in textwrap.wrap(text, width)), line]
    return "\n".join(lines) + "\n"


def _beside(line: str, remark: str) -> str:
    """Return a line with a comment in column `_REMARK_COLUMN`, or the line alone if `remark` is
    empty."""
    return f"{line:<{_REMARK_COLUMN}} # {remark}" if remark else line
