"""A program lowered in one way, with its price."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc.cache.results import Result, Results
from nscc.logic.generate import solutions
from nscc.logic.problem import Demand, Machine, Problem, Solution
from nscc.lower.plan import ExposurePlan, Misfit, Step
from nscc.lower.schedule import Schedule, schedule
from nscc.lower.timeline import Before, Timeline, flag_actions, timeline
from nscc.program.program import Program
from nscc.truth import members
from nscc.words.container import DecodeTable
from nscc.words.operations import Effect

# Solutions, the best of each encoding, that are worth steps of improvement at each level.
MOST_IMPROVED = {0: 1, 1: 1, 2: 6, 3: 16}

# Times are sums of decimal fractions: a slot just as long as its words is long enough.
_ROUNDING = 1 + 1e-9


@dataclass(frozen=True)
class Lowered:
    """A plan, its gates and its words, priced against the program's target.

    `most_words` is the most words that the user allows at a boundary, None for any number.
    """

    program: Program
    plan: ExposurePlan
    solution: Solution
    schedule: Schedule
    time: Timeline
    analog_writes: tuple[int, int]
    most_words: int | None = None

    @cached_property
    def words_per_boundary(self) -> list[int]:
        """Words executed at each boundary 0..N."""
        return self.schedule.words_at(self.plan.slots)

    @cached_property
    def busy_us(self) -> list[float]:
        """Time that each boundary's words take."""
        return self.schedule.busy_us(self.plan.slots, self.program.target)

    @property
    def shortest_slot_us(self) -> float:
        """The shortest slot that any boundary's words leave possible, were all slots equal."""
        return max(self.busy_us[: self.plan.slots])

    @property
    def shortest_slot_launches(self) -> int:
        """Kernel launches whose overhead is part of `shortest_slot_us`."""
        boundary = self.busy_us.index(self.shortest_slot_us)
        # The frame's first launch comes before the exposure starts.
        return sum(n == boundary for n, _ in self.schedule.launches[1:])

    @property
    def frame_us(self) -> float:
        """Time from boundary 0's first word to boundary N's last."""
        return self.schedule.setup_us + self.time.boundary_us[-1] + self.busy_us[-1]

    @cached_property
    def late(self) -> list[int]:
        """Slots that are shorter than the words at their start."""
        slots = self.program.frame.slot_us
        return [n for n, slot_us in enumerate(slots) if self.busy_us[n] > slot_us * _ROUNDING]

    @cached_property
    def overfull(self) -> list[int]:
        """Boundaries that have more words than the user allows."""
        if self.most_words is None:
            return []
        return [n for n, words in enumerate(self.words_per_boundary) if words > self.most_words]

    @cached_property
    def overload(self) -> float:
        """How many times what it may be the fullest boundary is, in words or in time; 0 if none
        is too full."""
        slots = self.program.frame.slot_us
        ratios = [self.busy_us[n] / slots[n] for n in self.late]
        ratios += [self.words_per_boundary[n] / (self.most_words or 1) for n in self.overfull]
        return max(ratios, default=0.0)

    @property
    def stored_ok(self) -> bool:
        """Whether the kernels fit the store."""
        target = self.program.target
        return self.schedule.words_stored <= target.store_words

    @property
    def retained(self) -> bool:
        """Whether digital memory lasts from one refresh to the next."""
        return self.time.refresh_at is not None or not self.schedule.allocation.code_registers

    @property
    def fits(self) -> bool:
        """Whether store, slot time, retention and the user's limit all allow this program."""
        return self.stored_ok and self.retained and not self.late and not self.overfull

    @property
    def price(self) -> tuple[bool, float, int, int, int]:
        """Sort key among solutions of one lowering: fits, how far from it a boundary is, words a
        frame without refresh, which runs when the light is read, largest boundary, refresh."""
        refresh = self.schedule.words_refresh
        rest = self.schedule.words_total - refresh
        return not self.fits, self.overload, rest, max(self.words_per_boundary), refresh

    @property
    def headroom_e(self) -> float:
        """Most electrons a frame, at constant light with the shutter always open, for every code.

        Neither PIX between two resets nor a frame register may leave its range.
        """
        return headroom_e(self.program, self.plan)


def analog_writes(program: Program, plan: ExposurePlan) -> tuple[int, int]:
    """Fewest and most analog words (`bus`) that an ever-open pixel executes after the setup."""
    steps = Counter((s.predicate, s.words) for s in plan.steps if s.bucket >= 0)
    counts = np.zeros(plan.shutters, dtype=np.int64)
    for (predicate, words), times in steps.items():
        buses = times * sum(word.operation.effect is Effect.BUS for word in words)
        if predicate is None:
            counts += buses
        else:
            counts[members(predicate, plan.shutters)] += buses
    opening = program.table.shutters.any(axis=(1, 2))
    used = counts[opening]
    return (int(used.min()), int(used.max())) if used.size else (0, 0)


def headroom_e(program: Program, plan: ExposurePlan) -> float:
    """See `Lowered.headroom_e`."""
    target = program.target
    slot_us = np.array(program.frame.slot_us)
    share = slot_us / slot_us.sum()
    open_share = program.table.shutters @ share
    register_share = float(open_share.max(initial=0.0))
    reads = [s.boundary for s in plan.steps if s.bucket >= 0 and _reads_pix(s)]
    if plan.lowering == "accumulate":
        read_slots = [n - 1 for n in reads]
        pix_share = float(share[read_slots].max(initial=0.0)) if read_slots else 0.0
    elif any(s.role == "rise" and not _reads_pix(s) for s in plan.steps):
        pix_share = _longest_bump_share(program.table.shutters, share)
    else:
        pix_share = float(share[: max(reads, default=0)].sum())
        if plan.lowering == "edges":
            register_share = max(register_share, _deepest_share(plan, share))
    limits = [target.full_well_e / pix_share] if pix_share else []
    if register_share:
        limits.append(min(target.register_max_e, -target.register_min_e) / register_share)
    return min(limits, default=target.full_well_e)


