"""The proof of every build: the words match the decode table, for all codes and two frames.

In the notation of the paper, a program must satisfy g(f(S), n) = S[n] (equation 7) and E = sum
over n of L[n] S[n] (equation 3). The exposure of every code is then a known linear form in the
light of the slots. Random light, and random values in everything on which a program may not rely,
distinguish it from any other linear form with practical certainty: a wrong coefficient would have
to match a hyperplane of measure zero to within 1e-9. Only FLAG could make the exposure nonlinear,
and a FLAG that depends on analog values counts as unknown.

The second frame detects bits that decay from frame to frame. The first frame starts from the code
only and leaves the code behind, so all further frames are equal. The words before the readout are
proved last."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from nscc.arrays import Bools, Floats
from nscc.diagnostics.diagnostic import Diagnostic, Label
from nscc.operations import Op
from nscc.prove.pixels import (
    TOLERANCE,
    WRONG_CODE,
    WRONG_EXPOSURE,
    Noise,
    ReplayError,
    ReplayPixels,
)
from nscc.record import Record
from nscc.source import Source, Span
from nscc.words.container import Container
from nscc.words.legality import target_fault
from nscc.words.readout import converted_buckets, converter_of, preparation_of


class Replay(ReplayPixels):
    """A replay of a program whose pixels do not look at their light: one simulated pixel ("lane")
    for each shutter."""

    def __init__(
        self,
        container: Container,
        kernels: Sequence[Sequence[Op]],
        *,
        lights: int = 1,
        quiet: bool = False,
    ) -> None:
        """Begin a replay with a lane (a simulated pixel) for each row of the container's
        `encoding`, one for each shutter.

        `kernels` are the decoded words of the container's kernels; `lights` is the number of
        exposures computed in parallel. With `quiet`, analog values that were never written are 0
        instead of random."""
        super().__init__(container, kernels, container.encoding, lights=lights, quiet=quiet)
        self.code = self.code_bits(container.encoding)

    def exposures(self, light: Floats) -> dict[str, Floats]:
        """Run one frame and return the exposure of each bucket that is read out, by name, float64
        (lanes, lights), in electrons.

        A lane is the pixel of one shutter. `light` float64 (N, lights) are the electrons of each
        slot; each column is exposed on its own, and the replay must have as many lights as there
        are columns."""
        container = self.container
        gathered = np.zeros((container.slots + 1, light.shape[1]))
        np.cumsum(light, axis=0, out=gathered[1:])
        self.start_frame()
        before = 0
        for boundary in self.launches:
            self.analog["PIX"] += gathered[boundary] - gathered[before]
            self.run_launches(boundary)
            before = boundary
        self.analog["PIX"] += gathered[-1] - gathered[before]
        self.end_frame()
        return {r.bucket: self.analog[r.register] * r.gain for r in container.readouts}

    def prove_frame(self, light: Floats) -> None:
        """Run one frame in `light`, float64 (N,), in electrons per slot, with a replay of one
        light.

        Raises ReplayError if a bucket is not read out, if an exposure differs from the sum of light
        over the open slots of the decode table, or if the code registers do not hold the code at
        the end. The first shutter with an error is named."""
        measured = self.exposures(light[:, None])
        table = self.container.table
        for index, bucket in enumerate(self.container.buckets):
            if bucket not in measured:
                raise ReplayError("no register is read out", bucket)
            opens = table.shutters[:, index, :]
            rows = max(1, (1 << 20) // max(1, opens.shape[1]))  # blocks, to limit the memory
            blocks = [opens[i : i + rows] @ light for i in range(0, len(opens), rows)]
            expected = np.concatenate(blocks)
            # Not `>`: an unknown exposure may be NaN, which must count as different.
            differs = ~(np.abs(measured[bucket][:, 0] - expected) <= TOLERANCE * light.sum())
            if differs.any():
                raise ReplayError(WRONG_EXPOSURE, bucket, int(np.flatnonzero(differs)[0]))
        if any(self.read(name) != bits for name, bits in self.code.items()):
            raise ReplayError(WRONG_CODE)


# Number of slots whose light one float64 can distinguish: powers of four from 1 to 4^23, so that
# weights of -1, 0, 1 and 2 a slot are exact.
_SLOTS_A_LIGHT = 24


def shutters(container: Container, kernels: Sequence[Sequence[Op]]) -> Bools | None:
    """Return the shutters that the words open, bool (lanes, buckets, slots); a lane is a row of
    `container.encoding`.

    The light of slot n is 4^n, so that the base-4 digits of an exposure are the weights of the
    slots. Return None if a weight is neither 0 nor 1, or unknown. Raises KeyError if a bucket is
    not read out."""
    slots = container.slots
    lights = -(-slots // _SLOTS_A_LIGHT)
    light = np.zeros((slots, lights))
    numbers = np.arange(slots)
    # Each column has the light of 24 slots: the base-4 digits of a sum are their weights.
    light[numbers, numbers // _SLOTS_A_LIGHT] = 4.0 ** (numbers % _SLOTS_A_LIGHT)
    # A reset level of zero keeps the sums exact; the proof checks that programs subtract it.
    replay = Replay(container, kernels, lights=lights, quiet=True)
    measured = replay.exposures(light)
    opened = np.zeros((replay.lanes, len(container.buckets), slots), dtype=np.bool_)
    for index, bucket in enumerate(container.buckets):
        value = measured[bucket]
        if not np.isfinite(value).all():
            return None
        for digit in range(_SLOTS_A_LIGHT):
            weight = np.rint(value) % 4
            if not np.isin(weight, (0, 1)).all():
                return None
            columns_ = slice(digit, None, _SLOTS_A_LIGHT)
            # The last column may have fewer than 24 slots.
            opened[:, index, columns_] = weight[:, : len(range(*columns_.indices(slots)))] == 1
            value = (value - weight) / 4
        if np.any(value != 0):
            return None
    return opened


_TOLERANCE = 1e-9
"""Largest error of a converted value, as a share of the full well."""


def readout_fault(container: Container) -> tuple[str, str] | None:
    """Return the first bucket that is not read out as the target defines, and the reason in words;
    None if all are.

    One replay with random values suffices, because the words are linear. If the target lacks a word
    before the readout, the first bucket is named."""
    preparation = preparation_of(container)
    buckets = converted_buckets(container)
    for word in preparation.words:
        fault = target_fault(word, container.target)
        if fault is not None:
            return container.buckets[0], f"the target does not support `{word}`: {fault}"
    # One pixel stands for all, because these words do not depend on codes.
    replay = Replay(replace(container, encoding=container.encoding[:1]), ())
    replay.start_frame()
    before = {name: float(replay.analog[name][0, 0]) for name in buckets}
    replay.set_in(preparation.level or 0)
    for word in preparation.words:
        replay.run(word)
    for register, bucket in buckets.items():
        wrong_e = float(replay.analog[register][0, 0]) - _converter_input_e(
            container, before[register]
        )
        # Not `>`: NaN must count as wrong.
        if not abs(wrong_e) <= _TOLERANCE * container.target.full_well_e:
            return bucket, "the converted value does not match the meaning of its codes"
    return None


def _converter_input_e(container: Container, exposure_e: float) -> float:
    """Return the converter input, in electrons, whose code means an exposure of `exposure_e`
    electrons: both the target's meaning of codes and its converter decide. The code need not be a
    whole number.

    The converter's codes are symmetric around an empty register."""
    target = converter_of(container)
    # The converter's own step: its codes cover two full wells, one below 0 and one above.
    own_e = 2 * target.full_well_e / ((1 << target.adc_bits) - 1)
    middle = (1 << (target.adc_bits - 1)) if target.conversion == "full" else 0.0
    if target.conversion == "spread":
        middle = target.full_well_e / own_e
    code = exposure_e / target.electrons_per_lsb + target.zero_lsb - target.adc_offset_lsb
    return (code - middle) * own_e


