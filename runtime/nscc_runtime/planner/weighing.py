"""What frames by weighted sums have in common whatever the scene, laid out for the loops over
pixels."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.counts import LIGHT, WITHOUT_LIGHT
from nscc_runtime.effects.parts import (
    CountedDark,
    CountedLight,
    Exchange,
    Soft,
    Well,
    WordGain,
)
from nscc_runtime.loop import Bound
from nscc_runtime.planner.chip import Chip
from nscc_runtime.planner.frame_loop import add_up

Values = NDArray[np.float64]
Weights = NDArray[np.float32]

ROUNDING = 1e-12
"""Of sums of charge: the part by which a well that is just full may seem to hold more."""
_NONE, _NONE_32 = np.zeros((1, 1)), np.zeros(1, np.float32)


@dataclass(frozen=True, eq=False)
class Weighing:
    """Sums under the effects of a chip, where the charge of the groups `counted` is counted."""

    chip: Chip
    counted: tuple[int, ...]

    @cached_property
    def sources(self) -> list[tuple[int, int]]:
        """What counts charge: the effect's stream, and the source."""
        kept = self.chip.kept
        lit = [(effect.stream, LIGHT) for effect, _ in kept.having(CountedLight)]
        return lit + [(effect.stream, WITHOUT_LIGHT) for effect, _ in kept.having(CountedDark)]

    @cached_property
    def noise(self) -> tuple[list[tuple[int, int]], Values]:
        """The streams and draws of small errors, and how much (draws, buckets, lanes) each is."""
        program, kept = self.chip.program, self.chip.kept
        # What is left out by choice is still the better account of where noise goes.
        wanted = program.model(self.chip.wanted)
        draws, sigmas = [], []
        for effect, part in kept.errors():
            factor = part.sigma_e(program.sensor) * program.tables.noise(part.at, wanted)[0]
            for draw in range(factor.shape[2]):
                if factor[:, :, draw].any():
                    draws.append((effect.stream, draw))
                    sigmas.append(factor[:, :, draw].T)
        shape = len(draws), len(program.container.buckets), len(program.container.encoding)
        return draws, np.ascontiguousarray(np.array(sigmas).reshape(shape))

    @cached_property
    def sizes(self) -> dict[str, Any]:
        """Everything of `Adding` but the rows."""
        program, kept = self.chip.program, self.chip.kept
        exchange, mark = kept.part(Exchange), kept.marking("well")
        rows, cols = program.reference.groups.lane.shape
        return {
            "rows": rows,
            "cols": cols,
            "pixels": rows * cols,
            "buckets": len(program.container.buckets),
            "lane_count": len(program.container.encoding),
            "groups": len(self.counted),
            "sources": len(self.noise[0]),
            "exchanges": bool(self.sources) and exchange is not None,
            "clipped": kept.part(Well) is not None and kept.part(Soft) is None,
            "patterned": kept.part(WordGain) is not None,
            "well_bit": mark.bit if mark else 0,
            "fraction": 0.0 if exchange is None else exchange.fraction(program.sensor),
            "full": 1.0 + ROUNDING,
        }

    @cached_property
    def weights(self) -> Values:
        """Mean weights (groups, buckets, lanes) of the deviations of a group's counts."""
        program = self.chip.program
        means = program.mean_weights(program.model(self.chip.kept))
        shape = len(self.counted), len(program.container.buckets), len(program.container.encoding)
        each = [means[group].T for group in self.counted]
        return np.ascontiguousarray(np.array(each).reshape(shape))

    @cached_property
    def overlap(self) -> tuple[Weights, Weights]:
        """Where pixels exchange counts: weights of their own, and of their neighbours'."""
        program = self.chip.program
        found = program.overlap(program.model(self.chip.kept), self.counted)
        return found.own, found.neighbours

    @cached_property
    def adding(self) -> Bound:
        """The loop that adds up, with all that scenes have in common."""
        own, neighbours = self.overlap if self.sizes["exchanges"] else (_NONE_32, _NONE_32)
        return add_up.bound(
            lanes=self.chip.program.lanes,
            weights=self.weights,
            own=own,
            neighbours=neighbours,
            limits=self.chip.limits if self.sizes["clipped"] else _NONE,
            patterns=self.chip.patterns if self.sizes["patterned"] else _NONE,
            sigma=self.noise[1],
        )
