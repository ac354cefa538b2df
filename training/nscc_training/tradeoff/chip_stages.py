"""What the words cost and what they do to a frame: levels, lowerings, slots."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from nscc.containers import with_pixels
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.lower.plan import LOWERINGS
from nscc.pipeline import Compiled, run_passes
from nscc.source import Source
from nscc.tradeoff.points import Point
from nscc.tradeoff.slots import NotJoined, in_fewer, with_slot_us
from nscc.tradeoff.synthesis import DOES_NOT_FIT
from nscc.words.container import Container
from nscc_training.tradeoff.bench import Bench, scaled, whole_ticks
from nscc_training.tradeoff.stages import PERCENT, Found, Misfit

JOINED = {1: "all", 2: "halves", 4: "quarters"}
"""Slots that are taken together as one, and what that leaves of them."""
LENGTHS = (0.25, 0.5, 1.0, 2.0)
"""Frames as parts of the program's own."""
_COMPILED = Misfit(
    "", "", "NS0743", "the program is compiled already: give its text, FILE.nsl, to compare these"
)


def compiling(bench: Bench) -> Found:
    """Levels of -O: seconds to compile, from text to proof and without the cache."""
    if bench.source is None:
        return Found((), (replace(_COMPILED, stage="compile"),))
    points, misfits = [], []
    for level in bench.asked.levels:
        setting = f"-O{level}"
        made = _compiled(bench, bench.source, level=level)
        if isinstance(made, Diagnostic):
            misfits.append(Misfit.of("compile", setting, made))
            continue
        container = _laid(bench, made)

        bench.watch.ran("compile", level)
        again = partial(_compiled, bench, bench.source, level=level)
        timed = partial(bench.watch.times_ms, bench.asked.repeats, "compile", level, again)
        took = bench.once(f"compile {level}", timed)
        points.append(_point(
            "compile", container.notes.get("lowering", ""),
            f"{setting} ({container.words_per_frame} words)",
            bench.error_percent(container), tuple(took),
        ))  # fmt: skip
    return Found(tuple(points), tuple(misfits))


def lowering(bench: Bench) -> Found:
    """Ways to gather exposures: the shortest frame that their words allow."""
    if bench.source is None:
        return Found((), (replace(_COMPILED, stage="lowering"),))
    if bench.container.machine is not None or bench.container.target.streamed:
        what = "pixels that look" if bench.container.machine is not None else "a chip without logic"
        reason = f"there is one way for {what}"
        return Found((), (Misfit("lowering", "", "", reason),))
    points, misfits = [], []
    for name in LOWERINGS:
        made = _compiled(bench, bench.source, lowering=name)
        if isinstance(made, Diagnostic):
            misfits.append(Misfit.of("lowering", name, made))
            continue
        container = _laid(bench, made)
        frame_ms = made.shortest_slot_us * container.slots / 1e3
        setting = f"{container.words_per_frame} words"
        points.append(
            _point("lowering", name, setting, bench.error_percent(container), (frame_ms,))
        )
    return Found(tuple(points), tuple(misfits))


def slots(bench: Bench) -> Found:
    """Fewer slots, and frames of other lengths down to the shortest that the words allow.

    The scene is as bright in all of them, so that less light falls in a shorter frame. A program in
    fewer slots opens its pixels where the given one does for half of the time; its error is from
    what the given one would see in a frame as long.
    """
    if bench.source is None:
        return Found((), (replace(_COMPILED, stage="slots"),))
    points, misfits, seen = [], [], set[tuple[int, float]]()
    frame_us = sum(bench.container.slot_us)
    for join in JOINED:
        try:
            source, own, codes = _program(bench, join)
        except NotJoined as why:
            misfits.append(Misfit("slots", JOINED[join], "", str(why)))
            continue
        count = own.slots // join
        shortest = _compiled(bench, source)
        if isinstance(shortest, Diagnostic):
            misfits.append(Misfit.of("slots", f"{count} slots", shortest))
            continue
        least_us = whole_ticks(shortest.shortest_slot_us) * count
        for whole_us in (least_us, *(frame_us * part for part in LENGTHS)):
            if whole_us < least_us or (count, whole_us) in seen:
                continue
            seen.add((count, whole_us))
            timed = replace(own, slot_us=scaled(own, whole_us))
            slot_us = np.array(timed.slot_us).reshape(-1, join).sum(axis=1).tolist()
            made = _compiled(bench, with_slot_us(source, slot_us))
            uneven = not np.allclose(slot_us, slot_us[0])
            setting = f"{whole_us / count:.5g} us" + " in the mean" * uneven
            if isinstance(made, Diagnostic):
                misfits.append(Misfit.of("slots", f"{count} x {setting}", made))
                continue
            container = _laid(bench, made, codes)
            error = bench.error_percent(container, timed)
            points.append(_point("slots", f"{count} slots", setting, error, (whole_us / 1e3,)))
    return Found(tuple(points), tuple(misfits))


def _program(bench: Bench, join: int) -> tuple[Source, Container, Any]:
    """The program in fewer slots, the given one, and the codes of its pixels; raises NotJoined."""
    assert bench.source is not None
    own = bench.container
    if join == 1:
        return bench.source, own, None
    text, codes = in_fewer(own, join)
    return Source(bench.source.name, text), own, {"id": codes}


def _compiled(bench: Bench, source: Source, **changes: Any) -> Compiled | Diagnostic:
    """The program compiled without the cache, or why it does not fit."""
    options = replace(bench.asked.options, cache=False, **changes)
    if options.target is None:
        options = replace(options, target=bench.container.target)
    try:
        return run_passes(source, bench.asked.program.parent, options)
    except Rejected as rejected:
        last = rejected.diagnostics[-1]
        if not last.code.startswith(DOES_NOT_FIT):
            raise
        return last


def _laid(bench: Bench, made: Compiled, codes: Any = None) -> Container:
    """Its words, with codes for its pixels."""
    assert made.container is not None
    given = bench.asked.pixels if codes is None else codes
    return with_pixels(made.container, Path(bench.asked.program), given)


def _point(
    stage: str, method: str, setting: str, error: float, taken_ms: tuple[float, ...]
) -> Point:
    return Point(stage, method, setting, error, PERCENT, taken_ms)
