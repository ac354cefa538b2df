"""Programs from bare shutter tables, and what a container's words do to pixels of every code.

The words are executed by `emulator_oracle.Chip`, which shares nothing with the compiler or its
proof: several pixels for each shutter, all they hold at the start random, each with light of its
own in every slot of two frames.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from emulator_oracle import Chip

from nscc.checks import check_gates, check_plans, check_schedule
from nscc.chips.load import load_target
from nscc.chips.target import Target
from nscc.lower.exposure_plan import Misfit, plan_exposures
from nscc.lower.gates import find_gates
from nscc.lower.lowered import Choice, Lowered, assemble, lay_out
from nscc.operations import Op
from nscc.program.program import BucketRule, Program, SlotGrid
from nscc.source import Source, Span
from nscc.words.container import Container, DecodeTable
from nscc.words.legality import decoded

FRAMES = 2
REPLICAS = 6


class FadingChip(Chip):
    """A chip whose bits are random once nobody has written them for the retention time.

    `now_us` is set from outside. A register is written when a word stores to it in every pixel.
    """

    def __init__(self, random, target: Target, *state, **more) -> None:
        super().__init__(*state, **more)
        self.random, self.target = random, target
        self.now_us = 0.0
        self.written_us = dict.fromkeys((*target.digital_registers, "FLAG"), 0.0)

    def run(self, name: str, destinations: tuple, sources: tuple) -> None:
        """One word."""
        for register, at in self.written_us.items():
            if self.now_us - at > self.target.digital_retention_us:
                self._forget(register)
        mask = self.target.mask_register
        enabled = mask is None or bool(self.digital[mask].all())
        super().run(name, destinations, sources)
        if name in ("all", "where", "WHERE"):
            self.written_us["FLAG"] = self.now_us
        for register in destinations:
            if register in self.digital and (enabled or register != self.target.masked_register):
                self.written_us[register] = self.now_us

    def end_frame(self, start_us: float) -> None:
        """Bits that a whole frame left alone go the way of all that many frames leave alone."""
        for register, at in self.written_us.items():
            if at < start_us:
                self.written_us[register] = -np.inf

    def _forget(self, register: str) -> None:
        noise = self.random.random(self.flag.shape) < 0.5
        if register == "FLAG":
            self.flag = noise
        else:
            self.digital[register] = noise


def program_from(shutters, slot_us=None, target: Target | str = "scamp5") -> Program:
    """A program that opens the distinct rows of `shutters` (codes, [buckets,] slots)."""
    table = np.asarray(shutters, dtype=bool)
    if table.ndim == 2:
        table = table[:, None, :]
    _, buckets, slots = table.shape
    table = np.unique(table.reshape(len(table), -1), axis=0).reshape(-1, buckets, slots)
    codes = np.arange(len(table))
    place = Span(0, 1)
    return Program(
        source=Source("test.nsl", "nsl 1"),
        target=load_target(target, Path()) if isinstance(target, str) else target,
        target_span=None,
        frame=SlotGrid(tuple(slot_us or (1000.0,) * slots), slot_us is None, place, place),
        fields=(),
        buckets=tuple(BucketRule(f"bucket{i}", place) for i in range(buckets)),
        mode="open",
        table=DecodeTable(("code",), codes[:, None], codes.astype(np.int32), table),
        legal_codes=len(table),
        pixel_codes=None,
        class_name="general",
        class_reason="",
        messages=(),
    )


def lowered_as(program: Program, lowering: str, level: int = 1) -> Lowered | Misfit:
    """`program` lowered in one way, or why it cannot be."""
    planned = plan_exposures(program, lowering)
    check_plans(planned)
    gated = find_gates(planned, level)
    check_gates(gated)
    if not gated.decodings:
        return gated.misfits[lowering]
    (decoding,) = gated.decodings
    choice = Choice((lay_out(program, decoding, gated.time, None),), gated.misfits)
    check_schedule(choice)
    return choice.best


def container_of(lowered: Lowered, level: int = 1) -> Container:
    """The words of a lowered program."""
    return assemble(lowered, level)


def words_at(container: Container, kernels: tuple[tuple[Op, ...], ...] | None = None):
    """For every boundary 0..N the words that run there, as (name, destinations, sources)."""
    kernels = kernels if kernels is not None else decoded(container)
    words: list[list[tuple]] = [[] for _ in range(container.slots + 1)]
    for launch in container.launches:
        for word in kernels[launch.kernel]:
            words[launch.instant].append((word.name, word.destinations, word.sources))
    return words


def expose(container: Container, seed: int, kernels=None, resets: bool | None = None):
    """Runs two frames; yields exposures (buckets, replicas, shutters), light (slots, replicas,
    shutters) and whether the code is as it was, after each.

    `resets` says whether rpix honours FLAG where the target does not know.
    """
    random = np.random.default_rng(seed)
    target = container.target
    shape = (REPLICAS, len(container.encoding))

    def noise():
        return random.choice([-1.0, 1.0], shape) * 10 ** random.uniform(0, 3, shape)

    def bits():
        return random.random(shape) < 0.5

    digital = {name: bits() for name in (*target.digital_registers, "SELECT")}
    code = {}
    for name in container.code_registers:
        column = container.encoding[:, target.digital_registers.index(name)]
        code[name] = np.broadcast_to(column, shape)
        digital[name] = code[name].copy()
    honours = target.reset_honours_flag == "yes" if resets is None else resets
    analog = {name: noise() for name in (*target.analog_registers, "PIX", "IN")}
    chip = FadingChip(
        random, target, analog, digital, bits(), noise(), honours, target.where_obeys_flag
    )
    words = words_at(container, kernels)
    end_us = 1.0  # loading ended before
    for _ in range(FRAMES):
        light = 10 ** random.uniform(0, 3, (container.slots, *shape))
        start_us = chip.now_us = end_us
        for n, here in enumerate(words):
            chip.expose([here], light[n : n + 1])
            chip.now_us += container.slot_us[n] if n < container.slots else 0.0
        end_us = chip.now_us + target.readout_us * len(container.readouts)
        chip.end_frame(start_us)
        found = np.stack([chip.analog[r.register] * r.gain for r in container.readouts])
        kept = all((chip.digital[name] == held).all() for name, held in code.items())
        yield found, light, kept


def does_as_told(container: Container, seed: int = 0, kernels=None) -> bool:
    """Whether the words gather, in every pixel and bucket, the light of the open slots, and keep
    the code, whatever the chip does where the target does not know."""
    unknown = container.target.reset_honours_flag == "unknown"
    names = list(container.buckets)
    order = [names.index(readout.bucket) for readout in container.readouts]
    opened = container.table.shutters.astype(float)[:, order, :]
    for resets in (False, True) if unknown else (None,):
        for found, light, kept in expose(container, seed, kernels, resets):
            truth = np.einsum("mbn,nrm->brm", opened, light)
            error = np.abs(found - truth)
            if not (kept and (error <= 1e-9 * light.sum(axis=0)).all()):
                return False
    return True


def longest_memory_us(container: Container, frames: int = 4) -> float:
    """The oldest bit, in microseconds, that any word reads in frames after the first.

    A bit is as old as the last write to it that took place in every pixel; one that no frame writes
    gets older with every frame.
    """
    target = container.target
    start = np.concatenate(([0.0], np.cumsum(container.slot_us)))
    frame_us = start[-1] + target.readout_us * len(container.readouts)
    written = dict.fromkeys(target.digital_registers, -np.inf)
    written["FLAG"] = -np.inf
    ones = dict.fromkeys(target.digital_registers, False)
    oldest = 0.0
    for frame in range(frames):
        for n, here in enumerate(words_at(container)):
            now = frame * frame_us + start[n]
            for name, destinations, sources in here:
                analog = name in ("bus", "bus2", "bus3", "where")
                read = {"FLAG"} if analog else {s for s in sources if s != "SELECT"}
                if target.masked_register in destinations:
                    read = read | {target.mask_register}
                for register in read:
                    if frame and np.isfinite(written[register]):
                        oldest = max(oldest, now - written[register])
                    elif frame:
                        return np.inf
                if name in ("all", "where", "WHERE"):
                    written["FLAG"] = now
                for register in () if analog else destinations:
                    if register != target.masked_register or ones[target.mask_register]:
                        written[register] = now
                    ones[register] = name == "SET"
    return float(oldest)
