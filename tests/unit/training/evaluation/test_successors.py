"""Tasks of the paper's successors: a sharp moment, two buckets, shutters across frames."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
from nscc_command import invoke
from numpy.typing import NDArray

from nscc_training.code_choices import SCATTERED
from nscc_training.command_settings import EvaluationSettings
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.encoders.encoder_classes import scattered
from nscc_training.evaluation.baselines import BASELINES, evaluate_baseline
from nscc_training.evaluation.methods import CapturedScene
from nscc_training.protocol_scenes.clips import ClipWindow
from nscc_training.protocol_scenes.file_scenes import files_of
from nscc_training.protocol_scenes.panoramas import DeblurMoment, moments
from nscc_training.protocols import load_protocol
from nscc_training.sensor_model import SensorModel


def touching(tile: NDArray[np.int64]) -> float:
    """The part of side by side places that are equal, around the tile's edges."""
    return float(np.mean([tile == np.roll(tile, 1, axis) for axis in (0, 1)]))


@pytest.mark.parametrize("name", SCATTERED)
def test_scattered_tiles_keep_equal_exposures_apart(name: str) -> None:
    """Eight exposures all occur, and the same seed gives the same tile. Less than 6 % of neighbours
    are equal, and none but for `poisson-disc`."""
    levels, shares = np.arange(1, 9), []
    for seed in range(3):
        tile = scattered(name, levels, (8, 8), np.random.default_rng(seed))
        again = scattered(name, levels, (8, 8), np.random.default_rng(seed))
        assert np.array_equal(tile, again)
        assert {*tile.ravel().tolist()} == {*range(1, 9)}
        shares.append(touching(tile))
    # Of random exposures one in eight is like its neighbour.
    assert max(shares) < 0.06
    assert name == "poisson-disc" or max(shares) == 0


def test_scattered_starts_exist_for_classes_b_and_c_only() -> None:
    """Classes b and c get at least seven different codes. Classes d and e raise a ValueError."""
    for kind, slots in (("b", 8), ("b", 256), ("c", 8)):
        spec = ShutterSpec(kind, slots, (8, 8), length=2 if kind == "c" else None)
        for name in SCATTERED:
            (codes,) = make_encoder(spec, name, 3).codes().values()
            assert len(np.unique(codes)) >= 7
    for kind in ("d", "e"):
        with pytest.raises(ValueError, match="classes b and c"):
            make_encoder(ShutterSpec(kind, 8, (4, 4)), "poisson-disc")


def test_moments_are_reproducible_exposures_of_their_own_light(tmp_path: Path) -> None:
    light = cv2.resize(np.exp(np.random.default_rng(1).uniform(-3, 3, (64, 128))), (1024, 512))
    cv2.imwrite(str(tmp_path / "a.hdr"), np.repeat(light[..., None], 3, 2).astype("f4"))
    protocol = load_protocol("deblur-v1")
    [file] = files_of(protocol, tmp_path)
    first, second = moments(file, 0, protocol)
    assert isinstance(first, DeblurMoment)
    assert isinstance(second, DeblurMoment)
    again = next(moments(file, 0, protocol))
    assert isinstance(again, DeblurMoment)
    assert np.array_equal(first.light_e, again.light_e)
    assert not np.array_equal(first.light_e, second.light_e)
    assert first.light_e.shape == (8, 256, 256)
    # 50 lux on grey paper behind f/1.8 are 0.69 lux on the sensor, and a lux is 0.26 photons a
    # square micrometre in 64 us: 3.6 thousand electrons in 40 ms, 454 in a slot.
    open_e = first.light_e.sum(axis=0)
    assert np.median(open_e) == pytest.approx(3640, rel=0.01)
    assert np.array_equal(first.truth_e, first.light_e[0] * 8)
    perfect = first.scores(first.light_e)
    assert perfect["psnr_db"] == "inf"
    assert perfect == first.scores(first.truth_e)
    moved = first.scores(np.roll(first.light_e, 1, axis=2))
    assert moved["psnr_db"] < 40


