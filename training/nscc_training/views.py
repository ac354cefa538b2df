"""Pictures of nscc's files: frames, reconstructions, and charts of runs, results and sensors.

Programs are drawn by `nscc_runtime.pictures.shutter_sheet`."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from nscc.arrays import Array
from nscc.chips.load import DEFAULT_NAME, load_target
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.files import read_whole, reads
from nscc.mappings import JsonObject
from nscc.npy import MOST_BYTES, InvalidArrays, npz_arrays
from nscc_runtime.effects import selected
from nscc_runtime.formats import Content
from nscc_runtime.formats.content import content_sheet
from nscc_runtime.frame_arrays import checked_meta, frame_meta
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.pictures.images import Image, image_plane_sheet, image_sheet
from nscc_runtime.pictures.sheet import head, panels, png_of, theme
from nscc_runtime.pictures.tone import fitted
from nscc_runtime.request import Request
from nscc_runtime.scenes.picture_files import CLIPS, PICTURES, open_pages, read_frames
from nscc_runtime.sensor import load_sensor
from nscc_runtime.simulate import simulate
from nscc_training.design.bracket import camera
from nscc_training.measures import METRIC_NAMES
from nscc_training.problems import one_line
from nscc_training.run_files import run_path
from nscc_training.scene_files import light_in

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MOST_FRAMES = 64
"""Most frames of a clip that are drawn."""
_MOST_DRAWN_PIXELS = 1 << 22
_MOST_FRAME_PIXELS = 1 << 20
"""Most pixels of each drawn frame of a clip, because all frames are in memory."""
_MOST_DRAWN_BYTES = 1 << 28
_FRAME_KEYS = ("frame", "exposure_e", "saturated_by")


def view_of(path: Path, tone: str | None = None) -> bytes:
    """Return the PNG of a frame file or reconstruction (.npz), a picture, a clip, a run folder, or
    a result (.json) or sensor (.toml) file.

    `tone` names a tone curve for light; None takes the usual one of the kind of file. Raises
    Rejected: NS0801 for another file, and the errors of the readers for damaged files."""
    folder = run_path(path)
    if folder.is_dir():
        if not (folder / "metrics.csv").is_file():
            raise _nothing_to_view(
                path, "it is a folder without metrics.csv, not a run of nscc train"
            )
        reads(folder / "metrics.csv")
        result = folder / "result.json"
        result_values = _json(result) if result.is_file() else {}
        return _drawn(path, run_sheet, folder, result_values)
    suffix = path.suffix.lower()
    if not path.is_file():
        raise _nothing_to_view(path, "the file does not exist")
    reads(path)
    if suffix == ".toml":
        return png_of(sensor_sheet, path)
    if suffix == ".json":
        result_values = _json(path)
        if not ("robustness" in result_values or "items" in result_values):
            raise _nothing_to_view(
                path, "it has no items and no robustness, so it is not a result of nscc"
            )
        return _drawn(path, result_sheet, result_values, path.name)
    if suffix == ".npz":
        return _of_arrays(path, tone)
    if suffix not in PICTURES + CLIPS:
        raise _nothing_to_view(path, f"the ending '{suffix}' cannot be viewed")
    pages = open_pages(path)
    moving = pages.count > 1 or pages.is_clip
    most = _MOST_FRAME_PIXELS if moving else _MOST_DRAWN_PIXELS
    frames = read_frames(path) if moving else pages.read()
    stored = [_reduced(frame, most) for frame in islice(frames, _MOST_FRAMES)]
    # Light is drawn with a logarithmic curve, pictures for display as they are.
    linear = pages.colours.transfer == "linear" or stored[0].dtype.kind == "f"
    clip = np.stack([light_in(f, "linear" if linear else pages.colours) for f in stored])
    usual, unit = ("log", "e") if linear else ("srgb", "")
    content = Content({}, clip if moving else clip[0], moving, tone=tone, usual=usual, unit=unit)
    return png_of(content_sheet, content, path.name)


def _of_arrays(path: Path, tone: str | None) -> bytes:
    """Return the PNG of the .npz file at `path`: a frame file, or a file with an array `image` or
    `video`.

    `tone` names the tone curve, None takes the usual one. Raises Rejected (NS0801) for other files.
    """
    try:
        _, array_names = npz_arrays(path, lambda _: False)
        most_bytes = MOST_BYTES if "frame" in array_names else _MOST_DRAWN_BYTES
        arrays, _ = npz_arrays(path, _is_drawn, most_bytes)
        meta = frame_meta(arrays)
        if meta is not None and "frame" in arrays:
            checked_meta(arrays)
            return png_of(frame_view, arrays, meta, path.name, tone)
    except (InvalidArrays, OSError) as error:
        raise _nothing_to_view(path, str(error)) from error
    for name in ("image", "video"):
        if name in arrays:
            values, moving = arrays[name], name == "video"
            dimensions = (3, 4) if moving else (2, 3)
            if not (values.dtype.kind in "buif" and values.ndim in dimensions and values.size):
                shown = " x ".join(map(str, values.shape)) or "a single value"
                raise _nothing_to_view(path, f"its array '{name}' is {shown} of {values.dtype}")
            light = values if moving else _reduced(values)
            colour = light.ndim == (4 if moving else 3)
            content = Content(
                {}, light, moving, colour, tone=tone, usual="srgb" if moving else "log"
            )
            return png_of(content_sheet, content, path.name)
    names = ", ".join(sorted(array_names)[:8]) or "nothing"
    raise _nothing_to_view(path, f"it is not a frame file and has no image or video, but {names}")


def _reduced(picture: Array, most: int = _MOST_DRAWN_PIXELS) -> Array:
    """Return a picture (rows, cols, [3]) reduced to at most `most` pixels by means over areas, in
    uint8 or uint16 as stored, else float32; a smaller one is returned as it is."""
    import cv2

    rows, cols = picture.shape[:2]
    share = (most / (rows * cols)) ** 0.5
    if share >= 1:
        return picture
    # OpenCV resizes these two integer types, but not all others.
    picture_values = (
        picture if picture.dtype in (np.uint8, np.uint16) else picture.astype(np.float32)
    )
    shape = max(1, int(cols * share)), max(1, int(rows * share))
    return np.asarray(cv2.resize(picture_values, shape, interpolation=cv2.INTER_AREA))


def _drawn(path: Path, sheet: Callable[..., Figure], *arguments: Any) -> bytes:
    """Return the PNG of the figure that `sheet` draws from `arguments`, which were read from the
    file `path`.

    Raises Rejected (NS0801) if their content cannot be drawn."""
    try:
        return png_of(sheet, *arguments)
    except (csv.Error, AttributeError, LookupError, TypeError, ValueError) as error:
        raise _nothing_to_view(path, f"it is damaged: {type(error).__name__}: {error}") from error


def frame_view(arrays: dict[str, Array], meta: JsonObject, title: str, tone: str | None) -> Figure:
    """Draw each bucket of a frame file: codes, electrons and saturated pixels, or if it has them,
    images, planes and events.

    `arrays` and `meta` are the content of the file, and `tone` names the tone curve of electrons,
    None takes a linear one. `title` is written above. Of repeated frames the first is drawn, of
    colours all."""
    missing = np.zeros(arrays["frame"].shape)
    frame, exposure, marks = (arrays.get(key, missing) for key in _FRAME_KEYS)
    # Only frames of programs that compute images, planes or events have an array `margin`.
    if "margin" in arrays:
        told = {key: values for key, values in arrays.items() if key not in (*_FRAME_KEYS, "meta")}
        pictured = Frame(frame, exposure, np.isfinite(exposure), marks, told=told)
        names = meta.get("buckets")
        return image_plane_sheet(pictured.first, names if isinstance(names, list) else [], title)
    if frame.ndim == 4 and "colours" not in meta:
        frame, exposure, marks = frame[0], exposure[0], marks[0]
    names = meta.get("colours") or meta.get("buckets")
    names = names if isinstance(names, list) else []
    rows = []
    flat = (values.reshape(-1, *values.shape[-2:]) for values in (frame, exposure, marks))
    for k, (codes, electrons, saturated_by) in enumerate(zip(*flat, strict=True)):
        name = f"{names[k]}: " if k < len(names) else ""
        curve = fitted(tone or "linear", electrons)
        share = np.count_nonzero(saturated_by) / saturated_by.size
        rows.append(
            [
                Image(codes, f"{name}as read out", "codes of the converter"),
                Image(
                    curve(electrons), f"{name}electrons", f"{curve.name}, white {curve.white:.4g} e"
                ),
                Image(
                    np.where(saturated_by != 0, 255, 0),
                    f"{name}saturated",
                    f"{share:.1%} of the pixels",
                ),
            ]
        )
    return image_sheet(rows, title)


def _is_drawn(name: str) -> bool:
    """Return whether a picture of a file shows the array `name`."""
    prefixes = ("image_", "plane_", "report_events_")
    return name in (*_FRAME_KEYS, "meta", "image", "video", "margin") or name.startswith(prefixes)


def _json(path: Path) -> JsonObject:
    """Return the object in a JSON file. Raise Rejected (NS0801) if it cannot be read or holds
    another kind of value."""
    try:
        document = json.loads(read_whole(path))
    except (OSError, ValueError, RecursionError) as error:
        raise _nothing_to_view(path, str(error)) from error
    if not isinstance(document, dict):
        raise _nothing_to_view(path, "it is not a result of nscc")
    return document


def _nothing_to_view(path: Path, reason: str) -> Rejected:
    """Return the error (NS0801) that the file `path` cannot be drawn, because of `reason`."""
    return rejected(
        "NS0801",
        f"cannot view '{path}': {one_line(reason)}",
        notes=(
            "nscc views programs, frames, reconstructions, pictures, clips, run folders, "
            "results and sensors",
        ),
        helps=("name a .nsl, .icw, .npz, .json, .toml, a picture, a clip or a run folder",),
    )


_PANEL = (4.6, 3.2)
_MOST_SCENES = 24
_ELSEWHERE = "with another sensor or exposure"


def run_sheet(path: Path, result: JsonObject) -> Figure:
    """Draw the training and validation scores of the run in the folder `path` over its steps, and
    its scores under changed conditions.

    `result` is the content of its `result.json`, or empty: then only the curves of `metrics.csv`
    are drawn. Cells that are no finite numbers are left out."""
    with open(path / "metrics.csv", encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    changes, metric = _changes(result), _metric(result)
    figure, (learning, *change_axes) = panels(2 if changes else 1, size=_PANEL, columns=2)
    for number, split in enumerate(("train", "val")):
        scores = [
            (_number(r.get("step")), _number(r.get(metric)))
            for r in rows
            if r.get("split") == split
        ]
        points = [(step, value) for step, value in scores if step is not None and value is not None]
        if points:
            style = theme().of(number)
            learning.plot(*zip(*points, strict=True), **style, label=split)
    learning.set_title("learning")
    learning.set_xlabel("step")
    learning.set_ylabel(METRIC_NAMES[metric])
    for axes in change_axes:
        _bars(axes, changes, _ELSEWHERE, metric)
    handles = learning.get_legend_handles_labels()[0]
    head(figure, path.name, f"{METRIC_NAMES[metric]}: training and validation", handles)
    return figure


def result_sheet(values: JsonObject, title: str) -> Figure:
    """Draw the scores of a run under changed conditions (`robustness`), or the mean scores of an
    evaluation by file or class (`items`), the worst first.

    At most `_MOST_SCENES` bars are drawn. `values` is the content of a result file, and `title` is
    written above."""
    changes, metric = _changes(values), _metric(values)
    if changes:
        figure, (axes,) = panels(1, size=_PANEL, columns=1)
        _bars(axes, changes, _ELSEWHERE, metric)
        head(figure, title, f"{METRIC_NAMES[metric]} of the scenes that the run was validated on")
        return figure
    scenes: dict[str, list[float]] = {}
    for item in values.get("items", []):
        value = _number(item.get(metric))
        if value is not None:
            scenes.setdefault(str(item.get("class", item.get("file"))), []).append(value)
    means = sorted((float(np.mean(scores)), name) for name, scores in scenes.items())
    figure, (axes,) = panels(1, size=(7.0, 0.9 + 0.24 * min(len(means), _MOST_SCENES)), columns=1)
    _bars(
        axes,
        {name: value for value, name in means[:_MOST_SCENES]},
        f"means by {'class' if metric == 'correct' else 'file'}, the worst first",
        metric,
    )
    note = f"protocol {values.get('protocol')}: PSNR in {values.get('domain')}"
    if metric == "correct":
        note = f"protocol {values.get('protocol')}"
    head(figure, title, note)
    return figure


def sensor_sheet(path: Path) -> Figure:
    """Draw the mean converter code over uniform light in one slot of 1 ms. Draw also the scatter of
    codes from frame to frame and from pixel to pixel.

    `path` is a sensor file. The emulator exposes two frames whose columns have increasing light."""
    target = load_target(DEFAULT_NAME, Path())
    sensor = load_sensor(target, path)
    electrons = np.geomspace(10.0, 3 * sensor.full_well_e, target.cols)
    picture = np.empty((target.rows, target.cols), np.float32)
    picture[:] = electrons
    light = Light.of_still(picture, np.ones(1))
    request = Request(selected("all"), repeat=2)
    codes = (
        simulate(camera(slots=1, slot_us=1000.0), light, sensor, request)
        .frame.frame[:, 0]
        .astype(np.float64)
    )
    figure, (response, scatter) = panels(2, size=_PANEL, columns=2)
    noise, fixed = (theme().of(number)["color"] for number in (0, 1))
    response.plot(electrons, codes.mean(axis=(0, 1)), color=theme().ink)
    response.set_title("response")
    # The difference of two frames has twice the variance of one.
    temporal = np.sqrt(np.mean(np.diff(codes, axis=0)[0] ** 2, axis=0) / 2)
    pattern = codes.mean(axis=0).std(axis=0)
    scatter.plot(electrons, temporal, color=noise, label="of a pixel from frame to frame")
    scatter.plot(electrons, pattern, color=fixed, label="from pixel to pixel, mean of two frames")
    scatter.set_title("scatter")
    for axes in (response, scatter):
        axes.set_xscale("log")
        axes.set_xlabel("electrons in one slot of 1 ms")
        axes.set_ylabel("codes")
    note = (
        f"open in one slot; full well {sensor.full_well_e:g} e, "
        f"{sensor.electrons_per_lsb:.4g} e a code"
    )
    head(figure, path.name, note, scatter.get_legend_handles_labels()[0])
    return figure


def _bars(axes: Axes, values: dict[str, float], title: str, metric: str) -> None:
    """Draw horizontal bars of `values` by name, the first at the top. `metric` is "psnr_db" or
    "correct" and labels the axis."""
    positions = range(len(values))
    axes.barh(positions, list(values.values()), color=theme().bar, height=0.6)
    axes.set_yticks(positions, list(values))
    axes.invert_yaxis()
    axes.set_xlabel(METRIC_NAMES[metric])
    axes.set_title(title)


def _metric(values: JsonObject) -> str:
    """Return the metric to draw: "correct" for a run or an evaluation with classes, else
    "psnr_db"."""
    rows = (*(values.get("robustness") or ()), *(values.get("items") or ()))
    return "correct" if any("correct" in row for row in rows) else "psnr_db"


def _changes(result: JsonObject) -> dict[str, float]:
    """Return the scores of a run, in its metric, by the name of the changed condition; empty if
    `result` has none. Infinite scores are left out, and of equal names the last counts."""
    rows = result.get("robustness") or ()
    scores = {str(row["change"]): _number(row[_metric(result)]) for row in rows}
    return {name: value for name, value in scores.items() if value is not None}


def _number(value: object) -> float | None:
    """Return a finite number from `value`, a cell of a table as text or a number; None for other
    text, an infinity or NaN."""
    try:
        number = float(str(value))
    except ValueError:
        return None
    return number if np.isfinite(number) else None
