"""The declaration of an effect and of its parameters, from which all simulations take what they
need.

The reference calls an effect's functions at their stages of a frame (`STAGES`). The fast paths
support the parts of `nscc_runtime.effects.parts` and simulate an effect by its parts. An effect
without suitable parts declares that a path cannot simulate it; a run that keeps this effect uses a
slower path, in the end the reference. Planning measures the change that an effect causes in a
scene.

Reading and writing sensor files, overriding values, the attributes of a `Sensor` and `nscc effects`
follow from the declared parameters."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from dataclasses import field as field_of
from types import MappingProxyType
from typing import Any, Literal, TypeVar, get_args

from nscc.chips.target import Target
from nscc.record import Record
from nscc.toml.kinds import Number
from nscc.toml.schema import Key
from nscc_runtime.effects.parts import CodeErrors, Codes, Part
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import OnDevice

OURS = "this project's default: not public"
TARGET = "the target table"
CHIP = "chip frames: fit to 404 public frames of a SCAMP-5, docs/silicon.md"
PUBLISHED = "publication: "
"""How the source of a value starts that was published."""

Default = float | Callable[[Target, Mapping[str, float]], float] | None
"""A number; a function of the target and of the preceding parameters; or None for the target's
value of the same name."""


@dataclass(frozen=True, slots=True)
class Parameter(Key):
    """A row of the sensor's schema: a number with unit, range and default. Under a heading,
    parameters are sorted by `place`. Calling a parameter with a sensor returns its value."""

    kind: Number
    place: int = 0

    def __call__(self, sensor: Sensor) -> float:
        """Return the value of the parameter on a sensor."""
        return sensor.values[self.name]

    @property
    def basis(self) -> str:
        """What the default rests on: "chip frames", a "publication", or an "assumption", which also
        stands for values of the target. It is the part of `source` before the colon."""
        basis, colon, _ = self.source.partition(":")
        return basis if colon and self.source.startswith((CHIP, PUBLISHED)) else "assumption"

    def default_for(self, target: Target, values: Mapping[str, float]) -> float:
        """Return the default on a target, given the values by name of the parameters before it in a
        sensor file. Raises AttributeError if the target has no value that the default names."""
        if self.default is None:
            return float(getattr(target, self.name))
        return float(self.default(target, values) if callable(self.default) else self.default)


def parameter(
    name: str,
    heading: str,
    default: Default,
    unit: str,
    low: float,
    high: float,
    meaning: str,
    source: str = OURS,
    *,
    low_excluded: bool = False,
    high_excluded: bool = False,
    place: int = 0,
) -> Parameter:
    """Declare a parameter of the sensor file for an effect.

    `name` ends in its unit, `heading` is a key of `HEADINGS`, under which it is listed. `default`
    is a number, a function of target and preceding values, or None for the target's value of this
    name. Values lie between `low` and `high` in `unit`; with `low_excluded` or `high_excluded` that
    end itself is not allowed. `meaning` is a text for the list of effects, `source` says where the
    default comes from, and `place` orders the parameters under a heading."""
    kind = Number(low, high, unit, low_excluded, high_excluded)
    # "": sensor files have no sections.
    return Parameter("", name, kind, meaning, default, source, heading=heading, place=place)


MOST_E = 1e15

HEADINGS = {
    "range": "what PIX and the registers hold",
    "light": "what becomes of the light",
    "dark": "charge without light",
    "noise": "of the photodiode",
    "comparator": "how well pixels compare",
    "analog": "errors of analog words: additions read two sources or more, moves fewer",
    "memory": "what registers lose",
    "readout": "the ADC",
}
"""The headings of a sensor file in order, each with an explanation."""

MARKED = {
    "well": ("well", "PIX was full when a word added what it held"),
    "subtracted": ("well", "PIX was full when a word subtracted what it held"),
    "level": ("level", "PIX was full when a word read the level of its reset"),
    "registers": ("registers", "registers lost more than `least_e` of what they were to hold"),
    "codes": ("codes", "the code is the last of the scale"),
}
"""The kinds of marks: the stage that sets each, and its meaning. Each belongs to one effect."""


class Mark(Record):
    """A bit of `saturated_by`, a power of two, and its name. It is set where an effect has clipped
    a value; that of registers only if more than `least_e` electrons (a function of the sensor) are
    lost.

    A mark follows the value. A word that reads a full PIX marks its result as added or as
    subtracted. Every further word inverts its result and exchanges the two. So a full PIX that no
    exposure depends on leaves no mark, and a subtracted full PIX, such as the reset level, differs
    from an added one. Losses of registers accumulate in the same way. PIX is the photodiode."""

    bit: int
    name: str
    least_e: Callable[[Sensor], float] = lambda _sensor: 0.0


Kind = Literal["fixed", "random", "both", "after"]
P = TypeVar("P", bound=Part)

RESERVED = ("auto", "all", "none")
"""Words with a special meaning in `--effects`, which no effect can have as name."""

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
    "pattern": "(sensor, device_seed, shape) -> codes (rows, cols), which a chip adds to every "
    "frame before it is rounded",
    "common": "(sensor) -> codes, the standard deviation of an error of all codes of a readout",
    "columns": "(sensor) -> six weights of the converter's noise of a pixel and of the five below "
    "it in its column; their squares add up to 1",
    "codes": "(sensor, exposure, noise, top) -> uint8 codes of exposures, `noise` codes off",
}
"""The stages of a frame in order, and the function of an effect at each stage.
`nscc_runtime.effects.views` defines `slots`, `pixels` and `word`."""


class CannotHave(Record):
    """Declares that the loops or sums cannot simulate an effect, with the reason."""

    reason: str


class InLoop(Record):
    """The fields of the loop over words that an effect sets, by name; without any, the loop has
    nothing to do for it.

    Names are fields of the records in `nscc_runtime.execution.layout`. `switch`: the field of
    `Switches` that turns the effect on. `numbers`: functions of the sensor for fields of `Numbers`.
    `patterns`: its fixed patterns, for fields of `FixedPatterns`. `draws`: the field of `WordKeys`
    for its random key, if it has no `Errors`."""

    switch: str | None = None
    numbers: Mapping[str, Callable[[Sensor], float]] = MappingProxyType({})
    patterns: Mapping[str, OnDevice] = MappingProxyType({})
    draws: str | None = None


_UNNEEDED = InLoop()
"""The loop over words has nothing to do for an effect."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Effect:
    """One effect of the sensor.

    `nscc_runtime.effects.registry.register` checks that the declaration is complete.

    Attributes
    ----------
    stream : int
        Number of its random stream, which never changes.
    kind : {"fixed", "random", "both", "after"}
        Fixed in every frame, new in every frame, both, or after the exposure (readout only).
    model, cost, applied, size, absent : str
        Texts: the model with its formula, the cost of simulation, the place in the reference, the
        size of the change of exposures, and when the effect changes nothing.
    parameters : tuple of Parameter
        The sensor parameters that it depends on.
    reference : mapping
        Its functions in the reference, by stage.
    sums, words
        Its parts in sums over slots, and its fields in the loops over words, by default none.
    cost_ns, light_ns : float
        Measured nanoseconds per pixel saved by leaving it out when the sums of a scene are
        prepared, to a factor of about two, and additional ones per frame of light. The costs of
        each frame follow from its parts (`nscc_runtime.planning.prices`).
    always : bool
        Whether it cannot be left out.
    marks : mapping
        The bits that mark clipped values in a frame (`nscc_runtime.effects.effect`).
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
    words: InLoop | CannotHave = _UNNEEDED
    size: str = ""
    absent: str = "exactly nothing with this sensor, scene and program"
    parameters: tuple[Parameter, ...] = ()
    cost_ns: float = 0.0
    light_ns: float = 0.0
    always: bool = False
    marks: Mapping[str, Mark] = field_of(default_factory=dict)

    def summed_ns(self, frames: int) -> float:
        """Return the nanoseconds per pixel saved by leaving the effect out when the sums of a scene
        with `frames` frames of light are prepared."""
        return self.cost_ns + self.light_ns * frames

    def parts_of_kind(self, kind: type[P]) -> list[P]:
        """Return the parts of the effect, in sums over slots, that are instances of `kind`; empty
        if it has none or sums cannot have it."""
        if isinstance(self.sums, CannotHave):
            return []
        return [member for member in self.sums if isinstance(member, kind)]

    def code_error_lsb(self, sensor: Sensor) -> float | None:
        """Return the error of a converter code that the effect causes before rounding or by
        rounding, as its standard deviation in codes; None for effects without one."""
        error_lsb = 1.0 / math.sqrt(12.0) if self.parts_of_kind(Codes) else None
        for errors in self.parts_of_kind(CodeErrors):
            error_lsb = errors.sigma_lsb(sensor)
        return error_lsb

    def lacks(self) -> list[str]:
        """Return the missing or wrong entries of the declaration, each a text that completes "it
        lacks"; empty if it is complete. Fields of any type are checked, because other code may
        declare effects."""
        missing = [
            f"`{name}`, a text"
            for name in ("name", "title", "model", "size", "cost", "applied", "absent")
            if not (isinstance(getattr(self, name), str) and getattr(self, name).strip())
        ]
        if not re.fullmatch(r"[a-z][a-z0-9_]*", str(self.name)) or self.name in RESERVED:
            missing.append("a `name` of small letters, digits, `_`; auto, all and none are choices")
        if not (isinstance(self.stream, int) and 0 < self.stream < 1 << 32):
            missing.append("`stream`, a number from 1 to 2**32 - 1")
        if self.kind not in get_args(Kind):
            missing.append(f"`kind`, one of {', '.join(get_args(Kind))}")
        missing += [
            f"`parameters`, each a parameter(..) under one of the headings {', '.join(HEADINGS)}"
            for row in self.parameters
            if not (isinstance(row, Parameter) and row.heading in HEADINGS)
        ]
        if not self.reference or not all(
            stage in STAGES and callable(call) for stage, call in self.reference.items()
        ):
            missing.append(f"`reference`, a function at one of the stages {', '.join(STAGES)}")
        if not isinstance(self.sums, tuple | CannotHave):
            missing.append("`sums`, its parts in sums over slots, or CannotHave(reason)")
        elif not isinstance(self.sums, CannotHave):
            strange = [entry for entry in self.sums if not isinstance(entry, Part)]
            missing += [
                f"`sums` with known parts only, but {entry!r:.60} is unknown" for entry in strange
            ]
            part_stages = {
                getattr(member, "at", member.stage) for member in self.parts_of_kind(Part)
            }
            # Both must name the same stages: else one of the simulations misses the effect.
            bare = {*self.reference} ^ part_stages
            if not strange and bare:
                text = "`sums` that match `reference`: one of them has no "
                missing.append(text + ", ".join(sorted(bare)))
        if not isinstance(self.words, InLoop | CannotHave):
            missing.append("`words`, InLoop(..) or CannotHave(reason)")
        if not isinstance(self.marks, Mapping) or not all(
            at in MARKED and MARKED[at][0] in self.reference and isinstance(mark, Mark)
            for at, mark in self.marks.items()
        ):
            missing.append(
                f"`marks` of {', '.join(MARKED)} only, each a Mark(..) at a stage of `reference`"
            )
        for name in ("cost_ns", "light_ns"):
            cost = getattr(self, name)
            if not (isinstance(cost, int | float) and 0 <= cost < math.inf):
                missing.append(f"`{name}`, a number of 0 or more")
        return missing
