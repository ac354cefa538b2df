"""Chips without logic: what they are sent, that it is proved, and what light becomes of it."""

from __future__ import annotations

import json
from dataclasses import replace
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke
from numpy.typing import NDArray
from program_oracle import table_of

import nscc
import nscc_runtime
from nscc.chips.load import load_target, target_toml
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Rejected
from nscc.emit.products import emitted
from nscc.shutter_program import ShutterProgram
from nscc.stream.planes_proof import prove_planes
from nscc.words.container import Container
from nscc.words.file import from_bytes, to_bytes
from nscc.words.readout import converter_of
from nscc.words.stream import DRAIN, Stream, schedule
from nscc_runtime.response import expected_noise
from nscc_runtime.sensor import default_sensor

CHIP = replace(load_target("dual-tap", Path()), rows=6, cols=11, name="small")
DRAINED = replace(CHIP, drain=True)
LONE = replace(CHIP, drain=True, taps=("ONLY",), tap_gain=())
FRAME = "frame 8 slots of 1ms\n"
STOPS = FRAME + "code stop : 0..8\nopen when n < stop\npixels stop = (2 * x + 3 * y) % 9\n"
SPLIT = (
    FRAME + "code split : 1..7\nbucket early open when n < split\n"
    "bucket late open when n >= split\npixels split = 1 + (x + y) % 7\n"
)
APART = SPLIT.replace("n >= split", "n >= 7")
FREE = FRAME + "code bits : bit[8]\nopen when bits[n]\npixels bits = (37 * x + 101 * y) % 256\n"


def built(text: str, chip: Target = CHIP) -> ShutterProgram:
    return nscc.compile(f"nsl 1\n{text}", target=chip)


def sent(program: ShutterProgram) -> tuple[Container, Stream]:
    assert program.container.stream is not None
    return program.container, program.container.stream


def opened(program: ShutterProgram) -> NDArray[np.bool_]:
    """When each pixel is open in each bucket (N, rows, cols, buckets), by the text alone."""
    assert program.compiled is not None
    checked = program.compiled.program
    meaning = table_of(checked)
    codes = checked.table.codes[program.code_at_pixels]
    rows, cols = program.shape
    found = [[meaning[tuple(codes[y, x].tolist())] for x in range(cols)] for y in range(rows)]
    return np.array(found, np.bool_).reshape(rows, cols, -1, program.slots).transpose(3, 0, 1, 2)


