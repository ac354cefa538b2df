"""`python -m nscc_training.any_code`: make the weights of the decoder for any code."""

from __future__ import annotations

import argparse
from pathlib import Path

import torch

from nscc_training.any_code.training import PARTS, Trainer, write_weights


def main() -> None:
    """Train, or go on where an interrupted training stopped; one thread, and a line now and then.

    `--write` writes the weights of finished trainings as they are shipped, in half precision.
    """
    parser = argparse.ArgumentParser(prog="python -m nscc_training.any_code")
    parser.add_argument("pictures", type=Path, nargs="*", help="folders of photographs, panoramas")
    parser.add_argument("--kind", choices=PARTS, default="clip")
    where = "the folder of the checkpoint; with --write that of each kind"
    parser.add_argument("--out", type=Path, action="append", required=True, help=where)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--write", type=Path, metavar="FILE", help="write weights, and stop")
    chosen = parser.parse_args()
    if chosen.write:
        write_weights(chosen.out, chosen.write)
        return
    torch.set_num_threads(1)
    for line in Trainer(chosen.kind, chosen.pictures, chosen.out[-1], chosen.seed).run():
        print(line, flush=True)


if __name__ == "__main__":
    main()
