"""Words on virtual registers for every moment (boundary with operations) of an analog plan, with
one encoding."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Indices
from nscc.chips.target import Target
from nscc.logic.problem import Gate, GaveUp, Machine
from nscc.looks.boundary_gates import FLAG, RegisterContents, write_simultaneously
from nscc.looks.counters import count, steps_of
from nscc.looks.encode import COUNTER, LooksEncoding, ValueBits
from nscc.looks.looking_plan import LookingPlan, Moment
from nscc.lower.exposure_plan import RESET
from nscc.operations import Op, op
from nscc.record import Record
from nscc.truth import columns, vector
from nscc.words.machine import LIGHT, Comparison


class SetIn(Record):
    """An item between words: set IN, the value that all pixels receive, to `level` steps."""

    level: int

    def __str__(self) -> str:
        """Return the item as text, such as "IN at 12"."""
        return f"IN at {self.level}"


Item = Gate | Op | SetIn
"""An entry in the code of a boundary: a gate, a word, or a change of IN (the level sent to all
pixels)."""


class LookingSolution(Record, eq=False):
    """The words of a frame on virtual registers, by boundary (`items`).

    p0, p1, .. keep their content over frames. `planes` are their contents before the first frame,
    as truth vectors: integers with one bit for each behaviour (set of codes that act alike).
    `holders` say what they hold. s0, s1, .. are states within a frame, initially 0, whose names are
    `states`; t0, .. are scratch registers (for intermediate results), `scratch` of them.
    `registers` names the virtual registers of each state, in the order of the encoding's bits."""

    encoding: LooksEncoding
    planes: tuple[int, ...]
    holders: tuple[str, ...]
    states: tuple[str, ...]
    registers: tuple[tuple[str, ...], ...]
    scratch: int
    items: dict[int, tuple[Item, ...]]


class Solver:
    """Finds the words of the analog plan of a program with senses, with one encoding of codes and
    states.

    `code` are the virtual registers of the code, and `registers` those of each state."""

    def __init__(self, plan: LookingPlan, encoding: LooksEncoding, target: Target) -> None:
        """Assign virtual registers to the bits of the code and of each state.

        Codes and kept states get registers that the host loads (p0, p1, ..); other states get
        registers that start at 0 (s0, s1, ..). `target` is the chip, which limits gates and
        registers."""
        self.plan, self.encoding, self.target = plan, encoding, target
        self.machine = plan.machine
        self.gates = Machine.of(target)
        self.holders: list[str] = []
        self.states: list[str] = []
        self.code = [
            self._plane(f"code, {encoding.code.kind}") for _ in range(encoding.code.registers)
        ]
        self.registers = tuple(
            tuple(
                self._plane(value_bits.name) if state.is_kept else self._state(value_bits.name)
                for _ in range(value_bits.registers)
            )
            for state, value_bits in zip(self.machine.states, encoding.states, strict=True)
        )

    def _plane(self, holder: str) -> str:
        """Return the name of a new register that keeps its content over frames, such as `p0`;
        `holder` says what it holds."""
        self.holders.append(holder)
        return f"p{len(self.holders) - 1}"

    def _state(self, holder: str) -> str:
        """Return the name of a new register for a state that is 0 at the start of a frame, such as
        `s0`; `holder` is the state's name."""
        self.states.append(holder)
        return f"s{len(self.states) - 1}"

    def solve(self) -> LookingSolution:
        """Return the words of the analog plan on virtual registers.

        Raises GaveUp if no gates are found for a boundary, or if the chip has too few registers for
        scratch."""
        items: dict[int, tuple[Item, ...]] = {}
        scratch = 0
        # Without unchanging code the masked register stays unused: it changes only in pixels whose
        # mask register is 1, so that every write needs that register too.
        unused = self.target.masked_register is not None and not self.holders
        room = len(self.target.digital_registers) - unused - len(self.holders) - len(self.states)
        # Only encodings that are tried last may take more words, so that they replace no other.
        last = any(value_bits.kind == COUNTER for value_bits in self.encoding.states)
        # The last boundary fails first if registers are missing.
        for moment in reversed(self.plan.moments):  # most states, so most scratch, at the end
            moment_items = _Moment(self, moment).items()
            if last and _scratch(moment_items) > room:
                moment_items = _Moment(self, moment, few=True).items()
            if moment_items:
                items[moment.boundary] = tuple(moment_items)
            scratch = max(scratch, _scratch(moment_items))
            if scratch > room:
                raise GaveUp("no register is left for scratch")
        start = self.machine.start_nodes()
        contents = self.vectors(start)
        planes = tuple(contents[f"p{i}"] for i in range(len(self.holders)))
        return LookingSolution(
            self.encoding,
            planes,
            holders=tuple(self.holders),
            states=tuple(self.states),
            registers=self.registers,
            scratch=scratch,
            items=dict(reversed(items.items())),
        )

    def vectors(self, nodes: Indices) -> dict[str, int]:
        """Return the content of every register by name, for lanes that are at these nodes of the
        state machine, one node for each lane.

        A content is a truth vector: an integer with one bit for each lane (a simulated pixel)."""
        contents = dict(
            zip(
                self.code,
                self._columns(self.encoding.code, self.machine.behaviour[nodes]),
                strict=True,
            )
        )
        for k, (value_bits, names) in enumerate(
            zip(self.encoding.states, self.registers, strict=True)
        ):
            contents |= zip(
                names, self._columns(value_bits, self.machine.values[nodes, k]), strict=True
            )
        return contents

    def _columns(self, value_bits: ValueBits, values: NDArray[np.signedinteger]) -> list[int]:
        """Return the contents of the registers that hold `values`, one value for each lane (a
        simulated pixel), in the order of the encoding's bits.

        A content is a truth vector: an integer with one bit for each lane. All values must be among
        those of `value_bits`."""
        order = np.argsort(value_bits.values)
        rows = order[np.searchsorted(np.array(value_bits.values)[order], values)]
        return columns(value_bits.bits[rows])


