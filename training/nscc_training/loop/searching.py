"""A step of a search: codes that are moved together, and the decoder's word on the best of them.

The decoder is not trained meanwhile, so that it favours no code that was tried before another;
what is left of the steps (`settle`) trains it for what was found.
"""

from __future__ import annotations

from contextlib import suppress
from itertools import islice

import numpy as np
import torch
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc_training.data import Batch
from nscc_training.draws import generator_of
from nscc_training.encoders.base import Codes
from nscc_training.loop.setup import TrainingSetup
from nscc_training.loop.steps import compared, decoded, window
from nscc_training.programs import compiled, program_of, words_per_slot
from nscc_training.search import Motion, moved, told_db
from nscc_training.sensor_model import SensorModel
from nscc_training.settings import ShutterSettings

_SPEEDS = (2.0, 8.0, 24.0, 64.0)
"""Pixels a frame: of hands and heads over a few frames of film, up to what flies past."""
_MEAN_LIGHT = 0.1
"""Of the light that fills a well. Films have three times as much in the mean, but a display shows
noise where they are dark: so the closed form ranks codes as the decoder for any code does."""
_FEWER = 0.9
"""Of their words codes keep at most in a step in which they take more than they may. A tenth comes
off by a move or two; random bits are within four words a slot after some twenty steps."""


def search(setup: TrainingSetup, batch: Batch, step: int) -> float:
    """Move the codes to the best of some that were tried, if it is better than they are; returns
    the loss of the codes that are kept.

    Of `shutter.moves` the closed form takes the `shutter.judged` that it expects most of (of stills
    the first), among those that compile within `shutter.most_words`. Losses are those of the
    batch's patches under the same noise, and the words' weight. A code is better where the mean
    over patches of what it gains is above its standard error. Codes that take more words than they
    may come down first: as long as they do, the best of those judged is taken, whatever it loses,
    and each of these takes a tenth fewer words than they.
    """
    chosen = setup.settings.shutter
    setup.decoder.eval()
    generator = np.random.default_rng([setup.settings.train.seed, 11, step])
    current = codes_of(setup)
    candidates = [moved(setup.encoder.spec, current, generator) for _ in range(chosen.moves)]
    first, words = _losses(setup, current, batch, step), _words(setup, current)
    over = words is not None and not within(chosen, words)
    allowed = chosen.most_words or np.inf
    if words is not None and over:
        allowed = max(allowed, _FEWER * words)
    best = None if over else (current, first)
    fitting = (
        codes for codes in _expected(setup, current, candidates) if _fits(setup, codes, allowed)
    )
    for codes in islice(fitting, chosen.judged):
        candidate_losses = _losses(setup, codes, batch, step)
        gain = first - candidate_losses
        error = gain.std(ddof=1) / len(gain) ** 0.5 if len(gain) > 1 else 0.0
        if (over or gain.mean() > error) and (
            best is None or candidate_losses.mean() < best[1].mean()
        ):
            best = codes, candidate_losses
    best_codes, losses = best or (current, first)
    setup.encoder.load_codes(best_codes)
    return float(losses.mean())


def within(chosen: ShutterSettings, words: float) -> bool:
    """Whether codes of so many words a slot may be a run's: a search has a limit, if it is set."""
    return not (chosen.learn and chosen.most_words) or words <= chosen.most_words


def codes_of(setup: TrainingSetup) -> Codes:
    """The codes of a run's tile, of a codebook with its shapes as `book`."""
    book = getattr(setup.encoder, "book", None)
    return setup.encoder.codes() | ({} if book is None else {"book": book()})


def _expected(setup: TrainingSetup, current: Codes, candidates: list[Codes]) -> list[Codes]:
    """Those of the codes that are allowed and others than `own`, most expected first."""
    ranked = []
    motion = motion_seen(setup.model)
    for codes in candidates:
        if all((values == current[name]).all() for name, values in codes.items()):
            continue
        with suppress(ValueError):  # what `require` does not allow
            setup.encoder.load_codes(codes)
            worth = 0.0 if setup.still else told_db(setup.encoder.hard().cpu().numpy(), motion)
            ranked.append((worth, codes))
    ranked.sort(key=lambda pair: -pair[0])
    return [codes for _, codes in ranked]


def motion_seen(model: SensorModel) -> Motion:
    """What light moves like that is as bright as that of films, with a sensor's noise."""
    read_e2 = (model.adc_noise_lsb**2 + 1 / 12) * model.electrons_per_lsb**2
    mean_e = _MEAN_LIGHT * model.full_e
    counts = 1 / mean_e if model.shot_noise else 0.0
    return Motion(_SPEEDS, noise=read_e2 / mean_e**2, counts=counts)


def _fits(setup: TrainingSetup, codes: Codes, allowed: float) -> bool:
    words = _words(setup, codes)
    return words is not None and words <= allowed


def _words(setup: TrainingSetup, codes: Codes) -> float | None:
    """Words a slot of codes, which the run then has; None where they do not compile."""
    every_code = setup.settings.shutter.codes == "open"
    setup.encoder.load_codes(codes)
    with suppress(Rejected):
        program = program_of(setup.encoder, setup.chip)
        return words_per_slot(compiled(program, setup.chip, every_code=every_code))
    return None


@torch.no_grad()
def _losses(setup: TrainingSetup, codes: Codes, batch: Batch, step: int) -> NDArray[np.float64]:
    """The loss of each patch (batch,) with these codes, their words weighed."""
    settings = setup.settings
    seed, weight = settings.train.seed, settings.shutter.words_weight
    setup.encoder.load_codes(codes)
    rows, cols = batch.light.shape[-2:]
    shutters = window(setup.encoder.hard(), rows, cols, (seed, 7, step)).to(setup.device)
    noise = generator_of(setup.device, seed, 10, step)
    prediction = decoded(setup, batch.light, shutters, setup.model, noise)
    losses = torch.stack([
        setup.loss(*compared(prediction[k : k + 1], batch.patches(k, k + 1)))
        for k in range(len(prediction))
    ])  # fmt: skip
    words = (_words(setup, codes) or 0.0) if weight else 0.0
    return losses.double().cpu().numpy() + weight * words
