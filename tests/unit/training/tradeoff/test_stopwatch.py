"""Times of a tradeoff: what the first run of a process takes besides is in none."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from nscc_training.experiments.study import SHORT_MS, Stopwatch


class Method:
    """Takes its time, and `cold_ms` more on its first run; a clock of its own counts."""

    def __init__(self, cold_ms: float = 1000.0) -> None:
        self.cold_ms, self.now_ms = cold_ms, 0.0
        self.ran: list[float] = []
        self.watch = Stopwatch(lambda: self.now_ms / 1e3)

    def __call__(self, own_ms: float) -> Callable[[], float]:
        def run() -> float:
            self.now_ms += own_ms + self.cold_ms
            self.cold_ms = 0.0
            self.ran.append(own_ms)
            return own_ms

        return run


def test_more_iterations_take_longer_whichever_is_first() -> None:
    """Each time is the method's own, though the first run of all is slower."""
    method = Method()
    for own_ms in (21.0, 84.0):
        made, taken_ms = method.watch.ms("m", f"{own_ms}", method(own_ms))
        assert made == own_ms
        assert taken_ms == pytest.approx(own_ms)


def test_long_runs_are_done_once_more_for_their_kind_and_not_for_each_setting() -> None:
    """Two settings measured twice take four runs, and one more to warm up their kind."""
    method = Method()
    long_ms = 2 * SHORT_MS
    for repeat in range(2):
        for setting in ("a", "b"):
            _, taken_ms = method.watch.ms("m", setting, method(long_ms))
            assert taken_ms == pytest.approx(long_ms), repeat
    assert len(method.ran) == 2 * 2 + 1


def test_a_short_warm_up_run_comes_before_a_long_measurement() -> None:
    """The given short call is run first, and only the long one is timed."""
    method = Method()
    _, taken_ms = method.watch.ms("m", "s", method(4000.0), method(1.0))
    assert taken_ms == pytest.approx(4000.0)
    assert method.ran == [1.0, 4000.0]


def test_the_first_short_run_of_each_setting_does_not_count() -> None:
    """A short setting is run twice and the second run counts, although its method is warm
    already."""
    method = Method(cold_ms=0.0)
    method.watch.ran("m")
    method.cold_ms = 5.0
    assert method.watch.ms("m", "s", method(1.0))[1] == pytest.approx(1.0)
    assert method.ran == [1.0] * 2


def test_a_method_that_has_run_is_timed_without_a_warm_up() -> None:
    """The method and setting were noted as warm, so three measurements take three runs."""
    method = Method(cold_ms=0.0)
    method.watch.ran("m", "s")
    times_ms = [method.watch.ms("m", "s", method(7.0))[1] for _ in range(3)]
    assert times_ms == pytest.approx([7.0] * 3)
    assert len(method.ran) == 3
