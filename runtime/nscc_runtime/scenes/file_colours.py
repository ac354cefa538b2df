"""Read the colours that a file states: ICC profiles, numbers of ITU-T H.273, chunks of PNG files.

A profile with curves and primaries (a matrix profile, or a grey one) gives exact curves. Its
luminances are those of the profile's connection space, whose white is D50."""

from __future__ import annotations

import io
import struct
from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Array, Floats
from nscc_runtime.scene_settings import Transfer
from nscc_runtime.scenes.colour import (
    LUMINANCE,
    Colours,
    Curve,
    Weights,
    luminance_weights,
    srgb_to_linear,
)
from nscc_runtime.scenes.pages import Note, Stated, head_of

_TRANSFER = "--transfer selects another curve"
_SRGB_D50 = (0.2225, 0.7169, 0.0606)
"""Luminances of the primaries of sRGB, adapted to D50; below, those of Adobe RGB."""
_ADOBE_D50 = (0.3111, 0.6257, 0.0632)
_NEAR = 3e-3
"""Curves and luminances that differ by less are equal: profiles store rounded numbers."""


def of_profile(data: bytes) -> Stated:
    """Return the colours that the ICC profile `data` states. Its note names the profile; sRGB has
    no note. Colours are None for a profile of tables and for a damaged one, which raises nothing:
    the note says why."""
    from PIL import ImageCms

    weights: Weights = _SRGB_D50
    try:
        profile: Any = ImageCms.ImageCmsProfile(io.BytesIO(data)).profile
        name = " ".join((profile.profile_description or "without a name").split())[:60]
        if profile.xcolor_space.strip() == "GRAY":
            curves = [_profile_curve(data, b"kTRC")]
        elif profile.is_matrix_shaper:
            curves = [_profile_curve(data, tag) for tag in (b"rTRC", b"gTRC", b"bTRC")]
            colorants = profile.red_colorant, profile.green_colorant, profile.blue_colorant
            luminances = np.array([xyz[1] for xyz, _ in colorants])
            # Rounded or scaled colorants may not add up to 1, the luminance of white.
            red, green, blue = (luminances / luminances.sum()).tolist()
            weights = (red, green, blue)
        else:
            text = f"has the colour profile '{name}', which consists of tables: it is not used"
            return Stated(None, ((text, "convert the picture to sRGB"),))
        return _named(tuple(curves), weights, f"the colour profile '{name}'")
    except Exception as error:  # littleCMS reads what it can; a damaged profile fails anywhere
        reason = " ".join(str(error).split())[:80] or type(error).__name__
        text = f"has a damaged colour profile ({reason}), which is not used"
        return Stated(None, ((text, _TRANSFER),))


def _named(curves: tuple[Curve, ...], weights: Weights, text: str) -> Stated:
    """Return colours with a note that names them; without a note if they are sRGB.

    `curves`: one, or those of red, green and blue. `weights`: their luminances. `text`: the name of
    the curve in the note. Raises ValueError if a curve does not rise."""
    ramp = np.linspace(0, 1, 65)
    values = [curve(ramp) for curve in curves]
    if not all(np.isfinite(value).all() and value[-1] > value[0] for value in values):
        raise ValueError("its curve does not rise")
    if all(np.abs(value - values[0]).max() < 1e-6 for value in values):
        # One common curve is applied faster than three.
        curves = curves[:1]
    is_srgb = all(np.abs(value - srgb_to_linear(ramp)).max() < _NEAR for value in values)
    if is_srgb and any(np.allclose(weights, usual, atol=_NEAR) for usual in (_SRGB_D50, LUMINANCE)):
        return Stated(Colours.of("srgb"))
    return Stated(Colours(curves, weights, text), ((f"is converted with {text}", _TRANSFER),))


def _profile_curve(data: bytes, tag: bytes) -> Curve:
    """Return the curve that the ICC profile `data` has under `tag`, four letters such as `rTRC`.
    The entry is of type `curv` or `para` (ICC.1:2022, 10.6 and 10.18).

    Raises ValueError for another type, and StopIteration, IndexError or struct.error for a missing
    tag or damaged data."""
    # After a header of 128 bytes, a count and entries of 12 bytes: tag, offset, size.
    (count,) = struct.unpack_from(">I", data, 128)
    # At most 100 entries are read, because a damaged count may be huge.
    entries = (struct.unpack_from(">4sII", data, 132 + 12 * k) for k in range(min(count, 100)))
    start = next(at for name, at, _ in entries if name == tag)
    kind = data[start : start + 4]
    if kind == b"para":
        function, *_ = struct.unpack_from(">H", data, start + 8)
        lengths = (1, 3, 4, 5, 7)
        numbers = struct.unpack_from(f">{lengths[function]}i", data, start + 12)
        # The numbers are fixed-point, with 16 bits of fraction.
        return partial(_parametric, tuple(n / 65536 for n in numbers))
    if kind != b"curv":
        raise ValueError(f"a curve of type {kind!r}")
    (length,) = struct.unpack_from(">I", data, start + 8)
    samples = np.frombuffer(data, ">u2", length, start + 12).astype(np.float64)
    # No entry is the identity; a single entry is a power, in units of 1/256.
    if length <= 1:
        return partial(_power, float(samples[0]) / 256 if length else 1.0)
    return partial(_table, samples / 65535)


