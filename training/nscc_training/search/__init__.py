"""Codes found by moving many places together: a closed form proposes, a decoder judges.

An edge of one place alone changes next to nothing, and a pattern such as two phases of 2 x 2 lies
many such steps away. `moves` changes blocks of a tile at once, `expected` says in milliseconds what
a code should tell of moving light, and `nscc_training.loop.searching` has the run's decoder judge
the few that are expected to be best.
"""

from __future__ import annotations

from nscc_training.search.expected import Motion, told_db
from nscc_training.search.moves import MOVING, moved
from nscc_training.search.scene_motion import speeds_of, texture_of

__all__ = ["MOVING", "Motion", "moved", "speeds_of", "texture_of", "told_db"]
