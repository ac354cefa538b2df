"""Types of numpy arrays, named after their elements; a number is the bits of an element.

The shape of an array stands in the docstring of what takes or returns it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
"""An array of any type."""
Bools = NDArray[np.bool_]
Bytes = NDArray[np.uint8]
"""Unsigned integers of 8 bits: codes of a frame, marks, grey values, packed bits."""
Floats = NDArray[np.float64]
Floats32 = NDArray[np.float32]
Indices = NDArray[np.intp]
"""Positions in another array, as numpy's functions return them."""
Ints = NDArray[np.int64]
Ints32 = NDArray[np.int32]