FRAMES = 2
"""Frames that a replay runs: the second begins with whatever the first leaves in the registers."""
LIGHT_SEED = 7
"""Fixed, so that every proof of a program replays the same random light."""


class Failure(Record):
    """The first error that a proof found, in the frame number `frame`.

    `bucket` and `shutter` are None if all are concerned. `doubts` are places where bits became
    unknown, which may be the cause. `unproved` is the image or plane that `unproved_error` reports;
    its words may be correct."""

    reason: str
    frame: int
    bucket: str | None = None
    shutter: int | None = None
    doubts: tuple[str, ...] = ()
    unproved: str | None = None


class Proof(Record):
    """How much was proved: numbers of codes, slots and frames, and the `failure`, None if the proof
    holds.

    `transitions` is the number of answers that were followed in all frames of a program with
    senses, 0 for others. `pixels` is the number of pixels whose light was followed through bit
    planes, 0 on chips with words."""

    codes: int
    slots: int
    frames: int
    failure: Failure | None
    transitions: int = 0
    pixels: int = 0

    @property
    def holds(self) -> bool:
        """Whether the words match the decode table."""
        return self.failure is None


def readout_failure(container: Container) -> Failure | None:
    """Return the error in the words before the readout as a failure of the last frame, or None."""
    fault = readout_fault(container)
    return None if fault is None else Failure(fault[1], FRAMES, fault[0])


