"""Counts of bits, states that step on planes, and the largest of neighbours."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.ndimage import maximum_filter

import nscc
import nscc_runtime
from nscc.chips.load import builtin_target
from nscc.codec import InvalidRecord, from_plain, to_plain
from nscc.diagnostics.diagnostic import Rejected
from nscc.editing.complete import complete
from nscc.editing.document import Document
from nscc.editing.hover import hover
from nscc.neighbours.picture_report import picture_report
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.syntax.format import format_source
from nscc.words.assembly import assemble
from nscc.words.container import Container
from nscc.words.counts import CountRange
from nscc.words.disassembly import disassemble
from nscc.words.file import to_bytes
from nscc.words.pictures import Condition, Exceeds
from nscc.words.pictures import Source as ImageSource
from nscc_runtime.effects import selected
from nscc_runtime.frame_file import image_unit
from nscc_runtime.light import Light
from nscc_runtime.neighbours.pictured_program import PicturedProgram
from nscc_runtime.sensor import default_sensor

SIDE = 20
CELL = """nsl 3                        # a binary recurrent cell
frame 1 slots of 33ms
open when true
outside 0
kernel wf from "cell.npz"
kernel uf from "cell.npz"
kernel wo from "cell.npz"
kernel uo from "cell.npz"
state h : bit = 1 kept
plane x = exposure > 50%
image f = agree(x, wf) + agree(h, uf)
image o = agree(x, wo) + agree(h, uo)
next h = not (h xor f > 0)
read h, o
"""
HEAD = "nsl 3 frame 1 slots of 1ms open when true outside 0 "
AROUND = "kernel k = [[1, 1, 1], [1, 0, 1], [1, 1, 1]] "


def small(text: str, side: int = SIDE, folder: Path = Path()) -> Container:
    target = replace(builtin_target("scamp5"), rows=side, cols=side)
    made = run_passes(
        Source("p.nsl", text), folder, Options(level=0, target=target, cache=False)
    ).container
    assert made is not None
    return made


@pytest.fixture(scope="module")
def cell(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The cell of four 5 x 5 kernels, with its weights."""
    folder = tmp_path_factory.mktemp("cell")
    rng = np.random.default_rng(45)
    np.savez(
        folder / "cell.npz", **{k: rng.choice([-1, 1], (5, 5)) for k in ("wf", "uf", "wo", "uo")}
    )
    (folder / "cell.nsl").write_text(CELL)
    return folder / "cell.nsl"


def test_a_cell_of_four_kernels_takes_few_words(cell: Path) -> None:
    container = small(CELL, folder=cell.parent)
    report = picture_report(container)
    # A recorded number of words: it must not grow.
    assert report["images_words_total"] <= 340
    assert container.words_stored <= container.target.store_words
    assert report["images"]["f"]["peak_count"] == 50
    unit_e = report["images"]["o"]["electrons_per_count"]
    assert 50 * unit_e <= container.target.register_max_e < 75 * unit_e
    assert report["states"]["h"] == {"words": report["states"]["h"]["words"], "reach": 2}


def test_images_that_are_counted_together_share_words(cell: Path) -> None:
    """The second image costs nothing but its sum."""
    report = picture_report(small(CELL, folder=cell.parent))
    alone = CELL.replace("image o = agree(x, wo) + agree(h, uo)\n", "").replace("h, o", "h, f")
    alone_words = picture_report(small(alone, folder=cell.parent))["images"]["f"]["words"]
    assert report["images"]["o"]["words"] <= 4
    assert report["images"]["f"]["words"] <= alone_words + 10


def test_four_images_are_counted_in_two_walks() -> None:
    """Eight accumulators do not fit; two for each pair of images do."""
    rng = np.random.default_rng(4)
    lines = ["nsl 3 frame 1 slots of 1ms open when true outside 0 state h : bit = 0 kept"]
    for name in "abcd":
        for plane in "xh":
            lines.append(f"kernel {name}{plane} = {rng.choice([-1, 1], (3, 3)).tolist()}")
    lines.append("plane x = exposure > 50%")
    lines += [f"image {name} = agree(x, {name}x) + agree(h, {name}h)" for name in "abcd"]
    lines += [f"plane p{name} = {name} > 2" for name in "abcd"]
    report = picture_report(small("\n".join(lines) + " next h = pa read pb, pc, pd"))
    words = [report["images"][name]["words"] for name in "abcd"]
    assert max(words[0], words[2]) <= 130
    assert max(words[1], words[3]) <= 4


