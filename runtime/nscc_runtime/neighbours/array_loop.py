"""Run the words of images and planes on a whole array without effects, in one compiled loop.

Register r of pixel i is at index r * pixels + i. After the analog registers follow cols + 1 zeros,
which stand for values beyond the array. An operand is three integers: a register, and the columns
to the right and the rows down to the pixel that is read or written. `marks` contains the saturation
marks of all analog registers."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.loop import Bytes, Floats, Ints, Written, inlined, loop, record

BUS, COMPARE, BITS, NEIGHBOURS = range(4)
LEVEL = -1
"""The register number that stands for IN in an operand."""


@record
class ArrayShape:
    """The array: its numbers of `words`, analog `registers`, `rows` and `cols`.

    `flag`, `mask` and `masked` are numbers of digital registers; `mask` is -1 on a chip without a
    masked register. Values outside `lowest` to `highest` (electrons) get the mark `range_bit`."""

    words: int
    registers: int
    rows: int
    cols: int
    flag: int
    mask: int
    masked: int
    obeys_flag: int
    lowest: float
    highest: float
    range_bit: int


@record
class ArrayWord:
    """A word. Its operands begin at index `operands`, sources first.

    It runs `lag` rows behind the first word. `everywhere` is 1 if FLAG is 1 in all pixels. `in_e`
    is IN in electrons."""

    kind: int
    operands: int
    sources: int
    destinations: int
    divisor: int
    inverted: int
    lag: int
    everywhere: int
    in_e: float


@inlined
def source_row(shape: ArrayShape, word: Any, operands: Ints, y: int, s: int) -> int:
    """Return the index where the row begins that row `y` reads from source number `s`.

    Return the index of zeros for a row beyond the array, for IN, and for a missing source."""
    zeros = shape.registers * shape.rows * shape.cols
    if s >= word.sources:
        return zeros
    at = word.operands + 3 * s
    row = y + operands[at + 2]
    if operands[at] == LEVEL or row < 0 or row >= shape.rows:
        return zeros
    return int((operands[at] * shape.rows + row) * shape.cols + operands[at + 1])


@inlined
def add_row(
    shape: ArrayShape, word: Any, operands: Ints, values: Floats, y: int, factor: float,
    total: Floats,
) -> int:  # fmt: skip
    """Set `total` to `factor` times the sums of a row; return how many leave the range."""
    cols, initial_e, right = shape.cols, 0.0, 0
    for s in range(word.sources):
        right += operands[word.operands + 3 * s + 1]
        if operands[word.operands + 3 * s] == LEVEL:
            initial_e = word.in_e
    a, b = source_row(shape, word, operands, y, 0), source_row(shape, word, operands, y, 1)
    outside = 0
    if word.sources <= 2:
        for x in range(cols):
            value = factor * (initial_e + values[a + x] + values[b + x])
            total[x] = value
            outside += (value < shape.lowest) | (value > shape.highest)
    else:
        c, d = source_row(shape, word, operands, y, 2), source_row(shape, word, operands, y, 3)
        for x in range(cols):
            value = factor * (
                initial_e + values[a + x] + values[b + x] + values[c + x] + values[d + x]
            )
            total[x] = value
            outside += (value < shape.lowest) | (value > shape.highest)
    if right:
        # A neighbour of this column is beyond the array.
        edge = 0 if right < 0 else cols - 1
        value = initial_e
        for s in range(word.sources):
            if operands[word.operands + 3 * s + 1] == 0:
                value += values[source_row(shape, word, operands, y, s) + edge]
        total[edge] = factor * value
    return outside


@inlined
def mark_row(
    shape: ArrayShape, word: Any, operands: Ints, marks: Bytes, y: int, total: Floats, mark: Bytes
) -> None:
    """Set `mark` to the marks of a word's sources, with `range_bit` for sums beyond the range."""
    cols = shape.cols
    for x in range(cols):
        beyond = total[x] < shape.lowest or total[x] > shape.highest
        mark[x] = shape.range_bit if beyond else 0
    for s in range(word.sources):
        start, right = source_row(shape, word, operands, y, s), operands[word.operands + 3 * s + 1]
        for x in range(max(0, -right), cols - max(0, right)):
            mark[x] |= marks[start + x]


@inlined
def store_row(
    shape: ArrayShape, word: Any, bits: Bytes, values: Floats, marks: Bytes, start: int, right: int,
    total: Floats, mark: Bytes, marked: Ints,
) -> None:  # fmt: skip
    """Write a row where FLAG is 1, shifted by `right` columns; a column without a value gets 0."""
    cols = shape.cols
    flag = shape.flag * shape.rows * cols + start % (shape.rows * cols)
    begin, end = max(0, right), cols + min(0, right)
    if word.everywhere:
        for x in range(begin, end):
            values[start + x] = total[x - right]
        if marked[0]:
            for x in range(begin, end):
                marks[start + x] = mark[x - right]
    else:
        # `+ 0.0` makes this a blend and a plain store, which is faster than a conditional store.
        for x in range(begin, end):
            old = values[start + x] + 0.0
            values[start + x] = total[x - right] if bits[flag + x] else old
        if marked[0]:
            for x in range(begin, end):
                if bits[flag + x]:
                    marks[start + x] = mark[x - right]
    if right:
        x = 0 if right > 0 else cols - 1
        if word.everywhere or bits[flag + x]:
            values[start + x] = 0.0
            marks[start + x] = 0


