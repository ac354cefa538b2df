"""Codes side by side behind the one decoder for any code, on a window of each clip.

    python training/results/codes.py DATA OUT NAME=CLASS:START|RUN[@start|@own] ...

Codes are those that a class may start with, those of a run, or those that the run began with. DATA
is a folder of clips. Of each the first window of protocol video-v1 is exposed, its middle of 112 x
112 pixels decoded by the decoder that no code was trained for, with @own by the run's.
OUT/codes-NAME.json is what `nscc evaluate` would say of it; those that are there and belong to the
same decoder stay: to its weights and to the text of its modules.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from hashlib import sha256
from importlib.resources import files
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from nscc_training.any_code.decode import WEIGHTS, decoded_clip
from nscc_training.any_code.measured import Measured
from nscc_training.encoders import Encoder, make_encoder
from nscc_training.evaluation.baseline_codes import codes_named
from nscc_training.evaluation.results import Scene, Subject, scored, with_arrays
from nscc_training.evaluation.video import Window, clips_of, windows
from nscc_training.loop.setup import started_encoder
from nscc_training.programs import Chip, compiled, program_of, words_per_slot
from nscc_training.protocols import load_protocol
from nscc_training.run_folder import RunFolder, load_run
from nscc_training.sensor_model import SensorModel, frame_of, laid

SIDE = 112
PROTOCOL = load_protocol("video-v1")
METHOD = "any, first windows"
"""Not `any`, whose rows in tables are of whole windows, and of all."""
KEY = "decoder_sha256"
Decode = Callable[[Tensor, Tensor, SensorModel], Tensor]
MODULES = ("decode.py", "measured.py", "network.py", "stages.py")


def main() -> None:
    """Evaluate what is missing."""
    if len(sys.argv) < 4:
        raise SystemExit(__doc__)
    data, out = map(Path, sys.argv[1:3])
    for name, _, what in (argument.partition("=") for argument in sys.argv[3:]):
        path = out / f"codes-{name}.json"
        folder, _, part = what.partition("@")
        own = part == "own"
        weights = Path(folder, "decoder.safetensors").read_bytes() if own else None
        decoder = digest(weights)
        if path.is_file() and json.loads(path.read_text())["settings"].get(KEY) == decoder:
            continue
        encoder, told = codes_of(what)
        decode = decoder_of(load_run(Path(folder))) if own else by_any
        result = evaluated(encoder, decode, data, told | {KEY: decoder})
        path.write_text(json.dumps(result, indent=2) + "\n")
        print(path, flush=True)


def digest(weights: bytes | None = None) -> str:
    """Of all that a decoder is made of: nscc's, or a run's with weights of its own."""
    folder = files("nscc_training.any_code")
    modules = MODULES if weights is None else (*MODULES, "decoder.py")
    parts = [(folder / name).read_bytes() for name in modules]
    return sha256(b"".join([weights or (folder / WEIGHTS).read_bytes(), *parts])).hexdigest()


def codes_of(what: str) -> tuple[Encoder, dict[str, Any]]:
    """Codes by class and start, or of a run, and what is to be said of them."""
    told: dict[str, Any] = {"codes": what}
    folder, _, part = what.partition("@")
    if (Path(folder) / "result.json").is_file():
        run = load_run(Path(folder))
        parts, report = run.parts, run.result["codes"]
        told = {"class": parts.encoder.spec.kind, "start": report["start"],
                "seed": parts.settings.train.seed}  # fmt: skip
        if part == "start":
            chosen = parts.settings.shutter
            encoder = started_encoder(chosen, parts.chip, parts.target, told["seed"])
        else:
            encoder = parts.encoder
            told |= {key: report[key] for key in ("moved", "places")}
    else:
        encoder = make_encoder(*codes_named(what, PROTOCOL, ("any",), "any"))
    words = words_per_slot(compiled(program_of(encoder, Chip()), Chip()))
    return encoder, told | {"words_per_slot": words}


def by_any(frame: Tensor, mask: Tensor, sensor: SensorModel) -> Tensor:
    """Electrons a slot (N, rows, cols) of a frame in codes, by the decoder for any code."""
    return decoded_clip(Measured.read(frame.numpy(), mask.numpy(), sensor))[0]


def decoder_of(run: RunFolder) -> Decode:
    """The same by a run's decoder."""

    @torch.no_grad()
    def decode(frame: Tensor, mask: Tensor, sensor: SensorModel) -> Tensor:
        light: Tensor = run.parts.decoder(sensor.relative(frame)[None], mask)[0]
        return light * (sensor.full_e / run.parts.slots)

    return decode


def evaluated(encoder: Encoder, decode: Decode, data: Path, told: dict[str, Any]) -> dict[str, Any]:
    """The result of codes, as `nscc evaluate` says it."""
    clips = clips_of(data)
    tile, sensor = encoder.hard(), SensorModel.of_protocol(PROTOCOL)

    def made(window: Scene, index: int) -> tuple[NDArray[np.float64], float]:
        begin = perf_counter()
        frame: Tensor = frame_of(window.light_e, tile, sensor, index)
        found = decode(frame, laid(tile, *frame.shape), sensor).double().numpy()
        return found, perf_counter() - begin

    every = list(scored(firsts(clips), made, []))
    return with_arrays(PROTOCOL, Subject(METHOD, told), clips, every, [])[0]


def firsts(clips: list[Path]) -> Iterator[Window]:
    """The middle of the first window of each clip."""
    for clip in clips:
        first = next(iter(windows([clip], PROTOCOL)))
        if isinstance(first, Window):
            margin = (first.light_e.shape[-1] - SIDE) // 2
            middle = slice(margin, margin + SIDE)
            yield replace(first, light_e=first.light_e[:, middle, middle])


if __name__ == "__main__":
    main()
