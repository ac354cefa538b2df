"""The training curves of a run as a notebook shows them."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from nscc import html
from nscc_training.measures import METRIC_NAMES

_WIDTH, _HEIGHT, _LEFT, _TOP, _BELOW = 350.0, 130.0, 66.0, 20.0, 20.0


def curve_chart(curves: Mapping[str, NDArray[np.float64]]) -> html.Html:
    """Return charts of the validation PSNR and of the training loss over the steps."""
    val = curves["split"] == 1
    metric = "correct" if "correct" in curves else "psnr_db"
    return html.side_by_side(
        _chart(title, curves["step"][rows], curves[name][rows], colour)
        for title, name, rows, colour in (
            (f"validation {METRIC_NAMES[metric]}", metric, val, html.SERIES[0]),
            ("training loss", "loss", ~val, html.SERIES[1]),
        )
    )


def _chart(
    title: str, steps: NDArray[np.float64], values: NDArray[np.float64], colour: str
) -> html.Html:
    """Return the chart of one curve with its range at the axes; empty without finite values."""
    known = np.isfinite(values)
    steps, values = steps[known], values[known]
    if not len(values):
        return html.Html()
    low, high = float(values.min()), float(values.max())
    span, last = (high - low) or 1.0, float(steps.max()) or 1.0
    x = _LEFT + (_WIDTH - _LEFT) * steps / last
    y = _TOP + _HEIGHT * (1 - (values - low) / span)
    points = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x, y, strict=True))
    frame = f"M{_LEFT:g} {_TOP:g}v{_HEIGHT:g}H{_WIDTH:g}"
    shapes = [
        f"<path d='{frame}' fill='none' stroke='currentColor' stroke-opacity='.4'/>",
        f"<polyline points='{points}' fill='none' stroke='{colour}' stroke-width='1.5'/>",
        f"<circle cx='{x[-1]:.1f}' cy='{y[-1]:.1f}' r='3' fill='{colour}'/>",
        html.words(_LEFT, 13, title),
        html.words(_LEFT - 5, _TOP + 10, f"{high:.4g}", "end"),
        html.words(_LEFT - 5, _TOP + _HEIGHT, f"{low:.4g}", "end"),
        html.words(_WIDTH, _TOP + _HEIGHT + 15, f"step {last:g}", "end"),
    ]
    return html.drawing(_WIDTH + 5, _TOP + _HEIGHT + _BELOW, shapes, title)
