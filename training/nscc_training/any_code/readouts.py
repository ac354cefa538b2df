"""Combination of several readouts of one exposure, one of which is always open.

Without motion all readouts measure the same light, and their mean has less noise than an ordinary
frame. If they differ by more than their noise, the clip decoded from the coded readouts is used.
This needs no training, because the noise of every readout is known."""

from __future__ import annotations

import torch
from torch import Tensor
from torch.nn import functional

from nscc_training.measured import Measured

FIRST_STAGE = 4
"""The first stage whose clip enters the mean of clips.

The errors of the stages differ, because each sees the clip mirrored in another way. The mean gains
0.2 dB in moving and 4 dB in static regions."""
_WIDE, _NARROW, _AROUND = 9, 5, 15
"""Window sides in pixels: for two measures of motion, and for the error of the clip's mean."""
_STILL, _MOVING = 0.25, 0.6
"""Limits of the motion measure: below the first all is static, above the second all is moving."""


def always_open(measured: Measured[Tensor]) -> int | None:
    """Return the index of the readout whose shutters never close; None if there is no such readout.

    None is also returned if all readouts are always open."""
    opened = (measured.mask > 0).all(dim=2).flatten(2).all(dim=2).all(dim=0)
    if bool(opened.all()) or not bool(opened.any()):
        return None
    return int(opened.int().argmax())


def joined(measured: Measured[Tensor], clip: Tensor, number: int) -> Tensor:
    """Return the clip (batch, N, rows, cols), static where the readouts agree, elsewhere `clip`.

    Readout `number` is always open. The static light is the mean of all readouts, weighted by
    precision. It is moved towards the mean of `clip` if their difference is within the noise. Its
    error is therefore close to the noise of the readouts at most, and it is smooth if `clip` is
    right."""
    opened = measured.mask.sum(dim=2)
    light = measured.value / opened.clamp(min=1e-9)
    variance = measured.variance / opened.clamp(min=1e-9).square()
    known = (opened > 0) & ~measured.saturated
    precision = torch.where(known, 1 / variance.clamp(min=1e-12), 0.0)
    total = precision.sum(dim=1, keepdim=True)
    noise = 1 / total.clamp(min=1e-12)
    mean = (precision * light).sum(dim=1, keepdim=True) * noise
    # A saturated pixel had at least the light of its fullest readout.
    still = torch.where(total > 0, mean, light.amax(dim=1, keepdim=True))
    smooth = clip.mean(dim=1, keepdim=True)
    apart = _around((still - smooth).square(), _AROUND)
    share = (1 - _around(noise.clamp(max=1), _AROUND) / apart.clamp(min=1e-12)).clamp(0, 1)
    steady = smooth + share * (still - smooth)
    # The mean contains a part of each readout's noise, so their difference has less noise.
    spread = (variance - noise).clamp(min=1e-3 * variance.clamp(min=1e-9)).sqrt()
    deviation = torch.where(known, (light - mean) / spread, 0.0)
    coded = [k for k in range(light.shape[1]) if k != number]
    gate = ((_MOVING - motion(deviation[:, coded])) / (_MOVING - _STILL)).clamp(0, 1)
    return clip + gate.unsqueeze(1) * (steady - clip)


def motion(deviation: Tensor) -> Tensor:
    """Return a measure of motion (batch, rows, cols) from deviations (batch, B, rows, cols).

    A deviation is the difference of a coded readout from the static prediction, in standard
    deviations. The measure adds the mean square in a wide window minus 1 and the squared mean in a
    narrow one."""
    wide = _around(deviation.square(), _WIDE) - 1
    return (wide + _around(deviation, _NARROW).square()).mean(dim=1)


def _around(values: Tensor, side: int) -> Tensor:
    """Return the mean of a window around each pixel of (batch, [B,] rows, cols)."""
    return functional.avg_pool2d(values, side, 1, side // 2, count_include_pad=False)
