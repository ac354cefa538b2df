"""The training loop in miniature: what it writes, how it goes on, when it stops."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from checkout import ROOT
from nscc_command import invoke

torch = pytest.importorskip("torch")

from safetensors.torch import load_file  # noqa: E402
from small_runs import CLIP, FILES, STILL, changed, run  # noqa: E402

from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_training.loop import artifacts  # noqa: E402
from nscc_training.loop import train as loop  # noqa: E402
from nscc_training.loop.optimizers import (  # noqa: E402
    anneal,
    codes_learn,
    cycle_of,
    set_rates,
    settling_step,
)
from nscc_training.loop.ranks import Ranks  # noqa: E402
from nscc_training.loop.train import train  # noqa: E402
from nscc_training.sensor_model import read_out  # noqa: E402
from nscc_training.settings import config_toml, settings_of  # noqa: E402


@pytest.mark.parametrize("values", [STILL, CLIP], ids=["still", "clip"])
def test_a_run_writes_all_promised_files(values: dict[str, Any], tmp_path: Path) -> None:
    run(values, tmp_path / "r")
    assert {path.name for path in (tmp_path / "r").iterdir()} == FILES
    head, *rows = (tmp_path / "r" / "metrics.csv").read_text().splitlines()
    assert head.split(",")[:6] == ["step", "split", "loss", "psnr_db", "ssim", "words_per_slot"]
    steps = values["train"]["steps"]
    assert [row.split(",")[:2] for row in rows] == [
        [str(k), part] for k in range(2, steps + 1, 2) for part in ("train", "val")
    ]
    found = json.loads((tmp_path / "r" / "result.json").read_text())
    assert found["stages"]["compiled_equals_hard"] is True
    assert found["stages"]["hard"] == found["stages"]["compiled"]
    assert found["stages"]["emulated"] == pytest.approx(found["stages"]["hard"], abs=0.01)
    card = (tmp_path / "r" / "model_card.md").read_text()
    scores_db = [found["stages"][stage] for stage in ("soft", "hard", "compiled", "emulated")]
    assert f"\n| {' | '.join(f'{score_db:.2f}' for score_db in scores_db)} |\n" in card
    assert len(found["robustness"]) == 8
    built = invoke(
        ["build", "shutter.nsl", "-O", "1", "-o", str(tmp_path / "s.icw")], tmp_path / "r"
    )
    assert built.status == 0, built.err
    for name, digest in found["files"].items():
        from hashlib import sha256

        assert sha256((tmp_path / "r" / name).read_bytes()).hexdigest() == digest


def test_robustness_is_of_the_sensors_and_exposures_that_it_names(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each row by what its sensor makes of a flat field of 9000 electrons and of a bright one."""
    seen: list[tuple[Any, float]] = []
    by_model, validated = artifacts.by_model, artifacts.validated

    def watched(parts: Any, shown: Any, decode: Any = None, exposure: float = 1.0) -> Any:
        if isinstance(decode, tuple):
            seen.append((decode[0], exposure))
        return validated(parts, shown, decode[1] if isinstance(decode, tuple) else decode, exposure)

    def by(parts: Any, tile: Any = None, model: Any = None) -> Any:
        decode = by_model(parts, tile, model)
        return decode if model is None or tile is not None else (model, decode)

    monkeypatch.setattr(artifacts, "validated", watched)
    monkeypatch.setattr(artifacts, "by_model", by)
    run(changed(STILL, "train", steps=1), tmp_path / "r")
    rows = json.loads((tmp_path / "r" / "result.json").read_text())["robustness"]
    gain = 30000 / 255
    found = {}
    for row, (model, exposure) in zip(rows, seen[-len(rows) :], strict=True):
        generator = torch.Generator().manual_seed(1)
        flat = torch.full((1, 300, 300), 9000.0 * exposure, dtype=torch.float64)
        frame = read_out(flat, model, generator).double()
        bright = read_out(flat * 100, replace(model, adc_bits=16)).double()
        found[row["change"]] = [frame.mean().item(), frame.var().item(), bright.max().item()]
    mean, full = 9000 / gain, 255
    # photons and readout; the rounding does not grow with them
    noise = 9000 / gain**2 + 0.65**2
    wanted = {
        "as trained": [mean, noise + 1 / 12, full],
        "full well -20 %": [mean, noise + 1 / 12, 0.8 * full],
        "full well +20 %": [mean, noise + 1 / 12, 1.2 * full],
        "electrons a code -20 %": [mean / 0.8, noise_at(0.8) + 1 / 12, full / 0.8],
        "electrons a code +20 %": [mean / 1.2, noise_at(1.2) + 1 / 12, full / 1.2],
        "noise x 2": [mean, 4 * noise + 1 / 12, full],
        "exposure x 0.5": [mean / 2, 4500 / gain**2 + 0.65**2 + 1 / 12, full],
        "exposure x 2": [mean * 2, 18000 / gain**2 + 0.65**2 + 1 / 12, full],
    }
    assert list(found) == list(wanted)
    for name, (mean, spread, top) in wanted.items():
        assert found[name] == [
            pytest.approx(mean, rel=2e-3),
            pytest.approx(spread, rel=0.05),
            pytest.approx(top, abs=0.6),
        ], name