def test_the_error_of_counts_is_what_the_report_says(cell: Path) -> None:
    container = small(CELL, side=64, folder=cell.parent)
    sensor = default_sensor(container.target).changed(
        analog_pattern_lsb=0.0, analog_gain=1.0, analog_noise_lsb=0.4, analog_move_noise=1.0
    )
    runner = PicturedProgram(container, sensor, selected("analog"), threads=1)
    bright = np.random.default_rng(2).random((1, 64, 64)) < 0.5
    (frame,) = runner.film([Light.of_clip(bright * np.float32(30000))], 3, 1)
    exact = film_of(container, [bright * np.float32(30000)])[0]["image_o"]
    word_e = sensor.analog_noise_lsb * sensor.analog_lsb_e
    noise_gain = picture_report(container)["images"]["o"]["noise_gain"]
    error_e = (frame.told["image_o"] - exact).std()
    # The standard deviation of 4096 pixels with related errors is uncertain by a few percent.
    assert error_e == pytest.approx(noise_gain * word_e, rel=0.06)


def test_python_films_keep_the_state(cell: Path, tmp_path: Path) -> None:
    program = nscc.compile(cell, level=0)
    rng = np.random.default_rng(1)
    lights = rng.integers(0, 30000, (4, 1, 256, 256)).astype(np.float32)
    film = nscc_runtime.film(program, list(lights))
    assert film.planes["h"].shape == film.images["o"].shape == (4, 256, 256)
    unit_e = film.meta["image_unit"]["o"]
    counts = film.images["o"] / unit_e
    np.testing.assert_allclose(counts, np.rint(counts), atol=1e-9)
    same = nscc_runtime.capture(program, lights[0], repeat=4)
    again = nscc_runtime.film(program, [lights[0]] * 4)
    assert np.array_equal(same.planes["h"], again.planes["h"])
    assert not np.array_equal(same.planes["h"][0], same.planes["h"][1])
    noisy = [nscc_runtime.film(program, list(lights), effects="all", seed=3) for _ in range(2)]
    assert np.array_equal(noisy[0].images["o"], noisy[1].images["o"])
    assert not np.array_equal(noisy[0].planes["h"], film.planes["h"])
    with np.load(film.save(tmp_path / "film.npz")) as arrays:
        assert arrays["plane_h"].shape == (4, 256, 256)


def test_a_film_needs_images_and_light(cell: Path) -> None:
    """A program without images, and a film of no light, give NS0789."""
    plain = nscc.compile("nsl 3 frame 1 slots of 1ms open when true", level=0)
    with pytest.raises(Rejected, match="NS0789"):
        nscc_runtime.film(plain, [np.zeros((1, 256, 256))])
    with pytest.raises(Rejected, match="NS0789"):
        nscc_runtime.film(nscc.compile(cell, level=0), [])


@pytest.mark.parametrize("kernel", ["[[1, 1, 1], [1, 0, 1], [1, 1, 1]]", "[[0, 1, 1, 0, -2]]"])
def test_the_largest_of_neighbours_equals_the_maximum_filter_of_scipy(kernel: str) -> None:
    text = (
        f"nsl 3 frame 1 slots of 1ms open when true kernel k = {kernel} "
        "image i = -exposure / 2 image up = max(exposure, k) image down = -max(i, k) "
        "read up, down"
    )
    light = np.random.default_rng(3).integers(0, 30000, (1, SIDE, SIDE)).astype(np.float32)
    mask = np.array(json.loads(kernel)) != 0
    told = frame_of(small(text), light)
    inside = ~told["margin"]
    assert inside[2:-2, 2:-2].all()
    largest = maximum_filter(light[0], footprint=mask)
    least = -maximum_filter(-light[0], footprint=mask)
    np.testing.assert_allclose(told["image_up"][inside], largest[inside], atol=1e-6)
    np.testing.assert_allclose(told["image_down"][inside], least[inside] / 2, atol=1e-6)


