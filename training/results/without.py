"""What each of a chip's errors costs a run: scored on sensors that do not have it.

    python training/results/without.py OUT.json RUN ...

RUNs are run folders, trained under effects, whose training data must be where their configuration
says. Of each of their validation files a crop or clip is exposed by the emulated chip, whose sensor
has some of its parameters at 0, and decoded by the run as it is. OUT.json has by run and by what
is left out the mean PSNR in dB (stills: PSNR-mu), and `noise_lsb`: by how many codes pixels vary in
time, and differ from one another, in a flat tenth of a full well, and by how many with photon and
readout noise alone.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from nscc.words.container import Container
from nscc_runtime.light import Light
from nscc_runtime.sensor import Sensor, parse_sensor
from nscc_runtime.simulate import Request, simulate
from nscc_training.data import load_scenes
from nscc_training.evaluation.hdr import parted
from nscc_training.evaluation.results import Scene
from nscc_training.evaluation.runs import container_of, made_by_chip
from nscc_training.evaluation.video import Window, exposed_window
from nscc_training.run_folder import RunFolder, load_run

WITHOUT: Mapping[str, tuple[str, ...]] = {
    "nothing": (),
    "differences of pixels": (
        "prnu_fraction", "analog_pattern_lsb", "dark_spread_fraction", "leakage_spread_fraction",
    ),
    "crosstalk": ("crosstalk_fraction",),
    "lag": ("lag_fraction",),
    "noise of words and resets": (
        "analog_noise_lsb", "spread_noise_lsb", "reset_noise_e", "read_noise_e",
    ),
}  # fmt: skip
REPEATS = 16


def main() -> None:
    """Measure and write."""
    if len(sys.argv) < 3:
        raise SystemExit(__doc__)
    found = {Path(name).name: measured(load_run(Path(name))) for name in sys.argv[2:]}
    Path(sys.argv[1]).write_text(json.dumps(found, indent=2) + "\n", encoding="utf-8")


def measured(run: RunFolder) -> dict[str, object]:
    """What `main` writes of a run."""
    parts, container = run.parts, container_of(run)
    effects, metric = parts.settings.sensor.effects, "mu_psnr_db" if parts.still else "psnr_db"
    scenes = scenes_of(run)
    scores: dict[str, float] = {}
    for name, zeros in WITHOUT.items():
        changes = [f"{zero}=0" for zero in zeros]
        sensor = parse_sensor(parts.target, b"", "the default sensor", changes)
        changed = replace(run, parts=replace(parts, sensor=sensor))
        found = []
        for index, scene in enumerate(scenes):
            made, _ = made_by_chip(changed, 0, container, effects, scene, index)
            found.append(scene.item(made).metrics[metric])
        scores[name] = float(np.mean(found))
        print(f"{run.path.name}, without {name}: {scores[name]:.2f} dB", flush=True)
    noise = {chosen: noise_lsb(container, parts.encoder.spec.tile, parts.sensor, chosen)
             for chosen in (effects, "shot,adc_noise")}  # fmt: skip
    return {"scenes": len(scenes), "without": scores, "noise_lsb": noise}


def scenes_of(run: RunFolder) -> list[Scene]:
    """The first crop or clip of each validation file."""
    parts = run.parts
    data = parts.settings.data
    if parts.still:
        split = json.loads((run.path / "split.json").read_text(encoding="utf-8"))
        files = [Path(data.train) / each["file"] for each in split["val"]]
        return [*parted(files, parts.protocol)[0]]
    held = load_scenes(data, parts.still, parts.slots, parts.settings.train.seed).val
    first = {scene.sha256: scene for scene in reversed(held)}.values()
    found = [
        exposed_window(Path(scene.name), 0, np.clip(scene.light[: parts.slots], 0, 1).astype(float),
                       True, parts.protocol)
        for scene in first
    ]  # fmt: skip
    return [window for window in found if isinstance(window, Window)]


def noise_lsb(
    container: Container, tile: tuple[int, int], sensor: Sensor, effects: str
) -> dict[str, float]:
    """Standard deviations of codes, in time and over the pixels of a place of the tile."""
    slot_s = np.asarray(container.slot_us)
    share = slot_s / slot_s.sum()
    assert container.pixel_codes is not None
    shutter = container.table.shutter_of_code[container.pixel_codes]
    opened = (container.table.shutters[:, 0] @ share)[shutter]
    light = Light.of_still((0.1 * sensor.full_well_e / opened).astype(np.float32), share)
    request = Request.of(effects=effects, seed=0, device_seed=0, repeat=REPEATS)
    codes = simulate(container, light, sensor, request).frame.frame[:, 0].astype(np.float64)
    mean, variance = codes.mean(axis=0), codes.var(axis=0, ddof=1)
    # The mean over frames has a part of what varies in time.
    fixed = [
        mean[row :: tile[0], col :: tile[1]].var()
        - variance[row :: tile[0], col :: tile[1]].mean() / REPEATS
        for row, col in np.ndindex(*tile)
    ]
    return {
        "in_time": float(np.sqrt(variance.mean())),
        "of_pixels": float(np.sqrt(max(np.mean(fixed), 0))),
    }


if __name__ == "__main__":
    main()
