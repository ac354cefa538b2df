"""What an effect is: one declaration, from which every part of the emulator takes what it needs.

The reference runs an effect's functions at the stages of a frame where it acts (`STAGES`). The
fast paths know the parts of `nscc_runtime.effects.parts` and simulate an effect by those it is made
of. One that is made of something else says that a path cannot have it, and a run that keeps it
takes a slower path: in the end the reference. Nothing here foresees what an effect does to a scene:
planning measures that.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from dataclasses import field as field_of
from typing import Any, Literal, TypeVar, get_args

from nscc_runtime.effects.marks import MARKED, Mark
from nscc_runtime.effects.parameters import HEADINGS, Parameter
from nscc_runtime.effects.parts import Part
from nscc_runtime.effects.sensor import Sensor

Kind = Literal["fixed", "random", "both", "after"]
P = TypeVar("P", bound=Part)

RESERVED = ("auto", "all", "none")
"""What `--effects` calls choices."""

STAGES = {
    "scene": "(scene) -> scene: which light falls on the array",
    "light": "(slots, light) -> electrons (N, rows, cols) of light that fall in every slot",
    "response": "(slots, light) -> light as the pixels take it",
    "count": "(slots, light) -> charge that light makes",
    "charge": "(slots, charge) -> charge with what falls without light",
    "neighbours": "(slots, charge) -> charge, exchanged by pixels that touch",
    "digital": "(sensor) -> microseconds for which a digital register keeps its value",
    "time": "(word) -> microseconds after its boundary at which a word ends",
    "well": "(pixels, charge) -> charge that PIX holds",
    "level": "(pixels, charge, word) -> charge that a word finds on a PIX that was reset at its "
    "boundary; none where nothing acts",
    "resets": "(pixels, level, word) -> level that a reset leaves on PIX",
    "reads": "(pixels, level, word) -> level of PIX as a word reads it",
    "words": "(pixels, value, word, destination, sign) -> what a word writes, of its exact result; "
    "-1 is the sign of a register that holds inverted values",
    "compare": "(pixels, total, word) -> the sum that a comparison with 0 sees",
    "registers": "(pixels, value) -> what a register holds of what is written to it",
    "hold": "(pixels, seconds) -> the part of its value that a register keeps so long",
    "readout": "(pixels, exposure, bucket) -> exposure as it leaves the pixels",
    "converter": "(sensor) -> codes, the standard deviation of a code before it is rounded; all "
    "effects' errors are one draw",
    "codes": "(sensor, exposure, noise, top) -> codes of exposures, `noise` codes off",
}
"""Where in a frame effects act, in the order in which a frame comes to them, and the function that
an effect has there; `slots`, `pixels`, `where` and `word` are of `nscc_runtime.effects.views`."""


@dataclass(frozen=True)
class CannotHave:
    """The statement that a path cannot simulate an effect."""

    reason: str


@dataclass(frozen=True)
class InLoop:
    """What the loops over words are told of an effect, by the names of their records
    (`nscc_runtime.execution.layout`): `switch` turns it on, `numbers` are its figures, `device_key`
    is that of its stream on the device, `draws_key` of its draws at words, where it has no
    `Errors`, `function` what is called.
    """

    switch: str | None = None
    numbers: Mapping[str, Callable[[Sensor], float]] = field_of(default_factory=dict)
    device_key: str | None = None
    draws_key: str | None = None
    function: Callable[..., float] | None = None


@dataclass(frozen=True, eq=False, kw_only=True)
class Effect:
    """One effect of the sensor, whole; `nscc_runtime.effects.registry.register` takes no less.

    `stream` is its number in the keys of random numbers and never changes. `kind`: the same in
    every frame; new in every frame; both; after the exposure, in the readout only. `model` is the
    effect in words with its formula, `cost` what simulating it takes, `applied` where the reference
    does, `size` how much it changes exposures, `absent` why it may change nothing. `parameters`:
    the sensor's that it depends on. `reference`: its functions by stage. `sums`: its parts in sums
    over slots; `words`: in the loops over the words of single pixels and of pixels that look.
    `cost_ns`: nanoseconds a pixel that leaving it out of sums saves, measured, to a factor of about
    two, and `light_ns` as many more for each frame of light; what it costs elsewhere follows from
    its parts (`nscc_runtime.planning.prices`).
    `always` effects cannot be left out. `marks`: how a frame tells where it cut values off, by what
    is marked (`nscc_runtime.effects.marks`).
    """

    name: str
    stream: int
    kind: Kind
    title: str
    model: str
    cost: str
    applied: str
    reference: Mapping[str, Callable[..., Any]]
    sums: tuple[Part, ...] | CannotHave
    words: InLoop | CannotHave
    size: str = ""
    absent: str = "exactly nothing with this sensor, scene and program"
    parameters: tuple[Parameter, ...] = ()
    cost_ns: float = 0.0
    light_ns: float = 0.0
    always: bool = False
    marks: Mapping[str, Mark] = field_of(default_factory=dict)

    def summed_ns(self, frames: int) -> float:
        """Nanoseconds a pixel that leaving it out of sums over so many frames of light saves."""
        return self.cost_ns + self.light_ns * frames

    def parts(self, kind: type[P]) -> list[P]:
        """Its parts of that kind in sums over slots."""
        if isinstance(self.sums, CannotHave):
            return []
        return [part for part in self.sums if isinstance(part, kind)]

    def lacks(self) -> list[str]:
        """What this declaration lacks, in words."""
        found = [
            f"`{name}`, a text"
            for name in ("name", "title", "model", "size", "cost", "applied", "absent")
            if not (isinstance(getattr(self, name), str) and getattr(self, name).strip())
        ]
        if not re.fullmatch(r"[a-z][a-z0-9_]*", str(self.name)) or self.name in RESERVED:
            found.append("a `name` of small letters, digits, `_`; auto, all and none are choices")
        if not (isinstance(self.stream, int) and 0 < self.stream < 1 << 32):
            found.append("`stream`, a number from 1 to 2**32 - 1")
        if self.kind not in get_args(Kind):
            found.append(f"`kind`, one of {', '.join(get_args(Kind))}")
        found += [
            f"`parameters`, each a parameter(..) under one of the headings {', '.join(HEADINGS)}"
            for row in self.parameters
            if not (isinstance(row, Parameter) and row.heading in HEADINGS)
        ]
        if not self.reference or not all(
            stage in STAGES and callable(call) for stage, call in self.reference.items()
        ):
            found.append(f"`reference`, a function at one of the stages {', '.join(STAGES)}")
        if not isinstance(self.sums, tuple | CannotHave):
            found.append("`sums`, its parts in sums over slots, or CannotHave(reason)")
        elif not isinstance(self.sums, CannotHave):
            strange = [each for each in self.sums if not isinstance(each, Part)]
            found += [f"`sums` of known parts only, and {each!r:.60} is none" for each in strange]
            made = {getattr(part, "at", part.stage) for part in self.parts(Part)}
            bare = {*self.reference} ^ made
            if not strange and bare:
                text = "`sums` that go with `reference`: one of them has no "
                found.append(text + ", ".join(sorted(bare)))
        if not isinstance(self.words, InLoop | CannotHave):
            found.append("`words`, InLoop(..) or CannotHave(reason)")
        if not isinstance(self.marks, Mapping) or not all(
            at in MARKED and MARKED[at][0] in self.reference and isinstance(mark, Mark)
            for at, mark in self.marks.items()
        ):
            found.append(
                f"`marks` of {', '.join(MARKED)} only, each a Mark(..) at a stage of `reference`"
            )
        for name in ("cost_ns", "light_ns"):
            cost = getattr(self, name)
            if not (isinstance(cost, int | float) and 0 <= cost < math.inf):
                found.append(f"`{name}`, a number from 0 on")
        return found
