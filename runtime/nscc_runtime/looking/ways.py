"""Frames of programs that look, by the compiled loop over ways: the reference's numbers, faster.

With the same effects and seeds it gives what `nscc_runtime.reference.looks` gives, to rounding, and
without effects bit for bit. What it cannot have it says, and the reference does it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.operations import Effect as Does
from nscc.words.container import Container
from nscc_runtime.effects import CannotHave, Selection, everything
from nscc_runtime.effects.in_loops import device_keys, draws_keys, figures, switches
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Scene
from nscc_runtime.interface import Executed, Exposure
from nscc_runtime.looking.layout import Keys, Numbers, Sizes, Word
from nscc_runtime.looking.paths import AnalogWord, Paths, paths_of
from nscc_runtime.looking.way_loop import BLOCK, run_ways
from nscc_runtime.pool import in_parts
from nscc_runtime.reference.capture import most_destinations, readout_waits_s
from nscc_runtime.reference.charge import Fallen, charge_of_rows
from nscc_runtime.reference.intervals import Intervals
from nscc_runtime.reference.looks import WORD_DRAWS
from nscc_runtime.reference.trace import retention_us
from nscc_runtime.reference.weights import error_sign
from nscc_runtime.remembered import remembered

Bits = NDArray[np.bool_]

_CELLS = 1 << 18
"""Intervals x pixels whose charge is made at once: it stays in the cache."""
BEFORE_WORDS = {"scene", "light", "response", "count", "charge", "neighbours"}
_AFTER_WORDS = {"converter", "codes"}
"""Stages that need no part in the loop: charge is made, and codes are, as in the reference."""


@dataclass(frozen=True, eq=False)
class Ways:
    """A container with a machine and a sensor, made ready for any scenes and effects."""

    container: Container
    sensor: Sensor

    @remembered
    def lacks(self, effects: Selection) -> tuple[str, ...]:
        """Why frames with these effects are the reference's to make; nothing where they are not."""
        found = [
            f"{each.name}: only the reference has it ({each.words.reason})"
            for each in effects.effects
            if isinstance(each.words, CannotHave)
            and not each.reference.keys() <= BEFORE_WORDS | _AFTER_WORDS
        ]
        laid = self._laid(retention_us(effects, self.sensor))
        return (*found, laid) if isinstance(laid, str) else tuple(found)

    @cached_property
    def fades(self) -> bool:
        """Whether a digital register may go unwritten for too long in a frame."""
        frame_us = float(sum(self.container.slot_us))
        return retention_us(everything(), self.sensor) < frame_us

    def expose(
        self,
        scene: Scene,
        loaded: Mapping[str, Bits],
        effects: Selection,
        seeds: tuple[int, int],
        frame: int,
        rows: range | None = None,
        threads: int = 1,
    ) -> Executed:
        """Frame number `frame`, or consecutive rows of it, as `LookingReference.expose` does;
        threads change no bit. ValueError for what `lacks` names."""
        intervals = Intervals.of(self.container, every_slot=effects.noiseless)
        joined = intervals.joined(scene)

        def fall(part: range) -> Fallen:
            return charge_of_rows(joined, None, self.sensor, effects, seeds, frame, part)

        rows = range(scene.light.shape[0]) if rows is None else rows
        return self.run(scene, loaded, effects, seeds, frame, rows, fall, threads)

    def run(
        self,
        scene: Scene,
        loaded: Mapping[str, Bits],
        effects: Selection,
        seeds: tuple[int, int],
        frame: int,
        rows: range,
        fall: Callable[[range], Fallen],
        threads: int = 1,
        among: Bits | None = None,
    ) -> Executed:
        """The same under the charge of rows that `fall` gives; `among` (rows, cols): the pixels
        whose words run, by default all. Of others the result means nothing."""
        lacking = self.lacks(effects)
        laid = self._laid(retention_us(effects, self.sensor))
        if lacking or isinstance(laid, str):
            raise ValueError("; ".join(lacking))
        begins = laid.paths.begins(loaded, scene.light.shape)
        if among is not None:
            begins = np.where(among, begins, -1)  # they have come to an end
        return _Run(self, laid, scene, effects, seeds, frame).rows(rows, begins, fall, threads)

    @remembered
    def _laid(self, retention_us: float) -> Laid | str:
        """The ways where bits are kept so long, or why there are none."""
        paths = paths_of(self.container, retention_us)
        if isinstance(paths, str):
            return f"the words run one by one: {paths}"
        return Laid(self.container, paths)


