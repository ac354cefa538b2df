"""`nscc sweep` in this process: grids, keys, what is kept, what is written."""

from __future__ import annotations

import csv
import io
import os
import sqlite3
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from nscc_command import invoke

from nscc.diagnostics.diagnostic import Rejected
from nscc.emit.report import report
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc_training.experiments.engine import PointRow, rows_in
from nscc_training.experiments.study_table import csv_of
from nscc_training.scene_files import files_in
from nscc_training.sweep import compiling, run_sweep
from nscc_training.sweep.grid import read_grid
from nscc_training.sweep.kinds import key_of
from nscc_training.sweep.point import GridPoint
from nscc_training.sweep.run_sweep import store_in

ROWS = Path(__file__).parents[3] / "data" / "rows"
STOPS = """
[stops]
rule = "code stop : 1..N\\nopen when n < stop"
slots = [4, 8]
codes = "open"
level = 0
"""
GRID = f'kind = "compile"\n{STOPS}lowering = ["accumulate", "edges"]\n'
BITS = '[bits]\nrule = "code bits : bit[N]\\nopen when bits[n]"\nslots = 16\ncodes = "open"\n'


def written(folder: Path, text: str, name: str = "grid.toml") -> Path:
    (folder / name).write_text(text)
    return folder / name


def swept(folder: Path, *more: str, status: int = 0) -> list[dict[str, str]]:
    """The rows of the table."""
    done = invoke(
        [
            "sweep",
            "grid.toml",
            "--out",
            "out",
            "--workers",
            "0",
            "--message-format",
            "short",
            *more,
        ],
        folder,
    )
    assert done.status == status, done.err
    return list(csv.DictReader(io.StringIO((folder / "out/table.csv").read_text())))


def kept(folder: Path) -> dict[str, PointRow]:
    with store_in(folder / "out") as store:
        return rows_in(store)


def test_every_combination_has_the_figures_of_its_report(tmp_path: Path) -> None:
    """Two numbers of slots and two lowerings give four rows. Their words and shortest slot are
    those of the compiler's report."""
    written(tmp_path, GRID)
    rows = swept(tmp_path)
    wanted = [(slots, how) for slots in ("4", "8") for how in ("accumulate", "edges")]
    assert [(row["slots"], row["lowering"]) for row in rows] == wanted
    for row in rows:
        text = f"nsl 1 frame {row['slots']} slots of 1ms code stop : 1..N open when n < stop"
        options = Options(level=0, codes="open", lowering=row["lowering"])  # type: ignore[arg-type]
        made = run_passes(Source("p.nsl", text), Path(), options)
        assert made.proof is not None
        told = report(made.layout, made.proof)
        assert row["words_total"] == str(told["words_total"])
        assert float(row["shortest_slot_us"]) == told["shortest_slot_us"]


def test_rows_without_noise_are_those_of_the_engine_before(
    tmp_path: Path, update_cases: bool
) -> None:
    """Commit fb2d3e8a wrote `programs.csv`, before studies and sweeps shared one engine."""
    written(tmp_path, (ROWS / "programs.toml").read_text())
    rows = [{**row} for row in swept(tmp_path)]
    for row in rows:
        del row["key"]
    if update_cases:
        text = csv_of(rows[0], (row.values() for row in rows))
        (ROWS / "programs.csv").write_text(text)
    assert rows == list(csv.DictReader(io.StringIO((ROWS / "programs.csv").read_text())))


def test_programs_that_do_not_fit_are_table_rows_with_their_error(tmp_path: Path) -> None:
    """The row has the code NS0412 and no figures. The page shows it and draws the other four."""
    written(tmp_path, GRID + BITS)
    rows = swept(tmp_path)
    assert [row["code"] for row in rows] == ["", "", "", "", "NS0412"]
    assert rows[-1]["words_total"] == ""
    assert "16 bits" in rows[-1]["error"]
    page = (tmp_path / "out/report.html").read_text()
    assert "NS0412" in page
    assert "data:image/png" in page


