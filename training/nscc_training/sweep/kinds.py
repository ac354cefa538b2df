"""What a point of a grid can be."""

from __future__ import annotations

from collections.abc import Mapping

from nscc_training.sweep.compiling import COMPILE, LIMITS
from nscc_training.sweep.designing import DESIGN
from nscc_training.sweep.emulating import EMULATE
from nscc_training.sweep.evaluating import EVALUATE
from nscc_training.sweep.point import PointKind
from nscc_training.sweep.training import TRAIN

KINDS: Mapping[str, PointKind] = {
    kind.name: kind for kind in (COMPILE, LIMITS, EMULATE, TRAIN, EVALUATE, DESIGN)
}
