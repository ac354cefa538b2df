"""From the names of flat and dark frames to what they tell of a sensor."""

from __future__ import annotations

from collections.abc import Sequence

from nscc.target.target import Target
from nscc_runtime.calibrate.estimate import Calibration, calibrated
from nscc_runtime.calibrate.frames import grouped, load_stack
from nscc_runtime.progress import Progress, unseen


def calibrate_files(
    flats: Sequence[str],
    darks: Sequence[str],
    target: Target,
    crosstalk: float | None = None,
    progress: Progress = unseen,
) -> Calibration:
    """The photon transfer fit of frames in files, folders or PATH@TIME, one level each.

    `crosstalk` None: it is measured. Raises Rejected for frames that cannot be read or do not do.
    """
    top = (1 << target.adc_bits) - 1
    named = [*flats, *darks]
    stacks = [load_stack(name, top) for name in progress(named, "reading frames", len(named))]
    split = len(flats)
    return calibrated(grouped(stacks[:split]), grouped(stacks[split:]), top, crosstalk)
