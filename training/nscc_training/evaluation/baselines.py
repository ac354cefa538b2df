"""Baselines of protocols that need no training: fixed codes, and a decoder for them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nscc.arrays import Bools
from nscc.diagnostics.diagnostic import rejected
from nscc.mappings import JsonObject
from nscc_training.code_choices import STARTS
from nscc_training.command_settings import EvaluationSettings
from nscc_training.evaluation import methods
from nscc_training.evaluation.methods import CapturedScene, Light, Method, captured
from nscc_training.evaluation.results import (
    Evaluated,
    Scored,
    ScoredMethod,
    Scorer,
    also_saturated,
    mean_score,
    result_of,
    usable_scenes,
)
from nscc_training.protocol_scenes.file_scenes import files_of, scenes_in
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene
from nscc_training.protocol_scenes.sci import SciClip
from nscc_training.protocols import Protocol, load_protocol

if TYPE_CHECKING:
    from torch import Tensor

    from nscc_training.encoders import Encoder

_TILE = (8, 8)
"""Rows and columns of the tile of codes that are not fixed."""
_CLASSES = {
    "hdr-v1": ("b",),
    "video-v1": ("c", "d", "e"),
    "codes-v1": ("c", "d", "e"),
    "deblur-v1": ("b", "c", "d", "e"),
}
"""Classes that `codes` may name, by protocol."""


class Baseline(NamedTuple):
    """A baseline of a protocol: fixed codes and a decoder without training (`method`).

    Its codes are `start` (CLASS:START) on a tile of `side` x `side`, or a number of open slots as
    text, the same for all pixels. `takes_codes` allows other codes. `best_in` names a metric in
    which the best of several uniform exposures is chosen with the ground truth. `tiles` is a
    function of protocol and seed that returns the shutters of several frames; `alone` decodes each
    frame separately."""

    method: Method
    start: str = ""
    side: int = _TILE[0]
    takes_codes: bool = False
    best_in: str = ""
    tiles: Callable[[Protocol, int], Bools] | None = None
    alone: bool = False

    def decode(self, frames: CapturedScene) -> Light:
        """Return the light of captured frames in electrons per slot or over the frame. If the
        baseline decodes frames `alone`, each is decoded without the others, and the clips are
        joined."""
        if not self.alone:
            return self.method.decode(frames)
        # A frame carries no information on slots outside of it.
        frame_lights = [self.method.decode(frames.frame(k)) for k in range(len(frames.codes))]
        return np.concatenate(frame_lights)


def _bits(protocol: Protocol, seed: int, tile: Sequence[int], buckets: int) -> Bools:
    """Return random shutters (buckets, slots, rows, cols) for a tile (rows, cols), with as many
    slots as a clip of the protocol has frames; a second bucket is open where the first is closed.
    `seed` determines them."""
    first = np.random.default_rng(seed).random((1, int(protocol["frames"]), *tile)) < 0.5
    return first if buckets == 1 else np.concatenate([first, ~first])


def _film(protocol: Protocol, *, staggered: bool) -> Bools:
    """Return shutters for a film of several frames, as a tile: (frames, slots of the whole film,
    rows, cols). Frame k is open only in its own slots. `protocol` gives the numbers of frames
    (`film`), of slots of the whole film (`frames`), and of open slots in a frame (`length`).

    Each pixel opens in one interval per frame. `staggered` intervals may begin at the end of one
    frame and continue in the next one."""
    film, length = int(protocol["film"]), int(protocol["length"])
    slots = int(protocol["frames"]) // film
    rows, cols = protocol["tile"]
    # Steps of 5 slots spread the phases of neighbouring pixels over the frame.
    phases = np.arange(rows * cols).reshape(rows, cols) * 5 % slots
    n = np.arange(slots).reshape(-1, 1, 1)
    if staggered:
        opened = (n - phases) % slots < length
    else:
        start = phases % (slots - length + 1)
        opened = (start <= n) & (n < start + length)
    tiles = np.zeros((film, film, slots, rows, cols), np.bool_)
    tiles[np.arange(film), np.arange(film)] = opened
    return tiles.reshape(film, film * slots, rows, cols)


_MERGED, _READ_OUT = methods.STILLS["merged"], methods.STILLS["read-out"]
_ANY = methods.CLIPS["any"]
BASELINES: dict[str, dict[str, Baseline]] = {
    "hdr-v1": {
        "ldr": Baseline(_MERGED, "256", 1),
        "best-uniform": Baseline(_MERGED, side=1, best_in="psnr_db"),
        "best-uniform-mu": Baseline(_MERGED, side=1, best_in="mu_psnr_db"),
        "quad": Baseline(_MERGED, "b:quad", 2),
        "random": Baseline(_MERGED, "b:random"),
        "sparse-coding": Baseline(methods.STILLS["sparse-coding"], "b:random", takes_codes=True),
        "any": Baseline(methods.STILLS["any"], "b:quad", 2, takes_codes=True),
    },
    "video-v1": {
        name: Baseline(
            method,
            "c:random" if name == "bilinear" else "e:random",
            takes_codes=method.sees == "capture",
        )
        for name, method in methods.CLIPS.items()
    },
    "codes-v1": {"any": Baseline(_ANY, "e:random", takes_codes=True)},
    "deblur-v1": {
        "long": Baseline(_READ_OUT, "8", 1),
        "short": Baseline(_READ_OUT, "1", 1),
        "any": Baseline(_ANY, "b:poisson-disc", takes_codes=True),
    },
    "two-bucket-v1": {
        "flutter": Baseline(_ANY, tiles=lambda p, seed: _bits(p, seed, (1, 1), 1)),
        "pixel-wise": Baseline(_ANY, tiles=lambda p, seed: _bits(p, seed, p["tile"], 1)),
        "two-bucket": Baseline(_ANY, tiles=lambda p, seed: _bits(p, seed, p["tile"], 2)),
    },
    "staggered-v1": {
        "aligned": Baseline(_ANY, tiles=lambda p, _seed: _film(p, staggered=False)),
        "staggered": Baseline(_ANY, tiles=lambda p, _seed: _film(p, staggered=True)),
        "staggered-alone": Baseline(
            _ANY, tiles=lambda p, _seed: _film(p, staggered=True), alone=True
        ),
    },
}


def evaluate_baseline(
    protocol: Protocol, wanted: EvaluationSettings, scorer: Scorer | None = None
) -> Evaluated:
    """Return the result of the baseline `wanted.subject` on the folder of scenes `wanted.data`, as
    JSON values, and the arrays of `--save` by name.

    `scorer` keeps scores (None: in memory). `wanted.shutter` names other shutters, CLASS:START or a
    run (`named_codes`). The noise of a scene depends only on the scene's index and `wanted.seed`.
    """
    from nscc_training.sensor_model import SensorModel

    name, seed, codes, scorer = wanted.subject, wanted.seed, wanted.shutter, scorer or Scorer()
    baseline, model = BASELINES[protocol.name][name], SensorModel.of_protocol(protocol)
    choices = _choices(baseline, protocol, name, seed, codes)
    files = files_of(protocol, wanted.data)
    scenes, left_out = usable_scenes(scenes_in(files, protocol), protocol)

    def decoded(tile: Tensor, shown: Sequence[ProtocolScene | None]) -> list[Scored]:
        """Return the scores of the scenes `shown`, captured with the shutters `tile` ([frames,] N,
        r, c) and decoded. An entry None is skipped."""

        def decode(scene: ProtocolScene, index: int) -> tuple[Light, float]:
            """Return the light of a scene that is captured with the tile, and the seconds of
            decoding it. Its `index` seeds the noise."""
            # Each scene has its own noise; up to 1000 scenes share none with another seed's.
            frames = captured(scene, tile, model, 1000 * seed + index)
            begin = perf_counter()
            return baseline.decode(frames), perf_counter() - begin

        return scorer.scored(shown, decode)

    attempts = [(tile, settings, decoded(tile, scenes)) for tile, settings in choices]
    metric = baseline.best_in or "psnr_db"
    # Of several uniform exposures the best counts; other baselines have one attempt.
    tile, settings, scored_scenes = max(attempts, key=lambda entry: mean_score(entry[2], metric))
    published = protocol.values.get("published_db", {}).get(name)
    extra_settings = {} if published is None else {"published_db": published}
    spent_s = [entry.seconds for entry in scored_scenes]
    method = ScoredMethod(
        name,
        {**settings, "seed": seed, "shutter": codes or baseline.start, **extra_settings},
        baseline.method.sees,
        1e3 * float(np.mean(spent_s)) if scored_scenes else None,
    )
    return result_of(
        protocol,
        method,
        files,
        scored_scenes,
        left_out,
        **also_saturated(files, protocol, lambda shown: decoded(tile, shown)),
    )


def _choices(
    baseline: Baseline, protocol: Protocol, name: str, seed: int, codes: str
) -> list[tuple[Tensor, JsonObject]]:
    """Return the candidate shutters of a baseline, each with the entries of the result that
    describe it. Only baselines with `best_in` have several.

    `name` is the baseline's, `codes` names other codes for baselines that accept any, and `seed` is
    that of random codes. Raises Rejected (NS0840) for codes that are not possible."""
    import torch

    from nscc_training.encoders import ShutterSpec, make_encoder
    from nscc_training.programs import Chip, compiled, program_of, words_per_slot

    # Baselines with several exposures bring their tiles; others have a start, or a list of stops.
    if baseline.tiles is not None:
        if codes:
            raise rejected("NS0840", f"{name} has fixed codes", helps=("leave --shutter out",))
        tile = torch.from_numpy(baseline.tiles(protocol, seed)).float()
        return [(tile, {"frames": len(tile), "tile": [*tile.shape[2:]]})]
    slots = int(protocol["slots" if protocol.still else "frames"])
    if codes or ":" in baseline.start:
        settings: JsonObject = {}
        if codes:
            encoder = named_codes(codes, protocol, name, seed)
            settings["words_per_slot"] = words_per_slot(
                compiled(program_of(encoder, Chip()), Chip())
            )
        else:
            kind, _, start = baseline.start.partition(":")
            length = 1 if name == "bilinear" else None  # only bilinear has class c
            spec = ShutterSpec(kind, slots, (baseline.side, baseline.side), length)
            encoder = make_encoder(spec, start, seed)
        for key, values in encoder.codes().items():
            settings["stops" if key == "stop" else key] = values.tolist()
        return [(encoder.hard().cpu(), settings)]
    # The candidates of "best uniform": every power of two up to the frame.
    stops = (
        [int(baseline.start)]
        if baseline.start
        else [1 << k for k in range(slots.bit_length()) if 1 << k <= slots]
    )
    opened = torch.arange(slots).reshape(-1, 1, 1)
    return [((opened < stop).float(), {"stops": [[stop]]}) for stop in stops]


def named_codes(text: str, protocol: Protocol, name: str, seed: int) -> Encoder:
    """Return the encoder with codes that `text` names: `CLASS[:START]`, such as "c:quad", or a run
    (a folder, or the name of a shipped one). A class without a start has random codes, which `seed`
    determines.

    Raises Rejected (NS0840) if the baseline `name` accepts no other codes, or the protocol does not
    support them."""
    from nscc_training.encoders import ShutterSpec, make_encoder
    from nscc_training.run_files import CONFIG, run_path
    from nscc_training.run_folder import run_codes

    known, rows = _CLASSES.get(protocol.name, ()), BASELINES[protocol.name]
    kind, _, start = text.partition(":")
    slots = int(protocol["slots" if protocol.still else "frames"])
    # A text may name a run, whose codes must have as many slots as the protocol, or a class.
    if text == rows[name].start or rows[name].takes_codes:
        folder = run_path(Path(text))
        if (folder / CONFIG).is_file():
            encoder = run_codes(folder)
            if encoder.spec.slots == slots:
                return encoder
            reason = f"'{text[:60]}' has codes of {encoder.spec.slots} slots"
            note = f"protocol {protocol.name} has {slots}"
            raise rejected("NS0840", reason, notes=(note,), helps=("name another run",))
        start = start or "random"
        if kind in known and start in STARTS:
            length = max(1, slots // 4) if kind == "c" else None
            try:
                return make_encoder(ShutterSpec(kind, slots, _TILE, length), start, seed)
            except ValueError as error:
                reason = f"'{text[:40]}' does not name codes: {error}"
                raise rejected("NS0840", reason, helps=(f"such as {kind}:quad",)) from error
        reason = f"'{text[:40]}' does not name codes of protocol {protocol.name}"
        note = f"its classes are {', '.join(known)}; starts are {', '.join(STARTS)}"
    else:
        takers = ", ".join(row_name for row_name, row in rows.items() if row.takes_codes)
        reason = f"{name} has fixed codes"
        note = f"under {protocol.name} these accept other codes: {takers}"
    raise rejected("NS0840", reason, notes=(note,), helps=(f"such as {known[0]}:quad",))


def evaluate_sci8(
    paths: Sequence[Path],
    method: str,
    iterations: int,
    weight: float,
    scorer: Scorer | None = None,
) -> Evaluated:
    """Return the result of `method` on the benchmark clips in the files `paths`, as JSON values,
    and the arrays of `--save` by name.

    `scorer` keeps scores (None: in memory). `iterations` and `weight` apply to methods of total
    variation only. Raises Rejected: NS0809 for a file that is not a clip of the benchmark, NS0810
    for an unknown method."""
    protocol, chosen = load_protocol("sci8"), methods.CLIPS.get(method)
    if chosen is None:
        raise rejected(
            "NS0810",
            f"unknown method '{method[:60]}' for sci8",
            notes=(f"the methods are {', '.join(methods.CLIPS)}",),
            helps=("to evaluate a trained decoder, name its run folder",),
        )
    methods.load(method, int(protocol["frames"]))
    options = {"iterations": iterations, "weight": weight} if method.endswith("-tv") else {}

    def decode(scene: ProtocolScene, _index: int) -> tuple[Light, float]:
        """Return the light of a benchmark clip, and the seconds of decoding it. Its index does not
        matter, because the clip contains its measurement."""
        assert isinstance(scene, SciClip)
        begin = perf_counter()
        return chosen.decode(CapturedScene.of_benchmark(scene), **options), perf_counter() - begin

    scenes, left_out = usable_scenes(scenes_in(paths, protocol), protocol)
    scored_scenes = (scorer or Scorer()).scored(scenes, decode)
    spent_ms = 1e3 * float(np.mean([entry.seconds for entry in scored_scenes]))
    scored_method = ScoredMethod(method, options, chosen.sees, spent_ms)
    return result_of(protocol, scored_method, paths, scored_scenes, left_out)