@dataclass(frozen=True, eq=False)
class Laid:
    """Paths as the loop takes them."""

    container: Container
    paths: Paths

    @cached_property
    def registers(self) -> tuple[str, ...]:
        """In the loop's order: after the analog registers PIX and IN."""
        return (*self.container.target.analog_registers, "PIX", "IN")

    @cached_property
    def operands(self) -> NDArray[np.int64]:
        """The registers of all words: sources, then destinations."""
        place = self.registers.index
        found = [place(n) for word in self.paths.words for n in _operands(word)]
        return np.array(found, np.int64)

    @remembered
    def words(self, begins: tuple[int, ...]) -> NDArray[Any]:
        """The words as records, where intervals begin with these slots."""
        starts = [*begins, self.container.slots]
        slot_us = self.container.slot_us
        start_s = np.concatenate(([0.0], np.cumsum(slot_us)))[starts] * 1e-6
        dtype, rows, operands = np.dtype(Word), [], 0
        for word in self.paths.words:
            op, interval = word.op, starts.index(word.boundary)
            last = word.boundary == self.container.slots
            resets = op.operation.effect is Does.RESET_PIX
            row = {
                "resets": resets,
                "compares": word.compares,
                "touches_pix": resets or "PIX" in op.sources,
                "sources": 0 if resets else len(op.sources),
                "destinations": 0 if resets or word.compares else len(op.destinations),
                "operands": operands,
                "interval": interval,
                "end_us": word.after_us if last else min(word.after_us, slot_us[word.boundary]),
                "time_s": start_s[interval],
                "divisor": op.operation.divisor,
                "in_e": word.in_e,
            }
            operands += len(_operands(word))
            rows.append(tuple(row[name] for name in dtype.names or ()))
        return np.array(rows, dtype)

    @cached_property
    def arrays(self) -> dict[str, NDArray[Any]]:
        """What is the same whatever the effects."""
        container, paths = self.container, self.paths
        target = container.target
        of_bucket = {readout.bucket: readout for readout in container.readouts}
        readouts = [of_bucket[bucket] for bucket in container.buckets]
        return {
            "operands": self.operands,
            "start": paths.start,
            "acting": paths.acting,
            "following": paths.following,
            "signs": np.array([error_sign(n, container) for n in target.analog_registers]),
            "readout_register": np.array([self.registers.index(r.register) for r in readouts]),
            "readout_gain": np.array([float(r.gain) for r in readouts]),
            "readout_wait_s": readout_waits_s(container),
        }


def _operands(word: AnalogWord) -> tuple[str, ...]:
    resets = word.op.operation.effect is Does.RESET_PIX
    return () if resets else word.op.sources + word.op.destinations


