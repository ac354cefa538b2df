"""Options and kinds of points that other tests leave at their defaults: each changes its result as
its help says."""

from __future__ import annotations

import csv
import io
import json
import shlex
from pathlib import Path

import numpy as np
import pytest
from nscc_command import Outcome, invoke
from PIL import Image

pytest.importorskip("torch")

from small_runs import clip

from nscc.editing.document import Document
from nscc.editing.hover import hover
from nscc_training.baselines import dictionary

CONFIG = """[shutter]
slots = 8
tile = [2, 2]
[data]
patch = 16
scenes = 2
val_items = 1
[train]
steps = 2
batch = 1
validate_every = 1
"""


def run(line: str, folder: Path, status: int = 0) -> Outcome:
    outcome = invoke(shlex.split(line), folder)
    assert outcome.status == status, outcome.err
    return outcome


def table(folder: Path, grid: str, *more: str) -> list[dict[str, str]]:
    """The rows of a sweep in this process."""
    (folder / "grid.toml").write_text(grid)
    line = ["sweep", "grid.toml", "--out", "out", "--workers", "0", *more]
    outcome = invoke(line, folder)
    assert outcome.status == 0, outcome.err
    return list(csv.DictReader(io.StringIO((folder / "out/table.csv").read_text())))


def test_points_of_kind_limits_name_the_largest_program_that_builds(tmp_path: Path) -> None:
    grid = '[bits]\nkind = "limits"\nfamily = "e"\ntarget = "scamp5"\nlevel = 0\n'
    (row,) = table(tmp_path, grid)
    built = int(row["built_up_to"])
    rule = "code bits : bit[N]\nopen when bits[n]\n"
    for slots, status in ((built, 0), (built + 1, 1)):
        (tmp_path / "p.nsl").write_text(f"nsl 1\nframe {slots} slots of 1ms\n{rule}")
        run("build p.nsl -O 0 --codes open --target scamp5 -o p.icw", tmp_path, status)


def test_points_of_kind_design_leave_programs(tmp_path: Path) -> None:
    """Designs of two and three looks each leave a program that passes `nscc check`."""
    grid = (
        '[looks]\nkind = "design"\nscene = "builtin:hdr"\nlooks = [2, 3]\nslots = 16\nlevel = 0\n'
    )
    few, many = table(tmp_path, grid)
    assert (few["code"], many["code"]) == ("", "")
    programs = sorted((tmp_path / "out/programs").iterdir())
    assert len(programs) == 2
    for path in programs:
        run(f"check {path}", tmp_path)


def test_points_of_kind_evaluate_have_the_scores_of_the_command_evaluate(tmp_path: Path) -> None:
    (tmp_path / "clips").mkdir()
    clip(tmp_path / "clips/a.mat", 8, 32)
    grid = (
        '[sci]\nkind = "evaluate"\nsubject = "gap-tv"\nprotocol = "sci8"\ndata = "clips"\n'
        "iterations = 2\nweight = [0.05, 2.0]\n"
    )
    weak, strong = table(tmp_path, grid)
    for row in (weak, strong):
        line = f"evaluate sci8 clips/a.mat --iterations 2 --weight {row['weight']} --json"
        items = json.loads(run(line, tmp_path).out)["items"]
        mean = np.mean([item["psnr_db"] for item in items])
        assert float(row["psnr_db"]) == pytest.approx(mean, abs=1e-3)
    assert weak["psnr_db"] != strong["psnr_db"]


def test_a_sweep_with_another_number_of_threads_trains_its_points_again(tmp_path: Path) -> None:
    """A second sweep with one thread trains nothing. With two threads the point is trained
    again."""
    import torch

    before = torch.get_num_threads()
    (tmp_path / "c.toml").write_text(CONFIG)
    grid = '[run]\nkind = "train"\nconfig = "c.toml"\n'
    try:
        for threads, count in ((1, 1), (1, 1), (2, 2)):
            table(tmp_path, grid, "--threads", str(threads))
            assert torch.get_num_threads() == threads or count == 1
            assert len(list((tmp_path / "out/points").iterdir())) == count
    finally:
        torch.set_num_threads(before)


def test_resume_continues_restarts_or_copies_another_run(tmp_path: Path) -> None:
    """`never` writes the same log anew, `--resume a` gives the weights of `a`, and a missing folder
    gives NS0816."""
    (tmp_path / "c.toml").write_text(CONFIG)
    run("train c.toml --out a", tmp_path)
    log = (tmp_path / "a/metrics.csv").read_bytes()
    weights = (tmp_path / "a/decoder.safetensors").read_bytes()
    (tmp_path / "a/metrics.csv").write_bytes(b"changed")
    run("train c.toml --out a --resume never", tmp_path)
    assert (tmp_path / "a/metrics.csv").read_bytes() == log
    run("train c.toml --out b --resume a", tmp_path)
    assert (tmp_path / "b/decoder.safetensors").read_bytes() == weights
    assert "NS0816" in run("train c.toml --out d --resume nowhere", tmp_path, 2).err


