"""Random programs of version 2, as texts, and the reference's frames of such programs."""

from __future__ import annotations

from functools import partial
from random import Random

from nscc_runtime.looked_frames import frames

looking_frames = partial(frames, by_words=True)
"""Frames of a program that looks, by the reference."""
LEVELS = ("12%", "25%", "45%", "22.5%", "9000e", "40lsb", "100lsb", "70%")


_TELLING = 0.7
"""The part of the programs whose shutters fall once, at a look that a state remembers: the readout
tells how long they were open. Of the others it often does not."""


def random_program(seed: int) -> str:
    """A program that reads well; it need not fit a chip, nor tell how long its pixels were open."""
    choose = Random(seed)
    slots = choose.randint(2, 6)
    lines = ["nsl 2", f"frame {slots} slots of 1ms"]
    per_pixel = choose.random() < 0.15
    if per_pixel:
        lines.append("target scamp5-algorithm1")
    fields = [f"f{i}" for i in range(choose.choice((0, 0, 1, 1, 2)))]
    lines += [f"code {name} : 0..{choose.randint(1, 2)}" for name in fields]
    if len(fields) == 1 and choose.random() < 0.3:
        lines.append("code level : 90..92")
        fields.append("level")
    buckets = [""] if choose.random() < 0.75 else ["a", "b"]
    senses = [f"s{i}" for i in range(choose.choice((1, 1, 1, 2)))]
    for name in senses:
        lines.append(_sense(choose, name, slots, buckets, fields))
    states = {f"t{i}": choose.choice((1, 2, 2, 3, 4)) for i in range(choose.choice((1, 1, 2, 2)))}
    bits = {name for name, most in states.items() if most == 1 and choose.random() < 0.6}
    for name, most in states.items():
        kept = " kept" if choose.random() < 0.2 else ""
        values = "bit" if name in bits else f"0..{most}"
        start = choose.randint(0, most) if choose.random() < 0.3 else 0
        lines.append(f"state {name} : {values} = {start}{kept}")
    known = _Known(choose, fields, senses, {n: m for n, m in states.items() if n not in bits}, bits)
    for name, most in states.items():
        when = f" when {known.condition()}" if choose.random() < 0.8 else ""
        value = known.condition() if name in bits else known.number(name, most)
        lines.append(f"next {name} = {value}{when}")
    if choose.random() < 0.3:
        condition = known.condition() if per_pixel else f"n % {choose.randint(2, 4)} == 1"
        lines.append(f"reset when {condition}")
    rules = [known.rule(slots) for _ in buckets]
    if choose.random() < _TELLING:
        lines.append(f"state closed : 0..{slots} = 0")
        lines.append(f"next closed = looks when closed == 0 and ({known.condition()})")
        rules = [known.falling(slots, first=not k) for k in range(len(buckets))]
        states["closed"] = slots
    for bucket, rule in zip(buckets, rules, strict=True):
        lines.append(f"{f'bucket {bucket} ' * bool(bucket)}open when {rule}")
    lines.append("read " + ", ".join(states))
    return "\n".join(lines) + "\n"


def _sense(choose: Random, name: str, slots: int, buckets: list[str], fields: list[str]) -> str:
    at = sorted(choose.sample(range(1, slots + 1), choose.randint(1, min(3, slots))))
    when, looks = f"n in {at}", len(at)
    if choose.random() < 0.3:
        every = choose.randint(1, 3)
        when, looks = f"n % {every} == 0", slots // every
        if not looks:
            when, looks = "n == 1", 1
    signal = "light"
    if choose.random() < 0.3:
        signal = f"exposure {choose.choice(buckets)}".strip()
    level = choose.choice(LEVELS)
    if choose.random() < 0.2:
        level = f"[{', '.join(choose.choice(LEVELS) for _ in range(looks))}]"
    elif "level" in fields and choose.random() < 0.7:
        level = "level"
    return f"sense {name} when {signal} {choose.choice('>><')} {level} at {when}"


class _Known:
    """Expressions over what a rule may read."""

    def __init__(
        self,
        choose: Random,
        fields: list[str],
        senses: list[str],
        numbers: dict[str, int],
        bits: set[str],
    ) -> None:
        self.choose, self.fields, self.senses = choose, fields, senses
        self.numbers, self.bits = numbers, sorted(bits)

    def atom(self) -> str:
        """A condition without operators."""
        kinds = ["sense", "state", "state", *["field"] * bool(self.fields)]
        kind = self.choose.choice(kinds)
        if kind == "sense":
            return self.choose.choice(self.senses)
        if kind == "field":
            return f"{self.choose.choice(self.fields)} {self._sign()} {self.choose.randint(0, 2)}"
        names = [*self.numbers, *self.bits]
        name = self.choose.choice(names)
        if name in self.bits:
            return name
        return f"{name} {self._sign()} {self.choose.randint(0, self.numbers[name])}"

    def _sign(self) -> str:
        return self.choose.choice(("==", "!=", "<", ">="))

    def condition(self) -> str:
        """Atoms and what joins them."""
        parts = [
            f"{'not ' * (self.choose.random() < 0.25)}({self.atom()})"
            for _ in range(self.choose.choice((1, 1, 2, 2, 3)))
        ]
        return f" {self.choose.choice(('and', 'or', 'xor', 'and'))} ".join(parts)

    def number(self, name: str, most: int) -> str:
        """A next value that stays within 0..most."""
        forms = [
            f"min({name} + 1, {most})",
            f"({name} + 1) % {most + 1}",
            f"min(looks, {most})",
            f"{most} if {self.condition()} else {name}",
            f"max({name} - 1, 0)",
            f"n % {most + 1}",
        ]
        forms += [f"min({field}, {most})" for field in self.fields]
        return self.choose.choice(forms)

    def falling(self, slots: int, *, first: bool) -> str:
        """When a shutter is open that falls, or of a second bucket rises, at a look."""
        closed = f"closed {'==' if first else '!='} 0"
        more = [f"n < {self.choose.randint(1, slots)}", f"n != {self.choose.randrange(slots)}"]
        if self.fields:
            more.append(f"{self.choose.choice(self.fields)} {self._sign()} 1")
        if self.choose.random() < 0.4:
            return f"{closed} and {self.choose.choice(more)}"
        return closed

    def rule(self, slots: int) -> str:
        """When a shutter is open."""
        if self.choose.random() < 0.3:
            return f"({self.condition()}) and n < {self.choose.randint(1, slots)}"
        return self.condition()
