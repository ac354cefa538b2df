"""Runs under protocols: the numbers are those of what was saved, and nothing seen is scored."""

from __future__ import annotations

import json
import re
import shutil
from hashlib import sha256
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from nscc_command import invoke
from scipy.io import savemat
from training_oracle import small_target

torch = pytest.importorskip("torch")

from small_runs import SMALL, clip, one_crop, trained  # noqa: E402

from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_training.baselines.merge_loop import merged  # noqa: E402
from nscc_training.evaluation.baselines import BASELINES, Baseline  # noqa: E402
from nscc_training.loop.train import train  # noqa: E402
from nscc_training.protocol_scenes.clips import encoded, windows  # noqa: E402
from nscc_training.protocol_scenes.panoramas import Crop, exposed_crop  # noqa: E402
from nscc_training.protocol_scenes.protocol_scene import Unusable  # noqa: E402
from nscc_training.protocols import load_protocol  # noqa: E402
from nscc_training.run_folder import load_run  # noqa: E402
from nscc_training.settings import settings_of  # noqa: E402


def test_a_still_run_is_evaluated_on_crops(tmp_path: Path) -> None:
    import cv2

    run = trained(tmp_path / "r", shutter={"slots": 256, "tile": [2, 2]})
    rng = np.random.default_rng(1)
    light = np.exp(rng.uniform(-4, 4, (512, 1024, 1)))
    (tmp_path / "d").mkdir()
    cv2.imwrite(str(tmp_path / "d/p.hdr"), np.repeat(light, 3, 2).astype(np.float32))
    outcome = invoke(
        ["evaluate", "r", "--data", "d", "--protocol", "hdr-v1", "--json", "--save", "s"], tmp_path
    )
    assert outcome.status == 0, outcome.err
    found = json.loads(outcome.out)
    assert [item["crop"] for item in found["items"]] == [[128, k] for k in (0, 256, 512, 768)]
    # The parameters of the small decoder of the run's settings, which must not change unnoticed.
    assert found["parameters"] == 487_441
    truth = np.load(tmp_path / "s/p_128_0_truth.npy").astype(float)
    made = np.load(tmp_path / "s/p_128_0_image.npy").astype(float)
    peak = np.percentile(truth, 99.9)
    error = np.mean((np.clip(truth / peak, 0, 1) - np.clip(made / peak, 0, 1)) ** 2)
    assert found["items"][0]["psnr_db"] == pytest.approx(-10 * np.log10(error), abs=1e-3)
    again = json.loads(
        invoke(["evaluate", "r", "--data", "d", "--protocol", "hdr-v1", "--json"], tmp_path).out
    )
    assert again["items"] == found["items"]
    other = invoke(["evaluate", str(run), "--data", "d", "--protocol", "video-v1"], tmp_path)
    assert other.codes == ["NS0821"]
    trained(tmp_path / "short", shutter={"slots": 64, "tile": [2, 2]})
    short = invoke(["evaluate", "short", "--data", "d", "--protocol", "hdr-v1"], tmp_path)
    assert short.codes == ["NS0821"]


def test_a_clip_run_is_evaluated_under_video_v1_and_refused_under_sci8(tmp_path: Path) -> None:
    decoder, data = {"name": "fcnet"}, {"protocol": "video-v1"}
    trained(
        tmp_path / "r16",
        shutter={"class": "c", "slots": 16, "tile": [4, 4]},
        decoder=decoder,
        data={**SMALL["data"], **data},
    )
    (tmp_path / "d").mkdir()
    orig = clip(tmp_path / "d/c.mat", 33, 256)
    outcome = invoke(
        ["evaluate", "r16", "--data", "d", "--protocol", "video-v1", "--json", "--save", "s"],
        tmp_path,
    )
    assert outcome.status == 0, outcome.err
    found = json.loads(outcome.out)
    assert [item["frame"] for item in found["items"]] == [0, 16]
    truth = np.load(tmp_path / "s/c_16_truth.npy").astype(float)
    made = np.load(tmp_path / "s/c_16_video.npy").astype(float)
    # a .mat clip is linear: its light is its values, up to the exposure
    values = np.moveaxis(orig[..., 16:32], 2, 0) / 255
    scale = truth[values > 0].sum() / values.sum()
    np.testing.assert_allclose(truth, values * scale, rtol=1e-5)
    assert np.percentile(truth.sum(axis=0), 99) == pytest.approx(30000, rel=1e-5)
    errors = np.mean((values - np.clip(made / scale, 0, 1)) ** 2, axis=(1, 2))
    assert found["items"][1]["psnr_db"] == pytest.approx(
        float(np.mean(-10 * np.log10(errors))), abs=1e-3
    )
    sci = invoke(["evaluate", "r16", "--data", "d", "--protocol", "sci8"], tmp_path)
    assert sci.codes == ["NS0821"]


