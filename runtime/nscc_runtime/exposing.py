"""The emulator in Python: simulate captures of a chip, from programs and light to arrays.

    import nscc, nscc_runtime

    p = nscc.compile("examples/hdr_2x2.nsl")
    taken = nscc_runtime.capture(p, "builtin:hdr", effects="auto")
    taken.frame, taken.exposure_e, taken.plan

The functions have the options of `nscc run`, with the same names and defaults. `docs/emulator.md`
describes plans and their promise."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import cycle, islice
from pathlib import Path
from typing import Any

from nscc.diagnostics.arguments import path_of, shown, warn, wrong_argument
from nscc.diagnostics.diagnostic import Diagnostic
from nscc.files import write_whole
from nscc.toml.arguments import checked
from nscc.words.container import Container
from nscc.words.readout import converter_of
from nscc_runtime.caches import OfContainer
from nscc_runtime.captured import Capture
from nscc_runtime.effects import Selection, Sensor
from nscc_runtime.host_setting import host_settings
from nscc_runtime.kept_plans import KeptPlans, Turn
from nscc_runtime.pieces import simulate_scene
from nscc_runtime.planning.audit import Audit
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.tolerance import ToleranceInput
from nscc_runtime.pool import THREADS, processors
from nscc_runtime.python_arguments import (
    LightLike,
    ProgramLike,
    SensorLike,
    changes_of,
    container_of,
    laid_of,
    refuse_removed,
    sensor_of,
)
from nscc_runtime.request import Fidelity, Request
from nscc_runtime.run_kinds import KINDS, refuse_planless
from nscc_runtime.scene_settings import Fit, FramesAre, Scene, Transfer
from nscc_runtime.scenes import PlacedLight
from nscc_runtime.sensor.file import load_sensor
from nscc_runtime.simulate import Listener

_converter_of = OfContainer(converter_of)
"""The target with the converter's values for a container (a compiled program); cached."""


@refuse_removed
def capture(
    program: ProgramLike,
    light: LightLike,
    *,
    sensor: SensorLike = None,
    effects: str | Selection | None = None,
    tolerance: str | float | None = None,
    plan: Plan | str | Path | None = None,
    fidelity: Fidelity = "planned",
    audit: bool = Request.audit,
    seed: int = Request.seed,
    device_seed: int = Request.device_seed,
    repeat: int | None = Request.repeat,
    threads: int | None = Request.threads,
    params: Any = Request.params,
    inputs: Any = Request.inputs,
    turn: Turn | None = Request.turn,
) -> Capture:
    """Capture a scene with a program on the emulated chip.

    Parameters
    ----------
    program : ShutterProgram or Container
        A compiled program, as `nscc.compile` and `nscc.load` return it; not a path.
    light : array, Light, Scene or str
        Electrons per slot (N, rows, cols), electrons per second of a still (rows, cols), a
        `scene(..)`, or the name of a scene. Arrays of float32 are not copied.
    sensor : Sensor, mapping, str or PathLike, optional
        A sensor, its file, or values by name such as {"full_well_e": 20000}; by default that of
        the chip.
    effects : str or Selection, optional
        "none" (sums of light), "auto", "all", or names as for `nscc run --effects`. The default is
        "auto" if `tolerance`, `plan` or `audit` is given, else "none".
    tolerance : str or float, optional
        Largest RMS difference from all effects: "5e", "0.1lsb", "1%" of the mean signal, or
        "0.15noise" of the frame's own noise (the default of "auto"). A number is in electrons.
    plan : Plan, str or PathLike, optional
        A plan of `nscc_runtime.plan`, or a file. A file that does not exist is written.
    fidelity : {"planned", "reference"}
        "reference" simulates all effects, word by word and slot by slot.
    audit : bool
        Measure the error of the plan on all pixels; the result is in `Capture.audit`.
    seed : int
        Seed of the noise.
    device_seed : int
        Seed of the fixed pattern, which stands for one device.
    repeat : int, optional
        Number of frames.
    threads : int, optional
        Number of threads, by default that of the processors. The result does not depend on it.
    params : mapping, optional
        Values of parameters by name (version 4 of the language): a level as text such as "4%" or
        "1200e", or as a number of electrons; an integer as a number.
    inputs : mapping, optional
        Bits of input planes by name (version 4): arrays (rows, cols) of bool or of 0 and 1, or
        paths of an .npy, an .npz or a picture.
    turn : Turn, optional
        Position in a series of frames that share plans (`nscc_runtime.kept_plans`).

    Returns
    -------
    Capture

    Raises
    ------
    Rejected
        NS0789 for arguments of wrong types, NS0730 to NS0740 for invalid light, NS0739 for options
        that exclude each other, NS0442 or NS0741 for programs without shutters or pixel data,
        NS0546 for invalid parameters and input planes.
    """
    given = locals()
    call = "nscc_runtime.capture"
    container = container_of(call, program)
    diagnostics: list[Diagnostic] = []
    scene = laid_of(call, light, container, diagnostics.append)
    settings = host_settings(container, params, inputs)
    request = Request.of(**checked(call, Request, given), turn=turn, settings=settings)
    return _captured(call, container, scene, sensor, request, diagnostics)


