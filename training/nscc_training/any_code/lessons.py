"""What the denoiser learns from: noisy clips, and clips behind codes of every kind."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from nscc_runtime.scenes.colour import srgb_to_linear
from nscc_training.any_code.decode import white
from nscc_training.any_code.measured import Measured
from nscc_training.data.moving import Generator, Picture, moving

Mask = NDArray[np.float32]
Light = NDArray[np.float32]

_NOISE = (3 / 255, 40 / 255)
_LENGTHS = (4, 6, 8, 8, 8, 8, 12, 16)
"""Frames of a clip; eight most often, as the benchmark has."""
_FILM_LENGTHS = (8, 16, 16)
_FULL_WELL_E = (2_000.0, 60_000.0)
_READ_LSB = (0.2, 2.0)
_BITS = 8


def noisy(
    pictures: Sequence[Picture], generator: Generator, batch: int, size: int
) -> tuple[Tensor, Tensor, Tensor]:
    """Clips of eight frames, the same with noise, and its standard deviation (batch,)."""
    clip = _clips(pictures, generator, batch, 8, size)
    sigma = torch.from_numpy(generator.uniform(*_NOISE, batch).astype(np.float32))
    noise = torch.from_numpy(generator.standard_normal(clip.shape, np.float32))
    return clip, clip + noise * sigma.reshape(-1, 1, 1, 1), sigma


def coded(
    pictures: Sequence[Picture], generator: Generator, batch: int, size: int, exact: float = 0.5
) -> tuple[Tensor, Measured]:
    """Clips of one length behind a mask each, as many as come to `batch` of eight frames.

    The part `exact` of them is measured exactly, as benchmarks are; the others by a sensor with
    photon noise, readout noise and rounding, and a full well that some pixels reach.
    """
    frames = _LENGTHS[int(generator.integers(len(_LENGTHS)))]
    count = max(1, batch * 8 // frames)
    clip = _clips(pictures, generator, count, frames, size)
    masks = [mask_drawn(generator, frames, size) for _ in range(count)]
    mask = torch.from_numpy(np.stack(masks)).unsqueeze(1)
    known = Measured.exact((mask[:, 0] * clip).sum(dim=1), mask[:, 0])
    if generator.random() < exact:
        return clip, known
    read = [_read_out(value.numpy(), generator) for value in known.value]
    value, variance, saturated = (
        torch.from_numpy(np.stack(part)) for part in zip(*read, strict=True)
    )
    return clip, Measured(value, mask, variance, saturated)


def filmed(
    pictures: Sequence[Picture], generator: Generator, batch: int, size: int
) -> tuple[Tensor, Measured, Tensor]:
    """Clips as a camera takes them, as many as come to `batch` of eight frames: linear light, in
    units of a white that is guessed as `decoded_clip` does, the white of the display being `unit`
    (batch,) of the third result.

    The full well holds about what always open pixels gather at the brightest percent of places, as
    protocol video-v1 exposes: behind short shutters dark places are lost in noise and rounding.
    """
    frames = _FILM_LENGTHS[int(generator.integers(len(_FILM_LENGTHS)))]
    count = max(1, batch * 8 // frames)
    shown = _clips(pictures, generator, count, frames, size).numpy()
    light = torch.from_numpy(srgb_to_linear(shown).astype(np.float32))
    drawn = [_film_mask(generator, frames, size) for _ in range(count)]
    mask = torch.from_numpy(np.stack(drawn)).unsqueeze(1)
    read = []
    for each, opened in zip(light.numpy(), mask.numpy(), strict=True):
        brightest = float(np.quantile(each.sum(axis=0), 0.99))
        full = max(brightest * float(np.exp2(generator.uniform(-1, 1))), 1e-3)
        read.append(_read_out((opened * each).sum(axis=1), generator, full))
    value, variance, saturated = (
        torch.from_numpy(np.stack(part)) for part in zip(*read, strict=True)
    )
    measured = Measured(value, mask, variance, saturated)
    unit = white(measured)
    return light / unit.reshape(-1, 1, 1, 1), measured.over(unit), 1 / unit


def exposed_still(
    pictures: Sequence[Light], generator: Generator, batch: int, size: int
) -> tuple[Tensor, Measured]:
    """Stills (batch, size, size), light over the frame in full wells, and their frames: behind
    stops in tiles or at random, with some part of the pixels saturated if they were all open."""
    lights, shares = [], []
    for _ in range(batch):
        light = _light_drawn(pictures, generator, size)
        lights.append(light / max(float(np.quantile(light, generator.uniform(0.4, 0.98))), 1e-6))
        shares.append(_stops_drawn(generator, size))
    light, share = np.stack(lights)[:, None], np.stack(shares)[:, None]
    read = [_read_out(value, generator, 1.0) for value in light * share]
    value, variance, saturated = (np.stack(part) for part in zip(*read, strict=True))
    arrays = (value, share[:, :, None], variance, saturated)
    return torch.from_numpy(light[:, 0]), Measured(*map(torch.from_numpy, arrays))


def _light_drawn(pictures: Sequence[Light], generator: Generator, size: int) -> Light:
    """A part of a picture, turned, shrunk by half or not, its contrast changed."""
    picture = pictures[int(generator.integers(len(pictures)))]
    step = int(generator.integers(1, 3))
    row, col = (int(generator.integers(side - step * size + 1)) for side in picture.shape)
    part = picture[row : row + step * size, col : col + step * size]
    part = part.reshape(size, step, size, step).mean(axis=(1, 3))
    turned = np.rot90(part, int(generator.integers(4)))[:, :: int(generator.choice((1, -1)))]
    return np.asarray(np.maximum(turned, 1e-7) ** generator.uniform(0.8, 1.3), np.float32)


def _stops_drawn(generator: Generator, size: int) -> Mask:
    """The part of the frame (size, size) that each pixel is open for."""
    tile = int(generator.choice((1, 2, 2, 4, 4, 8, size)))
    lowest = generator.uniform(-8, -1)
    stops = np.exp2(generator.uniform(lowest, 0, (tile, tile)))
    if tile == 2 and generator.random() < 0.5:
        stops = np.exp2(np.linspace(lowest, 0, 4)[generator.permutation(4)]).reshape(2, 2)
    repeats = -(-size // tile)
    return np.tile(stops, (repeats, repeats))[:size, :size].astype(np.float32)


def mask_drawn(generator: Generator, frames: int, size: int) -> Mask:
    """The shutters (frames, size, size) of a code of some class: bits, bumps, tiles, rows of a
    codebook, stops; a pixel that would never open opens once."""
    kind = generator.choice((*["bits"] * 6, "bump", "bumps", "book", "stops"))
    tile = size
    if generator.random() < (0.3 if kind == "bits" else 0.6):
        tile = int(generator.choice((2, 4, 8)))
    slot = np.arange(frames)[:, None, None]
    places = (tile, tile)
    if kind == "bits":
        made = generator.random((frames, *places)) < generator.uniform(0.25, 0.75)
    elif kind == "bump":
        length = int(generator.integers(1, frames))
        begin = generator.integers(0, frames - length + 1, places)
        if generator.random() < 0.3:
            # Around the end of the frame, as a cyclic code has it.
            begin = generator.integers(0, frames, places)
        made = (slot - begin) % frames < length
    elif kind == "bumps":
        ends = np.sort(generator.integers(0, frames + 1, (2, *places)), axis=0)
        made = (slot >= ends[0]) & (slot < ends[1])
    elif kind == "book":
        rows = generator.random((frames, int(generator.integers(2, 17)))) < 0.5
        made = rows[:, generator.integers(0, rows.shape[1], places)]
    else:
        made = slot < generator.integers(1, frames + 1, places)
    closed = ~made.any(axis=0)
    made[int(generator.integers(frames))] |= closed
    whole = np.tile(made, (1, -(-size // tile), -(-size // tile)))[:, :size, :size]
    return np.ascontiguousarray(whole, np.float32)


def _film_mask(generator: Generator, frames: int, size: int) -> Mask:
    """Half of them of any class; the others bumps of a quarter of the frame that open one after
    the other in a small tile: within the frame, in two phases, or around its end."""
    if generator.random() < 0.5:
        return mask_drawn(generator, frames, size)
    length = max(1, frames // 4)
    side, kind = 4, int(generator.integers(3))
    begin = np.arange(16) * frames // 16
    if kind < 2:
        begin = np.tile(np.arange(4) * (frames - length) // 3, 4)
    if kind == 1:
        begin[8:] = np.minimum(begin[8:] + length // 2, frames - length)
    if kind == 0:
        side, begin = 2, begin[:4]
    places = generator.permutation(begin).reshape(side, side)
    made = (np.arange(frames)[:, None, None] - places) % frames < length
    whole = np.tile(made, (1, -(-size // side), -(-size // side)))[:, :size, :size]
    return np.ascontiguousarray(whole, np.float32)


def _clips(
    pictures: Sequence[Picture], generator: Generator, batch: int, frames: int, size: int
) -> Tensor:
    return torch.from_numpy(
        np.stack([moving(pictures, generator, frames, size) for _ in range(batch)])
    )


def _read_out(
    value: NDArray[np.float32], generator: Generator, full: float | None = None
) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.bool_]]:
    """A frame (1, rows, cols) as some sensor reads it: value, variance, what is saturated.

    `full` is the value that fills the well, else one that some pixels reach, or none.
    """
    well_e = float(np.exp(generator.uniform(*np.log(_FULL_WELL_E))))
    top = (1 << _BITS) - 1
    # The part of pixels that saturate: none, for most.
    share = generator.uniform(0, 0.15) * (generator.random() < 0.4)
    reached = max(float(np.quantile(value, 1 - share)), 1e-3) * (1.02 if share == 0 else 1.0)
    level = reached if full is None else full
    electrons = np.minimum(value / level, 2.0) * well_e
    read = float(np.exp(generator.uniform(*np.log(_READ_LSB))))
    charge = electrons + np.sqrt(electrons) * generator.standard_normal(value.shape)
    lsb = charge / well_e * top + read * generator.standard_normal(value.shape)
    codes = np.clip(np.rint(lsb), 0, top)
    found = (codes / top * level).astype(np.float32)
    variance = (level / top) ** 2 * (read**2 + 1 / 12) + level / well_e * np.maximum(found, 0)
    return found, variance.astype(np.float32), codes >= top