@pytest.mark.parametrize("name", ["unet3d", "unrolled", "refined"])
def test_a_run_is_evaluated_with_the_mask_of_the_file(name: str, tmp_path: Path) -> None:
    shutter = {"class": "e", "slots": 8, "tile": [4, 4], "init": "random"}
    trained(
        tmp_path / "r",
        shutter=shutter,
        decoder={"name": name},
        data={**SMALL["data"], "protocol": "video-v1"},
    )
    clip(tmp_path / "c.mat", 10, 32)
    outcome = invoke(["evaluate", "r", "--data", "c.mat", "--protocol", "sci8", "--json"], tmp_path)
    assert outcome.status == 0, outcome.err
    found = json.loads(outcome.out)
    assert (len(found["items"]), found["data_range"]) == (8, 255)
    (tmp_path / "empty").mkdir()
    for where in ("empty", "none.mat"):
        refused = invoke(["evaluate", "r", "--data", where, "--protocol", "sci8"], tmp_path)
        assert (refused.status, refused.codes) == (2, ["NS0811"])


def test_files_of_the_training_are_not_scored(tmp_path: Path) -> None:
    import cv2

    (tmp_path / "d").mkdir()
    rng = np.random.default_rng(1)
    for name in ("p", "q"):
        light = np.exp(rng.uniform(-4, 4, (512, 1024, 1)))
        cv2.imwrite(str(tmp_path / f"d/{name}.hdr"), np.repeat(light, 3, 2).astype(np.float32))
    data = {**SMALL["data"], "train": str(tmp_path / "d"), "val": ""}
    trained(tmp_path / "r", shutter={"slots": 256, "tile": [2, 2]}, data=data)
    (tmp_path / "e").mkdir()
    (tmp_path / "d/p.hdr").rename(tmp_path / "e/renamed.hdr")
    evaluate = ["evaluate", "r", "--data", "e", "--protocol", "hdr-v1"]
    refused = invoke(evaluate, tmp_path)
    assert (refused.status, refused.codes) == (2, ["NS0820"])
    assert "renamed.hdr" in refused.err
    # There is nothing else in the folder, so that skipping is no way out.
    assert "--skip-seen" not in refused.err
    assert invoke([*evaluate, "--skip-seen"], tmp_path).codes == ["NS0820"]
    light = np.exp(rng.uniform(-4, 4, (512, 1024, 1)))
    cv2.imwrite(str(tmp_path / "e/new.hdr"), np.repeat(light, 3, 2).astype(np.float32))
    refused = invoke(evaluate, tmp_path)
    assert "1 of these 2 files" in refused.err
    assert "--skip-seen" in refused.err
    outcome = invoke([*evaluate, "--skip-seen", "--json"], tmp_path)
    assert outcome.status == 0, outcome.err
    found = json.loads(outcome.out)
    assert [entry["file"] for entry in found["data"]] == ["new.hdr"]
    assert {item["file"] for item in found["items"]} == {"new.hdr"}
    assert [entry["file"] for entry in found["left_out"]] == ["renamed.hdr"]


def read_by_hand(truth: np.ndarray, share: np.ndarray, seed: int) -> np.ndarray:
    """Codes of light in full wells over the frame, with a noise of its own."""
    rng = np.random.default_rng(seed)
    charge = truth * share * 30000
    charge = np.minimum(charge + np.sqrt(charge) * rng.standard_normal(charge.shape), 30000)
    codes = charge / 30000 * 255 + 0.65 * rng.standard_normal(charge.shape)
    return np.clip(np.rint(codes), 0, 255).astype(np.float32)


