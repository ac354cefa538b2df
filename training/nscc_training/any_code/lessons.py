"""Training examples ("lessons") of the decoder for any code: noisy clips, coded clips and stills.

Seed and step determine light and shutters. Noise is drawn on the device of the training."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor
from torch.utils.data import Dataset

from nscc.arrays import Floats32
from nscc_training.any_code.decode import white
from nscc_training.code_choices import over_array
from nscc_training.codes_files import load_codes
from nscc_training.curves import srgb_inverse
from nscc_training.data.exposures import quantiles
from nscc_training.data.moving import Generator, Picture, moving
from nscc_training.draws import uniform
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.measured import Measured
from nscc_training.random_streams import DrawStream
from nscc_training.run_files import searched_codes
from nscc_training.settings import RunSettings

_NOISE = (3 / 255, 40 / 255)
"""Limits of the standard deviation of noise in lessons of denoising; white is 1."""
_LENGTHS = (4, 6, 8, 8, 8, 8, 12, 16)
"""Numbers of frames of a clip; 8 is most frequent because the benchmark has 8."""
_FILM_LENGTHS = (8, 16, 16)
"""Numbers of frames of a filmed lesson; the searched code has 16."""
SEARCHED_SLOTS = 16
"""Slots of the searched code."""
_FULL_WELL_E = (2_000.0, 60_000.0)
"""Limits of the full well of the sensors that lessons simulate."""
_READ_LSB = (0.2, 2.0)
"""Limits of the standard deviation of their read noise, in steps of the converter."""
_TOP = 255.0


class Lesson(NamedTuple):
    """The examples of one training step.

    `light` is a batch of clips (batch, T, rows, cols) from 0 to 1 in display encoding, or of stills
    (batch, 1, rows, cols) in full wells; `mask`, of the same shape, is the open fraction of each
    slot. `exact` means that there is no measurement noise, as in benchmarks. `filmed` means linear
    light with unknown white, as a camera records it. `names` is the kind of lesson, for the
    trainer's interface of batches."""

    light: Tensor
    mask: Tensor
    exact: bool
    filmed: bool
    names: tuple[str, ...]


