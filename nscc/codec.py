"""One codec of records: type hints say how a record is written as JSON values, and read again.

`to_plain(record)` returns JSON values, and `from_plain(kind, values)` the record. Whoever declares
a record writes no other code for it. The hints of its fields decide:

* `int` (64 bits), `float` (finite), `str`, `bool`, `Literal` and `None` are themselves; `object` is
  any JSON value.
* `tuple[T, ...]` and `tuple[T, U]` are lists, `Mapping[str, T]` is an object.
* A `Fraction` is two items of the list around it: its numerator and its denominator.
* A dataclass is an object with a key for each field.
* A `Record` is the list of its values; one with a tuple as its only field is that tuple's list.
* A union of records is the name of the record's class, followed by its values.
* `Annotated` adds to a hint: `Within(low, high)` of a number, or of the length of a text, list or
  object; `HEX` for integers of any size, which are texts; `KeyName(name)`, the key of a field that
  has another name in files; `LATER` for a field of a newer version, which is written only if it
  differs from its default.

For example::

    class Stop(Record):
        boundary: Annotated[int, Within(0, 1 << 20)]
        bucket: str

    @dataclass(frozen=True)
    class Stops:
        stops: tuple[Stop, ...]
        note: Annotated[str, LATER] = ""

    to_plain(Stops((Stop(3, "frame"),)))            # {"stops": [[3, "frame"]]}
    from_plain(Stops, {"stops": [[-3, "frame"]]})   # InvalidRecord: `stops[0].boundary` is -3, ..

Both directions check types and limits, so that a file holds only what can be read. `to_json` and
`from_json` add text, and the name and version of a format."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import fields
from fractions import Fraction
from functools import cache, partial
from types import NoneType, UnionType
from typing import (
    Annotated,
    Any,
    Literal,
    NamedTuple,
    TypeVar,
    Union,
    get_args,
    get_origin,
    get_type_hints,
)

from nscc.mappings import JsonObject, NamedValues
from nscc.record import Record

Kind = TypeVar("Kind")
Convert = Callable[[Any], Any]

_MOST_FLOAT = 1e300
"""Numbers of this size or larger are refused, so that sums of many stay finite."""


class InvalidRecord(ValueError):
    """Raised for values that their hints do not allow; the text names the field and the reason."""

    def __init__(self, reason: str, key_path: str = "") -> None:
        """Store why a value is invalid; `key_path` is its path of keys such as `.words[3]`, or ""
        for the whole value."""
        super().__init__(f"`{key_path.removeprefix('.')}` {reason}" if key_path else f"it {reason}")
        self.reason, self.key_path = reason, key_path

    def inside(self, key_path: str) -> InvalidRecord:
        """Return the same error for a value that is inside the value at `key_path`, such as `[3]`
        or `.words`, which is put before its path."""
        return InvalidRecord(self.reason, key_path + self.key_path)


class Within(Record):
    """The smallest (`low`) and largest (`high`) allowed value of a number, or length of a text,
    list or object, both included."""

    low: float
    high: float


class KeyName(Record):
    """The key of a field in a file."""

    name: str


LATER = "later"
"""Marks a field of a dataclass that older files do not have; it has a default."""
HEX = "hex"
"""Marks an integer of any size. Python does not read decimal numbers of thousands of digits."""


def to_plain(record: Any, kind: Any = None) -> Any:
    """Return a record as JSON values.

    Parameters
    ----------
    record : object
        A record, or any value that a hint describes.
    kind : type or hint, optional
        The hint; the record's class by default. A member of a union needs the union.

    Raises
    ------
    InvalidRecord
        A value has another type, or exceeds its limits.
    """
    hint: Any = kind or type(record)
    return _codec(hint).write(record)


def from_plain(kind: Any, plain: Any) -> Any:
    """Return the record that `to_plain` converted to JSON values.

    Parameters
    ----------
    kind : type or hint
        The record's class, or the union of the classes that it may have.
    plain : object
        JSON values, of which nothing is assumed.

    Raises
    ------
    InvalidRecord
        The values are not those of such a record; the text names the field.
    """
    try:
        return _codec(kind).read(plain)
    except RecursionError:
        raise InvalidRecord("is nested too deeply") from None


def to_json(record: Any, schema: str = "") -> str:
    """Return a record as one line of JSON in ASCII; the same record gives the same text.

    Raises InvalidRecord for a value that the record's hints do not allow. With `schema`, such as
    ``"nscc-plan-3"``, the text has a key `schema` that names its format and version."""
    import json

    plain = to_plain(record)
    values = {"schema": schema, **plain} if schema else plain
    return json.dumps(values, sort_keys=True, separators=(",", ":"), allow_nan=False)


def from_json(kind: type[Kind], text: str | bytes, schema: str = "") -> Kind:
    """Return the record of class `kind` in a text that `to_json` wrote.

    `schema` is what the key `schema` must hold; "" expects no such key. Raises InvalidRecord for
    any other text."""
    import json

    try:
        plain = json.loads(text)
    except RecursionError:
        raise InvalidRecord("is nested too deeply") from None
    except ValueError as error:
        raise InvalidRecord(f"is not JSON: {str(error)[:80]}") from None
    if schema:
        actual = plain.pop("schema", None) if isinstance(plain, dict) else None
        if actual != schema:
            raise InvalidRecord(f"is {_shown(actual)}, not '{schema}'", ".schema")
    record: Kind = from_plain(kind, plain)
    return record


class _Codec(NamedTuple):
    """How values of one hint are written to JSON values and read again.

    `write` and `read` raise InvalidRecord for a value that the hint does not allow. `width` is the
    number of items that a value takes in the list of a record, 0 for a list of any length."""

    write: Convert
    read: Convert
    width: int = 1


class _Field(NamedTuple):
    """A field of a record, or an item of a tuple, with its codec.

    `name` is the attribute, or `[i]` for an item of a tuple. `key` is its key in JSON objects, ""
    for such an item. A `later` field may be missing, and then has its `default`."""

    name: str
    key: str
    codec: _Codec
    later: bool = False
    default: Any = None

    @property
    def key_path(self) -> str:
        """The field's part of a path in messages."""
        return f".{self.key}" if self.key else self.name


