"""The compiled loop of images and planes beside the reference: the same values, marks and bits."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from nscc.chips.load import builtin_target
from nscc.operations import NEIGHBOURS, STEERING, Op, op, pair
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc_runtime.effects import selected
from nscc_runtime.neighbours.pictured_program import PicturedProgram, PictureWords
from nscc_runtime.reference.array_pixels import ArrayPixels
from nscc_runtime.sensor import default_sensor

ROWS = 9
COLS = (13, 64, 130)
"""Columns of an array: less than a 64-bit word of a plane, a whole one, and more than two."""
ANALOG = ("A", "B", "C", "D", "E", "F", "NEWS")
DIGITAL = ("R0", *STEERING, "R5", "R6", "R12")


def random_word(rng: np.random.Generator) -> list[Op]:
    """A word that the table allows, or the two of a pair."""

    def some(names: tuple[str, ...], least: int, most: int) -> list[str]:
        return [str(name) for name in rng.permutation(names)[: rng.integers(least, most + 1)]]

    while True:
        try:
            match rng.integers(9):
                case 0:
                    return [op("bus", some((*ANALOG, *NEIGHBOURS), 1, 1), some(ANALOG, 0, 4))]
                case 1:
                    near = some(tuple(NEIGHBOURS), 1, 1)
                    return [op("bus", some(ANALOG, 1, 1), [*near, *some(ANALOG, 0, 3)])]
                case 2:
                    return [op("bus2", some(ANALOG, 2, 2), some((*ANALOG, *NEIGHBOURS), 1, 2))]
                case 3:
                    return [op("where", [], some((*ANALOG, "IN"), 1, 2))]
                case 4:
                    return [op("all")]
                case 5:
                    return [op("WHERE", [], some(DIGITAL, 1, 2))]
                case 6:
                    kind = str(rng.choice(["SET", "CLR", "OR", "NOR", "NOT", "MOV"]))
                    count = {"SET": 0, "CLR": 0, "OR": 2, "NOR": 2}.get(kind, 1)
                    into = some(DIGITAL, 1, 3 if count == 0 else 1)
                    return [op(kind, into, some((*DIGITAL, "FLAG"), count, count))]
                case 7:
                    kind = str(rng.choice(["OR", "NOR"]))
                    return list(pair(kind, some(DIGITAL, 1, 1)[0], some(DIGITAL, 1, 2)))
                case _:
                    kind = str(rng.choice(["DNEWS0", "DNEWS1"]))
                    return [op(kind, some(DIGITAL, 1, 1), some(DIGITAL, 1, 1))]
        except ValueError:
            continue


@pytest.mark.parametrize(
    "effects", ["none", "analog", "register", "comparator_offset", "comparator_noise", "all"]
)
@pytest.mark.parametrize("obeys_flag", [False, True])
@pytest.mark.parametrize("seed", range(20))
def test_the_compiled_loop_executes_random_words_like_the_reference(
    seed: int, obeys_flag: bool, effects: str
) -> None:
    """Both draw the same numbers, which the loop computes to some millionths."""
    rng, cols = np.random.default_rng(seed), COLS[seed % len(COLS)]
    target = replace(builtin_target("scamp5"), rows=ROWS, cols=cols, where_obeys_flag=obeys_flag)
    text = "nsl 3 frame 1 slots of 1ms open when true image i = exposure / 2 read i"
    options = Options(level=0, target=target, cache=False)
    container = run_passes(Source("p.nsl", text), Path(), options).container
    assert container is not None
    words = [
        (word, int(rng.integers(-90, 90)) if rng.random() < 0.3 else None)
        for _ in range(60)
        for word in random_word(rng)
    ]
    pixels = ROWS * cols
    exposed = {name: rng.integers(-9000, 20000, pixels).astype(float) for name in ANALOG}
    exposed_by = {name: rng.choice([0, 0, 1, 2], pixels).astype(np.uint8) for name in ANALOG}
    code = {name: rng.random(pixels) < 0.5 for name in (*target.digital_registers, "FLAG")}
    sensor, selection, noise_seed, device_seed, frame = (
        default_sensor(target),
        selected(effects),
        3,
        4,
        5,
    )
    reference = ArrayPixels(
        sensor=sensor,
        seed=noise_seed,
        device_seed=device_seed,
        frame=frame,
        places=np.arange(pixels, dtype=np.int64),
        container=container,
        effects=selection,
        code=code,
        shape=(ROWS, cols),
        exposed=exposed,
        exposed_by=exposed_by,
    )
    reference.run_words(words)
    reference.hold(0.02)
    program = PicturedProgram(container, sensor, selection)
    errors = program.errors((noise_seed, device_seed), frame, pixels)
    contents = PictureWords(target, words).run((ROWS, cols), exposed, exposed_by, code, errors)
    contents.hold(0.02)
    close_e = 0.0 if effects == "none" else 0.02
    for name in ANALOG:
        register, cut_by = contents.register[name].reshape(-1), contents.cut_by[name].reshape(-1)
        np.testing.assert_allclose(register, reference.register[name], rtol=1e-12, atol=close_e)
        np.testing.assert_array_equal(cut_by, reference.cut_by[name])
    for name in (*target.digital_registers, "FLAG"):
        np.testing.assert_array_equal(contents.bit(name).reshape(-1), reference.bit(name))
