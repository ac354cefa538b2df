"""The JSON that `nscc evaluate` writes, and the comparison of two of them."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any

from nscc.diagnostics.rejection import rejected
from nscc_training.measures import number
from nscc_training.protocols import Protocol
from nscc_training.statistics import paired, summary

SCHEMA = "nscc-result-1"
STAGES = ("soft", "hard", "compiled", "emulated")


@dataclass(frozen=True)
class Item:
    """One scored picture or frame: where it is from, and its metrics as JSON values."""

    file: str
    crop: list[int] | None
    frame: int | None
    metrics: dict[str, Any]

    @property
    def key(self) -> str:
        """The same item in another result: file, corner of the crop, first frame."""
        return f"{self.file} {self.crop} {self.frame}"

    def as_json(self) -> dict[str, Any]:
        """The item as one flat object."""
        return {"file": self.file, "crop": self.crop, "frame": self.frame, **self.metrics}


@dataclass(frozen=True)
class Subject:
    """What was evaluated: a method's name and settings, its stage and what it costs."""

    method: str
    settings: dict[str, Any]
    stage: str = "hard"
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
    **more: Any,
) -> dict[str, Any]:
    """The result of these items as JSON values; `more` are further keys."""
    values = [number(item.metrics["psnr_db"]) for item in items]
    return {
        "schema": SCHEMA,
        "protocol": protocol.name,
        "protocol_sha256": protocol.sha256,
        "method": subject.method,
        "settings": subject.settings,
        "sees": subject.sees,
        "stage": subject.stage,
        "data": [
            {"file": path.name, "sha256": sha256(path.read_bytes()).hexdigest()} for path in files
        ],
        "data_range": protocol["data_range"],
        "domain": protocol["domain"],
        "items": [item.as_json() for item in items],
        **summary(values, [item.file for item in items]),
        "decoder_ms": subject.decoder_ms,
        "device": subject.device,
        "parameters": subject.parameters,
        "flops": subject.flops,
        **more,
    }  # fmt: skip


def read_result(path: Path) -> dict[str, Any]:
    """A result that `nscc evaluate` wrote; Rejected (NS0807) for another file."""
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
        good = isinstance(found, dict) and found.get("schema") == SCHEMA
        if good:
            for item in found["items"]:
                number(item["psnr_db"])
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


def compare(
    first: dict[str, Any], second: dict[str, Any], metric: str = "psnr_db"
) -> dict[str, Any]:
    """How much better the second result is in a metric of dB, item by item.

    Rejected (NS0808) across protocols, without common items, or where the metric is missing.
    """
    for key, what in (("protocol", "protocols"), ("protocol_sha256", "versions of a protocol")):
        if first.get(key) != second.get(key):
            raise rejected(
                "NS0808",
                f"the results are of two {what}: {first.get(key)} and {second.get(key)}",
                notes=("a number without its protocol is no number: these do not compare",),
                helps=("evaluate both under one protocol",),
            )
    items = [_by_key(found) for found in (first, second)]
    if not set(items[0]) & set(items[1]):
        raise rejected(
            "NS0808",
            "the results have no item in common",
            notes=("results are compared in pairs: the same crop or frame of the same file",),
            helps=("evaluate both on the same data",),
        )
    held = (v.get(metric) for part in items for v in part.values())
    if any(not isinstance(v, int | float) and v != "inf" for v in held):
        known = sorted(k for k in next(iter(items[0].values())) if k.endswith("_db"))
        raise rejected(
            "NS0808",
            f"not every item of the results has the metric '{metric[:40]}'",
            notes=(f"the first has {', '.join(known)}",),
            helps=("name one of them with --metric",),
        )
    scenes = {k: str(v["file"]) for part in items for k, v in part.items()}
    scores = [{k: number(v[metric]) for k, v in part.items()} for part in items]
    return {
        "protocol": first["protocol"],
        "protocol_sha256": first["protocol_sha256"],
        "metric": metric,
        "first": {"method": first.get("method"), "mean": first.get("mean")},
        "second": {"method": second.get("method"), "mean": second.get("mean")},
        **paired(scores[0], scores[1], scenes),
    }


def _by_key(found: dict[str, Any]) -> dict[str, dict[str, Any]]:
    items = {}
    for item in found["items"]:
        items[f"{item['file']} {item['crop']} {item['frame']}"] = item
    return items
