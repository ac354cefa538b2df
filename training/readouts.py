"""The network that joins several readouts of a clip: `python training/readouts.py PICTURES OUT`.

PICTURES is a folder of photographs (`python training/data/fetch.py PICTURES`). Every lesson is some
clips, a quarter of which stand still, and a quarter in part; readouts of a code that is drawn, one
of them always open; and the clip that the decoder for any code makes of these. The network learns
from each lesson several times, mirrored. The same command goes on from OUT/checkpoint.pt, and gives
the same weights, OUT/readouts.safetensors, interrupted or not.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray
from safetensors.torch import save_file
from torch import Tensor

from nscc_training.any_code.decode import coded_clip, shipped
from nscc_training.any_code.lessons import Lesson, measured_lesson
from nscc_training.any_code.network import WIDTHS, bf16_where_multiplied
from nscc_training.any_code.readouts import STAGES, ReadoutFusion
from nscc_training.curves import srgb
from nscc_training.data.moving import Picture, light_of_picture, moving, pictures_below
from nscc_training.data.moving import shown_picture
from nscc_training.measured import Measured

STEPS, BATCH, SIZE, SLOTS = 400, 2, 64, 16
RATE = 3e-4
STILL = 0.25
TURNS = 8
"""Ways to turn and mirror a lesson, each of which is an update."""
_AVERAGE = 0.995
_EVERY = 10
_FLOOR = 1e-5
"""A mean square error on 0..1 below which less counts little: 50 dB."""


def drawn_masks(generator: np.random.Generator, size: int) -> NDArray[np.float32]:
    """Return the shutters (B, SLOTS, size, size) of an always open readout and one to three of a
    quarter of the frame, at 4 to 16 moments in a small tile."""
    count = int(generator.integers(1, 4))
    length, slot = SLOTS // 4, np.arange(SLOTS)[:, None, None]
    side = int(generator.choice((2, 4)))
    if side == 4:  # around the frame's end
        begin, apart = generator.permutation(SLOTS).reshape(4, 4), SLOTS // max(2, count)
    else:
        last = SLOTS - length * (1 if count == 1 else 3)
        begin = generator.permutation(np.arange(4) * last // 3).reshape(2, 2)
        apart = length * (2 if count == 2 else 1)
    tile = [np.ones((SLOTS, side, side), bool)]
    tile += [(slot - begin - k * apart) % SLOTS < length for k in range(count)]
    rolled = np.roll(np.stack(tile), generator.integers(0, side, 2), axis=(2, 3))
    return np.tile(rolled, (1, 1, size // side, size // side)).astype(np.float32)


def lesson_of(step: int, seed: int, pictures: Sequence[Picture], batch: int, size: int) -> Lesson:
    """Return the lesson of a step."""
    generator = np.random.default_rng([seed, 14, step])
    clips = [moving(pictures, generator, SLOTS, size, still=STILL) for _ in range(batch)]
    mask = drawn_masks(generator, size)  # as many readouts for all of a batch
    light, masks = (torch.from_numpy(np.stack(part)) for part in (clips, [mask] * batch))
    return Lesson(light, masks, exact=False, filmed=True, names=("readouts",))


def turned(values: Tensor, number: int) -> Tensor:
    """Return a square turned by so many right angles, and from the fourth on mirrored."""
    made = values.rot90(number, (-2, -1))
    return made.flip(-1) if number >= 4 else made


def loss_of(
    network: ReadoutFusion, measured: Measured, clip: Tensor, truth: Tensor, white: Tensor
) -> Tensor:
    """Return the mean square error as a display shows it, in decibels."""
    level = white.reshape(-1, 1, 1, 1)
    made, shown = (srgb(part / level) for part in (network.fused(measured, clip), truth))
    squared = (made.clamp(max=1.5) - shown.clamp(max=1)).square().mean(dim=(1, 2, 3))
    return 10 * torch.log10(squared + _FLOOR).mean()


def learn(
    pictures: Sequence[Picture], out: Path, steps: int = STEPS, batch: int = BATCH,
    size: int = SIZE, seed: int = 0, report: Callable[[str], None] = print,
) -> ReadoutFusion:  # fmt: skip
    """Return the network after `steps` lessons; those that OUT/checkpoint.pt holds are not
    repeated."""
    network, averaged = ReadoutFusion(WIDTHS), ReadoutFusion(WIDTHS)
    network.begin_with(shipped("clip"))
    averaged.load_state_dict(network.state_dict())
    optimizer = torch.optim.Adam(network.parameters(), lr=RATE)
    kept, first = out / "checkpoint.pt", 0
    if kept.is_file():
        state = torch.load(kept, weights_only=True)
        first = state["step"]
        for part in ("network", "averaged", "optimizer"):
            {"network": network, "averaged": averaged, "optimizer": optimizer}[
                part].load_state_dict(state[part])  # fmt: skip
    losses = []
    for step in range(first, steps):
        lesson = lesson_of(step, seed, pictures, batch, size)
        noise = torch.Generator().manual_seed(seed * 1_000_003 + step)
        with torch.no_grad():
            truth, measured, white = measured_lesson(lesson, noise)
            assert white is not None  # of filmed lessons
            clip = coded_clip(measured, STAGES)
        for number in range(TURNS):
            seen = Measured(*(turned(part, number) for part in (
                measured.value, measured.mask, measured.variance, measured.saturated)))  # fmt: skip
            with bf16_where_multiplied():
                loss = loss_of(network, seen, turned(clip, number), turned(truth, number), white)
            optimizer.zero_grad()
            loss.backward()
            torch.nn.utils.clip_grad_norm_(network.parameters(), 10.0)
            optimizer.step()
            losses.append(float(loss.detach()))
            with torch.no_grad():
                for mean, weight in zip(averaged.parameters(), network.parameters(), strict=True):
                    mean.lerp_(weight, 1 - min(_AVERAGE, step / (step + 2)))
        if (step + 1) % _EVERY == 0 or step + 1 == steps:
            report(f"lesson {step + 1} of {steps}: {-np.mean(losses[-TURNS * _EVERY :]):.2f} dB")
            parts = {"network": network, "averaged": averaged, "optimizer": optimizer}
            out.mkdir(parents=True, exist_ok=True)
            torch.save({"step": step + 1} | {k: v.state_dict() for k, v in parts.items()}, kept)
            weights = {name: w.half() for name, w in averaged.state_dict().items()}
            save_file(weights, out / "readouts.safetensors")
    return averaged


def main(arguments: Sequence[str] | None = None) -> int:
    """Learn from a folder of pictures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pictures", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--steps", type=int, default=STEPS)
    chosen = parser.parse_args(arguments)
    shown = [shown_picture(light_of_picture(path)) for path in pictures_below(chosen.pictures)]
    learn(shown, chosen.out, chosen.steps)
    return 0


if __name__ == "__main__":
    sys.exit(main())
