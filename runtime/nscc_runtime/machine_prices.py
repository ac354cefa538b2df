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

_SCHEMA = "nscc-prices-1"


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


def place() -> Path:
    """The file of this machine's prices. Another processor has another one."""
    about = _SCHEMA, platform.machine(), platform.node(), _model(), os.cpu_count()
    digest = hashlib.sha256(repr(about).encode()).hexdigest()[:16]
    user = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    return Path(user) / "nscc" / f"prices-{digest}.json"


def _model() -> str:
    """The processor's name, where the system tells it."""
    with contextlib.suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text(errors="replace").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor()


def kept() -> MachinePrices | None:
    """What was measured here, None where nothing was or the file is no such list."""
    try:
        return _read(json.loads(place().read_bytes()))
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
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
    values = {"schema": _SCHEMA, **asdict(found)}
    partial = path.with_suffix(f".{os.getpid()}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        partial.write_text(json.dumps(values, indent=2) + "\n")
        partial.replace(path)
    except OSError:
        with contextlib.suppress(OSError):
            partial.unlink()
        return None
    return path


@cache
def best_threads() -> int | None:
    """With how many threads frames are done first here; None where nobody has measured it."""
    found = kept()
    return None if found is None else found.threads
