"""What simulating takes on this machine, measured once and kept in the user's cache folder.

Prices that decide on effects are shipped (`nscc_runtime.planner.prices`), so that the same input
gives the same bytes anywhere. These say how long it takes here, and choose only what changes no
bit: how many threads a run has.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import platform
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path
from typing import Any

from nscc.cache.store import Store, cache_folder

_SCHEMA = "nscc-prices-2"


@dataclass(frozen=True)
class Price:
    """One line of the list: `here` as measured, `shipped` what plans are chosen by, None where they
    are not, both in `unit`."""

    name: str
    what: str
    unit: str
    shipped: float | None
    here: float


@dataclass(frozen=True)
class MachinePrices:
    """The list, and with how many `threads` a frame is done first."""

    prices: tuple[Price, ...]
    threads: int


def place() -> Path | None:
    """The file of this machine's prices, None where nothing is kept (`nscc.cache.store`). Another
    processor has another one."""
    folder = cache_folder()
    about = _SCHEMA, platform.machine(), platform.node(), _model(), os.cpu_count()
    return folder and folder / "prices" / hashlib.sha256(repr(about).encode()).hexdigest()


def _model() -> str:
    """The processor's name, where the system tells it."""
    with contextlib.suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text(errors="replace").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor()


def kept() -> MachinePrices | None:
    """What was measured here, None where nothing was or the file is no such list."""
    path = place()
    data = path and Store(path.parent).read(path.name)
    try:
        return _read(json.loads(data)) if data else None
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return None


def _read(values: Any) -> MachinePrices:
    if values["schema"] != _SCHEMA:
        raise ValueError("another schema")
    threads = values["threads"]
    if type(threads) is not int or not 1 <= threads <= 4096:
        raise ValueError("threads")
    prices = tuple(Price(**each) for each in values["prices"])
    if not all(isinstance(each.here, float) and isinstance(each.name, str) for each in prices):
        raise ValueError("prices")
    return MachinePrices(prices, threads)


def keep(found: MachinePrices) -> Path | None:
    """Write the list; where it went, None where there is no room for it."""
    path = place()
    if path is not None:
        values = {"schema": _SCHEMA, **asdict(found)}
        Store(path.parent).write(path.name, json.dumps(values, indent=2).encode())
    return path if kept() == found else None


@cache
def best_threads() -> int | None:
    """With how many threads frames are done first here; None where nobody has measured it."""
    found = kept()
    return None if found is None else found.threads
