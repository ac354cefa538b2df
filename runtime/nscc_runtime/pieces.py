"""A picture of any size on one chip: exposed piece by piece and colour by colour, put together."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc.words.container import Container
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.progress import unseen
from nscc_runtime.scenes import Laid
from nscc_runtime.sensor import Sensor
from nscc_runtime.simulate import Listener, Request, Simulated, simulate

COLOURS = ("red", "green", "blue")


@dataclass(frozen=True, eq=False)
class Taken:
    """What became of a scene: frames of the picture's size, with those of colours on a leading
    axis; `container` has a code for every pixel of them, `light` is what the first of them saw.

    `laid` belongs into the frame file's meta.
    """

    simulated: Simulated
    container: Container
    light: Light
    laid: dict[str, Any]


def simulate_scene(
    container: Container,
    scene: Sequence[Laid],
    sensor: Sensor,
    request: Request,
    listener: Listener | None = None,
) -> Taken:
    """Expose a scene of one or three colours; raises as `simulate`, NS0739 for what cannot be.

    The pieces are exposed on the same chip, with the same fixed patterns, one frame after the
    other: their noise has the seeds `request.seed`, and so on. Plan and audit are those of the
    piece that is furthest off.
    """
    listener = listener or Listener()
    where = scene[0].where
    lights = [piece for laid in scene for piece in where.pieces(laid.light)]
    numbered: Iterable[tuple[int, Light]] = enumerate(lights)
    one = listener
    if len(lights) > 1:
        _refuse_once(request)
        one = replace(listener, progress=unseen)
        numbered = listener.progress(numbered, "exposing pieces", len(lights))
    made = [
        simulate(container, light, sensor, replace(request, seed=request.seed + number), one)
        for number, light in numbered
    ]
    frames, each = [one.frame for one in made], len(lights) // len(scene)
    frames = [_joined(frames[k : k + each], where.joined) for k in range(0, len(made), each)]
    frame = frames[0] if len(scene) == 1 else _joined(frames, np.stack)
    worst = max(made, key=lambda one: one.plan.predicted_e if one.plan else 0.0)
    broken = next((one.broken for one in made if one.broken), None)
    light = scene[0].light.part(*(slice(0, side) for side in where.size))
    about = {} if where.fit == "crop" else {"laid": where.as_json()}
    about |= {} if len(scene) == 1 else {"colours": list(COLOURS)}
    simulated = replace(worst, frame=frame, broken=broken)
    return Taken(simulated, where.widened(container), light, about)


def _joined(frames: Sequence[Frame], join: Callable[[list[Any]], NDArray[Any]]) -> Frame:
    """A frame whose every array is made of those of the frames."""
    names = [field.name for field in fields(Frame)]
    return Frame(**{name: join([getattr(frame, name) for frame in frames]) for name in names})


def _refuse_once(request: Request) -> None:
    """NS0739 for what means one exposure."""
    for name in ("plan", "repeat"):
        if getattr(request, name) is not None:
            raise rejected(
                "NS0739",
                f"--{name} is for one exposure, and this scene takes several",
                notes=("pieces of a picture and colours are exposed one after the other",),
                helps=(f"leave --{name} out, or --fit tiles and --color",),
            )
