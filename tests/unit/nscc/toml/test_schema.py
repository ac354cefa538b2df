"""The layer under every TOML file: what a schema reads, refuses, changes and writes."""

from __future__ import annotations

import pickle
import tomllib
from dataclasses import replace
from typing import Any

import pytest

from nscc.chips.load import builtin_target
from nscc.source import Source
from nscc.toml.kinds import Flag, Integer, Number, Several, TextKind
from nscc.toml.schema import FileCodes, Key, Schema, file_text
from nscc.toml.toml_text import parsed
from nscc_runtime.sensor import default_sensor, parameter, parameters
from nscc_runtime.sensor.file import schema

ROWS = (
    Key("", "title", TextKind(), "what it is called", default=""),
    Key("lens", "focus_mm", Number(1, 100, "mm"), "of the lens", default=8.0, required=True),
    Key("lens", "stops", Several(Integer(1, 9), 2), "first and last", default=(1, 2)),
    Key("shutter", "open", Flag(), "whether it is", default=False),
)
CODES = FileCodes("U", "T", unknown="NS1", wrong_value="NS2", missing="NS3", change="NS4")
CAMERA = Schema(
    "camera",
    ROWS,
    {"": "", "lens": "", "shutter": ""},
    CODES,
    "ask the maker",
    option="--set",
    example="lens.focus_mm=9",
)


def problems(text: str) -> list[tuple[str, int, str]]:
    source, values = parsed(text.encode())
    _, found = CAMERA.read(values, Source("c.toml", source))
    return [
        (each.code, each.source.row_column(each.label.span.start)[0], "".join(each.helps))
        for each in found
        if each.source and each.label
    ]


def test_everything_wrong_is_told_at_its_place() -> None:
    text = "opne = 1\nstops = 2\nlens = 3\n[shuter]\n[shutter]\nopen = 1\nclosed = 2\n"
    assert problems(text) == [
        ("NS1", 1, "did you mean `open` under [shutter]?"),
        ("NS1", 2, "`stops` belongs under [lens]"),
        ("NS2", 3, ""),
        ("NS1", 4, "did you mean `shutter`?"),
        ("NS2", 6, ""),
        ("NS1", 7, "the keys here are open"),
    ]
    assert problems('[lens]\nstops = [1]\n"a b" = 3') == [
        ("NS2", 2, ""),
        ("NS1", 3, "the keys here are focus_mm, stops"),
        ("NS3", 1, "ask the maker"),
    ]


def test_changes_are_values_or_are_refused() -> None:
    found, wrong = CAMERA.changed(
        ["title=", "title = a b", "lens.stops=[3,4]", "lens.focus_mm=9", "shutter.open=true"]
    )
    assert not wrong
    assert found == {
        "title": "a b",
        "lens.stops": (3, 4),
        "lens.focus_mm": 9.0,
        "shutter.open": True,
    }
    _, wrong = CAMERA.changed(["title", "lens.focus_mm=", "lens.focus_mm=0", "lense.a=1", "a.b=1"])
    assert [each.code for each in wrong] == ["NS4", "NS4", "NS2", "NS1", "NS1"]
    expected = "--set: lens.focus_mm must be a number from 1 to 100 (mm), not 0"
    assert wrong[2].message == expected


@pytest.mark.parametrize("title", ["", 'a "b" \\', "line\nend\t\x00\x7f", "caf\xe9 \U0001f600"])
def test_what_is_written_is_read_back(title: str) -> None:
    values: dict[str, Any] = {key.path: key.default for key in ROWS} | {"title": title}
    for beside in (False, True):
        text = file_text(CAMERA, values, lambda key: key.meaning, ("a camera",), beside=beside)
        assert tomllib.loads(text) == CAMERA.plain(values)
        assert CAMERA.read(tomllib.loads(text), complete=True) == (values, [])


def test_a_schema_refuses_duplicate_keys_and_unknown_headings() -> None:
    glow = parameter("glow_e", "light", 0.0, "e", 0, 10, "of the chip itself")
    assert "glow_e" in replace(schema(), keys=(*parameters(), glow)).by_path
    with pytest.raises(ValueError, match="glow_e"):
        replace(schema(), keys=(glow, *parameters(), glow))
    with pytest.raises(ValueError, match="no such"):
        replace(CAMERA, keys=(replace(ROWS[0], heading="no such"),))


def test_a_sensor_is_its_parameters_by_name() -> None:
    sensor = default_sensor(builtin_target("scamp5"))
    other = sensor.changed(read_noise_e=3.0)
    assert (other.read_noise_e, sensor.read_noise_e) == (3.0, 10.0)
    assert other.changed(read_noise_e=10.0) == sensor
    assert pickle.loads(pickle.dumps(other)) == other
    assert len({sensor, other, other.changed()}) == 2
    with pytest.raises(TypeError, match="read_nose_e"):
        sensor.changed(read_nose_e=3.0)
    with pytest.raises(AttributeError, match="read_nose_e"):
        _ = sensor.read_nose_e
