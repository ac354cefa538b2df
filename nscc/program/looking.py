"""Checked statements of language version 2: senses, states, resets and readouts."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from nscc.chips.target import Target
from nscc.program.constants import at_scope, constant, constants_scope, next_scope
from nscc.program.evaluate import Fault, Value, evaluate
from nscc.program.expressions import Checked, Meaning, check
from nscc.program.names import Declarations, State
from nscc.program.problems import Problems
from nscc.program.values import judge_values
from nscc.record import Record
from nscc.source import Span
from nscc.syntax import tree
from nscc.words import machine


class CheckedSense(Record, eq=False):
    """A comparison of the pixel's light with a level, at the boundaries `at`. `span` is the place
    of the statement.

    `signal` is -1 for the light since the reset (`machine.LIGHT`), or the index of a bucket whose
    exposure is compared. The answer is whether the signal is above its level, or below if not
    `above`. `steps` is the level in steps of IN (the level sent to all pixels) for each boundary of
    `at`; None if the `field` of the code gives the level as a converter code."""

    name: str
    signal: int
    above: bool
    at: tuple[int, ...]
    steps: tuple[int, ...] | None
    field: str | None
    span: Span


class CheckedNext(Record, eq=False):
    """The next value of a state at a boundary with senses, and its condition (None: always). Where
    the condition is false, the state keeps its value."""

    value: Checked
    condition: Checked | None
    span: Span


class Looking(Record, eq=False):
    """The senses, states and resets of a program whose pixels look at their light.

    `nexts` has the changes of states by name; `reset` is the condition of `reset when`, if there is
    one."""

    senses: tuple[CheckedSense, ...]
    states: tuple[machine.State, ...]
    nexts: Mapping[str, CheckedNext]
    reset: Checked | None

    @property
    def looks(self) -> tuple[int, ...]:
        """The boundaries with at least one sense."""
        return tuple(sorted({n for sense in self.senses for n in sense.at}))

    @property
    def expressions(self) -> list[Checked]:
        """All checked expressions of `next` and `reset when`, with the conditions of `next`."""
        expressions = [] if self.reset is None else [self.reset]
        for step in self.nexts.values():
            expressions += [step.value] if step.condition is None else [step.value, step.condition]
        return expressions


def make_looking(
    declared: Declarations,
    constants: Mapping[str, Meaning],
    target: Target | None,
    problems: Problems,
) -> Looking | None:
    """Return the checked senses, states, changes and resets of a program.

    `constants` has the meanings of N, rows, cols and `let` names. Return None for a program without
    such statements, or after reporting errors: names that are not states (NS0209, NS0214), levels
    that the well or IN (the level sent to all pixels) cannot represent (NS0320, NS0321), senses
    without a boundary (NS0322), starts outside their range (NS0311) and signals that cannot be
    compared (NS0323)."""
    if not declared.looking:
        return None
    maker = _Maker(declared, constants, target, problems)
    senses = [maker.sense(sense) for sense in declared.senses.values()]
    states = [
        checked_state(name, state, maker.constants, problems, declared)
        for name, state in declared.states.items()
    ]
    nexts = {name: maker.next(statement) for name, statement in declared.nexts.items()}
    for name in () if declared.pictures else declared.reads.values():
        maker.known_state(name)
    reset = None
    if declared.reset is not None:
        reset = check(
            declared.reset.condition, "boolean", maker.scope, problems, "the condition of a reset"
        )
    if problems.has_errors():
        return None
    return Looking(
        tuple(sense for sense in senses if sense is not None),
        tuple(state for state in states if state is not None),
        {name: step for name, step in nexts.items() if step is not None},
        reset,
    )


class _Maker:
    """Checks the statements of senses, states and their changes one by one, and reports errors.

    `slots` is N, or 0 if it has an error. `target` is None if it could not be loaded. `buckets` has
    the index of each bucket by name."""

    def __init__(
        self,
        declared: Declarations,
        constants: Mapping[str, Meaning],
        target: Target | None,
        problems: Problems,
    ) -> None:
        """Prepare the names that these statements may use."""
        self.declared = declared
        self.constants = constants_scope(declared, constants)
        self.scope = next_scope(declared, constants)
        self.at_scope = at_scope(declared, constants)
        # 0 means that N has an error, which is reported already.
        self.slots = constants["N"].value if constants["N"].kind == "constant" else 0
        self.target = target
        self.problems = problems
        self.buckets = {
            rule.name.text: number
            for number, rule in enumerate(declared.rules)
            if isinstance(rule, tree.Bucket)
        }

    def sense(self, sense: tree.Sense) -> CheckedSense | None:
        """Return a checked sense; None after reporting an error, or if N or the target has one."""
        signal = self._signal(sense.signal)
        if sense.comparison not in ("<", ">"):
            self.problems.error(
                "NS0323",
                "unsupported comparison: use `>` or `<`",
                sense.span,
                f"this is `{sense.comparison}`",
                notes=("a comparator cannot test whether two charges are equal",),
            )
        boundaries = self._boundaries(sense)
        if boundaries is None or signal is None or self.target is None:
            return None
        name, above = sense.name.text, sense.comparison == ">"
        if isinstance(sense.level, tree.Name) and sense.level.text in self.declared.codes:
            return CheckedSense(
                name, signal, above, boundaries, steps=None, field=sense.level.text, span=sense.span
            )
        steps = self._levels(sense, len(boundaries), self.target)
        if steps is None:
            return None
        return CheckedSense(name, signal, above, boundaries, steps, field=None, span=sense.span)

    def _signal(self, signal: tree.Light | tree.Exposure) -> int | None:
        """Return what a sense compares, as `signal` names it: `machine.LIGHT` (the light since the
        reset) or the index of a bucket.

        Return None after reporting an unknown bucket, or `exposure` without a name beside several
        buckets."""
        if isinstance(signal, tree.Light):
            return machine.LIGHT
        if signal.bucket is None:
            if len(self.declared.rules) == 1:
                return 0
            helps = (f"name the bucket: `exposure {next(iter(self.buckets), 'NAME')}`",)
            self.problems.error(
                "NS0323",
                "this program has several buckets",
                signal.span,
                "whose exposure?",
                helps=helps,
            )
            return None
        number = self.buckets.get(signal.bucket.text)
        if number is None:
            self.problems.unknown("a bucket", signal.bucket.text, signal.bucket.span, self.buckets)
        return number

    def _boundaries(self, sense: tree.Sense) -> tuple[int, ...] | None:
        """Return the boundaries, among 1..N, at which a sense looks.

        Return None if N has an error, or after reporting (NS0322) that there are none or that they
        cannot be computed."""
        checked = check(
            sense.at, "boolean", self.at_scope, self.problems, "the boundaries of a sense"
        )
        if checked is None or not self.slots:
            return None
        numbers = np.arange(1, self.slots + 1, dtype=np.int64)
        # All boundaries are evaluated at once; a fault is then one for all, or one for some of
        # them.
        evaluated = evaluate(checked, {"n": Value(numbers)}, {})
        if isinstance(evaluated.faults, Fault):
            evaluated.faults.report(self.problems)
            return None
        if evaluated.faults is not None:
            boundary = int(numbers[np.broadcast_to(evaluated.faults, numbers.shape)][0])
            text = f"for n = {boundary}"
            message = "the boundaries of this sense cannot be computed"
            self.problems.error("NS0322", message, sense.at.span, text)
            return None
        boundaries = numbers[np.broadcast_to(np.asarray(evaluated.data, np.bool_), numbers.shape)]
        if not boundaries.size:
            self.problems.error(
                "NS0322",
                f"the sense `{sense.name.text}` never looks",
                sense.at.span,
                f"false at every boundary 1..{self.slots}",
                helps=("name boundaries, `at n in [1, 2]`, or give a condition, `at n % 8 == 0`",),
            )
            return None
        judge_values([checked], {"n": (1, self.slots)}, self.problems)
        return tuple(boundaries.tolist())

    def _levels(self, sense: tree.Sense, looks: int, target: Target) -> tuple[int, ...] | None:
        """Return the level of a sense at each of its `looks` boundaries, in steps of IN (the level
        sent to all pixels).

        Return None after reporting an error, such as another number of levels than looks (NS0320).
        """
        items: tuple[tree.Amount | tree.Levels | tree.Expr, ...] = (sense.level,) * looks
        if isinstance(sense.level, tree.Levels):
            items = sense.level.items
            if len(items) != looks:
                message = f"`{sense.name.text}` looks {looks} times, but has {len(items)} levels"
                self.problems.error(
                    "NS0320", message, sense.level.span, "give one level for each look"
                )
                return None
        known: dict[int, int | None] = {}
        for item in items:
            # The same object for all looks is checked, and reported, only once.
            if id(item) not in known:
                known[id(item)] = self._step(item, target)
        steps = [known[id(item)] for item in items]
        return None if None in steps else tuple(step for step in steps if step is not None)

    def _step(self, level: tree.Amount | tree.Levels | tree.Expr, target: Target) -> int | None:
        """Return one level in steps of IN (the level sent to all pixels).

        Return None after reporting that it has no unit or is a list (NS0320) or that the chip
        cannot compare with it (NS0321)."""
        if isinstance(level, tree.Levels):
            self.problems.error("NS0320", "a level cannot be a list of lists", level.span, "")
            return None
        if not isinstance(level, tree.Amount):
            number = constant(level, self.constants, self.problems, "a level")
            if number is not None:
                self.problems.error(
                    "NS0320",
                    f"the level {number} has no unit",
                    level.span,
                    "of what?",
                    helps=(
                        f"write {number}% of a full well, {number}e electrons or {number}lsb "
                        "converter codes; the values of a field are converter codes",
                    ),
                )
            return None
        # From here on, the level has a value and a unit; it must lie where the light can cross
        # it.
        unit, value = level.unit, level.value
        most_e, full_e = target.in_high * target.electrons_per_step, _full_e(target)
        least, most = (
            100 * e / target.full_well_e for e in (target.electrons_per_step, min(most_e, full_e))
        )
        if not can_tell(float(value), unit, target):
            self.problems.error(
                "NS0321",
                f"the level {target.level_e(float(value), unit):g} e is out of range",
                level.span,
                "this level",
                notes=(
                    f"a full well of {target.name} holds {target.full_well_e:g} e; PIX "
                    "cannot hold more",
                    f"the largest IN is {target.in_high} steps of "
                    f"{target.electrons_per_step:.4g} e: {most_e:.6g} e",
                ),
                helps=(
                    f"give a level from {least:.3g}% to {'below ' * (full_e <= most_e)}{most:.3g}%",
                ),
            )
            return None
        return level_steps(float(value), unit, target)

    def next(self, statement: tree.Next) -> CheckedNext | None:
        """Return the checked `next` statement, the change of a state, with its condition; None
        after reporting an error."""
        if not self.known_state(statement.name):
            return None
        boolean = isinstance(self.declared.states[statement.name.text], tree.StateBit)
        value = check(
            statement.value,
            "boolean" if boolean else "integer",
            self.scope,
            self.problems,
            "the next value of a bit" if boolean else "the next value",
        )
        condition = None
        if statement.condition is not None:
            condition = check(
                statement.condition,
                "boolean",
                self.scope,
                self.problems,
                "the condition of a `next`",
            )
            if condition is None:
                return None
        return None if value is None else CheckedNext(value, condition, statement.span)

    def known_state(self, name: tree.Name) -> bool:
        """Return whether a name is that of a state; report it if not: NS0209 for a name of another
        kind, NS0214 for an unknown name."""
        if name.text in self.declared.states:
            return True
        helps = ("`next` and `read` need a state: declare `state NAME : LO..HI = START`",)
        if name.text in self.declared.senses:
            helps = (
                "store its answer in a state: `state seen : bit = false`, `next seen = "
                f"{name.text}`, `read seen`",
            )
        self.declared.report_other(name, "a state", "", self.declared.states, helps, self.problems)
        return False


def level_steps(value: float, unit: str, target: Target) -> int:
    """Return a level in whole steps of IN (the level sent to all pixels), rounded; `unit` is "%" of
    a full well, "e" or "lsb"."""
    return round(target.level_e(value, unit) / target.electrons_per_step)


def can_tell(value: float, unit: str, target: Target) -> bool:
    """Return whether the light can be both below and above a level, so that comparing makes sense.

    `unit` is "%" of a full well, "e" or "lsb". IN (the level sent to all pixels) must be able to
    represent the level, and neither PIX (the photodiode) nor a register may saturate below it."""
    reached = 1 <= level_steps(value, unit, target) <= target.in_high
    return reached and target.level_e(value, unit) < _full_e(target)


def _full_e(target: Target) -> float:
    """Return the electrons at which the photodiode or a register saturates, whichever is first."""
    return min(target.full_well_e, target.register_max_e)


def checked_state(
    name: str,
    state: State,
    constants: Mapping[str, Meaning],
    problems: Problems,
    declared: Declarations,
) -> machine.State | None:
    """Return a checked state with its range and initial value; None after reporting an error.

    A bit has the range 0..1. Among the errors are an empty range (NS0306) and a start outside
    it (NS0311)."""
    boolean = isinstance(state, tree.StateBit)
    low, high = 0, 1
    if isinstance(state, tree.StateRange):
        bounds = [
            constant(expression, constants, problems, role)
            for expression, role in (
                (state.low, "the start of a range"),
                (state.high, "its end"),
            )
        ]
        if bounds[0] is None or bounds[1] is None:
            return None
        low, high = bounds[0], bounds[1]
        if low > high:
            span = state.low.span.to(state.high.span)
            message = f"the range {low}..{high} is empty"
            problems.error("NS0306", message, span, "the first value is larger than the second")
            return None
    start: int | None
    if isinstance(state, tree.StateBit) and isinstance(state.start, tree.Bool):
        start = int(state.start.value)
    else:
        start = constant(state.start, constants, problems, "the start of a state")
    if start is None:
        return None
    if not low <= start <= high:
        message = f"`{name}` starts with {start}, outside {low}..{high}"
        problems.error("NS0311", message, state.start.span, "its value at boundary 0")
        return None
    read = name in declared.reads
    return machine.State(name, low, high, start, is_kept=state.kept, read=read, boolean=boolean)