def noise_at(factor: float) -> float:
    """The variance of 9000 electrons where a code is so many times 30000 / 255 of them."""
    return 9000 / (factor * 30000 / 255) ** 2 + 0.65**2


@pytest.mark.parametrize("name", ["unrolled", "refined"])
def test_codes_learn_through_projections(name: str, tmp_path: Path) -> None:
    """Codes behind an unrolled decoder differ from those of a run with `learn=False`. The compiled
    program has the learned shutters."""
    shutter = {"class": "e", "slots": 6, "tile": [4, 4], "init": "random"}
    values = {**CLIP, "shutter": shutter, "decoder": {"name": name}}
    values = changed(values, "train", code_rate=1.0)
    run(values, tmp_path / "r")
    run(changed(values, "shutter", learn=False), tmp_path / "frozen")
    learned, frozen = (np.load(tmp_path / k / "codes.npz")["bits"] for k in ("r", "frozen"))
    assert not np.array_equal(learned, frozen)
    found = json.loads((tmp_path / "r" / "result.json").read_text())
    assert found["parameters"] <= 600_000 < found["flops"]
    assert found["stages"]["compiled_equals_hard"] is True


def test_patches_larger_than_the_array_are_emulated_as_far_as_it_reaches(tmp_path: Path) -> None:
    """Patches of 272 pixels are wider than the chip's 256. The emulator's score is that of the
    model within 1 dB."""
    values = changed(STILL, "data", patch=272, scenes=2, val_items=1, augment=False)
    values = changed(values, "train", steps=1, batch=1)
    run(changed(values, "decoder", name="unet2d", sees_code=False), tmp_path)
    stages = json.loads((tmp_path / "result.json").read_text())["stages"]
    assert stages["emulated"] == pytest.approx(stages["hard"], abs=1.0)


def test_codes_that_are_not_learned_keep_their_start(tmp_path: Path) -> None:
    """The stops stay those of the pattern `quad`. Given as the start of a second run, they stay
    again."""
    run(changed(STILL, "shutter", learn=False, init="quad"), tmp_path / "r")
    stop = np.load(tmp_path / "r" / "codes.npz")["stop"]
    assert stop.tolist() == [[16, 4, 16, 4], [1, 1, 1, 1]] * 2
    run(
        changed(STILL, "shutter", init=str(tmp_path / "r" / "codes.npz"), learn=False),
        tmp_path / "again",
    )
    assert np.array_equal(np.load(tmp_path / "again" / "codes.npz")["stop"], stop)