def scored_by_hand(truth: np.ndarray, made: np.ndarray) -> dict[str, float]:
    """Linear and mu-law PSNR of light in full wells."""
    peak = np.percentile(truth, 99.9)
    pair = [np.clip(x / peak, 0, 1) for x in (truth, made)]
    curved = [np.log1p(5000 * x) / np.log1p(5000) for x in pair]
    return {
        f"mean_{name}": -10 * np.log10(np.mean((a - b) ** 2))
        for name, (a, b) in (("psnr_db", pair), ("mu_psnr_db", curved))
    }


def decoded_by(run: Path, frame: np.ndarray, stops: np.ndarray) -> np.ndarray:
    """What a run's decoder makes of codes, in full wells."""
    opened = torch.from_numpy(np.arange(256)[:, None, None] < stops).float()
    with torch.no_grad():
        made = load_run(run).setup.decoder(torch.from_numpy(frame / 255)[None], opened)
    return np.asarray(made[0].numpy(), float)


@pytest.mark.parametrize("subject", ["quad", "best-uniform", "run"])
def test_other_saturated_fractions_are_reported(subject: str, tmp_path: Path) -> None:
    """The expected scores come from the crop, exposed and scored by hand at 10 and 50 %."""
    (tmp_path / "d").mkdir()
    light = one_crop(tmp_path / "d/p.hdr")
    if subject == "run":
        shutter = {"slots": 256, "tile": [2, 2], "learn": False}
        trained(tmp_path / "run", shutter=shutter)
    arguments = ["evaluate", subject, "--data", "d", "--protocol", "hdr-v1", "--json"]
    outcome = invoke(arguments, tmp_path)
    assert outcome.status == 0, outcome.err
    found = json.loads(outcome.out)
    assert [part["saturated_fraction"] for part in found["also_saturated"]] == [0.1, 0.5]
    if subject == "run":
        stops = np.load(tmp_path / "run/codes.npz")["stop"]
    else:
        # the stop that is best at 30 % is kept
        stops = np.array(found["settings"]["stops"])
    share = np.tile(stops / 256, [256 // side for side in stops.shape])
    for part in found["also_saturated"]:
        truth = light / np.quantile(light, 1 - part["saturated_fraction"], method="higher")
        scores = []
        for seed in range(4):
            frame = read_by_hand(truth, share, seed)
            if subject == "run":
                made = decoded_by(tmp_path / "run", frame, stops)
            else:
                made = merged(frame, share, 30000 / 255, frame >= 255, 0.65 * 30000 / 255) / 30000
            scores.append(scored_by_hand(truth, made))
        for name in ("mean_psnr_db", "mean_mu_psnr_db"):
            # the darkest pixels of a 2 x 2 pattern make 0.3 dB of difference from noise to noise
            assert part[name] == pytest.approx(np.median([s[name] for s in scores]), abs=0.5)
        assert 0 < part["mean_ssim"] < 1
        assert (part["crops"], part["crops_left_out"]) == (1, 3)
    at_ten, at_fifty = (part["mean_psnr_db"] for part in found["also_saturated"])
    # so that neither could be taken for the other or for 30 %
    assert min(abs(a - b) for a, b in combinations((at_ten, found["mean"], at_fifty), 2)) > 1.5


def test_a_run_keeps_a_chip_and_a_sensor_of_ones_own(tmp_path: Path) -> None:
    """Whoever has the folder needs nothing else: from anywhere, after the files are gone."""
    (tmp_path / "mine").mkdir()
    chip = small_target(invoke(["targets", "scamp5", "--toml"], tmp_path).out, 64, 48)
    sensor = re.sub(
        r"(?m)^full_well_e = .*$",
        "full_well_e = 20000.0",
        invoke(["effects", "--toml"], tmp_path).out,
    )
    sensor = re.sub(r"(?m)^electrons_per_lsb = .*$", "electrons_per_lsb = 70.0", sensor)
    given = {"target.toml": chip + "# a chip\n", "sensor.toml": sensor + "# a sensor\n"}
    for name, text in given.items():
        (tmp_path / "mine" / f"my_{name}").write_text(text)
    (tmp_path / "c.toml").write_text(
        '[shutter]\nslots = 256\ntile = [2, 2]\ntarget = "mine/my_target.toml"\n'
        '[sensor]\nfile = "mine/my_sensor.toml"\n[data]\npatch = 16\nscenes = 2\nval_items = 1\n'
        "[train]\nsteps = 1\nbatch = 1\nvalidate_every = 1\n"
    )
    done = invoke(["train", "c.toml", "--out", "r"], tmp_path)
    assert done.status == 0, done.err
    shutil.rmtree(tmp_path / "mine")
    files = json.loads((tmp_path / "r/result.json").read_text())["files"]
    for name, text in given.items():
        assert (tmp_path / "r" / name).read_text() == text
        assert files[name] == sha256(text.encode()).hexdigest()
    here = tmp_path / "elsewhere"
    (here / "d").mkdir(parents=True)
    one_crop(here / "d/p.hdr")
    arguments = ["evaluate", "../r", "--data", "d", "--protocol", "hdr-v1", "--json"]
    outcome = invoke(arguments, here)
    assert outcome.status == 0, outcome.err
    assert len(json.loads(outcome.out)["items"]) == 1
    model = load_run(tmp_path / "r").setup.model
    assert (model.full_well_e, model.electrons_per_lsb) == (20000, 70)
    # what is printed at the end works, and so does a frame of it
    command = re.search(r"`nscc (build .*)`", done.err)
    assert command
    assert invoke([*command[1].split(), "-O", "1", "-o", "s.icw"], tmp_path).status == 0
    exposing = [
        "run",
        "../r/shutter.nsl",
        "-O",
        "1",
        "--scene",
        "builtin:hdr",
        "--sensor",
        "../r/sensor.toml",
    ]
    own = ["--target", "../r/target.toml"]
    assert invoke([*exposing, *own, "-o", "f.npz"], here).status == 0
    for run in ("../r", str(tmp_path / "r")):
        made = invoke(["reconstruct", run, "f.npz", "-o", "o.npz"], here)
        assert made.status == 0, made.err
        image = np.load(here / "o.npz")["image"]
        assert image.shape == (64, 48)
        assert np.isfinite(image).all()
    # a frame of another chip, of another sensor
    invoke([*exposing, "-o", "g.npz"], here)
    invoke([*exposing[:-2], *own, "-o", "h.npz"], here)
    for name, words in (("g.npz", "--target target.toml"), ("h.npz", "electrons_per_lsb")):
        refused = invoke(["reconstruct", "../r", name, "-o", "p.npz"], here)
        assert refused.codes == ["NS0819"]
        assert words in refused.err


def own_files(folder: Path) -> dict[str, str]:
    """A chip and a sensor of one's own, in a folder."""
    chip = invoke(["targets", "scamp5", "--toml"], folder).out
    (folder / "t.toml").write_text(small_target(chip, 64, 48))
    (folder / "s.toml").write_text("full_well_e = 20000.0\nelectrons_per_lsb = 70.0\n")
    return {name: (folder / name).read_text() for name in ("t.toml", "s.toml")}


OWN: dict[str, dict[str, Any]] = {
    "shutter": {"class": "b", "slots": 16, "tile": [2, 2], "target": "t.toml"},
    "sensor": {"file": "s.toml"},
    "data": {"patch": 16, "scenes": 2, "val_items": 1},
    "train": {"steps": 4, "batch": 1, "validate_every": 2},
}
KEPT = {"t.toml": "target.toml", "s.toml": "sensor.toml"}


def test_a_run_is_for_the_files_that_it_began_with(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The files may be damaged or removed while the run trains."""
    monkeypatch.chdir(tmp_path)
    given = own_files(tmp_path)
    train(settings_of(OWN), tmp_path / "whole")

    def spoiling(steps: Any, _label: str, _total: int) -> Any:
        for step in steps:
            if step == 1:
                (tmp_path / "t.toml").write_text("rows = nonsense")
                (tmp_path / "s.toml").unlink()
            yield step

    train(settings_of(OWN), tmp_path / "r", track=spoiling)
    for path in (tmp_path / "whole").iterdir():
        assert (tmp_path / "r" / path.name).read_bytes() == path.read_bytes(), path.name
    for name, text in given.items():
        assert (tmp_path / "r" / KEPT[name]).read_text() == text
    assert load_run(tmp_path / "r").setup.target.rows == 64


@pytest.mark.parametrize("which", ["t.toml", "s.toml"])
def test_a_run_refuses_to_resume_with_other_files(
    which: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    given = own_files(tmp_path)
    settings, out = settings_of(OWN), tmp_path / "r"
    train(settings, out, stop_after=2)
    assert all((out / KEPT[name]).read_text() == text for name, text in given.items())
    (tmp_path / which).write_text(given[which] + "# changed\n")
    with pytest.raises(Rejected, match="NS0816") as refused:
        train(settings, out)
    assert KEPT[which] in refused.value.diagnostics[0].notes[0]
    assert (out / KEPT[which]).read_text() == given[which]
    # put back, it goes on; begun anew, it is a run of the others
    (tmp_path / which).write_bytes((out / KEPT[which]).read_bytes())
    train(settings, out)
    assert (out / "result.json").is_file()
    (tmp_path / which).write_text(given[which] + "# changed\n")
    train(settings, out, resume="never", stop_after=1)
    assert (out / KEPT[which]).read_text() == given[which] + "# changed\n"


def test_a_run_does_not_use_target_and_sensor_files_of_an_earlier_run_in_its_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The first run had a chip and sensor file of its own. The second, in the same folder, has
    those of SCAMP-5."""
    monkeypatch.chdir(tmp_path)
    own_files(tmp_path)
    train(settings_of(OWN), tmp_path / "r", stop_after=1)
    plain = {**OWN, "shutter": {**OWN["shutter"], "target": "scamp5"}, "sensor": {}}
    train(settings_of(plain), tmp_path / "r", resume="never")
    parts = load_run(tmp_path / "r").setup
    assert (parts.target.rows, parts.model.full_well_e) == (256, 30000)


def test_bilinear_sees_one_slot_of_each_pixel(tmp_path: Path) -> None:
    """Each pixel is seen in one of 16 slots. All other values are weighted by tents from samples of
    the same frame."""
    (tmp_path / "d").mkdir()
    noise = np.random.default_rng(2).integers(1, 256, (256, 256, 16), np.uint8)
    savemat(tmp_path / "d/c.mat", {"orig": noise})
    arguments = ["evaluate", "bilinear", "--data", "d", "--protocol", "video-v1", "--json"]
    outcome = invoke([*arguments, "--save", "s", "--seed", "3"], tmp_path)
    assert outcome.status == 0, outcome.err
    found = json.loads(outcome.out)
    assert (found["sees"], found["settings"]["seed"]) == ("truth", 3)
    start = np.array(found["settings"]["start"])
    assert (start.shape, set(found["settings"])) == ((8, 8), {"start", "seed", "shutter"})
    assert 0 <= start.min() < start.max() <= 15
    seen = np.arange(16)[:, None, None] == np.tile(start, (32, 32))
    assert np.mean(seen) == 1 / 16
    truth, made = (np.load(tmp_path / f"s/c_0_{n}.npy") for n in ("truth", "video"))
    assert np.array_equal(made[seen], truth[seen])
    assert np.mean(made[~seen] == truth[~seen]) < 0.1
    rng = np.random.default_rng(4)
    for _ in range(60):
        n, row, col = (int(rng.integers(side)) for side in truth.shape)
        if seen[n, row, col]:
            continue
        # The tent is doubled until a sample is below it.
        for reach in (2, 4, 8, 16, 32, 64):
            top = bottom = 0.0
            for r in range(max(0, row - reach + 1), min(256, row + reach)):
                for c in range(max(0, col - reach + 1), min(256, col + reach)):
                    weight = (1 - abs(r - row) / reach) * (1 - abs(c - col) / reach)
                    top += weight * seen[n, r, c] * truth[n, r, c]
                    bottom += weight * seen[n, r, c]
            if bottom:
                break
        if bottom:
            assert made[n, row, col] == pytest.approx(top / bottom, rel=1e-5)


def test_baselines_are_evaluated_on_windows_of_clips(tmp_path: Path) -> None:
    (tmp_path / "d").mkdir()
    clip(tmp_path / "d/c.mat", 16, 256)
    clip(tmp_path / "d/small.mat", 16, 64)
    clip(tmp_path / "d/short.mat", 15, 256)
    found = {}
    for name in ("adjoint", "gap-tv", "thin-out"):
        arguments = ["evaluate", name, "--data", "d", "--protocol", "video-v1", "--json"]
        outcome = invoke(arguments, tmp_path)
        assert outcome.status == 0, outcome.err
        found[name] = json.loads(outcome.out)
    assert found["gap-tv"]["mean"] > found["adjoint"]["mean"] + 5
    passed = {left["file"]: left["reason"] for left in found["gap-tv"]["left_out"]}
    assert passed == {
        "small.mat": "64 x 64 is smaller than 256 x 256",
        "short.mat": "it has 15 frames, but a window has 16",
    }
    human = invoke(["evaluate", "adjoint", "--data", "d", "--protocol", "video-v1"], tmp_path).out
    assert "left out: short.mat: it has 15 frames" in human
    assert {k: v["sees"] for k, v in found.items()} == {
        "adjoint": "capture",
        "gap-tv": "capture",
        "thin-out": "truth",
    }


def test_a_small_clip_is_named_with_its_own_size(tmp_path: Path) -> None:
    """A clip of 64 x 300 pixels is left out with a reason that gives both sizes."""
    savemat(tmp_path / "flat.mat", {"orig": np.ones((64, 300, 16), np.uint8)})
    (left_out,) = windows(tmp_path / "flat.mat", load_protocol("video-v1"))
    assert isinstance(left_out, Unusable)
    assert left_out.reason == "64 x 300 is smaller than 256 x 256"


def test_an_interrupted_evaluation_resumes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The scores of scenes are kept beside the result until it is written."""
    for k in range(2):
        clip(tmp_path / f"{k}.mat", 16, 256)
    line = ["evaluate", "thin-out", "--protocol", "video-v1", "--data", ".", "-o", "r.json"]
    decode = Baseline.decode
    decoded: list[str] = []

    def until(self: Baseline, frames: Any) -> Any:
        if len(decoded) == 1:
            raise KeyboardInterrupt
        decoded.append(frames.scene.file.name)
        return decode(self, frames)

    with monkeypatch.context() as patch:
        patch.setattr(Baseline, "decode", until)
        ended = invoke(line, tmp_path)
    # The status of an interrupted command.
    assert ended.status == 130
    assert "stored in 'r.measurements.sqlite'; the same command continues" in ended.err
    done = invoke(line, tmp_path)
    assert (done.status, decoded) == (0, ["0.mat"])
    again = json.loads((tmp_path / "r.json").read_text())
    whole = json.loads(invoke([*line[:-2], "--json"], tmp_path).out)
    assert again["items"] == whole["items"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["0.mat", "1.mat", "r.json"]


def test_a_damaged_file_is_named_and_the_others_are_scored(tmp_path: Path) -> None:
    """The means are those of a folder without the damaged file, and the exit status says that a
    file is missing. If both files are damaged, nothing remains to score."""
    for name in ("whole", "damaged"):
        (tmp_path / name).mkdir()
        for k in range(2):
            clip(tmp_path / name / f"{k}.mat", 16, 256)
    data = (tmp_path / "damaged/0.mat").read_bytes()
    (tmp_path / "damaged/9.mat").write_bytes(data[: len(data) // 2])
    line = ["evaluate", "thin-out", "--protocol", "video-v1", "--json", "--data"]
    whole, damaged = (invoke([*line, name], tmp_path) for name in ("whole", "damaged"))
    assert (whole.status, whole.codes) == (0, [])
    assert damaged.status == 1
    result = json.loads(damaged.out)
    assert result["items"] == json.loads(whole.out)["items"]
    [left_out] = result["left_out"]
    assert left_out["file"] == "9.mat"
    assert [left_out["code"]] == damaged.codes
    assert "9.mat" in damaged.err
    human = invoke(["evaluate", "thin-out", *line[2:4], "--data", "damaged"], tmp_path)
    assert "left out: 9.mat" in human.out
    (tmp_path / "g.toml").write_text(
        'kind = "evaluate"\n[q]\nsubject = "thin-out"\nprotocol = "video-v1"\n'
        'data = ["whole", "damaged"]\n'
    )
    swept = invoke(["sweep", "g.toml", "--out", "o", "--workers", "0"], tmp_path)
    assert f"1 x {left_out['code']}" in swept.err
    for k in range(2):
        (tmp_path / f"damaged/{k}.mat").write_bytes(b"no clip")
    nothing = invoke([*line, "damaged"], tmp_path)
    assert (nothing.status, len(nothing.codes), nothing.out) == (2, 3, "")


def test_data_without_a_usable_scene_are_refused(tmp_path: Path) -> None:
    """Says why, instead of a result without an item."""
    import cv2

    (tmp_path / "d").mkdir()
    cv2.imwrite(str(tmp_path / "d/flat.hdr"), np.ones((512, 1024, 3), "f4"))
    cv2.imwrite(str(tmp_path / "d/small.hdr"), np.ones((100, 200, 3), "f4"))
    clip(tmp_path / "d/short.mat", 9, 256)
    for arguments, reasons in (
        (["ldr", "--protocol", "hdr-v1"], ("flat.hdr: 100.0% saturate", "small.hdr: (100, 200)")),
        (["thin-out", "--protocol", "video-v1"], ("short.mat: it has 9 frames",)),
    ):
        outcome = invoke(["evaluate", *arguments, "--data", "d", "-o", "r.json"], tmp_path)
        assert (outcome.status, outcome.codes) == (2, ["NS0811"])
        assert all(reason in outcome.err for reason in reasons)
        assert not (tmp_path / "r.json").exists()


def test_the_best_uniform_stops_are_the_best_of_what_they_are_named_for(tmp_path: Path) -> None:
    """The expected stop is the best power of two, each simulated with noise. Mu-law PSNR prefers
    long exposures, linear PSNR short ones."""
    (tmp_path / "d").mkdir()
    crop = one_crop(tmp_path / "d/p.hdr")
    truth = crop / np.quantile(crop, 0.7)
    peak = np.percentile(truth, 99.9)
    rng, linear, curved = np.random.default_rng(7), {}, {}
    for stop in (1 << k for k in range(9)):
        charge = truth * 30000 * stop / 256
        charge = np.minimum(charge + np.sqrt(charge) * rng.standard_normal(charge.shape), 30000)
        codes = charge / 30000 * 255 + 0.65 * rng.standard_normal(charge.shape)
        frame = np.clip(np.rint(codes), 0, 255).astype(np.float32)
        share = np.full(frame.shape, stop / 256)
        made = merged(frame, share, 30000 / 255, frame >= 255, 0.65 * 30000 / 255) / 30000
        pair = [np.clip(x / peak, 0, 1) for x in (truth, made)]
        linear[stop] = -10 * np.log10(np.mean((pair[0] - pair[1]) ** 2))
        pair = [np.log1p(5000 * x) / np.log1p(5000) for x in pair]
        curved[stop] = -10 * np.log10(np.mean((pair[0] - pair[1]) ** 2))
    best = {}
    for name, metric, wanted in (
        ("best-uniform", "psnr_db", linear),
        ("best-uniform-mu", "mu_psnr_db", curved),
    ):
        outcome = invoke(
            ["evaluate", name, "--data", "d", "--protocol", "hdr-v1", "--json"], tmp_path
        )
        assert outcome.status == 0, outcome.err
        found = json.loads(outcome.out)
        assert len(found["items"]) == 1
        (best[name],) = found["settings"]["stops"][0]
        assert best[name] == max(wanted, key=lambda stop: wanted[stop])
        assert found["items"][0][metric] == pytest.approx(wanted[best[name]], abs=0.1)
        assert sorted(wanted.values())[-2] < max(wanted.values()) - 0.3
    assert best["best-uniform-mu"] > best["best-uniform"]


def test_crops_are_exposed_so_that_the_stated_fraction_saturates() -> None:
    """Fractions of 0.1, 0.3 and 0.5 of the pixels reach the well of 30 000 electrons. Dark, flat
    and infinite crops are left out."""
    protocol = load_protocol("hdr-v1")
    rng = np.random.default_rng(2)
    light = np.exp(rng.normal(0, 2, (256, 256)))
    for fraction in (0.1, 0.3, 0.5):
        crop = exposed_crop(Path("x.hdr"), (0, 0), light, protocol, fraction)
        assert isinstance(crop, Crop)
        assert np.mean(crop.light_e >= 30000) == pytest.approx(fraction, abs=1e-4)
    for bad in (np.zeros((256, 256)), np.ones((256, 256)), light * np.inf):
        assert isinstance(exposed_crop(Path("x.hdr"), (0, 0), bad, protocol), Unusable)


def test_encoding_with_the_srgb_curve_reverses_the_linearisation_of_scenes() -> None:
    """Values of 0 to 1 come back to 1e-7. Without the curve, values are cut off at 0 and 1."""
    from nscc_runtime.scenes.colour import srgb_to_linear

    values = np.linspace(0, 1, 256)
    np.testing.assert_allclose(encoded(srgb_to_linear(values), True), values, atol=1e-7)
    assert encoded(np.array([-1.0, 0.25, 7.0]), False).tolist() == [0.0, 0.25, 1.0]


def test_files_that_differ_only_in_their_ending_have_separate_products(tmp_path: Path) -> None:
    """The products of `one.mat` and `one.MAT` have the ending in their names. Products of other
    files keep short names."""
    (tmp_path / "d").mkdir()
    rng = np.random.default_rng(2)
    clips = {name: rng.integers(1, 256, (256, 256, 16), np.uint8) for name in "abc"}
    for name, file in (("a", "one.mat"), ("b", "one.MAT"), ("c", "two.mat")):
        savemat(tmp_path / "d" / file, {"orig": clips[name]}, appendmat=False)
    arguments = ["evaluate", "thin-out", "--data", "d", "--protocol", "video-v1", "--save", "s"]
    assert invoke(arguments, tmp_path).status == 0
    saved = {path.name for path in (tmp_path / "s").glob("*_truth.npy")}
    assert saved == {"one_mat_0_truth.npy", "one_MAT_0_truth.npy", "two_0_truth.npy"}
    truths = {name: np.load(tmp_path / f"s/{name}_0_truth.npy") for name in ("one_mat", "one_MAT")}
    for name, key in (("one_mat", "a"), ("one_MAT", "b")):
        frames = np.moveaxis(clips[key].astype(float), 2, 0)
        np.testing.assert_allclose(truths[name] / truths[name].max(), frames / 255, atol=1e-6)


@pytest.mark.parametrize("bad", [float("nan"), float("inf")])
def test_a_reconstruction_that_is_not_finite_has_no_score(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, bad: float
) -> None:
    clip(tmp_path / "c.mat", 16, 256)

    def decode(captured: Any) -> Any:
        found = np.zeros(captured.scene.light_e.shape)
        found[3, 2, 1] = bad
        return found

    row = BASELINES["video-v1"]["gap-tv"]
    wrong = row._replace(method=row.method._replace(decode=decode))
    monkeypatch.setitem(BASELINES["video-v1"], "gap-tv", wrong)
    asked = ["evaluate", "gap-tv", "--data", ".", "--protocol", "video-v1", "-o", "r.json"]
    done = invoke(asked, tmp_path)
    assert (done.status, done.codes) == (2, ["NS0804"])
    assert "1 of 1048576 values" in done.err
    assert not (tmp_path / "r.json").exists()
