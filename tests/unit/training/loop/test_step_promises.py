"""What a step does and says: everything on its device, and the metric that `evaluate` reports."""

from __future__ import annotations

import csv
import json
import sys
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from nscc_command import invoke

torch = pytest.importorskip("torch")

from safetensors.torch import load_file  # noqa: E402
from small_runs import run  # noqa: E402
from torch.optim.swa_utils import AveragedModel, get_ema_multi_avg_fn  # noqa: E402

from nscc_training.baselines import tensor_tv  # noqa: E402
from nscc_training.loop import train as loop  # noqa: E402
from nscc_training.loop.ranks import Ranks  # noqa: E402
from nscc_training.sensor_model import SensorModel  # noqa: E402
from nscc_training.settings import settings_of  # noqa: E402

DATA = {"patch": 16, "scenes": 3, "val_items": 2}
TRAIN = {"steps": 4, "batch": 2, "validate_every": 2, "code_rate": 0.05, "device": "cpu"}
STILL = {"shutter": {"class": "b", "slots": 16, "tile": [4, 4], "noise": 0.5}, "data": DATA}
CLIP = {
    "shutter": {"class": "d", "slots": 8, "tile": [4, 4], "noise": 0.5},
    "data": {**DATA, "protocol": "video-v1"},
}
RUNS: dict[str, dict[str, Any]] = {
    "a still": STILL,
    "a clip": CLIP,
    "a clip by trials": {**CLIP, "shutter": {**CLIP["shutter"], "relaxation": "tried"}},
    "a clip in 3D": {**CLIP, "decoder": {"name": "unet3d"}},
    "blocks": {**CLIP, "decoder": {"name": "fcnet"}},
    "pixels that look": {
        "shutter": {"class": "looks", "slots": 16, "exposures": 3, "relaxation": "tried"},
        "data": DATA,
    },
    "a codebook by gumbel": {
        **CLIP,
        "shutter": {
            "class": "codebook",
            "slots": 8,
            "tile": [4, 4],
            "rows": 4,
            "relaxation": "gumbel",
            "noise": 0.1,
        },
    },
    "two buckets": {
        "shutter": {"class": "e", "slots": 8, "tile": [4, 4], "buckets": 2, "target": "dual-tap"},
        "data": {**DATA, "protocol": "two-bucket-v1"},
    },
    "any": {**CLIP, "decoder": {"name": "any"}},
    "refined": {**CLIP, "decoder": {"name": "refined"}},
}
MOVES = ("cpu", "numpy", "tolist", "__array__", "item")


def values_of(name: str, **train: Any) -> dict[str, Any]:
    return {**RUNS[name], "train": {**TRAIN, **train}}


@contextmanager
def counted() -> Iterator[Counter[str]]:
    """How often tensors leave their device, by the names of the calls that do it."""
    found: Counter[str] = Counter()
    kept = {name: getattr(torch.Tensor, name) for name in MOVES}

    def watched(name: str) -> Any:
        def call(tensor: Any, *arguments: Any, **named: Any) -> Any:
            found[name] += 1
            return kept[name](tensor, *arguments, **named)

        return call

    with pytest.MonkeyPatch.context() as patch:
        for name in MOVES:
            patch.setattr(torch.Tensor, name, watched(name))
        yield found


def stepped(values: dict[str, Any], tmp_path: Path) -> Counter[str]:
    """What a step moves, of a run whose first step has been made."""
    begun = loop.start(settings_of(values), None, Ranks(), tmp_path)
    loop.update(begun, 0, begun.dataset[0])
    drawn = begun.dataset[1]
    with counted() as found:
        loop.update(begun, 1, drawn)
    return found


