"""When things happen in a frame, how long digital memory keeps, and what FLAG holds meanwhile."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import accumulate, pairwise
from typing import Literal

from nscc.lower.plan import ExposurePlan, Step
from nscc.operations import Effect
from nscc.target.target import Target

# Words take time, and the retention is a typical figure: nothing is left to age beyond this share.
RETENTION_SHARE = 0.9


@dataclass(frozen=True)
class Timeline:
    """The frame's time in microseconds.

    `boundary_us[n]` is the time of boundary n; `between_us` lies between boundary N and the next
    frame's boundary 0 (readout). `refresh_at` are the boundaries inside the frame at which
    registers must be written again; None where even that cannot keep them.
    """

    boundary_us: tuple[float, ...]
    between_us: float
    keep_us: float
    refresh_at: tuple[int, ...] | None

    @property
    def slots(self) -> int:
        """Number of slots."""
        return len(self.boundary_us) - 1


def timeline(slot_us: tuple[float, ...], buckets: int, target: Target) -> Timeline:
    """The timeline of a frame of `buckets` readouts."""
    boundary_us = (0.0, *accumulate(slot_us))
    between_us = target.readout_us * buckets
    keep_us = RETENTION_SHARE * target.digital_retention_us
    return Timeline(
        boundary_us, between_us, keep_us, _refresh_boundaries(boundary_us, between_us, keep_us)
    )


def _refresh_boundaries(
    boundary_us: tuple[float, ...], between_us: float, keep_us: float
) -> tuple[int, ...] | None:
    """As few boundaries as keep every gap within keep_us, from one frame's end to the next's."""
    at: list[int] = []
    last = -between_us
    for n in range(1, len(boundary_us)):
        if boundary_us[n] - last > keep_us:
            if boundary_us[n] - boundary_us[n - 1] > keep_us or boundary_us[n - 1] <= last:
                return None
            at.append(n - 1)
            last = boundary_us[n - 1]
    return tuple(at)


def fades(written_at: tuple[int, ...], time: Timeline) -> bool:
    """Whether a register written at these boundaries of every frame is ever left too long."""
    if not written_at:
        return True
    times = [time.boundary_us[n] for n in sorted(written_at)]
    wrap = time.boundary_us[-1] - times[-1] + time.between_us + times[0]
    gaps = [b - a for a, b in pairwise(times)]
    return max([wrap, *gaps]) > time.keep_us


Before = Literal["nothing", "all", "keep", "load"]


def flag_actions(plan: ExposurePlan, time: Timeline, target: Target) -> list[Before]:
    """What each step needs done to FLAG before its words.

    "nothing": FLAG does not matter; "all": set it everywhere; "load": bring the step's predicate;
    "keep": FLAG still holds the last predicate that was loaded, or 1 everywhere if the step is
    for every pixel.
    """
    lost_at = set(time.refresh_at or ())
    actions: list[Before] = []
    held: Literal["unknown", "all", "predicate"] = "unknown"
    loaded: int | None = None
    since_us = 0.0
    boundary = 0
    for step in plan.steps:
        now_us = time.boundary_us[step.boundary]
        crossed = any(boundary < n <= step.boundary for n in lost_at) if lost_at else False
        if crossed or now_us - since_us > time.keep_us:
            held = "unknown"
        boundary = step.boundary
        if step.predicate is not None:
            actions.append("keep" if held == "predicate" else "load")
            if held != "predicate" or step.predicate != loaded:
                since_us = now_us
            held, loaded = "predicate", step.predicate
        elif not _needs_flag(step, target):
            actions.append("nothing")
        elif held == "all":
            actions.append("keep")
        else:
            actions.append("all")
            held, since_us = "all", now_us
    return actions


def _needs_flag(step: Step, target: Target) -> bool:
    for word in step.words:
        effect = word.operation.effect
        if effect is Effect.BUS:
            return True
        if effect is Effect.RESET_PIX and target.reset_honours_flag != "no":
            return True
    return False
