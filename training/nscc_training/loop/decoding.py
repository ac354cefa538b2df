"""Capture and decode scenes with a run's decoder, on the sensor model or the emulated chip."""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter

import numpy as np
import torch
from torch import Tensor

from nscc.arrays import Array, Bools, Bytes, Floats, Floats32
from nscc.words.container import Container
from nscc_runtime import capture
from nscc_runtime.emulator import expose
from nscc_runtime.looked_light import OPEN
from nscc_runtime.request import Request
from nscc_runtime.sensor import Sensor
from nscc_runtime.simulate import simulate
from nscc_training.code_choices import LOOKS
from nscc_training.emulated import light_on_array
from nscc_training.looking_model import looked
from nscc_training.loop.setup import TrainingSetup
from nscc_training.sensor_model import SensorModel, filled, frame_of, laid, read_out, shared_out

_BLOCK, _MARGIN = 256, 32
"""Side in pixels of the blocks in which large frames are decoded, and the margin of the blocks.

The margin is larger than the receptive field of decoders."""


Decode = Callable[[Array, int], tuple[Floats, float]]
"""A function that captures and decodes a scene, given its light in electrons and its index.

The light is over the frame (rows, cols), or per slot (N, rows, cols). The function returns the
decoded light in electrons, or a score for each class, and the seconds that the decoder took. Each
scene has its own noise, which a seed and the scene's index determine: up to 1000 scenes share none
with another seed's."""


def by_model(
    setup: TrainingSetup,
    tile: Tensor | None = None,
    model: SensorModel | None = None,
    seed: int = 0,
) -> Decode:
    """Return a function that captures a scene by a sensor model and decodes it.

    `tile` (N, r, c) and `model` replace the run's shutters and sensor model; None keeps them. For
    pixels that look, `tile` has their boundaries and levels."""
    shown = setup.encoder.hard().cpu() if tile is None else tile.cpu()
    sensor = setup.model if model is None else model

    @torch.no_grad()
    def decode(light_e: Array, index: int) -> tuple[Floats, float]:
        """Capture and decode a scene."""
        if setup.encoder.spec.kind == LOOKS:
            generator = torch.Generator().manual_seed(1000 * seed + index)
            light = torch.as_tensor(light_e, dtype=torch.float32)[None]
            step_e = setup.target.electrons_per_step
            codes, share = looked(light, shown, setup.slots, step_e, sensor, generator)
            frame, shutters = codes[0] - sensor.adc_offset_lsb, share
        else:
            frame = frame_of(light_e, shared_out(shown, setup.buckets), sensor, 1000 * seed + index)
            shutters = laid(shown, *frame.shape[-2:])
        begin = perf_counter()
        result = _decoder_output(setup, setup.model.relative(frame), shutters)
        seconds = perf_counter() - begin
        return result.astype(np.float64) * setup.unit_e, seconds

    return decode


def by_chip(
    setup: TrainingSetup, effects: str, sensor: Sensor | None = None, seed: int = 0
) -> Decode:
    """Return a function that captures a scene on the emulated chip with `effects` and decodes it.

    Equals `nscc run` followed by `nscc reconstruct`. `sensor` replaces the run's sensor; None keeps
    it. `effects` are written as for `--effects`. `seed` is also that of the chip. A scene smaller
    than the array is extended by its edge pixels; of a larger scene the upper left part is
    exposed."""
    container, used = setup.compiled().built, setup.sensor if sensor is None else sensor

    def decode(light_e: Array, index: int) -> tuple[Floats, float]:
        """Capture and decode a scene."""
        light = light_on_array(light_e, setup.slots, container.target)
        request = Request.of(effects=effects, seed=1000 * seed + index, device_seed=seed)
        frame = simulate(container, light, used, request).frame
        begin = perf_counter()
        opened = frame.told.get(OPEN)
        # Pixels that look report the slots in which they were open.
        share = None if opened is None else (opened[0] / setup.slots).astype(np.float32)
        bucket = 0 if setup.buckets == 1 else ...  # decoders of one bucket expect no axis of them
        rows, cols = light_e.shape[-2:]
        visible_part = np.s_[..., :rows, :cols]
        codes, saturated = frame.frame[bucket], frame.saturated[bucket]
        if setup.classes:  # the continuation of the scene has no class
            result = decoded_frame(setup, codes[visible_part], saturated[visible_part])
        else:
            result = decoded_frame(setup, codes, saturated, share)[visible_part]
        return result.astype(np.float64), perf_counter() - begin

    return decode


