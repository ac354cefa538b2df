"""Steps of `nscc train` beside a bare loop of the same network and batch, in turn.

    python tests/benchmarks/bench_training.py [--steps 20] [--patch 64] [--batch 4]

The bare loop has its batch in memory and knows nothing of shutters, sensors, files or validations:
forward, loss, backward, Adam. A ratio of 1 means that all the rest costs nothing. The last figure
is the share of a step that a profile sees in torch's operators.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path
from time import perf_counter

import torch
from torch.profiler import ProfilerActivity, profile

from nscc_training.loop import train as loop
from nscc_training.loop.ranks import Ranks
from nscc_training.loop.steps import window
from nscc_training.settings import settings_of

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
            run = loop.start(settings_of(values), None, Ranks(), Path(folder))
        [drawn] = loop.loader_of(run, 0, 1)
        parts, batch = run.setup, loop.batch_of(run, drawn)
        rows, cols = batch.light.shape[-2:]
        frame = torch.rand(len(batch.light), rows, cols)
        shutters = window(parts.encoder.hard(), rows, cols, (0,))
        bare = torch.optim.Adam(parts.decoder.parameters(), lr=1e-6)

        def bare_step(parts=parts, frame=frame, shutters=shutters, batch=batch, bare=bare) -> None:
            bare.zero_grad(set_to_none=True)
            loss = (parts.decoder(frame, shutters) - batch.truth).abs().mean()
            loss.backward()
            bare.step()

        spent = [0.0, 0.0]
        for step in range(-2, arguments.steps):

            def own_step(run=run, step=step) -> None:
                # What is drawn for a step is part of it.
                [drawn] = loop.loader_of(run, step + 2, step + 3)
                loop.update(run, step + 2, drawn)

            for which, action in enumerate((own_step, bare_step)):
                begin = perf_counter()
                action()
                spent[which] += perf_counter() - begin if step >= 0 else 0.0
        with profile(activities=[ProfilerActivity.CPU]) as seen:
            begin = perf_counter()
            own_step(step=arguments.steps + 1)
            spent_us = 1e6 * (perf_counter() - begin)
        ours, theirs = (1e3 * total / arguments.steps for total in spent)
        print(
            f"  {name:<18} {ours:8.1f} ms a step   bare {theirs:8.1f} ms   x{theirs / ours:5.2f}   "
            f"{operators_us(seen) / spent_us:.0%} in torch operators"
        )


def operators_us(seen: profile) -> float:
    """How long operators of torch ran, those that others call counted once."""
    spans = sorted(
        (event.time_range.start, event.time_range.end)
        for event in seen.events()
        if event.name.startswith(("aten::", "autograd::", "Optimizer"))
    )
    total = end = 0.0
    for first, last in spans:
        total += max(0.0, last - max(first, end))
        end = max(end, last)
    return total


if __name__ == "__main__":
    main()
