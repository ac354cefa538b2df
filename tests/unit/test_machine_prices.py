"""What this machine takes: measured, kept, shown; it enters no product."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from nscc_command import invoke

from nscc_runtime import machine_prices, pool
from nscc_runtime.machine_prices import MachinePrices, Price, best_threads, keep, kept, place
from nscc_runtime.planner import measuring

FOUND = MachinePrices((Price("sums", "a pixel", "ns", 137.5, 100.0),
                       Price("thread", "woken", "us", None, 20.0)), 1)  # fmt: skip


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    best_threads.cache_clear()
    return tmp_path


def test_prices_are_kept_and_read_again() -> None:
    assert kept() is None
    assert keep(FOUND) == place()
    assert kept() == FOUND
    assert [each.name for each in place().parent.iterdir()] == [place().name]


@pytest.mark.parametrize(
    "change",
    [
        lambda values: values | {"schema": "another"},
        lambda values: values | {"threads": 0},
        lambda values: values | {"threads": "2"},
        lambda values: values | {"prices": [{"name": "sums"}]},
        lambda values: values | {"prices": [{**values["prices"][0], "here": None}]},
        lambda values: [],
    ],
)
def test_a_file_that_is_no_list_is_measured_anew(change: object) -> None:
    keep(FOUND)
    assert callable(change)
    place().write_text(json.dumps(change(json.loads(place().read_text()))))
    assert kept() is None


def test_a_folder_without_room_is_no_error(folder: Path) -> None:
    (folder / "nscc").write_text("a file")
    assert keep(FOUND) is None


def test_threads_follow_what_was_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pool, "processors", lambda: 8)
    assert pool.threads_of(None) == 8
    assert pool.threads_of(3) == 3
    keep(FOUND)
    best_threads.cache_clear()
    assert pool.threads_of(None) == 1
    assert pool.threads_of(3) == 3


def test_the_command_shows_them(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    times: list[MachinePrices] = []

    def measured() -> MachinePrices:
        times.append(FOUND)
        return FOUND

    monkeypatch.setattr(measuring, "measured", measured)
    shown = [invoke(["effects", "--cost"], tmp_path).out for _ in range(2)]
    assert len(times) == 1
    assert "measured now" in shown[0]
    assert "measured before" in shown[1]
    assert str(machine_prices.place()) in shown[1]
    assert invoke(["effects", "--cost", "--toml"], tmp_path).status == 2


@pytest.mark.slow
def test_measuring_finds_prices_of_every_way() -> None:
    found = measuring.measured()
    assert {e.name for e in found.prices} == {"planning", "sums", "words", "reference", "thread"}
    here = {each.name: each.here for each in found.prices}
    assert all(value > 0 for value in here.values())
    # A pixel through its words takes many times one by sums, whatever the machine.
    assert here["words"] > 5 * here["sums"]
