"""Construction of encoders by class name."""

from __future__ import annotations

import numpy as np

from nscc_training.code_choices import ORDERED, SCATTERED, STARTS
from nscc_training.encoders.base import Encoder, ShutterSpec
from nscc_training.encoders.bumps import AlwaysOpen, Bump, Start, StartStop, Stop
from nscc_training.encoders.looks_encoder import LOOKS, LooksEncoder
from nscc_training.encoders.ordered import ordered
from nscc_training.encoders.patterns import Bits, Codebook
from nscc_training.encoders.scattered import scattered

CLASSES: dict[str, type[Encoder]] = {
    "a": AlwaysOpen,
    "b": Stop,
    "c": Start,
    "d": StartStop,
    "e": Bits,
    "codebook": Codebook,
    LOOKS: LooksEncoder,
}

_MOST_LEVELS = 16
"""Most exposure times that are scattered individually; with more, powers of two are used."""


def make_encoder(
    spec: ShutterSpec, start: str = "random", seed: int = 0, relaxation: str = "straight-through"
) -> Encoder:
    """Make an encoder of the class that `spec` names.

    Parameters
    ----------
    spec : ShutterSpec
    start : str
        One of `nscc_training.code_choices.STARTS`.
    seed : int
        Seed of random starts.
    relaxation : str
        How codes are learned: one of `nscc_training.code_choices.RELAXATIONS`.

    Returns
    -------
    Encoder

    Raises
    ------
    ValueError
        For a start or a relaxation that the class does not support.
    """
    if spec.kind not in CLASSES:
        raise ValueError(f"{spec.kind!r} is not one of {', '.join(CLASSES)}")
    if spec.slots < 1 or min(spec.tile) < 1:
        raise ValueError(f"{spec.slots} slots, a tile of {spec.tile}")
    encoder = CLASSES[spec.kind](spec, relaxation)
    if relaxation in ("tried", "search") and spec.kind == "a":
        raise ValueError("class a is always open and has no parameters to try")
    if relaxation == "search" and spec.kind == LOOKS:
        raise ValueError("a search changes the codes of places, but pixels that look have levels")
    if start not in STARTS:
        raise ValueError(f"{start!r} is not one of {', '.join(STARTS)}")
    if start in SCATTERED:
        _scatter(encoder, start, np.random.default_rng(seed))
    elif start in ORDERED:
        encoder.load_codes(ordered(start, spec))
    elif start == "random":
        encoder.start_random(np.random.default_rng(seed))
    else:
        (encoder.start_quad if start == "quad" else encoder.start_uniform)()
    return encoder


def _scatter(encoder: Encoder, start: str, generator: np.random.Generator) -> None:
    """Set exposure times so that equal ones are far apart; raise ValueError for other classes than
    b and c."""
    if not isinstance(encoder, Bump) or len(encoder.limits) != 1:
        raise ValueError(f"{start} needs codes with one field, classes b and c")
    ((name, (low, high)),) = encoder.limits.items()
    levels = np.arange(low, high + 1)
    if len(levels) > _MOST_LEVELS:
        doubling = low + 2 ** np.arange(int(np.log2(high - low + 1)) + 1) - 1
        levels = np.unique(np.minimum(doubling, high))
    encoder.load_codes({name: scattered(start, levels, encoder.spec.tile, generator)})
