"""Measuring what simulating takes on this machine: a small program, each way of exposing it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from time import perf_counter, process_time

import numpy as np

import nscc
from nscc_runtime.effects import CannotHave, Effect, everything, registered, selected
from nscc_runtime.light import Light
from nscc_runtime.machine_prices import MachinePrices, Price
from nscc_runtime.planner.capture import prepared
from nscc_runtime.planner.choose import plan_for
from nscc_runtime.planner.frames import made_ready
from nscc_runtime.planner.plan import Plan
from nscc_runtime.planner.prices import SHIPPED
from nscc_runtime.planner.program import Program
from nscc_runtime.pool import in_parts, processors
from nscc_runtime.reference.capture import scene_of
from nscc_runtime.sensor import default_sensor

_TEXT = """nsl 1
frame 16 slots of 1ms
code stop : 1..16
open when n < stop
pixels stop = 1 + (5 * x + 3 * y) % 16
"""
_SUMMED = "a pixel by sums over slots"
_LIT = "a pixel and frame of light"
_ANY_E = 1e5
"""A tolerance to which sums do anything."""
_NEAR = 512
"""Pixels that run through their words."""
_ROUNDS = 5
_FASTER = 0.95
"""More threads have to take less than this part of the time to be worth their waking."""


def measured() -> MachinePrices:
    """The list of this machine, each price the least of some rounds; a few seconds."""
    container = nscc.compile(_TEXT, level=1).container
    program = made_ready(container, default_sensor(container.target))
    rows, cols = program.reference.groups.lane.shape
    # Waves of some ten pixels, at 30 to 470 electrons a slot: bright, and nothing saturates.
    wave = np.sin(np.arange(rows) / 7.0)[:, None] * np.sin(np.arange(cols) / 5.0)
    light = Light.of_still((250e3 + 220e3 * wave).astype(np.float32), program.slot_s)
    pixels = len(program.lanes)

    # `replace`: the same light, without what has been found out about it.
    def planned() -> Plan:
        return plan_for(program, replace(light), 5.0, selected("auto"))

    plan = planned()
    frame = partial(_frame, program, light, plan)
    assert plan.cost is not None
    exposing_ms = plan.cost.total_ms - plan.cost.planning_ms
    words = everything()
    words = words.without(*(e.name for e in words.effects if isinstance(e.words, CannotHave)))
    chosen = np.linspace(0, pixels - 1, _NEAR).astype(np.int64)
    return MachinePrices(
        (
            Price("planning", f"a plan for {rows} x {cols} pixels", "ms", plan.cost.planning_ms,
                  1e3 * _least(planned)),
            Price("sums", "a pixel by sums over slots, to 5 e", "ns", exposing_ms * 1e6 / pixels,
                  1e9 * _least(lambda: frame(1)) / pixels),
            Price("words", "a pixel through its words, all effects", "ns",
                  program.work.words_ns(words, SHIPPED, "nothing"),
                  1e9 / _NEAR * _least(lambda: program.words(words).exposures(
                      light, program.slot_s, chosen, words))),
            Price("reference", "a pixel and slot in the reference", "ns",
                  SHIPPED.slot_of_reference,
                  1e9 / (pixels * light.slots) * _least(lambda: _reference(program, light), 1)),
            Price("thread", "one more thread woken", "us", None, 1e6 * _waking_s()),
            *_of_effects(program, light),
        ),
        _threads(frame),
    )  # fmt: skip


def _of_effects(program: Program, still: Light) -> list[Price]:
    """What leaving each effect out of sums saves that there is in this scene: of a still, and of
    each frame of a film's light."""
    film = Light.of_clip(np.repeat(still.frames, still.slots, axis=0), float(program.slot_s[0]))
    decisions = plan_for(program, still, _ANY_E, selected("all")).decisions
    here = {each.name for each in decisions if each.decision != "absent"}
    priced = [each for each in registered() if each.cost_ns and each.name in here]
    saved = [_saved_ns(program, light, priced) for light in (still, film)]
    found: list[Price] = []
    for effect, of_still, of_film in zip(priced, *saved, strict=True):
        of_light = max(0.0, of_film - of_still) / (film.slots - 1)
        found.append(Price(effect.name, _SUMMED, "ns", effect.cost_ns, of_still))
        if effect.light_ns:
            found.append(Price(effect.name, _LIT, "ns", effect.light_ns, of_light))
    return found


def _saved_ns(program: Program, light: Light, effects: list[Effect]) -> list[float]:
    """Nanoseconds a pixel of a frame with all effects less those of one without each."""
    chosen = [selected("all"), *(selected("all").without(each.name) for each in effects)]
    plans = [plan_for(program, light, _ANY_E, each) for each in chosen]
    least_s = [math.inf] * len(plans)
    for _ in range(_ROUNDS):
        for number, plan in enumerate(plans):
            run = partial(_frame, program, light, plan)
            least_s[number] = min(least_s[number], _least(run, 2))
    every, *without = (1e9 * each / len(program.lanes) for each in least_s)
    return [max(0.0, every - each) for each in without]


def _frame(program: Program, light: Light, plan: Plan, threads: int = 1) -> None:
    """One frame of a light of which nothing has been found out."""
    prepared(program, replace(light), plan, threads=threads).frame(0, 0)


def _reference(program: Program, light: Light) -> None:
    program.reference.expose(scene_of(program.container, light), 0, 0, 0, 1)


def _waking_s() -> float:
    def both() -> None:
        in_parts(lambda _begin, _end: None, 2, 2)

    return _least(both, 100, perf_counter)


def _threads(frame: Callable[[int], None]) -> int:
    """With how many threads a frame is done first."""
    most = processors()
    one, all_of_them = (_least(partial(frame, n), _ROUNDS, perf_counter) for n in (1, most))
    return most if all_of_them < _FASTER * one else 1


def _least(
    run: Callable[[], object], rounds: int = _ROUNDS, clock: Callable[[], float] = process_time
) -> float:
    """Seconds of the fastest round, after one that is not counted."""
    run()
    found = []
    for _ in range(rounds):
        begin = clock()
        run()
        found.append(clock() - begin)
    return min(found)