def test_learned_codes_differ_from_codes_that_are_not_learned(tmp_path: Path) -> None:
    run(STILL, tmp_path / "r")
    run(changed(STILL, "shutter", learn=False), tmp_path / "frozen")
    learned, frozen = (np.load(tmp_path / k / "codes.npz")["stop"] for k in ("r", "frozen"))
    assert not np.array_equal(learned, frozen)


@pytest.mark.parametrize("name", ["bad_loss", "steep_loss"])
def test_values_that_are_not_finite_stop_before_the_step(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "losses_of_tests.py").write_text(
        "import torch\n"
        "def bad_loss(p, t):\n    return (p - t).sum() * float('nan')\n"
        "def steep_loss(p, t):\n    return torch.sqrt((p - p.detach()).abs().sum())\n"
    )
    monkeypatch.chdir(tmp_path)
    values = changed(STILL, "loss", name=f"losses_of_tests:{name}")
    (tmp_path / "c.toml").write_text(config_toml(settings_of(values)))
    outcome = invoke(["train", "c.toml", "--out", "r"], tmp_path)
    assert (outcome.status, outcome.codes) == (3, ["NS0817"])
    assert "procedural-train-" in outcome.err
    assert "step 0" in outcome.err
    assert not (tmp_path / "r" / "checkpoint.safetensors").exists()


def test_data_of_the_user_are_imported_by_path_and_checked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "data_of_tests.py").write_text(
        "import numpy as np\n"
        "def scenes(kind, part, slots, seed):\n"
        "    rng = np.random.default_rng([seed, part == 'val'])\n"
        "    return [(f'{part}{k}', rng.random((20, 24))) for k in range(2)]\n"
        "def dark(kind, part, slots, seed):\n"
        "    return [('one', -np.ones((20, 20)))]\n"
    )
    monkeypatch.chdir(tmp_path)
    run(
        changed(STILL, "data", train="data_of_tests:scenes", val="data_of_tests:scenes"),
        tmp_path / "r",
    )
    split = json.loads((tmp_path / "r" / "split.json").read_text())
    assert [s["file"] for s in split["train"]] == ["train0", "train1"]
    with pytest.raises(Rejected, match="NS0811"):
        run(changed(STILL, "data", train="data_of_tests:dark"), tmp_path / "no")
    same = changed(STILL, "data", train="data_of_tests:dark", val="data_of_tests:dark")
    with pytest.raises(Rejected, match="NS0811"):
        run(same, tmp_path / "no")


def test_training_in_bf16_stores_weights_in_float32(tmp_path: Path) -> None:
    run(changed(STILL, "train", dtype="bf16"), tmp_path / "r")
    weights = load_file(tmp_path / "r" / "decoder.safetensors")
    assert {w.dtype for w in weights.values()} == {torch.float32}


def test_two_processes_learn_the_same_parameters(tmp_path: Path) -> None:
    """Both processes have the same parameters after every step, and only one writes. Neither ends
    while an object still holds their group: its threads would abort when the interpreter ends."""
    (tmp_path / "c.toml").write_text(config_toml(settings_of(STILL)))
    root = ROOT
    paths = os.pathsep.join(str(root / part) for part in (".", "cli", "runtime", "training"))
    code = (
        "import sys, weakref\n"
        "from torch import distributed\n"
        "from nscc_cli.main import main\n"
        "from nscc_training.loop.ranks import Ranks\n"
        "groups, close = [], Ranks.close\n"
        "def watched(ranks):\n"
        "    groups.append(weakref.ref(distributed.group.WORLD))\n"
        "    close(ranks)\n"
        "Ranks.close = watched\n"
        "status = main(['train', 'c.toml', '--out', 'r'])\n"
        "assert [group() for group in groups] == [None], 'the group outlives its end'\n"
        "sys.exit(status)\n"
    )
    (tmp_path / "go.py").write_text(code)
    done = subprocess.run(
        [
            sys.executable,
            "-m",
            "torch.distributed.run",
            "--standalone",
            "--nproc-per-node",
            "2",
            "go.py",
        ],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": paths, "OMP_NUM_THREADS": "1"},
        capture_output=True,
        text=True,
        timeout=110,
    )
    assert done.returncode == 0, done.stderr[-3000:]
    assert done.stderr.count("model_card.md says") == 1
    assert {path.name for path in (tmp_path / "r").iterdir()} == FILES
    run(STILL, tmp_path / "alone")
    both, alone = (load_file(tmp_path / k / "decoder.safetensors") for k in ("r", "alone"))
    # the patches are the same; the noise of the second half of a batch is another
    for key in both:
        assert torch.allclose(both[key], alone[key], atol=0.02)


