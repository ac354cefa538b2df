"""The stages of `nscc tradeoff PROGRAM`: their points, from compile levels to decoders."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal
from functools import cache, partial

import numpy as np

from nscc.arrays import Array, Ints32
from nscc.diagnostics.diagnostic import Rejected
from nscc.limits.families import MOST_DIGITS, book_text
from nscc.lower.exposure_plan import LOWERINGS
from nscc.pipeline import KINDS, Compiled
from nscc.program.problems import counted
from nscc.source import Source
from nscc.syntax.parse import parse
from nscc.syntax.tree import EqualSlots, ListedSlots
from nscc.words.container import Container
from nscc_runtime.effects import everything, selected
from nscc_runtime.effects.effect import MOST_E
from nscc_runtime.looked_light import DEVIATION, LIGHT, OPEN, merged_image
from nscc_runtime.merge import light_estimate, readouts
from nscc_runtime.planning.audit import audit
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan import Plan, PlanRequest
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.planning.tolerance import LEAST_E
from nscc_runtime.reference.capture import Reference, reference_scene
from nscc_runtime.response import response_of
from nscc_runtime.run_kinds import refuse_planless
from nscc_runtime.simulate import Simulated
from nscc_training.experiments.engine import Figures
from nscc_training.experiments.study import NotMeasured, StudyPoint, timed_ms
from nscc_training.reconstruct_any import gap_tv_clip
from nscc_training.sweep.point_programs import whole_ticks
from nscc_training.tradeoff.emulator import unknown
from nscc_training.tradeoff.joint_bench import PERCENT, Bench, rms_percent, scaled_text

JOINED = {1: "all", 2: "halves", 4: "quarters"}
"""Names of programs in which this many neighbouring slots are joined into one."""
LENGTHS = (0.25, 0.5, 1.0, 2.0)
"""Frame lengths relative to the program's own."""
PARTS = (0.1, 0.3, 1.0, 3.0)
"""Tolerances of plans, as fractions of the target error."""
COMPARED = 1 << 20
"""Most slots times pixels that the reference simulates."""


def refused(stage: str, setting: str, why: Exception) -> StudyPoint:
    """Return a point that raises `why` instead of measuring, so that the table lists its reason. A
    `setting` of "" stands for the whole stage."""

    def refuse() -> Figures:
        """Raise the error that prevents the point."""
        raise why

    return StudyPoint(stage, "", setting, refuse)


def compiling(bench: Bench) -> Iterator[StudyPoint]:
    """Yield a point of the study for each optimisation level of the request. Its time is that of
    compiling, from text to proof and without the cache. Its error, in percent, is that of the
    compiled program's frame."""

    def figures(level: int, compiled: Compiled) -> Figures:
        """Return error, lowering (a way to compute the exposure) and number of words of the
        program, compiled at this level."""
        container = bench.with_codes(compiled)
        return {
            PERCENT: bench.error_percent(container),
            "method": container.notes.get("lowering", ""),
            "setting": f"-O{level} ({container.words_per_frame} words)",
        }

    for level in bench.request.levels:
        run = partial(bench.compiled, bench.source, level=level)
        yield StudyPoint("compile", "", f"-O{level}", run, partial(figures, level))


def lowering(bench: Bench) -> Iterator[StudyPoint]:
    """Yield a point for each lowering, the way in which the exposure is computed from photodiode
    values (accumulate, latch, edges). Its time is that of the shortest frame that the words allow.

    Raise NotMeasured if the program has only one lowering."""
    source, subject = bench.source, KINDS.of(bench.container).one_lowering_for
    if subject:
        raise NotMeasured(f"there is one way for {subject}")

    def measured(name: str) -> Figures:
        """Return the error, the time of the shortest frame in ms, and the number of words of the
        program with the lowering `name`. A lowering is a way to compute the exposure."""
        compiled = bench.compiled(source, lowering=name)
        container = bench.with_codes(compiled)
        return {
            PERCENT: bench.error_percent(container),
            "ms": [compiled.shortest_slot_us * container.slots / 1e3],
            "setting": f"{container.words_per_frame} words",
        }

    for name in LOWERINGS:
        yield StudyPoint("lowering", name, "", partial(measured, name))


