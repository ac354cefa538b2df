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

from collections.abc import Sequence
from dataclasses import dataclass, replace

from nscc.diagnostics.diagnostic import Diagnostic, Label
from nscc.operations import Op
from nscc.prove.looks_proof import Looks
from nscc.prove.pixels import Noise, ReplayError
from nscc.prove.replay import Replay
from nscc.source import Source, Span
from nscc.words.container import Container
from nscc.words.legality import target_fault
from nscc.words.readout import converter_of, preparation_of

_TOLERANCE = 1e-9


def readout_fault(container: Container) -> tuple[str, str] | None:
    """Return the first bucket that is not read out as the target defines, and the error; None if
    all are.

    Random values suffice, because the words are linear."""
    preparation = preparation_of(container)
    buckets = {readout.register: readout.bucket for readout in container.readouts}
    for word in preparation.words:
        fault = target_fault(word, container.target)
        if fault is not None:
            return next(iter(buckets.values())), f"the target does not support `{word}`: {fault}"
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
        if not abs(wrong_e) <= _TOLERANCE * container.target.full_well_e:
            return bucket, "the converted value does not match the meaning of its codes"
    return None


def _converter_input_e(container: Container, exposure_e: float) -> float:
    """Return the converter input, in electrons, for which the code means `exposure_e`.

    The converter's codes are symmetric around an empty register."""
    target = converter_of(container)
    own_e = 2 * target.full_well_e / ((1 << target.adc_bits) - 1)
    middle = (1 << (target.adc_bits - 1)) if target.conversion == "full" else 0.0
    if target.conversion == "spread":
        middle = target.full_well_e / own_e
    code = exposure_e / target.electrons_per_lsb + target.zero_lsb - target.adc_offset_lsb
    return (code - middle) * own_e


FRAMES = 2
LIGHT_SEED = 7


@dataclass(frozen=True)
class Failure:
    """The first error found by a proof; `shutter` is None if all codes are concerned.

    `doubts` are places where bits became unknown, which may be the cause. `unproved` is the image
    or plane whose proof is too large; its words may be correct."""

    reason: str
    frame: int
    bucket: str | None = None
    shutter: int | None = None
    doubts: tuple[str, ...] = ()
    unproved: str | None = None


@dataclass(frozen=True)
class Proof:
    """The extent of a proof and its failure, None if it holds.

    `transitions` is the number of answers that were followed in all frames of a program with
    senses. `pixels` is the number of pixels whose light was followed through bit planes."""

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


def prove(container: Container, kernels: Sequence[Sequence[Op]]) -> Proof:
    """Prove that `kernels`, the decoded words of the container, match its decode table."""
    codes, slots = len(container.table.codes), container.slots
    for operation in dict.fromkeys(word for kernel in kernels for word in kernel):
        fault = target_fault(operation, container.target)
        if fault is not None:
            reason = f"the target does not support the word `{operation}`: {fault}"
            return Proof(codes, slots, 0, Failure(reason, 0))
    looks = container.machine is not None
    replay = Looks(container, kernels) if looks else Replay(container, kernels)
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
    return Proof(codes, slots, FRAMES, failure or _after_frame(container), replay.transitions)


def _after_frame(container: Container) -> Failure | None:
    """Return the error in the words between frame and readout, or None."""
    fault = readout_fault(container)
    if fault is not None:
        return Failure(fault[1], FRAMES, fault[0])
    if container.pictures is None:
        return None
    from nscc.prove.diagrams import TooLarge
    from nscc.prove.pictures_proof import pictures_fault

    try:
        picture_reason = pictures_fault(container)
    except TooLarge as large:
        return Failure("its proof is too large", FRAMES, unproved=large.name)
    return Failure(picture_reason, FRAMES) if picture_reason else None


def proof_too_large(
    name: str, source: Source | None = None, span: Span | None = None
) -> Diagnostic:
    """Return the error (NS0544) for an image or a plane whose proof needs too many nodes."""
    from nscc.prove.diagrams import MOST_NODES

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
            "compare a count: for a kernel with K weights of 1, `any(P, kernel)` is `agree(P, "
            "kernel) > -K`, and `all(P, kernel)` is `agree(P, kernel) >= K`",
            "use a smaller kernel, or combine bits of pixels that are closer together",
        ),
        data={"resource": "nodes", "available": MOST_NODES},
    )
