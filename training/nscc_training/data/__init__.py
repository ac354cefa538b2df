"""Scenes for training: folders of pictures and clips, a camera turned in panoramas, made ones."""

from __future__ import annotations

from nscc_training.data.ahead import Ahead
from nscc_training.data.batches import Batch, Batches
from nscc_training.data.sources import Scene, Scenes, load_scenes

__all__ = ["Ahead", "Batch", "Batches", "Scene", "Scenes", "load_scenes"]