@cache
def _codec(hint: Any) -> _Codec:
    """Return the codec of a type hint; raise TypeError for a hint that has none, which is a fault
    of nscc."""
    origin, arguments = get_origin(hint), get_args(hint)
    if hint in _SCALARS:
        return _Codec(_SCALARS[hint], _SCALARS[hint])
    if origin is Annotated:
        return _annotated(arguments[0], arguments[1:])
    if origin is Literal:
        return _literal(arguments)
    if origin in (Union, UnionType):
        return _union(arguments)
    if origin is tuple and arguments[1:] == (...,):
        item = _codec(arguments[0])
        return _Codec(
            lambda values: _convert_all(item.write, values),
            lambda plain: tuple(_convert_all(item.read, _instance(list, plain))),
            width=0,
        )
    if origin is tuple:
        row = tuple(_Field(f"[{i}]", "", _codec(kind)) for i, kind in enumerate(arguments))
        return _Codec(
            lambda values: _joined(row, values),
            lambda plain: tuple(_split(row, _instance(list, plain))),
        )
    if origin is not None and issubclass(origin, Mapping):
        value = _codec(arguments[1])
        return _Codec(
            lambda values: _convert_values(value.write, values),
            lambda plain: _convert_values(value.read, _instance(dict, plain)),
        )
    if hint is Fraction:
        return _Codec(lambda value: list(value.as_integer_ratio()), _read_fraction, width=2)
    if issubclass(hint, Record):
        return _Codec(
            lambda record: _joined(_fields(hint), _values(hint, record)),
            lambda plain: hint(*_split(_fields(hint), _instance(list, plain))),
        )
    if hasattr(hint, "__dataclass_fields__"):
        return _Codec(partial(_write_object, hint), partial(_read_object, hint))
    raise TypeError(f"no codec for {hint}")


def _shown(value: Any) -> str:
    """Return a value, or its kind if it is no text or number, for a message: at most 40 characters,
    and printable whatever it is."""
    # Python refuses to write integers of thousands of digits.
    if type(value) is int and abs(value) >= 1 << 64:
        return "a number of more than 64 bits"
    text = ascii(value) if isinstance(value, str | int | float | None) else _NAMES[type(value)]
    return text if len(text) <= 40 else f"{text[:36]} ..."


_NAMES: Mapping[type, str] = defaultdict(
    lambda: "an unknown value",
    {
        int: "an integer of 64 bits",
        float: "a finite number",
        str: "a text",
        list: "a list",
        bool: "true or false",
        NoneType: "null",
        dict: "an object",
    },
)


def _refused(value: Any, needed: str) -> InvalidRecord:
    """Return the exception that a value is not of the `needed` kind, which completes "is ..., not
    ..."."""
    return InvalidRecord(f"is {_shown(value)}, not {needed}")


def _instance(kind: type, value: Any) -> Any:
    """Return a value if it is of exactly the type `kind`; raise InvalidRecord otherwise."""
    if type(value) is not kind:
        raise _refused(value, _NAMES[kind])
    return value


