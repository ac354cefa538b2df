"""The rows of video-v1 that need no training."""

from __future__ import annotations

from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_training.any_code.decode import decoded_clip
from nscc_training.any_code.measured import Measured
from nscc_training.baselines.sci import ITERATIONS, WEIGHT
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.evaluation.baseline_codes import codes_named
from nscc_training.evaluation.methods import METHODS
from nscc_training.evaluation.results import Scene, Subject, scored, with_arrays
from nscc_training.evaluation.video import Window, clips_of, windows
from nscc_training.protocols import load_protocol
from nscc_training.sensor_model import SensorModel, frame_of, laid

BASELINES = tuple(METHODS)
_TAKERS = tuple(name for name, method in METHODS.items() if method.sees == "capture")
_TILE = (8, 8)


def evaluate_video_baseline(
    name: str, folder: Path, seed: int = 0, codes: str = ""
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The result of a baseline on a folder of clips, and its clips: arrays by name.

    Captures are coded with random bits (class e) on an 8 x 8 tile, one draw a seed, or as `codes`
    names them (see `codes_named`), on the protocol's sensor; the yardsticks bilinear and thin-out
    see the truth instead, both a sixteenth of it: one slot of every pixel, and all slots of every
    sixteenth pixel. The dictionary is learned first, from made scenes.
    """
    protocol = load_protocol("video-v1")
    files = clips_of(folder)
    slots = int(protocol["frames"])
    spec, start = ShutterSpec("e", slots, _TILE), "random"
    if codes:
        spec, start = codes_named(codes, protocol, _TAKERS, name)
    elif name == "bilinear":
        spec = ShutterSpec("c", slots, _TILE, length=1)
    encoder = make_encoder(spec, start, seed)
    tile, method = encoder.hard(), METHODS[name]
    sensor = SensorModel.of_protocol(protocol)

    def decode(window: Scene, index: int) -> tuple[NDArray[np.float64], float]:
        """Electrons a slot (16, rows, cols), as a baseline sees them."""
        assert isinstance(window, Window)
        begin = perf_counter()
        mask = laid(tile, *window.light_e.shape[-2:]).numpy().astype(np.float32)
        truth, scale_e = window.light_e.astype(np.float32), 1.0
        measurement = np.zeros(truth.shape[1:], np.float32)
        if name == "any":
            # It weighs the sensor's noise, and needs no unit.
            frame = frame_of(window.light_e, tile, sensor, 1000 * seed + index).numpy()
            clip = decoded_clip(Measured.read(frame, mask, sensor))[0].double().numpy()
            return clip, perf_counter() - begin
        if method.sees == "capture":
            # In units of the source's white a slot, for which the weight of TV is meant.
            scale_e = window.scale_e
            frame = frame_of(window.light_e, tile, sensor, 1000 * seed + index).numpy()
            measurement = (frame * sensor.electrons_per_lsb / scale_e).astype(np.float32)
        made = method.run(measurement, mask, truth, ITERATIONS, WEIGHT)
        return made.astype(np.float64) * scale_e, perf_counter() - begin

    left_out: list[dict[str, Any]] = []
    every = list(scored(windows(files, protocol), decode, left_out))
    settings: dict[str, Any] = {}
    if name != "thin-out":
        settings = {key: values.tolist() for key, values in encoder.codes().items()}
        settings |= {"seed": seed, "shutter": codes}
    spent = 1e3 * sum(each.seconds for each in every) / max(1, len(every))
    subject = Subject(name, settings, sees=method.sees, decoder_ms=spent)
    return with_arrays(protocol, subject, files, every, left_out)
