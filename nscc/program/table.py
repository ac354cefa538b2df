"""The decode table: the rules evaluated for every code and slot, with distinct shutters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import prod

import numpy as np

from nscc.arrays import Bools, Bytes, Ints, Ints32
from nscc.program.evaluate import Books, Fault, Value, bit_count, values_of
from nscc.program.expressions import Checked
from nscc.program.limits import (
    COMBINATION_LIMIT,
    PROOF_LIMIT,
    TABLE_LIMIT,
    WORK_LIMIT,
    work,
)
from nscc.program.problems import counted, printable
from nscc.program.program import Field, whole_name
from nscc.words.container import DecodeTable

CodeArray = Ints

_BLOCK = 2**18
"""Number of codes x slots evaluated at once: 2 MB of integers, which fit the cache."""


class TooMuch(Exception):
    """Raised if codes, slots or operations exceed a limit. `message` has no place in the program;
    `required` and `available` are the numbers that it compares."""

    def __init__(self, message: str, required: int, available: int) -> None:
        """Store the message, the number that is required and the limit (`available`)."""
        super().__init__(message)
        self.message = message
        self.required = required
        self.available = available


@dataclass(eq=False, repr=False)
class MissingValue:
    """An expression that has no value for some codes and slots.

    `fault` is the reason, `first_case` names the first code and slot, such as "for stop = 3, in
    slot 0", and `count` is the number of cases."""

    fault: Fault
    first_case: str
    count: int

    @property
    def text(self) -> str:
        """The first code and slot without a value, in words, and how many cases there are."""
        if self.count == 1:
            return self.first_case
        return f"first {self.first_case}; {self.count} times in all"


class NoValue(Exception):
    """Raised for expressions without a value, with one entry for each expression (not for each
    code)."""

    def __init__(self, findings: Sequence[MissingValue]) -> None:
        """Store one `MissingValue` for each expression without a value, at least one. The
        exception's text consists of the messages that say why the values are missing."""
        super().__init__("; ".join(f.fault.message for f in findings))
        self.findings = tuple(findings)


@dataclass(eq=False, repr=False)
class Rules:
    """The checked expressions that define codes and shutters.

    `requires` are the conditions on codes. `rules` has one boolean expression for each bucket.
    `books` are the codebooks by name, and `slots` is N. `rules` are in the order of the buckets in
    the program, and `fields` in that of the columns of codes."""

    fields: tuple[Field, ...]
    requires: Sequence[Checked]
    rules: Sequence[Checked]
    books: Books
    slots: int

    @property
    def combinations(self) -> int:
        """The number of combinations of field values, whether or not `require` allows them."""
        return prod(field.high - field.low + 1 for field in self.fields)


def allowed(rules: Rules, codes: CodeArray) -> Bools:
    """Return which of `codes` (codes, fields) satisfy every `require` of `rules`, as bool (codes,).

    Conditions are evaluated in order, each for the codes that satisfy the previous ones. Raises
    NoValue if a condition has no value, TooMuch beyond the work limit."""
    _limit_work(rules.requires, rules, len(codes), slots=1)
    satisfied = np.ones(len(codes), dtype=bool)
    for condition in rules.requires:
        rows = np.flatnonzero(satisfied)
        for block in _blocks(len(rows), width=1):
            block_rows = rows[block]
            bindings = _bindings(rules, codes[block_rows])
            values, gap = values_of(condition, bindings, rules.books, (len(block_rows), 1))
            if gap is not None:
                first_case = f"for {code_text(rules, codes[block_rows[gap.first_index[0]]])}"
                raise NoValue([MissingValue(gap.fault, first_case, gap.number)])
            satisfied[block_rows] = values[:, 0]
    return satisfied


