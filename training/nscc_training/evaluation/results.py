"""The JSON that `nscc evaluate` writes, and the comparison of two of them."""

from __future__ import annotations

import json
import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc.files import read_whole
from nscc_training.measures import number, stamp
from nscc_training.protocols import Protocol
from nscc_training.scene_files import labels
from nscc_training.statistics import paired, summary

SCHEMA = "nscc-result-1"
_MOST_REASONS = 5

Array = NDArray[Any]


@dataclass(frozen=True)
class Item:
    """One scored picture or frame: where it is from, and its metrics as JSON values."""

    file: str
    crop: list[int] | None
    frame: int | None
    metrics: dict[str, Any]

    def as_json(self) -> dict[str, Any]:
        """The item as one flat object."""
        return {"file": self.file, "crop": self.crop, "frame": self.frame, **self.metrics}


class Scored(NamedTuple):
    """An item, its reconstruction and truth (float32), and the seconds that decoding took."""

    item: Item
    made: Array
    truth: Array
    seconds: float


class Scene(ABC):
    """A scene as a protocol exposes it; `light_e` in electrons."""

    light_e: Array

    @property
    def truth_e(self) -> Array:
        """What a perfect decoder would make of it, in electrons: by default the light itself."""
        return self.light_e

    @abstractmethod
    def scores(self, result_e: Array) -> dict[str, Any]:
        """The protocol's metrics of what was made of it, as JSON values."""

    @abstractmethod
    def item(self, result_e: Array) -> Item:
        """The same as an item of a result."""


@dataclass(frozen=True)
class Unusable:
    """A scene that cannot be exposed as the protocol says: its file, its place there, and why."""

    file: str
    place: Mapping[str, Any]
    reason: str

    def as_json(self) -> dict[str, Any]:
        """What a result says of it."""
        return {"file": self.file, **self.place, "reason": self.reason}


def scored(
    scenes: Iterable[Scene | Unusable],
    decode: Callable[[Scene, int], tuple[Array, float]],
    left_out: list[dict[str, Any]],
) -> Iterator[Scored]:
    """Every scene that can be used, decoded and scored; the others go into `left_out`.

    `decode` gives electrons and seconds; it is told the scene's number, for noise of its own.
    """
    for index, scene in enumerate(scenes):
        if isinstance(scene, Unusable):
            left_out.append(scene.as_json())
            continue
        made, seconds = decode(scene, index)
        truth = scene.truth_e.astype(np.float32)
        yield Scored(scene.item(made), made.astype(np.float32), truth, seconds)


@dataclass(frozen=True)
class Subject:
    """What was evaluated, with hard shutters: a method's name and settings, and what it costs."""

    method: str
    settings: dict[str, Any]
    sees: str = "capture"
    decoder_ms: float | None = None
    device: str = "cpu"
    parameters: int = 0
    flops: int | None = None


def result(
    protocol: Protocol,
    subject: Subject,
    files: Sequence[Path],
    items: Sequence[Item],
    left_out: Sequence[Mapping[str, Any]] = (),
    **more: Any,
) -> dict[str, Any]:
    """The result of these items as JSON values; `more` are further keys.

    `left_out` are items that the protocol cannot use, each with its `file` and the `reason`.
    Rejected (NS0811) where there is no other.
    """
    if not items:
        reasons = dict.fromkeys(f"{entry['file']}: {entry['reason']}" for entry in left_out)
        raise rejected(
            "NS0811",
            f"protocol {protocol.name} can use nothing of this data",
            notes=tuple(list(reasons)[:_MOST_REASONS]),
            helps=("name a folder of other scenes, or bring these into the protocol's form",),
        )
    values = [number(item.metrics["psnr_db"]) for item in items]
    return {
        "schema": SCHEMA,
        "protocol": protocol.name,
        "protocol_sha256": protocol.sha256,
        "method": subject.method,
        "settings": subject.settings,
        "sees": subject.sees,
        "stage": "hard",
        "data": [stamp(path) for path in files],
        "data_range": protocol["data_range"],
        "domain": protocol["domain"],
        "items": [item.as_json() for item in items],
        **summary(values, [item.file for item in items]),
        "decoder_ms": subject.decoder_ms,
        "device": subject.device,
        "parameters": subject.parameters,
        "flops": subject.flops,
        "left_out": list(left_out),
        **more,
    }  # fmt: skip


def with_arrays(
    protocol: Protocol,
    subject: Subject,
    files: Sequence[Path],
    every: Sequence[Scored],
    left_out: Sequence[Mapping[str, Any]],
    **more: Any,
) -> tuple[dict[str, Any], dict[str, Array]]:
    """The same of what was scored, and what `--save` writes of every item, by name: the
    reconstruction, an `image` or a `video`, and the truth."""
    found = result(protocol, subject, files, [each.item for each in every], left_out, **more)
    called, arrays = labels(files), {}
    for item, made, truth, _ in every:
        place = [item.frame] if item.crop is None else item.crop
        label = "_".join([called[item.file], *map(str, place)])
        kind = "image" if truth.ndim == 2 else "video"
        arrays[f"{label}_{kind}"], arrays[f"{label}_truth"] = made, truth
    return found, arrays


