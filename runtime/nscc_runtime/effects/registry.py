"""The list of effects, and the choice that `--effects` makes of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.diagnostics.suggest import closest
from nscc_runtime.effects.crosstalk import CROSSTALK
from nscc_runtime.effects.dark import DARK
from nscc_runtime.effects.effect import Effect
from nscc_runtime.effects.photodiode import FULL_WELL, READ, RESET
from nscc_runtime.effects.photons import PRNU, SHOT
from nscc_runtime.effects.readout import ADC, ADC_NOISE
from nscc_runtime.effects.registers import ANALOG, LEAKAGE, REGISTER
from nscc_runtime.effects.timing import DEAD_TIME, DECAY, LAG, MOTION
from nscc_runtime.sensor.parameters import SCHEMA
from nscc_runtime.sensor.sensor import Sensor

EFFECTS: tuple[Effect, ...] = (
    SHOT, PRNU, DARK, LAG, MOTION, CROSSTALK, FULL_WELL, RESET, READ, DEAD_TIME, ANALOG, REGISTER,
    LEAKAGE, DECAY, ADC_NOISE, ADC,
)  # fmt: skip
"""In the order in which charge meets them."""

BY_NAME = {effect.name: effect for effect in EFFECTS}
OPTIONAL = tuple(effect.name for effect in EFFECTS if not effect.always)
_WORDS = ("auto", "all", "none")


@dataclass(frozen=True)
class Selection:
    """The effects that are on, `always` ones included, and those that were named one by one.

    With `auto` a planner decides on those that were not named; `on` has them all.
    """

    on: frozenset[str]
    forced: frozenset[str]
    auto: bool = False

    @property
    def noiseless(self) -> bool:
        """Whether only what is always on is on: the exposure is the exact sum of light."""
        return not self.on & set(OPTIONAL)

    def __contains__(self, effect: object) -> bool:
        return isinstance(effect, Effect) and effect.name in self.on


def selected(text: str) -> Selection:
    """The effects of `auto`, `all`, `none` or `a,b`, each followed by changes `+a` and `-a`.

    Changes alone start from `none` where the first adds, from `all` where it takes away.
    Raises Rejected (NS0756, status 2) for anything else.
    """
    parts = [part.strip() for part in text.split(",") if part.strip()]
    if not parts:
        raise _wrong("--effects names no effect", f"write one of {', '.join(_WORDS)}, or effects")
    auto = parts[0] == "auto"
    on = set(OPTIONAL) if parts[0] in ("auto", "all") or parts[0][0] == "-" else set()
    forced: set[str] = set()
    for index, part in enumerate(parts):
        if part in _WORDS:
            if index:
                raise _wrong(f"--effects has `{part}` after its beginning", f"put `{part}` first")
            continue
        add, name = part[0] != "-", part.lstrip("+-") if part[0] in "+-" else part
        effect = named(name)
        if effect.always and not add:
            raise _wrong(f"the effect `{name}` is always on", f"leave -{name} out")
        if not effect.always:
            (on.add if add else on.discard)(name)
            forced.add(name)
    always = {effect.name for effect in EFFECTS if effect.always}
    return Selection(frozenset(on | always), frozenset(forced), auto)


def effects_json(sensor: Sensor) -> list[dict[str, Any]]:
    """The effects as JSON values; the parameters' defaults are those of `sensor`."""
    return [
        {
            "name": effect.name,
            "title": effect.title,
            "kind": effect.kind,
            "model": effect.model,
            "predicted": effect.contribution,
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
                }
                for row in map(SCHEMA.by_path.__getitem__, effect.parameters)
            ],
        }
        for effect in EFFECTS
    ]


def named(name: str) -> Effect:
    """The effect of that name; NS0756 (status 2) if there is none."""
    found = BY_NAME.get(name)
    if found is None:
        near = closest(name, (*BY_NAME, *_WORDS))
        raise _wrong(
            f"there is no effect {name[:60]!a}",
            f"did you mean `{near}`?" if near else "`nscc effects` lists them",
        )
    return found


def _wrong(what: str, help_text: str) -> Rejected:
    return Rejected(
        Diagnostic(
            "NS0756",
            what,
            notes=(
                "--effects takes auto, all, none or names separated by commas; +NAME adds one, "
                "-NAME leaves one out",
                f"the effects are {', '.join(BY_NAME)}",
            ),
            helps=(help_text,),
        ),
        status=2,
    )
