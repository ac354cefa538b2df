"""Results of `nscc evaluate` as text and as files."""

from __future__ import annotations

import io
import json
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.files import Product
from nscc_training.evaluation.results import mean_of


def result_json(result: Any) -> str:
    """Return a result as JSON text."""
    return json.dumps(result, indent=2, allow_nan=False) + "\n"


def arrays_in(folder: Path, arrays: Mapping[str, NDArray[Any]]) -> dict[Path, Product]:
    """Return the files of `--save`: one NAME.npy per array in `folder`, which is created."""
    folder.mkdir(parents=True, exist_ok=True)
    products: dict[Path, Product] = {}
    for name, values in arrays.items():
        stream = io.BytesIO()
        np.save(stream, values)
        products[folder / f"{name}.npy"] = stream.getvalue()
    return products


def result_text(result: dict[str, Any]) -> str:
    """Return a result of `nscc_training.evaluation.results` as a few lines."""
    lines = [
        f"{result['method']}, protocol {result['protocol']} ({result['protocol_sha256'][:12]})"
    ]
    if effects := result["settings"].get("effects"):
        trained = result["settings"]["trained_effects"] or "noise and full well alone"
        lines.append(f"  on a chip with effects {effects}; trained with {trained}")
    if result["sees"] == "truth":
        lines.append("  an oracle: it reads the truth, not the capture")
    for file in dict.fromkeys(item["file"] for item in result["items"]):
        items = [item for item in result["items"] if item["file"] == file]
        finite = [item["psnr_db"] for item in items if item["psnr_db"] != "inf"]
        mean = f"{sum(finite) / len(finite):.2f} dB" if finite else "inf"
        ssim = sum(item["ssim"] for item in items) / len(items)
        lines.append(f"  {file:32} {mean}, SSIM {ssim:.4f}, {len(items)} items")
    passed = Counter(f"{entry['file']}: {entry['reason']}" for entry in result["left_out"])
    for reason, count in passed.items():
        lines.append(f"  left out: {reason}" + (f", {count} times" if count > 1 else ""))
    if result["mean"] is not None:
        interval = result["ci95"]
        between = "one scene" if interval is None else "95 % {:.2f} to {:.2f}".format(*interval)
        lines.append(
            f"  mean {result['mean']:.2f} dB, sd {result['sd']:.2f}, {between}"
            f", {result['infinite']} infinite"
        )
    counts = Counter(item["file"] for item in result["items"])
    if len(set(counts.values())) > 1:
        by_source = mean_of([result], "psnr_db", by_source=True)
        most = max(counts.values())
        if by_source is not None:
            lines.append(
                f"  by source {by_source:.2f} dB: {most} of {counts.total()} items are of one file"
            )
    if result["decoder_ms"] is not None:
        lines.append(f"  {result['decoder_ms']:.0f} ms a scene on {result['device']}")
    return "\n".join(lines) + "\n"


def comparison_text(comparison: Mapping[str, Any], metric: str) -> str:
    """Return a comparison of `nscc_training.evaluation.results.compare` as a line."""
    gain, interval = comparison["gain_db"], comparison["ci95"]
    if gain is None:
        return "no pair of items has finite scores"
    unit = " dB" if metric.endswith("_db") else ""
    between = "one scene" if interval is None else f"95 % {interval[0]:+.3f} to {interval[1]:+.3f}"
    seeds = f" with {comparison['pairs']} seeds" if comparison["pairs"] > 1 else ""
    first, second = comparison["first"]["method"], comparison["second"]["method"]
    return (
        f"{second} over {first}: {gain:+.3f}{unit}, "
        f"{between} ({metric}, {comparison['items']} items of {comparison['scenes']} "
        f"scenes{seeds}, "
        f"protocol {comparison['protocol']})"
    )
