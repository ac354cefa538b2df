"""What a finished run leaves: the program, its codes, the decoder, and what they are worth."""

from __future__ import annotations

import json
import platform
from collections.abc import Callable
from dataclasses import replace
from hashlib import sha256
from typing import Any

import numpy as np
import torch

from nscc import __version__
from nscc.prove.shutters import shutters_of_pixels
from nscc.words.container import Container
from nscc_runtime.emulator import expose
from nscc_runtime.light import Light
from nscc_runtime.sensor import sensor_sha256
from nscc_training.config import config_toml
from nscc_training.data import Batches, Scenes
from nscc_training.decoders.make import flops, parameter_count
from nscc_training.encoders.looks import LOOKS
from nscc_training.least_squares import solve
from nscc_training.loop.looks import looking_codes, looking_stages
from nscc_training.loop.setup import Parts, started_encoder
from nscc_training.loop.steps import scored
from nscc_training.measures import decibels
from nscc_training.metrics import finite_mean, psnr
from nscc_training.programs import CODES_FILE, compiled, program_of, words_per_slot
from nscc_training.sensor_model import laid, read_out, shared_out
from nscc_training.settings import Settings

_CHANGES: tuple[tuple[str, dict[str, float], float], ...] = (
    ("as trained", {}, 1.0),
    ("full well -20 %", {"full_well_e": 0.8}, 1.0),
    ("full well +20 %", {"full_well_e": 1.2}, 1.0),
    ("electrons a code -20 %", {"electrons_per_lsb": 0.8}, 1.0),
    ("electrons a code +20 %", {"electrons_per_lsb": 1.2}, 1.0),
    ("noise x 2", {"noise_factor": 2.0}, 1.0),
    ("exposure x 0.5", {}, 0.5),
    ("exposure x 2", {}, 2.0),
)
"""Names, and factors: of the sensor's values, and of the exposure."""
_FEW_CHIPS = 2
"""Chips that stand for all where a sensor that is off is emulated."""


def artifacts(parts: Parts, batches: Batches, scenes: Scenes, step: int) -> dict[str, bytes]:
    """The files of a run by name; the parts are in their best state, reached at `step`."""
    from safetensors.torch import save

    container_of = compiled(program_of(parts.encoder, parts.chip), parts.chip)
    assert container_of.container is not None
    remark = (
        f"Shutters of class {parts.encoder.spec.kind}, learned by nscc train with the decoder "
        f"beside them\n(step {step}, seed {parts.settings.train.seed}, "
        f"protocol {parts.protocol.name})."
    )
    if not parts.settings.shutter.learn:
        remark = remark.replace("learned by nscc train with", "kept by nscc train, which learned")
    program = program_of(parts.encoder, parts.chip, remark)
    weights = save({k: v.contiguous() for k, v in parts.decoder.state_dict().items()})
    files = {"shutter.nsl": program.text.encode(), "decoder.safetensors": weights}
    if program.codes:
        files[CODES_FILE] = program.codes
    files |= parts.files
    files["capture.toml"] = capture_toml(parts).encode()
    val = batches.val()
    side, count = parts.settings.data.patch, sum(len(batch.peak) for batch in val)
    stages, codes = _stages(parts, batches, container_of.container), _codes_report(parts, batches)
    robustness = _robustness(parts, batches)
    result = {
        "schema": "nscc-run-1",
        "headline": _headline(parts, batches, robustness[0]),
        "protocol": parts.protocol.name,
        "protocol_sha256": parts.protocol.sha256,
        "config_sha256": config_digest(parts.settings),
        "split_sha256": split_digest(scenes),
        "step": step,
        "stages": stages,
        "stages_note": f"mean PSNR in dB of {count} validation patches of {side} x {side}, "
        "data range the patch's peak, without noise",
        "robustness": robustness,
        "words_per_slot": words_per_slot(container_of),
        "codes": codes,
        "parameters": parameter_count(parts.decoder),
        "flops": flops(parts.decoder, parts.slots, side, side, parts.buckets),
        "flops_size": [side, side],
        "files": {name: sha256(data).hexdigest() for name, data in sorted(files.items())},
    }
    files["result.json"] = lines_of(result)
    files["model_card.md"] = _card(parts, scenes, result).encode()
    return files


def environment(parts: Parts) -> dict[str, Any]:
    """Versions that the numbers depend on; no host, no time, no path."""
    return {
        "nscc": __version__,
        "python": platform.python_version(),
        "torch": torch.__version__,
        "numpy": np.__version__,
        "machine": platform.machine(),
        "device": parts.device.type,
    }


def lines_of(values: Any) -> bytes:
    """JSON as a file."""
    return (json.dumps(values, indent=2, allow_nan=False) + "\n").encode()


def config_digest(settings: Settings) -> str:
    """That of config.resolved.toml: everything that a run depends on."""
    return sha256(config_toml(settings).encode()).hexdigest()


def split_digest(scenes: Scenes) -> str:
    """That of split.json: the scenes that a run learns from and is chosen by."""
    return sha256(lines_of(scenes.split())).hexdigest()


