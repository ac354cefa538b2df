"""The JSON results of `nscc evaluate`, their text, and their comparison."""

from __future__ import annotations

import json
import math
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from pathlib import Path
from typing import Any, NamedTuple, Self

import numpy as np

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, rejected
from nscc.experiment_store import ExperimentStore
from nscc.files import Product, read_whole
from nscc.mappings import JsonObject
from nscc.program.problems import counted
from nscc_runtime.progress import Progress, unseen
from nscc_training.experiments.engine import Done, PointRow, results, rows_in
from nscc_training.measures import number, paired, stamp, summary
from nscc_training.metrics import finite_mean
from nscc_training.problems import one_line
from nscc_training.protocol_scenes.file_scenes import scenes_in
from nscc_training.protocol_scenes.protocol_scene import Item, ProtocolScene, Unusable
from nscc_training.protocols import Protocol
from nscc_training.scene_files import labels, names_of

SCHEMA = "nscc-result-1"
_MEANS = ("psnr_db", "ssim", "mu_psnr_db", "pu21_psnr_db")
"""Metrics of hdr-v1 that are also reported at other fractions of saturated pixels."""
_MOST_REASONS = 5
"""Most reasons in the message that no scene can be used."""


class Scored(NamedTuple):
    """A scene, its items with their scores (JSON values), its reconstruction in the form that is
    scored, and the seconds of decoding it.

    The reconstruction is None if the scores were stored by an earlier process."""

    scene: ProtocolScene
    items: list[Item]
    reconstruction: Array | None
    seconds: float


class ScoredMethod(NamedTuple):
    """What was scored, for the result: its name, its settings as JSON values, what it `sees` (such
    as "capture"), the milliseconds of decoding a scene (None if unknown), and of a network its
    device, the number of its parameters, and its operations a scene (None if unknown)."""

    name: str
    settings: JsonObject
    sees: str = "capture"
    decoder_ms: float | None = None
    device: str = "cpu"
    parameters: int = 0
    flops: int | None = None


class Evaluated(NamedTuple):
    """The result of scored scenes as JSON values, and the arrays of `--save` by name."""

    result: JsonObject
    arrays: dict[str, Array]


def usable_scenes(
    candidates: Iterable[ProtocolScene | Unusable], protocol: Protocol
) -> tuple[list[ProtocolScene | None], list[JsonObject]]:
    """Return those of `candidates` that are scenes, not `Unusable`, and entries of the result for
    the others (`file`, place, `reason`).

    A scene's index in the list seeds its noise. Therefore None keeps the place of the others in the
    list, except under hdr-v1, where the list has usable crops only. A file that cannot be read is
    such an entry, with the `code` of its error; raises Rejected if only such files remain."""
    scenes: list[ProtocolScene | None] = []
    left_out: list[JsonObject] = []
    damages: list[Diagnostic] = []
    for scene in candidates:
        if isinstance(scene, ProtocolScene):
            scenes.append(scene)
            continue
        code = {} if scene.damage is None else {"code": scene.damage.code}
        left_out.append(
            {"file": scene.file.as_posix(), **scene.place, "reason": scene.reason, **code}
        )
        if scene.damage is not None:
            damages.append(scene.damage)
            # Frames before the damage of a file do not count.
            scenes = [s for s in scenes if s is None or s.file != scene.file]
        elif not protocol.still:
            scenes.append(None)
    if damages and not any(scenes):
        raise Rejected(damages, status=2)
    return scenes, left_out


def damaged_files(result: Mapping[str, Any]) -> list[Diagnostic]:
    """Return an error for each file that `result` left out because it cannot be read. Files that
    were left out for other reasons have no error."""
    help_text = "repair or remove the file, then the same command scores all files"
    return [
        Diagnostic(entry["code"], entry["reason"], helps=(help_text,))
        for entry in result["left_out"]
        if "code" in entry
    ]


