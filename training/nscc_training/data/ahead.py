"""Batches made ahead: the next one in a thread, while a step is busy with its gradient."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor

from nscc_training.data.batches import Batch


class Ahead:
    """Batches by step, as `make` gives them; a context, which no thread outlives.

    `begin` has a batch of a step before `end` made in the background, at most one at a time, and
    `take` gives it, or makes it where it was not begun: a batch depends on its step alone, not on
    who makes it. What goes wrong with a batch is raised where it is taken.
    """

    def __init__(self, make: Callable[[int], Batch], end: int) -> None:
        self._make, self._end = make, end
        # Its thread begins with the first batch, not here.
        self._worker = ThreadPoolExecutor(1, "nscc-batches")
        self._begun: tuple[int, Future[Batch]] | None = None

    def __enter__(self) -> Ahead:
        return self

    def __exit__(self, *_: object) -> None:
        self._worker.shutdown(wait=True, cancel_futures=True)

    def begin(self, step: int) -> None:
        """Have the batch of a step made."""
        if step < self._end:
            self._begun = step, self._worker.submit(self._make, step)

    def take(self, step: int) -> Batch:
        """The batch of a step."""
        begun, self._begun = self._begun, None
        if begun is None or begun[0] != step:
            return self._make(step)
        return begun[1].result()
