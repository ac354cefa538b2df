"""The emulated sensor as a differentiable table, for training.

The emulator exposes a program once to constant light at many levels. For every pixel of the tile,
the frames give the mean code and its standard deviation over noise and chips. They include gains
and offsets of words, register compression, dark current, noise and the range of the converter.
Crosstalk depends on neighbouring pixels, so it is applied to the light, as in the emulator. Errors
of the readout are alike in neighbouring pixels, so they are cut from whole frames of errors."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
import torch
from torch import Tensor

from nscc.arrays import Array, Floats
from nscc.chips.target import Target
from nscc.words.container import Container
from nscc_runtime.caches import Recent
from nscc_runtime.effects import Selection, selected
from nscc_runtime.effects.parts import CommonCode, Exchange, FixedCodes
from nscc_runtime.light import Light
from nscc_runtime.readout_noise import ReadoutNoise
from nscc_runtime.request import Request
from nscc_runtime.sensor import Sensor
from nscc_runtime.simulate import simulate
from nscc_training.draws import normal, uniform
from nscc_training.gradients import rounded, saturated
from nscc_training.sensor_model import SensorModel, laid

_DARK_LEVELS = 16
"""Number of light levels below those at which the sensor compresses, spaced geometrically."""
_DARKEST = 1 / 64
"""Exposure, in full wells, of the longest shutter at the lowest nonzero light level."""
_BENT = (0.85, 1.15)
"""Range in full wells in which registers and PIX compress; light levels are dense there."""
_DENSE = 1.03
"""Ratio of neighbouring light levels where they are dense."""
_RECENT = 64
"""Number of tables that are kept: a search compares a few codes with the present ones."""
CHIPS, _FRAMES = 8, 2
"""Number of chips, and number of frames of each chip."""
_READ_CHIPS = 16
"""Number of chips whose errors of the readout are kept, one frame of each."""


@dataclass(frozen=True, eq=False)
class EmulatedSensor:
    """The response to constant light at the pixels (r, c) of a tile.

    `light_e` (K,) increases from 0, in electrons over the frame. `share` (r, c) is the fraction of
    the frame in which each pixel was open. `code` and `spread` (K, r, c) are the mean and standard
    deviation of converter codes above the offset, before the errors of the readout. `full` (K, r,
    c) is the fraction of pixels marked as saturated. `readout` float16 (chips, rows, cols) are
    errors of the readout of whole arrays, in converter codes: noise, fixed pattern and common
    error. `crosstalk` is the fraction of charge that each of the four neighbours receives."""

    light_e: Tensor
    share: Tensor
    code: Tensor
    spread: Tensor
    full: Tensor
    readout: Tensor
    crosstalk: float

    def smeared(self, light: Tensor) -> Tensor:
        """Return light (.., rows, cols) after crosstalk: each pixel exchanges the fraction
        `crosstalk` with each of its four neighbours. At the border no light is lost, and the sum of
        all pixels stays."""
        down = light[..., 1:, :] - light[..., :-1, :]
        right = light[..., :, 1:] - light[..., :, :-1]
        pad = torch.nn.functional.pad
        # The difference to the neighbour below (or right) flows into a pixel, and out of the
        # neighbour.
        flow = pad(down, (0, 0, 0, 1)) - pad(down, (0, 0, 1, 0))
        flow = flow + pad(right, (0, 1)) - pad(right, (1, 0))
        return light + self.crosstalk * flow

    def read_out(
        self, exposure_e: Tensor, model: SensorModel, generator: torch.Generator | None
    ) -> tuple[Tensor, Tensor]:
        """Return the converter codes above the offset of an exposure, float32 (batch, rows, cols),
        and the mask of saturated pixels, bool of the same shape.

        `exposure_e` (float64, of this shape) are the electrons of the open slots. The table is
        entered at the constant light that gave a pixel this exposure, also if other slots are open
        now. `model` defines the range of converter codes. Without a generator there is neither
        noise nor variation between pixels, and a pixel is saturated if that is likelier than not.
        Gradients pass through the rounding."""
        open_share = laid(self.share, *exposure_e.shape[-2:]).to(exposure_e)
        steady = exposure_e / open_share.clamp(min=1e-9)
        known = self.light_e.to(exposure_e)
        after = torch.searchsorted(known, steady.detach().contiguous(), right=True)
        # Beyond the last level, the codes stay at those of the last level (`fraction` is at most
        # 1).
        after = after.clamp(1, len(known) - 1)
        fraction = (steady - known[after - 1]) / (known[after] - known[after - 1])
        codes = self._between(self.code, after, fraction.clamp(max=1))
        known_part = fraction.detach().clamp(max=1)
        full = self._between(self.full, after, known_part)
        marked: Tensor = full > 0.5
        if generator is not None:
            sigma = self._between(self.spread, after, known_part)
            errors = sigma * normal(codes, generator, torch.float32)
            errors = errors + self._readout_errors(codes, generator)
            codes = codes + model.noise_factor * errors
            marked = full > uniform(full, generator)
        codes = rounded(codes) + model.adc_offset_lsb
        codes = saturated(codes, low=0.0, high=float(model.top_code), slope=model.slope)
        return codes.float() - model.adc_offset_lsb, marked

    def _readout_errors(self, codes: Tensor, generator: torch.Generator) -> Tensor:
        """Return the errors of the readout, in converter codes, in the shape of `codes` (.., rows,
        cols). Each frame gets the errors of a random chip, from a random place of its array. Frames
        larger than the array repeat it."""
        places: list[Tensor] = []
        for axis, size in zip((-2, -1), codes.shape[-2:], strict=True):
            whole = self.readout.shape[axis]
            first = uniform(codes, generator, codes.shape[:-2]) * (max(whole - size, 0) + 1)
            place = first.long()[..., None] + torch.arange(size, device=codes.device)
            places.append(place % whole)
        chip = (uniform(codes, generator, codes.shape[:-2]) * len(self.readout)).long()
        errors = self.readout.to(codes.device)
        return errors[chip[..., None, None], places[0][..., None], places[1][..., None, :]].to(
            codes
        )

    def _between(self, table: Tensor, after: Tensor, fraction: Tensor) -> Tensor:
        """Return the values (batch, rows, cols) of a `table` (K, r, c) between its levels `after` -
        1 and `after`: the first plus `fraction` of the difference.

        `after` is the index of the upper level, at least 1, and `fraction` is 0 to 1; both are
        (batch, rows, cols); the tile of the table repeats over the pixels."""
        rows, cols = after.shape[-2:]
        down = torch.arange(rows, device=after.device).reshape(-1, 1) % table.shape[1]
        across = torch.arange(cols, device=after.device) % table.shape[2]
        table = table.to(fraction)
        low, high = table[after - 1, down, across], table[after, down, across]
        return low + fraction * (high - low)


class MeasuredTables:
    """The emulated sensor (`table`) of the shutters in use, and a few that were in use before, so
    that returning to their shutters needs no new measurement.

    `table` is None before the first measurement."""

    def __init__(self) -> None:
        """Begin without a table."""
        self.table: EmulatedSensor | None = None
        self._shutters: Tensor | None = None
        self._recent = Recent(_RECENT)

    def use(self, shutters: Tensor, measure: Callable[[], EmulatedSensor]) -> None:
        """Set `table` to the emulated sensor of a tile of shutters (N, r, c). Call `measure` only
        if none of the recent `_RECENT` tables is for these shutters."""
        self._shutters = shutters.detach().cpu().to(torch.uint8)
        self.table = self._recent.of(self._shutters.numpy().tobytes(), measure)

    def arrange(self, shutters: Tensor, measure: Callable[[], EmulatedSensor]) -> None:
        """Set `table` to the emulated sensor of a tile that has the present shutters at other
        places. Only the first call calls `measure`, for the tile as it is.

        The response depends on the words of a program, and so on its shutters, but not on their
        places: pixels with equal shutters have the response of the first of them."""
        table = self.table or measure()
        wanted = shutters.detach().cpu().to(torch.uint8)
        known, self._shutters = wanted if self._shutters is None else self._shutters, wanted
        equal = wanted.flatten(1).T[:, None] == known.flatten(1).T
        places = equal.all(dim=2).int().argmax(dim=1).reshape(wanted.shape[1:])
        names = "share", "code", "spread", "full"
        tables = {name: getattr(table, name).flatten(-2)[..., places] for name in names}
        self.table = replace(table, **tables)

    def tensors(self) -> dict[str, Tensor]:
        """Return the tensors that a checkpoint stores, by name: `shutters` and the fields of
        `table`. Return an empty dictionary before the first measurement."""
        if self.table is None or self._shutters is None:
            return {}
        fields = {key: torch.as_tensor(value) for key, value in vars(self.table).items()}
        return {"shutters": self._shutters, **fields}

    def set(self, tensors: dict[str, Tensor]) -> None:
        """Use the table that `tensors` of a checkpoint hold; with empty `tensors`, change nothing.
        The names are those of `tensors()`. Raise KeyError if some are missing."""
        if tensors:
            names = "light_e", "share", "code", "spread", "full", "readout"
            arrays = {name: tensors[name] for name in names}
            table = EmulatedSensor(**arrays, crosstalk=float(tensors["crosstalk"]))
            self.use(tensors["shutters"], lambda: table)


def emulated_sensor(
    container: Container, tile: tuple[int, int], sensor: Sensor, effects: str, chips: int = CHIPS
) -> EmulatedSensor:
    """Measure the emulated sensor of a program with one bucket whose codes repeat a tile (rows,
    cols).

    `effects`, and the errors for a wrong one, are as for the option `--effects`. The measurement
    takes seconds, or half a minute if each pixel has its own shutter. Fewer `chips` are faster, but
    sample less of the variation between chips. At least one pixel of the tile opens."""
    chosen = selected(effects)
    assert container.pixel_codes is not None
    slot_s = np.asarray(container.slot_us)
    lanes = container.table.shutter_of_code[container.pixel_codes[: tile[0], : tile[1]]]
    share = (container.table.shutters[:, 0] @ slot_s / slot_s.sum())[lanes]
    opened = share[share > 0]
    full_e = float(sensor.full_well_e)
    first, last = _BENT[0] * full_e / opened.max(), _BENT[1] * full_e / opened.min()
    weak = np.geomspace(_DARKEST * full_e / opened.max(), first, _DARK_LEVELS, endpoint=False)
    # At least both ends; rounding down makes the ratio of neighbours `_DENSE` or a little more.
    dense = np.geomspace(first, last, 2 + int(np.log(last / first) / np.log(_DENSE)))
    light_e = np.concatenate([[0.0], weak, dense])
    # The converter's noise is exposed, because the mean of codes that are rounded without noise is
    # wrong; its variance is subtracted, because errors of the readout are drawn apart.
    exposed_effects = chosen.without(*chosen.names(FixedCodes, CommonCode))
    code, spread, full = _measured(container, tile, light_e, sensor, exposed_effects, chips)
    spread = np.sqrt(np.maximum(spread**2 - exposed_effects.converter_lsb(sensor) ** 2, 0.0))
    exchange = chosen.find_part(Exchange)
    crosstalk = 0.0 if exchange is None else float(exchange.fraction(sensor))
    size = (container.target.rows, container.target.cols)
    arrays = light_e, share, code, spread, full
    levels, shares, codes, spreads, marked = map(torch.from_numpy, arrays)
    return EmulatedSensor(
        levels,
        share=shares,
        code=codes,
        spread=spreads,
        full=marked,
        readout=_readout_frames(sensor, chosen, size),
        crosstalk=crosstalk,
    )


@lru_cache(4)
def _readout_frames(sensor: Sensor, effects: Selection, size: tuple[int, int]) -> Tensor:
    """Return errors of the readout, in converter codes, float16 (chips, rows, cols), of one frame
    of `size` (rows, cols) for each of `_READ_CHIPS` chips. They do not depend on the program, so
    all tables of a search share them."""
    frames = np.empty((_READ_CHIPS, *size), np.float16)
    for chip, frame in enumerate(frames):
        frame[:] = ReadoutNoise.of(sensor, effects, chip, size).codes(chip, frame=0, buckets=1)[0]
    return torch.from_numpy(frames)


def _measured(
    container: Container,
    tile: tuple[int, int],
    light_e: Floats,
    sensor: Sensor,
    effects: Selection,
    chips: int,
) -> tuple[Floats, Floats, Floats]:
    """Return the mean and the standard deviation of converter codes above the offset, and the
    fraction of saturated pixels, each (K, r, c), at K light levels.

    `container` is the program, exposed under `effects`. `light_e` (K,) are the levels in electrons
    over the frame. They are exposed side by side, each on columns of whole tiles, in as many scenes
    as needed. The number of each of `chips` is its seed."""
    rows, cols = container.target.rows, container.target.cols
    down, across = rows // tile[0], cols // tile[1]
    times = max(1, across // len(light_e))
    levels_per_scene = across // times
    slot_s = np.asarray(container.slot_us)
    sums, squares, full = np.zeros((3, len(light_e), *tile))
    for first in range(0, len(light_e), levels_per_scene):
        levels = light_e[first : first + levels_per_scene]
        # Columns left over at the right have the last level, and are ignored.
        row = np.full(cols, levels[-1])
        width = times * tile[1]
        row[: len(levels) * width] = np.repeat(levels, width)
        still = np.broadcast_to(row, (rows, cols)).astype(np.float32)
        light = Light.of_still(np.ascontiguousarray(still), slot_s / slot_s.sum())
        level_slice = slice(first, first + len(levels))

        def mean(
            values: Array, used: int = len(levels) * width, count: int = len(levels)
        ) -> Floats:
            """Return the mean of a quantity (frames, rows, cols) over frames and over the copies of
            the tile, (count, r, c).

            `used` is the number of columns with the `count` levels of the scene. Both are defaults
            so that they keep the values of this turn of the loop."""
            tiles = values[:, : down * tile[0], :used].astype(np.float64)
            tiles = tiles.reshape(_FRAMES, down, tile[0], count, times, tile[1])
            return np.asarray(tiles.mean(axis=(0, 1, 4)).transpose(1, 0, 2))

        for chip in range(chips):
            request = Request.of(effects=effects, seed=chip, device_seed=chip, repeat=_FRAMES)
            frame = simulate(container, light, sensor, request).frame
            codes = np.asarray(
                frame.frame[..., 0, :, :] - sensor.adc_offset_lsb, np.float32
            ).astype(np.float64)
            sums[level_slice] += mean(codes) / chips
            squares[level_slice] += mean(np.square(codes)) / chips
            full[level_slice] += mean(frame.saturated[..., 0, :, :]) / chips
    # Subtract the variance of rounding, 1/12: codes are rounded when the table is used.
    variance = np.maximum(squares - np.square(sums) - 1 / 12, 0)
    return sums, np.sqrt(variance), full


def light_on_array(light_e: Array, slots: int, target: Target) -> Light:
    """Return `light_e`, electrons over a frame (rows, cols) or per slot (N, rows, cols), as light
    on the array of `target`.

    The light of a frame is spread evenly over `slots` slots; light per slot keeps its own N slots.
    A scene smaller than the array is extended by its edge pixels; of a larger scene the upper left
    part is taken."""
    visible = light_e[..., : target.rows, : target.cols].astype(np.float32)
    missing = (target.rows - visible.shape[-2], target.cols - visible.shape[-1])
    margins = [(0, 0)] * (visible.ndim - 2) + [(0, count) for count in missing]
    padded = np.pad(visible, margins, mode="edge")
    if padded.ndim == 2:
        return Light.of_still(padded, np.full(slots, 1 / slots))
    return Light.of_clip(padded)
