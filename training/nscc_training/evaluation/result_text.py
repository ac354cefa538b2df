"""Results of `nscc evaluate` as text and as files."""

from __future__ import annotations

import io
import json
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.files import Product
from nscc.program.problems import counted
from nscc_training.evaluation.results import mean_of, score_of


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
    classified = score_of(result) == "correct"
    lines += _class_lines(result["items"]) if classified else _scene_lines(result["items"])
    passed = Counter(f"{entry['file']}: {entry['reason']}" for entry in result["left_out"])
    for reason, count in passed.items():
        lines.append(f"  left out: {reason}" + (f", {count} times" if count > 1 else ""))
    if result["mean"] is not None:
        interval = result["ci95"]
        if classified:
            low, high = interval or (result["mean"], result["mean"])
            lines.append(f"  {result['mean']:.1%} correct, 95 % {low:.1%} to {high:.1%}")
        else:
            between = "one scene" if interval is None else "95 % {:.2f} to {:.2f}".format(*interval)
            lines.append(
                f"  mean {result['mean']:.2f} dB, sd {result['sd']:.2f}, {between}"
                f", {result['infinite']} infinite"
            )
    counts = Counter(item["file"] for item in result["items"])
    if len(set(counts.values())) > 1 and not classified:
        by_source = mean_of([result], "psnr_db", by_source=True)
        most = max(counts.values())
        if by_source is not None:
            lines.append(
                f"  by source {by_source:.2f} dB: {most} of {counts.total()} items are of one file"
            )
    if result["decoder_ms"] is not None:
        lines.append(f"  {result['decoder_ms']:.0f} ms a scene on {result['device']}")
    return "\n".join(lines) + "\n"


def _scene_lines(items: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return a line for each file."""
    lines = []
    for file in dict.fromkeys(item["file"] for item in items):
        file_items = [item for item in items if item["file"] == file]
        finite = [item["psnr_db"] for item in file_items if item["psnr_db"] != "inf"]
        mean = f"{sum(finite) / len(finite):.2f} dB" if finite else "inf"
        ssim = sum(item["ssim"] for item in file_items) / len(file_items)
        lines.append(f"  {file:32} {mean}, SSIM {ssim:.4f}, {counted(len(file_items), 'item')}")
    return lines


def _class_lines(items: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return a line for each class, with the class for which it is most often mistaken."""
    lines = []
    for label in dict.fromkeys(item["class"] for item in items):
        decoded = Counter(item["decoded"] for item in items if item["class"] == label)
        count, correct = decoded.total(), decoded.pop(label, 0)
        mistaken = decoded.most_common(1)
        remark = f", {mistaken[0][1]} for {mistaken[0][0]}" if mistaken else ""
        lines.append(f"  {label:32} {correct / count:.1%} of {count} correct{remark}")
    return lines


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
