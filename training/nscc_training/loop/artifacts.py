"""What a finished run leaves: the program, its codes, the decoder, and what they are worth."""

from __future__ import annotations

import json
import platform
from collections.abc import Callable, Sequence
from dataclasses import replace
from hashlib import sha256
from typing import Any

import numpy as np
import torch

from nscc import __version__
from nscc.prove.shutters import shutters_of_pixels
from nscc.words.container import Container
from nscc_runtime.sensor import sensor_sha256
from nscc_training.config import config_toml
from nscc_training.data import Scenes
from nscc_training.decoders.make import flops, parameter_count
from nscc_training.encoders.looks import LOOKS
from nscc_training.least_squares import solve
from nscc_training.loop.decoding import scene_by_words
from nscc_training.loop.setup import Parts, started_encoder
from nscc_training.loop.validation import as_trained, by_model, validated
from nscc_training.measures import decibels
from nscc_training.programs import CODES_FILE, compiled, program_of, words_per_slot
from nscc_training.protocol_scenes.scene import Scene
from nscc_training.sensor_model import shared_out
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


def artifacts(parts: Parts, shown: Sequence[Scene], scenes: Scenes, step: int) -> dict[str, bytes]:
    """The files of a run by name; the parts are in their best state, reached at `step`.

    All scores are the protocol's, of the validation scenes that are `shown`.
    """
    from safetensors.torch import save

    found = compiled(program_of(parts.encoder, parts.chip), parts.chip)
    assert found.container is not None
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
    side = parts.settings.data.patch
    robustness = _robustness(parts, shown)
    result = {
        "schema": "nscc-run-2",
        "headline": _headline(parts, shown, robustness[0]),
        "protocol": parts.protocol.name,
        "protocol_sha256": parts.protocol.sha256,
        "config_sha256": config_digest(parts.settings),
        "split_sha256": split_digest(scenes),
        "step": step,
        "stages": _stages(parts, shown, found.container),
        "stages_note": f"PSNR in dB of {len(shown)} validation scenes, as the protocol counts it, "
        "without noise",
        "robustness": robustness,
        "words_per_slot": words_per_slot(found),
        "codes": _codes_report(parts, shown),
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


def _stages(parts: Parts, shown: Sequence[Scene], container: Container) -> dict[str, Any]:
    """PSNR with soft, hard, compiled and emulated shutters on the same scenes, without noise."""
    ideal, kind = parts.model.noiseless(), parts.encoder.spec.kind
    hard = parts.encoder.hard().cpu()
    if kind == LOOKS:
        machine = container.machine
        assert machine is not None
        codes = parts.encoder.codes()
        asked = [(each.boundary, each.level) for each in machine.comparisons]
        same = asked == [*zip(codes["at"][0].tolist(), codes["level"][0].tolist(), strict=True)]
        tiles = {"soft": hard, "hard": hard, **({"compiled": hard} if same else {})}
    else:
        with torch.no_grad():
            soft = parts.encoder.shutters(None, soft=True)
        rows, cols = parts.encoder.spec.tile
        packed = shutters_of_pixels(container)["shutter"][:, :rows, :cols]
        opened = np.unpackbits(packed, axis=-1, count=parts.slots, bitorder="little")
        words = torch.from_numpy(opened.astype(np.float32).transpose(0, 3, 1, 2).copy())
        same = torch.equal(words, shared_out(hard, parts.buckets).reshape(words.shape))
        tiles = {"soft": soft, "hard": hard, "compiled": words[0]}
    found: dict[str, Any] = dict.fromkeys(("soft", "hard", "compiled"))
    for name, tile in tiles.items():
        scores = validated(parts, shown, by_model(parts, tile, ideal))
        found[name] = decibels(scores.psnr_db)
    emulated = validated(parts, shown, lambda light_e, _: scene_by_words(parts, container, light_e))
    return found | {"emulated": decibels(emulated.psnr_db), "compiled_equals_hard": bool(same)}


def _headline(parts: Parts, shown: Sequence[Scene], trained: dict[str, Any]) -> dict[str, Any]:
    """What a run is worth on the sensor that it was `trained` under, and beside effects without."""
    effects = parts.settings.sensor.effects
    found = {"effects": effects, **{key: trained[key] for key in ("psnr_db", "ssim")}}
    if effects:
        alone = validated(parts, shown, by_model(parts))
        found |= {"noise_alone_psnr_db": decibels(alone.psnr_db), "noise_alone_ssim": alone.ssim}
    return found


def _robustness(parts: Parts, shown: Sequence[Scene]) -> list[dict[str, Any]]:
    """Scores under a sensor and an exposure that are not those of training."""
    found = []
    for name, factors, exposure in _CHANGES:
        values = {key: getattr(parts.model, key) * factor for key, factor in factors.items()}
        others = {key: value for key, value in values.items() if key in parts.sensor.values}
        if parts.settings.sensor.effects:
            decode = as_trained(parts, parts.sensor.changed(**others))
        else:
            decode = by_model(parts, model=replace(parts.model, **values))
        scores = validated(parts, shown, decode, exposure)
        found.append({"change": name, "psnr_db": decibels(scores.psnr_db), "ssim": scores.ssim})
    return found


def _codes_report(parts: Parts, shown: Sequence[Scene]) -> dict[str, Any]:
    """How many shutters there are, how far from dependent they are, at how many places of the tile
    they are not those that the run began with, and what these alone are worth to the decoder."""
    chosen = parts.settings.shutter
    start = started_encoder(chosen, parts.chip, parts.target, parts.settings.train.seed)
    if parts.encoder.spec.kind == LOOKS:
        codes, begun = parts.encoder.codes(), start.codes()
        moved = (codes["at"] != begun["at"]) | (codes["level"] != begun["level"])
        return {
            "places": int(moved.size), "start": chosen.init, "moved": int(moved.sum()),
            "shutters": int(moved.size) + 1, "at": codes["at"][0].tolist(),
            "steps": codes["level"][0].tolist(),
        }  # fmt: skip
    hard = parts.encoder.hard().cpu()
    moved = (start.hard() != hard).any(dim=0)
    alone = validated(parts, shown, by_model(parts, start.hard()))
    shutters = hard.reshape(parts.slots, -1).T.double().numpy()
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
            f"**{score}** on its validation scenes under photon noise, readout noise and "
            "converter alone. It knows\nno other effects of a chip: `nscc evaluate RUN --effects "
            "all` says what they cost it."
        )
    alone = f"{db(found['noise_alone_psnr_db'])} dB, SSIM {found['noise_alone_ssim']:.4f}"
    return (
        f"**{score}** on its validation scenes under the emulated chip's effects "
        f"(`{found['effects']}`), which it was\ntrained under; {alone} under photon noise, "
        "readout noise and converter "
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
    stages = " | ".join(
        "-" if result["stages"][k] is None else db(result["stages"][k])
        for k in ("soft", "hard", "compiled", "emulated")
    )
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

PSNR in dB of the validation scenes without noise, as the protocol counts it, with the shutters of
four stages:

| soft | hard | compiled | emulated |
|---|---|---|---|
| {stages} |

With noise, and with a sensor or exposure that it was not trained for:

| change | PSNR in dB |
|---|---|
{rows}
"""
