"""Scenes for training: folders of pictures and clips, a turning camera in panoramas, procedural
scenes."""

from __future__ import annotations

from nscc_training.data.exposures import Batch, Exposures, ExposureSet, cut_batch
from nscc_training.data.sources import Scenes, SourceScene, load_scenes

__all__ = ["Batch", "ExposureSet", "Exposures", "Scenes", "SourceScene", "cut_batch", "load_scenes"]
