"""Random solutions, and what the words of a solution do to pixels of every shutter.

Pixels are boolean arrays (replicas, shutters); the words are those that `nscc.lower.schedule` makes
of the gates, run on the registers of the chip with the rule of the masked one. Whatever a solution
may not rely on is random.
"""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path

import numpy as np

from nscc.chips.load import load_target
from nscc.chips.target import Target
from nscc.logic.problem import Demand, Gate, Machine, Problem, Solution
from nscc.lower.schedule import allocate, words

REPLICAS = 5


def chip(
    registers: int = 13,
    masked: bool = True,
    or_sources: int | None = None,
    where_sources: int | None = None,
    where_reads_flag: bool = False,
) -> Target:
    """A chip like SCAMP-5 with some of its digital half changed."""
    target = load_target("scamp5", Path())
    names = target.digital_registers
    target = replace(
        target,
        or_sources=or_sources,
        where_sources=where_sources,
        where_reads_flag=where_reads_flag,
    )
    if masked:
        return replace(target, digital_registers=(*names[: registers - 1], "R12"))
    return replace(
        target, digital_registers=names[:registers], mask_register=None, masked_register=None
    )


def rows_of(vector: int, shutters: int) -> np.ndarray:
    """A truth vector as bool (shutters,)."""
    return np.array([vector >> i & 1 for i in range(shutters)], dtype=bool)


class Chip:
    """Physical digital registers and FLAG of some pixels of every shutter."""

    def __init__(self, target: Target, shutters: int, seed: int) -> None:
        self.target = target
        self.shape = (REPLICAS, shutters)
        self.random = np.random.default_rng(seed)
        names = (*target.digital_registers, "FLAG")
        self.held = {name: self.noise() for name in names}
        self.bus: np.ndarray | None = None

    def noise(self) -> np.ndarray:
        """Random bits."""
        return self.random.random(self.shape) < 0.5

    def run(self, ops) -> int:
        """Runs words; returns how many."""
        for word in ops:
            name = word.name
            some = np.zeros(self.shape, dtype=bool)
            for source in word.sources:
                some = some | self.held[source]
            if name == "WHERE":
                limit = self.target.where_sources
                assert limit is None or len(word.sources) <= limit
                assert self.target.where_reads_flag or "FLAG" not in word.sources
                self.held["FLAG"] = some
                continue
            limit = self.target.or_sources
            assert limit is None or len(word.sources) <= max(limit, 1)
            if name.endswith(".read"):
                self.bus = ~some if name.startswith("NOR") else some
                continue
            if name.endswith(".write"):
                assert self.bus is not None
                some = self.bus
            else:
                assert not set(word.destinations) & set(word.sources)
                some = ~some if name in ("NOR", "NOT", "SET") else some
            for register in word.destinations:
                if register == self.target.masked_register:
                    mask = self.held[self.target.mask_register]
                    some = np.where(mask, some, self.held[register])
                self.held[register] = some
            self.bus = None
        return len(ops)


def words_of(solution: Solution, problem: Problem, target: Target, seed: int = 0) -> int:
    """Runs two frames of a solution; returns the words of one, with the refresh of planes that no
    word writes. Fails where a demand is not answered or a plane not restored."""
    allocation = allocate(solution, target)
    chip_registers = allocation.chip_registers
    used = len(solution.planes) + solution.states + solution.scratch
    assert len(set(chip_registers.values())) == len(chip_registers) == used
    pixels = Chip(target, problem.shutters, seed)
    held = pixels.held
    for i, plane in enumerate(solution.planes):
        row = rows_of(plane, problem.shutters)
        held[chip_registers[f"p{i}"]] = np.broadcast_to(row, pixels.shape).copy()
    code = {place: held[place].copy() for place in allocation.code_registers}
    scratch = [place for name, place in chip_registers.items() if name[0] == "t"]
    demands = problem.demands
    for _ in range(2):
        count = 0
        held["FLAG"] = pixels.noise()

        def run(segments) -> int:
            return sum(pixels.run(words(segment, allocation)) for segment in segments)

        count += run(solution.opening)
        for demand, answer in zip(demands, solution.answers, strict=True):
            if not demand.flag_kept:
                held["FLAG"] = pixels.noise()
            if not demand.scratch_kept:
                held.update({place: pixels.noise() for place in scratch})
            count += run(answer)
            assert (held["FLAG"] == rows_of(demand.predicate, problem.shutters)).all()
        held["FLAG"] = pixels.noise()
        if not problem.flag_lasts:
            held.update({place: pixels.noise() for place in scratch})
        count += run(solution.closing)
        assert all((held[place] == was).all() for place, was in code.items())
        held.update({place: pixels.noise() for place in scratch})
        held.update({chip_registers[f"s{i}"]: pixels.noise() for i in range(solution.states)})
    written = {gate.destination for segment in solution.segments() for gate in segment}
    return count + 2 * sum(f"p{i}" not in written for i in range(len(solution.planes)))


