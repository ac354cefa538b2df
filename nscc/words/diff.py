"""The differences between two containers, as lines of text."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from difflib import unified_diff
from itertools import takewhile, zip_longest
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.chips.load import target_dict
from nscc.words.assembly_text import name_text, number_text, ranges_text
from nscc.words.container import Container, StoredKernel
from nscc.words.cost import FrameCost, frame_cost
from nscc.words.disassembly import instruction_lines
from nscc.words.file import to_bytes

_LONGEST_LISTING = 4096
_MOST_LINES = 200


def differences(first: Container, second: Container) -> list[str]:
    """Return the changes from `first` to `second`; empty if the files are equal."""
    if to_bytes(first) == to_bytes(second):
        return []
    lines: list[str] = []
    for title, changes in (
        ("target", _target(first, second)),
        ("costs", _costs(frame_cost(first), frame_cost(second))),
        ("slots", _slots(first, second)),
        ("kernels", _kernels(first, second)),
        ("schedule", _schedule(first, second)),
        ("codes", _codes(first, second)),
        ("planes", _planes(first, second)),
        ("readouts", _readouts(first, second)),
        ("notes", _notes(first, second)),
    ):
        body = list(changes)
        if body:
            shown = body[:_MOST_LINES]
            hidden_count = len(body) - len(shown)
            lines += [f"{title}:", *(f"  {line}".rstrip() for line in shown)]
            lines += [f"  .. and {hidden_count} lines more"] if hidden_count else []
    return lines


def _change(subject: str, old: object, new: object) -> str:
    return f"{subject}: {old} -> {new}"


def _target(first: Container, second: Container) -> Iterator[str]:
    old, new = _flat(target_dict(first.target)), _flat(target_dict(second.target))
    for name in {**old, **new}:
        if old.get(name) != new.get(name):
            yield _change(name, old.get(name, "none"), new.get(name, "none"))


def _flat(target: Mapping[str, Any]) -> dict[str, Any]:
    """Return the keys of a target, with their sections."""
    flat: dict[str, Any] = {}
    for name, value in target.items():
        keys = value.items() if isinstance(value, dict) else ()
        flat |= {f"{name}.{key}": item for key, item in keys} or {name: value}
    return flat


def _costs(old: FrameCost, new: FrameCost) -> Iterator[str]:
    for subject, before, after, unit in (
        ("words stored", old.stored_words, new.stored_words, ""),
        ("words a frame", old.words, new.words, ""),
        ("launches a frame", old.launches, new.launches, ""),
        ("time of the words", old.busy_us, new.busy_us, " us"),
        ("time of the busiest instant", old.busiest_us, new.busiest_us, " us"),
        ("frame time", old.frame_us, new.frame_us, " us"),
    ):
        if before != after:
            share = f" ({(after - before) / before:+.1%})" if before else ""
            yield _change(subject, f"{before:.10g}{unit}", f"{after:.10g}{unit}") + share


def _slots(first: Container, second: Container) -> Iterator[str]:
    if first.slots != second.slots:
        yield _change("slots", first.slots, second.slots)
        return
    changed = [i for i in range(first.slots) if first.slot_us[i] != second.slot_us[i]]
    if changed:
        old, new = first.slot_us[changed[0]], second.slot_us[changed[0]]
        change = _change(f"length of slot {changed[0]}", number_text(old), number_text(new))
        yield f"{change} us; lengths differ at {_cut(ranges_text(changed))}"


def _cut(text: str) -> str:
    return text if len(text) <= 100 else text[:96] + " ..."


def _kernels(first: Container, second: Container) -> Iterator[str]:
    old = {kernel.name: kernel for kernel in first.kernels}
    new = {kernel.name: kernel for kernel in second.kernels}
    for name in {**old, **new}:
        before, after = old.get(name), new.get(name)
        if before is None or after is None:
            change = "added" if before is None else "removed"
            count = sum(len(kernel.words) for kernel in (before, after) if kernel)
            yield f"{change} {name}: {count} word{'s' if count != 1 else ''}"
        elif before.words != after.words:
            yield f"changed {name}: {len(before.words)} -> {len(after.words)} words"
        else:
            continue
        yield from _listing_change(before, first, after, second)
    if list(old) != list(new) and sorted(old) == sorted(new):
        yield "the kernels are in another order"


def _listing_change(
    before: StoredKernel | None, first: Container, after: StoredKernel | None, second: Container
) -> Iterator[str]:
    old, new = _listing(before, first), _listing(after, second)
    # Listings of which one is a prefix of the other differ from the end of the shorter one.
    alike = takewhile(lambda pair: pair[0] == pair[1], zip_longest(old, new))
    same = sum(1 for _ in alike)
    yield from _text_change(old, new, 2, f"; they differ from line {same} on")


def _listing(kernel: StoredKernel | None, container: Container) -> list[str]:
    if kernel is None:
        return []
    return [text for _, text, _ in instruction_lines(kernel.words, container.target)]


def _at_instants(container: Container) -> dict[int, tuple[str, ...]]:
    kernels_at: dict[int, tuple[str, ...]] = {}
    for launch in container.launches:
        name = container.kernels[launch.kernel].name
        kernels_at[launch.instant] = (*kernels_at.get(launch.instant, ()), name)
    return kernels_at


def _schedule(first: Container, second: Container) -> Iterator[str]:
    """Yield the boundaries with different launches, grouped by change."""
    old, new = _at_instants(first), _at_instants(second)
    changes: dict[tuple[tuple[str, ...], tuple[str, ...]], list[int]] = {}
    for instant in sorted(old.keys() | new.keys()):
        change = (old.get(instant, ()), new.get(instant, ()))
        if change[0] != change[1]:
            changes.setdefault(change, []).append(instant)
    for (before, after), instants in changes.items():
        subject = f"at {_cut(ranges_text(instants))}"
        yield _change(
            subject, _cut(" ".join(before)) or "nothing", _cut(" ".join(after)) or "nothing"
        )


def _codes(first: Container, second: Container) -> Iterator[str]:
    old, new = first.table, second.table
    for subject, before, after in (
        ("fields", old.fields, new.fields),
        ("buckets", first.buckets, second.buckets),
        ("code registers", first.code_registers, second.code_registers),
    ):
        if before != after:
            yield _change(subject, " ".join(before) or "none", " ".join(after) or "none")
    if len(old.codes) != len(new.codes):
        yield _change("codes", len(old.codes), len(new.codes))
    else:
        yield from _rows("field values in codes", old.codes, new.codes)
    if len(old.shutters) != len(new.shutters):
        yield _change("distinct shutters", len(old.shutters), len(new.shutters))
    else:
        yield from _rows("slots open in shutters", old.shutters, new.shutters)
        yield from _rows("register contents for shutters", first.encoding, second.encoding)
        yield from _rows("shutters for codes", old.shutter_of_code, new.shutter_of_code)
    yield from _pixels(first, second)


def _planes(first: Container, second: Container) -> Iterator[str]:
    """Yield the differences of bit planes, for chips without logic."""
    old, new = first.stream, second.stream
    if old is not None and new is not None:
        yield from _rows("bits of slots", old.planes, new.planes)
        for bit in ("zeros", "ones"):
            yield from _rows(f"where {bit} lead in slots", getattr(old, bit), getattr(new, bit))


def _rows(subject: str, old: NDArray[Any], new: NDArray[Any]) -> Iterator[str]:
    """Yield the rows in which arrays of equal shape differ."""
    if old.shape == new.shape and not np.array_equal(old, new):
        changed = (old != new).any(axis=tuple(range(1, old.ndim)))
        yield f"other {subject} {_cut(ranges_text(np.flatnonzero(changed).tolist()))}"


def _pixels(first: Container, second: Container) -> Iterator[str]:
    old, new = first.pixel_codes, second.pixel_codes
    if (old is None) != (new is None):
        yield "the second has pixel data" if old is None else "the second has no pixel data"
    elif old is not None and new is not None:
        if old.shape != new.shape:
            yield _change("array", f"{old.shape}", f"{new.shape}")
        elif not np.array_equal(old, new):
            yield f"{np.count_nonzero(old != new)} of {old.size} pixels hold another code"


def _readouts(first: Container, second: Container) -> Iterator[str]:
    old = {r.bucket: f"{r.register} x {number_text(r.gain)}" for r in first.readouts}
    new = {r.bucket: f"{r.register} x {number_text(r.gain)}" for r in second.readouts}
    for bucket in {**old, **new}:
        if old.get(bucket) != new.get(bucket):
            yield _change(bucket, old.get(bucket, "none"), new.get(bucket, "none"))
    if list(old) != list(new) and sorted(old) == sorted(new):
        yield "they are in another order"


def _notes(first: Container, second: Container) -> Iterator[str]:
    for key in sorted(first.notes.keys() | second.notes.keys()):
        old, new = first.notes.get(key), second.notes.get(key)
        if old != new:
            yield _change(name_text(key), _quoted(old), _quoted(new))
    if first.source_lines != second.source_lines:
        yield "the program's source:"
        old_lines, new_lines = ([*map(_visible, c.source_lines)] for c in (first, second))
        yield from _text_change(old_lines, new_lines, 1)


def _visible(line: str) -> str:
    """Replace control characters in a line of text."""
    return line if line.isprintable() else ascii(line)[1:-1]


def _quoted(text: str | None) -> str:
    return "none" if text is None else _cut(ascii(text))


def _text_change(
    old: Sequence[str], new: Sequence[str], around: int, position: str = ""
) -> Iterator[str]:
    if max(len(old), len(new)) > _LONGEST_LISTING:
        yield f"  too long to compare line by line{position}"
        return
    for line in list(unified_diff(old, new, lineterm="", n=around))[2:]:
        yield f"  {line}"
