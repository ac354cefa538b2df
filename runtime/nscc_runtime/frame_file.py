"""The frame file: the result of one exposure (or of K exposures), as an .npz of a fixed layout.

    frame         uint8   (buckets, rows, cols)  the readout: 8 bits per pixel
    exposure_e    float64 (buckets, rows, cols)  electrons before the ADC
    valid         bool    (buckets, rows, cols)  False where the exposure is meaningless
    saturated     bool    (buckets, rows, cols)  True where light was lost: a lower bound
    saturated_by  uint8   (buckets, rows, cols)  the causes as bits: 1 well, 2 register,
                                                 4 converter, 8 reset level, 16 black sun
    meta          text    JSON, see `meta`

A program with images and planes also has, for every image that it reads, `image_NAME` float64
(rows, cols), electrons before the converter, `image_codes_NAME` uint8 and `image_saturated_by_NAME`
uint8 (32: a value left the range of registers). For every plane it has `plane_NAME` bool, for
states with a range `states_NAME` int64 and the plane of each bit, `plane_NAME 0` and so on, for
reports `report_any_NAME`, `report_events_NAME` (with `_count` and `_overflow`) and
`report_box_NAME`, and `margin` bool: pixels that depend on light beyond the array. `frame` then
contains the buckets that the program reads, possibly none. `image_unit` in `meta` has the electrons
of a count for every image of counts that is read.

A program whose pixels look at the light has `states_NAME` int64 (rows, cols) for every state that
it reads, `open_slots` int64 (buckets, rows, cols), the number of slots in which each pixel was
open, and `light_e_per_s` and `light_sd_e_per_s` float64 (buckets, rows, cols), the light estimated
from these and its standard deviation.

With K repeats these arrays have a leading axis K. On request there are also: `light` float32 (N,
rows, cols); `truth_e`, the light of all slots, float64 (rows, cols) of a still or the `light` of a
clip; `shutter` uint8 (buckets, rows, cols, ceil(N / 8)), packed along N with the first slot in the
lowest bit, and `shutter_shape` = (buckets, rows, cols, N); `codes_FIELD` int64 (rows, cols).
`nscc_runtime.response` describes the arrays `decode_..` for decoders.

Equal frames give equal bytes: the archive contains no times, and its entries have a fixed order."""

from __future__ import annotations

import json
import zipfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import IO, Any, Protocol

import numpy as np

from nscc.arrays import Array, Bools, Bytes, Floats
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import rejected
from nscc.mappings import JsonObject
from nscc.words.container import Container, fields_at_pixels, packed_shutters
from nscc_runtime.effects import Selection, everything, marks, registered
from nscc_runtime.effects.parts import Moving
from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.light import Light
from nscc_runtime.progress import Progress, unseen
from nscc_runtime.readout_loop import ReadoutErrors
from nscc_runtime.readout_noise import ReadoutNoise
from nscc_runtime.run_kinds import KINDS
from nscc_runtime.sensor import Sensor, default_sensor, sensor_sha256

SCHEMA = "nscc-frame-1"
KEEP = ("light", "truth", "shutter", "codes")
_MOST_BITS = 8
"""Largest number of bits of an ADC: `frame` is uint8."""
_BLOCK_BYTES = 1 << 24


@dataclass(frozen=True, eq=False)
class Frame:
    """The arrays of a frame file, each (buckets, rows, cols); repeats have a leading axis K.

    `frame`: converter codes. `exposure_e`: electrons before the converter. `valid`: False where
    these are meaningless. `saturated_by`: causes of saturation as bits, 0 if not saturated. 1 well:
    PIX (the photodiode) was full when it was read. 2 register: an analog register stored less than
    was written to it. 4 converter: the code is the last code. 8 reset level: PIX was full when the
    subtracted level was read, so the exposure may be anything down to 0. 16 black sun: that level
    was a reset level. `told`: further arrays of a program that looks (`states_NAME`, `open_slots`,
    its light) or that has images, by key."""

    frame: Bytes
    exposure_e: Floats
    valid: Bools
    saturated_by: Bytes
    told: Mapping[str, Array] = field(default_factory=dict, kw_only=True)

    @property
    def saturated(self) -> Bools:
        """Mask (buckets, rows, cols) of pixels that received more light than `exposure_e` tells."""
        return np.asarray(self.saturated_by != 0)

    @property
    def first(self) -> Frame:
        """The first frame along the leading axis of repeats or colours; a single frame is returned
        unchanged."""
        return self if self.frame.ndim == 3 else joined([self], lambda arrays: arrays[0][0])


