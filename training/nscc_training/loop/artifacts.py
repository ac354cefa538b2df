"""The files of a finished run: program, codes, decoder, and their scores."""

from __future__ import annotations

import json
import platform
from collections.abc import Sequence
from dataclasses import replace
from hashlib import sha256
from typing import Any

import numpy as np
import torch

from nscc import __version__
from nscc.container_proof import shutters_of_pixels
from nscc.mappings import JsonObject
from nscc.words.container import Container
from nscc_runtime.sensor import sensor_sha256
from nscc_training.code_choices import LOOKS
from nscc_training.data import Scenes
from nscc_training.decoders.decoder_building import flops, parameter_count
from nscc_training.least_squares import solve
from nscc_training.loop.decoding import by_model, scene_by_words
from nscc_training.loop.setup import TrainingSetup, started_encoder
from nscc_training.loop.validation import as_trained, validated
from nscc_training.measures import METRIC_NAMES, means_text, score_text
from nscc_training.programs import CAPTURE_FILE, CODES_FILE, program_of, words_per_slot
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene
from nscc_training.sensor_model import shared_out
from nscc_training.settings import RunSettings, config_toml

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
"""Name of each change of conditions, factors on sensor values, and a factor on the exposure."""
_ALONE, _START = "noise_alone_", "start_alone_"
"""Prefixes of metrics: with noise and no other effects, and with the initial codes."""


def artifacts(
    setup: TrainingSetup, shown: Sequence[ProtocolScene], scenes: Scenes, step: int
) -> dict[str, bytes]:
    """Return the files of a run, their bytes by name: program, codes, decoder, `capture.toml`,
    `result.json` and the model card.

    `setup` holds the best state of the run, which was reached at `step`. `shown` are the validation
    scenes of the scores, and `scenes` the split that the files name. Computing the scores takes the
    most time. Raises Rejected with the compiler's errors if the shutters do not fit the chip."""
    from safetensors.torch import save

    build = setup.compiled()
    remark = (
        f"Shutters of class {setup.encoder.spec.kind}, learned by nscc train with the decoder "
        f"beside them\n(step {step}, seed {setup.settings.train.seed}, "
        f"protocol {setup.protocol.name})."
    )
    if not setup.settings.shutter.learn:
        remark = remark.replace("learned by nscc train with", "kept by nscc train, which learned")
    program = program_of(setup.encoder, setup.chip, remark)
    weights = save({k: v.contiguous() for k, v in setup.decoder.state_dict().items()})
    files = {"shutter.nsl": program.text.encode(), "decoder.safetensors": weights}
    if program.codes:
        files[CODES_FILE] = program.codes
    files |= setup.files
    files[CAPTURE_FILE] = capture_toml(setup).encode()
    side = setup.settings.data.patch
    robustness = _robustness(setup, shown)
    effects, metrics = setup.settings.sensor.effects, setup.protocol.metrics
    headline = {"effects": effects, **{key: robustness[0][key] for key in metrics}}
    if effects:
        # The scores with the noise of the sensor model alone, without the chip's other effects.
        noise_scores = validated(setup, shown, by_model(setup))
        headline |= {f"{_ALONE}{metric}": value for metric, value in noise_scores.means.items()}
    result = {
        "schema": "nscc-run-2",
        "headline": headline,
        "protocol": setup.protocol.name,
        "protocol_sha256": setup.protocol.sha256,
        "config_sha256": config_digest(setup.settings),
        "split_sha256": split_digest(scenes),
        "step": step,
        "stages": _stages(setup, shown, build.built),
        "stages_note": f"{METRIC_NAMES[metrics[0]]} of {len(shown)} validation scenes, as the "
        "protocol counts it, without noise",
        "robustness": robustness,
        "words_per_slot": words_per_slot(build),
        "codes": _codes_report(setup, shown),
        "parameters": parameter_count(setup.decoder),
        "flops": flops(setup.decoder, setup.slots, side, side, setup.buckets),
        "flops_size": [side, side],
        "files": {name: sha256(data).hexdigest() for name, data in sorted(files.items())},
    }
    files["result.json"] = lines_of(result)
    files["model_card.md"] = _card(setup, scenes, result).encode()
    return files


