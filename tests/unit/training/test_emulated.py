"""The table of what the emulator does to frames, beside the emulator itself on other light."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from marks import slow
from nscc_command import invoke

torch = pytest.importorskip("torch")

from small_runs import clip, run, trained  # noqa: E402
from training_oracle import small_target  # noqa: E402

from nscc.compiler import compile_source  # noqa: E402
from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc.pipeline import Options  # noqa: E402
from nscc.source import Source  # noqa: E402
from nscc.words.container import Container  # noqa: E402
from nscc_runtime.effects.crosstalk import smeared  # noqa: E402
from nscc_runtime.light import Light  # noqa: E402
from nscc_runtime.request import Request  # noqa: E402
from nscc_runtime.sensor import Sensor, default_sensor, sensor_sha256  # noqa: E402
from nscc_runtime.simulate import simulate  # noqa: E402
from nscc_training.codes_files import load_codes  # noqa: E402
from nscc_training.command_settings import EvaluationSettings  # noqa: E402
from nscc_training.emulated import EmulatedSensor, MeasuredTables, emulated_sensor  # noqa: E402
from nscc_training.evaluation.results import result_text  # noqa: E402
from nscc_training.evaluation.runs import evaluate  # noqa: E402
from nscc_training.frame_reading import Dark, FrameRead  # noqa: E402
from nscc_training.loop import setup as setups  # noqa: E402
from nscc_training.loop import train  # noqa: E402
from nscc_training.loop.setup import TrainingSetup, make_setup  # noqa: E402
from nscc_training.programs import compiled, program_of  # noqa: E402
from nscc_training.reconstruct import reconstructed  # noqa: E402
from nscc_training.run_files import WEIGHTS  # noqa: E402
from nscc_training.run_folder import load_run  # noqa: E402
from nscc_training.sensor_model import SensorModel, laid  # noqa: E402
from nscc_training.settings import settings_of  # noqa: E402

RUNS = ROOT / "training/results/shipped"
TILE = (2, 2)
SLOTS = 8
PROGRAM = """nsl 1
target scamp5
frame 8 slots of 125us
code start : 0..N - 1
code stop : 1..N
require start < stop
open when start <= n < stop
pixels start = tile [[0, 2], [0, 3]]
pixels stop = tile [[8, 5], [4, 8]]
"""


@pytest.fixture(scope="module")
def program() -> Container:
    container = compile_source(Source("p.nsl", PROGRAM), Path(), Options(level=1)).container
    assert container is not None
    return container


QUIET = {
    "analog_noise_lsb": 0.4,
    "spread_noise_lsb": 0.65,
    "adc_pattern_lsb": 0.5,
    "adc_smooth_lsb": 0.0,
    "adc_level_lsb": 0.0,
    "analog_bias_lsb": 1.0,
}
"""Errors whose mean a few chips and frames tell."""


def sensor_of(program: Container) -> Sensor:
    return default_sensor(program.target).changed(**QUIET)


def emulated_codes(program: Container, light: Light, seeds: tuple[int, int]):
    """Codes above the ADC's offset (2, rows, cols) of two frames with all effects."""
    sensor, (seed, device_seed) = sensor_of(program), seeds
    request = Request.of(effects="all", seed=seed, device_seed=device_seed, repeat=2)
    frame = simulate(program, light, sensor, request).frame.frame
    return np.asarray(frame[..., 0, :, :] - sensor.adc_offset_lsb, np.float32)


@pytest.fixture(scope="module")
def table(program: Container) -> EmulatedSensor:
    return emulated_sensor(program, TILE, sensor_of(program), "all")


def share(program: Container) -> torch.Tensor:
    assert program.pixel_codes is not None
    lanes = program.table.shutter_of_code[program.pixel_codes[:2, :2]]
    return torch.from_numpy(program.table.shutters[:, 0].mean(axis=1)[lanes])