def test_a_grid_of_which_nothing_fits_has_no_diagram(tmp_path: Path) -> None:
    """Its one row is an error, so the status is 1 and no diagram is written."""
    written(tmp_path, f'kind = "compile"\n{BITS}[plot]\ny = ["words_total"]\n')
    assert [row["code"] for row in swept(tmp_path, status=1)] == ["NS0412"]
    assert not (tmp_path / "out/diagram.png").exists()


def test_unknown_columns_of_a_plot_are_refused(tmp_path: Path) -> None:
    """A misspelt column gives NS0832 with a proposal. The four computed points are kept."""
    written(tmp_path, GRID + '[plot]\ny = ["word_total"]\n')
    done = invoke(["sweep", "grid.toml", "--out", "out", "--workers", "0"], tmp_path)
    assert (done.status, done.codes) == (2, ["NS0832"])
    assert "did you mean `words_total`?" in done.err
    assert len(kept(tmp_path)) == 4


def test_panels_that_show_the_same_have_the_same_scales() -> None:
    from nscc_runtime.pictures.sweeps import Lines, sweep_diagram

    wide = {"one": [(1, 2.0), (100, 300.0)], "two": [(5, 9.0)]}
    panels = [
        Lines("a", "slots", "words", wide),
        Lines("b", "slots", "words", {"two": [(7, 7.0), (8, 8.0)]}),
        Lines("c", "class", "psnr", {"one": [("b", 30.0), ("d", 31.0)]}),
    ]
    figure = sweep_diagram(panels, "t", "")
    first, second, third = figure.axes
    assert (first.get_xlim(), first.get_ylim()) == (second.get_xlim(), second.get_ylim())
    assert second.get_xscale() == second.get_yscale() == "log"
    assert [label.get_text() for label in third.get_xticklabels()] == ["b", "d"]
    assert [list(line.get_xdata()) for line in third.lines] == [[0, 1]]
    assert first.lines[1].get_color() == second.lines[0].get_color() != first.lines[0].get_color()
    with pytest.raises(ValueError, match="no points"):
        sweep_diagram([Lines("", "x", "y", {"one": []})], "t", "")