class _Moment:
    """The words of one boundary, under construction, in `emitted`.

    `contents` are what registers hold now, and `new_values` the truth vectors that the boundary
    must write, by register. A truth vector is an integer with one bit for each simulated pixel."""

    def __init__(self, solver: Solver, moment: Moment, *, few: bool = False) -> None:
        """Compute the register contents before the boundary of `moment`, and the new values that
        its gates must write.

        `solver` has the analog plan and the registers of codes and states. With `few`, gates take
        fewer scratch registers (for intermediate results), and more words."""
        self.solver, self.moment, self.plan = solver, moment, solver.plan
        self.target = solver.target
        self.contents = RegisterContents(
            solver.gates, moment.everything, solver.vectors(moment.before), few=few
        )
        after = solver.vectors(moment.after)
        self.new_values = {name: v for name, v in after.items() if v != self.contents.values[name]}
        self.emitted: list[Item] = []
        self.sampled = False
        """Whether the scratch register holds -PIX in every pixel."""

    def items(self) -> list[Item]:
        """Return the words and gates of the boundary, in order; call it once.

        First come comparisons, then buckets that close, resets, buckets that open, and new values
        of registers. Raises GaveUp if no gates are found."""
        # The answer of each comparison goes to a register, the last answer to FLAG.
        moment = self.moment
        order = self.plan.machine.order(moment.boundary)
        signal: int | None = None
        for position, number in enumerate(order):
            comparison = moment.comparisons[number]
            if comparison.signal != signal:
                signal = comparison.signal
                self._take_signal(comparison)
            # A comparison would act only where the last one answered yes.
            elif self.target.where_obeys_flag:
                self.emitted.append(op("all"))
            self.emitted.append(SetIn(comparison.level))
            self.emitted.append(op("where", (), (*self.plan.scratched, "IN")))
            self.contents.values[FLAG] = moment.below(number)
            if position + 1 < len(order):
                self.contents.copy_to_scratch(FLAG)
                self.emitted += self.contents.pop_gates()
                del self.contents.values[FLAG]
        plan, registers = self.plan, self.plan.bucket_registers
        falls: list[tuple[int, tuple[Op, ...]]] = []
        for register, v, copied in zip(registers, moment.falls, moment.copies, strict=True):
            # register += PIX - reset level, or a copy of it into an empty register
            first = plan.sampled() if copied else plan.sampled(register)
            falls.append((v, (first, op("bus", (register,), plan.scratched))))
        rises: list[tuple[int, tuple[Op, ...]]] = []
        for register, v in zip(registers, moment.rises, strict=True):
            # register -= PIX - reset level
            first = plan.register_to_scratch(register)
            rises.append((v, (first, op("bus", (register,), (plan.scratch, "PIX")))))
        pending = [*falls, (moment.resets, RESET), *rises]
        while pending:
            v, words = pending.pop(0)
            if not v:
                continue
            # The reset acts in every pixel, whatever FLAG is.
            if words is RESET and self.target.reset_honours_flag == "no":
                self.emitted += RESET
                self.sampled = False
                continue
            self._load(
                v,
                [predicate for predicate, _ in pending if predicate not in (0, moment.everything)],
            )
            if words is RESET:
                self.sampled = False
            # The scratch register still holds -PIX: one word less.
            elif self.sampled and words[0] == self.plan.sampled():
                words = words[1:]
            else:
                self.sampled = v == moment.everything and words[0] == self.plan.sampled()
            self.emitted += words
        counters = {}
        for held, names in zip(self.solver.encoding.states, self.solver.registers, strict=True):
            if held.kind == COUNTER and (steps := steps_of(self.contents, names, self.new_values)):
                counters[names] = steps
        rippled = {name for names in counters for name in names}
        write_simultaneously(
            self.contents, {r: v for r, v in self.new_values.items() if r not in rippled}
        )
        for names, steps in counters.items():
            count(self.contents, names, steps)
        self.emitted += self.contents.pop_gates()
        return renamed(self.emitted)

    def _take_signal(self, comparison: Comparison) -> None:
        """Append words that write the negative signal of a comparison to the registers `scratched`
        of the analog plan. The sum of these registers is the negative signal.

        The signal of a bucket that is open includes the light that the bucket has not taken yet.
        Raises GaveUp if no gates tell in which pixels the bucket is open."""
        self.emitted.append(op("all"))
        if comparison.signal == LIGHT:
            self.emitted.append(self.plan.sampled())
            self.sampled = True
            return
        moment, bucket = self.moment, comparison.signal
        register = self.plan.bucket_registers[bucket]
        opens = self.plan.machine.opens[moment.before, bucket, moment.boundary - 1]
        running = self.plan.sampled(register)
        self.sampled = False
        if opens.all():
            self.emitted.append(running)
            return
        # Pixels in which the bucket is closed keep this; the others add their light where FLAG is
        # 1.
        self.emitted.append(self.plan.register_to_scratch(register))
        if opens.any():
            sequence = self.contents.shortest_gates_to_flag(vector(np.flatnonzero(opens)))
            if sequence is None:
                raise GaveUp("no gates tell which shutters are open")
            self.emitted += sequence.gates
            self.emitted.append(running)
            if self.target.where_obeys_flag:
                self.emitted.append(op("all"))

    def _load(self, v: int, later: Sequence[int]) -> None:
        """Append gates that write the truth vector `v` (an integer with one bit for each lane) to
        FLAG (the bit that lets a pixel act), and save what FLAG holds if it is needed later.

        `later` are the vectors that FLAG must have after this. Raises GaveUp if no gates are found.
        """
        contents = self.contents
        if v == self.moment.everything:
            if contents.values.get(FLAG) != v:
                self._save_flag(later, ())
                self.emitted += [*contents.pop_gates(), op("all")]
                contents.values[FLAG] = v
            return
        for name, new in self.new_values.items():
            # A register without a value takes its new value at once, and FLAG reads it there.
            if new == v and not contents.values[name]:
                sequence = contents.shortest_gates(v, name)
                if sequence is not None:
                    contents.take(sequence, (name, v))
        sequence = contents.shortest_gates_to_flag(v)
        # The copy of FLAG occupies a scratch register, so the gates are then chosen again.
        if sequence and sequence.gates and self._save_flag(later, sequence.scratch):
            sequence = contents.shortest_gates_to_flag(v)
        if sequence is None:
            raise GaveUp("the registers do not tell the lanes of a look apart")
        contents.take(sequence, (FLAG, v))
        self.emitted += contents.pop_gates()

    def _save_flag(self, later: Sequence[int], written: Sequence[tuple[str, int]]) -> bool:
        """Copy FLAG (the bit that lets a pixel act) to a scratch register if no other register
        could give what depends on it; return whether it was copied.

        The truth vectors `later`, which FLAG must have later, and the new values of registers
        depend on it. `written` are pairs (scratch register that is about to be written, truth
        vector). Return False if the content of FLAG is unknown. A truth vector is an integer with
        one bit for each simulated pixel. A scratch register holds an intermediate result."""
        contents = self.contents
        if FLAG not in contents.values:
            return False
        without = contents.copy()
        del without.values[FLAG]
        without.values.update(written)
        if without.distinguishes([*later, *self.new_values.values()]):
            return False
        contents.copy_to_scratch(FLAG)
        return True


