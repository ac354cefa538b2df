"""`nscc design`: compute programs for scenes from the scenes' light and the sensor's noise.

from nscc_training.design import Frame, design_looks

made = design_looks([light_e], 5, Frame(slots=256, slot_us=125))
print(made.text)"""

from __future__ import annotations

from nscc_training.design.make import Design, Frame, design_looks, design_tile
from nscc_training.design.stop_patterns import design_pattern

__all__ = ["Design", "Frame", "design_looks", "design_pattern", "design_tile"]
