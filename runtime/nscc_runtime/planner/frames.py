"""Frames under a plan, read out: from a program's analysis, made once, to codes."""

from __future__ import annotations

from collections.abc import Iterable

from nscc_runtime.frame_file import Frame, check_adc
from nscc_runtime.light import Light
from nscc_runtime.planner.capture import prepared
from nscc_runtime.planner.plan import Plan
from nscc_runtime.planner.program import Program
from nscc_runtime.ready import MadeReady

made_ready = MadeReady(Program.of)
"""The analysis of a program on a sensor."""


def planned_frames(
    program: Program,
    light: Light,
    plan: Plan,
    seed: int = 0,
    device_seed: int = 0,
    count: int = 1,
    threads: int | None = None,
    torch_device: str | None = None,
) -> Iterable[Frame]:
    """Frames 0 .. `count` - 1 under a plan, read out; ValueError for fewer than one."""
    if count < 1:
        raise ValueError(f"{count} frames")
    scene = prepared(
        program, light, plan, device_seed=device_seed, threads=threads, torch_device=torch_device
    )
    check_adc(program.container.target)
    yield from scene.frames(seed, count)
