"""The sample of pixels: means over it are those of the array, a lamp is never missed, and what its
pixels expose is what they expose in a whole frame, bit for bit."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from plan_cases import CASES, case, moving_light
from reference_programs import sensor_of

from nscc_runtime.effects import everything, selected
from nscc_runtime.execution.frames import Execution, executed
from nscc_runtime.execution.near_saturation import NO_PIXELS, NearSaturation
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.planning import sample as module
from nscc_runtime.planning.sample import Sample, chances, contrasts_of, drawn_by, sample_of
from nscc_runtime.planning.sampled_exposures import SEED
from nscc_runtime.planning.summed_trial import SummedTrial
from nscc_runtime.reference import expose

WELL_E = 30_000.0


def near_at(places: np.ndarray, spilt: np.ndarray | None = None) -> NearSaturation:
    """Pixels near saturation, some of them by what their neighbours spill."""
    spilt = np.zeros(len(places), np.bool_) if spilt is None else spilt
    most_e = np.random.default_rng(8).uniform(0.5, 4.0, len(places)) * WELL_E
    return NearSaturation(places, most_e, np.where(spilt, 0.0, most_e), spilt)


def scene(kind: str, rows: int = 128, cols: int = 160) -> np.ndarray:
    rng = np.random.default_rng(4)
    if kind == "noise":
        return rng.exponential(500.0, (rows, cols))
    if kind == "ramp":
        return np.linspace(0, 9000, rows * cols).reshape(rows, cols)
    if kind == "edges":
        return np.where((np.arange(cols) // 20 % 2)[None], 8000.0, 20.0) * np.ones((rows, 1))
    if kind == "dark":
        return np.zeros((rows, cols))
    found = np.full((rows, cols), 30.0)
    found[77, 31] = 1e7
    return found


@pytest.mark.parametrize("kind", ["noise", "ramp", "edges", "dark", "lamp"])
@pytest.mark.parametrize("near_count", [0, 100, 3000])
def test_means_over_the_sample_are_those_of_the_array(kind: str, near_count: int) -> None:
    total = scene(kind)
    places = np.sort(np.random.default_rng(1).choice(total.size, near_count, replace=False))
    found = sample_of(total, near_at(places), WELL_E)
    assert found.weight.sum() == pytest.approx(total.size)
    assert np.all(found.weight > 0)
    assert np.isin(found.places[found.near_pixels], places).all()
    assert not np.isin(found.places[found.far_pixels], places).any()
    assert found.weight[found.near_pixels].sum() == pytest.approx(near_count)
    assert found.near_part == pytest.approx(near_count / total.size)
    flat = total.reshape(-1)
    rest = np.setdiff1d(np.arange(total.size), places)
    code = np.arange(total.size) % 160 % 8
    for values, most in (
        (np.ones(total.size), 1e-9), (flat, 0.25), (np.sqrt(flat), 0.2), (flat**2, 0.4),
        (1.0 * (code < 4), 0.25),
    ):  # fmt: skip
        # With the lamp, means that no even sample of this size gets right.
        mean = found.weight[found.far_pixels] @ values[found.places[found.far_pixels]] / len(rest)
        assert mean == pytest.approx(values[rest].mean(), rel=most)


def test_the_standard_error_is_the_spread_of_such_means() -> None:
    """Over many scenes of one kind, pixels of a tile being alike."""
    away, told = [], []
    for seed in range(60):
        rng = np.random.default_rng(seed)
        total = np.repeat(np.repeat(rng.exponential(500.0, (64, 80)), 2, axis=0), 2, axis=1)
        found = sample_of(total, NO_PIXELS, WELL_E)
        values = np.repeat(np.repeat(rng.exponential(1.0, (64, 80)), 2, axis=0), 2, axis=1)
        measured = values.reshape(-1)[found.places][None]
        away.append(float(found.mean(measured)[0] - values.mean()))
        told.append(float(found.standard_error(measured)[0]))
    assert np.std(away) == pytest.approx(np.mean(told), rel=0.35)


def test_pixels_that_are_all_measured_leave_no_doubt() -> None:
    found = sample_of(scene("noise", 20, 30), near_at(np.array([4, 5, 9])), WELL_E)
    assert sorted(found.places) == list(range(600))
    np.testing.assert_allclose(found.weight, 1.0)
    assert found.standard_error(np.random.default_rng(1).normal(size=(2, 600))).max() == 0.0


def test_the_mean_square_of_a_single_lamp_is_found() -> None:
    total = scene("lamp")
    found = sample_of(total, NO_PIXELS, WELL_E)
    assert 77 * 160 + 31 in found.places
    square = found.mean(total.reshape(-1)[found.places] ** 2)
    assert square == pytest.approx((total**2).mean(), rel=0.02)


def test_pixels_near_saturation_are_measured_by_what_they_see_and_get() -> None:
    """The brightest, the darkest and those at a full well for sure, and some of those that only
    their neighbours' light brings there."""
    rng = np.random.default_rng(3)
    places = np.sort(rng.choice(128 * 160, 4000, replace=False))
    near = near_at(places, rng.random(4000) < 0.5)
    found = sample_of(scene("noise"), near, WELL_E)
    measured = np.isin(near.places, found.places[found.near_pixels])
    assert 40 <= measured.sum() <= module.near_sampled(4000, 128 * 160)
    assert module._SPILT // 2 < (measured & near.spilt).sum() <= module._SPILT
    own, seen_e = ~near.spilt, near.most_e
    for sure in (seen_e.max(where=own, initial=0), seen_e.min(where=own, initial=1e9)):
        assert measured[seen_e == sure].all()
    at_well = np.abs(np.where(own, seen_e, 0.0) - WELL_E).argmin()
    assert measured[at_well]
    assert found.drawn_near == (found.weight[found.near_pixels] > 1).sum() > 0
    for stratum in (near.spilt, own):
        weight = found.weight[np.isin(found.places, near.places[stratum])]
        assert weight.sum() == pytest.approx(stratum.sum())


