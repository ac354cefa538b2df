"""Read folders of pictures as clips."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc_runtime.scenes.errors import Warn, damaged, unheard
from nscc_runtime.scenes.numbering import frames_missing, missing_frames
from nscc_runtime.scenes.pages import Pages
from nscc_runtime.scenes.picture_files import (
    LINEAR,
    PICTURES,
    only_picture,
    open_pages,
    same_size,
)


def files_of(folder: Path, skip: bool = False, warn: Warn = unheard) -> list[Path]:
    """Return the pictures of a `folder` in natural order (2 before 10).

    Hidden files, and files that belong to no sequence of frames, are ignored. Missing frames are
    files that are not read, or gaps in the numbering. With `skip`, `warn` is called with a message
    (NS0776) about them. Raises Rejected: NS0732 for a folder that cannot be read, NS0735 for one
    without pictures, NS0739 for linear and display pictures in one folder, NS0776 for missing
    frames without `skip`."""
    try:
        names = sorted(entry.name for entry in folder.iterdir() if entry.is_file())
    except OSError as error:
        raise damaged(folder, error.strerror or error) from error
    pictures = [
        folder / name
        for name in sorted(names, key=_natural)
        if not name.startswith(".") and Path(name).suffix.lower() in PICTURES
    ]
    if not pictures:
        raise rejected(
            "NS0735",
            f"the folder '{folder}' holds no pictures",
            notes=(f"{len(names)} other files; pictures end in {', '.join(PICTURES)}",),
            helps=("name the folder that holds the clip's frames",),
        )
    # One example of each kind, linear and for display, by whether it is linear.
    first = {path.suffix.lower() in LINEAR: path.name for path in reversed(pictures)}
    if len(first) > 1:
        raise rejected(
            "NS0739",
            f"the folder '{folder}' contains linear pictures ({first[True]}) and "
            f"display pictures ({first[False]})",
            helps=(
                "all frames of a clip must have one kind: move the others into a separate folder",
            ),
        )
    missing = missing_frames([path.name for path in pictures], names)
    if missing:
        if not skip:
            raise Rejected(frames_missing(folder, missing), status=2)
        warn(frames_missing(folder, missing, skipped=True))
    return pictures


def _natural(name: str) -> tuple[list[tuple[int, int, str]], str]:
    """Return a key that sorts file names with runs of digits as numbers, before letters, and
    without regard to case. The name itself breaks ties."""
    runs = re.findall(r"\d+|\D+", name)
    return [
        # Python refuses to parse numbers of more than 4300 digits.
        (0, int(p), "") if p.isdecimal() and p.isascii() and len(p) < 4000 else (1, 0, p.casefold())
        for p in runs
    ], name


def read_folder(
    pictures: list[Path], skip: bool = False, warn: Warn = unheard
) -> Iterator[tuple[Array, Pages]]:
    """Yield each of the files `pictures` as stored, (R, C) or (R, C, 3), with the pages of its
    file.

    With `skip`, a file that is damaged, or has several pictures, is reported to `warn` (NS0776) and
    left out; without, the error of `open_pages` or `only_picture` is raised. Raises Rejected
    (NS0734) if one differs in size from the first."""
    opened: list[Pages] = []

    def read() -> Iterator[tuple[Path, Array]]:
        """Yield each picture; with `skip`, warn of unreadable ones and leave them out."""
        for path in pictures:
            try:
                pages = open_pages(path)
                picture = only_picture(path, pages)
            except Rejected as error:
                if not skip:
                    raise
                reason = error.diagnostics[0].message
                warn(frames_missing(path.parent, (f"{path.name}: {reason}",), skipped=True))
                continue
            opened.append(pages)
            yield path, picture

    # `read` appends to `opened` just before it yields: the last entry belongs to the picture.
    return ((picture, opened[-1]) for picture in same_size(read()))
