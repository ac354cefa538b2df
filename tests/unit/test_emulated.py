"""The table of what the emulator does to frames, beside the emulator itself on other light."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke

torch = pytest.importorskip("torch")

from small_runs import clip  # noqa: E402

from nscc.compiler import compile_source  # noqa: E402
from nscc.pipeline import Options  # noqa: E402
from nscc.source import Source  # noqa: E402
from nscc.words.container import Container  # noqa: E402
from nscc_runtime.effects.crosstalk import smeared  # noqa: E402
from nscc_runtime.light import Light  # noqa: E402
from nscc_runtime.sensor import default_sensor  # noqa: E402
from nscc_training.emulated import EmulatedSensor, emulated_codes, emulated_sensor  # noqa: E402
from nscc_training.evaluation.result_text import result_text  # noqa: E402
from nscc_training.evaluation.subjects import evaluate  # noqa: E402
from nscc_training.run_files import shipped_runs  # noqa: E402
from nscc_training.sensor_model import SensorModel, laid  # noqa: E402

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


@pytest.fixture(scope="module")
def table(program: Container) -> EmulatedSensor:
    return emulated_sensor(program, TILE, default_sensor(program.target), "all")


def share(program: Container) -> torch.Tensor:
    assert program.pixel_codes is not None
    lanes = program.table.shutter_of_code[program.pixel_codes[:2, :2]]
    return torch.from_numpy(program.table.shutters[:, 0].mean(axis=1)[lanes])


@pytest.mark.parametrize("level", [0.1, 0.45, 0.93])
def test_codes_are_the_emulators(program: Container, table: EmulatedSensor, level: float) -> None:
    """Mean, deviation from steady light (bias) and variance of every place, within a tenth."""
    sensor = default_sensor(program.target)
    model = SensorModel.of(sensor, program.target)
    rows, cols = program.target.rows, program.target.cols
    light_e = np.full((rows, cols), level * sensor.full_well_e, np.float32)
    light = Light.of_still(light_e, np.full(SLOTS, 1 / SLOTS))
    wanted = np.concatenate([
        emulated_codes(program, light, sensor, "all", 90 + k, 90 + k, 2) for k in range(3)
    ])  # fmt: skip
    exposure = torch.from_numpy(light_e).double() * laid(share(program), rows, cols)
    generator = torch.Generator().manual_seed(1)
    found = table.read_out(exposure.expand(3, -1, -1), share(program), model, generator).numpy()
    for row, col in np.ndindex(2, 2):
        mine, theirs = (each[:, row::2, col::2] for each in (found, wanted))
        ideal = float(exposure[row, col]) / sensor.electrons_per_lsb
        assert mine.mean() == pytest.approx(theirs.mean(), rel=0.01, abs=0.15)
        assert mine.mean() - ideal == pytest.approx(theirs.mean() - ideal, rel=0.1, abs=0.15)
        assert mine.var() == pytest.approx(theirs.var(), rel=0.1)
    # Photons and the readout alone vary much less.
    photons = level * sensor.full_well_e / sensor.electrons_per_lsb**2
    assert wanted[:, ::2, ::2].var() > 1.3 * (photons + sensor.adc_noise_lsb**2)


def test_crosstalk_is_the_emulators_and_light_has_a_slope(
    program: Container, table: EmulatedSensor
) -> None:
    generator = np.random.default_rng(1)
    light = generator.random((3, 7, 9))
    wanted = smeared(light, table.crosstalk)
    assert table.crosstalk > 0
    np.testing.assert_allclose(table.smeared(torch.from_numpy(light)).numpy(), wanted, atol=1e-12)
    sensor = default_sensor(program.target)
    model = SensorModel.of(sensor, program.target)
    exposure = torch.full((1, 4, 4), 9000.0, dtype=torch.float64, requires_grad=True)
    table.read_out(exposure, share(program), model, None).sum().backward()
    gain = exposure.grad * sensor.electrons_per_lsb
    assert ((gain > 0.8) & (gain < 1.05)).all()


def test_a_run_is_scored_and_doubted_on_a_chip_it_was_not_trained_for(tmp_path: Path) -> None:
    """As protocol and `nscc run` expose it: the chip costs decibels, and the run is told so."""
    clip(tmp_path / "c.mat", 16, 256)
    run = shipped_runs()["clip"]
    plain, _ = evaluate(str(run), tmp_path, "video-v1", 0)
    chip, _ = evaluate(str(run), tmp_path, "video-v1", 0, effects="all")
    assert chip["settings"]["effects"] == "all"
    assert chip["mean"] < plain["mean"] - 0.1
    assert "on a chip with effects all; trained with noise" in result_text(chip)
    line = ["run", str(run / "shutter.nsl"), "--scene", "builtin:motion", "--effects", "all"]
    assert invoke([*line, "-o", "f.npz"], tmp_path).status == 0
    made = invoke(["reconstruct", "clip", "f.npz", "-o", "o.npz"], tmp_path)
    assert made.status == 0, made.err
    assert "warning[NS0842]" in made.err
    assert "analog" in made.err
    baseline = ["evaluate", "gap-tv", "--data", ".", "--protocol", "video-v1", "--effects", "all"]
    assert "NS0841" in invoke(baseline, tmp_path).err