def legal_codes(rules: Rules) -> CodeArray:
    """Return every code that fields and `require` allow, int64 (codes, fields), sorted by field
    values.

    Raises TooMuch if limits on combinations or codes are exceeded; NoValue if a condition has no
    value. Without fields there is one code, shape (1, 0); if `require` excludes all, shape (0,
    fields)."""
    sizes = [field.high - field.low + 1 for field in rules.fields]
    total = rules.combinations
    if not rules.requires:
        _limit_codes(rules, total)
    elif total > COMBINATION_LIMIT:
        limit_text = f"at most {COMBINATION_LIMIT} combinations are tested against `require`"
        message = f"the fields have {printable(total)} combinations, and {limit_text}"
        raise TooMuch(message, min(total, UNCOUNTED), COMBINATION_LIMIT)
    _limit_work(rules.requires, rules, total, slots=1)
    kept_codes: list[CodeArray] = []
    count = 0
    for block in _blocks(total, width=1):
        number = np.arange(block.start, block.stop, dtype=np.int64)
        codes = np.empty((len(number), len(sizes)), dtype=np.int64)
        for k in range(len(sizes) - 1, -1, -1):
            # The number of a combination, written in digits: the last field changes fastest.
            number, codes[:, k] = np.divmod(number, sizes[k])
            codes[:, k] += rules.fields[k].low
        block_codes = codes[allowed(rules, codes)] if rules.requires else codes
        count += len(block_codes)
        _limit_codes(rules, count)
        kept_codes.append(block_codes)
    return np.concatenate(kept_codes)


