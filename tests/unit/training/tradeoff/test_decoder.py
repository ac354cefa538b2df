"""`nscc tradeoff decoder`: scores are those of what a decoder makes, networks come from runs."""

from __future__ import annotations

import csv
import io
from dataclasses import replace
from functools import partial
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from nscc_command import invoke
from PIL import Image
from scipy.io import savemat

torch = pytest.importorskip("torch")

from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_training.command_settings import DecoderStudySettings  # noqa: E402
from nscc_training.decoders.blocks import BlockNet  # noqa: E402
from nscc_training.decoders.declared import DECODERS, DecoderTask  # noqa: E402
from nscc_training.evaluation.methods import CLIPS, CapturedScene  # noqa: E402
from nscc_training.experiments.study import StudyPoint, measure  # noqa: E402
from nscc_training.loop.decoding import decoded_frame  # noqa: E402
from nscc_training.loop.train import train  # noqa: E402
from nscc_training.protocol_scenes.file_scenes import protocol_of, some_scenes  # noqa: E402
from nscc_training.run_folder import load_run  # noqa: E402
from nscc_training.settings import settings_of  # noqa: E402
from nscc_training.tradeoff import decoder  # noqa: E402
from nscc_training.tradeoff.decoder import (  # noqa: E402
    decoder_points,
    decoder_study,
)

TINY = DecoderStudySettings(count=2, size=32, repeats=1, budget_s=1e6)


def trained(out: Path, name: str, protocol: str, slots: int) -> Path:
    values: dict[str, dict[str, Any]] = {
        "shutter": {"class": "b", "slots": slots, "tile": [4, 4]},
        "decoder": {"name": name},
        "data": {"protocol": protocol, "patch": 16, "scenes": 2, "val_items": 1},
        "train": {"steps": 1, "batch": 1, "validate_every": 1, "device": "cpu"},
    }
    train(settings_of(values), out)
    return out


@pytest.fixture(scope="module")
def clip_run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return trained(tmp_path_factory.mktemp("run") / "u", "unet3d", "video-v1", 4)


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """The dictionary and filters take a minute to learn: their methods have tests of their own."""
    kept = decoder.untrained

    def few(kind: Any) -> list[decoder.Decoder]:
        return [way for way in kept(kind) if way[0] not in ("dictionary", "sparse-coding")]

    monkeypatch.setattr(decoder, "untrained", few)


def captures_of(point: StudyPoint) -> list[CapturedScene]:
    """The captures that a decoder is scored on."""
    assert isinstance(point.figures, partial)
    return [*point.figures.args[0]]


def test_the_study_has_every_clip_method_that_sees_the_capture() -> None:
    """The methods are those of CLIPS that see the capture. GAP-TV has five settings, from 5 to 80
    iterations."""
    methods = [method for method, *_ in decoder.untrained("clips")]
    assert set(methods) == {name for name, each in CLIPS.items() if each.sees == "capture"}
    assert [way[1] for way in decoder.untrained("clips") if way[0] == "gap-tv"] == [
        "5",
        "10",
        "20",
        "40",
        "80",
    ]


def test_scores_of_the_method_adjoint_equal_those_computed_from_the_captures(quick: None) -> None:
    study = decoder_study([], replace(TINY, repeats=2))
    [asked] = [each for each in study.points if each.method == "adjoint"]
    points = measure(replace(study, points=[asked])).points
    values = []
    for taken in captures_of(asked):
        light = taken.scene.light_e
        mask = taken.masks[0]
        opened = mask.sum(axis=0)
        exposure = taken.codes[0] * (30000 / 255)
        # Noise and saturation apart, a frame holds the light of the open slots.
        whole = (light * mask).sum(axis=0)
        assert np.corrcoef(np.minimum(whole, 30000).ravel(), exposure.ravel())[0, 1] > 0.99
        made = mask * (exposure / np.maximum(opened, 1))
        pair = [np.clip(x / taken.scene.scale_e, 0, 1) for x in (light, made)]
        frames = zip(*pair, strict=True)
        values.append(np.mean([-10 * np.log10(np.mean((a - b) ** 2)) for a, b in frames]))
    assert [p.error_unit for p in points] == ["psnr_db", "ssim"]
    assert points[0].error == pytest.approx(np.mean(values), abs=1e-3)
    assert all(len(p.times_ms) == 2 and p.more_is_better for p in points)


