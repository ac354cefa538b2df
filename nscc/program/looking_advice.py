"""What a target or a readout does not allow of a program that looks, what makes its machine too
large, and what is worth saying."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import prod

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.program.expressions import Checked
from nscc.program.looking import Looking, Next
from nscc.program.names import LOOKS, Declarations
from nscc.program.open_time import Untold
from nscc.program.problems import Problems, counted, printable
from nscc.program.table import CodeArray
from nscc.source import Span
from nscc.syntax import tree
from nscc.words.machine import Machine


def judge_looking(
    declared: Declarations,
    machine: Machine,
    untold: Untold | None,
    target: Target,
    problems: Problems,
) -> None:
    """Reports a readout that does not tell how long pixels were open (NS0324), a reset that the
    target does not have (NS0415), and rules that never open (NS0350).

    `untold` as of `nscc.program.open_time.with_open_times`.
    """
    if untold is not None:
        rule = declared.rules[untold.bucket]
        names = ", ".join(untold.states)
        helps = (f"`read {names}` tells it",) if names else (
            "remember in a state when the shutter closed, `state closed_at : 0..3 = 0`: read that",
        )  # fmt: skip
        problems.error(
            "NS0324", "the readout does not tell how long a pixel was open", rule.span,
            "pixels of one code are open for different times", helps=helps,
            data={"missing": list(untold.states)},
        )  # fmt: skip
    if declared.reset is not None and target.reset_honours_flag != "yes":
        _judge_resets(declared.reset, machine, target, problems)
    for k, rule in enumerate(declared.rules):
        if not machine.opens[:, k].any():
            who = (
                f"the bucket `{rule.name.text}`" if isinstance(rule, tree.Bucket) else "the shutter"
            )
            problems.warning("NS0350", f"{who} never opens", rule.rule.span, "false in every slot")


def judge_looked_names(
    declared: Declarations,
    looking: Looking,
    rules: Sequence[Checked],
    machine: Machine,
    problems: Problems,
) -> None:
    """Notes senses and states that nothing reads, and states that keep their start (NS0355).

    A sense that nothing reads is in use where it alone makes a look, if a `next` steps there or
    `looks` is read. `rules` say when shutters are open.
    """
    read = frozenset[str]().union(*(each.variables for each in [*rules, *looking.expressions]))
    steps = bool(looking.nexts) or LOOKS in read
    used = {n for sense in looking.senses if sense.name in read for n in sense.at}
    for sense in looking.senses:
        if sense.name in read:
            continue
        if steps and not used.issuperset(sense.at):
            used.update(sense.at)
            continue
        place = declared.senses[sense.name].name.span
        problems.note("NS0355", f"nothing reads the sense `{sense.name}`", place, "not used")
    for k, state in enumerate(machine.states):
        if state.sense:
            continue
        name, place = state.name, declared.states[state.name].name.span
        without_its_own = [*rules, *replace(looking, nexts=_others(looking, name)).expressions]
        if name not in declared.nexts:
            problems.note("NS0355", f"`{name}` keeps its start", place, "no `next` changes it")
        elif not state.kept and (machine.values[:, k] == state.start).all():
            text = "its `next` never changes it"
            problems.note("NS0355", f"`{name}` keeps its start", place, text)
        elif not state.read and not any(name in each.variables for each in without_its_own):
            problems.note("NS0355", f"nothing reads the state `{name}`", place, "not used")


def _others(looking: Looking, name: str) -> dict[str, Next]:
    return {other: each for other, each in looking.nexts.items() if other != name}


def _judge_resets(
    statement: tree.Reset, machine: Machine, target: Target, problems: Problems
) -> None:
    """Where the reset is global, all pixels that can be at a boundary must agree on it."""
    for stage in range(machine.stages):
        slots = slice(machine.starts(stage), machine.ends(stage))
        here = machine.resets[machine.nodes(stage), slots]
        differ = (here != here[:1]).any(axis=0)
        if differ.any():
            boundary = slots.start + int(differ.argmax())
            problems.error(
                "NS0415", f"{target.name} resets all pixels at once", statement.condition.span,
                f"at n = {boundary} only some pixels are to be reset",
                notes=("its reset of the photodiode does not honour FLAG",),
                helps=(
                    "reset at boundaries that depend on `n` alone, or use a target whose reset is "
                    "per pixel: `target scamp5-algorithm1`",
                ),
                data={"boundary": boundary},
            )  # fmt: skip
            return


def shutters_in_the_dark(machine: Machine) -> NDArray[np.bool_]:
    """The shutters (behaviours, buckets, N) of pixels whose signals are never above a level."""
    nodes = machine.start_nodes()
    found = machine.opens[nodes].copy()
    for stage in range(1, machine.stages):
        nodes = machine.steps[nodes, 0]
        slots = slice(machine.starts(stage), machine.ends(stage))
        found[:, :, slots] = machine.opens[nodes][:, :, slots]
    return found


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