@pytest.mark.parametrize("level", [slow(0.1), 0.45, slow(0.93)])
def test_codes_of_the_model_have_the_moments_of_the_emulators(
    program: Container, table: EmulatedSensor, level: float
) -> None:
    """Mean, deviation from steady light (bias) and variance of every place, within a tenth."""
    sensor = sensor_of(program)
    model = SensorModel.of(sensor, program.target)
    rows, cols = program.target.rows, program.target.cols
    light_e = np.full((rows, cols), level * sensor.full_well_e, np.float32)
    light = Light.of_still(light_e, np.full(SLOTS, 1 / SLOTS))
    wanted = np.concatenate([emulated_codes(program, light, (90 + k, 90 + k)) for k in range(3)])
    exposure = torch.from_numpy(light_e).double() * laid(share(program), rows, cols)
    generator = torch.Generator().manual_seed(1)
    codes, _full = table.read_out(exposure.expand(3, -1, -1), model, generator)
    found = codes.numpy()
    for row, col in np.ndindex(2, 2):
        mine, theirs = (each[:, row::2, col::2] for each in (found, wanted))
        ideal = float(exposure[row, col]) / sensor.electrons_per_lsb
        assert mine.mean() == pytest.approx(theirs.mean(), rel=0.01, abs=0.15)
        assert mine.mean() - ideal == pytest.approx(theirs.mean() - ideal, rel=0.1, abs=0.15)
        assert mine.var() == pytest.approx(theirs.var(), rel=0.1)
    # Photons and the readout alone vary much less.
    photons = level * sensor.full_well_e / sensor.electrons_per_lsb**2
    assert wanted[:, ::2, ::2].var() > 1.3 * (photons + sensor.adc_noise_lsb**2)


def test_a_shutter_that_moves_to_another_place_keeps_its_response(table: EmulatedSensor) -> None:
    """The expected responses come from a measurement of the same shutters at other places. The
    tables themselves need no new measurement."""
    turned = PROGRAM.replace("[[0, 2], [0, 3]]", "[[3, 0], [2, 0]]")
    turned = turned.replace("[[8, 5], [4, 8]]", "[[8, 8], [5, 4]]")
    other = compile_source(Source("p.nsl", turned), Path(), Options(level=1)).container
    assert other is not None
    measured = emulated_sensor(other, TILE, sensor_of(other), "all")
    shutters = torch.eye(4).reshape(4, 2, 2)

    def unneeded() -> EmulatedSensor:
        raise AssertionError("measured again")

    tables = MeasuredTables()
    tables.arrange(shutters, lambda: table)
    tables.arrange(shutters.flatten(1)[:, [3, 0, 1, 2]].reshape(4, 2, 2), unneeded)
    assert tables.table is not None
    assert torch.equal(tables.table.share, measured.share)
    assert torch.allclose(tables.table.code, measured.code, atol=0.4)
    assert torch.allclose(tables.table.spread, measured.spread, atol=0.2)
    assert not torch.allclose(table.code[0, 0, 0], table.code[0, 0, 1], atol=3)


def test_places_of_one_shutter_have_one_response(table: EmulatedSensor) -> None:
    """A tile has two shutters, each at two places. Places of the same shutter get the code table of
    the first."""
    tables = MeasuredTables()
    tables.arrange(torch.tensor([[[1, 0], [1, 0]], [[0, 1], [0, 1]]]), lambda: table)
    assert tables.table is not None
    assert torch.equal(tables.table.code, table.code[:, :1].expand(-1, 2, 2))


