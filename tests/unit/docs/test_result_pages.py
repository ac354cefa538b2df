"""Pages of results: what their words stand for, and that the committed pages are what they say."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from checkout import ROOT
from nscc_command import invoke
from recorded import compare_with_recorded

torch = pytest.importorskip("torch")

from small_runs import clip, one_crop, trained  # noqa: E402

from nscc_training.evaluation.paper_tables import paper_tables  # noqa: E402
from nscc_training.evaluation.results import (  # noqa: E402
    compare,
    read_result,
    result_text,
)
from nscc_training.run_files import shipped_evaluations  # noqa: E402
from nscc_training.sweep.grid import read_grid  # noqa: E402
from result_pages import EVALUATIONS, NOT_RUN, Page  # noqa: E402

RESULTS = ROOT / "training/results"
LEARNED = "clips/class-d/learned-from-2x2/unet2d/noise-alone"


def result(scores: dict[str, list[float | str]], **settings: Any) -> dict[str, Any]:
    """A result whose items have these scores, by file."""
    items = [
        {"file": file, "crop": None, "frame": k, "psnr_db": score, "ssim": 0.5}
        for file, values in scores.items()
        for k, score in enumerate(values)
    ]
    return {
        "schema": "nscc-result-1",
        "protocol": "video-v1",
        "protocol_sha256": "1",
        "mean": 0.0,
        "method": "m",
        "items": items,
        "settings": settings,
        "parameters": 487441,
        "data": [{"file": file, "sha256": "2"} for file in scores],
        "also_saturated": [{"saturated_fraction": 0.1, "mean_psnr_db": 12.5, "mean_ssim": 0.9}],
    }


@pytest.fixture
def page(tmp_path: Path) -> Page:
    """The result page of two seeds of a run and of a baseline, `base/line`. Only seed 0 has
    weights. The dict of `result` gives the PSNR in dB of the two windows of each clip."""
    made = {
        "run/seed0": result({"a": [30.0, 32.0], "b": [20.0, "inf"]}, moved=3, places=4, steps=7),
        "run/seed1": result({"a": [31.0, 33.0], "b": [21.0, "inf"]}, moved=0, places=4, steps=7),
        "base/line": result({"a": [29.0, 30.0], "b": [20.5, 10.0]}, stops=[[8]]),
    }
    made["every-effect/run/seed1"] = made["run/seed1"]
    for name, found in made.items():
        path = tmp_path / f"evaluations/{name}.json"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(found))
        if name.startswith("run/"):
            (tmp_path / "runs" / name).mkdir(parents=True)
    (tmp_path / "runs/run/seed0/decoder.safetensors").touch()
    return Page(tmp_path / "evaluations")


def test_a_template_shows_the_validation_score_of_a_run(page: Page) -> None:
    told = {"headline": {"effects": "all", "psnr_db": 31.256}}
    (page.results.parent / "runs/run/seed1/result.json").write_text(json.dumps(told))
    assert page.filled("{{validated runs/run/seed1}} dB") == "31.26 dB"
    assert page.filled("{{validated shipped/run}}") == NOT_RUN


def test_templates_are_filled_with_means_and_values(page: Page) -> None:
    # The mean over the windows whose PSNR is finite, for each seed; then over the seeds.
    assert page.filled("a {{mean run/* psnr_db}} b") == f"a {(82 / 3 + 85 / 3) / 2:.2f} b"
    # First over the windows of each clip, then over clips: (31 + 20) / 2 and (32 + 21) / 2.
    assert page.filled("{{mean run/* psnr_db/source}}") == "26.00"
    assert page.filled("{{mean run/* ssim}}") == "0.500"
    # @0.1: the score at light that saturates 10 % of the pixels, from `also_saturated`.
    assert page.filled("{{mean run/* psnr_db@0.1}}") == "12.50"
    assert page.filled("{{value base/line stops}}, {{value run/* moved}}") == "8, 3 of 4, 0 of 4"
    assert page.filled("{{value base/line items}}") == "4 windows from 2 clips"
    assert page.filled("{{mean other psnr_db}}") == "not run"
    pairs = [
        (read_result(page.results / "base/line.json"), read_result(path))
        for path in sorted((page.results / "run").iterdir())
    ]
    found = compare(pairs)
    low, high = found["ci95"]
    gain = f"{found['gain_db']:+.2f} ({low:+.2f} to {high:+.2f})"
    assert page.filled("{{gain base/line run/* psnr_db}}") == gain
    row = page.filled('{{row "a label" run/seed0 psnr_db/interval = parameters base/line:ssim}}')
    assert (
        row == "| a label | 27.33 (20.00 to 31.00) |  | 0.49 million | +0.000 (+0.000 to +0.000) |"
    )
    columns = page.filled("{{columns c psnr_db+ssim run/seed0 base/line@0.1 none}}")
    assert columns.startswith("| c | 27.33 / 0.500 | 12.50 / ")


def test_rows_of_runs_without_weights_have_a_dagger(page: Page) -> None:
    without = "run/seed1", "run/*", "every-effect/run/seed1"
    for name, mark in {"run/seed0": "", "base/line": "", **dict.fromkeys(without, " †")}.items():
        assert page.filled(f"{{{{row r {name} psnr_db}}}}").startswith(f"| r{mark} | ")


@pytest.mark.parametrize(
    "wrong",
    [
        "nonsense",
        "mean run/seed0",
        "mean run/seed0 snr",
        "mean run/* psnr_db/film",
        "value run/* stops",
        "_found run/*",
    ],
)
def test_a_wrong_template_is_refused(page: Page, wrong: str) -> None:
    with pytest.raises(ValueError, match=wrong.split()[0]):
        page.filled(f"{{{{{wrong}}}}}")


def test_tables_of_the_paper_use_the_shipped_results(tmp_path: Path) -> None:
    done = invoke(["evaluate", "tables", "--json", "-o", "t.json"], tmp_path)
    assert done.status == 0, done.err
    rows = json.loads(done.out)
    assert rows == json.loads((tmp_path / "t.json").read_text())
    assert {row["table"] for row in rows} == {2, 3, 4}
    assert all(row["psnr_db"] is not None for row in rows)
    paper = {(row["table"], row["row"]): (row["paper_psnr_db"], row["paper_ssim"]) for row in rows}
    # PSNR in dB and SSIM as they are printed in tables 2 to 4 of Martel et al. (2020).
    assert paper[2, "learned code, U-Net"] == (35.42, 0.9464)
    assert paper[3, "3D U-Net, e learned"] == (33.56, 0.9374)
    assert paper[4, "dictionary, e random"] == (26.22, 0.7258)
    learned = [read_result(shipped_evaluations() / LEARNED / f"seed{k}.json") for k in range(3)]
    [row] = [row for row in rows if row["row"] == "2D U-Net, d learned"]
    assert row["psnr_db"] == pytest.approx(sum(each["mean"] for each in learned) / 3)
    assert row["remark"] == ""  # learning moved nothing
    assert row["seeds"] == [0, 1, 2]
    human = invoke(["evaluate", "tables"], tmp_path).out
    assert human.count("\n| ") == len(rows) + 3


def test_tables_of_an_empty_folder_say_not_run(tmp_path: Path) -> None:
    (tmp_path / "none").mkdir()
    human = invoke(["evaluate", "tables", "--results", "none"], tmp_path).out
    assert human.count("not run") == len(paper_tables()[0])
    assert "NS0807" in invoke(["evaluate", "tables", "--results", "nowhere"], tmp_path).err


@pytest.mark.slow
def test_a_sweep_fills_the_tables(tmp_path: Path) -> None:
    """Runs and baselines of a grid, under the names that tables know."""
    (tmp_path / "data").mkdir()
    one_crop(tmp_path / "data/p.hdr")
    trained(tmp_path / "mine", shutter={"slots": 256, "tile": [2, 2]})
    (tmp_path / "grid.toml").write_text(
        'kind = "evaluate"\n[base]\nname = "hdr-v1/{subject}"\nsubject = "ldr"\ndata = "data"\n'
        '[run]\nname = "stills/class-b/learned-from-2x2/unet2d/noise-alone/seed0"\n'
        'subject = "mine"\ndata = "data"\n'
    )
    swept = invoke(["sweep", "grid.toml", "--out", "out", "--workers", "0"], tmp_path)
    assert swept.status == 0, swept.err
    done = invoke(["evaluate", "tables", "--results", "out", "--json"], tmp_path)
    there = {row["row"]: row for row in json.loads(done.out) if row["psnr_db"] is not None}
    assert set(there) == {"no coding (LDR)", "learned code, U-Net"}
    asked = ["evaluate", "mine", "--data", "data", "--protocol", "hdr-v1", "--json"]
    alone = json.loads(invoke(asked, tmp_path).out)
    assert there["learned code, U-Net"]["psnr_db"] == pytest.approx(alone["mean"])


@pytest.mark.parametrize(
    ("name", "page"),
    [
        ("README.md", RESULTS / "README.md"),
        ("details.md", RESULTS / "details.md"),
        ("paper.md", RESULTS.parents[1] / "docs/paper.md"),
    ],
)
def test_a_committed_page_equals_the_page_made_from_results(name: str, page: Path) -> None:
    template = (RESULTS / "templates" / name).read_text(encoding="utf-8")
    text = Page(RESULTS / "evaluations").filled(template)
    assert text == page.read_text(encoding="utf-8"), (
        f"python docs/result_pages.py training/results/templates/{name} > {page}"
    )
    assert "not run" not in text


def test_the_experiment_defines_every_run_and_every_evaluation() -> None:
    grid = read_grid(RESULTS / "experiment.toml")
    runs = {point.name for point in grid.points if point.kind == "train"}
    rows = {point.name for point in grid.points if point.kind == "evaluate"}
    folders = {
        folder: {
            path.parent.relative_to(RESULTS / folder).as_posix()
            for path in (RESULTS / folder).rglob("config.resolved.toml")
        }
        for folder in ("runs", "shipped")
    }
    assert folders["runs"] | folders["shipped"] == runs
    assert not folders["runs"] & folders["shipped"]
    kept = RESULTS / "evaluations"
    assert {
        path.relative_to(kept).with_suffix("").as_posix() for path in kept.rglob("*.json")
    } == rows


TEXTS = (
    "every-effect/shipped/clips/class-d/learned-from-2x2/unet2d/every-effect/seed0",
    "every-effect/shipped/stills/class-b/learned-from-2x2/unet2d/noise-alone/seed0",
    "classes/class-d/learned-from-2x2/classifier/seed0",
    "deblur-v1/long",
    "codes-v1/c-quad",
    "hdr-v1/any",
)


def test_texts_of_shipped_results_are_as_recorded(update_cases: bool) -> None:
    shown = "\n".join(
        result_text(read_result(shipped_evaluations() / f"{name}.json")) for name in TEXTS
    )
    compare_with_recorded(shown, "commands/results", update_cases)


def test_texts_of_pixels_that_look_name_no_training() -> None:
    for path in (shipped_evaluations() / "looks").rglob("*.json"):
        line = result_text(read_result(path)).splitlines()[1]
        assert line.startswith("  on a chip with effects ")
        assert "trained" not in line


def test_means_by_source_are_printed_if_one_file_dominates() -> None:
    found = read_result(shipped_evaluations() / LEARNED / "seed0.json")
    assert result_text(found).count("by source 29.02 dB: 68 of 94 items are of one file") == 1
    still = shipped_evaluations() / "stills/class-b/2x2/unet2d/noise-alone/seed0.json"
    assert "by source" not in result_text(read_result(still))  # every panorama has four crops


def test_baselines_record_the_codes_that_they_were_run_on(tmp_path: Path) -> None:
    """GAP-TV on the 2 x 2 pattern is not GAP-TV on random bits, and results say which is which."""
    clip(tmp_path / "c.mat", 16, 256)
    line = ["evaluate", "gap-tv", "--data", ".", "--protocol", "video-v1", "--json"]
    quad = json.loads(invoke([*line, "--shutter", "c:quad"], tmp_path).out)
    assert quad["settings"]["shutter"] == "c:quad"
    assert quad["settings"]["words_per_slot"] > 0
    assert {start for row in quad["settings"]["start"] for start in row} == {0, 4, 8, 12}
    for subject, codes in (("gap-tv", "b:quad"), ("thin-out", "c:quad"), ("gap-tv", "c:no")):
        wrong = ["evaluate", subject, *line[2:], "--shutter", codes]
        assert "NS0840" in invoke(wrong, tmp_path).err


def test_the_codes_of_a_run_without_weights_can_be_evaluated(tmp_path: Path) -> None:
    clip(tmp_path / "c.mat", 16, 112)
    run = RESULTS / "runs/clips/class-e/searched-from-random/any/four-words/seed0"
    line = ["evaluate", "any", "--data", ".", "--protocol", "codes-v1", "--json", "--shutter"]
    done = invoke([*line, str(run)], tmp_path)
    assert done.status == 0, done.err
    found = json.loads(done.out)
    told = json.loads((run / "result.json").read_text())
    assert found["settings"]["words_per_slot"] == told["words_per_slot"]


def test_every_result_of_the_sites_page_is_stored() -> None:
    template = (ROOT / "docs/nscc_site/results.template").read_text()
    charts = template.count("```chart ")
    filled = Page(EVALUATIONS).filled(template)
    assert charts == 5
    assert "{{" not in filled
    assert NOT_RUN not in filled
