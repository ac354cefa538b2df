"""Strips of rows over threads: every row once, and no more in work than asked for."""

from __future__ import annotations

import platform
import subprocess
import sys
from threading import Lock
from time import sleep

import numpy as np
import pytest
from plan_cases import case, moving_light
from reference_programs import sensor_of

from nscc_runtime.effects import selected
from nscc_runtime.emulator import chip_program as emulator
from nscc_runtime.emulator import expose
from nscc_runtime.pool import in_parts, in_strips
from nscc_runtime.reference.capture import Reference, reference_scene

ROWS, COLS = 12, 16


@pytest.mark.parametrize("most", [1, 3, 7, 100])
@pytest.mark.parametrize("threads", [1, 2, 5])
@pytest.mark.parametrize("rows", [range(1), range(4, 11), range(64)])
def test_every_row_is_done_once(rows: range, threads: int, most: int) -> None:
    """For any rows, threads and limit of waiting rows, each row is in one strip. A strip has at
    most `most // threads` rows, and one at least."""
    done: list[range] = []
    lock = Lock()

    def run(strip: range) -> None:
        with lock:
            done.append(strip)

    in_strips(run, rows, most, threads)
    assert sorted(row for strip in done for row in strip) == list(rows)
    assert max(map(len, done)) <= max(1, most // threads)


@pytest.mark.parametrize("failing", [0, 1, 2])
def test_an_error_is_raised_after_all_parts_have_ended(failing: int) -> None:
    """One of three parts fails at once. The others end first, and then the error reaches the
    caller."""
    ended: list[int] = []

    def run(begin: int, _: int) -> None:
        if begin == failing:
            raise OSError(f"part {begin}")
        sleep(0.05)
        ended.append(begin)

    with pytest.raises(OSError, match=f"part {failing}"):
        in_parts(run, 3, 3)
    assert sorted([*ended, failing]) == [0, 1, 2]


def test_threads_change_no_bit_of_the_reference() -> None:
    program = case("c edges", 8, rows=ROWS, cols=COLS)
    reference = Reference.of(program, sensor_of(program), selected("all"))
    scene = reference_scene(program, moving_light((8, ROWS, COLS), 40_000.0))
    once = reference.expose(scene, 3, 4, 1, threads=1)
    for threads in (2, 5, 64):
        again = reference.expose(scene, 3, 4, 1, threads=threads)
        assert again.exposure_e.tobytes() == once.exposure_e.tobytes()
        assert again.valid.tobytes() == once.valid.tobytes()
        np.testing.assert_array_equal(again.saturated_by, once.saturated_by)


def test_threads_change_no_bit_of_the_emulator(monkeypatch: pytest.MonkeyPatch) -> None:
    """Blocks are 64 pixels, so that three threads have several each. The electrons have the bytes
    of one thread."""
    monkeypatch.setattr(emulator, "EMULATED_BLOCK", 64)
    program = case("c edges", 8, rows=ROWS, cols=COLS)
    light = moving_light((8, ROWS, COLS), 400.0)
    once = expose(program, light, device_seed=3, threads=1)
    again = expose(program, light, device_seed=3, threads=3)
    assert again.exposure_e.tobytes() == once.exposure_e.tobytes()


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="only glibc can be told to keep it")
def test_memory_of_a_frame_is_kept_for_the_next() -> None:
    """A new process touches fewer than a tenth of the pages again when the same arrays are made
    anew."""
    script = """
import resource
import numpy as np
from nscc_runtime.pool import keep_memory

def pages():
    before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    arrays = [np.ones(50_000) for _ in range(20)]
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before

keep_memory()
print(pages(), pages())
"""
    told = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    ).stdout
    first, second = map(int, told.split())
    assert first > 1000
    assert second < first / 10