def _captured(
    call: str,
    container: Container,
    scene: Sequence[PlacedLight],
    sensor: SensorLike,
    request: Request,
    diagnostics: list[Diagnostic],
) -> Capture:
    """Expose a scene, warn of `diagnostics` and of what is found meanwhile, write the file of a new
    plan, and return the capture. `call` names the function in errors."""
    chip = sensor_of(call, sensor, _converter_of(container))
    exposed = simulate_scene(container, scene, chip, request, Listener(warn=diagnostics.append))
    warn(diagnostics)
    result = exposed.simulated
    if result.plan_file is not None and isinstance(request.plan, Path):
        write_whole(request.plan, result.plan_file.encode())
    return Capture(**vars(result.frame), exposed=exposed)


def captures(
    programs: Sequence[ProgramLike] | ProgramLike,
    lights: Sequence[LightLike] | LightLike,
    *,
    threads: int | None = None,
    **options: Any,
) -> list[Capture]:
    """Capture many scenes with one program, one scene with many programs, or pairs of both.

    Programs are analysed once. Scenes with light of the same kind share a plan (the effects that
    are simulated); the result does not depend on the number of threads.

    Parameters
    ----------
    programs : program or list of programs
        A compiled program, or several in a list or tuple.
    lights : light or list of lights
        An array, a `Light`, a `scene(..)` or the name of a scene as for `capture`, or several in a
        list or tuple.
    threads : int, optional
        Number of captures at a time, by default that of the processors.
    **options
        Further arguments of `capture`.

    Returns
    -------
    list of Capture

    Raises
    ------
    Rejected
        NS0789 if two lists have different lengths, neither of them 1, or a list is empty;
        otherwise as `capture`, with the first error of a scene.
    """
    # Only lists and tuples are several: an array is one light, though it has a length.
    many_programs = [*programs] if isinstance(programs, list | tuple) else [programs]
    many_lights = [*lights] if isinstance(lights, list | tuple) else [lights]
    count = max(len(many_programs), len(many_lights))
    if {len(many_programs), len(many_lights)} - {1, count} or not (many_programs and many_lights):
        raise wrong_argument(
            f"nscc_runtime.captures: {len(many_lights)} scenes for {len(many_programs)} programs",
            helps=("give lists of the same length, or a single scene or program",),
        )

    checked("nscc_runtime.captures", Request, {"threads": threads})
    plans = KeptPlans()
    plans.expect(range(count))

    def run(number: int, program: Any, light: Any) -> Capture:
        """Capture scene `number` of the batch, `program` with `light`; then let scenes with higher
        numbers begin, even after an error."""
        try:
            turn = Turn(plans, number, frames=count)
            return capture(program, light, threads=1, turn=turn, **options)
        finally:
            plans.passed(number)

    with ThreadPoolExecutor(threads or processors(), thread_name_prefix=THREADS) as pool:
        arguments = islice(cycle(many_programs), count), cycle(many_lights)
        return [*pool.map(run, range(count), *arguments)]


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
    return _captured(call, container, scenes[0], sensor, request, diagnostics)


@refuse_removed
def plan(
    program: ProgramLike,
    light: LightLike,
    *,
    sensor: SensorLike = None,
    effects: str | Selection = "auto",
    tolerance: ToleranceInput = Request.tolerance,
    device_seed: int = Request.device_seed,
) -> Plan:
    """Choose the effects that a capture has to simulate for a tolerance. Nothing is exposed.

    Parameters
    ----------
    program : ShutterProgram or Container
        A compiled program, as `nscc.compile` and `nscc.load` return it; not a path.
    light : array, Light, Scene or str
        Electrons per slot (N, rows, cols), electrons per second of a still (rows, cols), a
        `scene(..)`, or the name of a scene. Arrays of float32 are not copied.
    sensor : Sensor, mapping, str or PathLike, optional
        As for `capture`.
    effects : str or Selection
        As for `capture`.
    tolerance : str or float
        As for `capture`.
    device_seed : int
        Seed of the fixed pattern.

    Returns
    -------
    Plan
        Can be given to `capture`, for this and other scenes.

    Raises
    ------
    Rejected
        As `capture`; NS0750 for programs that plans do not apply to.
    """
    from nscc_runtime.emulator.capture import check
    from nscc_runtime.planning.make import make_plan
    from nscc_runtime.planning.plan import PlanRequest
    from nscc_runtime.planning.planned_scene import PlannedScene

    given = locals()
    call = "nscc_runtime.plan"
    container = container_of(call, program)
    diagnostics: list[Diagnostic] = []
    scene = laid_of(call, light, container, diagnostics.append)[0].light
    chip = sensor_of(call, sensor, _converter_of(container))
    request = Request.of(**checked(call, Request, given))
    check(container, scene)
    refuse_planless(container, call)
    warn(diagnostics)
    wanted = PlanRequest(request.effects, request.tolerance, figures=True)
    return make_plan(PlannedScene(container, chip, scene, request.device_seed), wanted)


