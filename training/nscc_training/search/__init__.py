"""Search of codes: many places move together, a closed form proposes, a decoder judges.

Moving an edge of one place changes almost nothing, and a pattern such as two phases of 2 x 2 is
many such steps away. `moves` changes blocks of a tile at once, `expected` estimates in milliseconds
how well a code captures moving light, and in `nscc_training.loop.searching` the run's decoder
judges the most promising codes.
"""

from __future__ import annotations

from nscc_training.search.expected import Motion, told_db
from nscc_training.search.moves import MOVING, moved
from nscc_training.search.scene_motion import speeds_of, texture_of

__all__ = ["MOVING", "Motion", "moved", "speeds_of", "texture_of", "told_db"]
