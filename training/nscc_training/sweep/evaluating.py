"""Points of kind evaluate: scores of runs, baselines and methods under a protocol."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from typing import Any

from nscc.diagnostics.diagnostic import Rejected
from nscc.files import write_whole
from nscc.mappings import JsonObject
from nscc.toml.kinds import TextKind
from nscc.toml.schema import Key
from nscc_training.command_settings import EvaluationSettings, TvSettings
from nscc_training.experiments.engine import Figures
from nscc_training.protocols import NAMES, PROCEDURAL, load_protocol
from nscc_training.scene_files import folders_of
from nscc_training.sweep.point import PointFault, PointKind, PointTask, Values
from nscc_training.sweep.point_programs import axis, declared_axes, sensor_changes, sensor_keys

RUN = "run"
"""The key that names a part of kind train, all of whose runs are evaluated."""


def _keys() -> tuple[Key, ...]:
    """Return the keys that points of kind evaluate may have in a grid."""
    return (
        axis(RUN, TextKind(), "parts of this grid, of kind train, whose runs are evaluated"),
        axis(
            "subject", TextKind(), "instead of run: a baseline, a run folder, or for sci8 a method"
        ),
        axis("protocol", TextKind(NAMES), "the evaluation protocol", "hdr-v1"),
        axis("data", TextKind(), "the folder of scenes"),
        *declared_axes(EvaluationSettings, "seed", "shutter", "effects", "skip_seen"),
        *(key for key in sensor_keys() if key.name != "sensor.file"),
        *declared_axes(TvSettings, "iterations", "weight"),
    )


def _fault(values: Values, _named: Collection[str]) -> PointFault | None:
    """Return what is wrong with the values of a point of kind evaluate, or None. The keys that the
    grid states do not matter."""
    if (RUN in values) == ("subject" in values):
        message = "a point needs a run of this grid or a subject"
        return PointFault(
            "subject" if RUN in values else "", message, 'for instance subject = "quad"'
        )
    if "data" not in values:
        return PointFault(
            "", "the key data is missing: the folder of scenes", 'add data = "scenes"'
        )
    return None


def _reads(values: Values) -> Sequence[Path]:
    """Return the files and folders that a point of kind evaluate reads."""
    named = [values.get("subject", ""), values["shutter"]]
    scenes = [] if values["data"] == PROCEDURAL else folders_of(values["data"])
    return [*scenes, *(Path(name) for name in named if name)]


def _evaluate(values: Values, task: PointTask) -> Figures:
    """Evaluate a run or a method, write the complete result to `task.files`, and return its mean
    scores and their 95 % interval (None for a single scene).

    Raises Rejected if files are damaged, because a mean of fewer files could not be compared."""
    import torch

    from nscc_training.evaluation.results import damaged_files, result_json

    torch.set_num_threads(task.threads)
    result = _result(values)
    if damaged := damaged_files(result):  # a mean of fewer files must not stand in the table
        raise Rejected(damaged)
    write_whole(task.files, result_json(result).encode())
    items = result["items"]
    low, high = result["ci95"] or (None, None)
    return {
        "method": result["method"],
        "items": len(items),
        **means_of(items),
        "ci95_low": low,
        "ci95_high": high,
        "parameters": result["parameters"],
    }


def means_of(items: Sequence[Mapping[str, Any]]) -> dict[str, float | None]:
    """Return the mean of each score over the `items` that have it, by name; None if no value is
    finite. Values are numbers, or "inf"; "inf" is left out of the mean. Places such as `file` and
    `crop` are no scores. A crop without dark pixels, for example, has no score for them."""
    from nscc_training.measures import summary

    means = {}
    for name in dict.fromkeys(name for item in items for name in item):
        scored = [item for item in items if isinstance(item.get(name), int | float | str)]
        if scored and name not in ("file", "crop", "frame", "class", "decoded"):
            scores = [float(item[name]) for item in scored]
            means[name] = summary(scores, [item["file"] for item in scored]).mean
    return means


def _result(values: Values) -> JsonObject:
    """Return the result of the evaluation that `values` describe, in the form that `nscc evaluate`
    writes."""
    from nscc_training.evaluation.baselines import evaluate_sci8
    from nscc_training.evaluation.methods import CLIPS
    from nscc_training.evaluation.runs import evaluate
    from nscc_training.protocol_scenes.file_scenes import files_of

    data, subject = Path(values["data"]), values.get("subject", "")
    if values["protocol"] == "sci8" and subject in CLIPS:
        count, weight = values["iterations"], values["weight"]
        return evaluate_sci8(files_of(load_protocol("sci8"), data), subject, count, weight).result
    named = ("protocol", "seed", "skip_seen", "shutter", "effects")
    wanted = EvaluationSettings(
        subject,
        data,
        # Runs of this grid may execute the code that their configuration names.
        trust_code=RUN in values,
        changes=sensor_changes(values),
        **{name: values[name] for name in named},
    )
    return evaluate(wanted).result


EVALUATE = PointKind(
    "evaluate",
    "scores under a protocol; complete results are stored under results",
    _keys,
    _evaluate,
    ("psnr_db", "correct"),
    _reads,
    _fault,
    packages=("nscc", "nscc_runtime", "nscc_training"),
    distributions=("lark", "networkx", "numba", "opencv-python-headless", "scipy", "torch"),
    leaves=".json",
    folder="results",
)
