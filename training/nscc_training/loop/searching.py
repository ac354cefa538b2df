"""A step of a search: propose moved codes by the gradient of the decoder's loss, and accept one by
its measured loss.

The decoder is not trained during the search, so that it does not favour codes that were tried
earlier. It learned random codes, and codes near the start, in `warm_up`; the remaining steps
(`settle`) train it for the result."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from itertools import islice

import numpy as np
import torch
from torch import Tensor

from nscc.arrays import Floats
from nscc.diagnostics.diagnostic import Rejected
from nscc_training.data import Batch
from nscc_training.draws import generator_of
from nscc_training.encoders.base import Codes
from nscc_training.loop.setup import TrainingSetup
from nscc_training.loop.steps import compared, decoded, window
from nscc_training.programs import compiled, program_of, words_per_slot
from nscc_training.random_streams import DrawStream
from nscc_training.search.moves import SINGLE_SHARE, candidate
from nscc_training.settings import ShutterSettings

_FEWER = 0.9
"""Factor on the number of words per step while codes exceed their limit.

A move or two reduce the words by a tenth; random bits need about twenty steps to reach four words
per slot."""


def search(setup: TrainingSetup, batches: Sequence[Batch], step: int) -> float:
    """Replace the run's codes by the best of some moved candidates, if one is better. Return the
    mean loss, with its part for words, of the codes that the run then has. The decoder is left in
    evaluation mode.

    `shutter.judged` of `shutter.moves` candidates are judged: those with the largest expected gain
    among those that compile within `shutter.most_words`. Their loss is measured on `batches`, the
    same in all steps, plus the weighted number of words. A candidate is better if its mean gain
    over patches exceeds the standard error. While codes exceed the limit of words, the best
    candidate with at least a tenth fewer words is chosen, whatever its loss."""
    chosen = setup.settings.shutter
    setup.decoder.eval()
    generator = np.random.default_rng([setup.settings.train.seed, DrawStream.SEARCH_MOVES, step])
    current = setup.encoder.codes()
    first, words = _losses(setup, current, batches, step), _words(setup, current)
    setup.encoder.load_codes(current)
    gain = expected_gain(setup, batches, step)
    over = words is not None and not within(chosen, words)
    allowed = chosen.most_words or np.inf
    if words is not None and over:
        allowed = max(allowed, _FEWER * words)
    # A single place hardly changes the number of words.
    single_share = 0.0 if over else SINGLE_SHARE
    candidates = [
        candidate(setup.encoder, current, generator, single_share) for _ in range(chosen.moves)
    ]
    best = None if over else (current, first)
    fitting = (
        codes
        for codes in _promising(setup, current, candidates, gain)
        if (words := _words(setup, codes)) is not None and words <= allowed
    )
    for codes in islice(fitting, chosen.judged):
        candidate_losses = _losses(setup, codes, batches, step)
        gains = first - candidate_losses
        # The standard error of the mean; a single patch has none.
        error = gains.std(ddof=1) / len(gains) ** 0.5 if len(gains) > 1 else 0.0
        if (over or gains.mean() > error) and (
            best is None or candidate_losses.mean() < best[1].mean()
        ):
            best = codes, candidate_losses
    best_codes, losses = best or (current, first)
    setup.encoder.load_codes(best_codes)
    return float(losses.mean())


def within(chosen: ShutterSettings, words: float) -> bool:
    """Return whether a run may keep codes that take `words` words per slot. Only runs that learn
    codes and set `most_words` (above 0) have a limit."""
    return not (chosen.learn and chosen.most_words) or words <= chosen.most_words


def _promising(
    setup: TrainingSetup, current: Codes, candidates: list[Codes], gain: Tensor
) -> list[Codes]:
    """Return the candidates that are legal and differ from `current`, the most promising first. The
    encoder may be left with the codes of any of them, so the caller loads codes again.

    The expected gain of a candidate is the sum of `gain` (N, rows, cols) over the slots and pixels
    that it opens, minus that over those that it closes."""
    ranked = []
    present = setup.encoder.hard()
    for codes in candidates:
        if all((values == current[name]).all() for name, values in codes.items()):
            continue
        with suppress(ValueError):  # codes that `require` forbids
            setup.encoder.load_codes(codes)
            ranked.append((float((gain * (setup.encoder.hard() - present)).sum()), codes))
    ranked.sort(key=lambda pair: -pair[0])
    return [codes for _, codes in ranked]


def expected_gain(setup: TrainingSetup, batches: Sequence[Batch], step: int) -> Tensor:
    """Return by how much the mean loss of `batches` falls, to first order, if a pixel of the tile
    opens in a slot: (N, rows, cols).

    For a slot in which a pixel is open, the negative value is the gain of closing it. The value is
    minus the gradient of the loss with respect to the shutter. It includes the light that the slot
    adds and what the decoder makes of the code. `step` chooses the noise."""
    tile = setup.encoder.hard().requires_grad_()
    with torch.enable_grad():
        losses = _patch_losses(setup, tile, batches, step)
    (slope,) = torch.autograd.grad(losses.mean(), tile)
    return -slope


def _words(setup: TrainingSetup, codes: Codes) -> float | None:
    """Load codes into the encoder of `setup`, compile them and return their words per slot; None if
    the compiler refuses them. Raise ValueError for codes that `require` forbids."""
    every_code = setup.settings.shutter.codes == "open"
    setup.encoder.load_codes(codes)
    with suppress(Rejected):
        program = program_of(setup.encoder, setup.chip)
        return words_per_slot(compiled(program, setup.chip, every_code=every_code))
    return None


@torch.no_grad()
def _losses(setup: TrainingSetup, codes: Codes, batches: Sequence[Batch], step: int) -> Floats:
    """Load codes into the encoder and return the loss of each patch of `batches`, float64
    (patches,), plus the weighted number of their words.

    `step` chooses the noise. The emulated sensor of the run follows the codes."""
    setup.encoder.load_codes(codes)
    setup.follow_codes()
    losses = _patch_losses(setup, setup.encoder.hard(), batches, step)
    weight = setup.settings.shutter.words_weight
    words = (_words(setup, codes) or 0.0) if weight else 0.0
    return losses.double().cpu().numpy() + weight * words


def _patch_losses(
    setup: TrainingSetup, tile: Tensor, batches: Sequence[Batch], step: int
) -> Tensor:
    """Return the loss of each patch of `batches`, (patches,), that is exposed with a tile of
    shutters (N, r, c).

    All tiles have the same noise in a `step`, so that losses can be compared."""
    seed = setup.settings.train.seed
    window_seed = (seed, DrawStream.TILE_WINDOWS, step)
    noise = generator_of(setup.device, seed, DrawStream.READOUT_NOISE, step)
    losses = []
    for batch in batches:
        rows, cols = batch.light.shape[-2:]
        shutters = window(tile, rows, cols, window_seed).to(setup.device)
        prediction = decoded(setup, batch.light, shutters, setup.model, noise)
        losses += [
            setup.loss(*compared(prediction[k : k + 1], batch.patches(k, k + 1)))
            for k in range(len(prediction))
        ]
    return torch.stack(losses)
