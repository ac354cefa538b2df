"""All metrics of a pair of arrays, for `nscc metrics` and `nscc evaluate`."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import rejected
from nscc.files import file_sha256
from nscc.program.problems import counted
from nscc_training import metrics
from nscc_training.array_files import read_picture_or_clip
from nscc_training.metrics import WINDOW, mean_square_error

NITS = 1000.0
"""Default luminance in cd/m2 of the data range in PU21-PSNR."""
LARGEST = 1e60
"""Largest data range and value; the smallest data range is its inverse.

Fourth powers of such numbers fit float64."""
METRIC_NAMES = {"psnr_db": "PSNR in dB", "ssim": "SSIM", "correct": "share of right classes"}
"""Names of the metrics of runs."""
_METRIC_TEXTS = {"psnr_db": "{:.2f} dB", "ssim": "SSIM {:.4f}", "correct": "{:.1%} correct"}


def check_pair(truth: Array, result: Array) -> None:
    """Raise Rejected unless metrics can compare both arrays: NS0802 for different or too small
    shapes, NS0804 for magnitudes above `LARGEST`. Both are (rows, cols) or (T, rows, cols), with at
    least one value."""
    if truth.shape != result.shape:
        raise rejected(
            "NS0802",
            f"the truth is {truth.shape}, the reconstruction {result.shape}",
            notes=("a metric compares pixel by pixel, without cropping or scaling",),
            helps=("crop both to the same frames, rows and columns",),
            data={"truth": list(truth.shape), "result": list(result.shape)},
        )
    if min(truth.shape[-2:]) < WINDOW:
        raise rejected(
            "NS0802",
            f"{truth.shape[-2]} x {truth.shape[-1]} is too small: SSIM needs {WINDOW} x {WINDOW}",
            helps=("give larger pictures",),
        )
    for array in (truth, result):
        most = np.max(np.abs(array.astype(np.longdouble)))
        if most > LARGEST:
            raise rejected(
                "NS0804",
                f"a value of {most:.3g} is too large: squares of such errors are not finite",
                notes=(f"values may be up to {LARGEST:g}",),
                helps=("store them in another unit, and scale the data range with them",),
            )


def measures(truth: Array, result: Array, data_range: float, nits: float = NITS) -> dict[str, Any]:
    """Return every metric of a pair of arrays that `check_pair` accepts, as JSON values by name.

    `truth` and `result` are (rows, cols), or clips (T, rows, cols), which also have `sd_db` and a
    list of metrics for each frame (`frames`). `data_range` is the value that counts as white, and
    `nits` its luminance in cd/m2 for PU21. Infinite dB are "inf"; `temporal_error` is None unless
    there are two frames or more."""
    frames = [(truth, result)] if truth.ndim == 2 else list(zip(truth, result, strict=True))
    scores = metrics.frame_scores((mean_square_error(a, b) for a, b in frames), data_range)
    values: dict[str, Any] = {
        "psnr_db": decibels(scores.mean),
        "psnr_of_mean_mse_db": decibels(scores.of_mean_mse),
        "infinite": scores.infinite,
        "ssim": metrics.ssim(truth, result, data_range),
        "mu_psnr_db": decibels(metrics.mu_psnr(truth, result, data_range)),
        "pu21_psnr_db": decibels(metrics.pu21_psnr(truth, result, data_range, nits)),
        "temporal_error": metrics.temporal_error(truth, result, data_range)
        if len(frames) > 1
        else None,
    }
    if truth.ndim == 3:
        values["sd_db"] = scores.sd
        values["frames"] = [
            {"frame": k, **frame_scores(a, b, data_range)} for k, (a, b) in enumerate(frames)
        ]
    return values


def frame_scores(truth: Array, result: Array, data_range: float) -> dict[str, Any]:
    """Return the metrics `psnr_db` and `ssim` of `result`, one frame of a clip, as JSON values.
    `data_range` is the peak value."""
    return {
        "psnr_db": decibels(metrics.psnr(truth, result, data_range)),
        "ssim": metrics.ssim(truth, result, data_range),
    }


def stamp(path: Path) -> dict[str, str]:
    """Return what identifies the file `path` in a result: its name without the folder (`file`) and
    its SHA-256 digest (`sha256`)."""
    return {"file": path.name, "sha256": file_sha256(path)}


def decibels(value: float) -> float | str:
    """Return a number of dB as a JSON value: itself if finite, else "inf" (JSON has no
    infinity)."""
    return "inf" if math.isinf(value) else value


def number(value: float | str) -> float:
    """Return the dB of a JSON value: infinity for "inf", as `decibels` writes it, else the
    number."""
    return float(np.inf) if value == "inf" else float(value)


def score_text(metric: str, value: float | str) -> str:
    """Return the value of a run's `metric` ("psnr_db", "ssim" or "correct") with its unit; "inf" is
    infinite."""
    return _METRIC_TEXTS[metric].format(number(value))


def means_text(means: Mapping[str, float | str]) -> str:
    """Return the metrics of a run as a text, such as "30.12 dB, SSIM 0.9123"."""
    return ", ".join(score_text(metric, value) for metric, value in means.items())


def measure_files(
    truth: Path,
    result: Path,
    data_range: float,
    nits: float = NITS,
    *,
    truth_key: str | None = None,
    result_key: str | None = None,
) -> dict[str, Any]:
    """Return every metric of the files `truth` and `result` as JSON values (`measures`), with names
    and digests of the files, and the `shape`, `data_range` and `nits`, the luminance of the data
    range in cd/m2.

    The files contain pictures (rows, cols) or clips (T, rows, cols); `truth_key` and `result_key`
    select one of several arrays, None the usual one. Raises Rejected for files and values without
    metrics, NS0803 for an invalid data range."""
    if not 1 / LARGEST <= data_range <= LARGEST:
        raise rejected(
            "NS0803",
            f"invalid data range {data_range:g}",
            notes=(
                "the data range is the peak value that errors are compared with, a number "
                f"from {1 / LARGEST:g} to {LARGEST:g}",
            ),
            helps=("255 for 8-bit values, 1 for values on [0, 1], a full well for electrons",),
        )
    arrays = [
        read_picture_or_clip(path, key) for path, key in ((truth, truth_key), (result, result_key))
    ]
    check_pair(arrays[0], arrays[1])
    return {
        "truth": stamp(truth),
        "result": stamp(result),
        "shape": list(arrays[0].shape),
        "data_range": data_range,
        "nits": nits,
        **measures(arrays[0], arrays[1], data_range, nits),
    }


def measures_text(values: Mapping[str, Any]) -> str:
    """Return the metrics `values` of `measure_files` as text: a line with data range and shape,
    then one for each metric. The temporal error of a single picture is left out."""
    rows = [
        ("PSNR", "psnr_db", " dB"),
        ("PSNR of the mean error", "psnr_of_mean_mse_db", " dB"),
        ("SSIM", "ssim", ""),
        ("PSNR, mu-law 5000", "mu_psnr_db", " dB"),
        (f"PSNR, PU21, {values['nits']:g} cd/m2", "pu21_psnr_db", " dB"),
        ("temporal error", "temporal_error", ""),
    ]
    lines = [f"data range {values['data_range']:g}, {' x '.join(map(str, values['shape']))}"]
    for name, key, unit in rows:
        value = values[key]
        if value is not None:
            text = value if isinstance(value, str) else f"{value:.4f}"
            lines.append(f"  {name:28}{text}{unit}")
    if values["infinite"]:
        frames = counted(values["infinite"], "frame")
        lines.append(f"  {frames} without any error: left out of the mean, unless all are")
    return "\n".join(lines) + "\n"
