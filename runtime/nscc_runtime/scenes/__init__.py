"""Scenes: light in electrons on the array, from files, folders and builtin names."""

from __future__ import annotations

from nscc_runtime.scene_settings import FITS, Fit, Scene
from nscc_runtime.scenes.exposure import ExposureLevel, parse_exposure
from nscc_runtime.scenes.load import (
    PlacedLight,
    laid_lights,
    laid_scene,
    light_of_array,
    scene_light,
)
from nscc_runtime.scenes.placement import Placement, parse_crop

__all__ = [
    "FITS",
    "ExposureLevel",
    "Fit",
    "PlacedLight",
    "Placement",
    "Scene",
    "laid_lights",
    "laid_scene",
    "light_of_array",
    "parse_crop",
    "parse_exposure",
    "scene_light",
]