class LessonSet(Dataset[Lesson]):
    """The lessons of a training run: item `step` is the batch of that step. Longer clips come in
    smaller batches, so that all batches have about as many values."""

    def __init__(
        self, pictures: Sequence[Picture] | Sequence[Floats32], settings: RunSettings
    ) -> None:
        """Prepare lessons whose light is drawn from `pictures`: for clips those that `moving`
        shifts, for stills linear arrays (rows, cols). Both sides are at least two patches long.
        `settings` gives kind, seed, and sizes."""
        self.pictures, self.settings = pictures, settings

    def __getitem__(self, step: int) -> Lesson:
        """Return the examples of training step `step`; the same step always gives the same light
        and codes.

        `settings.decoder.lessons` decides the kind: "stills", "denoise" (noisy clips), or coded
        clips with random codes and sometimes the searched code."""
        settings = self.settings
        generator = np.random.default_rng([settings.train.seed, DrawStream.LESSONS, step])
        kind, size, batch = settings.decoder.lessons, settings.data.patch, settings.train.batch
        if kind == "stills":
            drawn = [_still_drawn(self.pictures, generator, size) for _ in range(batch)]  # type: ignore[arg-type]
            light, mask = (
                torch.from_numpy(np.stack(arrays)) for arrays in zip(*drawn, strict=True)
            )
            return Lesson(light[:, None], mask[:, None], exact=False, filmed=False, names=(kind,))
        filmed = kind == "codes" and generator.random() < settings.decoder.films
        exact = kind == "denoise" or (not filmed and generator.random() < settings.decoder.exact)
        lengths = (8,) if kind == "denoise" else _FILM_LENGTHS if filmed else _LENGTHS
        frames = lengths[int(generator.integers(len(lengths)))]
        # The batch is counted in clips of 8 frames; longer clips are fewer, so that a lesson needs
        # the same memory.
        count = max(1, batch * 8 // frames)
        clips = [moving(self.pictures, generator, frames, size) for _ in range(count)]  # type: ignore[arg-type]
        if settings.decoder.still:
            clips = [
                np.repeat(clip[:1], frames, axis=0)
                if generator.random() < settings.decoder.still
                else clip
                for clip in clips
            ]
        draw = _film_mask if filmed else mask_drawn
        if filmed and frames == SEARCHED_SLOTS and generator.random() < settings.decoder.searched:
            draw = _searched_mask
        masks = [draw(generator, frames, size) for _ in range(count)]
        light, mask = (torch.from_numpy(np.stack(arrays)) for arrays in (clips, masks))
        return Lesson(light, mask, exact=exact, filmed=filmed, names=(kind,))


def noisy(clip: Tensor, generator: torch.Generator) -> tuple[Tensor, Tensor]:
    """Return `clip` (batch, T, rows, cols) plus Gaussian noise, and the noise's standard deviation
    (batch,), which is drawn uniformly for each clip within `_NOISE`. The result is not clipped."""
    low, high = _NOISE
    sigma = low + (high - low) * uniform(clip, generator, clip.shape[:1])
    drawn = torch.randn(clip.shape, generator=generator, device=generator.device).to(clip)
    return clip + drawn * sigma.reshape(-1, 1, 1, 1), sigma


def measured_lesson(
    lesson: Lesson, generator: torch.Generator
) -> tuple[Tensor, Measured[Tensor], Tensor | None]:
    """Return the ground truth of a lesson, its measurement, and the light that a display shows as
    white (batch,).

    Noise is drawn from `generator`. White is None except for filmed lessons, whose errors are
    measured in display encoding; their truth and measurement are divided by the white that the
    decoder estimates. Their full well is within a factor of 2 of the light that the brightest
    percent of pixels would collect if always open. This is as in protocol video-v1, so that noise
    is realistic for short shutters. The full well of a still is 1. In other lessons some pixels may
    saturate."""
    light, mask = lesson.light, lesson.mask
    if lesson.filmed:
        light = srgb_inverse(light)
    value = (mask * light).sum(dim=1, keepdim=True)
    masks = mask.unsqueeze(1)
    if lesson.exact:
        return light, Measured.exact(value[:, 0], mask), None
    full: Tensor | None = None
    if light.shape[1] == 1:
        full = torch.ones_like(value[:, 0, 0, 0])
    elif lesson.filmed:
        brightest = quantiles(light.sum(dim=1).flatten(1), 0.99).to(light)
        stops = 2 * uniform(brightest, generator) - 1
        full = (brightest * torch.exp2(stops)).clamp(min=1e-3)
    measured = Measured(*_read_out(value, masks, generator, full))
    if not lesson.filmed:
        return light, measured, None
    unit = white(measured)
    return light / unit.reshape(-1, 1, 1, 1), measured.over(unit), 1 / unit


def _still_drawn(
    pictures: Sequence[Floats32], generator: Generator, size: int
) -> tuple[Floats32, Floats32]:
    """Return a random still (size, size) in full wells, cut from one of the `pictures` (rows,
    cols), and the open fraction of the frame of each pixel (size, size). Both sides of every
    picture are at least twice `size`.

    Part of the light would saturate a pixel that is always open; only pixels with a short exposure
    measure it."""
    picture = pictures[int(generator.integers(len(pictures)))]
    # A pixel of the still is the mean of `step` x `step` pixels of the picture: two sizes of
    # detail.
    step = int(generator.integers(1, 3))
    row, col = (int(generator.integers(side - step * size + 1)) for side in picture.shape)
    crop = picture[row : row + step * size, col : col + step * size]
    crop = crop.reshape(size, step, size, step).mean(axis=(1, 3))
    turned = np.rot90(crop, int(generator.integers(4)))[:, :: int(generator.choice((1, -1)))]
    # An exponent on light changes the contrast.
    light = np.asarray(np.maximum(turned, 1e-7) ** generator.uniform(0.8, 1.3), np.float32)
    # Light that fills a well: 2 to 60 % of the pixels would saturate if they were always open.
    level = max(float(np.quantile(light, generator.uniform(0.4, 0.98))), 1e-6)
    # Sides of a tile. With 1 all pixels have one exposure time, with `size` each has its own.
    tile = int(generator.choice((1, 2, 2, 4, 4, 8, size)))
    # The shortest exposure is between 1 / 256 and 1 / 2 of the frame.
    lowest = generator.uniform(-8, -1)
    stops = np.exp2(generator.uniform(lowest, 0, (tile, tile)))
    if tile == 2 and generator.random() < 0.5:
        # Four exposure times in equal ratios, in random order.
        stops = np.exp2(np.linspace(lowest, 0, 4)[generator.permutation(4)]).reshape(2, 2)
    mask = over_array(stops, size, size).astype(np.float32)
    return np.asarray(light / level, np.float32), mask


def mask_drawn(generator: Generator, frames: int, size: int) -> Floats32:
    """Return random shutters (frames, size, size), 1 where open. Every pixel opens in at least one
    frame. `frames` is at least 2.

    Their kind is random, too: free bits, bumps of one length, bumps of any length, rows of a
    codebook, or stops. Some are drawn for each pixel, others for a tile that is repeated."""
    # Free bits in six of ten cases: they include all other kinds.
    kind = generator.choice((*["bits"] * 6, "bump", "bumps", "book", "stops"))
    tile = size
    if generator.random() < (0.3 if kind == "bits" else 0.6):
        tile = int(generator.choice((2, 4, 8)))
    slot = np.arange(frames)[:, None, None]
    places = (tile, tile)
    if kind == "bits":
        opened = generator.random((frames, *places)) < generator.uniform(0.25, 0.75)
    elif kind == "bump":
        length = int(generator.integers(1, frames))
        begin = generator.integers(0, frames - length + 1, places)
        if generator.random() < 0.3:
            # The bump continues at the start of the frame, as in a cyclic code.
            begin = generator.integers(0, frames, places)
        opened = (slot - begin) % frames < length
    elif kind == "bumps":
        ends = np.sort(generator.integers(0, frames + 1, (2, *places)), axis=0)
        opened = (slot >= ends[0]) & (slot < ends[1])
    elif kind == "book":
        # A codebook of 2 to 16 shutters.
        rows = generator.random((frames, int(generator.integers(2, 17)))) < 0.5
        opened = rows[:, generator.integers(0, rows.shape[1], places)]
    else:
        opened = slot < generator.integers(1, frames + 1, places)
    # Pixels that would never open open in one slot, the same for all of them.
    closed = ~opened.any(axis=0)
    opened[int(generator.integers(frames))] |= closed
    return np.ascontiguousarray(over_array(opened, size, size), np.float32)


def _film_mask(generator: Generator, frames: int, size: int) -> Floats32:
    """Return random shutters (frames, size, size), 1 where open.

    Half of the draws are shutters of any kind (`mask_drawn`). The other half are bumps of a quarter
    of the frame in a 2 x 2 or 4 x 4 tile, which open one after another."""
    if generator.random() < 0.5:
        return mask_drawn(generator, frames, size)
    length = max(1, frames // 4)
    side, kind = 4, int(generator.integers(3))
    # Kind 2: sixteen starts, which may continue at the start of the frame. Kind 0: four starts in a
    # 2 x 2 tile. Kind 1: four starts, delayed by half a bump in half of the places.
    begin = np.arange(16) * frames // 16
    if kind < 2:
        begin = np.tile(np.arange(4) * (frames - length) // 3, 4)
    if kind == 1:
        begin[8:] = np.minimum(begin[8:] + length // 2, frames - length)
    if kind == 0:
        side, begin = 2, begin[:4]
    starts = generator.permutation(begin).reshape(side, side)
    opened = (np.arange(frames)[:, None, None] - starts) % frames < length
    return np.ascontiguousarray(over_array(opened, size, size), np.float32)


@cache
def _searched_tile() -> Floats32:
    """Return the shutters (16 slots, 8 x 8 pixels), 1 where open, of the code that a search found
    and that comes with nscc."""
    # The encoder's own random codes are replaced at once by those of the file.
    encoder = make_encoder(ShutterSpec("e", SEARCHED_SLOTS, tile=(8, 8)), start="random", seed=0)
    encoder.load_codes(load_codes(searched_codes()))
    return np.asarray(encoder.hard().numpy(), np.float32)


def _searched_mask(generator: Generator, frames: int, size: int) -> Floats32:
    """Return the searched code, repeated to (16, size, size), 1 where open, and randomly shifted,
    rotated and reversed in time.

    `frames` must be `SEARCHED_SLOTS`; it is a parameter because all functions that draw masks have
    it."""
    tile = np.rot90(_searched_tile(), int(generator.integers(4)), axes=(1, 2))
    tile = tile[:: int(generator.choice((1, -1)))]
    row, col = generator.integers(8, size=2)  # the tile has 8 x 8 pixels
    mask = over_array(tile, row + size, col + size)[:, row:, col:]
    return np.ascontiguousarray(mask, np.float32)


def _read_out(
    value: Tensor, masks: Tensor, generator: torch.Generator, full: Tensor | None
) -> tuple[Tensor, Tensor, Tensor, Tensor]:
    """Simulate the readout of frames by a sensor with random full well and read noise. Return the
    four fields of `Measured`: values, masks, variances, saturation.

    `value` (batch, 1, rows, cols) is the light of the open slots. `full` (batch,) is the value that
    fills a well. None draws it: 60 % of the frames do not saturate, and up to 15 % of the pixels of
    the others do."""
    wide = (-1, 1, 1, 1)

    def drawn(limits: tuple[float, float]) -> Tensor:
        """Return a random number for each frame, (batch, 1, 1, 1), uniform in the logarithm between
        the two `limits`."""
        low, high = np.log(limits)
        return torch.exp(low + (high - low) * uniform(value, generator, (len(value),))).reshape(
            wide
        )

    well_e, read_lsb = drawn(_FULL_WELL_E), drawn(_READ_LSB)
    if full is None:
        # The fraction of saturated pixels: 0 for most lessons.
        shares = 0.15 * uniform(value, generator, (len(value),))
        shares = shares * (uniform(value, generator, (len(value),)) < 0.4)
        reached = quantiles(value.flatten(1), 1 - shares).to(value).clamp(min=1e-3)
        # Where nothing may saturate, the brightest pixel stays 2 % below a full well.
        full = reached * torch.where(shares == 0, 1.02, 1.0)
    level = full.reshape(wide)
    # Two full wells saturate in any case; the limit keeps numbers small.
    electrons = (value / level).clamp(max=2.0) * well_e
    noise = torch.randn((2, *value.shape), generator=generator, device=generator.device).to(value)
    charge = electrons + electrons.sqrt() * noise[0]
    codes = torch.round(charge / well_e * _TOP + read_lsb * noise[1]).clamp(0, _TOP)
    read = codes / _TOP * level
    # Rounding to whole codes adds the variance 1 / 12. Shot noise is estimated from the value that
    # was read.
    variance = (level / _TOP) ** 2 * (read_lsb**2 + 1 / 12) + level / well_e * read.clamp(min=0)
    return read, masks, variance, codes >= _TOP