def test_the_budget_ends_repeats_but_nothing_is_left_out(quick: None) -> None:
    """A budget of 0 s ends after one of 50 repeats, with every point measured."""
    tight = decoder_study([], replace(TINY, repeats=50, budget_s=0.0))
    found = measure(tight)
    assert found.repeats == 1
    assert len(found.points) == 2 * len(tight.points)


def test_scores_depend_on_the_seed_alone(quick: None) -> None:
    """The same seed gives the same errors, whatever the times were. Another seed gives others."""
    first, second, other = (
        [
            (p.case, p.method, p.setting, p.error)
            for p in measure(decoder_study([], replace(TINY, seed=seed))).points
        ]
        for seed in (0, 0, 1)
    )
    assert first == second
    assert [row[-1] for row in first] != [row[-1] for row in other]


def test_a_part_of_a_frame_is_decoded_by_its_own_shutters(clip_run: Path) -> None:
    """Tiles are 4 x 4: parts at whole tiles are alike, others not."""
    folder, rng = load_run(clip_run), np.random.default_rng(3)
    codes = rng.integers(10, 200, (24, 20)).astype(np.uint8)
    full = np.zeros(codes.shape, bool)
    made = [decoded_frame(folder.setup, codes, full, corner=at) for at in ((0, 0), (8, 4), (1, 0))]
    assert made[0].shape == (4, 24, 20)
    np.testing.assert_array_equal(made[0], made[1])
    assert not np.allclose(made[0], made[2])


def test_runs_with_equal_codes_share_captures_in_the_study(
    quick: None, clip_run: Path, tmp_path: Path
) -> None:
    """A run with another code has a case of its own."""
    made = [
        trained(tmp_path / "f", "fcnet", "video-v1", 4),
        clip_run,
        trained(tmp_path / "s", "unet2d", "hdr-v1", 16),
    ]
    runs = [load_run(path) for path in made]
    study = decoder_study(runs, replace(TINY, count=1))
    names = [each.case for each in study.points]
    assert [*dict.fromkeys(names)] == ["clips, code of f", "stills, code of s"]
    methods = {(each.method, each.setting) for each in study.points if each.case == names[0]}
    assert {("unet3d small", "f32"), ("unet3d small", "bf16")} <= methods
    assert {("fcnet small", f"x{k} {d}") for k in (1, 2, 4) for d in ("f32", "bf16")} <= methods
    tile = runs[0].setup.encoder.hard().numpy()
    assert np.array_equal(captures_of(study.points[0])[0].masks[0, :, :4, :4], tile)
    assert all(np.isfinite(p.error) for p in measure(study).points)


def test_the_study_decodes_with_the_network_of_the_run(clip_run: Path) -> None:
    """The exact point is the run's own network, in electrons a slot. The rough one is less exact,
    but near."""
    folder = load_run(clip_run)
    points = decoder_points([folder], replace(TINY, count=1))
    exact, rough = (each for each in points if each.method == "unet3d small")
    [taken] = captures_of(exact)
    with torch.no_grad():
        frame = torch.from_numpy(taken.codes) / 255
        wanted = folder.setup.decoder(frame, torch.from_numpy(taken.masks[0]))[0].numpy()
    assert np.allclose(exact.run()[0], wanted * (30000 / 4), rtol=1e-4, atol=0.1)
    error = np.abs(rough.run()[0] - exact.run()[0]).max()
    assert 0 < error < 0.1 * np.abs(exact.run()[0]).max() + 10


