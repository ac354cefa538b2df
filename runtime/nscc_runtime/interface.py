"""What exposes a frame: one method, shared by the emulator and by devices."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from nscc.words.container import Container
    from nscc_runtime.light import Light


@dataclass(frozen=True, eq=False)
class Exposure:
    """One exposed frame, before the ADC.

    `exposure_e` float64 (buckets, rows, cols): electrons, in the order of `Container.buckets`; a
    pixel that never opens is +0. `valid` bool, the same shape: False where the value means nothing
    (it is not finite). `saturated_by` uint8, the same shape: the bits of what cut the value off on
    its way here (`nscc_runtime.effects.marks`); None: nothing could.
    """

    exposure_e: NDArray[np.float64]
    valid: NDArray[np.bool_]
    saturated_by: NDArray[np.uint8] | None = None


class Exposer(Protocol):
    """Anything that can run a compiled program for one frame."""

    def expose(self, container: Container, light: Light | None) -> Exposure:
        """Expose one frame of `container`.

        `light` is the scene on the array; a device that looks at the world takes None. Raises
        `nscc.diagnostics.diagnostic.Rejected` where the program cannot run here.
        """
        ...
