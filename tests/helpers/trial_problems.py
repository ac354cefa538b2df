"""Small problems whose losses are known without training, for codes that learn by trial."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray

from nscc_training.data import Batch
from nscc_training.draws import generator_of
from nscc_training.loop.setup import TrainingSetup, make_setup
from nscc_training.loop.steps import decoded, loss_of, pull, trial_of
from nscc_training.sensor_model import laid
from nscc_training.settings import settings_of

CPU = torch.device("cpu")


class Share(torch.nn.Module):
    """Says of every pixel for which part of the frame it was open, whatever it saw."""

    def forward(self, frame: Any, shutters: Any) -> Any:
        return laid(shutters.mean(dim=0), *frame.shape[-2:]).expand_as(frame)


class Alone(torch.nn.Module):
    """Every pixel's light by itself, as if nothing saturated."""

    def forward(self, frame: Any, shutters: Any) -> Any:
        share = shutters.mean(dim=0).clamp(min=1 / 64).detach()
        return frame / laid(share, *frame.shape[-2:])


def squared(prediction: Any, truth: Any) -> Any:
    return (prediction - truth).square().mean()


def parts_of(
    decoder: Any, loss: Any = squared, sensor_noise: bool = False, **shutter: Any
) -> TrainingSetup:
    """Parts with that decoder and loss; by default of class b, 64 slots, a tile of 2 x 2."""
    values = {"class": "b", "slots": 64, "tile": [2, 2], "relaxation": "tried", **shutter}
    sensor, cpu = {"noise": sensor_noise}, {"device": "cpu"}
    found = make_setup(settings_of({"shutter": values, "sensor": sensor, "train": cpu}))
    return replace(found, decoder=decoder, loss=loss)


def batch_of(
    parts: TrainingSetup, light: Any, truth: Any, shape: tuple[int, int] = (20, 20)
) -> Batch:
    """One patch: light and truth over the frame in full wells."""
    light = torch.as_tensor(light, dtype=torch.float32).expand(shape)[None]
    truth = torch.as_tensor(truth, dtype=torch.float32).expand(shape)[None]
    return Batch(light * parts.model.full_well_e, truth, torch.tensor([1.0]), ("one",))


def tried_gradients(parts: TrainingSetup, batch: Batch, trials: int) -> list[NDArray[np.float64]]:
    """The gradients of each parameter, (trials, ..), of that many trials."""
    found: list[list[NDArray[np.float64]]] = []
    for seed in range(trials):
        parts.encoder.zero_grad()
        trial = trial_of(parts.encoder, *batch.light.shape[-2:], (1, seed), (2, seed))
        made = decoded(
            parts, batch.light, trial.shutters[0], parts.model, generator_of(CPU, 3, seed)
        )
        zero = pull(parts, batch, trial, made, generator_of(CPU, 3, seed))
        assert zero.item() == 0
        zero.backward()
        found.append([p.grad.double().numpy().copy() for p in parts.encoder.parameters()])
    return [np.stack(each) for each in zip(*found, strict=True)]


def open_share(parts: TrainingSetup, batch: Batch, steps: int, rate: float) -> float:
    """The part of the frame that pixels are open for after so many steps of learning."""
    optimiser = torch.optim.Adam(parts.encoder.parameters(), betas=(0.5, 0.9))
    for step in range(steps):
        optimiser.param_groups[0]["lr"] = rate * (1 - step / steps)
        optimiser.zero_grad()
        trial = None
        shutters = parts.encoder(None)
        if parts.encoder.relaxation == "tried":
            trial = trial_of(parts.encoder, *batch.light.shape[-2:], (1, step), (2, step))
            shutters = trial.shutters[0]
        made = decoded(parts, batch.light, shutters, parts.model, generator_of(CPU, 3, step))
        loss = loss_of(parts, made, batch, shutters)
        if trial is not None:
            loss = loss + pull(parts, batch, trial, made, generator_of(CPU, 3, step))
        loss.backward()
        optimiser.step()
        parts.encoder.project()
    return float(parts.encoder.hard().mean())
