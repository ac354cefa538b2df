"""The paper's tables: which rows there are, whose results stand in them, and what was not run."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from nscc_command import invoke

torch = pytest.importorskip("torch")

from small_runs import SMALL, clip, one_crop, trained  # noqa: E402

from nscc_training.baselines import sparse_coding  # noqa: E402
from nscc_training.config import settings_of  # noqa: E402
from nscc_training.evaluation.result_text import result_text  # noqa: E402
from nscc_training.evaluation.results import mean_of  # noqa: E402
from nscc_training.evaluation.tables import ROWS, key_of, tables, text_of  # noqa: E402
from nscc_training.run_files import shipped_evaluations  # noqa: E402


def test_tables_have_every_row_and_say_what_was_not_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "d/hdr").mkdir(parents=True)
    one_crop(tmp_path / "d/hdr/p.hdr")
    # sparse coding takes seconds a crop, and has tests of its own
    monkeypatch.setattr(sparse_coding, "coded_still", lambda _frame, _share, made, *_: made)
    (tmp_path / "runs").mkdir()
    for seed in (0, 1):
        shutter = {"slots": 256, "tile": [2, 2], "init": "quad", "learn": False}
        trained(tmp_path / f"runs/{seed}", shutter=shutter,
                train={**SMALL["train"], "seed": seed})  # fmt: skip
    # of the same key, but not what the protocols expose: no seeds of these rows
    trained(tmp_path / "runs/short", shutter={**shutter, "slots": 64},
            train={**SMALL["train"], "seed": 7})  # fmt: skip
    clips = {"class": "c", "slots": 8, "tile": [2, 2], "init": "quad", "learn": False}
    trained(tmp_path / "runs/clips", shutter=clips, decoder={"name": "unet3d"},
            data={**SMALL["data"], "protocol": "video-v1"})  # fmt: skip
    arguments = ["evaluate", "tables", "--data", "d", "--runs", "runs"]
    outcome = invoke([*arguments, "--json", "-o", "t.json"], tmp_path)
    assert outcome.status == 0, outcome.err
    rows = json.loads(outcome.out)
    assert rows == json.loads((tmp_path / "t.json").read_text())
    assert [sum(row["table"] == k for row in rows) for k in (2, 3, 4)] == [9, 18, 9]
    paper = {(row["table"], row["row"]): (row["paper_psnr_db"], row["paper_ssim"]) for row in rows}
    assert paper[2, "learned code, U-Net"] == (35.42, 0.9464)
    assert paper[3, "3D U-Net, e learned"] == (33.56, 0.9374)
    assert paper[4, "dictionary, e random"] == (26.22, 0.7258)
    (eight,) = (row for row in rows if row["row"] == "3D U-Net, c fixed")
    assert (eight["remark"], eight["seeds"]) == (
        "not run: no run of unet3d, class c, codes quad; the 2 x 2 pattern",
        [],
    )
    ours = next(row for row in rows if row["row"] == "2 x 2 pattern, U-Net")
    assert (ours["seeds"], ours["steps"], ours["size"]) == ([0, 1], 2, "small")
    each = [
        json.loads(
            invoke(["evaluate", f"runs/{seed}", "--data", "d/hdr", "--protocol", "hdr-v1",
                    "--json"], tmp_path).out
        )["mean"]
        for seed in (0, 1)
    ]  # fmt: skip
    assert ours["psnr_db"] == pytest.approx(sum(each) / 2)
    for row in rows:
        assert (row["psnr_db"] is None) == ("not run" in row["remark"])
    assert text_of(rows).count("not run") == sum("not run" in row["remark"] for row in rows)
    (tmp_path / "none").mkdir()
    human = invoke(["evaluate", "tables", "--data", "none"], tmp_path).out
    assert human.count("not run") == len(rows)


@pytest.mark.parametrize(
    ("decoder", "shutter", "name"),
    [
        ("unet2d", {"class": "d", "learn": False, "init": "random"}, "2D U-Net, d random"),
        ("unet2d", {"class": "d"}, "2D U-Net, d learned"),
        ("unet2d", {"class": "d", "learn": False}, "2D U-Net, d, 2 x 2 pattern"),
        ("unet3d", {"class": "d", "learn": False, "init": "random"}, "3D U-Net, d random"),
        ("unet3d", {"class": "d"}, "3D U-Net, d learned"),
        ("unet3d", {"class": "d", "learn": False}, "3D U-Net, d, 2 x 2 pattern"),
        ("unet3d", {"class": "codebook"}, "3D U-Net, codebook learned"),
        ("unet3d", {"class": "codebook", "words_weight": 0.1},
         "3D U-Net, codebook, words in the loss"),
        ("unrolled", {"class": "d"}, None),
        ("unet2d", {"class": "e", "learn": False, "init": "random"}, None),
    ],
)  # fmt: skip
def test_rows_of_our_own(decoder: str, shutter: dict[str, Any], name: str | None) -> None:
    key = key_of(settings_of({"decoder": {"name": decoder}, "shutter": shutter}))
    found = [row for row in ROWS if row.table == 3 and row.key == key]
    assert [row.name for row in found] == ([name] if name else [])
    assert all(row.paper is None for row in found)
    narrow = key_of(settings_of({"decoder": {"name": decoder, "width": 0.5}, "shutter": shutter}))
    assert narrow not in {row.key for row in ROWS}


def test_a_run_of_two_rows_is_evaluated_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """FC-net with learned class c stands in Tables 3 and 4."""
    run = trained(
        tmp_path / "runs/c", shutter={"class": "c", "slots": 16, "tile": [4, 4]},
        decoder={"name": "fcnet"}, data={**SMALL["data"], "protocol": "video-v1"},
    )  # fmt: skip
    (tmp_path / "d").mkdir()
    clip(tmp_path / "d/c.mat", 16, 256)
    asked = []

    def evaluated(
        subject: str, data: Path, protocol: str, seed: int, codes: str
    ) -> tuple[dict[str, Any], Any]:
        asked.append((subject, codes))
        settings = {"row": ["fcnet", "c", "learned"], "config_sha256": "1"}
        return {
            "protocol": protocol, "method": subject, "protocol_sha256": "2",
            "items": [{"file": "c.mat", "ssim": 0.5, "psnr_db": 20.0}],
            "settings": settings if subject == str(run) else {"shutter": codes},
            "data": [{"file": "c.mat"}],
        }, {}  # fmt: skip

    monkeypatch.setattr("nscc_training.evaluation.tables.evaluate", evaluated)
    rows = tables(tmp_path / "d", tmp_path / "runs")
    assert [row["psnr_db"] for row in rows if row["row"] == "FC-net, c learned"] == [20.0, 20.0]
    assert asked.count((str(run), "")) == 1
    assert len(asked) == len(set(asked))


def test_tables_of_runs_whose_weights_were_not_kept(tmp_path: Path) -> None:
    """Their rows say so, and results of them that were kept are taken; others are evaluated."""
    sections = {"shutter": {"class": "c", "slots": 16, "tile": [4, 4]},
                "decoder": {"name": "fcnet"}, "data": {"protocol": "video-v1"}}  # fmt: skip
    whole = trained(tmp_path / "runs/whole", **sections)
    bare = trained(tmp_path / "runs/bare", **sections, train={"seed": 5})
    (tmp_path / "d/video").mkdir(parents=True)
    clip(tmp_path / "d/video/c.mat", 16, 256)
    (tmp_path / "kept").mkdir()
    kept = invoke(["evaluate", str(bare), "--data", "d/video", "--protocol", "video-v1", "-o",
                   "kept/bare.json"], tmp_path)  # fmt: skip
    assert kept.status == 0, kept.err
    (bare / "decoder.safetensors").unlink()

    def row_of(results: Path | None) -> dict[str, Any]:
        (row,) = (row for row in ROWS if row.name == "FC-net, c learned" and row.table == 3)
        (found,) = tables(tmp_path / "d", tmp_path / "runs", results, lambda _: [row])
        return found

    partly = row_of(None)
    assert partly["seeds"] == [0]
    assert f"'{bare}' is no finished run" in partly["remark"]
    assert "decoder.safetensors" in partly["remark"]
    both = row_of(tmp_path / "kept")
    assert both["seeds"] == [0, 5]
    assert both["remark"].startswith("places moved: ")
    (whole / "decoder.safetensors").unlink()
    none = row_of(None)
    assert none["psnr_db"] is None
    assert none["remark"].startswith("not run: '")


def test_tables_without_arguments_are_of_what_is_shipped(tmp_path: Path) -> None:
    outcome = invoke(["evaluate", "tables", "--json"], tmp_path)
    assert outcome.status == 0, outcome.err
    rows = json.loads(outcome.out)
    shown = {row["row"]: row for row in rows if row["psnr_db"] is not None}
    learned = [json.loads((shipped_evaluations() / f"vid_learned_{k}.json").read_text())
               for k in range(3)]  # fmt: skip
    row = shown["2D U-Net, d learned"]
    assert row["psnr_db"] == pytest.approx(sum(each["mean"] for each in learned) / 3)
    assert row["remark"] == "places moved: 0 of 64, 0 of 64, 0 of 64"
    # Beside it lie results of the same decoder on other codes, of a window of each clip.
    any_code = json.loads((shipped_evaluations() / "any.json").read_text())
    assert shown["the decoder for any code, e random"]["psnr_db"] == any_code["mean"]
    by_file: dict[str, list[float]] = {}
    for item in learned[0]["items"]:
        by_file.setdefault(item["file"], []).append(item["psnr_db"])
    wanted = sum(sum(values) / len(values) for values in by_file.values()) / len(by_file)
    assert mean_of(learned[:1], "psnr_db", by_source=True) == pytest.approx(wanted)
    assert all("not run" in row["remark"] for row in rows if row["psnr_db"] is None)
    runs = invoke(["evaluate", "tables", "--runs", "r"], tmp_path)
    assert "--data" in runs.err


def test_one_long_film_does_not_hide_the_others() -> None:
    found = json.loads((shipped_evaluations() / "vid_learned_0.json").read_text())
    assert result_text(found).count("by source 29.02 dB: 68 of 94 items are of one file") == 1
    still = json.loads((shipped_evaluations() / "hdr_learned_0.json").read_text())
    assert "by source" not in result_text(still)  # every panorama has four crops


def test_results_under_effects_stand_in_no_table(tmp_path: Path) -> None:
    """What a chip costs is not what the protocol's sensor gives: rows do not mix the two."""
    name = "vid_learned_0.json"
    found = json.loads((shipped_evaluations() / name).read_text())
    (tmp_path / name).write_text(json.dumps(found))
    chip = {**found, "mean": 1.0, "settings": {**found["settings"], "effects": "all"}}
    for item in chip["items"]:
        item["psnr_db"] = 1.0
    (tmp_path / "chip.json").write_text(json.dumps(chip))
    [row] = [row for row in tables(results=tmp_path) if row["row"] == "2D U-Net, d learned"]
    assert row["psnr_db"] > 30


