"""Steps of `nscc train` beside a bare loop of the same network and batch, in turn.

    python tests/benchmarks/bench_training.py [--steps 20] [--patch 64] [--batch 4]

The bare loop has its batch in memory and knows nothing of shutters, sensors, files or validations:
forward, loss, backward, Adam. A ratio of 1 means that all the rest costs nothing.
"""

from __future__ import annotations

import argparse
import tempfile
from functools import partial
from pathlib import Path
from time import perf_counter

import torch

from nscc_training.config import settings_of
from nscc_training.data import Ahead
from nscc_training.loop import train as loop
from nscc_training.loop.ranks import Ranks

CASES = {
    "unet2d, class b": {"shutter": {"class": "b", "slots": 256}},
    "unet3d, class e": {
        "shutter": {"class": "e", "slots": 13},
        "decoder": {"name": "unet3d"},
        "data": {"protocol": "video-v1"},
    },
    "fcnet, codebook": {
        "shutter": {"class": "codebook", "slots": 16},
        "decoder": {"name": "fcnet"},
        "data": {"protocol": "video-v1"},
    },
}


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--steps", type=int, default=20)
    parser.add_argument("--patch", type=int, default=64)
    parser.add_argument("--batch", type=int, default=4)
    arguments = parser.parse_args()
    for name, case in CASES.items():
        values = {
            **case,
            "loss": {"name": "l1"},
            "data": {**case.get("data", {}), "patch": arguments.patch, "scenes": 4},
            "train": {"steps": 10**6, "batch": arguments.batch},
        }
        with tempfile.TemporaryDirectory() as folder:
            run = loop._start(settings_of(values), Path(folder), "never", Ranks())
        parts, batch = run.parts, run.batches.train(0)
        rows, cols = batch.light.shape[-2:]
        frame = torch.rand(len(batch.light), rows, cols)
        shutters = loop.window(parts.encoder.hard(), rows, cols, (0,))
        bare = torch.optim.Adam(parts.decoder.parameters(), lr=1e-6)

        def bare_step(parts=parts, frame=frame, shutters=shutters, batch=batch, bare=bare) -> None:
            bare.zero_grad(set_to_none=True)
            loss = (parts.decoder(frame, shutters) - batch.truth).abs().mean()
            loss.backward()
            bare.step()

        spent = [0.0, 0.0]
        with Ahead(partial(loop.batch_of, run), arguments.steps + 2) as ahead:
            for step in range(-2, arguments.steps):

                def own_step(run=run, step=step, ahead=ahead) -> None:
                    loop._update(run, step + 2, ahead)
                    # The batch that it has begun is its own work, not the bare loop's.
                    if ahead._begun:
                        ahead._begun[1].result()

                for which, action in enumerate((own_step, bare_step)):
                    begin = perf_counter()
                    action()
                    spent[which] += perf_counter() - begin if step >= 0 else 0.0
        ours, theirs = (1e3 * total / arguments.steps for total in spent)
        print(f"  {name:<18} {ours:8.1f} ms a step   bare {theirs:8.1f} ms   x{theirs / ours:5.2f}")


if __name__ == "__main__":
    main()
