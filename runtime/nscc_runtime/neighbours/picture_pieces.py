"""Images and planes of a picture that is exposed in parts, or that is smaller than the array.

Parts overlap by the reach of the program. Outside the margin, the joined images and planes are
those of a chip whose array has the size of the picture. Reports refer to the joined planes."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import numpy as np

from nscc.diagnostics.rejection import rejected
from nscc.words.container import Container
from nscc.words.legality import picture_words
from nscc.words.pictures import Pictures
from nscc.words.reach import Reach, RegisterReaches, reaches_of_frames
from nscc_runtime.frame_file import Frame
from nscc_runtime.neighbours.plane_summary import reported, summary_of
from nscc_runtime.scenes.placement import Placement


def overlapping(container: Container, placement: Placement) -> Placement:
    """Return the placement whose arrays overlap by the reach of the program's outputs.

    Raises Rejected (NS0542) if the parts cannot be joined to the images of one large array."""
    pictures, codes = _pictures(container), container.pixel_codes
    words = (op for op, _ in picture_words(container))
    reaches = RegisterReaches(container.target, words)
    reach = Reach().joined(*(reaches.of(pictures.registers[name]) for name in pictures.outputs))
    overlap = (reach.up, reach.down), (reach.left, reach.right)
    if placement.arrays == (1, 1) or reach == Reach():
        return placement
    reason = ""
    if codes is not None and (codes != codes[0, 0]).any():
        reason = "its pixels have different codes, which must continue across the parts"
    if any(sum(pair) >= side for pair, side in zip(overlap, placement.array, strict=True)):
        reason = "its images depend on pixels as far away as the size of the array"
    if reason:
        raise rejected(
            "NS0542",
            "this program does not support a picture in several parts",
            notes=(reason,),
            helps=("use --fit crop or scale",),
            status=1,
        )
    return replace(placement, overlap=overlap)


def with_planes_for_reports(container: Container) -> Container:
    """Return the program with reported planes read out in place of its reports."""
    pictures = _pictures(container)
    return replace(container, pictures=replace(pictures, reads=pictures.outputs, reports=()))


def with_reports(frame: Frame, container: Container, placement: Placement) -> Frame:
    """Return the joined frame of `with_planes_for_reports` as a frame of `container`.

    The arrays of the frame have the size of the picture, and repeats a leading axis."""
    pictures = _pictures(container)
    shape = container.target.rows, container.target.cols
    hidden = {f"plane_{report.plane}" for report in pictures.reports}
    hidden -= {f"plane_{name}" for name in pictures.reads}
    told = {key: values for key, values in frame.told.items() if key not in hidden}
    for report in pictures.reports:
        planes = frame.told[f"plane_{report.plane}"]
        repeats = planes.reshape(-1, *planes.shape[-2:])
        all_reaches = islice(reaches_of_frames(container), len(repeats))
        arrays = [
            reported(
                report, summary_of(bits & ~placement.repeated(reaches[report.plane].margin(shape)))
            )
            for bits, reaches in zip(repeats, all_reaches, strict=True)
        ]
        for key, values in arrays[0].items():
            told[key] = values if planes.ndim == 2 else np.stack([each[key] for each in arrays])
    return replace(frame, told=told)


def _pictures(container: Container) -> Pictures:
    assert container.pictures is not None
    return container.pictures