class _Writer:
    """Writes random gates down and follows what they do."""

    def __init__(self, choose: random.Random, machine: Machine, everything: int, sizes) -> None:
        self.choose = choose
        self.machine = machine
        self.everything = everything
        planes, states, scratch = sizes
        self.planes = [f"p{i}" for i in range(planes)]
        self.states = [f"s{i}" for i in range(states)]
        self.scratch = [f"t{i}" for i in range(scratch)]
        self.held: dict[str, int] = {}
        self.gates: list[Gate] = []
        self.writable = [*self.states, *self.scratch]

    def gate(self, name: str, destination: str, sources: tuple[str, ...]) -> None:
        some = 0
        for source in sources:
            some |= self.held[source]
        inverted = name in ("NOR", "NOT", "SET")
        value = some ^ (self.everything if inverted else 0)
        self.held[destination] = value
        self.gates.append(Gate(name, destination, sources))

    def sources(self, limit: int | None, banned: tuple[str, ...] = ()) -> tuple[str, ...]:
        known = [name for name in self.held if name not in banned]
        most = min(len(known), limit or 4)
        return tuple(sorted(self.choose.sample(known, self.choose.randint(1, most))))

    def some_gates(self, count: int) -> None:
        for _ in range(count):
            kind = self.choose.random()
            if kind < 0.15 and self.planes:
                plane = self.choose.choice(self.planes)
                self.gate("NOT", plane, (plane,))
                continue
            target = self.choose.choice(self.writable)
            if kind < 0.2:
                self.gate(self.choose.choice(["SET", "CLR"]), target, ())
                continue
            sources = self.sources(self.machine.or_sources)
            if len(sources) > 1:
                self.gate(self.choose.choice(["NOR", "NOR", "OR"]), target, sources)
            elif sources[0] != target:
                self.gate(self.choose.choice(["NOT", "MOV"]), target, sources)

    def flag(self) -> None:
        banned = () if self.machine.where_reads_flag else ("FLAG",)
        self.gate("WHERE", "FLAG", self.sources(self.machine.where_sources, banned))

    def take(self) -> tuple[tuple[Gate, ...], ...]:
        """The gates since the last call, in segments."""
        cut = self.choose.randint(0, len(self.gates))
        parts = (tuple(self.gates[:cut]), tuple(self.gates[cut:]))
        self.gates = []
        return tuple(part for part in parts if part)


def random_solution(seed: int, machine: Machine) -> tuple[Problem, Solution]:
    """A problem, and a legal but wasteful solution of it.

    It does not write the last plane, which is in the masked register.
    """
    choose = random.Random(seed)
    shutters = choose.randint(2, 40)
    everything = (1 << shutters) - 1
    states = choose.randint(0, 1)
    scratch = choose.randint(1, 2)
    planes = choose.randint(1, max(1, machine.registers - states - scratch))
    write = _Writer(choose, machine, everything, (planes, states, scratch))
    vectors = tuple(choose.getrandbits(shutters) for _ in range(planes))
    write.held = dict(zip(write.planes, vectors, strict=True))
    # The masked register goes to a plane that is never written.
    write.planes = write.planes[:-1] or write.planes
    if len(write.planes) == planes and planes + states + scratch == machine.registers:
        write.planes = []
    lasts = choose.random() < 0.7

    def some() -> None:
        if write.planes:
            write.some_gates(choose.randint(0, 6))

    some()
    opening = write.take()
    demands: list[Demand] = []
    answers = []
    boundary = 0
    for _ in range(choose.randint(1, 12)):
        kept = bool(demands) and choose.random() < 0.5
        now = boundary + choose.randint(0, 1)
        if not kept:
            write.held.pop("FLAG", None)
        quiet = lasts or now == boundary
        if not quiet:
            for name in write.scratch:
                write.held.pop(name, None)
        boundary = now
        some()
        write.flag()
        if write.held["FLAG"] in (0, everything):
            write.gate("WHERE", "FLAG", ("p0",))
        demands.append(Demand(boundary, "open", 0, write.held["FLAG"], kept, quiet))
        answers.append(write.take())
    for name in write.planes:
        if write.held[name] != vectors[int(name[1:])]:
            write.gate("NOT", name, (name,))
    closing = write.take()
    problem = Problem(tuple(demands), shutters, ((),), lasts, {})
    solution = Solution(
        "random",
        vectors,
        tuple(f"plane {i}" for i in range(planes)),
        states,
        scratch,
        opening,
        tuple(answers),
        closing,
    )
    return problem, solution