class Scorer:
    """Decodes and scores scenes, and keeps the scores in a store, so that they are not computed
    again.

    `open_store` opens the store when the first score is needed; by default it is in memory. `track`
    receives the scenes and may show progress."""

    def __init__(
        self, open_store: Callable[[], ExperimentStore] = ExperimentStore, track: Progress = unseen
    ) -> None:
        """Begin without results. `open_store` is called when the first score is needed."""
        self._open_store, self._track, self._passes = open_store, track, 0

    @cached_property
    def store(self) -> ExperimentStore:
        """The store of results; opened at first use."""
        return self._open_store()

    def scored(
        self,
        scenes: Iterable[ProtocolScene | None],
        decode: Callable[[ProtocolScene, int], tuple[Array, float]],
    ) -> list[Scored]:
        """Decode and score every scene, and return the results in this order; None is left out.

        `decode` takes a scene and its index in `scenes`, which seeds the noise, and returns
        electrons and seconds. Raises Rejected (NS0804) for a reconstruction with values that are
        not finite."""
        self._passes += 1
        # Scenes keep their index, which selects their noise, when others are left out.
        tasks = [
            _SceneTask(self._passes, index, scene)
            for index, scene in enumerate(scenes)
            if scene is not None
        ]
        reconstructions: dict[str, Array] = {}

        def execute(tasks: Iterable[_SceneTask]) -> Iterator[Done]:
            """Decode and score the scene of each of the `tasks`, and yield its row. The
            reconstruction is put into `reconstructions` by the task's key."""
            for task in tasks:
                result_e, seconds = decode(task.scene, task.index)
                _refuse_non_finite(result_e, task.scene.file.as_posix())
                reconstructions[task.key] = task.scene.result(result_e).astype(np.float32)
                items = task.scene.items(result_e)
                yield Done(task, PointRow(task.key, {"items": items, "seconds": seconds}))

        # The loop computes and stores all rows; its items are not needed.
        for _ in self._track(results(self.store, tasks, execute), "scoring", len(tasks)):
            pass
        rows = rows_in(self.store)
        return [
            Scored(
                task.scene, reconstruction=reconstructions.get(task.key), **rows[task.key].figures
            )
            for task in tasks
        ]

    def __enter__(self) -> Self:
        """Return the scorer, whose store is closed at the end of the `with` block."""
        return self

    def __exit__(self, *raised: Any) -> None:
        """Close the store if it was opened."""
        if "store" in vars(self):
            self.store.__exit__(*raised)


@dataclass(frozen=True, eq=False)
class _SceneTask:
    """One scene to decode and score. `index` is its place in the list of scenes, and `number`
    counts the calls of `Scorer.scored`. Its key in the store names both, and file, crop and frame.
    """

    number: int
    index: int
    scene: ProtocolScene

    @property
    def label(self) -> str:
        """The task as text, which is also its key."""
        scene = self.scene
        return f"{self.number}, {self.index}: {scene.file} {scene.crop} {scene.frame}"

    key = label


def _refuse_non_finite(result_e: Array, name: str) -> None:
    """Raise Rejected (NS0804) if the reconstruction `result_e`, of any shape, contains NaN or
    infinity; `name` names the scene."""
    bad_count = int(np.count_nonzero(~np.isfinite(result_e)))
    if bad_count:
        raise rejected(
            "NS0804",
            f"{bad_count} of {result_e.size} values of the reconstruction of '{name}' are not "
            "finite",
            notes=("PSNR and SSIM of such values are meaningless",),
            helps=("check the decoder and its weights, which are the source of NaN and infinity",),
            data={"count": bad_count},
        )


def mean_score(scored_scenes: Sequence[Scored], metric: str) -> float:
    """Return the mean of a metric in dB over the items of all scenes. Infinite values are left out
    unless all are; without items it is -inf, so that any other is better."""
    scores = [number(item[metric]) for entry in scored_scenes for item in entry.items]
    return finite_mean(scores) if scores else -math.inf


def also_saturated(
    files: Sequence[Path],
    protocol: Protocol,
    decoded: Callable[[list[ProtocolScene | None]], list[Scored]],
) -> JsonObject:
    """Return the mean scores with other fractions of saturated pixels, under the key
    `also_saturated` of a result. The dictionary is empty if the protocol names no other fractions.

    `decoded` scores a list of scenes, in which None stands for one that cannot be used."""
    rows = []
    for fraction in protocol.values.get("also_saturated", ()):
        usable, left_out = usable_scenes(scenes_in(files, protocol, fraction), protocol)
        scored_scenes = decoded(usable)
        means = {f"mean_{name}": mean_score(scored_scenes, name) for name in _MEANS}
        rows.append(
            {
                "saturated_fraction": fraction,
                "crops": len(usable),
                "crops_left_out": len(left_out),
                **{name: value if math.isfinite(value) else None for name, value in means.items()},
            }
        )
    return {"also_saturated": rows} if rows else {}


