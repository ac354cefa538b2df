"""A picture of what methods made of the same scenes, from folders of `nscc evaluate --save`.

    python training/results/figure.py OUT.png NAME.. -- METHOD=DIR [METHOD=DIR ..]

Each NAME is a row, the start of the files' names (`studio_small_05_1k_128_0`); columns are the
truth and the methods. Stills are shown by mu-law over the truth's 99.9th percentile, as hdr-v1
counts them; of clips the ninth frame, relative to the truth's 99th percentile, in sRGB.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.pictures.images import Image, image_sheet
from nscc_runtime.pictures.sheet import png_of
from nscc_training.curves import mu_law, srgb

FRAME = 8


def shown(values: NDArray[np.float64], truth: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values on 0..255 for the screen."""
    if values.ndim == 3:
        white = np.percentile(truth, 99)
        return 255 * srgb(np.clip(values[FRAME] / white, 0, 1))
    return 255 * np.asarray(mu_law(np.clip(values / np.percentile(truth, 99.9), 0, 1)))


def loaded(folder: Path, name: str, what: str) -> NDArray[np.float64]:
    """An array of a folder: `truth`, or else the image or video."""
    kinds = ("truth",) if what == "truth" else ("image", "video")
    for kind in kinds:
        path = folder / f"{name}_{kind}.npy"
        if path.is_file():
            return np.asarray(np.load(path), np.float64)
    raise SystemExit(f"{folder} has no {name}_{' or _'.join(kinds)}.npy")


def main() -> None:
    """Draw."""
    try:
        out, *rest = sys.argv[1:]
        cut = rest.index("--")
        names = rest[:cut]
        methods = [entry.split("=", 1) for entry in rest[cut + 1 :]]
    except ValueError:
        raise SystemExit(__doc__) from None
    if not names or not methods or any(len(method) != 2 for method in methods):
        raise SystemExit(__doc__)
    rows = []
    for name in names:
        truth = loaded(Path(methods[0][1]), name, "truth")
        found = {method: loaded(Path(folder), name, "result") for method, folder in methods}
        columns = {"truth": truth} | found
        rows.append([Image(shown(values, truth), title) for title, values in columns.items()])
    Path(out).write_bytes(png_of(image_sheet, rows, ""))


if __name__ == "__main__":
    main()
