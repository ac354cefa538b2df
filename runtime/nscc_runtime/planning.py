"""What plans a program: sums over slots or, where its pixels look, their ways."""

from __future__ import annotations

from nscc.words.container import Container
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.light import Light
from nscc_runtime.planner.planning import Planning, PlanningBySums


def planning_of(
    container: Container,
    sensor: Sensor,
    light: Light,
    device_seed: int = 0,
    threads: int | None = None,
    torch_device: str | None = None,
) -> Planning:
    """What plans for this program on this scene are made, run and audited by. Pixels that look are
    exposed on the processor, whatever device of torch is named."""
    if container.machine is None:
        return PlanningBySums(container, sensor, light, device_seed, threads, torch_device)
    from nscc_runtime.looking.planning import PlanningByWays

    return PlanningByWays(container, sensor, light, device_seed, threads)