def environment(setup: TrainingSetup) -> JsonObject:
    """Return the versions that results depend on, and the kind of machine and device. Host, time
    and paths are left out, so that equal runs give equal files."""
    return {
        "nscc": __version__,
        "python": platform.python_version(),
        "torch": torch.__version__,
        "numpy": np.__version__,
        "machine": platform.machine(),
        "device": setup.device.type,
    }


def lines_of(values: Any) -> bytes:
    """Return JSON values (dictionaries keep their order) as indented JSON, the bytes of a file.
    Infinity and NaN raise ValueError."""
    return (json.dumps(values, indent=2, allow_nan=False) + "\n").encode()


def config_digest(settings: RunSettings) -> str:
    """Return the SHA-256 of config.resolved.toml, the text of `settings` with every key. It
    determines the run."""
    return sha256(config_toml(settings).encode()).hexdigest()


def split_digest(scenes: Scenes) -> str:
    """Return the SHA-256 of split.json, which lists the scenes of training and validation with the
    digests of their files."""
    return sha256(lines_of(scenes.split())).hexdigest()


def capture_toml(setup: TrainingSetup) -> str:
    """Return the text of capture.toml: the conditions that the decoder was trained for.

    They are sensor, slots, effects, and the exposure of scenes. `nscc run --like` sets them, and
    `nscc reconstruct` compares frames with them."""
    model, slots = setup.model, "" if setup.still else " / slots in a slot"
    values = {
        "sensor_sha256": sensor_sha256(setup.sensor),
        "full_well_e": model.full_well_e,
        "electrons_per_lsb": model.electrons_per_lsb,
        "adc_offset_lsb": model.adc_offset_lsb,
        "adc_bits": model.adc_bits,
        "slots": setup.slots,
        "slot_us": setup.chip.slot_us,
        "effects": setup.settings.sensor.effects,
        "scenes": "stills" if setup.still else "clips",
        "transfer": setup.settings.data.transfer,
        "exposure": _exposure(setup),
        **({"classes": [*setup.classes]} if setup.classes else {}),
        "normalisation": f"1 is a full well{slots or ' over the frame'}",
    }  # fmt: skip
    head = "# What the decoder was trained on; `nscc reconstruct` refuses frames of something else."
    lines = [head, *(f"{key} = {json.dumps(value)}" for key, value in values.items())]
    return "\n".join(lines) + "\n"


def _exposure(setup: TrainingSetup) -> str:
    """Return a sentence, for capture.toml, on how brightly the training of `setup` exposes scenes:
    stills by the part that saturates, clips by a full well, or by the electrons of a mid-grey."""
    if setup.still:
        low, high = sorted(setup.settings.data.saturated)
        share = f"{100 * low:g}" if low == high else f"{100 * low:g} to {100 * high:g}"
        return f"{share} % of the pixels saturate when always open"
    grey_e = setup.protocol.mid_grey_e
    if grey_e is None:
        part = "" if setup.protocol.light == 1 else f"{setup.protocol.light:g} of "
        return f"percentile 99 of the all-open sum is {part}a full well"
    return f"the median of the all-open sum is {grey_e:.0f} e"


