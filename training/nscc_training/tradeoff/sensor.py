"""Points of `nscc tradeoff sensor`: PSNR against the shortest slot, and against readout time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from itertools import groupby, product
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from nscc.arrays import Array, Floats
from nscc.chips.load import load_target
from nscc.compiler import compile_file
from nscc.examples import examples
from nscc.options import Options
from nscc.words.container import Container
from nscc_runtime.light import Light
from nscc_runtime.pictures.precision import Panel, Point, PointReading, precision_diagram
from nscc_training.any_code.decode import decoded_clip
from nscc_training.any_code.frames import exposed_frame
from nscc_training.command_settings import SensorStudySettings
from nscc_training.demo.expose import CLIPS
from nscc_training.design.bracket import camera
from nscc_training.experiments.engine import Figures
from nscc_training.experiments.study import Study, StudyPoint, StudyResult
from nscc_training.experiments.study_table import refusals_text, table_text
from nscc_training.measures import number
from nscc_training.metrics import finite_mean
from nscc_training.protocol_scenes.file_scenes import KINDS, kinds_in
from nscc_training.sweep.bench import (
    BenchScenes,
    bench_figures,
    is_looks_row,
    looks_figures,
    scenes_of,
)
from nscc_training.sweep.emulating import EMULATE
from nscc_training.sweep.point import Values

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SLOTS, SLOT_US = 16, 125.0
"""Number and length in microseconds of the slots of the shipped programs."""


def sensor_study(settings: SensorStudySettings) -> Study:
    """Return the study of what shutters and readouts reach on a chip: PSNR against the shortest
    slot, and against readout time.

    Readouts are studied only if the data contain clips. Raises Rejected for a target that cannot be
    loaded, and NS0811 for a data folder without scenes."""
    points, target = sensor_points(settings), load_target(settings.target, Path()).name
    if any(point.case == "clips" for point in points):
        points += readout_points(settings)

    def text(measured: StudyResult) -> str:
        """Return the tables of shutters and of readouts, and a line for each program that does not
        fit."""
        readouts = [point for point in measured.points if point.case == "readouts"]
        names = ("shutters", "slots", "PSNR, dB"), ("readouts", "count", "PSNR, dB")
        tables = [table_text(shutters_of(measured.points), names[0], ("slot, us", 1e3))]
        if readouts:
            tables.append(table_text(readouts, names[1], ("readout, ms", 1.0)))
        refused = [f"does not fit: {line}" for line in refusals_text(measured.refused)]
        return "\n".join(["\n\n".join(tables), *refused])

    def diagram(measured: StudyResult, _device: str) -> Figure:
        """Draw PSNR against the shortest slot."""
        return sensor_diagram(shutters_of(measured.points), target, settings.slot_us)

    return Study(
        points, text, {"png": diagram}, device=target, lists_refused=True, csv_of=shutters_of
    )


def shutters_of(points: Sequence[Point]) -> list[Point]:
    """Return the points of shutters: all points except those whose case is "readouts"."""
    return [point for point in points if point.case != "readouts"]


def sensor_points(settings: SensorStudySettings) -> list[StudyPoint]:
    """Return a point for each combination of class, number of slots, kind of codes and lowering,
    and for each number of looks. Points of kinds of scenes that the data lack are left out.

    The method of a point is "CLASS, CODES codes, LOWERING" (`sensor_diagram` splits it at ", "), or
    "looks-N" and "designed-N" for pixels that look N times, with the usual or with designed times
    and levels. Clips have as many frames as the largest number of slots. Stills are exposed by
    class b on a tile of 2 x 2 stops, and by pixels that look. Raises Rejected (NS0811) for a folder
    without scenes. A lowering is a way to compute the exposure."""
    kinds = KINDS if settings.data is None else kinds_in(settings.data)
    shapes = [("clips", *shape) for shape in product(settings.classes, settings.slots)]
    shapes += [("stills", "b", slots) for slots in settings.stop_slots]
    points = []
    for (kind, name, slots), codes, lowering in product(shapes, settings.codes, settings.lowerings):
        values = {
            **bench_values(settings, kind),
            "class": name,
            "slots": slots,
            "codes": codes,
            "lowering": lowering,
        }
        method = f"{name}, {codes} codes, {lowering}"
        points.append(_point(kind, method, slots, partial(bench_figures, values)))
    rows = [("looks", count) for count in settings.looks if is_looks_row(count)]
    for name, count in rows + [("designed", count) for count in settings.looks]:
        values = {
            **bench_values(settings, "stills"),
            "exposures": count,
            "designed": name == "designed",
        }
        # Pixels that look have the 256 slots of hdr-v1, whatever the settings.
        points.append(_point("stills", f"{name}-{count}", 256, partial(looks_figures, values)))
    return [point for point in points if point.case in kinds]


def bench_values(settings: SensorStudySettings, kind: str) -> Values:
    """Return the values, by option, of a sweep's point of kind `emulate` for scenes of one `kind`,
    "clips" or "stills". Options that `settings` do not have keep their defaults; stills add a tile
    of 2 x 2 stops."""
    tile = {"tile": (2, 2), "init": "quad"} if kind == "stills" else {}
    return {
        **EMULATE.defaults(),
        **tile,
        "target": settings.target,
        "level": settings.level,
        "effects": settings.effects,
        "seed": settings.seed,
        "bench": kind,
        "at_us": settings.slot_us,
        "data": str(settings.data or ""),
        "scenes": settings.count,
        "frames": max(settings.slots),
    }


def _point(kind: str, method: str, slots: int, measure: Callable[[], Figures]) -> StudyPoint:
    """Return a point of the study for scenes of one `kind`, "clips" or "stills", a `method`
    ("CLASS, CODES codes, LOWERING", or "NAME-COUNT" for pixels that look), and a number of slots.

    `measure` is called when the point runs; it returns `psnr_db`, `shortest_slot_us` and `words`,
    as `bench_figures` does."""
    setting = f"{slots} slots"

    def figures() -> Figures:
        """Measure, and return the PSNR in dB, the shortest slot in ms, and the setting with the
        number of words."""
        found = measure()
        return {
            "psnr_db": found["psnr_db"],
            "ms": [found["shortest_slot_us"] / 1e3],
            "setting": f"{setting}, {found['words']} words",
        }

    return StudyPoint(kind, method, setting, figures)


def readout_points(settings: SensorStudySettings) -> list[StudyPoint]:
    """Return two points for each number of readouts in `settings.readouts`, both of clips.

    Point "coded" reads out one coded exposure that many times, and the decoder for any code
    reconstructs the clip. Point "burst" takes that many ordinary frames one after another, and
    shows each frame for the time for which it was open."""
    # The shipped programs have this many slots, whatever the settings.
    values = {**bench_values(settings, "clips"), "frames": SLOTS}
    return [
        StudyPoint("readouts", method, str(count), partial(_readouts, method, count, values))
        for count in settings.readouts
        for method in ("burst", "coded")
    ]


def _readouts(method: str, count: int, values: Values) -> Figures:
    """Return the mean PSNR in dB over clips that were captured in `count` readouts, the readout
    time in ms, and a text of both as `setting`. `method` is "burst", ordinary frames one after
    another, or "coded", the shipped program with `count` readouts (1 to 4). `values` are those of
    `bench_values` and describe the scenes. Raises Rejected if the program does not fit the target.
    """
    scenes = scenes_of(values)
    if method == "burst":
        container = camera(SLOTS, SLOT_US, values["target"], count)
    else:
        options = Options(level=values["level"], target=values["target"])
        container = compile_file(examples()[CLIPS[count]], options).built
    psnr_db = finite_mean(
        number(scene.scores(_clip(method, container, scene.light_e, scenes, index))["psnr_db"])
        for index, scene in enumerate(scenes.scenes)
    )
    readout_ms = scenes.target.readout_us / 1e3
    setting = f"{count} x {readout_ms:g} ms"
    return {"psnr_db": psnr_db, "ms": [count * readout_ms], "setting": setting}


def _clip(
    method: str, container: Container, light_e: Array, scenes: BenchScenes, index: int
) -> Floats:
    """Return the reconstruction (N, rows, cols) of a clip, in electrons in each of its N frames.

    The clip is scene number `index`, with the light `light_e` (N, rows, cols). With the `method`
    "coded" the network decodes its readouts. In a burst, each frame is shown for as long as it was
    open."""
    light = Light.of_clip(light_e.astype(np.float32))
    coded = exposed_frame(container, light, scenes.sensor, scenes.request(index))
    if method == "coded":
        return np.asarray(decoded_clip(coded.clip().tensors())[0].numpy(), np.float64)
    # Each frame of a burst is shown for as long as it was open.
    # All pixels of a burst share one shutter, (frames, slots).
    slots = coded.opened[0].sum(axis=-1)
    shown = coded.value_e / slots[:, None, None]
    return np.repeat(np.asarray(shown, np.float64), slots, axis=0)


def sensor_diagram(points: Sequence[Point], target: str, slot_us: float | None) -> Figure:
    """Draw the PSNR of points against the shortest slot. Stills have a panel for their class and
    one for pixels that look; clips have a panel for each kind of codes and lowering (a way to
    compute the exposure).

    `slot_us` is the length of the slots, None if each program has its shortest; the note says so.
    """

    def names(point: Point) -> tuple[str, str]:
        """Return the names of the panel and of the line that a point belongs to, from its method:
        "CLASS, CODES codes, LOWERING", or "NAME-COUNT" for pixels that look."""
        shutters, _, way = point.method.partition(", ")
        if not way:  # pixels that look have one lowering; their number is the number of exposures
            return ("stills, pixels that look", shutters.partition("-")[0])
        return (f"stills, class {shutters}", way) if point.case == "stills" else (way, shutters)

    panels = [
        Panel(title, "PSNR, dB", list(group))
        for title, group in groupby(sorted(points, key=names), key=lambda point: names(point)[0])
    ]
    slots = "shortest slots" if slot_us is None else f"slots of {slot_us:g} us"
    return precision_diagram(
        panels,
        "What the shortest slot costs",
        f"captured by the emulated {target} at {slots} (numbers: slots of a frame, "
        "exposures of pixels that look; hollow: dominated), decoded without training",
        PointReading(
            "shortest slot, us",
            1e3,
            lambda point: names(point)[1],
            lambda point: point.method.partition("-")[2] or point.setting.split()[0],
            linear=True,
        ),
    )
