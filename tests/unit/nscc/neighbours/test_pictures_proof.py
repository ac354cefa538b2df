"""The proof of images and planes notices every word that is changed."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from marks import slow
from nscc_command import invoke

import nscc
from nscc.chips.load import builtin_target
from nscc.neighbours.pictures_proof import pictures_fault
from nscc.operations import NEIGHBOURS, Op, op
from nscc.pipeline import Options, run_passes
from nscc.prove import diagrams
from nscc.source import Source
from nscc.syntax.parse import read_source
from nscc.words.container import Container, StoredKernel
from nscc.words.encoding import encode, matching
from nscc.words.legality import picture_fault
from nscc_runtime.effects import selected
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.neighbours.pictured_program import PicturedProgram
from nscc_runtime.sensor import default_sensor

EXAMPLES = ROOT / "examples"
NAMES = ("edges", "bright_spots", "motion_in_a_frame", "local_contrast", "grown_regions", "cell")
CELL = """nsl 3
frame 1 slots of 33ms
open when true
outside 1
kernel wf = [[1, -1, 1]]
kernel uf = [[-1], [1], [-1]]
kernel wo = [[1, 1, 0]]
kernel uo = [[-1], [-1], [1]]
state h : bit = 1 kept
plane x = exposure > 50%
image f = agree(x, wf) + agree(h, uf)
image o = agree(x, wo) + agree(h, uo)
image most = max(o, wf)
next h = not (h xor f > 0)
read h, o, most
"""
"""Four kernels counted in one walk, and the largest count of neighbours."""
SIDE = 20
MUTATIONS = 50
"""Of each program, in each of five parts."""


@cache
def container_of(name: str) -> Container:
    target = replace(builtin_target("scamp5"), rows=SIDE, cols=SIDE)
    in_text = name == "cell"
    source = Source("cell.nsl", CELL) if in_text else read_source(EXAMPLES / f"{name}.nsl")
    made = run_passes(source, EXAMPLES, Options(level=1, target=target, cache=False)).container
    assert made is not None
    return made


def with_word(container: Container, kernel: int, index: int, word: Op | None) -> Container:
    """The container with another word, or without one, in the kernels of its images."""
    pictures = container.pictures
    kernels = [list(words) for words in pictures.kernels]
    kernels[kernel][index : index + 1] = [] if word is None else [encode(word)]
    return replace(container, pictures=replace(pictures, kernels=tuple(map(tuple, kernels))))


def mutated(word: Op, rng: np.random.Generator, container: Container) -> Op | None:
    """Another word that the target takes, with other operands; None takes the word away."""
    if rng.random() < 0.15:
        return None
    analog = [*container.target.analog_registers, *NEIGHBOURS, "IN"]
    names = analog if word.analog else list(container.target.digital_registers)
    for _ in range(200):
        destinations, sources = list(word.destinations), list(word.sources)
        operands = destinations if destinations and rng.random() < 0.4 else sources
        if operands and rng.random() < 0.7:
            operands[rng.integers(len(operands))] = str(rng.choice(names))
        elif operands:
            operands.append(str(rng.choice(names)))
        else:
            destinations.append(str(rng.choice(names)))
        name = word.name
        if rng.random() < 0.1:
            name = {
                "bus": "bus2",
                "bus2": "bus",
                "OR": "NOR",
                "NOT": "MOV",
                "MOV": "NOT",
                "DNEWS0": "DNEWS1",
                "DNEWS1": "DNEWS0",
                "SET": "CLR",
                "CLR": "SET",
            }.get(name, name)
        try:
            made = op(name, destinations, sources)
        except ValueError:
            continue
        if made != word and picture_fault(made, container.target) is None:
            return made
    return None


def film_of(container: Container, seed: int) -> list[Frame]:
    """Frames one after the other: what a state does shows in later ones."""
    rng = np.random.default_rng(seed)
    frames = 3 if container.pictures.states else 1
    lights = [
        rng.integers(0, 30000, (container.slots, SIDE, SIDE)) / container.slots
        for _ in range(frames)
    ]
    sensor = default_sensor(container.target)
    runner = PicturedProgram(container, sensor, selected("none"), threads=1)
    return list(runner.film((Light.of_clip(e.astype(np.float32)) for e in lights), 0, seed))


def same_frames(first: Container, second: Container) -> bool:
    """Whether two containers give the same images and planes outside of their margins."""
    for seed in range(2):
        films = film_of(first, seed), film_of(second, seed)
        if not all(same_frame(a, b) for a, b in zip(*films, strict=True)):
            return False
    return True


def same_frame(a: Frame, b: Frame) -> bool:
    inside = ~(a.told["margin"] | b.told["margin"])
    for key, values in a.told.items():
        computed = key.startswith(("image_", "plane_")) and "saturated" not in key
        if computed and not np.allclose(values[inside], b.told[key][inside], atol=1e-6):
            return False
        reported = key.startswith("report_") and inside.all()
        if reported and not np.array_equal(values, b.told[key]):
            return False
    return True


@pytest.mark.parametrize("name", NAMES)
def test_words_of_examples_are_proved(name: str) -> None:
    assert pictures_fault(container_of(name)) is None


def test_a_proof_that_is_too_large_is_refused_as_an_error_of_the_program(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = (
        "nsl 3\nframe 1 slots of 1ms\nopen when true\noutside 0\n"
        "kernel k = [[1, 1, 1], [1, 1, 1], [1, 1, 1]]\nplane a = exposure > 50%\n"
        "plane pair = a and a[0, 3]\nplane far = any(pair, k)\nplane b = exposure > 60%\n"
        "read far, b\n"
    )
    (tmp_path / "p.nsl").write_text(text)
    assert invoke(["build", "p.nsl", "-o", "p.icw"], tmp_path).status == 0
    monkeypatch.setattr(diagrams, "MOST_NODES", 1500)
    refused = invoke(["build", "p.nsl", "-o", "q.icw"], tmp_path)
    assert (refused.status, refused.codes) == (1, ["NS0544"])
    assert "`far` depends on" in refused.err
    assert "all that is computed before `far`" in refused.err
    assert "compare a count" in refused.err
    assert "p.nsl:8:1" in refused.err
    assert not (tmp_path / "q.icw").exists()
    assert invoke(["prove", "p.icw"], tmp_path).codes == ["NS0544"]
    # A count is one answer: the same plane needs fewer nodes.
    (tmp_path / "p.nsl").write_text(text.replace("any(pair, k)", "agree(pair, k) > -9"))
    assert invoke(["build", "p.nsl", "-o", "q.icw"], tmp_path).status == 0


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("part", [0, *(slow(part) for part in range(1, 5))])
def test_changed_words_pass_the_proof_only_if_frames_stay_the_same(name: str, part: int) -> None:
    container = container_of(name)
    pictures = container.pictures
    rng = np.random.default_rng(44 + part)
    passed = 0
    for _ in range(MUTATIONS):
        kernel = int(rng.integers(len(pictures.kernels)))
        index = int(rng.integers(len(pictures.kernels[kernel])))
        word = matching(pictures.kernels[kernel][index])
        assert word is not None
        changed = with_word(container, kernel, index, mutated(word, rng, container))
        if pictures_fault(changed) is None:
            passed += 1
            assert same_frames(container, changed), f"{word} in kernel {kernel}, word {index}"
    assert passed < MUTATIONS // 2  # words that are not needed, such as a second `all`


def test_another_level_of_in_does_not_pass() -> None:
    """Every level of the input IN is one step higher in the container. The proof names the plane
    that is then wrong."""
    container = container_of("edges")
    pictures = container.pictures
    launches = tuple(
        replace(launch, level=None if launch.level is None else launch.level + 1)
        for launch in pictures.launches
    )
    changed = replace(container, pictures=replace(pictures, launches=launches))
    assert pictures_fault(changed) == "`edge` differs from its expression in the program"


def test_the_proof_depends_on_the_declared_bits_beyond_the_array() -> None:
    """The words were compiled for `outside 0`, so the proof fails for `outside 1`."""
    container = container_of("bright_spots")
    pictures = container.pictures
    changed = replace(container, pictures=replace(pictures, outside=1))
    assert pictures_fault(changed) == "`core` differs from its expression in the program"


def test_values_that_are_equal_in_some_pixels_are_compared() -> None:
    # `bright[1, 0]` is 1 in the last column: there `i` is always the exposure.
    text = (
        "nsl 3 frame 1 slots of 1ms open when true outside 1 plane bright = exposure > 4% "
        "image i = exposure if bright[1, 0] else exposure / 2 plane p = i > exposure read p"
    )
    assert pictures_fault(nscc.compile(text, level=1).container) is None


def test_the_largest_of_negative_values_is_proved() -> None:
    text = (
        "nsl 3 frame 1 slots of 1ms open when true assume exposure <= 8% kernel k = [[-1, -1, 0]] "
        "image a = k(exposure) image b = max(exposure, k) read a, b"
    )
    assert pictures_fault(nscc.compile(text, level=1).container) is None


def test_the_proof_reports_words_that_overwrite_a_code_bit() -> None:
    container = container_of("bright_spots")
    assert (
        pictures_fault(replace(container, code_registers=("R5",)))
        == "R5 holds a code bit, but a word overwrites it"
    )


def test_the_proof_notices_a_state_in_another_register() -> None:
    """A register that holds something else at the end, or that the exposure writes, is no state."""
    container = container_of("cell")
    pictures = container.pictures
    moved = replace(pictures, registers={**pictures.registers, "h": "R11"})
    assert pictures_fault(replace(container, pictures=moved)) == (
        "`h` differs from its expression in the program"
    )
    writing = StoredKernel("writes", (encode(op("SET", [pictures.registers["h"]])),))
    spoilt = replace(container, kernels=(*container.kernels, writing))
    reason = "the register of a state is also used for other bits"
    assert pictures_fault(spoilt) == reason