def test_decoders_of_two_sizes_do_not_share_a_row(tmp_path: Path) -> None:
    """Their mean would be nobody's figure: small decoders come first, each with its own."""
    for size, psnr_db in (("paper", 33.0), ("small", 31.0)):
        found = json.loads((shipped_evaluations() / "u3_c_quad.json").read_text())
        found["settings"]["size"] = size
        for item in found["items"]:
            item["psnr_db"] = psnr_db
        (tmp_path / f"{size}.json").write_text(json.dumps(found))
    rows = [row for row in tables(results=tmp_path) if row["row"] == "3D U-Net, c fixed"]
    assert [(row["size"], row["psnr_db"]) for row in rows] == [("small", 31.0), ("paper", 33.0)]


def test_baselines_on_other_codes(tmp_path: Path) -> None:
    """GAP-TV on the 2 x 2 pattern is not GAP-TV on random bits, and rows know which is which."""
    clip(tmp_path / "c.mat", 16, 256)
    line = ["evaluate", "gap-tv", "--data", ".", "--protocol", "video-v1", "--json"]
    quad = json.loads(invoke([*line, "--shutter", "c:quad"], tmp_path).out)
    assert quad["settings"]["shutter"] == "c:quad"
    assert {start for row in quad["settings"]["start"] for start in row} == {0, 4, 8, 12}
    for subject, codes in (("gap-tv", "b:quad"), ("thin-out", "c:quad"), ("gap-tv", "c:no")):
        wrong = ["evaluate", subject, *line[2:], "--shutter", codes]
        assert "NS0840" in invoke(wrong, tmp_path).err
