"""Selections of effects, as `--effects` describes them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import hypot
from typing import Any, TypeVar

from nscc.diagnostics.diagnostic import Rejected, rejected, unknown_name
from nscc.diagnostics.suggest import meant
from nscc_runtime.caches import remembered
from nscc_runtime.effects.effect import RESERVED, Effect, Mark
from nscc_runtime.effects.parts import CodeErrors, Errors, Part
from nscc_runtime.effects.registry import by_name, of_registered, registered
from nscc_runtime.effects.sensor import Sensor

P = TypeVar("P", bound=Part)


@dataclass(frozen=True)
class Selection:
    """A set of effects.

    `on`: names of the effects that are on, including those that are always on. `forced`: names that
    the user switched on or off. `auto`: whether a planner decides on the other effects; `on` then
    contains all of these."""

    on: frozenset[str]
    forced: frozenset[str]
    auto: bool = False

    def __reduce__(self) -> tuple[type[Selection], tuple[frozenset[str], frozenset[str], bool]]:
        """Pickle names only: declarations of effects contain functions."""
        return Selection, (self.on, self.forced, self.auto)

    @cached_property
    def without_effects(self) -> bool:
        """Whether only permanent effects are selected: the exposure is the sum of light, without
        noise, losses or saturation."""
        return all(effect.always for effect in self.effects)

    def __contains__(self, effect: object) -> bool:
        """Return whether `effect`, an `Effect`, is simulated; False for anything else, also for a
        name."""
        return isinstance(effect, Effect) and effect.name in self.on

    @cached_property
    def effects(self) -> tuple[Effect, ...]:
        """The effects that are on, in the order of registration."""
        return tuple(effect for effect in registered() if effect in self)

    def acting(self, stage: str) -> list[tuple[Effect, Callable[..., Any]]]:
        """Return the effects that act at `stage` (a key of `STAGES`) of the reference, with their
        functions there, in the order of registration; empty if none does."""
        acting = [effect for effect in self.effects if stage in effect.reference]
        return [(effect, effect.reference[stage]) for effect in acting]

    def at(self, stage: str) -> list[Callable[..., Any]]:
        """Return the functions of the effects at `stage` (a key of `STAGES`, which says what they
        take), in the order in which they are called; empty if no effect acts there."""
        return [does for _, does in self.acting(stage)]

    @remembered
    def marking(self, at: str) -> Mark | None:
        """Return the saturation mark of kind `at` (see `MARKED`); None if no effect on sets it."""
        return next((effect.marks[at] for effect in self.effects if at in effect.marks), None)

    @remembered
    def having(self, kind: type[P]) -> list[tuple[Effect, P]]:
        """Return pairs of an effect that is on and its part that is an instance of `kind`, in the
        order of registration; empty if there is none."""
        return [(effect, member) for effect, member in _parts_of_kind(kind) if effect in self]

    @remembered
    def names(self, *kinds: type[Part]) -> frozenset[str]:
        """Return the names of the effects that have a part of any of these kinds in sums over
        slots."""
        return frozenset(effect.name for kind in kinds for effect, _ in self.having(kind))

    @remembered
    def find_part(self, kind: type[P]) -> P | None:
        """Return the part that is an instance of `kind`; None if no effect that is on has one. Of
        several it is the first; only `Errors` and code errors occur more than once."""
        return next((effect_part for _, effect_part in self.having(kind)), None)

    def require_part(self, kind: type[P]) -> P:
        """Return the part that is an instance of `kind`. Raises ValueError if no effect has one."""
        effect_part = self.find_part(kind)
        if effect_part is None:
            raise ValueError(f"no effect has a part {kind.__name__}")
        return effect_part

    def errors(self) -> list[tuple[Effect, Errors]]:
        """Return the effects with small errors and their parts: reads, then resets, then words."""
        return sorted(self.having(Errors), key=lambda effect_and_part: effect_and_part[1].at)

    def converter_lsb(self, sensor: Sensor) -> float:
        """Return the standard deviation of a converter code before rounding, in codes: over frames,
        and of the fixed pattern over pixels."""
        return hypot(*(part.sigma_lsb(sensor) for _, part in self.having(CodeErrors)))

    def without(self, *names: str) -> Selection:
        """Return the selection without the effects called `names`; names that are not on change
        nothing. Equal calls return the same object, because selections cache their parts."""
        return selection_of(self.on.difference(names), self.forced, self.auto)


@lru_cache(4096)
def selection_of(on: frozenset[str], forced: frozenset[str], auto: bool = False) -> Selection:
    """Return the `Selection` of these fields, the same object for equal fields."""
    return Selection(on, forced, auto)


@of_registered
def everything() -> Selection:
    """Return the selection of all effects."""
    return Selection(frozenset(by_name()), frozenset())


@of_registered
def _parts_of_kind(kind: type[P]) -> tuple[tuple[Effect, P], ...]:
    """Return pairs of an effect and its part that is an instance of `kind`."""
    return tuple((effect, part) for effect in registered() for part in effect.parts_of_kind(kind))


@of_registered
def selected(text: str) -> Selection:
    """Parse a selection: `auto`, `all`, `none` or `a,b`, each followed by changes `+a` and `-a`.

    Changes alone start from `none` if the first change adds, and from `all` if it removes. Raises
    Rejected (NS0756, status 2) for any other text, for unknown effects, and for removing an effect
    that is always on."""
    items = [item.strip() for item in text.split(",") if item.strip()]
    if not items:
        raise _invalid_selection(
            "--effects is empty", f"write one of {', '.join(RESERVED)}, or names of effects"
        )
    auto = items[0] == "auto"
    # A text that begins with -NAME removes from all effects; one with a name begins with none.
    from_all = items[0] in ("auto", "all") or items[0][0] == "-"
    on = {effect.name for effect in registered() if effect.always or from_all}
    forced: set[str] = set()
    for index, item in enumerate(items):
        if item in RESERVED:
            if index:
                raise _invalid_selection(
                    f"--effects has `{item}` after its start", f"put `{item}` first"
                )
            continue
        add, name = item[0] != "-", item.lstrip("+-") if item[0] in "+-" else item
        effect = by_name().get(name)
        if effect is None:
            raise _invalid_selection(
                f"unknown effect {name[:60]!a}",
                *meant(name, (*by_name(), *RESERVED), "`nscc effects` lists the effects"),
            )
        if effect.always and not add:
            raise _invalid_selection(f"the effect `{name}` is always on", f"leave -{name} out")
        if not effect.always:
            (on.add if add else on.discard)(name)
            forced.add(name)
    return Selection(frozenset(on), frozenset(forced), auto)


def named(name: str) -> Effect:
    """Return the effect with this name. Raises Rejected (NS0756, status 2) for an unknown name."""
    effect = by_name().get(name)
    if effect is None:
        raise unknown_name(
            "NS0756", "unknown effect '{}'", name, tuple(by_name()), "the effects are {}"
        )
    return effect


def _invalid_selection(message: str, help_text: str) -> Rejected:
    """Return the error NS0756, for the caller to raise, for an invalid `--effects`. `message`: what
    is wrong. `help_text`: what to do instead. Notes explain the syntax and list the effects."""
    return rejected(
        "NS0756",
        message,
        notes=(
            "--effects takes auto, all, none or names separated by commas; +NAME adds an "
            "effect, -NAME removes one",
            f"the effects are {', '.join(by_name())}",
        ),
        helps=(help_text,),
    )
