"""Charts of measurements: training curves of a run, results, the response of a sensor."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from nscc.chips.load import DEFAULT_NAME, load_target
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.pictures.sheet import head, look, panels
from nscc_runtime.sensor import load_sensor
from nscc_runtime.simulate import Request, simulate
from nscc_training.demo.expose import camera
from nscc_training.measures import METRIC_NAMES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_PANEL = (4.6, 3.2)
_MOST_SCENES = 24
_ELSEWHERE = "with another sensor or exposure"


def run_sheet(path: Path, result: dict[str, Any]) -> Figure:
    """Draw a run's training curves, and its scores under changed conditions."""
    with open(path / "metrics.csv", encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    changes, metric = _changes(result), _metric(result)
    figure, (learning, *change_axes) = panels(2 if changes else 1, _PANEL, 2)
    for number, split in enumerate(("train", "val")):
        scores = [(_number(r.get("step")), _number(r.get(metric))) for r in rows
                 if r.get("split") == split]  # fmt: skip
        points = [(step, value) for step, value in scores if step is not None and value is not None]
        if points:
            style = look().of(number)
            learning.plot(*zip(*points, strict=True), **style, label=split)
    learning.set_title("learning")
    learning.set_xlabel("step")
    learning.set_ylabel(METRIC_NAMES[metric])
    for axes in change_axes:
        _bars(axes, changes, _ELSEWHERE, metric)
    handles = learning.get_legend_handles_labels()[0]
    head(figure, path.name, f"{METRIC_NAMES[metric]}: training and validation", handles)
    return figure


def result_sheet(values: dict[str, Any], title: str) -> Figure:
    """Draw the scores of a run (`robustness`) or an evaluation (`items`), worst first."""
    changes, metric = _changes(values), _metric(values)
    if changes:
        figure, (axes,) = panels(1, _PANEL, 1)
        _bars(axes, changes, _ELSEWHERE, metric)
        head(figure, title, f"{METRIC_NAMES[metric]} of the scenes that the run was validated on")
        return figure
    scenes: dict[str, list[float]] = {}
    for item in values.get("items", []):
        value = _number(item.get(metric))
        if value is not None:
            scenes.setdefault(str(item.get("class", item.get("file"))), []).append(value)
    means = sorted((float(np.mean(scores)), name) for name, scores in scenes.items())
    figure, (axes,) = panels(1, (7.0, 0.9 + 0.24 * min(len(means), _MOST_SCENES)), 1)
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
    """Draw the response of a sensor to uniform light in one slot, and its standard deviation."""
    target = load_target(DEFAULT_NAME, Path())
    sensor = load_sensor(target, path)
    electrons = np.geomspace(10.0, 3 * sensor.full_well_e, target.cols)
    picture = np.empty((target.rows, target.cols), np.float32)
    picture[:] = electrons
    light = Light.of_still(picture, np.ones(1))
    request = Request(selected("all"), repeat=2)
    codes = simulate(camera(1, 1000.0), light, sensor, request).frame.frame[:, 0].astype(np.float64)
    figure, (response, scatter) = panels(2, _PANEL, 2)
    noise, fixed = (look().of(number)["color"] for number in (0, 1))
    response.plot(electrons, codes.mean(axis=(0, 1)), color=look().ink)
    response.set_title("response")
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
    places = range(len(values))
    axes.barh(places, list(values.values()), color=look().bar, height=0.6)
    axes.set_yticks(places, list(values))
    axes.invert_yaxis()
    axes.set_xlabel(METRIC_NAMES[metric])
    axes.set_title(title)


def _metric(values: dict[str, Any]) -> str:
    """Return the metric of a run's result or of an evaluation."""
    rows = (*(values.get("robustness") or ()), *(values.get("items") or ()))
    return "correct" if any("correct" in row for row in rows) else "psnr_db"


def _changes(result: dict[str, Any]) -> dict[str, float]:
    rows = result.get("robustness") or ()
    scores = {str(row["change"]): _number(row[_metric(result)]) for row in rows}
    return {name: value for name, value in scores.items() if value is not None}


def _number(value: object) -> float | None:
    try:
        number = float(str(value))
    except ValueError:
        return None
    return number if np.isfinite(number) else None
