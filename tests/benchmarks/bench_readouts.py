"""What several readouts of one exposure are worth: PSNR of `nscc demo`, in dB, film by film.

    python tests/benchmarks/bench_readouts.py [--data DIR] [--readouts 1,4]

Films are those below DIR (default: NSCC_DATA, or ../shared/data), and builtin ones. A burst has as
many ordinary frames as the last number of readouts.
"""

from __future__ import annotations

import argparse
import os
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from nscc_runtime.scenes import Scene
from nscc_training.command_settings import DemoSettings
from nscc_training.demo import demo

ROOT = Path(__file__).resolve().parents[2]
BUILTIN = ("builtin:motion:0", "builtin:motion:0.15", "builtin:motion")
CHOSEN_WITH = ("cutie_example.mp4", "sleap_centered_pair_small.mp4", "builtin:motion:0.15")
"""Programs, windows and thresholds were chosen with these in view; the others were kept back."""


def main() -> None:
    """Print a line a film, and the mean of those that were kept back."""
    parser = argparse.ArgumentParser()
    data = Path(os.environ.get("NSCC_DATA", ROOT / "../shared/data"))
    parser.add_argument("--data", type=Path, default=data)
    parser.add_argument("--readouts", default="1,4")
    chosen = parser.parse_args()
    counts = [int(count) for count in chosen.readouts.split(",")]
    films = sorted(chosen.data.glob("video/*.mp4")) + sorted(chosen.data.glob("sci/*.mat"))
    titles = ["always open", "burst", *(f"{count} readouts" for count in counts)]
    print(f"{'film':32}" + "".join(f"{title:>13}" for title in titles))
    kept_back = []
    for name in (*map(str, films), *BUILTIN):
        found = []
        with TemporaryDirectory() as out:
            for count in counts:
                made = demo(Scene(name), Path(out), DemoSettings(readouts=count))
                found.append(made.psnr_db)
        row = [made.open_db, made.open_db if made.fair_db is None else made.fair_db, *found]
        short = name if name.startswith("builtin:") else Path(name).name
        kept_back += [row] * (short not in CHOSEN_WITH)
        mark = "*" if short in CHOSEN_WITH else ""
        print(f"{short + mark:32}" + "".join(f"{value:13.1f}" for value in row), flush=True)
    print(f"{'mean of those without *':32}" + "".join(f"{v:13.1f}" for v in np.mean(kept_back, 0)))


if __name__ == "__main__":
    main()
