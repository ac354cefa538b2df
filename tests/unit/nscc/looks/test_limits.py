"""Programs that look and are too large, or look for what no pixel holds: refused soon, with why."""

from __future__ import annotations

import resource
from dataclasses import replace

import pytest

import nscc
from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected

SMALL_WELL = replace(
    builtin_target("scamp5"), name="mine", rows=8, cols=8, full_well_e=10000.0, readout="full"
)


def rejection(text: str, target: nscc.Target | str = "scamp5") -> str:
    with pytest.raises(Rejected) as caught:
        nscc.compile(text, target=target)
    (found,) = caught.value.diagnostics
    assert caught.value.status == 1
    return f"{found.code} {found.message} {found.helps}"


def test_a_state_of_any_range_is_counted_before_it_is_made() -> None:
    said = rejection(
        "nsl 2\nframe 8 slots of 1ms\nsense b when light > 45% at n == 2\n"
        f"state c : 0..{10**15} = 1 kept\nnext c = 10 when b\nopen when c == 1\nread c\n"
    )
    assert said.startswith("NS0450")
    assert f" {10**15 + 1} " in said


@pytest.mark.parametrize(("slots", "last"), [(16, "12"), (12, "12"), (16, "N - 4")])
def test_the_error_for_a_state_that_does_not_fit_names_the_largest_that_fits(
    slots: int, last: str
) -> None:
    """If the range ends with a number, the suggestion replaces this number and not an equal number
    of slots. If it ends with a formula, the suggestion shortens the frame."""
    chip = replace(SMALL_WELL, digital_registers=("R0", "R1", "R2", "R3", "R4", "R5", "R12"))

    def text(slots: int, last: str) -> str:
        return (
            f"nsl 2\nframe {slots} slots of 1ms\nsense b when light > 45% at n > 0\n"
            f"state c : 0..{last} = 0\nnext c = c + 1 when b and c < {last}\n"
            "open when true\nread c\n"
        )

    with pytest.raises(Rejected) as caught:
        nscc.compile(text(slots, last), target=chip, level=1)
    (found,) = caught.value.diagnostics
    assert found.code == "NS0502"
    (way,) = found.ways_out
    if last == "12":
        assert way.startswith("7 instead of 12 ")
        fits, next_larger = text(slots, "7"), text(slots, "8")
    else:
        assert way.startswith("frame 11 slots ")
        fits, next_larger = text(11, last), text(12, last)
    nscc.compile(fits, target=chip, level=1)
    with pytest.raises(Rejected):
        nscc.compile(next_larger, target=chip, level=1)


@pytest.mark.parametrize("slots", [1024, 4096])
def test_a_look_at_every_boundary_of_a_long_frame_is_refused_in_little_memory(slots: int) -> None:
    """Keeping all nodes of a thousand stages for every slot would take gigabytes."""
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    said = rejection(
        f"nsl 2\nframe {slots} slots of 100us\nsense b when light > 45% at n >= 1\n"
        f"state c : 0..{slots} = 0\nnext c = n when b and c == 0\nopen when c == 0\nread c\n"
    )
    assert said.startswith("NS0450")
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 2 << 20  # KiB


@pytest.mark.parametrize(("code", "fits"), [(4, True), (60, True), (127, True), (128, False)])
def test_levels_of_a_field_must_be_below_a_full_well(code: int, fits: bool) -> None:
    """10,000 e are 127.5 codes: 8 bits reach over two wells."""
    looks = "nsl 2\nframe 4 slots of 1ms\n{}sense b when light > {} at n == 2\n"
    looks += "state c : bit = 0\nnext c = b\nopen when n < 3\nread c\n{}"
    plain = looks.format("", f"{code}lsb", "")
    field = looks.format("code f : 1..200\n", "f", f"pixels f = {code}\n")
    for text in (plain, field):
        if fits:
            nscc.compile(text, target=SMALL_WELL)
        else:
            assert "NS0321" in rejection(text, SMALL_WELL)
    if not fits:
        assert "below 100%" in rejection(plain, SMALL_WELL)
