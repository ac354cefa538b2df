"""What is drawn of programs that look is what their text does with steady light."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from looks_oracle import FULL_WELL_E, Interpreter
from looks_programs import random_program
from nscc_command import invoke
from PIL import Image

import nscc
from nscc.diagnostics.diagnostic import Rejected
from nscc.words.container import Container
from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.looking_chart import course_sheet, courses, thresholds
from nscc_runtime.pictures.sheet import DARK, themed

LOOKING = ("float_pixel", "auto_exposure", "first_light", "spike")
WELLS = np.geomspace(0.05, 60, 9)


def check(text: str, container: Container) -> None:
    """Two frames of every behaviour at some lights."""
    interpreter, table, machine = Interpreter(text), container.table, container.machine
    for behaviour in range(int(machine.behaviour.max()) + 1):
        code = int(np.flatnonzero(table.shutter_of_code == behaviour)[0])
        fields = dict(zip(table.fields, table.codes[code].tolist(), strict=True))
        frames = [courses(container, behaviour, WELLS, frame) for frame in range(2)]
        for light, wells in enumerate(WELLS):
            electrons = [wells * FULL_WELL_E / container.slots] * container.slots
            kept: dict[str, object] = {}
            for found in frames:
                pixel = interpreter.run(fields, electrons, kept)
                assert found.opens[light].tolist() == pixel.opens, (text, fields, wells)
                names = [state.name for state in machine.states]
                for name, value in pixel.states.items():
                    assert found.values[light, names.index(name)] == int(value), (text, wells)
                kept = {s.name: pixel.states[s.name] for s in machine.states if s.is_kept}


@pytest.mark.parametrize("name", LOOKING)
def test_charts_of_examples_agree_with_the_interpreter(name: str) -> None:
    path = ROOT / "examples" / f"{name}.nsl"
    check(path.read_text(), nscc.compile(path, level=0).container)


@pytest.mark.filterwarnings("ignore::UserWarning")  # of shutters that never open
def test_charts_of_random_programs_agree_with_the_interpreter() -> None:
    done = 0
    for seed in range(100):
        text = random_program(seed)
        try:
            container = nscc.compile(text, level=0, codes="open").container
        except Rejected:
            continue
        check(text, container)
        done += 1
        if done == 12:
            return
    raise AssertionError(f"only {done} programs compile")


def test_answers_change_where_the_light_reaches_the_level() -> None:
    """The pixel is not reset, and looks at 45 % of a well, rounded to a step of IN."""
    container = nscc.compile(ROOT / "examples/float_pixel.nsl", level=0).container
    level = round(0.45 * 127) / 127
    # By slot n of 256 a pixel has n / 256 of the frame's light.
    expected = [(n, level * 256 / n) for n in (1, 2, 4, 8, 16, 32, 64, 128)]
    assert thresholds(container) == pytest.approx([at for _, at in expected])
    wells = np.geomspace(0.1, 300, 2000)
    found = courses(container, 0, wells).flips
    assert [n for n, _ in found] == [n for n, _ in expected]
    assert [at for _, at in found] == pytest.approx([at for _, at in expected], rel=0.01)


def test_a_program_whose_answers_never_change_is_drawn() -> None:
    """The pixel is closed when it is asked."""
    text = (
        "nsl 2 frame 4 slots of 1ms sense full when exposure > 30% at n == 2 "
        "state s : bit = 0 next s = full open when n > 2 and not s read s"
    )
    container = nscc.compile(text + "\n", level=0).container
    assert courses(container, 0, np.geomspace(0.1, 300, 50)).flips == ()
    assert sheet.png_of(course_sheet, container, "p.nsl").startswith(b"\x89PNG")


def test_charts_of_looking_programs_are_drawn_on_white_and_dark_ground(tmp_path: Path) -> None:
    program = ROOT / "examples" / "float_pixel.nsl"
    done = invoke(["view", str(program), "-O", "0", "-o", "v.png"], tmp_path)
    assert done.status == 0, done.err
    light = np.asarray(Image.open(tmp_path / "v.png").convert("RGB"))
    container = nscc.compile(program, level=0).container
    with themed(DARK):
        (tmp_path / "dark.png").write_bytes(sheet.png_of(course_sheet, container, program.name))
    dark = np.asarray(Image.open(tmp_path / "dark.png").convert("RGB"))
    assert dark.shape == light.shape
    # The background in the corner is white or nearly black.
    assert light[0, 0].mean() > 240 > 60 > dark[0, 0].mean()
