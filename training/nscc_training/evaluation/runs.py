"""`nscc evaluate NAME --data DIR --protocol P`: evaluate a run or a baseline by name."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from hashlib import sha256
from pathlib import Path
from time import perf_counter

import numpy as np
import torch

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import rejected
from nscc.diagnostics.suggest import meant
from nscc.files import file_sha256
from nscc.mappings import JsonObject
from nscc.program.problems import counted
from nscc_runtime.sensor import load_sensor
from nscc_training.code_choices import LOOKS
from nscc_training.command_settings import EvaluationSettings
from nscc_training.data import load_scenes
from nscc_training.decoders.declared import DECODERS
from nscc_training.decoders.decoder_building import flops, parameter_count
from nscc_training.evaluation.baselines import BASELINES, evaluate_baseline
from nscc_training.evaluation.looks_rows import UNDECODED, evaluate_looks
from nscc_training.evaluation.results import (
    Evaluated,
    Scored,
    ScoredMethod,
    Scorer,
    also_saturated,
    result_of,
    usable_scenes,
)
from nscc_training.loop.decoding import by_chip, by_model
from nscc_training.loop.validation import validation_scenes
from nscc_training.problems import listed
from nscc_training.programs import SENSOR_FILE
from nscc_training.protocol_scenes.clips import class_windows
from nscc_training.protocol_scenes.file_scenes import files_of, scenes_in
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene
from nscc_training.protocol_scenes.sci import SciClip
from nscc_training.protocols import Protocol, load_protocol
from nscc_training.run_files import run_path
from nscc_training.run_folder import RunFolder, load_run

DecodeScene = Callable[[ProtocolScene, int], tuple[Array, float]]
_SIZE = (256, 256)
"""Rows and columns of the scenes of protocols."""


def evaluate_run(
    folder: RunFolder,
    protocol: Protocol,
    wanted: EvaluationSettings,
    scorer: Scorer | None = None,
) -> Evaluated:
    """Return the result of a run with its hard shutters on the scenes in the folder `wanted.data`,
    as JSON values, and the arrays of `--save` by name.

    The result lists the files that `wanted.skip_seen` leaves out. Effects are those of a different
    chip for each seed.

    Raises Rejected: NS0756 for unknown effects; NS0841 for effects under sci8, whose measurements
    come from files; NS0820 if the run has seen a file of the data, or with `skip_seen` all files;
    NS0821 if the run was trained for another task than the protocol's; NS0811 for a folder without
    data."""
    _check_kind(folder, protocol)
    files = files_of(protocol, wanted.data)
    seen_files = seen_of(folder, files)
    # Files of the training are skipped if the user asks for it, unless none would remain.
    if not (wanted.skip_seen and len(seen_files) < len(files)):
        check_unseen(folder, files)
    files = [path for path in files if path not in seen_files]
    if wanted.changes and not wanted.effects:
        raise rejected(
            "NS0841",
            f"'{folder.path}' is exposed with the sensor of its training, which no value changes",
            helps=('name the effects of the emulated chip, such as effects = "all"',),
        )
    if wanted.effects and protocol.name == "sci8":
        raise rejected(
            "NS0841",
            "sci8 contains measurements that were not made by the emulated chip",
            helps=("leave --effects out, or use video-v1",),
        )
    decode = _by_mask(folder) if protocol.name == "sci8" else _by_run(folder, wanted)
    candidates = (
        class_windows(files, folder.setup.classes, protocol, wanted.seed)
        if protocol.classifies
        else scenes_in(files, protocol)
    )
    scenes, unusable = usable_scenes(candidates, protocol)
    left_out = [
        {"file": path.name, "reason": "the run has seen it"} for path in seen_files
    ] + unusable
    scorer = scorer or Scorer()
    scored_scenes = scorer.scored(scenes, decode)
    extra_keys = also_saturated(files, protocol, lambda shown: scorer.scored(shown, decode))
    if wanted.changes:
        extra_keys["sensor_changes"] = [*wanted.changes]
    return _run_result(folder, protocol, wanted, files, scored_scenes, left_out, extra_keys)


def evaluate_validation(folder: RunFolder, scorer: Scorer | None = None) -> Evaluated:
    """Return the result of a run on its validation scenes, with the run's effects, as JSON values,
    and the arrays of `--save` by name.

    `scorer` keeps scores (None: in memory). Its mean equals the PSNR in `metrics.csv` at the step
    that the run kept. Raises Rejected (NS0811) if the scenes of its configuration are missing or
    have changed."""
    settings = folder.setup.settings
    setup = folder.setup
    scenes = load_scenes(
        settings.data, setup.still, setup.slots, settings.train.seed, classes=setup.classes
    )
    if not {scene.sha256 for scene in scenes.val} <= folder.seen_digests:
        raise rejected(
            "NS0811",
            f"'{folder.path}' was validated on other scenes than those that its "
            "configuration now names",
            notes=("split.json contains the digests of the original validation scenes",),
            helps=("set [data] val to the original files",),
        )
    shown = validation_scenes(folder.setup, scenes)
    wanted = EvaluationSettings("", effects=settings.sensor.effects)
    scored_scenes = (scorer or Scorer()).scored(shown, _by_run(folder, wanted))
    split = {"split": "val"}
    return _run_result(folder, shown[0].protocol, wanted, [], scored_scenes, [], split)


def _by_run(folder: RunFolder, wanted: EvaluationSettings) -> DecodeScene:
    """Return a function that captures and decodes a scene: with the sensor model of the training,
    or if `wanted.effects` are named, with them on the emulated chip. `wanted.changes` apply to that
    chip's sensor, and `wanted.seed` seeds noise and chip."""
    if wanted.effects:
        file = folder.path / SENSOR_FILE
        sensor_file = file if folder.setup.settings.sensor.file and file.is_file() else None
        sensor = None
        if wanted.changes:
            sensor = load_sensor(folder.setup.target, sensor_file, wanted.changes)
        decode = by_chip(folder.setup, wanted.effects, sensor, wanted.seed)
    else:
        decode = by_model(folder.setup, seed=wanted.seed)
    return lambda scene, index: decode(scene.light_e, index)