def decode(rules: Rules, codes: CodeArray) -> DecodeTable:
    """Return the decode table of `codes` (codes, fields), which are sorted, distinct and legal.

    Shutters are sorted as rows of bits: first bucket's slot 0 first, closed before open. Raises
    TooMuch beyond the limits, before evaluation; NoValue if rules have no value for some codes and
    slots, with the first place of each such rule."""
    _limit_codes(rules, len(codes))
    _limit_work(rules.rules, rules, len(codes), rules.slots)
    buckets, slots = len(rules.rules), rules.slots
    # The number of bytes is rounded up.
    packed = np.empty((len(codes), -(-buckets * slots // 8)), dtype=np.uint8)
    trouble: dict[int, MissingValue] = {}
    for block in _blocks(len(codes), slots * buckets):
        opens = np.empty((block.stop - block.start, buckets, slots), dtype=bool)
        for k, rule in enumerate(rules.rules):
            opens[:, k, :], finding = _decoded(rules, rule, codes[block])
            if finding is not None:  # the first place of a rule is reported, with the count of all
                first = trouble.setdefault(k, finding)
                first.count += finding.count if first is not finding else 0
        packed[block] = np.packbits(opens.reshape(len(opens), -1), axis=1)
    if trouble:
        raise NoValue([trouble[k] for k in sorted(trouble)])
    distinct, shutter_of_code = distinct_rows(packed)
    shutters = np.unpackbits(distinct, axis=1, count=buckets * slots).view(np.bool_)
    return DecodeTable(
        tuple(field.name for field in rules.fields),
        codes,
        shutter_of_code,
        shutters.reshape(len(distinct), buckets, slots),
    )


def _decoded(rules: Rules, rule: Checked, codes: CodeArray) -> tuple[Bools, MissingValue | None]:
    """Return whether the shutter of each code is open, bool (codes, slots), and the first missing
    value.

    The latter is None if the rule has a value for all codes and slots. `codes` is (codes, fields),
    and `rule` is a boolean expression of `rules`."""
    shape = (len(codes), rules.slots)
    bindings = _bindings(rules, codes)
    bindings["n"] = Value(np.arange(rules.slots, dtype=np.int64).reshape(1, -1))
    opens, gap = values_of(rule, bindings, rules.books, shape)
    if gap is None:
        return opens, None
    code, slot = gap.first_index
    of_code = f"for {code_text(rules, codes[code])}, " if rules.fields else ""
    return opens, MissingValue(gap.fault, f"{of_code}in slot {slot}", gap.number)


def _bindings(rules: Rules, codes: CodeArray) -> dict[str, Value]:
    """Return the values of the fields of `codes` as columns (codes, 1), and the numbers of bits of
    bit fields, under the keys of `bit_count`."""
    bindings: dict[str, Value] = {}
    for k, field in enumerate(rules.fields):
        column = np.ascontiguousarray(codes[:, k]).reshape(-1, 1)
        bindings[field.name] = Value(column)
        if field.bits is not None:
            # The last chunk of a long field has the highest bit.
            bindings[bit_count(whole_name(field.name))] = Value(field.first_bit + field.bits)
    return bindings


def code_text(rules: Rules, code: CodeArray) -> str:
    """Return one code (fields,) for messages, such as `start = 3, stop = 7`. Fields after the sixth
    are replaced by `...`; without fields it is empty."""
    assignments = [f"{f.name} = {v}" for f, v in zip(rules.fields, code.tolist(), strict=True)]
    return ", ".join(assignments[:6]) + (", ..." if len(assignments) > 6 else "")


def _blocks(count: int, width: int) -> Iterator[slice]:
    """Yield slices that divide `count` rows of `width` values into blocks of at most `_BLOCK`
    values, but at least one row. Without rows there is no block."""
    step = max(1, _BLOCK // max(width, 1))
    for start in range(0, count, step):
        yield slice(start, min(start + step, count))


UNCOUNTED = 2**72
"""Larger numbers of codes are printed as a power of two."""


def _limit_codes(rules: Rules, codes: int) -> None:
    """Raise TooMuch if this number of codes is more than nscc can prove, or takes too much
    memory.

    The limits are `PROOF_LIMIT` for codes x buckets x slots and `TABLE_LIMIT` for codes x fields.
    """
    buckets = len(rules.rules)
    needed = codes * buckets * rules.slots
    if needed > PROOF_LIMIT:
        in_buckets = f"{counted(buckets, 'bucket')} x " if buckets != 1 else ""
        if needed < UNCOUNTED:
            of_codes, values = counted(codes, "code"), f"{needed} values"
        else:
            of_codes = f"2^{codes.bit_length() - 1} codes or more"
            values = f"2^{needed.bit_length() - 1} values or more"
        size = f"{of_codes} x {in_buckets}{counted(rules.slots, 'slot')}"
        message = f"{size} are {values} to prove, and the limit is {PROOF_LIMIT}"
        raise TooMuch(message, min(needed, UNCOUNTED), PROOF_LIMIT)
    stored_values = codes * len(rules.fields)
    if stored_values > TABLE_LIMIT:
        size = f"{counted(codes, 'code')} of {counted(len(rules.fields), 'field')}"
        message = f"{size} are {stored_values} values to keep, and the limit is {TABLE_LIMIT}"
        raise TooMuch(message, stored_values, TABLE_LIMIT)


def _limit_work(exprs: Sequence[Checked], rules: Rules, codes: int, slots: int) -> None:
    """Raise TooMuch if evaluating the expressions for all codes and slots takes more than
    `WORK_LIMIT` operations.

    `codes` and `slots` are their numbers; 1 slot means that expressions do not depend on n."""
    sizes = {field.name: (0, codes) for field in rules.fields}
    sizes["n"] = (1, slots)
    needed = sum(work(expr, sizes) for expr in exprs)
    if needed > WORK_LIMIT:
        takes = f"evaluating them takes {needed} operations, but the limit is {WORK_LIMIT}"
        message = f"{takes} ({counted(codes, 'code')}, {counted(slots, 'slot')})"
        raise TooMuch(message, needed, WORK_LIMIT)


def distinct_rows(packed: Bytes) -> tuple[Bytes, Ints32]:
    """Return the distinct rows of packed bits, sorted bit by bit, and the index of every row among
    them.

    `packed` is (rows, bytes), as `numpy.packbits` returns it: the first bit is the highest of byte
    0. The index is int32 (rows,)."""
    # Rows as opaque bytes compare from their first byte on.
    keys = np.ascontiguousarray(packed).view(f"V{packed.shape[1]}")[:, 0]
    _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
    return packed[first], inverse.astype(np.int32)
