"""What it costs a run's own decoder if single pixels move an edge by a slot.

    python training/results/moves.py RUN [SHARE]

RUN is a run folder of class d, whose training data must be where its configuration says. A random
SHARE of the pixels (default 0.02) moves the same edge the same way on new batches; the change of
the loss, in dB where the loss counts decibels, is divided by the share: what it would be if all
pixels moved and their changes added up. Positive numbers say that the codes are best as they are.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import torch

from nscc_training.data import Batches, load_scenes
from nscc_training.loop.steps import compared, decoded, generator_of
from nscc_training.run_folder import load_run
from nscc_training.sensor_model import laid

BATCHES = 60
MOVES = {
    "opens earlier": (-1, 0), "opens later": (1, 0),
    "closes earlier": (0, -1), "closes later": (0, 1),
    "longer at both ends": (-1, 1), "shorter at both ends": (1, -1),
}  # fmt: skip


def main() -> None:
    """Measure and print."""
    if len(sys.argv) not in (2, 3):
        raise SystemExit(__doc__)
    share = float(sys.argv[2]) if len(sys.argv) == 3 else 0.02
    parts = load_run(Path(sys.argv[1])).parts
    settings, slots = parts.settings, parts.slots
    # Other paths of the cameras and other batches than the run has learned from.
    scenes = load_scenes(settings.data, parts.still, slots, settings.train.seed + 5)
    batches = Batches(
        scenes, settings.data, slots=slots, full_well_e=parts.model.full_well_e,
        batch=settings.train.batch, seed=settings.train.seed + 77,
    )  # fmt: skip
    codes = parts.encoder.codes()
    n = torch.arange(slots).reshape(-1, 1, 1)
    found: dict[str, list[float]] = {name: [] for name in MOVES}
    for step in range(BATCHES):
        batch = batches.train(step)
        size = batch.light.shape[-2:]
        start, stop = (laid(torch.as_tensor(codes[k]), *size) for k in ("start", "stop"))
        moving = torch.rand(size, generator=generator_of(1, step)) < share

        def loss(down: int, up: int, step=step, batch=batch, start=start, stop=stop,
                 moving=moving) -> float:  # fmt: skip
            first = torch.where(moving, (start + down).clamp(0, slots - 1), start)
            last = torch.where(moving, (stop + up).clamp(1, slots), stop)
            shutters = ((n >= first) & (n < last)).float()
            with torch.no_grad():
                made = decoded(parts, batch.light, shutters, parts.model, generator_of(2, step))
                return parts.loss(*compared(made, batch)).item()

        still = loss(0, 0)
        for name, move in MOVES.items():
            found[name].append(10 * (loss(*move) - still) / share)
    for name, costs in found.items():
        error = np.std(costs, ddof=1) / len(costs) ** 0.5
        print(f"{name:22} {np.mean(costs):+6.2f} +- {error:.2f} dB")


if __name__ == "__main__":
    main()