def _by_mask(folder: RunFolder) -> DecodeScene:
    """Return a function that decodes a benchmark clip with the decoder of a run and the clip's own
    mask, without noise.

    As in training, a full well is the 99th percentile of the light of an always open pixel. It is
    estimated from the measurement by scaling the light of open slots to all slots; pixels that
    never open do not count, and others must exist."""
    setup = folder.setup

    @torch.no_grad()
    def decode(scene: ProtocolScene, _index: int) -> tuple[Array, float]:
        """Return the light of a benchmark clip on 0..1, and the seconds of decoding it."""
        assert isinstance(scene, SciClip)
        share = scene.mask.mean(axis=0)
        gathered = scene.measurement[share > 0] / share[share > 0]
        level = max(float(np.percentile(gathered, 99)), 1e-6)
        frame = torch.from_numpy((scene.measurement / level).astype(np.float32)).clamp(max=1)
        begin = perf_counter()
        mask = torch.from_numpy(scene.mask).to(setup.device)
        result = setup.decoder(frame[None].to(setup.device), mask)[0].float().cpu().numpy()
        # Decoders return a slot's light in full wells / N, and `level` is a full well.
        return result.astype(np.float64) * (level / len(scene.mask)), perf_counter() - begin

    return decode


def _run_result(
    folder: RunFolder,
    protocol: Protocol,
    wanted: EvaluationSettings,
    files: list[Path],
    scored_scenes: Sequence[Scored],
    left_out: list[JsonObject],
    extra_keys: JsonObject,
) -> Evaluated:
    """Return the result of scored scenes, with the settings of the run, as JSON values, and the
    arrays of `--save` by name.

    Times are medians. `files` are the scenes' files, `left_out` the scenes that could not be used,
    and `extra_keys` are added to the result."""
    setup, settings = folder.setup, folder.setup.settings
    decoder_s = [entry.seconds for entry in scored_scenes]
    method = ScoredMethod(
        f"{settings.decoder.name} ({settings.decoder.sized})",
        {
            "run": folder.path.name,
            "buckets": setup.buckets,
            "size": settings.decoder.sized,
            "steps": settings.train.steps,
            "train_seed": settings.train.seed,
            "places": folder.result.get("codes", {}).get("places"),
            "moved": folder.result.get("codes", {}).get("moved"),
            "words_per_slot": folder.result.get("words_per_slot"),
            "program_sha256": sha256(folder.program.encode()).hexdigest(),
            "config_sha256": folder.result.get("config_sha256"),
            "effects": wanted.effects,
            "trained_effects": settings.sensor.effects,
            "seed": wanted.seed,
        },
        decoder_ms=1e3 * float(np.median(decoder_s)) if scored_scenes else None,
        device=setup.device.type,
        parameters=parameter_count(setup.decoder),
        flops=flops(setup.decoder, setup.slots, *_SIZE, setup.buckets),
    )
    return result_of(
        protocol,
        method,
        files,
        scored_scenes,
        left_out,
        **extra_keys,
        flops_size=[*_SIZE],
    )