def _power(gamma: float, values: Floats) -> Floats:
    """Return values to the power `gamma`; negative ones become 0. A `gamma` of 1 changes
    nothing."""
    return np.maximum(values, 0.0) ** gamma if gamma != 1 else values


def _table(samples: Floats, values: Floats) -> Floats:
    """Return `values` (0..1) mapped by the curve that `samples` give at even distances from 0 to 1,
    with straight lines between. Values outside 0..1 get the first or the last sample."""
    return np.interp(values, np.linspace(0, 1, len(samples)), samples)


def _parametric(numbers: tuple[float, ...], values: Floats) -> Floats:
    """Return `values` mapped by the ICC parametric curve of `numbers`: 1, 3, 4, 5 or 7 of g, a, b,
    c, d, e, f.

    Three are g, a, b; four are g, a, b and one number for e and f. A missing a is 1, other missing
    numbers are 0."""
    # (a x + b)^g + e from d on, c x + f below it. Missing numbers make the second part empty.
    g, a, b, c, d, e, f = numbers[0], 1.0, 0.0, 0.0, -np.inf, 0.0, 0.0
    if len(numbers) > 1:
        a, b = numbers[1:3]
        d = -b / a
    if len(numbers) == 4:
        e = f = numbers[3]
    elif len(numbers) > 4:
        c, d = numbers[3:5]
        e, f = numbers[5:] or (0.0, 0.0)
    return np.where(values >= d, np.maximum(a * values + b, 0.0) ** g + e, c * values + f)


_CURVES: dict[int, Transfer | float] = {
    **dict.fromkeys((1, 6, 13, 14, 15), "srgb"),
    4: 2.2,
    5: 2.8,
    8: "linear",
    16: "pq",
    18: "hlg",
}
"""Transfer curves, or powers, by their number in ITU-T H.273. Displays show the camera curves of
BT.709 and BT.2020 nearly like sRGB."""
_D65, _C = (0.3127, 0.3290), (0.310, 0.316)
"""CIE x and y of the white points D65 and C."""
_PRIMARIES: dict[int, tuple[float, ...]] = {
    4: (0.67, 0.33, 0.21, 0.71, 0.14, 0.08, *_C), 5: (0.64, 0.33, 0.29, 0.60, 0.15, 0.06, *_D65),
    **dict.fromkeys((6, 7), (0.63, 0.34, 0.31, 0.595, 0.155, 0.07, *_D65)),
    9: (0.708, 0.292, 0.17, 0.797, 0.131, 0.046, *_D65),
    11: (0.68, 0.32, 0.265, 0.69, 0.15, 0.06, 0.314, 0.351),
    12: (0.68, 0.32, 0.265, 0.69, 0.15, 0.06, *_D65),
}  # fmt: skip
"""Primaries by their number in ITU-T H.273: x and y of red, green, blue, white."""
_UNSPECIFIED = (0, 2)
"""Numbers of transfer curves that say nothing: reserved and unspecified."""


def of_numbers(primaries: int, transfer: int) -> Stated:
    """Return the colours that a file states by two numbers of ITU-T H.273, those of its `primaries`
    and of its `transfer` curve.

    Primaries not in `_PRIMARIES` count as Rec. 709. A curve that is unspecified, or unknown (a note
    says so), counts as sRGB; the colours are None if the primaries are also those of Rec. 709.
    Other primaries are named in a note."""
    weights, notes = _weighted(_PRIMARIES.get(primaries))
    curve = _CURVES.get(transfer)
    if isinstance(curve, float):
        colours = Colours((partial(_power, curve),), weights, f"a curve of power {curve:g}")
        return Stated(colours, notes)
    if curve is not None:
        return Stated(Colours.of(curve, weights), notes)
    if transfer not in _UNSPECIFIED:
        text = f"names the unknown transfer curve {transfer}: the sRGB curve is used"
        notes = (*notes, (text, _TRANSFER))
    return Stated(Colours.of("srgb", weights) if weights != LUMINANCE else None, notes)


