"""Programs with fixed shutters, all of whose pixels run through their words, or are exposed by the
reference: where sums would approximate too much for a tolerance, or cannot have an effect."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from nscc_runtime.effects import Effect, everything
from nscc_runtime.execution.frames import Execution
from nscc_runtime.planning.differences import Difference, Errors
from nscc_runtime.planning.summed_trial import SummedTrial
from nscc_runtime.planning.trial import NONE, Move, Names, Setting, slow_reason
from nscc_runtime.remembered import remembered

APPROXIMATE = (
    "counts would have to be spread over the slots of most pixels: the weights of a code's slots "
    "differ too much for this tolerance"
)


@dataclass(frozen=True, eq=False)
class WordTrial(SummedTrial):
    """As `SummedTrial`. Effects that make more than `limit_e` by sums are not tried by words."""

    limit_e: float = np.inf

    approximations = ()

    @remembered
    def execution(self, setting: Setting) -> Execution:
        """What a setting comes to."""
        kept_effects = self._requested_fast_effects.without(*setting.dropped)
        return Execution("words", kept_effects, kept_effects, self.requested_effects)

    def alone(self, effect: Effect, near_saturation: bool) -> Errors:
        """By words; what sums show to be too large, by sums."""
        by_sums = super().alone(effect, False)
        if effect.name in self.slow or Difference(by_sums, self.sample).rms_e > self.limit_e:
            return by_sums
        fast_effects = everything().without(*(self.forced_off - {effect.name}), *self.slow)
        exposed = (
            self.exposures.expose(Execution("words", effects, effects, everything()), 0)
            for effects in (fast_effects.without(effect.name), fast_effects)
        )
        return Errors.of(*exposed)

    def approximated(self) -> Difference | None:
        """Nothing."""
        return None

    def together(self, setting: Setting) -> Errors:
        """Beside words with every effect."""
        full_execution = Execution("words", self._fast_effects, self._fast_effects, everything())
        exposed, truth = (
            self.exposures.expose(execution, 0)
            for execution in (self.execution(setting), full_execution)
        )
        return Errors.of(exposed + self._lacked_e, truth)

    def moves(self, free: Names) -> Sequence[Move]:
        """Effects one by one, but for what saturates."""
        return [move for move in super().moves(free) if not move.names & self.saturation]

    def too_large(self, tolerance_e: float) -> Names:
        """Sums have shown it."""
        return NONE

    def settings(self, dropped: Names) -> Sequence[Setting]:
        """All pixels lack the same."""
        return [Setting(dropped)]

    def unseen_e2(self, setting: Setting) -> float:
        """Pixels near saturation are measured as all others are."""
        return 0.0

    def saved_ns(self, name: str) -> float:
        """What leaving an effect out of the words saves."""
        if name in self.absent | self.saturation:
            return 0.0
        without = self.requested_effects.without(name)
        return self.work.words_ns(self.requested_effects, "all") - self.work.words_ns(
            without, "all"
        )

    def reasons(self, setting: Setting) -> tuple[str, ...]:
        """Sums would approximate too much."""
        return (APPROXIMATE,)

    def frame_ns(self, setting: Setting) -> tuple[float, float]:
        """By words alone."""
        return self.work.words_ns(self.execution(setting).kept_effects, "all"), 0.0


@dataclass(frozen=True, eq=False)
class ReferenceTrial(WordTrial):
    """The same in the reference, which has every effect: leaving one out saves nothing."""

    def execution(self, setting: Setting) -> Execution:
        """What a setting comes to."""
        return Execution(
            "reference", self.requested_effects, self.requested_effects, self.requested_effects
        )

    def together(self, setting: Setting) -> Errors:
        """What is forced off, beside the reference with every effect."""
        by = self.exposures
        return Errors.of(by.by_reference(self.requested_effects), by.by_reference(everything()))

    def alone(self, effect: Effect, near_saturation: bool) -> Errors:
        """By sums, or where only the reference has it, in the reference."""
        return SummedTrial.alone(self, effect, False)

    def moves(self, free: Names) -> Sequence[Move]:
        """None."""
        return []

    def noise_ratio(self, setting: Setting) -> float | None:
        """The reference takes too long to tell what forcing effects off makes of it."""
        return None if self.forced_off else 1.0

    def saved_ns(self, name: str) -> float:
        """Nothing, but for what only the reference has."""
        return self.work.reference_ns if name in self.slow - self.absent else 0.0

    def reasons(self, setting: Setting) -> tuple[str, ...]:
        """What only the reference has, or that it is faster than words."""
        slow = [e for e in self.requested_effects.effects if e.name in self.slow - self.absent]
        return tuple(map(slow_reason, slow)) or (APPROXIMATE,)

    def frame_ns(self, setting: Setting) -> tuple[float, float]:
        """By the reference."""
        return self.work.reference_ns, 0.0
