"""The gallery: examples by task, each with its shutters, a frame, and a reconstruction."""

from __future__ import annotations

import io
import shutil
from pathlib import Path
from tempfile import TemporaryDirectory

from PIL import Image

from nscc.examples import ExampleScene, tasks
from nscc_runtime.pictures.sheet import THEMES, themed
from nscc_site.tool import block, grid, said

_THUMBNAIL = (440, 330)
"""Largest width and height of a thumbnail in pixels."""


def _kinds(shown: ExampleScene) -> dict[str, str]:
    """Return the titles of the pictures of a frame, by file name."""
    return {"frame": "A frame"} | ({"light": "The reconstruction"} if shown.reconstruct else {})


def gallery_pages(examples: Path) -> dict[str, str | bytes]:
    """Return the pages and their light and dark pictures, by their path in `docs/generated`.

    Raises KeyError for an example without a task.
    """
    pages: dict[str, str | bytes] = {}
    parts = [
        "# Gallery\n",
        "All programs of [examples](../../examples/README.md), sorted by task, each with a frame "
        "and the light that was reconstructed from the frame. A click on a picture opens a page "
        "with the program, its shutters, its cost and the commands.\n",
    ]
    missing = {path.stem for path in examples.glob("*.nsl")}.difference(*tasks().values())
    if missing:
        raise KeyError(f"the gallery has no task for {', '.join(sorted(missing))}")
    for task, programs in tasks().items():
        cards = []
        for name, shown in programs.items():
            path = examples / f"{name}.nsl"
            with TemporaryDirectory() as made:
                folder = Path(made)
                for file in examples.iterdir():
                    shutil.copy(file, folder / file.name)
                pages |= _pictures(path.name, shown, folder)
                pages[f"gallery/{name}.md"] = _page(path, shown, folder)
            thumbnails = " ".join(
                f"[![{what} of {name}](pictures/{name}_{kind}_small_light.png)](gallery/{name}.md)"
                for kind, what in _kinds(shown).items()
            )
            cards.append(f"{thumbnails}\n\n[{name}](gallery/{name}.md): {_remark(path, 1)}")
        parts += [f"## {task}\n", grid(cards)]
    parts.append("```{toctree}\n:hidden:\n:glob:\n\ngallery/*\n```\n")
    pages["gallery.md"] = "\n".join(parts)
    return pages


def _commands(program: str, shown: ExampleScene) -> list[str]:
    """Return the commands that draw the pictures of a page."""
    commands = [
        f"view {program} -o shutters.png",
        f"run {program} --scene {shown.scene} --exposure {shown.exposure} -o frame.npz "
        "--png frame.png",
    ]
    if shown.reconstruct is not None:
        commands.append(f"reconstruct {shown.reconstruct} -o light.npz --png light.png")
    return commands


def _pictures(program: str, shown: ExampleScene, folder: Path) -> dict[str, str | bytes]:
    """Draw the pictures of one example with its commands; return them with thumbnails."""
    view, run, *reconstruct = _commands(program, shown)
    view, run = (command.replace(program, f"{program} -O1") for command in (view, run))
    pictures: dict[str, str | bytes] = {}
    for number, (name, theme) in enumerate(THEMES.items()):
        with themed(theme):
            said(view, folder)
            said(run, folder)
            for command in reconstruct:
                said("view light.npz -o light.png" if number else command, folder)
        for kind in ("shutters", *_kinds(shown)):
            data = (folder / f"{kind}.png").read_bytes()
            stem = f"pictures/{Path(program).stem}_{kind}"
            pictures[f"{stem}_{name}.png"] = data
            if kind != "shutters":
                pictures[f"{stem}_small_{name}.png"] = _thumbnail(data)
    return pictures


def _thumbnail(data: bytes) -> bytes:
    """Return a picture reduced to the size of a card."""
    picture = Image.open(io.BytesIO(data)).convert("RGB")
    picture.thumbnail(_THUMBNAIL)
    out = io.BytesIO()
    picture.save(out, "png", optimize=True)
    return out.getvalue()


def _remark(path: Path, sentences: int | None = None) -> str:
    """Return the comment at the start of a program; with `sentences`, only its first one."""
    text = " ".join(
        line.lstrip("# ")
        for line in path.read_text().partition("\nnsl ")[0].splitlines()
        if line[:1] == "#"
    )
    return text if sentences is None else text.replace(": ", ". ").partition(". ")[0] + "."


def _page(path: Path, shown: ExampleScene, folder: Path) -> str:
    text, name = path.read_text(), path.stem
    commands = "\n".join(f"$ nscc {command}" for command in _commands(path.name, shown))
    light = (
        ()
        if shown.reconstruct is None
        else (
            "Light that was reconstructed from the frame:\n",
            f"![The reconstruction](../pictures/{name}_light_light.png)\n",
        )
    )
    return "\n".join(
        (
            f"# {name}\n",
            f"{_remark(path)}\n",
            f"![A frame of {shown.scene}](../pictures/{name}_frame_light.png)\n",
            *light,
            "## Shutters\n",
            f"![The shutters of {path.name}](../pictures/{name}_shutters_light.png)\n",
            "## Program\n",
            block(text, "nsl"),
            block(f"$ nscc examples {name}\n$ nscc check {path.name}", "console"),
            block(said(f"check {path.name}", folder)),
            "The pictures:\n",
            block(commands, "console"),
        )
    )
