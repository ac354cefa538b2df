"""The proof of bit planes: every pixel's light goes where the decode table says."""

from __future__ import annotations

import numpy as np

from nscc.prove.proof import Failure, Proof
from nscc.words.container import Container
from nscc.words.stream import schedule


def prove_planes(container: Container) -> Proof:
    """Follow the light of every pixel through the bit planes, and compare it with the decode table.

    Planes must be completely loaded before they take effect, one at a time. The proof does not use
    the code that made the planes. Without pixel codes there are no planes, and only the times are
    proved; `pixels` of the result is then 0, as after a failure of the times. The result holds the
    first failure."""
    table, target = container.table, container.target
    failure = _times(container)
    sent, pixels = container.stream, container.pixel_codes
    count = 0
    if failure is None and sent is not None and pixels is not None:
        count = pixels.size
        at_pixel = table.shutter_of_code[pixels]
        for slot in range(container.slots):
            destinations = sent.destinations(slot, target.cols)
            for bucket, name in enumerate(container.buckets):
                misrouted = (destinations == bucket) != table.shutters[:, bucket, slot][at_pixel]
                if misrouted.any():
                    y, x = np.argwhere(misrouted)[0].tolist()
                    message = (
                        f"the light of pixel x = {x}, y = {y} goes to another destination in "
                        f"slot {slot}"
                    )
                    failure = failure or Failure(
                        message, frame=1, bucket=name, shutter=int(at_pixel[y, x])
                    )
    return Proof(len(table.codes), container.slots, frames=1, failure=failure, pixels=count)


def _times(container: Container) -> Failure | None:
    """Return the first failure of the schedule, else None.

    A plane must be loaded when it takes effect, within its slot, and after the previous plane is
    loaded; a millionth of the load time is allowed for rounding."""
    free_us, load_us = -np.inf, container.target.plane_load_us
    end_us = np.cumsum(container.slot_us)
    slack = 1e-6 * load_us
    for slot, loading in enumerate(schedule(container.target, container.slot_us)):
        loads_in_time = loading.load_us + load_us <= loading.acts_us + slack
        if (
            not loads_in_time
            or loading.load_us < free_us - slack
            or loading.acts_us >= end_us[slot]
        ):
            return Failure(f"slot {slot} is too short to load its plane", frame=1)
        free_us = loading.load_us + load_us
    return None
