"""Kept states of version 3: they step once a frame, after all images and planes."""

from __future__ import annotations

from collections.abc import Mapping

from nscc.program.constants import constant
from nscc.program.expressions import Meaning
from nscc.program.names import Declarations, State
from nscc.program.picture_expressions import Reader
from nscc.program.problems import Problems
from nscc.syntax import tree
from nscc.words.pictures import Bit, Condition, Inverse, Joined, KeptPlane


def kept_planes(
    declared: Declarations,
    constants: Mapping[str, Meaning],
    reader: Reader,
    problems: Problems,
) -> tuple[KeptPlane, ...]:
    """Return the states of a program with images or planes.

    Report a state that is not a kept bit (NS0543), a start that is not 0 or 1 (NS0311), and a
    `next` of an unknown state (NS0214)."""
    if not declared.keeps_planes:
        return ()
    for name, step in declared.nexts.items():
        if name not in declared.states and name not in declared.refused:
            problems.unknown("a state", name, step.name.span, declared.states)
    states = []
    for name, state in declared.states.items():
        start = _start(name, state, constants, problems)
        following = _next(name, declared.nexts.get(name), reader)
        if start is not None and following is not None:
            states.append(KeptPlane(name, bool(start), following))
    return tuple(states)


def _start(
    name: str, state: State, constants: Mapping[str, Meaning], problems: Problems
) -> int | None:
    if isinstance(state, tree.StateRange) or not state.kept:
        problems.error(
            "NS0543", f"`{name}` is not a kept bit, but the program has images or planes",
            state.span, "this state",
            notes=("images and planes are computed after the last slot, so the new value of the "
                   "state is used in the next frame",),
            helps=(f"write `state {name} : bit = 0 kept`",),
        )  # fmt: skip
        return None
    if isinstance(state.start, tree.Bool):
        return int(state.start.value)
    start = constant(state.start, constants, problems, "the start of a state")
    if start is not None and start not in (0, 1):
        message = f"`{name}` starts with {start}, outside 0..1"
        problems.error("NS0311", message, state.start.span, "its value in the first frame")
        return None
    return start


def _next(name: str, step: tree.Next | None, reader: Reader) -> Condition | None:
    """Return the state after a frame: unchanged without `next`, or where its condition is 0."""
    if step is None:
        return Bit(name)
    value = reader.condition(step.value)
    if step.condition is None or value is None:
        return value
    when = reader.condition(step.condition)
    if when is None:
        return None
    changed, unchanged = Joined("and", when, value), Joined("and", Inverse(when), Bit(name))
    return Joined("or", changed, unchanged)
