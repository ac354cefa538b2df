"""How the weights beside this file were made; `python -m nscc_training.any_code --help`.

Parts, one after the other: noise is taken from clips (the plug-and-play form is ready then), and
all stages learn together, with new masks for every clip and gradients through a few of them. A
checkpoint is written often, and an interrupted training goes on from it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass
from math import cos, log, pi
from pathlib import Path
from time import process_time

import numpy as np
import torch
from torch import Tensor, nn

from nscc_training.any_code.lessons import coded, exposed_still, filmed, noisy
from nscc_training.any_code.muon import optimizers
from nscc_training.any_code.network import ClipDenoiser, bf16_where_multiplied
from nscc_training.any_code.stages import schedule, stage, started
from nscc_training.any_code.stills import (
    coded_light,
    started_still,
    still_schedule,
    still_stage,
)
from nscc_training.curves import srgb
from nscc_training.data.moving import Picture, lights_in, pictures_in

CHECKPOINT = "checkpoint.pt"
_KEEP_EVERY = 20
_WARM_UP = 20


@dataclass(frozen=True)
class Part:
    """A part of the training: `batch` clips of `size` pixels a side a step, and its rate at the
    most, which falls to a hundredth as a cosine. `through`: stages that a gradient passes, of
    `stages`. The part `films` of the lessons is `filmed`, and of the others `exact` has no noise.
    """

    name: str
    steps: int
    batch: int
    size: int
    rate: float
    through: int = 0
    stages: int = 8
    films: float = 0.0
    exact: float = 0.5


PARTS: Mapping[str, tuple[Part, ...]] = {
    "clip": (
        Part("noise", 1800, 4, 64, 1e-3),
        Part("together", 240, 2, 80, 1e-4, 4),
        Part("again", 360, 2, 80, 2e-4, 4),
        Part("longer", 150, 2, 80, 1e-4, 4, 12),
        Part("films", 640, 2, 80, 2e-4, 6, 12, 0.4, 0.8),
    ),
    "still": (Part("stills", 3000, 6, 96, 8e-4, 3),),
}


class Trainer:
    """The network, its average over steps, and where the training stands; `folder` keeps it.

    It learns from the pictures in `sources`, clips or stills as `kind` says.
    """

    def __init__(self, kind: str, sources: Sequence[Path], folder: Path, seed: int = 0) -> None:
        torch.manual_seed(seed)
        self.kind, self.folder, self.seed = kind, folder, seed
        self.pictures: list[Picture] = pictures_in(sources) if kind == "clip" else []
        self.lights = lights_in(sources) if kind == "still" else []
        self.network = ClipDenoiser()
        self.average = deepcopy(self.network)
        self.optimizers = optimizers(self.network)
        self.part, self.step, self.updates, self.spent_s = 0, 0, 0, 0.0
        if (folder / CHECKPOINT).is_file():
            self._load()

    def run(self, parts: Sequence[Part] | None = None) -> Iterator[str]:
        """Train to the end; yields a line of text now and then."""
        parts = PARTS[self.kind] if parts is None else parts
        begin = process_time() - self.spent_s
        losses: list[float] = []
        while self.part < len(parts):
            part = parts[self.part]
            while self.step < part.steps:
                losses.append(self._one(part))
                self.step += 1
                if self.step % _KEEP_EVERY == 0 or self.step == part.steps:
                    self.spent_s = process_time() - begin
                    self._save()
                    done, mean = f"{self.step} of {part.steps}", float(np.mean(losses))
                    yield f"{part.name} {done}: loss {mean:.4f}, {self.spent_s:.0f} s"
                    losses.clear()
            self.part, self.step = self.part + 1, 0
            self.optimizers = optimizers(self.network)
            self._save()

    def _one(self, part: Part) -> float:
        """One step, or with stages one lesson; its loss."""
        generator = np.random.default_rng([self.seed, self.part, self.step])
        falling = 0.505 + 0.495 * cos(pi * self.step / part.steps)
        rate = part.rate * falling * min(1.0, (self.step + 1) / _WARM_UP)
        for optimizer in self.optimizers:
            for group in optimizer.param_groups:
                group["lr"] = rate
        if self.kind == "still":
            return self._learn_stills(part, generator)
        if part.through == 0:
            return self._learn_noise(part, generator)
        return self._learn_stages(part, generator)

    def _learn_noise(self, part: Part, generator: np.random.Generator) -> float:
        clip, noise, sigma = noisy(self.pictures, generator, part.batch, part.size)
        with bf16_where_multiplied():
            seen = torch.zeros(len(clip), 3, *clip.shape[1:])
            found = self.network(noise, seen, sigma)
        error = (found - clip) / sigma.reshape(-1, 1, 1, 1)
        return self._update(error.square().mean() + 0.2 * error.abs().mean())

    def _learn_stages(self, part: Part, generator: np.random.Generator) -> float:
        drawn = self.pictures, generator, part.batch, part.size
        shown: Tensor | None = None
        if part.films and generator.random() < part.films:
            clip, measured, shown = filmed(*drawn)
        else:
            clip, measured = coded(*drawn, part.exact)
        now, target = started(measured)
        losses: list[float] = []
        waiting: list[Tensor] = []
        for number, sigma in enumerate(schedule(part.stages)):
            with bf16_where_multiplied():
                now, target = stage(measured, self.network, now, target, sigma)
            # The root: a clip counts by its error's ratio, nearly, as decibels do.
            error = _difference(now, clip, shown)
            waiting.append(error.square().mean(dim=(1, 2, 3)).add(1e-6).sqrt().mean())
            if (number + 1) % part.through == 0:
                losses.append(self._update(torch.stack(waiting).mean() * 10))
                waiting.clear()
                now, target = now.detach(), target.detach()
        return float(np.mean(losses))

    def _learn_stills(self, part: Part, generator: np.random.Generator) -> float:
        truth, measured = exposed_still(self.lights, generator, part.batch, part.size)
        light = started_still(measured)
        losses = []
        for sigma in still_schedule(part.through):
            with bf16_where_multiplied():
                light = still_stage(measured, self.network, light, sigma)
            losses.append(_still_loss(light, truth))
        return self._update(torch.stack(losses).mean())

    def _update(self, loss: Tensor) -> float:
        self.network.zero_grad(set_to_none=True)
        loss.backward()  # type: ignore[no-untyped-call]
        size = nn.utils.clip_grad_norm_(self.network.parameters(), 1.0)
        if not bool(torch.isfinite(size)):
            raise FloatingPointError(f"the gradient is {float(size)} at step {self.step}")
        for optimizer in self.optimizers:
            optimizer.step()
        self.updates += 1
        keep = min(0.99, self.updates / (9 + self.updates))
        with torch.no_grad():
            for mean, new in zip(self.average.parameters(), self.network.parameters(), strict=True):
                mean.lerp_(new, 1 - keep)
        return float(loss.detach())

    def _save(self) -> None:
        """The checkpoint, whole or not at all; the average as what is shipped, beside it."""
        self.folder.mkdir(parents=True, exist_ok=True)
        state = {
            "kind": self.kind, "part": self.part, "step": self.step, "updates": self.updates,
            "spent_s": self.spent_s,
            "network": self.network.state_dict(), "average": self.average.state_dict(),
            "optimizers": [optimizer.state_dict() for optimizer in self.optimizers],
        }  # fmt: skip
        new = self.folder / f"{CHECKPOINT}.new"
        torch.save(state, new)
        new.replace(self.folder / CHECKPOINT)

    def _load(self) -> None:
        state = torch.load(self.folder / CHECKPOINT, weights_only=True)
        self.network.load_state_dict(state["network"])
        self.average.load_state_dict(state["average"])
        for optimizer, kept in zip(self.optimizers, state["optimizers"], strict=True):
            optimizer.load_state_dict(kept)
        self.part, self.step, self.updates = state["part"], state["step"], state["updates"]
        self.spent_s = state["spent_s"]


def write_weights(folders: Sequence[Path], out: Path) -> None:
    """The averages of trainings, in half precision, as `decode.shipped_state` reads them."""
    from safetensors.torch import save_file

    found: dict[str, Tensor] = {}
    for folder in folders:
        state = torch.load(folder / CHECKPOINT, weights_only=True)
        found |= {f"{state['kind']}.{name}": p.half() for name, p in state["average"].items()}
    save_file({name: part.contiguous() for name, part in found.items()}, out)


def _difference(found: Tensor, clip: Tensor, shown: Tensor | None) -> Tensor:
    """That of two clips, or of what a display shows of them, whose white is `shown` (batch,)."""
    if shown is None:
        return found - clip
    level = shown.reshape(-1, 1, 1, 1)
    return srgb(found / level) - srgb(clip / level)


def _still_loss(light: Tensor, truth: Tensor) -> Tensor:
    """Errors of light and of its logarithm, over the peak that all but a thousandth of the pixels
    stay below: as protocol hdr-v1 counts them, nearly."""
    peak = torch.quantile(truth.flatten(1), 0.999, dim=1).clamp(min=1e-6).reshape(-1, 1, 1)
    found, wanted = ((part / peak).clamp(0, 1) for part in (light, truth))
    linear = (found - wanted).square().mean(dim=(1, 2)).add(1e-6).sqrt()
    curved = [torch.log1p(5000 * part) / log(5001) for part in (found, wanted)]
    bent = (curved[0] - curved[1]).square().mean(dim=(1, 2)).add(1e-6).sqrt()
    whole = (coded_light(light) - coded_light(truth)).abs().mean(dim=(1, 2))
    return 10 * (linear + bent + whole).mean()
