"""Parse and apply `--exposure E[@P]`: the electrons of a scene without units."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from nscc.arrays import Floats
from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.scenes.errors import Path_or_name

DEFAULT_PERCENTILE = 99.0
"""Percentile of an exposure that names none: a few bright lights may saturate."""


@dataclass(frozen=True)
class ExposureLevel:
    """An exposure: the pixel at `percentile` (0 to 100) of all light gets `electrons` over the
    frame."""

    electrons: float
    percentile: float = DEFAULT_PERCENTILE


BUILTIN = ExposureLevel(30000.0)
"""The default of builtin scenes: a full well of PIX at percentile 99."""


def parse_exposure(exposure: str | float | ExposureLevel | None) -> ExposureLevel | None:
    """Parse an exposure `E` or `E@P`: E electrons above 0, P a percentile in 0..100, by default 99.
    A number counts as E. Raises NS0738 for other text or values, also NaN and infinity.

    A parsed exposure, or None, is returned unchanged."""
    if exposure is None or isinstance(exposure, ExposureLevel):
        return exposure
    text = str(exposure)
    electrons, at, percentile = text.partition("@")
    try:
        parsed = ExposureLevel(float(electrons), float(percentile) if at else DEFAULT_PERCENTILE)
    except ValueError:
        # NaN fails the check below.
        parsed = ExposureLevel(math.nan)
    if not (0 < parsed.electrons < math.inf and 0 <= parsed.percentile <= 100):
        raise rejected(
            "NS0738",
            f"invalid exposure '{text[:60]}'",
            notes=(
                "--exposure E or E@P: E electrons, above 0, over the whole frame, for the pixel at "
                "percentile P (0 to 100, 99 if not given) of the scene",
            ),
            helps=("for instance --exposure 30000@99",),
        )
    return parsed


def check_white(white: float | None) -> None:
    """Raise Rejected (NS0739) unless the white level is None, or finite and above 0."""
    if white is None or 0 < white < math.inf:
        return
    raise rejected(
        "NS0739",
        f"invalid white level --white {white:g}",
        notes=("--white W: the sample value of white, above 0",),
        helps=("for instance --white 4095 for 12 bits",),
    )


def scale(open_sum: Floats, exposure: ExposureLevel, name: Path_or_name) -> float:
    """Return the factor from the unit of the scene `name` to electrons, with which its pixel at the
    percentile of `exposure` gets the electrons of `exposure`.

    `open_sum` (rows, cols) is the light over the frame in the scene's unit. Percentiles between two
    pixels are interpolated linearly. Raises Rejected (NS0738) if the scene is dark at the
    percentile, or if its electrons exceed float32."""
    level = float(np.percentile(open_sum, exposure.percentile))
    if level <= 0.0:
        lit = int(np.count_nonzero(open_sum > 0))
        raise rejected(
            "NS0738",
            f"the scene '{name}' is dark at percentile {exposure.percentile:g}, so it "
            f"cannot be scaled to {exposure.electrons:g} electrons",
            notes=(f"{lit} of {open_sum.size} pixels have light",),
            helps=("use a higher percentile, such as @100, or another --crop",)
            if lit
            else ("use another scene, or another --crop",),
        )
    factor = exposure.electrons / level
    peak = float(open_sum.max())
    if not (0.0 < factor < math.inf and peak * factor < float(np.finfo(np.float32).max)):
        raise rejected(
            "NS0738",
            f"{exposure.electrons:g} electrons at percentile {exposure.percentile:g} of "
            f"'{name}' exceed the largest light value (3.4e38)",
            helps=("a full well of scamp5 is 30000 electrons: --exposure 30000",),
        )
    return factor
