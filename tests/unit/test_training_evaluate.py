"""Runs under protocols: the numbers are those of what was saved, and nothing seen is scored."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from nscc_command import invoke
from scipy.io import savemat

torch = pytest.importorskip("torch")

from nscc.cli.support import write_together  # noqa: E402
from nscc_training.baselines.hdr import merged  # noqa: E402
from nscc_training.config import settings_of  # noqa: E402
from nscc_training.evaluation.hdr import Crop, Unusable, exposed_crop  # noqa: E402
from nscc_training.evaluation.video import encoded  # noqa: E402
from nscc_training.loop.train import train  # noqa: E402
from nscc_training.protocols import load_protocol  # noqa: E402

SMALL: dict[str, dict[str, Any]] = {
    "data": {"patch": 16, "scenes": 2, "val_items": 1},
    "train": {"steps": 2, "batch": 1, "validate_every": 2},
}


def trained(out: Path, **sections: dict[str, Any]) -> Path:
    values = {
        name: {**SMALL.get(name, {}), **sections.get(name, {})} for name in {*SMALL, *sections}
    }
    train(settings_of(values), out, write=write_together)
    return out


def clip(path: Path, frames: int, side: int) -> np.ndarray:
    rng = np.random.default_rng(3)
    ground = np.kron(rng.integers(20, 230, (side // 8, side // 8)), np.ones((8, 8)))
    orig = np.stack([np.roll(ground, k, axis=1) for k in range(frames)], axis=2).astype(np.uint8)
    mask = (rng.random((side, side, 8)) < 0.5).astype(np.uint8)
    meas = (orig[..., :8].astype(float) * mask).sum(axis=2)[..., None]
    savemat(path, {"orig": orig, "mask": mask, "meas": meas})
    return orig


def test_a_still_run(tmp_path: Path) -> None:
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


def test_a_clip_run_on_both_protocols_of_clips(tmp_path: Path) -> None:
    decoder, data = {"name": "fcnet"}, {"protocol": "video-v1"}
    trained(tmp_path / "r16", shutter={"class": "c", "slots": 16, "tile": [4, 4]},
            decoder=decoder, data={**SMALL["data"], **data})  # fmt: skip
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


def test_a_run_with_the_mask_of_the_file(tmp_path: Path) -> None:
    shutter = {"class": "e", "slots": 8, "tile": [4, 4], "init": "random"}
    trained(tmp_path / "r", shutter=shutter, decoder={"name": "unet3d"},
            data={**SMALL["data"], "protocol": "video-v1"})  # fmt: skip
    clip(tmp_path / "c.mat", 10, 32)
    outcome = invoke(["evaluate", "r", "--data", "c.mat", "--protocol", "sci8", "--json"], tmp_path)
    assert outcome.status == 0, outcome.err
    found = json.loads(outcome.out)
    assert (len(found["items"]), found["data_range"]) == (8, 255)


def test_what_was_seen_is_not_scored(tmp_path: Path) -> None:
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
    refused = invoke(["evaluate", "r", "--data", "e", "--protocol", "hdr-v1"], tmp_path)
    assert (refused.status, refused.codes) == (2, ["NS0820"])
    assert "renamed.hdr" in refused.err


def test_tables_have_every_row_and_say_what_was_not_run(tmp_path: Path) -> None:
    import cv2

    (tmp_path / "d/hdr").mkdir(parents=True)
    rng = np.random.default_rng(1)
    light = cv2.resize(np.exp(rng.uniform(-4, 4, (64, 128))), (1024, 512))
    light[:, :768] = 1.0  # one crop of four can be exposed as the protocol says
    cv2.imwrite(str(tmp_path / "d/hdr/p.hdr"), np.repeat(light[..., None], 3, 2).astype("f4"))
    (tmp_path / "runs").mkdir()
    for seed in (0, 1):
        shutter = {"slots": 256, "tile": [2, 2], "init": "quad", "learn": False}
        trained(tmp_path / f"runs/{seed}", shutter=shutter,
                train={**SMALL["train"], "seed": seed})  # fmt: skip
    arguments = ["evaluate", "tables", "--data", "d", "--runs", "runs"]
    outcome = invoke([*arguments, "--json", "-o", "t.json"], tmp_path)
    assert outcome.status == 0, outcome.err
    rows = json.loads(outcome.out)
    assert rows == json.loads((tmp_path / "t.json").read_text())
    assert [sum(row["table"] == k for row in rows) for k in (2, 3, 4)] == [8, 15, 6]
    paper = {(row["table"], row["row"]): (row["paper_psnr_db"], row["paper_ssim"]) for row in rows}
    assert paper[2, "learned code, U-Net"] == (35.42, 0.9464)
    assert paper[3, "3D U-Net, e learned"] == (33.56, 0.9374)
    assert paper[4, "dictionary, e random"] == (26.22, 0.7258)
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
    human = invoke(arguments, tmp_path).out
    assert human.count("not run") == sum("not run" in row["remark"] for row in rows)


def test_baselines_of_clips(tmp_path: Path) -> None:
    (tmp_path / "d").mkdir()
    clip(tmp_path / "d/c.mat", 16, 256)
    clip(tmp_path / "d/small.mat", 16, 64)
    found = {}
    for name in ("adjoint", "gap-tv", "thin-out"):
        arguments = ["evaluate", name, "--data", "d", "--protocol", "video-v1", "--json"]
        outcome = invoke(arguments, tmp_path)
        assert outcome.status == 0, outcome.err
        found[name] = json.loads(outcome.out)
    assert found["gap-tv"]["mean"] > found["adjoint"]["mean"] + 5
    assert [left["file"] for left in found["gap-tv"]["windows_left_out"]] == ["small.mat"]
    assert {k: v["sees"] for k, v in found.items()} == {
        "adjoint": "capture", "gap-tv": "capture", "thin-out": "truth"
    }  # fmt: skip


def test_the_best_uniform_stops_are_the_best_of_what_they_are_named_for(tmp_path: Path) -> None:
    """Against every power of two with a noise of its own: mu-law wants the shadows, linear light
    the highlights."""
    import cv2

    (tmp_path / "d").mkdir()
    light = cv2.resize(np.exp(np.random.default_rng(1).uniform(-4, 4, (64, 128))), (1024, 512))
    light[:, 256:] = 1.0  # one crop of four can be exposed as the protocol says
    cv2.imwrite(str(tmp_path / "d/p.hdr"), np.repeat(light[..., None], 3, 2).astype("f4"))
    crop = cv2.imread(str(tmp_path / "d/p.hdr"), cv2.IMREAD_UNCHANGED)[128:384, :256, 1]
    truth = crop / np.quantile(crop, 0.7)
    peak = np.percentile(truth, 99.9)
    rng, linear, curved = np.random.default_rng(7), {}, {}
    for stop in (1 << k for k in range(9)):
        charge = truth * 30000 * stop / 256
        charge = np.minimum(charge + np.sqrt(charge) * rng.standard_normal(charge.shape), 30000)
        codes = charge / 30000 * 255 + 0.65 * rng.standard_normal(charge.shape)
        frame = np.clip(np.rint(codes), 0, 255).astype(np.float32)
        share = np.full(frame.shape, stop / 256)
        made = merged(frame, share, 30000 / 255, 255, 0.65 * 30000 / 255) / 30000
        pair = [np.clip(x / peak, 0, 1) for x in (truth, made)]
        linear[stop] = -10 * np.log10(np.mean((pair[0] - pair[1]) ** 2))
        pair = [np.log1p(5000 * x) / np.log1p(5000) for x in pair]
        curved[stop] = -10 * np.log10(np.mean((pair[0] - pair[1]) ** 2))
    best = {}
    for name, metric, wanted in (
        ("best-uniform", "psnr_db", linear), ("best-uniform-mu", "mu_psnr_db", curved),
    ):  # fmt: skip
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


def test_crops_are_exposed_as_the_protocol_says() -> None:
    protocol = load_protocol("hdr-v1")
    rng = np.random.default_rng(2)
    light = np.exp(rng.normal(0, 2, (256, 256)))
    for fraction in (0.1, 0.3, 0.5):
        crop = exposed_crop(Path("x.hdr"), (0, 0), light, protocol, fraction)
        assert isinstance(crop, Crop)
        assert np.mean(crop.light_e >= 30000) == pytest.approx(fraction, abs=1e-4)
    for bad in (np.zeros((256, 256)), np.ones((256, 256)), light * np.inf):
        assert isinstance(exposed_crop(Path("x.hdr"), (0, 0), bad, protocol), Unusable)


def test_encoding_is_the_reverse_of_the_scenes() -> None:
    from nscc_runtime.scenes.colour import srgb_to_linear

    values = np.linspace(0, 1, 256)
    np.testing.assert_allclose(encoded(srgb_to_linear(values), True), values, atol=1e-7)
    assert encoded(np.array([-1.0, 0.25, 7.0]), False).tolist() == [0.0, 0.25, 1.0]
