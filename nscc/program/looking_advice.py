"""What a target or a readout does not allow of a program that looks, and what is worth saying."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.program.expressions import Checked
from nscc.program.looking import Looking, Next
from nscc.program.names import LOOKS, Declarations
from nscc.program.open_time import Untold
from nscc.program.problems import Problems
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
