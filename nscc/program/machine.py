"""The finite state machine of a program with senses, built by running it for every code and answer.

For each stage it contains the reachable nodes, the shutters and resets in them until the next look,
and the next node for each outcome of that look."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from nscc.arrays import Bools, Ints, Ints32
from nscc.chips.target import Target
from nscc.program.evaluate import Fault, Value, bit_count, outside_range, values_of
from nscc.program.expressions import Checked
from nscc.program.looking import CheckedSense, Looking, can_tell, level_steps
from nscc.program.names import LOOKS
from nscc.program.problems import counted
from nscc.program.program import whole_name
from nscc.program.table import CodeArray, MissingValue, NoValue, Rules, TooMuch, code_text
from nscc.record import Record
from nscc.words.machine import Comparison, State, StateMachine

MOST_TRANSITIONS = 10**7
"""Most codes x states x outcomes, which the proof replays, too."""
MOST_CELLS = 1 << 29
"""Most nodes x slots of all stages and rules together; each takes a byte."""
MOST_HISTORIES = 1 << 16
"""Most different open times of one node."""

Nodes = Ints
"""The nodes of a stage: (nodes, 1 + states + remembered senses).

A row has the index of the code, the states' values, and the answers."""


class Stage(Record, eq=False):
    """All that can happen between two looks (boundaries at which pixels compare their light).

    `nodes` has a row for each state in which a pixel can be (see `Nodes`), `opens` bool (nodes,
    buckets, N) and `resets` bool (nodes, N) what it does then. `steps` (nodes, outcomes) are the
    rows in the next stage for each outcome of the look that ends this one; -1 in the last stage."""

    nodes: Nodes
    opens: Bools
    resets: Bools
    steps: Ints


