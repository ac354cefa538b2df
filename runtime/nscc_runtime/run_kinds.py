"""The kinds of programs: what the runtime does for each. `nscc.kinds` explains kinds."""

from __future__ import annotations

from collections.abc import Mapping
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


class RunKind:
    """What the runtime does for a program with fixed shutters.

    The classes of other kinds change it, and may be combined: they call `super`."""

    without_plan = ""
    """Why frames are simulated slot by slot, without a plan; empty if plans apply."""
    open_times_known = True
    """Whether the open time of every pixel is known before the exposure. If not, a frame contains
    the open times, and the light that follows from them."""
    takes_films = False
    """Whether each frame of a film may have its own light."""

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
