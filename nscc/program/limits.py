"""Limits on enumeration, checked before it starts."""

from __future__ import annotations

from collections.abc import Mapping

from nscc.program.expressions import Checked, operands
from nscc.syntax.tree import Index, Name

PROOF_LIMIT = 2**26
"""Most codes x buckets x slots, each of which is evaluated, stored as a byte, and proved.

67 million take less than 100 MB and about a second."""

COMBINATION_LIMIT = 2**22
"""Most combinations of field values to test against `require` if every legal code is compiled."""

TABLE_LIMIT = 2**23
"""Most codes x fields, stored as 8 bytes each: 64 MB."""

WORK_LIMIT = 2**32
"""Most operations to evaluate one expression, which take about ten seconds."""

SURVEY_LIMIT = 2**20
"""Most codes x buckets x slots for determining the class if only used codes are compiled.

The limit keeps `nscc check` fast."""

MOST_SLOTS = 65536
"""Most slots in a frame: 16 times the longest frame in the literature.

A table of 1024 codes with this number of slots is within the proof limit."""

MOST_FIELDS = 64
"""Most fields of a pixel code: more than any target has registers for."""

MOST_BITS = MOST_SLOTS
"""Most bits of a bit field: one for each slot of the longest frame."""


def work(expr: Checked, sizes: Mapping[str, tuple[int, int]]) -> int:
    """Return the number of operations to evaluate `expr` for all values of its variables.

    `sizes` contains the axis (0 or 1) and the length of every variable."""
    axes: list[frozenset[int]] = []
    lengths = dict.fromkeys((0, 1), 1)
    lengths.update(dict(sizes.values()))
    total = 0
    none: frozenset[int] = frozenset()
    for node in expr.nodes:
        count = len(operands(node))
        varies = none.union(*axes[len(axes) - count :]) if count else none
        del axes[len(axes) - count :]
        if isinstance(node, Name) and node.text in sizes:
            varies = frozenset((sizes[node.text][0],))
        elif isinstance(node, Index):
            base = sizes.get(node.base.text, sizes.get("n"))
            varies |= {base[0]} if base else none
        axes.append(varies)
        cost = 1
        for axis in varies:
            cost *= lengths[axis]
        total += cost
    return total