def read_out(
    exposure: Exposure,
    target: Target,
    sensor: Sensor | None = None,
    noise_lsb: ReadoutErrors | Floats | float = 0.0,
) -> Frame:
    """Convert an exposure to converter codes, with the noise `noise_lsb`, in codes, before
    rounding: an array, one number, or errors to be drawn.

    frame = clip(round_half_even(exposure_e / electrons_per_lsb + noise_lsb) + offset, 0, top code),
    with the values of `sensor` (None: the target's defaults). NaN becomes 0 and is not valid;
    infinities become the ends of the scale. Raises Rejected (NS0742) for a target whose ADC has
    more than 8 bits."""
    sensor = sensor or default_sensor(target)
    check_adc(target)
    (codes_of,) = everything().at("codes")
    exposure_e = exposure.exposure_e
    frame = codes_of(sensor, exposure_e, noise_lsb, target.top_code)
    saturated_by = last_codes(frame, target)
    if exposure.saturated_by is not None:
        saturated_by |= exposure.saturated_by
    return Frame(frame, exposure_e, exposure.valid & (exposure_e == exposure_e), saturated_by)


def last_codes(frame: Bytes, target: Target) -> Bytes:
    """Return an array like `frame` (converter codes) with saturation marks. A mark is the
    converter's bit of `saturated_by` where a code is the largest of `target`, else 0."""
    bit = marks()["codes"].bit
    return np.asarray((frame == target.top_code).view(np.uint8) * np.uint8(bit))


def converted(
    exposure: Exposure,
    target: Target,
    sensor: Sensor,
    effects: Selection,
    seeds: tuple[int, int],
    number: int,
) -> Frame:
    """Convert the exposure of frame `number` to converter codes, with the converter's noise
    if `effects` include it. `seeds`: noise seed, device seed. NaN becomes code 0 and is not valid.
    Raises Rejected (NS0742) for a target whose ADC has more than 8 bits."""
    buckets, *shape = exposure.exposure_e.shape
    noise = ReadoutNoise.of(sensor, effects, seeds[1], (shape[0], shape[1]))
    return read_out(exposure, target, sensor, noise.drawn(seeds[0], number, buckets))


def check_adc(target: Target) -> None:
    """Raise Rejected (NS0742) if the ADC of `target` has more bits than a frame file supports."""
    if target.adc_bits > _MOST_BITS:
        raise rejected(
            "NS0742",
            f"the ADC of target '{target.name}' has {target.adc_bits} bits, but a frame "
            f"file supports {_MOST_BITS}",
            helps=(f"set adc_bits to at most {_MOST_BITS} in the target's [range]",),
            data={"required": target.adc_bits, "available": _MOST_BITS},
        )


ARRAYS = ("frame", "exposure_e", "valid", "saturated_by")
"""Names of the arrays of every frame, without those of `Frame.told`."""


def joined(frames: Sequence[Frame], join: Callable[[list[Array]], Array]) -> Frame:
    """Return the frame each of whose arrays is `join(arrays)`, such as `numpy.stack`, where
    `arrays` lists the same array of all `frames`. There is at least one frame, and all have the
    arrays `told` of the first."""
    return Frame(
        *(join([getattr(frame, name) for frame in frames]) for name in ARRAYS),
        told={key: join([frame.told[key] for frame in frames]) for key in frames[0].told},
    )


def repeated(frame: Frame, count: int) -> Frame:
    """Return the frame `count` times with a leading axis: frames without effects are equal. The
    arrays are read-only views, so the copies take no memory."""
    return joined([frame], lambda arrays: np.broadcast_to(arrays[0], (count, *arrays[0].shape)))


class WrittenAsJson(Protocol):
    """A value with a form for JSON."""

    def as_json(self) -> JsonObject: ...


@dataclass(frozen=True)
class Provenance:
    """The origin of a frame. `program_sha256`: digest of the container (a compiled program).
    `sensor`: of the simulation or, for a device, the one that is assumed. Seeds are None if nothing
    was simulated. `fidelity`: "reference" for a frame of the reference with effects; "planned" for
    any other simulated frame, also without a plan; or how else the frame was made. `plan`: JSON
    values, or a plan (the effects that are simulated), which is converted when it is written.
    `audit`: JSON values. Both are None if there is none."""

    program_sha256: str
    sensor: Sensor
    seed: int | None = 0
    device_seed: int | None = 0
    fidelity: str = "planned"
    plan: Mapping[str, Any] | WrittenAsJson | None = None
    audit: Mapping[str, Any] | None = None
    params: tuple[Mapping[str, float], ...] = ()
    """The parameters that the host set before each frame, levels in electrons."""


