"""The compiled loop of the emulator: a block of pixels through a whole frame, step by step.

A block is a range of consecutive pixels that starts at a multiple of 64. Its planes are 64-bit
words: pixel i is bit i % 64 of word i // 64. Its rows are float64. Plane p starts at p * words in
`planes`, row r at r * 64 * words in `rows`. A pixel's result depends only on that pixel, so results
do not depend on the block size.

Where FLAG differs between pixels, an unchanged value is written back as `old + 0.0`, which changes
at most the sign of a zero. Choosing between two computed values becomes a blend and a plain store.
Choosing the loaded value itself would become a masked store, which takes twice as long (measured on
AMD Zen 3)."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc_runtime.emulator.steps import COLUMNS, Step
from nscc_runtime.loop import (
    Floats,
    Floats32,
    Ints,
    Ints32,
    Words,
    Written,
    compiled,
    loop,
    record,
)

_COMBINE, _STORE = int(Step.COMBINE), int(Step.STORE)
_BUS2, _DIVIDE, _COPY = int(Step.BUS2), int(Step.DIVIDE), int(Step.COPY)
_COMPARE, _COMPARE_MASKED, _BUS = int(Step.COMPARE), int(Step.COMPARE_MASKED), int(Step.BUS)

_NONE, _SOME, _ALL = 0, 1, 2

_GOLDEN = 0.6180339887498949

_ZERO = np.uint64(0)
_ONE = np.uint64(1)
_FULL = np.uint64(0xFFFF_FFFF_FFFF_FFFF)


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
def _any_all(planes: Words, flag: int, words: int) -> int:
    """Return `_NONE`, `_SOME` or `_ALL`: how many pixels of the plane at `flag` are 1."""
    any_bits, all_bits = _ZERO, _FULL
    for i in range(words):
        any_bits |= planes[flag + i]
        all_bits &= planes[flag + i]
    if any_bits == _ZERO:
        return _NONE
    return _ALL if all_bits == _FULL else _SOME


@compiled
def _combine(
    planes: Words, words: int, out: int, operands: Ints, first: int, count: int, flip: np.uint64
) -> None:
    """Set the plane at `out` to the OR of `count` planes operands[first..], XOR `flip`."""
    if count == 0:
        for i in range(words):
            planes[out + i] = flip
        return
    a = operands[first] * words
    if count == 1:
        for i in range(words):
            planes[out + i] = planes[a + i] ^ flip
        return
    b = operands[first + 1] * words
    if count == 2:
        for i in range(words):
            planes[out + i] = (planes[a + i] | planes[b + i]) ^ flip
        return
    for i in range(words):
        planes[out + i] = planes[a + i] | planes[b + i]
    for k in range(2, count - 1):
        a = operands[first + k] * words
        for i in range(words):
            planes[out + i] |= planes[a + i]
    b = operands[first + count - 1] * words
    for i in range(words):
        planes[out + i] = (planes[out + i] | planes[b + i]) ^ flip


@compiled
def _bus2(
    rows: Floats, out: int, a: int, b: int, planes: Words, flag: int, words: int, state: int
) -> None:
    """Set the row at `out` to -(a + b) where FLAG = 1; `out` is neither a nor b."""
    if state == _ALL:
        for i in range(64 * words):
            rows[out + i] = -(rows[a + i] + rows[b + i])
        return
    for g in range(words):
        word = planes[flag + g]
        if word == _ZERO:
            continue
        x, y, z = out + 64 * g, a + 64 * g, b + 64 * g
        for j in range(64):
            old, new = rows[x + j] + 0.0, -(rows[y + j] + rows[z + j])
            rows[x + j] = new if (word >> np.uint64(j)) & _ONE else old


@compiled
def _bus(
    rows: Floats,
    out: int,
    operands: Ints,
    first: int,
    count: int,
    planes: Words,
    flag: int,
    words: int,
) -> None:
    """Set row `out` to -(sum of `count` other rows operands[first..]) where FLAG = 1."""
    for g in range(words):
        word = planes[flag + g]
        if word == _ZERO:
            continue
        for j in range(64):
            i = 64 * g + j
            old, total = rows[out + i] + 0.0, 0.0
            for k in range(count):
                total += rows[operands[first + k] * 64 * words + i]
            rows[out + i] = -total if (word >> np.uint64(j)) & _ONE else old


@compiled
def _divide(
    rows: Floats, out: int, a: int, divisor: float, planes: Words, flag: int, words: int
) -> None:
    """Set the row at `out` to a / divisor where FLAG = 1; `out` is not a."""
    for g in range(words):
        word = planes[flag + g]
        if word == _ZERO:
            continue
        x, y = out + 64 * g, a + 64 * g
        for j in range(64):
            old, new = rows[x + j] + 0.0, rows[y + j] / divisor
            rows[x + j] = new if (word >> np.uint64(j)) & _ONE else old


@compiled
def _compare(
    rows: Floats,
    operands: Ints,
    first: int,
    count: int,
    planes: Words,
    flag: int,
    words: int,
    within: int,
) -> None:
    """Set FLAG to whether the sum of `count` rows operands[first..] is above 0; with `within`, FLAG
    stays 0 where it was 0."""
    for g in range(words):
        word = _ZERO
        for j in range(64):
            i, total = 64 * g + j, 0.0
            for k in range(count):
                total += rows[operands[first + k] * 64 * words + i]
            if total > 0.0:
                word |= _ONE << np.uint64(j)
        planes[flag + g] = word & planes[flag + g] if within else word


@compiled
def _run_steps(
    steps: Ints,
    first: int,
    stop: int,
    operands: Ints,
    planes: Words,
    rows: Floats,
    words: int,
    flag_plane: int,
    state: int,
) -> int:
    """Run a kernel and return the new `state` of FLAG: `_NONE`, `_SOME` or `_ALL` pixels are 1."""
    flag, pixels = flag_plane * words, 64 * words
    for s in range(first, stop):
        at = s * COLUMNS
        code, out = steps[at], steps[at + 1]
        a, b, c = steps[at + 2], steps[at + 3], steps[at + 4]
        if code == _COMBINE:
            _combine(planes, words, out * words, operands, a, b, _FULL if c else _ZERO)
            if out == flag_plane:
                state = _any_all(planes, flag, words)
        elif code == _STORE:
            for i in range(words):
                old, mask = planes[out * words + i], planes[b * words + i]
                planes[out * words + i] = old ^ ((old ^ planes[a * words + i]) & mask)
        elif code == _COPY:
            for i in range(pixels):
                rows[out * pixels + i] = rows[a * pixels + i]
        elif code in (_COMPARE, _COMPARE_MASKED):
            _compare(rows, operands, a, b, planes, flag, words, code == _COMPARE_MASKED)
            state = _any_all(planes, flag, words)
        elif state == _NONE:
            continue
        elif code == _BUS2:
            _bus2(rows, out * pixels, a * pixels, b * pixels, planes, flag, words, state)
        elif code == _BUS:
            _bus(rows, out * pixels, operands, a, b, planes, flag, words)
        elif code == _DIVIDE:
            _divide(rows, out * pixels, a * pixels, float(b), planes, flag, words)
    return state


@compiled
def _start(
    planes: Words,
    rows: Floats,
    words: int,
    flag_plane: int,
    pix: int,
    scale: int,
    seed: np.uint64,
    first: int,
    used_rows: Ints,
) -> None:
    """Set arbitrary initial values, as `nscc_runtime.emulator.capture` describes them.

    Rows r with used_rows[r] = 0 are not set, because no word uses them.

    The row at `scale` contains the light of the whole frame, 0 outside the array. The reset level
    is the row after PIX; the row after that is overwritten."""
    for p in range(flag_plane + 1):
        for g in range(words):
            planes[p * words + g] = _hash(seed, p, first // 64 + g)
    for i in range((flag_plane + 1) * words, (flag_plane + 3) * words):
        planes[i] = _ZERO
    # One random number u per pixel; the fractional part of K u serves as another for each large K.
    pixels = 64 * words
    place = (pix + 2) * pixels
    for i in range(pixels):
        bits = _hash(seed, flag_plane + 1, first + i)
        rows[place + i] = float(np.int64(bits >> np.uint64(11))) * 2.0**-53
    for r in range(pix + 2):
        if used_rows[r] == 0:
            continue
        lowest = -1.0 if r < pix else 1.0
        for i in range(pixels):
            turn = rows[place + i] * (16384.0 * (1.0 + r * _GOLDEN))
            spread = 2.0 * (turn - np.floor(turn)) - 1.0
            light = rows[scale + i]
            value = abs(spread) + 1.0
            if light > 0.0:
                value = light * (0.25 + 0.5 * abs(spread))
            rows[r * pixels + i] = value * lowest if spread < 0.0 else value


@compiled
def _same_light(row_start: Ints, frame_index: Ints32, weight: Floats, slot: int) -> bool:
    """Return whether a slot has the light of the slot before it."""
    if slot == 0:
        return False
    before, start, stop = row_start[slot - 1], row_start[slot], row_start[slot + 1]
    if stop - start != start - before:
        return False
    for k in range(stop - start):
        if frame_index[before + k] != frame_index[start + k]:
            return False
        if weight[before + k] != weight[start + k]:
            return False
    return True


@record
class PixelBlock:
    """A block of pixels, and sizes. `pixels`: number of pixels of the array. `first` (a multiple of
    64), `length`: the pixels that are exposed. `flag_plane`: FLAG's plane. `pix_row`: PIX's row."""

    slots: int
    pixels: int
    first: int
    length: int
    frames: int
    code_registers: int
    buckets: int
    seed: np.uint64
    flag_plane: int
    pix_row: int


@loop
def expose_block(
    block: PixelBlock,
    steps: Annotated[Ints, "steps columns"],
    operands: Ints,
    kernel_start: Ints,
    launch_start: Annotated[Ints, "slots+2"],
    launch_kernel: Ints,
    used_rows: Ints,
    frames: Annotated[Floats32, "frames pixels"],
    row_start: Annotated[Ints, "slots+1"],
    frame_index: Annotated[Ints32, "entries"],
    weight: Annotated[Floats, "entries"],
    frame_weight: Annotated[Floats, "frames"],
    code_planes: Annotated[Words, "code_registers words"],
    code_rows: Annotated[Ints, "code_registers"],
    readout_rows: Annotated[Ints, "buckets"],
    readout_gain: Annotated[Floats, "buckets"],
    planes: Written[Words],
    rows: Written[Floats],
    charge: Written[Floats32],
    exposure: Written[Annotated[Floats, "buckets pixels"]],
) -> None:
    """Expose a block of pixels and write the results into `exposure`.

    `used_rows`: 1 for rows that words use, else 0.
    `row_start`, `frame_index` and `weight` are the matrix of `nscc_runtime.light.Light`.
    `frame_weight`: the weight of each frame in the light of the whole exposure. `code_planes`:
    initial values of the planes numbered `code_rows`. `planes`, `rows` and `charge` (block) are
    working memory, with two planes after FLAG's and four rows after PIX's
    (`nscc_runtime.emulator.steps.Layout`)."""
    slots, pixels, first, length = block.slots, block.pixels, block.first, block.length
    seed, flag_plane, pix_row = block.seed, block.flag_plane, block.pix_row
    words = (length + 63) // 64
    row_length, pix = 64 * words, pix_row * 64 * words
    zero, exact = (pix_row + 3) * row_length, (pix_row + 4) * row_length

    for i in range(row_length):
        rows[exact + i] = 0.0
    for k in range(block.frames):
        frame_weight_fraction, frame = frame_weight[k], k * pixels + first
        if frame_weight_fraction != 0.0:
            for i in range(length):
                rows[exact + i] += frame_weight_fraction * frames[frame + i]
    _start(planes, rows, words, flag_plane, pix_row, exact, seed, first, used_rows)
    for i in range(row_length):
        rows[zero + i] = 0.0
    for c in range(block.code_registers):
        source = c * ((pixels + 63) // 64) + first // 64
        for g in range(words):
            planes[code_rows[c] * words + g] = code_planes[source + g]

    state = _any_all(planes, flag_plane * words, words)
    for n in range(slots + 1):
        for at in range(launch_start[n], launch_start[n + 1]):
            begin, end = kernel_start[launch_kernel[at]], kernel_start[launch_kernel[at] + 1]
            state = _run_steps(steps, begin, end, operands, planes, rows, words, flag_plane, state)
        if n == slots:
            break
        start, stop = row_start[n], row_start[n + 1]
        if stop - start == 1 and weight[start] == 1.0:
            frame = frame_index[start] * pixels + first
            for i in range(length):
                rows[pix + i] += frames[frame + i]
            continue
        if not _same_light(row_start, frame_index, weight, n):
            for i in range(length):
                rows[exact + i] = 0.0
            for k in range(start, stop):
                frame, frame_weight_fraction = frame_index[k] * pixels + first, weight[k]
                for i in range(length):
                    rows[exact + i] += frames[frame + i] * frame_weight_fraction
            for i in range(length):
                charge[i] = np.float32(rows[exact + i])
        for i in range(length):
            rows[pix + i] += charge[i]

    for k in range(block.buckets):
        row, gain, out = readout_rows[k] * row_length, readout_gain[k], k * pixels + first
        for i in range(length):
            # -0 + 0 is +0.
            exposure[out + i] = rows[row + i] * gain + 0.0