def _stages(
    setup: TrainingSetup, shown: Sequence[ProtocolScene], container: Container
) -> JsonObject:
    """Return the score of the validation scenes without noise, with shutters that are soft, hard,
    compiled and emulated, by these names.

    `compiled_equals_hard` says whether the compiled program has the learned shutters; the scores of
    the last three should then be equal. A score is None for shutters that a class lacks."""
    ideal, kind = setup.model.noiseless(), setup.encoder.spec.kind
    hard = setup.encoder.hard().cpu()
    if kind == LOOKS:
        machine = container.machine
        codes = setup.encoder.codes()
        compiled_looks = [
            (comparison.boundary, comparison.level) for comparison in machine.comparisons
        ]
        # The compiled program must look at the learned boundaries and levels.
        same = compiled_looks == [
            *zip(codes["at"][0].tolist(), codes["level"][0].tolist(), strict=True)
        ]
        tiles = {"soft": hard, "hard": hard, **({"compiled": hard} if same else {})}
    else:
        with torch.no_grad():
            soft = setup.encoder.shutters(None, soft=True)
        rows, cols = setup.encoder.spec.tile
        packed = shutters_of_pixels(container)["shutter"][:, :rows, :cols]
        opened = np.unpackbits(packed, axis=-1, count=setup.slots, bitorder="little")
        words = torch.from_numpy(opened.astype(np.float32).transpose(0, 3, 1, 2).copy())
        same = torch.equal(words, shared_out(hard, setup.buckets).reshape(words.shape))
        tiles = {"soft": soft, "hard": hard, "compiled": words[0]}
    stages: JsonObject = dict.fromkeys(("soft", "hard", "compiled"))
    for name, tile in tiles.items():
        scores = validated(setup, shown, by_model(setup, tile, ideal))
        stages[name] = scores.score
    emulated = validated(setup, shown, lambda light_e, _: scene_by_words(setup, container, light_e))
    return stages | {"emulated": emulated.score, "compiled_equals_hard": bool(same)}


def _robustness(setup: TrainingSetup, shown: Sequence[ProtocolScene]) -> list[JsonObject]:
    """Return the scores on the scenes `shown` under changed sensors and exposures: for each change
    a dictionary with its name (`change`) and each metric; the first is "as trained".

    Runs that were trained under the chip's effects skip changes of values that the chip's sensor
    file lacks."""
    rows = []
    for name, factors, exposure in _CHANGES:
        values = {key: getattr(setup.model, key) * factor for key, factor in factors.items()}
        sensor_values = {key: value for key, value in values.items() if key in setup.sensor.values}
        if setup.settings.sensor.effects:
            if sensor_values.keys() != values.keys():
                continue
            decode = as_trained(setup, setup.sensor.changed(**sensor_values))
        else:
            decode = by_model(setup, model=replace(setup.model, **values))
        scores = validated(setup, shown, decode, exposure)
        rows.append({"change": name, **scores.means})
    return rows


def _codes_report(setup: TrainingSetup, shown: Sequence[ProtocolScene]) -> JsonObject:
    """Return the entry `codes` of `result.json`: how many places (pixels of the tile) and different
    shutters the codes have, how many places differ from their start, and the score of the start
    with this decoder.

    `rank` and `condition` are those of the matrix of different shutters. `unused_share` is the
    fraction of rows of a codebook that no pixel uses. For pixels that look, a place is a look; its
    boundary (`at`) and level (`steps`) replace these three entries and the score."""
    chosen = setup.settings.shutter
    start = started_encoder(chosen, setup.chip, setup.target, setup.settings.train.seed)
    if setup.encoder.spec.kind == LOOKS:
        codes, begun = setup.encoder.codes(), start.codes()
        moved = (codes["at"] != begun["at"]) | (codes["level"] != begun["level"])
        return {
            "places": int(moved.size),
            "start": chosen.init,
            "moved": int(moved.sum()),
            "shutters": int(moved.size) + 1,
            "at": codes["at"][0].tolist(),
            "steps": codes["level"][0].tolist(),
        }
    hard = setup.encoder.hard().cpu()
    moved = (start.hard() != hard).any(dim=0)
    start_scores = validated(setup, shown, by_model(setup, start.hard()))
    shutters = hard.reshape(setup.slots, -1).T.double().numpy()
    distinct = np.unique(shutters, axis=0)
    # Only rank and condition of the matrix are of interest, not a solution.
    system = solve(distinct, np.zeros(len(distinct)))
    unused = getattr(setup.encoder, "unused_share", None)
    return {
        "places": len(shutters),
        "start": chosen.init,
        "moved": int(moved.sum()),
        f"{_START}{setup.protocol.metrics[0]}": start_scores.score,
        "shutters": len(distinct),
        "rank": system.rank,
        "condition": None if np.isinf(system.condition) else system.condition,
        "unused_share": None if unused is None else float(unused()),
    }


