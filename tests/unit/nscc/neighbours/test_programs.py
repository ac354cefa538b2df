"""Programs of one input: what they compute, how short they are, and what their errors add up to."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from network_kernels import ANALOGNET2, MAX_POOLED
from scipy.ndimage import correlate

from nscc.cache.results import Results
from nscc.cache.store import Store
from nscc.chips.load import builtin_target
from nscc.neighbours.addition import additions
from nscc.neighbours.alternatives import with_shared_halvings
from nscc.neighbours.digit_planes import digit_plane_programs
from nscc.neighbours.programs import (
    TURNS,
    UNIT,
    BusWord,
    Program,
    added,
    exact_taps,
    kernel_of,
    noise_gain,
    program_from_text,
    turned,
    turned_taps,
    values_of,
)
from nscc.neighbours.synthesis import Synthesis, reads_news_once
from nscc.neighbours.table import ROWS, WordForms
from nscc.operations import NEIGHBOURS
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words import pictures as p

Array = np.ndarray[tuple[int, ...], np.dtype[np.float64]]
_FETCH = {"XN": (1, 0), "XE": (0, -1), "XS": (-1, 0), "XW": (0, 1)}
"""How an array rolls so that each pixel has what its neighbour had."""


def run_on_array(program: Program, image: Array) -> Array:
    """The program on an array whose ends meet; written anew for this test."""
    held = {"x": image}
    result = image
    for word in program:
        total = np.zeros_like(image)
        for name in word.sources:
            rolled = (
                np.roll(held["NEWS"], _FETCH[name], (0, 1)) if name in NEIGHBOURS else held[name]
            )
            total = total + rolled
        result = -total / len(word.destinations)
        for name in word.destinations:
            if name in NEIGHBOURS:  # NEWS takes the bus of the opposite neighbour
                down, right = _FETCH[name]
                held["NEWS"] = np.roll(result, (-down, -right), (0, 1))
            else:
                held[name] = result
    return held[program[-1].destinations[0]] if program else image


def weights_of(rows: list[list[int]], divisor: int = 1) -> dict[tuple[int, int], Fraction]:
    down, right = len(rows) // 2, len(rows[0]) // 2
    return {
        (j - right, i - down): Fraction(w, divisor)
        for i, row in enumerate(rows)
        for j, w in enumerate(row)
        if w
    }


def outer(column: list[int], row: list[int]) -> list[list[int]]:
    return [[a * b for b in row] for a in column]


GAUSS_5 = [[0, 1, 2, 1, 0], [1, 4, 6, 4, 1], [2, 6, 10, 6, 2], [1, 4, 6, 4, 1], [0, 1, 2, 1, 0]]
LAPLACE_8 = [[-1, -1, -1], [-1, 8, -1], [-1, -1, -1]]
PUBLIC, ALL = WordForms(), WordForms(sources=4, halving=True)
FORMS = (
    PUBLIC,
    ALL,
    WordForms(sources=3),
    WordForms(sources=1),
    WordForms(halving=True),
    WordForms(sources=1, news_keeps=False),
    WordForms(sources=4, halving=True, news_keeps=False),
)
KERNELS = {
    "sobel x": (outer([1, 2, 1], [1, 0, -1]), 1, 7, 7),
    "sobel x / 8": (outer([1, 2, 1], [1, 0, -1]), 8, 7, 6),
    "sobel y / 8": (outer([1, 0, -1], [1, 2, 1]), 8, 7, 6),
    "prewitt x": (outer([1, 1, 1], [1, 0, -1]), 1, 6, 6),
    "laplace 4": ([[0, -1, 0], [-1, 4, -1], [0, -1, 0]], 1, 6, 6),
    "laplace 8": (LAPLACE_8, 1, 12, 10),
    "laplace 8 / 4": (LAPLACE_8, 4, 9, 9),
    "laplace 8 / 8": (LAPLACE_8, 8, 11, 11),
    "gauss 3x3": (outer([1, 2, 1], [1, 2, 1]), 16, 8, 7),
    "box 3x3": (outer([1] * 3, [1] * 3), 1, 7, 7),
    "box 5x5": (outer([1] * 5, [1] * 5), 1, 12, 12),
    "sharpen": ([[0, -1, 0], [-1, 5, -1], [0, -1, 0]], 1, 7, 7),
    "gauss 5x5": (GAUSS_5, 64, 20, 19),
}
"""Kernel, divisor, and the most words that it may take: with public forms, with all forms."""


@pytest.mark.parametrize("forms", [PUBLIC, ALL], ids=["public", "all"])
@pytest.mark.parametrize("name", KERNELS)
def test_a_kernel_takes_few_words(name: str, forms: WordForms) -> None:
    rows, divisor, *most = KERNELS[name]
    taps = exact_taps(weights_of(rows, divisor))
    best = Synthesis(20_000, forms).variants(taps)[0].program
    assert kernel_of(best) == taps
    assert len(best) <= most[forms == ALL]


def is_allowed(word: BusWord, forms: WordForms) -> bool:
    """Whether forms allow a word; written anew for this test."""
    if not any(name.startswith("X") for name in (*word.sources, *word.destinations)):
        return True
    return len(word.sources) <= forms.sources and (forms.halving or len(word.destinations) == 1)


@pytest.mark.parametrize("seed", range(80))
def test_the_programs_of_a_kernel_equal_the_correlation_of_scipy(seed: int) -> None:
    forms = PUBLIC if seed < 40 else FORMS[seed % len(FORMS)]
    rng = np.random.default_rng(seed)
    rows = rng.integers(-4, 5, [(3, 3), (1, 5), (5, 3), (1, 1), (7, 1)][seed % 5])
    rows.flat[0] = rng.integers(1, 4)
    divisor = int(2 ** rng.integers(0, 5))
    image = rng.integers(0, 1000, (12, 14)).astype(float)
    expected = correlate(image, rows / divisor, mode="wrap")
    taps = exact_taps(weights_of(rows.tolist(), divisor))
    found = [ranged.program for ranged in Synthesis(300, forms).variants(taps)]
    for each in (*found, *additions(taps, forms), *digit_plane_programs(taps, forms)):
        assert all(is_allowed(word, forms) for word in each)
        assert forms.news_keeps or reads_news_once(each)
        np.testing.assert_allclose(run_on_array(each, image), expected, atol=1e-9)


def registers_of(program: Program) -> int:
    """Most registers besides NEWS that hold a value that a later word reads, input included."""
    last = {name: number for number, word in enumerate(program) for name in word.sources}
    most, live = 1, {"x"}
    for number, word in enumerate(program):
        live |= {name for name in word.destinations if name[:1] != "X" and name != "NEWS"}
        most = max(most, len(live))
        live = {name for name in live if last.get(name, -1) > number}
    return most


@pytest.mark.parametrize(("size", "most"), [(4, 80), (5, 110), (7, 195), (9, 290), (15, 820)])
def test_dense_kernels_of_any_size_take_few_words_and_registers(size: int, most: int) -> None:
    for seed in range(3):
        rows = np.random.default_rng(seed).integers(-9, 10, (size, size))
        divisor = 1 << int(np.abs(rows).sum() - 1).bit_length()
        taps = exact_taps(weights_of(rows.tolist(), divisor))
        programs = digit_plane_programs(taps, PUBLIC)
        assert all(kernel_of(program) == taps for program in programs)
        assert len(programs[0]) <= most
        assert [registers_of(program) for program in programs[:2]] == [5, 4]
        for values in values_of(programs[0]):
            assert sum(abs(weight) for weight in values.values()) <= 2 * UNIT
            assert (
                max(abs(sum(w for w in values.values() if w * sign > 0)) for sign in (1, -1))
                <= UNIT
            )


def test_three_dense_kernels_of_one_exposure_fit() -> None:
    rng = np.random.default_rng(3)
    kernels = [rng.integers(-9, 10, (5, 5)).tolist() for _ in range(3)]
    # A recorded number of words: it must not grow.
    assert words_of(kernels, 256) <= 310


@pytest.mark.parametrize(("size", "most"), [(5, 45), (7, 75), (9, 100)])
def test_products_of_a_row_and_a_column_take_few_words_with_few_registers(
    size: int, most: int
) -> None:
    """A program with five registers applies the column after the row, so words grow with the side.

    The bounds are recorded numbers of words: they must not grow."""
    for seed in range(3):
        column, row = np.random.default_rng(seed).integers(1, 10, (2, size)).tolist()
        rows = outer(column, row)
        divisor = 1 << (sum(map(sum, rows)) - 1).bit_length()
        programs = Synthesis(400, PUBLIC).variants(exact_taps(weights_of(rows, divisor)))
        words = [len(ranged.program) for ranged in programs if registers_of(ranged.program) <= 5]
        assert min(words) <= most


def chain_read_twice(kind: str, count: int) -> str:
    """A program with `count` planes or images that two others read, one of them in reverse."""
    if kind == "planes":
        items = [f"plane v{i} = exposure > {90 * i // count + 5}%" for i in range(count)]
        items += [f"plane t = {' xor '.join(f'v{i}' for i in range(count))}"]
        items += [f"plane u = {' and '.join(f'v{i}' for i in reversed(range(count)))}"]
    else:
        items = [
            f"kernel k{i} = [[{i % 7 + 1}, 0, -1]] / 8 image v{i} = abs(k{i}(exposure))"
            for i in range(count)
        ]
        terms = [f"v{i} / {1 << (count - 1).bit_length()}" for i in range(count)]
        items += [f"image t = {' + '.join(terms)} image u = {' + '.join(reversed(terms))}"]
    return f"nsl 3 frame 1 slots of 1ms open when true {' '.join(items)} read t, u"


@pytest.mark.parametrize("kind", ["planes", "images"])
def test_images_and_planes_that_others_read_twice_need_registers_of_a_few(kind: str) -> None:
    """Words grow with the number of images and planes, and all of them fit the registers."""
    words = []
    for count in (8, 16, 32):
        source = Source("p.nsl", chain_read_twice(kind, count))
        made = run_passes(source, Path(), Options(level=1, cache=False)).container
        assert made is not None
        words.append(made.pictures.words)
    assert all(after < 2.4 * before for before, after in pairwise(words))


@pytest.mark.parametrize("line", [line for line in ROWS.split("\n") if line])
def test_every_stored_program_and_its_turned_copies_compute_their_kernels(line: str) -> None:
    program = program_from_text(line)
    taps = kernel_of(program)
    image = np.random.default_rng(1).normal(size=(10, 11))
    for turn in TURNS:
        turned_program = turned(program, turn)
        assert kernel_of(turned_program) == turned_taps(taps, turn)
        expected = np.zeros_like(image)
        for (x, y), weight in turned_taps(taps, turn).items():
            expected += weight / UNIT * np.roll(image, (-y, -x), (0, 1))
        np.testing.assert_allclose(run_on_array(turned_program, image), expected, atol=1e-9)


def test_the_search_is_deterministic() -> None:
    taps = exact_taps(weights_of(GAUSS_5, 64))
    first, again = (Synthesis(500, ALL) for _ in range(2))
    assert first.variants(taps) == again.variants(taps)


def test_all_forms_are_used_where_a_target_allows_them() -> None:
    """A word that reads a neighbour halves, and a word reads more than two sources."""
    for rows, divisor in ((outer([1, 2, 1], [1, 0, -1]), 8), (LAPLACE_8, 1)):
        taps = exact_taps(weights_of(rows, divisor))
        best = Synthesis(2_500, ALL).variants(taps)[0].program
        assert all(is_allowed(word, ALL) for word in best)
        assert not all(is_allowed(word, PUBLIC) for word in best)


@pytest.mark.parametrize("sources", [1, 2, 3])
def test_words_that_a_chip_lacks_are_replaced(sources: int) -> None:
    """For chips of one to three sources a word, each stored program has only allowed words and
    still computes its kernel."""
    forms = WordForms(sources=sources)
    for line in filter(None, ROWS.split("\n")):
        program = program_from_text(line)
        allowed = forms.allowed(program)
        assert all(is_allowed(word, forms) for word in allowed)
        assert kernel_of(allowed) == kernel_of(program)


def test_the_error_of_a_result_adds_up() -> None:
    """Two words with an error each: the first one's is halved."""
    program = program_from_text("an=x b=a")
    assert noise_gain(program) == pytest.approx(np.sqrt(2))
    assert noise_gain(program_from_text("a=x bn=a")) == pytest.approx(np.sqrt(1 + 1 / 4))


