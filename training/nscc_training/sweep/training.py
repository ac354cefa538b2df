"""Points of kind train: runs, each in its own folder."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import MISSING
from functools import cache
from pathlib import Path

from nscc.toml.kinds import Axis, TextKind
from nscc.toml.schema import Key
from nscc.toml.toml_text import written
from nscc_training.experiments.engine import Figures
from nscc_training.import_paths import is_import_path
from nscc_training.run_files import run_path
from nscc_training.scene_files import folders_of
from nscc_training.settings import SCHEMA, RunSettings, load_config, settings_of
from nscc_training.sweep.point import PointKind, PointTask, Values
from nscc_training.sweep.point_programs import axis, text_files

_CONFIG = "config"
_STAGES = ("soft", "hard", "compiled", "emulated")


@cache
def _keys() -> tuple[Key, ...]:
    """Return the keys that points of kind train may have in a grid: a configuration file and all
    settings of a training."""
    settings = (Key("", key.path, Axis(key.kind), key.meaning, MISSING) for key in SCHEMA.keys)
    return (
        axis(_CONFIG, TextKind(), "a configuration of nscc train, else its defaults"),
        *settings,
    )


def _settings(values: Values) -> RunSettings:
    """Return the training settings of a point: its configuration file, or the defaults, with the
    point's own values.

    Raises Rejected with all errors at once: a file that cannot be read (NS0813), unknown keys
    (NS0814) or invalid values (NS0815)."""
    changes = [
        f"{key.path} = {written(key.kind.plain(values[key.path]))}"
        for key in SCHEMA.keys
        if key.path in values
    ]
    config = values.get(_CONFIG)
    return settings_of({}, changes) if config is None else load_config(Path(config), changes)


def _reads(values: Values) -> Sequence[Path]:
    """Return the files and folders, which may not exist, on which a training depends: its
    configuration and everything that it names, including the user's Python modules."""
    settings = _settings(values)
    named = [
        settings.shutter.target,
        settings.sensor.file,
        settings.decoder.name,
        *settings.loss.name.split("+"),
    ]
    data = [
        folder
        for text in (settings.data.train, settings.data.val)
        if text and not is_import_path(text)
        for folder in folders_of(text)
    ]
    named += [text for text in (settings.data.train, settings.data.val) if is_import_path(text)]
    files = [
        f"{n.partition(':')[0].replace('.', '/')}.py" if is_import_path(n) else n for n in named
    ]
    begun = (settings.shutter.init, settings.decoder.init)
    return [
        *([Path(values[_CONFIG])] if _CONFIG in values else []),
        *(Path(name) for name in files if name),
        *data,
        *(path for name in begun if name for path in _begun_with(run_path(Path(name)))),
    ]


def _begun_with(path: Path) -> Sequence[Path]:
    """Return the files that a training starts from: a run folder, a code file, or a program with
    the files that it names. Whether `path` exists is not checked."""
    is_program = path.suffix.lower() == ".nsl" and path.is_file()
    return text_files(path) if is_program else [path]


def _train(values: Values, task: PointTask) -> Figures:
    """Train with the settings of a point in the folder `task.files`, and return the scores of the
    run. A checkpoint of an earlier attempt is continued."""
    import json

    import torch

    from nscc_training.loop.train import train

    torch.set_num_threads(task.threads)
    train(_settings(values), task.files)
    result = json.loads((task.files / "result.json").read_text(encoding="utf-8"))
    scores = {name: value for name, value in result["robustness"][0].items() if name != "change"}
    unit = "correct" if "correct" in scores else "db"
    return {
        **scores,
        **{f"{stage}_{unit}": result["stages"][stage] for stage in _STAGES},
        "words_a_slot": result["words_per_slot"],
        "parameters": result["parameters"],
    }


TRAIN = PointKind(
    "train",
    "a run of nscc train and its validation; the run is stored under runs",
    _keys,
    _train,
    ("psnr_db", "correct"),
    _reads,
    packages=("nscc", "nscc_runtime", "nscc_training"),
    distributions=("lark", "networkx", "numba", "opencv-python-headless", "scipy", "torch"),
    leaves="",
    folder="runs",
)
