"""The pictures of a file, with the properties that the file states."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from nscc_runtime.scenes.colour import Transfer

Note = tuple[str, str]
"""A sentence about a file, without its name, and a remedy."""


@dataclass(frozen=True)
class Pages:
    """The `count` pictures of a file. `read` decodes them one after the other, each (R, C) grey or
    (R, C, 3) red, green, blue as stored. `transfer`: the transfer curve that the file names, or
    None. `notes`: unexpected choices of the reader."""

    count: int
    read: Callable[[], Iterator[NDArray[Any]]]
    transfer: Transfer | None = None
    notes: tuple[Note, ...] = ()


class UnsupportedPicture(Exception):
    """An intact file of a kind that nscc does not decode: the reason, and a remedy."""

    def __init__(self, reason: str, help_text: str) -> None:
        super().__init__(reason)
        self.reason, self.help_text = reason, help_text