def followed(stream: Stream, shape: tuple[int, int]) -> NDArray[np.int64]:
    """Where light goes, one bit after the other (N, rows, cols)."""
    found = np.empty((stream.slots, *shape), np.int64)
    for slot, y, x in np.ndindex(*found.shape):
        bit = stream.planes[slot, y, x // 8] >> x % 8 & 1
        found[slot, y, x] = (stream.ones if bit else stream.zeros)[slot]
    return found


@pytest.mark.parametrize(
    ("text", "chip"),
    [(STOPS, CHIP), (STOPS, LONE), (SPLIT, CHIP), (SPLIT, DRAINED), (FREE, CHIP)],
)
def test_planes_send_light_where_the_text_says(text: str, chip: Target) -> None:
    program = built(text, chip)
    container, stream = sent(program)
    places, opens = followed(stream, program.shape), opened(program)
    for bucket in range(opens.shape[-1]):
        assert np.array_equal(places == bucket, opens[..., bucket])
    closed = places[~opens.any(axis=-1)]
    assert set(closed.tolist()) <= ({DRAIN} if chip.drain else {len(container.buckets)})


def test_every_single_bit_is_proved() -> None:
    container, stream = sent(built(SPLIT))
    assert prove_planes(container).holds
    rng = np.random.default_rng(0)
    for _ in range(40):
        slot, y, x = (int(rng.integers(0, most)) for most in (8, 6, 11))
        planes = stream.planes.copy()
        planes[slot, y, x // 8] ^= 1 << x % 8
        proof = prove_planes(replace(container, stream=replace(stream, planes=planes)))
        assert proof.failure is not None
        assert f"x = {x}, y = {y}" in proof.failure.reason
        assert f"slot {slot}" in proof.failure.reason
    crossed = replace(stream, ones=stream.zeros, zeros=stream.ones)
    assert not prove_planes(replace(container, stream=crossed)).holds


@pytest.mark.parametrize("pipelined", [True, False])
def test_planes_load_in_turn_and_act_when_complete(pipelined: bool) -> None:
    chip = replace(CHIP, pipelined=pipelined, row_load_us=100.0)
    loads = list(schedule(chip, (700.0, 650.0, 900.0)))
    # Six rows of 100 us load in 600 us: before their slot if pipelined, else at its start.
    assert [each.acts_us for each in loads] == (
        [0.0, 700.0, 1350.0] if pipelined else [600.0, 1300.0, 1950.0]
    )
    assert all(each.acts_us - each.load_us == 600.0 for each in loads)
    # Six rows of 167 us take longer than a slot of 1 ms.
    late = replace(sent(built(STOPS))[0], target=replace(chip, row_load_us=167.0))
    assert not prove_planes(late).holds


def test_a_slot_of_just_the_loading_time_fits_a_pipelined_chip_only() -> None:
    """Six rows of 0.5 us load in 3 us, which is the slot. Without a pipeline or with slower rows it
    gives NS0508."""
    text = STOPS.replace("1ms", "3us")
    assert built(text, replace(CHIP, row_load_us=0.5)).container.stream is not None
    for chip in (replace(CHIP, row_load_us=0.5, pipelined=False), replace(CHIP, row_load_us=0.6)):
        with pytest.raises(Rejected) as caught:
            built(text, chip)
        (wrong,) = caught.value.diagnostics
        assert wrong.code == "NS0508"
        assert wrong.data["required"] == pytest.approx(chip.rows * chip.row_load_us)
        assert wrong.helps


@pytest.mark.parametrize(
    ("text", "chip", "said"),
    [
        (SPLIT.replace("n >= split", "n >= split - 1"), DRAINED, "open in `early` and in `late`"),
        (SPLIT.replace("n >= split", "n > split"), CHIP, "has no drain"),
        (SPLIT.replace("n >= split", "n > split"), DRAINED, "3 destinations"),
        (SPLIT, LONE, "2 buckets need as many taps"),
    ],
)
def test_light_that_no_bit_can_sort_is_refused(text: str, chip: Target, said: str) -> None:
    with pytest.raises(Rejected, match="NS0509") as caught:
        built(text, chip)
    assert said in caught.value.diagnostics[0].message


def test_the_destinations_of_light_may_change_from_slot_to_slot() -> None:
    program = built(APART.replace("1..7", "1..6").replace("% 7", "% 6"), DRAINED)
    _, stream = sent(program)
    assert {(int(a), int(b)) for a, b in zip(stream.ones, stream.zeros, strict=True)} == {
        (0, DRAIN),
        (1, DRAIN),
    }


def test_a_container_of_planes_is_read_as_it_was_written() -> None:
    container, stream = sent(built(SPLIT))
    data = to_bytes(container)
    again = from_bytes(data, "x.icw")
    assert again.stream is not None
    assert np.array_equal(again.stream.planes, stream.planes)
    assert again.target == CHIP
    assert to_bytes(again) == data
    behind = stream.planes.copy()
    behind[0, 0, -1] |= 0x80
    for wrong in (
        replace(stream, planes=behind),
        replace(stream, ones=np.full(8, 2, np.int8)),
        replace(stream, zeros=np.full(8, DRAIN, np.int8)),
        None,
    ):
        with pytest.raises(ValueError, match="unsound"):
            to_bytes(replace(container, stream=wrong))


def test_planes_follow_the_codes_that_pixels_get_later() -> None:
    """A program compiled with open codes gets stops of 0 to 8. The proof holds, and each plane
    opens the pixels whose stop lies above the slot."""
    program = nscc.compile(f"nsl 1\n{STOPS}", target=CHIP, codes="open")
    codes = np.arange(66).reshape(6, 11) % 9
    moved = program.with_pixels(stop=codes)
    container, stream = sent(moved)
    assert prove_planes(container).holds
    assert np.array_equal(followed(stream, moved.shape) == 0, np.arange(8)[:, None, None] < codes)


def test_emitted_planes_have_their_times_and_taps() -> None:
    program = built(SPLIT)
    assert program.compiled is not None
    (data,) = emitted("planes", program.compiled, "p").values()
    with np.load(BytesIO(data)) as file:
        meta = json.loads(str(file["meta"]))
        stream = Stream(file["planes"], file["ones"], file["zeros"])
        assert meta["format"] == "nscc-planes-1"
        assert meta["taps"] == ["TAP1", "TAP2"]
        # Slots of 1 ms; six rows of 0.5 us load before each.
        assert np.array_equal(file["acts_us"], 1000.0 * np.arange(8))
        assert np.allclose(file["load_us"], 1000.0 * np.arange(8) - 3.0)
    assert np.array_equal(followed(stream, program.shape) == 0, opened(program)[..., 0])


def test_exposures_are_the_sums_of_open_slots_times_the_gain() -> None:
    light = np.random.default_rng(1).uniform(0, 500, (8, 6, 11)).astype(np.float32)
    program = built(SPLIT, replace(CHIP, tap_gain=(1.0, 2.5)))
    taken = nscc_runtime.capture(program, light)
    wanted = (light.astype(np.float64)[..., None] * opened(program)).sum(axis=0)
    assert np.allclose(taken.exposure_e, (wanted * [1.0, 2.5]).transpose(2, 0, 1), rtol=1e-12)


def _noisy(chip: Target, effects: str, **values: float) -> NDArray[np.float64]:
    """Exposures of a flat scene of 1000 e a slot, 24 frames: (frames, buckets, rows, cols)."""
    program = built(SPLIT, replace(chip, rows=32, cols=32))
    light = np.full((8, 32, 32), 1000.0, np.float32)
    sensor = nscc_runtime.sensor_for(program, **values)
    taken = nscc_runtime.capture(program, light, effects=effects, repeat=24, sensor=sensor)
    slots = opened(program).sum(axis=0).transpose(2, 0, 1)
    return taken.exposure_e - 1000.0 * slots * np.array(chip.gains)[:, None, None]


def test_each_tap_is_reset_and_read_once() -> None:
    chip = replace(CHIP, tap_gain=(1.0, 3.0))
    off = _noisy(chip, "read,reset", read_noise_e=20.0, reset_noise_e=30.0)
    # A reset is before the gain of a tap, a read after it. Noise of two taps is independent.
    for bucket, gain in enumerate(chip.gains):
        assert np.std(off[:, bucket]) == pytest.approx(np.hypot(20.0, gain * 30.0), rel=0.02)
    assert abs(np.corrcoef(off[:, 0].ravel(), off[:, 1].ravel())[0, 1]) < 0.03


def test_photons_are_counted_once_for_both_taps() -> None:
    off = _noisy(CHIP, "shot")
    # The two taps share out 8000 photons: independent counts, whose sum has their variance.
    assert np.var(off.sum(axis=1)) == pytest.approx(8000, rel=0.03)
    assert np.var(off[:, 0, 0, 0]) == pytest.approx(1000, rel=1.0)


def test_each_tap_has_a_well_of_its_own() -> None:
    off = _noisy(CHIP, "full_well", full_well_e=4500.0)
    slots = opened(built(SPLIT, replace(CHIP, rows=32, cols=32))).sum(axis=0).transpose(2, 0, 1)
    assert np.allclose(off, np.minimum(1000.0 * slots, 4500.0) - 1000.0 * slots)


def test_a_single_latch_loses_light_while_planes_load() -> None:
    chip = replace(CHIP, pipelined=False, row_load_us=10.0)
    off = _noisy(replace(chip), "dead_time")  # 32 rows of 10 us: 32 % of every slot
    slots = opened(built(SPLIT, replace(chip, rows=32, cols=32))).sum(axis=0).transpose(2, 0, 1)
    assert np.allclose(off, -320.0 * slots)
    assert np.allclose(_noisy(CHIP, "dead_time"), 0.0)


def test_effects_of_words_are_absent_by_name() -> None:
    """A chip without words has no error of analog words, registers or decay. Effects of light and
    readout stay."""
    taken = nscc_runtime.capture(built(SPLIT), np.ones((8, 6, 11), np.float32), effects="all")
    plan = taken.exposed.simulated.origin.plan
    assert plan is not None
    absent = {row["name"] for row in plan["effects"] if row["decision"] == "absent"}
    assert {"analog", "register", "decay", "dead_time"} <= absent
    assert not {"shot", "read", "reset", "dark", "full_well", "leakage"} & absent


def test_the_expected_noise_is_that_of_frames() -> None:
    chip = replace(CHIP, rows=64, cols=64, tap_gain=(1.0, 2.0))
    program = built(SPLIT, chip)
    found = expected_noise(program.container)
    assert found is not None
    dark = nscc_runtime.capture(program, np.zeros((8, 64, 64), np.float32), effects="all", repeat=8)
    light_e = dark.frame * (30000.0 / 255) / np.array(chip.gains)[:, None, None]
    # The converter cuts off what is below 0: half of the noise around a dark pixel is seen.
    exposed = dark.exposure_e / np.array(chip.gains)[:, None, None]
    converter = np.array([1.0, 0.5]) * 30000.0 / 255 * np.hypot(0.65, 12**-0.5)
    spread = np.sqrt(np.var(exposed, axis=(0, 2, 3)) + converter**2)
    assert light_e.min() >= 0
    assert found[0] == pytest.approx(np.sqrt(np.mean(spread**2)), rel=0.08)
    # Half a full well has shot noise of 15000 squared electrons.
    assert found[1] ** 2 - found[0] ** 2 == pytest.approx(15000.0)


def test_the_expected_noise_is_a_mean_over_pixels() -> None:
    """The noise is a mean of squares. Three of eleven columns have the long code, so its weight is
    3 / 11."""
    sensor = default_sensor(converter_of(built(STOPS).container)).changed(dark_current_e_per_s=1e6)

    def dark_e2(stop: str) -> float:
        rule = "code stop : 1..8\nopen when n < stop\npixels stop = "
        found = expected_noise(built(FRAME + rule + stop).container, sensor)
        assert found is not None
        return found[0] ** 2

    short_e2, long_e2 = dark_e2("1"), dark_e2("8")
    assert long_e2 > 1.2 * short_e2
    mixed_e2 = dark_e2("8 if x % 4 == 0 else 1")
    assert mixed_e2 == pytest.approx((8 * short_e2 + 3 * long_e2) / 11, rel=1e-6)


def test_a_file_has_the_keys_of_its_kind(tmp_path: Path) -> None:
    text = target_toml(CHIP)
    (tmp_path / "chip.toml").write_text(text)
    assert load_target("chip.toml", tmp_path) == CHIP
    for change, code in (
        (text + '\n[registers]\ndigital = ["R0"]\n', "NS0233"),
        (text.replace("\ntaps =", "\n# taps ="), "NS0234"),
        (text.replace('["TAP1", "TAP2"]', '["TAP1", "TAP1"]'), "NS0236"),
        (text.replace('["TAP1", "TAP2"]', '["TAP1"]').replace("[1.0, 1.0]", "[1.0]"), "NS0236"),
        (text.replace("[1.0, 1.0]", "[1.0]"), "NS0236"),
        (text.replace('kind = "stream"', 'kind = "strem"'), "NS0235"),
        (text.replace("row_load_us = 0.5", "row_load_us = 0"), "NS0235"),
    ):
        (tmp_path / "chip.toml").write_text(change)
        with pytest.raises(Rejected) as caught:
            load_target("chip.toml", tmp_path)
        assert code in {each.code for each in caught.value.diagnostics}


def test_targets_compare_shows_two_chips(tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(f"nsl 1\n{STOPS}")
    found = invoke(["targets", "--compare", "scamp5", "dual-tap", "p.nsl", "--json"], tmp_path)
    assert found.status == 0
    scamp, dual = json.loads(found.out)
    assert (scamp["fits"], dual["fits"]) == (True, True)
    # 176 rows of 0.5 us; a bit for each of 176 x 280 pixels in 8 slots.
    assert dual["shortest_slot_us"] == 176 * 0.5
    assert dual["sent_bits_a_frame"] == 8 * 176 * 280
    assert scamp["sent_bits_a_frame"] == 0
    assert scamp["noise_dark_e"] > dual["noise_dark_e"] > 0
    (tmp_path / "p.nsl").write_text(f"nsl 1\n{STOPS}".replace("1ms", "20us"))
    told = invoke(["targets", "--compare", "scamp5", "dual-tap", "p.nsl"], tmp_path)
    assert told.status == 0
    assert "no, NS0508" in told.out
    assert "88 us or longer" in told.out


@pytest.mark.parametrize(
    "line",
    [
        "build p.nsl -o p.icw --emit asm",
        "build p.nsl -o p.icw --emit cpp",
        "check p.nsl --lowering edges",
        "view p.nsl --gates -o g.png",
        "targets dual-tap --limits",
        "disasm p.icw",
    ],
)
def test_options_that_need_words_are_refused_by_name(line: str, tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(f"nsl 1\ntarget dual-tap\n{STOPS}")
    assert invoke(["build", "p.nsl", "-o", "p.icw"], tmp_path).status == 0
    found = invoke(line.split(), tmp_path)
    assert found.status == 1
    assert found.codes == ["NS0510"]
