"""Trials in which all pixels run through their words, or the reference exposes them: used if sums
are too inaccurate for a tolerance, or do not support an effect."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from nscc_runtime.effects import Effect, everything
from nscc_runtime.execution.frames import Execution
from nscc_runtime.method_cache import remembered
from nscc_runtime.planning.differences import Difference, ExposureErrors
from nscc_runtime.planning.summed_trial import SummedTrial
from nscc_runtime.planning.trial import NONE, Move, Names, Setting, slow_reason

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
        """What a setting comes to."""
        kept_effects = self._requested_fast_effects.without(*setting.dropped)
        return Execution("words", kept_effects, kept_effects, self.requested_effects)

    def alone(self, effect: Effect, near_saturation: bool) -> ExposureErrors:
        """See `Trial`: by words, or by sums if these show an error above the limit."""
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
        """See `Trial`: words do not approximate."""
        return None

    def together(self, setting: Setting) -> ExposureErrors:
        """See `Trial`: compared with words with every effect."""
        full_execution = Execution("words", self._fast_effects, self._fast_effects, everything())
        exposed, truth = (
            self.exposures.expose(execution, 0)
            for execution in (self.execution(setting), full_execution)
        )
        return ExposureErrors.of(exposed + self._lacked_e, truth)

    def moves(self, free: Names) -> Sequence[Move]:
        """See `Trial`: single effects, except those that saturate."""
        return [move for move in super().moves(free) if not move.names & self.saturation]

    def too_large(self, tolerance_e: float) -> Names:
        """See `Trial`: `alone` finds them by sums."""
        return NONE

    def settings(self, dropped: Names) -> Sequence[Setting]:
        """See `Trial`: the same effects for all pixels."""
        return [Setting(dropped)]

    def unseen_e2(self, setting: Setting) -> float:
        """See `Trial`: pixels near saturation are sampled as all others are."""
        return 0.0

    def saved_ns(self, name: str) -> float:
        """See `Trial`."""
        if name in self.absent | self.saturation:
            return 0.0
        without = self.requested_effects.without(name)
        return self.work.words_ns(self.requested_effects, "all") - self.work.words_ns(
            without, "all"
        )

    def reasons(self, setting: Setting) -> tuple[str, ...]:
        """See `Trial`: sums are too inaccurate."""
        return (APPROXIMATE,)

    def frame_ns(self, setting: Setting) -> tuple[float, float]:
        """See `Trial`."""
        return self.work.words_ns(self.execution(setting).kept_effects, "all"), 0.0


@dataclass(frozen=True, eq=False)
class ReferenceTrial(WordTrial):
    """A trial by the reference, which supports every effect: dropping one saves no time."""

    def execution(self, setting: Setting) -> Execution:
        """What a setting comes to."""
        return Execution(
            "reference", self.requested_effects, self.requested_effects, self.requested_effects
        )

    def together(self, setting: Setting) -> ExposureErrors:
        """See `Trial`: only the effects that are forced off."""
        by = self.exposures
        return ExposureErrors.of(
            by.by_reference(self.requested_effects), by.by_reference(everything())
        )

    def alone(self, effect: Effect, near_saturation: bool) -> ExposureErrors:
        """See `Trial`: by sums, or by the reference if only it supports the effect."""
        return SummedTrial.alone(self, effect, False)

    def moves(self, free: Names) -> Sequence[Move]:
        """See `Trial`: no move saves time."""
        return []

    def noise_ratio(self, setting: Setting) -> float | None:
        """See `Trial`: not measured with effects forced off, as the reference is slow."""
        return None if self.forced_off else 1.0

    def saved_ns(self, name: str) -> float:
        """See `Trial`: only effects that require the reference."""
        return self.work.reference_ns if name in self.slow - self.absent else 0.0

    def reasons(self, setting: Setting) -> tuple[str, ...]:
        """See `Trial`: effects that only the reference supports, or that it is faster than
        words."""
        slow = [e for e in self.requested_effects.effects if e.name in self.slow - self.absent]
        return tuple(map(slow_reason, slow)) or (APPROXIMATE,)

    def frame_ns(self, setting: Setting) -> tuple[float, float]:
        """See `Trial`."""
        return self.work.reference_ns, 0.0
