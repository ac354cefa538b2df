"""Scores of pictures, clips and files as JSON values, their means and confidence intervals."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import rejected
from nscc.files import file_sha256
from nscc.mappings import JsonObject
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


def measures(truth: Array, result: Array, data_range: float, nits: float = NITS) -> JsonObject:
    """Return every metric of a pair of arrays that `check_pair` accepts, as JSON values by name.

    `truth` and `result` are (rows, cols), or clips (T, rows, cols), which also have `sd_db` and a
    list of metrics for each frame (`frames`). `data_range` is the value that counts as white, and
    `nits` its luminance in cd/m2 for PU21. Infinite dB are "inf"; `temporal_error` is None unless
    there are two frames or more."""
    frames = [(truth, result)] if truth.ndim == 2 else list(zip(truth, result, strict=True))
    scores = metrics.frame_scores((mean_square_error(a, b) for a, b in frames), data_range)
    values: JsonObject = {
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


def frame_scores(truth: Array, result: Array, data_range: float) -> JsonObject:
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
) -> JsonObject:
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


RESAMPLES = 2000
"""Number of samples of a bootstrap."""


class Summary(NamedTuple):
    """The mean of scores, their standard deviation, the 95 % interval of the mean, and the number
    of infinite scores, which the other three leave out."""

    mean: float | None
    sd: float | None
    ci95: list[float] | None
    infinite: int


def summary(values: Sequence[float], groups: Sequence[str], seed: int = 0) -> Summary:
    """Return the statistics of scores.

    `groups`, as long as `values`, names the scene of each value. `sd` is the sample standard
    deviation, 0 for a single finite value. The interval is a bootstrap over scenes, because crops
    of one scene are not independent; `seed` is that of its samples. It is None for a single scene;
    `mean`, `sd` and `ci95` are None without finite values. Raises ValueError for NaN."""
    if any(np.isnan(value) for value in values):
        raise ValueError("NaN is not a score")
    finite = [(v, g) for v, g in zip(values, groups, strict=True) if np.isfinite(v)]
    scores = np.array([v for v, _ in finite], np.float64)
    scenes = [g for _, g in finite]
    variance = float(scores.var(ddof=1)) if len(scores) > 1 else 0.0
    return Summary(
        mean=float(scores.mean()) if finite else None,
        sd=variance**0.5 if finite else None,
        ci95=list(bootstrap(scores, scenes, seed)) if len(set(scenes)) > 1 else None,
        infinite=len(values) - len(finite),
    )


def bootstrap(values: ArrayLike, groups: Sequence[str], seed: int = 0) -> tuple[float, float]:
    """Return the limits of the 95 % interval of the mean of values, from a bootstrap over groups.

    `groups`, as long as `values`, names the group of each value; values of one group are drawn
    together. `RESAMPLES` samples are drawn with `seed`. Values must be finite; with a single group
    both limits are the mean."""
    names, of_value = np.unique(np.asarray(groups, np.str_), return_inverse=True)
    sums = np.bincount(of_value, weights=np.asarray(values, np.float64), minlength=len(names))
    counts = np.bincount(of_value, minlength=len(names)).astype(np.float64)
    draws = np.random.default_rng(seed).integers(len(names), size=(RESAMPLES, len(names)))
    means = sums[draws].sum(axis=1) / counts[draws].sum(axis=1)
    low, high = np.percentile(means, (2.5, 97.5))
    return float(low), float(high)


def paired(
    first: Mapping[str, float], second: Mapping[str, float], scene_names: Mapping[str, str]
) -> JsonObject:
    """Return the statistics of the gain, second minus first score, on the items that both have.

    Scores are by the name of the item, and `scene_names` names its scene. `items` and `scenes` are
    counts, `only_first` and `only_second` count items without a partner, and `gain_db` is the mean
    gain. `sd` is the standard deviation of the gains, `ci95` the 95 % interval of their mean (None
    for a single scene), and `infinite` the number of infinite gains, which are left out of the
    others; a gain counts as infinite if either score is. Without common items `gain_db`, `sd` and
    `ci95` are None. Raises ValueError for NaN."""
    common = sorted(set(first) & set(second))
    if any(np.isnan(score) for score in (*first.values(), *second.values())):
        raise ValueError("NaN is not a score")
    gains = [
        second[k] - first[k] if np.isfinite(first[k]) and np.isfinite(second[k]) else np.inf
        for k in common
    ]
    gain = summary(gains, [scene_names[k] for k in common])
    return {
        "items": len(common),
        "scenes": len({scene_names[k] for k in common}),
        "only_first": len(set(first) - set(second)),
        "only_second": len(set(second) - set(first)),
        "gain_db": gain.mean,
        "sd": gain.sd,
        "ci95": gain.ci95,
        "infinite": gain.infinite,
    }
