"""The statements of version 2, checked: what a pixel senses, remembers, resets and reads out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from nscc.chips.target import Target
from nscc.program.arithmetic import Fault, array
from nscc.program.constants import constant
from nscc.program.evaluate import evaluate
from nscc.program.expressions import Checked, Meaning, check
from nscc.program.names import Declarations, State
from nscc.program.problems import Problems
from nscc.program.scopes import at_scope, constants_scope, next_scope
from nscc.source import Span
from nscc.syntax import tree
from nscc.words import machine


@dataclass(frozen=True, eq=False)
class Sense:
    """What is compared: `signal` as of `machine.Comparison`, at the boundaries `at`.

    The answer is whether the signal is above its level, or below where not `above`. `steps` has the
    level in steps of IN, one for each boundary of `at`; None where the `field` of the code gives
    it, in codes of the ADC.
    """

    name: str
    signal: int
    above: bool
    at: tuple[int, ...]
    steps: tuple[int, ...] | None
    field: str | None
    span: Span


@dataclass(frozen=True, eq=False)
class Next:
    """The value that a state takes at a look, and when; None: always."""

    value: Checked
    condition: Checked | None
    span: Span


@dataclass(frozen=True, eq=False)
class Looking:
    """All that shutters depend on beside code and slot."""

    senses: tuple[Sense, ...]
    states: tuple[machine.State, ...]
    nexts: Mapping[str, Next]
    reset: Checked | None

    @property
    def looks(self) -> tuple[int, ...]:
        """The boundaries with at least one sense."""
        return tuple(sorted({n for sense in self.senses for n in sense.at}))

    @property
    def expressions(self) -> list[Checked]:
        """What `next` and `reset when` ask."""
        found = [] if self.reset is None else [self.reset]
        for each in self.nexts.values():
            found += [each.value] if each.condition is None else [each.value, each.condition]
        return found


def make_looking(
    declared: Declarations,
    constants: Mapping[str, Meaning],
    target: Target | None,
    problems: Problems,
) -> Looking | None:
    """The statements of version 2; None where there are none, or after reporting what is wrong.

    Reports names that are no state (NS0209, NS0214), levels that cannot be told from the well or
    that IN cannot have (NS0320, NS0321), senses that never look (NS0322), starts outside their
    range (NS0311) and signals that cannot be compared (NS0323).
    """
    if not declared.looking:
        return None
    maker = _Maker(declared, constants, target, problems)
    senses = [maker.sense(sense) for sense in declared.senses.values()]
    states = [maker.state(name, state) for name, state in declared.states.items()]
    nexts = {name: maker.next(each) for name, each in declared.nexts.items()}
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
        tuple(each for each in senses if each is not None),
        tuple(each for each in states if each is not None),
        {name: each for name, each in nexts.items() if each is not None},
        reset,
    )


class _Maker:
    def __init__(
        self,
        declared: Declarations,
        constants: Mapping[str, Meaning],
        target: Target | None,
        problems: Problems,
    ) -> None:
        self.declared = declared
        self.constants = constants_scope(declared, constants)
        self.scope = next_scope(declared, constants)
        self.at_scope = at_scope(declared, constants)
        self.slots = constants["N"].value if constants["N"].kind == "constant" else 0
        self.target = target
        self.problems = problems
        self.buckets = {
            rule.name.text: number
            for number, rule in enumerate(declared.rules)
            if isinstance(rule, tree.Bucket)
        }

    def sense(self, sense: tree.Sense) -> Sense | None:
        """One sense."""
        signal = self._signal(sense.signal)
        if sense.comparison not in ("<", ">"):
            self.problems.error(
                "NS0323", "a comparison of charge is `>` or `<`", sense.span,
                f"this one is `{sense.comparison}`",
                notes=("no comparator can tell whether two charges are equal",),
            )  # fmt: skip
        at = self._boundaries(sense)
        if at is None or signal is None or self.target is None:
            return None
        name, above = sense.name.text, sense.comparison == ">"
        field = self._field(sense.level)
        if field is not None:
            return Sense(name, signal, above, at, None, field, sense.span)
        steps = self._levels(sense, len(at), self.target)
        if steps is None:
            return None
        return Sense(name, signal, above, at, steps, None, sense.span)

    def _signal(self, signal: tree.Light | tree.Exposure) -> int | None:
        if isinstance(signal, tree.Light):
            return machine.LIGHT
        if signal.bucket is None:
            if len(self.declared.rules) == 1:
                return 0
            helps = (f"say which one: `exposure {next(iter(self.buckets), 'NAME')}`",)
            self.problems.error(
                "NS0323", "this program has several buckets", signal.span, "whose exposure?",
                helps=helps,
            )  # fmt: skip
            return None
        number = self.buckets.get(signal.bucket.text)
        if number is None:
            self.problems.unknown("a bucket", signal.bucket.text, signal.bucket.span, self.buckets)
        return number

    def _boundaries(self, sense: tree.Sense) -> tuple[int, ...] | None:
        """The boundaries 1..N of a sense."""
        asked = check(
            sense.at, "boolean", self.at_scope, self.problems, "the boundaries of a sense"
        )
        if asked is None or not self.slots:
            return None
        numbers = np.arange(1, self.slots + 1, dtype=np.int64)
        found = evaluate(asked, {"n": array(numbers)}, {})
        if isinstance(found.faults, Fault):
            self.problems.error(*found.faults)
            return None
        if found.faults is not None:
            where = int(numbers[np.broadcast_to(found.faults, numbers.shape)][0])
            text = f"for n = {where}"
            message = "the boundaries of this sense cannot be told"
            self.problems.error("NS0322", message, sense.at.span, text)
            return None
        at = numbers[np.broadcast_to(np.asarray(found.data, np.bool_), numbers.shape)]
        if not at.size:
            self.problems.error(
                "NS0322", f"the sense `{sense.name.text}` never looks", sense.at.span,
                f"false at every boundary 1..{self.slots}",
                helps=("name boundaries, `at n in [1, 2]`, or give a condition, `at n % 8 == 0`",),
            )  # fmt: skip
            return None
        return tuple(at.tolist())

    def _field(self, level: tree.Amount | tree.Levels | tree.Expr) -> str | None:
        if isinstance(level, tree.Name) and level.text in self.declared.codes:
            return level.text
        return None

    def _levels(self, sense: tree.Sense, looks: int, target: Target) -> tuple[int, ...] | None:
        items: tuple[tree.Amount | tree.Levels | tree.Expr, ...] = (sense.level,) * looks
        if isinstance(sense.level, tree.Levels):
            items = sense.level.items
            if len(items) != looks:
                message = f"`{sense.name.text}` looks {looks} times and has {len(items)} levels"
                self.problems.error("NS0320", message, sense.level.span, "one for each look")
                return None
        known: dict[int, int | None] = {}
        for item in items:
            if id(item) not in known:
                known[id(item)] = self._step(item, target)
        steps = [known[id(item)] for item in items]
        return None if None in steps else tuple(step for step in steps if step is not None)

    def _step(self, level: tree.Amount | tree.Levels | tree.Expr, target: Target) -> int | None:
        """A level in steps of IN."""
        if isinstance(level, tree.Levels):
            self.problems.error("NS0320", "a list of lists is no level", level.span, "")
            return None
        if not isinstance(level, tree.Amount):
            number = constant(level, self.constants, self.problems, "a level")
            if number is not None:
                self.problems.error(
                    "NS0320", f"the level {number} has no unit", level.span, "of what?",
                    helps=(
                        f"write {number}% of a full well, {number}e electrons or {number}lsb codes "
                        "of the ADC; a field of the code is in codes",
                    ),
                )  # fmt: skip
            return None
        unit, value = level.unit, level.value
        most_e, full_e = target.in_high * target.electrons_per_step, _full_e(target)
        least, most = (
            100 * e / target.full_well_e for e in (target.electrons_per_step, min(most_e, full_e))
        )
        if not can_tell(float(value), unit, target):
            self.problems.error(
                "NS0321",
                f"no pixel can tell whether it holds {level_e(float(value), unit, target):g} e",
                level.span, "this level",
                notes=(
                    f"PIX of {target.name} holds {target.full_well_e:g} e, and beyond that it says "
                    "no more than that it is full",
                    f"IN goes up to {target.in_high} steps of {target.electrons_per_step:.4g} e: "
                    f"{most_e:.6g} e",
                ),
                helps=(
                    f"give a level from {least:.3g}% to {'below ' * (full_e <= most_e)}{most:.3g}%",
                ),
            )  # fmt: skip
            return None
        return level_steps(float(value), unit, target)

    def state(self, name: str, state: State) -> machine.State | None:
        """One state."""
        boolean = isinstance(state, tree.StateBit)
        low, high = 0, 1
        if isinstance(state, tree.StateRange):
            given = [
                constant(each, self.constants, self.problems, what)
                for each, what in ((state.low, "the start of a range"), (state.high, "its end"))
            ]
            if given[0] is None or given[1] is None:
                return None
            low, high = given[0], given[1]
            if low > high:
                span = state.low.span.to(state.high.span)
                message = f"the range {low}..{high} is empty"
                self.problems.error("NS0306", message, span, "the first value is the larger one")
                return None
        start = self._start(state)
        if start is None:
            return None
        if not low <= start <= high:
            message = f"`{name}` starts with {start}, outside {low}..{high}"
            self.problems.error("NS0311", message, state.start.span, "its value at boundary 0")
            return None
        read = name in self.declared.reads
        return machine.State(name, low, high, start, state.kept, read, boolean)

    def _start(self, state: State) -> int | None:
        """START; a bit may start with true and false, too."""
        if isinstance(state, tree.StateBit) and isinstance(state.start, tree.Bool):
            return int(state.start.value)
        return constant(state.start, self.constants, self.problems, "the start of a state")

    def next(self, each: tree.Next) -> Next | None:
        """One `next`."""
        if not self.known_state(each.name):
            return None
        boolean = isinstance(self.declared.states[each.name.text], tree.StateBit)
        value = check(
            each.value, "boolean" if boolean else "integer", self.scope, self.problems,
            "the next value of a bit" if boolean else "the next value",
        )  # fmt: skip
        condition = None
        if each.condition is not None:
            condition = check(
                each.condition, "boolean", self.scope, self.problems, "the condition of a `next`"
            )
            if condition is None:
                return None
        return None if value is None else Next(value, condition, each.span)

    def known_state(self, name: tree.Name) -> bool:
        """Whether this is a state; says so if it is not."""
        if name.text in self.declared.states:
            return True
        if name.text in self.declared.refused:
            return False
        what = dict(self.declared.declared()).get(name.text)
        if what is None:
            self.problems.unknown("a state", name.text, name.span, self.declared.states)
            return False
        helps = (
            "only states step, and come with the frame: declare `state NAME : LO..HI = START`",
        )
        if name.text in self.declared.senses:
            helps = (
                "remember its answer in a state: `state seen : bit = false`, "
                f"`next seen = {name.text}`, `read seen`",
            )
        message = f"`{name.text}` is {what}, not a state"
        self.problems.error("NS0209", message, name.span, what, helps=helps)
        return False


def level_e(value: float, unit: str, target: Target) -> float:
    """A level in electrons."""
    size = {"%": target.full_well_e / 100, "e": 1.0, "lsb": target.electrons_per_lsb}[unit]
    return value * size


def level_steps(value: float, unit: str, target: Target) -> int:
    """A level in steps of IN, rounded."""
    return round(level_e(value, unit, target) / target.electrons_per_step)


def can_tell(value: float, unit: str, target: Target) -> bool:
    """Whether pixels can hold less than a level and more: IN reaches it, and neither PIX nor a
    register is full below it."""
    reached = 1 <= level_steps(value, unit, target) <= target.in_high
    return reached and level_e(value, unit, target) < _full_e(target)


def _full_e(target: Target) -> float:
    """Electrons at which a pixel is full, where it is read or where that is held."""
    return min(target.full_well_e, target.register_max_e)
