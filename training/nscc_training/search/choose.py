"""A code for clips, chosen by how things move: the one of which most is expected within its words.

No code is best for all scenes. What stands still wants long exposures, what flies past short ones
at many moments; what a frame then tells is worked out in closed form (`nscc_training.search`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.pipeline import Compiled
from nscc.source import Source
from nscc.syntax.format import format_source
from nscc_training.codes_files import load_codes
from nscc_training.design.chip import Chip
from nscc_training.design.make import Design, Frame
from nscc_training.encoders import Encoder, ShutterSpec, make_encoder
from nscc_training.programs import Chip as Place
from nscc_training.programs import program_of, words_per_slot
from nscc_training.run_files import searched_codes
from nscc_training.search.expected import Motion, told_db
from nscc_training.search.scene_motion import speeds_of, texture_of

Kind = Literal["slow", "fast", "scene"]
SPEEDS: dict[str, tuple[float, ...]] = {"slow": (1.0, 4.0, 8.0), "fast": (16.0, 32.0, 64.0)}
"""Pixels over the whole frame."""

_TILE = (4, 4)
_STARTS = ("quad", "two-phase", "staggered", "cyclic")
_PARTS_OPEN = (2, 4, 8)
"""Bumps are open for a half, a quarter or an eighth of the frame."""
_SEARCHED = ShutterSpec("e", 16, (8, 8))
"""What was searched: free bits. Codes for frames of other lengths were not."""
_BRIGHT = 0.35
"""Of a full well, light as films have it in the mean, where no scene is named."""
_YARDSTICK = "quad, 1/4 of the frame"


@dataclass(frozen=True, eq=False)
class MotionDesign(Design):
    """One for clips: its `name`, and `expected`, decibels by code, of all that were looked at."""

    name: str
    expected: dict[str, float]


def design_motion(
    kind: Kind, scenes: Sequence[NDArray[np.floating]] = (), frame: Frame | None = None,
    most_words: float = 4.0,
) -> MotionDesign:  # fmt: skip
    """The program of bumps in a 4 x 4 tile, or for 16 slots of searched bits, that tells most of
    light that moves as `kind` says, or as the `scenes` do: light (N or fewer parts, rows, cols),
    electrons in each.

    Codes of more than `most_words` a slot are passed over. Raises Rejected: NS0843 where no code is
    left, or `scene` names none, and as the compiler.
    """
    frame = frame or Frame(slots=16)
    if kind == "scene" and not scenes:
        raise rejected("NS0843", "there is no scene whose motion could be looked at",
                       helps=("name one with --scene, or --motion slow or fast",))  # fmt: skip
    motions = [_motion(kind, scene, frame.chip()) for scene in scenes or (None,)]
    encoders = _encoders(frame.slots)
    expected = {
        name: float(np.mean([told_db(encoder.hard().numpy(), motion) for motion in motions]))
        for name, encoder in encoders.items()
    }
    passed: list[str] = []
    refused: Rejected | None = None
    for name in sorted(expected, key=lambda each: -expected[each]):
        try:
            text, made = _compiled(encoders[name], frame, _remark(kind, name))
        except Rejected as error:
            refused = error
            passed.append(f"{name} (does not fit)")
            continue
        if (words := words_per_slot(made)) <= most_words:
            lines = _lines(name, expected, motions, passed)
            return MotionDesign(text, made, lines, name, expected)
        passed.append(f"{name} ({words:.1f} words a slot)")
    if refused and all(each.endswith("(does not fit)") for each in passed):
        raise refused  # the compiler's own words say more
    raise rejected(
        "NS0843", f"no code for clips takes at most {most_words:g} words a slot here",
        notes=(f"passed over: {'; '.join(passed)}",),
        helps=("allow more with --max-words, or take longer slots",),
    )  # fmt: skip


def _motion(kind: Kind, scene: NDArray[np.floating] | None, chip: Chip) -> Motion:
    """What moves, seen with the chip's noise."""
    mean_e = _BRIGHT * chip.full_e if scene is None else float(scene.sum(axis=0).mean())
    if mean_e <= 0:
        raise rejected("NS0824", "a scene has no light: there is nothing to design shutters for",
                       helps=("name a scene with light; --exposure says how much of it a frame "
                              "gets",))  # fmt: skip
    dark_e = float(chip.exposed_sd_e(np.zeros(1))[0])
    found = Motion(SPEEDS.get(kind, (0.0,)), noise=(dark_e / mean_e) ** 2, counts=1 / mean_e)
    if scene is None:
        return found
    length, contrast = texture_of(scene.mean(axis=0))
    speeds = speeds_of(scene) if kind == "scene" else found.speeds
    return replace(found, speeds=speeds, length=length, contrast=contrast)


def _encoders(slots: int) -> dict[str, Encoder]:
    """Codes by what people call them."""
    found = {}
    for part in _PARTS_OPEN:
        length = -(-slots // part)
        for start in _STARTS:
            kind = "codebook" if start == "cyclic" else "c"
            spec = ShutterSpec(kind, slots, _TILE, length, 16 if kind == "codebook" else None)
            found[f"{start}, 1/{part} of the frame"] = make_encoder(spec, start)
    if slots == _SEARCHED.slots:
        found["searched"] = make_encoder(_SEARCHED)
        found["searched"].load_codes(load_codes(searched_codes()))
    return found


def _compiled(encoder: Encoder, frame: Frame, remark: str) -> tuple[str, Compiled]:
    chip = Place(frame.target, frame.slot_us)
    text = format_source(Source("design.nsl", program_of(encoder, chip, remark).text))
    return text, frame.compiled("motion.nsl", text)


def _remark(kind: Kind, name: str) -> str:
    of = "as its scene has it" if kind == "scene" else kind
    return f"Shutters for clips, {name}: of such codes most is expected of it where motion is {of}."


def _lines(
    name: str, expected: dict[str, float], motions: Sequence[Motion], passed: Sequence[str]
) -> tuple[tuple[str, str], ...]:
    speeds = [speed for motion in motions for speed in motion.speeds]
    lines = [
        ("code", name),
        ("motion", f"{min(speeds):.3g} to {max(speeds):.3g} pixels over the frame"),
        ("expected", f"{expected[name]:.1f} dB below the light's variance; the 2 x 2 tile "
                     f"{expected[_YARDSTICK]:.1f} dB"),
    ]  # fmt: skip
    if passed:
        lines.append(("passed", "; ".join(passed)))
    return tuple(lines)
