"""Points of kind design: programs designed for scenes."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import MISSING
from pathlib import Path

from nscc.chips.load import DEFAULT_NAME, load_target
from nscc.files import write_whole
from nscc.options import Options
from nscc.toml.kinds import TextKind
from nscc.toml.schema import Key
from nscc_training.command_settings import DesignSettings
from nscc_training.experiments.engine import Figures
from nscc_training.sweep.point import PointFault, PointKind, PointTask, Values
from nscc_training.sweep.point_programs import (
    axis,
    declared_axes,
    light_files,
    program_files,
    scene_keys,
    scene_of_point,
    sensor_keys,
    sensor_of,
)

_TILE = "sve-risk"


def _keys() -> tuple[Key, ...]:
    """Return the keys that points of kind design may have in a grid."""
    return (
        *scene_keys(),
        *declared_axes(DesignSettings, "slot_us", looks=MISSING, criterion="mu", slots=256),
        axis("target", TextKind(), "the chip, by name or file", DEFAULT_NAME),
        *declared_axes(Options, "level"),
        *sensor_keys(),
    )


def _fault(values: Values, _named: Collection[str]) -> PointFault | None:
    """Return what is wrong with the values of a point of kind design, or None: no scene, both or
    none of looks and the criterion sve-risk, or more looks than boundaries. The keys that the grid
    states do not matter."""
    if "scene" not in values:
        return PointFault("", "a point needs a scene to design for", 'add scene = "builtin:hdr"')
    if (values["criterion"] == _TILE) == ("looks" in values):
        message = "a point needs looks or the criterion sve-risk"
        return PointFault("looks" if "looks" in values else "", message, "for instance looks = 5")
    if values.get("looks", 0) > values["slots"]:
        message = (
            f"{values['looks']} exposures need {values['looks']} of {values['slots']} boundaries"
        )
        return PointFault("looks", message, "ask for fewer looks, or for more slots")
    return None


def _reads(values: Values) -> Sequence[Path]:
    """Return the files that a point of kind design reads."""
    return [*light_files(values), *program_files(values)]


def _design(values: Values, task: PointTask) -> Figures:
    """Design a program for the scene of a point, and write it to `task.files`. Return its expected
    PSNR in dB for each curve, stops or boundaries, words and shortest slot. Only the part of the
    array that the scene covers counts."""
    from nscc_runtime.scenes import laid_lights
    from nscc_training.design import Design, Frame, design_looks, design_tile
    from nscc_training.metrics import psnr_of_mse

    target = load_target(values["target"], Path())
    slots, slot_us = values["slots"], values["slot_us"]
    [laid] = laid_lights(scene_of_point(values), [slot_us] * slots, target)
    scene_light = [laid.placement.cut(laid.light.total_e())]
    frame = Frame(slots, slot_us, values["target"], sensor_of(values, target), values["level"])
    figures: Figures
    design: Design
    if values["criterion"] == _TILE:
        tile = design_tile(scene_light, frame)
        design, figures = tile, {"stops": " ".join(map(str, tile.tile.stops))}
        errors = {"mu": tile.tile.risk}
    else:
        looking = design_looks(scene_light, values["looks"], frame, values["criterion"])
        design, figures = looking, {"at": " ".join(map(str, looking.schedule.at))}
        errors = {str(curve): error for curve, error in looking.expected.errors.items()}
    write_whole(task.files, design.text.encode())
    lowered = design.compiled.lowered
    assert lowered is not None
    # The tile is judged by its PSNR-mu, looks also by other curves; logarithms have no PSNR.
    expected = {
        f"expected_{curve}_db": psnr_of_mse(error, 1.0)
        for curve, error in errors.items()
        if curve != "log"
    }
    return {
        **expected,
        **figures,
        "words_total": lowered.schedule.words_total,
        "shortest_slot_us": round(lowered.shortest_slot_us, 6),
    }


DESIGN = PointKind(
    "design",
    "a program designed for a scene, and its expected error",
    _keys,
    _design,
    ("expected_mu_db",),
    _reads,
    _fault,
    packages=("nscc", "nscc_runtime", "nscc_training"),
    distributions=("lark", "networkx", "numba", "opencv-python-headless", "scipy"),
    leaves=".nsl",
    folder="programs",
)
