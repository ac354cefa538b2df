"""A direct interpreter of programs that look: one pixel, one boundary at a time, from the tree.

It knows nothing of machines, nodes or words: senses are compared with the light that the pixel has
gathered, `next` happens all at once, and then the rules say whether the shutter is open.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from program_oracle import statements, value

from nscc.syntax import tree as t

FULL_WELL_E = 30000.0
LSB_E = FULL_WELL_E / 255
STEP_E = FULL_WELL_E / 127

Answer = Callable[[str, int, float, float], bool]
"""(sense, boundary, signal, level) -> whether the signal is above its level."""


def above(_sense: str, _boundary: int, signal: float, level: float) -> bool:
    """What a comparator without errors answers."""
    return signal > level


@dataclass
class Pixel:
    """What a frame did to one pixel: `opens` by bucket and slot, and the states at its end."""

    opens: list[list[bool]]
    states: dict[str, Any]
    exposure: list[float] = field(default_factory=list)


class Interpreter:
    """The program of a text of version 2; its frame has slots of one length."""

    def __init__(self, text: str) -> None:
        self.parts = statements(text)
        (frame,) = (s for s in self.parts if isinstance(s, t.EqualSlots))
        self.constants: dict[str, Any] = {"N": value(frame.count, {})}
        for let in self._all(t.Let):
            self.constants[let.name.text] = value(let.value, self.constants)
        self.slots = self.constants["N"]
        self.senses = self._all(t.Sense)
        self.states = self._all(t.StateRange, t.StateBit)
        self.rules = self._all(t.Open, t.Bucket)
        self.looks = [
            n for n in range(1, self.slots + 1) if any(self.at(s, n) for s in self.senses)
        ]

    def _all(self, *kinds: type) -> list[Any]:
        return [s for s in self.parts if isinstance(s, kinds)]

    def at(self, sense: t.Sense, boundary: int) -> bool:
        """Whether a sense looks there."""
        return bool(value(sense.at, {**self.constants, "n": boundary}))

    def starts(self) -> dict[str, Any]:
        """START of every state."""
        return {s.name.text: self._typed(s, value(s.start, self.constants)) for s in self.states}

    @staticmethod
    def _typed(state: Any, number: Any) -> Any:
        return bool(number) if isinstance(state, t.StateBit) else number

    def level_e(self, sense: t.Sense, boundary: int, code: Mapping[str, int]) -> float:
        """The level of a sense at a boundary, in whole steps of IN."""
        level = sense.level
        if isinstance(level, t.Levels):
            mine = [n for n in range(1, self.slots + 1) if self.at(sense, n)]
            level = level.items[mine.index(boundary)]
        if isinstance(level, t.Amount):
            electrons = (
                float(level.value) * {"%": FULL_WELL_E / 100, "e": 1.0, "lsb": LSB_E}[level.unit]
            )
        else:
            electrons = value(level, {**self.constants, **code}) * LSB_E
        return round(electrons / STEP_E) * STEP_E

    def run(
        self,
        code: Mapping[str, Any],
        light: Sequence[float],
        kept: Mapping[str, Any] | None = None,
        answer: Answer = above,
    ) -> Pixel:
        """One frame of a pixel: `code` has its fields (and bit counts as "NAME[]"), `light` its
        electrons by slot, `kept` the states that survived the frame before."""
        states = self.starts() | dict(kept or {})
        answers = {s.name.text: False for s in self.senses}
        since, gathered, looks = 0.0, [0.0] * len(self.rules), 0
        opens: list[list[bool]] = [[] for _ in self.rules]
        for n in range(self.slots + 1):
            if n in self.looks:
                looks += 1
                for sense in self.senses:
                    if self.at(sense, n):
                        signal = since
                        if isinstance(sense.signal, t.Exposure):
                            signal = gathered[self._bucket(sense.signal)]
                        level = self.level_e(sense, n, code)
                        found = answer(sense.name.text, n, signal, level)
                        answers[sense.name.text] = found == (sense.comparison == ">")
                names = {**self.constants, **code, **answers, **states, "n": n, "looks": looks}
                states = {**states, **self._next(names)}
            if n == self.slots:
                break
            names = {**self.constants, **code, **answers, **states, "n": n, "looks": looks}
            if any(value(r.condition, names) for r in self._all(t.Reset)):
                since = 0.0
            since += light[n]
            for b, rule in enumerate(self.rules):
                opens[b].append(bool(value(rule.rule, names)))
                gathered[b] += light[n] * opens[b][n]
        return Pixel(opens, states, gathered)

    def _bucket(self, signal: t.Exposure) -> int:
        if signal.bucket is None:
            return 0
        return [rule.name.text for rule in self.rules].index(signal.bucket.text)

    def _next(self, names: Mapping[str, Any]) -> dict[str, Any]:
        """The states that change, each from the values before."""
        return {
            each.name.text: value(each.value, names)
            for each in self._all(t.Next)
            if each.condition is None or value(each.condition, names)
        }
