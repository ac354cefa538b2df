"""Frames of programs with fixed shutters that need no plan: without effects, or by the reference.

Frames under a plan are made by `nscc_runtime.planning.planned_scene`."""

from __future__ import annotations

from functools import partial

from nscc.words.container import Container
from nscc_runtime.effects import Selection, Sensor
from nscc_runtime.frame_file import Frame, read_out, repeated
from nscc_runtime.light import Light
from nscc_runtime.request import Request
from nscc_runtime.run_kinds import Exposing


def exact_or_reference(
    container: Container, light: Light, sensor: Sensor, effects: Selection, request: Request
) -> Exposing:
    """Return the function without arguments that exposes the frames of `light`, and the compiled
    loop that it needs: by the emulator without effects, else by the reference.

    `effects` are those to simulate; `request` gives the seeds, the number of frames
    (`request.repeat`, None for one) and the threads."""
    if request.effects.without_effects:
        from nscc_runtime.emulator.loops import expose_without_effects

        return Exposing(partial(_exact, container, light, sensor, request), expose_without_effects)
    from nscc_runtime.noise.noise_loops import fill_normals
    from nscc_runtime.reference import frames

    run = partial(
        frames,
        container,
        light,
        sensor,
        effects,
        seed=request.seed,
        device_seed=request.device_seed,
        count=request.repeat or 1,
        threads=request.threads,
    )
    return Exposing(run, fill_normals, "noise")


def _exact(container: Container, light: Light, sensor: Sensor, request: Request) -> Frame:
    """Return a frame without effects, exposed and read out once; with `request.repeat`, this number
    of copies with a leading axis, because it has no noise."""
    from nscc_runtime.emulator import expose

    exact = expose(container, light, device_seed=request.device_seed, threads=request.threads)
    frame = read_out(exact, container.target, sensor)
    return repeated(frame, request.repeat) if request.repeat else frame
