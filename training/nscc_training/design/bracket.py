"""An ordinary bracket in one exposure time: readouts of all pixels one after the other, merged
without a network."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate, pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Bools, Floats
from nscc.chips.target import Target
from nscc.compiler import compile_source
from nscc.options import Options
from nscc.source import Source
from nscc.words.container import Container
from nscc_training.design.chip import DesignChip
from nscc_training.design.text import frame_text

_BRACKET = (4, 36, 216)
"""Slots of the readouts of an ordinary bracket, of 256: exposure times with ratios of 9 and 6.

The shortest is first: PIX collects light until the frame ends, so a readout after a long one is
saturated where the long one is."""


def bracket_slots(slots: int) -> tuple[int, ...]:
    """Return the number of slots of each readout of an ordinary bracket, the shortest first.
    Together they fill a frame of `slots` slots, if it has at least three; each has at least one
    slot."""
    shorter = [max(1, round(slots * length / sum(_BRACKET))) for length in _BRACKET[:-1]]
    return *shorter, max(1, slots - sum(shorter))


def camera(
    slots: int,
    slot_us: float,
    target: str | Target | None = None,
    frames: int = 1,
    stop: int | None = None,
    lengths: Sequence[int] = (),
) -> Container:
    """Compile the program of an ordinary camera, whose pixels all have the same shutter.

    It has one readout, open until slot `stop` (None: the whole frame). With `frames` it has several
    readouts of equal length, one after the other; with `lengths`, which then decides, readouts of
    these numbers of slots. `stop` has no effect on several readouts. `target` is a chip, its name
    or file; None the default one. Raises Rejected if the program does not fit the chip."""
    rules = f"open when n < {stop or slots}\n"
    ends = [slots * k // frames for k in range(frames + 1)]
    if lengths:
        ends = [0, *accumulate(lengths)]
    if len(ends) > 2:
        rules = "".join(
            f"bucket frame{k} open when {first} <= n < {last}\n"
            for k, (first, last) in enumerate(pairwise(ends), start=1)
        )
    text = f"nsl 1\n{frame_text(slots, slot_us)}\n{rules}"
    return compile_source(Source("camera.nsl", text), Path(), Options(level=1, target=target)).built


def merged_bracket(
    exposure_e: NDArray[np.floating],
    open_share: NDArray[np.floating],
    saturated: Bools,
    chip: DesignChip,
) -> Floats:
    """Estimate the light over the frame from a bracket: several readouts with different exposure
    times. The result is in electrons, (rows, cols) or with colours last; every pixel is estimated
    alone.

    `exposure_e` and `saturated` are (readouts, rows, cols, ..), in electrons of the registers and
    true where saturated. `open_share` (readouts,) is the fraction of the frame in which each
    readout was open. Readouts are weighted by precision, for the light in the longest readout that
    is not saturated. A pixel that saturates all of them has at least the light of the shortest one.
    """
    order = np.argsort(open_share)
    shares = open_share[order].reshape(-1, *[1] * (exposure_e.ndim - 1))
    light, full = exposure_e[order] / (chip.gain * shares), saturated[order]
    estimate = light[0]
    for longer, is_full in zip(light[1:], full[1:], strict=True):
        estimate = np.where(is_full, estimate, longer)
    spread = chip.exposed_sd_e(np.maximum(estimate, 0) * shares) / shares
    precision = np.where(full, 0.0, 1 / spread**2)
    total = precision.sum(axis=0)
    mean = (precision * light).sum(axis=0) / np.where(total > 0, total, 1)
    return np.asarray(np.where(total > 0, mean, light[0]), np.float64)
