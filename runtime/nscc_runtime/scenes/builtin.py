"""Scenes without files: `builtin:hdr`, `builtin:motion[:PART]`, `builtin:flat:E`,
`builtin:dark`."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from nscc.diagnostics.rejection import rejected
from nscc.diagnostics.suggest import closest, did_you_mean
from nscc_runtime.light import Light
from nscc_runtime.scenes import exposure as exposures
from nscc_runtime.scenes.exposure import BUILTIN, ExposureLevel

NAMES = ("hdr", "motion", "flat", "dark")


def load_builtin(
    spec: str,
    *,
    slot_us: Sequence[float],
    rows: int,
    cols: int,
    exposure: ExposureLevel | None = None,
) -> Light:
    """Return the light of `builtin:NAME`.

    Without `exposure`, hdr and motion have 30000 electrons at percentile 99, and flat has its own
    number of electrons over the frame, divided by slot length. Raises Rejected (NS0731) for an
    unknown name or an invalid argument."""
    _, name, *arguments = spec.split(":")
    least, most = {"flat": (1, 1), "motion": (0, 1)}.get(name, (0, 0))
    if name not in NAMES or not least <= len(arguments) <= most:
        raise _unknown(spec, name)
    seconds = np.array(slot_us, np.float64) * 1e-6
    match name:
        case "motion":
            from nscc_runtime.scenes.builtin_motion import motion

            share = _clip_share(spec, arguments[0]) if arguments else 1.0
            return motion(slot_us, rows, cols, exposure or BUILTIN, spec, share)
        case "hdr":
            from nscc_runtime.scenes.builtin_hdr import landscape

            frame = landscape(rows, cols)
            exposure_level: ExposureLevel | None = exposure or BUILTIN
        case "flat":
            electrons = _electrons(spec, arguments[0])
            frame = np.full((rows, cols), 1.0 if electrons else 0.0, np.float32)
            exposure_level = exposure or (ExposureLevel(electrons) if electrons else None)
        case _:
            frame = np.zeros((rows, cols), np.float32)
            exposure_level = exposure
    factor = 1.0
    if exposure_level is not None:
        open_sum = frame.astype(np.float64) * float(seconds.sum())
        factor = exposures.scale(open_sum, exposure_level, spec)
    return Light.of_still(frame, seconds * factor, factor)


def _clip_share(spec: str, text: str) -> float:
    try:
        share = float(text)
    except ValueError:
        share = math.nan
    if 0.0 <= share <= 1.0:
        return share
    raise rejected(
        "NS0731",
        f"'{text[:60]}' in '{spec[:80]}' is not a fraction from 0 to 1",
        notes=(
            "builtin:motion:PART shows this fraction of the clip, from its middle, in slow motion",
        ),
        helps=("for instance builtin:motion:0.2",),
    )


def _electrons(spec: str, text: str) -> float:
    try:
        electrons = float(text)
    except ValueError:
        electrons = math.nan
    if 0.0 <= electrons < 1e38:
        return electrons
    raise rejected(
        "NS0731",
        f"invalid number of electrons '{text[:60]}' in '{spec[:80]}'",
        notes=("builtin:flat:E gives every pixel E electrons over the whole frame, 0 or more",),
        helps=("for instance builtin:flat:10000",),
    )


def _unknown(spec: str, name: str) -> Exception:
    suggestion = name if name in NAMES else closest(name, NAMES)
    written = f"builtin:{suggestion}" + (":10000" if suggestion == "flat" else "")
    help_text = did_you_mean(written) if suggestion else "choose one of these, or name a file"
    return rejected(
        "NS0731",
        f"unknown scene '{spec[:80]}'",
        notes=("builtin scenes: builtin:hdr, builtin:motion, builtin:flat:E, builtin:dark",),
        helps=(help_text,),
    )
