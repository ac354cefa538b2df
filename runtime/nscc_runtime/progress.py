"""The interface through which long tasks report their progress."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

Progress = Callable[[Iterable[Any], str, int | None], Iterable[Any]]
"""A function of (items, label, number of items) that yields the items and may show progress."""


def unseen(items: Iterable[Any], _label: str, _total: int | None) -> Iterator[Any]:
    """Yield the items and show nothing."""
    yield from items
