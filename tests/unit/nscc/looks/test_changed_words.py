"""Changed words, launches and levels of programs that look: the proof notices each that shows.

What still proves is executed over random light by the emulator, which shares no line with the
proof: exposures and states must be what they were.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from looks_programs import looking_frames

from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.operations import OPERATIONS, Op, Phase, WordEffect, op
from nscc.pipeline import KINDS, Options, run_passes
from nscc.source import Source
from nscc.words.container import Container, Launch, StoredKernel
from nscc.words.encoding import encode
from nscc.words.legality import decoded
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.sensor import default_sensor

SIDE = 16
CHANGES = 120

PROGRAMS = {
    "float": """nsl 2
frame 8 slots of 1ms
sense bright when light > 45% at n in [1, 2, 4]
state closed_at : 0..3 = 0
next closed_at = looks when bright and closed_at == 0
open when closed_at == 0
read closed_at
""",
    "two_senses": """nsl 2
frame 6 slots of 1ms
code late : 0..1
sense low when light < 20% at n in [2, 4]
sense high when light > 60% at n in [2, 3]
state held : 0..3 = 0
next held = looks when (high or low and late == 1) and held == 0
open when held == 0 and n < 5
read held
pixels late = x % 2
""",
    "kept": """nsl 2
frame 5 slots of 1ms
sense full when exposure > 30% at n == 5
state short : bit = 0 kept
state was : bit = 0
next was = short
next short = full
open when n < 4 and (not short or n < 2)
read short, was
""",
    "buckets": """nsl 2
frame 6 slots of 1ms
sense turned when exposure a > 25% at n in [2, 4]
state part : 0..2 = 0
next part = looks when turned and part == 0
bucket a open when part == 0
bucket b open when part != 0
read part
""",
}


def built(text: str) -> Container:
    """The container for a small array."""
    target = replace(builtin_target("scamp5"), rows=SIDE, cols=SIDE)
    found = run_passes(
        Source("test.nsl", text), Path(), Options(level=1, target=target, cache=False)
    )
    assert found.container is not None
    return found.container


def changed(container: Container, choose: random.Random) -> Container:
    """One word, one launch or one level changed."""
    kind = choose.choice(("word", "word", "word", "drop", "launch", "level"))
    if kind in ("word", "drop"):
        number = choose.randrange(len(container.kernels))
        words = list(container.kernels[number].words)
        place = choose.randrange(len(words))
        words[place : place + 1] = [] if kind == "drop" else [encode(any_word(choose))]
        kernels = list(container.kernels)
        kernels[number] = StoredKernel(kernels[number].name, tuple(words))
        return replace(container, kernels=tuple(kernels))
    launches = list(container.launches)
    place = choose.randrange(len(launches))
    old = launches[place]
    if kind == "launch":
        launches[place] = replace(old, kernel=choose.randrange(len(container.kernels)))
    else:
        level = None if old.level is None else old.level + choose.choice((-1, 1))
        launches[place] = Launch(old.instant, old.kernel, level)
    return replace(container, launches=tuple(launches))


def any_word(choose: random.Random) -> Op:
    """A word that the array takes, of registers that such programs use."""
    analog, digital = ("A", "B", "C", "NEWS"), ("R0", "R1", "R2", "R3", "R12")
    while True:
        row = choose.choice([row for row in OPERATIONS if row.phase is Phase.WHOLE])
        writes, reads = (analog, (*analog, "PIX", "IN")), (digital, (*digital, "FLAG"))
        targets, sources = writes if row.analog else reads
        least, most = row.sources
        count = choose.randint(least, min(most or 3, 3) if most != 0 else 0)
        made = choose.sample(targets, row.destinations[0]) if row.destinations[0] else []
        try:
            return op(row.name, made, choose.sample(sources, count))
        except ValueError:
            continue


def frames(container: Container, seed: int) -> Iterator[tuple[np.ndarray, dict[str, np.ndarray]]]:
    """Two frames of random light on a chip whose registers start with anything."""
    light = np.random.default_rng(seed).uniform(0, 12000, (container.slots, SIDE, SIDE))
    taken = looking_frames(
        container,
        Light.of_clip(light.astype(np.float32)),
        default_sensor(container.target),
        selected("none"),
        device_seed=seed,
        count=2,
    )
    for frame in taken:
        states = {k: v for k, v in frame.told.items() if k.startswith("states_")}
        yield frame.exposure_e, states


def alike(container: Container, other: Container) -> bool:
    """Whether two containers do the same on three chips."""
    for seed in range(3):
        pairs = zip(frames(container, seed), frames(other, seed), strict=True)
        for (exposure, states), (exposure_2, states_2) in pairs:
            if not np.allclose(exposure, exposure_2, rtol=1e-9, atol=1e-3):
                return False
            if any(not np.array_equal(states[name], states_2[name]) for name in states):
                return False
    return True


@pytest.mark.parametrize("name", PROGRAMS)
def test_changed_words_that_are_proved_open_the_same_shutters(name: str) -> None:
    container = built(PROGRAMS[name])
    choose = random.Random(name)
    noticed = 0
    for _ in range(CHANGES):
        other = changed(container, choose)
        try:
            kernels = decoded(other)
        except Rejected:
            continue
        if not KINDS.of(other).prove(other, kernels).holds:
            noticed += 1
        else:
            assert alike(container, other), [launch.level for launch in other.launches]
    assert noticed > CHANGES // 2


@pytest.mark.parametrize("name", PROGRAMS)
def test_the_proof_fails_without_any_single_comparison_word(name: str) -> None:
    container = built(PROGRAMS[name])
    for number, kernel in enumerate(decoded(container)):
        for place, word in enumerate(kernel):
            if word.operation.effect is not WordEffect.FLAG_ANALOG:
                continue
            words = list(container.kernels[number].words)
            del words[place]
            kernels = list(container.kernels)
            kernels[number] = StoredKernel(kernels[number].name, tuple(words))
            other = replace(container, kernels=tuple(kernels))
            assert not KINDS.of(other).prove(other, decoded(other)).holds


def test_the_proof_notices_a_changed_state_machine() -> None:
    container = built(PROGRAMS["float"])
    machine = container.machine
    kernels = decoded(container)
    opens = machine.opens.copy()
    opens[machine.nodes(2).stop - 1, 0, 2] ^= True
    steps = machine.steps.copy()
    steps[0] = steps[0][::-1]
    level = replace(machine.comparisons[1], level=machine.comparisons[1].level + 1)
    comparisons = (machine.comparisons[0], level, *machine.comparisons[2:])
    for other in (
        replace(machine, opens=opens),
        replace(machine, steps=steps),
        replace(machine, comparisons=comparisons),
    ):
        assert not KINDS.of(container).prove(replace(container, machine=other), kernels).holds
