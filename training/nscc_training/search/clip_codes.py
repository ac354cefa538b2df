"""Search for the best code for clips, judged by the decoder for any code.

Searches that change codes in small steps keep their mixture of exposure times, and the model of
`choose` knows no decoder. This search exposes scenes on the emulated chip with every effect, once
for each code of a table, in one readout or in two readouts of which one is always open. It compares
the clips that the decoder for any code, which was trained for none of them, reconstructs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Bools
from nscc.diagnostics.diagnostic import Rejected
from nscc.source import Source
from nscc.syntax.format import format_source
from nscc.words.container import Container
from nscc_runtime.request import Request
from nscc_runtime.sensor import Sensor
from nscc_training.any_code.decode import decoded_clip
from nscc_training.any_code.frames import exposed_frame
from nscc_training.code_choices import RANKS, ShutterSpec
from nscc_training.curves import srgb
from nscc_training.design.make import Design, Frame
from nscc_training.design.scene import peak_of
from nscc_training.design.stop_patterns import TRIALS, Progress, less_words, tuned
from nscc_training.emulated import light_on_array
from nscc_training.encoders.base import Codes
from nscc_training.metrics import psnr
from nscc_training.programs import Chip, program
from nscc_training.search.choose import encoders_by_name
from nscc_training.search.moves import Generator, moved

_BUMPS = "cyclic, 1/{} of the frame"
"""The name of a code with bumps of this part of the frame in `encoders_by_name`."""
_MIXED = ((1, 2), (1, 4), (1, 8), (2, 4), (2, 8))
"""Open fractions of the frame, as divisors, of every other pixel and of the pixels between."""
_EVERY_OTHER = np.less(RANKS, RANKS.size // 2)
"""The places of a 4 x 4 tile that have the first open fraction of a mixture."""
_EIGHT_STARTS = RANKS.argsort(axis=None)[2 * RANKS % RANKS.size]
"""For each place, the place whose shutter it has in a mixture: each half of the pixels then has
eight of the sixteen starts of `cyclic`, evenly around the frame."""
_USUAL = "always open, one readout"
"""The name of the code without coding, with which others are compared."""
_TUNED = ", tuned"
"""The end of the name of a code that was changed after the comparison."""
_JUDGED_SIDE = 128
"""Rows and columns in the middle of a scene that are reconstructed."""


@dataclass(frozen=True, eq=False)
class ClipCode:
    """A code to compare: its `name`, a tile of shutters `opened` (N, rows, cols), and its mean PSNR
    over scenes in dB (`mean_db`, 0 until measured).

    With `long`, pixels have a second readout that is always open."""

    name: str
    opened: Bools
    long: bool = False
    mean_db: float = 0.0

    def codebook(self) -> tuple[ShutterSpec, Codes]:
        """Return the code as a codebook of its different shutters."""
        slots, rows, cols = self.opened.shape
        shutters = self.opened.reshape(slots, -1).T.astype(np.int64)
        book, row_of_place = np.unique(shutters, axis=0, return_inverse=True)
        spec = ShutterSpec("codebook", slots, tile=(rows, cols), length=None, rows=len(book))
        return spec, {"book": book, "id": row_of_place.reshape(rows, cols)}

    def changed(self, generator: Generator) -> ClipCode:
        """Return another code: this one after random moves of a search, with at most one shutter
        more."""
        spec, codes = self.codebook()
        codes["book"] = np.concatenate([codes["book"], codes["book"][-1:]])
        opened = self.opened
        while np.array_equal(opened, self.opened):
            moved_codes = moved(spec, codes, generator)
            opened = np.moveaxis(moved_codes["book"][moved_codes["id"]] == 1, -1, 0)
        return replace(self, name=self.name.removesuffix(_TUNED) + _TUNED, opened=opened)

    def text(self, frame: Frame, remark: str = "") -> str:
        """Return the program of the code for the chip and slots of `frame`, with a codebook of its
        shutters. `remark` is the comment at its head."""
        spec, codes = self.codebook()
        if self.opened.all():  # one shutter needs no code
            spec, codes = ShutterSpec("a", spec.slots, tile=(1, 1)), {}
        text = program(spec, codes, Chip(frame.target, frame.slot_us), remark).text
        if self.long:
            rule = "open when book"
            text = text.replace(rule, f"bucket long open when true\nbucket coded {rule}")
        return format_source(Source("design.nsl", text))

    def container(self, frame: Frame) -> Container:
        """Compile the program of the code for the chip and slots of `frame`. Raise Rejected if it
        does not fit."""
        return frame.container("clip.nsl", self.text(frame))


@dataclass(frozen=True, eq=False)
class ClipDesign(Design):
    """A design with the best `code` for clips. `ranked` contains all codes that were compared, the
    best first."""

    code: ClipCode
    ranked: tuple[ClipCode, ...]


def clip_codes(slots: int) -> list[ClipCode]:
    """Return all codes that are compared for frames of `slots` slots: always open, bumps, mixtures
    and free bits, in one readout and, where useful, in two. The first is `_USUAL`; the names
    differ."""
    tiles = {
        name: encoder.hard().numpy() > 0.5 for name, encoder in encoders_by_name(slots).items()
    }
    always_open = np.ones((slots, *RANKS.shape), bool)
    bumps = {k: tiles[_BUMPS.format(k)].reshape(slots, -1)[:, _EIGHT_STARTS] for k in (2, 4, 8)}
    for longer, shorter in _MIXED:
        # A longer exposure of 1/1 of the frame is one that is always open.
        name = f"1/{longer} beside {_BUMPS.format(shorter)}".replace("1/1", "always open")
        tiles[name] = np.where(_EVERY_OTHER, bumps.get(longer, always_open), bumps[shorter])
    tiles["random bits"] = np.random.default_rng(0).random((slots, 8, 8)) < 0.5
    single = [ClipCode(f"{name}, one readout", opened) for name, opened in tiles.items()]
    # A second readout that is always open makes such pixels of the first one useless.
    both = [
        ClipCode(f"{name}, two readouts, one always open", opened, long=True)
        for name, opened in tiles.items()
        if not opened.all(axis=0).any()
    ]
    return [ClipCode(_USUAL, always_open), *single, *both]


def design_clip(
    scenes: Sequence[NDArray[np.floating]],
    frame: Frame | None = None,
    progress: Progress = iter,
    trials: int = TRIALS,
) -> ClipDesign:
    """Design the code for clips with the highest PSNR, minus a cost for its words.

    The best of `clip_codes` is improved by `trials` random changes, each of which is kept if it
    measures better. `scenes` are light in electrons per slot, (N, rows, cols), at most as large as
    the array. `frame` is the chip with its slots; None takes 16 slots. `progress` receives the
    numbers of the codes and of the changes. Raises Rejected: NS0824 for a scene without light, and
    the compiler's errors if no code fits the chip."""
    frame = frame or Frame(slots=16)
    ranked = _judged(clip_codes(frame.slots), scenes, frame, progress)

    def change(code: ClipCode, generator: Generator) -> ClipCode:
        """Return a changed and measured code, or `code` if the changed one does not fit."""
        return next(iter(_judged([code.changed(generator)], scenes, frame, iter)), code)

    best, gain_db = tuned(
        ranked,
        progress(range(trials)),
        change,
        lambda code: less_words(code.mean_db, code.container(frame)),
    )
    remark = f"The code that the decoder for any code is best with, of {len(ranked)}: {best.name}."
    text = best.text(frame, remark)
    single = next(code for code in ranked if not code.long)
    usual = next(code for code in ranked if code.name == _USUAL)
    lines = (
        ("code", best.name),
        ("tried", f"{len(ranked)} codes, by the decoder for any code under every effect"),
        ("tuned", f"{trials} changes of the best tried: {gain_db:+.2f} dB"),
        ("reached", f"{best.mean_db:.1f} dB PSNR in sRGB"),
        ("single", f"{single.name}: {single.mean_db:.1f} dB PSNR in sRGB"),
        ("open", f"{usual.name}: {usual.mean_db:.1f} dB PSNR in sRGB"),
    )
    return ClipDesign(text, frame.compiled("clip.nsl", text), lines, best, tuple(ranked))


