"""Diagrams of tradeoffs."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING

from nscc.tradeoff.points import Point
from nscc_runtime.pictures.precision import Guide, Panel, PointReading, precision_diagram

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from nscc_training.tradeoff.joint import Joint
    from nscc_training.tradeoff.sensor import SensorStudyResult

TITLES = {"psnr_db": "PSNR, dB", "ssim": "SSIM"}
"""Axis titles of the units of a decoder's points."""


def decoder_diagram(points: Sequence[Point], repeats: int, device: str) -> Figure:
    """Draw PSNR and SSIM against the time of a scene: a panel a case, a line a decoder."""
    panels = [
        Panel(case, title, [point for point in case_points if point.error_unit == unit])
        for case, group in groupby(points, key=lambda point: point.case)
        for case_points in [list(group)]
        for unit, title in TITLES.items()
    ]
    times = "one run" if repeats == 1 else f"median and range of {repeats} runs"
    return precision_diagram(
        panels, "What decoding time buys",
        f"more is better; hollow: dominated; time of one scene, {times}, on {device}",
        PointReading("time of one scene, ms", linear=True),
    )  # fmt: skip


def sensor_diagram(measured: SensorStudyResult, slot_us: float | None) -> Figure:
    """Draw PSNR against the shortest slot or at `slot_us`, stills apart from clips."""

    def names(point: Point) -> tuple[str, str]:
        """Return the panel and line of a point."""
        shutters, _, way = point.method.partition(", ")
        if not way:  # pixels that look have one lowering; their number is the number of exposures
            return ("stills, pixels that look", shutters.partition("-")[0])
        return (f"stills, class {shutters}", way) if point.case == "stills" else (way, shutters)

    points = sorted(measured.points, key=names)
    panels = [
        Panel(title, "PSNR, dB", list(group))
        for title, group in groupby(points, key=lambda point: names(point)[0])
    ]
    slots = "shortest slots" if slot_us is None else f"slots of {slot_us:g} us"
    return precision_diagram(
        panels, "What the shortest slot costs",
        f"captured by the emulated {measured.target} at {slots} (numbers: slots of a frame, "
        "exposures of pixels that look; hollow: dominated), decoded without training",
        PointReading(
            "shortest slot, us", 1e3, lambda point: names(point)[1],
            lambda point: point.method.partition("-")[2] or point.setting.split()[0], linear=True,
        ),
    )  # fmt: skip


def joint_diagram(joint: Joint, repeats: int, device: str) -> Figure:
    """Draw the points of all stages, a line for each, and mark the recommended ones."""
    advised = {id(advice.point) for advice in joint.advice}
    names = {
        advice.stage: f"{advice.stage}: {', '.join(filter(None, (point.method, point.setting)))}"
        for advice in joint.advice for point in [advice.point] if point is not None
    }  # fmt: skip
    guides = (
        Guide(f"target, {joint.target}", "--", error=joint.target_percent),
        Guide("the light's own noise", ":", error=joint.shot_percent),
    )
    points = sorted(joint.points, key=lambda point: (joint.stages.index(point.case), point.time_ms))
    times = "one run" if repeats == 1 else f"medians of {repeats} runs"
    return precision_diagram(
        [Panel("", "RMS error, % of the mean signal", points, guides)],
        f"{joint.program} on {Path(joint.scene).name}: what each stage's time buys",
        "compile, lowering, slots: the chip's frame against the light that fell; effects: against "
        "the reference; decoder: against the scene's light (names: the advised setting; hollow: "
        f"dominated within its stage; pointing down: no error); {times} on {device}",
        PointReading(
            "time, s", 1e-3, lambda point: names[point.case],
            lambda point: "advised" if id(point) in advised else "",
        ),
    )  # fmt: skip
