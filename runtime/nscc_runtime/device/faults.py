"""Simulated line faults: the effect of `--fault` on bytes."""

from __future__ import annotations

import re
from contextlib import suppress
from dataclasses import dataclass
from math import log
from random import Random
from typing import Any

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.diagnostics.suggest import meant

_TIME = re.compile(r"(\d+(?:\.\d+)?)(us|ms|s)")
_UNITS = {"us": 1e-6, "ms": 1e-3, "s": 1.0}
_LONGEST_S = 3600.0
EXAMPLE = "corrupt=1e-4,drop=1e-5,delay=50ms,disconnect=after:20000,reboot=after:40000"


@dataclass(frozen=True)
class LineFaults:
    """Simulated faults of a line.

    `corrupt`, `drop`: rates per byte. `delay_s`: delay in both directions. `disconnect_after`:
    number of bytes, in both directions together, after which the line is interrupted for
    `outage_s`. `reboot_after`: number of bytes after which the loader reboots. Both happen once;
    None for never."""

    corrupt: float = 0.0
    drop: float = 0.0
    delay_s: float = 0.0
    disconnect_after: int | None = None
    reboot_after: int | None = None
    outage_s: float = 0.3
    seed: int = 0

    def __str__(self) -> str:
        terms = [f"corrupt={self.corrupt:g}", f"drop={self.drop:g}", f"delay={self.delay_s:g}s"]
        for name, after in (("disconnect", self.disconnect_after), ("reboot", self.reboot_after)):
            if after is not None:
                terms.append(f"{name}=after:{after}")
        return ",".join([*terms, f"outage={self.outage_s:g}s", f"seed={self.seed}"])


NAMES = {
    "corrupt": "corrupt", "drop": "drop", "delay": "delay_s", "disconnect": "disconnect_after",
    "reboot": "reboot_after", "outage": "outage_s", "seed": "seed",
}  # fmt: skip


def parse_faults(text: str) -> LineFaults:
    """Parse a list of faults such as EXAMPLE. Raises NS0769 (status 2) for other texts."""
    values: dict[str, Any] = {}
    for item in text.split(","):
        name, _, value = (piece.strip() for piece in item.partition("="))
        if name not in NAMES:
            raise _invalid_faults(f"unknown fault '{name[:40]}'", *meant(name, NAMES))
        if NAMES[name] in values:
            raise _invalid_faults(f"'{name}' is given twice")
        values[NAMES[name]] = _value(name, value)
    return LineFaults(**values)


def _value(name: str, text: str) -> float | int:
    shown = f"{name}={text[:40]}"
    if name in ("corrupt", "drop"):
        with suppress(ValueError):
            if 0 <= float(text) <= 1:
                return float(text)
        raise _invalid_faults(f"'{shown}' is not a rate per byte from 0 to 1")
    if name in ("delay", "outage"):
        match = _TIME.fullmatch(text)
        seconds = float(match[1]) * _UNITS[match[2]] if match else _LONGEST_S + 1
        if seconds > _LONGEST_S:
            raise _invalid_faults(f"'{shown}' is not a time such as 50ms, at most {_LONGEST_S:g} s")
        return seconds
    digits = text if name == "seed" else text.removeprefix("after:")
    counted = name == "seed" or text.startswith("after:")
    if not counted or not digits.isascii() or not digits.isdigit() or len(digits) > 12:
        raise _invalid_faults(
            f"'{shown}' should be {name}={'1' if name == 'seed' else 'after:BYTES'}"
        )
    return int(digits)


def _invalid_faults(problem: str, *helps: str) -> Rejected:
    return rejected(
        "NS0769",
        f"--fault: {problem}",
        notes=(f"--fault takes a comma-separated list of: {', '.join(NAMES)}",),
        helps=helps or (f"for instance --fault {EXAMPLE}",),
    )


class Spoiler:
    """Corrupts and drops bytes at the rates of `faults`; the seed determines the sequence."""

    def __init__(self, faults: LineFaults, seed: int) -> None:
        self._random = Random(f"{faults.seed} {seed}")
        self._faults = faults
        self._to_corrupt = self._gap(faults.corrupt)
        self._to_drop = self._gap(faults.drop)

    def _gap(self, rate: float) -> int:
        """Return the number of bytes before the next fault."""
        if rate <= 0:
            return 1 << 62
        if rate >= 1:
            return 0
        return int(log(1 - self._random.random()) / log(1 - rate))

    def spoiled(self, data: bytes) -> bytes:
        """Return the bytes that arrive at the other end of the line."""
        if self._to_corrupt >= len(data) and self._to_drop >= len(data):
            self._to_corrupt -= len(data)
            self._to_drop -= len(data)
            return data
        out = bytearray()
        for byte in data:
            value = byte
            if self._to_corrupt == 0:
                value ^= self._random.randrange(1, 256)
                self._to_corrupt = self._gap(self._faults.corrupt) + 1
            if self._to_drop == 0:
                self._to_drop = self._gap(self._faults.drop) + 1
            else:
                out.append(value)
            self._to_corrupt -= 1
            self._to_drop -= 1
        return bytes(out)


class Accidents:
    """Decides, by the number of transferred bytes, when the line breaks or the loader reboots."""

    def __init__(self, faults: LineFaults) -> None:
        after = {"disconnect": faults.disconnect_after, "reboot": faults.reboot_after}
        self._to_come = {name: count for name, count in after.items() if count is not None}
        self._passed = 0

    def passed(self, count: int) -> list[str]:
        """Return the accidents ("disconnect", "reboot") within the next `count` bytes."""
        self._passed += count
        due = [name for name, after in self._to_come.items() if self._passed >= after]
        for name in due:
            del self._to_come[name]
        return due
