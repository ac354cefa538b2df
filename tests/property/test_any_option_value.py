"""Whatever number an option or a parameter of the sensor is given, nscc does its work or says what
is wrong with it; it never fails, and never writes a frame beside an error."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from nscc_command import invoke

from nscc.chips.load import builtin_target, target_toml
from nscc_runtime.effects.registry import parameters

pytestmark = pytest.mark.filterwarnings("error::RuntimeWarning")

PROGRAM = """nsl 1
target "small.toml"
frame 4 slots of 1ms
code stop : 1..4
open when n < stop
pixels stop = tile [[4, 3], [2, 1]]
"""
EXTREMES = [
    "0", "-0.0", "1", "-1", "1e-320", "5e-324", "1e-308", "1e-200", "1e-155", "1e-30", "1e-9",
    "1e9", "1e15", "1e30", "1e38", "1e39", "1e155", "1e200", "1e308", "1e999", "nan", "inf", "-inf",
    "-1e-320", "-1e15", "-1e308", "", "x", "0x10", "1_0", "99999999999999999999",
]  # fmt: skip
NUMBERS = st.one_of(st.sampled_from(EXTREMES), st.floats().map(repr), st.integers().map(str))
PARAMETERS = [row.name for row in parameters()]
RANGES = {row.name: row.kind for row in parameters()}
OPTIONS = {
    "--tolerance": "{}e", "--exposure": "{}", "--fps": "{}", "--crop": "{},0", "--seed": "{}",
    "--device-seed": "{}", "--repeat": "{}", "-O": "{}", "--max-words-per-slot": "{}",
    "--scene": "builtin:flat:{}", "--patience": "{}", "--baud": "{}",
}  # fmt: skip


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("values")
    small = replace(builtin_target("scamp5"), rows=4, cols=6, name="small")
    (made / "small.toml").write_text(target_toml(small))
    (made / "p.nsl").write_text(PROGRAM)
    return made


def judge(folder: Path, *more: str) -> None:
    frame = folder / "f.npz"
    frame.unlink(missing_ok=True)
    found = invoke(["run", "p.nsl", "--scene", "builtin:hdr", "-o", "f.npz", *more], folder)
    assert found.status in (0, 1, 2), found.err
    # 1 is a promise that could not be kept: then there is a frame, and the plan says so.
    assert frame.exists() == (found.status == 0) or found.codes[-1:] == ["NS0749"], found.err
    assert not list(folder.glob("*.zip"))


@settings(max_examples=120)
@given(name=st.sampled_from(PARAMETERS), value=NUMBERS, effects=st.sampled_from(["auto", "all"]))
@example(name="leakage_tau_s", value="1e-320", effects="auto")
@example(name="full_well_e", value="5e-324", effects="auto")
def test_any_value_of_the_sensor_runs_or_is_refused(
    name: str, value: str, effects: str, folder: Path
) -> None:
    judge(folder, "--effects", effects, "--sensor-set", f"{name}={value}")


@pytest.mark.parametrize("name", PARAMETERS)
def test_the_ends_of_the_range_of_every_sensor_value_run_or_are_refused(
    name: str, folder: Path
) -> None:
    """With the least and with the largest value, a run writes a frame or ends with an error
    message. It never leaves a fault report."""
    for value in (RANGES[name].low, RANGES[name].high):
        judge(folder, "--effects", "auto", "--sensor-set", f"{name}={value!r}")


@settings(max_examples=8)
@given(values=st.dictionaries(st.sampled_from(PARAMETERS), st.booleans(), min_size=2, max_size=3))
def test_extreme_sensor_values_together_run_or_are_refused(
    values: dict[str, bool], folder: Path
) -> None:
    ends = {name: RANGES[name].high if high else RANGES[name].low for name, high in values.items()}
    changes = [part for name, end in ends.items() for part in ("--sensor-set", f"{name}={end!r}")]
    judge(folder, "--effects", "auto", *changes)


@pytest.mark.slow
@settings(max_examples=120)
@given(option=st.sampled_from([*OPTIONS]), value=NUMBERS)
@example(option="--tolerance", value="1e200")
@example(option="--tolerance", value="1e-320")
def test_any_value_of_an_option_runs_or_is_refused(option: str, value: str, folder: Path) -> None:
    if option == "--repeat" and value.isdecimal() and int(value) > 100:
        value = "100"  # ten thousand frames are legal, and slow
    judge(folder, option, OPTIONS[option].format(value))
