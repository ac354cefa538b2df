"""Random programs that look: their words do to every pixel what an interpreter of the text does."""

from __future__ import annotations

from dataclasses import replace
from itertools import count as counted
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from looks_oracle import FULL_WELL_E, Interpreter
from looks_programs import looking_frames, random_program
from marks import slow

from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words.container import Container
from nscc.words.file import from_bytes, to_bytes
from nscc_runtime.effects import selected
from nscc_runtime.execution.block_program import lacks
from nscc_runtime.light import Light
from nscc_runtime.looked_frames import frames
from nscc_runtime.sensor import default_sensor

PROGRAMS, CHUNKS = 2000, 20
"""So many programs run, in so many tests."""
SIDE = 2
ALLOWED = {"NS0324", "NS0502", "NS0601", "NS0415", "NS0350"}
"""What such a program may be refused for: it tells too little, or is too large."""
MOST_REFUSED = 0.4


def compiled(text: str, level: int) -> Container | None:
    """The proved container for a small array; None where the program is refused for good."""
    name = "scamp5-algorithm1" if "algorithm1" in text else "scamp5"
    target = replace(builtin_target(name), rows=SIDE, cols=SIDE)
    options = Options(level=level, target=target, codes="open", cache=False)
    try:
        made = run_passes(Source("random.nsl", text), Path(), options)
    except Rejected as rejected:
        wrong = {d.code for d in rejected.diagnostics if d.severity.value == "error"}
        if not wrong <= ALLOWED:
            raise
        return None
    assert made.container is not None
    return made.container


def with_codes(container: Container, seed: int) -> Container:
    """The container with a code of its own for every pixel."""
    codes = np.random.default_rng(seed).integers(0, len(container.table.codes), (SIDE, SIDE))
    return replace(container, pixel_codes=codes.astype(np.int32))


@pytest.mark.parametrize("chunk", [slow(c) if c % 5 else c for c in range(CHUNKS)])
def test_words_of_random_looking_programs_equal_the_interpreter(chunk: int) -> None:
    run(chunk, range(PROGRAMS // CHUNKS))


@pytest.mark.slow
@pytest.mark.parametrize("chunk", range(CHUNKS, 3 * CHUNKS))
def test_more_random_programs_of_level_2_equal_the_interpreter(chunk: int) -> None:
    run(chunk, range(PROGRAMS // CHUNKS), level=2)


def run(chunk: int, programs: range, level: int | None = None) -> None:
    """Runs so many programs that are accepted; few are refused, and for what is allowed."""
    seeds, refused = counted(chunk * 100_000), 0
    for _ in programs:
        for seed in seeds:
            text = random_program(seed)
            found = compiled(text, (1 if seed % 40 == 0 else 0) if level is None else level)
            if found is not None:
                check(text, with_codes(found, seed), seed)
                break
            refused += 1
    assert refused < MOST_REFUSED * len(programs)


def check(text: str, container: Container, seed: int) -> None:
    """Random light, pixel by pixel; two frames of it where a state is kept."""
    interpreter = Interpreter(text)
    choose = np.random.default_rng(seed)
    share = choose.uniform(0, 2.0, (container.slots, SIDE, SIDE)) * choose.uniform(
        0, 1, (SIDE, SIDE)
    )
    light = (share * FULL_WELL_E / container.slots).astype(np.float32)
    sensor = default_sensor(container.target)
    assert container.pixel_codes is not None
    kept_names = {state.name for state in container.machine.states if state.is_kept}
    scene, none, count = Light.of_clip(light), selected("none"), 2 if kept_names else 1
    taken = [*looking_frames(container, scene, sensor, none, device_seed=seed, count=count)]
    assert not lacks(container, sensor, none), text
    for words, ways in zip(taken, frames(container, scene, sensor, none, count=count), strict=True):
        assert np.array_equal(words.exposure_e, ways.exposure_e), text
        alike = (np.array_equal(words.told[key], ways.told[key], True) for key in words.told)
        assert all(alike), text
    if seed % 20 == 0:
        check_with_effects(text, container, scene, seed)
    kept: dict[tuple[int, int], dict[str, object]] = {}
    for number, frame in enumerate(taken):
        for y, x in product(range(SIDE), repeat=2):
            code = container.table.codes[container.pixel_codes[y, x]].tolist()
            fields = dict(zip(container.table.fields, code, strict=True))
            electrons = light[:, y, x].astype(float).tolist()
            pixel = interpreter.run(fields, electrons, kept.get((y, x)))
            where = (text, number, (y, x), fields)
            np.testing.assert_allclose(
                frame.exposure_e[:, y, x], pixel.exposure, rtol=1e-9, atol=1e-6, err_msg=str(where)
            )
            opens = [sum(each) for each in pixel.opens]
            assert frame.told["open_slots"][:, y, x].tolist() == opens, where
            for name, value in pixel.states.items():
                assert frame.told[f"states_{name}"][y, x] == int(value), (name, where)
            kept[y, x] = {name: pixel.states[name] for name in kept_names & pixel.states.keys()}


def check_with_effects(text: str, container: Container, scene: Light, seed: int) -> None:
    """With all effects but counts, paths give what the words give, to the rounding of noise."""
    sensor, every = default_sensor(container.target), selected("all,-shot,-dark")
    assert not lacks(container, sensor, every), text
    options = {"seed": seed, "device_seed": seed, "count": 2}
    for words, ways in zip(
        looking_frames(container, scene, sensor, every, **options),
        frames(container, scene, sensor, every, **options),
        strict=True,
    ):
        np.testing.assert_allclose(
            ways.exposure_e, words.exposure_e, rtol=1e-9, atol=1e-3, err_msg=text
        )
        assert np.array_equal(ways.saturated_by, words.saturated_by), text
        assert np.array_equal(ways.told["open_slots"], words.told["open_slots"]), text


@pytest.mark.parametrize(
    ("last", "rule"),
    [
        (32, "count + 1 when bright and count < 32"),
        (44, "count + 1 when not bright and count < 44"),
        (63, "count + 1 when bright"),
        (100, "count + 1 when bright and count < 100"),
    ],
)
def test_counting_in_a_state_of_many_values_takes_few_words_for_each_bit(
    last: int, rule: str
) -> None:
    """The state takes five words for each bit, three more for a bit of the limit, and the words of
    the look."""
    slots = 60 if last == 63 else last + 10
    text = (
        f"nsl 2\nframe {slots} slots of 100us\nsense bright when light > 50% at n > 0\n"
        f"state count : 0..{last} = 0\nnext count = {rule}\nopen when true\nread count\n"
    )
    found = compiled(text, 1)
    assert found is not None
    for seed in range(3):
        check(text, with_codes(found, seed), seed)
    words = [0] * (slots + 1)
    for launch in found.launches:
        words[launch.instant] += len(found.kernels[launch.kernel].words)
    assert max(words[1:slots]) <= (8 if "<" in rule else 5) * last.bit_length() + 9


@pytest.mark.parametrize("seed", range(0, 60))
def test_containers_of_machines_are_their_bytes(seed: int) -> None:
    container = compiled(random_program(seed), 0)
    # The program does not fit the chip.
    if container is None:
        return
    data = to_bytes(container)
    assert to_bytes(from_bytes(data, "x")) == data
