"""Points of kind cell: recurrent cells of bits that tell the direction of motion."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import fields
from typing import get_args

from nscc.files import write_together
from nscc.toml.kinds import Integer, Number, TextKind
from nscc.toml.schema import Key
from nscc_training.experiments.engine import Figures
from nscc_training.sweep.point import PointFault, PointKind, PointTask, Values
from nscc_training.sweep.point_programs import axis, program_files


def _keys() -> tuple[Key, ...]:
    from nscc_training.cells import MOST_KERNEL, MOST_OUTPUTS, MOST_STATES, Update
    from nscc_training.motion_cells import MotionSettings

    steps = Integer(1, 10**6)
    kinds = {
        "kernel": (Integer(3, MOST_KERNEL), "rows and columns of kernels, odd"),
        "states": (Integer(1, MOST_STATES), "one-bit states of a pixel"),
        "outputs": (Integer(1, MOST_OUTPUTS), "one-bit outputs of a pixel"),
        "pool": (Integer(1, MOST_KERNEL), "side of the squares that outputs are pooled over, odd"),
        "update": (TextKind(get_args(Update)), "how gates update states"),
        "size": (Integer(16, 256), "rows and columns of the array"),
        "frames": (Integer(2, 256), "frames of a film"),
        "speed": (Number(0.1, 8), "pixels per frame"),
        "noise": (Number(0, 100), "factor of the noise during training"),
        "films": (Integer(8, 10**5), "films for training"),
        "tuned_films": (Integer(8, 10**5), "of these, films that are emulated for the decoder"),
        "test_films": (Integer(8, 10**5), "films for the accuracies"),
        "real_steps": (steps, "steps with real weights"),
        "binary_steps": (steps, "steps with binary weights"),
        "batch": (Integer(2, 1024), "films of a step"),
        "target": (TextKind(), "the chip, by name or file; its array gets `size`"),
        "seed": (Integer(0, 2**31 - 1), "seed of films, training and noise"),
    }
    defaults = MotionSettings()
    return tuple(axis(name, *kind, getattr(defaults, name)) for name, kind in kinds.items())


def _fault(values: Values, _named: Collection[str]) -> PointFault | None:
    for name in ("kernel", "pool"):
        if values[name] % 2 == 0:
            return PointFault(name, f"{name} is {values[name]}, but must be odd", "choose 3 or 5")
    return None


def _train(values: Values, task: PointTask) -> Figures:
    import torch

    from nscc_training.motion_cells import MotionSettings, motion_cell_files, train_motion_cell

    torch.set_num_threads(task.threads)
    names = [field.name for field in fields(MotionSettings)]
    trained = train_motion_cell(MotionSettings(**{name: values[name] for name in names}))
    files = motion_cell_files(trained)
    write_together({task.files / name: data for name, data in files.items()})
    report = trained.program.report
    return {
        **{f"{name}_accuracy": round(share, 4) for name, share in trained.accuracies.items()},
        "different_bits": trained.different_bits,
        "words": report["images_words_total"],
        "us": round(report["images_us"], 3),
        "count_noise": round(trained.noise.count, 3),
        "bits_per_frame": trained.bits_per_frame,
        "full_frame_bits": trained.full_frame_bits,
    }


CELL = PointKind(
    "cell", "a recurrent cell of bits in the pixels that tells the direction of motion", _keys,
    _train, ("tuned_accuracy", "effects_accuracy"), program_files, _fault,
    packages=("nscc", "nscc_runtime", "nscc_training"),
    distributions=("lark", "networkx", "numba", "scipy", "torch"), leaves="", folder="cells",
)  # fmt: skip
