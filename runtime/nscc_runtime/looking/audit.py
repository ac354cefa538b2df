"""The audit of programs that look: a plan's frames beside the reference's, with the same draws.

Every frame begins with the kept states that the reference has left, so that each is compared by
itself. Exposures are compared where both end in the same states; how many do not is told.
"""

from __future__ import annotations

from dataclasses import replace
from math import sqrt

import numpy as np

from nscc_runtime.effects import everything
from nscc_runtime.light import Light
from nscc_runtime.looking.frames import Planes, exposer
from nscc_runtime.looking.sample import same_states
from nscc_runtime.looking.ways import Ways
from nscc_runtime.planner.audit import (
    Audit,
    bands,
    compared,
    compared_frames,
    compared_rows,
    row_weights,
)
from nscc_runtime.planner.plan import Plan
from nscc_runtime.reference.capture import scene_of
from nscc_runtime.reference.film import next_planes
from nscc_runtime.reference.intervals import Intervals
from nscc_runtime.reference.looks import LookingReference


def audit(
    ways: Ways,
    light: Light,
    plan: Plan,
    *,
    seed: int = 0,
    device_seed: int = 0,
    frames: int = 1,
    threads: int = 1,
) -> Audit:
    """Expose frames 0, 1, .. by plan and by reference with all effects, and compare."""
    container = ways.container
    intervals = Intervals.of(container, every_slot=False)
    rows = compared_rows(len(intervals), light.total_e())
    count, pooled = compared_frames(frames, light.shape)
    scene = scene_of(container, light)
    reference = LookingReference(container, ways.sensor, everything()).expose
    planned = exposer(ways, plan.kept, threads)
    loaded: Planes = container.planes()
    plans, fulls, others = [], [], []
    for frame in range(count):
        left = {name: plane.copy() for name, plane in loaded.items()}
        of_plan, of_full, same = [], [], []
        for band in bands(rows):
            some = planned(scene, loaded, (seed, device_seed), frame, band)
            full = reference(scene, loaded, (seed, device_seed), frame, band)
            same.append(same_states(some, full))
            of_plan.append(some.exposure.exposure_e)
            of_full.append(full.exposure.exposure_e)
            for name, plane in full.planes.items():
                left.setdefault(name, np.zeros(light.shape, np.bool_))[band.start : band.stop] = (
                    plane
                )
        loaded = next_planes(container, loaded, left)
        here = np.concatenate(same)
        others.append(1.0 - float(here.mean()))
        fulls.append(np.where(here, np.concatenate(of_full, axis=1), np.nan))
        plans.append(np.where(here, np.concatenate(of_plan, axis=1), np.nan))
    weight = row_weights(rows, light.shape[0])
    found = compared(np.stack(plans), np.stack(fulls), weight, pooled, plan)
    other = float(np.mean(others))
    found = replace(
        found,
        other_states=other,
        other_states_mc_error=sqrt(
            other * (1.0 - other) / (found.samples / len(container.buckets))
        ),
    )
    return replace(found, holds=found.breach(plan) is None)
