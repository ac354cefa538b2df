"""From a picture to pictures: `nscc demo` and the commands that it names, step by step."""

from __future__ import annotations

import io
import re
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import cv2
import numpy as np
import pytest
from checkout import ROOT
from nscc_command import RunNscc
from PIL import Image
from recorded import compare_with_recorded

from nscc.diagnostics.diagnostic import Rejected
from nscc.examples import START, about, examples
from nscc_runtime.pictures import images
from nscc_training import views
from nscc_training.demo.sheet import Shown, _decoder_text
from nscc_training.demo.subject import liveliest
from nscc_training.metrics import mu_psnr
from nscc_training.run_files import run_capture, shipped_runs

pytest.importorskip("torch")

from small_runs import trained

EVALUATIONS = ROOT / "training/results/evaluations"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("demo")
    rng = np.random.default_rng(2)
    small = cv2.resize(rng.uniform(0, 255, (9, 12, 3)).astype(np.float32), (400, 300))
    Image.fromarray(np.clip(small, 0, 255).astype(np.uint8)).save(found / "photo.jpg")
    frames = [
        Image.fromarray(np.roll(small[::2, ::2].astype(np.uint8), 9 * k, 1)) for k in range(5)
    ]
    frames[0].save(found / "short.gif", save_all=True, append_images=frames[1:])
    Image.new("L", (90, 60)).save(found / "black.png")
    return found


def test_a_photo_becomes_a_sheet_and_a_picture(
    folder: Path, run_nscc: RunNscc, monkeypatch: pytest.MonkeyPatch, update_cases: bool
) -> None:
    """The numbers on the sheet equal those in its files, and the printed commands make the same
    files."""
    drawn = []

    def image_sheet(rows: list[list[images.Image]], title: str, *arguments: Any) -> Any:
        drawn.append([[image.title for image in row] for row in rows])
        compare_with_recorded(
            panels_of(rows, title), "figures/a_demo", update_cases, share=0.01, spare=0.2
        )
        return images.image_sheet(rows, title, *arguments)

    monkeypatch.setattr("nscc_training.demo.sheet.image_sheet", image_sheet)
    outcome = run_nscc(["demo", "photo.jpg", "-o", "out", "--tone", "log"], folder)
    assert outcome.status == 0, outcome.err
    ((first, looked, coded),) = drawn
    assert first == ["truth", "an ordinary camera", "error"]
    assert looked == ["pixels that look", "error", "when they closed"]
    assert coded[:2] == ["reconstruction", "error"]
    made = folder / "out"
    left = {
        "picture_sheet.png",
        "picture.hdr",
        "picture.png",
        "picture_frame.npz",
        "picture_dark.npz",
    }
    assert {path.name for path in made.iterdir()} == left
    with Image.open(made / "picture.png") as picture:
        assert picture.size == (256, 192)
    before = {path.name: path.read_bytes() for path in made.iterdir()}
    lines = [line.strip() for line in outcome.err.splitlines() if line.startswith("  nscc ")]
    assert [line.split()[1] for line in lines] == ["run", "run", "reconstruct"]
    for line in lines:
        assert run_nscc(line.split()[1:], folder).status == 0
    assert (made / "picture.hdr").read_bytes() == before["picture.hdr"]
    (made / "picture_frame.npz").write_bytes(before["picture_frame.npz"])
    line = ["reconstruct", "any", "out/picture_frame.npz", "--dark", "out/picture_dark.npz"]
    outcome = run_nscc([*line, "-o", "any.npz"], folder)
    assert outcome.status == 0, outcome.err
    with np.load(folder / "any.npz") as found:
        assert found["image"].shape[:2] == (192, 256)
    with np.load(made / "picture_frame.npz") as now:
        assert now["frame"].shape == (1, 192, 256)