def read_result(path: Path) -> dict[str, Any]:
    """A result that `nscc evaluate` wrote; Rejected (NS0807) for another file."""
    try:
        found = json.loads(read_whole(path))
        if isinstance(found, dict) and found.get("schema") == SCHEMA:
            if not isinstance(found.get("mean"), int | float | None):
                raise ValueError("its mean is no number")
            _ = [str(entry["sha256"]) for entry in found.get("data", ())]
            for item in found["items"]:
                if math.isnan(number(item["psnr_db"])):
                    raise ValueError("an item's PSNR is no number")
                _ = item["file"], item["crop"], item["frame"]
            return dict(found)
        reason = f"it has no schema {SCHEMA}"
    except OSError as error:
        reason = error.strerror or str(error)
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        reason = f"{type(error).__name__}: {' '.join(str(error).split())[:100]}"
    raise rejected(
        "NS0807",
        f"'{path}' is no result of nscc evaluate",
        notes=(reason,),
        helps=("`nscc evaluate ... -o OUT.json` writes one",),
    )


def mean_of(
    results: Sequence[Mapping[str, Any]], metric: str, *, by_source: bool = False
) -> float | None:
    """The mean of a metric over the items of each result, then over the results, which are seeds;
    items that are infinite are left out. `by_source`: over the means of the files, each of which
    counts once, however many items it has. None without a finite item."""
    means = []
    for found in results:
        values: dict[str, list[float]] = {}
        for item in found["items"]:
            value = number(item[metric])
            if math.isfinite(value):
                values.setdefault(str(item["file"]) if by_source else "", []).append(value)
        if values:
            means.append(float(np.mean([np.mean(part) for part in values.values()])))
    return float(np.mean(means)) if means else None


def compare(
    pairs: Sequence[tuple[dict[str, Any], dict[str, Any]]], metric: str = "psnr_db"
) -> dict[str, Any]:
    """How much better second results are than first ones in a metric of dB, item by item.

    Each pair is a seed; the bootstrap draws scenes, with their items of all seeds. Rejected
    (NS0808) across protocols, without common items, or where the metric is missing.
    """
    scores: tuple[dict[str, float], dict[str, float]] = ({}, {})
    scenes: dict[str, str] = {}
    for seed, pair in enumerate(pairs):
        _check_alike(pairs[0][0], *pair)
        # By what they are in other results too: file, corner of the crop, first frame.
        items = [
            {f"{each['file']} {each['crop']} {each['frame']}": each for each in found["items"]}
            for found in pair
        ]
        if not set(items[0]) & set(items[1]):
            raise rejected(
                "NS0808",
                "the results have no item in common",
                notes=("results are compared in pairs: the same crop or frame of the same file",),
                helps=("evaluate both on the same data",),
            )
        _check_metric(items, metric)
        for kept, part in zip(scores, items, strict=True):
            for key, item in part.items():
                kept[f"{seed} {key}"] = number(item[metric])
                scenes[f"{seed} {key}"] = str(item["file"])
    first, second = ([pair[k] for pair in pairs] for k in (0, 1))
    return {
        "protocol": first[0]["protocol"],
        "protocol_sha256": first[0]["protocol_sha256"],
        "metric": metric,
        "pairs": len(pairs),
        "first": _about(first),
        "second": _about(second),
        **paired(*scores, scenes),
    }


def _about(results: Sequence[dict[str, Any]]) -> dict[str, Any]:
    means = [found["mean"] for found in results if found.get("mean") is not None]
    mean = sum(means) / len(means) if means else None
    return {"method": results[0].get("method"), "mean": mean}


def _check_alike(*results: dict[str, Any]) -> None:
    for key, what in (("protocol", "protocols"), ("protocol_sha256", "versions of a protocol")):
        found = list(dict.fromkeys(str(result.get(key)) for result in results))
        if len(found) > 1:
            raise rejected(
                "NS0808",
                f"the results are of two {what}: {found[0]} and {found[1]}",
                notes=("a number without its protocol is no number: these do not compare",),
                helps=("evaluate both under one protocol",),
            )


def _check_metric(items: Sequence[dict[str, dict[str, Any]]], metric: str) -> None:
    held = (v.get(metric) for part in items for v in part.values())
    if any(not isinstance(v, int | float) and v != "inf" for v in held):
        known = sorted(k for k in next(iter(items[0].values())) if k.endswith("_db"))
        raise rejected(
            "NS0808",
            f"not every item of the results has the metric '{metric[:40]}'",
            notes=(f"the first has {', '.join(known)}",),
            helps=("name one of them with --metric",),
        )
