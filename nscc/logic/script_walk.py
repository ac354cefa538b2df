"""Execution of a scripted frame, and search for the cheapest gates for each demand.

A script defines the planes and the gates that run before each demand (inversions, state updates).
The walk runs them on truth vectors, so it knows the content of every register. It meets each demand
by an OR of values and new cubes, or by the complement of one. Cubes that serve later demands stay
in scratch registers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import chain

from nscc.logic.cover import Cover, Covers, life
from nscc.logic.cubes import Budget
from nscc.logic.digits import unzipped
from nscc.logic.problem import (
    MASK,
    Gate,
    Gates,
    GaveUp,
    Machine,
    Problem,
    Segment,
    Solution,
    masked_destination,
    quietest,
)
from nscc.logic.script import Script
from nscc.record import Record
from nscc.truth import union


class _Choice(Record):
    """A cover of a demand, or of its complement if `inverted`, over the values of the registers
    `names`.

    If `turned` is not None, the last name stands for the inverse of the register `turned`, which
    must be computed first. `price` is the number of words, with shares of cubes (NORs of registers)
    that later demands reuse. A demand is a set of shutters that FLAG must select at a boundary."""

    cover: Cover
    names: tuple[str, ...]
    turned: str | None
    inverted: bool
    price: float


_TURNED = "turned"

# Words for a demand below which no other kind of cover is tried (a NOR, a WHERE and a share of a
# lasting cube), and above which one is.
_GOOD_PRICE = 2.5
_DEAR = 4.0

# Number of following demands for the life of a cube: the longest horizon of `cover`.
_AHEAD = 64


def walk(problem: Problem, machine: Machine, script: Script, steps: int) -> Iterator[Solution]:
    """Yield the solution of a script, found in `steps` of search.

    Nothing is yielded if the script leaves too few registers, if a demand cannot be met, or if the
    steps are used up. A demand is a set of shutters that FLAG must select at a boundary."""
    scratch = machine.registers - len(script.planes) - script.states
    if scratch >= 0:
        script = _within_fan_in(script, machine)
        covers = Covers(problem.everything, machine.or_sources, Budget(steps))
        with suppress(GaveUp):
            yield _Walker(problem, machine, script, scratch, covers).solution()


def _within_fan_in(script: Script, machine: Machine) -> Script:
    """Return the script with every gate of too many sources divided into several; the same script
    if there is no limit or no such gate. WHERE stays as it is."""
    limit = machine.or_sources
    if limit is None or all(len(g.sources) <= limit for g in _all_gates(script)):
        return script
    gates = Gates(machine)

    def narrow(segment: Segment) -> Segment:
        """Return the segment (gates that run together) with every OR and NOR of too many sources
        divided into several gates."""
        for gate in segment:
            if len(gate.sources) <= limit or gate.name == "WHERE":
                gates.add(gate)
            elif gate.name == "NOR":
                gates.nor(gate.destination, gate.sources, gate.masked)
            else:
                gates.or_(gate.destination, gate.sources, gate.masked)
        return gates.take()

    def all_of(run: tuple[Segment, ...]) -> tuple[Segment, ...]:
        """Return segments (groups of gates that run together) in which no gate reads more sources
        than the machine allows."""
        return tuple(narrow(segment) for segment in run)

    return replace(
        script,
        opening=all_of(script.opening),
        before={i: all_of(run) for i, run in script.before.items()},
        closing=all_of(script.closing),
    )


def _all_gates(script: Script) -> Iterator[Gate]:
    """Yield all gates that a script itself contains."""
    runs = (script.opening, *script.before.values(), script.closing)
    return chain.from_iterable(chain.from_iterable(runs))


@dataclass
class _Walker:
    """One run through a script's demands (sets of shutters that FLAG must select at boundaries);
    make a new one for each run.

    `scratch` is the number of scratch registers. `values` are the known truth vectors (integers
    with one bit for each shutter) of registers by name, now. `quiet` is the name of the register
    that is in the masked register, empty if none is. `used` is the number of scratch registers used
    so far."""

    problem: Problem
    machine: Machine
    script: Script
    scratch: int
    covers: Covers
    values: dict[str, int] = field(default_factory=dict)
    quiet: str = ""
    used: int = 0

    def solution(self) -> Solution:
        """Run the script and return the gates for every demand (a set of shutters that FLAG must
        select at a boundary).

        Raises GaveUp if a demand has no cover within the scratch registers, if the script reads an
        unknown value or does not restore its planes, or if the steps are used up. A scratch
        register holds an intermediate result."""
        script, problem = self.script, self.problem
        self.gates = Gates(self.machine)
        writes = Counter(gate.destination for gate in _all_gates(script))
        masked = masked_destination(_all_gates(script))
        if masked is not None:
            self.quiet = masked
        elif self.machine.masked and script.planes:
            self.quiet = f"p{quietest([writes[f'p{i}'] for i in range(len(script.planes))])}"
        planes, holders = unzipped(script.planes)
        self.values = {f"p{i}": vector for i, vector in enumerate(planes)}
        self._run(script.opening)
        answers: list[tuple[Segment, ...]] = []
        for i, demand in enumerate(problem.demands):
            # After analog words or a refresh, the content of a register is unknown.
            if not demand.flag_kept:
                self.values.pop("FLAG", None)
            if not demand.scratch_kept:
                self.values = {k: v for k, v in self.values.items() if k[0] != "t"}
            scripted = script.before.get(i, ())
            self._run(scripted)
            if self.values.get("FLAG") != demand.predicate:
                scripted = (*scripted, self._answer(i))
            answers.append(scripted)
        self.values.pop("FLAG", None)
        if not problem.flag_lasts:
            self.values = {k: v for k, v in self.values.items() if k[0] != "t"}
        self._run(script.closing)
        for i, vector in enumerate(planes):
            if self.values[f"p{i}"] != vector:
                raise GaveUp("the script does not restore its planes")
        return Solution(
            script.encoding,
            planes,
            holders,
            script.states,
            self.used,
            script.opening,
            tuple(answers),
            script.closing,
        )

    def _run(self, segments: Sequence[Segment]) -> None:
        """Update the truth vectors (integers with one bit for each shutter) of registers by the
        script's own gates.

        Raises GaveUp if a gate reads an unknown value or needs another scratch register (for
        intermediate results)."""
        for gate in chain.from_iterable(segments):
            for name in gate.reads:
                if name not in self.values:
                    raise GaveUp(f"the script reads {name}, which holds nothing known")
            self.values[gate.destination] = gate.result(self.values, self.problem.everything)
            if gate.destination == self.quiet and not gate.masked:
                # Its mask is set for the write.
                self.values.pop(MASK, None)
            if gate.destination.startswith("t"):
                self._use(gate.destination)
                if self.used > self.scratch:
                    raise GaveUp("the script needs more scratch registers than there are")

    def _use(self, scratch: str) -> None:
        """Count a scratch register (for intermediate results) as used."""
        self.used = max(self.used, int(scratch[1:]) + 1)

    def _answer(self, index: int) -> Segment:
        """Return the gates for demand `index`, from the cheapest cover for which registers suffice;
        update the values.

        Covers use all registers, then planes and states only, which frees scratch registers (for
        intermediate results); one value may be inverted first. Raises GaveUp if there is no cover.
        A demand is a set of shutters that FLAG must select at a boundary."""
        problem = self.problem
        ahead = [d.predicate for d in problem.demands[index : index + _AHEAD]]
        against = [problem.everything & ~predicate for predicate in ahead]
        steady = [name for name in self.values if name[0] in "ps"]
        choices: list[_Choice] = []
        for names in (list(self.values), steady):
            choices += self._covers(names, None, ahead, against)
            if choices and min(c.price for c in choices) <= _GOOD_PRICE:
                break
        # An inverted value takes a register, and so does a cube or a complement.
        if self.scratch > 1 and min((c.price for c in choices), default=_DEAR) >= _DEAR:
            for name in steady:
                choices += self._covers(steady, name, ahead, against)
        choices.sort(key=lambda c: c.price)
        for choice in choices:
            before = dict(self.values), self.used
            try:
                self._emit(choice, against if choice.inverted else ahead)
            except GaveUp:
                self.values, self.used = before
                self.gates.take()
                continue
            return self.gates.take()
        raise GaveUp(f"demand {index} has no cover of one-word cubes")

    def _covers(
        self, names: list[str], turned: str | None, ahead: Sequence[int], against: Sequence[int]
    ) -> Iterator[_Choice]:
        """Yield a cover of a demand and one of its complement, where there is one, by the values of
        the registers `names` and, unless `turned` is None, the inverse of the register `turned`.

        `ahead` are the predicates of this and the next demands (sets of shutters that FLAG must
        select at boundaries), `against` their complements. FLAG is the bit that lets a pixel act.
        """
        values = [self.values[name] for name in names]
        scratch = self.scratch
        if turned is not None:
            names = [*names, _TURNED]
            values.append(self.problem.everything & ~self.values[turned])
            scratch -= 1
        extra = turned is not None
        for inverted, predicates in ((False, ahead), (True, against)):
            if inverted and not scratch:
                continue
            usable = [inverted or n != "FLAG" or self.machine.where_reads_flag for n in names]
            cover = self.covers.find(values, usable, predicates, scratch)
            if cover is not None:
                # The price has a word for WHERE, one for the NOR of a complement, one more if that
                # NOR must overwrite a cube in place, and one for the inverse of a value.
                full = inverted and len(cover.cubes) >= scratch
                yield _Choice(
                    cover, tuple(names), turned, inverted, cover.cost + 1 + inverted + full + extra
                )

    def _emit(self, choice: _Choice, ahead: Sequence[int]) -> None:
        """Append the gates of a cover for one demand (a set of shutters that FLAG must select at a
        boundary), which load FLAG; its cubes overwrite the scratch values that are needed last.

        `ahead` are the predicates of this and the next demands (inverted, if the cover is), which
        decide what is needed. Raises GaveUp if no register is free; the gates and values are then
        incomplete, and the caller restores them. A cube is a NOR of registers."""
        names = list(choice.names)
        # Cubes that read scratch come first, because later ones may overwrite it; then those with
        # most sources, whose registers are most likely overwritten.
        cubes = sorted(
            choice.cover.cubes,
            key=lambda c: (-sum(names[k][0] == "t" for k in c.sources), -len(c.sources)),
        )
        positive = [names[k] for k in choice.cover.positive]
        waiting = [{names[k] for k in cube.sources} for cube in cubes]
        if choice.turned is not None:
            register = self._free(set(positive).union(*waiting), ahead)
            if register is None:
                raise GaveUp("no register is left to compute with")
            self._gate("NOR", register, [choice.turned])
            names[-1] = register
            positive = [register if n == _TURNED else n for n in positive]
            waiting = [
                {register if n == _TURNED else n for n in needed_names} for needed_names in waiting
            ]
        terms = positive
        for n, cube in enumerate(cubes):
            needed = set().union(*waiting[n + 1 :])
            sources = [names[k] for k in cube.sources]
            target = self._free(needed | set(terms) | set(sources), ahead)
            if target is None:
                # In place, over a source that nothing else reads.
                over = [s for s in sources if s[0] == "t" and s not in needed and s not in terms]
                target = next(iter(over), None)
            if target is None:  # combine two terms
                loose = [t for t in terms if t[0] == "t" and t not in needed | set(sources)]
                if len(loose) < 2:
                    raise GaveUp("no register is left to compute with")
                into, target, *_ = loose
                self._gate("OR", into, [into, target])
                terms = [t for t in terms if t != target]
            self._gate("NOR", target, sources)
            terms = [*terms, target]
        if not choice.inverted:
            self._load_flag(terms)
            return
        free = self._free(set(terms), ahead)
        free = free or next(t for t in reversed(terms) if t[0] == "t")
        self._gate("NOR", free, terms)
        self._load_flag([free])

    def _free(self, busy: set[str], ahead: Sequence[int]) -> str | None:
        """Return the scratch register, not in `busy`, whose value serves the fewest of the next
        demands (sets of shutters that FLAG must select at boundaries); a register that holds
        nothing serves none.

        `ahead` are the predicates of this and the next demands. Of equal registers the lowest is
        taken. None if all scratch registers (for intermediate results) are in `busy`."""

        def missed(name: str) -> int:
            """Return how many of the next demands, one after the other, can still use the value of
            a register; 0 if it holds none. A demand is a set of shutters that FLAG must select at a
            boundary."""
            vector = self.values.get(name)
            return life(vector, ahead[1:]) if vector else 0

        names = [name for k in range(self.scratch) if (name := f"t{k}") not in busy]
        return min(names, key=missed, default=None)

    def _gate(self, kind: str, destination: str, sources: Sequence[str]) -> None:
        """Append a gate of this `kind` (OR or NOR) from `sources` to `destination`, and compute the
        new content of `destination`."""
        inverted = kind == "NOR"
        (self.gates.nor if inverted else self.gates.or_)(destination, sources)
        self.values[destination] = self._or(sources, inverted)
        self._use(destination)

    def _or(self, sources: Sequence[str], inverted: bool) -> int:
        """Return the truth vector (an integer with one bit for each shutter) of the OR of the
        registers `sources`, or of their NOR if `inverted`. All their values must be known."""
        value = union(self.values[name] for name in sources)
        return self.problem.everything & ~value if inverted else value

    def _load_flag(self, sources: Sequence[str]) -> None:
        """Append the gates that load FLAG (the bit that lets a pixel act) with the OR of the
        registers `sources`, and compute its content.

        If WHERE takes fewer sources, a scratch register gathers some first, which overwrites it;
        its content is then unknown. Raises GaveUp if no register is free. A scratch register holds
        an intermediate result."""
        limit = self.machine.where_sources
        spare = None
        if limit is not None and len(sources) > limit:
            scratch_sources = [s for s in sources if s.startswith("t")]
            spare = scratch_sources[0] if scratch_sources else self._free(set(sources), [])
            if spare is None:
                raise GaveUp("no register to gather the sources of WHERE")
        value = self._or(sources, False)
        self.gates.load_flag(sources, spare)
        if spare is not None:
            # It may hold an OR of some sources now, which is not followed.
            self.values.pop(spare, None)
            self._use(spare)
        self.values["FLAG"] = value
