"""Search for the best code for clips, judged by the decoder for any code.

Searches that change codes in small steps keep their mixture of exposure times, and the model of
`choose` knows no decoder. This search exposes scenes on the emulated chip with every effect, once
for each code of a table, in one readout or in two readouts of which one is always open. It compares
the clips that the decoder for any code, which was trained for none of them, reconstructs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.words.container import Container
from nscc_runtime.light import Light
from nscc_runtime.sensor import Sensor
from nscc_runtime.simulate import Request
from nscc_training.any_code.decode import decoded_clip
from nscc_training.any_code.frames import exposed_frame
from nscc_training.code_choices import RANKS
from nscc_training.curves import srgb
from nscc_training.design.make import Design, Frame
from nscc_training.design.scene import peak_of
from nscc_training.design.stop_patterns import cheapest
from nscc_training.design.text import book_text
from nscc_training.metrics import psnr
from nscc_training.search.choose import bump_name, encoders_by_name

Bits = NDArray[np.bool_]
Clip = NDArray[np.floating]
Progress = Callable[[Sequence["ClipCode"]], Iterable["ClipCode"]]

_MIXED = ((1, 2), (1, 4), (1, 8), (2, 4), (2, 8))
"""Open fractions of the frame, as divisors, of every other pixel and of the pixels between."""
_EVERY_OTHER = np.less(RANKS, RANKS.size // 2)
_EIGHT_STARTS = RANKS.argsort(axis=None)[2 * RANKS % RANKS.size]
"""For each place, the place whose shutter it has in a mixture: each half of the pixels then has
eight of the sixteen starts of `cyclic`, evenly around the frame."""
_RANDOM_SIDE = 8
_OPEN = "always open"
_JUDGED_SIDE = 128
"""Rows and columns in the middle of a scene that are reconstructed."""


@dataclass(frozen=True, eq=False)
class ClipCode:
    """A tile of shutters (N, rows, cols), and its mean PSNR over scenes in dB.

    With `long`, the frame has a second readout that is always open."""

    name: str
    opened: Bits
    long: bool = False
    mean_db: float = 0.0

    @property
    def title(self) -> str:
        """The name with the number of readouts."""
        return f"{self.name}, {'two readouts, one always open' if self.long else 'one readout'}"

    def text(self, frame: Frame, remark: str = "") -> str:
        """Return the program of the code."""
        return book_text(self.opened, self.long, frame.slots, frame.slot_us, frame.named, remark)


@dataclass(frozen=True, eq=False)
class ClipDesign(Design):
    """A design with the best `code` for clips; `ranked` contains all codes, the best first."""

    code: ClipCode
    ranked: tuple[ClipCode, ...]


def clip_codes(slots: int) -> list[ClipCode]:
    """Return all codes: bumps, mixtures and free bits, in one readout and in two."""
    tiles = {name: encoder.hard().numpy() > 0.5
             for name, encoder in encoders_by_name(slots).items()}  # fmt: skip
    always_open = np.ones((slots, *RANKS.shape), bool)
    bumps = {k: tiles[bump_name("cyclic", k)].reshape(slots, -1)[:, _EIGHT_STARTS]
             for k in (2, 4, 8)}  # fmt: skip
    for longer, shorter in _MIXED:
        name = f"1/{longer} beside {bump_name('cyclic', shorter)}".replace("1/1", _OPEN)
        tiles[name] = np.where(_EVERY_OTHER, bumps.get(longer, always_open), bumps[shorter])
    draw = np.random.default_rng(0)
    tiles["random bits"] = draw.random((slots, _RANDOM_SIDE, _RANDOM_SIDE)) < 0.5
    codes = [ClipCode(name, opened) for name, opened in tiles.items()]
    # A second readout that is always open makes such pixels of the first one useless.
    both = [replace(code, long=True) for code in codes if not code.opened.all(axis=0).any()]
    return [ClipCode(_OPEN, always_open), *codes, *both]


def design_clip(
    scenes: Sequence[Clip], frame: Frame | None = None, progress: Progress = iter
) -> ClipDesign:
    """Design the code for clips with the highest PSNR, minus a cost for its words.

    Parameters
    ----------
    scenes : sequence of array
        Light in electrons per slot, (N, rows, cols), at most as large as the array.
    frame : Frame, optional
        16 slots by default.
    progress : callable, optional
        Called with the codes; returns an iterable over them.

    Returns
    -------
    ClipDesign

    Raises
    ------
    Rejected
        NS0824 for a scene without light, and the compiler's errors if no code fits the chip.
    """
    frame = frame or Frame(slots=16)
    ranked = _judged(clip_codes(frame.slots), scenes, frame, progress)
    best = cheapest(ranked, lambda code: _container(code, frame).words_per_frame)
    remark = f"The code that the decoder for any code is best with, of {len(ranked)}: {best.title}."
    text = best.text(frame, remark)
    single = next(code for code in ranked if not code.long)
    usual = next(code for code in ranked if code.name == _OPEN)
    lines = (
        ("code", best.title),
        ("tried", f"{len(ranked)} codes, by the decoder for any code under every effect"),
        ("reached", f"{best.mean_db:.1f} dB PSNR in sRGB"),
        *(("single", f"{code.title}: {code.mean_db:.1f} dB PSNR in sRGB")
          for code in (single,) if best.long),
        ("open", f"{usual.title}: {usual.mean_db:.1f} dB PSNR in sRGB"),
    )  # fmt: skip
    return ClipDesign(text, frame.compiled("clip.nsl", text), lines, best, tuple(ranked))


def _judged(
    codes: Sequence[ClipCode], scenes: Sequence[Clip], frame: Frame, progress: Progress
) -> list[ClipCode]:
    """Return the codes that fit the chip with their PSNR, best first; raise the compiler's error if
    none fits."""
    sensor = frame.chip().sensor
    quick = replace(frame, level=min(frame.level, 1))
    ranked: list[ClipCode] = []
    refused: Rejected | None = None
    for code in progress(codes):
        try:
            container = _container(code, quick)
        except Rejected as error:
            refused = error
            continue
        psnr_db = [_psnr_db(container, sensor, scene, k) for k, scene in enumerate(scenes)]
        ranked.append(replace(code, mean_db=float(np.mean(psnr_db))))
    if refused and not ranked:
        raise refused
    return sorted(ranked, key=lambda code: -code.mean_db)


def _container(code: ClipCode, frame: Frame) -> Container:
    container = frame.compiled("clip.nsl", code.text(frame)).container
    assert container is not None  # programs that do not fit are rejected
    return container


def _psnr_db(container: Container, sensor: Sensor, light_e: Clip, number: int) -> float:
    """Return the PSNR, in sRGB, of the middle of a scene that is exposed and reconstructed."""
    rows, cols = light_e.shape[1:]
    target = container.target
    margins = ((0, 0), (0, target.rows - rows), (0, target.cols - cols))
    light = Light.of_clip(np.pad(light_e, margins, mode="edge").astype(np.float32))
    # All codes have the same noise, so that their differences are those of the codes.
    frame = exposed_frame(container, light, sensor, Request.of(effects="all", seed=number))
    middle = [slice(max(0, side - _JUDGED_SIDE) // 2, -(-(side + min(side, _JUDGED_SIDE)) // 2))
              for side in (rows, cols)]  # fmt: skip
    clip = decoded_clip(frame.crop(*middle).clip().tensors())[0].numpy()
    truth = np.asarray(light_e[:, middle[0], middle[1]], np.float64)
    peak = peak_of(truth.reshape(-1), number)
    expected, result = (srgb(np.clip(part / peak, 0, 1)) for part in (truth, clip))
    return psnr(expected, result, 1.0)