def test_every_process_needs_a_patch(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A mean over no patch is not finite, so the training is refused with the number of
    processes."""

    class ThreeRanks(Ranks):
        def __init__(self) -> None:
            super().__init__()
            self.count = 3

    monkeypatch.setattr(f"{train.__module__}.Ranks", ThreeRanks)
    with pytest.raises(Rejected, match="3 processes") as caught:
        run(STILL, tmp_path / "r")
    assert [d.code for d in caught.value.diagnostics] == ["NS0815"]


def test_a_still_run_reconstructs_its_frames_and_refuses_others(tmp_path: Path) -> None:
    run(changed(STILL, "train", steps=2), tmp_path / "r")
    exposed = invoke(
        ["run", "r/shutter.nsl", "-O", "1", "--scene", "builtin:hdr", "-o", "f.npz"], tmp_path
    )
    assert exposed.status == 0, exposed.err
    made = invoke(["reconstruct", "r", "f.npz", "-o", "o.npz"], tmp_path)
    assert made.status == 0, made.err
    image = np.load(tmp_path / "o.npz")["image"]
    assert (image.shape, image.dtype) == ((256, 256), np.float32)
    assert np.isfinite(image).all()
    (tmp_path / "other.nsl").write_text(
        "nsl 1\nframe 16 slots of 125us\ncode stop : 1..16\nopen when n < stop\npixels stop = 5\n"
    )
    for more in ([], ["--keep", "shutter"]):
        invoke(["run", "other.nsl", "--scene", "builtin:hdr", "-o", "x.npz", *more], tmp_path)
        refused = invoke(["reconstruct", "r", "x.npz", "-o", "p.npz"], tmp_path)
        assert (refused.status, refused.codes) == (2, ["NS0819"])
        assert not (tmp_path / "p.npz").exists()
    forced = invoke(["reconstruct", "r", "x.npz", "-o", "p.npz", "--force"], tmp_path)
    assert (forced.status, forced.codes) == (0, ["NS0819"])
    kept = ["run", "r/shutter.nsl", "--scene", "builtin:hdr", "--keep", "shutter", "-O", "0"]
    invoke([*kept, "-o", "k.npz"], tmp_path)
    assert invoke(["reconstruct", "r", "k.npz", "-o", "k2.npz"], tmp_path).status == 0
    invoke([*kept, "-o", "g.npz", "--sensor-set", "electrons_per_lsb=50"], tmp_path)
    other = invoke(["reconstruct", "r", "g.npz", "-o", "p2.npz"], tmp_path)
    assert other.codes == ["NS0819"]
    assert "electrons_per_lsb" in other.err
    (tmp_path / "broken.npz").write_bytes(b"PK")
    with np.load(tmp_path / "k.npz") as file:
        whole = dict(file)
    np.savez(tmp_path / "part.npz", **{**whole, "frame": whole["frame"][:, :30]})
    np.savez(tmp_path / "empty.npz", **{**whole, "frame": whole["frame"][:, :0]})
    np.savez(tmp_path / "flat.npz", **{**whole, "shutter": whole["shutter"][0]})
    for name in ("broken.npz", "o.npz", "none.npz", "part.npz", "empty.npz", "flat.npz"):
        refused = invoke(["reconstruct", "r", name, "-o", "q.npz", "--force"], tmp_path)
        assert (refused.status, refused.codes) == (2, ["NS0819"])
    assert "NS0818" in invoke(["reconstruct", ".", "f.npz", "-o", "q.npz"], tmp_path).codes
    (tmp_path / "r" / "decoder.safetensors").write_bytes(b"\x00" * 9)
    assert "NS0818" in invoke(["reconstruct", "r", "f.npz", "-o", "q.npz"], tmp_path).codes


@pytest.mark.parametrize("relaxation", ["straight-through", "tried"])
def test_settled_codes_stay_and_the_decoder_learns(relaxation: str, tmp_path: Path) -> None:
    """Codes are frozen from half of the run on; before, and without settling, they change."""

    def at(step: int, settle: float) -> dict[str, Any]:
        out = tmp_path / f"r{settle}"
        values = changed(STILL, "shutter", settle=settle, relaxation=relaxation)
        run(values, out, stop_after=step)
        return dict(load_file(out / "checkpoint.safetensors"))

    for settle in (0.0, 0.5):
        early, middle, late = (at(step, settle) for step in (2, 4, 5))
        assert not torch.equal(early["encoder.stop"], middle["encoder.stop"])
        assert torch.equal(middle["encoder.stop"], late["encoder.stop"]) == (settle > 0)
        key = "decoder.network.last.weight"
        assert not torch.equal(middle[key], late[key])
    rows = (tmp_path / "r0.5" / "metrics.csv").read_text().splitlines()
    shares = {row.split(",")[0]: row.split(",")[6] for row in rows[1:] if ",val," in row}
    assert shares["2"] != ""
    assert shares["4"] == shares["5"] == ""


def test_codes_wait_for_the_decoder(tmp_path: Path) -> None:
    """With `warm_up=0.5` of four steps, the stops do not change from step 1 to 2 and have changed
    at 4. The decoder changes at once."""
    values = changed(STILL, "shutter", warm_up=0.5, settle=0.0, relaxation="tried")
    found = []
    for step in (1, 2, 4):
        run(values, tmp_path / "r", stop_after=step)
        found.append(dict(load_file(tmp_path / "r" / "checkpoint.safetensors")))
    one, two, four = found
    assert torch.equal(one["encoder.stop"], two["encoder.stop"])
    assert not torch.equal(two["encoder.stop"], four["encoder.stop"])
    key = "decoder.network.last.weight"
    assert not torch.equal(one[key], two[key])


def test_rates_rise_in_the_first_steps() -> None:
    """Rates rise in at most 20 steps, and in at most a fiftieth of all steps."""
    parameter = torch.nn.Parameter(torch.zeros(1))
    optimizer = torch.optim.Adam([{"params": [parameter], "base": 0.5}])
    for schedule, steps, risen in (("constant", 1000, 20), ("cosine", 100, 2), ("cosine", 40, 0)):
        settings = settings_of(
            {"train": {"steps": steps, "schedule": schedule}, "shutter": {"learn": False}}
        )
        rates = []
        for step in range(steps):
            set_rates([optimizer], settings, step)
            rates.append(optimizer.param_groups[0]["lr"])
        cosine = 0.5 + 0.5 * np.cos(np.pi * np.arange(steps) / steps)
        full = np.where(schedule == "cosine", cosine, 1.0) * 0.5
        rising = np.arange(1, risen + 1) / (risen + 1)
        np.testing.assert_allclose(rates[:risen], full[:risen] * rising)
        np.testing.assert_allclose(rates[risen:], full[risen:])


def test_a_run_learns_from_each_start_and_then_settles() -> None:
    """The first 60 of 100 steps contain three starts. Each has a cycle of rates and of noise, and
    its own steps of `warm_up`. Then only the decoder learns."""
    values = {"settle": 0.4, "restarts": 2, "warm_up": 0.15, "noise": 1.0}
    settings = settings_of({"train": {"steps": 100}, "shutter": values})
    assert settling_step(settings) == 60
    cycles = [(0, 20), (20, 40), (40, 60), (60, 100)]
    assert sorted({cycle_of(settings, step) for step in range(100)}) == cycles
    learning = [step for step in range(100) if codes_learn(settings, step)]
    assert learning == [*range(5, 20), *range(25, 40), *range(45, 60)]
    parameter = torch.nn.Parameter(torch.zeros(1))
    optimizer = torch.optim.Adam([{"params": [parameter], "base": 1.0}])
    setup = SimpleNamespace(settings=settings, encoder=SimpleNamespace())
    for first, last in cycles:
        rates, noise = [], []
        for step in range(first, last):
            set_rates([optimizer], settings, step)
            anneal(setup, step)  # type: ignore[arg-type]
            rates.append(optimizer.param_groups[0]["lr"])
            noise.append(setup.encoder.noise)
        falling = 0.5 + 0.5 * np.cos(np.pi * np.arange(last - first) / (last - first))
        np.testing.assert_allclose(rates, falling)
        expected = np.zeros(40) if first == 60 else np.linspace(1, 0, 20)
        np.testing.assert_allclose(noise, expected, atol=1e-12)


@pytest.mark.parametrize("decoder", [{"name": "divided"}, {"name": "any", "learn": False}])
def test_codes_learn_to_the_end_if_no_decoder_does(decoder: dict[str, Any]) -> None:
    """A decoder without weights, or one that does not learn, needs no last steps of its own: codes
    learn in all 100."""
    settings = settings_of({"train": {"steps": 100}, "decoder": decoder})
    assert settling_step(settings) == 100
    assert codes_learn(settings, 99)


def test_the_best_of_several_starts_settles(tmp_path: Path) -> None:
    """A run with restarts is, at the begin of settling, the best state that validation found; it
    resumes bit by bit, across restarts too."""
    values = changed(STILL, "shutter", restarts=1, settle=0.34)
    values = changed(values, "train", validate_every=1)
    run(values, tmp_path / "whole", stop_after=4)
    state = dict(load_file(tmp_path / "whole" / "checkpoint.safetensors"))
    rows = [row.split(",") for row in (tmp_path / "whole/metrics.csv").read_text().splitlines()]
    losses = {int(row[0]): float(row[2]) for row in rows if row[1] == "val"}
    run(values, tmp_path / "begun", stop_after=min(losses, key=lambda step: losses[step]))
    best = dict(load_file(tmp_path / "begun" / "checkpoint.safetensors"))
    key = "encoder.stop"
    assert torch.equal(state[f"best.{key}"], best[key])
    run(values, tmp_path / "whole", stop_after=5)
    settled = dict(load_file(tmp_path / "whole" / "checkpoint.safetensors"))
    assert torch.equal(settled[key], best[key])
    run(values, tmp_path / "begun")
    run(values, tmp_path / "whole")
    for name in FILES:
        assert (tmp_path / "whole" / name).read_bytes() == (tmp_path / "begun" / name).read_bytes()


def test_a_wide_network_survives_its_first_steps(tmp_path: Path) -> None:
    """Without rising rates its output was infinite after the first step."""
    values = {
        "shutter": {"class": "b", "slots": 256, "tile": [4, 4], "init": "quad"},
        "data": {"patch": 64, "scenes": 8, "val_items": 1},
        "decoder": {"size": "paper"},
        "loss": {"name": "psnr+psnr-mu"},
        "train": {"steps": 1000, "batch": 2},
    }
    started = loop.start(settings_of(values), None, Ranks(), tmp_path)
    for step, drawn in enumerate(loop.loader_of(started, 0, 2)):
        assert abs(float(loop.update(started, step, drawn).detach())) < 20
