"""Mapping of virtual registers to the chip's registers and of gates to words, and the words of a
frame in time: kernels, the boundaries that launch them, and their costs.

The masked register (R12 on SCAMP-5) is written only where its mask (R0) is 1, so it gets code that
does not change within the frame. If every register is needed, it gets the plane with the fewest
writes; each of these writes first sets the mask, which is then a scratch register.

The words of a boundary come in segments. A kernel is stored once however often it is launched, but
every launch takes time. So the segments of a boundary are one kernel if the store has room, else
smaller kernels that boundaries share."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import chain, groupby
from typing import Literal, get_args

from nscc.chips.target import Target
from nscc.logic.problem import MASK, Gate, Segment, Solution
from nscc.lower.decoding import Decoding
from nscc.lower.exposure_plan import Timeline, fades
from nscc.operations import Op, WordEffect, op, pair
from nscc.record import Record
from nscc.words.cost import refresh_count, words_us


class Allocation(Record):
    """The chip register of every virtual register (`chip_registers`), and what each chip register
    holds in words (`holders`).

    `code_registers` contain code, in the order in which they are loaded, and `state_registers`
    states. `masked` is the target's masked register and `mask` its mask; None if it has none."""

    chip_registers: dict[str, str]
    holders: dict[str, str]
    code_registers: tuple[str, ...]
    state_registers: tuple[str, ...]
    mask: str | None
    masked: str | None


def allocate(solution: Solution, target: Target, spared: Collection[str] = ()) -> Allocation:
    """Return the allocation of a solution's virtual registers to registers of `target`.

    The registers `spared` are the last choice for code, and the first for other bits. The caller
    ensures that the solution needs no more registers than there are."""
    planes = [f"p{i}" for i in range(len(solution.planes))]
    scratch = [f"t{i}" for i in range(solution.scratch)]
    states = [f"s{i}" for i in range(solution.states)]
    chip_registers = _pair_registers(solution, target)
    free = [
        register
        for register in sorted(target.digital_registers, key=lambda name: name in spared)
        if register != target.masked_register and register not in chip_registers.values()
    ]
    names = [name for name in (*planes, *states, *scratch) if name not in chip_registers]
    if target.mask_register in free and len(free) > len(names):
        free.remove(target.mask_register)  # the mask is the last choice for code bits
    codes = len([name for name in names if name in planes])
    after_codes = sorted(free[codes:], key=lambda name: name not in spared)
    chip_registers.update(zip(names, (free[:codes] + after_codes)[: len(names)], strict=True))
    holders = {
        **dict(zip(planes, solution.holders, strict=True)),
        **dict.fromkeys(states, "state: open"),
        **dict.fromkeys(scratch, "scratch"),
    }
    by_register = {chip_registers[name]: holders[name] for name in (*planes, *states, *scratch)}
    # Code is loaded into the masked register first, while its mask is 1, and into the mask last.
    order: dict[str | None, int] = {r: i for i, r in enumerate(target.digital_registers)}
    order |= {target.masked_register: -1, target.mask_register: len(order)}
    return Allocation(
        chip_registers,
        holders={r: by_register[r] for r in target.digital_registers if r in by_register},
        code_registers=tuple(
            sorted((chip_registers[name] for name in planes), key=order.__getitem__)
        ),
        state_registers=tuple(chip_registers[name] for name in states),
        mask=target.mask_register,
        masked=target.masked_register,
    )


def _pair_registers(solution: Solution, target: Target) -> dict[str, str]:
    """Return which virtual register is in the masked register, and which in its mask, as virtual to
    chip register.

    Either may be missing: without scratch registers (for intermediate results) the mask is free for
    other bits, and the masked register may stay empty. Empty if the target has no masked register.
    """
    masked, mask = target.masked_register, target.mask_register
    if masked is None or mask is None:
        return {}
    chip_registers = {MASK: mask} if solution.scratch else {}
    name = solution.in_masked_register(len(target.digital_registers))
    return chip_registers if name is None else {**chip_registers, name: masked}


def words(segment: Segment, allocation: Allocation) -> tuple[Op, ...]:
    """Return the words of a segment of gates, on the registers of `allocation`. A gate that is not
    masked and writes the masked register is preceded by the SET of the mask."""
    out: list[Op] = []
    for gate in segment:
        in_masked = allocation.chip_registers.get(gate.destination) == allocation.masked
        if allocation.mask and in_masked and not gate.masked:
            out.append(op("SET", (allocation.mask,)))
        out.extend(_gate_words(gate, allocation.chip_registers))
    return tuple(out)


