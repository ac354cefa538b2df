"""The finite machine of a program that looks: its text, played through every code and answer.

One stage after the other: the nodes that can be reached, what the rules say in them until the next
look, and where each outcome of that look leads.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.program.arithmetic import Fault, Value, array, scalar
from nscc.program.evaluate import bit_count, evaluate, fault_at
from nscc.program.expressions import Checked
from nscc.program.looking import Looking, Sense, can_tell, level_e, level_steps
from nscc.program.names import LOOKS
from nscc.program.problems import counted
from nscc.program.table import CodeArray, Finding, NoValue, Rules, TooMuch, code_text
from nscc.program.wide import whole_name
from nscc.words.machine import Comparison, Machine, State

MOST_TRANSITIONS = 10**7
"""Most codes x states x outcomes that are played through, and replayed by the proof."""
MOST_CELLS = 1 << 29
"""Most nodes x slots, of all stages and rules together: a byte each."""
MOST_HISTORIES = 1 << 16
"""Most different times that a pixel may have been open in one node, while they are counted."""

Nodes = NDArray[np.int64]
"""(nodes, 1 + states + held senses): the row of the code, the states' values, the answers."""


@dataclass(frozen=True, eq=False)
class Stage:
    """The nodes between two looks, what they do, and where the look at the end leads them."""

    nodes: Nodes
    opens: NDArray[np.bool_]
    resets: NDArray[np.bool_]
    steps: NDArray[np.int64]


def build_machine(
    rules: Rules, looking: Looking, codes: CodeArray, target: Target
) -> tuple[Machine, NDArray[np.int32]]:
    """The machine, and the behaviour of every code (codes,).

    Raises NoValue where an expression has none for something that can happen, or a state leaves
    its range; TooMuch beyond MOST_TRANSITIONS.
    """
    return _Builder(rules, looking, codes, target).build()


