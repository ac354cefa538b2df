"""Programs that were refused, or cost many times more than ones of nearly the same size."""

from __future__ import annotations

import numpy as np
import pytest

import nscc

PICTURES = "nsl 3\nframe 1 slots of 1ms\nopen when true\noutside 0\n"


def book(rows: int, slots: int, seed: int) -> str:
    digits = np.random.default_rng(seed).integers(0, 2, (rows, slots))
    lines = ", ".join("".join(map(str, row)) for row in digits)
    return (
        f"nsl 1\nframe {slots} slots of 100us\nshutters book [{lines}]\n"
        "code id : row of book\nopen when book[id]\n"
    )


@pytest.mark.parametrize("seed", [3, 4])
def test_a_codebook_of_twice_the_slots_takes_about_twice_the_words(seed: int) -> None:
    small, large = (
        nscc.compile(book(48, slots, seed), level=1, codes="open").words_per_frame
        for slots in (32, 64)
    )
    # Twice as many, and a margin of 15 %.
    assert large <= 2.3 * small


def test_a_random_codebook_of_more_than_32_slots_is_searched_for_cascades() -> None:
    text = book(20, 40, 5)
    covers, cascades = (
        nscc.compile(text, level=level, codes="open").words_per_frame for level in (1, 2)
    )
    # Level 1 does not search for cascades, which save a fifth or more here.
    assert cascades < 0.8 * covers


CHAIN = "".join(f"plane p{i} = exposure > {5 * i + 5}%\n" for i in range(12))


@pytest.mark.parametrize(
    "text",
    [
        CHAIN
        + "plane c1 = p0 xor p1\n"
        + "".join(f"plane c{i} = c{i - 1} xor p{i}\n" for i in range(2, 12))
        + "read c11\n",
        CHAIN
        + "plane c1 = p10 xor p11\n"
        + "".join(f"plane c{i} = p{11 - i} or c{i - 1}\n" for i in range(2, 12))
        + "read c11\n",
        CHAIN + "plane c = " + " xor ".join(f"p{i}" for i in range(12)) + "\nread c\n",
        "".join(f"kernel k{i} = [[0, 1, {i % 5}]] / 32\n" for i in range(30))
        + "".join(f"image i{i} = abs(k{i}(exposure))\n" for i in range(30))
        + "image m = ("
        + " + ".join(f"i{i}" for i in range(30))
        + ") / 32\nread m\n",
    ],
    ids=["chain", "chain from its end", "one expression", "sum"],
)
def test_values_that_are_read_once_are_computed_just_before(text: str) -> None:
    """All of them together need more registers than there are; the proof compares all pixels."""
    assert nscc.compile(PICTURES + text).report["images_words_total"] > 0