def test_one_pixel_of_each_tile_is_not_always_the_same_corner() -> None:
    """Codes repeat from tile to tile."""
    found = sample_of(scene("noise"), NO_PIXELS, WELL_E)
    some = found.places[found.one_each]
    assert len(some) == len(np.unique(found.cluster))
    corners = some // 160 % 2 * 2 + some % 160 % 2
    assert (np.bincount(corners, minlength=4) > len(some) / 8).all()


@given(st.integers(1, 9), st.integers(1, 9), st.data())
def test_any_array_has_a_sample(rows: int, cols: int, data: st.DataObject) -> None:
    values = data.draw(st.lists(st.floats(0, 1e30), min_size=rows * cols, max_size=rows * cols))
    near = data.draw(st.sets(st.integers(0, rows * cols - 1)))
    total, places = np.array(values).reshape(rows, cols), np.array(sorted(near), np.int64)
    found = sample_of(total, near_at(places), WELL_E)
    assert found.weight.sum() == pytest.approx(rows * cols)
    once = zip(found.places.tolist(), found.frame.tolist(), strict=True)
    assert len({*once}) == len(found.places) == rows * cols * found.frames
    again = sample_of(total, near_at(places), WELL_E)
    assert found.places.tolist() == again.places.tolist()


@pytest.mark.parametrize("wanted", [1, 7, 300])
def test_places_are_drawn_where_the_sum_of_chances_passes_points_in_equal_strata(
    wanted: int,
) -> None:
    chance = np.random.default_rng(wanted).exponential(1.0, 211)
    chance[[0, 50, 51, 210]] = 0.0
    points = np.arange(wanted) + (np.arange(wanted) * 0.6180339887498949) % 1.0
    upto = np.cumsum(chance)
    passed = np.searchsorted(upto, points * (upto[-1] / wanted), side="right")
    assert drawn_by(chance, wanted).tolist() == np.minimum(passed, 210).tolist()


@pytest.mark.parametrize("shape", [(1, 1), (1, 9), (9, 1), (6, 7)])
def test_chances_are_light_and_its_differences_to_each_neighbour(shape: tuple[int, int]) -> None:
    light, well_e = np.random.default_rng(2).exponential(50.0, shape), 60.0
    never = np.arange(min(2, light.size - 1))
    drawn = np.ones(light.size, bool)
    drawn[never] = False
    drawn = drawn.reshape(shape)

    def contrast(values: np.ndarray) -> np.ndarray:
        wide = np.pad(values, 1, mode="edge")
        beside = (wide[:-2, 1:-1], wide[2:, 1:-1], wide[1:-1, :-2], wide[1:-1, 2:])
        return np.where(drawn, values + sum(np.abs(values - each) for each in beside), 0.0)

    within, square = contrast(np.minimum(light, well_e)), contrast(light) ** 2
    expected = 4 * drawn / drawn.sum() + 2 * within / within.sum() + square / square.sum()
    assert chances(contrasts_of(light, well_e), never) == pytest.approx(expected)


