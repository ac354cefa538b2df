"""The kinds of programs: what the runtime does for each. `nscc.kinds` explains kinds."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.kinds import KindTable
from nscc.lazy import LazyFunctions
from nscc.record import Record
from nscc.words.container import Container
from nscc.words.reach import Reach
from nscc_runtime.sensor import Sensor


class Sent(Record):
    """What a chip sends beside converter codes.

    `exact`: it sent the electrons before the converter, too. `planes`: bits (rows, cols) by digital
    register. `reaches`, `summaries`: see `told_of_planes`."""

    sensor: Sensor
    exact: bool
    planes: Mapping[str, NDArray[np.bool_]]
    reaches: Mapping[str, Reach] | None = None
    summaries: Mapping[str, Any] = MappingProxyType({})


class Exposing(Record):
    """How frames are exposed without a plan.

    `run()` returns frames one after the other, or one frame with all repeats without effects.
    `loop` is the compiled loop that it waits for, and `subject` names it in a message."""

    run: Callable[[], Any]
    loop: Any = None
    subject: str = "emulator"


class RunKind:
    """What the runtime does for a program with fixed shutters.

    The classes of other kinds change it, and may be combined: they call `super`."""

    without_plan = ""
    """Why frames are simulated slot by slot, without a plan; empty if plans apply."""
    note_without_plan = ""
    """What is said if effects are chosen automatically, and there is no plan."""
    is_fast = False
    """Whether frames without a plan need the reference only if it is requested."""
    open_times_known = True
    """Whether the open time of every pixel is known before the exposure. If not, a frame contains
    the open times, and the light that follows from them."""
    takes_films = False
    """Whether each frame of a film may have its own light."""

    def absent_effects(self, container: Container, effects: Any) -> Mapping[str, str]:
        """Return why the chip does not have some of the requested effects, by effect."""
        return {}

    def exposing(
        self, container: Container, light: Any, sensor: Sensor, effects: Any, request: Any
    ) -> Exposing:
        """Return how frames are exposed slot by slot: without effects, or with the reference.

        `effects`: the requested effects that the chip has."""
        exposing: Exposing = LazyFunctions("nscc_runtime.runs.fixed_run").exposing(
            container, light, sensor, effects, request
        )
        return exposing

    def sheet(self, container: Container, title: str) -> Any:
        """Return the figure of `nscc view`: when shutters are open."""
        return LazyFunctions("nscc_runtime.pictures.shutter_sheet").shutter_sheet(container, title)

    def flow(self, container: Container, width: float) -> Any:
        """Return the `DataFlow` below the shutters, or None."""
        return None

    def frame_sheet(self, container: Container, frame: Any, response: Any, title: str) -> Any:
        """Return the figure of a frame; `response()` is its sensor response."""
        readouts = LazyFunctions("nscc_runtime.merge").readouts(container, frame, response())
        return LazyFunctions("nscc_runtime.pictures.images").frame_sheet(readouts, title)

    def sent_frame(self, container: Container, frame: Any, sent: Sent) -> Any:
        """Return the frame with what a chip sent beside it."""
        return LazyFunctions("nscc_runtime.full_codes").marked_frame(container, frame, sent)


KINDS = KindTable(
    RunKind,
    images="nscc_runtime.runs.images_run:ImagesRun",
    looks="nscc_runtime.runs.looks_run:LooksRun",
    stream="nscc_runtime.runs.planes_run:BitPlanesRun",
)
"""The kinds of programs that the runtime knows."""
