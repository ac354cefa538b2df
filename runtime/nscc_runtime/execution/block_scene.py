"""Pixels of a scene that run through their words: their light, once, and any number of frames.

`prepare_pixels` computes everything that frames share, unless it takes too much memory: the mean
charge of every stretch of slots, and the fixed patterns. `expose_pixels` draws the counts of a
frame, exchanges them between neighbours, and runs the words. Every draw is keyed by seed, effect,
frame, event and place, so scenes with other effects or other pixels have the same random
numbers."""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass, replace
from functools import partial
from math import prod

import numpy as np

from nscc.arrays import Bytes, Floats, Ints, Ints32
from nscc.mappings import NamedValues
from nscc.words.container import Container
from nscc_runtime.caches import Recent
from nscc_runtime.effects import Selection
from nscc_runtime.effects.in_loops import draws_keys, patterns
from nscc_runtime.effects.parts import (
    CountedDark,
    CountedLight,
    Echo,
    Exchange,
    Moving,
    Response,
    SlowWords,
)
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import LIGHT, WITHOUT_LIGHT, whole_device
from nscc_runtime.execution.block_loop import BlockScratch, BlockSizes, Charge, run_blocks
from nscc_runtime.execution.block_program import (
    BlockProgram,
    block_program,
    lacks,
    numbers_of,
    switches_of,
)
from nscc_runtime.execution.count_loop import draw_deviations
from nscc_runtime.execution.layout import (
    WORD_BLOCK,
    FixedPatterns,
    Numbers,
    PixelState,
    Switches,
    WordKeys,
)
from nscc_runtime.execution.program import light_under
from nscc_runtime.execution.stretch_loop import (
    NEIGHBOURS,
    NONE,
    STRETCH_BLOCK,
    Exchanging,
    LightBlock,
    Sites,
    SiteSizes,
    StretchMeans,
    StretchSizes,
    exchange_counts,
    find_sites,
    stretch_means,
)
from nscc_runtime.execution.sum_loop import drawn_at
from nscc_runtime.light import DrawnFrames, Light
from nscc_runtime.pool import in_parts
from nscc_runtime.reference.words import WORD_DRAWS

Places = Ints

_MOST_BYTES = 1 << 26
"""Largest memory of the means that are kept from frame to frame."""
_FEWEST = 64
"""Smallest number of pixels per thread."""


@dataclass(frozen=True, eq=False)
class PixelExposures:
    """Exposures of pixels in one frame.

    Attributes
    ----------
    exposure_e : float64, shape (buckets, pixels)
        Electrons before the converter; NaN where the light is not a number.
    saturated_by : uint8, shape (buckets, pixels)
        Saturation marks.
    endings : int32, shape (pixels,)
        The number of the ending of each pixel's path of answers; 0 for fixed shutters.
    """

    exposure_e: Floats
    saturated_by: Bytes
    endings: Ints32


@dataclass(frozen=True, eq=False)
class ChargeScene:
    """The charge of some pixels in the stretches of slots between their words.

    `number` (pixels,): the index of each of these pixels among the pixels of the scene. `sites`:
    these pixels, then neighbours whose counts they exchange. `patterns`: fixed patterns of the
    chip. `counted`: for each source of counts its random stream, its source number there, and
    the means (stretches, sites). `means`: expected charge, see `StretchMeans`. `exchanged`: the
    fraction of its charge that a pixel gives to each neighbour. `invalid`: the indices in `number`
    of pixels whose light is not a number. A site is a pixel whose charge is computed."""

    number: Ints
    sites: Sites
    patterns: FixedPatterns
    counted: list[tuple[int, int, Floats]]
    means: StretchMeans
    exchanged: float
    invalid: Ints

    @property
    def pixels(self) -> int:
        """The number of pixels whose charge is computed."""
        return len(self.number)


@dataclass(frozen=True, eq=False)
class BlockScene:
    """Pixels of a scene under some effects, ready to expose any frame. `places`: places (pixels,)
    of these pixels on the chip. `light`: what they collect, with motion if that effect is on
    (`light_under`). `device_seed`: seed of the fixed patterns."""

    container: Container
    program: BlockProgram
    sensor: Sensor
    light: Light
    effects: Selection
    places: Places
    device_seed: int
    switches: Switches
    numbers: Numbers
    parts: list[Ints]
    """For each group of pixels whose charge is computed together, their indices in `places`."""
    known_means: Recent | None = None
    """Cache of means of light that several scenes share, see `prepare_pixels`."""
    kept: tuple[ChargeScene, ...] = ()
    """The charge of all parts; empty if it takes too much memory."""
    draws: bool = True
    """Whether counts of electrons are drawn."""


