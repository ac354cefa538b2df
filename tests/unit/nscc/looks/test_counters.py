"""Counters that start anywhere and count up and down: the words do what the text says, over random
answers, and take few words."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from random import Random

import numpy as np
import pytest
from looks_programs import looking_frames

import nscc
from nscc.chips.load import builtin_target
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.sensor import default_sensor

SIDE = 16
TARGET = replace(builtin_target("scamp5"), rows=SIDE, cols=SIDE)

COUNTERS: dict[str, tuple[int, int, int, str, Callable[[int, bool], int], int]] = {
    "down": (15, 15, 18, "count - 1 when bright and count > 0",
             lambda c, b: max(c - b, 0), 22),
    "down by three": (63, 63, 30, "max(count - 3, 0) when bright",
                      lambda c, b: max(c - 3 * b, 0), 27),
    "down, 8 bits": (255, 255, 40, "count - 1 when bright and count > 0",
                     lambda c, b: max(c - b, 0), 31),
    "up and down": (16, 8, 24, "(count + 1 if bright else count - 1) when count > 0 and count < 16",
                    lambda c, b: c + (2 * b - 1) * (0 < c < 16), 37),
    "up and down, with limits": (64, 32, 40, "min(count + 1, 64) if bright else max(count - 1, 0)",
                                 lambda c, b: min(max(c + 2 * b - 1, 0), 64), 45),
    "around": (9, 3, 24, "(count + 1) % 10 when bright",
               lambda c, b: (c + b) % 10, 20),
    "around by seven": (19, 0, 24, "(count + 7) % 20 when bright",
                        lambda c, b: (c + 7 * b) % 20, 66),
    "up by three": (63, 0, 30, "min(count + 3, 63) when bright",
                    lambda c, b: min(c + 3 * b, 63), 28),
}  # fmt: skip
"""Highest value, start, slots, the next value as text and as a function of the value and the
answer, and the most words at a look."""


@pytest.mark.parametrize("name", COUNTERS)
def test_counters_count_as_a_model_does(name: str) -> None:
    highest, start, slots, text, after, most = COUNTERS[name]
    container = nscc.compile(
        f"nsl 2\nframe {slots} slots of 1ms\nsense bright when light > 45% at n > 0 and n < N\n"
        f"state count : 0..{highest} = {start}\nnext count = {text}\n"
        "reset when n > 0\nopen when n == 0\nread count\n",
        target=TARGET,
        level=1,
    ).container
    choose = Random(name)
    shares = np.array([choose.choice((0, 0.2, 0.5, 0.8, 1)) for _ in range(SIDE * SIDE)])
    answers = np.array([[choose.random() < share for share in shares] for _ in range(slots)])
    full = container.target.full_well_e
    light = np.where(answers, 0.8 * full, 0).reshape(slots, SIDE, SIDE).astype(np.float32)
    (frame,) = looking_frames(
        container,
        Light.of_clip(light),
        default_sensor(container.target),
        selected("none"),
        device_seed=1,
        count=1,
    )
    expected = []
    for pixel in answers.T.tolist():
        count = start
        for bright in pixel[: slots - 1]:
            count = after(count, bright)
        expected.append(count)
    assert frame.told["states_count"].reshape(-1).tolist() == expected
    assert len(set(expected)) > 4
    words = sum(len(container.kernels[launch.kernel].words) for launch in container.launches)
    assert words <= most * slots


@pytest.mark.parametrize(("codes", "highest"), [(16, 8), (30, 4)])
def test_a_counter_fits_beside_codes_that_need_half_of_the_registers(
    codes: int, highest: int
) -> None:
    """nscc proves its words, so a container is right."""
    nscc.compile(
        f"nsl 2\nframe 32 slots of 100us\ncode s : 1..{codes}\n"
        "sense bright when light > 45% at n > 0 and n < N\n"
        f"state count : 0..{highest} = 0\n"
        f"next count = count + 1 when bright and count < {highest}\n"
        "open when n < s\nread count\n",
        target=TARGET,
        level=1,
    )


def test_eight_bits_count_up_and_down_where_the_shutter_closes_at_the_last_look() -> None:
    """The answer then takes a register beside those of the counter. nscc proves its words."""
    nscc.compile(
        "nsl 2\nframe 140 slots of 100us\nsense bright when light > 45% at n > 0\n"
        "state count : 0..128 = 128\n"
        "next count = min(count + 1, 128) if bright else max(count - 1, 0)\n"
        "open when true\nread count\n",
        target=TARGET,
        level=1,
    )
