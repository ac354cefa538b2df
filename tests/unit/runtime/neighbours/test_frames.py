"""Frames of images and planes: borders, marks, reports, effects, and what Python makes of them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import nscc
import nscc_runtime
from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.neighbours.picture_report import picture_report
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words.assembly import assemble
from nscc.words.container import Container
from nscc.words.disassembly import disassemble
from nscc.words.file import from_bytes, to_bytes
from nscc_runtime.effects import selected
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.neighbours.pictured_program import PicturedProgram
from nscc_runtime.sensor import default_sensor

SIDE = 16
HEAD = "nsl 3 frame 1 slots of 1ms open when true "
CROSS = "kernel k = [[0, 1, 0], [1, 1, 1], [0, 1, 0]] / 8 "


def container_of(text: str, side: int = SIDE) -> Container:
    target = replace(builtin_target("scamp5"), rows=side, cols=side)
    options = Options(level=1, target=target, cache=False)
    made = run_passes(Source("p.nsl", text), Path(), options).container
    assert made is not None
    return made


def exposed(
    container: Container, light: NDArray[np.float32], effects: str = "none", seed: int = 0
) -> Frame:
    sensor = default_sensor(container.target)
    runner = PicturedProgram(container, sensor, selected(effects), threads=1)
    (frame,) = runner.film([Light.of_clip(light[None].astype(np.float32))], seed, 1)
    return frame


def test_the_margin_marks_pixels_that_depend_on_light_beyond_the_array() -> None:
    container = container_of(HEAD + CROSS + "image i = k(exposure) read i")
    light = np.full((SIDE, SIDE), 800.0, np.float32)
    frame = exposed(container, light)
    inner = np.zeros((SIDE, SIDE), np.bool_)
    inner[1:-1, 1:-1] = True
    assert np.array_equal(~frame.told["margin"], inner)
    assert np.all(frame.told["image_i"][inner] == 500.0)
    # Images have symmetric codes: 0 electrons at 128, and 60000 electrons in 255 steps.
    assert np.all(frame.told["image_codes_i"][inner] == 128 + round(500 / (60000 / 255)))
    assert frame.frame.shape == (0, SIDE, SIDE)


@pytest.mark.parametrize("outside", [0, 1])
def test_bits_beyond_the_array_are_as_declared(outside: int) -> None:
    text = (
        HEAD + CROSS + f"outside {outside} plane p = exposure > 50% plane near = any(p, k) "
        "plane core = all(p, k) plane right = p[1, 0] read near, core, right"
    )
    for bright in (False, True):
        light = np.full((SIDE, SIDE), 20000.0 if bright else 100.0, np.float32)
        told = exposed(container_of(text), light).told
        edge = np.ones((SIDE, SIDE), np.bool_)
        edge[1:-1, 1:-1] = False
        assert np.array_equal(told["plane_near"], edge & bool(outside) | bright)
        assert np.array_equal(told["plane_core"], (~edge | bool(outside)) & bright)
        assert np.array_equal(told["plane_right"][:, -1], np.full(SIDE, bool(outside)))
        assert not told["margin"].any()


def test_reports_list_the_positions_of_bits() -> None:
    """Without a bit set the count is 0 and the box is four times -1. Of four bits the first three
    are listed as (column, row), and an overflow is noted."""
    text = (
        HEAD + "plane p = exposure > 50% report events p at most 3 report any p report box p read p"
    )
    light = np.zeros((SIDE, SIDE), np.float32)
    told = exposed(container_of(text), light).told
    assert not told["report_any_p"]
    assert told["report_box_p"].tolist() == [-1] * 4
    assert told["report_events_p_count"] == 0
    light[2, 5] = light[7, 1] = light[7, 9] = light[11, 4] = 20000
    told = exposed(container_of(text), light).told
    assert told["report_any_p"]
    assert told["report_events_p"].tolist() == [[5, 2], [1, 7], [9, 7]]
    assert told["report_events_p_overflow"]
    assert told["report_box_p"].tolist() == [1, 2, 9, 11]


def test_planes_in_the_margin_are_not_reported() -> None:
    text = HEAD + CROSS + "image i = k(exposure) plane p = i < 10% report box p"
    told = exposed(container_of(text), np.zeros((SIDE, SIDE), np.float32)).told
    assert told["report_box_p"].tolist() == [1, 1, SIDE - 2, SIDE - 2]


def test_values_beyond_the_assumed_exposure_are_marked() -> None:
    text = HEAD + "assume exposure <= 50% image twice = exposure * 2 read twice"
    light = np.full((SIDE, SIDE), 1000.0, np.float32)
    light[3, 3] = 15001
    frame = exposed(container_of(text), light)
    # 32 is the bit for such values; one pixel is above 50 % of 30000 electrons.
    marked = frame.told["image_saturated_by_twice"] & 32
    assert marked[3, 3] == 32
    assert np.count_nonzero(marked) == 1
    assert frame.told["image_twice"][3, 3] == 30002


def test_a_mark_travels_with_the_branch_that_was_chosen() -> None:
    text = (
        "nsl 3 frame 2 slots of 1ms bucket a open when n == 0 bucket b open when n == 1 "
        "assume exposure b <= 10% plane full = a > 50% image i = b if full else a / 2 read i"
    )
    container = container_of(text)
    light = np.full((2, SIDE, SIDE), 4000.0, np.float32)  # b is beyond 10 % everywhere
    light[0, 5, 6] = 20000.0
    sensor = default_sensor(container.target)
    runner = PicturedProgram(container, sensor, selected("none"), threads=1)
    (frame,) = runner.film([Light.of_clip(light)], 0, 1)
    marked = frame.told["image_saturated_by_i"] & 32
    assert marked[5, 6] == 32
    assert np.count_nonzero(marked) == 1


def test_the_error_of_words_is_what_the_report_says() -> None:
    container = container_of(
        HEAD + "kernel k = [[1, 2, 1], [2, 4, 2], [1, 2, 1]] / 16 image i = k(exposure) read i",
        side=128,
    )
    sensor = default_sensor(container.target)
    light = np.full((128, 128), 9000.0, np.float32)
    quiet = sensor.changed(
        analog_pattern_lsb=0.0, analog_gain=1.0, analog_noise_lsb=0.4, analog_move_noise=1.0
    )
    runner = PicturedProgram(container, quiet, selected("analog"), threads=1)
    (frame,) = runner.film([Light.of_clip(light[None])], 3, 1)
    inside = ~frame.told["margin"]
    word_e = quiet.analog_noise_lsb * quiet.analog_lsb_e
    # The exposure has errors of its own: two words, blurred by the kernel.
    # The squares of the weights add up to (1 + 4 + 1)^2 = 36, over 16^2.
    exposure_words = 2 * 36 / 256
    report = picture_report(container)["images"]["i"]
    expected_e = word_e * np.sqrt(report["noise_gain"] ** 2 + exposure_words)
    measured_e = frame.told["image_i"][inside].std()
    assert measured_e == pytest.approx(expected_e, rel=0.12)


def test_effects_are_the_same_for_the_same_seed() -> None:
    container = container_of(HEAD + CROSS + "image i = k(exposure) plane p = i > 10% read i, p")
    light = np.full((SIDE, SIDE), 6000.0, np.float32)
    first, again, other = (exposed(container, light, "all", seed) for seed in (1, 1, 2))
    assert np.array_equal(first.told["image_i"], again.told["image_i"])
    assert not np.array_equal(first.told["image_i"], other.told["image_i"])


def test_the_frame_has_only_the_buckets_that_the_program_reads() -> None:
    text = (
        "nsl 3 frame 2 slots of 1ms bucket a open when n == 0 bucket b open when n == 1 "
        "image d = b - a read b, d"
    )
    container = container_of(text)
    light = np.stack([np.full((SIDE, SIDE), e, np.float32) for e in (100.0, 700.0)])
    sensor = default_sensor(container.target)
    runner = PicturedProgram(container, sensor, selected("none"), threads=1)
    (frame,) = runner.film([Light.of_clip(light)], 0, 1)
    assert container.buckets_read == ("b",)
    assert np.all(frame.exposure_e == 700.0)
    assert np.all(frame.told["image_d"] == 600.0)


def test_containers_and_assembly_text_are_the_same_program() -> None:
    container = container_of(HEAD + CROSS + "image i = k(exposure) plane a = i > 3% read i, a")
    data = to_bytes(container)
    assert to_bytes(from_bytes(data, "p.icw")) == data
    assert disassemble(from_bytes(data, "p.icw")) == disassemble(container)
    again = assemble(Source("p.asm", disassemble(container)), Path())
    assert to_bytes(again) == data


def test_a_damaged_picture_is_refused() -> None:
    container = container_of(HEAD + CROSS + "image i = k(exposure) read i")
    pictures = container.pictures
    for wrong in (
        replace(pictures, reads=("nothing",)),
        replace(pictures, weights=()),
        replace(pictures, registers={"i": "R99"}),
        replace(pictures, limits_e={}),
    ):
        with pytest.raises(ValueError, match=r"unsound|is allowed"):
            to_bytes(replace(container, pictures=wrong))
    with pytest.raises(ValueError, match=r"`pictures\.outside` is 2, but 0 to 1 is allowed"):
        to_bytes(replace(container, pictures=replace(pictures, outside=2)))


def test_python_has_images_planes_and_reports(tmp_path: Path) -> None:
    text = (
        HEAD + "outside 0 plane p = exposure > 50% image i = exposure / 2 read i, p "
        "report events p at most 5 report any p"
    )
    program = nscc.compile(text, level=0)
    light = np.zeros((1, 256, 256), np.float32)
    light[0, 3, 4] = 20000.0
    captured = nscc_runtime.capture(program, light)
    assert captured.images["i"][3, 4] == 10000.0
    assert captured.planes["p"].sum() == 1
    assert captured.reports["events p"].tolist() == [[4, 3]]
    assert captured.reports["any p"] is True
    assert captured.margin is not None
    repeated = nscc_runtime.capture(program, light, repeat=2)
    assert repeated.images["i"].shape == (2, 256, 256)
    assert [each.tolist() for each in repeated.reports["events p"]] == [[[4, 3]]] * 2
    path = captured.save(tmp_path / "frame.npz")
    with np.load(path) as arrays:
        assert arrays["plane_p"].sum() == 1
    assert "of no bucket" in repr(captured)
    with pytest.raises(Rejected, match="NS0542"):
        captured.light_e_per_s()


def test_a_frame_with_images_says_which_pixels_ran_through_their_words() -> None:
    """With effects, sums expose all pixels but the 256 that 40,000 e bring near saturation. Without
    effects, and in the reference, every pixel is exposed slot by slot."""
    program = nscc.compile(HEAD + "image i = exposure / 2 read i", level=0)
    dim = np.full((1, 256, 256), 900, np.float32)
    bright = dim.copy()
    bright[:, 0] = 40_000
    every = ["every pixel is exposed slot by slot"]

    def reasons(light: NDArray[np.float32], **settings: str) -> tuple[bool, list[str]]:
        plan = nscc_runtime.capture(program, light, **settings).meta["plan"]
        return plan["slot_loop"], plan["slot_loop_reasons"]

    assert reasons(dim, effects="all") == (False, [])
    assert reasons(bright, effects="all") == (True, ["256 pixels may saturate"])
    assert reasons(bright) == (True, every)
    assert reasons(dim, effects="shot", fidelity="reference") == (True, every)


def test_plans_of_programs_with_images_are_refused() -> None:
    """The error NS0750 of a program with images claims neither words slot by slot nor exactness."""
    program = nscc.compile(HEAD + "image i = exposure / 2 read i", level=0)
    with pytest.raises(Rejected) as refused:
        nscc_runtime.plan(program, np.zeros((1, 256, 256), np.float32))
    (error,) = refused.value.diagnostics
    assert error.code == "NS0750"
    reason = "images and planes depend on the neighbours of every pixel"
    assert error.notes == (f"{reason}, so all selected effects are simulated",)
