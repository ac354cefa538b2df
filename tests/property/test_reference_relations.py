"""What must hold of the reference whatever its numbers are: coupling, exact zeros, symmetries."""

from __future__ import annotations

import numpy as np
import pytest
from reference_exposure import expose
from reference_programs import (
    BUCKETS,
    BUMPS,
    COLS,
    LOWERINGS,
    ROWS,
    SLOTS,
    STOPS,
    columns,
    exposures,
    flat,
    program,
    sensor_of,
)

import nscc_runtime.reference.words
from nscc.diagnostics.diagnostic import Rejected
from nscc.operations import op
from nscc.words.container import Container
from nscc_runtime.effects import optional, selected
from nscc_runtime.emulator import expose as noiseless
from nscc_runtime.light import Light

PLACES = np.arange(ROWS * COLS, dtype=np.int64)
LINEAR = ["shot", "prnu", "dark", "lag", "crosstalk", "reset", "read", "dead_time"]


def random_light(seed: int = 1, scale: float = 500.0) -> Light:
    values = np.random.default_rng(seed).exponential(scale, (SLOTS, ROWS, COLS))
    return Light.of_clip(values.astype(np.float32))


@pytest.mark.parametrize("lowering", LOWERINGS)
@pytest.mark.parametrize("text", [STOPS, BUMPS, BUCKETS], ids=["stops", "bumps", "buckets"])
def test_the_reference_without_effects_is_the_exact_sum(text: str, lowering: str) -> None:
    try:
        container = program(text, lowering)
    except Rejected:
        assert lowering == "latch"  # serves only shutters that open with slot 0
        return
    light = random_light()
    exact = noiseless(container, light).exposure_e
    found = exposures(container, light, sensor_of(container), "none")[0]
    np.testing.assert_allclose(found, exact, rtol=1e-9, atol=1e-9)
    assert not np.signbit(found[exact == 0]).any()


def test_overlapping_buckets_share_their_reads() -> None:
    text = "nsl 1\nframe 4 slots of 1ms\nbucket a open when n < 4\nbucket b open when n < 2\n"
    container = program(text, "accumulate")
    found = exposures(container, flat(10.0), sensor_of(container, read_noise_e=5.0), "read", 1500)
    a, b = found[:, 0].reshape(1500, -1), found[:, 1].reshape(1500, -1)
    # Each bucket reads PIX by a word of its own and subtracts the same reading of the level.
    covariance = ((a - 40) * (b - 20)).mean()
    assert a.var() == pytest.approx(25 * (4 + 16), rel=0.01)
    assert b.var() == pytest.approx(25 * (2 + 4), rel=0.01)
    assert covariance == pytest.approx(25 * 4 * 2, rel=0.01)


@pytest.mark.parametrize("name", LINEAR)
def test_dropping_an_effect_changes_no_other_effects_draw(name: str) -> None:
    """The other, additive effects add the same electrons with and without the dropped effect."""
    container = program(BUMPS, "edges")
    light, sensor = random_light(), sensor_of(container)
    others = [other for other in ("read", "reset", "dark") if other != name]
    alone = exposures(container, light, sensor, "none," + name)
    both = exposures(container, light, sensor, ",".join(["none", name, *others]))
    rest = exposures(container, light, sensor, ",".join(["none", *others]))
    nothing = exposures(container, light, sensor, "none")
    if name in ("crosstalk", "dead_time"):
        # These act on dark charge as well.
        rest = exposures(container, light, sensor, ",".join(["none", *(set(others) - {"dark"})]))
        both = exposures(
            container, light, sensor, ",".join(["none", name, *(set(others) - {"dark"})])
        )
    np.testing.assert_allclose(both - alone, rest - nothing, atol=1e-8)


@pytest.mark.parametrize(
    ("name", "values"),
    [
        ("prnu", {"prnu_fraction": 0.0}),
        ("dark", {"dark_current_e_per_s": 0.0}),
        ("lag", {"lag_fraction": 0.0}),
        ("crosstalk", {"crosstalk_fraction": 0.0}),
        ("reset", {"reset_noise_e": 0.0}),
        ("read", {"read_noise_e": 0.0}),
        ("full_well", {"full_well_e": 1e12, "electrons_per_lsb": 100.0}),
        ("register", {"register_max_e": 1e12, "register_min_e": -1e12}),
        ("motion", {}),
        ("decay", {"digital_retention_us": 1e12}),
        (
            "analog",
            {
                "analog_gain": 1.0,
                "analog_noise_lsb": 0.0,
                "analog_pattern_lsb": 0.0,
                "analog_bias_lsb": 0.0,
            },
        ),
    ],
)
def test_leaving_out_an_effect_that_is_exactly_zero_changes_no_bit(
    name: str, values: dict[str, float]
) -> None:
    container = program(BUMPS, "accumulate")
    sensor = sensor_of(container).changed(
        register_max_e=3e5, register_min_e=-3e5, electrons_per_lsb=10.0
    )
    sensor = sensor.changed(**values)
    light = random_light()
    kept = exposures(container, light, sensor, "all", 2)
    left = exposures(container, light, sensor, f"all,-{name}", 2)
    assert kept.tobytes() == left.tobytes()


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_code_zero_without_dark_current_has_pedestal_and_read_noise_only(lowering: str) -> None:
    container = program(lowering=lowering)
    sensor = sensor_of(container, dark_current_e_per_s=0.0, analog_move_noise=0.5)
    dark, bright = (
        columns(exposures(container, flat(level), sensor, "all", 3), 0) for level in (0.0, 900.0)
    )
    assert dark.tobytes() == bright.tobytes()
    assert dark.std() > 0
    only = columns(exposures(container, flat(900.0), sensor, "all,-analog", 3), 0)
    assert np.array_equal(only, np.zeros_like(only))
    assert not np.signbit(only).any()