@torch.no_grad()
def scene_by_words(
    setup: TrainingSetup, container: Container, light_e: Array
) -> tuple[Floats, float]:
    """Capture a scene as the words of a program expose it, without noise, and decode it. Return the
    light in electrons and the seconds of both.

    `light_e` is in electrons over the frame (rows, cols), or per slot (N, rows, cols). A scene
    larger than the array of the chip is cut."""
    rows, cols = light_e.shape[-2:]
    light = light_on_array(light_e, setup.slots, container.target)
    ideal = setup.model.noiseless()
    begin = perf_counter()
    if setup.encoder.spec.kind == LOOKS:
        shot = capture(container, light)
        codes = torch.from_numpy(shot.frame[0, :rows, :cols].astype(np.float32))
        share = np.cumsum([0.0, *container.slot_us]) / sum(container.slot_us)
        opened = share[shot.told[OPEN][0, :rows, :cols]].astype(np.float32)
        shutters = torch.from_numpy(opened)[None]
    else:
        exposure = expose(container, light).exposure_e[:, :rows, :cols].copy()
        codes = read_out(torch.from_numpy(exposure), ideal)
        codes = codes if setup.buckets > 1 else codes[0]
        shutters = laid(setup.encoder.hard().cpu(), rows, cols)
    relative = setup.model.relative(codes - ideal.adc_offset_lsb)
    result = _decoder_output(setup, relative, shutters)
    return result.astype(np.float64) * setup.unit_e, perf_counter() - begin


def decoded_frame(
    setup: TrainingSetup,
    frame: Bytes | Floats32,
    saturated: Bools,
    share: Floats32 | None = None,
    corner: tuple[int, int] = (0, 0),
) -> Floats32:
    """Decode the converter codes of a frame. Return electrons over the frame (rows, cols),
    electrons per slot (T, rows, cols), or a number for each class.

    `frame` holds converter codes, (rows, cols), or (2, rows, cols) for two buckets. `saturated`, of
    the same shape, marks codes that count as full. `share` (rows, cols) is the open fraction of
    each pixel, for pixels that look; None for others. `corner` (row, column) is the place of the
    first pixel on the array, which decides its code. Large frames are decoded in blocks of `_BLOCK`
    pixels."""
    rows, cols = frame.shape[-2:]
    if setup.classes:
        opened = shutters_at(setup, (rows, cols), corner)
        return _decoded_block(setup, frame, saturated, opened)
    light: Floats32 | None = None
    array = (setup.target.rows, setup.target.cols)
    for block_row in range(0, rows, _BLOCK):
        for block_col in range(0, cols, _BLOCK):
            down, across = (
                slice(max(at - _MARGIN, 0), min(at + _BLOCK + _MARGIN, most))
                for at, most in ((block_row, rows), (block_col, cols))
            )
            codes, full = frame[..., down, across], saturated[..., down, across]
            first = (down.start + corner[0]) % array[0], (across.start + corner[1]) % array[1]
            if share is None:
                opened = shutters_at(setup, codes.shape[-2:], first)
            else:
                opened = torch.from_numpy(share[None, down, across].copy())
            block = _decoded_block(setup, codes, full, opened)
            # The block without its margins.
            inside = block[..., block_row - down.start :, block_col - across.start :][
                ..., :_BLOCK, :_BLOCK
            ]
            if light is None:
                light = np.empty((*block.shape[:-2], rows, cols), np.float32)
            light[..., block_row : block_row + _BLOCK, block_col : block_col + _BLOCK] = inside
    assert light is not None  # a frame has pixels
    return light


@torch.no_grad()
def _decoded_block(
    setup: TrainingSetup,
    frame: Bytes | Floats32,
    saturated: Bools,
    shutters: Tensor,
) -> Floats32:
    """Return the decoded light in electrons (or scores of classes) of one block of a frame.

    `frame` ([2,] rows, cols) holds converter codes, `saturated`, of the same shape, marks the
    pixels that count as full. `shutters` (N, rows, cols) are those of this block; for pixels that
    look, their open fraction (1, rows, cols)."""
    shutters = shutters.to(setup.device)
    codes = torch.from_numpy(frame.astype(np.float32)).to(setup.device)
    relative = setup.model.relative(codes - setup.model.adc_offset_lsb)
    # Saturated pixels may read less: registers compress, and light lowers the reset level.
    full = torch.from_numpy(np.ascontiguousarray(saturated)).to(setup.device)
    if setup.encoder.spec.kind != LOOKS:
        relative = filled(relative, full, shared_out(shutters, setup.buckets))
    return np.asarray(_decoder_output(setup, relative, shutters) * setup.unit_e, np.float32)


def _decoder_output(setup: TrainingSetup, relative: Tensor, shutters: Tensor) -> Floats32:
    """Return the decoder's output, float32, for one frame `relative` to a full well ([2,] rows,
    cols) with its `shutters` (N, r, c), or the open fractions (1, rows, cols) of pixels that look:
    light (rows, cols) or (N, rows, cols), or (classes,)."""
    frame = relative[None].to(setup.device)
    output: Tensor = setup.decoder(frame, shutters.to(setup.device))[0]
    return np.asarray(output.float().cpu().numpy())


def shutters_at(
    setup: TrainingSetup, shape: tuple[int, ...], corner: tuple[int, int] = (0, 0)
) -> Tensor:
    """Return the run's shutters (N, rows, cols) for a region of the size `shape` (rows, cols),
    whose first pixel is at `corner` of the array. Beyond the array they repeat."""
    target = setup.target
    array = laid(setup.encoder.hard(), target.rows, target.cols)
    rows, cols = (
        (torch.arange(side) + at) % most
        for side, at, most in zip(shape, corner, (target.rows, target.cols), strict=True)
    )
    return array[:, rows][:, :, cols]