def result_of(
    protocol: Protocol,
    method: ScoredMethod,
    files: Sequence[Path],
    scored_scenes: Sequence[Scored],
    left_out: Sequence[Mapping[str, Any]],
    **extra_keys: Any,
) -> Evaluated:
    """Return the result of the scenes that `method` was scored on.

    Its arrays are the reconstruction of each item, an `image` or a `video`, and its ground truth.
    `left_out` lists the items that the protocol cannot use, each with `file` and `reason`. `files`
    are all files of scenes, whose digests are stored. `extra_keys` become further entries of the
    result. Raises Rejected (NS0811) without items."""
    items = [item for entry in scored_scenes for item in entry.items]
    if not items:
        reasons = dict.fromkeys(f"{entry['file']}: {entry['reason']}" for entry in left_out)
        raise rejected(
            "NS0811",
            f"protocol {protocol.name} cannot use any of this data",
            notes=tuple(list(reasons)[:_MOST_REASONS]),
            helps=("name a folder with other scenes, or convert these to the protocol's form",),
        )
    values = [number(item[protocol.metrics[0]]) for item in items]
    names = names_of(files)
    report = {
        "schema": SCHEMA,
        "protocol": protocol.name,
        "protocol_sha256": protocol.sha256,
        "method": method.name,
        "settings": method.settings,
        "sees": method.sees,
        "stage": "hard",
        "data": [{**stamp(path), "file": names[path].as_posix()} for path in files],
        "data_range": protocol["data_range"],
        "domain": protocol["domain"],
        "items": items,
        **summary(values, [item["file"] for item in items])._asdict(),
        "decoder_ms": method.decoder_ms,
        "device": method.device,
        "parameters": method.parameters,
        "flops": method.flops,
        "left_out": list(left_out),
        **extra_keys,
    }  # fmt: skip
    called, arrays = labels(names.values()), {}
    for scene, _, reconstruction, _ in scored_scenes:
        if reconstruction is None:
            continue
        place = [*(scene.crop or ()), *([] if scene.frame is None else [scene.frame])]
        label = "_".join([called.get(scene.file, scene.file.as_posix()), *map(str, place)])
        truth = scene.truth_e
        kind = ("class", "image", "video")[truth.ndim - 1]
        arrays[f"{label}_{kind}"] = reconstruction
        arrays[f"{label}_truth"] = truth if truth.dtype == np.uint8 else truth.astype(np.float32)
    return Evaluated(report, arrays)


def read_result(path: Path) -> JsonObject:
    """Return the result of `nscc evaluate` in file `path`. Raise Rejected (NS0807) for a file that
    cannot be read or is not a result."""
    try:
        document = json.loads(read_whole(path))
        if isinstance(document, dict) and document.get("schema") == SCHEMA:
            if not isinstance(document.get("mean"), int | float | None):
                raise ValueError("its mean is not a number")
            _ = [str(entry["sha256"]) for entry in document.get("data", ())]
            for item in document["items"]:
                if math.isnan(number(item[score_of(document)])):
                    raise ValueError("the score of an item is not a number")
                _ = item["file"], item["crop"], item["frame"]
            return dict(document)
        reason = f"it has no schema {SCHEMA}"
    except OSError as error:
        reason = error.strerror or str(error)
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        reason = f"{type(error).__name__}: {one_line(error, 100)}"
    raise rejected(
        "NS0807",
        f"'{path}' is not a result of nscc evaluate",
        notes=(reason,),
        helps=("`nscc evaluate ... -o OUT.json` writes one",),
    )


def score_of(result_values: Mapping[str, Any]) -> str:
    """Return the metric whose mean is the score of a result: "correct" if it names classes, else
    "psnr_db"."""
    classified = any("correct" in item for item in result_values["items"])
    return "correct" if classified else "psnr_db"


def mean_of(
    results: Sequence[Mapping[str, Any]], metric: str, *, by_source: bool = False
) -> float | None:
    """Return the mean of a metric over the items of each result, then over results (seeds); None if
    no item is finite. Every item has the metric.

    Infinite items are left out. `by_source` first averages the items of each file, so that each
    file counts once."""
    means = []
    for result_values in results:
        values: dict[str, list[float]] = {}
        for item in result_values["items"]:
            value = number(item[metric])
            if math.isfinite(value):
                values.setdefault(str(item["file"]) if by_source else "", []).append(value)
        if values:
            means.append(float(np.mean([np.mean(file_values) for file_values in values.values()])))
    return float(np.mean(means)) if means else None