ALL_FORMS = {"directed_sources": 4, "directed_halving": True}


def words_of(kernels: list[list[list[int]]], divisor: int, level: int = 1, **keys: Any) -> int:
    """The words of the images of kernels of one exposure, in one proved program."""
    lines = ["nsl 3", "frame 1 slots of 1ms", "open when true", "assume exposure <= 3%"]
    for number, rows in enumerate(kernels):
        lines.append(f"kernel k{number} = {rows} / {divisor}")
        lines += [f"image i{number} = k{number}(exposure)", f"plane p{number} = i{number} > 1%"]
    lines.append(f"read {', '.join(f'p{number}' for number in range(len(kernels)))}")
    target = replace(builtin_target("scamp5"), **keys)
    options = Options(level=level, target=target, cache=False)
    made = run_passes(Source("p.nsl", "\n".join(lines)), Path(), options).container
    assert made is not None
    return sum(cost.words for cost in made.pictures.costs if cost.name.startswith("i"))


BOX_3, BOX_5 = outer([1] * 3, [1] * 3), outer([1] * 5, [1] * 5)
SOBEL_X, SOBEL_Y = outer([1, 2, 1], [1, 0, -1]), outer([1, 0, -1], [1, 2, 1])


def test_kernels_of_one_exposure_share_words() -> None:
    # Recorded numbers of words: they must not grow.
    assert words_of([SOBEL_X, SOBEL_Y], 1) <= 13
    assert words_of(ANALOGNET2, 4) <= 36
    apart = sum(words_of([rows], 4) for rows in ANALOGNET2)
    assert words_of(ANALOGNET2, 4) < apart


