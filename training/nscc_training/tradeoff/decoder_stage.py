"""The decoder stage: reconstruct one frame with every suitable decoder."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from nscc.arrays import Array
from nscc_runtime.looked_light import DEVIATION, LIGHT, OPEN, merged_image
from nscc_runtime.merge import light_estimate, readouts
from nscc_runtime.response import response_of
from nscc_runtime.simulate import Simulated
from nscc_training.experiments.engine import Figures
from nscc_training.experiments.study import StudyPoint
from nscc_training.reconstruct_any import gap_tv_clip
from nscc_training.tradeoff.joint_bench import PERCENT, Bench, rms_percent

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
        yield _point("any", _stages(STILL_STAGES), lambda: decoded_still(still).numpy(), truth)
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
        yield _point("any", _stages(count), partial(by_any, count), clip)
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


def _stages(count: int) -> str:
    """Return a number of stages as text: "1 stage", "2 stages"."""
    return f"{count} stage{'s' * (count > 1)}"


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
