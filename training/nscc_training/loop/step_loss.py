"""The loss of one training step, and what of the codes changes from step to step."""

from __future__ import annotations

from torch import Tensor, nn

from nscc_training.data import Batch
from nscc_training.draws import generator_of
from nscc_training.loop.ranks import Ranks
from nscc_training.loop.setup import TrainingSetup
from nscc_training.loop.steps import decoded, loss_of, window
from nscc_training.loop.trials import pull, trial_of
from nscc_training.settings import RunSettings


class StepLoss(nn.Module):
    """The loss of a batch in one step: shutters, capture, decoder, and a trial of codes.

    It is a module so that gradients are averaged over processes."""

    def __init__(self, setup: TrainingSetup, ranks: Ranks) -> None:
        super().__init__()
        self.encoder, self.decoder = setup.encoder, setup.decoder
        self._setup, self._ranks = setup, ranks

    def forward(self, batch: Batch, step: int) -> Tensor:
        setup, settings, rank = self._setup, self._setup.settings, self._ranks.rank
        seed, device = settings.train.seed, setup.device
        rows, cols = batch.light.shape[-2:]
        place = (seed, 7, step)
        trial = None
        learns = codes_learn(settings, step)
        if learns and setup.encoder.relaxation == "tried":
            trial = trial_of(setup.encoder, rows, cols, (seed, 6, step, rank), place)
            shutters = trial.shutters[0]
        elif learns:
            # All processes share the noise of the codes, and draw the sensor's noise independently.
            tile = setup.encoder(generator_of(device, seed, 6, step))
            shutters = window(tile, rows, cols, place)
        else:
            shutters = window(setup.encoder.hard(), rows, cols, place)
        noise = (seed, 10, step, rank)
        prediction = decoded(
            setup, batch.light, shutters, setup.model, generator_of(device, *noise)
        )
        loss = loss_of(setup, prediction, batch, shutters)
        if trial is not None:
            loss = loss + pull(setup, batch, trial, prediction, generator_of(device, *noise))
        return loss * self._ranks.weight(settings.train.batch)


def codes_learn(settings: RunSettings, step: int) -> bool:
    """Return whether the codes change in a step; they do not in `warm_up` and `settle`."""
    shutter, steps = settings.shutter, settings.train.steps
    return shutter.learn and shutter.warm_up * steps <= step < (1 - shutter.settle) * steps


def anneal(setup: TrainingSetup, step: int) -> None:
    """Set temperature and noise of the codes at a step."""
    settings = setup.settings
    progress_share = step / max(1, settings.train.steps - 1)
    warm, cold = settings.shutter.temperature
    setup.encoder.temperature = warm * (cold / warm) ** progress_share
    setup.encoder.noise = settings.shutter.noise * (1 - progress_share)