def capture_toml(parts: Parts) -> str:
    """What a frame must have been made with for the decoder to understand it."""
    model, slots = parts.model, "" if parts.still else " / slots in a slot"
    values = {
        "sensor_sha256": sensor_sha256(parts.sensor),
        "full_well_e": model.full_well_e,
        "electrons_per_lsb": model.electrons_per_lsb,
        "adc_offset_lsb": model.adc_offset_lsb,
        "adc_bits": model.adc_bits,
        "slots": parts.slots,
        "slot_us": parts.chip.slot_us,
        "effects": parts.settings.sensor.effects,
        "scenes": "stills" if parts.still else "clips",
        "transfer": parts.settings.data.transfer,
        "exposure": _exposure(parts),
        "normalisation": f"1 is a full well{slots or ' over the frame'}",
    }  # fmt: skip
    head = "# What the decoder was trained on; `nscc reconstruct` refuses frames of something else."
    lines = [head, *(f"{key} = {json.dumps(value)}" for key, value in values.items())]
    return "\n".join(lines) + "\n"


def _exposure(parts: Parts) -> str:
    """How bright scenes are."""
    if parts.still:
        return "30 % of the pixels saturate when always open"
    grey_e = parts.protocol.mid_grey_e
    if grey_e is None:
        return "percentile 99 of the all-open sum is a full well"
    return f"the median of the all-open sum is {grey_e:.0f} e"


def _stages(parts: Parts, batches: Batches, container: Container) -> dict[str, Any]:
    """PSNR with soft, hard, compiled and emulated shutters on the same patches."""
    ideal, seed = parts.model.noiseless(), parts.settings.train.seed
    val = batches.val()
    if parts.encoder.spec.kind == LOOKS:
        return looking_stages(parts, val, container)
    with torch.no_grad():
        soft = parts.encoder.shutters(None, soft=True)
    found: dict[str, Any] = {}
    rows, cols = parts.encoder.spec.tile
    packed = shutters_of_pixels(container)["shutter"][:, :rows, :cols]
    opened = np.unpackbits(packed, axis=-1, count=parts.slots, bitorder="little")
    words = torch.from_numpy(opened.astype(np.float32).transpose(0, 3, 1, 2).copy())
    hard = parts.encoder.hard()
    for name, shutters in (("soft", soft), ("hard", hard), ("compiled", words[0])):
        found[name] = decibels(scored(parts, val, shutters, ideal, seed).psnr_db)
    found["emulated"] = decibels(_emulated(parts, batches, container))
    wanted = shared_out(hard.cpu(), parts.buckets).reshape(words.shape)
    found["compiled_equals_hard"] = bool(torch.equal(words, wanted))
    return found


@torch.no_grad()
def _emulated(parts: Parts, batches: Batches, container: Container) -> float:
    """PSNR from frames that the emulator exposed: the words, on the whole array.

    Of patches larger than the array the part that it holds.
    """
    rows, cols = container.target.rows, container.target.cols
    values = []
    tile, ideal = parts.encoder.hard(), parts.model.noiseless()
    patches = (batch.part(k, k + 1) for batch in batches.val() for k in range(len(batch.peak)))
    for batch in patches:
        patch = batch.light[0, ..., :rows, :cols].numpy()
        down, across = patch.shape[-2:]
        whole = np.zeros((*patch.shape[:-2], rows, cols), np.float32)
        whole[..., :down, :across] = patch
        if parts.still:
            light = Light.of_still(whole, np.full(parts.slots, 1.0 / parts.slots))
        else:
            light = Light.of_clip(whole)
        exposure = torch.from_numpy(expose(container, light).exposure_e[:, :down, :across].copy())
        if parts.buckets > 1:
            exposure = exposure[None]
        frame = ideal.relative(read_out(exposure, ideal) - ideal.adc_offset_lsb)
        shutters = laid(tile[:, :down, :across], down, across).to(parts.device)
        prediction = parts.decoder(frame.to(parts.device), shutters).float()
        truth, peak = batch.truth[0, ..., :rows, :cols], batch.peak.item()
        pair = [np.clip(x.cpu().numpy() / peak, 0, 1) for x in (truth, prediction[0])]
        values.append(psnr(pair[0], pair[1], 1.0))
    return finite_mean(values)


def _headline(parts: Parts, batches: Batches, trained: dict[str, Any]) -> dict[str, Any]:
    """What a run is worth on the sensor that it was `trained` under, and beside effects without."""
    effects = parts.settings.sensor.effects
    found = {"effects": effects, **{key: trained[key] for key in ("psnr_db", "ssim")}}
    if effects:
        settings = parts.settings
        bare = replace(settings, sensor=replace(settings.sensor, effects=""))
        alone = scored(replace(parts, settings=bare), batches.val(), parts.encoder.hard(),
                       parts.model, settings.train.seed)  # fmt: skip
        found |= {"noise_alone_psnr_db": decibels(alone.psnr_db), "noise_alone_ssim": alone.ssim}
    return found


