"""The statements of version 3: what they mean, what is refused, and what stays a name before it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nscc
from nscc.chips.load import builtin_target
from nscc.chips.target import Target
from nscc.codec import InvalidRecord, from_plain, to_plain
from nscc.diagnostics.diagnostic import Rejected
from nscc.pipeline import Options, run_passes
from nscc.program.program import Program
from nscc.source import Source
from nscc.syntax.format import format_source
from nscc.syntax.parse import parse
from nscc.words.counts import count_unit
from nscc.words.pictures import Above, At, Bit, Inverse, Joined, Node

HEAD = "nsl 3 frame 4 slots of 1ms "
ONE = HEAD + "open when true "
TWO = HEAD + "bucket a open when n < 2 bucket b open when n > 1 "
KEPT = ONE + "plane p = exposure > 6% "
COUNT = KEPT + ("outside 0 kernel k = [[0, 1, 0], [1, -1, 1], [0, 1, 0]] image c = agree(p, k) ")
KERNEL = "kernel k = [[0, 1, 0], [1, 1, 1], [0, 1, 0]] / 8 "


def program(text: str) -> Program:
    return run_passes(Source("p.nsl", text), Path(), Options(level=0, cache=False)).program


def refused(text: str) -> list[str]:
    with pytest.raises(Rejected) as caught:
        program(text)
    return [diagnostic.code for diagnostic in caught.value.diagnostics]


@pytest.mark.parametrize("version", [1, 2])
def test_words_of_version_3_are_names_before_it(version: int) -> None:
    """`kernel`, `image` and others are free names in versions 1 and 2."""
    names = ("kernel", "image", "plane", "outside", "report", "assume")
    lets = " ".join(f"let {name} = {number}" for number, name in enumerate(names))
    text = f"nsl {version} frame 4 slots of 1ms {lets} open when n < {' + '.join(names)}"
    assert parse(Source("p.nsl", text))[1] == ()


@pytest.mark.parametrize("version", [1, 2])
@pytest.mark.parametrize(
    "statement",
    ["image i = exposure", "plane p = x > 6%", "outside 0", "report any p", "kernel k = [[1]]"],
)
def test_statements_of_version_3_are_refused_before_it(version: int, statement: str) -> None:
    """Each statement of version 3 gives NS0109 in a text of version 1 or 2."""
    text = f"nsl {version} frame 4 slots of 1ms open when true\n{statement}"
    found = [diagnostic.code for diagnostic in parse(Source("p.nsl", text))[1]]
    assert found[:1] == ["NS0109"]


@pytest.mark.parametrize(
    ("text", "codes"),
    [
        (ONE + "kernel k = [[1, 2]] image i = k(exposure) read i", ["NS0530"]),
        (ONE + "kernel k = [[1], [1, 2], [1]] image i = exposure / 2 read i", ["NS0530"]),
        (ONE + "kernel k = [[0]] image i = exposure / 2 read i", ["NS0530"]),
        (ONE + f"kernel k = {[[1] * 11]} image i = exposure / 2 read i", ["NS0530"]),
        (ONE + "kernel k = [[1]] / 3 image i = exposure / 2 read i", ["NS0532"]),
        (ONE + "image i = exposure / 6 read i", ["NS0532"]),
        (ONE + "image i = exposure / 0 read i", ["NS0532"]),
        (ONE + "image i = exposure * exposure read i", ["NS0531"]),
        (ONE + "image i = exposure + 3 read i", ["NS0531"]),
        (ONE + "image i = exposure * (6%) read i", ["NS0531"]),
        (ONE + "image i = later image later = exposure / 2 read i", ["NS0531"]),
        (ONE + "plane p = exposure > 6% image i = p read i", ["NS0531"]),
        (ONE + "image i = exposure / 2 plane p = i read p", ["NS0531"]),
        (ONE + KERNEL + "image i = any(exposure > 6%, k) read i", ["NS0531"]),
        (ONE + KERNEL + "plane p = k(exposure) read p", ["NS0531"]),
        (ONE + "image i = abs(exposure, exposure) read i", ["NS0531"]),
        (ONE + "image i = blur(exposure) read i", ["NS0214"]),
        (TWO + "image i = exposure read i", ["NS0323"]),
        (ONE + "plane p = exposure == 6% read p", ["NS0533"]),
        (ONE + "plane p = exposure > 6 read p", ["NS0533"]),
        (ONE + "plane p = exposure > 130% read p", ["NS0533"]),
        (ONE + "plane p = 3% > 6% read p", ["NS0533"]),
        (ONE + "image i = exposure plane p = i > exposure read p", ["NS0533"]),
        (ONE + "image i = exposure - exposure plane p = 0 > i read p", ["NS0533"]),
        (ONE + KERNEL + "plane p = any(exposure > 6%, k) read p", ["NS0534"]),
        (ONE + "plane p = exposure > 6% plane q = p[1, 0] read q", ["NS0534"]),
        (ONE + "outside 2 image i = exposure / 2 read i", ["NS0534"]),
        (ONE + "image i = exposure / 2", ["NS0536"]),
        (ONE + "plane p = exposure > 6% report events p", ["NS0536"]),
        (ONE + "plane p = exposure > 6% report any p at most 3", ["NS0536"]),
        (ONE + "plane p = exposure > 6% report events p at most 5000", ["NS0536"]),
        (ONE + "plane p = exposure > 6% report some p", ["NS0536"]),
        (KEPT + "report events p at most 3 report events p at most 5", ["NS0536"]),
        (ONE + "image i = exposure / 2 report any i", ["NS0536"]),
        (ONE + "image i = exposure / 2 read j", ["NS0214"]),
        (ONE + "assume exposure < 6% image i = exposure / 2 read i", ["NS0537"]),
        (ONE + "assume exposure <= 120% image i = exposure / 2 read i", ["NS0537"]),
        (ONE + KERNEL + "image i = min(exposure, k) read i", ["NS0531"]),
        (ONE + KERNEL + "image i = max(exposure) read i", ["NS0531"]),
        (ONE + KERNEL + "plane p = exposure > 6% image i = agree(p, k) read i", ["NS0534"]),
        (COUNT + "image i = exposure + c read i", ["NS0531"]),
        (COUNT + "image i = exposure if p else c read i", ["NS0531"]),
        (COUNT + "plane q = exposure > c read q", ["NS0531"]),
        (COUNT + "plane q = c > 6% read q", ["NS0533"]),
        (COUNT + "plane q = c > 5 read q", ["NS0533"]),
        (COUNT + "plane q = c >= -5 read q", ["NS0533"]),
        (COUNT + "plane q = c == 1 read q", ["NS0533"]),
        (COUNT + "image i = c * 26 read i", ["NS0540"]),
        (COUNT + "image i = agree(c, k) read i", ["NS0531"]),
        (KEPT + "state h : 0..3 = 0 next h = 1 if p else h read h", ["NS0543"]),
        (KEPT + "state h : 0..3 = 0 kept next h = p read h", ["NS0301"]),
        (KEPT + "state h : 0..3 = 0 kept next h = h + 1 when p read h", ["NS0311"]),
        (KEPT + "state h : 0..3 = 4 kept read h", ["NS0311"]),
        (KEPT + "state h : 3..0 = 0 kept plane q = h > 1 next h = 1 read h", ["NS0306"]),
        (KEPT + "state h : 0..3 = 0 kept plane q = p and h read q", ["NS0531"]),
        (KEPT + "state h : 0..3 = 0 kept next h = 1 if exposure > 0 else 0 read h", ["NS0208"]),
        (KEPT + "state h : 0..3 = 0 kept next h = 1 / (h - 1) read h", ["NS0302"]),
        (KEPT + "state h : 0..99999 = 0 kept next h = min(h + 1, 9) read h", ["NS0450"]),
        (KEPT + "state h : bit = 0 next h = p read h", ["NS0543"]),
        (KEPT + "state h : bit = 2 kept next h = p read h", ["NS0311"]),
        (KEPT + "state h : bit = 0 kept next h = exposure read h", ["NS0531"]),
        (KEPT + "state h : bit = 0 kept next h = p next g = p read h", ["NS0214"]),
        (KEPT + "state h : bit = 0 kept next h = exposure > 3 read h", ["NS0533"]),
        (KEPT.replace("1ms", "400ms") + "state h : bit = 0 kept next h = p read h", ["NS0602"]),
        (ONE + "image i = exposure * 2 read i", ["NS0540"]),
        (ONE + "outside 0 plane p = exposure > 6% plane q = p[0, 65] read q", ["NS0541"]),
        (ONE + "outside 0 plane p = exposure > 6% plane q = p[65, 0] read q", ["NS0541"]),
        (ONE + "outside 0 plane p = exposure > 6% plane q = p[far, 0] read q", ["NS0214"]),
        (ONE + "outside 0 plane p = exposure > 6% plane q = p[0, far] read q", ["NS0214"]),
        (ONE + "image i = exposure / 2 image i = exposure read i", ["NS0201"]),
        (TWO + "image a = b / 2 read a", ["NS0201"]),
        (ONE + "outside 0 outside 1 image i = exposure / 2 read i", ["NS0205"]),
    ],
)
def test_invalid_statements_of_version_3_are_refused(text: str, codes: list[str]) -> None:
    assert refused(text) == codes


def test_images_beside_senses_are_refused() -> None:
    """A program that looks at the light while exposing has no images: NS0539."""
    text = (
        ONE.replace("open when true", "open when not full")
        + "sense full when light > 45% at n in [2] image i = exposure / 2 read i"
    )
    assert refused(text) == ["NS0539"]


def test_a_chip_that_sees_no_neighbours_is_refused() -> None:
    """The chip `dual-tap` has no words that read a neighbour: NS0538."""
    text = (
        "nsl 3 target dual-tap frame 4 slots of 20ms bucket a open when n < 2 "
        "bucket b open when n > 1 image i = a - b read i"
    )
    assert refused(text) == ["NS0538"]


def test_a_chip_whose_exposures_are_in_news_is_refused() -> None:
    """Words that read a neighbour overwrite NEWS, so no exposure can be there."""
    chip = replace(builtin_target("scamp5"), analog_scratch="F")
    with pytest.raises(Rejected) as caught:
        nscc.compile(ONE + KERNEL + "image i = k(exposure) read i", target=chip)
    assert [diagnostic.code for diagnostic in caught.value.diagnostics] == ["NS0538"]


@pytest.mark.parametrize(
    "condition",
    [
        "5% < exposure",
        "3% < exposure < 5%",
        "(5%) < exposure",
        "exposure > (5%)",
        "-5% < exposure",
        "900e < exposure and 3lsb < exposure",
        "h xor 5% >= exposure",
    ],
)
def test_levels_in_next_are_those_in_a_plane(condition: str) -> None:
    """A comparison with a level, in any spelling, has the same syntax tree in `next` of a state as
    in a plane."""
    kept = "state h : bit = 0 kept "
    plane = program(ONE + kept + f"plane p = {condition} read p, h").pictures.items[0].node
    (state,) = program(ONE + kept + f"next h = {condition} read h").pictures.states
    assert state.next == plane


def test_a_remainder_in_next_stays_one() -> None:
    text = (
        "nsl 3 frame 4 slots of 1ms sense full when exposure > 30% at n in [2, 4] "
        "state s : 0..4 = 0 next s = {} when full open when n < 2 read s"
    )
    expected = program(text.format("2")).machine.values.tolist()
    for remainder in ("5% 3", "5 %3", "(5% 3)", "7 -(5% 10)"):
        assert program(text.format(remainder)).machine.values.tolist() == expected


def test_changes_of_a_program_are_tried_for_a_limited_number_of_steps(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The limit of steps is set to 0, so no changed program is tried and the help gives only
    general advice."""
    kernel = "kernel s = [[1, 0, -1], [2, 0, -2], [1, 0, -1]] image i = s(exposure) read i"
    monkeypatch.setattr("nscc.neighbours.passes._STEPS_OF_CHANGES", 0)
    with pytest.raises(Rejected) as caught:
        program(ONE + kernel)
    (found,) = caught.value.diagnostics
    assert found.helps == ("use smaller factors, or fewer and smaller convolution kernels",)