def _judged(
    codes: Sequence[ClipCode],
    scenes: Sequence[NDArray[np.floating]],
    frame: Frame,
    progress: Progress,
) -> list[ClipCode]:
    """Return the codes that fit the chip, with their mean PSNR over the scenes, the best first.
    `progress` receives their numbers. Codes that do not fit are left out.

    Raises Rejected if not even the code that is always open fits."""
    sensor = frame.chip().sensor
    ranked: list[ClipCode] = []
    for code in (codes[number] for number in progress(range(len(codes)))):
        try:
            # A low level opens the same shutters and compiles faster.
            container = code.container(replace(frame, level=min(frame.level, 1)))
        except Rejected:
            if code.name == _USUAL:
                raise
            continue
        psnr_db = [_psnr_db(container, sensor, scene, k) for k, scene in enumerate(scenes)]
        ranked.append(replace(code, mean_db=float(np.mean(psnr_db))))
    return sorted(ranked, key=lambda code: -code.mean_db)


def _psnr_db(
    container: Container, sensor: Sensor, light_e: NDArray[np.floating], number: int
) -> float:
    """Return the PSNR, in sRGB, of the middle of a scene after exposure on the emulated chip and
    reconstruction by the decoder for any code.

    `light_e` (N, rows, cols) is its light in electrons per slot. `number` is that of the scene; it
    is the seed of the noise. White is the scene's peak (`peak_of`). Raises Rejected (NS0824) for a
    middle without light."""
    light = light_on_array(light_e, container.slots, container.target)
    # All codes have the same noise, so that their differences are those of the codes.
    frame = exposed_frame(container, light, sensor, Request.of(effects="all", seed=number))
    # At most `_JUDGED_SIDE` rows and columns, or one more if the side is odd.
    middle = [
        slice(max(0, side - _JUDGED_SIDE) // 2, -(-(side + min(side, _JUDGED_SIDE)) // 2))
        for side in light_e.shape[1:]
    ]
    clip = decoded_clip(frame.crop(*middle).clip().tensors())[0].numpy()
    truth = np.asarray(light_e[:, middle[0], middle[1]], np.float64)
    peak = peak_of(truth.reshape(-1), number)
    expected, result = (srgb(np.clip(part / peak, 0, 1)) for part in (truth, clip))
    return psnr(expected, result, data_range=1.0)
