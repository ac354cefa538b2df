"""Learned shutters: real-valued parameters that represent legal codes of a shutter class."""

from __future__ import annotations

from nscc_training.code_choices import RELAXATIONS
from nscc_training.encoders.base import CodeTrial, Encoder, ShutterSpec
from nscc_training.encoders.encoder_classes import CLASSES, make_encoder

__all__ = ["CLASSES", "RELAXATIONS", "CodeTrial", "Encoder", "ShutterSpec", "make_encoder"]
