"""The scripted part of a frame: planes, and the gates that run whatever answers the demands."""

from __future__ import annotations

from dataclasses import dataclass, field

from nscc.logic.digits import Planes
from nscc.logic.problem import Segment


@dataclass(frozen=True)
class Script:
    """An encoding and the gates that do not depend on how demands are met.

    `before[i]` runs before the gates of demand i; it may overwrite states, scratch registers and
    FLAG."""

    encoding: str
    planes: Planes
    states: int = 0
    opening: tuple[Segment, ...] = ()
    before: dict[int, tuple[Segment, ...]] = field(default_factory=dict)
    closing: tuple[Segment, ...] = ()