@dataclass(frozen=True, eq=False)
class _Run:
    """One frame."""

    ways: Ways
    laid: Laid
    scene: Scene
    effects: Selection
    seeds: tuple[int, int]
    frame: int

    @cached_property
    def intervals(self) -> Intervals:
        return Intervals.of(self.ways.container, every_slot=self.effects.noiseless)

    def rows(
        self, rows: range, begins: NDArray[np.int64], fall: Callable[[range], Fallen], threads: int
    ) -> Executed:
        """Consecutive rows; `begins` (rows, cols) of all of them."""
        cols = self.scene.light.shape[1]
        shape = (len(self.ways.container.buckets), len(rows), cols)
        exposure, saturated_by = np.empty(shape), np.empty(shape, np.uint8)
        valid, ends = np.empty(shape[1:], np.bool_), np.empty(shape[1:], np.int32)
        pace = self.intervals.paced(self.scene, self.effects)
        bound = self._bound
        step = max(1, _CELLS // (len(self.intervals) * cols))

        def fill(first: int, stop: int) -> None:
            for top in range(first, stop, step):
                part = rows[top : min(top + step, stop)]
                here, of_array = slice(top, top + len(part)), slice(part.start, part.stop)
                fallen = fall(part)
                found = self._loop(
                    bound, fallen.charge, pace(of_array, fallen.light), begins[of_array], part
                )
                exposure[:, here], saturated_by[:, here], ends[here] = found
                valid[here] = fallen.valid

        in_parts(fill, len(rows), threads)
        told = self.laid.paths.endings.items()
        planes = {name: bits.astype(np.bool_)[ends] for name, bits in told}
        good = np.isfinite(exposure) & valid
        return Executed(Exposure(exposure, good, saturated_by), planes)

    @cached_property
    def _bound(self) -> Callable[..., None]:
        """The loop with what all rows have in common."""
        sensor = self.ways.sensor
        seed, device_seed = self.seeds
        mark = self.effects.marking("registers")
        numbers = Numbers(
            least_lost=mark.least_e(sensor) if mark else 0.0,
            frame_s=float(self.intervals.us.sum()) * 1e-6,
            **figures(Numbers, sensor, self.effects),
        )
        keys = Keys(**device_keys(Keys, device_seed), **draws_keys(Keys, seed, WORD_DRAWS))
        return run_ways.bound(
            numbers=numbers,
            keys=keys,
            words=self.laid.words(self.intervals.starts),
            **self.laid.arrays,
        )

    def _loop(
        self,
        bound: Callable[..., None],
        charge: NDArray[np.float64],
        pace: NDArray[np.float64],
        begins: NDArray[np.int64],
        rows: range,
    ) -> tuple[NDArray[Any], ...]:
        """Exposures and what cut them off (buckets, rows, cols), and endings (rows, cols)."""
        container, laid, pixels = self.ways.container, self.laid, begins.size
        sizes = Sizes(
            pixels=pixels,
            first_place=rows.start * begins.shape[1],
            intervals=len(self.intervals),
            segments=len(laid.paths.following),
            registers=len(container.target.analog_registers),
            buckets=len(container.buckets),
            steps=len(laid.paths.words),
            numbered=most_destinations(container.target),
            paces=pace.shape[1],
            frame=self.frame,
            **switches(Sizes, self.effects),
            **{
                f"{at}_bit": mark.bit if (mark := self.effects.marking(at)) else 0
                for at in ("well", "subtracted", "level", "registers")
            },
        )
        out = np.empty((len(container.buckets), pixels))
        marked = np.empty(out.shape, np.uint8)
        ends = np.empty(pixels, np.int32)
        bound(
            sizes=sizes, begins=begins.reshape(-1),
            charge=np.require(charge.reshape(len(charge), -1), np.float64, ["C"]),
            pace=np.require(pace, np.float64, ["C"]),
            out=out, marked=marked, ends=ends, **_scratch(sizes),
        )  # fmt: skip
        shape = (len(out), *begins.shape)
        return out.reshape(shape), marked.reshape(shape), ends.reshape(begins.shape)


def _scratch(sizes: Sizes) -> dict[str, NDArray[Any]]:
    blocks, whole = (sizes.registers + 2) * BLOCK, np.uint64
    pixels = ("pattern", "leak", "offset", "pix", "level", "part", "much", "z", "total")
    return {
        **{name: np.empty(sizes.steps, whole) for name in ("read_keys", "reset_keys", "ask_keys")},
        "write_keys": np.empty(sizes.steps * sizes.numbered, whole),
        "head": np.full(sizes.segments, -1, np.int64),
        **{name: np.empty(BLOCK, np.int64) for name in ("behind", "some", "reached", "marks")},
        "full": np.empty(blocks, np.int64),
        **{name: np.empty(BLOCK) for name in pixels},
        **{name: np.empty(blocks) for name in ("value", "stamp", "lost")},
    }
