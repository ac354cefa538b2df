"""The compiled loop that executes words on an array of pixels, exactly or with sensor effects.

The emulator runs it on blocks of pixels (one row) without effects, and programs with images on the
whole array.

A plane (a one-bit register) has `plane_words` 64-bit words per row: pixel x is bit x % 64 of word
x // 64. A register has `length` values per row, at least `cols`. Rows of zeros lie before, between
and after the registers. If words reach neighbours, `length` is larger than `cols`, so that zeros
also lie between the rows: values beyond the array are read like all others. `marks` contains the
saturation marks of the values in the same order. FLAG is 0 beyond the array, so nothing changes
there.

An operand is three integers: a register, and the columns to the right and the rows down to the
pixel that is read or written."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np

from nscc.arrays import Array, Bytes, Floats, Ints
from nscc_runtime.effects.spread import soft_in_loop
from nscc_runtime.loop import Words, Written, compiled, inlined, loop, record
from nscc_runtime.noise.gaussian import normal_fast
from nscc_runtime.noise.keys import bits
from nscc_runtime.noise.noise_loops import uniform

BUS, COMPARE, BITS, NEIGHBOURS, PROPAGATION = range(5)
_NONE, _SOME, _ALL = range(3)
_ZERO, _ONE = np.uint64(0), np.uint64(1)
_FULL = np.uint64(0xFFFF_FFFF_FFFF_FFFF)


@record
class ArrayShape:
    """The array: `rows`, `cols`, the `length` of a row of values, and `plane_words`, the number of
    64-bit words of a row of a plane.

    `count`: number of words of `run_array_words`. `total`, `part`, `normals`: indices of rows of
    values, two for intermediate sums and one for random numbers. `flag` to `masked` are numbers of
    planes: `bus`, of half-word pairs; `zero`, of zeros; `mask` and `masked`, of the mask and of the
    register that it guards, are -1 on a chip without a masked register. `obeys_flag`: 1 if a
    comparison only clears FLAG (the bit that lets a pixel act), 0 if it sets it anew. Values
    outside `lowest` to `highest` (electrons) get the saturation mark `range_bit`; 0 to record no
    marks."""

    rows: int
    cols: int
    length: int
    plane_words: int
    count: int
    total: int
    part: int
    normals: int
    flag: int
    bus: int
    zero: int
    mask: int
    masked: int
    obeys_flag: int
    lowest: float
    highest: float
    range_bit: int


@record
class ArrayWord:
    """A word. `kind`: BUS, COMPARE, BITS, NEIGHBOURS or PROPAGATION. Its operands begin at index
    `operands`, first as many as `sources`, then as many as `destinations`.

    `divisor`: of the result; for a propagation, the largest number of steps. `inverted`: whether
    bits are inverted, or the bits beyond the array that neighbours read are 1. It runs `lag` rows
    behind the first word. `everywhere`: whether an analog word acts where FLAG (the bit that lets a
    pixel act) is 0, too. `in_e`: the value of IN (the level sent to all pixels) in electrons if the
    word reads IN, else 0. `adds`: whether it has several sources. `number`: its number among the
    analog words, which selects its random numbers."""

    kind: int
    operands: int
    sources: int
    destinations: int
    divisor: int
    inverted: int
    everywhere: int
    lag: int
    in_e: float
    adds: int
    number: int


@record
class ArrayErrors:
    """The effects that act on words; 0 for effects that are off, so that `gain` and `highest` tell
    whether words have errors and whether registers saturate.

    The fields from `gain` to `compares` are those of the same names in `Numbers` and `WordKeys` of
    `nscc_runtime.execution.layout`. `frame`: number of the frame. `numbered`:
    difference between the draw numbers of consecutive words. `inverted`: number of the register
    that holds inverted values, -1 for none. `patterns`: number of the first of two registers that
    hold fixed patterns: errors of additions, then offsets of comparators."""

    gain: float
    move_gain: float
    word_error: float
    move_error: float
    lowest: float
    highest: float
    knee: float
    compare_noise: float
    words: np.uint64
    compares: np.uint64
    frame: int
    numbered: int
    inverted: int
    patterns: int


OfArrayWords = Annotated[Array, ArrayWord]


class ArrayState(NamedTuple):
    """The registers of the array, in the layout of this module's docstring, and operands.

    `operands`: three integers each. `errors`: one record. `values`, `marks`: electrons and
    saturation marks of analog registers. `planes`: digital registers, 64 pixels a number. `marked`:
    one number, 1 once any value has a mark; while it is 0, `marks` is not read, and it may be empty
    if the array records no marks."""

    operands: Ints
    errors: Annotated[Array, ArrayErrors]
    values: Written[Floats]
    marks: Written[Bytes]
    planes: Written[Words]
    marked: Written[Ints]


@inlined
def row_of(shape: ArrayShape, register: int, y: int) -> int:
    """Return the index in the values where row y of analog register number `register` begins. Rows
    -1 and shape.rows, beyond the array, are rows of zeros."""
    return (register * (shape.rows + 1) + y + 1) * shape.length


@inlined
def plane_of(shape: ArrayShape, register: int, y: int) -> int:
    """Return the index in the planes where row y of plane number `register` begins."""
    return (register * shape.rows + y) * shape.plane_words


@inlined
def _inside(shape: ArrayShape, g: int) -> np.uint64:
    """Return the mask of those pixels of the 64-bit word number g of a row of a plane that belong
    to the array; no bit beyond its last column."""
    pixels = shape.cols - 64 * g
    if pixels >= 64:
        return _FULL
    return (_ONE << np.uint64(pixels)) - _ONE if pixels > 0 else _ZERO


@compiled
def clear_flag_outside(shape: ArrayShape, planes: Words, y: int) -> None:
    """Set FLAG (the bit that lets a pixel act) to 0 in row y of `planes` in the bits beyond the
    last column."""
    flag = plane_of(shape, shape.flag, y)
    for g in range(shape.cols // 64, shape.plane_words):
        planes[flag + g] &= _inside(shape, g)


@compiled
def _flagged(shape: ArrayShape, planes: Words, y: int) -> int:
    """Return in which pixels of row `y` of the array FLAG (the bit that lets a pixel act) is 1:
    `_NONE`, `_SOME` or `_ALL`. `planes`: 64 pixels in each number; bits beyond the last column are
    0 and do not count."""
    flag, full = plane_of(shape, shape.flag, y), shape.cols // 64
    any_bits, unset_bits = _ZERO, _ZERO
    for g in range(full):
        any_bits |= planes[flag + g]
        unset_bits |= ~planes[flag + g]
    for g in range(full, shape.plane_words):
        any_bits |= planes[flag + g]
        unset_bits |= planes[flag + g] ^ _inside(shape, g)
    if any_bits == _ZERO:
        return _NONE
    return _ALL if unset_bits == _ZERO else _SOME


@compiled
def _add(
    shape: ArrayShape,
    values: Floats,
    out: int,
    a: int,
    b: int,
    factor: float,
    initial_e: float,
    planes: Words,
    flag: int,
    state: int,
) -> None:
    """Set the row that begins at values[out] to `factor` * (`initial_e` + the rows that begin at
    values[a] and values[b]) where FLAG is 1.

    A `b` of 0 stands for a row of zeros. `flag`: index in `planes` of the row of FLAG (the bit that
    lets a pixel act). `state`: in which pixels FLAG is 1 (`_flagged`); with `_ALL` it is not read,
    with `_NONE` nothing changes.

    Where FLAG differs between pixels, an unchanged value is written back as `old + 0.0`, which
    changes at most the sign of a zero. Choosing between two computed values becomes a blend and a
    plain store. Choosing the loaded value itself would become a masked store, which takes twice as
    long (measured on AMD Zen 3)."""
    if state == _ALL:
        if b == 0:  # the row of zeros
            for x in range(shape.cols):
                values[out + x] = factor * (initial_e + values[a + x])
            return
        for x in range(shape.cols):
            values[out + x] = factor * (initial_e + values[a + x] + values[b + x])
    elif state == _SOME:
        # The last group of 64 may reach beyond the row: FLAG is 0 there, so values stay.
        for g in range(shape.plane_words):
            word = planes[flag + g]
            if word == _ZERO:
                continue
            x, y, z = out + 64 * g, a + 64 * g, b + 64 * g
            for j in range(64):
                old, new = values[x + j] + 0.0, factor * (initial_e + values[y + j] + values[z + j])
                values[x + j] = new if (word >> np.uint64(j)) & _ONE else old


@inlined
def _source(shape: ArrayShape, word: ArrayWord, operands: Ints, y: int, s: int) -> int:
    """Return the index in the values where the row begins that row y reads from source number s of
    `word`: that of the pixel itself or of a neighbour. For a missing source it is 0, a row of
    zeros."""
    if s >= word.sources:
        return 0
    at = word.operands + 3 * s
    begin: int = row_of(shape, operands[at], y + operands[at + 2]) + operands[at + 1]
    return begin


@inlined
def _two_terms(
    shape: ArrayShape, word: ArrayWord, state: ArrayState, y: int
) -> tuple[int, int, float]:
    """Return the starts of two rows in the values, and a constant in electrons, whose sum is the
    sum of a word's sources in row `y`.

    `a` and `b` are the starts of the two rows, `initial_e` is the constant. With more than two
    sources, the scratch rows `shape.part` and `shape.total` take turns to hold the sum so far."""
    operands = state.operands
    a, b = _source(shape, word, operands, y, 0), _source(shape, word, operands, y, 1)
    initial_e = word.in_e
    for s in range(2, word.sources):
        # Not in place, because LLVM vectorises only loops over separate rows.
        out = shape.part if (word.sources - s) % 2 else shape.total
        # out = 1.0 * (initial_e + a + b) in all pixels: with _ALL no FLAG is read, so its plane (0)
        # does not matter.
        _add(shape, state.values, out, a, b, 1.0, initial_e, state.planes, 0, _ALL)
        a, b, initial_e = out, _source(shape, word, operands, y, s), 0.0
    return a, b, initial_e


@inlined
def _is_beyond(shape: ArrayShape, values: Floats, row: int, low: float, high: float) -> bool:
    """Return whether any of the values of a row, which begins at index `row`, is below `low` or
    above `high`."""
    beyond = 0
    for x in range(row, row + shape.cols):
        beyond |= (values[x] < low) | (values[x] > high)
    return beyond != 0


@compiled
def _mark(shape: ArrayShape, word: ArrayWord, state: ArrayState, y: int, result: int) -> None:
    """Set the row of marks at `shape.total` to the OR of the saturation marks of a word's sources
    in row y, with `range_bit` where the row of values at `result` is beyond the range; while there
    are no marks in the array, do nothing."""
    total, values, marks = shape.total, state.values, state.marks
    if _is_beyond(shape, values, result, shape.lowest, shape.highest):
        state.marked[0] = 1
    if not state.marked[0]:
        return
    for x in range(shape.cols):
        value = values[result + x]
        is_outside = value < shape.lowest or value > shape.highest
        marks[total + x] = shape.range_bit if is_outside else 0
    for s in range(word.sources):
        source = _source(shape, word, state.operands, y, s)
        for x in range(shape.cols):
            marks[total + x] |= marks[source + x]


@compiled
def _store_marks(
    shape: ArrayShape, word: ArrayWord, state: ArrayState, out: int, flag: int, source: int
) -> None:
    """Set the row of marks at index `out` to the row at `source` where FLAG is 1, or everywhere if
    `word` acts everywhere. `flag`: index in the planes of the row of FLAG (the bit that lets a
    pixel act)."""
    planes, marks = state.planes, state.marks
    for x in range(shape.cols):
        if word.everywhere or (planes[flag + x // 64] >> np.uint64(x % 64)) & _ONE:
            marks[out + x] = marks[source + x]


@compiled
def _store(
    shape: ArrayShape, word: ArrayWord, state: ArrayState, register: int, y: int, source: int
) -> None:
    """Set row `y` of analog register number `register` to the row of values that begins at
    `source`, where FLAG is 1 or `word` acts everywhere, and its saturation marks likewise, if there
    are any in the array. FLAG is the bit that lets a pixel act."""
    planes, out, flag = state.planes, row_of(shape, register, y), plane_of(shape, shape.flag, y)
    acting = _ALL if word.everywhere else _flagged(shape, planes, y)
    _add(shape, state.values, out, source, 0, 1.0, 0.0, planes, flag, acting)
    if state.marked[0]:
        _store_marks(shape, word, state, out, flag, source)


@compiled
def _draw(
    shape: ArrayShape, errors: ArrayErrors, stream: np.uint64, number: int, y: int, values: Floats
) -> None:
    """Set the row of values at `shape.normals` to the standard normal numbers of the pixels of row
    `y`, for the draw `number` of the random key `stream`. The two steps are separate loops, because
    a single loop runs out of processor registers."""
    key, out, place = bits(stream, errors.frame, np.uint64(number)), shape.normals, y * shape.cols
    for x in range(shape.cols):
        values[out + x] = uniform(key, place + x)
    for x in range(out, out + shape.cols):
        values[x] = float(normal_fast(values[x]))


@compiled
def _err(
    shape: ArrayShape,
    errors: ArrayErrors,
    word: ArrayWord,
    values: Floats,
    y: int,
    destination: int,
    register: int,
) -> None:
    """Change the row of values at `shape.total` from the exact result of `word` in row `y` to that
    with errors of words. `destination`: its index in the word. `register`: its number."""
    sign = -1.0 if register == errors.inverted else 1.0
    gain, fixed, random = errors.move_gain, 0.0, sign * errors.move_error
    if word.adds:
        gain, fixed, random = errors.gain, sign, sign * errors.word_error
    if random != 0.0:
        number = word.number * errors.numbered + destination
        _draw(shape, errors, errors.words, number, y, values)
    total, normals, pattern = shape.total, shape.normals, row_of(shape, errors.patterns, y)
    for x in range(shape.cols):
        error_e = fixed * values[pattern + x] + random * values[normals + x]
        values[total + x] = gain * values[total + x] + error_e


@compiled
def _bend(shape: ArrayShape, errors: ArrayErrors, values: Floats, row: int) -> None:
    """Bend the values of a row, which begins at index `row`, into the range of registers."""
    low, high, knee = errors.lowest, errors.highest, errors.knee
    if _is_beyond(shape, values, row, knee * low, knee * high):
        for x in range(row, row + shape.cols):
            values[x] = soft_in_loop(values[x], low, high, knee)


@compiled
def _bus(shape: ArrayShape, word: ArrayWord, state: ArrayState, y: int) -> None:
    """Run the bus word `word` for row `y` of its sources: write minus their sum, over the divisor,
    to the destinations where FLAG is 1, with saturation marks if these are recorded. Marks tell the
    range before the effects of registers bend the value into it.

    A destination may be in a neighbouring row; a row whose neighbour is beyond the array gets 0.
    FLAG is the bit that lets a pixel act."""
    operands, values, planes, errors = state.operands, state.values, state.planes, state.errors[0]
    is_exact = errors.gain == 0.0 and errors.highest == 0.0
    first, total = word.operands + 3 * word.sources, shape.total
    halves = word.divisor & (word.divisor - 1) == 0  # so that a factor is exact
    flag, acting = plane_of(shape, shape.flag, y), _ALL
    # A word writes no register that it reads, so a single destination needs no intermediate sum.
    direct = word.destinations == 1 and halves and is_exact
    direct = direct and operands[first + 1] == 0 and operands[first + 2] == 0
    out = total
    if direct:
        out = row_of(shape, operands[first], y)
        acting = _ALL if word.everywhere else _flagged(shape, planes, y)
        if acting == _NONE:
            return
    a, b, initial_e = _two_terms(shape, word, state, y)
    factor = -1.0 / word.divisor if halves else -1.0
    down = 0
    for d in range(word.destinations):
        at = first + 3 * d
        down = operands[at + 2]
        if d == 0 or not is_exact:
            _add(shape, values, out, a, b, factor, initial_e, planes, flag, acting)
            for x in range(total, total + (0 if halves else shape.cols)):
                values[x] /= word.divisor
            if errors.gain:
                _err(shape, errors, word, values, y, d, operands[at])
            if shape.range_bit:
                _mark(shape, word, state, y, out)
            if errors.highest:
                _bend(shape, errors, values, total)
        if direct:
            if state.marked[0]:
                _store_marks(shape, word, state, out, flag, total)
            return
        if 0 <= y + down < shape.rows:
            _store(shape, word, state, operands[at], y + down, total - operands[at + 1])
    if (down > 0 and y == 0) or (down < 0 and y == shape.rows - 1):
        # No bus reaches this row.
        _store(shape, word, state, operands[first], y, 0)


@compiled
def _compare(shape: ArrayShape, word: ArrayWord, state: ArrayState, y: int) -> None:
    """Set FLAG in row `y` to 1 where the sum of the sources of `word` is above 0, else to 0 (also
    for NaN); with `shape.obeys_flag`, also to 0 where FLAG (the bit that lets a pixel act) was 0.
    """
    values, planes, errors = state.values, state.planes, state.errors[0]
    a, b, initial_e = _two_terms(shape, word, state, y)
    if errors.patterns:
        total, offset = shape.total, row_of(shape, errors.patterns + 1, y)
        _add(shape, values, total, a, b, 1.0, initial_e, planes, 0, _ALL)
        if errors.compare_noise:
            _draw(shape, errors, errors.compares, word.number, y, values)
        for x in range(shape.cols):
            noise_e = errors.compare_noise * values[shape.normals + x]
            values[total + x] += values[offset + x] + noise_e
        a, b, initial_e = total, 0, 0.0
    flag = plane_of(shape, shape.flag, y)
    for g in range(shape.plane_words):
        above = _ZERO
        for j in range(64):
            if initial_e + values[a + 64 * g + j] + values[b + 64 * g + j] > 0.0:
                above |= _ONE << np.uint64(j)
        planes[flag + g] = above & planes[flag + g] if shape.obeys_flag else above
    clear_flag_outside(shape, planes, y)


@compiled
def _write_bits(shape: ArrayShape, word: ArrayWord, state: ArrayState, y: int) -> None:
    """Write the OR of the sources in row `y`, or its inverse, to the destinations; without sources
    the OR is 0. The masked register changes only where its mask is 1."""
    operands, planes = state.operands, state.planes
    first, bus = word.operands, plane_of(shape, shape.bus, y)
    flip = _FULL if word.inverted else _ZERO
    a = plane_of(shape, operands[first] if word.sources else shape.zero, y)
    b = plane_of(shape, operands[first + 3] if word.sources > 1 else shape.zero, y)
    for g in range(shape.plane_words):
        planes[bus + g] = planes[a + g] | planes[b + g]
    for s in range(2, word.sources):
        a = plane_of(shape, operands[first + 3 * s], y)
        for g in range(shape.plane_words):
            planes[bus + g] |= planes[a + g]
    # The masked destination comes first, so that the mask still has its old value.
    for d in range(word.destinations):
        register = operands[first + 3 * (word.sources + d)]
        out = plane_of(shape, register, y)
        if shape.mask >= 0 and register == shape.masked:
            mask = plane_of(shape, shape.mask, y)
            for g in range(shape.plane_words):
                old, new = planes[out + g], planes[bus + g] ^ flip
                planes[out + g] = old ^ ((old ^ new) & planes[mask + g])
        else:
            for g in range(shape.plane_words):
                planes[out + g] = planes[bus + g] ^ flip
        if register == shape.flag:
            clear_flag_outside(shape, planes, y)


@compiled
def _look(shape: ArrayShape, word: ArrayWord, state: ArrayState, y: int) -> None:
    """Write, in row `y`, the OR of the bits of those neighbours that the steering registers choose;
    0 for pixels that choose none. Bits beyond the array are 1 if `word` is inverted, else 0.

    The first operand is the destination, the second the source. All further operands steer: a
    register, and the step to the neighbour that it chooses where it is 1."""
    operands, planes = state.operands, state.planes
    first, bus, last = word.operands, plane_of(shape, shape.bus, y), shape.cols - 1
    for g in range(shape.plane_words):
        planes[bus + g] = _ZERO
    # Three numbers for each operand: its register, columns to the right, rows down.
    for at in range(first + 6, first + 3 * word.sources, 3):
        steering, right = plane_of(shape, operands[at], y), operands[at + 1]
        row = y + operands[at + 2]
        source = plane_of(shape, operands[first + 3], row)
        for g in range(shape.plane_words):
            seen, outside = _ZERO, _ZERO
            if row < 0 or row >= shape.rows:
                outside = _FULL
            elif right > 0:  # a shift by one bit, with a bit of the next 64 pixels
                seen = planes[source + g] >> _ONE
                if g + 1 < shape.plane_words:
                    seen |= planes[source + g + 1] << np.uint64(63)
                outside = _ONE << np.uint64(last % 64) if g == last // 64 else _ZERO
            elif right < 0:
                seen = planes[source + g] << _ONE
                if g:
                    seen |= planes[source + g - 1] >> np.uint64(63)
                outside = _ONE if g == 0 else _ZERO
            else:
                seen = planes[source + g]
            seen = seen | outside if word.inverted else seen & ~outside
            planes[bus + g] |= planes[steering + g] & seen
    out = plane_of(shape, operands[first], y)
    for g in range(shape.plane_words):
        planes[out + g] = planes[bus + g]


@compiled
def _propagate(shape: ArrayShape, word: ArrayWord, state: ArrayState) -> None:
    """Set those bits of the word's register, within the mask, that a 1 reaches in at most
    `word.divisor` steps; each step goes to neighbours as the steering registers choose.

    The operands are the bus, the register and the steering registers, as for `_look`, then the
    mask."""
    operands, planes = state.operands, state.planes
    for _ in range(word.divisor):
        for y in range(shape.rows):
            _look(shape, word, state, y)
        changed = _ZERO
        for y in range(shape.rows):
            bits = plane_of(shape, operands[word.operands + 3], y)
            mask = plane_of(shape, operands[word.operands + 3 * word.sources], y)
            near = plane_of(shape, operands[word.operands], y)
            for g in range(shape.plane_words):
                grown = planes[near + g] & planes[mask + g] & ~planes[bits + g]
                planes[bits + g] |= grown
                changed |= grown
        if changed == _ZERO:
            return


@compiled
def _run_rows(
    shape: ArrayShape, words: OfArrayWords, first: int, stop: int, state: ArrayState
) -> None:
    """Run the words `first` to `stop` - 1, which contain no propagation, row by row: each word runs
    `lag` rows behind the first one, so that rows stay in the cache. Without words nothing happens.
    """
    for step in range(shape.rows + words[stop - 1].lag if stop > first else 0):
        for w in range(first, stop):
            word = words[w]
            y = step - word.lag
            if y < 0 or y >= shape.rows:
                continue
            if word.kind == BUS:
                _bus(shape, word, state, y)
            elif word.kind == COMPARE:
                _compare(shape, word, state, y)
            elif word.kind == NEIGHBOURS:
                _look(shape, word, state, y)
            else:
                _write_bits(shape, word, state, y)


@compiled
def run_words(
    shape: ArrayShape, words: OfArrayWords, first: int, stop: int, state: ArrayState
) -> None:
    """Run the words `first` to `stop` - 1 in their order, and change the registers as they do.

    A row goes through all words while it is in the cache. A word runs `lag` rows behind the first
    word: the neighbouring rows that it reads are then complete, and no earlier word still needs the
    rows that it overwrites. A propagation waits for all rows."""
    begin = first
    for w in range(first, stop):
        if words[w].kind == PROPAGATION:
            _run_rows(shape, words, begin, w, state)
            _propagate(shape, words[w], state)
            begin = w + 1
    _run_rows(shape, words, begin, stop, state)


@loop
def run_array_words(
    shape: ArrayShape, words: Annotated[Array, ArrayWord, "count"], state: ArrayState
) -> None:
    """Run all words on the array, and change its registers."""
    run_words(shape, words, 0, shape.count, state)