class MachineBuilder:
    """Builds the state machine of a program with senses, for the compiled codes.

    `codes` (codes, fields) are the compiled codes. `remembered` are the senses whose answers pixels
    must store, because rules read them later."""

    def __init__(self, rules: Rules, looking: Looking, codes: CodeArray, target: Target) -> None:
        """Find which answers a pixel must remember: those that rules, resets or later changes of
        states read."""
        self.rules, self.looking, self.codes, self.target = rules, looking, codes, target
        self.looks = looking.looks
        expressions = [*rules.rules, *([looking.reset] if looking.reset else [])]
        in_rules = {name for expression in expressions for name in expression.variables}
        for step in looking.nexts.values():
            used = step.value.variables | (step.condition.variables if step.condition else set())
            # A `next` at a look of other senses also reads the latest answer.
            in_rules |= {
                s.name for s in looking.senses if s.name in used and set(s.at) != set(self.looks)
            }
        self.remembered = [sense for sense in looking.senses if sense.name in in_rules]
        # Columns of a node before its answers: the code's index and the states.
        self.width = 1 + len(looking.states)
        # Counted while the machine is built, for the limits MOST_TRANSITIONS and MOST_CELLS.
        self.transitions = 0
        self.cells = 0

    def build(self) -> tuple[StateMachine, Ints32]:
        """Return the machine, and the number of the behaviour of every code, int32 (codes,).

        A behaviour is a set of codes whose pixels act alike for all answers. Raises NoValue if an
        expression has no value in a reachable node (state of the machine) or a state leaves its
        range, and TooMuch for too large a machine."""
        # Every code with every possible value of its kept states.
        ranges = [(s.low, s.high) if s.is_kept else (s.start, s.start) for s in self.looking.states]
        size = len(self.codes) * math.prod(high - low + 1 for low, high in ranges)
        self._limit(size)
        values = [np.arange(low, high + 1) for low, high in ranges]
        grids = np.meshgrid(np.arange(len(self.codes)), *values, indexing="ij")
        columns = [grid.reshape(-1) for grid in grids]
        # Before its first look, the answer of a sense is false.
        columns += [np.zeros(size, np.int64)] * len(self.remembered)
        nodes = np.stack(columns, axis=1).astype(np.int64)
        stages: list[Stage] = []
        comparisons: list[Comparison] = []
        ends = (*self.looks, self.rules.slots)
        begin = 0
        for number, end in enumerate(ends):
            opens, resets = self._rules(nodes, begin, end, number)
            steps = np.full((len(nodes), 1), -1, np.int64)
            following = nodes
            if number < len(self.looks):
                stage_comparisons, of_sense = self._comparisons(end)
                comparisons += stage_comparisons
                steps, following = self._next_nodes(
                    nodes, end, number + 1, len(stage_comparisons), of_sense
                )
            stages.append(Stage(nodes, opens, resets, steps))
            nodes, begin = following, end
        return self._joined(stages, tuple(comparisons))

    def _limit(self, added: int) -> None:
        """Add `added` to the number of transitions (steps from a node to another); raise TooMuch
        beyond `MOST_TRANSITIONS`."""
        self.transitions += added
        if self.transitions > MOST_TRANSITIONS:
            message = (
                f"{counted(len(self.codes), 'code')} with their states and answers have at "
                f"least {self.transitions} transitions, but the limit is {MOST_TRANSITIONS}"
            )
            raise TooMuch(message, self.transitions, MOST_TRANSITIONS)

    def _bindings(self, nodes: Nodes, looks: int) -> dict[str, Value]:
        """Return the values of names for `nodes`: fields, states and latest answers as columns
        (nodes, 1).

        The latest answer of a sense that pixels do not remember is False. `looks` is the number of
        looks so far, which is the value of the name `looks`."""
        bindings: dict[str, Value] = {LOOKS: Value(looks)}
        for k, field in enumerate(self.rules.fields):
            column = self.codes[nodes[:, 0], k].reshape(-1, 1)
            bindings[field.name] = Value(column)
            if field.bits is not None:
                bindings[bit_count(whole_name(field.name))] = Value(field.first_bit + field.bits)
        for k, state in enumerate(self.looking.states, 1):
            column = nodes[:, k : k + 1]
            bindings[state.name] = Value(column != 0 if state.boolean else column)
        for sense in self.looking.senses:
            bindings[sense.name] = Value(np.zeros((len(nodes), 1), np.bool_))
        for k, sense in enumerate(self.remembered, self.width):
            bindings[sense.name] = Value(nodes[:, k : k + 1] != 0)
        return bindings

    def _rules(self, nodes: Nodes, begin: int, end: int, looks: int) -> tuple[Bools, Bools]:
        """Return the open shutters, bool (nodes, buckets, N), and the resets of PIX (the
        photodiode), bool (nodes, N), of a stage.

        The stage has slots `begin` to `end` - 1 and follows `looks` looks; other slots are closed.
        Raises TooMuch for too large a machine, and NoValue if a rule has no value."""
        slots = self.rules.slots
        self._limit(len(nodes))
        # Every stage stores opens and resets for all slots of the frame.
        self.cells += len(nodes) * (len(self.rules.rules) + 1) * slots
        if self.cells > MOST_CELLS:
            message = (
                f"{counted(len(self.codes), 'code')} with their states and answers, at "
                f"{counted(len(self.looks), 'look')}, open and reset in at least "
                f"{self.cells} slots, but the limit is {MOST_CELLS}"
            )
            raise TooMuch(message, self.cells, MOST_CELLS)
        bindings = self._bindings(nodes, looks)
        bindings["n"] = Value(np.arange(begin, end, dtype=np.int64).reshape(1, -1))
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
        needed: Bools | bool = True,
    ) -> Ints:
        """Return the values of an expression, int64 or (for a condition) bool of `shape`: a row for
        each node, a column for each slot from `begin` on.

        `bindings` are the values of names. `needed` marks the values that matter. Raises NoValue if
        one of them does not exist; its text names the first of `nodes` and the slot."""
        data, gap = values_of(expr, bindings, self.rules.books, shape, needed)
        if gap is None:
            return data
        row, slot = gap.first_index
        first_case = self._node_text(nodes[row], begin + slot)
        raise NoValue([MissingValue(gap.fault, first_case, gap.number)])

    def _node_text(self, node: Nodes, boundary: int) -> str:
        """Describe a node (state of the machine, a row of `Nodes`) at a boundary for a message: its
        code and states."""
        texts = [code_text(self.rules, self.codes[node[0]])] if self.rules.fields else []
        texts += [f"{state.name} = {node[1 + k]}" for k, state in enumerate(self.looking.states)]
        return f"for {', '.join(texts)}, at n = {boundary}" if texts else f"at n = {boundary}"

    def _comparisons(self, boundary: int) -> tuple[list[Comparison], dict[str, Ints]]:
        """Return the comparisons of the look at `boundary`, and which of them each sense uses.

        The latter is an array (codes,) of indices by the sense's name: a level can depend on the
        code. Senses that compare the same signal with the same level share a comparison. Raises
        NoValue (NS0321) for a level that the chip cannot compare."""
        comparisons: list[Comparison] = []
        of_sense: dict[str, Ints] = {}
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
                if comparison not in comparisons:
                    comparisons.append(comparison)
                numbers.append(comparisons.index(comparison))
            of_sense[sense.name] = np.broadcast_to(np.array(numbers), (len(self.codes),))
        return comparisons, of_sense

    def _field_step(self, sense: CheckedSense, value: int) -> int:
        """Return the level of a sense in steps of IN (the level sent to all pixels) for one value
        of its field, which is a converter code.

        Raises NoValue (NS0321) if the chip cannot compare with this level."""
        target = self.target
        step = level_steps(value, "lsb", target)
        if not can_tell(value, "lsb", target):
            text = (
                f"a level must be between 1 and {target.in_high} steps, and below "
                f"{target.full_well_e:g} e (a full well) and {target.register_max_e:g} e (a "
                "full register)"
            )
            held_e = target.level_e(value, "lsb")
            message = f"the level {value} of `{sense.field}` is {step} steps of IN, {held_e:g} e"
            fault = Fault("NS0321", message, sense.span, text)
            raise NoValue([MissingValue(fault, f"for {sense.field} = {value}", count=1)])
        return step

    def _next_nodes(
        self,
        nodes: Nodes,
        boundary: int,
        looks: int,
        comparison_count: int,
        of_sense: Mapping[str, Ints],
    ) -> tuple[Ints, Nodes]:
        """Return the next node (state of the machine) for each of `nodes` and each outcome of the
        look at `boundary`.

        The first result (nodes, outcomes) has rows of the second, the nodes of the next stage. Bit
        k of an outcome is the answer of comparison k of `comparison_count`; `of_sense` gives each
        code's comparison. `looks` counts the looks so far. Raises NoValue if a state leaves its
        range, and TooMuch."""
        outcomes = 1 << comparison_count
        self._limit(len(nodes) * outcomes)
        rows = np.repeat(nodes, outcomes, axis=0)
        outcome = np.tile(np.arange(outcomes), len(nodes))
        bindings = self._bindings(rows, looks)
        bindings["n"] = Value(boundary)
        for sense in self.looking.senses:
            if sense.name in of_sense:
                # Column 0 of a row is its code, whose comparison the outcome answers.
                bit = outcome >> of_sense[sense.name][rows[:, 0]] & 1
                answer = (bit == 1) == sense.above
                bindings[sense.name] = Value(answer.reshape(-1, 1))
        after = rows.copy()
        shape = (len(rows), 1)
        for k, state in enumerate(self.looking.states, 1):
            step = self.looking.nexts.get(state.name)
            if step is None:
                continue
            changes = np.ones(shape, np.bool_)
            if step.condition is not None:
                changes = self._value(step.condition, bindings, shape, rows, boundary) != 0
            value = self._value(
                expr=step.value,
                bindings=bindings,
                shape=shape,
                nodes=rows,
                begin=boundary,
                needed=changes,
            )
            beyond = changes & ((value < state.low) | (value > state.high))
            if beyond.any():
                row = int(beyond[:, 0].argmax())
                fault = outside_range(
                    state.name,
                    range(state.low, state.high + 1),
                    int(value[row, 0]),
                    step.span,
                    f"declare more values, or let the rule keep `{state.name}` within them",
                )
                raise NoValue(
                    [MissingValue(fault, self._node_text(rows[row], boundary), int(beyond.sum()))]
                )
            after[:, k] = np.where(changes, value, rows[:, k : k + 1])[:, 0]
        for k, sense in enumerate(self.remembered, self.width):
            after[:, k] = np.broadcast_to(bindings[sense.name].data, shape)[:, 0]
        # Equal rows are one node; the code is part of a row.
        following, inverse = np.unique(after, axis=0, return_inverse=True)
        return inverse.reshape(len(nodes), outcomes), following

    def _joined(
        self, stages: list[Stage], comparisons: tuple[Comparison, ...]
    ) -> tuple[StateMachine, Ints32]:
        """Return the machine of all stages, and the number of the behaviour (set of codes that act
        alike) of every code, int32 (codes,).

        `comparisons` are those of all looks in order. Codes of equal behaviour are merged: of each
        behaviour, only the nodes (states of the machine) of its first code remain."""
        behaviour_of_code, chosen = self._behaviours(stages)
        most = max(stage.steps.shape[1] for stage in stages)
        stage_rows = [np.flatnonzero(np.isin(stage.nodes[:, 0], chosen)) for stage in stages]
        first = np.cumsum([0, *map(len, stage_rows)])
        steps = np.full((int(first[-1]), most), -1, np.int64)
        for number, (stage, rows) in enumerate(zip(stages[:-1], stage_rows[:-1], strict=True)):
            # The number in the machine of each row of the next stage; -1 for rows left out.
            new_number = np.full(len(stages[number + 1].nodes), -1, np.int64)
            new_number[stage_rows[number + 1]] = first[number + 1] + np.arange(
                len(stage_rows[number + 1])
            )
            steps[first[number] : first[number + 1], : stage.steps.shape[1]] = new_number[
                stage.steps[rows]
            ]
        pairs = [*zip(stages, stage_rows, strict=True)]
        nodes = np.concatenate([stage.nodes[rows] for stage, rows in pairs])
        opens = np.concatenate([stage.opens[rows] for stage, rows in pairs])
        behaviour = behaviour_of_code[nodes[:, 0]]
        answers = [
            State(s.name, low=0, high=1, start=0, boolean=True, sense=True) for s in self.remembered
        ]
        machine = StateMachine(
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

    def _behaviours(self, stages: list[Stage]) -> tuple[Ints32, Ints]:
        """Return the number of the behaviour of every code, int32 (codes,), and the index of the
        first code of each behaviour.

        Two codes have one behaviour if their shutters, resets and states are equal for all answers.
        """
        behaviour_of_key: dict[bytes, int] = {}
        behaviour_of_code = np.empty(len(self.codes), np.int32)
        chosen: list[int] = []
        # Nodes are sorted by code: a code has the rows from its bound to that of the next code.
        bounds = [
            np.searchsorted(stage.nodes[:, 0], np.arange(len(self.codes) + 1)) for stage in stages
        ]
        for code in range(len(self.codes)):
            stage_bytes: list[bytes] = []
            for number, stage in enumerate(stages):
                rows = slice(bounds[number][code], bounds[number][code + 1])
                steps = stage.steps[rows]
                # Steps are rows of the next stage: relative to the code's first row there, they can
                # be compared with those of other codes.
                if number + 1 < len(stages):
                    steps = steps - bounds[number + 1][code]
                tables = stage.nodes[rows, 1:], stage.opens[rows], stage.resets[rows], steps
                stage_bytes += [np.ascontiguousarray(table).tobytes() for table in tables]
            key = b"|".join(stage_bytes)
            if key not in behaviour_of_key:
                behaviour_of_key[key] = len(chosen)
                chosen.append(code)
            behaviour_of_code[code] = behaviour_of_key[key]
        return behaviour_of_code, np.array(chosen, np.int64)
