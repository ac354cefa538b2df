"""Gain, bias and variance of every example's exposures, beside frames of the reference.

The light is flat and nothing differs from pixel to pixel, so pixels with one shutter are as many
frames of it.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from looks_programs import looking_frames
from marks import slow
from reference_programs import sensor_of

from nscc.compiler import compile_source
from nscc.pipeline import Options
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.looked_light import looked_response, row_of
from nscc_runtime.reference import frames
from nscc_runtime.response import ShutterResponse, shutter_response

EXAMPLES = [
    path
    for path in sorted((ROOT / "examples").glob("*.nsl"))
    # Images are made of exposures before readout.
    if not {"nsl 3", "nsl 4"} & {*path.read_text().splitlines()}
]
ROWS, COLS = 16, 24
EFFECTS = "shot,dark,read,reset,analog,leakage,dead_time,black_sun"
ALIKE = {"dark_spread_fraction": 0.0, "leakage_spread_fraction": 0.0, "analog_pattern_lsb": 0.0}
SHARES = {"first_light": 6.0}
"""Light over the frame as a part of a full well, where a look would hang on noise at 0.25."""
LARGE = {"dark_current_e_per_s": 2e4, "leakage_tau_s": 4.0, "analog_gain": 0.99}


def example(path: Path) -> Container:
    """The example on a small array of its chip."""
    source = Source(path.name, path.read_text())
    whole = compile_source(source, path.parent, Options(level=0, cache=False)).container
    small = replace(whole.target, rows=ROWS, cols=COLS)
    return compile_source(
        source, path.parent, Options(level=0, target=small, cache=False)
    ).container


@pytest.mark.parametrize("count", [6, slow(120)], ids=lambda count: f"{count} frames")
@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_the_response_of_every_example_predicts_mean_and_variance_of_its_frames(
    path: Path, count: int
) -> None:
    program, effects = example(path), selected(EFFECTS)
    sensor = sensor_of(program, **ALIKE, **LARGE)
    slot_s = np.array(program.slot_us) * 1e-6
    rate = SHARES.get(path.stem, 0.25) * sensor.full_well_e / slot_s.sum()
    light = Light.of_still(np.full((ROWS, COLS), rate, np.float32), slot_s)
    expose = looking_frames if program.machine.stages else frames
    taken = [*expose(program, light, sensor, effects, seed=1, device_seed=2, count=count)]
    behaviour = program.table.shutter_of_code[program.pixel_codes]
    response: ShutterResponse
    if not program.machine.stages:
        response = shutter_response(program, sensor, effects)
        rows = np.broadcast_to(behaviour, (count, ROWS, COLS))
    else:
        ends, response = looked_response(program, sensor, effects)
        read = [f"states_{state.name}" for state in program.machine.states if state.read]
        told = ([behaviour, *(frame.told[name] for name in read)] for frame in taken)
        rows = np.stack([row_of(ends, each)[0] for each in told])
    # Of pixels whose looks hang on noise, those that ended so are no fair draw.
    steady = (rows == rows[0]).all(axis=0)
    assert steady.mean() > 0.5
    exposure_e = np.stack([frame.exposure_e for frame in taken])[..., steady]
    row = rows[0][steady]
    mean_e = (response.bias_e + rate * response.seen_s)[row].T
    variance_e2 = (response.variance_e2 + rate * response.seen_s)[row].T
    # A shutter that stays shut may have no noise at all.
    silent = variance_e2 == 0.0
    differences_e = exposure_e - mean_e
    assert not differences_e[:, silent].any()
    off = differences_e / np.sqrt(np.where(silent, 1.0, variance_e2))
    for bucket in range(off.shape[1]):
        noisy = ~silent[bucket]
        here = off[:, bucket, noisy]
        assert abs(here.mean()) < 5.0 / np.sqrt(here.size)
        assert np.mean(here**2) == pytest.approx(1.0, abs=6.0 * np.sqrt(2.0 / here.size) + 0.02)
        for shutter in np.unique(row[noisy]):
            some = here[:, row[noisy] == shutter]
            assert abs(some.mean()) < 5.5 / np.sqrt(some.size)
