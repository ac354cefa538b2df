"""Codes mean what the target says they mean: black, half and full come back as electrons, whatever
the readout, from the emulator and from a device. (C++ and the SCAMP-5d's loader: test_emit_cpp,
test_device_firmware.)"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from device_sessions import ChipAtOnce, board_program, new_host
from device_simulation import Simulation
from emulator_programs import bumps, target_of
from loader_twin.loader import Loader

from nscc.chips.target import Target
from nscc.compiler import compile_source
from nscc.operations import Op
from nscc.pipeline import Options
from nscc.prove.proof import prove
from nscc.source import Source
from nscc.words import readout as readout_words
from nscc.words.container import Container
from nscc.words.legality import decoded
from nscc.words.readout import converter_of, preparation_of, spreading
from nscc_runtime.device import firmware, tasks
from nscc_runtime.device.device_chip import frame_of
from nscc_runtime.device.messages import Channel
from nscc_runtime.device.objects import upload_of
from nscc_runtime.device.tasks import FrameRequest
from nscc_runtime.effects import selected
from nscc_runtime.emulator import expose
from nscc_runtime.frame_file import read_out
from nscc_runtime.light import Light
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan import PlanRequest
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.reference import frames
from nscc_runtime.sensor import default_sensor

WELL_E = 30_000.0
CODES = {"spread": (0, 128, 255), "full": (128, 192, 255), "half": (0, 64, 127)}
"""By hand: of nothing, half a well and a well. Steps are 30000 / 255 and twice that."""


def chip(readout: str) -> Target:
    """An array of three pixels in a row."""
    return replace(target_of((1, 3)), readout=readout)  # type: ignore[arg-type]


def program_and_light(target: Target) -> tuple[Container, Light]:
    """Open all the time; one pixel each sees nothing, half a well, a well."""
    container = bumps(target, None, np.full((1, 3), 4), 4, "latch")
    container = replace(container, slot_us=(1000.0,) * 4)
    electrons = np.array([[0.0, WELL_E / 2, WELL_E]], np.float32)
    return container, Light.of_clip(np.repeat(electrons[None] / 4, 4, axis=0))


@pytest.mark.parametrize("readout", list(CODES))
def test_emulated_codes_mean_what_the_target_says(readout: str) -> None:
    target = chip(readout)
    container, light = program_and_light(target)
    sensor = default_sensor(target)
    frame = read_out(expose(container, light), target, sensor)
    check(frame.frame, readout, target)
    assert frame.saturated.tolist() == [[[False, False, True]]]
    planning = PlannedScene(container, sensor, light)
    plan = make_plan(planning, PlanRequest(selected("none"), 5.0))
    [planned] = planning.frames(plan.kept, 0, 1)
    np.testing.assert_array_equal(planned.frame, frame.frame)


@pytest.mark.parametrize(
    ("kind", "readout"), [*(("python", readout) for readout in CODES), ("firmware", "full")]
)
def test_codes_of_a_device_mean_what_the_target_says(
    kind: str, readout: str, tmp_path: Path
) -> None:
    target = chip(readout)
    container, light = program_and_light(target)
    emulated = ChipAtOnce(lambda _: light, target)
    if kind == "firmware" and firmware.compiler() is None:
        pytest.skip("no C++ compiler: the firmware cannot be built")
    host, upload = new_host(1), upload_of(container, bytes(32))
    wanted = FrameRequest(1, Channel.CODES, upload)

    def work() -> tasks.Task[tasks.FetchedFrame]:
        yield from tasks.upload(host, upload)
        return (yield from tasks.capture(host, wanted))

    if kind == "python":
        taken = Simulation(host, Loader(target, emulated, "x")).run(host.lasting(work))
    else:
        from device_lockstep import Lockstep

        with Lockstep(firmware.built(target, ("-O0",), tmp_path), emulated) as loader:
            taken = Simulation(host, loader).run(host.lasting(work))
    assert isinstance(taken, tasks.FetchedFrame)
    sensor = default_sensor(target)
    frame = frame_of(taken.data, Channel.CODES, (1, 1, 3), sensor, target)
    check(frame.frame, readout, target)
    np.testing.assert_allclose(
        frame.exposure_e[0, 0], [0.0, WELL_E / 2, WELL_E], atol=sensor.electrons_per_lsb / 2
    )


def test_a_program_that_leaves_no_register_is_converted_as_it_is() -> None:
    """Emulator and stand-in give code 128 for 0 electrons of such a program."""
    rules = (f"bucket b{n} open when n == {n}" for n in range(6))
    container = compiled("frame 6 slots of 1ms", *rules)
    target = container.target
    assert len(target.analog_available) == 6
    assert preparation_of(container).level is None
    electrons = np.array([[0.0, WELL_E / 2, WELL_E]], np.float32)
    light = Light.of_clip(np.repeat(electrons[None], 6, axis=0))
    sensor = default_sensor(converter_of(container))
    found = read_out(expose(container, light), target, sensor)
    assert found.frame.reshape(6, 3).tolist() == [list(CODES["full"])] * 6
    in_all = ChipAtOnce(lambda _: light, target, default_sensor(target))
    sent = np.frombuffer(in_all.execute(board_program(container), Channel.CODES).frame, np.uint8)
    assert sent.reshape(6, 3).tolist() == found.frame.reshape(6, 3).tolist()
    np.testing.assert_allclose(
        (found.frame[0, 0] - sensor.adc_offset_lsb) * sensor.electrons_per_lsb,
        electrons[0],
        atol=sensor.electrons_per_lsb,
    )


@pytest.mark.parametrize("range_e", [{"full_well_e": 20_000.0}, {"register_max_e": 25_000.0}])
def test_codes_computed_by_hand_give_electrons_on_targets_with_other_registers(
    range_e: dict[str, float],
) -> None:
    """On one target a step of IN meets the full well to half a step. On the other target no
    register holds the full well."""
    target = replace(chip("spread"), in_step_e=30_000 / 127, **range_e)
    well_e, level = target.full_well_e, target.spread_level
    assert (level is None) == ("register_max_e" in range_e)
    light_e = np.array([0.1, 0.5, 0.9]) * well_e
    held_e = light_e if level is None else 2 * light_e + level * 30_000 / 127
    lsb_e = 2 * well_e / 255
    codes = np.rint(held_e / lsb_e + (128 if level is None else 127.5))
    sensor = default_sensor(target)
    found_e = (codes - sensor.adc_offset_lsb) * sensor.electrons_per_lsb
    np.testing.assert_allclose(found_e, light_e, atol=0.51 * sensor.electrons_per_lsb)


def test_the_noise_of_the_words_before_readout_equals_a_computation_by_hand() -> None:
    """The test computes each word with its error and compares mean and deviation with frames of the
    emulator."""
    target = chip("spread")
    sensor = default_sensor(target)
    container, light = program_and_light(target)
    numbers = np.random.default_rng(1)
    sigma_e, count = sensor.analog_noise_lsb * sensor.analog_lsb_e, 4000
    error = sigma_e * numbers.standard_normal((3, count))
    full_e = -WELL_E
    copy, scratch = (-(WELL_E / 2 + full_e) + each for each in error[:2])
    spread = -(scratch + copy + full_e) + error[2]
    by_hand = np.rint(spread / (2 * WELL_E / 255) + 127.5)
    made = frames(container, light, sensor, selected("spreading"), count=count)
    codes = np.array([frame.frame[0, 0, 1] for frame in made], np.float64)
    assert codes.std() == pytest.approx(by_hand.std(), rel=0.06)
    assert codes.mean() == pytest.approx(by_hand.mean(), abs=0.6)
    quiet = default_sensor(replace(target, readout="full"))
    assert quiet.spread_noise_lsb == 0


@pytest.mark.parametrize("fault", range(3))
def test_a_wrong_spreading_word_is_found_by_the_proof(
    monkeypatch: pytest.MonkeyPatch, fault: int
) -> None:
    container = compiled(
        "frame 4 slots of 1ms", "bucket a open when n < k", "bucket b open when n > 1"
    )
    assert prove(container, decoded(container)).holds

    def wrong(target: Target, register: str, copy: str) -> tuple[Op, ...]:
        words = [*spreading(target, register, copy)]
        words[fault] = replace(words[fault], sources=words[fault].sources[:-1])
        return tuple(words)

    monkeypatch.setattr(readout_words, "spreading", wrong)
    failure = prove(container, decoded(container)).failure
    assert failure is not None
    assert "the meaning of its codes" in failure.reason


def compiled(*statements: str) -> Container:
    """A program for three pixels in a row."""
    text = "\n".join(("nsl 1", statements[0], "code k : 0..3", *statements[1:], "pixels k = x"))
    options = Options(target=chip("spread"), cache=False)
    container = compile_source(Source("p.nsl", text), Path(), options).container
    assert container is not None
    return container


def check(codes: np.ndarray, readout: str, target: Target) -> None:
    """The codes, and that they are electrons again by the sensor's figures."""
    assert codes.reshape(-1).tolist() == list(CODES[readout])
    sensor = default_sensor(target)
    electrons = (codes - sensor.adc_offset_lsb) * sensor.electrons_per_lsb
    wanted = [0.0, WELL_E / 2, WELL_E]
    np.testing.assert_allclose(electrons.reshape(-1), wanted, atol=sensor.electrons_per_lsb / 2)