def test_a_divisor_beyond_2_to_the_40_needs_too_many_halvings() -> None:
    """Dividing by 2^40 compiles. By 2^41 it gives NS0535, whose help names the limit."""
    options = Options(level=1, cache=False)
    source = Source("p.nsl", ONE + f"image i = exposure / {2**41} read i")
    with pytest.raises(Rejected) as caught:
        run_passes(source, Path(), options)
    [diagnostic] = caught.value.diagnostics
    assert diagnostic.code == "NS0535"
    assert diagnostic.data["resource"] == "halvings"
    assert diagnostic.helps == ("divide by at most 2^40 in all",)
    run_passes(Source("p.nsl", ONE + f"image i = exposure / {2**40} read i"), Path(), options)


def test_planes_that_do_not_fit_name_how_many_fit() -> None:
    def reading(count: int) -> str:
        planes = "".join(f"plane v{i} = exposure > {5 * i + 5}% " for i in range(count))
        return ONE + planes + "read " + ", ".join(f"v{i}" for i in range(count))

    with pytest.raises(Rejected) as caught:
        program(reading(14))
    (found,) = caught.value.diagnostics
    assert found.code == "NS0535"
    first = "the first 11 of 14 images and planes"
    assert found.helps == (f"compute and read out only {first}: this compiles",)
    program(reading(11))
    with pytest.raises(Rejected):
        program(reading(12))


