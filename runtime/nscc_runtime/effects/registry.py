"""The registered effects: those of this package, then those of other distributions.

Incomplete declarations are refused when they are registered, so other code can rely on them."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, wraps
from typing import ParamSpec, TypeVar

from nscc.diagnostics.diagnostic import rejected
from nscc.mappings import JsonObject
from nscc.plugins import added
from nscc_runtime.effects.adc import ADC, ADC_NOISE
from nscc_runtime.effects.analog import ANALOG
from nscc_runtime.effects.black_sun import BLACK_SUN
from nscc_runtime.effects.comparator import COMPARATOR_NOISE, COMPARATOR_OFFSET
from nscc_runtime.effects.crosstalk import CROSSTALK
from nscc_runtime.effects.dark import DARK
from nscc_runtime.effects.dead_time import DEAD_TIME
from nscc_runtime.effects.decay import DECAY
from nscc_runtime.effects.effect import Effect, InLoop, Mark, Parameter
from nscc_runtime.effects.full_well import FULL_WELL
from nscc_runtime.effects.lag import LAG
from nscc_runtime.effects.leakage import LEAKAGE
from nscc_runtime.effects.motion import MOTION
from nscc_runtime.effects.parts import Converter, Errors, Part
from nscc_runtime.effects.prnu import PRNU
from nscc_runtime.effects.read import READ
from nscc_runtime.effects.readout import COLUMN_NOISE, READOUT_LEVEL, READOUT_PATTERN
from nscc_runtime.effects.register import REGISTER
from nscc_runtime.effects.reset import RESET
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.shot import SHOT
from nscc_runtime.effects.spreading import SPREADING

P = ParamSpec("P")
R = TypeVar("R")

_OURS = (
    SHOT, PRNU, DARK, LAG, MOTION, CROSSTALK, FULL_WELL, RESET, READ, DEAD_TIME, BLACK_SUN, ANALOG,
    REGISTER, COMPARATOR_OFFSET, COMPARATOR_NOISE, LEAKAGE, DECAY, ADC_NOISE, SPREADING,
    COLUMN_NOISE, READOUT_PATTERN, READOUT_LEVEL, ADC,
)  # fmt: skip
"""The effects of this package, in the order in which they act on charge."""

_registered: dict[str, Effect] = {}
_complete = False
"""Whether the effects of other distributions have been loaded."""


def register(effect: Effect) -> None:
    """Register an effect. Raises Rejected (NS0905) with all missing entries of its declaration if
    it is incomplete, else with all conflicts with registered effects; then nothing is
    registered."""
    lacking = (
        effect.lacks() if isinstance(effect, Effect) else ["a declaration: it is not an Effect"]
    )
    lacking = lacking or _clashes(effect)
    if lacking:
        name = getattr(effect, "name", None)
        shown = name if isinstance(name, str) and name else type(effect).__name__
        raise rejected(
            "NS0905",
            f"the effect {shown[:60]!a} cannot be used: it lacks {lacking[0]}",
            notes=tuple(f"it also lacks {entry}" for entry in lacking[1:]),
            helps=("docs/emulator.md describes the declaration of an effect",),
        )
    _registered[effect.name] = effect


def _clashes(effect: Effect) -> list[str]:
    """Return the conflicts of `effect`, whose declaration is complete, with the registered effects,
    each a text that completes "it lacks"; empty if there is none. Names, random streams, parameter
    names, bits of marks and most parts belong to one effect only."""
    known = {
        row.name: row for other_effect in _registered.values() for row in other_effect.parameters
    }
    conflicts = [
        f"a name of its own for its parameter `{row.name}`"
        for row in effect.parameters
        if known.get(row.name, row) is not row
    ]
    if effect not in _OURS and isinstance(effect.words, InLoop):
        conflicts.append(
            "`words` that is CannotHave: that loop is compiled, for the effects it knows"
        )
    # Each mark is one bit of a byte, which no other effect uses.
    effects = (*_registered.values(), effect)
    bits = [mark.bit for known_effect in effects for mark in known_effect.marks.values()]
    if not {*bits} <= {1 << k for k in range(8)} or len({*bits}) < len(bits):
        conflicts.append("`marks` with bits of their own: powers of two from 1 to 128")
    if effect not in _OURS and effect.always:
        conflicts.append("`always` that is False: without effects the words are executed exactly")
    for other_effect in _registered.values():
        if other_effect.name == effect.name:
            conflicts.append(f"a name of its own: there is an effect `{other_effect.name}`")
        if other_effect.stream == effect.stream:
            conflicts.append(
                f"a stream of its own: {other_effect.stream} is that of `{other_effect.name}`"
            )
        if {"codes"} & effect.reference.keys() & other_effect.reference.keys():
            conflicts.append(f"`reference` without `codes`: it is that of `{other_effect.name}`")
        conflicts += [
            f"`marks` without `{at}`: it is that of `{other_effect.name}`"
            for at in effect.marks.keys() & other_effect.marks.keys()
        ]
        for effect_part in effect.parts_of_kind(Part):
            if other_effect.parts_of_kind(type(effect_part)) and not isinstance(
                effect_part, Errors | Converter
            ):
                kind = type(effect_part).__name__
                conflicts.append(
                    f"`sums` without {kind}: sums have one, that of `{other_effect.name}`"
                )
    return conflicts


def registered() -> tuple[Effect, ...]:
    """Return all effects in the order of registration. The first call loads those of other
    distributions. Raises Rejected (NS0905) if one of these cannot be registered."""
    global _complete
    if not _complete:
        for effect in added("nscc.effects").values():
            if effect not in _registered.values():
                register(effect)
        _complete = True
    return tuple(_registered.values())


def of_registered(make: Callable[P, R]) -> Callable[P, R]:
    """Cache the results of `make` for equal arguments, which must be hashable, as long as the
    registered effects are the same."""

    # The effects are a part of the key only.
    cached: Callable[..., R] = lru_cache(64)(
        lambda _effects, *arguments, **named: make(*arguments, **named)
    )

    @wraps(make)
    def call(*arguments: P.args, **named: P.kwargs) -> R:
        """Return the result for these arguments and the registered effects, cached."""
        return cached(registered(), *arguments, **named)

    return call


def by_name() -> dict[str, Effect]:
    """Return all effects by name, in the order of registration."""
    return {effect.name: effect for effect in registered()}


def optional() -> tuple[str, ...]:
    """Return the names of the effects that can be left out."""
    return tuple(effect.name for effect in registered() if not effect.always)


@of_registered
def marks() -> dict[str, Mark]:
    """Return the saturation marks of all effects by kind, the keys of `MARKED`. Callers must not
    change them."""
    return {at: mark for effect in registered() for at, mark in effect.marks.items()}


@of_registered
def parameters() -> tuple[Parameter, ...]:
    """Return the parameters of all effects, each once, in the order of a sensor file."""
    rows = {row.name: row for effect in registered() for row in effect.parameters}
    return tuple(sorted(rows.values(), key=lambda row: row.place))


def effects_json(sensor: Sensor) -> list[JsonObject]:
    """Return a dict for each effect, in the order of registration, for JSON: its texts, `kind` and
    `always`, and a list of its `parameters`, whose "default" is the value of `sensor`."""
    return [
        {
            "name": effect.name,
            "title": effect.title,
            "kind": effect.kind,
            "model": effect.model,
            "predicted": effect.size,
            "cost": effect.cost,
            "applied": effect.applied,
            "always": effect.always,
            "parameters": [
                {
                    "name": row.name,
                    "unit": row.kind.unit,
                    "default": getattr(sensor, row.name),
                    "low": row.kind.low,
                    "high": row.kind.high,
                    "meaning": row.meaning,
                    "source": row.source,
                    "basis": row.basis,
                }
                for row in effect.parameters
            ],
        }
        for effect in registered()
    ]


for _effect in _OURS:
    register(_effect)
