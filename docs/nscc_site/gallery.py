"""The gallery: examples by task, each with its shutters, a frame, and a reconstruction."""

from __future__ import annotations

import io
import shutil
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from PIL import Image

from nscc.examples import ExampleScene, notebook, tasks
from nscc_runtime.pictures.sheet import THEMES, themed
from nscc_site.scenes import scene_file
from nscc_site.tool import block, grid, said

_THUMBNAIL, _QUALITY = (360, 270), 75
"""Largest width and height of a thumbnail in pixels, and its quality as WebP."""
_SCENES = {
    "room.hdr": ("hdr_doubling", "class_b_4096", "edges", "local_contrast"),
    "stars.hdr": ("bright_spots", "grown_regions"),
    "letters.gif": ("class_d", "motion_in_a_frame", "three_readouts", "deblur"),
}
"""Examples that the gallery shows with a scene of its own."""


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
    scenes = {name: scene_file(name) for name in _SCENES}
    pages |= {f"scenes/{name}": data for name, data in scenes.items()}
    scene_of = {example: scene for scene, shown_in in _SCENES.items() for example in shown_in}
    for task, programs in tasks().items():
        cards = []
        for name, example in programs.items():
            path = examples / f"{name}.nsl"
            shown = replace(example, scene=scene_of.get(name, example.scene))
            pages[f"notebooks/{path.stem}.ipynb"] = _notebook(path, example)
            with TemporaryDirectory() as made:
                folder = Path(made)
                for file in examples.iterdir():
                    shutil.copy(file, folder / file.name)
                for scene, data in scenes.items():
                    (folder / scene).write_bytes(data)
                pages |= _pictures(path.name, shown, folder)
                pages[f"gallery/{name}.md"] = _page(path, shown, folder)
            thumbnails = " ".join(
                f"[![{what} of {name}](pictures/{name}_{kind}_small_light.webp)](gallery/{name}.md)"
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
                pictures[f"{stem}_small_{name}.webp"] = _thumbnail(data)
    return pictures


def _thumbnail(data: bytes) -> bytes:
    """Return a picture reduced to the size of a card."""
    picture = Image.open(io.BytesIO(data)).convert("RGB")
    picture.thumbnail(_THUMBNAIL)
    out = io.BytesIO()
    picture.save(out, "webp", quality=_QUALITY)
    return out.getvalue()


def _remark(path: Path, sentences: int | None = None) -> str:
    """Return the comment at the start of a program; with `sentences`, only its first one."""
    text = " ".join(
        line.lstrip("# ")
        for line in path.read_text().partition("\nnsl ")[0].splitlines()
        if line[:1] == "#"
    )
    return text if sentences is None else text.replace(": ", ". ").partition(". ")[0] + "."


def _notebook(path: Path, shown: ExampleScene) -> bytes:
    """Return a notebook that exposes a built-in scene with a program and reconstructs its light."""
    name = path.stem
    cells = [
        f"!nscc examples {name}",
        f'import nscc\n\nprogram = nscc.compile("{path.name}")\nprogram',
        "import nscc_runtime\n\n"
        f'scene = nscc_runtime.scene("{shown.scene}", exposure={shown.exposure})\n'
        'frame = nscc_runtime.capture(program, scene, effects="auto")\nframe',
    ]
    if shown.reconstruct is not None:
        cells.append(
            'frame.save("frame.npz")\n'
            f"!nscc reconstruct {shown.reconstruct} -o light.npz --png light.png\n\n"
            'from IPython.display import Image\n\nImage("light.png")'
        )
    text = f"# {name}\n\n{_remark(path)}\n\nThis notebook needs nscc with `[run,view]`.\n"
    return notebook(text + "".join(f"\n```{{code-cell}} ipython3\n{cell}\n```\n" for cell in cells))


def _own(program: str, shown: ExampleScene) -> str:
    """Return the command that exposes a file of the reader's with a program."""
    own = "clip.mp4" if "motion" in shown.scene or shown.scene.endswith(".gif") else "photo.jpg"
    return (
        f"nscc run {program} --scene {own} --fit scale --exposure {shown.exposure} \\\n"
        "  --effects auto -o frame.npz --png frame.png"
    )


def _page(path: Path, shown: ExampleScene, folder: Path) -> str:
    text, name = path.read_text(), path.stem
    commands = "\n".join(f"$ nscc {command}" for command in _commands(path.name, shown))
    files = {
        "program": f"../../../examples/{path.name}",
        "notebook": f"../notebooks/{name}.ipynb",
    }
    if shown.scene in _SCENES:
        files["scene"] = f"../scenes/{shown.scene}"
    downloads = ", ".join(
        f"{{download}}`{Path(file).name} <{file}>` ({kind})" for kind, file in files.items()
    )
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
            f"Download: {downloads}.\n",
            block(f"$ nscc examples {name}\n$ nscc check {path.name}", "console"),
            block(said(f"check {path.name}", folder)),
            "The pictures:\n",
            block(commands, "console"),
            "With a file of your own:\n",
            block(_own(path.name, shown), "sh"),
        )
    )
