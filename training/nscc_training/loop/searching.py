"""A step of a search: compare moved codes by the decoder's loss.

The decoder is not trained during the search, so that it does not favour codes that were tried
earlier. The remaining steps (`settle`) train it for the result."""

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
from nscc_training.random_streams import DrawStream
from nscc_training.search.expected import Motion, told_db
from nscc_training.search.moves import moved
from nscc_training.sensor_model import SensorModel
from nscc_training.settings import ShutterSettings

_SPEEDS = (2.0, 8.0, 24.0, 64.0)
"""Speeds in pixels per frame, from moving hands and heads to passing objects."""
_MEAN_LIGHT = 0.1
"""Mean light, in full wells, that the closed form assumes.

Films have three times as much, but displays show noise mainly in dark regions. With this value the
closed form ranks codes as the decoder for any code does."""
_FEWER = 0.9
"""Factor on the number of words per step while codes exceed their limit.

A move or two reduce the words by a tenth; random bits need about twenty steps to reach four words
per slot."""


def search(setup: TrainingSetup, batch: Batch, step: int) -> float:
    """Move the codes to the best of some candidates if it is better; return the loss of the result.

    The closed form selects `shutter.judged` of `shutter.moves` candidates (for stills the first
    ones) among those that compile within `shutter.most_words`. The loss is that of the batch's
    patches under the same noise, plus the weighted number of words. A candidate is better if its
    mean gain over patches exceeds the standard error. While codes exceed the limit of words, the
    best candidate with at least a tenth fewer words is chosen, whatever its loss."""
    chosen = setup.settings.shutter
    setup.decoder.eval()
    generator = np.random.default_rng([setup.settings.train.seed, DrawStream.SEARCH_MOVES, step])
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
    """Return whether a run may keep codes of `words` words per slot; only a search has a limit."""
    return not (chosen.learn and chosen.most_words) or words <= chosen.most_words


def codes_of(setup: TrainingSetup) -> Codes:
    """Return the codes of a run's tile; a codebook has its shapes as `book`."""
    book = getattr(setup.encoder, "book", None)
    return setup.encoder.codes() | ({} if book is None else {"book": book()})


def _expected(setup: TrainingSetup, current: Codes, candidates: list[Codes]) -> list[Codes]:
    """Return the candidates that are legal and differ from `current`, most promising first."""
    ranked = []
    motion = motion_seen(setup.model)
    for codes in candidates:
        if all((values == current[name]).all() for name, values in codes.items()):
            continue
        with suppress(ValueError):  # codes that `require` forbids
            setup.encoder.load_codes(codes)
            worth = 0.0 if setup.still else told_db(setup.encoder.hard().cpu().numpy(), motion)
            ranked.append((worth, codes))
    ranked.sort(key=lambda pair: -pair[0])
    return [codes for _, codes in ranked]


def motion_seen(model: SensorModel) -> Motion:
    """Return the motion model of film-like scenes with a sensor's noise."""
    read_e2 = (model.adc_noise_lsb**2 + 1 / 12) * model.electrons_per_lsb**2
    mean_e = _MEAN_LIGHT * model.full_e
    counts = 1 / mean_e if model.shot_noise else 0.0
    return Motion(_SPEEDS, noise=read_e2 / mean_e**2, counts=counts)


def _fits(setup: TrainingSetup, codes: Codes, allowed: float) -> bool:
    words = _words(setup, codes)
    return words is not None and words <= allowed


def _words(setup: TrainingSetup, codes: Codes) -> float | None:
    """Load codes and return their words per slot; None if they do not compile."""
    every_code = setup.settings.shutter.codes == "open"
    setup.encoder.load_codes(codes)
    with suppress(Rejected):
        program = program_of(setup.encoder, setup.chip)
        return words_per_slot(compiled(program, setup.chip, every_code=every_code))
    return None


@torch.no_grad()
def _losses(setup: TrainingSetup, codes: Codes, batch: Batch, step: int) -> NDArray[np.float64]:
    """Return the loss of each patch (batch,) with these codes, plus the weight of their words."""
    settings = setup.settings
    seed, weight = settings.train.seed, settings.shutter.words_weight
    setup.encoder.load_codes(codes)
    setup.follow_codes()
    rows, cols = batch.light.shape[-2:]
    place = (seed, DrawStream.TILE_WINDOWS, step)
    shutters = window(setup.encoder.hard(), rows, cols, place).to(setup.device)
    noise = generator_of(setup.device, seed, DrawStream.READOUT_NOISE, step)
    prediction = decoded(setup, batch.light, shutters, setup.model, noise)
    losses = torch.stack(
        [
            setup.loss(*compared(prediction[k : k + 1], batch.patches(k, k + 1)))
            for k in range(len(prediction))
        ]
    )
    words = (_words(setup, codes) or 0.0) if weight else 0.0
    return losses.double().cpu().numpy() + weight * words