def trial_of(name: str, electrons: float, shape: tuple[int, int] = (64, 80)) -> SummedTrial:
    container = case(name, rows=shape[0], cols=shape[1])
    sensor = sensor_of(container, register_max_e=9000.0, register_min_e=-9000.0)
    light = moving_light((8, *shape), electrons)
    light.frames[:, 20:23, 30] = 9000.0
    return SummedTrial(frozenset(), AnalysedProgram.of(container, sensor), light, 5, 1)


def tiles_of(sample: Sample) -> bool:
    return sample.side > 0 and len(sample.places) < sample.scene_pixels / 4


@pytest.mark.parametrize("effects", ["all", "all,-crosstalk", "all,-shot,-dark,-read", "none"])
@pytest.mark.parametrize("name", CASES)
def test_measured_pixels_expose_what_they_expose_in_a_whole_frame(name: str, effects: str) -> None:
    trial, kept = trial_of(name, 300.0), selected(effects)
    assert tiles_of(trial.sample)
    near = kept.without("shot", "dark") if "crosstalk" in effects else kept
    for execution in (
        Execution("sums", kept, near, everything()),
        Execution("sums", kept, near, everything(), exact=True),
        Execution("words", kept, kept, everything()),
    ):
        scene = executed(trial.program, trial.light, execution, device_seed=5, threads=1)
        whole = scene.expose(SEED, 0).exposure_e
        found = trial.exposures.expose(execution, 0)
        assert found.tobytes() == whole.reshape(len(whole), -1)[:, trial.sample.places].tobytes()


@pytest.mark.parametrize("name", ["a", "d edges"])
def test_pixels_near_saturation_by_sums_are_those_of_a_whole_frame(name: str) -> None:
    """On tiles of their own, where those at the border exchange nothing with others."""
    trial, kept = trial_of(name, 3000.0), selected("all,-full_well,-register")
    places = trial.sample.places[trial.sample.near_pixels]
    assert {0, 79} & set((places % 80).tolist())
    execution = Execution("sums", kept, kept, everything())
    scene = executed(trial.program, trial.light, execution, device_seed=5, threads=1)
    whole = scene.expose(SEED, 0).exposure_e
    found = trial.exposures.by_sums(kept, everything(), "near", 0)
    np.testing.assert_allclose(found, whole.reshape(len(whole), -1)[:, places], rtol=1e-6)


@pytest.mark.parametrize("name", ["a", "d edges"])
def test_measured_pixels_have_the_exposures_of_the_reference(name: str) -> None:
    trial = trial_of(name, 3000.0)
    exposed = expose(
        trial.program.container, trial.light, trial.sensor, everything(), seed=SEED, device_seed=5
    ).exposure_e
    found = trial.exposures.by_reference(everything())
    wanted = exposed.reshape(len(exposed), -1)[:, trial.sample.places]
    np.testing.assert_allclose(found, wanted, rtol=1e-12)


def test_neighbours_of_suns_leave_draws_for_pixels_below_the_well() -> None:
    """Six hundred suns among bright pixels, all near saturation but their neighbours."""
    rng = np.random.default_rng(5)
    total = np.full((256, 256), 50.0)
    total[60:120, 90:130] = 0.9 * WELL_E
    suns = rng.choice(total.size, 600, replace=False)
    total.reshape(-1)[suns] = 100 * WELL_E
    found = sample_of(total, near_at(np.sort(suns)), WELL_E)
    bright = total.reshape(-1)[found.places[found.far_pixels]] == 0.9 * WELL_E
    assert bright.sum() > 60
    assert found.weight[found.far_pixels][bright].sum() == pytest.approx(2400, rel=0.25)


def test_near_saturation_neighbours_of_lamps_are_found() -> None:
    """A scene whose noise alone brings every pixel near saturation."""
    total = np.full((48, 48), 50.0)
    total[10:30, 5:9] = 0.8 * WELL_E
    lamps = np.array([[27, 33], [40, 12], [5, 40]])
    total[lamps[:, 0], lamps[:, 1]] = 40 * WELL_E
    near = near_at(np.arange(total.size), np.zeros(total.size, np.bool_))
    found = sample_of(total, near, WELL_E)
    beside = np.zeros(total.shape, np.bool_)
    for row, col in ((0, 1), (0, -1), (1, 0), (-1, 0)):
        beside[lamps[:, 0] + row, lamps[:, 1] + col] = True
    measured = beside.reshape(-1)[found.places]
    assert measured.sum() >= 6
    assert found.weight[measured].sum() == pytest.approx(12, rel=0.3)
