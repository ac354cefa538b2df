"""The decode table: the rules evaluated for every code and slot, shutters made distinct."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import prod

import numpy as np
from numpy.typing import NDArray

from nscc.program.arithmetic import Fault, Value, array, scalar
from nscc.program.evaluate import Books, bit_count, evaluate, fault_at
from nscc.program.expressions import Checked
from nscc.program.limits import (
    COMBINATION_LIMIT,
    PROOF_LIMIT,
    TABLE_LIMIT,
    WORK_LIMIT,
    total_work,
)
from nscc.program.problems import counted, printable
from nscc.program.program import Field
from nscc.program.wide import whole_name
from nscc.words.container import DecodeTable

CodeArray = NDArray[np.int64]

_BLOCK = 2**18
"""Codes x slots evaluated at once: 2 MB of integers, which stay in the cache."""


class TooMuch(Exception):
    """More codes, slots or operations than a stated limit: the numbers in words."""

    def __init__(self, message: str, required: int, available: int) -> None:
        super().__init__(message)
        self.message = message
        self.required = required
        self.available = available


@dataclass(eq=False, repr=False)
class Finding:
    """One expression without a value: why, for which code and slot first, and for how many."""

    fault: Fault
    where: str
    count: int

    @property
    def text(self) -> str:
        """Where it happens, in words."""
        if self.count == 1:
            return self.where
        return f"first {self.where}; {self.count} times in all"


class NoValue(Exception):
    """Expressions that have no value for some code: one finding for each."""

    def __init__(self, findings: Sequence[Finding]) -> None:
        super().__init__("; ".join(f.fault.message for f in findings))
        self.findings = tuple(findings)


@dataclass(eq=False, repr=False)
class Rules:
    """What decides which codes exist and what they mean, all names and types right.

    `rules` has one boolean expression for each bucket; `slots` is N.
    """

    fields: tuple[Field, ...]
    requires: Sequence[Checked]
    rules: Sequence[Checked]
    books: Books
    slots: int

    @property
    def combinations(self) -> int:
        """How many combinations the fields' ranges name, whether `require` allows them or not."""
        return prod(field.high - field.low + 1 for field in self.fields)


def allowed(rules: Rules, codes: CodeArray) -> NDArray[np.bool_]:
    """Which of `codes` (codes, fields) satisfy every `require`.

    The conditions are tried in the order written, each on the codes that the ones before allow.
    Raises NoValue where one has no value, TooMuch beyond the work limit.
    """
    _limit_work(rules.requires, rules, len(codes), 1)
    left = np.ones(len(codes), dtype=bool)
    for condition in rules.requires:
        rows = np.flatnonzero(left)
        for block in _blocks(len(rows), 1):
            part = rows[block]
            bindings = _bindings(rules, codes[part])
            found = evaluate(condition, bindings, rules.books)
            if found.faults is not None:
                places = _everywhere(found, (len(part), 1))
                code = int(places.argmax())
                fault = fault_at(condition, bindings, rules.books, (len(part), 1), (code, 0))
                where = f"for {code_text(rules, codes[part[code]])}"
                raise NoValue([Finding(fault, where, int(places.sum()))])
            left[part] = np.broadcast_to(found.data, (len(part), 1))[:, 0]
    return left


def legal_codes(rules: Rules) -> CodeArray:
    """Every code that fields and `require` allow, sorted by field values.

    Raises TooMuch before it enumerates more combinations, or keeps more codes, than the limits
    say; NoValue where a condition has no value for some combination.
    """
    sizes = [field.high - field.low + 1 for field in rules.fields]
    total = rules.combinations
    if not rules.requires:
        _limit_codes(rules, total)
    elif total > COMBINATION_LIMIT:
        tried = f"at most {COMBINATION_LIMIT} combinations are tested against `require`"
        message = f"the fields have {printable(total)} combinations, and {tried}"
        raise TooMuch(message, min(total, UNCOUNTED), COMBINATION_LIMIT)
    _limit_work(rules.requires, rules, total, 1)
    kept: list[CodeArray] = []
    count = 0
    for block in _blocks(total, 1):
        rest = np.arange(block.start, block.stop, dtype=np.int64)
        codes = np.empty((len(rest), len(sizes)), dtype=np.int64)
        for k in range(len(sizes) - 1, -1, -1):
            rest, codes[:, k] = np.divmod(rest, sizes[k])
            codes[:, k] += rules.fields[k].low
        part = codes[allowed(rules, codes)] if rules.requires else codes
        count += len(part)
        _limit_codes(rules, count)
        kept.append(part)
    return np.concatenate(kept)


