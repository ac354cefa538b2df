"""The emulator as a Python function: arrays in, arrays out, batches, refusals."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from dataclasses import replace
from multiprocessing import get_context

import numpy as np
import pytest
from plan_cases import case, moving_light, plan_of
from reference_programs import program as compiled
from reference_programs import sensor_of

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime import audit, capture, captures, film, plan
from nscc_runtime.captured import Capture
from nscc_runtime.effects import selected
from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.frame_file import read_out
from nscc_runtime.light import DrawnFrames, Light
from nscc_runtime.planning.plan import Plan
from nscc_runtime.scenes import builtin_motion
from nscc_runtime.scenes.timing import with_motion
from nscc_runtime.sensor import default_sensor

ROWS, COLS = 12, 16
CLIP = moving_light((8, ROWS, COLS), 400.0).frames
PROGRAM = case("b edges", 8, rows=ROWS, cols=COLS)
LOOKS = """nsl 2
frame 8 slots of 1ms
sense bright when light > 45% at n in [1, 4]
state closed : 0..2 = 0
next closed = looks when bright and closed == 0
open when closed == 0
read closed
"""

IMAGES = """nsl 3
frame 8 slots of 1ms
open when true
kernel k = [[0, 1, 0], [1, 1, 1], [0, 1, 0]] / 8
image i = k(exposure)
plane p = i > 300e
read i
read p
"""


def test_arrays_are_clips_or_stills_and_light_is_light() -> None:
    """An array of three axes is a clip in electrons a slot, one of two axes a still in electrons a
    second. A Light gives the same bytes as its clip."""
    taken = capture(PROGRAM, CLIP, effects="auto", seed=2, device_seed=3)
    assert taken.frame.shape == taken.exposure_e.shape == taken.valid.shape == (1, ROWS, COLS)
    assert (taken.frame.dtype, taken.exposure_e.dtype) == (np.uint8, np.float64)
    same = capture(PROGRAM, Light.of_clip(CLIP), effects="auto", seed=2, device_seed=3)
    assert same.exposure_e.tobytes() == taken.exposure_e.tobytes()
    assert same.frame.tobytes() == taken.frame.tobytes()
    rate = CLIP[0] * 1000.0
    still = capture(PROGRAM, rate, effects="none")
    stops = 1 + (5 * np.arange(COLS) + 3 * np.arange(ROWS)[:, None]) % 8
    np.testing.assert_allclose(still.exposure_e[0], rate * stops * 500e-6, rtol=1e-5)


def test_integers_and_float64_are_taken_as_their_values() -> None:
    """A clip of whole numbers gives the same bytes in its own dtype and in float64."""
    whole = np.round(CLIP)
    first = capture(PROGRAM, whole.astype(np.float64), effects="auto")
    assert (
        capture(PROGRAM, whole, effects="auto").exposure_e.tobytes() == first.exposure_e.tobytes()
    )


def test_repeats_are_consecutive_frames() -> None:
    """`repeat=3` gives an axis in front. The first frame has the bytes of a single capture, and the
    noise of the others differs."""
    plan = plan_of("all")
    taken = capture(PROGRAM, CLIP, plan=plan, seed=3, device_seed=5, repeat=3)
    assert taken.frame.shape == (3, 1, ROWS, COLS)
    first = capture(PROGRAM, CLIP, plan=plan, seed=3, device_seed=5)
    assert first.exposure_e.tobytes() == taken.exposure_e[0].tobytes()
    assert not np.array_equal(taken.exposure_e[1], taken.exposure_e[2])
    assert taken.plan.kept == plan.kept


def test_the_readout_is_that_of_frame_files() -> None:
    sensor = sensor_of(
        PROGRAM,
        adc_noise_lsb=0.0,
        spread_noise_lsb=0.0,
        adc_pattern_lsb=0.0,
        adc_smooth_lsb=0.0,
        adc_level_lsb=0.0,
        electrons_per_lsb=25.0,
        adc_offset_lsb=4.0,
    )
    taken = capture(PROGRAM, CLIP, sensor=sensor, tolerance="1e")
    expected = read_out(Exposure(taken.exposure_e, taken.valid), PROGRAM.target, sensor)
    assert taken.frame.tobytes() == expected.frame.tobytes()
    assert taken.frame.max() == 255
    noisy = capture(PROGRAM, CLIP, sensor=sensor.changed(adc_noise_lsb=3.0), tolerance="1e")
    assert noisy.exposure_e.tobytes() == taken.exposure_e.tobytes()
    inside = (taken.frame > 20) & (taken.frame < 235)
    change = noisy.frame[inside].astype(float) - taken.frame[inside]
    assert change.std() == pytest.approx(3.0, rel=0.25)
    silent = capture(
        PROGRAM,
        CLIP,
        sensor=sensor.changed(adc_noise_lsb=3.0),
        tolerance="1e",
        effects="auto,-adc_noise",
    )
    assert silent.frame.tobytes() == taken.frame.tobytes()


def test_captures_repeat_by_seed_and_plan_with_any_threads() -> None:
    """The number of threads changes no byte. Another seed or device seed changes the electrons."""
    one = capture(PROGRAM, CLIP, effects="auto", seed=1)
    assert (
        capture(PROGRAM, CLIP, effects="auto", seed=1, threads=3).exposure_e.tobytes()
        == one.exposure_e.tobytes()
    )
    assert not np.array_equal(
        capture(PROGRAM, CLIP, effects="auto", seed=2).exposure_e, one.exposure_e
    )
    again = capture(PROGRAM, CLIP, plan=one.plan, seed=1)
    assert again.exposure_e.tobytes() == one.exposure_e.tobytes()
    assert again.plan.kept == one.plan.kept
    other = capture(PROGRAM, CLIP, plan=one.plan, seed=1, device_seed=9)
    assert not np.array_equal(other.exposure_e, one.exposure_e)


def test_capture_takes_tolerances_and_effects_as_on_the_command_line() -> None:
    """`2e`, 2 and `0.5lsb` are tolerances in electrons. Effects as text and as a selection give
    equal plans."""
    sensor = default_sensor(PROGRAM.target)
    lsb = sensor.electrons_per_lsb
    for given, electrons in (("2e", 2.0), (2, 2.0), (2.5, 2.5), ("0.5lsb", 0.5 * lsb)):
        assert capture(PROGRAM, CLIP, tolerance=given).plan.tolerance_e == electrons
    chosen = capture(PROGRAM, CLIP, effects=selected("none,+shot")).plan
    assert chosen.kept.on == {"shot", "adc"}
    assert capture(PROGRAM, CLIP, effects="none,+shot").plan == chosen


@pytest.mark.parametrize(
    ("light", "options", "code"),
    [
        (CLIP[:, :5], {}, "NS0734"),
        (CLIP[:4], {}, "NS073"),
        (-CLIP, {}, "NS0736"),
        (np.full_like(CLIP, np.nan), {}, "NS0736"),
        (np.array([["a"]]), {}, "NS073"),
        (CLIP, {"tolerance": "5"}, "NS0746"),
        (CLIP, {"tolerance": 0.0}, "NS0746"),
        (CLIP, {"effects": "shots"}, "NS0756"),
    ],
)
def test_invalid_light_tolerances_and_effects_are_refused(
    light: np.ndarray, options: dict[str, object], code: str
) -> None:
    with pytest.raises(Rejected) as caught:
        capture(PROGRAM, light, **{"effects": "auto", **options})  # type: ignore[arg-type]
    assert caught.value.diagnostics[0].code.startswith(code)


def test_no_frames_at_all_are_a_mistake() -> None:
    for repeat in (-1, 0):
        with pytest.raises(
            ValueError, match=r"repeat is a whole number from 1 to \d+, not (0|-1)$"
        ):
            capture(PROGRAM, CLIP, effects="auto", repeat=repeat)


def test_words_that_compare_light_are_refused() -> None:
    """A word that compares the photodiode with a level gives NS0442 when `effects` is `auto`."""
    from emulator_programs import container_of, target_of

    from nscc.operations import op

    words = [op("where", [], ["PIX"]), op("bus", ["A"], ["PIX"])]
    bad = container_of(target_of((2, 3)), {}, [words], [(0, 0), (1, 0)], 1)
    with pytest.raises(Rejected) as caught:
        capture(bad, np.ones((1, 2, 3), np.float32), effects="auto")
    assert caught.value.diagnostics[0].code == "NS0442"


@pytest.mark.parametrize("threads", [1, 3])
def test_batches_are_single_captures(threads: int) -> None:
    other = case("c accumulate", 8, rows=ROWS, cols=COLS)
    lights = [CLIP, CLIP * 3.0, CLIP[0] * 100.0]
    same = captures(PROGRAM, lights, threads=threads, seed=4, tolerance="2e")
    for light, found in zip(lights, same, strict=True):
        alone = capture(PROGRAM, light, seed=4, tolerance="2e")
        assert found.exposure_e.tobytes() == alone.exposure_e.tobytes()
        assert replace(found.plan, reused=False) == alone.plan
    many = captures([PROGRAM, other], [CLIP], effects="auto", threads=threads)
    for program, found in zip((PROGRAM, other), many, strict=True):
        assert found.frame.tobytes() == capture(program, CLIP, effects="auto").frame.tobytes()
    pairs = captures([PROGRAM, other], lights[:2], effects="auto", threads=threads)
    assert pairs[1].frame.tobytes() == capture(other, lights[1], effects="auto").frame.tobytes()
    one = captures([PROGRAM, other], Light.of_clip(CLIP), effects="auto", threads=threads)
    assert one[1].frame.tobytes() == many[1].frame.tobytes()


def test_captures_refuses_unequal_numbers_of_programs_and_scenes_and_bad_repeats() -> None:
    """Two scenes for three programs, and `repeat=0`, give a ValueError with the numbers."""
    with pytest.raises(ValueError, match="2 scenes for 3 programs"):
        captures([PROGRAM] * 3, [CLIP, CLIP], effects="auto")
    with pytest.raises(ValueError, match=r"repeat is a whole number from 1 to \d+, not (0|-1)$"):
        captures(PROGRAM, [CLIP], effects="auto", repeat=0)


def test_captures_of_a_batch_share_a_plan() -> None:
    plan = capture(PROGRAM, CLIP, effects="auto").plan
    found = captures(PROGRAM, [CLIP, CLIP * 2], plan=plan)
    assert all(each.plan.kept.on == plan.kept.on for each in found)


def test_the_audit_of_a_frame_is_what_its_plan_predicts() -> None:
    """At a tolerance of 50 electrons the measured error is the predicted one within 20 %, and the
    promise holds."""
    taken = capture(PROGRAM, CLIP, tolerance="50e", seed=3, device_seed=5, audit=True)
    assert isinstance(taken.plan, Plan)
    assert taken.audit.holds
    assert taken.plan.predicted_e == pytest.approx(taken.audit.measured_rms_e, rel=0.2)


def contents(taken: Capture) -> list[object]:
    """Texts, plan, meta data, and the bytes of all arrays of a capture, and its estimated light."""
    arrays = [taken.exposure_e, taken.frame, taken.saturated_by, *taken.told.values()]
    if not taken.told:
        arrays.append(taken.light_e_per_s())
    texts = repr(taken), taken._repr_html_(), str(taken.plan), taken.meta
    return [*texts, taken.light.sha256(), *taken.told, *(array.tobytes() for array in arrays)]


@pytest.fixture(scope="module")
def other_process() -> Iterator[Executor]:
    """A process that shares nothing with this one."""
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        yield pool


@pytest.mark.parametrize("effects", ["none", "auto", "all"])
@pytest.mark.parametrize("kind", ["fixed", "looks", "images", "drawn clip"])
def test_captures_cross_processes(
    other_process: Executor, monkeypatch: pytest.MonkeyPatch, kind: str, effects: str
) -> None:
    """A capture that goes to another process and comes back has the same contents there and here.
    So has one of a clip that is drawn whenever it is read."""
    monkeypatch.setattr(builtin_motion, "_MOST_BYTES", 0)
    text = {"looks": LOOKS, "images": IMAGES}.get(kind)
    chosen = PROGRAM if text is None else compiled(text, "auto", ROWS, COLS)
    taken = capture(
        chosen, "builtin:motion" if kind == "drawn clip" else CLIP, effects=effects, repeat=2
    )
    assert isinstance(taken.light.frames, DrawnFrames) is (kind == "drawn clip")
    assert other_process.submit(contents, taken).result(100) == contents(taken)
    assert contents(pickle.loads(pickle.dumps(taken))) == contents(taken)


@pytest.mark.parametrize("sampled", [False, True])
def test_light_that_is_changed_in_place_is_exposed_as_it_is(sampled: bool) -> None:
    """Dim light becomes bright, is turned round in time, and then negative: each capture is that of
    fresh light, and negative light is refused."""
    clip = np.array(CLIP)

    def light() -> Light:
        return with_motion(Light.of_clip(clip)) if sampled else Light.of_clip(clip)

    kept = light()
    for change in (1.0, 300.0, -1):
        clip[:] = clip[::-1] if change == -1 else clip * np.float32(change)
        taken, fresh = (capture(PROGRAM, each, effects="all") for each in (kept, light()))
        assert taken.exposure_e.tobytes() == fresh.exposure_e.tobytes()
        assert plan(PROGRAM, kept, tolerance="5e") == plan(PROGRAM, light(), tolerance="5e")
    clip[0, 0, 0] = -1.0
    with pytest.raises(Rejected):
        capture(PROGRAM, kept)


def test_sums_read_before_the_first_capture_do_not_outlast_a_change_in_place() -> None:
    """The truth of a frame and its exposure are those of fresh light."""
    clip = np.array(CLIP)
    kept = Light.of_clip(clip)
    assert kept.sum_e.shape == kept.total_e().shape
    clip *= np.float32(300.0)
    for taken in (capture(PROGRAM, kept, effects="all"), capture(PROGRAM, kept, effects="all")):
        fresh = capture(PROGRAM, Light.of_clip(clip), effects="all")
        assert taken.exposure_e.tobytes() == fresh.exposure_e.tobytes()
        assert (taken.light.total_e() == fresh.light.total_e()).all()


def test_infinite_light_is_accepted_unless_it_is_negative() -> None:
    """A pixel with infinite light is invalid in the frame. Negative infinity is no light."""
    clip = np.array(CLIP)
    clip[0, 1, 2] = np.inf
    assert not capture(PROGRAM, Light.of_clip(clip)).valid[0, 1, 2]
    clip[0, 1, 2] = -np.inf
    with pytest.raises(Rejected) as refused:
        capture(PROGRAM, Light.of_clip(clip))
    assert refused.value.diagnostics[0].code == "NS0736"


@pytest.mark.parametrize("name", ["tolerance_max", "torch_device"])
@pytest.mark.parametrize("call", [capture, captures, film, plan, audit])
def test_arguments_of_earlier_versions_say_what_to_do(
    name: str, call: Callable[..., object]
) -> None:
    """`tolerance_max` and `torch_device` give a TypeError that says what to use instead, or to
    leave it out."""
    with pytest.raises(TypeError, match=rf"no longer has the argument {name}(?s:.*)(use|leave)"):
        call(PROGRAM, CLIP, **{name: "5e"})
