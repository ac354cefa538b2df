"""`--fault`: what it says, and what it does to bytes."""

from __future__ import annotations

import pytest

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.device.serving import EXAMPLE, Accidents, LineFaults, Spoiler, parse_faults


def test_fault_texts_are_parsed() -> None:
    """A text such as `outage=2s, seed=7` gives rates, seconds and byte counts. What it leaves out
    keeps its default."""
    assert parse_faults(EXAMPLE) == LineFaults(1e-4, 1e-5, 0.05, 20000, 40000)
    assert parse_faults("outage=2s, seed=7") == LineFaults(outage_s=2.0, seed=7)
    assert parse_faults("delay=250us").delay_s == pytest.approx(250e-6)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "corrupt",
        "corrupt=",
        "corrupt=2",
        "corrupt=-1e-3",
        "corrupt=nan",
        "drop=x",
        "delay=50",
        "delay=-1s",
        "delay=1h",
        "delay=1e9s",
        "delay=99999s",
        "disconnect=20000",
        "disconnect=after:",
        "disconnect=after:-1",
        "reboot=after:1e4",
        "reboot=after:²",
        "corupt=1e-4",
        "corrupt=0,corrupt=0",
        "seed=-1",
        "seed=after:1",
    ],
)
def test_invalid_faults_are_refused(text: str) -> None:
    with pytest.raises(Rejected) as caught:
        parse_faults(text)
    assert [d.code for d in caught.value.diagnostics] == ["NS0769"]
    assert caught.value.status == 2


def test_a_misspelt_fault_gets_a_suggestion() -> None:
    """`corupt` gets the help that proposes `corrupt`."""
    with pytest.raises(Rejected) as caught:
        parse_faults("corupt=1e-4")
    assert caught.value.diagnostics[0].helps == ("did you mean `corrupt`?",)


def test_bytes_are_hit_at_the_rates_given() -> None:
    """At a rate of 1 %, about 5120 of 512 000 bytes are changed or lost, within 5 standard
    deviations."""
    data = bytes(range(256)) * 2000
    spoiler = Spoiler(LineFaults(corrupt=1e-2, seed=1), 1)
    out = b"".join(spoiler.spoiled(data[i : i + 77]) for i in range(0, len(data), 77))
    assert len(out) == len(data)
    wrong = sum(one != other for one, other in zip(out, data, strict=True))
    # 5120 are expected, with a standard deviation of 71.
    assert abs(wrong - 5120) < 5 * 71
    spoiler = Spoiler(LineFaults(drop=1e-2, seed=1), 1)
    lost = len(data) - len(
        b"".join(spoiler.spoiled(data[i : i + 77]) for i in range(0, len(data), 77))
    )
    assert abs(lost - 5120) < 5 * 71


def test_faults_happen_never_at_probability_0_and_always_at_1() -> None:
    """Without rates the bytes pass. `drop=1` leaves none, and `corrupt=1` changes each byte."""
    assert Spoiler(LineFaults(), 1).spoiled(b"as it is") == b"as it is"
    assert Spoiler(LineFaults(drop=1.0), 1).spoiled(b"gone") == b""
    out = Spoiler(LineFaults(corrupt=1.0), 1).spoiled(b"\0" * 1000)
    assert len(out) == 1000
    assert 0 not in out


def test_equal_seeds_cause_equal_faults() -> None:
    """The same seed and line number spoil the same bytes, however the stream is cut. Another line
    number spoils others."""
    data = bytes(100_000)
    faults = LineFaults(corrupt=1e-3, drop=1e-3, seed=4)
    assert Spoiler(faults, 1).spoiled(data) == Spoiler(faults, 1).spoiled(data)
    assert Spoiler(faults, 1).spoiled(data) != Spoiler(faults, 2).spoiled(data)
    cut = Spoiler(faults, 1)
    pieces = b"".join(cut.spoiled(data[i : i + 333]) for i in range(0, len(data), 333))
    assert pieces == Spoiler(faults, 1).spoiled(data), "however the bytes are cut"


def test_faults_at_a_byte_count_happen_once() -> None:
    """The link breaks once when byte 10 has passed and the loader restarts once after byte 25. Both
    can happen at one byte."""
    accidents = Accidents(LineFaults(disconnect_after=10, reboot_after=25))
    assert [accidents.passed(5) for _ in range(6)] == [[], ["disconnect"], [], [], ["reboot"], []]
    assert Accidents(LineFaults(disconnect_after=1, reboot_after=1)).passed(1) == [
        "disconnect",
        "reboot",
    ]
