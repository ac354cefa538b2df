"""Plans of programs whose pixels look: made, run and audited."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import Selection, selected
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.looking.audit import audit
from nscc_runtime.looking.choose import plan_for, predicted_for, serves
from nscc_runtime.looking.frames import frames, ways_of
from nscc_runtime.looking.sample import Sample
from nscc_runtime.looking.way_loop import run_ways
from nscc_runtime.looking.ways import Ways
from nscc_runtime.planner.audit import Audit
from nscc_runtime.planner.plan import Plan
from nscc_runtime.planner.tolerance import (
    OPTION_MAX,
    Given,
    Tolerance,
    mean_signal_e,
    tolerance_of,
    with_readout_e,
)
from nscc_runtime.pool import threads_of


@dataclass(frozen=True, eq=False)
class PlanningByWays:
    """As `nscc_runtime.planner.planning.Planning` says."""

    container: Container
    sensor: Sensor
    light: Light
    device_seed: int = 0
    threads: int | None = None

    @property
    def compiled(self) -> bool:
        """Whether its loops are machine code already."""
        return run_ways.is_compiled()

    def ready(self) -> None:
        """Analyse the program."""
        self._ways  # noqa: B018  # made when it is asked for

    @cached_property
    def _ways(self) -> Ways:
        return ways_of(self.container, self.sensor)

    def signal_e(self) -> float:
        """See `Planning`."""
        [frame] = frames(
            self.container, self.light, self.sensor, selected("none"),
            device_seed=self.device_seed, threads=self.threads,
        )  # fmt: skip
        return mean_signal_e(frame.exposure_e, self.sensor)

    def noise_e(self) -> float:
        """See `Planning`."""
        return with_readout_e(self._sample.noise_e, self.sensor)

    @cached_property
    def _sample(self) -> Sample:
        return Sample.of(self._ways, self.light)

    def plan(
        self, tolerance: Given, effects: Selection, tolerance_max: Given | None = None
    ) -> Plan:
        """The cheapest plan within the tolerances."""
        allowed, most = self._allowed(tolerance, tolerance_max)
        return plan_for(self._sample, allowed, effects, most)

    def predicted(self, plan: Plan) -> Plan:
        """What the decisions of a plan for another scene make of this one."""
        return predicted_for(self._sample, plan, *self._allowed(plan.asked, plan.asked_max))

    def _allowed(self, tolerance: Given, most: Given | None) -> tuple[Tolerance, Tolerance | None]:
        """What tolerances mean on this scene."""
        allowed = tolerance_of(tolerance, self.sensor, self)
        if most is None:
            return allowed, None
        return allowed, tolerance_of(most, self.sensor, self, OPTION_MAX)

    @property
    def open_part(self) -> NDArray[np.float32]:
        """See `Planning`."""
        return np.ones(self.light.shape, np.float32)

    def serves(self, plan: Plan) -> bool:
        """See `Planning`: tried on a sample of this scene."""
        return serves(self._sample, plan)

    def frames(self, plan: Plan, seed: int, count: int) -> Iterable[Frame]:
        """Frames 0 .. `count` - 1 under a plan."""
        return frames(
            self.container, self.light, self.sensor, plan.kept,
            seed=seed, device_seed=self.device_seed, count=count, threads=self.threads,
        )  # fmt: skip

    def audit(self, plan: Plan, seed: int, count: int) -> Audit:
        """A plan's frames against the reference's."""
        return audit(
            self._ways, self.light, plan,
            seed=seed, device_seed=self.device_seed, frames=count,
            threads=threads_of(self.threads),
        )  # fmt: skip
