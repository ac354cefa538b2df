"""The sRGB curve and its inverse: one undoes the other, and both rise."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from nscc_runtime.scenes.colour import srgb_to_linear
from nscc_training.curves import srgb as linear_to_srgb

VALUES = st.lists(st.floats(0, 4), min_size=1, max_size=20).map(np.array)
BENDS = np.array([0.0, 0.0031308, np.nextafter(0.0031308, 1), 0.04045, np.nextafter(0.04045, 1), 1])
"""Where the curves change from lines to powers. Their standard rounds both places: the pieces miss
each other by 3e-8 there."""


@given(VALUES)
def test_srgb_curves_are_inverses_of_each_other(values: np.ndarray) -> None:
    for given_ in (values, BENDS, BENDS * 0.99, BENDS * 1.01):
        np.testing.assert_allclose(linear_to_srgb(srgb_to_linear(given_)), given_, atol=1e-6)
        np.testing.assert_allclose(srgb_to_linear(linear_to_srgb(given_)), given_, atol=1e-7)


@given(VALUES)
def test_display_curves_increase(values: np.ndarray) -> None:
    ordered = np.unique(np.concatenate([values, BENDS]))
    apart = ordered[np.concatenate([[True], np.diff(ordered) > 1e-7])]
    for curve in (linear_to_srgb, srgb_to_linear):
        assert (np.diff(curve(apart)) > 0).all()


def test_srgb_curves_give_the_values_of_the_standard() -> None:
    """IEC 61966-2-1: grey of 18 % is 0.4614; the first of 255 steps is a light of 1 / 3294.6."""
    np.testing.assert_allclose(linear_to_srgb(np.array([0, 0.18, 1])), [0, 0.4614, 1], atol=5e-5)
    np.testing.assert_allclose(linear_to_srgb(np.array([1 / 3294.6])), [1 / 255], rtol=1e-4)
