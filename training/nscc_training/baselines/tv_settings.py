"""The settings of total variation: their kinds, meanings and defaults, without torch."""

from __future__ import annotations

from dataclasses import dataclass

from nscc.toml.kinds import Integer, Number
from nscc.toml.schema import key


@dataclass(frozen=True)
class TvSettings:
    """How clips are reconstructed by total variation: the number of iterations of the method, and
    the weight of total variation."""

    iterations: int = key(Integer(1, 10000), "Iterations of total variation", 40)
    weight: float = key(
        Number(0, 10, low_excluded=True), "Weight of total variation, for values 0..1", 0.1
    )