def test_the_largest_count_of_neighbours_equals_a_maximum_filter() -> None:
    text = (
        HEAD
        + AROUND
        + ("plane p = exposure > 50% image c = agree(p, k) image top = max(c, k) read c, top")
    )
    light = np.random.default_rng(3).integers(0, 30000, (1, SIDE, SIDE)).astype(np.float32)
    container = small(text)
    told = frame_of(container, light)
    inside = ~told["margin"]
    around = np.ones((3, 3), np.bool_)
    around[1, 1] = False
    top = maximum_filter(told["image_c"], footprint=around)
    np.testing.assert_allclose(told["image_top"][inside], top[inside], atol=1e-6)


def test_sums_of_counts_that_cancel_or_come_from_one_weight_are_exact() -> None:
    """Some sums of agreements are 0 everywhere; others add up single weights."""
    text = HEAD + (
        "kernel a = [[1, -1, 0]] kernel b = [[-1, 1, 0]] kernel c = [[1]] plane p = exposure > 50% "
        "image none = agree(p, a) + agree(p, b) image three = 2 * agree(p, c) + agree(not p, c) "
        "image rest = agree(p, a) + agree(p, b) + agree(p, c) "
        "plane q = p and three > 0 read none, three, rest, q"
    )
    light = np.random.default_rng(5).integers(0, 30000, (1, SIDE, SIDE)).astype(np.float32)
    bits = light[0] > 64 * 30000 / 127
    container = small(text)
    assert all(abs(launch.level or 0) <= 126 for launch in container.pictures.launches)
    told, unit_e = frame_of(container, light), container.pictures.count_steps * 30000 / 127
    assert np.array_equal(told["plane_q"], bits)
    for name, ones in (("none", 0), ("three", 1), ("rest", 1)):
        expected = np.where(bits, ones, -ones)
        np.testing.assert_allclose(told[f"image_{name}"] / unit_e, expected, atol=1e-9)


