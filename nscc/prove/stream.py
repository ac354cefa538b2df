"""The proof of planes of bits: what they open, pixel by pixel and slot by slot, is the program."""

from __future__ import annotations

import numpy as np

from nscc.prove.proof import Failure, Proof
from nscc.words.container import Container
from nscc.words.stream import schedule


def prove_stream(container: Container) -> Proof:
    """Follows the light of every pixel through the planes, and compares with the decode table.

    A plane is whole when it acts, and is loaded when no other one is. Nothing is taken from how
    planes were made. A container without pixels has no planes: only the times are proved.
    """
    table, target = container.table, container.target
    failure = _times(container)
    sent, pixels = container.stream, container.pixel_codes
    count = 0
    if failure is None and sent is not None and pixels is not None:
        count = pixels.size
        at_pixel = table.shutter_of_code[pixels]
        for slot in range(container.slots):
            place = sent.place(slot, target.cols)
            for bucket, name in enumerate(container.buckets):
                wrong = (place == bucket) != table.shutters[:, bucket, slot][at_pixel]
                if wrong.any():
                    y, x = np.argwhere(wrong)[0].tolist()
                    what = (
                        f"the light of pixel x = {x}, y = {y} goes to another destination in "
                        f"slot {slot}"
                    )
                    failure = failure or Failure(what, 1, name, int(at_pixel[y, x]))
    return Proof(len(table.codes), container.slots, 1, failure, pixels=count)


def _times(container: Container) -> Failure | None:
    """Planes that overlap, or are cut short."""
    free_us, load_us = -np.inf, container.target.plane_load_us
    end_us = np.cumsum(container.slot_us)
    slack = 1e-6 * load_us
    for slot, each in enumerate(schedule(container.target, container.slot_us)):
        whole = each.load_us + load_us <= each.acts_us + slack
        if not whole or each.load_us < free_us - slack or each.acts_us >= end_us[slot]:
            return Failure(f"slot {slot} is too short to load its plane", 1)
        free_us = each.load_us + load_us
    return None
