"""Capture consecutive frames in Python: each has its own light, and kept states go on."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from nscc.diagnostics.arguments import shown, warn, wrong_argument
from nscc.diagnostics.diagnostic import Diagnostic
from nscc.toml.arguments import checked
from nscc.words.readout import converter_of
from nscc_runtime.captured import Capture, capture_of
from nscc_runtime.effects import Selection
from nscc_runtime.host_setting import host_settings
from nscc_runtime.pieces import simulate_scene
from nscc_runtime.python_arguments import (
    LightLike,
    ProgramLike,
    SensorLike,
    container_of,
    laid_of,
    refuse_removed,
    sensor_of,
)
from nscc_runtime.request import Request
from nscc_runtime.run_kinds import KINDS
from nscc_runtime.simulate import Listener


@refuse_removed
def film(
    program: ProgramLike,
    lights: Iterable[LightLike],
    *,
    sensor: SensorLike = None,
    effects: str | Selection | None = None,
    seed: int = Request.seed,
    device_seed: int = Request.device_seed,
    threads: int | None = Request.threads,
    params: Any = Request.params,
    inputs: Any = Request.inputs,
) -> Capture:
    """Capture consecutive frames of a program with images or planes, each with its own light.

    Kept states go on from frame to frame. `capture` with `repeat` does the same with one light.

    Parameters
    ----------
    program : ShutterProgram or Container
        A compiled program with images or planes; not a path.
    lights : iterable of array, Light, Scene or str
        The light of each frame, at least one: electrons per slot (N, rows, cols), electrons per
        second (rows, cols), a `scene(..)`, or the name of a scene.
    sensor : Sensor, mapping, str or PathLike, optional
        A sensor, its file, or values by name; by default that of the chip.
    effects : str or Selection, optional
        "none" (the default), "auto", "all", or names as for `nscc run --effects`.
    seed : int
        Seed of the noise.
    device_seed : int
        Seed of the fixed pattern, which stands for one device.
    threads : int, optional
        Number of threads, by default all processors. The result does not depend on it.
    params : mapping or sequence of mapping, optional
        Values of parameters as for `capture`: for all frames, or one mapping for each frame. What a
        later mapping leaves out keeps its value.
    inputs : mapping or sequence of mapping, optional
        Bits of input planes as for `capture`: for all frames, or one mapping for each frame.

    Returns
    -------
    Capture
        All arrays have a leading axis of frames. `light` is the light of the first frame.

    Raises
    ------
    Rejected
        NS0789 for a program without images or planes, or for no lights; otherwise as `capture`.
    """
    # Read before any other local name exists, so that it holds the arguments only.
    given = locals()
    call = "nscc_runtime.film"
    container = container_of(call, program)
    if not KINDS.of(container).takes_films:
        raise wrong_argument(
            f"{call} takes a program with images or planes",
            helps=("nscc_runtime.captures(program, lights) captures other programs",),
        )
    options = checked(call, Request, given)
    if isinstance(lights, str) or not isinstance(lights, Iterable):
        raise wrong_argument(
            f"{call} takes a list with the light of each frame, not {shown(lights)}"
        )
    diagnostics: list[Diagnostic] = []
    scenes = [laid_of(call, light, container, diagnostics.append) for light in lights]
    if not scenes:
        raise wrong_argument(f"{call}: there is no light", helps=("give one for each frame",))
    for number, scene in enumerate(scenes):
        if len(scene) > 1 or scene[0].placement.arrays != (1, 1):
            raise wrong_argument(
                f"{call}: light {number} takes several exposures",
                helps=("use scenes in grey, and fit='crop' or fit='scale'",),
            )
    # The first frame is exposed like a capture; the request has the light of all others.
    next_lights = tuple(scene[0].light for scene in scenes[1:])
    settings = host_settings(container, params, inputs)
    request = Request.of(**options, repeat=len(scenes), next_lights=next_lights, settings=settings)
    chip = sensor_of(call, sensor, converter_of(container))
    exposed = simulate_scene(container, scenes[0], chip, request, Listener(warn=diagnostics.append))
    warn(diagnostics)
    return capture_of(exposed)