def slots(bench: Bench) -> Iterator[StudyPoint]:
    """Yield a point for each frame length with the program's own slots, and with fewer slots. The
    shortest length is the one that the words allow.

    The scene has the same brightness in all cases, so that a shorter frame receives less light. A
    program with fewer slots opens a pixel in a joined slot if the original is open for at least
    half of it. Its error is measured from the ideal frame of the original with the same frame
    length."""
    text, original = bench.source, bench.container
    frame_us = sum(original.slot_us)
    for join, name in JOINED.items():
        count, setting = original.slots // join, name
        try:
            source, codes = in_fewer(original, join, text) if join > 1 else (text, None)
            setting = f"{count} slots"
            least_us = whole_ticks(bench.compiled(source).shortest_slot_us) * count
        except (NotMeasured, Rejected) as why:
            yield refused("slots", setting, why)
            continue
        lengths_us = (frame_us * length for length in LENGTHS if frame_us * length >= least_us)
        for whole_us in dict.fromkeys((least_us, *lengths_us)):
            timed = replace(
                original, slot_us=tuple(us / frame_us * whole_us for us in original.slot_us)
            )
            slot_us = np.array(timed.slot_us).reshape(-1, join).sum(axis=1).tolist()
            uneven = not np.allclose(slot_us, slot_us[0])
            setting = f"{whole_us / count:.5g} us" + " in the mean" * uneven
            run = partial(_joined, bench, with_slot_us(source, slot_us), codes, timed)
            yield StudyPoint("slots", f"{count} slots", setting, run)


def _joined(
    bench: Bench, source: Source, codes: dict[str, Ints32] | None, timed: Container
) -> Figures:
    """Return the error of the program `source` and the time of its frame in ms.

    `codes` are those of its pixels, None for the program's own. `timed` is the original with the
    same frame length, which gives the ideal frame."""
    container = bench.with_codes(bench.compiled(source), codes)
    return {PERCENT: bench.error_percent(container, timed), "ms": [sum(timed.slot_us) / 1e3]}