def compare(pairs: Sequence[tuple[JsonObject, JsonObject]], metric: str = "psnr_db") -> JsonObject:
    """Return the gain of second results over first results, item by item, as JSON values: the
    entries of `paired`, and what the results are.

    Each of `pairs` is a first and a second result for one seed; there is at least one. Scores are
    of the metric `metric`; the bootstrap draws scenes, with their items of all seeds. Raises
    Rejected (NS0808) for different protocols, without common items, or without the metric."""
    scores: tuple[dict[str, float], dict[str, float]] = ({}, {})
    scenes: dict[str, str] = {}
    for seed, pair in enumerate(pairs):
        _check_alike(pairs[0][0], *pair)
        # Items are matched by file, corner of the crop and first frame.
        items = [
            {f"{item['file']} {item['crop']} {item['frame']}": item for item in result["items"]}
            for result in pair
        ]
        if not set(items[0]) & set(items[1]):
            raise rejected(
                "NS0808",
                "the results have no common item",
                notes=("results are compared in pairs: the same crop or frame of the same file",),
                helps=("evaluate both on the same data",),
            )
        metric_values = (v.get(metric) for items_by_key in items for v in items_by_key.values())
        if any(not isinstance(v, int | float) and v != "inf" for v in metric_values):
            known = sorted(k for k in next(iter(items[0].values())) if k.endswith("_db"))
            raise rejected(
                "NS0808",
                f"not every item of the results has the metric '{metric[:40]}'",
                notes=(f"the first has {', '.join(known)}",),
                helps=("name one of them with --metric",),
            )
        for pair_scores, items_by_key in zip(scores, items, strict=True):
            for key, item in items_by_key.items():
                pair_scores[f"{seed} {key}"] = number(item[metric])
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


def _about(results: Sequence[JsonObject]) -> JsonObject:
    """Return the `method` of results and the `mean` of their scores over seeds, as JSON values."""
    means = [entry["mean"] for entry in results if entry.get("mean") is not None]
    mean = sum(means) / len(means) if means else None
    return {"method": results[0].get("method"), "mean": mean}


def _check_alike(*results: JsonObject) -> None:
    """Raise Rejected (NS0808) if results belong to different protocols, or to different versions of
    one."""
    for key, plural_name in (
        ("protocol", "protocols"),
        ("protocol_sha256", "versions of a protocol"),
    ):
        values = list(dict.fromkeys(str(result.get(key)) for result in results))
        if len(values) > 1:
            raise rejected(
                "NS0808",
                f"the results belong to two {plural_name}: {values[0]} and {values[1]}",
                notes=("results of different protocols cannot be compared",),
                helps=("evaluate both under one protocol",),
            )


def result_json(result: Any) -> str:
    """Return a result as JSON text."""
    return json.dumps(result, indent=2, allow_nan=False) + "\n"


def arrays_in(folder: Path, arrays: Mapping[str, Array]) -> dict[Path, Product]:
    """Return the content of the files of the option --save by path: one NAME.npy in `folder` for
    each of `arrays`. The folder is created; files are not written."""
    folder.mkdir(parents=True, exist_ok=True)
    return {folder / f"{name}.npy": partial(np.save, arr=array) for name, array in arrays.items()}


def result_text(result: JsonObject) -> str:
    """Return a result as text for people: method and protocol, scores by file or class, what was
    left out, mean with its interval, and decoding time."""
    lines = [
        f"{result['method']}, protocol {result['protocol']} ({result['protocol_sha256'][:12]})"
    ]
    if effects := result["settings"].get("effects"):
        trained = result["settings"].get("trained_effects")
        lines.append(f"  on a chip with effects {effects}")
        if trained is not None:
            lines[-1] += f"; trained with {trained or 'noise and full well alone'}"
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
            # Results of earlier versions have no cross-entropy.
            if all("cross_entropy" in item for item in result["items"]):
                lines[-1] += f", cross-entropy {mean_of([result], 'cross_entropy'):.3f}"
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
    """Return a line for each file among `items`, with its mean PSNR and SSIM and the number of its
    items. Infinite PSNR is left out."""
    lines = []
    for file in dict.fromkeys(item["file"] for item in items):
        file_items = [item for item in items if item["file"] == file]
        finite = [item["psnr_db"] for item in file_items if item["psnr_db"] != "inf"]
        mean = f"{sum(finite) / len(finite):.2f} dB" if finite else "inf"
        ssim = sum(item["ssim"] for item in file_items) / len(file_items)
        lines.append(f"  {file:32} {mean}, SSIM {ssim:.4f}, {counted(len(file_items), 'item')}")
    return lines


def _class_lines(items: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return a line for each class among `items`: how often it was decoded correctly, and, if it
    ever was, the class for which it is most often mistaken."""
    lines = []
    for label in dict.fromkeys(item["class"] for item in items):
        decoded = Counter(item["decoded"] for item in items if item["class"] == label)
        count, correct = decoded.total(), decoded.pop(label, 0)
        mistaken = decoded.most_common(1)
        remark = f", {mistaken[0][1]} for {mistaken[0][0]}" if mistaken else ""
        lines.append(f"  {label:32} {correct / count:.1%} of {count} correct{remark}")
    return lines


def comparison_text(comparison: Mapping[str, Any], metric: str) -> str:
    """Return a line about a comparison that `compare` returned: the gain of the second result over
    the first in the `metric`, its 95 % interval, and the numbers of items, scenes and seeds.
    Without a pair of finite scores, the line says only that."""
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
