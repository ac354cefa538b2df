"""How long work tells its caller how far it is."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

Progress = Callable[[Iterable[Any], str, int | None], Iterable[Any]]
"""Hands on the items of an iterable and may show how many: (items, label, number of items)."""


def unseen(items: Iterable[Any], _label: str, _total: int | None) -> Iterator[Any]:
    """Hands on the items and shows nothing."""
    yield from items