def test_margins_of_states_grow_with_the_frames() -> None:
    """Values from beyond the array stay unknown in a state, and spread to its neighbours."""
    text = (
        "nsl 3 frame 1 slots of 1ms open when true outside 0 "
        + AROUND
        + "state h : bit = 0 kept image i = k(exposure) / 8 next h = any(h, k) or i > 10% read h"
    )
    light = np.full((1, SIDE, SIDE), 9000.0, np.float32)
    margins = [told["margin"] for told in film_of(small(text), [light] * 3)]
    widths = [int(margin[SIDE // 2].sum()) // 2 for margin in margins]
    assert widths == [1, 2, 3]


def test_bits_fade_where_registers_keep_them_for_less_than_a_frame() -> None:
    text = "nsl 3 frame 1 slots of 30ms open when true state h : bit = 1 kept plane p = h read p"
    container = small(text)
    light = Light.of_clip(np.zeros((1, SIDE, SIDE), np.float32))
    for retention_us, bits in ((20_000.0, [True, False]), (40_000.0, [True, True])):
        sensor = default_sensor(container.target).changed(digital_retention_us=retention_us)
        runner = PicturedProgram(container, sensor, selected("decay"), threads=1)
        frames = list(runner.film([light] * 2, 0, 1))
        assert [bool(frame.told["plane_p"].all()) for frame in frames] == bits


def test_a_state_without_next_is_refreshed() -> None:
    """The state keeps its start of 1 in both frames. The container, disassembled and assembled, has
    the same bytes."""
    container = small(HEAD + "state h : bit = 1 kept plane p = not h read p, h")
    text = disassemble(container)
    again = assemble(Source("p.asm", text), Path())
    assert to_bytes(again) == to_bytes(container)
    frames = film_of(container, [np.zeros((1, SIDE, SIDE), np.float32)] * 2)
    assert all(told["plane_h"].all() and not told["plane_p"].any() for told in frames)


def test_a_state_whose_condition_is_false_keeps_its_value() -> None:
    """The statement `next seen = true when bright` has a condition, and `next odd = not odd` has
    none."""
    text = HEAD + (
        "state seen : bit = 0 kept state odd : bit = 0 kept plane bright = exposure > 50% "
        "next seen = true when bright next odd = not odd read seen, odd"
    )
    lights = [np.full((1, SIDE, SIDE), e, np.float32) for e in (0.0, 20000.0, 0.0)]
    frames = film_of(small(text), lights)
    assert [bool(told["plane_seen"].all()) for told in frames] == [False, True, True]
    assert [bool(told["plane_odd"].all()) for told in frames] == [True, False, True]


def test_registers_of_an_exposure_are_not_those_of_states() -> None:
    """The words of coded shutters write registers; a state lies in another one."""
    text = (
        "nsl 3 frame 8 slots of 1ms code stop : 1..8 open when n < stop "
        "state h : bit = 0 kept plane p = exposure > 20% next h = p or h read h "
        "pixels stop = 1 + (x + y) % 8"
    )
    assert picture_report(small(text))["states"]["h"]["words"] > 0


@pytest.mark.parametrize(
    ("level", "or_equal", "half_way"),
    [
        (0, False, 0),
        (0, True, 0),
        (1, False, 2),
        (1, True, 0),
        (-3, False, -2),
        (2, False, 2),
        (3, True, 2),
        (3, False, None),
        (-3, True, None),
        (-9, False, None),
        (9, True, None),
    ],
)
def test_levels_lie_half_way_between_attainable_counts(
    level: int, or_equal: bool, half_way: int | None
) -> None:
    """The counts are -3, -1, 1 and 3."""
    counts = CountRange(Fraction(-3), Fraction(3), Fraction(2))
    assert counts.half_way(Fraction(level), or_equal=or_equal) == half_way


def test_editors_complete_and_explain_states_of_planes(cell: Path) -> None:
    document = Document("cell.nsl", CELL, cell.parent)
    found = hover(document, CELL.index("h xor"))
    assert found is not None
    assert "a kept plane" in found.text
    found = hover(document, CELL.index("o = agree"))
    assert found is not None
    assert "counts to 50" in found.text
    names = {offer.text for offer in complete(document, CELL.index("h xor"))[1]}
    assert {"wf", "x", "f", "h"} <= names
    assert format_source(Source("cell.nsl", CELL)).startswith("nsl 3")


@pytest.mark.parametrize(
    ("image", "times"),
    [
        ("agree(p, k) - agree(p, k)", 0),
        ("0 * agree(p, k)", 0),
        ("k(a - a)", 0),
        ("abs(a - a)", 0),
        ("agree(p, k) - a + a", 1),
        ("(a - a) if p else a", 0.5),
    ],
)
def test_counts_that_cancel_are_counts(image: str, times: float) -> None:
    """Counts that cancel keep the unit of counts, and their value is 0."""
    text = HEAD + AROUND + f"plane p = exposure > 50% image a = agree(p, k) image o = {image} "
    made = small(text + "read o, a")
    assert image_unit(made).keys() == {"o", "a"}
    light = np.random.default_rng(3).choice([0.0, 20_000.0], (1, SIDE, SIDE)).astype(np.float32)
    frame = frame_of(made, light)
    share = np.where(light[0] > 15_000, 0, 1) if times == 0.5 else times
    np.testing.assert_allclose(frame["image_o"], share * frame["image_a"], atol=1e-6)


def test_nodes_of_counts_survive_a_file() -> None:
    """A condition on a count becomes lists and comes back equal. A bit in place of a source is
    refused."""
    node = Exceeds(ImageSource("f"), Fraction(3, 2))
    plain = to_plain(node, Condition)
    assert plain == ["Exceeds", ["Source", "f"], 3, 2]
    assert from_plain(Condition, plain) == node
    with pytest.raises(InvalidRecord, match="begins with 'Bit', not with the name of a"):
        from_plain(Condition, ["Exceeds", ["Bit", "p"], 1, 2])


def frame_of(container: Container, light: np.ndarray) -> dict[str, Any]:
    (told,) = film_of(container, [light])
    return told


def film_of(container: Container, lights: list[np.ndarray]) -> list[dict[str, Any]]:
    runner = PicturedProgram(
        container, default_sensor(container.target), selected("none"), threads=1
    )
    return [dict(frame.told) for frame in runner.film(map(Light.of_clip, lights), 0, 1)]