def _integer(value: Any) -> int:
    """Return a value if it is an integer of 64 bits with its sign; raise InvalidRecord otherwise,
    also for True and False."""
    if type(value) is not int or not -(1 << 63) <= value < 1 << 63:
        raise _refused(value, _NAMES[int])
    return value


def _number(value: Any) -> float:
    """Return a number below `_MOST_FLOAT` in magnitude as float; raise InvalidRecord for any other
    value, also for NaN, True and False."""
    if type(value) not in (int, float) or not -_MOST_FLOAT < value < _MOST_FLOAT:
        raise _refused(value, _NAMES[float])
    return float(value)


_SCALARS: dict[Any, Convert] = {
    int: _integer,
    float: _number,
    **{kind: partial(_instance, kind) for kind in (str, bool, NoneType)},
    object: lambda value: value,
}


def _read_fraction(items: list[Any]) -> Fraction:
    """Return the fraction of `items`, a numerator and a denominator; raise InvalidRecord unless
    both are integers and the denominator is not 0."""
    if not all(type(item) is int for item in items) or items[1] == 0:
        raise InvalidRecord("is not a fraction: two integers, the second not 0")
    return Fraction(*items)


def _literal(options: tuple[Any, ...]) -> _Codec:
    """Return the codec of a Literal hint, which allows only values that equal one of `options` and
    have its type. It raises InvalidRecord for others."""

    def check(value: Any) -> Any:
        """Return `value` if it is one of the options; raise InvalidRecord otherwise."""
        for option in options:
            if type(value) is type(option) and value == option:
                return value
        raise _refused(value, " or ".join(map(repr, options)))

    return _Codec(check, check)


def _annotated(kind: Any, remarks: tuple[Any, ...]) -> _Codec:
    """Return the codec of a hint `kind` with the remarks that Annotated adds.

    HEX stores an integer as hexadecimal text. Each `Within` limits a number or the length of a
    value, in writing and reading. Other remarks (KeyName, LATER) concern fields, and are ignored
    here."""
    if HEX in remarks:
        return _Codec(lambda value: f"{value:x}", _read_hex)
    codec = _codec(kind)
    for limits in remarks:
        if isinstance(limits, Within):
            checked = partial(_checked, limits)
            codec = codec._replace(write=checked(codec.write), read=checked(codec.read))
    return codec


def _read_hex(text: Any) -> int:
    """Return the integer of a hexadecimal text; raise InvalidRecord for any other value."""
    try:
        return int(_instance(str, text), 16)
    except ValueError:
        raise _refused(text, "a number in hexadecimal") from None


def _checked(limits: Within, convert: Convert) -> Convert:
    """Return the conversion `convert`, followed by a check of the result against `limits`.

    The new function raises InvalidRecord if the result is a number outside the limits, or another
    value whose length is."""

    def converted(value: Any) -> Any:
        """Convert `value`; raise InvalidRecord if the result (or its length) is outside the
        limits."""
        result = convert(value)
        is_number = isinstance(result, int | float)  # else the length is limited
        measured = result if is_number else len(result)
        if not limits.low <= measured <= limits.high:
            allowed = f"{limits.low:.15g} to {limits.high:.15g}"
            found = f"is {_shown(value)}" if is_number else f"has a length of {measured}"
            raise InvalidRecord(f"{found}, but {allowed} is allowed")
        return result

    return converted


def _union(kinds: tuple[Any, ...]) -> _Codec:
    """Return the codec of a union of `kinds`: of a hint and None, or of records. It raises
    InvalidRecord for a record of another class.

    A record of a union is stored as the name of its class, followed by its values."""
    if NoneType in kinds:
        optional = _codec(Union[tuple(kind for kind in kinds if kind is not NoneType)])  # noqa: UP007
        return _Codec(
            lambda value: None if value is None else optional.write(value),
            lambda plain: None if plain is None else optional.read(plain),
        )
    by_name = {kind.__name__: kind for kind in kinds}

    def write(value: Any) -> list[Any]:
        """Return the name of the value's class, followed by the plain values of its fields."""
        name = type(value).__name__
        if name not in by_name:
            raise _refused(value, f"one of {', '.join(by_name)}")
        return [name, *_joined(_fields(by_name[name]), _values(by_name[name], value))]

    def read(plain: Any) -> Any:
        """Return the record whose class is named by the first item of `plain`; the other items are
        its fields."""
        name = _instance(list, plain)[0] if plain else None
        if type(name) is not str or name not in by_name:
            raise InvalidRecord(f"begins with {_shown(name)}, not with the name of a node")
        return by_name[name](*_split(_fields(by_name[name]), plain[1:]))

    return _Codec(write, read)