def panels_of(rows: list[list[images.Image]], title: str) -> str:
    """The texts of a sheet, without times of this machine, and means of its pictures."""
    lines = [title]
    for image in (image for row in rows for image in row):
        values = np.asarray(image.values, float)
        sides = (values[: len(values) // 2], values[:, : values.shape[1] // 2])
        means = " ".join(f"{part.mean():.4f}" for part in (values, *sides))
        note = re.sub(r"[0-9.e-]+\N{NO-BREAK SPACE}s", "some s", image.note)
        lines.append(f"{image.title}: {note}: {values.shape} means {means}")
    return "\n".join(lines) + "\n"


def test_light_of_high_range_is_counted_as_protocols_do(folder: Path, run_nscc: RunNscc) -> None:
    outcome = run_nscc(["demo", "builtin:hdr", "-o", "lake"], folder)
    said = float(outcome.err.split("reconstructed ")[1].split(" dB")[0])
    with np.load(folder / "lake/picture_frame.npz") as frame:
        truth = frame["truth_e"]
    data = np.fromfile(folder / "lake/picture.hdr", np.uint8)
    made = cv2.imdecode(data, cv2.IMREAD_ANYDEPTH | cv2.IMREAD_COLOR)[..., 0]
    assert mu_psnr(truth, made, np.percentile(truth, 99.9)) == pytest.approx(said, abs=0.1)
    assert said > float(outcome.err.split("always open ")[1].split(" dB")[0]) + 5
    looked, ordinary = (
        float(outcome.err.split(text)[1].split(" dB")[0])
        for text in ("that look ", "automatic exposure ")
    )
    assert looked > said + 3
    assert float(outcome.err.split("always open ")[1].split(" dB")[0]) < ordinary < looked


@pytest.mark.parametrize("how", [[], ["--merge"]], ids=["decoder", "merge"])
def test_a_short_clip_becomes_a_film(folder: Path, run_nscc: RunNscc, how: list[str]) -> None:
    outcome = run_nscc(["demo", "short.gif", "-o", "film", *how], folder)
    assert outcome.status == 0, outcome.err
    assert "its 5 frames are spread over 16 slots" in outcome.err
    with Image.open(folder / "film/clip.gif") as film:
        assert film.n_frames == 16
    video, count = cv2.VideoCapture(str(folder / "film/clip.mp4")), 0
    while video.read()[0]:
        count += 1
    assert count == 16
    assert ("four" if not how else "one") + " readout" in outcome.err
    before = (folder / "film/clip_frame.npz").read_bytes()
    line = next(line for line in outcome.err.splitlines() if line.startswith("  nscc run "))
    assert run_nscc(line.split()[1:], folder).status == 0
    with np.load(io.BytesIO(before)) as old, np.load(folder / "film/clip_frame.npz") as new:
        assert np.array_equal(old["frame"], new["frame"])


def test_several_readouts_need_a_decoder(folder: Path, run_nscc: RunNscc) -> None:
    """`--merge` beside `--readouts 3` has status 2 and the help to leave it out."""
    outcome = run_nscc(["demo", "short.gif", "--merge", "--readouts", "3"], folder)
    assert outcome.status == 2
    assert "leave out --merge" in outcome.err


def test_demo_refuses_several_readouts_of_a_photo(folder: Path, run_nscc: RunNscc) -> None:
    """`--readouts` is for clips: with a photo it gives NS0821."""
    outcome = run_nscc(["demo", "photo.jpg", "--readouts", "2"], folder)
    assert (outcome.status, outcome.codes) == (2, ["NS0821"])
    assert "leave --readouts out" in outcome.err


def test_black_and_missing_scenes_are_refused(folder: Path, run_nscc: RunNscc) -> None:
    """A black picture gives NS0738 and a missing one NS0730, and no folder is made."""
    assert run_nscc(["demo", "black.png"], folder).codes == ["NS0738"]
    assert run_nscc(["demo", "nothing.jpg"], folder).codes == ["NS0730"]
    assert not list(folder.glob("*_demo"))


def test_run_like_uses_the_program_and_exposure_of_a_run(folder: Path, run_nscc: RunNscc) -> None:
    """The run sets program, slots, exposure and sensor; given options replace them."""
    like = run_capture(Path("hdr"))
    assert (like.slots, like.exposure, like.still) == (256, "30000@65", True)
    line = ["run", "--like", "hdr", "--scene", "builtin:hdr", "--keep", "truth", "-o", "like.npz"]
    assert run_nscc(line, folder).status == 0
    with np.load(folder / "like.npz") as file:
        # The exposure 30000@65 of the run, and below the one that is given.
        assert np.percentile(file["truth_e"], 65) == pytest.approx(30000)
    assert run_nscc([*line, "--exposure", "500@50"], folder).status == 0
    with np.load(folder / "like.npz") as file:
        assert np.percentile(file["truth_e"], 50) == pytest.approx(500)
    (folder / "other.nsl").write_text("nsl 1\nframe 4 slots of 1ms\nopen when true\n")
    assert run_nscc(["run", "other.nsl", *line[1:]], folder).codes == ["NS0821"]
    assert run_nscc(["run", "--like", ".", *line[3:]], folder).codes == ["NS0818"]
    for name, path in shipped_runs().items():
        assert (path / "decoder.safetensors").is_file(), name


def test_demo_chooses_the_part_of_a_clip_with_the_most_motion_and_no_cut() -> None:
    frames = np.zeros((30, 8, 8), np.float32)
    for k in range(30):
        frames[k, :, k % 8] = 1 if 10 <= k < 18 else 0.1
    frames[25:] += 40  # a cut
    first = liveliest(frames, 8)
    assert 9 <= first <= 11


def test_examples_are_listed_copied_and_never_overwritten(
    tmp_path: Path, run_nscc: RunNscc
) -> None:
    """Each example is listed and has a text. A copy has the same bytes, and a second copy gives
    NS0788."""
    listed = run_nscc(["examples"], tmp_path).out
    for name, path in examples().items():
        assert name in listed
        assert about(path)
    assert run_nscc(["examples", "hdr_2x2", "learn_hdr.toml"], tmp_path).status == 0
    assert (tmp_path / "hdr_2x2.nsl").read_bytes() == examples()["hdr_2x2"].read_bytes()
    assert run_nscc(["examples", "hdr_2x2"], tmp_path).codes == ["NS0788"]


def test_a_new_program_passes_check(tmp_path: Path, run_nscc: RunNscc) -> None:
    """`nscc new mine` writes the start program, which `nscc check` accepts."""
    assert run_nscc(["new", "mine"], tmp_path).status == 0
    assert (tmp_path / "mine.nsl").read_text() == START
    assert run_nscc(["check", "mine.nsl"], tmp_path).status == 0


@pytest.mark.parametrize("name", ["", ".", "..", "a/..", "/", ".nsl"])
def test_a_new_program_has_a_name(name: str, tmp_path: Path, run_nscc: RunNscc) -> None:
    """An empty name, a folder and a suffix alone are refused, and nothing is written."""
    assert run_nscc(["new", name], tmp_path).status == 2
    assert not [*tmp_path.iterdir()]


def test_light_in_a_tiff_is_viewed_as_that_of_other_formats(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(views, "png_of", lambda _sheet, content, _name: content.tone_text.encode())
    light = np.random.default_rng(5).uniform(0, 9000, (8, 6, 3)).astype(np.float32)
    for ending in ("tiff", "pfm"):
        assert cv2.imwrite(str(tmp_path / f"light.{ending}"), light)
    told = {views.view_of(tmp_path / f"light.{ending}") for ending in ("tiff", "pfm")}
    assert len(told) == 1
    assert told.pop().startswith(b"log curve, white ")
    assert cv2.imwrite(str(tmp_path / "photo.tiff"), light.astype(np.uint8))
    assert re.fullmatch(rb"srgb curve, white [0-9.]+", views.view_of(tmp_path / "photo.tiff"))


def test_files_that_cannot_be_viewed_are_refused_with_their_contents(tmp_path: Path) -> None:
    np.savez(tmp_path / "scene.npz", light=np.ones((3, 4)))
    with pytest.raises(Rejected, match="has no image or video, but light"):
        views.view_of(tmp_path / "scene.npz")


@pytest.mark.parametrize("line", ["view hdr", "run a.nsl --scene builtin:dark -o a.npz"])
def test_an_unknown_tone_curve_is_refused_where_nothing_is_drawn(
    line: str, tmp_path: Path, run_nscc: RunNscc
) -> None:
    """`--tone nope` gives NS0739, although neither command draws a picture."""
    (tmp_path / "a.nsl").write_text(START)
    outcome = run_nscc([*line.split(), "--tone", "nope"], tmp_path)
    assert (outcome.status, outcome.codes) == (2, ["NS0739"])
    assert not (tmp_path / "a.npz").exists()


def test_every_kind_of_file_has_a_view(folder: Path, run_nscc: RunNscc) -> None:
    runs, evaluation = shipped_runs(), EVALUATIONS / "looks/looks-2/hdr-v1.json"
    (folder / "sensor.toml").write_text(run_nscc(["effects", "--toml"], folder).out)
    run_nscc(["run", "--like", "hdr", "--scene", "builtin:hdr", "-o", "frame.npz"], folder)
    run_nscc(["reconstruct", "hdr", "frame.npz", "-o", "rec.npz"], folder)
    seen = set()
    for path in (
        "frame.npz",
        "rec.npz",
        "sensor.toml",
        "photo.jpg",
        "short.gif",
        "hdr",
        str(evaluation),
        str(runs["hdr"] / "shutter.nsl"),
    ):
        outcome = run_nscc(["view", path, "-o", "view.png"], folder)
        assert outcome.status == 0, outcome.err
        seen.add((folder / "view.png").read_bytes())
    assert len(seen) == 8
    assert run_nscc(["view", "nothing.npz"], folder).codes == ["NS0801"]
    assert run_nscc(["view", "frame.npz", "-o", "view.jpg"], folder).codes == ["NS0786"]


def test_a_photo_is_demonstrated_with_a_run_of_the_user(
    folder: Path, run_nscc: RunNscc, tmp_path: Path
) -> None:
    own = trained(tmp_path / "own", shutter={"slots": 64, "tile": [2, 2]}, decoder={"width": 0.25})
    outcome = run_nscc(["demo", "photo.jpg", "--run", own, "-o", tmp_path / "shown"], folder)
    assert outcome.status == 0, outcome.err
    assert (tmp_path / "shown/picture_sheet.png").is_file()
    lines = [line.strip() for line in outcome.err.splitlines() if line.startswith("  nscc ")]
    assert [f"--like {own}" in line for line in lines] == [True, True, False]
    assert lines[2].startswith(f"nscc reconstruct {own} ")
    refused = run_nscc(["demo", "short.gif", "--run", own, "-o", tmp_path / "no"], folder)
    assert refused.codes == ["NS0821"]
    assert run_nscc(["demo", "photo.jpg", "--run", own, "--merge"], folder).status == 2


@pytest.mark.parametrize(("psnr_db", "worse"), [(22.0, True), (25.5, False)])
def test_the_sheet_says_where_a_result_is_worse_than_an_ordinary_camera(
    psnr_db: float, worse: bool
) -> None:
    shown = SimpleNamespace(
        open_db=20.0, fair_db=25.0, psnr_db=psnr_db, measure="PSNR", how="a run", decode_s=0.1
    )
    shown.camera_db = Shown.camera_db.fget(shown)
    assert shown.camera_db == 25.0
    assert (f"{psnr_db} dB, worse than an ordinary camera" in _decoder_text(shown)) == worse