def _robustness(parts: Parts, batches: Batches) -> list[dict[str, Any]]:
    """PSNR under a sensor and an exposure that are not those of training."""
    val, hard, seed = batches.val(), parts.encoder.hard(), parts.settings.train.seed
    found = []
    for name, factors, exposure in _CHANGES:
        values = {key: getattr(parts.model, key) * factor for key, factor in factors.items()}
        others = {key: value for key, value in values.items() if key in parts.sensor.values}
        where = parts
        if others and parts.settings.sensor.effects:
            where = replace(parts, sensor=parts.sensor.changed(**others), chips=_FEW_CHIPS)
        scores = scored(where, val, hard, replace(parts.model, **values), seed, exposure)
        found.append({"change": name, "psnr_db": decibels(scores.psnr_db), "ssim": scores.ssim})
    return found


def _codes_report(parts: Parts, batches: Batches) -> dict[str, Any]:
    """How many shutters there are, how far from dependent they are, at how many places of the tile
    they are not those that the run began with, and what these alone are worth to the decoder."""
    if parts.encoder.spec.kind == LOOKS:
        return looking_codes(parts)
    chosen = parts.settings.shutter
    seed = parts.settings.train.seed
    start = started_encoder(chosen, parts.chip, parts.target, seed)
    moved = (start.hard() != parts.encoder.hard().cpu()).any(dim=0)
    alone = scored(parts, batches.val(), start.hard(), parts.model, seed)
    shutters = parts.encoder.hard().reshape(parts.slots, -1).T.double().cpu().numpy()
    distinct = np.unique(shutters, axis=0)
    system = solve(distinct, np.zeros(len(distinct)))
    unused = getattr(parts.encoder, "unused_share", None)
    return {
        "places": len(shutters),
        "start": chosen.init,
        "moved": int(moved.sum()),
        "start_alone_psnr_db": decibels(alone.psnr_db),
        "shutters": len(distinct),
        "rank": system.rank,
        "condition": None if np.isinf(system.condition) else system.condition,
        "unused_share": None if unused is None else float(unused()),
    }


def _headline_text(found: dict[str, Any], db: Callable[[float | str], str]) -> str:
    """The headline of a run as a sentence."""
    score = f"{db(found['psnr_db'])} dB, SSIM {found['ssim']:.4f}"
    if not found["effects"]:
        return (
            f"**{score}** on validation patches under photon noise, readout noise and converter "
            "alone. It knows no other\neffects of a chip: `nscc evaluate RUN --effects all` says "
            "what they cost it."
        )
    alone = f"{db(found['noise_alone_psnr_db'])} dB, SSIM {found['noise_alone_ssim']:.4f}"
    return (
        f"**{score}** on validation patches under the emulated chip's effects (`{found['effects']}`"
        f"), which it was trained\nunder; {alone} under photon noise, readout noise and converter "
        "alone."
    )


def _card(parts: Parts, scenes: Scenes, result: dict[str, Any]) -> str:
    """The model card."""
    settings = parts.settings

    def db(value: float | str) -> str:
        return value if isinstance(value, str) else f"{value:.2f}"

    alone = ""
    if result["codes"]["moved"] and "start_alone_psnr_db" in result["codes"]:
        # Pixels that look have no such score: their report is another.
        alone = (f"\nBehind this decoder the start alone gives "
                 f"{db(result['codes']['start_alone_psnr_db'])} dB where these shutters give "
                 f"{db(result['robustness'][0]['psnr_db'])}.")  # fmt: skip
    stages = " | ".join(db(result["stages"][k]) for k in ("soft", "hard", "compiled", "emulated"))
    rows = "\n".join(f"| {r['change']} | {db(r['psnr_db'])} |" for r in result["robustness"])
    return f"""# Model card

{_headline_text(result["headline"], db)}

A decoder `{settings.decoder.name}` ({settings.decoder.sized}, {result["parameters"]} parameters)
and shutters of class {settings.shutter.kind} for `{settings.shutter.target}`: \
{settings.shutter.slots} slots of {settings.shutter.slot_us:g} us, \
{result["codes"]["shutters"]} shutters. Of {result["codes"]["places"]} places \
{result["codes"]["moved"]} moved from the start, `{result["codes"]["start"]}`.{alone}

* **For** {"stills of high dynamic range" if parts.still else "clips from one exposure"} as the
  protocol {parts.protocol.name} exposes them; `capture.toml` says how. Frames of another program
  or sensor mean nothing to it.
* **Trained** for {settings.train.steps} steps of {settings.train.batch} patches of \
{settings.data.patch} x {settings.data.patch}, loss {settings.loss.name}, seed \
{settings.train.seed}, on {len(scenes.train)} scenes; validated on {len(scenes.val)} others \
(`split.json`).
* **Not** measured here: other scenes than those of validation. `nscc evaluate` does that.

PSNR in dB of the validation patches without noise, with the shutters of four stages:

| soft | hard | compiled | emulated |
|---|---|---|---|
| {stages} |

With noise, and with a sensor or exposure that it was not trained for:

| change | PSNR in dB |
|---|---|
{rows}
"""
