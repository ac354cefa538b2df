"""Shutters that can be learned: real parameters outside, legal codes of a class inside."""

from __future__ import annotations

from nscc_training.code_choices import RELAXATIONS
from nscc_training.encoders.base import Encoder, ShutterSpec
from nscc_training.encoders.make import CLASSES, make_encoder
from nscc_training.encoders.trial import Trial

__all__ = ["CLASSES", "RELAXATIONS", "Encoder", "ShutterSpec", "Trial", "make_encoder"]
