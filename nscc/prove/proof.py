"""The proof that goes with every build: words against decode table, all codes, two frames.

For a program that satisfies g(f(S), n) = S[n], equation (7), and E = sum of L[n] S[n], equation
(3), the exposure of every code is a known linear form in the light of the slots. Random light and
random values in everything that a program may not rely on tell it from any other linear form with
certainty for every practical purpose: a wrong coefficient would have to meet a hyperplane of
measure zero to within 1e-9. Nothing but FLAG could make it other than linear, and a FLAG that hangs
on analog values counts as unknown. The second frame shows what decays from frame to frame; as the
first one started from nothing but the code and leaves the code behind, all others are like it. Last
come the words before readout.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from nscc.operations import Op
from nscc.prove.looks_proof import Looks
from nscc.prove.noise import Noise
from nscc.prove.pixels import ReplayError
from nscc.prove.readout import readout_fault
from nscc.prove.replay import Replay
from nscc.words.container import Container
from nscc.words.legality import target_fault

FRAMES = 2
LIGHT_SEED = 7


@dataclass(frozen=True)
class Failure:
    """What a proof found wrong first; `shutter` is None where all codes are concerned.

    `doubts` are places where bits became unknown, and so perhaps the cause.
    """

    reason: str
    frame: int
    bucket: str | None = None
    shutter: int | None = None
    doubts: tuple[str, ...] = ()


@dataclass(frozen=True)
class Proof:
    """What was replayed and whether it holds.

    `transitions` counts the answers that were followed in all frames, of a program that looks;
    `pixels` those whose light was followed through planes of bits.
    """

    codes: int
    slots: int
    frames: int
    failure: Failure | None
    transitions: int = 0
    pixels: int = 0

    @property
    def holds(self) -> bool:
        """Whether the words do what the decode table says."""
        return self.failure is None


def prove(container: Container, kernels: Sequence[Sequence[Op]]) -> Proof:
    """Replays `kernels` (the container's words, decoded) against the container's decode table."""
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
    """What is wrong with the words between frame and readout."""
    fault = readout_fault(container)
    if fault is not None:
        return Failure(fault[1], FRAMES, fault[0])
    if container.pictures is None:
        return None
    from nscc.prove.pictures_proof import pictures_fault

    picture_reason = pictures_fault(container)
    return Failure(picture_reason, FRAMES) if picture_reason else None
