"""How far `nscc calibrate` is from the truth, in its own standard errors, over many chips.

    python tests/benchmarks/bench_calibrate.py [--chips N]

Chips and frames come from tests/helpers/calibration_frames.py, which shares no code with the
product.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / part) for part in ("", "runtime", "tests/helpers")]

from calibration_frames import TOP, Chip, taken, truth  # noqa: E402

from nscc_runtime.calibrate import calibrated  # noqa: E402


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--chips", type=int, default=200)
    count = parser.parse_args().chips
    known = truth(Chip())
    found = [calibrated(*taken(Chip(), 1000 + seed), TOP).quantities for seed in range(count)]
    print("| figure | true | mean found | standard error | off | within |")
    print("|---|---|---|---|---|---|")
    for name, value in known.items():
        values = np.array([one[name].value for one in found])
        errors = np.array([one[name].se for one in found])
        z = (values - value) / errors
        title, unit = found[0][name].title, found[0][name].unit
        print(
            f"| {title}, {unit} | {value:.5g} | {values.mean():.5g} | {np.median(errors):.2g} | "
            f"{np.sqrt((z * z).mean()):.2f} | {(abs(z) < 1).mean():.2f} |"
        )


if __name__ == "__main__":
    main()
