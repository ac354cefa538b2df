"""Read folders of pictures as clips, and find missing frames: unread files, and gaps in the
numbering."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import islice, pairwise
from mimetypes import guess_type
from pathlib import Path

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity, rejected
from nscc_runtime.scenes.errors import Warn, damaged, unheard
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


_SHOWN = 4
"""Number of missing files or frame numbers that a message names; the others are counted."""
_MOST_DIGITS = 18
"""Longest number of a frame, in digits. Longer runs of digits are taken for times or checksums."""


def missing_frames(pictures: Sequence[str], names: Sequence[str]) -> tuple[str, ...]:
    """Return a sentence for each kind of missing frames of a clip: files that are not read, and
    gaps in the numbering. Return () if no frame is missing.

    `pictures`: names of the files that are read, in order. `names`: names of all files in the
    folder. A file counts as an unread frame if its ending is that of a picture, or if its name
    differs from theirs in the frame number only. Hidden files, and files named like a picture but
    for the ending, do not count."""
    stems = {Path(name).stem for name in pictures}
    split_names = [_split(name) for name in pictures]
    part_index = _counting_part(split_names)
    unread = [
        name
        for name in sorted(set(names).difference(pictures))
        if not name.startswith(".")
        and Path(name).stem not in stems
        and (
            (guess_type(name, strict=False)[0] or "").startswith("image/")
            or (part_index is not None and _counts(name, split_names[0], part_index))
        )
    ]
    sentences = []
    if unread:
        listed = ", ".join(name[:60] for name in unread[:_SHOWN])
        rest_text = f" and {len(unread) - _SHOWN} more" if len(unread) > _SHOWN else ""
        sentences.append(f"{listed}{rest_text}: unsupported format")
    if part_index is not None:
        read = {int(split_name[part_index]) for split_name in split_names}
        # Numbers of unread files are reported already.
        unread_numbers = {
            int(_split(name)[part_index])
            for name in unread
            if _counts(name, split_names[0], part_index)
        }
        gaps = _gaps(sorted(read | unread_numbers))
        if gaps:
            sentences.append(f"the frame numbers {gaps} are missing")
    return tuple(sentences)


def frames_missing(folder: Path, missing: Sequence[str], skipped: bool = False) -> Diagnostic:
    """Return the diagnostic NS0776 for a `folder`: an error, or a warning if missing frames are
    `skipped`. `missing` are sentences that say which, as `missing_frames` returns them."""
    helps = ("convert or remove the files, or add --skip to expose the remaining frames",)
    return Diagnostic(
        "NS0776",
        f"frames of the folder '{folder}' are missing" + " and left out" * skipped,
        severity=Severity.WARNING if skipped else Severity.ERROR,
        notes=tuple(missing),
        helps=() if skipped else helps,
    )


def _split(name: str) -> list[str]:
    """Return the file name `name` without its ending, split into texts (even indices) and runs of
    digits (odd indices)."""
    return re.split(r"(\d+)", Path(name).stem)


def _counting_part(split_names: Sequence[list[str]]) -> int | None:
    """Return the index of the part of file names that numbers the frames, None if there is none.

    `split_names` are the names, each as `_split` returns it. The part must be the only one that
    differs, and a run of at most 18 digits. Fewer than two names, or names of different numbers of
    parts, have none."""
    if len(split_names) < 2 or len({len(split_name) for split_name in split_names}) != 1:
        return None
    varying = [k for k, texts in enumerate(zip(*split_names, strict=True)) if len({*texts}) > 1]
    # Texts and numbers alternate in a split name: numbers have odd indices.
    numbers = len(varying) == 1 and varying[0] % 2 == 1
    if numbers and max(len(p[varying[0]]) for p in split_names) <= _MOST_DIGITS:
        return varying[0]
    return None


def _counts(name: str, like: list[str], part_index: int) -> bool:
    """Return whether the file name `name` equals those of the frames but for its ending and its
    number at `part_index`. `like` is the name of a frame, split into texts and runs of digits."""
    split_name = _split(name)
    return len(split_name) == len(like) and all(
        split_name[k] == like[k] for k in range(len(like)) if k != part_index
    )


def _gaps(numbers: Sequence[int]) -> str:
    """Return the numbers missing from ascending `numbers` of constant step, as text: the first 4 of
    them and how many more.

    The step is the smallest difference; it must be that of half of the pairs or more, and must
    divide the others. Return "" if nothing is missing, or if there is no such step (for example
    times)."""
    steps = [b - a for a, b in pairwise(numbers)]
    step = min(steps, default=0)
    usual = step > 0 and 2 * steps.count(step) >= len(steps)
    if not usual or any(difference % step for difference in steps):
        return ""
    count = sum(difference // step - 1 for difference in steps)
    gaps = (n for a, b in pairwise(numbers) for n in range(a + step, b, step))
    shown = ", ".join(str(number) for number in islice(gaps, _SHOWN))
    return shown + (f" and {count - _SHOWN} more" if count > _SHOWN else "")
