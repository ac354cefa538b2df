"""Encoders by the names of their classes."""

from __future__ import annotations

import numpy as np

from nscc_training.encoders.base import Encoder, ShutterSpec
from nscc_training.encoders.bumps import AlwaysOpen, Start, StartStop, Stop
from nscc_training.encoders.looks import LOOKS, Looks
from nscc_training.encoders.patterns import Bits, Codebook

CLASSES: dict[str, type[Encoder]] = {
    "a": AlwaysOpen,
    "b": Stop,
    "c": Start,
    "d": StartStop,
    "e": Bits,
    "codebook": Codebook,
    LOOKS: Looks,
}

STARTS = ("random", "uniform", "quad")


def make_encoder(
    spec: ShutterSpec, start: str = "random", seed: int = 0, relaxation: str = "straight-through"
) -> Encoder:
    """An encoder of that class, at one of `STARTS`; the seed is for `random`.

    ValueError for what the class cannot be.
    """
    if spec.kind not in CLASSES:
        raise ValueError(f"{spec.kind!r} is none of {', '.join(CLASSES)}")
    if spec.slots < 1 or min(spec.tile) < 1:
        raise ValueError(f"{spec.slots} slots, a tile of {spec.tile}")
    encoder = CLASSES[spec.kind](spec, relaxation)
    if relaxation == "tried" and spec.kind == "a":
        raise ValueError("class a is always open: there is nothing to try")
    if start not in STARTS:
        raise ValueError(f"{start!r} is none of {', '.join(STARTS)}")
    if start == "random":
        encoder.start_random(np.random.default_rng(seed))
    else:
        (encoder.start_quad if start == "quad" else encoder.start_uniform)()
    return encoder
