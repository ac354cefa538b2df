"""Threads and memory that are reused: starting a thread takes as long as a small frame."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable
from functools import cache
from itertools import pairwise
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from concurrent.futures import ThreadPoolExecutor

THREADS = "nscc"
"""Prefix of the names of threads that work on a part of a task and must not divide it further."""


def processors() -> int:
    """Return the number of processors that a run may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def threads_of(threads: int | None) -> int:
    """Return `threads`, or the number of processors if it is None; `threads` is not checked."""
    return processors() if threads is None else threads


@cache
def keep_memory() -> None:
    """Have the C library keep up to 64 MiB of freed memory; called again, do nothing. Every frame
    needs the same arrays, and new pages from the system take a third of the time of some frames.

    glibc keeps twice the size of the largest block of at most 32 MiB that it has returned to the
    system. The pages of the block here are never touched, so it takes no memory."""
    if sys.platform == "linux":
        bytes((1 << 25) - (1 << 16))


@cache
def _pool(threads: int) -> ThreadPoolExecutor:
    """Return the pool of `threads` threads, the same for each call; it lives as long as the
    process."""
    from concurrent.futures import ThreadPoolExecutor  # commands that list effects start none

    return ThreadPoolExecutor(threads, thread_name_prefix=THREADS)


def after_fork(renew: Callable[[], object]) -> None:
    """Call `renew` in every child process right after fork, if the system supports fork."""
    if hasattr(os, "register_at_fork"):
        os.register_at_fork(after_in_child=renew)


# A fork copies the pools of the parent process, but not their threads.
after_fork(_pool.cache_clear)


def in_parts(run: Callable[[int, int], None], count: int, threads: int, multiple: int = 1) -> None:
    """Call `run(begin, end)`, for the numbers from `begin` up to before `end`, for parts of the
    numbers below `count`, `threads` at a time; return when all are done. The first error of a
    part is raised here, after all parts have ended.

    Parts begin at multiples of `multiple`. For 0 numbers, `run(0, 0)` is called. If it is called
    from a thread of a pool itself, that thread runs all as one part. `run` must not wait for such
    threads. Before Python 3.12, threads wait for each other's `cached_property` of one object, so
    compute those that use `in_parts` before."""
    blocks = -(-count // multiple)
    threads = min(threads, blocks)
    if threads <= 1 or threading.current_thread().name.startswith(THREADS):
        run(0, count)
        return
    from concurrent.futures import wait

    cuts = [min(blocks * i // threads * multiple, count) for i in range(threads + 1)]
    # This thread runs one part, so one thread less has to wake up.
    futures = [_pool(threads).submit(run, begin, end) for begin, end in pairwise(cuts[1:])]
    try:
        run(cuts[0], cuts[1])
    finally:  # the caller owns what the parts write, so none may go on after an error
        wait(futures)
    for future in futures:
        future.result()


def in_strips(run: Callable[[range], None], rows: range, most: int, threads: int) -> None:
    """Call `run(strip)` for consecutive strips of `rows`, `threads` at a time; return when all are
    done. All strips in work together have at most `most` rows, or one row each if `most` is less
    than `threads`. Without rows it is not called."""
    strip_rows = max(1, min(most // threads, -(-len(rows) // threads)))
    strips = [rows[first : first + strip_rows] for first in range(0, len(rows), strip_rows)]

    def run_strips(begin: int, end: int) -> None:
        """Run the strips from `begin` up to before `end`, one after the other."""
        for strip in strips[begin:end]:
            run(strip)

    in_parts(run_strips, len(strips), threads)