def test_kernels_share_halvings_and_are_computed_in_the_best_order() -> None:
    # Recorded numbers of words: they must not grow.
    assert words_of(MAX_POOLED, 4, level=2) <= 31
    assert words_of(ANALOGNET2, 4, level=2) <= 30
    assert words_of([BOX_3, BOX_5], 1, level=2) <= 19


@pytest.mark.parametrize("kernels", [MAX_POOLED, ANALOGNET2, [outer([1, 2, 1], [1, 2, 1])]])
def test_more_forms_never_make_programs_longer(kernels: list[list[list[int]]]) -> None:
    """More forms of words give at most as many words, and fewer forms at least as many."""
    public = words_of(kernels, 4, level=2)
    assert words_of(kernels, 4, level=2, **ALL_FORMS) <= public
    assert public <= words_of(kernels, 4, level=2, directed_sources=1)


def test_divided_values_are_shared_by_kernels_alone() -> None:
    text = "nsl 3 frame 1 slots of 1ms bucket a open when true bucket b open when true "
    text += "assume exposure a <= 40% assume exposure b <= 40% "
    text += "kernel k = [[1, 2, 1]] / 4 kernel s = [[1, 0, -1]] / 2 "
    text += "image c = k(a) + k(b) image d = s(a) + s(k(b)) image e = b read c, d, e"
    made = run_passes(Source("p.nsl", text), Path(), Options(level=2, cache=False)).container
    assert made is not None
    shared = with_shared_halvings(made.pictures)
    assert shared is not None
    assert [item.name for item in shared.items] == ["a / 2", "c", "d", "e"]
    half = p.Sum(((Fraction(2), p.Source("a / 2")),))
    assert p.Filtered("k", half) in p.operands(shared.items[1].node)
    assert with_shared_halvings(shared) is None
    assert [cost.name for cost in made.pictures.costs] == ["c", "d", "e"]
    assert sum(cost.words for cost in made.pictures.costs) >= made.pictures.words - 2