def decode(rules: Rules, codes: CodeArray) -> DecodeTable:
    """The decode table of `codes` (codes, fields), which are sorted, distinct and legal.

    The shutters are sorted as rows of bits: the first bucket's slot 0 counts most, closed before
    open. Raises TooMuch beyond the limits before evaluating, NoValue where a rule has no value.
    """
    _limit_codes(rules, len(codes))
    _limit_work(rules.rules, rules, len(codes), rules.slots)
    buckets, slots = len(rules.rules), rules.slots
    packed = np.empty((len(codes), -(-buckets * slots // 8)), dtype=np.uint8)
    trouble: dict[int, Finding] = {}
    for block in _blocks(len(codes), slots * buckets):
        opens = np.empty((block.stop - block.start, buckets, slots), dtype=bool)
        for k, rule in enumerate(rules.rules):
            opens[:, k, :], finding = _decoded(rules, rule, codes[block])
            if finding is not None:
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


def _decoded(
    rules: Rules, rule: Checked, codes: CodeArray
) -> tuple[NDArray[np.bool_], Finding | None]:
    """Open or closed (codes, slots), and what has no value."""
    shape = (len(codes), rules.slots)
    bindings = _bindings(rules, codes)
    bindings["n"] = array(np.arange(rules.slots, dtype=np.int64).reshape(1, -1))
    found = evaluate(rule, bindings, rules.books)
    opens = np.broadcast_to(np.asarray(found.data, dtype=bool), shape)
    if found.faults is None:
        return opens, None
    places = _everywhere(found, shape)
    code, slot = (int(k) for k in np.unravel_index(int(places.argmax()), shape))
    fault = fault_at(rule, bindings, rules.books, shape, (code, slot))
    count = int(places.sum())
    if not rules.fields:
        return opens, Finding(fault, f"in slot {slot}", count)
    where = f"for {code_text(rules, codes[code])}, in slot {slot}"
    return opens, Finding(fault, where, count)


def _bindings(rules: Rules, codes: CodeArray) -> dict[str, Value]:
    """The fields of `codes` as columns (codes, 1)."""
    bindings: dict[str, Value] = {}
    for k, field in enumerate(rules.fields):
        column = np.ascontiguousarray(codes[:, k]).reshape(-1, 1)
        bindings[field.name] = Value(column, field.low, field.high)
        if field.bits is not None:
            # Of a long field's parts the last one has the highest bit.
            bindings[bit_count(whole_name(field.name))] = scalar(field.first_bit + field.bits)
    return bindings


def _everywhere(found: Value, shape: tuple[int, int]) -> NDArray[np.bool_]:
    if isinstance(found.faults, np.ndarray):
        return np.broadcast_to(found.faults, shape)
    return np.ones(shape, dtype=bool)


def code_text(rules: Rules, code: CodeArray) -> str:
    """One code (fields,) for messages: `start = 3, stop = 7`."""
    parts = [f"{f.name} = {v}" for f, v in zip(rules.fields, code.tolist(), strict=True)]
    return ", ".join(parts[:6]) + (", ..." if len(parts) > 6 else "")


def _blocks(count: int, width: int) -> Iterator[slice]:
    """Consecutive slices of `count` rows, each of `width` values or less than _BLOCK of them."""
    step = max(1, _BLOCK // max(width, 1))
    for start in range(0, count, step):
        yield slice(start, min(start + step, count))


UNCOUNTED = 2**72
"""More codes than this are told by a power of two: nobody reads so many digits."""


def _limit_codes(rules: Rules, codes: int) -> None:
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
    kept = codes * len(rules.fields)
    if kept > TABLE_LIMIT:
        size = f"{counted(codes, 'code')} of {counted(len(rules.fields), 'field')}"
        message = f"{size} are {kept} values to keep, and the limit is {TABLE_LIMIT}"
        raise TooMuch(message, kept, TABLE_LIMIT)


def _limit_work(exprs: Sequence[Checked], rules: Rules, codes: int, slots: int) -> None:
    sizes = {field.name: (0, codes) for field in rules.fields}
    sizes["n"] = (1, slots)
    needed = total_work(exprs, sizes)
    if needed > WORK_LIMIT:
        takes = f"evaluating them takes {needed} operations, but the limit is {WORK_LIMIT}"
        message = f"{takes} ({counted(codes, 'code')}, {counted(slots, 'slot')})"
        raise TooMuch(message, needed, WORK_LIMIT)


def distinct_rows(packed: NDArray[np.uint8]) -> tuple[NDArray[np.uint8], NDArray[np.int32]]:
    """The distinct rows in the order of their bits, and which of them every row is."""
    width = packed.shape[1]
    if width <= 8:
        wide = np.zeros((len(packed), 8), dtype=np.uint8)
        wide[:, :width] = packed
        keys = wide.view(">u8")[:, 0].astype(np.uint64)
        distinct, inverse = np.unique(keys, return_inverse=True)
        rows = distinct.astype(">u8").view(np.uint8).reshape(-1, 8)[:, :width]
        return np.ascontiguousarray(rows), inverse.astype(np.int32)
    # Rows as opaque bytes compare from their first byte on.
    keys = np.ascontiguousarray(packed).view(f"V{width}")[:, 0]
    order = np.argsort(keys, kind="stable")
    ranked = packed[order]
    new = np.ones(len(packed), dtype=bool)
    new[1:] = (ranked[1:] != ranked[:-1]).any(axis=1)
    ranks = np.empty(len(packed), dtype=np.int32)
    ranks[order] = np.cumsum(new, dtype=np.int32) - 1
    return ranked[new], ranks
