"""What this machine takes: measured, kept, shown; it enters no product."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from nscc_command import invoke

from nscc.cache.store import Store
from nscc_runtime import machine_prices, pool
from nscc_runtime.machine_prices import MachinePrices, Price, best_threads, keep, kept, place
from nscc_runtime.planner import measuring

FOUND = MachinePrices((Price("sums", "a pixel", "ns", 137.5, 100.0),
                       Price("thread", "woken", "us", None, 20.0)), 1)  # fmt: skip


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("NSCC_CACHE_DIR", str(tmp_path))
    best_threads.cache_clear()
    return tmp_path


def test_prices_are_kept_and_read_again() -> None:
    assert kept() is None
    path = keep(FOUND)
    assert path == place() is not None
    assert kept() == FOUND
    assert [*path.parent.iterdir()] == [path]


def test_who_keeps_nothing_has_none(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NSCC_CACHE", "off")
    assert place() is keep(FOUND) is kept() is None


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
    path = keep(FOUND)
    assert path is not None
    assert callable(change)
    store = Store(path.parent)
    values = json.loads(store.read(path.name) or b"")
    store.write(path.name, json.dumps(change(values)).encode())
    assert kept() is None
    path.write_bytes(b"no entry of the cache")
    assert kept() is None


def test_a_folder_without_room_is_no_error(folder: Path) -> None:
    (folder / "prices").write_text("a file")
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
    ways = {"planning", "sums", "words", "reference", "thread"}
    assert {e.name for e in found.prices} > ways | {"shot", "dark", "read", "crosstalk"}
    here = {each.name: each.here for each in found.prices if each.name in ways}
    assert all(value > 0 for value in here.values())
    assert all(each.here >= 0 and each.shipped for each in found.prices if each.name not in ways)
    assert not {e.name for e in found.prices} & {"comparator_offset", "comparator_noise"}
    # A pixel through its words takes many times one by sums, whatever the machine.
    assert here["words"] > 5 * here["sums"]
