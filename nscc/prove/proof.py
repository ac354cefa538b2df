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

import numpy as np
from numpy.typing import NDArray

from nscc.operations import Op
from nscc.prove.looks import Looks, Wrong
from nscc.prove.noise import Noise
from nscc.prove.readout import readout_fault
from nscc.prove.replay import Replay
from nscc.words.container import Container
from nscc.words.legality import target_fault

FRAMES = 2
LIGHT_SEED = 7
LOOKS_SEED = 20202
TOLERANCE = 1e-9
"""Largest error of an exposure, as a share of all the light of the frame."""


@dataclass(frozen=True)
class Failure:
    """What a proof found wrong first; `shutter` is None where all codes are concerned.

    `doubts` are places where bits became unknown, and so perhaps the cause.
    """

    what: str
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
            what = f"the target does not take the word `{operation}`: {fault}"
            return Proof(codes, slots, 0, Failure(what, 0))
    noise = Noise(LIGHT_SEED)
    if container.machine is not None:
        return _prove_looks(container, kernels, noise.levels(slots, 1)[:, 0])
    replay = Replay(container, kernels, lights=1)
    frames = (_frame(replay, noise.levels(slots, 1), n) for n in range(1, FRAMES + 1))
    failure = next(filter(None, frames), None) or _readout(container) or _pictures(container)
    return Proof(codes, slots, FRAMES, failure)


def _readout(container: Container) -> Failure | None:
    """What is wrong with the words between frame and readout."""
    fault = readout_fault(container)
    return Failure(fault[1], FRAMES, fault[0]) if fault else None


def _pictures(container: Container) -> Failure | None:
    """What is wrong with the words of images and planes."""
    if container.pictures is None:
        return None
    from nscc.prove.pictures import pictures_fault

    fault = pictures_fault(container)
    return Failure(fault, FRAMES) if fault else None


def _prove_looks(
    container: Container, kernels: Sequence[Sequence[Op]], light: NDArray[np.float64]
) -> Proof:
    """The proof of a program that looks."""
    codes, slots = len(container.table.codes), container.slots
    looks = Looks(container, kernels, light, LOOKS_SEED)
    failure = None
    for frame in range(1, FRAMES + 1):
        try:
            looks.frame()
        except Wrong as wrong:
            failure = Failure(wrong.what, frame, wrong.bucket, wrong.behaviour)
            break
    return Proof(codes, slots, FRAMES, failure or _readout(container), looks.transitions)


def _frame(replay: Replay, light: NDArray[np.float64], frame: int) -> Failure | None:
    container = replay.container
    measured = replay.exposures(light)
    scale = float(light.sum())
    for index, bucket in enumerate(container.buckets):
        if bucket not in measured:
            return Failure("no register is read out", frame, bucket)
        expected = _sums(container.table.shutters[:, index, :], light)
        wrong = ~(np.abs(measured[bucket] - expected)[:, 0] <= TOLERANCE * scale)
        if wrong.any():
            return Failure(
                "exposure differs from the sum of light over the open slots", frame, bucket,
                int(np.flatnonzero(wrong)[0]), tuple(replay.doubts),
            )  # fmt: skip
    if not replay.code_kept:
        what = "the code registers do not hold their code when the frame ends"
        return Failure(what, frame, doubts=tuple(replay.doubts))
    return None


def _sums(shutters: NDArray[np.bool_], light: NDArray[np.float64]) -> NDArray[np.float64]:
    """shutters @ light, a few rows at a time: as float64 a whole table may not fit in memory."""
    rows = max(1, (1 << 20) // max(1, shutters.shape[1]))
    blocks = [shutters[i : i + rows] @ light for i in range(0, len(shutters), rows)]
    return np.concatenate(blocks)
