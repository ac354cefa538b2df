"""Choice of a code for clips by the motion of the scene, within a limit of words per slot.

No code is best for all scenes. Static parts need long exposures. Fast parts need short exposures
at many times. The information in a frame is computed in closed form (`nscc_training.search`)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.source import Source
from nscc.syntax.format import format_source
from nscc_training.codes_files import load_codes
from nscc_training.command_settings import MotionKind
from nscc_training.design.chip import DesignChip
from nscc_training.design.make import Design, Frame
from nscc_training.encoders import Encoder, ShutterSpec, make_encoder
from nscc_training.programs import Chip, program_of, words_per_slot
from nscc_training.run_files import searched_codes
from nscc_training.search.expected import Motion, speeds_of, texture_of, told_db

SPEEDS: dict[str, tuple[float, ...]] = {"slow": (1.0, 4.0, 8.0), "fast": (16.0, 32.0, 64.0)}
"""Speeds in pixels per frame time, by name."""

_TILE = (4, 4)
"""Rows and columns of the candidates' tile, except of the searched code."""
_STARTS = ("quad", "two-phase", "staggered", "cyclic")
"""The arrangements of bumps that are tried (`nscc_training.encoders.encoder_classes`)."""
_PARTS_OPEN = (2, 4, 8)
"""Candidate bumps are open for 1/2, 1/4 or 1/8 of the frame."""
_SEARCHED = ShutterSpec("e", 16, tile=(8, 8))
"""The searched code: free bits for 16 slots. No codes were searched for other lengths."""
_BRIGHT = 0.35
"""Assumed mean light in full wells if no scene is given."""
_YARDSTICK = "quad, 1/4 of the frame"
"""The code that the report compares the choice with."""


@dataclass(frozen=True, eq=False)
class MotionDesign(Design):
    """A design for clips: the `name` of its code, and `expected`: by how many dB the frames of each
    code that was tried reduce the variance of light, by the code's name."""

    name: str
    expected: dict[str, float]


def design_motion(
    kind: MotionKind,
    scenes: Sequence[NDArray[np.floating]] = (),
    frame: Frame | None = None,
    most_words: float = 4.0,
) -> MotionDesign:
    """Design shutters for moving light.

    The candidates are bumps (consecutive open slots) in a 4 x 4 tile and, for 16 slots, searched
    bits. The one with the highest expected information that fits the chip is chosen.

    Parameters
    ----------
    kind : {"slow", "fast", "scene"}
        The speed of the light; "scene" measures it in `scenes`.
    scenes : sequence of array
        Light in electrons, (intervals, rows, cols), with at most N intervals. Without scenes,
        typical light is assumed.
    frame : Frame, optional
        Chip and slots; 16 slots of the default chip if None.
    most_words : float
        Codes with more words (instructions of the chip) per slot are skipped.

    Returns
    -------
    MotionDesign

    Raises
    ------
    Rejected
        NS0843 if no code is left, or for "scene" without scenes; otherwise the compiler's
        errors.
    """
    frame = frame or Frame(slots=16)
    if kind == "scene" and not scenes:
        raise rejected(
            "NS0843",
            "there is no scene to measure the motion of",
            helps=("name one with --scene, or --motion slow or fast",),
        )
    motions = [_motion(kind, scene, frame.chip()) for scene in scenes or (None,)]
    encoders = encoders_by_name(frame.slots)
    expected = {
        name: float(np.mean([told_db(encoder.hard().numpy(), motion) for motion in motions]))
        for name, encoder in encoders.items()
    }
    remark = "Shutters for clips, {}: of such codes most is expected of it where motion is " + (
        "as its scene has it." if kind == "scene" else f"{kind}."
    )
    passed: list[str] = []
    refused: Rejected | None = None
    # The codes from which most is expected are tried first; the first that fits is taken.
    for name in sorted(expected, key=lambda code_name: -expected[code_name]):
        try:
            files = program_of(
                encoders[name], Chip(frame.target, frame.slot_us), remark.format(name)
            )
            text = format_source(Source("design.nsl", files.text))
            program = frame.compiled("motion.nsl", text)
        except Rejected as error:
            refused = error
            passed.append(f"{name} (does not fit)")
            continue
        if (words := words_per_slot(program)) <= most_words:
            lines = _lines(name, expected, motions, passed)
            return MotionDesign(text, program, lines, name, expected)
        passed.append(f"{name} ({words:.1f} words a slot)")
    if refused and all(code_name.endswith("(does not fit)") for code_name in passed):
        raise refused  # the compiler's message says more
    raise rejected(
        "NS0843",
        f"no code for clips has at most {most_words:g} words per slot here",
        notes=(f"rejected: {'; '.join(passed)}",),
        helps=("allow more words with --max-words, or use longer slots",),
    )