@inlined
def bus(
    shape: ArrayShape, word: Any, operands: Ints, values: Floats, marks: Bytes, bits: Bytes, y: int,
    total: Floats, mark: Bytes, marked: Ints,
) -> None:  # fmt: skip
    """Write minus the sum of the sources, over the divisor, to the destinations."""
    rows, cols = shape.rows, shape.cols
    if add_row(shape, word, operands, values, y, -1.0 / word.divisor, total):
        marked[0] = 1
    if marked[0]:
        mark_row(shape, word, operands, marks, y, total, mark)
    down = 0
    for d in range(word.destinations):
        at = word.operands + 3 * (word.sources + d)
        down = operands[at + 2]
        if 0 <= y + down < rows:
            start = (operands[at] * rows + y + down) * cols
            store_row(
                shape, word, bits, values, marks, start, operands[at + 1], total, mark, marked
            )
    if (down > 0 and y == 0) or (down < 0 and y == rows - 1):
        # No bus reaches this row.
        for x in range(cols):
            total[x] = 0.0
            mark[x] = 0
        start = (operands[word.operands + 3 * word.sources] * rows + y) * cols
        store_row(shape, word, bits, values, marks, start, 0, total, mark, marked)


@inlined
def compare(shape: ArrayShape, bits: Bytes, y: int, total: Floats) -> None:
    """Set FLAG to 1 where a sum is above 0; with `obeys_flag`, only where FLAG was 1."""
    flag = (shape.flag * shape.rows + y) * shape.cols
    for x in range(shape.cols):
        kept = bits[flag + x] if shape.obeys_flag else np.uint8(1)
        bits[flag + x] = np.uint8(total[x] > 0.0) & kept


@inlined
def write_bits(
    shape: ArrayShape, word: Any, operands: Ints, bits: Bytes, y: int, mark: Bytes
) -> None:
    """Write the OR of the sources, or its inverse, to the destinations."""
    rows, cols = shape.rows, shape.cols
    for x in range(cols):
        mark[x] = 0
    for s in range(word.sources):
        start = (operands[word.operands + 3 * s] * rows + y) * cols
        for x in range(cols):
            mark[x] |= bits[start + x]
    for x in range(cols):
        mark[x] ^= word.inverted
    # The masked destination comes first, so that the mask still has its old value.
    for d in range(word.destinations):
        register = operands[word.operands + 3 * (word.sources + d)]
        start, guard = (register * rows + y) * cols, (shape.mask * rows + y) * cols
        guarded = shape.mask >= 0 and register == shape.masked
        for x in range(cols):
            if not guarded or bits[guard + x]:
                bits[start + x] = mark[x]


@inlined
def look(shape: ArrayShape, word: Any, operands: Ints, bits: Bytes, y: int, mark: Bytes) -> None:
    """Write the OR of the bits of those neighbours that the steering registers choose.

    The first operand is the destination, the second the source. All further operands steer."""
    rows, cols, first = shape.rows, shape.cols, word.operands
    for x in range(cols):
        mark[x] = 0
    for s in range(2, word.sources):
        steer = (operands[first + 3 * s] * rows + y) * cols
        right, row = operands[first + 3 * s + 1], y + operands[first + 3 * s + 2]
        source = (operands[first + 3] * rows + row) * cols + right
        begin, end = max(0, -right), cols - max(0, right)
        if row < 0 or row >= rows:
            begin, end = cols, cols
        for x in range(begin, end):
            mark[x] |= bits[steer + x] & bits[source + x]
        for x in range(begin):
            mark[x] |= bits[steer + x] & word.inverted
        for x in range(end, cols):
            mark[x] |= bits[steer + x] & word.inverted
    start = (operands[first] * rows + y) * cols
    for x in range(cols):
        bits[start + x] = mark[x]


@loop
def run_array_words(
    shape: ArrayShape, words: Annotated[NDArray[Any], ArrayWord], operands: Ints,
    values: Written[Floats], marks: Written[Bytes], bits: Written[Bytes], total: Written[Floats],
    mark: Written[Bytes], marked: Written[Ints],
) -> None:  # fmt: skip
    """Run words in their order. `total` and `mark` are buffers of one row; marked[0] is 1 once any
    value has a saturation mark.

    A row goes through all words while it is in the cache. A word runs `lag` rows behind the first
    word: the neighbouring rows that it reads are then complete, and no earlier word still needs the
    rows that it overwrites."""
    for step in range(shape.rows + words[shape.words - 1].lag):
        for w in range(shape.words):
            word = words[w]
            y = step - word.lag
            if y < 0 or y >= shape.rows:
                continue
            if word.kind == BUS:
                bus(shape, word, operands, values, marks, bits, y, total, mark, marked)
            elif word.kind == COMPARE:
                add_row(shape, word, operands, values, y, 1.0, total)
                compare(shape, bits, y, total)
            elif word.kind == NEIGHBOURS:
                look(shape, word, operands, bits, y, mark)
            else:
                write_bits(shape, word, operands, bits, y, mark)
