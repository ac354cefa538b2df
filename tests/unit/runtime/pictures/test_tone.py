"""Tone curves against their formulas, computed here another way."""

from __future__ import annotations

import numpy as np
import pytest

from nscc_runtime.pictures.tone import fitted


def srgb(linear: float) -> float:
    return 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055


def test_reinhard_maps_the_geometric_mean_to_the_key() -> None:
    """Only lit pixels count, because dark ones have no logarithm."""
    light = np.array([[0.0, 0.0, 1.0], [10.0, 100.0, 1000.0]])
    tone = fitted("reinhard", light, white=1000.0)
    scale = 0.18 / np.exp(np.log(light[light > 0] / 1000).mean())
    for electrons in (0.0, 1.0, 30.0, 100.0, 1000.0):
        bright = electrons / 1000 * scale
        shown = srgb(bright * (1 + bright / scale**2) / (1 + bright))
        assert tone(np.array([electrons]))[0] == np.rint(255 * min(shown, 1))


def test_reinhard_of_the_dark_shows_light_by_its_white() -> None:
    tone = fitted("reinhard", np.zeros((3, 4)), white=8.0)
    assert tone(np.array([0.0, 8.0])).tolist() == [0, 255]


@pytest.mark.parametrize("name", ["log", "reinhard", "mu-law", "srgb", "linear"])
def test_a_dark_picture_without_a_given_white_is_drawn_black(name: str) -> None:
    assert fitted(name, np.zeros((3, 4)))(np.ones((3, 4))).max() == 0


@pytest.mark.parametrize("name", ["log", "reinhard", "mu-law", "srgb", "linear"])
def test_values_that_are_not_finite_do_not_change_the_curve(name: str) -> None:
    light = np.linspace(0, 900, 12)
    tone, whole = fitted(name, np.append(light, [np.inf, np.nan, -np.inf])), fitted(name, light)
    assert tone.white == whole.white
    np.testing.assert_array_equal(tone(light), whole(light))
    assert tone(np.array([np.inf, 1e308, np.nan, -np.inf])).tolist() == [255, 255, 0, 0]
