"""What a run may begin with: programs whose shutters are its own, and settings that go together."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

torch = pytest.importorskip("torch")

from nscc.chips.load import load_target  # noqa: E402
from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_training.encoders import Encoder  # noqa: E402
from nscc_training.loop.setup import make_setup, started_encoder  # noqa: E402
from nscc_training.programs import Chip  # noqa: E402
from nscc_training.settings import settings_of  # noqa: E402

TILE = [[8, 2], [3, 1]]
HEAD = "nsl 1\nframe 8 slots of 125us\n"
STOPS = f"{HEAD}code stop : 1..N\nopen when n < stop\npixels stop = tile {TILE}\n"
BUMP = f"{HEAD}code start : 0..N - 2\nopen when start <= n < start + 2\npixels start = tile "
BITS = "code bits : bit[N]\n"
FIELDS = (
    f"{HEAD}code start : 0..N - 1\ncode stop : 1..N\nrequire start < stop\n"
    f"open when start <= n < stop\npixels start = 0\npixels stop = tile {TILE}\n"
)
BOOK = (
    f"{HEAD}shutters book [1100_0000, 0011_0000, 0000_1111]\ncode id : row of book\n"
    "open when book[id]\npixels id = tile [[0, 2], [2, 0]]\n"
)
LOOKS = (
    "nsl 2\nframe 8 slots of 125us\nsense bright when light > 40% at n in [4]\n"
    "state seen : 0..1 = 0\nnext seen = 1 when bright\nopen when seen == 0\nread seen\n"
)


def begun(folder: Path, text: str, **shutter: Any) -> Encoder:
    (folder / "p.nsl").write_text(text)
    chosen = {"slots": 8, "tile": [2, 2], "init": str(folder / "p.nsl"), **shutter}
    settings = settings_of({"shutter": chosen})
    chip = Chip()
    return started_encoder(settings.shutter, chip, load_target(chip.target, Path()), 0)


def opened(first: Any, last: Any) -> np.ndarray:
    """From `first` up to `last`, by place of the tile: (N, rows, cols)."""
    n = np.arange(8).reshape(-1, 1, 1)
    return (np.asarray(first) <= n) & (n < np.asarray(last))


def test_shutters_of_a_program_are_begun_with(tmp_path: Path) -> None:
    once = np.tile(opened(0, TILE), (1, 2, 1))
    book = np.array([[c == "1" for c in row] for row in ("11000000", "00110000", "00001111")])
    chosen = [[0, 2], [2, 0]]
    rest = "bucket one open when bits[n]\nbucket two open when not bits[n]\n"
    two = f"{HEAD}{BITS}{rest}pixels bits = tile [[3, 129]]\n"
    bits = opened(0, [[2, 1]]) | opened([[8, 7]], 8)
    wide = BUMP + "[[6, 0], [3, 5]]\n"
    always = f"{HEAD}open when true\n"
    cases: list[tuple[str, dict[str, Any], np.ndarray]] = [
        (STOPS, {"class": "b"}, opened(0, TILE)),
        (STOPS, {"class": "b", "tile": [4, 2]}, once),
        (wide, {"class": "c", "length": 2}, opened([[6, 0], [3, 5]], [[8, 2], [5, 7]])),
        (FIELDS, {"class": "d"}, opened(0, TILE)),
        (two, {"class": "e", "tile": [1, 2], "buckets": 2}, bits),
        (BOOK, {"class": "codebook", "rows": 3}, book[chosen].transpose(2, 0, 1)),
        (always, {"class": "a"}, np.ones((8, 1, 1), bool)),
    ]
    for text, shutter, wanted in cases:
        found = begun(tmp_path, text, **shutter).hard().numpy()
        np.testing.assert_array_equal(found, wanted, err_msg=text)


@pytest.mark.parametrize(
    ("text", "shutter", "said"),
    [
        (STOPS, {"class": "b", "tile": [3, 3]}, "not a repeated tile of 3 x 3"),
        (STOPS, {"class": "b", "tile": [1, 1]}, "not a repeated tile of 1 x 1"),
        (FIELDS, {"class": "b"}, "has the fields: start, stop; class b has: stop"),
        (BUMP + "[[4]]", {"class": "c", "length": 4}, "other shutters"),
        (STOPS.replace("n <", "n <="), {"class": "b"}, "other shutters"),
        (f"{HEAD}open when n < 3\n", {"class": "a"}, "other shutters"),
        (BOOK, {"class": "codebook", "rows": 4}, "'book' must be"),
        (
            f"{HEAD}{BITS}bucket one open when bits[n]\nbucket two open when not bits[n]\n"
            "pixels bits = 3\n",
            {"class": "e"},
            "2 buckets, but the run has one",
        ),
        (
            f"{HEAD}{BITS}bucket one open when bits[n]\nbucket two open when n < 2\n"
            "pixels bits = 240\n",
            {"class": "e", "buckets": 2},
            "other shutters",
        ),
        (LOOKS, {"class": "a"}, "look at the light"),
    ],
)
def test_other_shutters_than_a_programs_are_refused(
    text: str, shutter: dict[str, Any], said: str, tmp_path: Path
) -> None:
    """Cropped, of other fields, or opened by another rule: they would not be the program's."""
    with pytest.raises(Rejected, match=said) as caught:
        begun(tmp_path, text, **{"length": 2, **shutter})
    assert [each.code for each in caught.value.diagnostics] == ["NS0815"]


@pytest.mark.parametrize(("warm_up", "settle"), [(0.7, 0.7), (0.25, 0.75), (1.0, 0.0)])
def test_codes_that_learn_have_steps_to_learn_in(warm_up: float, settle: float) -> None:
    """If `warm_up` and `settle` leave no step, NS0815 says so. Codes that do not learn may have
    such shares."""
    shutter = {"slots": 8, "tile": [2, 2], "warm_up": warm_up, "settle": settle}
    with pytest.raises(Rejected, match="codes cannot learn") as caught:
        make_setup(settings_of({"shutter": shutter}))
    assert [each.code for each in caught.value.diagnostics] == ["NS0815"]
    make_setup(settings_of({"shutter": {**shutter, "learn": False}}))
    make_setup(settings_of({"shutter": {**shutter, "warm_up": 0.2, "settle": 0.7}}))
