"""The requests of the playground page: answers are those of the Python interface and of `check`."""

from __future__ import annotations

import json
import re
from base64 import b64decode, b64encode
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from checkout import ROOT

import nscc
import nscc_runtime
from nscc.editing.document import Document
from nscc.examples import examples, tasks
from nscc_cli.playground import PAGE
from nscc_cli.playground.requests import Playground

TILE = """nsl 1
frame 16 slots of 1ms
code stop : 1..16
open when n < stop
pixels stop = tile [[16, 4]]
"""
EDGES = examples()["edges"].read_text()
WHITE = b64encode(np.ones((256, 256), np.float32).tobytes()).decode()
SETTINGS = {
    "program": TILE,
    "scene": "builtin:hdr",
    "picture": "",
    "exposure_e": 200_000.0,
    "effects": "none",
    "seed": 3,
    "row": 40,
    "col": 7,
}


@pytest.fixture
def playground(tmp_path: Path) -> Playground:
    return Playground(tmp_path)


def ask(playground: Playground, kind: str, **changes: Any) -> Any:
    return playground.answer(kind, SETTINGS | changes)


def codes(answer: Any) -> list[str]:
    return [message["code"] for message in answer["messages"]]


def grey(picture: Any) -> Any:
    levels = np.frombuffer(b64decode(picture["grey"]), np.uint8)
    return levels.reshape(picture["shape"])


def taken(**options: Any) -> nscc_runtime.Capture:
    scene = nscc_runtime.scene("builtin:hdr", exposure=200_000.0)
    return nscc_runtime.capture(nscc.compile(TILE, level=1), scene, seed=3, **options)


def test_every_example_has_a_task_and_a_scene(playground: Playground) -> None:
    """The answer to `start` lists each example program once. `kernel` is a word of version 3 and
    not of version 1."""
    start = playground.answer("start", {})
    programs = {name for name, path in examples().items() if path.suffix == ".nsl"}
    assert {example["name"] for example in start["examples"]} == programs
    assert sorted(name for named in tasks().values() for name in named) == sorted(programs)
    assert start["file"] is None
    assert "kernel" in start["words"][3][0]
    assert "kernel" not in start["words"][1][1]


def test_a_message_has_its_place_and_a_fix_that_compiles(playground: Playground) -> None:
    wrong = TILE.replace("n < stop", "n < stp")
    answer = ask(playground, "check", program=wrong)
    (message,) = answer["messages"]
    assert message["location"] == {"row": 4, "column": 15}
    (fix,) = message["fixes"]
    lines = wrong.splitlines(keepends=True)
    place, end = fix["location"], fix["end_location"]
    line = lines[place["row"] - 1]
    lines[place["row"] - 1] = (
        line[: place["column"] - 1] + fix["replacement"] + line[end["column"] - 1 :]
    )
    assert "".join(lines) == TILE
    assert "rows" not in answer


def test_a_valid_program_has_a_report_a_chart_and_a_map(playground: Playground) -> None:
    """The answer has no message. The map shows that pixels of even and odd columns have different
    shutters."""
    answer = ask(playground, "check")
    assert answer["messages"] == []
    assert dict(answer["rows"])["proved"] == "2 codes x 16 slots, 2 frames"
    assert answer["array"] == [256, 256]
    assert answer["chart"].startswith("<svg")
    ranks = np.frombuffer(b64decode(answer["map"]), "<u2").reshape(256, 256)
    assert (ranks[:, 0::2] != ranks[:, 1::2]).all()


@pytest.mark.parametrize("effects", ["none", "auto", "all"])
def test_the_playground_shows_the_frame_of_capture(playground: Playground, effects: str) -> None:
    """The codes are those of `capture`. The merged picture is like the light: a median error below
    12 of 255 grey levels."""
    answer = ask(playground, "frame", effects=effects)
    light, frame, merged = answer["pictures"]
    assert np.array_equal(grey(frame), taken(effects=effects).frame[0])
    assert grey(light).min() < 50 < 200 < grey(light).max()
    assert bool(answer["plan"]) == (effects != "none")
    assert merged["title"] == "merged: frame"
    # Like the light, with the same tone curve.
    error = np.abs(grey(merged).astype(int) - grey(light))
    assert np.median(error) < 12


def test_images_and_planes_are_shown_and_not_merged(playground: Playground) -> None:
    """A program that reads a plane shows the light and the plane, which is black and white."""
    answer = ask(playground, "frame", program=EDGES)
    assert [picture["title"] for picture in answer["pictures"]] == ["the light", "plane edge"]
    assert set(np.unique(grey(answer["pictures"][1]))) == {0, 255}


@pytest.mark.parametrize("effects", ["none", "all"])
def test_the_words_of_a_pixel_end_with_the_exposure_of_the_reference(
    playground: Playground, effects: str
) -> None:
    for row, col in ((40, 7), (200, 100)):
        answer = ask(playground, "words", effects=effects, row=row, col=col)
        whole = taken(effects=effects, fidelity="reference").exposure_e[0, row, col]
        assert answer["exposure_e"]["frame"] == pytest.approx(whole, rel=1e-12)
        assert len(answer["steps"]) == answer["words"]
        assert answer["registers"][0] == "PIX"
        assert answer["registers"][-1] == "FLAG"
        assert {len(step["values"]) for step in answer["steps"]} == {len(answer["registers"])}
        times = [step["us"] for step in answer["steps"]]
        assert times == sorted(times)


