"""GAP-TV beside a plain numpy version with scikit-image's total variation, one thread each: neither
calls a library that takes more.

    python tests/benchmarks/bench_sci.py [CLIP.mat ...] [--rounds 3]

Without clips a made one of the benchmark's size is taken. Per clip: seconds a measurement, the best
of several rounds, the two taken in turn, and PSNR on 0..255 as protocol sci8 scores it.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from nscc_training import metrics
from nscc_training.baselines.sci import gap_tv
from nscc_training.baselines.tv_loop import denoise
from nscc_training.protocol_scenes.sci import SciClip, read_sci_clip
from nscc_training.protocols import load_protocol

_ITERATIONS = 40


def plain(measurement: NDArray[np.float64], mask: NDArray[np.float64]) -> NDArray[np.float64]:
    """The same iteration as anyone would write it, with the weight that the literature takes."""
    from skimage.restoration import denoise_tv_chambolle

    energy = np.maximum((mask**2).sum(axis=0), 1)
    clip = mask * measurement / energy
    target = np.zeros_like(measurement)
    for _ in range(_ITERATIONS):
        seen = (mask * clip).sum(axis=0)
        target = target + measurement - seen
        clip = denoise_tv_chambolle(clip + mask * ((target - seen) / energy), weight=0.1)
    return clip


def made() -> SciClip:
    """Squares that cross a picture of 256 x 256."""
    rng = np.random.default_rng(1)
    clip = np.kron(rng.integers(30, 200, (32, 32)), np.ones((8, 8)))[None].repeat(8, axis=0)
    for k in range(8):
        clip[k, 60:140, 30 + 6 * k : 110 + 6 * k] = 230
    mask = (rng.random(clip.shape) < 0.5).astype(np.float32)
    measurement = (clip * mask / 255).sum(axis=0).astype(np.float32)
    return SciClip(Path("made"), None, None, clip / 255, load_protocol("sci8"), mask, measurement)


def score(truth: NDArray[np.uint8], clip: NDArray[np.float64]) -> float:
    """Mean of per-frame dB."""
    frames = zip(truth, np.clip(clip, 0, 1) * 255, strict=True)
    return float(np.mean([metrics.psnr(a, b, 255.0) for a, b in frames]))


def main() -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("clips", nargs="*", type=Path)
    parser.add_argument("--rounds", type=int, default=1)
    arguments = parser.parse_args()
    try:
        import skimage  # noqa: F401
    except ModuleNotFoundError:
        print("scikit-image is not installed: pip install 'nscc[bench]'")
        return 1
    denoise.load()
    protocol = load_protocol("sci8")
    clips = {path.stem: read_sci_clip(path, protocol) for path in arguments.clips}
    for name, clip in (clips or {"made": made()}).items():
        best = [np.inf, np.inf]
        found: list[NDArray[np.float64]] = []
        for _ in range(arguments.rounds):
            found = []
            for which in (0, 1):
                begin = perf_counter()
                if which == 0:
                    result = gap_tv(clip.measurement, clip.mask, _ITERATIONS).astype(np.float64)
                else:
                    result = plain(clip.measurement.astype(float), clip.mask.astype(float))
                best[which] = min(best[which], perf_counter() - begin)
                found.append(result)
        ours, theirs = (score(clip.truth_e, result) for result in found)
        print(
            f"  {name:<10} {best[0]:7.3f} s {ours:6.2f} dB   plain {best[1]:7.3f} s "
            f"{theirs:6.2f} dB   x{best[1] / best[0]:6.1f}"
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())