def test_an_interrupted_sweep_computes_only_missing_points(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ended in the middle: nothing that is known is computed again."""
    written(tmp_path, GRID)
    whole = swept(tmp_path)
    calls: list[Any] = []
    compute = compiling.COMPILE.compute
    monkeypatch.setattr(
        "nscc_training.sweep.work.KINDS",
        {"compile": replaced(lambda values, place: calls.append(values) or compute(values, place))},
    )
    rows = kept(tmp_path)
    with store_in(tmp_path / "out") as store:
        store.forget(*list(rows)[2:])
    assert swept(tmp_path) == whole
    assert len(calls) == 2
    assert kept(tmp_path) == rows
    assert swept(tmp_path) == whole
    assert len(calls) == 2


def replaced(compute: Any) -> Any:
    from dataclasses import replace

    return replace(compiling.COMPILE, compute=compute)


def test_a_changed_grid_computes_only_its_new_points(tmp_path: Path) -> None:
    """The grid of 4 and 8 slots becomes one of 8 and 9. The table has four rows, and six points are
    kept."""
    written(tmp_path, GRID)
    swept(tmp_path)
    written(tmp_path, GRID.replace("[4, 8]", "[8, 9]"))
    rows = swept(tmp_path)
    assert [row["slots"] for row in rows] == ["8", "8", "9", "9"]
    assert len(kept(tmp_path)) == 6  # those of 4 slots too


def test_a_point_that_fails_twice_is_a_row(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    tries: list[int] = []

    def fails(values: Any, place: Any) -> Any:
        tries.append(values["slots"])
        if values["slots"] == 8 or len(tries) == 1:  # 4 slots fail once
            raise OSError(f"no disk for {values['slots']} slots")
        return {"words_total": 7}

    with monkeypatch.context() as patch:
        patch.setattr("nscc_training.sweep.work.KINDS", {"compile": replaced(fails)})
        written(tmp_path, f'kind = "compile"\n{STOPS}')
        rows = swept(tmp_path, status=1)
    assert tries == [4, 4, 8, 8]
    assert [row["code"] for row in rows] == ["", "NS0833"]
    assert rows[1]["error"] == "OSError: no disk for 8 slots"
    assert [row["code"] for row in swept(tmp_path, status=1)] == ["", "NS0833"]
    assert [row["code"] for row in swept(tmp_path, "--again")] == ["", ""]


def test_the_key_of_a_point_covers_what_its_result_depends_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    written(tmp_path, "nsl 1 frame 2 slots of 1ms open when true", "a.nsl")
    path = written(tmp_path, 'kind = "compile"\n[one]\nprogram = "a.nsl"\ntarget = "c.toml"\n')
    chip = invoke(["targets", "scamp5", "--toml"], tmp_path).out
    written(tmp_path, chip, "c.toml")

    def key(threads: int = 1) -> str:
        return key_of(read_grid(path).points[0], threads)

    first = key()
    assert key(threads=2) == first  # words do not depend on threads
    written(tmp_path, chip.replace("launch_us = 1.0", "launch_us = 2.0"), "c.toml")
    other_chip = key()
    written(tmp_path, "nsl 1 frame 3 slots of 1ms open when true", "a.nsl")
    other_text = key()
    monkeypatch.setattr("nscc_training.sweep.kinds.versions", lambda *_: ("another",))
    assert len({first, other_chip, other_text, key()}) == 4


@pytest.mark.parametrize(
    ("init", "name"),
    [
        ("decoder.init", "begun/decoder.safetensors"),
        ("decoder.init", "clip/decoder.safetensors"),
        ("shutter.init", "begun/codes.npz"),
        ("shutter.init", "clip/codes.npz"),
        ("shutter.init", "p.nsl/codes.npz"),
    ],
)
def test_the_initial_program_is_part_of_the_key_of_a_run(
    init: str, name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A run's folder, one that comes with nscc, and the file that a program names."""
    given, _, part = name.partition("/")
    (tmp_path / "shipped").mkdir()
    (tmp_path / "begun").mkdir()
    shipped = {"clip": tmp_path / "shipped"}
    monkeypatch.setattr("nscc_training.run_files.shipped_runs", lambda: shipped)
    monkeypatch.chdir(tmp_path)
    written(tmp_path, "", "c.toml")
    written(tmp_path, 'nsl 1 frame 2 slots of 1ms pixels from "codes.npz"', "p.nsl")
    path = written(tmp_path, f'kind = "train"\n[run]\nconfig = "c.toml"\n{init} = "{given}"\n')
    file = {"clip": tmp_path / "shipped", "begun": tmp_path / "begun"}.get(given, tmp_path) / part
    keys = []
    for text in ("one", "another"):
        file.write_text(text)
        keys.append(key_of(read_grid(path).points[0], 1))
    assert keys[0] != keys[1]


def test_values_of_chip_and_sensor_are_axes(tmp_path: Path) -> None:
    written(
        tmp_path,
        """
[walk]
kind = "emulate"
rule = "code stop : 1..N\\nopen when n < stop\\npixels stop = tile [[4, 2], [1, 3]]"
slots = 4
level = 0
target = "scamp5"
chip.full_well_e = [20000, 30000]
scene = "builtin:flat:1000"
effects = "none"
sensor.read_noise_e = [1, 2.5]
""",
    )
    rows = swept(tmp_path)
    assert [(row["chip.full_well_e"], row["sensor.read_noise_e"]) for row in rows] == [
        ("20000.0", "1.0"),
        ("20000.0", "2.5"),
        ("30000.0", "1.0"),
        ("30000.0", "2.5"),
    ]
    assert {float(row["mean_e"]) for row in rows} == {625.0}  # 10 of 16 slots


@pytest.mark.slow
def test_options_of_a_bench_change_its_results(tmp_path: Path) -> None:
    """The table of `nscc tradeoff sensor` at its own values, other numbers at others."""
    pytest.importorskip("torch")
    written(
        tmp_path,
        """
[clips]
kind = "emulate"
bench = "clips"
class = "d"
slots = 4
frames = 4
tile = [[8, 8], [2, 2]]
sensor.read_noise_e = [1, 500]
lowering = "edges"
target = "scamp5"
level = 0
effects = "read"
""",
    )
    same, noisy, tiled, _ = (float(row["psnr_db"]) for row in swept(tmp_path))
    done = invoke(
        [
            "tradeoff",
            "sensor",
            "--classes",
            "d",
            "--slots",
            "4",
            "--stop-slots",
            "2",
            "--looks",
            "none",
            "--codes",
            "fixed",
            "--lowerings",
            "edges",
            "-O",
            "0",
            "--effects",
            "none",
            "--readouts",
            "none",
            "--csv",
            "sensor.csv",
        ],
        tmp_path,
    )
    assert done.status == 0, done.err
    with open(tmp_path / "sensor.csv", newline="") as file:
        [clip, _] = csv.DictReader(file)
    assert same == pytest.approx(float(clip["error"]), abs=0.1)  # an electron of noise
    assert noisy < same - 0.5
    assert abs(tiled - same) > 0.05


@pytest.mark.parametrize(
    ("text", "code", "said"),
    [
        ("x = 1", "NS0831", "a grid has no key 'x'"),
        ("[p]\nslots = 4", "NS0832", "the kind of [p] is missing"),
        ('kind = "compiler"\n[p]', "NS0832", "the kind of [p] is not 'compiler'"),
        ('kind = "compile"', "NS0832", "but it has none"),
        (GRID + "slot = 1", "NS0831", "did you mean `slots`?"),
        ("level = 1\n" + GRID, "NS0831", "`level` belongs under [stops]"),
        (GRID + "max_words = []", "NS0832", "an empty list gives no points"),
        (GRID + "max_words = [9, 9]", "NS0832", "a list contains a value twice"),
        (GRID + "seed = [0, -1]", "NS0832", "stops.seed must be a whole number"),
        (GRID + "seed = [0, -1]", "NS0832", "-1 is not allowed"),
        (GRID + 'class = ["b", "d"]', "NS0832", "but has rule and class"),
        (GRID + "tile = [2, 2]", "NS0832", "tile has no effect on a point with rule"),
        (GRID + "seed = [1, 2]", "NS0832", "seed has no effect"),
        (GRID + "chip.launch_us = 2", "NS0832", "changes a chip, but target is missing"),
        (GRID.replace("[stops]", "['a/b']"), "NS0832", "cannot be called 'a/b'"),
        (GRID + "seed = [" + "1,\n" * 40000 + "]", "NS0830", "larger than 64 KiB"),
        (
            GRID + '[scores]\nkind = "evaluate"\nrun = "stops"\ndata = "."',
            "NS0832",
            "unknown part [stops] of kind train",
        ),
        ("kind = ", "NS0830", "is not a TOML table"),
    ],
)
def test_an_invalid_grid_is_refused(tmp_path: Path, text: str, code: str, said: str) -> None:
    written(tmp_path, text)
    done = invoke(["sweep", "grid.toml", "--out", "out", "--workers", "0"], tmp_path)
    assert done.status == 2
    assert code in done.codes
    assert said in done.err
    assert not (tmp_path / "out").exists()


def test_points_have_the_names_that_are_asked_for(tmp_path: Path) -> None:
    """Without `name` a point is named after its part and values. An unknown field in `name` gets a
    proposal."""
    text = GRID + "[two]\n" + GRID.partition("[stops]\n")[2] + 'name = "s{slots}-{lowering}"\n'
    names = [point.name for point in read_grid(written(tmp_path, text)).points]
    assert names[:2] == ["stops_4_accumulate", "stops_4_edges"]
    assert names[4:] == ["s4-accumulate", "s4-edges", "s8-accumulate", "s8-edges"]
    with pytest.raises(Rejected, match="did you mean `slots`"):
        read_grid(written(tmp_path, GRID + 'name = "x{slot}"'))


RUNS = """
kind = "train"

[first]
name = "class-{shutter.class}/first/seed{train.seed}"
shutter.slots = 4
shutter.tile = [2, 2]
shutter.class = "b"
data.patch = 16
data.val_items = 2
train.seed = [0, 1]
train.steps = 2
train.batch = 2
train.validate_every = 2

[second]
like = "first"
name = "class-{shutter.class}/second"
train.seed = 0
decoder.init = "run:class-b/first/seed1"
"""


def test_a_part_of_a_grid_inherits_the_keys_of_the_part_that_it_names(tmp_path: Path) -> None:
    """The second run has the settings of the first part and comes after one of its runs. The run
    before it is part of its key."""
    points = read_grid(written(tmp_path, RUNS)).points
    assert [point.name for point in points] == [
        "class-b/first/seed0",
        "class-b/first/seed1",
        "class-b/second",
    ]
    assert points[2].values["train.batch"] == 2
    assert [run.name for run in points[2].after] == ["class-b/first/seed1"]
    assert key_of(points[2], 1) != key_of(replace(points[2], after=(points[0],)), 1)


def test_each_seed_names_the_run_of_its_own_seed(tmp_path: Path) -> None:
    second = RUNS.replace("/second", "/second/seed{train.seed}").replace(
        'train.seed = 0\ndecoder.init = "run:class-b/first/seed1"',
        'train.seed = [1, 0]\nshutter.init = "run:class-{shutter.class}/first/seed{train.seed}"',
    )
    points = read_grid(written(tmp_path, second)).points[2:]
    assert {point.name: [run.name for run in point.after] for point in points} == {
        "class-b/second/seed1": ["class-b/first/seed1"],
        "class-b/second/seed0": ["class-b/first/seed0"],
    }


def test_a_run_of_a_grid_starts_from_the_result_of_another_run(tmp_path: Path) -> None:
    """The settings of the second run name the folder of the first as `init`. All three runs
    succeed."""
    pytest.importorskip("torch")
    written(tmp_path, RUNS)
    rows = swept(tmp_path)
    assert [row["code"] for row in rows] == ["", "", ""]
    second = tmp_path / "out/runs/class-b/second"
    settings = (second / "config.resolved.toml").read_text()
    begun = (tmp_path / "out/runs/class-b/first/seed1").resolve()
    assert f'init = "{begun}"' in settings
    assert not list((tmp_path / "out/runs").glob("first*"))


def test_a_part_is_computed_alone_and_the_table_lists_all_known_rows(tmp_path: Path) -> None:
    """`--part two` computes four points. After `--part stops` the table has all eight. A misspelt
    part is NS0832."""
    two = GRID.partition("[stops]\n")[2].replace("[4, 8]", "[5, 6]")
    written(tmp_path, GRID + "[two]\n" + two)
    whole = invoke(["sweep", "grid.toml", "--out", "out", "--dry-run", "--part", "two"], tmp_path)
    assert whole.out == "4 points: 0 known, 4 to compute\n"
    assert [row["part"] for row in swept(tmp_path, "--part", "two")] == ["two"] * 4
    assert [row["part"] for row in swept(tmp_path, "--part", "stops")] == ["stops"] * 4 + [
        "two"
    ] * 4
    wrong = invoke(["sweep", "grid.toml", "--out", "out", "--part", "too"], tmp_path)
    assert (wrong.status, wrong.codes) == (2, ["NS0832"])
    assert "did you mean `two`" in wrong.err


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ('decoder.init = "run:class-b/first/seed7"', "no run called 'class-b/first/seed7'"),
        ('decoder.init = "run:class-b/second"', "run 'class-b/second' depends on itself"),
        ('decoder.init = "run:{seed}/first"', "no run called 'seed/first'"),
        ('name = "class-b/first/seed1"', "2 runs called 'class-b/first/seed1'"),
        ('name = "../second"', "second.name must be a name"),
        ('name = "/second"', "second.name must be a name"),
        ('like = "third"', "there is no part 'third' above"),
        ('like = "second"', "there is no part 'second' above"),
    ],
)
def test_wrong_links_between_settings_are_refused(tmp_path: Path, changed: str, said: str) -> None:
    key = changed.split(" = ")[0]
    first, second = RUNS.split("[second]")
    lines = [line for line in second.splitlines() if not line.startswith(key)]
    written(tmp_path, f"{first}[second]\n{changed}\n" + "\n".join(lines))
    done = invoke(["sweep", "grid.toml", "--out", "out", "--workers", "0"], tmp_path)
    assert (done.status, done.codes) == (2, ["NS0832"])
    assert said in done.err
    assert not (tmp_path / "out").exists()