def prove(
    container: Container,
    kernels: Sequence[Sequence[Op]],
    replay_of: Callable[[Container, Sequence[Sequence[Op]]], ReplayPixels] = Replay,
    after_frame: Callable[[Container], Failure | None] = readout_failure,
) -> Proof:
    """Prove that `kernels`, the decoded words of the container (a compiled program), match its
    decode table.

    `replay_of` makes the pixels that run the words for two frames. `after_frame` returns the first
    error of the words that follow a frame, None if they are right; it is asked only if both frames
    hold. The result holds the first failure, None if there is none; with `frames` 0, the target
    does not support a word, and nothing was replayed."""
    codes, slots = len(container.table.codes), container.slots
    for operation in dict.fromkeys(word for kernel in kernels for word in kernel):
        fault = target_fault(operation, container.target)
        if fault is not None:
            reason = f"the target does not support the word `{operation}`: {fault}"
            return Proof(codes, slots, frames=0, failure=Failure(reason, frame=0))
    replay = replay_of(container, kernels)
    noise = Noise(LIGHT_SEED)
    failure = None
    for frame in range(1, FRAMES + 1):
        try:
            replay.prove_frame(noise.levels(slots, 1)[:, 0])
        except ReplayError as wrong:
            failure = Failure(
                wrong.reason, frame, wrong.bucket, wrong.shutter, tuple(replay.doubts)
            )
            break
    return Proof(codes, slots, FRAMES, failure or after_frame(container), replay.transitions)


ALWAYS_EQUAL = "it compares values that are always equal"


def unproved_error(
    failure: Failure, source: Source | None = None, span: Span | None = None
) -> Diagnostic:
    """Return the error for an image or a plane without a proof; `failure.unproved` is its name.

    It is NS0533 if the image or plane compares values that are always equal, else NS0544: its proof
    needs too many nodes. `span` is the place of its statement in `source`; without them the error
    has no place."""
    from nscc.prove.diagrams import MOST_NODES

    name = failure.unproved
    if failure.reason == ALWAYS_EQUAL:
        return Diagnostic(
            "NS0533",
            f"`{name}` compares two values that are equal in every pixel",
            source=source,
            label=Label(span, "compared here") if span else None,
            notes=("no comparator can tell whether two charges are equal",),
            helps=("compare with another image, or with a level such as `6%`",),
        )
    return Diagnostic(
        "NS0544",
        f"`{name}` depends on too many combinations of comparisons to be proved",
        source=source,
        label=Label(span, "computed here") if span else None,
        notes=(
            f"the proof follows all answers of comparisons; it stops at {MOST_NODES:,} nodes of "
            "decision diagrams",
        ),
        helps=(
            f"the proof followed all that is computed before `{name}`: read a result from there",
            *[
                "compare a count: for a kernel with K weights of 1, `any(P, kernel)` is `agree(P, "
                "kernel) > -K`, and `all(P, kernel)` is `agree(P, kernel) >= K`",
            ]
            * (source is None or bool(re.search(r"\b(any|all)\b", source.text))),
            "use a smaller kernel, or combine bits of pixels that are closer together",
        ),
        data={"resource": "nodes", "available": MOST_NODES},
    )
