"""Captures after fork, in spawned processes and in threads: all give the same frame."""

from __future__ import annotations

import multiprocessing
import os
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest
from plan_cases import case, moving_light
from reference_programs import sensor_of

from nscc.words.container import Container
from nscc_runtime import capture
from nscc_runtime.caches import OfContainer
from nscc_runtime.effects import selected
from nscc_runtime.pool import in_parts
from nscc_runtime.reference.capture import Reference, reference_scene

ROWS, COLS = 12, 16
SECONDS = 100
"""How long a process may take before the test says that it hangs."""


def _program() -> Container:
    return case("c edges", 8, rows=ROWS, cols=COLS)


def _reference_frame() -> bytes:
    """The frame of the reference emulator on two threads."""
    program = _program()
    reference = Reference.of(program, sensor_of(program), selected("all"))
    scene = reference_scene(program, moving_light((8, ROWS, COLS), 40_000.0))
    exposure = reference.expose(scene, 3, 4, 1, threads=2)
    return exposure.exposure_e.tobytes()


@pytest.fixture
def frame() -> bytes:
    """The frame of this process, whose thread pool runs from then on."""
    return _reference_frame()


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_processes_expose_as_their_parent_does(frame: bytes, method: str) -> None:
    """The parent has exposed before it starts two processes. Both return its frame, by fork and by
    spawn."""
    context = multiprocessing.get_context(method)
    pool = ProcessPoolExecutor(2, mp_context=context)
    try:
        frames = [pool.submit(_reference_frame) for _ in range(2)]
        assert [each.result(SECONDS) for each in frames] == [frame, frame]
    finally:
        for process in pool._processes.values():
            process.kill()  # a process that hangs must not stop the other tests
        pool.shutdown()


def test_threads_expose_side_by_side(frame: bytes) -> None:
    """Four threads that expose at once each return the frame of a single one."""
    with ThreadPoolExecutor(4) as pool:
        frames = [pool.submit(_reference_frame) for _ in range(4)]
        assert [each.result(SECONDS) for each in frames] == [frame] * 4


class _Captures:
    """A data set whose items are captured frames."""

    def __len__(self) -> int:
        return 4

    def __getitem__(self, index: int) -> Any:
        light = np.full((8, ROWS, COLS), 40.0 * (index + 1), np.float32)
        return capture(_program(), light, tolerance="5e", threads=2).exposure_e


def test_a_data_loader_with_workers_captures() -> None:
    from torch.utils.data import DataLoader

    captures = _Captures()
    alone = [captures[index] for index in range(4)]
    loader = DataLoader(captures, num_workers=2, batch_size=None, timeout=SECONDS)  # type: ignore[arg-type]
    for frame, loaded in zip(alone, loader, strict=True):
        np.testing.assert_array_equal(frame, np.asarray(loaded))


def test_a_lock_that_another_thread_holds_is_free_in_the_child() -> None:
    """An analysis that runs while a process forks is not waited for by the child."""
    program = _program()

    def fork_within(_: Container) -> int:
        child = os.fork()
        if child == 0:
            os._exit(_exit_status_of_analysis(program))
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])

    analysed = OfContainer(fork_within)

    def _exit_status_of_analysis(container: Container) -> int:
        import signal

        signal.alarm(SECONDS)
        analysed._make = lambda _: 7
        return analysed(container)

    assert analysed(program) == 7


def test_a_child_of_a_pool_thread_does_all_parts_itself() -> None:
    rows: list[int] = []

    def run(begin: int, end: int) -> None:
        rows.extend(range(begin, end))

    in_parts(run, 8, 2)
    rows.clear()
    child = os.fork()
    if child == 0:
        import signal

        signal.alarm(SECONDS)
        in_parts(run, 8, 2)
        os._exit(0 if sorted(rows) == [*range(8)] else 1)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