def _reads_pix(step: Step) -> bool:
    return any("PIX" in word.sources for word in step.words)


def _longest_bump_share(shutters: NDArray[np.bool_], share: NDArray[np.float64]) -> float:
    """The largest light between a rise and its fall, as a share of the frame's."""
    bump = np.zeros(shutters.shape[:2])
    longest = 0.0
    for slot, part in enumerate(share):
        bump = np.where(shutters[:, :, slot], bump + part, 0.0)
        longest = max(longest, float(bump.max(initial=0.0)))
    return longest


def _deepest_share(plan: ExposurePlan, share: np.ndarray) -> float:
    """The largest light that a rising edge subtracts, as a share of the frame's."""
    rises = [s.boundary for s in plan.steps if s.role == "rise"]
    return float(share[: max(rises, default=0)].sum())


def problem_of(
    program: Program, plan: ExposurePlan, time: Timeline, opens: list[list[int]]
) -> tuple[Problem, list[Before]]:
    """What the gates must compute for a plan, and what every step does to FLAG."""
    actions = flag_actions(plan, time, program.target)
    demands: list[Demand] = []
    for step, action in zip(plan.steps, actions, strict=True):
        if step.predicate is not None:
            kept = action == "keep" and bool(demands)
            last = demands[-1].boundary if demands else 0
            quiet = not any(last < n <= step.boundary for n in time.refresh_at or ())
            demands.append(
                Demand(step.boundary, step.role, step.bucket, step.predicate, kept, quiet)
            )
    lasts = not time.refresh_at and time.boundary_us[-1] <= time.keep_us
    levels = tuple(tuple(bucket) for bucket in opens)
    values = _field_values(program)
    return Problem(tuple(demands), plan.shutters, levels, lasts, values), actions


def _field_values(program: Program) -> dict[str, NDArray[np.int64]]:
    """Every field's value in one code of each shutter; free bits are fields of their own.

    Of several codes one is taken whose values other shutters need anyway.
    """
    codes = _code_of_shutter(program.table)
    values: dict[str, NDArray[np.int64]] = {}
    for index, field in enumerate(program.fields):
        if field.bits is None:
            values[field.name] = codes[:, index]
        else:
            bits = {f"{field.name}[{k}]": codes[:, index] >> k & 1 for k in range(field.bits)}
            values.update(bits)
    return values


def _code_of_shutter(table: DecodeTable) -> NDArray[np.int64]:
    """A row of `table.codes` for each shutter."""
    if len(table.codes) == len(table.shutters):
        return table.codes[np.argsort(table.shutter_of_code)]
    meant = np.bincount(table.shutter_of_code, minlength=len(table.shutters))
    only = table.codes[meant[table.shutter_of_code] == 1]
    needed = np.ones(len(table.codes), dtype=np.bool_)
    for column, used in zip(table.codes.T, only.T, strict=True):
        needed &= np.isin(column, used)
    order = np.argsort(~needed, kind="stable")
    _, first = np.unique(table.shutter_of_code[order], return_index=True)
    return table.codes[order[first]]


def lower(
    program: Program,
    plan: ExposurePlan,
    level: int,
    opens: list[list[int]],
    writes: tuple[int, int],
    results: Results | None = None,
    most_words: int | None = None,
) -> Lowered | Misfit:
    """The cheapest solution of a plan, whether it fits or not; a Misfit where none was found.

    `opens` is `levels(program)` and `writes` is `analog_writes(program, plan)`; `most_words` as
    in Lowered. Level 0 takes the first solution that fits, levels 2 and 3 improve the best ones.
    No level's solution is dearer than that of the level below. What is already known comes from
    `results`.
    """
    time = timeline(program.frame.slot_us, len(program.buckets), program.target)
    problem, actions = problem_of(program, plan, time, opens)
    machine = Machine.of(program.target)
    known = Result()
    if results is not None:
        known = results.find(problem, machine, level, plan, time, program.target, most_words)

    def priced(solution: Solution) -> Lowered:
        laid = schedule(plan, solution, actions, time, program.target)
        return Lowered(program, plan, solution, laid, time, writes, most_words)

    by_encoding: dict[str, Lowered] = {}
    for solution in known.or_else(solutions(problem, machine, level)):
        candidate = priced(solution)
        other = by_encoding.get(solution.encoding)
        if other is None or candidate.price < other.price:
            by_encoding[solution.encoding] = candidate
        if level == 0 and candidate.fits:
            break
    found = sorted(by_encoding.values(), key=lambda each: each.price)[: MOST_IMPROVED[level]]
    searched = known.known is None and bool(problem.demands)
    if level >= 2 and searched and found:
        from nscc.logic.improve import refine  # with networkx, which `check` does without

        store = program.target.store_words
        found.insert(0, refine(found, problem, machine, level, priced, store))
    if level > 0 and searched and (level > 1 or not found or not found[0].fits):
        # More steps end some generators elsewhere and leave out others: not always better.
        below = lower(program, plan, level - 1, opens, writes, results, most_words)
        if isinstance(below, Lowered):
            found.append(below)
    if not found:
        return Misfit(
            "no generator found gates in "
            f"{len(program.target.digital_registers)} digital registers",
            searched=True,
        )
    best = min(found, key=lambda each: each.price)
    if level >= 2 and searched:
        known.keep(best.solution)
    return best
