"""The emulator in Python: what a chip would have captured, from arrays to arrays.

    from nscc.compiler import compile_file
    from nscc_runtime.capture import capture

    program = compile_file(Path("flutter.nsl")).container
    taken = capture(light, program)             # light: electrons a slot (N, rows, cols)
    taken.exposure_e, taken.frame, taken.plan   # electrons; codes; what was simulated, and why

`docs/emulator.md` says what a plan is and what it promises.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import cycle, islice
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import Selection, selected
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.frame_file import Frame, check_adc, converted, stacked
from nscc_runtime.light import Light
from nscc_runtime.plan.capture import prepared
from nscc_runtime.plan.choose import plan_for
from nscc_runtime.plan.plan import Plan
from nscc_runtime.plan.pool import processors
from nscc_runtime.plan.program import Program
from nscc_runtime.plan.tolerance import tolerance_e
from nscc_runtime.sensor.file import default_sensor

_programs: WeakKeyDictionary[Container, dict[Sensor, Program]] = WeakKeyDictionary()


@dataclass(frozen=True, eq=False)
class Capture(Frame):
    """One scene captured; with `repeat` the arrays have a leading axis.

    `frame` uint8, `exposure_e` float64, `valid` and `saturated` bool, `saturated_by` uint8, each
    (buckets, rows, cols) as in a frame file; `plan` says what was simulated.
    """

    plan: Plan


LightLike = Light | NDArray[np.floating]


def capture(
    light: LightLike,
    program: Container,
    sensor: Sensor | None = None,
    plan: Plan | None = None,
    *,
    effects: str | Selection = "auto",
    tolerance: str | float = "5e",
    seed: int = 0,
    device_seed: int = 0,
    repeat: int | None = None,
    threads: int | None = None,
) -> Capture:
    """Capture a scene, or `repeat` frames of it, with a program on an emulated chip.

    `light`: electrons a slot (N, rows, cols), electrons a second of a still (rows, cols), or a
    `Light`. Without a `plan` one is made: `effects` as in `nscc run --effects`, to a `tolerance` in
    electrons (or text as `5e`, `0.1lsb`). Threads, by default as many as there are processors,
    change no bit. Raises Rejected for light that does not fit or is no light, and for programs that
    open no shutters; ValueError for a number of frames below 1.
    """
    sensor = sensor or default_sensor(program.target)
    made, scene = made_ready(program, sensor), as_light(light, program)
    if plan is None:
        wanted = selected(effects) if isinstance(effects, str) else effects
        plan = plan_for(made, scene, tolerance_e(tolerance, sensor), wanted, device_seed)
    count = 1 if repeat is None else repeat
    frames = [*planned_frames(made, scene, plan, seed, device_seed, count, threads)]
    found = frames[0] if repeat is None else stacked(frames)
    return Capture(found.frame, found.exposure_e, found.valid, found.saturated_by, plan)


def captures(
    lights: Iterable[LightLike] | LightLike,
    programs: Sequence[Container] | Container,
    sensor: Sensor | None = None,
    plan: Plan | None = None,
    *,
    threads: int | None = None,
    **options: object,
) -> list[Capture]:
    """Capture many scenes with one program, one scene with many, or pair by pair; as `capture`.

    Programs are analysed once. ValueError where there are neither as many scenes as programs nor
    one of either.
    """
    many_programs = [programs] if isinstance(programs, Container) else list(programs)
    many_lights = [lights] if isinstance(lights, Light) else list(lights)
    count = max(len(many_programs), len(many_lights))
    for each in (many_programs, many_lights):
        if len(each) not in (1, count):
            raise ValueError(f"{len(many_lights)} scenes for {len(many_programs)} programs")
    for each_program in many_programs:
        made_ready(each_program, sensor or default_sensor(each_program.target))

    def run(light: LightLike, program: Container) -> Capture:
        return capture(light, program, sensor, plan, threads=1, **options)  # type: ignore[arg-type]

    with ThreadPoolExecutor(threads or processors()) as pool:
        return [*pool.map(run, islice(cycle(many_lights), count), cycle(many_programs))]


def planned_frames(
    program: Program,
    light: Light,
    plan: Plan,
    seed: int = 0,
    device_seed: int = 0,
    count: int = 1,
    threads: int | None = None,
) -> Iterable[Frame]:
    """Frames 0 .. `count` - 1 under a plan, read out."""
    if count < 1:
        raise ValueError(f"{count} frames")
    scene = prepared(program, light, plan, device_seed=device_seed, threads=threads)
    sensor, target = program.sensor, program.container.target
    check_adc(target)
    for number in range(count):
        if scene.fused is not None:
            yield scene.fused.expose(seed, number, read_out=True)
        else:
            exposure = scene.expose(seed, number)
            yield converted(exposure, target, sensor, plan.kept, (seed, device_seed), number)


def made_ready(container: Container, sensor: Sensor) -> Program:
    """The analysis of a program, kept as long as the program is."""
    found = _programs.setdefault(container, {})
    if sensor not in found:
        found[sensor] = Program.of(container, sensor)
    return found[sensor]


def as_light(light: LightLike, program: Container) -> Light:
    """Light of an array, as `nscc run` takes it of a file; raises Rejected for what is none."""
    if isinstance(light, Light):
        return light
    from nscc_runtime.scenes import light_of_array

    rows, cols = program.target.rows, program.target.cols
    return light_of_array(light, slot_us=program.slot_us, rows=rows, cols=cols)