def _check_kind(folder: RunFolder, protocol: Protocol) -> None:
    """Raise Rejected (NS0821) if the run was trained for another task than the protocol's: stills,
    clips or classes, number of slots, class of shutters, buckets. A decoder that knows only its own
    code is refused for sci8, whose clips have another one."""
    setup = folder.setup
    if protocol.name == "staggered-v1":
        raise rejected(
            "NS0821",
            f"'{folder.path}' was trained for one exposure, but protocol "
            f"{protocol.name} has several",
            helps=("its rows are those of `nscc evaluate --help`",),
        )
    kind = setup.encoder.spec.kind
    have = f"{'stills' if setup.still else 'clips'} of {setup.slots} slots, class {kind}"
    if protocol.still:
        want = f"stills of {protocol['slots']} slots, class {protocol['class']}"
        known = kind in (protocol["class"], LOOKS)
        matches = setup.still and setup.slots == protocol["slots"] and known
    else:
        want = f"{'classes' if protocol.classifies else 'clips'} of {protocol['frames']} slots"
        have = f"the classes of {have}" if setup.classes else have
        matches = not setup.still and setup.slots == protocol["frames"]
        matches = matches and protocol.classifies == bool(setup.classes)
    if not matches:
        raise rejected(
            "NS0821",
            f"'{folder.path}' was trained for {have}, but protocol {protocol.name} needs {want}",
            helps=("train with [data] protocol and [shutter] slots of the protocol",),
        )
    name = setup.settings.decoder.name
    if protocol.name == "sci8" and setup.buckets > 1:
        raise rejected(
            "NS0821",
            f"'{folder.path}' was trained with two buckets, but clips of sci8 have one",
            helps=("protocol two-bucket-v1 has two",),
        )
    # Benchmark clips bring their own mask, which a decoder for one code cannot use.
    if protocol.name == "sci8" and name in DECODERS and not DECODERS[name].any_code:
        raise rejected(
            "NS0821",
            f"{name} was trained for one code, but sci8 uses its own mask",
            helps=("use a decoder that receives the code, such as unet3d",),
        )


def seen_of(folder: RunFolder, files: list[Path]) -> list[Path]:
    """Return those of `files` that the run was trained or validated on, by the digests of their
    contents."""
    return [path for path in files if file_sha256(path) in folder.seen_digests]


def check_unseen(folder: RunFolder, files: list[Path]) -> None:
    """Raise Rejected (NS0820) if the run in `folder` was trained or validated on one of `files`.
    The message names them."""
    shared = [path.name for path in seen_of(folder, files)]
    if shared:
        other_files = counted(len(files) - len(shared), "other file")
        skip = (f"`nscc evaluate RUN --skip-seen` scores it on the {other_files} of the folder",)
        raise rejected(
            "NS0820",
            f"'{folder.path}' was trained or validated on {len(shared)} of these "
            f"{counted(len(files), 'file')}",
            notes=(f"used files: {listed(shared, 8)}",),
            helps=(
                *(skip if len(shared) < len(files) else ()),
                "evaluate on other files: split.json in the run lists the used files",
            ),
            data={"files": shared},
        )


def evaluate(wanted: EvaluationSettings, scorer: Scorer | None = None) -> Evaluated:
    """Return the result of a baseline or of a run, as JSON values, and the arrays of `--save` by
    name. `wanted` names subject, protocol, data and options; `scorer` keeps scores (None: in
    memory).

    Raises Rejected: NS0806 for the protocol, NS0810 for an unknown subject, NS0840 for codes and
    NS0841 for effects that the subject does not support, NS0811 for a folder without suitable data,
    and the errors of `load_run` and `evaluate_run`."""
    chosen, subject = load_protocol(wanted.protocol), wanted.subject
    # A subject is a row without decoder, else a baseline, else a run.
    known = (*BASELINES.get(chosen.name, ()), *(UNDECODED if chosen.still else ()))
    if subject in UNDECODED and chosen.still:
        _refuse_codes(wanted.shutter, subject)
        return evaluate_looks(wanted, scorer)
    if subject in known:
        if wanted.effects or wanted.changes:
            raise rejected(
                "NS0841",
                f"the baseline {subject} has no program, so effects of a chip cannot be applied",
                notes=("its codes are exposed with the fixed sensor of the protocol",),
                helps=("name a run folder of nscc train, or leave --effects out",),
            )
        return evaluate_baseline(chosen, wanted, scorer)
    run = run_path(Path(subject))
    if run.is_dir():
        _refuse_codes(wanted.shutter, f"the run '{subject[:60]}'")
        folder = load_run(run, trust_code=wanted.trust_code)
        return evaluate_run(folder, chosen, wanted, scorer)
    raise rejected(
        "NS0810",
        f"'{subject[:60]}' cannot be evaluated under protocol {chosen.name}: unknown "
        "baseline or run",
        notes=(f"its baselines are {', '.join(known)}",) if known else (),
        helps=meant(subject, known, "name one of them, or a run folder of nscc train")
        if known
        else ("name a run folder; `nscc evaluate sci8 CLIP.mat` evaluates the baselines",),
    )


def _refuse_codes(codes: str, subject: str) -> None:
    """Raise Rejected (NS0840) if the option --shutter, `codes`, is given for a subject with fixed
    codes."""
    if codes:
        raise rejected("NS0840", f"{subject} has fixed codes", helps=("leave --shutter out",))
