"""Read noise of PIX."""

from __future__ import annotations

from nscc_runtime.effects.effect import ByParts, Effect, InLoop
from nscc_runtime.effects.field import Field, Sampled, Values
from nscc_runtime.effects.parameters import MOST_E, parameter
from nscc_runtime.effects.parts import Errors
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Pixels, Word


def _sigma(sensor: Sensor) -> float:
    return sensor.read_noise_e


def _found(pixels: Pixels, level: Values, word: Word) -> Values:
    return level + _sigma(pixels.sensor) * pixels.error("read", word)


def _field(sample: Sampled) -> Field:
    """rms = sigma sqrt(reads), reads weighted with their squared coefficients: a reset level that
    is subtracted k times counts k^2"""
    return Field(variance=sample.errors("reads", _sigma(sample.sensor)), behind_well=0.0)


_PARAMETERS = (
    parameter("read_noise_e", "noise", 10.0, "e", 0, MOST_E, "of one read of PIX"),
)  # fmt: skip

READ = Effect(
    name="read",
    stream=4,
    kind="random",
    title="read noise of PIX",
    model="Every word that reads PIX finds it off by sigma z. The reads of a frame are normal "
    "numbers whose weighted sum in each bucket is one keyed draw (see the package's notes).",
    cost="one normal number a pixel and bucket; the reference adds one a read",
    applied="to PIX as a source of an analog word",
    absent="this sensor has none",
    parameters=_PARAMETERS,
    reference={"reads": _found},
    field=_field,
    sums=(Errors("reads", _sigma),),
    fused=ByParts(),
    words=InLoop("read_errors", {"read_error": _sigma}),
    cost_ns=7.0,
)