def _gate_words(gate: Gate, chip_registers: dict[str, str]) -> tuple[Op, ...]:
    """Return the words of a gate. `chip_registers` maps virtual registers to the chip's registers;
    FLAG keeps its name.

    A gate that reads its own destination takes a pair of words; every other gate takes one word.
    The caller ensures that the gate reads no more sources than a word can. FLAG is the bit that
    lets a pixel act."""
    sources = [chip_registers.get(name, name) for name in gate.sources]
    if gate.name == "WHERE":
        return (op("WHERE", (), sources),)
    destination = chip_registers[gate.destination]
    if destination in sources:
        kind = {"NOT": "NOR", "NOR": "NOR", "OR": "OR", "MOV": "REFRESH"}[gate.name]
        return pair(kind, destination, sources)
    return (op(gate.name, (destination,), sources),)


def refresh_words(registers: tuple[str, ...], allocation: Allocation) -> tuple[Op, ...]:
    """Return words that rewrite the content of all `registers` (names of the chip's registers),
    with the same content.

    They overwrite FLAG if both the masked register and its mask contain code, and the mask if only
    the masked register does. FLAG is the bit that lets a pixel act."""
    masked, mask = allocation.masked, allocation.mask
    out: list[Op] = []
    plain = [r for r in registers if r != masked]
    if masked in registers and mask is not None:
        if mask in allocation.code_registers:
            # The mask's code is saved in FLAG; writing it back also refreshes it.
            out += [op("WHERE", (), (mask,)), op("SET", (mask,))]
            out += [*pair("REFRESH", masked, (masked,)), op("MOV", (mask,), ("FLAG",))]
            plain = [r for r in plain if r != mask]
        else:
            out += [op("SET", (mask,)), *pair("REFRESH", masked, (masked,))]
    for register in plain:
        out += pair("REFRESH", register, (register,))
    return tuple(out)


Words = tuple[Op, ...]

KernelSize = Literal["boundary", "segment", "step", "gate"]
"""What one kernel contains: all words of a boundary; a segment, the last with the analog words of
its step; a segment or the analog words; a gate or the analog words."""
SIZES: tuple[KernelSize, ...] = get_args(KernelSize)
"""The sizes of kernels, in the order in which they are tried until the store has room."""


class FrameSchedule(Record):
    """All words of a frame.

    `kernels` are distinct; `launches` are (boundary, number of the kernel) in execution order.
    `setup_us` is the time of boundary 0's words before the exposure starts, including their launch
    (the start of a kernel). `refreshed` are the code registers that need words of refresh. `levels`
    is the value of IN (the level sent to all pixels) of each launch in steps, None if it does not
    matter; empty if no launch sets IN."""

    allocation: Allocation
    kernels: tuple[Words, ...]
    launches: tuple[tuple[int, int], ...]
    setup_us: float
    refreshed: tuple[str, ...]
    levels: tuple[int | None, ...] = ()

    def settles(self) -> list[int]:
        """Return the boundaries at which IN changes, ascending, once for each change. Launches for
        which IN (the level sent to all pixels) does not matter change nothing."""
        boundaries: list[int] = []
        last: int | None = None
        levels = self.levels or (None,) * len(self.launches)
        for (boundary, _), level in zip(self.launches, levels, strict=True):
            if level not in (None, last):
                boundaries.append(boundary)
                last = level
        return boundaries

    @property
    def words_stored(self) -> int:
        """The number of stored words."""
        return sum(len(kernel) for kernel in self.kernels)

    @property
    def words_total(self) -> int:
        """The number of words that a frame executes."""
        return sum(len(self.kernels[kernel]) for _, kernel in self.launches)

    @property
    def words_refresh(self) -> int:
        """The number of words of a frame that only refresh registers."""
        of_kernel = [refresh_count(kernel) for kernel in self.kernels]
        return sum(of_kernel[kernel] for _, kernel in self.launches)


def kernel_us(kernel: Sequence[Op], target: Target) -> float:
    """Return the time of a kernel's launch and words in microseconds."""
    analog = sum(1 for word in kernel if word.analog)
    return words_us(analog, len(kernel) - analog, target) + target.launch_us


def schedule(
    decoding: Decoding, time: Timeline, target: Target, spared: Collection[str] = ()
) -> FrameSchedule:
    """Lay out the gates of a solution and the analog words of its exposure plan over the
    boundaries.

    The digital registers `spared` are the last choice for code. Kernels are as large as the store
    allows; if it has too few words even for the smallest kernels (lists of words), that schedule is
    returned nevertheless."""
    allocation = allocate(decoding.solution, target, spared)
    for size in SIZES:
        result = _scheduled(decoding, time, target, allocation, size)
        if result.words_stored <= target.store_words:
            break
    return result