def _convert_all(convert: Convert, values: Any) -> list[Any]:
    """Return the values of a sequence, each converted by `convert`; an InvalidRecord names the
    index of the invalid value."""
    converted: list[Any] = []
    try:
        for value in values:
            converted.append(convert(value))
    except InvalidRecord as error:
        raise error.inside(f"[{len(converted)}]") from None
    return converted


def _convert_values(convert: Convert, values: Mapping[str, Any]) -> NamedValues:
    """Return a mapping whose values are converted by `convert`; an InvalidRecord names the key of
    the invalid value."""
    converted: NamedValues = {}
    name = ""
    try:
        for name, value in values.items():
            converted[name] = convert(value)
    except InvalidRecord as error:
        raise error.inside(f".{ascii(name)[1:-1][:40]}") from None
    return converted


def _joined(row: Sequence[_Field], values: Sequence[Any]) -> list[Any]:
    """Return the items of a record's fields in one list.

    `row` declares the fields, and `values` has one value for each, in the same order. A field of
    width 2 adds two items; a record's only field, if it is a list, adds its items; every other
    field adds one item. Raises InvalidRecord for an invalid value."""
    items: list[Any] = []
    for field, value in zip(row, values, strict=True):
        try:
            plain = field.codec.write(value)
        except InvalidRecord as error:
            raise error.inside(field.key_path) from None
        if field.codec.width == 2 or (field.codec.width == 0 and len(row) == 1):
            items += plain
        else:
            items.append(plain)
    return items


def _split(row: Sequence[_Field], items: list[Any]) -> Iterator[Any]:
    """Yield the values of the fields `row` from `items`, the list of a record, whose form `_joined`
    describes.

    Raises InvalidRecord for an invalid item, or another number of items."""
    if len(row) == 1 and row[0].codec.width == 0:
        yield row[0].codec.read(items)
        return
    # Beside other fields, a list (width 0) is one item of the record's list.
    length = sum(field.codec.width or 1 for field in row)
    if len(items) != length:
        raise InvalidRecord(f"has {len(items)} items, not {length}")
    position = 0
    for field in row:
        width = field.codec.width or 1
        try:
            yield field.codec.read(
                items[position : position + 2] if width == 2 else items[position]
            )
        except InvalidRecord as error:
            raise error.inside(field.key_path) from None
        position += width


@cache
def _fields(kind: Any) -> tuple[_Field, ...]:
    """Return the fields of a record class, in order.

    They are found when a record is first converted, because a record may contain its own kind."""
    hints = get_type_hints(kind, include_extras=True)
    row = []
    for field in fields(kind):
        hint = hints[field.name]
        remarks = get_args(hint)[1:] if get_origin(hint) is Annotated else ()
        key = next((remark.name for remark in remarks if isinstance(remark, KeyName)), field.name)
        row.append(_Field(field.name, key, _codec(hint), LATER in remarks, field.default))
    return tuple(row)


def _values(kind: Any, record: Any) -> list[Any]:
    """Return the field values of a record, in order; raise InvalidRecord unless its class is
    exactly `kind`."""
    names = [field.name for field in _fields(kind)]
    if type(record) is not kind:
        raise InvalidRecord(f"is a {type(record).__name__}, not a {kind.__name__}")
    return [getattr(record, name) for name in names]


def _write_object(kind: Any, record: Any) -> JsonObject:
    """Return a record of the dataclass `kind` as a JSON object.

    Fields of a newer version are left out if they have their default. Raises InvalidRecord for an
    invalid value, or a record of another class."""
    plain: JsonObject = {}
    for field, value in zip(_fields(kind), _values(kind, record), strict=True):
        if not field.later or value != field.default:
            plain |= _convert_values(field.codec.write, {field.key: value})
    return plain


def _read_object(kind: Any, plain: Any) -> Any:
    """Return the record of the dataclass `kind` that the JSON object `plain` describes.

    Raises InvalidRecord for an unknown key, an invalid value, and a missing key unless a later
    version added the field."""
    _instance(dict, plain)
    row = {field.key: field for field in _fields(kind)}
    for key in plain.keys() - row.keys():
        raise InvalidRecord("is unknown", f".{ascii(key)[1:-1][:40]}")
    values = {}
    for key, field in row.items():
        if key in plain:
            values[field.name] = _convert_values(field.codec.read, {key: plain[key]})[key]
        elif not field.later:
            raise InvalidRecord("is missing", f".{key}")
    return kind(**values)
