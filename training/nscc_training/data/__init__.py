"""Scenes for training: folders of pictures and clips, a camera turned in panoramas, made ones."""

from __future__ import annotations

from nscc_training.data.exposures import Batch, Exposures, ExposureSet, cut_batch
from nscc_training.data.sources import Scene, Scenes, load_scenes

__all__ = ["Batch", "ExposureSet", "Exposures", "Scene", "Scenes", "cut_batch", "load_scenes"]