def test_kernels_that_do_not_fit_name_the_largest_that_do() -> None:
    def text(side: int) -> str:
        names, ring = "abcdefg", range(-(side // 2), side // 2 + 1)
        kernels = ""
        for k, name in enumerate(names):
            rows = [[(7 * i * i + 5 * j + 3 * i * j + k) % 19 - 9 for j in ring] for i in ring]
            kernels += f"kernel {name} = {rows} / 4096 "
        total = " + ".join(f"abs({name}(exposure))" for name in names)
        return ONE + f"{kernels}image v = ({total}) / 8 read v"

    with pytest.raises(Rejected) as caught:
        program(text(9))
    (found,) = caught.value.diagnostics
    assert found.code == "NS0535"
    assert found.data["resource"] == "words in the store"
    assert found.helps == ("use the middle 5 x 5 weights of larger kernels: this compiles",)
    program(text(5))
    with pytest.raises(Rejected):
        program(text(7))


def test_suggestions_for_too_large_values_compile() -> None:
    """NS0540 offers a divisor and a smaller exposure. Both changes compile."""
    kernel = "kernel s = [[1, 0, -1], [2, 0, -2], [1, 0, -1]] image i = s(exposure) read i"
    with pytest.raises(Rejected) as caught:
        program(ONE + kernel)
    (found,) = caught.value.diagnostics
    assert found.code == "NS0540"
    assert "by 4" in found.helps[0]
    assert "assume exposure <= 25%" in found.helps[1]
    program(ONE + "assume exposure <= 25% " + kernel)
    program(ONE + kernel.replace("]] image", "]] / 4 image"))


@pytest.mark.parametrize(
    ("changed", "steps_available"),
    [
        ({}, 126),
        ({"in_high": 50}, 50),
        ({"in_low": -40}, 40),
        ({"register_max_e": 7500.0, "in_step_e": 600.0}, 12),
        ({"register_min_e": -6000.0, "in_step_e": 600.0}, 10),
    ],
)
def test_counts_fill_the_registers_and_in(changed: dict[str, Any], steps_available: int) -> None:
    made = program(COUNT + "read c")
    target: Target = replace(made.target, **changed)
    unit = count_unit(made.pictures, target)
    assert unit is not None
    assert unit.steps_available == steps_available
    assert (unit.peak, unit.name) == (5, "c")
    assert unit.steps == steps_available // 5


def test_a_kernel_is_read_from_a_file(tmp_path: Path) -> None:
    np.savez(tmp_path / "k.npz", k=np.array([[0, 1, 0], [1, -4, 1], [0, 1, 0]]))
    text = ONE + 'assume exposure <= 20% kernel k from "k.npz" image i = k(exposure) read i'
    made = run_passes(Source("p.nsl", text), tmp_path, Options(level=0, cache=False)).program
    assert made.pictures.weights[0].rows == ((0, 1, 0), (1, -4, 1), (0, 1, 0))


def test_chained_comparisons_and_shifts_become_nodes() -> None:
    """`a < x < b` is the conjunction of two comparisons. `p[-1, 2]` is p one to the left and two
    down."""
    text = ONE + "outside 0 plane p = -4% < exposure < 40% plane q = p[-1, 2] read q"
    pictures = program(text).pictures
    first, second = (item.node for item in pictures.items)
    assert isinstance(first, Joined)
    assert isinstance(first.first, Above)
    assert isinstance(first.second, Inverse)
    assert isinstance(second, At)
    assert (second.right, second.down) == (-1, 2)


def test_nodes_of_images_are_read_back_as_they_were_written() -> None:
    """Each node becomes plain values and comes back equal. A factor that is no fraction is refused
    with its place."""
    text = (
        TWO + KERNEL + "outside 1 plane p = a > b and not all(b > 2%, k) "
        "image i = abs(k(a) - 3 * b / 4) / 4 if p else -(b / 2) read i"
    )
    pictures = program(text).pictures
    for item in pictures.items:
        assert from_plain(Node, to_plain(item.node, Node)) == item.node
    with pytest.raises(InvalidRecord, match=r"`\[0\]\[0\]` is not a fraction"):
        from_plain(Node, ["Sum", [1, 0, ["Source", "a"]]])


def test_images_and_planes_are_formatted() -> None:
    text = (
        "nsl 3\nkernel  k=[[1,0,-1]]/2\nimage i=abs ( k( exposure ) )-exposure*2/4\n"
        "plane p=i>-4%  and i[ 1,-1 ]\n"
    )
    formatted = format_source(Source("p.nsl", text))
    assert formatted == (
        "nsl 3\nkernel k = [[1, 0, -1]] / 2\nimage i = abs(k(exposure)) - exposure * 2 / 4\n"
        "plane p = i > -4% and i[1, -1]\n"
    )


def test_next_reads_planes_as_images_do() -> None:
    """Levels, functions and neighbours in `next`; a field's bit stays what it is."""
    text = (
        ONE + "outside 0 kernel k = [[1, 0, -1]] state h : bit = 1 kept plane p = exposure > 6% "
        "next h = h[-1, 2] xor any(p, k) and (exposure < 40% or agree(not h, k) > 0) read h"
    )
    pictures = program(text).pictures
    (state,) = pictures.states
    assert (state.name, state.start) == ("h", True)
    assert isinstance(state.next, Joined)
    assert state.next.first == At(Bit("h"), -1, 2)
    looked = (
        "nsl 3 frame 4 slots of 1ms code bits : bit[4] open when n < 4 "
        "sense a when light > 3% at n < 3 state s : bit = 1 "
        "next s = bits[(8 % 3)] and not a read s pixels bits = 5"
    )
    assert program(looked).machine.stages
    source = Source("p.nsl", text)
    assert format_source(Source("p.nsl", format_source(source))) == format_source(source)


def test_a_state_may_follow_the_neighbours_alone() -> None:
    """Without an image or plane statement, too."""
    kernel = "outside 0 kernel k = [[1, 1, 1]]"
    checked = program(f"{ONE} {kernel} state h : bit = 1 kept next h = not any(h, k) read h")
    assert [state.name for state in checked.pictures.states] == ["h"]


@pytest.mark.parametrize("name", ["x", "y", "rows", "cols"])
def test_a_position_beside_a_number_of_a_pixel_needs_a_plane_of_its_own(name: str) -> None:
    text = f"state h : 0..3 = 0 kept next h = 1 if {name} > 3 and h < 2 else 0 read h"
    with pytest.raises(Rejected) as caught:
        nscc.compile(KEPT.replace("nsl 3", "nsl 4") + text)
    found = {each.code: str(each) for each in caught.value.diagnostics}
    assert "plane of its own: `plane p = x > 3`" in found["NS0208"]