def test_without_overlap_each_block_has_the_result_of_the_network_alone() -> None:
    """Each pixel then belongs to one block."""
    torch.manual_seed(1)
    net = BlockNet((8,), DecoderTask("clip", 3, (2, 2)), "small")
    frame = torch.rand(1, 10, 7)
    both = net(frame, torch.ones(3, 2, 2))
    net.overlapping = (False, False)
    apart = net(frame, torch.ones(3, 2, 2))
    block = net.layers(frame[:, 4:8, :4].reshape(1, -1)).reshape(3, 4, 4)
    assert torch.allclose(apart[0, :, 4:8, :4], block, atol=1e-6)
    assert apart.shape == both.shape == (1, 3, 10, 7)
    assert not torch.allclose(apart, both)


def test_made_scenes_are_exposed_as_the_protocol_says() -> None:
    """Of a still 30 % of the pixels saturate. Of a clip the 99th percentile of the sum is a full
    well."""
    protocol = protocol_of("stills", 64, 1)
    [still] = some_scenes(protocol, None, 1)
    assert np.mean(still.light_e >= 30000) == pytest.approx(0.3, abs=0.005)
    [clip] = some_scenes(protocol_of("clips", 32, 8), None, 1)
    assert clip.light_e.shape == (8, 32, 32)
    assert np.percentile(clip.light_e.sum(axis=0), 99) == pytest.approx(30000)


def test_tradeoff_decoder_writes_table_and_diagram(quick: None, tmp_path: Path) -> None:
    done = invoke(
        ["tradeoff", "decoder", "--scenes", "1", "--size", "32", "--repeats", "1", "-o", "out"],
        tmp_path,
    )
    assert done.status == 0, done.err
    runs = [name for name, decoder in DECODERS.items() if not decoder.fixed_channels]
    assert f"not measured: {', '.join(runs)};" in done.out
    rows = list(csv.DictReader(io.StringIO((tmp_path / "out.csv").read_text())))
    assert {row["error_unit"] for row in rows} == {"psnr_db", "ssim"}
    assert {row["method"] for row in rows} >= {"clips, random bits, gap-tv"}
    for unit in ("psnr_db", "ssim"):
        clips = [r for r in rows if r["method"].startswith("clips") and r["error_unit"] == unit]
        best = max(clips, key=lambda row: float(row["error"]))
        assert best["dominated"] == "no"
    Image.open(tmp_path / "out.png").verify()


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["--run", "none"], "NS0818"),
        (["--data", "."], "NS0811"),
        (["--data", "none"], "NS0811"),
        (["--size", "8"], "NS0783"),
        (["--csv", "a", "--png", "a"], "NS0745"),
        (["--png", "a.jpg"], "NS0786"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else value,
)
def test_tradeoff_decoder_refuses_wrong_usage(
    tmp_path: Path, arguments: list[str], code: str
) -> None:
    done = invoke(["tradeoff", "decoder", *arguments], tmp_path)
    assert (done.status, done.codes) == (2, [code])
    assert not list(tmp_path.iterdir())


def test_data_that_a_run_has_seen_is_refused(clip_run: Path, tmp_path: Path) -> None:
    """The clip is used, until its digest is among those that the run was trained with: NS0820."""
    (tmp_path / "d").mkdir()
    frames = np.random.default_rng(0).random((8, 64, 64)).astype(np.float32)
    savemat(tmp_path / "d/c.mat", {"orig": np.moveaxis(frames, 0, 2) * 255})
    folder = load_run(clip_run)
    asked = replace(TINY, data=tmp_path / "d", count=1)
    [taken] = captures_of(decoder_points([folder], asked)[0])
    assert taken.scene.file.name == "c.mat"
    digest = sha256((tmp_path / "d/c.mat").read_bytes()).hexdigest()
    with pytest.raises(Rejected, match="NS0820"):
        decoder_points([folder._replace(seen_digests=frozenset({digest}))], asked)
