"""Warnings and notes about valid programs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import prod
from typing import TYPE_CHECKING

import numpy as np

from nscc.arrays import Bools
from nscc.chips.target import Target
from nscc.program.classes import Recognised
from nscc.program.evaluate import Books
from nscc.program.expressions import Checked, nodes_in
from nscc.program.names import LOOKS, Declarations, Rule
from nscc.program.problems import Problems, counted, printable
from nscc.program.program import Field
from nscc.program.table import CodeArray
from nscc.record import Record
from nscc.source import Span
from nscc.syntax import tree
from nscc.words.container import DecodeTable

if TYPE_CHECKING:
    from nscc.program.looking import Looking
    from nscc.program.open_time import Untold
    from nscc.words.machine import StateMachine


def judge_looking(
    declared: Declarations,
    machine: StateMachine,
    untold: Untold | None,
    target: Target,
    problems: Problems,
) -> None:
    """Report faults of a program whose pixels look at their light (statements `sense` and `state`).

    Readouts that do not determine open times are NS0324, and resets of some pixels only, on a chip
    that cannot, are NS0415. Rules that never open are NS0350, a warning. `untold` says which bucket
    has an unknown open time; None if the readout determines all. `declared` are the program's
    statements, and `machine` is its state machine."""
    # The state that the message suggests has a value for each look, and one for "not yet".
    if untold is not None:
        rule = declared.rules[untold.bucket]
        names = ", ".join(untold.states)
        state = f"`state changed_at : 0..{len(machine.looks)} = 0`"
        helps = (
            (f"`read {names}` gives the open time",)
            if names
            else (
                f"add a state that stores the look at which the shutter changes, {state}, and "
                "read it",
                "use this state in the rule, so that the shutter changes only once: "
                "`changed_at == 0` or `changed_at > 0`",
            )
        )
        problems.error(
            "NS0324",
            "the readout does not determine how long a pixel was open",
            rule.span,
            "pixels with the same code are open for different times",
            helps=helps,
            data={"missing": list(untold.states)},
        )
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
    machine: StateMachine,
    problems: Problems,
) -> None:
    """Note unused senses and states, and states that never change (NS0355).

    `declared` and `looking` are its statements, as written and checked. An unread sense counts as
    used if it is the only sense at a boundary where a state changes, or that `looks` counts.
    `rules` are the rules of shutters. `machine` has the values that states really reach."""
    read = frozenset[str]().union(
        *(checked.variables for checked in [*rules, *looking.expressions])
    )
    looks_count = bool(looking.nexts) or LOOKS in read
    used_boundaries = {n for sense in looking.senses if sense.name in read for n in sense.at}
    for sense in looking.senses:
        if sense.name in read:
            continue
        if looks_count and not used_boundaries.issuperset(sense.at):
            used_boundaries.update(sense.at)
            continue
        span = declared.senses[sense.name].name.span
        problems.note("NS0355", f"the sense `{sense.name}` is not used", span, "not used")
    for k, state in enumerate(machine.states):
        if state.sense:
            continue
        name, span = state.name, declared.states[state.name].name.span
        nexts = {state: step for state, step in looking.nexts.items() if state != name}
        # A state that only its own `next` reads affects nothing else.
        without_its_own = [*rules, *replace(looking, nexts=nexts).expressions]
        if name not in declared.nexts:
            problems.note(
                "NS0355", f"`{name}` always keeps its start value", span, "no `next` changes it"
            )
        elif not state.is_kept and (machine.values[:, k] == state.start).all():
            text = "its `next` never changes it"
            problems.note("NS0355", f"`{name}` always keeps its start value", span, text)
        elif not state.read and not any(name in checked.variables for checked in without_its_own):
            problems.note("NS0355", f"the state `{name}` is not used", span, "not used")


def _judge_resets(
    statement: tree.Reset, machine: StateMachine, target: Target, problems: Problems
) -> None:
    """Report the first boundary at which only some pixels reset their photodiode by `statement`,
    `reset when` (NS0415).

    `target` is a chip that can only reset all pixels. A pixel is any code with any answers so far.
    """
    for stage in range(machine.stages):
        slots = slice(machine.starts(stage), machine.ends(stage))
        stage_resets = machine.resets[machine.nodes(stage), slots]
        differ = (stage_resets != stage_resets[:1]).any(axis=0)
        if differ.any():
            boundary = slots.start + int(differ.argmax())
            problems.error(
                "NS0415",
                f"{target.name} resets all pixels at once",
                statement.condition.span,
                f"at n = {boundary} the condition selects only some pixels",
                notes=("the reset of the photodiode ignores FLAG",),
                helps=(
                    "use a condition on `n` alone, or a target with a reset per pixel: "
                    "`target scamp5-algorithm1`",
                ),
                data={"boundary": boundary},
            )
            return


def shutters_in_the_dark(machine: StateMachine) -> Bools:
    """Return the shutters of pixels whose light never exceeds a level: bool (behaviours, buckets,
    N).

    `machine` is the program's state machine. A behaviour is a set of codes whose pixels act alike
    for all answers. Row k belongs to behaviour k."""
    nodes = machine.start_nodes()
    shutters = machine.opens[nodes].copy()
    for stage in range(1, machine.stages):
        # Outcome 0: every comparison answers no.
        nodes = machine.steps[nodes, 0]
        slots = slice(machine.starts(stage), machine.ends(stage))
        shutters[:, :, slots] = machine.opens[nodes][:, :, slots]
    return shutters


class Excess(Record):
    """The factor that makes a state machine too large.

    `place` is its statement (None for the fields of the code), `text` the label there, `helps` how
    to make it smaller."""

    place: Span | None
    text: str
    helps: list[str]


def largest_part(
    declared: Declarations, looking: Looking, fields: Sequence[str], codes: CodeArray
) -> Excess:
    """Return what contributes most to the size of a state machine: codes, states, or levels at one
    boundary.

    Codes are returned if they are more than the states and than the combinations of answers. States
    are returned if they are more than the answers; else the sense with most levels. `codes` (codes,
    fields) are the compiled codes, with the names `fields`. The helps do not include how to have
    fewer codes."""
    values = {name: len(np.unique(codes[:, k])) for k, name in enumerate(fields)}
    boundary, levels_of_sense = _busiest(looking, values)
    levels = sum(levels_of_sense.values())
    states = _state_combinations(looking, levels * len(looking.looks))
    helps = _helps(looking, most_senses=len(levels_of_sense), states=states)
    if len(codes) > max(states, 1 << levels):
        return Excess(place=None, text=f"{counted(len(codes), 'code')} in all", helps=helps)
    if states > 1 << levels:
        widest = max(looking.states, key=lambda state: state.high - state.low)
        span = declared.states[widest.name].name.span
        return Excess(span, f"states can hold {printable(states)} different values", helps)
    most = max(levels_of_sense, key=lambda name: levels_of_sense[name])
    text = f"{counted(levels, 'level')} to compare at n = {boundary}: 2^{levels} answers"
    return Excess(declared.senses[most].name.span, text, helps)


def most_looks(declared: Declarations, looking: Looking) -> Excess:
    """Return the sense that looks at the most boundaries, as the reason why open times are too
    many.

    There is at least one sense; the first of equals is returned. Each look can close a shutter, and
    so adds possible open times."""
    sense = max(looking.senses, key=lambda candidate: len(candidate.at))
    text = f"looks at {counted(len(sense.at), 'boundary', 'boundaries')}"
    helps = ["use fewer looks, or a state that keeps a shutter closed"]
    return Excess(declared.senses[sense.name].at.span, text, helps)


def _helps(looking: Looking, most_senses: int, states: int) -> list[str]:
    """Return how to reduce the size of a state machine, as helps of an error; none if nothing can
    be reduced.

    `looking` has the checked senses and states. `most_senses` is the number of senses at the
    busiest boundary, `states` the number of combined values of states."""
    helps = []
    if most_senses > 1:
        helps.append("use fewer senses at one boundary: each sense doubles the number of answers")
    by_field = dict.fromkeys(
        f"`{sense.field}`" for sense in looking.senses if sense.field is not None
    )
    if by_field:
        helps.append(
            f"use fewer values of {', '.join(by_field)}: each value is one more level to compare"
        )
    if states > 1:
        helps.append("reduce the ranges of the states, or use fewer states")
    if len(looking.looks) > 1:
        helps.append(f"use fewer looks: there are {len(looking.looks)}")
    return helps


def _state_combinations(looking: Looking, answers: int) -> int:
    """Return an upper bound on the number of combined values of states.

    `looking` has the states, with their ranges. Kept states start with any value. Other states
    start with one, so each of 2^`answers` histories of answers leads to one combined value, but at
    most to all in their ranges."""
    kept_values, reached = (
        prod(state.high - state.low + 1 for state in looking.states if state.is_kept == is_kept)
        for is_kept in (True, False)
    )
    return kept_values * min(reached, 1 << answers)


def _busiest(looking: Looking, values: Mapping[str, int]) -> tuple[int, dict[str, int]]:
    """Return the boundary with most comparisons (the first of equals), and its senses with their
    numbers of levels.

    `values` is the number of values in use of each field, because a field can give the level.
    Without senses, the result is 0 and no senses."""
    levels = {s.name: 1 if s.field is None else values[s.field] for s in looking.senses}
    level_counts = Counter[int]()
    for sense in looking.senses:
        level_counts.update(dict.fromkeys(sense.at, levels[sense.name]))
    # Of equal counts, the smallest boundary.
    busiest = max(level_counts, key=lambda n: (level_counts[n], -n), default=0)
    return busiest, {s.name: levels[s.name] for s in looking.senses if busiest in s.at}


def judge_rules(
    rules: Sequence[Rule],
    has_fields: bool,
    table: DecodeTable,
    survey: DecodeTable,
    basis: str,
    problems: Problems,
) -> None:
    """Warn about rules that never open (NS0350) and, if the code has fields (`has_fields`), always
    open (NS0351).

    Rules and tables have the buckets in the same order. Rules that never open are found among the
    compiled codes (`table`, described by `basis`), because the frame would stay dark. Rules that
    always open are found among the codes in `survey` (all codes if there are few), because the used
    codes may need long exposures. A bucket that is always open beside coded buckets is an ordinary
    exposure of the same scene, and is not reported."""
    for k, rule in enumerate(rules):
        shutters = table.shutters[:, k, :]
        who = f"the bucket `{rule.name.text}`" if isinstance(rule, tree.Bucket) else "the shutter"
        if not shutters.any():
            text = f"false in every slot, {basis}" if has_fields else "false in every slot"
            problems.warning("NS0350", f"{who} never opens", rule.rule.span, text)
        elif has_fields and survey.shutters.all():
            message = f"{who} is always open, whatever the code"
            camera = ("for an ordinary camera write `open when true` without fields",)
            helps = () if isinstance(rule, tree.Bucket) else camera
            problems.warning("NS0351", message, rule.rule.span, "true in every slot", helps=helps)


def judge_names(
    declared: Declarations,
    fields: Sequence[Field],
    rules: Sequence[Checked],
    books: Books,
    problems: Problems,
) -> None:
    """Warn about fields that no rule reads (NS0352); note unused `let` constants and codebooks
    (NS0355).

    `fields` are in chunks: a long bit field has several. `books` are the codebooks by name. `rules`
    are all expressions on which shutters depend. A field may also give the level of a sense."""
    in_rules = frozenset[str]().union(*(rule.variables for rule in rules))
    in_rules |= {s.level.text for s in declared.senses.values() if isinstance(s.level, tree.Name)}
    for field in fields:
        # A long bit field has several chunks; only the first has its name.
        if not field.first_bit and field.name not in in_rules:
            span = declared.codes[field.name].name.span
            why = "all its values give the same shutter"
            problems.warning("NS0352", f"no rule depends on the field `{field.name}`", span, why)
    mentions = Counter(
        node.text
        for statement in declared.statements
        for node in nodes_in(statement)
        if isinstance(node, tree.Name)
    )
    for name, let in declared.lets.items():
        # The only mention is the declaration.
        if mentions[name] == 1:
            problems.note("NS0355", f"`{name}` is not used", let.name.span, "not used")
    in_rules_or_fields = {book for rule in rules for book in rule.books}
    in_rules_or_fields |= {field.book for field in fields if field.book is not None}
    for name in books:
        if name not in in_rules_or_fields:
            span = declared.books[name].name.span
            problems.note("NS0355", f"the codebook `{name}` is not used", span, "not used")


def judge_bumps(shape: Recognised, rule: Rule, table: DecodeTable, problems: Problems) -> None:
    """Warn about bumps (intervals of open slots) of fixed length that the end of the frame cuts
    short (NS0354).

    The warning is placed at `rule`. `shape` is the recognised class of the shutters in `table`."""
    if shape.name == "c" and shape.cut:
        problems.warning(
            "NS0354",
            f"{counted(shape.cut, 'shutter has', 'shutters have')} a bump that the end of "
            "the frame cuts short",
            rule.rule.span,
            f"a frame has the slots 0..{table.shutters.shape[2] - 1}",
            notes=(shape.reason,),
            helps=(
                "end the starts at N - len, where len is the length of the bump: "
                "`code start : 0..N - len`",
            ),
        )