def test_the_same_kernel_again_takes_a_copy_at_most() -> None:
    assert words_of([SOBEL_X, SOBEL_X], 1) <= words_of([SOBEL_X], 1) + 2


def test_a_kernel_of_7_by_7_equal_weights_is_computed_by_rows_and_columns() -> None:
    # 49 weights one by one would take more than a word each.
    assert words_of([outer([1] * 7, [1] * 7)], 64) <= 24


@pytest.mark.parametrize("kernels", [[SOBEL_X], [SOBEL_X, SOBEL_Y], ANALOGNET2])
def test_kernels_take_more_words_if_reading_a_neighbour_changes_news(
    kernels: list[list[list[int]]],
) -> None:
    # The proof forgets NEWS when a neighbour reads it.
    assert words_of(kernels, 4, news_read_keeps=False) > words_of(kernels, 4)


@pytest.mark.parametrize(
    ("program", "is_valid"),
    [
        ([(("NEWS",), ("A",)), (("B",), ("XN",)), (("C",), ("B",))], True),
        ([(("NEWS",), ("A",)), (("B",), ("XN",)), (("C",), ("XE",))], False),
        ([(("NEWS",), ("A",)), (("B",), ("XN",)), (("C",), ("NEWS",))], False),
        ([(("NEWS",), ("A",)), (("B",), ("NEWS",)), (("C",), ("XN",))], True),
        ([(("B",), ("XN",)), (("NEWS",), ("A",)), (("C",), ("XE",))], True),
        ([(("B",), ("XN",)), (("XS",), ("A",)), (("C",), ("XE",))], True),
        ([(("B",), ("XN",)), (("NEWS",), ("XE",)), (("C",), ("XE",))], False),
    ],
)
def test_reading_news_again_after_a_neighbour_was_read_requires_a_new_write(
    program: list[tuple[tuple[str, ...], tuple[str, ...]]], is_valid: bool
) -> None:
    assert reads_news_once(tuple(BusWord(*word) for word in program)) == is_valid


