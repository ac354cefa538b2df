"""The compiled loop of the emulator: blocks of pixels through a whole frame.

A block is a range of consecutive pixels that starts at a multiple of 64: an array of one row
(`nscc_runtime.emulator.array_loop`). A pixel's result depends only on that pixel, so results do not
depend on the block size."""

from __future__ import annotations

from typing import Annotated, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.emulator.array_loop import (
    ArrayShape,
    ArrayWord,
    row_of,
    run_words,
)
from nscc_runtime.loop import (
    Bytes,
    Floats,
    Floats32,
    Ints,
    Words,
    Written,
    compiled,
    loop,
    record,
)
from nscc_runtime.sizes_loop import LightMatrix

_GOLDEN = 0.6180339887498949


@compiled
def _hash(seed: np.uint64, stream: int, counter: int) -> np.uint64:
    """Return a 64-bit hash of (seed, stream, counter): two rounds of splitmix64's finaliser."""
    z = seed + np.uint64(stream + 1) * np.uint64(0x9E37_79B9_7F4A_7C15)
    for step in range(2):
        z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58_476D_1CE4_E5B9)
        z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D0_49BB_1331_11EB)
        z = z ^ (z >> np.uint64(31))
        if step == 0:
            z += np.uint64(counter)
    return z


@compiled
def _start(
    shape: ArrayShape, pix: int, seed: np.uint64, first: int, values: Floats, planes: Words
) -> None:
    """Set arbitrary initial values, as `nscc_runtime.emulator.capture` describes them.

    The row `shape.total` contains the light of the whole frame; the row `shape.part` is
    overwritten. The register after PIX is set to minus the reset level."""
    words, pixels = shape.plane_words, 64 * shape.plane_words
    for p in range(shape.flag + 1):
        for g in range(words):
            planes[p * words + g] = _hash(seed, p, first // 64 + g)
    for i in range((shape.flag + 1) * words, (shape.flag + 3) * words):
        planes[i] = np.uint64(0)
    # One random number u per pixel; the fractional part of K u serves as another for each large K.
    uniforms, light = shape.part, shape.total
    for i in range(pixels):
        bits = _hash(seed, shape.flag + 1, first + i)
        values[uniforms + i] = float(np.int64(bits >> np.uint64(11))) * 2.0**-53
    for r in range(pix + 2):
        row, lowest = row_of(shape, r, 0), -1.0 if r < pix else 1.0
        sign = -1.0 if r > pix else 1.0
        for i in range(pixels):
            turn = values[uniforms + i] * (16384.0 * (1.0 + r * _GOLDEN))
            spread = 2.0 * (turn - np.floor(turn)) - 1.0
            value = abs(spread) + 1.0
            if values[light + i] > 0.0:
                value = values[light + i] * (0.25 + 0.5 * abs(spread))
            values[row + i] = sign * (value * lowest if spread < 0.0 else value)


@compiled
def _same_light(light: LightMatrix, slot: int) -> bool:
    """Return whether a slot has the light of the slot before it."""
    if slot == 0:
        return False
    before, start = light.row_start[slot - 1], light.row_start[slot]
    stop = light.row_start[slot + 1]
    if stop - start != start - before:
        return False
    for k in range(stop - start):
        if light.frame_index[before + k] != light.frame_index[start + k]:
            return False
        if light.weight[before + k] != light.weight[start + k]:
            return False
    return True


@compiled
def _add_frame(
    values: Floats, out: int, frames: Floats32, frame: int, length: int, factor: float
) -> None:
    """Add `factor` times the pixels of a frame to the row at `out`."""
    for i in range(length):
        values[out + i] += factor * frames[frame + i]


class EmulatedProgram(NamedTuple):
    """The words of kernel k are words[kernel_start[k] : kernel_start[k + 1]]. Boundary n launches
    launch_kernel[launch_start[n] : launch_start[n + 1]], in that order. `code_planes`: initial
    values of the planes numbered `code_rows`."""

    words: Annotated[NDArray[Any], ArrayWord]
    operands: Ints
    kernel_start: Ints
    launch_start: Annotated[Ints, "slots+2"]
    launch_kernel: Ints
    code_planes: Annotated[Words, "code_registers code_words"]
    code_rows: Annotated[Ints, "code_registers"]


@record
class PixelRange:
    """The pixels `begin` (a multiple of 64) to `end` - 1 of `pixels`, which are exposed in blocks
    of `block`, and sizes. `pix`: the number of the register PIX."""

    slots: int
    pixels: int
    begin: int
    end: int
    block: int
    frames: int
    code_registers: int
    buckets: int
    seed: np.uint64
    pix: int


@compiled
def _expose_block(
    chosen: PixelRange, first: int, length: int, shape: ArrayShape, program: EmulatedProgram,
    light: LightMatrix, frame_weight: Floats, planes: Words, values: Floats, marks: Bytes,
    marked: Ints, charge: Floats32,
) -> None:  # fmt: skip
    """Expose `length` pixels from pixel number `first` on: run the words of all slots."""
    slots, pixels = chosen.slots, chosen.pixels
    pix, total = row_of(shape, chosen.pix, 0), shape.total
    for i in range(64 * shape.plane_words):
        values[total + i] = 0.0
    for k in range(chosen.frames):
        _add_frame(values, total, light.frames, k * pixels + first, length, frame_weight[k])
    _start(shape, chosen.pix, chosen.seed, first, values, planes)
    for c in range(chosen.code_registers):
        source = c * ((pixels + 63) // 64) + first // 64
        for g in range((length + 63) // 64):
            planes[program.code_rows[c] * shape.plane_words + g] = program.code_planes[source + g]
    for n in range(slots + 1):
        for at in range(program.launch_start[n], program.launch_start[n + 1]):
            kernel = program.launch_kernel[at]
            run_words(
                shape, program.words, program.kernel_start[kernel],
                program.kernel_start[kernel + 1], program.operands, values, marks, planes, marked,
            )  # fmt: skip
        if n == slots:
            break
        start, stop = light.row_start[n], light.row_start[n + 1]
        if stop - start == 1 and light.weight[start] == 1.0:
            frame = light.frame_index[start] * pixels + first
            for i in range(length):
                values[pix + i] += light.frames[frame + i]
            continue
        if not _same_light(light, n):
            for i in range(length):
                values[total + i] = 0.0
            for k in range(start, stop):
                frame = light.frame_index[k] * pixels + first
                _add_frame(values, total, light.frames, frame, length, light.weight[k])
            for i in range(length):
                charge[i] = np.float32(values[total + i])
        for i in range(length):
            values[pix + i] += charge[i]


@loop
def expose_pixels(
    chosen: PixelRange,
    shape: ArrayShape,
    program: EmulatedProgram,
    light: LightMatrix,
    frame_weight: Annotated[Floats, "frames"],
    readout_rows: Annotated[Ints, "buckets"],
    readout_gain: Annotated[Floats, "buckets"],
    planes: Written[Words],
    values: Written[Floats],
    marks: Written[Bytes],
    marked: Written[Ints],
    charge: Written[Floats32],
    exposure: Written[Annotated[Floats, "buckets pixels"]],
) -> None:
    """Expose pixels and write the results into `exposure`.

    `frame_weight`: the weight of each frame in the light of the whole exposure. `planes` to
    `charge` are working memory for a block; `values` is 0 at first."""
    first = chosen.begin
    while first < chosen.end:
        length = min(chosen.block, chosen.end - first)
        _expose_block(
            chosen, first, length, shape, program, light, frame_weight, planes, values, marks,
            marked, charge,
        )  # fmt: skip
        for k in range(chosen.buckets):
            row, gain = row_of(shape, readout_rows[k], 0), readout_gain[k]
            out = k * chosen.pixels + first
            for i in range(length):
                # -0 + 0 is +0.
                exposure[out + i] = values[row + i] * gain + 0.0
        first += chosen.block
