"""The words' meaning a second time, as slowly and plainly as possible.

Written from the public description of the chip, not from the compiler's table: whole arrays of bool
and float64, one word after the other. A word is (name, destinations, sources).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

_DIVISORS = {"bus": 1, "bus2": 2, "bus3": 3}


@dataclass
class Chip:
    """The pixels' state: `analog` and `digital` hold arrays (rows, cols) by register."""

    analog: dict[str, np.ndarray]
    digital: dict[str, np.ndarray]
    flag: np.ndarray
    reset: np.ndarray
    reset_honours_flag: bool = False
    where_obeys_flag: bool = False

    def expose(self, words: list[list[tuple]], light: np.ndarray) -> None:
        """Run words[n] at boundary n = 0..N, and between them add light[n] to PIX."""
        for n, here in enumerate(words):
            for word in here:
                self.run(*word)
            if n < len(light):
                self.analog["PIX"] = self.analog["PIX"] + light[n].astype(float)

    def run(self, name: str, destinations: tuple, sources: tuple) -> None:
        """One word."""
        if name == "nop":
            return
        if name == "all":
            self.flag = np.ones_like(self.flag)
        elif name == "rpix":
            where = self.flag if self.reset_honours_flag else np.ones_like(self.flag)
            self.analog["PIX"] = np.where(where, self.reset, self.analog["PIX"])
        elif name in _DIVISORS:
            value = -self.total(sources) / _DIVISORS[name]
            for register in destinations:
                self.analog[register] = np.where(self.flag, value, self.analog[register])
        elif name == "where":
            positive = self.total(sources) > 0
            self.flag = self.flag & positive if self.where_obeys_flag else positive
        elif name == "WHERE":
            self.flag = self.some(sources)
        else:
            self.digital_word(name, destinations, sources)

    def digital_word(self, name: str, destinations: tuple, sources: tuple) -> None:
        """SET, CLR, MOV, OR, NOT, NOR, whole or in halves."""
        kind, _, half = name.partition(".")
        if half == "write":
            value = self.bus
        else:
            value = self.some(sources)
            if kind in ("SET", "NOT", "NOR"):
                value = ~value
        if half == "read":
            self.bus = value
            return
        enabled = self.digital["R0"]
        for register in destinations:
            if register == "R12":
                value_here = np.where(enabled, value, self.digital["R12"])
            else:
                value_here = value
            self.digital[register] = value_here

    def total(self, sources: tuple) -> np.ndarray:
        """The sum of analog sources."""
        total = np.zeros(self.flag.shape)
        for register in sources:
            total = total + self.analog[register]
        return total

    def some(self, sources: tuple) -> np.ndarray:
        """The OR of digital sources."""
        some = np.zeros(self.flag.shape, bool)
        for register in sources:
            some = some | (self.flag if register == "FLAG" else self.digital[register])
        return some