def test_stored_programs_are_those_of_a_search(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The result depends neither on earlier searches nor on damaged entries."""
    kernels = [exact_taps(weights_of(*each)) for each in ((LAPLACE_8, 8), (GAUSS_5, 64))]
    found = [Synthesis(60, PUBLIC).variants(taps) for taps in kernels]
    both = Synthesis(60, PUBLIC, Results(Store(tmp_path)))
    assert [both.variants(taps) for taps in reversed(kernels)] == found[::-1]
    entries = list(tmp_path.iterdir())
    assert len(entries) == 2  # a kernel and its inverse share one
    with monkeypatch.context() as patched:
        patched.setattr(Synthesis, "_proved", None)
        known = Synthesis(60, PUBLIC, Results(Store(tmp_path)))
        assert [known.variants(taps) for taps in kernels] == found
    store = Store(tmp_path)
    for wrong in (b"", b"[]", b'[[],[[[["a"],["b"]]]]]', store.read(entries[0].name) or b""):
        for entry in entries:
            store.write(entry.name, wrong)
        assert Synthesis(60, PUBLIC, Results(store)).variants(kernels[1]) == found[1]


def test_stored_programs_of_words_that_the_chip_lacks_are_not_taken(tmp_path: Path) -> None:
    """An entry that another chip could have written computes the kernel all the same."""
    results = Results(Store(tmp_path))
    taps = exact_taps(weights_of(LAPLACE_8, 8))
    found = Synthesis(60, PUBLIC).variants(taps)
    assert Synthesis(60, PUBLIC, results).variants(taps) == found
    (entry,) = tmp_path.iterdir()
    programs = [
        [ranged.program for ranged in Synthesis(60, ALL).variants(kernel)]
        for kernel in sorted([taps, added((-1, taps))], key=lambda kernel: sorted(kernel.items()))
    ]
    results.store.write(entry.name, json.dumps(programs).encode())
    assert Synthesis(60, PUBLIC, results).variants(taps) == found
    assert results.read == 0
    results.distrust()
    assert results.entry(entry.name) is None
