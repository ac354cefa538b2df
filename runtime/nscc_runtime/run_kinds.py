"""The kinds of programs: what the runtime does for each. `nscc.kinds` explains kinds."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

from nscc.arrays import Bools
from nscc.diagnostics.diagnostic import rejected
from nscc.kinds import KindTable
from nscc.lazy import LazyFunctions
from nscc.record import Record
from nscc.words.container import Container
from nscc.words.reach import Reach
from nscc_runtime.sensor import Sensor


class Sent(Record):
    """What a chip sends beside converter codes.

    `sensor`: the one that is assumed. `exact`: it sent the electrons before the converter, too.
    `planes`: bits (rows, cols) by digital register. `reaches`: by name, how far around a pixel an
    output depends on values outside the array (None: as in a first frame). `summaries`: by digital
    register, the summary of a plane that is only reported."""

    sensor: Sensor
    exact: bool
    planes: Mapping[str, Bools]
    reaches: Mapping[str, Reach] | None = None
    summaries: Mapping[str, Any] = MappingProxyType({})


class Exposing(Record):
    """How frames are exposed without a plan (the effects that are simulated).

    `run()` returns an iterator over frames, or one `Frame` with all repeats. `loop` is the compiled
    loop that it waits for (None: nothing is said about it), and `subject` names its user in a
    message. `word_reasons()`, called after `run()`, returns why pixels run through their words;
    empty if sums of light gave all exposures."""

    run: Callable[[], Any]
    loop: Any = None
    subject: str = "emulator"
    word_reasons: Callable[[], tuple[str, ...]] = lambda: ("every pixel is exposed slot by slot",)


class RunKind:
    """What the runtime does for a program with fixed shutters.

    The classes of other kinds change it, and may be combined: they call `super`."""

    without_plan = ""
    """Why frames are simulated without a plan; empty if plans apply."""
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
        """Return why the chip does not have some of the requested `effects` (a `Selection`), by
        name; here it has all."""
        return {}

    def exposing(
        self, container: Container, light: Any, sensor: Sensor, effects: Any, request: Any
    ) -> Exposing:
        """Return how frames of `light` (a `Light`) are exposed without a plan: without effects by
        the emulator, else by the reference.

        `effects`: the requested effects that the chip has (a `Selection`). `request`: the other
        options (a `Request`)."""
        exposing: Exposing = LazyFunctions("nscc_runtime.runs.without_plan").exact_or_reference(
            container, light, sensor, effects, request
        )
        return exposing

    def sheet(self, container: Container, title: str) -> Any:
        """Return the figure of `nscc view`: when shutters are open."""
        return LazyFunctions("nscc_runtime.pictures.shutter_sheet").shutter_sheet(container, title)

    def flow(self, container: Container, width: float) -> Any:
        """Return the `DataFlow`, `width` wide, that is drawn below the shutters; None for programs
        without images and planes, as here."""
        return None

    def frame_sheet(self, container: Container, frame: Any, response: Any, title: str) -> Any:
        """Return the figure of `frame`, a single frame, with `title`. `response()` computes its
        sensor response; it is called only if the figure needs it."""
        readouts = LazyFunctions("nscc_runtime.merge").readouts(container, frame, response())
        return LazyFunctions("nscc_runtime.pictures.images").frame_sheet(readouts, title)

    def sent_frame(self, container: Container, frame: Any, sent: Sent) -> Any:
        """Return `frame` with additions from the data that a chip `sent`: here, saturation marks
        that follow from the frame's converter codes."""
        return LazyFunctions("nscc_runtime.full_codes").marked_frame(container, frame, sent)


KINDS = KindTable(
    RunKind,
    images="nscc_runtime.runs.images_run:ImagesRun",
    looks="nscc_runtime.runs.looks_run:LooksRun",
    stream="nscc_runtime.runs.stream_run:BitPlanesRun",
)
"""The kinds of programs that the runtime knows."""


def refuse_planless(container: Container, subject: str) -> None:
    """Raise Rejected (NS0750) if plans do not apply to the program of `container`. `subject`: what
    needs a plan (the effects that are simulated), such as an option or a function's name; the
    message begins with it."""
    reason = KINDS.of(container).without_plan
    if reason:
        raise rejected(
            "NS0750",
            f"{subject} needs a plan, but plans do not apply to this program",
            notes=(f"{reason}, so all selected effects are simulated",),
            helps=(f"leave {subject} out",),
        )
