"""The bounds that interval arithmetic gives are those of all pairs of operands."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from nscc.program.arithmetic import ARITHMETIC, array
from nscc.source import Span
from nscc.syntax.tree import Binary, Name

PLACE = Span(0, 1)
OPERATIONS = {
    "+": np.add, "-": np.subtract, "*": np.multiply, "/": np.floor_divide, "%": np.mod,
    "<<": np.left_shift,
}  # fmt: skip
ranges = st.tuples(st.integers(-12, 12), st.integers(0, 12)).map(lambda r: (r[0], r[0] + r[1]))


@pytest.mark.parametrize("operation", sorted(OPERATIONS))
@given(left=ranges, right=ranges)
def test_bounds_contain_all_results_and_are_attained(
    operation: str, left: tuple[int, int], right: tuple[int, int]
) -> None:
    if operation == "<<":
        right = (abs(right[0]), abs(right[0]) + right[1] - right[0])
    a, b = np.meshgrid(np.arange(left[0], left[1] + 1), np.arange(right[0], right[1] + 1))
    node = Binary(PLACE, operation, Name(PLACE, "a"), Name(PLACE, "b"))
    value = ARITHMETIC[operation](node, array(a), array(b))
    is_fault = (b == 0) & (operation in "/%")
    expected = OPERATIONS[operation](a, np.where(is_fault, 1, b))
    assert np.array_equal(np.broadcast_to(value.data, a.shape)[~is_fault], expected[~is_fault])
    results = expected[~is_fault]
    if not results.size:
        return
    assert value.low <= results.min()
    assert results.max() <= value.high
    if operation != "%" and not is_fault.any():
        assert (value.low, value.high) == (results.min(), results.max())