def _scheduled(
    decoding: Decoding,
    time: Timeline,
    target: Target,
    allocation: Allocation,
    size: KernelSize,
) -> FrameSchedule:
    """Return the schedule of a frame with kernels (lists of words) of this `size`; it may store
    more words than the controller can.

    Registers that the frame's own words do not write often enough are refreshed at the boundaries
    of `time`, and at the end."""
    boundaries = _segments(decoding, allocation, size)
    refreshed = refreshed_registers(boundaries, allocation, time)
    # The exposure begins with the last reset of the setup.
    exposed = max(
        i for i, w in enumerate(boundaries[0][0]) if w.operation.effect is WordEffect.RESET_PIX
    )
    setup_us = kernel_us(boundaries[0][0][: exposed + 1], target)
    apart: set[Words] = set()
    for n in time.refresh_at or ():
        # A state that was not written yet in this frame needs no refresh.
        written = {
            register
            for run in boundaries[:n]
            for words_ in run
            for word in words_
            for register in word.destinations
        }
        to_refresh = (*refreshed, *(r for r in allocation.state_registers if r in written))
        if to_refresh:
            boundaries[n].insert(0, refresh_words(to_refresh, allocation))
            apart.add(boundaries[n][0])
    # The registers must also last over the readout, until the next frame.
    if refreshed:
        boundaries[decoding.plan.slots].append(refresh_words(refreshed, allocation))
    # Refreshes inside the frame differ at each boundary. As separate kernels they are stored once,
    # and leave the other kernels of boundaries equal.
    number: dict[Words, int] = {}
    launches = tuple(
        (n, number.setdefault(segment, len(number)))
        for n, segments in enumerate(
            _merged(boundaries, apart) if size == "boundary" else boundaries
        )
        for segment in segments
        if segment
    )
    return FrameSchedule(allocation, tuple(number), launches, setup_us, refreshed)


def _segments(decoding: Decoding, allocation: Allocation, size: KernelSize) -> list[list[Words]]:
    """Return the segments of every boundary 0..N; the first segment of boundary 0 is the setup.

    They are as small as kernels (lists of words) of this size: gates alone are often equal in all
    slots, and a single gate occurs in many slots of a random codebook."""
    plan, solution, slots = decoding.plan, decoding.solution, decoding.plan.slots
    boundaries: list[list[Words]] = [[] for _ in range(slots + 1)]
    answers = iter(solution.answers)
    known: dict[Segment, Words] = {}

    def placed(*segments: Segment) -> Iterator[Words]:
        """Yield the words of segments, by gate (size "gate") or by segment. Equal results are the
        same object."""
        for segment in segments:
            for part in [(gate,) for gate in segment] if size == "gate" else [segment]:
                if part not in known:
                    known[part] = words(part, allocation)
                yield known[part]

    setup: list[Op] = []
    opened = False
    for step, action in zip(plan.steps, decoding.actions, strict=True):
        # Steps of the whole frame at boundary 0 clear and reset registers, which needs no gates.
        in_setup = step.boundary == 0 and step.bucket < 0
        analog: Words = step.words
        if action == "all":
            analog = (op("all"), *step.words)
        if in_setup:
            setup.extend(analog)
            boundaries[0] = [tuple(setup)]
            continue
        if not opened:
            boundaries[0].extend(placed(*solution.opening))
            opened = True
        segments = boundaries[step.boundary]
        if step.predicate is None or not (answer := next(answers)):
            segments.append(analog)
        elif size in ("step", "gate"):
            segments += [*placed(*answer), analog]
        else:
            *first, last = placed(*answer)
            segments += [*first, (*last, *analog)]
    boundaries[slots].extend(placed(*solution.closing))
    return boundaries


def refreshed_registers(
    boundaries: Sequence[Sequence[Words]], allocation: Allocation, time: Timeline
) -> tuple[str, ...]:
    """Return the code registers that the frame's own words do not write often enough, in the order
    of the allocation.

    `boundaries` has the segments of words of each boundary 0..N. A write to the masked register
    counts only after SET of its mask, because otherwise it does not reach all pixels."""
    written: dict[str, set[int]] = {register: set() for register in allocation.code_registers}
    mask_is_set = False
    for n, segments in enumerate(boundaries):
        for word in chain.from_iterable(segments):
            for register in written.keys() & word.destinations:
                if register != allocation.masked or mask_is_set:
                    written[register].add(n)
            if allocation.mask in word.destinations:
                mask_is_set = word.operation.name == "SET"
    return tuple(register for register, at in written.items() if fades(at, time))


def _merged(boundaries: Sequence[Sequence[Words]], apart: Collection[Words]) -> list[list[Words]]:
    """Return the segments of each boundary merged into one, except segments in `apart`, which stay
    alone and divide those before and after them. A boundary without segments stays empty."""
    merged: list[list[Words]] = []
    for segments in boundaries:
        run: list[Words] = []
        for alone, group in groupby(segments, key=apart.__contains__):
            group_words = list(group)
            run += group_words if alone else [tuple(chain.from_iterable(group_words))]
        merged.append(run)
    return merged