def _motion(kind: MotionKind, scene: NDArray[np.floating] | None, chip: DesignChip) -> Motion:
    """Return the model of moving light with the chip's noise. `kind` gives its speeds: "slow",
    "fast", or "scene" for those of `scene`.

    `scene` (N, rows, cols) in electrons gives brightness, contrast and fineness of the texture;
    None takes typical values (kind "slow" or "fast" only). Raises Rejected (NS0824) for a scene
    without light."""
    mean_e = _BRIGHT * chip.full_e if scene is None else float(scene.sum(axis=0).mean())
    if mean_e <= 0:
        raise rejected(
            "NS0824",
            "a scene has no light, so no shutters can be designed for it",
            helps=("use a scene with light; --exposure sets how much light a frame receives",),
        )
    dark_e = float(chip.exposed_sd_e(np.zeros(1))[0])
    motion = Motion(SPEEDS.get(kind, (0.0,)), noise=(dark_e / mean_e) ** 2, counts=1 / mean_e)
    if scene is None:
        return motion
    length, contrast = texture_of(scene.mean(axis=0))
    speeds = speeds_of(scene) if kind == "scene" else motion.speeds
    return motion._replace(speeds=speeds, length=length, contrast=contrast)


def encoders_by_name(slots: int) -> dict[str, Encoder]:
    """Return the candidate codes for frames of `slots` slots as encoders, by name: bumps ("START,
    1/K of the frame") in a 4 x 4 tile, and for 16 slots the searched bits ("searched")."""
    encoders = {}
    for divisor in _PARTS_OPEN:
        length = -(-slots // divisor)
        for start in _STARTS:
            kind = "codebook" if start == "cyclic" else "c"
            spec = ShutterSpec(
                kind, slots, tile=_TILE, length=length, rows=16 if kind == "codebook" else None
            )
            encoders[f"{start}, 1/{divisor} of the frame"] = make_encoder(spec, start)
    if slots == _SEARCHED.slots:
        encoders["searched"] = make_encoder(_SEARCHED)
        encoders["searched"].load_codes(load_codes(searched_codes()))
    return encoders


def _lines(
    name: str, expected: dict[str, float], motions: Sequence[Motion], passed: Sequence[str]
) -> tuple[tuple[str, str], ...]:
    """Return what was chosen and why, as pairs of a label and a text.

    `name` is the chosen code. `expected` is the expected gain of each code in dB by name, and
    `passed` are texts: codes with a higher gain that were not chosen, with the reason. `motions`
    are the models of the scenes."""
    speeds = [speed for motion in motions for speed in motion.speeds]
    lines = [
        ("code", name),
        ("motion", f"{min(speeds):.3g} to {max(speeds):.3g} pixels over the frame"),
        (
            "expected",
            f"{expected[name]:.1f} dB below the light's variance; the 2 x 2 tile "
            f"{expected[_YARDSTICK]:.1f} dB",
        ),
    ]
    if passed:
        lines.append(("passed", "; ".join(passed)))
    return tuple(lines)
