"""Metrics against sums written out by hand, and `nscc metrics` as a command."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from nscc_command import invoke
from numpy.typing import NDArray

from nscc_training import metrics
from nscc_training.measures import bootstrap, paired, summary

Picture = NDArray[np.float64]


def _pair(shape: tuple[int, ...], seed: int = 1) -> tuple[Picture, Picture]:
    rng = np.random.default_rng(seed)
    truth = rng.random(shape)
    return truth, np.clip(truth + 0.1 * rng.standard_normal(shape), 0, 1)


def slow_ssim(x: Picture, y: Picture, data_range: float) -> float:
    """The definition, window by window, with exact sums."""
    weight = [math.exp(-0.5 * (k / 1.5) ** 2) for k in range(-5, 6)]
    total = math.fsum(weight)
    weight = [w / total for w in weight]
    window = [wr * wc for wr in weight for wc in weight]
    values = []
    for r in range(x.shape[0] - 10):
        for c in range(x.shape[1] - 10):
            a, b = (p[r : r + 11, c : c + 11].ravel().tolist() for p in (x, y))
            mean_a, mean_b = (
                math.fsum(w * v for w, v in zip(window, part, strict=True)) for part in (a, b)
            )
            vaa = math.fsum(w * (v - mean_a) ** 2 for w, v in zip(window, a, strict=True))
            vbb = math.fsum(w * (v - mean_b) ** 2 for w, v in zip(window, b, strict=True))
            vab = math.fsum(
                w * (p - mean_a) * (q - mean_b) for w, p, q in zip(window, a, b, strict=True)
            )
            c1, c2 = (0.01 * data_range) ** 2, (0.03 * data_range) ** 2
            values.append(
                (2 * mean_a * mean_b + c1)
                * (2 * vab + c2)
                / ((mean_a**2 + mean_b**2 + c1) * (vaa + vbb + c2))
            )
    return math.fsum(values) / len(values)


def test_psnr_equals_its_definition_computed_by_hand() -> None:
    """The value is 10 log10(1 / mean squared error). Values and range times 255 give the same."""
    truth, result = _pair((17, 13))
    mse = math.fsum((a - b) ** 2 for a, b in zip(truth.flat, result.flat, strict=True)) / truth.size
    assert metrics.psnr(truth, result, 1.0) == pytest.approx(10 * math.log10(1 / mse), abs=1e-9)
    assert metrics.psnr(truth * 255, result * 255, 255.0) == pytest.approx(
        metrics.psnr(truth, result, 1.0), abs=1e-9
    )


def test_psnr_of_bytes_does_not_wrap() -> None:
    """Black against white in uint8 is 0 dB: 0 - 255 is not computed in bytes."""
    low, high = np.zeros((11, 11), np.uint8), np.full((11, 11), 255, np.uint8)
    # The error is the whole range: 0 dB.
    assert metrics.psnr(low, high, 255.0) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("data_range", [1.0, 0.25])
def test_ssim_equals_its_definition_computed_by_hand(data_range: float) -> None:
    """SSIM of a noisy and of an inverted picture is that of a slow loop over windows, for ranges 1
    and 0.25."""
    truth, result = _pair((14, 16))
    assert metrics.ssim(truth, result, data_range) == pytest.approx(
        slow_ssim(truth, result, data_range), abs=1e-10
    )
    assert metrics.ssim(truth, 1 - truth, data_range) == pytest.approx(
        slow_ssim(truth, 1 - truth, data_range), abs=1e-10
    )


def test_mu_and_pu21_count_dark_errors_more() -> None:
    """An error of 0.005 costs 20 dB more at 0.01 than at 0.91. Values and range times 7 give the
    same."""
    truth = np.full((12, 12), 0.01)
    bright = truth + 0.9
    for measure in (
        metrics.mu_psnr,
        lambda a, b, r: metrics.pu21_psnr(a, b, r, 1000.0),
    ):
        in_dark = measure(truth, truth + 0.005, 1.0)
        in_light = measure(bright, bright + 0.005, 1.0)
        assert in_light > in_dark + 20
        assert measure(truth * 7, (truth + 0.005) * 7, 7.0) == pytest.approx(in_dark, abs=1e-9)


def test_mu_psnr_equals_a_value_computed_by_hand() -> None:
    """For 0.5 against 0.25 the value follows from the curve log(1 + 5000 x) / log 5001."""
    truth, result = np.full((11, 11), 0.5), np.full((11, 11), 0.25)
    # log(1 + 5000 x) / log 5001 at 0.5 and at 0.25.
    difference = (math.log1p(2500) - math.log1p(1250)) / math.log1p(5000)
    assert metrics.mu_psnr(truth, result, 1.0) == pytest.approx(-20 * math.log10(difference))


def test_temporal_error_sees_flicker_only() -> None:
    """A constant offset of 0.2 is no error. A flicker of plus and minus 0.1 is 0.2 between frames,
    and 0.1 of a range of 2."""
    truth = np.tile(np.linspace(0, 1, 12)[None, None], (6, 12, 1))
    assert metrics.temporal_error(truth, truth + 0.2, 1.0) == pytest.approx(0.0, abs=1e-15)
    flicker = truth + 0.1 * (-1.0) ** np.arange(6)[:, None, None]
    assert metrics.temporal_error(truth, flicker, 2.0) == pytest.approx(0.1)


MEASURES: dict[str, Any] = {
    "mse": metrics.mean_square_error,
    "psnr": lambda a, b: metrics.psnr(a, b, 1.0),
    "mu_psnr": lambda a, b: metrics.mu_psnr(a, b, 1.0),
    "pu21_psnr": lambda a, b: metrics.pu21_psnr(a, b, 1.0, 1000.0),
    "ssim": lambda a, b: metrics.ssim(a, b, 1.0),
    "temporal_error": lambda a, b: metrics.temporal_error(a, b, 1.0),
}


@pytest.mark.parametrize("name", MEASURES)
@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize("side", ["truth", "reconstruction"])
def test_a_bad_number_is_an_error_and_never_a_score(name: str, bad: float, side: str) -> None:
    """One NaN or infinity in either picture gives a ValueError that counts it and names the
    picture."""
    pair = [np.full((3, 12, 12), 0.5), np.full((3, 12, 12), 0.5)]
    pair[side == "reconstruction"][1, 4, 5] = bad
    with pytest.raises(ValueError, match=f"1 of 432 values of the {side} are not finite"):
        MEASURES[name](*pair)


@pytest.mark.parametrize("name", sorted({*MEASURES} - {"ssim", "temporal_error"}))
def test_metrics_of_empty_arrays_are_refused(name: str) -> None:
    """Arrays of 0 x 12 give a ValueError: there is no value to compare."""
    with pytest.raises(ValueError, match="at least one value"):
        MEASURES[name](np.zeros((0, 12)), np.zeros((0, 12)))


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: metrics.psnr([[1], [1, 2]], [1], 1.0), "cannot convert the truth to an array"),
        (lambda: metrics.mu_psnr([1], [1], 1.0, 0), "mu is a number above 0, not 0"),
        (lambda: metrics.mu_psnr([1], [1], 1.0, "a"), "mu is a number above 0, not the text 'a'"),
        (lambda: metrics.pu21_psnr([1], [1], 1.0, "a"), "above 0.005, not the text 'a'"),
    ],
)
def test_arguments_of_other_types_are_refused(call: Any, words: str) -> None:
    """A ragged list, a `mu` of 0 and texts in place of numbers give a ValueError that says what was
    given."""
    with pytest.raises(ValueError, match=words):
        call()


@pytest.mark.parametrize("bad", [[], [math.nan], [30.0, math.nan], [-math.inf, 30.0]])
def test_means_of_bad_scores_are_refused(bad: list[float]) -> None:
    """An empty list, NaN and minus infinity have no mean: ValueError."""
    with pytest.raises(ValueError, match="a mean is taken of numbers of dB"):
        metrics.finite_mean(bad)


def test_equal_pictures_have_no_part_in_a_mean() -> None:
    assert metrics.finite_mean([30.0, math.inf, 20.0]) == 25.0
    assert metrics.finite_mean([math.inf, math.inf]) == math.inf


@pytest.mark.parametrize("bad", [[], [math.nan], [0.01, math.nan], [math.inf, 0.1], [-1.0]])
def test_invalid_errors_have_no_frame_scores(bad: list[float]) -> None:
    with pytest.raises(ValueError, match="a mean"):
        metrics.frame_scores(bad, 1.0)


def test_scores_that_are_not_numbers_are_refused() -> None:
    with pytest.raises(ValueError, match="NaN"):
        summary([1.0, math.nan], ["a", "b"])
    with pytest.raises(ValueError, match="NaN"):
        paired({"x": 1.0}, {"x": math.nan}, {"x": "a"})


@pytest.mark.parametrize("bad", [0.0, -1.0, math.nan, math.inf])
def test_a_data_range_is_needed(bad: float) -> None:
    truth, result = _pair((12, 12))
    for measure in (metrics.psnr, metrics.ssim):
        with pytest.raises(ValueError, match="data range"):
            measure(truth, result, bad)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (
            lambda a: metrics.psnr(a, a[1:], 1.0),
            r"an array \(12, 12\) of float64, the rec.* \(11, 12",
        ),
        (lambda a: metrics.mu_psnr(a, "a", 1.0), "the reconstruction the text 'a'"),
        (lambda a: metrics.ssim(a[:4], a[:4], 1.0), r"at least 11 x 11 pixels, not of \(4, 12\)"),
        (lambda a: metrics.temporal_error(a, a, 1.0), r"two frames or more, not of \(12, 12\)"),
        (lambda a: metrics.pu21_psnr(a, a, "255", 1000.0), "a number above 0, not the text '255'"),
    ],
)
def test_arrays_that_cannot_be_compared_are_refused_in_a_sentence(call: Any, words: str) -> None:
    with pytest.raises(TypeError, match=words):
        call(np.ones((12, 12)))


def test_lists_and_tensors_are_numbers() -> None:
    torch = pytest.importorskip("torch")
    truth, result = _pair((12, 12))
    wanted = metrics.psnr(truth, result, 1.0)
    assert metrics.psnr(truth.tolist(), torch.from_numpy(result), 1.0) == wanted


def test_summaries_leave_out_infinity_and_bootstrap_intervals() -> None:
    found = summary([1.0, 2.0, 3.0, math.inf], ["a", "a", "b", "b"])
    assert (found.mean, found.sd, found.infinite) == (2.0, 1.0, 1)
    assert summary([math.inf], ["a"]).mean is None
    rng = np.random.default_rng(3)
    values, groups = rng.normal(5, 1, 400), [str(k) for k in range(400)]
    low, high = bootstrap(values.tolist(), groups)
    # the normal interval of 400 draws is 2 * 1.96 / 20 wide
    assert high - low == pytest.approx(0.196, rel=0.15)
    assert low < values.mean() < high
    # ten equal values a scene are one draw a scene: the interval knows
    few = bootstrap(np.repeat(values[:40], 10).tolist(), np.repeat(groups[:40], 10).tolist())
    assert few[1] - few[0] == pytest.approx(2 * 1.96 * values[:40].std() / 40**0.5, rel=0.15)


def test_paired_scores_compare_only_the_items_of_both_results() -> None:
    """Of `a`, `b` and `d`, which both results have, the two finite pairs gain 1 and 3 dB, 2 on
    average. `c` and `e` are counted apart."""
    first = {"a": 20.0, "b": 30.0, "c": 1.0, "d": math.inf}
    second = {"a": 21.0, "b": 33.0, "d": 5.0, "e": 2.0}
    found = paired(first, second, {"a": "s", "b": "t", "d": "t"})
    assert found["items"] == 3
    assert (found["gain_db"], found["infinite"]) == (2.0, 1)
    assert (found["only_first"], found["only_second"]) == (1, 1)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a truth and a result, of a still and of a clip."""
    truth, result = _pair((3, 16, 16))
    np.save(tmp_path / "t.npy", truth[0])
    np.savez(tmp_path / "r.npz", image=result[0].astype(np.float32), other=result)
    np.savez(tmp_path / "clip.npz", truth=truth, video=result)
    np.save(tmp_path / "small.npy", truth[0, :10])
    np.save(tmp_path / "nan.npy", np.where(truth[0] > 0.5, np.nan, 1.0))
    np.save(tmp_path / "huge.npy", truth[0] * 1e200)
    np.save(tmp_path / "text.npy", np.full((16, 16), "x"))
    (tmp_path / "broken.npz").write_bytes(b"PK\x03\x04 and nothing")
    (tmp_path / "notes.txt").write_text("no picture")
    return tmp_path


