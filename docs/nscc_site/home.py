"""The pair of pictures at the top of the home page, and what the command that made them prints."""

from __future__ import annotations

import io
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from nscc_runtime.scene_settings import Scene
from nscc_runtime.simulate import Listener
from nscc_site.tool import block, run_nscc
from nscc_training.command_settings import DemoSettings
from nscc_training.demo.expose import exposed
from nscc_training.demo.sheet import Shown
from nscc_training.demo.subject import subject
from nscc_training.run_files import run_capture

_COMMAND = "demo builtin:hdr"
_ROWS = slice(72, 232)
"""The rows of the array that the home page shows: the sun and the hut are among them."""
_PREVIEW_SCALE = 5
"""Dots of the preview for each pixel of the array."""
PREVIEW = "pictures/preview.png"
"""The picture of links to the site, by its path in `docs/generated`."""


def home_pages() -> dict[str, str | bytes]:
    """Return the pictures of the home page, and the text below them, by path in `docs/generated`.

    The frames of both cameras have all effects of the sensor that change them."""
    scene, settings = Scene("builtin:hdr", fit="scale"), DemoSettings(merge=True)
    run = run_capture(Path("hdr"))
    subject_ = subject(scene, run.slots, run.slots * run.slot_us * 1e-6)
    captured = exposed(subject_, settings, Listener())
    shown = Shown(captured, False, None, captured.truth(), "truth", 0.0)
    assert shown.fair_light is not None
    assert captured.looked is not None
    before, after = (
        shown.fitted(np.maximum(light, 0))[_ROWS]
        for light in (shown.fair_light, captured.looked.light)
    )
    gain_db = (shown.looked_db or 0.0) - (shown.fair_db or 0.0)
    text = (
        f"**{gain_db:+.1f} dB** with the same scene, the same sensor and the same time. Left: an "
        "ordinary camera with its best exposure. Right: pixels that look at their light and close "
        "before they are full. Each square is a pixel. The command prints both values:\n"
    )
    return {
        "pictures/home_before.png": _png(before),
        "pictures/home_after.png": _png(after),
        PREVIEW: _preview(before, after),
        "home.inc": "\n".join((text, block(f"$ nscc {_COMMAND}", "console"), block(_printed()))),
    }


def _printed() -> str:
    """Return the results that the demo prints, one a line, so that phones show all of them."""
    with TemporaryDirectory() as folder:
        _, messages = run_nscc(f"{_COMMAND} -o {folder}")
    results = next(line for line in messages.splitlines() if line.startswith("always open"))
    return results.replace(", ", "\n")


def _preview(before: NDArray[Any], after: NDArray[Any]) -> bytes:
    """Return a picture with both cameras side by side, in the format of links' previews."""
    half = before.shape[1] // 2
    both = np.hstack([before[:, :half], np.full((len(before), 1), 255, np.uint8), after[:, half:]])
    return _png(both[:126].repeat(_PREVIEW_SCALE, axis=0).repeat(_PREVIEW_SCALE, axis=1))


def _png(levels: NDArray[Any]) -> bytes:
    out = io.BytesIO()
    Image.fromarray(levels.astype(np.uint8)).save(out, "png", optimize=True)
    return out.getvalue()
