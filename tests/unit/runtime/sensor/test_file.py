"""The sensor file: defaults, files of a user's own, changes, and what is wrong with them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from nscc.chips.load import builtin_names, builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.effects.effect import HEADINGS
from nscc_runtime.sensor import (
    default_sensor,
    load_sensor,
    parameters,
    sensor_sha256,
    sensor_toml,
)

TARGET = builtin_target("scamp5")


def codes(path: Path | None = None, *changes: str) -> list[str]:
    with pytest.raises(Rejected) as caught:
        load_sensor(TARGET, path, changes)
    assert caught.value.status == 2
    return [diagnostic.code for diagnostic in caught.value.diagnostics]


def test_the_table_covers_every_attribute_once_and_says_where_defaults_come_from() -> None:
    """The table has the parameters of a sensor in their order, each with source, unit, meaning and
    heading."""
    assert [row.name for row in parameters()] == list(default_sensor(TARGET).values)
    assert all(row.source and row.kind.unit and row.meaning for row in parameters())
    assert {row.heading for row in parameters()} == set(HEADINGS)


def test_defaults_are_the_targets_and_within_their_ranges() -> None:
    sensor = default_sensor(TARGET)
    assert (sensor.full_well_e, round(sensor.register_max_e * 0.9)) == (30000, 30000)
    assert sensor.register_min_e == -sensor.register_max_e
    assert sensor.electrons_per_lsb == 30000 / 255
    assert sensor.adc_noise_lsb == 0.65
    # Words have electrons of their own, whatever the readout.
    full = default_sensor(replace(TARGET, readout="full"))
    assert sensor.analog_lsb_e == full.analog_lsb_e == full.electrons_per_lsb == 60000 / 255
    for name in builtin_names():
        found = default_sensor(builtin_target(name))
        for row in parameters():
            assert row.kind.low <= getattr(found, row.name) <= row.kind.high
    wide = replace(TARGET, full_well_e=1000.0, adc_bits=4, adc_offset_lsb=2.0)
    assert default_sensor(wide).electrons_per_lsb == 1000 / 15
    # IN takes four steps away in place of a full well.
    off_e = 1000 - 4 * 30000 / 127
    assert default_sensor(wide).adc_offset_lsb == pytest.approx(2.0 + off_e / (2000 / 15))


def test_a_printed_file_reads_back_to_the_bit(tmp_path: Path) -> None:
    """The file has all values, so it reads back equal for a chip of another full well. Changes
    change the digest."""
    file = tmp_path / "sensor.toml"
    sensor = load_sensor(TARGET, None, ["read_noise_e=0.1", "full_well_e = 1234.5678e1"])
    assert sensor.full_well_e == 12345.678
    file.write_text(sensor_toml(sensor))
    again = load_sensor(replace(TARGET, full_well_e=7.0), file)
    assert again == sensor
    assert sensor_sha256(again) == sensor_sha256(sensor)
    assert sensor_sha256(sensor) != sensor_sha256(default_sensor(TARGET))


def test_missing_lines_have_their_default_and_changes_come_last(tmp_path: Path) -> None:
    """The full well of 2550 gives 10 electrons a code. The last of two changes holds, and -0.0 is
    read as 0.0."""
    file = tmp_path / "sensor.toml"
    file.write_text("full_well_e = 2550\nprnu_fraction = -0.0\n")
    sensor = load_sensor(TARGET, file, ["lag_fraction=0", "lag_fraction=0.5"])
    assert sensor == default_sensor(TARGET).changed(
        full_well_e=2550.0,
        electrons_per_lsb=10.0,
        analog_lsb_e=20.0,
        prnu_fraction=0.0,
        lag_fraction=0.5,
    )
    assert str(sensor.prnu_fraction) == "0.0"


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("read_noise_e = 5 e", ["NS0752"]),
        ("\xff", ["NS0752"]),
        ("prnu = 1\nread_noise_e = -1\nlag_fraction = 2", ["NS0753", "NS0754", "NS0754"]),
        ("[noise]\nread_noise_e = 1", ["NS0753"]),
        ("read_noise_e = nan\nreset_noise_e = inf\nprnu_fraction = true", ["NS0754"] * 3),
        ('dark_current_e_per_s = "1"\nfull_well_e = 0', ["NS0754"] * 2),
        ("register_min_e = 0\nleakage_tau_s = 0\nfull_well_e = [1]", ["NS0754"] * 3),
    ],
)
def test_all_errors_of_a_sensor_file_are_reported_together(
    text: str, found: list[str], tmp_path: Path
) -> None:
    """No TOML gives NS0752, an unknown key NS0753, and a value out of range, NaN or of another type
    NS0754."""
    file = tmp_path / "sensor.toml"
    file.write_bytes(text.encode("latin-1"))
    assert codes(file) == found


def test_unreadable_sensor_files_and_bad_changes_are_refused(tmp_path: Path) -> None:
    """A missing file and a folder give NS0751, a change without name or value NS0755. Wrong names
    and values are NS0753 and NS0754."""
    assert codes(tmp_path / "none.toml") == ["NS0751"]
    assert codes(tmp_path) == ["NS0751"]
    assert codes(None, "read_noise_e", "=3", "read_noise_e=") == ["NS0755"] * 3
    assert codes(None, "read_nose_e=1", "read_noise_e=5 e") == ["NS0753", "NS0754"]


def test_a_misspelt_name_is_suggested() -> None:
    """`dark_curent_e_per_s` gets the help that proposes `dark_current_e_per_s`."""
    with pytest.raises(Rejected) as caught:
        load_sensor(TARGET, None, ["dark_curent_e_per_s=1"])
    assert "did you mean `dark_current_e_per_s`?" in caught.value.diagnostics[0].helps