_UNPLANNED = (
    "tolerance",
    "tolerance_e",
    "predicted_e",
    "bound_e",
    "worst_e",
)
"""Keys of a plan that are None in a run without a plan."""


def unplanned(
    chosen: Selection,
    moving: bool,
    word_reasons: Sequence[str],
    absent: Mapping[str, str] = MappingProxyType({}),
) -> JsonObject:
    """Return the `plan` entry of a run without a plan: the keys of a plan, with None for what only
    plans have, and a row for every effect.

    `chosen`: the selected effects. `moving`: whether the light moves within slots. `word_reasons`:
    why pixels run through their words (`Exposing.word_reasons`). `absent`: names of effects that
    the chip cannot have, with the reason, which has priority over others."""
    nothing = ("predicted_rms_e", "predicted_bias_e", "predicted_if_dropped_e", "cost_ms_model")
    rows = []
    # Later conditions override earlier ones: an effect that is absent cannot have been simulated.
    for effect in registered():
        decision = "kept" if effect in chosen else "dropped"
        reason = "part of --effects all" if effect in chosen else "not in --effects"
        if effect.name in chosen.forced:
            reason = "named in --effects"
        if effect in chosen and not moving and effect.parts_of_kind(Moving):
            decision, reason = "absent", effect.absent
        if effect.always:
            reason = "always applied"
        if effect.name in absent:
            decision, reason = "absent", absent[effect.name]
        rows.append(
            {
                "name": effect.name,
                "kind": effect.kind,
                "decision": decision,
                "forced": effect.name in chosen.forced,
                "reason": reason,
                **dict.fromkeys(nothing),
            }
        )
    return {
        **dict.fromkeys(_UNPLANNED),
        "slot_loop": bool(word_reasons),
        "slot_loop_reasons": [*word_reasons],
        "sampled_fraction": 0.0,
        "effects": rows,
    }


def meta(
    container: Container | None, light: Light | None, frame: Frame, origin: Provenance
) -> JsonObject:
    """Return the `meta` of the frame file of `frame`, values for JSON by key.

    `container`: the program, None for an unknown program on a device, whose buckets are numbered.
    `light`: None if the scene is unknown. Keys whose value is not known are None; `image_unit`,
    `frame_us` and `params` are left out where they do not apply."""
    sensor, plan = origin.sensor, origin.plan
    numbered = [f"bucket{number}" for number in range(frame.frame.shape[-3])]
    return {
        "schema": SCHEMA,
        "program_sha256": origin.program_sha256,
        "scene_sha256": light.sha256() if light else None,
        "sensor_sha256": sensor_sha256(sensor),
        "sensor": dict(sensor.values),
        "seed": origin.seed,
        "device_seed": origin.device_seed,
        "fidelity": origin.fidelity,
        "lowering": container.notes.get("lowering") if container else None,
        "buckets": list(container.buckets_read) if container else numbered,
        "electrons_per_lsb": sensor.electrons_per_lsb,
        "adc_offset": sensor.adc_offset_lsb,
        "exposure_scale_e": light.exposure_scale_e if light else None,
        "open_us": open_us(container) if container else None,
        **({"image_unit": unit} if container and (unit := image_unit(container)) else {}),
        **(
            {"frame_us": float(sum(container.slot_us))}
            if container and not KINDS.of(container).open_times_known
            else {}
        ),
        "invalid_pixels": frame.valid.size - int(np.count_nonzero(frame.valid)),
        "plan": plan if plan is None or isinstance(plan, Mapping) else plan.as_json(),
        "audit": origin.audit,
        **({"params": [*map(dict, origin.params)]} if any(origin.params) else {}),
    }


def image_unit(container: Container) -> dict[str, float]:
    """Return, for each image of counts that `container` reads out, how many electrons one count
    stands for, by name; empty if there is none."""
    from nscc.words.counts import counts_by_name

    pictures = container.pictures
    unit_e = pictures.count_steps * container.target.electrons_per_step
    return {name: unit_e for name in counts_by_name(pictures) if name in pictures.reads}