def prepare_pixels(
    container: Container,
    sensor: Sensor,
    light: Light,
    effects: Selection,
    places: Places,
    device_seed: int,
    threads: int = 1,
    known_means: Recent | None = None,
) -> BlockScene:
    """Prepare pixels of a scene to run through their words.

    Parameters
    ----------
    container : Container
        A program with fixed shutters, or whose pixels look.
    sensor : Sensor
    light : Light
        The light of the whole array.
    effects : Selection
        The effects that are simulated.
    places : int64, shape (pixels,)
        The pixels that run: row * cols + col. Results do not depend on other pixels.
    device_seed : int
        Seed of the fixed patterns.
    threads : int
        Number of threads.
    known_means : Recent, optional
        Cache of means of the light of these places: adding up the light takes most of the time, and
        few effects change it.

    Returns
    -------
    BlockScene

    Raises
    ------
    ValueError
        If the loop does not support the program with these effects (`block_program.lacks`).
    """
    reasons = lacks(container, sensor, effects)
    if reasons:
        raise ValueError("; ".join(reasons))
    program = block_program(container, sensor, effects)
    lane = program.lane.reshape(-1)[places]
    # Pixels of a code are neighbours in the arrays, so that they run in the same blocks.
    # 16-bit numbers are sorted by radix, ten times as fast as others.
    few = lane.astype(np.uint16) if program.lane.max() < 1 << 16 else lane
    order = np.argsort(few, kind="stable")
    # The means are up to four arrays of float64 with a row for each stretch.
    bytes_ = 8 * 4 * (program.most_stretches + 1) * max(len(places), 1)
    parts = np.array_split(order, -(-bytes_ // _MOST_BYTES)) if bytes_ > _MOST_BYTES else [order]
    scene = BlockScene(
        container,
        program,
        sensor,
        light_under(effects, light),
        effects,
        places,
        device_seed,
        switches_of(len(program.words.signs), len(program.readouts.register), effects),
        numbers_of(container, sensor, effects),
        parts,
        # Several scenes share means only if about eight sets of them fit into the memory.
        known_means if 8 * bytes_ <= _MOST_BYTES else None,
    )
    if len(parts) > 1:
        return scene
    return replace(scene, kept=(_charge_scene(scene, parts[0], threads),))


def without_draws(scene: BlockScene) -> BlockScene:
    """Return the scene with frames that draw no random numbers: charge has its mean, and words have
    their fixed errors only."""
    numbers = copy(scene.numbers)
    numbers.reset_error = numbers.read_error = numbers.compare_noise = 0.0
    numbers.word_error = numbers.move_error = 0.0
    return replace(scene, numbers=numbers, draws=False)


def _charge_scene(scene: BlockScene, number: Ints, threads: int) -> ChargeScene:
    """Return the mean charge of each stretch of slots for the pixels of `scene` with the indices
    `number`, their fixed patterns, and what exchange between neighbours needs."""
    effects, program, pixels = scene.effects, scene.program, len(number)
    exchange = effects.find_part(Exchange)
    exchanged = 0.0 if exchange is None else exchange.fraction(scene.sensor)
    sites = _sites_of(scene, scene.places[number], exchanged > 0)
    lit, dark = effects.having(CountedLight), effects.having(CountedDark)
    compute = partial(_stretch_means, scene, sites, pixels, exchanged, threads)
    changing = Moving, Echo, Response, Exchange, CountedLight, CountedDark, SlowWords
    key, known = (program, effects.names(*changing)), scene.known_means
    means = compute() if known is None else known.of(key, compute)
    counted = [(effect.stream, LIGHT, means.lit) for effect, _ in lit]
    counted += [(effect.stream, WITHOUT_LIGHT, means.dark) for effect, _ in dark]
    device = whole_device(scene.sensor, scene.device_seed, program.lane.size)
    fixed = FixedPatterns(**patterns(effects, device))
    invalid = np.flatnonzero(np.isnan(means.charge[0]))
    return ChargeScene(number, sites, fixed, counted, means, exchanged, invalid)


def _stretch_means(
    scene: BlockScene, sites: Sites, pixels: int, exchanged: float, threads: int
) -> StretchMeans:
    """Return the means of the charge of `sites`, of which the first `pixels` run through their
    words. `exchanged`: the fraction of its charge that a pixel gives to each neighbour."""
    light, count, rows = scene.light, len(sites.place), scene.program.most_stretches
    lit, dark, slow = map(bool, map(scene.effects.having, (CountedLight, CountedDark, SlowWords)))
    means = StretchMeans(
        lit=np.zeros((rows, count) if lit else (1, 1)),
        dark=np.zeros((rows, count) if dark else (1, 1)),
        charge=np.zeros((rows, pixels)),
        pace=np.zeros((rows + 1, pixels) if slow else (1, 1)),
    )
    # In the order of places, neighbours share cache lines of every frame. Of a single frame, all
    # sites are taken together, as they are.
    is_drawn = isinstance(light.frames, DrawnFrames)
    at_once = light.even and not is_drawn
    order = np.arange(count) if at_once else np.argsort(sites.place, kind="stable")
    together, taken, number = count if at_once else STRETCH_BLOCK, sites, np.empty(count, np.int32)
    if not at_once:
        number[order] = np.arange(count)
        taken = Sites._make([*(values[order] for values in sites[:-1]), number[sites.beside]])
    if is_drawn and scene.known_means is not None:
        # The planner exposes the same pixels many times, so their light is drawn once.
        key = (count, scene.effects.names(Moving))
        light = scene.known_means.of(key, lambda: drawn_at(scene.light, taken.place))
        taken = taken._replace(place=np.arange(count))
    room = min(count, together + 2 * scene.light.shape[1])

    def add_part(strip: Light, top: int, first: int, begin: int, end: int) -> None:
        """Compute the means of the sites order[first + begin : first + end]. `strip`: the light of
        the rows from number `top` on."""
        stretch_means(
            sizes=StretchSizes(
                begin=first + begin,
                end=first + end,
                sites=count,
                slots=light.slots,
                own=pixels,
                pixels=prod(strip.shape),
                together=together,
                even=light.even,
                counts_light=lit,
                counts_dark=dark,
                slow_words=slow,
                exchanged=exchanged,
            ),
            stretches=scene.program.stretches,
            sites=taken._replace(place=taken.place - top * strip.shape[1]),
            light=strip.matrix,
            index=order,
            means=means,
            block=LightBlock.of(room),
        )

    for rows_of, top, strip in light.strips(1):
        edges = np.array([rows_of.start, rows_of.stop]) * strip.shape[1]
        first, stop = (0, count) if at_once else np.searchsorted(taken.place, edges)
        in_parts(partial(add_part, strip, top, first), stop - first, threads, _FEWEST)
    return means


def _sites_of(scene: BlockScene, places: Places, exchanges: bool) -> Sites:
    """Return the pixels at `places` as sites (pixels whose charge is computed). If the scene
    `exchanges` charge, those of their neighbours that are not in `places` follow in ascending
    order.

    Without exchange, no pixel has another site beside it."""
    effects, sensor, (rows, cols) = scene.effects, scene.sensor, scene.program.lane.shape
    beside = np.tile(np.arange(len(places), dtype=np.int32), (NEIGHBOURS + 1, 1))
    every, count = places, np.zeros(1, np.int64)
    if exchanges:
        every = np.empty(rows * cols, np.int64)
        find_sites(
            sizes=SiteSizes(rows=rows, cols=cols, pixels=rows * cols, own=len(places)),
            own_places=places,
            number=np.full(rows * cols, NONE, np.int32),
            place=every,
            beside=beside,
            count=count,
        )
        every = every[: count[0]]
    device = whole_device(sensor, scene.device_seed, scene.program.lane.size)
    echo, response = effects.find_part(Echo), effects.find_part(Response)
    dark = effects.find_part(CountedDark)
    factor = np.full(len(every), 1.0 + (echo.fraction(sensor) if echo else 0.0))
    return Sites(
        place=np.require(every, np.int64, ["C"]),
        lane=np.require(scene.program.lane.reshape(-1)[every], np.int32, ["C"]),
        counted=np.require(scene.program.counted.reshape(-1)[every], np.int32, ["C"]),
        factor=factor * device.fixed(response.factor)[every] if response else factor,
        dark_e_per_s=device.fixed(dark.per_s)[every] if dark else np.zeros(len(every)),
        beside=beside,
    )


def expose_pixels(
    scene: BlockScene,
    seed: int,
    frame: int,
    threads: int = 1,
    begins: Places | None = None,
    whole: PixelExposures | None = None,
) -> PixelExposures:
    """Expose one frame of prepared pixels.

    Parameters
    ----------
    scene : BlockScene
        The result of `prepare_pixels`.
    seed, frame : int
        Seed of the noise, and number of the frame.
    threads : int
        Number of threads. Results do not depend on it.
    begins : int64, shape (pixels,), optional
        The first segment of each pixel, or -1 - e for ending e; by default that of its code.
    whole : PixelExposures, optional
        Exposures of all pixels of the chip, by place. Those of the scene's pixels are replaced.

    Returns
    -------
    PixelExposures
        `whole`, or the exposures of the scene's pixels.
    """
    buckets, pixels = len(scene.container.buckets), len(scene.places)
    result = whole or PixelExposures(
        np.empty((buckets, pixels)),
        np.empty((buckets, pixels), np.uint8),
        np.zeros(pixels, np.int32),
    )
    # Light that takes too much memory is added up again in every frame.
    charges = scene.kept or (_charge_scene(scene, part, threads) for part in scene.parts)
    for charge in charges:
        places = charge.sites.place[: charge.pixels]
        first = (
            scene.program.first_segment.take(places) if begins is None else begins[charge.number]
        )
        chosen = charge.number if whole is None else places
        _run_words(scene, charge, (first, chosen), seed, frame, threads, result)
        result.exposure_e[:, chosen[charge.invalid]] = np.nan
    return result


def _charge_of_frame(
    scene: BlockScene, charge: ChargeScene, seed: int, frame: int, threads: int
) -> Floats:
    """Return the charge of one frame, electrons (stretches, pixels): the means plus the deviations
    of Poisson counts, exchanged between neighbours.

    `seed`: of the noise. `frame`: number of the frame. Without counts this is the array of means
    itself, which callers must not change. Slots of a stretch are counted as one number."""
    if not (scene.draws and charge.counted):
        return charge.means.charge
    away = draw_deviations(charge.counted, charge.sites.place, seed, frame, threads)
    charge_e = np.empty(charge.means.charge.shape)

    def run(begin: int, end: int) -> None:
        """Exchange the random electron counts of the pixels `begin` to `end` - 1 with their
        neighbours. Write the charge of these pixels, in electrons, into `charge_e`."""
        exchange_counts(
            exchanging=Exchanging(
                begin=begin,
                end=end,
                rows=len(charge_e),
                sites=away.shape[1],
                pixels=charge.pixels,
                exchanged=charge.exchanged,
            ),
            stretches=scene.program.stretches,
            sites=charge.sites,
            mean_e=charge.means.charge,
            away=away,
            charge=charge_e,
        )

    in_parts(run, charge.pixels, threads, WORD_BLOCK)
    return charge_e


def _run_words(
    scene: BlockScene,
    charge: ChargeScene,
    at: tuple[Places, Places],
    seed: int,
    frame: int,
    threads: int,
    result: PixelExposures,
) -> None:
    """Run the pixels of `charge` through their words, and store exposures, marks and endings in
    `result`, in place.

    `at`: the segment in which each pixel begins, or -1 - e if it has reached ending e, and its
    index in `result`. `seed`: of the noise. `frame`: number of the frame. A segment is the part of
    a path between two comparisons."""
    charge_e = _charge_of_frame(scene, charge, seed, frame, threads)
    program, pixels = scene.program, charge.pixels
    places = charge.sites.place[:pixels]
    shared: NamedValues = {
        "switches": scene.switches, "numbers": scene.numbers,
        "keys": WordKeys(**draws_keys(seed, WORD_DRAWS)), "program": program.words,
        "segments": program.segments, "readouts": program.readouts,
        "begins": at[0], "places": places, "chosen": at[1], "patterns": charge.patterns,
        "charge": Charge(charge_e, charge.means.pace), "out": result.exposure_e,
        "marked": result.saturated_by, "ends": result.endings,
    }  # fmt: skip
    segments, words = len(program.segments.following), len(program.words.words)

    def run(begin: int, end: int) -> None:
        """Run the words in the pixels from `begin` up to before `end`, block by block, and write
        their exposures."""
        run_blocks(
            sizes=BlockSizes(
                first=begin,
                end=end,
                pixels=len(result.endings),
                charged=pixels,
                segments=segments,
                words=words,
                numbered=program.numbered,
                frame=frame,
            ),
            block=BlockScratch(
                segment=np.empty(WORD_BLOCK, np.int64),
                keys=np.empty(words * (1 + program.numbered), np.uint64),
            ),
            state=PixelState.of(scene.switches.registers, 1 + program.numbered),
            **shared,
        )

    in_parts(run, pixels, threads, WORD_BLOCK)