class _Builder:
    def __init__(self, rules: Rules, looking: Looking, codes: CodeArray, target: Target) -> None:
        self.rules, self.looking, self.codes, self.target = rules, looking, codes, target
        self.looks = looking.looks
        asked = [*rules.rules, *([looking.reset] if looking.reset else [])]
        in_rules = {name for each in asked for name in each.variables}
        for each in looking.nexts.values():
            used = each.value.variables | (each.condition.variables if each.condition else set())
            # A `next` at a look of other senses reads the latest answer, too.
            in_rules |= {s.name for s in looking.senses if s.name in used and self._stale(s)}
        self.held = [sense for sense in looking.senses if sense.name in in_rules]
        self.width = 1 + len(looking.states)
        self.transitions = 0
        self.cells = 0

    def _stale(self, sense: Sense) -> bool:
        return set(self.looks) != set(sense.at)

    def build(self) -> tuple[Machine, NDArray[np.int32]]:
        nodes = self._start()
        stages: list[Stage] = []
        comparisons: list[Comparison] = []
        ends = (*self.looks, self.rules.slots)
        begin = 0
        for number, end in enumerate(ends):
            opens, resets = self._rules(nodes, begin, end, number)
            steps = np.full((len(nodes), 1), -1, np.int64)
            following = nodes
            if number < len(self.looks):
                asked, of_sense = self._comparisons(end)
                comparisons += asked
                steps, following = self._look(nodes, end, number + 1, len(asked), of_sense)
            stages.append(Stage(nodes, opens, resets, steps))
            nodes, begin = following, end
        return self._joined(stages, tuple(comparisons))

    def _start(self) -> Nodes:
        """Every code, with every value that kept states may have."""
        kept = [(s.low, s.high) if s.kept else (s.start, s.start) for s in self.looking.states]
        size = len(self.codes) * math.prod(high - low + 1 for low, high in kept)
        self._limit(size)
        values = [np.arange(low, high + 1) for low, high in kept]
        grids = np.meshgrid(np.arange(len(self.codes)), *values, indexing="ij")
        columns = [grid.reshape(-1) for grid in grids]
        columns += [np.zeros(size, np.int64)] * len(self.held)
        return np.stack(columns, axis=1).astype(np.int64)

    def _limit(self, more: int) -> None:
        self.transitions += more
        if self.transitions > MOST_TRANSITIONS:
            message = (
                f"{counted(len(self.codes), 'code')} with their states and answers have at "
                f"least {self.transitions} transitions, but the limit is {MOST_TRANSITIONS}"
            )
            raise TooMuch(message, self.transitions, MOST_TRANSITIONS)

    def _bindings(self, nodes: Nodes, looks: int) -> dict[str, Value]:
        """Fields, states and latest answers as columns (nodes, 1), and the looks so far."""
        found: dict[str, Value] = {LOOKS: scalar(looks)}
        for k, field in enumerate(self.rules.fields):
            column = self.codes[nodes[:, 0], k].reshape(-1, 1)
            found[field.name] = Value(column, field.low, field.high)
            if field.bits is not None:
                found[bit_count(whole_name(field.name))] = scalar(field.first_bit + field.bits)
        for k, state in enumerate(self.looking.states, 1):
            column = nodes[:, k : k + 1]
            found[state.name] = Value(
                column != 0 if state.boolean else column, state.low, state.high
            )
        for sense in self.looking.senses:
            found[sense.name] = Value(np.zeros((len(nodes), 1), np.bool_), 0, 1)
        for k, sense in enumerate(self.held, self.width):
            found[sense.name] = Value(nodes[:, k : k + 1] != 0, 0, 1)
        return found

    def _rules(
        self, nodes: Nodes, begin: int, end: int, looks: int
    ) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Where shutters are open (nodes, buckets, N) and PIX is reset (nodes, N)."""
        slots = self.rules.slots
        self._limit(len(nodes))
        # Every stage keeps what its nodes open and reset in all slots of the frame.
        self.cells += len(nodes) * (len(self.rules.rules) + 1) * slots
        if self.cells > MOST_CELLS:
            message = (
                f"{counted(len(self.codes), 'code')} with their states and answers, at "
                f"{counted(len(self.looks), 'look')}, open and reset in at least "
                f"{self.cells} slots, but the limit is {MOST_CELLS}"
            )
            raise TooMuch(message, self.cells, MOST_CELLS)
        bindings = self._bindings(nodes, looks)
        bindings["n"] = array(np.arange(begin, end, dtype=np.int64).reshape(1, -1))
        shape = (len(nodes), end - begin)
        opens = np.zeros((len(nodes), len(self.rules.rules), slots), np.bool_)
        resets = np.zeros((len(nodes), slots), np.bool_)
        for k, rule in enumerate(self.rules.rules):
            opens[:, k, begin:end] = self._value(rule, bindings, shape, nodes, begin)
        if self.looking.reset is not None:
            resets[:, begin:end] = self._value(self.looking.reset, bindings, shape, nodes, begin)
        return opens, resets

    def _value(
        self,
        expr: Checked,
        bindings: Mapping[str, Value],
        shape: tuple[int, int],
        nodes: Nodes,
        begin: int,
        where: NDArray[np.bool_] | None = None,
    ) -> NDArray[np.int64]:
        """The value of an expression everywhere; raises NoValue where it has none and is needed."""
        found = evaluate(expr, bindings, self.rules.books)
        data = np.broadcast_to(np.asarray(found.data), shape)
        if found.faults is None:
            return data
        if isinstance(found.faults, np.ndarray):
            places = np.broadcast_to(found.faults, shape)
        else:
            places = np.ones(shape, np.bool_)
        if where is not None:
            places = places & where
        if not places.any():
            return data
        row, slot = (int(k) for k in np.unravel_index(int(places.argmax()), shape))
        fault = fault_at(expr, bindings, self.rules.books, shape, (row, slot))
        raise NoValue([Finding(fault, self._place(nodes[row], begin + slot), int(places.sum()))])

    def _place(self, node: Nodes, boundary: int) -> str:
        """A node in words."""
        parts = [code_text(self.rules, self.codes[node[0]])] if self.rules.fields else []
        parts += [f"{state.name} = {node[1 + k]}" for k, state in enumerate(self.looking.states)]
        return f"for {', '.join(parts)}, at n = {boundary}" if parts else f"at n = {boundary}"

    def _comparisons(self, boundary: int) -> tuple[list[Comparison], dict[str, NDArray[np.int64]]]:
        """The comparisons of a look, and the number of that of each sense by code (codes,)."""
        asked: list[Comparison] = []
        of_sense: dict[str, NDArray[np.int64]] = {}
        for sense in self.looking.senses:
            if boundary not in sense.at:
                continue
            if sense.steps is not None:
                levels = np.array([sense.steps[sense.at.index(boundary)]])
            else:
                names = [field.name for field in self.rules.fields]
                values = self.codes[:, names.index(sense.field or "")]
                steps = {v: self._field_step(sense, v) for v in sorted(set(values.tolist()))}
                levels = np.array([steps[v] for v in values.tolist()])
            numbers = []
            for level in levels.tolist():
                comparison = Comparison(boundary, sense.signal, level)
                if comparison not in asked:
                    asked.append(comparison)
                numbers.append(asked.index(comparison))
            of_sense[sense.name] = np.broadcast_to(np.array(numbers), (len(self.codes),))
        return asked, of_sense

    def _field_step(self, sense: Sense, value: int) -> int:
        target = self.target
        step = level_steps(value, "lsb", target)
        if not can_tell(value, "lsb", target):
            text = (
                f"a level must be between 1 and {target.in_high} steps, and below "
                f"{target.full_well_e:g} e (a full well) and {target.register_max_e:g} e (a "
                "full register)"
            )
            held_e = level_e(value, "lsb", target)
            message = f"the level {value} of `{sense.field}` is {step} steps of IN, {held_e:g} e"
            fault = Fault("NS0321", message, sense.span, text)
            raise NoValue([Finding(fault, f"for {sense.field} = {value}", 1)])
        return step

    def _look(
        self,
        nodes: Nodes,
        boundary: int,
        looks: int,
        asked: int,
        of_sense: Mapping[str, NDArray[np.int64]],
    ) -> tuple[NDArray[np.int64], Nodes]:
        """Where each outcome leads (nodes, outcomes), as rows of the nodes that follow."""
        outcomes = 1 << asked
        self._limit(len(nodes) * outcomes)
        rows = np.repeat(nodes, outcomes, axis=0)
        outcome = np.tile(np.arange(outcomes), len(nodes))
        bindings = self._bindings(rows, looks)
        bindings["n"] = scalar(boundary)
        for sense in self.looking.senses:
            if sense.name in of_sense:
                bit = outcome >> of_sense[sense.name][rows[:, 0]] & 1
                answer = (bit == 1) == sense.above
                bindings[sense.name] = Value(answer.reshape(-1, 1), 0, 1)
        after = rows.copy()
        shape = (len(rows), 1)
        for k, state in enumerate(self.looking.states, 1):
            given = self.looking.nexts.get(state.name)
            if given is None:
                continue
            where = np.ones(shape, np.bool_)
            if given.condition is not None:
                where = self._value(given.condition, bindings, shape, rows, boundary) != 0
            value = self._value(given.value, bindings, shape, rows, boundary, where)
            beyond = where & ((value < state.low) | (value > state.high))
            if beyond.any():
                row = int(beyond[:, 0].argmax())
                message = f"`{state.name}` gets the value {int(value[row, 0])}, outside its range"
                text = f"`{state.name}` has the values {state.low}..{state.high}"
                fault = Fault("NS0311", message, given.span, text)
                raise NoValue([Finding(fault, self._place(rows[row], boundary), int(beyond.sum()))])
            after[:, k] = np.where(where, value, rows[:, k : k + 1])[:, 0]
        for k, sense in enumerate(self.held, self.width):
            after[:, k] = np.broadcast_to(bindings[sense.name].data, shape)[:, 0]
        following, inverse = np.unique(after, axis=0, return_inverse=True)
        return inverse.reshape(len(nodes), outcomes), following

    def _joined(
        self, stages: list[Stage], comparisons: tuple[Comparison, ...]
    ) -> tuple[Machine, NDArray[np.int32]]:
        """One machine of what is different in the codes."""
        behaviour_of_code, chosen = self._behaviours(stages)
        most = max(stage.steps.shape[1] for stage in stages)
        kept = [np.flatnonzero(np.isin(stage.nodes[:, 0], chosen)) for stage in stages]
        first = np.cumsum([0, *map(len, kept)])
        steps = np.full((int(first[-1]), most), -1, np.int64)
        for number, (stage, rows) in enumerate(zip(stages[:-1], kept[:-1], strict=True)):
            place = np.full(len(stages[number + 1].nodes), -1, np.int64)
            place[kept[number + 1]] = first[number + 1] + np.arange(len(kept[number + 1]))
            steps[first[number] : first[number + 1], : stage.steps.shape[1]] = place[
                stage.steps[rows]
            ]
        pairs = [*zip(stages, kept, strict=True)]
        nodes = np.concatenate([stage.nodes[rows] for stage, rows in pairs])
        opens = np.concatenate([stage.opens[rows] for stage, rows in pairs])
        behaviour = behaviour_of_code[nodes[:, 0]]
        answers = [State(s.name, 0, 1, 0, boolean=True, sense=True) for s in self.held]
        machine = Machine(
            states=(*self.looking.states, *answers),
            comparisons=comparisons,
            looks=self.looks,
            first=first.astype(np.int32),
            behaviour=behaviour.astype(np.int32),
            values=nodes[:, 1:].copy(),
            opens=opens,
            resets=np.concatenate([stage.resets[rows] for stage, rows in pairs]),
            steps=steps.astype(np.int32),
            open_slots=np.full((len(nodes), opens.shape[1]), -1, np.int32),
            open_us=np.full((len(nodes), opens.shape[1]), -1.0),
        )
        return machine, behaviour_of_code

    def _behaviours(self, stages: list[Stage]) -> tuple[NDArray[np.int32], NDArray[np.int64]]:
        """The behaviour of every code, and the first code of each; alike codes do the same."""
        seen: dict[bytes, int] = {}
        found = np.empty(len(self.codes), np.int32)
        chosen: list[int] = []
        bounds = [
            np.searchsorted(stage.nodes[:, 0], np.arange(len(self.codes) + 1)) for stage in stages
        ]
        for code in range(len(self.codes)):
            parts: list[bytes] = []
            for number, stage in enumerate(stages):
                rows = slice(bounds[number][code], bounds[number][code + 1])
                steps = stage.steps[rows]
                if number + 1 < len(stages):
                    steps = steps - bounds[number + 1][code]
                tables = stage.nodes[rows, 1:], stage.opens[rows], stage.resets[rows], steps
                parts += [np.ascontiguousarray(each).tobytes() for each in tables]
            key = b"|".join(parts)
            if key not in seen:
                seen[key] = len(chosen)
                chosen.append(code)
            found[code] = seen[key]
        return found, np.array(chosen, np.int64)
