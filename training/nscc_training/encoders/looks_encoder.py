"""The encoder for pixels that look: boundaries and levels of looks, the same for all pixels."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn

from nscc.arrays import Ints
from nscc_training.encoders.base import Codes, CodeTrial, Encoder, Over, Ranges, ShutterSpec, drawn
from nscc_training.gradients import replaced, rounded

_OCTAVES, _WELLS = 0.3, 0.06
"""Standard deviations of trials: of moments in octaves, of levels in full wells."""


class LooksEncoder(Encoder):
    """The encoder of pixels that close at the first look (a comparison of their light) above a
    level. All pixels have the same looks.

    Its tile is (1, looks). Its parameters are the logarithms of the boundaries of looks, to base 2,
    and the levels of looks in steps of IN, 1 to `spec.levels`. IN is the level sent to all pixels.
    """

    def __init__(self, spec: ShutterSpec, relaxation: str = "straight-through") -> None:
        """Begin with all looks at boundary 1 and level 1; the tile (1, looks) says how many. Raise
        ValueError if the frame has too few boundaries."""
        super().__init__(spec, relaxation)
        looks = spec.tile[1]
        if spec.tile[0] != 1 or looks >= spec.slots:
            raise ValueError(
                f"{looks} looks need a tile of (1, {looks}) and more than {looks} slots, not "
                f"{spec.tile} and {spec.slots}"
            )
        self.most = spec.levels or 1
        self.moment = nn.Parameter(torch.zeros(looks, dtype=torch.float64))
        self.level = nn.Parameter(torch.ones(looks, dtype=torch.float64))

    def ranges(self) -> Ranges:
        """Return the parameters of times (log2 of boundaries) and levels, each with its lowest and
        highest value."""
        most = float(np.log2(self.spec.slots - 1)) or 1.0
        return [(self.moment, (0.0, most)), (self.level, (1.0, float(max(self.most, 2))))]

    def shutters(self, generator: torch.Generator | None, soft: bool) -> Tensor:
        """Return whole boundaries, then whole levels, in place of shutters: (2 looks, 1, 1). The
        open time of a pixel depends on its light.

        The arguments have no effect."""
        return self.hardened(self.fields()).float()

    def fields(self) -> Tensor:
        """Return the real parameters (2 looks, 1, 1): logarithms of boundaries, then levels."""
        return torch.cat([self.moment, self.level]).reshape(-1, 1, 1)

    def hardened(self, fields: Tensor) -> Tensor:
        """Return whole increasing boundaries, then whole levels, (2 looks, ..), from real `fields`
        of this shape.

        A boundary is at least one after that of the look before, and leaves room for the looks
        after it. The gradient passes as if nothing was rounded."""
        moments, levels = fields.chunk(2)
        look_slots = 2.0**moments  # times are learned as logarithms to base 2
        looks, slots = len(look_slots), self.spec.slots
        whole_slots = torch.round(look_slots.detach())
        boundaries: list[Tensor] = []
        for k in range(looks):
            least = boundaries[-1] + 1 if boundaries else torch.ones_like(whole_slots[k])
            boundaries.append(
                torch.clamp(torch.maximum(whole_slots[k], least), max=slots - looks + k)
            )
        return torch.cat(
            [
                replaced(look_slots, torch.stack(boundaries)),
                rounded(levels.clamp(1, max(self.most, 1))),
            ]
        )

    def trial(self, over: Over, generator: torch.Generator) -> CodeTrial:
        """Return two versions of times and levels, moved by the same random steps in opposite
        directions.

        `over` repeats them over the pixels of a patch, each of which moves on its own. The moves
        are drawn from `generator`. A side has (2 looks, rows, cols) fields, as whole boundaries and
        levels."""
        fields = over(self.fields())
        with torch.no_grad():
            # The first half of the fields are times, as logarithms; the second half are levels.
            spread = torch.full_like(fields, _OCTAVES)
            spread[len(fields) // 2 :] = max(1.0, _WELLS * self.most)
            moved = spread * drawn(fields, generator, self.tried_share)
            first, second = (self.hardened(fields + sign * moved).float() for sign in (1, -1))
        return CodeTrial(fields, moved, spread, (first, second))

    def codes(self) -> Codes:
        """Return the codes as integers (1, looks) by field: the boundaries `at` of the looks, and
        the levels `level` with which they compare, in steps of the chip's analog input."""
        self.check_finite()
        with torch.no_grad():
            at, level = self.hardened(self.fields()).chunk(2)
        shape = self.spec.tile
        return {
            name: values.reshape(shape).to("cpu", torch.int64).numpy()
            for name, values in (("at", at), ("level", level))
        }

    def load_codes(self, codes: Mapping[str, Ints]) -> None:
        """Set the boundaries `at` and the levels `level`, both (1, looks). Raise ValueError if one
        is missing, has another shape or is out of range, or if boundaries do not increase."""
        limits = {"at": (1, self.spec.slots - 1), "level": (1, self.most)}
        at, level = self.checked(codes, limits)
        if not bool((at[0, 1:] > at[0, :-1]).all()):
            raise ValueError(
                "its looks do not follow each other: the boundaries `at` must increase"
            )
        self._fill(at[0].numpy(), level[0].numpy())

    def start_random(self, generator: np.random.Generator) -> None:
        """Draw different boundaries and independent levels, all with equal probability."""
        looks = self.spec.tile[1]
        at = 1 + np.sort(generator.choice(self.spec.slots - 1, looks, replace=False))
        self._fill(at, generator.integers(1, self.most, looks, endpoint=True))

    def start_uniform(self) -> None:
        """Set evenly spaced boundaries, and all levels at half of the largest."""
        looks = self.spec.tile[1]
        at = np.linspace(0, self.spec.slots, looks + 2)[1:-1]
        self._fill(at, np.full(looks, max(1, self.most // 2)))

    def start_quad(self) -> None:
        """Set boundaries in a geometric sequence from 1, and one level for all, at which the
        exposure at the next look nearly fills the well."""
        looks = self.spec.tile[1]
        ratio = self.spec.slots ** (1 / looks)
        # From one look to the next the exposure grows by `ratio`; it then reaches 90 % of the well.
        level = 0.9 * self.most / max(ratio, 2.0)
        self._fill(ratio ** np.arange(looks), np.full(looks, max(1.0, np.rint(level))))

    def _fill(self, at: NDArray[np.generic], level: NDArray[np.generic]) -> None:
        """Set the parameters to boundaries `at` and levels `level`, both (looks,). They are not
        checked."""
        with torch.no_grad():
            self.moment.copy_(torch.log2(torch.as_tensor(np.asarray(at, np.float64)).clamp(min=1)))
            self.level.copy_(torch.as_tensor(np.asarray(level, np.float64)))