def effects(bench: Bench) -> Iterator[StudyPoint]:
    """Yield points for plans of several tolerances, for all effects, and for the reference. Their
    time is that of emulating a frame.

    Errors are those of the audit: differences from all effects with the same random numbers. Raises
    Rejected (NS0750) for a program without plans, which is simulated with all effects."""
    container, request = bench.container, bench.request
    refuse_planless(container, "comparing tolerances")
    height, cols = bench.light.shape
    # The reference is slow, so it runs only as many rows as a fixed amount of work allows.
    rows = range(min(height, max(1, COMPARED // (container.slots * cols))))
    if len(rows) < height:
        bench.notes.append(
            f"effects: the reference ran {len(rows)} of {height} rows: its time is theirs scaled "
            "to all"
        )
    ways = [("auto", tolerance) for tolerance in _tolerances(bench)]
    ways.append(("all", scaled_text(request.target_error, 1.0)))

    def planning() -> PlannedScene:
        """Return the scene for a plan (the effects that are simulated). Its light has no stored
        sums, because computing them is part of the frame's time."""
        light = unknown(bench.light)
        return PlannedScene(container, bench.sensor, light, request.device_seed)

    def made_plan(scene: PlannedScene, chosen: str, tolerance: str) -> Plan:
        """Make the plan for `chosen` effects ("auto" or "all") and a tolerance."""
        return make_plan(scene, PlanRequest(selected(chosen), tolerance))

    plans = {way: cache(partial(made_plan, planning(), *way)) for way in ways}

    def planned(way: tuple[str, str]) -> None:
        """Expose a frame with a plan that exists before the time is measured. `way` is the choice
        of effects and the tolerance."""
        next(iter(planning().frames(plans[way]().kept, request.seed, 1)))

    def with_planning(way: tuple[str, str]) -> None:
        """Make a plan and expose a frame with it. `way` is the choice of effects and the
        tolerance."""
        scene = planning()
        next(iter(scene.frames(made_plan(scene, *way).kept, request.seed, 1)))

    scene = PlannedScene(container, bench.sensor, bench.light, request.device_seed)

    @cache  # both ways to expose share the error of their plan
    def figures(way: tuple[str, str], _exposed: None) -> Figures:
        """Return the measured error of the plan for a choice of effects and a tolerance, in percent
        of the mean signal, by name."""
        return {PERCENT: 100.0 * audit(scene, plans[way]()).measured_rms_e / bench.signal_e()}

    for method, run in (("with planning", with_planning), ("planned", planned)):
        for way in ways:
            measured = partial(figures, way)
            yield StudyPoint(
                "effects", method, " ".join(way), partial(run, way), measured, loads=way
            )
    yield StudyPoint("effects", "reference", "all", partial(_reference, bench, rows))


def _reference(bench: Bench, rows: range) -> Figures:
    """Return the figures of the reference: no error, and the time of a frame, estimated from the
    time of some `rows`."""
    reference = Reference.of(bench.container, bench.sensor, everything())
    scene, planes = reference_scene(bench.container, bench.light), bench.container.planes()
    seeds = bench.request.seed, bench.request.device_seed
    run = partial(reference.execute, scene, planes, seeds, 0, rows)
    run()
    ms = timed_ms(run)[1] * bench.light.shape[0] / len(rows)
    return {PERCENT: 0.0, "ms": [ms]}


def _tolerances(bench: Bench) -> list[str]:
    """Return the fractions `PARTS` of the target error as texts of tolerances. A tolerance outside
    the allowed range is replaced by the nearest limit, which a note of `bench` says."""
    target = bench.target
    tolerances = dict[str, None]()
    for share in PARTS:
        tolerance = scaled_text(bench.request.target_error, share)
        electrons = share * target.electrons
        nearest = min(max(electrons, LEAST_E), MOST_E)
        if nearest != electrons:
            text = f"effects: no plan is made for {tolerance}: {nearest:g}e stands for it"
            bench.notes.append(text)
            tolerance = f"{nearest:g}e"
        tolerances[tolerance] = None
    return [*tolerances]


def with_slot_us(source: Source, slot_us: Sequence[float]) -> Source:
    """Return the program `source` in which the first frame statement is replaced: its slots have
    the lengths `slot_us` in microseconds, whose number may differ from before. Raise ValueError if
    its text has no frame statement."""
    tree, _ = parse(source)
    spans = [s.span for s in tree.statements if isinstance(s, EqualSlots | ListedSlots)]
    if not spans:
        raise ValueError(f"{source.name} has no frame")
    times = [f"{Decimal(repr(float(us))):f}us" for us in slot_us]
    frame = f"frame {len(times)} slots of {times[0]}"
    if len(set(times)) > 1:
        frame = f"frame slots [{', '.join(times)}]"
    text = source.text
    return Source(source.name, text[: spans[0].start] + frame + text[spans[0].end :])


def in_fewer(container: Container, join: int, source: Source) -> tuple[Source, dict[str, Ints32]]:
    """Return a program in which each slot joins `join` successive slots of a program, and the codes
    of its pixels: `id`, int32 (rows, cols).

    `container` is the compiled program and `source` its text, which gives the name. A joined slot
    is open if the pixel is open for at least half of its time. Raises NotMeasured if the slots
    cannot be joined, pixels have no codes, or there are too many shutters for a codebook."""
    codes, slots = container.pixel_codes, container.slots
    if codes is None or not KINDS.of(container).shutters_known:
        raise NotMeasured("programs with pixels that look keep their own slots")
    if slots % join:
        raise NotMeasured(f"{slots} slots are not a multiple of {join}")
    if slots // join < 2:
        raise NotMeasured(f"fewer than 2 of {slots} slots would remain")
    slot_us = np.array(container.slot_us).reshape(-1, join)
    used, row = np.unique(container.table.shutter_of_code[codes], return_inverse=True)
    opened = container.table.shutters[used].reshape(len(used), -1, *slot_us.shape)
    share = (opened * slot_us).sum(axis=3) / slot_us.sum(axis=1)
    rows, same = np.unique(share >= 0.5, axis=0, return_inverse=True)
    if rows.size > MOST_DIGITS:
        raise NotMeasured(
            f"{len(rows)} shutters are a codebook of {rows.size} digits, more than {MOST_DIGITS}"
        )
    if (rows.sum(axis=1) > 1).any():
        raise NotMeasured("two buckets would be open in one slot, each for half of it")
    text = book_text(slot_us.sum(axis=1).tolist(), container.buckets, rows)
    ids = same.reshape(-1)[row].reshape(codes.shape).astype(np.int32)
    return Source(source.name, text), {"id": ids}


CLIP_VALUES = 1 << 18
"""Most slots times pixels of a decoded clip; of larger clips the middle of the array is decoded."""
TV_ITERATIONS = (10, 40)
"""Numbers of iterations of GAP-TV that are compared."""
ANY_STAGES = (2, 8)
"""Numbers of stages of the decoder for any code that are compared."""


def decoding(bench: Bench) -> Iterator[StudyPoint]:
    """Yield the points of all decoders that suit the program, with several settings. Their time is
    that of decoding one frame with all effects.

    The result is a picture if all shutters open at the start of the frame or pixels look, else a
    clip, as in `nscc reconstruct any`. Raises ModuleNotFoundError if torch is needed and missing.
    """
    if LIGHT in bench.capture.frame.told:
        yield from _of_looks(bench, bench.capture)
    else:
        yield from _of_codes(bench, bench.capture)


def _point(
    method: str, setting: str, run: Callable[[], Array], truth: Array, loads: str = ""
) -> StudyPoint:
    """Return the point of a decoder, called `method` with `setting`. `run` returns an estimate of
    `truth` (T, rows, cols); its error is a percentage of the mean light.

    `loads` differs with what the first run loads, which is not timed."""

    def figures(light: Array) -> Figures:
        """Return the RMS error of decoded light as a percentage of the mean light, over pixels
        whose light is known (finite)."""
        light_e, truth_e = np.asarray(light, np.float64), np.asarray(truth, np.float64)
        known = np.isfinite(light_e)
        signal_e = float(truth_e.mean())
        return {PERCENT: rms_percent(light_e[None], truth_e[None], known[None], signal_e)}

    return StudyPoint("decoder", method, setting, run, figures, loads=loads)


def _of_looks(bench: Bench, capture: Simulated) -> Iterator[StudyPoint]:
    """Yield the points of decoders for pixels that look at their light: the exposure divided by the
    open time, and the program's run if it has one."""
    frame_s = sum(bench.container.slot_us) * 1e-6
    arrays = capture.frame.told
    truth = np.asarray(bench.light.total_e())[None]

    def run() -> Array:
        """Return the light that the pixels measured, in electrons over the frame."""
        return merged_image(arrays[LIGHT], arrays[DEVIATION])[None] * frame_s

    yield _point("exposure over time", "", run, truth)
    yield from _of_run(bench, capture, truth)


def _of_codes(bench: Bench, capture: Simulated) -> Iterator[StudyPoint]:
    """Yield the points of decoders for fixed shutters: merging for a still or GAP-TV for a clip,
    the decoder for any code, and the program's run if it has one.

    Large clips are decoded on the middle of the array only; a note of `bench` says so."""
    from nscc_training.any_code.decode import decoded_clip, decoded_still
    from nscc_training.any_code.frames import coded_capture
    from nscc_training.any_code.stages import STILL_STAGES

    container, light = bench.container, bench.light
    coded = coded_capture(container, light, bench.sensor, capture)
    if coded.is_still:
        truth = np.asarray(light.total_e())[None]
        yield _point("merged", "neighbours", partial(_merged, bench, capture), truth)
        still = coded.still().tensors()
        yield _point(
            "any", counted(STILL_STAGES, "stage"), lambda: decoded_still(still).numpy(), truth
        )
        yield from _of_run(bench, capture, truth)
        return
    middle = _middle(coded.row.shape, container.slots)
    if coded.row[middle].size < coded.row.size:
        rows, cols = (side.stop - side.start for side in middle)
        bench.notes.append(f"decoder: clips were decoded on the middle {rows} x {cols} pixels")
    cropped, clip = coded.crop(*middle), np.asarray(light.part(*middle).dense())
    # Slots may differ in length; the decoders reconstruct slots of equal length.
    slots = (cropped.slot_us / cropped.slot_us.mean()).astype(np.float32)[:, None, None]
    measured = cropped.clip()
    tensors = measured.tensors()

    def by_tv(iterations: int) -> Array:
        """Return the clip in electrons per slot, reconstructed by this number of iterations of
        GAP-TV."""
        return np.asarray(gap_tv_clip(measured, iterations) * slots)

    def by_any(stages: int) -> Array:
        """Return the clip in electrons per slot, reconstructed by this number of stages of the
        decoder for any code."""
        return np.asarray(decoded_clip(tensors, stages)[0].numpy() * slots)

    for count in TV_ITERATIONS:
        yield _point("gap-tv", f"{count} iterations", partial(by_tv, count), clip)
    for count in ANY_STAGES:
        yield _point("any", counted(count, "stage"), partial(by_any, count), clip)
    yield from _of_run(bench, capture, clip, middle)


def _merged(bench: Bench, capture: Simulated) -> Array:
    """Return the light over the frame in electrons (1, rows, cols): the mean of the readouts of the
    frame in `capture`, in each of which neighbours are merged. It is NaN where no readout has an
    estimate."""
    container = bench.container
    response = response_of(container, bench.sensor, capture.effects)
    estimates = [
        light_estimate(readout) for readout in readouts(container, capture.frame, response)
    ]
    frame_s = sum(container.slot_us) * 1e-6
    light = np.nanmean([np.where(known, estimate, np.nan) for estimate, known in estimates], axis=0)
    return np.asarray(light)[None] * frame_s


def _of_run(
    bench: Bench,
    capture: Simulated,
    truth: Array,
    region: tuple[slice, slice] = (slice(None), slice(None)),
) -> Iterator[StudyPoint]:
    """Yield the points of the decoder of the program's run in both number formats; none if the
    request names no run.

    The rows and columns `region` of the frame are decoded; `truth` is their light."""
    if bench.request.run is None:
        return
    import torch

    from nscc_training.loop.decoding import decoded_frame
    from nscc_training.run_folder import load_run

    folder = load_run(bench.request.run, trust_code=bench.request.trust_code)
    frame, opened = capture.frame, capture.frame.told.get(OPEN)
    rows, cols = region
    codes, full = frame.frame[0, rows, cols], frame.saturated[0, rows, cols]
    share = None if opened is None else (opened[0] / bench.container.slots).astype(np.float32)
    chosen = folder.setup.settings.decoder

    def run(dtype: str) -> Array:
        """Return the light that the run's network decodes in `dtype`, "bf16" or float32."""
        with torch.autocast(folder.setup.device.type, torch.bfloat16, enabled=dtype == "bf16"):
            decoded = decoded_frame(
                folder.setup, codes, full, share, (rows.start or 0, cols.start or 0)
            )
        return decoded[None] if folder.setup.still else decoded

    for dtype in ("f32", "bf16"):
        yield _point(f"{chosen.name} {chosen.sized}", dtype, partial(run, dtype), truth, dtype)


def _middle(shape: tuple[int, ...], slots: int) -> tuple[slice, slice]:
    """Return the rows and columns in the middle of an array of this shape that are decoded: a
    square whose side is a multiple of 16, with at most `CLIP_VALUES` values in `slots` slots, but
    at least 16 pixels wide. A smaller side of the array is kept whole."""
    side = max(16, int((CLIP_VALUES / slots) ** 0.5) // 16 * 16)
    region = []
    for length in shape:
        cropped_length = min(side, length)
        start = (length - cropped_length) // 2
        region.append(slice(start, start + cropped_length))
    return region[0], region[1]
