"""Decoders that need no training, each from coded frames to light."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nscc_training.baselines import sci
from nscc_training.baselines.dictionary import made_dictionary
from nscc_training.baselines.hdr import merged
from nscc_training.baselines.tv_loop import denoise
from nscc_training.evaluation.captured import CapturedScene

Light = NDArray[np.float64]


@dataclass(frozen=True)
class Method:
    """A decoder without training.

    `decode` returns electrons over the frame (rows, cols), or per slot (slots, rows, cols). `sees`
    is "capture", or "truth" for reference methods that use the ground truth. `settings` are named
    options of `decode`, which `nscc tradeoff` compares."""

    decode: Callable[..., Light]
    sees: Literal["capture", "truth"] = "capture"
    settings: Mapping[str, Mapping[str, Any]] | None = None


def _clip(
    loop: Callable[..., NDArray[np.float32]], captured: CapturedScene, **options: Any
) -> Light:
    """Decode a capture with a function of a measurement, in units of white, and a mask."""
    white_e = captured.white_e
    measurement = (captured.codes[0] * (captured.code_e / white_e)).astype(np.float32)
    return np.asarray(loop(measurement, captured.masks[0], **options), np.float64) * white_e


def _of_truth(loop: Callable[..., NDArray[np.float32]], captured: CapturedScene) -> Light:
    truth = captured.scene.light_e.astype(np.float32)
    return np.asarray(loop(truth, captured.masks[0]), np.float64)


def _merged(captured: CapturedScene) -> Light:
    model = captured.model
    assert model is not None
    noise_e = model.adc_noise_lsb * model.electrons_per_lsb
    return merged(
        captured.codes[0], captured.share, model.electrons_per_lsb, captured.saturated[0], noise_e
    )


def _sparse(captured: CapturedScene, **options: Any) -> Light:
    from nscc_training.baselines.sparse_coding import coded_still

    model = captured.model
    assert model is not None
    return coded_still(
        captured.codes[0], captured.share, _merged(captured), model.electrons_per_lsb,
        captured.saturated[0], model.full_well_e, **options,
    )  # fmt: skip


def _any(captured: CapturedScene, **options: Any) -> Light:
    from nscc_training.any_code.decode import decoded_clip, decoded_still

    decode = decoded_still if captured.is_still else decoded_clip
    return np.asarray(decode(captured.measured(), **options)[0].double().numpy())


def _read_out(captured: CapturedScene) -> Light:
    """Return the measurement of each pixel divided by its open fraction of the frame."""
    return np.asarray(captured.codes[0].astype(np.float64) * captured.code_e / captured.share)


_TV = {f"{n}": {"iterations": n} for n in (5, 10, 20, 40, 80)}
CLIPS: Mapping[str, Method] = {
    "gap-tv": Method(partial(_clip, sci.gap_tv), settings=_TV),
    "admm-tv": Method(partial(_clip, sci.admm_tv), settings=_TV),
    "dictionary": Method(partial(_clip, sci.from_dictionary), settings={"learned": {}}),
    "adjoint": Method(partial(_clip, sci.adjoint), settings={"S^T E": {}}),
    "bilinear": Method(partial(_of_truth, sci.bilinear), "truth"),
    "thin-out": Method(partial(_of_truth, lambda truth, _mask: sci.thin_out(truth)), "truth"),
    "any": Method(_any, settings={f"{n}": {"count": n} for n in (2, 4, 8, 12)}),
}
STILLS: Mapping[str, Method] = {
    "merged": Method(_merged, settings={"neighbours": {}}),
    "sparse-coding": Method(_sparse, settings={f"{n}": {"iterations": n} for n in (15, 60)}),
    "any": Method(_any, settings={"1": {"count": 1}}),
    "read-out": Method(_read_out),
}


def load(method: str, slots: int) -> None:
    """Compile or learn everything that a method needs, so that measured times exclude it."""
    if method in ("gap-tv", "admm-tv", "any"):
        denoise.load()
    if method == "dictionary":
        made_dictionary(slots)
