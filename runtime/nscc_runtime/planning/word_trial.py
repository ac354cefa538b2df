"""Trials in which all pixels run through their words or are exposed by the reference. They are used
if sums are too inaccurate for a tolerance, or do not support an effect."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from nscc_runtime.caches import remembered
from nscc_runtime.effects import CannotHave, Effect, everything
from nscc_runtime.execution.frames import Execution
from nscc_runtime.planning.differences import Difference, ExposureErrors
from nscc_runtime.planning.planned_scene import NONE, Move, Names, Setting
from nscc_runtime.planning.summed_trial import SummedTrial

APPROXIMATE = (
    "counts would have to be spread over the slots of most pixels: the weights of a code's slots "
    "differ too much for this tolerance"
)


@dataclass(frozen=True, eq=False)
class WordTrial(SummedTrial):
    """A trial by words. Effects whose error by sums exceeds `limit_e` are not measured by words."""

    limit_e: float = np.inf

    approximations = ()

    @remembered
    def execution(self, setting: Setting) -> Execution:
        kept_effects = self._requested_fast_effects.without(*setting.dropped)
        return Execution("words", kept_effects, kept_effects, self.requested_effects)

    def alone(self, effect: Effect, near_saturation: bool) -> ExposureErrors:
        """Return the error of dropping one effect by words; by sums if that exceeds `limit_e`."""
        by_sums = super().alone(effect, False)
        if effect.name in self.slow or Difference(by_sums, self.sample).rms_e > self.limit_e:
            return by_sums
        fast_effects = everything().without(*(self.forced_off - {effect.name}), *self.slow)
        exposed = (
            self.exposures.expose(Execution("words", effects, effects, everything()), 0)
            for effects in (fast_effects.without(effect.name), fast_effects)
        )
        return ExposureErrors.of(*exposed)

    def approximated(self) -> Difference | None:
        return None

    def together(self, setting: Setting) -> ExposureErrors:
        """Return the error of a setting, relative to words with every effect."""
        full_execution = Execution("words", self._fast_effects, self._fast_effects, everything())
        exposed = self.exposures.expose(self.execution(setting), 0)
        truth = self.exposures.expose(full_execution, 0)
        return ExposureErrors.of(exposed + self._lacked_e, truth)

    def moves(self, free: Names) -> Sequence[Move]:
        """Return a move for each single effect, except those that saturate."""
        return [move for move in super().moves(free) if not move.names & self.saturation]

    def too_large(self, tolerance_e: float) -> Names:
        """Return the empty set: `alone` detects large errors by sums."""
        return NONE

    def settings(self, dropped: Names) -> Sequence[Setting]:
        return [Setting(dropped)]

    def unseen_e2(self, setting: Setting) -> float:
        """Return the allowance for rare pixels near saturation, which lack all dropped effects."""
        return super().unseen_e2(replace(setting, near_dropped=setting.dropped))

    def saved_ns(self, name: str) -> float:
        if name in self.absent | self.saturation:
            return 0.0
        without = self.requested_effects.without(name)
        return self.work.words_ns(self.requested_effects, "all") - self.work.words_ns(
            without, "all"
        )

    def reasons(self, setting: Setting) -> tuple[str, ...]:
        return (APPROXIMATE,)

    def frame_ns(self, setting: Setting) -> tuple[float, float]:
        return self.work.words_ns(self.execution(setting).kept_effects, "all"), 0.0


@dataclass(frozen=True, eq=False)
class ReferenceTrial(WordTrial):
    """A trial by the reference, which supports every effect: dropping one saves no time."""

    def execution(self, setting: Setting) -> Execution:
        return Execution(
            "reference", self.requested_effects, self.requested_effects, self.requested_effects
        )

    def together(self, setting: Setting) -> ExposureErrors:
        """Return the error of the effects that are forced off; the setting is ignored."""
        by = self.exposures
        return ExposureErrors.of(
            by.by_reference(self.requested_effects), by.by_reference(everything())
        )

    def alone(self, effect: Effect, near_saturation: bool) -> ExposureErrors:
        """Return the error of dropping one effect, by sums or, if necessary, by the reference."""
        return SummedTrial.alone(self, effect, False)

    def moves(self, free: Names) -> Sequence[Move]:
        return []

    def noise_ratio(self, setting: Setting) -> float | None:
        """Return 1; None if effects are forced off, because measuring would be slow."""
        return None if self.forced_off else 1.0

    def saved_ns(self, name: str) -> float:
        return self.work.reference_ns if name in self.slow - self.absent else 0.0

    def reasons(self, setting: Setting) -> tuple[str, ...]:
        """Return the reasons for the reference: effects that only it has, or inaccurate sums."""
        slow = [
            f"{e.name}: only the reference has it ({e.words.reason})"
            for e in self.requested_effects.effects
            if e.name in self.slow - self.absent and isinstance(e.words, CannotHave)
        ]
        return tuple(slow) or (APPROXIMATE,)

    def frame_ns(self, setting: Setting) -> tuple[float, float]:
        return self.work.reference_ns, 0.0