def test_a_pixel_outside_of_the_array_is_refused(playground: Playground) -> None:
    """Row 256 and column -1 of an array of 256 x 256 give NS0796."""
    for place in ({"row": 256}, {"col": -1}):
        assert codes(ask(playground, "words", **place)) == ["NS0796"]


def test_white_of_an_opened_picture_has_the_given_exposure(playground: Playground) -> None:
    levels = np.zeros((256, 256), np.float32)
    levels[:, 100:] = 1
    picture = b64encode(levels.tobytes()).decode()
    answer = ask(playground, "frame", picture=picture, exposure_e=16_000.0)
    light, frame, _ = map(grey, answer["pictures"])
    assert light[0, 0] == 0
    assert light[0, 200] == 255
    # 16000 e over 16 slots: open columns see all of it, the others a quarter.
    steps = nscc.compile(TILE).target.electrons_per_lsb
    offset = int(frame[0, 0])
    assert frame[0, 200] - offset == round(16_000 / steps)
    assert frame[0, 201] - offset == round(4_000 / steps)
    dark = b64encode(bytes(4 << 16)).decode()
    assert np.ptp(grey(ask(playground, "frame", picture=dark)["pictures"][1])) == 0


@pytest.mark.parametrize(
    "changes",
    [
        {"picture": "AAAA"},
        {"picture": "?"},
        {"scene": "/etc/hostname"},
        {"effects": "some"},
        {"seed": 0.5},
        {"program": 3},
    ],
    ids=str,
)
def test_wrong_requests_are_refused(playground: Playground, changes: dict[str, Any]) -> None:
    assert codes(ask(playground, "frame", **changes)) == ["NS0796"]


@pytest.mark.parametrize(
    "changes",
    [{"exposure_e": -1.0}, {"exposure_e": float("nan")}, {"exposure_e": 1e300}, {"seed": -1}],
    ids=str,
)
@pytest.mark.parametrize("picture", ["", WHITE], ids=["scene", "picture"])
def test_impossible_numbers_are_refused(
    playground: Playground, changes: dict[str, Any], picture: str
) -> None:
    """A negative, NaN or huge exposure and a negative seed each give an error, for a scene and for
    an own picture."""
    assert codes(ask(playground, "frame", picture=picture, **changes))


def test_missing_values_and_unknown_kinds_are_refused(playground: Playground) -> None:
    assert codes(playground.answer("frame", {})) == ["NS0796"]
    assert codes(playground.answer("open", SETTINGS)) == ["NS0796"]


def test_files_outside_of_the_folder_are_not_read(tmp_path: Path) -> None:
    folder = tmp_path / "inside"
    folder.mkdir()
    codes_file = tmp_path / "codes.npz"
    np.savez(codes_file, stop=np.full((256, 256), 4))
    (folder / "link.npz").symlink_to(codes_file)
    np.savez(folder / "own.npz", stop=np.full((256, 256), 4))
    program = TILE.replace("stop = tile [[16, 4]]", 'from "{}"')
    for name in ("../codes.npz", codes_file.as_posix(), "link.npz"):
        answer = ask(Playground(folder), "check", program=program.format(name))
        assert codes(answer) == ["NS0796"]
        assert answer["messages"][0]["location"]["row"] == 5
    assert codes(ask(Playground(folder), "check", program=program.format("own.npz"))) == []


def test_a_file_is_saved_unless_another_program_changed_it(tmp_path: Path) -> None:
    file = tmp_path / "mine.nsl"
    file.write_text(TILE)
    playground = Playground(tmp_path, file)
    assert playground.answer("start", {})["file"] == {"name": "mine.nsl", "text": TILE}
    better = TILE.replace("16, 4", "16, 8")
    assert playground.answer("save", {"text": better, "before": TILE}) == {"saved": "mine.nsl"}
    assert file.read_text() == better
    assert codes(playground.answer("save", {"text": "", "before": TILE})) == ["NS0796"]
    assert file.read_text() == better
    assert codes(Playground(tmp_path).answer("save", {"text": "", "before": ""})) == ["NS0796"]


def test_the_playground_gives_the_messages_of_check(playground: Playground, tmp_path: Path) -> None:
    broken = TILE.replace("16]]", "99]]").replace("1ms", "1us")
    listed = Document("program.nsl", broken, tmp_path).checked.diagnostics
    assert codes(ask(playground, "check", program=broken)) == [d.code for d in listed]
    assert codes(ask(playground, "frame", program=broken)) == [d.code for d in listed]


def test_the_editor_component_has_the_locked_versions_and_their_licences() -> None:
    """`make editor` bundles it: a changed lock file without a new bundle is noticed here."""
    head = (PAGE / "codemirror.js").read_text().partition("\n")[0]
    licences = (PAGE / "codemirror.LICENSE.txt").read_text()
    bundled = dict(re.findall(r"([@\w/-]+) ([\d.]+) \(MIT\)", head))
    lock = json.loads((ROOT / "editors/playground/package-lock.json").read_text())
    locked = {
        path.removeprefix("node_modules/"): package.get("version")
        for path, package in lock["packages"].items()
    }
    assert "@codemirror/view" in bundled
    assert bundled.items() <= locked.items()
    for name, version in bundled.items():
        assert f"{name} {version} (MIT)" in licences
    assert licences.count("Permission is hereby granted") == len(bundled)