def of_primaries(primaries: Array | None) -> Stated:
    """Return the colours of linear light with these `primaries`: CIE x and y of red, green, blue
    and white, eight numbers of any shape. None counts as Rec. 709; others are named in a note."""
    weights, notes = _weighted(None if primaries is None else np.ravel(primaries).tolist())
    return Stated(Colours.of("linear", weights), notes)


def _weighted(primaries: Sequence[float] | None) -> tuple[Weights, tuple[Note, ...]]:
    """Return the luminances of red, green and blue for `primaries`, and a note if they are not
    those of Rec. 709.

    `primaries`: CIE x and y of red, green, blue and white, eight numbers. None counts as Rec. 709,
    without a note."""
    if primaries is None:
        return LUMINANCE, ()
    weights = luminance_weights(primaries)
    if np.allclose(weights, LUMINANCE, atol=_NEAR):
        return LUMINANCE, ()
    shown = ", ".join(f"{weight:.3g}" for weight in weights)
    text = f"names other primaries than Rec. 709: luminance has the weights {shown}"
    return weights, ((text, "convert its colours to Rec. 709 primaries if you need those weights"),)


def of_pillow(path: Path, info: Mapping[Any, Any]) -> Stated:
    """Return the colours of the file `path` that Pillow opened; `info` is what Pillow reads beside
    the samples.

    The first source that the file has counts: numbers of H.273 in a PNG, an ICC profile, numbers of
    H.273 in a HEIC, gamma and primaries in a PNG. A profile that cannot be used is passed over,
    with its note. Colours are None without any."""
    if _has_png_numbers(path):
        return of_film(path)
    notes: tuple[Note, ...] = ()
    if info.get("icc_profile"):
        stated = of_profile(info["icc_profile"])
        if stated.colours is not None:
            return stated
        notes = stated.notes
    if "nclx_profile" in info:
        nclx = info["nclx_profile"]
        stated = of_numbers(int(nclx["color_primaries"]), int(nclx["transfer_characteristics"]))
    # A PNG that says sRGB repeats it as a rounded gamma for old readers.
    elif "gamma" in info and "srgb" not in info:
        stated = _of_gamma(float(info["gamma"]), info.get("chromaticity"))
    else:
        stated = Stated()
    return Stated(stated.colours, notes + stated.notes)


def _of_gamma(gamma: float, primaries: Sequence[float] | None) -> Stated:
    """Return the colours of a PNG file by its `gamma` (the power of its encoding, 0.45 for a common
    display) and `primaries`, x and y of red, green, blue and white or None for Rec. 709.

    Gamma 1 is linear and 1 / 2.2 sRGB. Outside 0.01..100 the colours are None, with a note."""
    weights, notes = _weighted(primaries)
    standard: tuple[tuple[float, Transfer], ...] = ((1.0, "linear"), (1 / 2.2, "srgb"))
    for power, transfer in standard:
        if abs(gamma - power) <= _NEAR:
            return Stated(Colours.of(transfer, weights), notes)
    if not 0.01 < gamma < 100:
        return Stated(None, ((f"names the impossible gamma {gamma:g} (gAMA)", _TRANSFER),))
    return _named((partial(_power, 1 / gamma),), weights, f"gamma {gamma:g} (gAMA)")


def of_adobe_rgb() -> Stated:
    """Return the colours of Adobe RGB (1998), which cameras name in EXIF data without a profile."""
    return _named((partial(_power, 563 / 256),), _ADOBE_D50, "Adobe RGB, which its EXIF data name")


def of_film(path: Path) -> Stated:
    """Return the colours of the file `path` by the numbers of ITU-T H.273 that FFmpeg reads in it:
    of AVIF and PNG files, whose numbers Pillow does not return. Unstated if FFmpeg cannot read
    it."""
    with suppress(Exception):  # Pillow decodes it, whatever FFmpeg says
        import av

        with av.open(str(path)) as container:
            context = container.streams.video[0].codec_context
            return of_numbers(int(context.color_primaries), int(context.color_trc))
    return Stated()


def _has_png_numbers(path: Path) -> bool:
    """Return whether the PNG file `path` states numbers of ITU-T H.273, in a chunk cICP before its
    samples. False for other formats."""
    head, _, _ = head_of(path).partition(b"IDAT")
    return head.startswith(b"\x89PNG") and b"cICP" in head
