"""Finding and reading the scene files of a folder."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterable, Sequence
from contextlib import suppress
from glob import glob
from os.path import commonpath
from pathlib import Path

import numpy as np

from nscc.arrays import Array, Floats
from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.scene_settings import Transfer
from nscc_runtime.scenes import picture_files
from nscc_runtime.scenes.colour import Colours, grey
from nscc_runtime.scenes.light_arrays import MAT_CLIP_KEY, clip_white, mat_shapes, read_mat
from nscc_runtime.scenes.picture_files import PICTURES, open_pages, read_frames

_PICKED = re.compile(r"(.+)#(\d+(?:,\d+)*)/([1-9]\d*)")
"""The ending `#K,L/N` of a folder's name, which selects some of its files."""
CLIPS = (*picture_files.CLIPS, ".mat")
"""File endings of clips: videos, and the arrays of the benchmark."""


def files_in(folder: Path, endings: Collection[str]) -> list[Path]:
    """Return the files with one of `endings` (in lower case), sorted by name within a folder; empty
    if the folder does not exist.

    `folder` may join several folders by +, contain * for any name, and end in #K,L/N, which selects
    the files at positions K and L (from 0) of every N files."""
    if folder.is_dir():
        return sorted(path for path in folder.iterdir() if path.suffix.lower() in endings)
    matching = []
    for pattern in str(folder).split("+"):
        picked = _PICKED.fullmatch(pattern)
        files = [
            path
            for place in folders_of(pattern if picked is None else picked[1])
            if place.is_dir()
            for path in files_in(place, endings)
        ]
        if picked is not None:
            positions = {int(position) for position in picked[2].split(",")}
            files = [path for k, path in enumerate(files) if k % int(picked[3]) in positions]
        matching += files
    return matching


def folders_of(text: str) -> list[Path]:
    """Return the folders that `text` names: one folder, or patterns joined by `+`, as in
    `files_in`. A folder without * is returned even if it does not exist; a pattern with * may match
    none. The ending #K,L/N is dropped."""
    if Path(text).is_dir():
        return [Path(text)]
    names = (_PICKED.sub(r"\1", pattern) for pattern in text.split("+"))
    return [
        Path(folder)
        for name in names
        if name
        for folder in (sorted(glob(name)) if "*" in name else [name])
    ]


def data_files(
    folder: Path,
    endings: Collection[str],
    contents: str,
    kind_text: str,
    expected: str,
    *,
    by_class: bool = False,
) -> list[Path]:
    """Return the scene files with one of `endings` in `folder`, sorted by name; `folder` may be a
    pattern, as `files_in` takes it. With `by_class`, they are in folders in it, one for each class
    (see `class_of`). Raise Rejected (NS0811) if there are none.

    Three arguments are parts of the message: the folder has no `contents`, files of this kind have
    the endings (`kind_text`, such as "clips end in"), and the user should name a folder of
    `expected`."""
    if by_class and folder.is_dir():
        folder /= "*"
    matching = files_in(folder, endings)
    if not matching:
        exists = any(map(Path.is_dir, folders_of(str(folder))))
        missing = () if exists else ("the folder does not exist",)
        raise rejected(
            "NS0811",
            f"'{folder}' contains no {contents}",
            notes=(*missing, f"{kind_text} {', '.join(endings)}"),
            helps=(f"name a folder of {expected}",),
        )
    return matching


def class_of(path: Path, classes: Sequence[str]) -> str:
    """Return which of `classes` the file `path` belongs to: the name of its folder. Raises Rejected
    (NS0811) for another name."""
    name = path.parent.name
    if name not in classes:
        raise rejected(
            "NS0811",
            f"the folder of '{path}' is not named after a class",
            notes=(f"the classes are {', '.join(classes)[:200]}",),
            helps=(
                "put the clips of each class into a folder of its name, or change [data] classes",
            ),
        )
    return name


def centre_of(frame: Array, size: int) -> Array:
    """Return the middle `size` x `size` pixels of a frame (rows, cols, ..). A side that is smaller
    stays whole."""
    first_row, first_col = (max(0, side - size) // 2 for side in frame.shape[:2])
    return frame[first_row : first_row + size, first_col : first_col + size]


def light_in(stored: Array, colours: Transfer | Colours) -> Floats:
    """Return the light (rows, cols) of a picture or frame as stored in a file; `colours` is its
    encoding. Of colours, return the luminance."""
    return grey(stored, colours, channel=None)


def frames_in(path: Path) -> Iterable[Array]:
    """Return the frames, (rows, cols) or with colours last, of the clip file `path` as stored, one
    after the other; in frames of floating-point numbers white is 1.

    Videos are read frame by frame. In a .mat file of the benchmark, time is the last axis. Raises
    Rejected for a file that cannot be read."""
    if path.suffix.lower() != ".mat":
        return read_frames(path)
    key, stored = read_mat(path, lambda _shape: None)
    if key != MAT_CLIP_KEY:
        return stored
    white = clip_white(stored)
    return np.moveaxis(stored if white is None else stored / white, 2, 0)


def frame_size(path: Path) -> tuple[int, int]:
    """Return rows and columns of the picture in file `path`, or of the frames of a clip.

    Pictures, videos and .mat files are not decoded. Raises Rejected for a file that cannot be read.
    """
    if path.suffix.lower() in PICTURES + picture_files.CLIPS:
        return open_pages(path).sizes[0]
    if path.suffix.lower() == ".mat":
        with suppress(Exception):  # the reader below refuses a damaged file
            rows, cols, _ = mat_shapes(path)[MAT_CLIP_KEY]
            return rows, cols
    rows, cols = next(iter(frames_in(path))).shape[:2]
    return rows, cols


def names_of(files: Collection[Path]) -> dict[Path, Path]:
    """Return a name for each file: its name without the folder, or if several files have this name,
    its path below their common folder. So clips `left/1.mp4` and `right/1.mp4` stay apart."""
    places = {path: path.absolute() for path in files}
    alike = Counter(path.name for path in places)
    folder = commonpath(place.parent for place in places.values()) if places else ""
    return {
        path: Path(path.name) if alike[path.name] == 1 else place.relative_to(folder)
        for path, place in places.items()
    }


def labels(names: Iterable[Path]) -> dict[Path, str]:
    """Return a label for each of the `names`, as `names_of` returns them, for names of arrays: the
    name without its ending, if no other file has the same. Otherwise the ending follows after an
    underscore (`a_png`). Folders stand before an underscore, too."""
    stems = {name: "_".join(name.with_suffix("").parts) for name in names}
    alike = Counter(stems.values())
    return {
        name: stem if alike[stem] == 1 else stem + name.suffix.replace(".", "_")
        for name, stem in stems.items()
    }
