"""The scripted part of a frame: planes, and the gates that run however the demands are met."""

from __future__ import annotations

from dataclasses import dataclass, field

from nscc.logic.digits import Planes
from nscc.logic.problem import Segment


@dataclass(frozen=True)
class Script:
    """An encoding and the gates that do not depend on how demands (sets of shutters that FLAG must
    select at boundaries) are met.

    `encoding` describes it in words, and `states` is the number of state registers. `before[i]`
    runs before the gates of demand i (no key: nothing); it may overwrite states, scratch registers
    (for intermediate results) and FLAG. `opening` runs before the first demand, `closing` after the
    last; the planes must then be as at the start."""

    encoding: str
    planes: Planes
    states: int = 0
    opening: tuple[Segment, ...] = ()
    before: dict[int, tuple[Segment, ...]] = field(default_factory=dict)
    closing: tuple[Segment, ...] = ()
