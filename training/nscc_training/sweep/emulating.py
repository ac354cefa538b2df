"""Points of kind emulate: captures of the emulated chip, and scores of reconstructions."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from hashlib import sha256
from pathlib import Path

import numpy as np

from nscc.toml.kinds import Flag, Integer, Number, TextKind
from nscc.toml.schema import Key
from nscc_runtime.request import Request
from nscc_training.command_settings import SensorStudySettings
from nscc_training.experiments.engine import Figures
from nscc_training.sweep.point import PointFault, PointKind, Values
from nscc_training.sweep.point_programs import (
    axis,
    compiled_of,
    declared_axes,
    light_files,
    program_fault,
    program_files,
    program_keys,
    scene_keys,
    scene_of_point,
    sensor_keys,
    sensor_of,
    silent,
)

_BENCHES = ("clips", "stills")
_SILENT = {
    "scene": ("data", "scenes", "frames", "at_us"),
    "bench": (
        "slot_us",
        "max_words",
        "exposure",
        "transfer",
        "tolerance",
        "fidelity",
        "audit",
        "device_seed",
    ),
}
"""Keys that have no effect on points with a scene, and on points with a bench."""


def _keys() -> tuple[Key, ...]:
    """Return the keys that points of kind emulate may have in a grid."""
    return (
        *program_keys(),
        *scene_keys(),
        axis(
            "bench",
            TextKind(_BENCHES),
            "instead of scene: scenes of a protocol, decoded without training",
        ),
        axis("data", TextKind(), "the bench's folder of scenes; empty: synthetic scenes", ""),
        axis("scenes", Integer(1, 1000), "the number of scenes", 1),
        axis(
            "frames",
            Integer(1, 4096),
            "number of frames of the bench's clips, a multiple of the slots",
            16,
        ),
        axis(
            "at_us",
            Number(0.01, 1e6, automatic=True),
            "slot length of the bench; auto: the shortest",
            None,
        ),
        *declared_axes(SensorStudySettings, "effects"),
        axis("tolerance", TextKind(), "the tolerance of the plan, as in --tolerance", "5e"),
        *declared_axes(Request, "fidelity"),
        axis("audit", Flag(), "measure how far the plan is from the reference", False),
        *declared_axes(Request, "device_seed"),
        *sensor_keys(),
    )


def _fault(values: Values, named: Collection[str]) -> PointFault | None:
    """Return the first thing that is wrong with the values of a point of kind emulate, or None.
    `named` are the keys that the grid states."""
    if ("scene" in values) == ("bench" in values):
        return PointFault(
            "bench" if "bench" in values else "",
            "a point needs a scene or a bench",
            'for instance scene = "builtin:hdr", or bench = "clips"',
        )
    if "bench" in values and "class" not in values:
        return PointFault("bench", "a bench needs a class, but it is missing", 'add class = "d"')
    if values.get("bench") == "clips" and values["frames"] % values["slots"]:
        return PointFault(
            "frames",
            f"{values['slots']} slots do not divide {values['frames']} frames",
            "name a multiple of every number of slots",
        )
    if values.get("bench") == "stills" and values["class"] != "b":
        return PointFault("bench", "a bench of stills exposes class b", 'write class = "b"')
    if "bench" in values and not values["target"]:
        return PointFault("bench", "a bench needs a chip", 'add target = "scamp5"')
    changed = next((name for name in values if name.startswith("chip.")), None)
    if "bench" in values and changed:
        return PointFault(changed, "a bench cannot change the chip", "name a target's file instead")
    source = "bench" if "bench" in values else "scene"
    return silent(named, _SILENT[source], f"a {source}") or program_fault(values, named)


def _reads(values: Values) -> Sequence[Path]:
    """Return the files that a point of kind emulate reads."""
    data = [Path(values["data"])] if values["data"] else []
    return [*program_files(values), *light_files(values), *data]


def _capture(values: Values, threads: int) -> Figures:
    """Expose a scene with the program of a point. Return the mean, the shares of saturated and
    invalid pixels, and the predicted and measured errors of the plan, if it has one. The mean is
    None without valid pixels.

    `threads` are those of the simulation."""
    from nscc.containers import with_pixels
    from nscc.words.readout import converter_of
    from nscc_runtime import capture

    compiled = compiled_of(values)
    container = with_pixels(compiled.built, "the program")
    plans = values["effects"] != "none" and values["fidelity"] == "planned"
    shot = capture(
        container,
        scene_of_point(values),
        sensor=sensor_of(values, converter_of(container)),
        effects=values["effects"],
        tolerance=values["tolerance"] if plans else None,
        fidelity=values["fidelity"],
        audit=values["audit"],
        seed=values["seed"],
        device_seed=values["device_seed"],
        threads=threads,
    )
    plan, audit = shot.plan, shot.audit
    return {
        "shortest_slot_us": round(compiled.shortest_slot_us, 6),
        "mean_e": float(shot.exposure_e[shot.valid].mean()) if shot.valid.any() else None,
        "saturated_share": float(shot.saturated.mean()),
        "invalid_share": float(1 - shot.valid.mean()),
        **({} if plan is None else {"predicted_e": plan.predicted_e}),
        **({} if audit is None else {"measured_e": audit.measured_rms_e, "holds": audit.holds}),
        "frame_sha256": sha256(np.ascontiguousarray(shot.frame).tobytes()).hexdigest()[:12],
    }


def _bench(values: Values) -> Figures:
    """Return the mean PSNR in dB and the shortest slot in microseconds of a class of shutters on
    the scenes of a protocol."""
    from nscc_training.sweep.bench import bench_figures

    figures = bench_figures(values)
    return {
        "psnr_db": figures["psnr_db"],
        "shortest_slot_us": round(figures["shortest_slot_us"], 6),
    }


EMULATE = PointKind(
    "emulate",
    "frames of the emulated chip, and for a bench their reconstructions",
    _keys,
    lambda values, task: _bench(values) if "bench" in values else _capture(values, task.threads),
    ("psnr_db", "mean_e"),
    _reads,
    _fault,
    packages=("nscc", "nscc_runtime", "nscc_training"),
    distributions=("lark", "networkx", "numba", "opencv-python-headless", "scipy", "torch"),
)