def test_scaled_light_scales_mean_and_variance_of_shot_noise() -> None:
    container = program("nsl 1\nframe 4 slots of 1ms\nopen when n < 3\n", "accumulate")
    sensor = sensor_of(container)
    values = {a: exposures(container, flat(50.0 * a), sensor, "shot", 200) for a in (1, 4, 16)}
    for a, found in values.items():
        samples = found.size
        assert found.mean() == pytest.approx(150 * a, abs=5 * (150 * a / samples) ** 0.5)
        assert found.var() == pytest.approx(150 * a, rel=5 * (2 / samples) ** 0.5 + 1e-3)


def test_permuted_slots_give_the_same_where_order_means_nothing() -> None:
    text = "nsl 1\nframe 4 slots of 1ms\nopen when n != 1\n"
    container = program(text, "accumulate")
    sensor = sensor_of(container)
    light = random_light()
    swapped = Light.of_clip(np.ascontiguousarray(light.frames[[3, 1, 0, 2]]))
    names = "prnu,lag,crosstalk,reset"
    one, other = (exposures(container, each, sensor, names) for each in (light, swapped))
    np.testing.assert_allclose(one, other, atol=1e-8)


def test_a_shutter_and_its_complement_add_up() -> None:
    container = program(BUCKETS, "accumulate")
    found = exposures(container, random_light(), sensor_of(container), "prnu,lag,crosstalk")[0]
    assert np.ptp(found.sum(axis=0)[:, :1]) > 0
    whole = program("nsl 1\nframe 4 slots of 1ms\nopen when n < 4\n", "accumulate")
    all_open = exposures(whole, random_light(), sensor_of(whole), "prnu,lag,crosstalk")[0, 0]
    np.testing.assert_allclose(found.sum(axis=0), all_open, rtol=1e-9)


def test_chunks_of_rows_change_no_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    container = program(BUMPS, "accumulate")
    light, sensor = random_light(), sensor_of(container)
    whole = exposures(container, light, sensor, "all")
    for rows in (1, 7):
        monkeypatch.setattr(nscc_runtime.reference.words, "CELLS", SLOTS * COLS * rows)
        assert exposures(container, light, sensor, "all").tobytes() == whole.tobytes()


def test_each_seed_changes_only_its_own_effects() -> None:
    container = program(BUMPS, "accumulate")
    light, sensor = random_light(), sensor_of(container)

    def run(effects: str, **seeds: int) -> bytes:
        return exposures(container, light, sensor, effects, 1, **seeds).tobytes()

    for fixed in ("prnu",):
        assert run(fixed, seed=1) == run(fixed, seed=2)
        assert run(fixed, device_seed=1) != run(fixed, device_seed=2)
    for random in ("shot", "read", "reset"):
        assert run(random, seed=1) != run(random, seed=2)
    shot = [exposures(container, light, sensor, "shot", 1, device_seed=d) for d in (1, 2)]
    np.testing.assert_allclose(shot[0], shot[1], atol=1e-8)
    two = exposures(container, light, sensor, "shot", 2)
    assert not np.array_equal(two[0], two[1])


def test_words_that_open_no_shutter_are_refused() -> None:
    from emulator_programs import container_of, target_of

    def made(*words: object) -> Container:
        return container_of(target_of((2, 3)), {}, [list(words)], [(0, 0), (1, 0)], 1)  # type: ignore[list-item]

    light = Light.of_clip(np.ones((1, 2, 3), np.float32))
    twice = made(
        op("all"),
        op("bus", ["NEWS"], ["PIX"]),
        op("bus", ["B"], ["PIX"]),
        op("bus", ["A"], ["NEWS", "B"]),
    )
    by_light = made(op("where", [], ["PIX"]), op("bus", ["A"], ["PIX"]))
    for container in (twice, by_light):
        with pytest.raises(Rejected) as caught:
            expose(container, light, sensor_of(container), selected("shot"))
        assert caught.value.diagnostics[0].code == "NS0442"


def test_light_of_another_size_is_refused() -> None:
    container = program()
    with pytest.raises(Rejected) as caught:
        expose(container, flat(1.0, ROWS, 3), sensor_of(container), selected("shot"))
    assert caught.value.diagnostics[0].code == "NS0734"


def test_no_number_is_marked_and_huge_light_is_the_top() -> None:
    container = program("nsl 1\nframe 4 slots of 1ms\nopen when n < 4\n", "accumulate")
    light = flat(10.0)
    light.frames[1, 3, 4] = np.nan
    light.frames[2, 5, 6] = 3e38
    light.frames[2, 7, 8] = np.inf
    found = expose(container, light, sensor_of(container), selected("all,-crosstalk"))
    assert not found.valid[0, 3, 4]
    assert found.valid.sum() == found.valid.size - 1
    for place in ((5, 6), (7, 8)):
        assert 25_000 < found.exposure_e[0][place] < 31_000


def test_every_effect_changes_the_frame_alone_unless_the_scene_lacks_its_cause() -> None:
    """The set `absent` names the effects that change no exposure of this scene."""
    container = program(BUMPS, "accumulate")
    light, sensor = random_light(scale=12000.0), sensor_of(container, register_max_e=2e4)
    nothing = exposures(container, light, sensor, "none")
    absent = {
        name
        for name in optional()
        if np.array_equal(exposures(container, light, sensor, name), nothing)
    }
    compared = {"comparator_offset", "comparator_noise"}
    readout = {"adc_noise", "spreading", "column_noise", "readout_pattern", "readout_level"}
    assert absent == {"motion", "decay", "black_sun", *readout, *compared}
