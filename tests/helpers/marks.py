"""Marks of single parameters."""

from __future__ import annotations

import pytest
from _pytest.mark import ParameterSet


def slow(*values: object) -> ParameterSet:
    """Parameters of a test that only `make test-slow` runs with them."""
    return pytest.param(*values, marks=pytest.mark.slow)
