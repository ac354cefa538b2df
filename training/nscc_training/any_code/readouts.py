"""Several readouts of one exposure, one of them always open: what stands still, and what moves.

Where nothing moves all readouts tell of the same light, and together more surely than an ordinary
camera. Where they contradict each other by more than their noise, the clip of the coded ones is
taken. Nothing is learned for this: the noise of every readout is known.
"""

from __future__ import annotations

import torch
from torch import Tensor
from torch.nn import functional

from nscc_training.measured import Measured

FIRST_STAGE = 4
"""The clip is the mean of those of this stage and all after it. Their errors differ, as stages see
the clip mirrored in different ways: worth 0.2 dB where things move, and 4 dB where nothing does."""
_WIDE, _NARROW, _AROUND = 9, 5, 15
"""Windows of pixels a side: of two measures of motion, and of how wrong the clip's mean is."""
_STILL, _MOVING = 0.25, 0.6
"""Below the first measure of motion nothing moves, above the second everything does."""


def always_open(measured: Measured[Tensor]) -> int | None:
    """Return the number of the readout whose shutters never close, if there is one beside others
    that do."""
    opened = (measured.mask > 0).all(dim=2).flatten(2).all(dim=2).all(dim=0)
    if bool(opened.all()) or not bool(opened.any()):
        return None
    return int(opened.int().argmax())


def joined(measured: Measured[Tensor], clip: Tensor, number: int) -> Tensor:
    """Return the clip (batch, N, rows, cols) that is still where the readouts agree, and elsewhere
    as `clip` is; readout `number` is always open.

    The still light is the mean of all readouts by precision. It shrinks towards the clip's mean as
    far as the difference of both is no larger than the noise of the first: so it is never much less
    sure than the readouts, and nearly as smooth as the clip where the clip is right.
    """
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
    # The mean has a part of each readout's own noise; it is no other light than one that is alone.
    spread = (variance - noise).clamp(min=1e-3 * variance.clamp(min=1e-9)).sqrt()
    deviation = torch.where(known, (light - mean) / spread, 0.0)
    coded = [k for k in range(light.shape[1]) if k != number]
    gate = ((_MOVING - motion(deviation[:, coded])) / (_MOVING - _STILL)).clamp(0, 1)
    return clip + gate.unsqueeze(1) * (steady - clip)


def motion(deviation: Tensor) -> Tensor:
    """Return how far coded readouts contradict what stands still (batch, rows, cols), from their
    deviations (batch, B, rows, cols): the mean square in a wide window beyond 1, and the square of
    the mean in a narrow one."""
    wide = _around(deviation.square(), _WIDE) - 1
    return (wide + _around(deviation, _NARROW).square()).mean(dim=1)


def _around(values: Tensor, side: int) -> Tensor:
    """Return the mean of a window around each pixel of (batch, [B,] rows, cols)."""
    return functional.avg_pool2d(values, side, 1, side // 2, count_include_pad=False)