def test_the_model_of_the_readout_has_the_spatial_correlation_of_the_emulator() -> None:
    """The test compares levels of frames, the smooth pattern and correlations of neighbours with
    frames of other chips. Light is even, and all pixels are always open."""
    text = "nsl 1 frame 8 slots of 125us open when true"
    program = compile_source(Source("p.nsl", text), Path(), Options(level=1)).container
    assert program is not None
    sensor, size = default_sensor(program.target), (program.target.rows, program.target.cols)
    light_e = np.full(size, 0.3 * sensor.full_well_e, np.float32)
    light = Light.of_still(light_e, np.full(SLOTS, 1 / SLOTS))
    wanted = np.concatenate(
        [
            simulate(program, light, sensor, Request.of(effects="all", seed=s, device_seed=s))
            .frame.frame.astype(float)
            .reshape(1, *size)
            for s in range(80, 104)
        ]
    )
    table = emulated_sensor(program, (1, 1), sensor, "all", 2)
    exposure = torch.from_numpy(light_e).double().expand(24, -1, -1)
    generator = torch.Generator().manual_seed(1)
    codes, _ = table.read_out(exposure, SensorModel.of(sensor, program.target), generator)

    def described(frames: np.ndarray) -> dict[str, float]:
        centred = frames - frames.mean(axis=(1, 2), keepdims=True)
        blocks = centred.reshape(24, 16, size[0] // 16, 16, size[1] // 16).mean(axis=(2, 4))
        return {
            "level": float(frames.mean(axis=(1, 2)).std()),
            "smooth": float(blocks.std()),
            "down": float((centred[:, 1:] * centred[:, :-1]).mean() / centred.var()),
            "across": float((centred[..., 1:] * centred[..., :-1]).mean() / centred.var()),
        }

    found, chips = described(codes.numpy()), described(wanted)
    assert chips["level"] > 0.3
    assert chips["smooth"] > 1.5
    for name, tolerance in {"level": 0.15, "smooth": 0.5, "down": 0.06, "across": 0.06}.items():
        assert found[name] == pytest.approx(chips[name], abs=tolerance), name


def test_the_table_gives_changed_codes_their_new_exposure(table: EmulatedSensor) -> None:
    """Some places are open for a longer or shorter time than when the table was measured."""
    stops = "[[4, 8], [2, 5]]"
    other = compile_source(
        Source("p.nsl", PROGRAM.replace("[[8, 5], [4, 8]]", stops)), Path(), Options(level=1)
    ).container
    assert other is not None
    sensor = sensor_of(other)
    light_e = np.full((other.target.rows, other.target.cols), 0.45 * sensor.full_well_e, "f4")
    light = Light.of_still(light_e, np.full(SLOTS, 1 / SLOTS))
    wanted = np.concatenate([emulated_codes(other, light, (70 + k, 70 + k)) for k in range(3)])
    exposure = torch.from_numpy(light_e).double() * laid(share(other), *light_e.shape)
    codes, _ = table.read_out(exposure[None], SensorModel.of(sensor, other.target), None)
    for row, col in np.ndindex(2, 2):
        mine, theirs = (each[:, row::2, col::2].mean() for each in (codes.numpy(), wanted))
        assert mine == pytest.approx(theirs, rel=0.02, abs=0.5)


DIM = {
    "shutter": {"class": "d", "slots": 16, "slot_us": 1000.0, "tile": [2, 2], "init": "quad"},
    "sensor": {"effects": "all"},
}
"""Places of the initial code open at slots 0, 4, 8 and 12."""
LATER = {"start": np.array([[0, 0], [5, 6]]), "stop": np.array([[9, 11], [16, 16]])}
"""A code of which a place that opened at slot 4 opens at slot 0."""


def dark_codes(setup: TrainingSetup, share: float) -> tuple[np.ndarray, np.ndarray]:
    """Mean codes (2, 2) of the run's table and of the emulated chip, at light of `share` full wells
    over the frame."""
    program = compiled(program_of(setup.encoder, setup.chip), setup.chip).container
    assert program is not None
    assert setup.emulated is not None
    size = (program.target.rows, program.target.cols)
    light_e = np.full(size, share * setup.sensor.full_well_e, np.float32)
    light = Light.of_still(light_e, np.full(16, 1 / 16))
    captures = np.concatenate([emulated_codes(program, light, (40 + k, 40 + k)) for k in range(4)])
    opened = laid(setup.encoder.hard().mean(dim=0).double(), *size)
    exposure = torch.from_numpy(light_e).double() * opened
    model = replace(setup.model, adc_bits=16)  # codes are clipped at 0, not rounded by the table
    codes = setup.emulated.read_out(exposure[None], model, None)[0].numpy()
    return tuple(
        np.array([[each[:, r::2, c::2].mean() for c in range(2)] for r in range(2)])
        for each in (codes, captures)
    )  # type: ignore[return-value]


def test_the_table_follows_the_codes_in_dim_light(tmp_path: Path) -> None:
    """A place that comes to open in slot 0 loses the offset of its second read."""
    file = tmp_path / "sensor.toml"
    file.write_text("".join(f"{name} = {value}\n" for name, value in QUIET.items()))
    setup = make_setup(settings_of(DIM | {"sensor": {"effects": "all", "file": str(file)}}))
    assert setup.emulated is not None
    setup.encoder.load_codes(LATER)
    old, _ = dark_codes(setup, 0.05)
    setup.follow_codes()
    followed, captured = dark_codes(setup, 0.05)
    assert abs(old - captured).max() > 1
    # The codes of the table are whole numbers here, so their mean may be half a code off.
    assert abs(followed - captured).max() < 0.6
    table = setup.emulated
    setup.follow_codes()
    assert setup.emulated is table  # equal codes are not measured again


def test_training_measures_the_sensor_again_and_resumes_exactly(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(train, "_FOLLOW_EVERY", 2)
    chip = small_target(invoke(["targets", "scamp5", "--toml"], tmp_path).out, 64, 48)
    (tmp_path / "chip.toml").write_text(chip)
    values = {
        "shutter": {
            "class": "d",
            "slots": 4,
            "tile": [2, 2],
            "target": str(tmp_path / "chip.toml"),
            "init": "random",
        },
        "sensor": {"effects": "all"},
        "data": {"protocol": "video-v1", "patch": 16, "scenes": 2, "val_items": 1},
        "train": {"steps": 6, "batch": 1, "validate_every": 3, "code_rate": 0.5},
    }
    measured = []
    monkeypatch.setattr(
        setups, "emulated_sensor", lambda *args: measured.append(args) or emulated_sensor(*args)
    )
    run(values, tmp_path / "whole")
    assert len(measured) > 1
    # The checkpoint of step 3 belongs to the table of step 2.
    run(values, tmp_path / "parts", stop_after=3)
    run(values, tmp_path / "parts")
    for name in ("codes.npz", WEIGHTS, "metrics.csv"):
        parts, whole = ((tmp_path / folder / name).read_bytes() for folder in ("parts", "whole"))
        assert parts == whole, name


def test_the_table_has_the_crosstalk_of_the_emulator_and_a_gradient_near_1(
    program: Container, table: EmulatedSensor
) -> None:
    """The table smears light as the emulator does. Its slope, in codes times electrons a code, lies
    between 0.8 and 1.05."""
    generator = np.random.default_rng(1)
    light = generator.random((3, 7, 9))
    wanted = smeared(light, table.crosstalk)
    assert table.crosstalk > 0
    np.testing.assert_allclose(table.smeared(torch.from_numpy(light)).numpy(), wanted, atol=1e-12)
    sensor = default_sensor(program.target)
    model = SensorModel.of(sensor, program.target)
    exposure = torch.full((1, 4, 4), 9000.0, dtype=torch.float64, requires_grad=True)
    table.read_out(exposure, model, None)[0].sum().backward()
    gain = exposure.grad * sensor.electrons_per_lsb
    assert ((gain > 0.8) & (gain < 1.05)).all()


def test_evaluating_a_run_under_effects_lowers_its_score_and_says_how_it_was_trained(
    tmp_path: Path,
) -> None:
    """The run was trained with noise only. Reconstructing a frame with all effects gives a
    warning."""
    clip(tmp_path / "c.mat", 16, 256)
    run = RUNS / "clips/class-d/learned-from-2x2/unet2d/noise-alone/seed0"
    plain, _ = evaluate(EvaluationSettings(str(run), tmp_path, "video-v1"))
    chip, _ = evaluate(EvaluationSettings(str(run), tmp_path, "video-v1", effects="all"))
    assert chip["settings"]["effects"] == "all"
    assert chip["mean"] < plain["mean"] - 0.1
    assert "on a chip with effects all; trained with noise" in result_text(chip)
    values = ("adc_noise_lsb=3.0",)
    with pytest.raises(Rejected) as refusal:  # values of a chip that exposes nothing
        evaluate(EvaluationSettings(str(run), tmp_path, "video-v1", changes=values))
    assert refusal.value.diagnostics[0].code == "NS0841"
    line = ["run", str(run / "shutter.nsl"), "--scene", "builtin:motion", "--effects", "all"]
    assert invoke([*line, "-o", "f.npz"], tmp_path).status == 0
    made = invoke(["reconstruct", str(run), "f.npz", "-o", "o.npz"], tmp_path)
    assert made.status == 0, made.err
    assert "warning[NS0842]" in made.err
    assert "analog" in made.err
    baseline = ["evaluate", "gap-tv", "--data", ".", "--protocol", "video-v1", "--effects", "all"]
    assert "NS0841" in invoke(baseline, tmp_path).err


def test_saturated_pixels_are_marked_as_the_emulator_marks_them(
    program: Container, table: EmulatedSensor
) -> None:
    """The light fills some pixels, or is just above the full well of one."""
    sensor = sensor_of(program)
    model = SensorModel.of(sensor, program.target)
    rows, cols = program.target.rows, program.target.cols
    for level in (1.4, 1.05 / float(share(program).max())):
        light_e = np.full((rows, cols), level * sensor.full_well_e, np.float32)
        light = Light.of_still(light_e, np.full(SLOTS, 1 / SLOTS))
        chosen = Request.of(effects="all", seed=50, device_seed=50)
        wanted = simulate(program, light, sensor, chosen).frame.saturated[0]
        exposure = torch.from_numpy(light_e).double() * laid(share(program), rows, cols)
        generator = torch.Generator().manual_seed(2)
        _, found = table.read_out(exposure[None], model, generator)
        for row, col in np.ndindex(2, 2):
            mine, theirs = found[0, row::2, col::2].numpy(), wanted[row::2, col::2]
            assert mine.mean() == pytest.approx(theirs.mean(), abs=0.06)


def test_a_run_starts_from_the_weights_and_codes_of_another(tmp_path: Path) -> None:
    """With rate 0 the run keeps the weights of the other run, which may then be deleted."""
    shutter = {"slots": 4, "tile": [2, 2]}
    first = trained(tmp_path / "a", shutter={**shutter, "init": "random"})
    begun = trained(
        tmp_path / "b",
        shutter={**shutter, "init": str(first), "learn": False},
        decoder={"init": str(first)},
        train={"rate": 0.0},
    )
    assert (begun / WEIGHTS).read_bytes() == (first / WEIGHTS).read_bytes()
    codes = [load_codes(folder / "codes.npz")["stop"] for folder in (first, begun)]
    np.testing.assert_array_equal(*codes)
    (first / WEIGHTS).unlink()
    assert load_run(begun).setup.settings.decoder.init == str(first)
    card = (begun / "model_card.md").read_text().split("\n\n")[1]
    score = json.loads((begun / "result.json").read_text())["headline"]["psnr_db"]
    assert card.startswith(f"**{score:.2f} dB")
    assert "no other effects of a chip" in card


EFFECTS = "analog,shot,full_well"


@pytest.mark.slow
def test_a_result_of_a_run_under_effects_begins_with_its_scores_with_and_without_them(
    tmp_path: Path,
) -> None:
    chip = small_target(invoke(["targets", "scamp5", "--toml"], tmp_path).out, 64, 48)
    (tmp_path / "chip.toml").write_text(chip)
    shutter = {"slots": 4, "tile": [2, 2], "target": str(tmp_path / "chip.toml")}
    run = trained(tmp_path / "r", shutter=shutter, sensor={"effects": EFFECTS})
    result = json.loads((run / "result.json").read_text())
    assert list(result)[1] == "headline"
    headline, rows = result["headline"], result["robustness"]
    assert headline["effects"] == EFFECTS
    assert headline["psnr_db"] == rows[0]["psnr_db"] != headline["noise_alone_psnr_db"]
    # A sensor that is off is emulated anew, not the old one with another name.
    assert len(rows) == 7
    assert "noise x 2" not in {row["change"] for row in rows}
    assert len({row["psnr_db"] for row in rows}) == len(rows)
    card = (run / "model_card.md").read_text().split("\n\n")[1]
    for key in ("psnr_db", "noise_alone_psnr_db"):
        assert f"{headline[key]:.2f} dB" in card


@pytest.mark.parametrize(("init", "name"), [("nowhere", "unet2d"), ("clip", "unet2d")])
def test_weights_that_do_not_fit_are_refused(init: str, name: str) -> None:
    """A file that does not exist, and weights of another decoder, give NS0815, which names
    `decoder.init`."""
    with pytest.raises(Rejected) as refusal:
        make_setup(settings_of({"decoder": {"name": name, "init": init}}))
    assert refusal.value.diagnostics[0].code == "NS0815"
    assert "decoder.init" in refusal.value.diagnostics[0].message


def test_the_dark_level_of_a_run_is_subtracted_once() -> None:
    """The run was trained under effects: only the mean of each place is subtracted."""
    folder = load_run(RUNS / "stills/class-b/2x2/unet2d/every-effect/seed0")
    size = (folder.setup.target.rows, folder.setup.target.cols)
    generator = np.random.default_rng(5)
    codes = generator.integers(20, 90, (1, *size)).astype(np.uint8)
    meta = {"sensor_sha256": sensor_sha256(folder.setup.sensor)}
    shutters = laid(folder.setup.encoder.hard(), *size).numpy().astype(bool)
    read = FrameRead(codes, np.zeros(codes.shape, bool), meta, shutters)
    rows, cols = folder.setup.encoder.spec.tile
    known = np.tile(generator.random((rows, cols)) * 3, (size[0] // rows, size[1] // cols))
    spot = known.copy()
    spot[96:104, 96:104] += 40  # several pixels: the network smooths a single one
    made = [
        reconstructed(folder, read, "f", dark, force=False)[0]
        for dark in (None, *(Dark("d", offset, {}, None, 0.0) for offset in (known, spot)))
    ]
    np.testing.assert_allclose(made[0], made[1], rtol=1e-4)
    assert (made[2][96:104, 96:104] < 0.9 * made[0][96:104, 96:104]).all()
