"""Encoding by the digits of the code's fields, in which rules and predicates are simple."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain, islice, product

import numpy as np
from numpy.typing import NDArray

from nscc.logic.digits import Planes, radices_of, thermometers
from nscc.logic.problem import GaveUp, Machine, Problem, Solution
from nscc.logic.script_walk import Script, walk
from nscc.truth import columns

# A walk takes milliseconds; counting the planes of a combination takes microseconds.
_MOST_TRIED = 40
_MOST_COMBINED = 5_000


def field_digits(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Store every field in mixed-radix thermometers or one plane a value, in either polarity.
    Layouts with most registers come first, since they need fewest words."""
    room = machine.registers - 1
    fields = {
        name: np.unique(values, return_inverse=True)[1]
        for name, values in problem.values.items()
        if values.min(initial=0) != values.max(initial=0)
    }
    if not fields or len(fields) > 4:
        raise GaveUp("no fields, or too many of them")
    options = [_forms(name, ranks, room) for name, ranks in fields.items()]
    combined = (list(chain(*chosen)) for chosen in islice(product(*options), _MOST_COMBINED))
    fitting = [planes for planes in combined if len(planes) <= room]
    # The more planes, the more comparisons are precomputed before the frame.
    fitting.sort(key=len, reverse=True)
    for planes in fitting[:_MOST_TRIED]:
        yield from walk(problem, machine, Script("digits of the fields", planes), steps)


def _forms(name: str, ranks: NDArray[np.int64], room: int) -> list[Planes]:
    """The layouts of a field with values 0 .. max that take at most `room` planes."""
    count = int(ranks.max()) + 1
    forms: list[Planes] = []
    sizes: set[int] = set()
    # A radix r takes r - 1 planes, so up to four digits fit if their sum is four more than the
    # room.
    for radices in radices_of(room + 4, count):
        size = sum(radices) - len(radices)
        if size > room or size in sizes:
            continue
        sizes.add(size)
        for negative in (False, True):
            planes = thermometers(ranks, radices, negative)
            forms.append([(plane, f"{name}, {digit}") for plane, digit in planes])
    if 2 < count <= room:
        equal = ranks[:, None] == np.arange(count)
        for value_columns, sign in ((equal, "is"), (~equal, "is not")):
            planes = [(p, f"{name} {sign} value {v}") for v, p in enumerate(columns(value_columns))]
            forms.append(planes)
    return forms