def test_the_command_prints_every_metric(folder: Path) -> None:
    outcome = invoke(["metrics", "t.npy", "r.npz", "--data-range", "1", "--json"], folder)
    assert outcome.status == 0, outcome.err
    found = json.loads(outcome.out)
    truth, result = np.load(folder / "t.npy"), np.load(folder / "r.npz")["image"]
    assert found["psnr_db"] == pytest.approx(metrics.psnr(truth, result, 1.0))
    assert found["ssim"] == pytest.approx(slow_ssim(truth, result.astype(np.float64), 1.0))
    assert found["data_range"] == 1.0
    assert found["shape"] == [16, 16]
    assert found["temporal_error"] is None
    human = invoke(["metrics", "t.npy", "r.npz", "--data-range", "1"], folder).out
    assert f"{found['psnr_db']:.4f} dB" in human


def test_the_command_takes_clips_apart(folder: Path) -> None:
    arguments = ["metrics", "clip.npz", "clip.npz", "--truth-key", "truth", "--data-range", "1"]
    found = json.loads(invoke([*arguments, "--json", "-o", "m.json"], folder).out)
    assert found == json.loads((folder / "m.json").read_text())
    each = [frame["psnr_db"] for frame in found["frames"]]
    assert len(each) == 3
    assert found["psnr_db"] == pytest.approx(sum(each) / 3)
    same = json.loads(
        invoke(["metrics", "clip.npz", "clip.npz", "--data-range", "1", "--json"], folder).out
    )
    assert (same["psnr_db"], same["infinite"], same["ssim"]) == ("inf", 3, pytest.approx(1.0))


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["t.npy", "small.npy", "--data-range", "1"], "NS0802"),
        (["small.npy", "small.npy", "--data-range", "1"], "NS0802"),
        (["t.npy", "clip.npz", "--data-range", "1"], "NS0802"),
        (["t.npy", "nan.npy", "--data-range", "1"], "NS0804"),
        (["t.npy", "text.npy", "--data-range", "1"], "NS0801"),
        (["t.npy", "broken.npz", "--data-range", "1"], "NS0801"),
        (["t.npy", "notes.txt", "--data-range", "1"], "NS0801"),
        (["t.npy", "none.npy", "--data-range", "1"], "NS0801"),
        (["t.npy", "r.npz", "--rec-key", "imag", "--data-range", "1"], "NS0801"),
        (["t.npy", "r.npz", "--data-range", "0"], "NS0803"),
        (["t.npy", "r.npz", "--data-range", "inf"], "NS0803"),
        (["t.npy", "r.npz"], "NS0780"),
        (["t.npy", "r.npz", "--data-range", "1", "--nits", "0"], "NS0783"),
        (["t.npy", "r.npz", "--data-range", "1", "--nits", "nan"], "NS0783"),
        (["t.npy", "r.npz", "--data-range", "1e200"], "NS0803"),
        (["t.npy", "r.npz", "--data-range", "1e-200"], "NS0803"),
        (["huge.npy", "t.npy", "--data-range", "1"], "NS0804"),
        (["t.npy", "huge.npy", "--data-range", "1"], "NS0804"),
    ],
)
def test_the_command_metrics_refuses_invalid_files(
    folder: Path, arguments: list[str], code: str
) -> None:
    outcome = invoke(["metrics", *arguments], folder)
    assert (outcome.status, outcome.codes) == (2, [code])


@pytest.mark.parametrize("scale", [1e-59, 1.0, 1e59])
def test_metrics_do_not_depend_on_the_unit_of_the_pictures(tmp_path: Path, scale: float) -> None:
    truth, result = _pair((16, 16))
    np.save(tmp_path / "t.npy", truth * scale)
    np.save(tmp_path / "r.npy", result * scale)
    arguments = ["metrics", "t.npy", "r.npy", "--data-range", str(scale), "--json"]
    outcome = invoke(arguments, tmp_path)
    assert outcome.status == 0, outcome.err
    found = json.loads(outcome.out)
    assert found["psnr_db"] == pytest.approx(metrics.psnr(truth, result, 1.0))
    assert found["ssim"] == pytest.approx(slow_ssim(truth, result, 1.0))
