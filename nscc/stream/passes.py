"""Compiler passes for chips without logic: the route of light for every pixel and slot, and the
schedule of its bit planes. `nscc.pipeline` lists all passes.

A bit chooses between two destinations, which are the same for all pixels in a slot. A program that
needs more destinations does not fit."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Bools
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Diagnostic, Label, Rejected
from nscc.lower.resources import at_least, chip_label, chip_note, resource, time_text
from nscc.pipeline import Found, Job
from nscc.program.problems import counted
from nscc.program.program import Program
from nscc.record import Record
from nscc.words.container import Container, Readout
from nscc.words.stream import DRAIN, Loading, Stream, schedule


class Route(Record, eq=False):
    """The two destinations of each slot, and the bits that choose between them.

    `ones` and `zeros` int8 (N,) are the destinations for bit 1 and 0: the index of a tap, or DRAIN.
    `bits` bool (shutters, N) are the chosen bits, one for each shutter of the decode table and
    slot."""

    ones: NDArray[np.int8]
    zeros: NDArray[np.int8]
    bits: Bools


class NoRoute(Record):
    """Why the chip cannot route the light: `reason` ends a sentence, `help` suggests a change.

    `slot` is the first slot that has no route; None if that is true of all. `bucket` is the index
    of the bucket that the message marks."""

    reason: str
    help: str
    slot: int | None = None
    bucket: int = 0


def route(shutters: Bools, buckets: tuple[str, ...], target: Target) -> Route | NoRoute:
    """Return how bits send the light of `shutters`, bool (shutters, buckets, N), to the taps.

    Bucket b, named `buckets[b]`, is collected by tap b. Light that no bucket collects goes to the
    drain, or else to a tap without a bucket. Return NoRoute if the chip has too few taps, if two
    buckets are open at once, or if a slot needs more than two destinations or a drain that is not
    there; the first of these that is true, in its first slot."""
    taps = len(target.taps)
    if len(buckets) > taps:
        most = f"keep at most {taps} buckets, one for each tap"
        return NoRoute(
            f"{len(buckets)} buckets need as many taps, but the chip has {taps}",
            most,
            bucket=len(buckets) - 1,
        )
    both = shutters.sum(axis=1) > 1
    if both.any():
        slot = int(np.flatnonzero(both.any(axis=0))[0])
        first, second = np.flatnonzero(shutters[both[:, slot].argmax(), :, slot])[:2]
        return NoRoute(
            f"in slot {slot} a pixel is open in `{buckets[first]}` and in "
            f"`{buckets[second]}`, but its light can go to only one tap",
            "let the buckets' rules exclude each other",
            slot,
            int(second),
        )
    # Bucket b is tap b, so the next tap belongs to no bucket.
    away = DRAIN if target.drain else len(buckets) if len(buckets) < taps else None
    open_in = np.where(shutters.any(axis=1), shutters.argmax(axis=1), _NOWHERE)
    return _chosen(open_in.astype(np.int8), away, buckets, target)


_NOWHERE = 127
"""Marks that no bucket is open; as an int8, and larger than the number of any bucket."""


def _chosen(
    open_in: NDArray[np.int8], away: int | None, buckets: tuple[str, ...], target: Target
) -> Route | NoRoute:
    """Return the two destinations of each slot and the bits that choose between them.

    `open_in` int8 (shutters, N) is the index of the open bucket, and _NOWHERE if none is open. The
    light then goes to `away`: the drain or a tap without a bucket, or None if the chip has neither.
    Return NoRoute if a slot has more than two destinations, or needs `away` where there is none."""
    slots = open_in.shape[1]
    ones, zeros = np.zeros(slots, np.int8), np.zeros(slots, np.int8)
    for slot in range(slots):
        destinations = np.unique(open_in[:, slot]).tolist()
        if len(destinations) > 2:
            names = [f"`{buckets[p]}`" if p != _NOWHERE else "no bucket" for p in destinations]
            listed = f"{', '.join(names[:-1])} and {names[-1]}"
            return NoRoute(
                f"in slot {slot} light has {len(destinations)} destinations ({listed}), but a bit "
                "chooses between two",
                "use at most two destinations in every slot: two buckets, or one bucket and "
                "the drain",
                slot,
                len(buckets) - 1,
            )
        if away is None and _NOWHERE in destinations:
            return NoRoute(
                f"in slot {slot} a pixel is open in no bucket, but {target.name} has no "
                "drain: light always goes to a tap",
                f"let one bucket collect the remaining light: `bucket {buckets[-1]} open "
                "when not (..)`",
                slot,
                len(buckets) - 1,
            )
        named = [destination for destination in destinations if destination != _NOWHERE]
        ones[slot] = named[0] if named else 0
        other_buckets = [bucket for bucket in range(len(buckets)) if bucket != ones[slot]]
        # If all light of a slot goes to one tap, no bit is 0, so any other destination will do.
        zeros[slot] = named[1] if len(named) > 1 else away if away is not None else other_buckets[0]
    return Route(ones, zeros, open_in == ones)


class Sending(Record, eq=False):
    """A program for a chip without logic: its route of the light, and when its bit planes are
    sent."""

    program: Program
    route: Route

    @property
    def loadings(self) -> tuple[Loading, ...]:
        """The times at which the plane of each slot is sent and takes effect."""
        return tuple(schedule(self.program.target, self.program.frame.slot_us))

    @property
    def shortest_slot_us(self) -> float:
        """The shortest slot that the chip allows, in microseconds: the time to load a plane."""
        return self.program.target.plane_load_us

    @property
    def bits_a_frame(self) -> int:
        """The number of bits sent for a frame: one for each pixel and slot."""
        target = self.program.target
        return len(self.program.frame.slot_us) * target.rows * target.cols

    @property
    def bits_per_us(self) -> float:
        """The data rate while a plane loads, in bits per microsecond."""
        return self.program.target.cols / self.program.target.row_load_us

    @property
    def frame_us(self) -> float:
        """The time from the start of the first slot to the end of the last, in microseconds."""
        return sum(self.program.frame.slot_us)


def late_fault(sending: Sending) -> Diagnostic | None:
    """Return the error (NS0508) if a slot is too short to load its bit plane, else None.

    The shortest slot is named. Where the light waits for the plane (no pipeline), a slot must be
    longer than the load time; else it may be equal."""
    program, target = sending.program, sending.program.target
    slots_us, needed_us = program.frame.slot_us, target.plane_load_us
    # If light waits for the plane, a slot as short as the load time has no light.
    late = [
        n
        for n, us in enumerate(slots_us)
        # Times are sums of decimal fractions, so equal ones may differ in their last digits.
        if us < needed_us * (1 - 1e-9) or (not target.pipelined and us <= needed_us)
    ]
    if not late:
        return None
    worst = min(late, key=slots_us.__getitem__)
    takes = f"{target.rows} rows x {time_text(target.row_load_us)}"
    longer_text = "or longer" if target.pipelined else "and more"
    rows = int(slots_us[worst] / target.row_load_us)
    fewer: tuple[str, ...] = ()
    if rows:
        fits_text = f"a target of at most {counted(rows, 'row')} fits slots of "
        fewer = (f"{fits_text}{time_text(slots_us[worst])}: `nscc targets {target.name} --toml`",)
    count = int(sum(slots_us) / needed_us)
    fewer_slots = f"; {counted(count, 'slot')} of that fit into this frame's time" if count else ""
    return Diagnostic(
        "NS0508",
        f"slot {worst} lasts {time_text(slots_us[worst])}, but loading its bit plane takes "
        f"{time_text(needed_us)}: {takes}",
        source=program.source,
        label=Label(program.frame.span, f"{len(late)} of {len(slots_us)} slots too short"),
        related=chip_label(program, f"{takes} a plane"),
        notes=(
            *chip_note(program, f"{takes} a plane"),
            "certain: every slot needs its own bit plane, which is sent row by row",
        ),
        helps=(
            f"slots of {at_least(needed_us)} {longer_text} are long enough{fewer_slots}",
            *fewer,
        ),
        data=resource("slot_us", needed_us, slots_us[worst], proved=True),
    )


def with_planes_of_route(container: Container, way: Route) -> Container:
    """Return a container (a compiled program) with the bit planes of its pixel codes, in place of
    any that it had.

    `way` has the destination of the light of each shutter. Without pixel codes the container gets
    no planes."""
    pixels = container.pixel_codes
    if pixels is None:
        return replace(container, stream=None)
    shutter = container.table.shutter_of_code[pixels]
    planes = [
        np.packbits(way.bits[:, slot][shutter], axis=1, bitorder="little")
        for slot in range(container.slots)
    ]
    return replace(container, stream=Stream(np.stack(planes), way.ones, way.zeros))


def with_planes(container: Container) -> Container:
    """Return a container (a compiled program) of a chip without logic with the bit planes of its
    current pixel codes.

    Raises Rejected (NS0509) if there is no route for the light of its shutters."""
    chosen_route = route(container.table.shutters, container.buckets, container.target)
    if isinstance(chosen_route, NoRoute):
        raise Rejected(no_route(chosen_route, container.target.name))
    return with_planes_of_route(container, chosen_route)


def no_route(missing_route: NoRoute, chip: str, program: Program | None = None) -> Diagnostic:
    """Return the error (NS0509) that a chip cannot route the light as the program requires.

    `chip` is its name. `program` gives the place in the source; None if only a compiled file is
    known, whose error has no place."""
    message = f"the pixels of {chip} cannot route light like this: {missing_route.reason}"
    help_text = (missing_route.help,)
    if program is None:
        return Diagnostic("NS0509", message, helps=help_text, data={"slot": missing_route.slot})
    taps = ", ".join(program.target.taps)
    return Diagnostic(
        "NS0509",
        message,
        source=program.source,
        label=Label(program.buckets[missing_route.bucket].span),
        related=chip_label(program, f"taps: {taps}" + "; a drain" * program.target.drain),
        notes=("certain: in each slot all pixels choose between the same two destinations",),
        helps=help_text,
        data={"slot": missing_route.slot},
    )


def plan_of(program: Program, job: Job) -> tuple[Sending | NoRoute, Found]:
    """Return the program with its route, without errors; or NoRoute and the error (NS0509).

    Options that only apply to words (a lowering, a limit on words) are refused with NS0510; the
    NoRoute is then empty. A lowering is a way to compute the exposure."""
    lowering = job.options.lowering
    word_options = [f"--lowering {lowering}"] * (lowering != "auto")
    word_options += ["--max-words-per-slot"] * (job.options.max_words_per_slot is not None)
    if word_options:
        options = " and ".join(word_options)
        no_words = Diagnostic(
            "NS0510",
            f"{options} does not apply: the pixels of {program.target.name} have no logic and "
            "run no words",
            source=program.source,
            label=Label(program.buckets[0].span),
            notes=("on this chip, one bit per pixel and slot routes the light",),
            helps=(f"leave {options} out, or compile for a chip with a processor in every pixel",),
        )
        # The message says everything; this NoRoute only stands for a missing route.
        return NoRoute("", ""), [no_words]
    names = tuple(bucket.name for bucket in program.buckets)
    chosen_route = route(program.table.shutters, names, program.target)
    if isinstance(chosen_route, NoRoute):
        return chosen_route, [no_route(chosen_route, program.target.name, program)]
    return Sending(program, chosen_route), []


def check_times(sending: Sending, job: Job) -> tuple[Sending, Found]:
    """Return `sending` unchanged, and the error (NS0508) if a plane cannot be loaded in time."""
    fault = late_fault(sending)
    return sending, [fault] if fault else []


def container_of(sending: Sending) -> Container:
    """Return the compiled program: no words, and bit planes if the pixels have codes. Bucket b is
    read from tap b."""
    program, target = sending.program, sending.program.target
    names = tuple(bucket.name for bucket in program.buckets)
    used = len(names)
    container = Container(
        target=target,
        slot_us=program.frame.slot_us,
        buckets=names,
        table=program.table,
        kernels=(),
        launches=(),
        code_registers=(),
        encoding=np.zeros((len(program.table.shutters), 0), np.bool_),
        pixel_codes=program.pixel_codes,
        readouts=tuple(
            Readout(tap, name, gain)
            for tap, name, gain in zip(target.taps[:used], names, target.gains[:used], strict=True)
        ),
        source_lines=tuple(program.source.text.splitlines()),
        notes={"class": program.class_name, "codes": program.mode, "lowering": "stream"},
    )
    return with_planes_of_route(container, sending.route)
