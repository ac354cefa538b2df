"""Analyses of containers live as long as these."""

from __future__ import annotations

import gc
import pickle
import weakref

import numpy as np
import pytest
from plan_cases import case

from nscc.words.container import Container
from nscc_runtime import capture
from nscc_runtime.light import Light


def taken(effects: str) -> Container:
    """A container of its own, of which a frame has been exposed."""
    container = pickle.loads(pickle.dumps(case("b accumulate", rows=8, cols=12)))
    light = Light.of_clip(np.full((container.slots, 8, 12), 50.0, np.float32))
    capture(container, light, effects=effects)
    return container


@pytest.mark.parametrize("effects", ["none", "all"])
def test_analyses_are_freed_with_their_container(effects: str) -> None:
    """A weak reference to what was computed for a capture is dead once the container is gone."""
    kept = weakref.ref(taken(effects))
    gc.collect()
    assert kept() is None


def test_copies_leave_analyses_behind() -> None:
    """A pickled container has fewer attributes than one that was captured with, and the same
    encoding."""
    container = taken("all")
    copy = pickle.loads(pickle.dumps(container))
    assert vars(copy).keys() == vars(pickle.loads(pickle.dumps(copy))).keys()
    assert vars(container).keys() > vars(copy).keys()
    np.testing.assert_array_equal(copy.encoding, container.encoding)
