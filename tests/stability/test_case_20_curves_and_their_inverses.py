"""Hard case 20: log, mu-law and PU21 at 0, below 0, at 1e-6 and at 1e8."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from nscc_training import curves


def mu_law_inverse(y: Any) -> Any:
    scaled = y.astype(np.float64) * np.log1p(curves.MU)
    return np.where(y >= 0, np.expm1(np.maximum(scaled, 0)), scaled) / curves.MU


VALUES = [0.0, -1e-7, 1e-6, 1e8, 1.0, 3e-3]
CURVES: dict[str, tuple[Callable[[Any], Any], Callable[[Any], Any]]] = {
    "log": (
        lambda x: curves.log_curve(x, 1e-3),
        lambda y: curves.log_curve_inverse(y, 1e-3),
    ),
    "mu": (curves.mu_law, mu_law_inverse),
}


@pytest.mark.parametrize("name", CURVES)
@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_curves_and_their_inverses_give_the_value_back(name: str, kind: type) -> None:
    there, back = CURVES[name]
    x = np.array(VALUES, kind)
    y = there(x)
    assert y.dtype == kind
    assert np.isfinite(y).all()
    np.testing.assert_allclose(back(y), x, rtol=2e-6, atol=0)


def test_pu21_can_be_inverted_where_it_is_defined() -> None:
    x = np.array([0.005, 0.01, 1.0, 100.0, 1e4, 1e8, -1e-7, 0.0])
    back = [
        brentq(lambda light, y=y: curves.pu21(np.float64(light)) - y, -1.0, 2e8, xtol=1e-13)
        for y in curves.pu21(x)
    ]
    np.testing.assert_allclose(back, x, rtol=2e-6, atol=1e-12)
    # the authors scale it so that an ordinary display's white is near 256
    assert curves.pu21(np.float64(100.0)) == pytest.approx(256, abs=1)
    assert curves.pu21(np.float64(0.005)) == pytest.approx(0, abs=1e-6)


@pytest.mark.parametrize("name", [*CURVES, "pu21"])
@pytest.mark.parametrize("dtype", ["float32", "float64"])
def test_gradients_are_finite_and_positive(name: str, dtype: str) -> None:
    torch = pytest.importorskip("torch")
    there = CURVES[name][0] if name in CURVES else curves.pu21
    x = torch.tensor(VALUES, dtype=getattr(torch, dtype), requires_grad=True)
    y = there(x)
    assert y.dtype == x.dtype
    y.sum().backward()
    assert torch.isfinite(x.grad).all()
    assert (x.grad > 0).all()
    np.testing.assert_allclose(y.detach().numpy(), there(x.detach().numpy()), rtol=1e-6, atol=1e-12)


@pytest.mark.parametrize("name", [*CURVES, "pu21"])
def test_gradients_of_curves_equal_finite_differences(name: str) -> None:
    torch = pytest.importorskip("torch")
    there = CURVES[name][0] if name in CURVES else curves.pu21
    x = torch.tensor([-0.5, 0.02, 0.7, 40.0, 2e4], dtype=torch.float64, requires_grad=True)
    assert torch.autograd.gradcheck(there, (x,), eps=1e-7, atol=1e-5, rtol=1e-4)
