"""A walk through the frame: scripted gates, and the cheapest answers found between them.

A script says what the planes hold at the start and which gates run before each demand (planes
turned over, states brought forward). The walk runs them on truth vectors, so it knows what every
register holds, and answers each demand from what stands there: by an OR of values and new cubes,
or by the complement of one. Cubes that serve demands to come stay in scratch registers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from nscc.logic.cover import Cover, find_cover, life
from nscc.logic.cubes import Budget
from nscc.logic.gates import Gates
from nscc.logic.problem import Gate, GaveUp, Machine, Problem, Segment, Solution


@dataclass(frozen=True)
class Script:
    """An encoding and the gates that do not depend on how demands are answered.

    `before[i]` runs before demand i is answered; it may use states and the scratch registers
    t0 .. t(reserved - 1), which lose what they hold, and FLAG where `writes_flag`.
    """

    encoding: str
    planes: tuple[int, ...]
    holders: tuple[str, ...]
    states: int
    opening: tuple[Segment, ...]
    before: dict[int, tuple[Segment, ...]]
    closing: tuple[Segment, ...]
    state_in_flag: bool = False


# Demands ahead of the one at hand that a cube's life is counted over.
_AHEAD = 64


def walk(problem: Problem, machine: Machine, script: Script, budget: Budget) -> Solution:
    """The solution of a script; raises GaveUp where some demand cannot be answered."""
    held = len(script.planes) + script.states
    scratch = machine.registers - held
    written = {g.destination for g in _all_gates(script)}
    planes = {f"p{i}" for i in range(len(script.planes))}
    if scratch < 0:
        raise GaveUp(f"{held} planes and states are more than {machine.registers} registers")
    if machine.masked and scratch > 1 and planes <= written:
        scratch -= 1  # only a plane that never changes may live in the masked register
    walker = _Walker(problem, machine, script, scratch, budget)
    return walker.solution()


def _all_gates(script: Script) -> list[Gate]:
    segments = [*script.opening, *script.closing]
    for run in script.before.values():
        segments.extend(run)
    return [gate for segment in segments for gate in segment]


@dataclass
class _Walker:
    problem: Problem
    machine: Machine
    script: Script
    scratch: int
    budget: Budget
    values: dict[str, int] = field(default_factory=dict)
    used: int = 0

    def solution(self) -> Solution:
        """Runs the script and answers every demand."""
        script, problem = self.script, self.problem
        self.gates = Gates(self.machine)
        self.values = {f"p{i}": vector for i, vector in enumerate(script.planes)}
        if script.state_in_flag:
            self.values["FLAG"] = problem.everything
        self._run(script.opening)
        answers: list[tuple[Segment, ...]] = []
        for i, demand in enumerate(problem.demands):
            if not (demand.flag_kept or script.state_in_flag):
                self.values.pop("FLAG", None)
            scripted = script.before.get(i, ())
            self._run(scripted)
            if self.values.get("FLAG") == demand.predicate:
                answers.append(scripted)
                continue
            answers.append((*scripted, self._answer(i)))
        self.values.pop("FLAG", None)
        self._run(script.closing)
        for i, vector in enumerate(script.planes):
            if self.values[f"p{i}"] != vector:
                raise GaveUp("the script does not restore its planes")
        return Solution(
            script.encoding, script.planes, script.holders, script.states, self.used,
            script.opening, tuple(answers), script.closing, script.state_in_flag,
        )  # fmt: skip

    def _run(self, segments: Sequence[Segment]) -> None:
        for segment in segments:
            for gate in segment:
                self._do(gate)

    def _do(self, gate: Gate) -> None:
        """Brings the truth vectors up to date."""
        union = 0
        for name in gate.sources:
            union |= self.values[name]
        inverted = gate.name in ("NOT", "NOR", "SET")
        everything = self.problem.everything
        self.values[gate.destination] = everything & ~union if inverted else union
        if gate.destination.startswith("t"):
            number = int(gate.destination[1:]) + 1
            if number > self.scratch:
                raise GaveUp("the script needs more scratch registers than there are")
            self.used = max(self.used, number)

    def _answer(self, index: int) -> Segment:
        problem = self.problem
        ahead = [d.predicate for d in problem.demands[index : index + _AHEAD]]
        everything = problem.everything
        against = [everything & ~predicate for predicate in ahead]
        names = list(self.values)
        values = [self.values[name] for name in names]
        keep = self.scratch > 1
        direct = find_cover(
            values, [n != "FLAG" or self.machine.where_reads_flag for n in names],
            ahead, everything, self.scratch, self.budget, keep,
        )  # fmt: skip
        other = find_cover(
            values, [True] * len(names), against, everything, self.scratch, self.budget, keep
        )
        price = self._price(direct, False), self._price(other, True)
        if direct is not None and price[0] <= price[1]:
            self._emit(direct, names, ahead, inverted=False)
        elif other is not None:
            self._emit(other, names, against, inverted=True)
        else:
            raise GaveUp(f"demand {index} has no cover of one-word cubes")
        segment = self.gates.take()
        return segment

    def _price(self, cover: Cover | None, inverted: bool) -> float:
        if cover is None:
            return float("inf")
        if not inverted:
            return cover.cost + 1
        if not self.scratch:
            return float("inf")
        in_place = 1 if len(cover.cubes) >= self.scratch else 0
        return cover.cost + 2 + in_place

    def _emit(
        self, cover: Cover, names: Sequence[str], ahead: Sequence[int], *, inverted: bool
    ) -> None:
        """Gates of a cover. New cubes go where the values are that are missed last."""
        sources = [names[i] for i in cover.positive]
        # A scratch value may be a source of a cube that is still to come.
        wanted = set(sources)
        cubes = sorted(cover.cubes, key=lambda c: -len(c.sources))
        waiting = [{names[k] for k in cube.sources} for cube in cubes]
        terms: list[str] = []
        for n, cube in enumerate(cubes):
            later = set().union(*waiting[n + 1 :])
            target = self._place(wanted | set(terms) | later, ahead)
            self._gate("NOR", target, [names[k] for k in cube.sources])
            terms.append(target)
        if not inverted:
            self._where([*sources, *terms])
            return
        free = self._place_or_none(wanted | set(terms), ahead)
        if free is None:
            free = terms[-1] if terms else "t0"
        self._gate("NOR", free, [*sources, *terms])
        self._where([free])

    def _place_or_none(self, busy: set[str], ahead: Sequence[int]) -> str | None:
        """A scratch register that is free, or whose value is missed last; None if all are busy."""
        best: str | None = None
        least = 0
        for k in range(self.scratch):
            name = f"t{k}"
            if name in busy:
                continue
            vector = self.values.get(name)
            missed = 0
            if vector is not None:
                missed = life(vector, ahead[1:]) if vector else 0
            if best is None or missed < least:
                best, least = name, missed
        return best

    def _place(self, busy: set[str], ahead: Sequence[int]) -> str:
        name = self._place_or_none(busy, ahead)
        if name is None:
            raise GaveUp("no register is left to compute with")
        return name

    def _gate(self, kind: str, destination: str, sources: Sequence[str]) -> None:
        if kind == "NOR":
            self.gates.nor(destination, sources)
        else:
            self.gates.or_(destination, sources)
        union = 0
        for name in sources:
            union |= self.values[name]
        everything = self.problem.everything
        self.values[destination] = everything & ~union if kind == "NOR" else union
        self.used = max(self.used, int(destination[1:]) + 1)

    def _where(self, sources: Sequence[str]) -> None:
        limit = self.machine.where_sources
        spare = None
        if limit is not None and len(sources) > limit:
            held = [s for s in sources if s.startswith("t")]
            spare = held[0] if held else self._place_or_none(set(sources), [])
            if spare is None:
                raise GaveUp("no register to gather the sources of WHERE")
        union = 0
        for name in sources:
            union |= self.values[name]
        self.gates.where(sources, spare)
        if spare is not None:
            self.values.pop(spare, None)
        self.values["FLAG"] = union
