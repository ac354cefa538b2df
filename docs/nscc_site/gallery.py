"""The gallery: for every example its shutters, what it makes of a scene, and what it costs."""

from __future__ import annotations

import shutil
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from nscc.containers import load_container
from nscc_runtime.pictures.picture_colours import LOOKS, looking
from nscc_site.tool import block, said

_STILL = "builtin:hdr --exposure 1000000"
_CLIP = "builtin:motion --exposure {:.0f}"
_WELL_E = 30000
"""Electrons that a pixel of mean open time gets in bright parts of the clip: what it can hold."""
_STILL_CLASSES = ("a", "b")
"""Shutters that open with the frame: what they can do shows on a still of many decades of light."""


def gallery_pages(examples: Path) -> dict[str, str | bytes]:
    """The page and its pictures, light and dark, by their path in `docs/generated`."""
    pages: dict[str, str | bytes] = {}
    parts = [
        "# Gallery\n",
        "Every program of [examples](../../examples/README.md): its shutters, which pixel has "
        "which, and a frame of a builtin scene without effects of the sensor.\n",
    ]
    for path in sorted(examples.glob("*.nsl")):
        with TemporaryDirectory() as made:
            folder = Path(made)
            for each in examples.iterdir():
                shutil.copy(each, folder / each.name)
            pages |= _pictures(path, folder)
            parts.append(_section(path, folder))
    pages["gallery.md"] = "\n".join(parts)
    return pages


def _scene(container_path: Path) -> str:
    """The scene and exposure that show what a program does."""
    container, _ = load_container(container_path)
    if container.notes.get("class") in _STILL_CLASSES:
        return _STILL
    open_us = container.table.shutters @ np.array(container.slot_us)
    share = open_us[open_us > 0].mean() / sum(container.slot_us)
    return _CLIP.format(round(_WELL_E / share, -3))


def _pictures(path: Path, folder: Path) -> dict[str, str | bytes]:
    """The pictures of one example, drawn by the commands that a reader would type."""
    said(f"build {path.name} -O1 -o p.icw", folder)
    scene = _scene(folder / "p.icw")
    pictures: dict[str, str | bytes] = {}
    for name, look in LOOKS.items():
        with looking(look):
            said(f"view {path.name} -O1 -o shutters.png", folder)
            said(f"run {path.name} -O1 --scene {scene} -o f.npz --png frame.png", folder)
        for kind in ("shutters", "frame"):
            found = (folder / f"{kind}.png").read_bytes()
            pictures[f"pictures/{path.stem}_{kind}_{name}.png"] = found
    return pictures


def _section(path: Path, folder: Path) -> str:
    text = path.read_text()
    remark = " ".join(
        line.lstrip("# ") for line in text.partition("\nnsl ")[0].splitlines() if line[:1] == "#"
    )
    scene = _scene(folder / "p.icw")
    return "\n".join((
        f"## {path.name}\n", f"{remark}\n",
        f"![The shutters of {path.name}](pictures/{path.stem}_shutters_light.png)\n",
        f"![A frame of {scene.split()[0]}](pictures/{path.stem}_frame_light.png)\n",
        block(text, "nsl"),
        block(
            f"$ nscc check examples/{path.name}\n{said(f'check {path.name}', folder)}\n"
            f"$ nscc view examples/{path.name} -o shutters.png\n"
            f"$ nscc run examples/{path.name} --scene {scene} -o frame.npz --png frame.png",
            "console",
        ),
    ))  # fmt: skip
