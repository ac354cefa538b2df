"""Learned shutters: real-valued parameters that represent legal codes of a shutter class."""

from __future__ import annotations

from nscc_training.code_choices import RELAXATIONS
from nscc_training.encoders.base import Encoder, ShutterSpec
from nscc_training.encoders.encoder_classes import CLASSES, make_encoder
from nscc_training.encoders.trial import CodeTrial

__all__ = ["CLASSES", "RELAXATIONS", "CodeTrial", "Encoder", "ShutterSpec", "make_encoder"]
