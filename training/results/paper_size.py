"""Train decoders of the paper's size, one after another, and score each as soon as it is done.

    python training/results/paper_size.py DATA OUT [NAME ..] [--minutes M]

DATA is the folder `data` that reproduce.sh makes. OUT gets a run folder and a NAME.json for every
run of `RUNS`, in that order, or for those that are named. Ended, killed or stopped after M minutes
and started again it goes on from the last checkpoint; what has its score is not done again. Where
the processor multiplies bf16 faster than f32, or there is a GPU, decoders learn in bf16 for all
their steps; elsewhere in f32, for a quarter of them: on one core that is still hours a run.
"""

from __future__ import annotations

import argparse
import tomllib
from pathlib import Path
from time import monotonic, process_time
from typing import Any

import torch

from nscc.files import write_together
from nscc_training.config import settings_of
from nscc_training.evaluation.result_text import result_json
from nscc_training.evaluation.subjects import evaluate
from nscc_training.loop.train import train

HERE = Path(__file__).resolve().parent
GUESSING = ("unet2d", "unet3d")
"""They begin with a first guess, which the paper's do not: it spares most of the paper's steps."""
FEWER = 4
"""Without bf16 the steps are divided by this."""
# What lies between two validations, some minutes, is lost at most; beginning takes half a one.
_STILL = {"shutter": {"tile": [8, 8]}, "train": {"steps": 3000, "validate_every": 250}}
# An FC-net's 51 million weights take as long for four clips as for sixteen.
_BLOCKS = {"shutter": {"class": "c"}, "train": {"steps": 500, "batch": 16, "validate_every": 100}}
_FREE_BITS = {"shutter": {"class": "e", "init": "random", "learn": False, "target": "scamp7"}}
# The 2 x 2 pattern in class d is that of class c.
_FREE_BUMPS = {"shutter": {"class": "d", "init": "random", "learn": False}}
_DEEP = {"shutter": {"class": "c"}, "train": {"steps": 400, "validate_every": 100}}
# What learns on from another of these runs comes after it.
_ON = {"decoder": {"init": "paper_hdr_quad"}, "train": {"steps": 1000, "rate": 1e-4}}
RUNS: dict[str, tuple[str, str, tuple[dict[str, Any], ...]]] = {
    "paper_hdr_random": (
        "hdr.toml", "unet2d", (_STILL, {"shutter": {"init": "random", "learn": False}})
    ),
    "paper_hdr_quad": ("hdr.toml", "unet2d", (_STILL, {"shutter": {"learn": False}})),
    "paper_hdr_learned": ("hdr.toml", "unet2d", (_STILL, {"shutter": {"init": "random"}})),
    "paper_hdr_quad_on": ("hdr.toml", "unet2d", (_STILL, _ON, {"shutter": {"learn": False}})),
    "paper_hdr_on": ("hdr.toml", "unet2d", (_STILL, _ON, {"train": {"code_rate": 2e-3}})),
    "paper_fc_c": ("clip.toml", "fcnet", (_BLOCKS, {"shutter": {"learn": False}})),
    "paper_fc_e": ("clip.toml", "fcnet", (_BLOCKS, _FREE_BITS)),
    "paper_u3_c": ("clip.toml", "unet3d", (_DEEP, {"shutter": {"learn": False}})),
    "paper_u3_d": ("clip.toml", "unet3d", (_DEEP, _FREE_BUMPS)),
}  # fmt: skip
"""By name: the configuration beside this file, the decoder, and what else is changed of it."""


def multiplies_bf16() -> bool:
    """Whether half the bits take less time here: on a GPU, or in a product on the processor."""
    if torch.cuda.is_available():
        return True

    def seconds(dtype: torch.dtype) -> float:
        pictures, kernels = torch.ones(1, 64, 64, 64, dtype=dtype), torch.ones(64, 64, 3, 3)
        torch.conv2d(pictures, kernels.to(dtype))
        begin = process_time()
        for _ in range(5):
            torch.conv2d(pictures, kernels.to(dtype))
        return process_time() - begin

    with torch.no_grad():
        return seconds(torch.bfloat16) < 0.8 * seconds(torch.float32)


def values_of(name: str, data: Path, out: Path, bf16: bool) -> dict[str, dict[str, Any]]:
    """The sections of a run's configuration."""
    file, decoder, changes = RUNS[name]
    values: dict[str, dict[str, Any]] = tomllib.loads((HERE / file).read_text(encoding="utf-8"))
    for change in changes:
        for section, keys in change.items():
            values.setdefault(section, {}).update(keys)
    decoding = values.setdefault("decoder", {})
    decoding |= {"name": decoder, "size": "paper"}
    if decoder in GUESSING:
        decoding["guess"] = "yes"
    if "init" in decoding:
        decoding["init"] = str(out / decoding["init"])
    values["data"]["train"] = str(data / Path(values["data"]["train"]).name)
    learning = values["train"]
    learning.setdefault("rate", 3e-4)
    learning |= {"device": "auto", "dtype": "bf16" if bf16 else "f32"}
    learning["steps"] //= 1 if bf16 else FEWER
    return values


def time_is_left(minutes: float | None, begin: float) -> bool:
    """Whether there is time left."""
    return minutes is None or monotonic() - begin < 60 * minutes


def main() -> None:
    """Train and score what is not done, while there is time."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("data", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(RUNS)}")
    parser.add_argument("--minutes", type=float, help="begin no further steps after so many")
    chosen = parser.parse_args()
    if unknown := [name for name in chosen.names if name not in RUNS]:
        parser.error(f"there is no run {unknown[0]}: they are {', '.join(RUNS)}")
    begin, bf16 = monotonic(), multiplies_bf16()
    print("decoders learn in", "bf16" if bf16 else f"f32, 1 of {FEWER} steps", flush=True)
    for name in chosen.names or RUNS:
        score, run = chosen.out / f"{name}.json", chosen.out / name
        if score.is_file():
            continue
        settings = settings_of(values_of(name, chosen.data, chosen.out, bf16))
        log = run / "metrics.csv"
        done = int(log.read_text().splitlines()[-1].split(",")[0]) if log.is_file() else 0
        while done < settings.train.steps:
            if not time_is_left(chosen.minutes, begin):
                print(f"{name}: {done} of {settings.train.steps} steps are done")
                return
            done += settings.train.validate_every
            train(settings, run, stop_after=done, report=lambda text: print(text, flush=True))
        still = settings.data.protocol == "hdr-v1"
        scenes, protocol = ("hdr_test", "hdr-v1") if still else ("clips", "video-v1")
        found, _ = evaluate(str(run), chosen.data / scenes, protocol, 0)
        write_together({score: result_json(found).encode()})
        print(f"{name}: {found['mean']:.2f} dB", flush=True)


if __name__ == "__main__":
    main()