def _scratch(items: Sequence[Item]) -> int:
    """Return the number of scratch registers (for intermediate results) that gates write."""
    gates = (item for item in items if isinstance(item, Gate))
    numbers = [int(gate.destination[1:]) for gate in gates if gate.destination.startswith("t")]
    return max(numbers, default=-1) + 1


def renamed(gates: Sequence[Item]) -> list[Item]:
    """Return the same gates with as few scratch registers (for intermediate results) as the values
    that are alive at once need.

    Scratch registers are those whose names begin with "t"; the new ones are t0, t1 and so on. The
    words between the gates read no scratch registers."""
    ends: dict[tuple[str, int], int] = {}
    writes: dict[str, int] = {}
    for gate_index, gate in enumerate(gates):
        if not isinstance(gate, Gate):
            continue
        for name in gate.sources:
            if name in writes:
                ends[name, writes[name]] = gate_index
        if gate.destination.startswith("t") and gate.destination not in gate.sources:
            writes[gate.destination] = gate_index
            ends[gate.destination, gate_index] = gate_index
        # This gate changes a scratch register that it also reads, so the old name stays.
        elif gate.destination in writes:
            ends[gate.destination, writes[gate.destination]] = gate_index
    renamed_items: list[Item] = []
    names: dict[str, str] = {}
    busy: dict[str, int] = {}
    for gate_index, gate in enumerate(gates):
        if not isinstance(gate, Gate):
            renamed_items.append(gate)
            continue
        # A register is free after the last gate that reads it.
        busy = {name: end for name, end in busy.items() if end >= gate_index}
        sources = tuple(names.get(name, name) for name in gate.sources)
        destination = gate.destination
        if (destination, gate_index) in ends:
            number = 0
            while f"t{number}" in busy:
                number += 1
            names[destination] = f"t{number}"
            busy[f"t{number}"] = ends[destination, gate_index]
        renamed_items.append(Gate(gate.name, names.get(destination, destination), sources))
    return renamed_items
