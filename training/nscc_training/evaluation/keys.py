"""What rows of tables know runs by."""

from __future__ import annotations

from nscc_training.settings import Settings

Key = tuple[str, str, str]
"""Decoder, class, and what became of the codes: learned, words, random, quad or fixed."""


def key_of(settings: Settings) -> Key:
    """The key of a run's settings."""
    shutter = settings.shutter
    codes = "learned"
    if not shutter.learn:
        codes = shutter.init if shutter.init in ("random", "quad") else "fixed"
    elif shutter.words_weight > 0:
        codes = "words"
    decoder = settings.decoder
    # Narrower decoders are none of the tables' rows.
    name = decoder.name if decoder.width == 1 else f"{decoder.name} x {decoder.width:g}"
    return name, shutter.kind, codes