@pytest.mark.parametrize("name", RUNS)
def test_a_training_step_moves_no_tensor_off_its_device(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The operators of other devices replace the compiled loop of the CPU."""
    monkeypatch.setattr(tensor_tv, "tv_denoised", tensor_tv.tv_by_operators)
    assert stepped(values_of(name), tmp_path) == Counter()


@pytest.mark.parametrize("lessons", ["denoise", "codes", "stills"])
def test_nothing_of_a_lesson_leaves_its_device(
    lessons: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import cv2

    monkeypatch.setattr(tensor_tv, "tv_denoised", tensor_tv.tv_by_operators)
    noise = np.random.default_rng(5).integers(0, 255, (80, 90), np.uint8)
    (tmp_path / "in").mkdir()
    cv2.imwrite(str(tmp_path / "in/p.png"), noise)
    still = lessons == "stills"
    data = {**DATA, "train": str(tmp_path / "in"), "protocol": "hdr-v1" if still else "video-v1"}
    values = {
        "shutter": {"class": "b" if still else "c", "slots": 8, "tile": [2, 2], "learn": False},
        "decoder": {"name": "any", "lessons": lessons, "films": 0.5},
        "data": data,
        "train": TRAIN,
    }
    assert stepped(values, tmp_path) == Counter()


def test_the_counter_counts_moves_off_the_device() -> None:
    """`cpu()` and `item()` are counted once each, and the two conversions to numpy as at least
    two."""
    with counted() as found:
        torch.ones(2).cpu().numpy()
        np.asarray(torch.ones(2))
        torch.ones(1).item()
    assert found["cpu"] == found["item"] == 1
    assert found["numpy"] + found["__array__"] >= 2


def test_noise_is_drawn_where_the_run_is(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """On the device meta, which computes nothing, every draw names the device."""
    asked: set[str] = set()
    for name in ("randn", "rand", "randint"):
        kept = getattr(torch, name)

        def watched(*size: Any, kept: Any = kept, **named: Any) -> Any:
            asked.add(str(named.get("device")))
            return kept(*size, **named)

        monkeypatch.setattr(torch, name, watched)
    for name in ("a still", "a clip by trials", "a codebook by gumbel", "pixels that look"):
        stepped(values_of(name), tmp_path)
    assert asked == {"cpu"}


@pytest.mark.parametrize(
    "name", [*(n for n in RUNS if n not in ("any", "refined")), "with effects of"]
)
def test_evaluate_reports_the_scores_printed_while_training(name: str, tmp_path: Path) -> None:
    if name == "with effects of":
        values = {**STILL, "sensor": {"effects": "all"}, "train": {**TRAIN, "steps": 2}}
    else:
        values = values_of(name)
    told: list[str] = []
    run(values, tmp_path / "r", report=told.append)
    step = json.loads((tmp_path / "r/result.json").read_text())["step"]
    with open(tmp_path / "r/metrics.csv", newline="") as file:
        [row] = [r for r in csv.DictReader(file) if (r["split"], r["step"]) == ("val", str(step))]
    done = invoke(["evaluate", "r", "--split", "val", "--json"], tmp_path)
    assert done.status == 0, done.err
    found = json.loads(done.out)
    assert found["split"] == "val"
    assert repr(found["mean"]) == row["psnr_db"]
    ssim = float(np.mean([item["ssim"] for item in found["items"]]))
    assert ssim == pytest.approx(float(row["ssim"]), abs=1e-12)
    assert any(f"step {step}: " in text and f", {found['mean']:.2f} dB" in text for text in told)
    result = json.loads((tmp_path / "r/result.json").read_text())
    assert result["headline"]["psnr_db"] == found["mean"]


def test_other_validation_scenes_are_refused(tmp_path: Path) -> None:
    run(values_of("a still", steps=2), tmp_path / "r")
    split = tmp_path / "r/split.json"
    split.write_text(split.read_text().replace('"sha256": "', '"sha256": "0'))
    (tmp_path / "r/result.json").write_text(
        json.dumps(
            {
                k: v
                for k, v in json.loads((tmp_path / "r/result.json").read_text()).items()
                if k != "split_sha256"
            }
        )
    )
    assert invoke(["evaluate", "r", "--split", "val"], tmp_path).codes == ["NS0811"]
    for more in ([], ["--data", "."], ["--split", "val", "--data", "."]):
        assert invoke(["evaluate", "r", *more], tmp_path).status == 2


def test_the_stored_weights_are_the_moving_average(tmp_path: Path) -> None:
    """The expected weights are a moving average over the weights of every step."""
    values = values_of("a still", average=0.6, steps=4, validate_every=4)
    settings = settings_of(values)
    begun = loop.start(settings, None, Ranks(), tmp_path)
    own = AveragedModel(begun.setup.decoder, multi_avg_fn=get_ema_multi_avg_fn(0.6))
    for step in range(4):
        loop.update(begun, step, begun.dataset[step])
        own.update_parameters(begun.setup.decoder)
    run(values, tmp_path / "r")
    kept = load_file(tmp_path / "r/decoder.safetensors")
    for name, value in own.module.state_dict().items():
        assert torch.equal(kept[name], value), name
    last = begun.setup.decoder.state_dict()
    assert any(not torch.equal(kept[name], last[name]) for name in kept)


@pytest.mark.slow
def test_batches_by_other_processes_are_the_same(tmp_path: Path) -> None:
    run(values_of("a clip", steps=2), tmp_path / "own")
    run(values_of("a clip", steps=2, workers=2), tmp_path / "two")
    files = [(tmp_path / k / "decoder.safetensors").read_bytes() for k in ("own", "two")]
    assert files[0] == files[1]


@pytest.mark.filterwarnings("ignore:The .grad attribute of a Tensor")  # of torch's own tracing
@pytest.mark.filterwarnings("ignore:.*should not be instantiated:DeprecationWarning")
def test_a_decoder_is_compiled_if_the_setting_asks(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = []
    kept = torch.compile

    def watched(*arguments: Any, **named: Any) -> Any:
        asked.append(True)
        return kept(*arguments, **{**named, "backend": "eager"})

    monkeypatch.setattr(torch, "compile", watched)
    run(values_of("a still", steps=2, compile=True), tmp_path / "r")
    run(values_of("a still", steps=2), tmp_path / "plain")
    assert asked
    one, other = (load_file(tmp_path / k / "decoder.safetensors") for k in ("r", "plain"))
    assert all(torch.allclose(one[name], other[name], atol=1e-5) for name in other)


def test_event_files_are_written_where_tensorboard_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The events have the numbers of metrics.csv; without the package no folder is written."""
    told: list[tuple[str, float, int]] = []

    class Writer:
        def __init__(self, folder: str) -> None:
            Path(folder).mkdir(parents=True)

        def add_scalar(self, name: str, value: float, step: int) -> None:
            told.append((name, value, step))

        def flush(self) -> None: ...

        def close(self) -> None: ...

    module = ModuleType("torch.utils.tensorboard")
    module.SummaryWriter = Writer  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "torch.utils.tensorboard", module)
    monkeypatch.setattr("nscc_training.loop.train.find_spec", lambda _name: None)
    run(values_of("a still", steps=2), tmp_path / "without")
    assert not told
    assert not (tmp_path / "without/tensorboard").exists()
    monkeypatch.setattr("nscc_training.loop.train.find_spec", lambda _name: True)
    run(values_of("a still", steps=2), tmp_path / "r")
    assert (tmp_path / "r/tensorboard").is_dir()
    with open(tmp_path / "r/metrics.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        for name in ("loss", "psnr_db", "ssim", "words_per_slot"):
            if row[name]:
                assert (f"{row['split']}/{name}", float(row[name]), int(row["step"])) in told


def test_the_sensor_s_gradient_does_not_loop_over_samples() -> None:
    """The gradient of shutters for many clips equals the sum of those of single clips."""
    from nscc_training.sensor_model import exposed, read_out

    generator = torch.Generator().manual_seed(1)
    light = torch.rand(3, 40, 5, 6, generator=generator) * 1e3
    shutters = torch.rand(40, 5, 6, generator=generator, requires_grad=True)
    frame = read_out(exposed(light, shutters), SensorModel(1e6, 10.0, adc_bits=20))
    weight = torch.rand(frame.shape, generator=generator)
    (found,) = torch.autograd.grad((frame * weight).sum(), shutters)
    wanted = (light * weight[:, None] / 10).sum(dim=0)
    torch.testing.assert_close(found, wanted, rtol=1e-4, atol=1e-4)
