"""Whether a reconstructed clip moves as the scene did."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray


def temporal_error(truth: NDArray[Any], result: NDArray[Any], data_range: float) -> float:
    """Root mean square of the error in the changes from frame to frame, over the data range.

    Clips (T, rows, cols) with T >= 2. An error that stands still does not count; flicker does.
    """
    if truth.shape != result.shape or truth.ndim != 3 or len(truth) < 2:
        raise ValueError(f"{truth.shape} and {result.shape}")
    if not data_range > 0:
        raise ValueError(f"data range {data_range}")
    error = result.astype(np.float64) - truth.astype(np.float64)
    return float(np.sqrt(np.mean(np.square(np.diff(error, axis=0))))) / data_range
