"""Many frames of one scene: gathered as they come, in memory or mapped to a file."""

from __future__ import annotations

import errno
import tracemalloc
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from plan_cases import case

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime import capture, frame_file, frame_series
from nscc_runtime.formats.content import frame_content
from nscc_runtime.frame_file import Frame, FrameFile, joined


def _frames(count: int) -> Iterator[Frame]:
    for number in range(count):
        values = np.full((2, 3, 4), number, np.float64)
        yield Frame(
            values.astype(np.uint8),
            values + 0.5,
            values > 1,
            (values % 3).astype(np.uint8),
            told={"open_slots": values.astype(np.int64)},
        )


@pytest.mark.parametrize("most", [0, 1 << 28])
def test_a_film_gathered_frame_by_frame_equals_its_frames_stacked(
    most: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In mapped files (a limit of 0 bytes) and in memory, the film has the values and dtypes of
    stacked frames."""
    monkeypatch.setattr(frame_series, "MOST_BYTES", most)
    found, wanted = frame_series.gathered(_frames(5), 5), joined(list(_frames(5)), np.stack)
    for name in ("frame", "exposure_e", "valid", "saturated_by"):
        values = getattr(found, name)
        assert type(values) is np.ndarray
        assert values.dtype == getattr(wanted, name).dtype
        np.testing.assert_array_equal(values, getattr(wanted, name))
        # Memory that is mapped belongs to a file, and not to the array.
        assert values.flags.owndata == (most > 0)
    np.testing.assert_array_equal(found.told["open_slots"], wanted.told["open_slots"])


def test_gathered_frames_are_copied_before_the_next_is_computed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The source writes each frame into the same array. The film holds 0, 1 and 2 all the same."""
    monkeypatch.setattr(frame_series, "MOST_BYTES", 0)
    room = np.zeros((1, 2, 2))

    def reused() -> Iterator[Frame]:
        for number in range(3):
            room[:] = number
            yield Frame(room.astype(np.uint8), room, room > 0, room.astype(np.uint8))

    assert frame_series.gathered(reused(), 3).exposure_e[:, 0, 0, 0].tolist() == [0.0, 1.0, 2.0]


def test_a_full_disk_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    """No space for the mapped file gives NS0784, with the help to set TMPDIR."""

    def full(*_: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(frame_series, "MOST_BYTES", 0)
    monkeypatch.setattr(frame_series.os, "posix_fallocate", full, raising=False)
    with pytest.raises(Rejected, match="No space left on device") as caught:
        frame_series.gathered(_frames(5), 5)
    assert caught.value.diagnostics[0].code == "NS0784"
    assert "TMPDIR" in caught.value.diagnostics[0].helps[0]


@pytest.mark.parametrize("ending", [".npz", ".npy"])
def test_saving_a_film_takes_less_memory_than_half_the_film(
    ending: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(frame_file, "_BLOCK_BYTES", 0)
    program = case("two buckets", 8, rows=12, cols=16)
    film = capture(program, np.ones((8, 12, 16), np.float32), repeat=2000)
    film.save(tmp_path / f"first{ending}")
    tracemalloc.start()
    film.save(tmp_path / f"second{ending}")
    repr(film)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < film.exposure_e.nbytes / 2
    np.testing.assert_array_equal(_frame_of(tmp_path / f"second{ending}"), film.frame)


def test_frames_of_a_film_are_shown_one_by_one(tmp_path: Path) -> None:
    """Buckets are shown side by side, and values that are not numbers are dark."""
    frame = joined(list(_frames(3)), np.stack)
    frame.exposure_e[1, 0, 2, 3] = np.nan
    program = case("two buckets", 8, rows=3, cols=4)
    file = FrameFile(frame, {}, {}, {})
    content = frame_content(file, program, None, lambda: program.table.shutters)
    pictures = [*content.pictures]
    wanted = np.concatenate([np.nan_to_num(frame.exposure_e[:, b]) for b in range(2)], axis=2)
    np.testing.assert_array_equal(pictures, wanted)
    np.testing.assert_array_equal(
        [*content.shown], np.concatenate([frame.frame[:, b] for b in range(2)], axis=2)
    )
    assert next(content.shown).dtype == np.uint8


def _frame_of(path: Path) -> NDArray[np.uint8]:
    found = np.load(path)
    return np.asarray(found["frame"] if path.suffix == ".npz" else found)
