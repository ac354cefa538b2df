"""The compiled loop of a readout: converter codes, with their errors."""

from __future__ import annotations

from math import prod
from typing import Annotated, NamedTuple

import numpy as np

from nscc.arrays import Bytes, Floats
from nscc_runtime.loop import Words, Written, loop, record
from nscc_runtime.noise.gaussian import normal_fast
from nscc_runtime.noise.noise_loops import row_normals, uniform

WEIGHTS = 6
"""Number of weights of the noise of a pixel and of those below it, which the loop adds up."""


class ReadoutErrors(NamedTuple):
    """Errors of codes before rounding, in codes. `pattern`: fixed errors of the rows, which begin
    again after the last. `common` (1,): standard deviation of the error that all codes of a bucket
    share. `weights` (6,): standard deviations of the parts that a pixel's own noise, and that of
    the five pixels below it in its column, have in its error; empty without noise. `common_keys`,
    `keys`: the random key of the common error and of the noise of each bucket."""

    pattern: Annotated[Floats, "pattern_rows cols"]
    common: Floats
    weights: Annotated[Floats, "weights"]
    common_keys: Annotated[Words, "buckets"]
    keys: Annotated[Words, "buckets"]


@record
class Converting:
    """Sizes of `convert`, the electrons of a code, the code of 0 e, and the largest code.
    `weights`: 6, or 0 without noise. `keeps_errors`: whether the errors of all codes are kept."""

    buckets: int
    rows: int
    cols: int
    pattern_rows: int
    weights: int
    keeps_errors: int
    electrons_per_lsb: float
    offset: float
    top: float


@loop
def convert(
    converting: Converting,
    of: ReadoutErrors,
    exposure: Floats,
    drawn: Written[Floats],
    errors: Written[Floats],
    codes: Written[Bytes],
) -> None:
    """Set codes[p] to the converter code of exposure[p], in electrons, with the error of the code;
    0 for NaN. Halves are rounded to even numbers. Both have the shape (buckets, rows, cols).

    Noise is drawn in single precision for each row, also for five rows below the array. `drawn` is
    working memory for the six rows that a row needs. `errors` gets the errors of all codes, or is
    working memory for a row."""
    cols, top, weights = converting.cols, converting.top, of.weights
    below = 5 if converting.weights else 0
    for bucket in range(converting.buckets):
        common = of.common[0] * float(normal_fast(uniform(of.common_keys[bucket], 0)))
        for last in range(converting.rows + below):
            fifth = last % 6 * cols
            if below:
                row_normals(of.keys[bucket], last, cols, drawn, fifth)
            if last < below:
                continue
            row = bucket * converting.rows + last - below
            first, fixed = row * cols, row % converting.pattern_rows * cols
            at = first if converting.keeps_errors else 0
            for i in range(cols):
                errors[at + i] = of.pattern[fixed + i] + common
            start, second, third = (
                (last + 1) % 6 * cols,
                (last + 2) % 6 * cols,
                (last + 3) % 6 * cols,
            )
            fourth, next_to_last = (last + 4) % 6 * cols, (last + 5) % 6 * cols
            for i in range(cols if below else 0):
                near = weights[0] * drawn[start + i] + weights[1] * drawn[second + i]
                middle = weights[2] * drawn[third + i] + weights[3] * drawn[fourth + i]
                far = weights[4] * drawn[next_to_last + i] + weights[5] * drawn[fifth + i]
                errors[at + i] += near + middle + far
            for i in range(cols):
                code = np.rint(exposure[first + i] / converting.electrons_per_lsb + errors[at + i])
                code = np.rint(code + converting.offset)  # the offset may be a fraction
                code = code if code > 0.0 else 0.0  # also for NaN
                codes[first + i] = np.uint8(code if code < top else top)


def codes_and_errors(
    exposure: Floats,
    errors: ReadoutErrors | Floats | float,
    scale: tuple[float, float, int],
    keeps_errors: bool = False,
) -> tuple[Bytes, Floats]:
    """Return the converter codes of exposures in electrons, and with `keeps_errors` their errors
    before rounding, in arrays like `exposure`.

    `errors`: those of each code, one for all, or what they are drawn from, for exposures (buckets,
    rows, cols). `scale`: the electrons of a code, the code of 0 e, and the largest code."""
    *ahead, cols = exposure.shape
    buckets, rows = 1, prod(ahead)
    if isinstance(errors, ReadoutErrors):
        buckets, rows = ahead
    else:
        pattern = np.ascontiguousarray(np.broadcast_to(errors, exposure.shape), np.float64)
        pattern, no_key = pattern.reshape(rows, cols), np.zeros(1, np.uint64)
        errors = ReadoutErrors(pattern, np.zeros(1), np.empty(0), no_key, no_key)
    codes = np.empty(exposure.shape, np.uint8)
    kept = np.empty(exposure.shape if keeps_errors else cols)
    convert(
        converting=Converting(
            buckets=buckets,
            rows=rows,
            cols=cols,
            pattern_rows=len(errors.pattern),
            weights=len(errors.weights),
            keeps_errors=keeps_errors,
            electrons_per_lsb=scale[0],
            offset=scale[1],
            top=scale[2],
        ),
        of=errors,
        exposure=np.ascontiguousarray(exposure, np.float64),
        drawn=np.empty(WEIGHTS * cols),
        errors=kept,
        codes=codes,
    )
    return codes, kept
