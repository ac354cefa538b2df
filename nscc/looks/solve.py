"""Words on virtual registers for every moment of a plan, with one encoding."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.logic.problem import Gate, GaveUp, Machine
from nscc.looks.encode import Encoding, Held
from nscc.looks.plan import LookingPlan, Moment
from nscc.looks.synthesis import FLAG, Board, update
from nscc.lower.plan import RESET
from nscc.operations import Op, op
from nscc.truth import columns, vector
from nscc.words.machine import LIGHT, Comparison


@dataclass(frozen=True, slots=True)
class SetIn:
    """IN is `level` steps from here on."""

    level: int


Item = Gate | Op | SetIn


@dataclass(frozen=True, eq=False)
class LookingSolution:
    """The words of a frame on virtual registers, by boundary.

    p0, p1, .. hold what outlasts a frame: `planes` (behaviours,) are their truth vectors when the
    first one starts; s0, s1, .. states inside a frame, which start at 0; t0, .. are scratch.
    `registers` names the virtual registers of each state, in the order of the encoding's bits.
    """

    encoding: Encoding
    planes: tuple[int, ...]
    holders: tuple[str, ...]
    states: tuple[str, ...]
    registers: tuple[tuple[str, ...], ...]
    scratch: int
    items: dict[int, tuple[Item, ...]]


def room_of(target: Target, planes: int) -> int:
    """The digital registers that a program with so many planes has: without code that rests, the
    masked register stays unused, since every write to it needs its mask."""
    return len(target.digital_registers) - (target.masked_register is not None and not planes)


def solve(plan: LookingPlan, encoding: Encoding, target: Target) -> LookingSolution:
    """The words of a plan. Raises GaveUp where no gates are found for some moment, or where they
    need more scratch than there are registers."""
    return _Solver(plan, encoding, target).solve()


class _Solver:
    def __init__(self, plan: LookingPlan, encoding: Encoding, target: Target) -> None:
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
                self._plane(held.name) if state.kept else self._state(held.name)
                for _ in range(held.registers)
            )
            for state, held in zip(self.machine.states, encoding.states, strict=True)
        )

    def _plane(self, holder: str) -> str:
        self.holders.append(holder)
        return f"p{len(self.holders) - 1}"

    def _state(self, holder: str) -> str:
        self.states.append(holder)
        return f"s{len(self.states) - 1}"

    def solve(self) -> LookingSolution:
        items: dict[int, tuple[Item, ...]] = {}
        scratch = 0
        room = room_of(self.target, len(self.holders)) - len(self.holders) - len(self.states)
        for moment in self.plan.moments:
            found = tuple(_Moment(self, moment).items())
            if found:
                items[moment.boundary] = found
            for item in found:
                if isinstance(item, Gate) and item.destination.startswith("t"):
                    scratch = max(scratch, int(item.destination[1:]) + 1)
            if scratch > room:
                raise GaveUp("no register is left for scratch")
        start = self.machine.start_nodes()
        held = self.vectors(start)
        planes = tuple(held[f"p{i}"] for i in range(len(self.holders)))
        return LookingSolution(
            self.encoding, planes, tuple(self.holders), tuple(self.states), self.registers,
            scratch, items,
        )  # fmt: skip

    def vectors(self, nodes: NDArray[np.intp]) -> dict[str, int]:
        """What every register holds in lanes at these nodes."""
        found = dict(
            zip(
                self.code,
                self._columns(self.encoding.code, self.machine.behaviour[nodes]),
                strict=True,
            )
        )
        for k, (held, names) in enumerate(zip(self.encoding.states, self.registers, strict=True)):
            found |= zip(names, self._columns(held, self.machine.values[nodes, k]), strict=True)
        return found

    def _columns(self, held: Held, values: NDArray[np.signedinteger]) -> list[int]:
        order = np.argsort(held.values)
        rows = order[np.searchsorted(np.array(held.values)[order], values)]
        return columns(held.bits[rows])


class _Moment:
    """The words of one moment."""

    def __init__(self, solver: _Solver, moment: Moment) -> None:
        self.solver, self.moment, self.plan = solver, moment, solver.plan
        self.target = solver.target
        self.board = Board(solver.gates, moment.everything, solver.vectors(moment.before))
        after = solver.vectors(moment.after)
        self.wanted = {name: v for name, v in after.items() if v != self.board.values[name]}
        self.found: list[Item] = []
        self.sampled = False
        """Whether the scratch register holds -PIX in every pixel."""

    def items(self) -> list[Item]:
        """What runs at this boundary."""
        self._compare()
        moment = self.moment
        falls = [(v, self._fall(b)) for b, v in enumerate(moment.falls)]
        rises = [(v, self._rise(b)) for b, v in enumerate(moment.rises)]
        asked = [*falls, (moment.resets, RESET), *rises]
        while asked:
            v, words = asked.pop(0)
            if not v:
                continue
            if words is RESET and self.target.reset_honours_flag == "no":
                self.found += RESET
                self.sampled = False
                continue
            self._load(v, [each for each, _ in asked if each not in (0, moment.everything)])
            if words is RESET:
                self.sampled = False
            elif self.sampled and words[0] == self.plan.sampled():
                words = words[1:]
            else:
                self.sampled = v == moment.everything and words[0] == self.plan.sampled()
            self.found += words
        update(self.board, self.wanted)
        self.found += self.board.taken()
        return renamed(self.found)

    def _fall(self, bucket: int) -> tuple[Op, ...]:
        """register += PIX - reset level, or := where it is empty."""
        plan, register = self.plan, self.plan.bucket_registers[bucket]
        first = plan.sampled() if self.moment.copies[bucket] else plan.sampled(register)
        return first, op("bus", (register,), plan.scratched)

    def _rise(self, bucket: int) -> tuple[Op, ...]:
        """register -= PIX - reset level."""
        plan, register = self.plan, self.plan.bucket_registers[bucket]
        return plan.kept(register), op("bus", (register,), (plan.scratch, "PIX"))

    def _compare(self) -> None:
        """Brings the outcome of each comparison into a register, that of the last one into FLAG."""
        moment = self.moment
        order = self.plan.machine.order(moment.boundary)
        signal: int | None = None
        for position, number in enumerate(order):
            comparison = moment.comparisons[number]
            if comparison.signal != signal:
                signal = comparison.signal
                self._take_signal(comparison)
            elif self.target.where_obeys_flag:
                self.found.append(op("all"))
            self.found.append(SetIn(comparison.level))
            self.found.append(op("where", (), (*self.plan.scratched, "IN")))
            self.board.values[FLAG] = moment.below(number)
            if position + 1 < len(order):
                self.board.keep(FLAG)
                self.found += self.board.taken()
                del self.board.values[FLAG]

    def _take_signal(self, comparison: Comparison) -> None:
        """Brings -signal into the scratch register of every pixel, or what adds up to it."""
        self.found.append(op("all"))
        if comparison.signal == LIGHT:
            self.found.append(self.plan.sampled())
            self.sampled = True
            return
        moment, bucket = self.moment, comparison.signal
        register = self.plan.bucket_registers[bucket]
        opens = self.plan.machine.opens[moment.before, bucket, moment.boundary - 1]
        running = self.plan.sampled(register)
        self.sampled = False
        if opens.all():
            self.found.append(running)
            return
        self.found.append(self.plan.kept(register))
        if opens.any():
            made = self.board.load(vector(np.flatnonzero(opens)))
            if made is None:
                raise GaveUp("no gates tell which shutters are open")
            self.found += made.gates
            self.found.append(running)
            if self.target.where_obeys_flag:
                self.found.append(op("all"))

    def _load(self, v: int, later: Sequence[int]) -> None:
        """Brings a vector into FLAG, and loses nothing that is still needed."""
        board = self.board
        if v == self.moment.everything:
            if board.values.get(FLAG) != v:
                self._save_flag(later, ())
                self.found += [*board.taken(), op("all")]
                board.values[FLAG] = v
            return
        for name, new in self.wanted.items():
            # A register that holds nothing yet takes its new value at once; FLAG reads it there.
            if new == v and not board.values[name]:
                made = board.make(v, name)
                if made is not None:
                    board.take(made, (name, v))
        made = board.load(v)
        if made is not None and made.gates:
            self._save_flag(later, made.scratch)
            made = board.load(v)
        if made is None:
            raise GaveUp("the registers do not tell the lanes of a look apart")
        board.take(made, (FLAG, v))
        self.found += board.taken()

    def _save_flag(self, later: Sequence[int], more: Sequence[tuple[str, int]]) -> None:
        """Copies FLAG into scratch if what comes later cannot be told without it."""
        board = self.board
        if FLAG not in board.values:
            return
        without = board.copy()
        del without.values[FLAG]
        without.values.update(more)
        if not without.tells([*later, *self.wanted.values()]):
            board.keep(FLAG)


def renamed(gates: Sequence[Item]) -> list[Item]:
    """The same gates with as few scratch registers as their values need while they are alive;
    what stands between them reads none."""
    ends: dict[tuple[str, int], int] = {}
    writes: dict[str, int] = {}
    for place, gate in enumerate(gates):
        if not isinstance(gate, Gate):
            continue
        for name in gate.sources:
            if name in writes:
                ends[name, writes[name]] = place
        if gate.destination.startswith("t") and gate.destination not in gate.sources:
            writes[gate.destination] = place
            ends[gate.destination, place] = place
        elif gate.destination in writes:
            ends[gate.destination, writes[gate.destination]] = place
    found: list[Item] = []
    names: dict[str, str] = {}
    busy: dict[str, int] = {}
    for place, gate in enumerate(gates):
        if not isinstance(gate, Gate):
            found.append(gate)
            continue
        # A register is free once the last gate that reads it is over.
        busy = {name: end for name, end in busy.items() if end >= place}
        sources = tuple(names.get(name, name) for name in gate.sources)
        destination = gate.destination
        if (destination, place) in ends:
            number = 0
            while f"t{number}" in busy:
                number += 1
            names[destination] = f"t{number}"
            busy[f"t{number}"] = ends[destination, place]
        found.append(Gate(gate.name, names.get(destination, destination), sources))
    return found
