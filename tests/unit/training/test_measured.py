"""Measurements for decoders of any code: their noise, and the light that counts as white."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

pytest.importorskip("torch")

from nscc_training.any_code.decode import white
from nscc_training.measured import Measured
from nscc_training.sensor_model import SensorModel

SENSOR = SensorModel(30000.0, 120.0, adc_bits=8, adc_noise_lsb=0.75)


def test_the_noise_of_a_read_frame_is_computed_from_the_sensor() -> None:
    """Converter noise and rounding everywhere, photons where there is light."""
    rng = np.random.default_rng(3)
    masks = rng.random((1, 3, 40, 50)) < 0.5
    codes = np.broadcast_to(np.array([-2.0, 0.0, 100.0, 400.0], np.float32), (1, 40, 4)).copy()
    found = Measured.read(codes, masks[..., :4], SENSOR)
    draws = 100.0 + 0.75 * rng.standard_normal(400_000)
    converter_e2 = np.var(np.rint(draws)) * 120.0**2
    assert found.variance[0, 0, 0] == pytest.approx(converter_e2, rel=0.01)
    with_photons = Measured.read(codes, masks[..., :4], replace(SENSOR, shot_noise=True))
    added_e2 = with_photons.variance - found.variance
    # Photons: the electrons of the codes -2 (as 0), 0, 100 and 400, of 120 electrons each.
    np.testing.assert_allclose(added_e2[0, 0, 0], [0, 0, 12000.0, 48000.0], rtol=1e-3)
    np.testing.assert_allclose(found.value[0, 0, 0], [-240.0, 0, 12000.0, 48000.0])
    assert found.saturated[0, 0, 0].tolist() == [False, False, False, True]


@pytest.mark.parametrize("closed", [0.0, 0.4, 1.0])
def test_white_is_a_quantile_of_the_pixels_that_open(closed: float) -> None:
    """White is the 0.995 quantile of the light of open pixels, for each scene. If all are closed it
    is 1."""
    rng = np.random.default_rng(5)
    light = np.sort(rng.exponential(1.0, (2, 1, 20, 30)), axis=0).astype(np.float32)
    opened = rng.random((1, 1, 1, 20, 30)) >= closed
    mask = np.repeat(opened, 4, axis=2).astype(np.float32)
    value = light * mask.sum(axis=2)
    measured = Measured(value, mask, np.ones_like(value), value < 0).tensors()
    found = white(measured).numpy()
    for batch in range(2):
        seen = light[batch, 0][opened[0, 0, 0]]
        wanted = np.quantile(seen, 0.995) if seen.size else 1.0
        assert found[batch] == pytest.approx(wanted, rel=1e-5)
