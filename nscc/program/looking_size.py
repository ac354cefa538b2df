"""What makes the machine of a program that looks too large, and what makes it smaller."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import prod

import numpy as np

from nscc.program.looking import Looking
from nscc.program.names import Declarations
from nscc.program.problems import counted, printable
from nscc.program.table import CodeArray
from nscc.source import Span


@dataclass(frozen=True)
class Part:
    """What there is too much of: its place, None for the fields; a label; what would help."""

    place: Span | None
    text: str
    helps: list[str]


def largest_part(
    declared: Declarations, looking: Looking, fields: Sequence[str], codes: CodeArray
) -> Part:
    """What multiplies the transitions most: codes, states, or the levels of one boundary.

    `codes` (codes, fields) are compiled for, in the order of `fields`. How to have fewer codes is
    not among the helps.
    """
    values = {name: len(np.unique(codes[:, k])) for k, name in enumerate(fields)}
    boundary, asked = _busiest(looking, values)
    levels = sum(asked.values())
    states = _held(looking, levels * len(looking.looks))
    helps = _helps(looking, most_senses=len(asked), states=states)
    if len(codes) > max(states, 1 << levels):
        return Part(None, f"{counted(len(codes), 'code')} in all", helps)
    if states > 1 << levels:
        widest = max(looking.states, key=lambda state: state.high - state.low)
        place = declared.states[widest.name].name.span
        return Part(place, f"states can hold {printable(states)} different values", helps)
    most = max(asked, key=lambda name: asked[name])
    text = f"{counted(levels, 'level')} to compare at n = {boundary}: 2^{levels} answers"
    return Part(declared.senses[most].name.span, text, helps)


def most_looks(declared: Declarations, looking: Looking) -> Part:
    """The sense that looks most often: what multiplies the times that pixels can be open."""
    sense = max(looking.senses, key=lambda each: len(each.at))
    text = f"looks at {counted(len(sense.at), 'boundary', 'boundaries')}"
    helps = ["look at fewer boundaries, or let a state keep a shutter closed once it has closed"]
    return Part(declared.senses[sense.name].at.span, text, helps)


def _helps(looking: Looking, most_senses: int, states: int) -> list[str]:
    helps = []
    if most_senses > 1:
        helps.append("use fewer senses at one boundary: each doubles the answers that there are")
    by_field = dict.fromkeys(f"`{each.field}`" for each in looking.senses if each.field is not None)
    if by_field:
        helps.append(f"use fewer values of {', '.join(by_field)}: each is a level to compare")
    if states > 1:
        helps.append("give the states smaller ranges, or use fewer of them")
    if len(looking.looks) > 1:
        helps.append(f"look at fewer boundaries: there are {len(looking.looks)}")
    return helps


def _held(looking: Looking, answers: int) -> int:
    """The most values that states hold together: kept ones begin a frame with any of theirs, the
    others reach one for each of 2^`answers` histories, and no more than they have."""
    kept, reached = (
        prod(state.high - state.low + 1 for state in looking.states if state.kept == which)
        for which in (True, False)
    )
    return kept * min(reached, 1 << answers)


def _busiest(looking: Looking, values: Mapping[str, int]) -> tuple[int, dict[str, int]]:
    """The boundary where most levels are compared, and how many are by its senses."""
    levels = {s.name: 1 if s.field is None else values[s.field] for s in looking.senses}
    asked = Counter[int]()
    for sense in looking.senses:
        asked.update(dict.fromkeys(sense.at, levels[sense.name]))
    busiest = max(asked, key=lambda n: (asked[n], -n), default=0)
    return busiest, {s.name: levels[s.name] for s in looking.senses if busiest in s.at}