def test_a_data_setting_joins_folders_with_plus_and_selects_files_with_a_hash(
    tmp_path: Path,
) -> None:
    for name in ("a/0.png", "a/1.png", "a/2.jpg", "a/3.png", "b/4.png", "c/x/5.png", "c/y/6.png"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()

    def names(text: str) -> list[str]:
        return [path.stem for path in files_in(tmp_path / text, (".png", ".jpg"))]

    assert names("a") == ["0", "1", "2", "3"]
    assert names(f"a+{tmp_path}/b") == ["0", "1", "2", "3", "4"]
    assert names(f"a#1,3/4+{tmp_path}/c/*") == ["1", "3", "5", "6"]
    assert names("a#0/2") == ["0", "2"]
    assert names("none+nor this") == []


def test_the_page_shows_the_example(root: Path) -> None:
    example = (root / "examples/sweep.toml").read_text().partition("\n")[2]
    assert f"```toml\n{example}```" in (root / "docs/sweep.md").read_text()


def test_too_many_points_are_refused(tmp_path: Path) -> None:
    keys = "".join(f"{key} = {[*range(1, 201)]}\n" for key in ("max_words", "slot_us"))
    text = GRID + keys
    with pytest.raises(Rejected, match="at most 100000 are allowed"):
        read_grid(written(tmp_path, text))


def test_two_sweeps_share_the_work(tmp_path: Path) -> None:
    """A point that another process has claimed is waited for, and taken over if that one ends."""
    written(tmp_path, GRID)
    whole = swept(tmp_path)
    known = list(kept(tmp_path).values())
    with store_in(tmp_path / "out") as store:
        store.forget(*(row.key for row in known))
    claims = (
        "import sys, time; from pathlib import Path\n"
        "from nscc_training.sweep.run_sweep import store_in\n"
        "store = store_in(Path('out'))\n"
        "print([store.claim(k) for k in sys.argv[1:]], flush=True)\n"
        "time.sleep(60)"
    )
    other = subprocess.Popen(
        [sys.executable, "-c", claims, *(row.key for row in known[:2])],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        stdout=subprocess.PIPE,
    )
    assert other.stdout is not None
    assert other.stdout.readline() == b"[True, True]\n"
    with ThreadPoolExecutor(1) as pool:
        table = pool.submit(swept, tmp_path)
        while len(kept_apart(tmp_path)) < 2:
            time.sleep(0.02)
        time.sleep(0.5)
        assert kept_apart(tmp_path) == {row.key for row in known[2:]}, "those of the other process"
        other.kill()
        assert table.result(timeout=60) == whole
    other.communicate()


def kept_apart(folder: Path) -> set[str]:
    """The keys in the store as another program reads them: a process has its claims once."""
    with sqlite3.connect(folder / "out/store.sqlite") as database:
        found = {name for (name,) in database.execute("SELECT name FROM measurement")}
    database.close()
    return found


@pytest.mark.parametrize(
    "kind",
    [
        "compile",
        "limits",
        "emulate",
        "train",
        "evaluate",
        "design",
    ],
)
def test_a_complete_part_can_be_read(tmp_path: Path, kind: str) -> None:
    text = invoke(["sweep", "--schema", kind], tmp_path).out
    assert f"[{kind}]" in text
    if kind == "train":  # a run of the defaults
        assert len(read_grid(written(tmp_path, text)).points) == 1
        return
    with pytest.raises(Rejected) as wrong:  # it names nothing to compute yet
        read_grid(written(tmp_path, text))
    assert {each.code for each in wrong.value.diagnostics} == {"NS0832"}


def test_a_dry_run_counts_points_and_parquet_equals_the_table(tmp_path: Path) -> None:
    """A dry run writes no folder and counts five points, none known. After the sweep all five are,
    and a missing figure is null in Parquet."""
    parquet = pytest.importorskip("pyarrow.parquet")
    written(tmp_path, GRID + BITS)
    said = invoke(["sweep", "grid.toml", "--out", "out", "--dry-run"], tmp_path)
    assert said.out == "5 points: 0 known, 5 to compute\n"
    assert not (tmp_path / "out").exists()
    rows = swept(tmp_path, "--parquet")
    table = parquet.read_table(tmp_path / "out/table.parquet").to_pydict()
    assert table["slots"] == [int(row["slots"]) for row in rows]
    assert table["words_total"][-1] is None
    again = invoke(["sweep", "grid.toml", "--out", "out", "--dry-run"], tmp_path)
    assert again.out == "5 points: 5 known, 0 to compute\n"


def test_means_leave_out_items_without_a_finite_score() -> None:
    """The mean of 30, 20 and infinity is 25; of none, 12 and 14 it is 13. Without any score there
    is no mean."""
    from nscc_training.sweep.evaluating import means_of

    items = [
        {"file": "a", "crop": None, "frame": 0, "psnr_db": 30.0, "dark_psnr_db": None},
        {"file": "b", "crop": None, "frame": 0, "psnr_db": 20.0, "dark_psnr_db": 12.0},
        {"file": "b", "crop": None, "frame": 1, "psnr_db": "inf", "dark_psnr_db": 14.0},
    ]
    assert means_of(items) == {"psnr_db": 25.0, "dark_psnr_db": 13.0}
    assert means_of([{"file": "a", "crop": None, "frame": 0, "dark_psnr_db": None}]) == {}


def test_several_threads_can_name_the_links_of_a_sweep_at_once(tmp_path: Path) -> None:
    """Links that belong to another grid are removed."""
    names = [f"point{number}" for number in range(30)]
    keys = {GridPoint("part", "design", name, {}): f"{name:x<20}" for name in names}
    (tmp_path / "points").mkdir()
    for key in keys.values():
        (tmp_path / "points" / f"{key[:16]}.nsl").write_text(key)
    (tmp_path / "programs").mkdir()
    (tmp_path / "programs/old.nsl").symlink_to("../points/old.nsl")
    with ThreadPoolExecutor(8) as pool:
        for _ in pool.map(lambda _: run_sweep._name(tmp_path, keys), range(40)):
            pass
    links = sorted((tmp_path / "programs").iterdir())
    assert [(link.stem, link.read_text()) for link in links] == sorted(
        (point.name, key) for point, key in keys.items()
    )
