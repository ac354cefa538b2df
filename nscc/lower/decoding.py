"""The problem that gates must solve for an exposure plan, and its solution. An exposure plan says
which analog words run at which boundary."""

from __future__ import annotations

from typing import Literal

import numpy as np

from nscc.arrays import Indices, Ints
from nscc.chips.target import Target
from nscc.logic.problem import AllCodes, Demand, Problem, Solution
from nscc.lower.exposure_plan import ExposurePlan, Opens, Timeline
from nscc.operations import WordEffect
from nscc.program.program import Program, whole_name
from nscc.record import Record
from nscc.words.container import DecodeTable

Before = Literal["nothing", "all", "keep", "load"]
"""How a step obtains FLAG before its words.

"nothing": FLAG does not matter; "all": set it in every pixel; "load": load the step's predicate;
"keep": FLAG still holds the last loaded predicate, or 1 everywhere if the step is for every pixel.
"""


class Decoding(Record):
    """An exposure plan (which analog words run at which boundary) with the gates that compute its
    predicates (sets of shutters).

    `problem` has a demand for each step of the plan that has a predicate, `solution` the gates;
    `actions` say how each step obtains FLAG, one for each step. A demand is a set of shutters that
    FLAG must select at a boundary."""

    plan: ExposurePlan
    problem: Problem
    actions: tuple[Before, ...]
    solution: Solution


def problem_of(
    program: Program, plan: ExposurePlan, time: Timeline, opens: Opens
) -> tuple[Problem, tuple[Before, ...]]:
    """Return the demands that gates must meet for an exposure plan, and how each step of the plan
    obtains FLAG.

    A demand says that FLAG must equal a predicate (a set of shutters) at a boundary; there is one
    for each step with a predicate, in order. `plan` and `time` belong to `program`. `opens` are the
    open shutters by bucket and slot, as truth vectors (integers with one bit for each shutter). The
    actions are one for each step, with or without a predicate. An exposure plan says which analog
    words run at which boundary."""
    actions = flag_actions(plan, time, program.target)
    demands: list[Demand] = []
    for step, action in zip(plan.steps, actions, strict=True):
        if step.predicate is not None:
            flag_kept = action == "keep" and bool(demands)
            last = demands[-1].boundary if demands else 0
            scratch_kept = not any(last < n <= step.boundary for n in time.refresh_at or ())
            demands.append(
                Demand(
                    step.boundary,
                    edge=step.role,
                    bucket=step.bucket,
                    predicate=step.predicate,
                    flag_kept=flag_kept,
                    scratch_kept=scratch_kept,
                )
            )
    flag_lasts = not time.refresh_at and time.boundary_us[-1] <= time.keep_us
    # Free bits are separate fields.
    table = program.table
    columns: dict[str, Ints] = {}
    for field, column in zip(program.fields, table.codes.T[: len(program.fields)], strict=True):
        if field.bits is None:
            columns[field.name] = column
        else:
            name, first = whole_name(field.name), field.first_bit
            for k in range(field.bits):
                columns[f"{name}[{first + k}]"] = column >> k & 1
    chosen = _code_of_shutter(table)
    values = {name: column[chosen] for name, column in columns.items()}
    several = len(table.codes) > len(table.shutters)
    codes = AllCodes(columns, table.shutter_of_code, chosen) if several else None
    return Problem(tuple(demands), plan.shutters, opens, flag_lasts, values, codes), tuple(actions)


def _code_of_shutter(table: DecodeTable) -> Indices:
    """Return the number of a row of `table.codes` for each shutter, (shutters,).

    Of several codes, one whose values other shutters also need is chosen, because fields with fewer
    values need fewer bits; else, and of several such codes, the first."""
    if len(table.codes) == len(table.shutters):
        return np.argsort(table.shutter_of_code)
    code_counts = np.bincount(table.shutter_of_code, minlength=len(table.shutters))
    only_codes = table.codes[code_counts[table.shutter_of_code] == 1]
    needed = np.ones(len(table.codes), dtype=np.bool_)
    for column, values_of_only in zip(table.codes.T, only_codes.T, strict=True):
        needed &= np.isin(column, values_of_only)
    # `np.unique` returns the first code of each shutter, so needed codes come first.
    order = np.argsort(~needed, kind="stable")
    _, first = np.unique(table.shutter_of_code[order], return_index=True)
    return order[first]


def flag_actions(plan: ExposurePlan, time: Timeline, target: Target) -> list[Before]:
    """Return for each step of an exposure plan whether FLAG is loaded, set in all pixels, kept from
    the step before, or does not matter (`Before`). A step has analog words that run at one
    boundary.

    FLAG (the bit that lets a pixel act) is lost at refreshes, and with time (`time.keep_us`). A
    step for all pixels needs FLAG only if it has words that obey it: bus words and, on some
    targets, resets of PIX (the photodiode)."""
    actions: list[Before] = []
    flag_state: Literal["unknown", "all", "predicate"] = "unknown"
    loaded: int | None = None
    since_us = 0.0
    boundary = 0
    obeying_flag = {WordEffect.BUS}
    if target.reset_honours_flag != "no":
        obeying_flag.add(WordEffect.RESET_PIX)
    for step in plan.steps:
        now_us = time.boundary_us[step.boundary]
        # The refresh at a boundary runs before the steps there.
        crossed = any(boundary < n <= step.boundary for n in time.refresh_at or ())
        if crossed or now_us - since_us > time.keep_us:
            flag_state = "unknown"
        boundary = step.boundary
        if step.predicate is not None:
            actions.append("keep" if flag_state == "predicate" else "load")
            if flag_state != "predicate" or step.predicate != loaded:
                since_us = now_us
            flag_state, loaded = "predicate", step.predicate
        elif not any(word.operation.effect in obeying_flag for word in step.words):
            actions.append("nothing")
        elif flag_state == "all":
            actions.append("keep")
        else:
            actions.append("all")
            flag_state, since_us = "all", now_us
    return actions
