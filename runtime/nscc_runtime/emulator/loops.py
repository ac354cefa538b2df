"""The compiled loop of the emulator: blocks of pixels through a whole frame.

A block is a range of consecutive pixels that starts at a multiple of 64: an array of one row
(`nscc_runtime.emulator.array_loop`). A pixel's result depends only on that pixel, so results do not
depend on the block size. If words reach neighbours, the whole array is one block with all its
rows."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np

from nscc.arrays import Array, Floats, Floats32, Ints
from nscc_runtime.emulator.array_loop import (
    ArrayShape,
    ArrayState,
    ArrayWord,
    clear_flag_outside,
    plane_of,
    row_of,
    run_words,
)
from nscc_runtime.light import LightMatrix
from nscc_runtime.loop import Words, Written, compiled, loop, record

_GOLDEN = 0.6180339887498949
_MOST_START_E = 1e38
"""Limit of initial analog values: float32 holds it."""


@compiled
def _hash(seed: np.uint64, stream: int, counter: int) -> np.uint64:
    """Return a 64-bit hash of (seed, stream, counter), each at least 0: two rounds of splitmix64's
    finaliser. Arithmetic is modulo 2**64."""
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
    shape: ArrayShape, pix: int, seed: np.uint64, first: int, y: int, values: Floats, planes: Words
) -> None:
    """Set all registers of the pixels of row `y` to arbitrary values, drawn with `seed`, as
    `nscc_runtime.emulator.chip_program` describes them.

    `pix` is the number of PIX among the analog registers. `first` is the number of the row's first
    pixel in the whole array. `values` (electrons) and `planes` (64 pixels a word) hold the analog
    and the digital registers. The row at `shape.total` must contain the light of the whole frame;
    the row at `shape.part` is overwritten. The register after PIX (the photodiode) is set to minus
    the reset level."""
    # Digital registers up to FLAG are random; the two planes after it begin with 0.
    for p in range(shape.flag + 3):
        for g in range(shape.plane_words):
            bits = _hash(seed, p, first // 64 + g)
            planes[plane_of(shape, p, y) + g] = bits if p <= shape.flag else np.uint64(0)
    clear_flag_outside(shape, planes, y)
    # One random number u per pixel; the fractional part of K u serves as another for each large K.
    uniforms, light = shape.part, shape.total
    for i in range(shape.cols):
        bits = _hash(seed, shape.flag + 1, first + i)
        values[uniforms + i] = float(np.int64(bits >> np.uint64(11))) * 2.0**-53
    for r in range(pix + 2):
        # Registers take either sign, PIX none below 0, and minus the reset level none above 0.
        row, lowest = row_of(shape, r, y), -1.0 if r < pix else 1.0
        sign = -1.0 if r > pix else 1.0
        for i in range(shape.cols):
            turn = values[uniforms + i] * (16384.0 * (1.0 + r * _GOLDEN))
            spread = 2.0 * (turn - np.floor(turn)) - 1.0
            value = abs(spread) + 1.0
            if values[light + i] > 0.0:
                value = values[light + i] * (0.25 + 0.5 * abs(spread))
            # With few bits, sums with light are as exact as those of light alone.
            value = float(np.float32(min(value, _MOST_START_E)))
            values[row + i] = sign * (value * lowest if spread < 0.0 else value)


@compiled
def same_light(light: LightMatrix, slot: int) -> bool:
    """Return whether slot number `slot` has the same entries of `light`, frames and weights, as the
    slot before it; False for slot 0."""
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
    """Add `factor` times `length` pixels of light, from frames[frame] on, to the row that begins at
    values[out]."""
    for i in range(length):
        values[out + i] += factor * frames[frame + i]


class EmulatedWords(NamedTuple):
    """The words of kernel k are words[kernel_start[k] : kernel_start[k + 1]]. Boundary n launches
    launch_kernel[launch_start[n] : launch_start[n + 1]], in that order. A launch is the start of a
    kernel, a list of words."""

    words: Annotated[Array, ArrayWord]
    kernel_start: Ints
    launch_start: Annotated[Ints, "slots+2"]
    launch_kernel: Ints


class RegisterBits(NamedTuple):
    """Rows of bits of digital registers, 64 pixels a number. `loaded`: initial values of the
    registers with the numbers `loaded_numbers`. `read`: gets the final values of the registers with
    the numbers `read_numbers`. Either may be empty."""

    loaded: Annotated[Words, "loads block_rows row_words"]
    loaded_numbers: Annotated[Ints, "loads"]
    read: Written[Annotated[Words, "reads block_rows row_words"]]
    read_numbers: Annotated[Ints, "reads"]


class KeptValues(NamedTuple):
    """Analog registers that begin with the values that the previous frame left: electrons `kept` of
    the registers with the numbers `kept_numbers`; possibly none."""

    kept: Annotated[Floats, "keeps pixels"]
    kept_numbers: Annotated[Ints, "keeps"]


@record
class PixelRange:
    """The pixels `begin` (a multiple of 64) to `end` - 1 of `pixels`, which are exposed in blocks
    of `block_rows` rows, and sizes. `row_words`: 64-bit words of a row of `RegisterBits`. `frames`:
    frames of light, of `lit_pixels` pixels each, from pixel `first_lit` on. `loads`, `reads`:
    digital registers that are loaded and read. `registers`: analog registers that are read.
    `keeps`: those that keep values. `seed`: of the arbitrary values. `pix`: the number of the
    register PIX (the photodiode)."""

    slots: int
    pixels: int
    begin: int
    end: int
    block_rows: int
    row_words: int
    frames: int
    lit_pixels: int
    first_lit: int
    loads: int
    reads: int
    registers: int
    keeps: int
    seed: np.uint64
    pix: int


@compiled
def _add_slot(
    chosen: PixelRange,
    first: int,
    length: int,
    n: int,
    shape: ArrayShape,
    light: LightMatrix,
    values: Floats,
    charge: Floats32,
) -> None:
    """Add the light of slot n to PIX (the photodiode) of the block that begins with pixel number
    `first`, `length` pixels of each row.

    `charge`: the light of the last weighted slot in this block, row after row; it is computed anew
    only if the slot's light differs from that of the slot before. The row at `shape.total` of
    `values` is overwritten."""
    start, stop, total = light.row_start[n], light.row_start[n + 1], shape.total
    is_same, is_frame = same_light(light, n), stop - start == 1 and light.weight[start] == 1.0
    for y in range(shape.rows):
        pix, pixel, at = row_of(shape, chosen.pix, y), first + y * shape.cols, y * shape.cols
        if is_frame:
            frame = light.frame_index[start] * chosen.lit_pixels + pixel - chosen.first_lit
            for i in range(length):
                values[pix + i] += light.frames[frame + i]
            continue
        if not is_same:
            for i in range(length):
                values[total + i] = 0.0
            for k in range(start, stop):
                frame = light.frame_index[k] * chosen.lit_pixels + pixel - chosen.first_lit
                _add_frame(values, total, light.frames, frame, length, light.weight[k])
            for i in range(length):
                charge[at + i] = np.float32(values[total + i])
        for i in range(length):
            values[pix + i] += charge[at + i]


@compiled
def _expose_block(
    chosen: PixelRange,
    first: int,
    length: int,
    shape: ArrayShape,
    program: EmulatedWords,
    light: LightMatrix,
    frame_weight: Floats,
    bits: RegisterBits,
    before: KeptValues,
    state: ArrayState,
    charge: Floats32,
) -> None:
    """Expose the block that begins with pixel number `first`: set its registers as at the start of
    a frame, run the words of all boundaries, add the light of the slots in between, and copy the
    digital registers that are read into `bits.read`. Analog registers stay in `state`.

    `length`: number of pixels of a row of the block, at most `shape.cols`. `frame_weight`: weight
    of each frame of light in all slots together. `charge` is working memory."""
    words, total, values, planes = (length + 63) // 64, shape.total, state.values, state.planes
    for y in range(shape.rows):
        for i in range(shape.cols):
            values[total + i] = 0.0
        pixel = first + y * shape.cols
        for k in range(chosen.frames):
            frame = k * chosen.lit_pixels + pixel - chosen.first_lit
            _add_frame(values, total, light.frames, frame, length, frame_weight[k])
        _start(shape, chosen.pix, chosen.seed, pixel, y, values, planes)
        for c in range(chosen.loads):
            source = (c * shape.rows + y) * chosen.row_words + first // 64
            out = plane_of(shape, bits.loaded_numbers[c], y)
            for g in range(words):
                planes[out + g] = bits.loaded[source + g]
        for c in range(chosen.keeps):
            row = row_of(shape, before.kept_numbers[c], y)
            for i in range(length):
                values[row + i] = before.kept[c * chosen.pixels + pixel + i]
    for n in range(chosen.slots + 1):
        for at in range(program.launch_start[n], program.launch_start[n + 1]):
            kernel = program.launch_kernel[at]
            run_words(
                shape,
                program.words,
                program.kernel_start[kernel],
                program.kernel_start[kernel + 1],
                state,
            )
        if n < chosen.slots:
            _add_slot(chosen, first, length, n, shape, light, values, charge)
    for y in range(shape.rows):
        for c in range(chosen.reads):
            out = (c * shape.rows + y) * chosen.row_words + first // 64
            source = plane_of(shape, bits.read_numbers[c], y)
            for g in range(words):
                bits.read[out + g] = planes[source + g]


@loop
def expose_without_effects(
    chosen: PixelRange,
    shape: ArrayShape,
    program: EmulatedWords,
    light: LightMatrix,
    frame_weight: Annotated[Floats, "frames"],
    register_numbers: Annotated[Ints, "registers"],
    bits: RegisterBits,
    before: KeptValues,
    state: ArrayState,
    charge: Written[Floats32],
    contents: Written[Annotated[Floats, "registers pixels"]],
) -> None:
    """Expose the pixels of `chosen`, block by block, and write the final `contents`, in electrons,
    of the analog registers with the numbers `register_numbers`, and the bits `bits.read`.

    `frame_weight`: weight of each frame of light in all slots together. `state` (0 at the
    start) and `charge` are working memory for a block."""
    first = chosen.begin
    while first < chosen.end:
        length = min(shape.cols, chosen.end - first)
        _expose_block(
            chosen,
            first,
            length,
            shape,
            program,
            light,
            frame_weight,
            bits,
            before,
            state,
            charge,
        )
        for k in range(chosen.registers):
            for y in range(shape.rows):
                row = row_of(shape, register_numbers[k], y)
                out = k * chosen.pixels + first + y * shape.cols
                for i in range(length):
                    contents[out + i] = state.values[row + i]
        first += shape.rows * shape.cols
