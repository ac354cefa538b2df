"""Draw the pictures of pages for the site, light and dark."""

from __future__ import annotations

import csv
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from docutils import nodes

from nscc_runtime.pictures.precision import Point
from nscc_runtime.pictures.sheet import THEMES, png_of, themed
from nscc_site.editor import editor_picture
from nscc_site.tool import said
from nscc_training.experiments.study import StudyResult
from nscc_training.tradeoff.decoder import decoder_diagram

if TYPE_CHECKING:
    from sphinx.application import Sphinx

GENERATED = "docs/generated/pictures"


def _shown(command: str) -> Callable[[Path], bytes]:
    """Return a function that draws the picture `OUT` with a command."""

    def draw(repository: Path) -> bytes:
        with TemporaryDirectory() as made:
            out = Path(made) / "out.png"
            said(command.replace("OUT", out.as_posix()), repository)
            return out.read_bytes()

    return draw


def _decoders(repository: Path) -> bytes:
    """Draw the diagram of the stored measurements of decoders."""
    file = repository / "training/results/evaluations/decoders.csv"
    rows = [*csv.DictReader(file.read_text().splitlines())]
    points = [
        Point(
            *row["method"].rsplit(", ", 1),
            row["setting"],
            float(row["error"]),
            row["error_unit"],
            (float(row["time_ms"]),),
            more_is_better=True,
        )
        for row in rows
        if row["error"]
    ]
    return png_of(decoder_diagram, StudyResult(tuple(points)), rows[0]["device"])


KEPT: dict[str, Callable[[Path], bytes]] = {
    "docs/images/hdr.png": _shown(
        "run examples/hdr_2x2.nsl --scene builtin:hdr --exposure 1000000 -o OUT.npz --png OUT"
    ),
    "docs/images/float.png": _shown(
        "run examples/float_pixel.nsl --scene builtin:hdr --exposure 1000000 --effects all "
        "-o OUT.npz --png OUT"
    ),
    "docs/images/hdr_shutters.png": _shown("view examples/hdr_2x2.nsl -o OUT"),
    "docs/images/float_shutters.png": _shown("view examples/float_pixel.nsl -o OUT"),
    "docs/images/editor.png": editor_picture,
    "docs/images/gates.png": _shown("view examples/skip_one.nsl --gates -o OUT"),
    "training/results/figures/decoders.png": _decoders,
}
"""The pictures in the repository, which pages show outside the site, and their functions."""


def draw_pictures(repository: Path) -> dict[str, str | bytes]:
    """Draw the pictures of KEPT, light and dark, by their path in `docs/generated`."""
    pictures: dict[str, str | bytes] = {}
    for name, draw in KEPT.items():
        for theme_name, theme in THEMES.items():
            with themed(theme):
                pictures[f"pictures/{Path(name).stem}_{theme_name}.png"] = draw(repository)
    return pictures


def pair_pictures(app: Sphinx, doctree: nodes.document) -> None:
    """Show the light or the dark version of a picture, depending on the reader's theme.

    Browsers load all pictures when they are needed, but those at the top of the home page at once.
    """
    for image in [*doctree.findall(nodes.image)]:
        name = image["uri"]
        if not Path(name).stem.startswith("home_"):
            image["loading"] = "lazy"
        if name in KEPT:
            name = f"{GENERATED}/{Path(name).stem}_light.png"
        dark = name.replace("_light.", "_dark.")
        if dark == name or not (Path(app.srcdir) / dark).is_file():
            continue
        twin = image.deepcopy()
        for each, uri, kind in ((image, name, "only-light"), (twin, dark, "only-dark")):
            each["uri"], each["candidates"] = uri, {"*": uri}
            each["classes"] = [*each["classes"], kind]
            app.env.images.add_file(app.env.docname, uri)
        image.parent.insert(image.parent.index(image) + 1, twin)