def test_the_option_first_leaves_out_earlier_frames_of_a_clip(tmp_path: Path) -> None:
    """`--first 2` gives the light of a clip without the first two frames."""
    frames = [np.full((256, 256, 3), 40 * k + 20, np.uint8) for k in range(5)]
    for name, shown in (("all", frames), ("late", frames[2:])):
        first, *others = map(Image.fromarray, shown)
        first.save(tmp_path / f"{name}.gif", save_all=True, append_images=others)
    (tmp_path / "p.nsl").write_text("nsl 1\nframe 2 slots of 1ms\nopen when true\n")
    options = "--fps 1000 --exposure 1000 --keep light"
    run(f"run p.nsl --scene all.gif --first 2 {options} -o a.npz", tmp_path)
    run(f"run p.nsl --scene late.gif {options} -o b.npz", tmp_path)
    run(f"run p.nsl --scene all.gif {options} -o c.npz", tmp_path)
    light = [np.load(tmp_path / f"{name}.npz")["light"] for name in "abc"]
    np.testing.assert_array_equal(light[0], light[1])
    assert not np.array_equal(light[0], light[2])


def test_a_given_crosstalk_replaces_the_measured_one(tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text("nsl 1\nframe 4 slots of 1ms\nopen when true\n")
    for electrons in (0, 4000, 12000):
        line = f"--scene builtin:flat:{electrons} --effects shot,adc_noise --repeat 8"
        run(f"run p.nsl {line} -o level{electrons}.npz", tmp_path)
    levels = "calibrate level4000.npz level12000.npz --dark level0.npz -o out.toml"
    for known in ("0.05", "0"):
        run(f"{levels} --crosstalk {known}", tmp_path)
        text = (tmp_path / "out.toml").read_text()
        (value,) = [
            line.split("=")[1].split("#")[0]
            for line in text.splitlines()
            if line.startswith("crosstalk_fraction")
        ]
        assert float(value) == float(known)


def test_a_design_stays_within_its_words(tmp_path: Path) -> None:
    """A limit of 40 words gives another design than no limit. No design takes 0.5 words, so no file
    is written."""
    line = "design --motion fast --slots 16 -O 0"
    run(f"{line} --max-words 40 -o many.nsl", tmp_path)
    run(f"{line} -o usual.nsl", tmp_path)
    assert (tmp_path / "many.nsl").read_text() != (tmp_path / "usual.nsl").read_text()
    assert invoke(shlex.split(f"{line} --max-words 0.5 -o few.nsl"), tmp_path).status != 0
    assert not (tmp_path / "few.nsl").exists()


def test_a_dictionary_of_made_scenes_is_the_same_each_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """Twelve atoms of length 1 are learned twice with equal values."""
    monkeypatch.setattr(dictionary, "ATOMS", 12)
    atoms = dictionary.made_dictionary.__wrapped__(2)
    assert atoms.shape == (2 * dictionary.SIDE**2, 12)
    np.testing.assert_allclose(np.linalg.norm(atoms, axis=0), 1, atol=1e-6)
    np.testing.assert_array_equal(dictionary.made_dictionary.__wrapped__(2), atoms)


def test_a_dictionary_of_another_seed_is_another() -> None:
    """Seed 3 gives equal atoms twice, and seed 4 others."""
    blocks = np.random.default_rng(1).random((40, 6))
    atoms = [dictionary.learned(blocks, 5, 2, 1, seed) for seed in (3, 3, 4)]
    np.testing.assert_array_equal(atoms[0], atoms[1])
    assert not np.array_equal(atoms[0], atoms[2])


@pytest.mark.parametrize(
    ("rule", "told"),
    [
        ("n < stop", "3 shutters, open in 1 to 3 of 4 slots."),
        ("n < 2 and stop > 0", "1 shutter, open in 2 of 4 slots."),
    ],
)
def test_hovering_over_a_bucket_tells_how_long_it_is_open(rule: str, told: str) -> None:
    text = f"nsl 1\nframe 4 slots of 1ms\ncode stop : 1..3\nbucket a open when {rule}\n"
    found = hover(Document("a.nsl", text, Path()), text.index("a open"))
    assert found is not None
    assert told in found.text


@pytest.mark.parametrize(
    ("line", "option"),
    [
        ("run p.nsl --scene builtin:dark --patience 3", "--patience"),
        ("run p.nsl --scene builtin:dark --skip", "--skip"),
        ("run p.nsl --scene light.npy --skip", "--skip"),
        ("run p.nsl --scene '*.png' --bracket --skip", "--skip"),
        ("design --looks 3 --scene builtin:hdr --max-words 4", "--max-words"),
        ("evaluate sci8 a.mat --method adjoint --iterations 3", "--iterations"),
        ("evaluate sci8 a.mat --method adjoint --weight 0.2", "--weight"),
    ],
)
def test_options_without_effect_are_refused(line: str, option: str, tmp_path: Path) -> None:
    invoke(["new", "p"], tmp_path)
    np.save(tmp_path / "light.npy", np.ones((256, 256), np.float32))
    outcome = run(line, tmp_path, 2)
    assert outcome.err.count(f"leave {option} out") == 1