def open_us(container: Container) -> list[float] | None:
    """Return the open time of each bucket in microseconds, in the container's order of buckets.
    None if it differs between pixels, depends on their light, or pixels have no codes."""
    if container.pixel_codes is None or not KINDS.of(container).open_times_known:
        return None
    lanes = np.unique(container.table.shutter_of_code[container.pixel_codes])
    times = container.table.shutters[lanes] @ np.array(container.slot_us, np.float64)
    same = bool(np.all(times == times[0]))
    return [float(time) for time in times[0]] if same else None


@dataclass(frozen=True, eq=False)
class FrameFile:
    """The content of a frame file. `meta`: values for JSON, see the function `meta`. `kept_arrays`:
    additional arrays by key. `slots`: light that is written slot by slot, by key. `progress`: shows
    how far writing is."""

    frame: Frame
    meta: Mapping[str, Any]
    kept_arrays: Mapping[str, Array]
    slots: Mapping[str, Light]
    progress: Progress = unseen

    @classmethod
    def of(
        cls,
        container: Container,
        light: Light | None,
        frame: Frame,
        meta: Mapping[str, Any],
        keep: Sequence[str] = (),
        shutters: Bools | None = None,
        progress: Progress = unseen,
    ) -> FrameFile:
        """Return the file of `frame`, with the further contents named in `keep`: "light", "truth",
        "shutter", "codes".

        If `light` is None, "light" and "truth" are left out, and without `shutters` (bool (distinct
        shutters, buckets, N), in the order of the decode table) so is "shutter". `progress` shows
        how far writing is."""
        kept_arrays: dict[str, Array] = {}
        slots: dict[str, Light] = {}
        if light is not None and "light" in keep:
            slots["light"] = light
        if light is not None and "truth" in keep:
            if light.kind == "still":
                kept_arrays["truth_e"] = light.total_e()
            else:
                slots["truth_e"] = light
        if "shutter" in keep and shutters is not None:
            packed, shape = packed_shutters(container, shutters)
            kept_arrays |= {"shutter": packed, "shutter_shape": shape}
        if "codes" in keep:
            kept_arrays |= fields_at_pixels(container)
        return cls(frame, meta, kept_arrays, slots, progress)

    def write(self, file: IO[bytes]) -> None:
        """Write the archive to `file`, a binary file at its start: light slot by slot and repeats
        block by block, to limit memory. Raises ValueError for NaN or infinity in the meta."""
        with zipfile.ZipFile(file, "w", zipfile.ZIP_STORED) as archive:
            for key in ("frame", "exposure_e", "valid"):
                _write_array(archive, key, getattr(self.frame, key))
            marked = self.frame.saturated_by
            blocks = (block != 0 for block in marked)  # one repeat at a time, to limit memory
            _write_entry(archive, "saturated", marked.shape, np.dtype(np.bool_), blocks)
            _write_array(archive, "saturated_by", marked)
            for key, values in self.frame.told.items():
                _write_array(archive, key, values)
            _write_array(archive, "meta", np.array(json.dumps(self.meta, allow_nan=False)))
            for key, light in self.slots.items():
                shape = (light.slots, *light.shape)
                numbers = self.progress(range(light.slots), f"writing {key}", light.slots)
                _write_entry(archive, key, shape, np.dtype("<f4"), (light.slot(n) for n in numbers))
            for key, values in self.kept_arrays.items():
                _write_array(archive, key, values)


def _write_array(archive: zipfile.ZipFile, key: str, values: Array) -> None:
    """Write the array `values` to the archive as the entry KEY.npy; one above `_BLOCK_BYTES` in
    blocks along its first axis, because a block is copied."""
    one_block = values.ndim == 0 or values.nbytes <= _BLOCK_BYTES
    _write_entry(archive, key, values.shape, values.dtype, iter([values] if one_block else values))


def _write_entry(
    archive: zipfile.ZipFile,
    key: str,
    shape: tuple[int, ...],
    dtype: np.dtype[Any],
    blocks: Iterator[Array],
) -> None:
    """Write an array with `shape` and `dtype` as the entry KEY.npy of `archive`: row-major,
    little-endian, dated 1980. `blocks` yields its values in order."""
    little = dtype.newbyteorder("<")
    entry = zipfile.ZipInfo(f"{key}.npy")
    # Permissions of the entry, the same on every system; its date is the default of ZipInfo, 1980.
    entry.external_attr = 0o600 << 16
    with archive.open(entry, "w", force_zip64=True) as out:
        header = {"descr": little.str, "fortran_order": False, "shape": shape}
        np.lib.format.write_array_header_1_0(out, header)
        for block in blocks:
            out.write(np.ascontiguousarray(block, little).tobytes())
