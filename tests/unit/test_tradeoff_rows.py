"""Rows of tradeoffs: on the disk as they are measured, known again, of one measurement alone."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from nscc_command import invoke

from nscc.diagnostics.diagnostic import Rejected
from nscc.source import Source
from nscc.tradeoff import synthesis
from nscc.tradeoff.rows import Rows
from nscc.tradeoff.synthesis import Case, every_way

TEXT = "nsl 1 frame 8 slots of 1ms code stop : 0..7 open when n < stop "


def test_a_row_is_on_the_disk_when_it_is_measured(tmp_path: Path) -> None:
    file = tmp_path / "x.rows.jsonl"
    with Rows(file, "digest") as rows:
        assert rows.once("a", lambda: {"ms": (1.5, 2)}) == {"ms": [1.5, 2]}
        assert file.read_text().splitlines() == ["digest", '["a", {"ms": [1.5, 2]}]']
        assert rows.once("a", lambda: pytest.fail("it is known")) == {"ms": [1.5, 2]}
    with Rows(file, "digest") as rows:
        assert rows.once("a", lambda: pytest.fail("it is known")) == {"ms": [1.5, 2]}
        rows.done()
    assert not file.exists()


@pytest.mark.parametrize("cut", range(1, 12))
def test_a_row_that_was_cut_short_is_measured_again(tmp_path: Path, cut: int) -> None:
    file = tmp_path / "rows"
    with Rows(file, "digest") as rows:
        rows.once("a", lambda: 1)
        rows.once("b", lambda: 2.25)
    whole = file.read_bytes()
    file.write_bytes(whole[:-cut])
    with Rows(file, "digest") as rows:
        assert [rows.once("a", lambda: 3), rows.once("b", lambda: 2.25)] == [1, 2.25]
    assert file.read_bytes() == whole


def test_rows_of_another_measurement_are_dropped(tmp_path: Path) -> None:
    file = tmp_path / "rows"
    with Rows(file, "one") as rows:
        rows.once("a", lambda: 1)
    with Rows(file, "other") as rows:
        assert rows.once("a", lambda: 2) == 2
    assert file.read_text() == 'other\n["a", 2]\n'


def test_without_a_file_everything_is_measured() -> None:
    rows = Rows()
    assert [rows.once("a", lambda: 1), rows.once("a", lambda: 2)] == [1, 2]


def test_one_process_at_a_time(tmp_path: Path) -> None:
    with Rows(tmp_path / "rows", "x"), pytest.raises(Rejected) as caught:
        Rows(tmp_path / "rows", "x")
    assert caught.value.diagnostics[0].code == "NS0825"
    with pytest.raises(Rejected) as caught:
        Rows(tmp_path / "no" / "rows", "x")
    assert caught.value.diagnostics[0].code == "NS0784"


def test_a_measurement_that_was_ended_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ways = [
        *every_way([Case("p", Source("p.nsl", TEXT), Path(), "open")], ("latch", "edges"), (0,))
    ]
    compiled = []
    real = synthesis.compiled_or_not
    monkeypatch.setattr(
        synthesis, "compiled_or_not", lambda way: (compiled.append(way), real(way))[1]
    )

    def until(turns):
        for number, way in enumerate(turns):
            if number == 3:
                raise KeyboardInterrupt
            yield way

    with Rows(tmp_path / "rows", "x") as rows, pytest.raises(KeyboardInterrupt):
        synthesis.measure(ways, 3, "all", until, rows)
    lines = (tmp_path / "rows").read_text().splitlines()
    before = [json.loads(line)[1]["ms"] for line in lines[1:]]
    assert len(before) == 3
    compiled.clear()
    with Rows(tmp_path / "rows", "x") as rows:
        found = synthesis.measure(ways, 3, "all", rows=rows)
    assert len(compiled) == 2 * 2 + 3, "each way untimed, and those that were not known"
    latch, edges = found.points
    assert [latch.times_ms[0], edges.times_ms[0], latch.times_ms[1]] == before


def test_who_interrupts_is_told_where_rows_are_kept(tmp_path: Path) -> None:
    file = tmp_path / "rows"
    told = r"kept in '.*rows', and the same command goes on"
    rows = Rows(file, "x")
    rows.once("a", lambda: 1)
    with pytest.raises(KeyboardInterrupt, match=told), rows:
        raise KeyboardInterrupt
    assert json.loads(file.read_text().splitlines()[1]) == ["a", 1]
    for nothing in (Rows(), Rows(tmp_path / "none", "x")):
        with pytest.raises(KeyboardInterrupt) as found, nothing:
            raise KeyboardInterrupt
        assert found.value.args == ()


def test_a_command_leaves_its_products_and_no_rows(tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(TEXT)
    command = ["tradeoff", "synthesis", "p.nsl", "--levels", "0", "--repeats", "1", "-o", "out"]
    done = invoke(command, tmp_path)
    assert (done.status, done.err) == (0, "wrote out.csv, out.png\n")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.csv", "out.png", "p.nsl"]