def audit(program: ProgramLike, light: LightLike, **options: Any) -> Audit:
    """Measure the error of captures with a plan against captures with all effects.

    A plan is a choice of the effects that are simulated.

    Parameters
    ----------
    program : ShutterProgram or Container
        A compiled program, as `nscc.compile` and `nscc.load` return it; not a path.
    light : array, Light, Scene or str
        Electrons per slot (N, rows, cols), electrons per second of a still (rows, cols), a
        `scene(..)`, or the name of a scene. Arrays of float32 are not copied.
    **options
        Further arguments of `capture`.

    Returns
    -------
    Audit
        `holds` tells whether the error is within 1.1 times the tolerance.

    Raises
    ------
    Rejected
        As `capture`.
    """
    report = capture(program, light, audit=True, **options).audit
    assert report is not None
    return report


def scene(
    name: str | Path,
    *,
    exposure: str | float | None = Scene.exposure,
    transfer: Transfer | None = Scene.transfer,
    fps: float | None = Scene.fps,
    crop: str | tuple[int, int] | None = Scene.crop,
    frames_are: FramesAre = Scene.frames_are,
    fit: Fit = Scene.fit,
    color: bool = Scene.color,
    first: int = Scene.first,
    single: bool = Scene.single,
    white: float | None = Scene.white,
    skip: bool = Scene.skip,
    bracket: bool = Scene.bracket,
    times: str | tuple[float, ...] | None = Scene.times,
) -> Scene:
    """Describe a scene for `capture`. The file is read when the scene is exposed.

    Parameters
    ----------
    name : str or Path
        A picture, clip or array file, a folder of pictures, or `builtin:hdr`, `builtin:motion`,
        `builtin:flat:E`, `builtin:dark`.
    exposure : str or float, optional
        Electrons over the frame at percentile 99 of the scene, or text such as "30000@70" for
        another percentile.
    transfer : {"linear", "srgb", "pq", "hlg"}, optional
        Transfer curve of the stored values.
    fps : float, optional
        Frame rate of a clip in frames per second; by default each slot is one frame.
    crop : str or tuple of int, optional
        Row and column of the part that is exposed.
    frames_are : {"integrals", "samples"}
        Whether a frame of a clip is the light over its time, or at one moment.
    fit : {"crop", "scale", "tiles"}
        How a picture of another size is placed on the array.
    color : bool
        Expose red, green and blue one after the other.
    first : int
        First frame of a clip, counted from 0.
    single : bool
        Expose one frame of a clip as a still.
    white : float, optional
        Sample value of white, by default the largest value of the type.
    skip : bool
        Leave out missing frames of a folder.
    bracket : bool
        Merge the photos of a folder or pattern, which differ in exposure, to one still.
    times : str or tuple of float, optional
        Exposure times of these photos in seconds such as "1/250,1/60", by default from EXIF data.

    Returns
    -------
    Scene

    Raises
    ------
    Rejected
        NS0789 for arguments of wrong types.
    """
    return Scene(**checked("nscc_runtime.scene", Scene, locals()))


def sensor_for(program: ProgramLike, file: str | Path | None = None, **values: float) -> Sensor:
    """Return the sensor of a program's chip or of a sensor file.

    Parameters
    ----------
    program : ShutterProgram or Container
        A compiled program; its chip gives the values that are not set otherwise.
    file : str or Path, optional
        A file of `nscc effects --toml` or `nscc calibrate`.
    **values : float
        Values that replace those of the sensor, such as `full_well_e=20000`.

    Returns
    -------
    Sensor

    Raises
    ------
    Rejected
        NS0751 to NS0754 for an invalid file or value.
    """
    call = "nscc_runtime.sensor_for"
    target = converter_of(container_of(call, program))
    path = None if file is None else path_of(call, file)
    return load_sensor(target, path, changes_of(call, values))
