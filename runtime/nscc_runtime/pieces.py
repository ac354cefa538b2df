"""A picture of any size on one chip: exposed piece by piece and colour by colour, put together."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from nscc.diagnostics.rejection import rejected
from nscc.words.container import Container
from nscc.words.legality import refuse_pictures
from nscc_runtime.frame_file import joined, stacked
from nscc_runtime.kept_plans import KeptPlans, Turn
from nscc_runtime.light import Light
from nscc_runtime.progress import unseen
from nscc_runtime.response import Response, response_of
from nscc_runtime.scenes import PlacedLight, Placement
from nscc_runtime.sensor import Sensor
from nscc_runtime.simulate import Listener, Request, Simulated, simulate

COLOURS = ("red", "green", "blue")


@dataclass(frozen=True, eq=False)
class Taken:
    """What became of a scene: frames of the picture's size, with those of colours on a leading
    axis; `container` has a code for every pixel of them, `light` is what the first of them saw.

    `laid` belongs into the frame file's meta. `program` is the chip's, `where` how it sees the
    picture, in so many `pieces`, colours each: the plan is that of the one it has most wrong with.
    """

    simulated: Simulated
    container: Container
    light: Light
    laid: dict[str, Any]
    program: Container
    where: Placement
    pieces: int

    def response(self, sensor: Sensor) -> Response:
        """What the chip makes of steady light, at every pixel of the picture."""
        found = response_of(self.program, sensor, self.simulated.effects)
        open_s, gain, zero_e = (
            self.where.repeated(values) for values in (found.open_s, found.gain, found.zero_e)
        )
        return replace(found, open_s=open_s, gain=gain, zero_e=zero_e)


def simulate_scene(
    container: Container,
    scene: Sequence[PlacedLight],
    sensor: Sensor,
    request: Request,
    listener: Listener | None = None,
) -> Taken:
    """Expose a scene of one or three colours; raises as `simulate`, NS0739 for what cannot be.

    The pieces are exposed on the same chip, with the same fixed patterns, one frame after the
    other: their noise has the seeds `request.seed`, and so on; a plan serves the next ones that it
    covers. Plan and audit are those of the piece that is furthest off; a tolerance that is a part
    of the scene is of that of all.
    """
    listener = listener or Listener()
    where = scene[0].placement
    lights = [piece for laid in scene for piece in where.pieces(laid.light)]
    numbered: Iterable[tuple[int, Light]] = enumerate(lights)
    one = listener
    if len(lights) > 1:
        refuse_pictures(container, "this scene takes several exposures", "use --fit crop or scale")
        _refuse_once(request)
        request = _for_all(container, lights, sensor, request)
        one = replace(listener, progress=unseen)
        numbered = listener.progress(numbered, "exposing pieces", len(lights))
    made, plans = [], KeptPlans()
    for number, light in numbered:
        asked = request
        if len(lights) > 1:
            # Pieces of a scene are seldom alike.
            asked = replace(request, seed=request.seed + number, turn=Turn(plans, number, 1))
        made.append(simulate(container, light, sensor, asked, one))
    alone = len(made) == 1 and where.fits_one_array
    simulated = made[0] if alone else _joined(made, where, len(scene))
    light = scene[0].light
    light = light if where.fits_one_array else light.part(*(slice(0, side) for side in where.size))
    about: dict[str, Any] = {} if where.fit == "crop" else {"laid": where.as_json()}
    about |= {} if len(scene) == 1 else {"colours": list(COLOURS)}
    about |= {"scene_notes": list(scene[0].notes)} if scene[0].notes else {}
    return Taken(simulated, where.widened(container), light, about, container, where, len(made))


def _joined(made: Sequence[Simulated], where: Placement, colours: int) -> Simulated:
    """What became of all pieces of so many colours."""
    frames, each = [one.frame for one in made], len(made) // colours
    frames = [joined(frames[k : k + each], where.joined) for k in range(0, len(made), each)]
    worst = max(made, key=lambda one: (one.plan.predicted_e or 0.0) if one.plan else 0.0)
    broken = next((one.broken for one in made if one.broken), None)
    return replace(worst, frame=frames[0] if colours == 1 else stacked(frames), broken=broken)


def _for_all(
    container: Container, lights: Sequence[Light], sensor: Sensor, request: Request
) -> Request:
    """The request with one tolerance for all the lights, which are of one size. A part of their
    noise is found only where plans are measured against it."""
    if not request.planned or container.target.streamed:
        return request
    from nscc_runtime.emulator.capture import check
    from nscc_runtime.planning.planned_scene import PlannedScene
    from nscc_runtime.planning.scenes import planning_of
    from nscc_runtime.planning.tolerance import OPTION_MAX, noise_part, tolerance_of

    class All:
        """All the lights together."""

        def each(self) -> Iterator[PlannedScene]:
            for light in lights:
                check(container, light)
                yield planning_of(container, sensor, light, request.device_seed)

        def signal_e(self) -> float:
            return sum(one.signal_e() for one in self.each()) / len(lights)

        def noise_e(self) -> float:
            return math.sqrt(sum(one.noise_e() ** 2 for one in self.each()) / len(lights))

    most, part = request.tolerance_max, noise_part(str(request.tolerance))
    measured = part is None or most is not None or request.audit
    if not measured and all(one.approximates(None, part) for one in All().each()):
        return request
    return replace(
        request,
        tolerance=tolerance_of(request.tolerance, sensor, All()),
        tolerance_max=None if most is None else tolerance_of(most, sensor, All(), OPTION_MAX),
    )


def _refuse_once(request: Request) -> None:
    """NS0739 for what means one exposure."""
    for name in ("plan", "repeat"):
        if getattr(request, name) is not None:
            raise rejected(
                "NS0739",
                f"--{name} supports one exposure, but this scene needs several",
                notes=("parts of a picture, and its colours, are exposed one after the other",),
                helps=(f"leave --{name} out, or --fit tiles and --color",),
            )
