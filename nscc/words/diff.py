"""The differences between two containers, as lines of text: costs, then their assembly texts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from difflib import unified_diff

import numpy as np

from nscc.words.assembly_text import ranges_text
from nscc.words.container import Container
from nscc.words.cost import FrameCost, frame_cost
from nscc.words.disassembly import sections
from nscc.words.file import to_bytes

_LONGEST_SECTION = 4096
"""Most lines of a part that are compared one by one."""
_MOST_LINES = 200
"""Most lines shown for each part."""
_OF_DATA = (".machine", ".pictures", ".pixels plane")
"""Directives with lines of base64."""


def differences(first: Container, second: Container) -> list[str]:
    """Return the changes from one compiled program to another as lines of text, by part of their
    assembly texts.

    A part has a line with its title, then indented lines; its first lines are the costs. The result
    is empty if the files are equal. At most `_MOST_LINES` lines of a part are shown."""
    if to_bytes(first) == to_bytes(second):
        return []
    changes = {"costs": _costs(frame_cost(first), frame_cost(second))}
    old, new = sections(first), sections(second)
    for section in (old["target"], new["target"]):
        del section[:2]  # the costs again, as comments
    for title in {**old, **new}:
        changes[title] = _text_change(old.get(title, []), new.get(title, []))
    changes["planes"] = _planes(first, second)
    lines: list[str] = []
    for title, change in changes.items():
        body = list(change)
        if body:
            lines += [f"{title}:", *(f"  {line}".rstrip() for line in body[:_MOST_LINES])]
            if len(body) > _MOST_LINES:
                lines.append(f"  .. and {len(body) - _MOST_LINES} lines more")
    return lines


def _costs(old: FrameCost, new: FrameCost) -> Iterator[str]:
    """Yield a line for each cost that differs, such as words or microseconds, with the change in
    percent, unless the old cost is 0."""
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
            yield f"{subject}: {before:.10g}{unit} -> {after:.10g}{unit}{share}"


def _text_change(old: Sequence[str], new: Sequence[str]) -> Iterator[str]:
    """Yield the lines that differ between two versions of a part of an assembly text, as a unified
    diff without context.

    Of data in base64, and of parts with more than `_LONGEST_SECTION` lines, only the fact that they
    differ is told. Yield nothing for equal parts."""
    if old == new:
        return
    if max(len(old), len(new)) > _LONGEST_SECTION:
        yield f"{len({*old} ^ {*new})} lines differ, too many to compare one by one"
        return
    (old_text, old_data), (new_text, new_data) = _split(old), _split(new)
    # The first two lines would name the files.
    changed = list(unified_diff(old_text, new_text, lineterm="", n=0))[2:]
    yield from (line if line.isprintable() else ascii(line)[1:-1] for line in changed)
    if old_data != new_data:
        yield "the data in base64 differ"


def _split(section: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the lines of a part that are text, and those that are base64 data: lines after a bar
    below a directive of `_OF_DATA`."""
    lines: tuple[list[str], list[str]] = [], []
    directive = ""
    for line in section:
        directive = line if line.startswith(".") else directive
        is_data = line.startswith("|") and directive.startswith(_OF_DATA)
        lines[is_data].append(line.strip())
    return lines


def _planes(first: Container, second: Container) -> Iterator[str]:
    """Yield a line for what differs in the bit planes of two programs for chips without logic.

    These are bits and the destinations of light, with their slots. Yield nothing if a program has
    no bit planes, and nothing for arrays of different shapes."""
    old, new = first.stream, second.stream
    if old is None or new is None:
        return
    for subject, name in (
        ("bits of slots", "planes"),
        ("where zeros lead in slots", "zeros"),
        ("where ones lead in slots", "ones"),
    ):
        before, after = getattr(old, name), getattr(new, name)
        if before.shape == after.shape and not np.array_equal(before, after):
            changed = (before != after).any(axis=tuple(range(1, before.ndim)))
            yield f"other {subject} {ranges_text(np.flatnonzero(changed).tolist())}"