def tiles(protocol_name: str, name: str, seed: int = 0) -> NDArray[np.float64]:
    make = BASELINES[protocol_name][name].tiles
    assert make is not None
    return make(load_protocol(protocol_name), seed).astype(float)


@pytest.mark.parametrize("seed", [0, 1])
def test_the_two_buckets_of_a_tile_are_complementary(seed: int) -> None:
    """In every slot each pixel is open in one of the two buckets. A `flutter` has one shutter for
    all pixels."""
    both = tiles("two-bucket-v1", "two-bucket", seed)
    assert both.shape == (2, 16, 8, 8)
    assert np.array_equal(both.sum(axis=0), np.ones((16, 8, 8)))
    assert np.array_equal(tiles("two-bucket-v1", "pixel-wise", seed)[0], both[0])
    assert tiles("two-bucket-v1", "flutter", seed).shape == (1, 16, 1, 1)


def test_staggered_shutters_go_on_into_the_next_frame() -> None:
    film, length, slots = 4, 4, 8
    masks = tiles("staggered-v1", "staggered")
    opened = masks.sum(axis=0)  # a slot belongs to one frame
    assert masks.shape == (film, film * slots, 4, 4)
    assert {*np.unique(opened).tolist()} == {0.0, 1.0}
    # Bumps of one length all over the film, but where the film begins and ends.
    for y, x in np.ndindex(4, 4):
        edges = np.flatnonzero(np.diff(opened[:, y, x]))
        assert set(np.diff(edges).tolist()) == {length}
    # At every moment half of the pixels are open; phases that stay within frames leave gaps.
    assert np.array_equal(opened.mean(axis=(1, 2)), np.full(film * slots, 0.5))
    aligned = tiles("staggered-v1", "aligned")
    assert np.array_equal(aligned.sum(axis=(0, 1)), np.full((4, 4), film * length))
    assert aligned.sum(axis=0).mean(axis=(1, 2)).std() > 0.1


@pytest.mark.parametrize("name", ["staggered", "staggered-alone"])
def test_frames_are_decoded_together_or_alone(name: str) -> None:
    """Frames of a still are decoded together; the slots of a frame belong to it alone."""
    light = np.full((8, 16, 16), 1000.0)
    protocol = load_protocol("staggered-v1")
    scene = ClipWindow(Path("c"), None, 0, light, protocol, 1000.0, False)
    tile = np.zeros((2, 8, 1, 1), np.float32)
    tile[0, :4] = tile[1, 4:] = 1
    model = SensorModel(30000.0, 1.0)
    codes = np.full((2, 16, 16), 4000.0, np.float32)
    frames = CapturedScene(scene, codes, tile, codes > 1e9, replace(model, adc_bits=16))
    made = BASELINES["staggered-v1"][name].decode(frames)
    assert np.allclose(made, light, rtol=0.02)


def test_rows_are_named_by_their_protocols(tmp_path: Path) -> None:
    for protocol, row in (
        ("deblur-v1", "quad"),
        ("two-bucket-v1", "any"),
        ("staggered-v1", "long"),
    ):
        line = ["evaluate", "of", row, "--data", ".", "--protocol", protocol]
        found = invoke(line, tmp_path)
        assert found.codes == ["NS0810"]
        assert "its baselines are" in found.err
    line = "evaluate of flutter --data . --protocol two-bucket-v1 --shutter e"
    assert invoke(line.split(), tmp_path).codes == ["NS0840"]
    line = "evaluate of long --data . --protocol deblur-v1"
    assert invoke(line.split(), tmp_path).codes == ["NS0811"]


@pytest.mark.slow
def test_two_buckets_score_above_one_bucket_and_flutter(tmp_path: Path) -> None:
    """The order of the published figures, on a made clip: flutter, pixel-wise, two buckets."""
    from small_runs import clip

    clip(tmp_path / "c.mat", 16, 256)
    scores = [
        evaluate_baseline(load_protocol("two-bucket-v1"), EvaluationSettings(name, tmp_path))[0][
            "mean"
        ]
        for name in ("flutter", "pixel-wise", "two-bucket")
    ]
    assert scores == sorted(scores)