def _headline_text(headline: JsonObject, metrics: Sequence[str]) -> str:
    """Return a sentence in Markdown with the scores of a run: `headline` of its `result.json`, of
    which `metrics` are named. It says under which effects the scores were measured, which are those
    of the training."""
    score = means_text({metric: headline[metric] for metric in metrics})
    if not headline["effects"]:
        return (
            f"**{score}** on its validation scenes under photon noise, readout noise and "
            "converter alone. It knows\nno other effects of a chip: `nscc evaluate RUN --effects "
            "all` says what they cost it."
        )
    alone = means_text({metric: headline[f"{_ALONE}{metric}"] for metric in metrics})
    return (
        f"**{score}** on its validation scenes under the emulated chip's effects "
        f"(`{headline['effects']}`), which it was\ntrained under; {alone} under photon noise, "
        "readout noise and converter "
        "alone."
    )


def _purpose(setup: TrainingSetup) -> str:
    """Return what a run reconstructs, as text that follows "For": classes, stills or clips."""
    if setup.classes:
        return f"the class of a clip from one exposure ({', '.join(setup.classes)})"
    return "stills of high dynamic range" if setup.still else "clips from one exposure"


def _card(setup: TrainingSetup, scenes: Scenes, result: JsonObject) -> str:
    """Return the text of the model card: scores, data, settings and limits of a run. `result` is
    the content of `result.json`, and `scenes` are only counted."""
    settings, metrics = setup.settings, setup.protocol.metrics
    metric, score_name = metrics[0], METRIC_NAMES[metrics[0]]

    def plain(value: float | str) -> str:
        """Return a number with two decimals. Text, such as an infinite score, stays."""
        return value if isinstance(value, str) else f"{value:.2f}"

    start_text = ""
    if result["codes"]["moved"] and f"{_START}{metric}" in result["codes"]:
        # The report of pixels that look lacks this score.
        start_text = (
            f"\nBehind this decoder the start alone gives "
            f"{score_text(metric, result['codes'][f'{_START}{metric}'])} where these shutters "
            f"give {score_text(metric, result['robustness'][0][metric])}."
        )
    stages = " | ".join(
        "-" if result["stages"][k] is None else plain(result["stages"][k])
        for k in ("soft", "hard", "compiled", "emulated")
    )
    rows = "\n".join(f"| {r['change']} | {plain(r[metric])} |" for r in result["robustness"])
    return f"""# Model card

{_headline_text(result["headline"], metrics)}

A decoder `{settings.decoder.name}` ({settings.decoder.sized}, {result["parameters"]} parameters)
and shutters of class {settings.shutter.kind} for `{settings.shutter.target}`: \
{settings.shutter.slots} slots of {settings.shutter.slot_us:g} us, \
{result["codes"]["shutters"]} shutters. Of {result["codes"]["places"]} places \
{result["codes"]["moved"]} moved from the start, `{result["codes"]["start"]}`.{start_text}

* **For** {_purpose(setup)} as the
  protocol {setup.protocol.name} exposes them; `capture.toml` says how. Frames of another program
  or sensor mean nothing to it.
* **Trained** for {settings.train.steps} steps of {settings.train.batch} patches of \
{settings.data.patch} x {settings.data.patch}, loss {settings.loss.name}, seed \
{settings.train.seed}, on {len(scenes.train)} scenes; validated on {len(scenes.val)} others \
(`split.json`).
* **Not** measured here: other scenes than those of validation. `nscc evaluate` does that.

{score_name[0].upper()}{score_name[1:]} of the validation scenes without noise, as the protocol \
counts it, with the shutters of
four stages:

| soft | hard | compiled | emulated |
|---|---|---|---|
| {stages} |

With noise, and with a sensor or exposure that it was not trained for:

| change | {score_name} |
|---|---|
{rows}
"""
