"""What plans need of a program on a scene: to be made, to be run, to be audited."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import Selection, selected
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.emulator.capture import check_size
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.planner.audit import Audit, audit
from nscc_runtime.planner.capture import prepared
from nscc_runtime.planner.choose import Chooser, plan_for, predicted_for
from nscc_runtime.planner.frames import made_ready, planned_frames
from nscc_runtime.planner.fused_loop import fused
from nscc_runtime.planner.pixel_loop import run_pixels
from nscc_runtime.planner.plan import Plan
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.tolerance import DEFAULT, Given
from nscc_runtime.pool import threads_of


class Planning(Protocol):
    """A program on a scene. `seed` is that of the frames' noise, `count` how many of them."""

    @property
    def compiled(self) -> bool:
        """Whether its loops are machine code already."""
        ...

    def ready(self) -> None:
        """Analyse the program. Raises Rejected where it cannot run."""
        ...

    def signal_e(self) -> float:
        """See `nscc_runtime.planner.tolerance.Follows`."""
        ...

    def noise_e(self) -> float:
        """See `nscc_runtime.planner.tolerance.Follows`."""
        ...

    def plan(
        self, tolerance: Given, effects: Selection, tolerance_max: Given | None = None
    ) -> Plan:
        """The cheapest plan within the tolerance, its worst pixel within `tolerance_max`. Raises
        Rejected (NS0746) where one of them is none."""
        ...

    def predicted(self, plan: Plan) -> Plan:
        """What the decisions of a plan for another scene make of this one. A tolerance that is a
        part of the scene is one of this scene."""
        ...

    @property
    def open_part(self) -> NDArray[np.float32]:
        """The part (rows, cols) of the frame whose light each pixel sees; all where they look."""
        ...

    def serves(self, plan: Plan) -> bool:
        """Whether a plan for a scene with light of the same kind, and no weaker, keeps its promise
        on this one: cheaper than a new plan."""
        ...

    def frames(self, plan: Plan, seed: int, count: int) -> Iterable[Frame]:
        """Frames 0 .. `count` - 1 under a plan."""
        ...

    def audit(self, plan: Plan, seed: int, count: int) -> Audit:
        """A plan's frames against the reference's."""
        ...


@dataclass(frozen=True, eq=False)
class PlanningBySums:
    """Of a program whose shutters are fixed. `threads`, None for all processors, change no bit;
    `torch_device`: where frames are drawn and added up, None for the processor.
    """

    container: Container
    sensor: Sensor
    light: Light
    device_seed: int = 0
    threads: int | None = None
    torch_device: str | None = None

    @property
    def compiled(self) -> bool:
        """See `Planning`."""
        return fused.is_compiled() and run_pixels.is_compiled()

    def ready(self) -> None:
        """See `Planning`."""
        for loop in (fused, run_pixels):
            if not loop.is_compiled():  # at once, so that one run waits for all of them
                loop.load()
        self._program  # noqa: B018  # made when it is asked for

    @cached_property
    def _program(self) -> Program:
        return made_ready(self.container, self.sensor)

    def signal_e(self) -> float:
        """See `Planning`."""
        return self._forecast.signal_e()

    def noise_e(self) -> float:
        """See `Planning`."""
        return self._forecast.noise_e()

    @property
    def _forecast(self) -> Chooser:
        check_size(self.container, self.light)
        auto, threads = selected("auto"), threads_of(self.threads)
        return Chooser(self._program, self.light, self.device_seed, threads, DEFAULT, None, auto)

    def plan(
        self, tolerance: Given, effects: Selection, tolerance_max: Given | None = None
    ) -> Plan:
        """See `Planning`."""
        return plan_for(
            self._program, self.light, tolerance, effects, self.device_seed, tolerance_max,
            threads_of(self.threads),
        )  # fmt: skip

    def predicted(self, plan: Plan) -> Plan:
        """See `Planning`."""
        threads = threads_of(self.threads)
        return predicted_for(self._program, self.light, plan, self.device_seed, threads)

    @property
    def open_part(self) -> NDArray[np.float32]:
        """See `Planning`."""
        return self._program.open_part

    def serves(self, plan: Plan) -> bool:
        """See `Planning`: errors by sums grow with light."""
        return True

    def frames(self, plan: Plan, seed: int, count: int) -> Iterable[Frame]:
        """See `Planning`."""
        return planned_frames(
            self._program, self.light, plan, seed, self.device_seed, count, self.threads,
            self.torch_device,
        )  # fmt: skip

    def audit(self, plan: Plan, seed: int, count: int) -> Audit:
        """See `Planning`."""
        exposed = prepared(
            self._program, self.light, plan, device_seed=self.device_seed, threads=self.threads
        )
        return audit(exposed, seed, count)
