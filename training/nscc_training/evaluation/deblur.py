"""Protocol deblur-v1: panoramas while the camera turns, and a sharp picture of one slot."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.scenes.colour import linear
from nscc_runtime.scenes.picture_files import read_picture
from nscc_training import metrics
from nscc_training.any_code.decode import decoded_clip
from nscc_training.any_code.measured import Measured
from nscc_training.data.camera import turned
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.evaluation.baseline_codes import codes_named
from nscc_training.evaluation.hdr import ENDINGS
from nscc_training.evaluation.results import Item, Scene, Subject, Unusable, scored, with_arrays
from nscc_training.measures import decibels, frame_scores
from nscc_training.protocols import Protocol, load_protocol
from nscc_training.scene_files import protocol_files
from nscc_training.sensor_model import SensorModel, frame_of, laid

Picture = NDArray[np.float64]
BASELINES = ("long", "short", "any")
_START = "poisson-disc"
_TILE = (8, 8)


@dataclass(frozen=True, eq=False)
class Moment(Scene):
    """A scene of the protocol: `light_e` (slots, rows, cols), electrons a slot."""

    file: Path
    number: int
    light_e: Picture
    protocol: Protocol

    @property
    def truth_e(self) -> Picture:
        """The light of the moment, as if it lasted for the whole frame."""
        return np.asarray(self.light_e[int(self.protocol["moment"])] * len(self.light_e))

    def item(self, result_e: Picture) -> Item:
        return Item(self.file.name, None, self.number, self.scores(result_e))

    def scores(self, result_e: Picture) -> dict[str, Any]:
        """Of a picture, or of the moment of a clip."""
        truth_e, protocol = self.truth_e, self.protocol
        if result_e.ndim == 3:
            result_e = result_e[int(protocol["moment"])] * len(result_e)
        peak = float(np.percentile(truth_e, protocol["normalise_percentile"]))
        truth, result = (np.clip(x / peak, 0.0, 1.0) for x in (truth_e, result_e))
        mu = metrics.mu_psnr(truth, result, 1.0, protocol["mu"])
        return {**frame_scores(truth, result, 1.0), "mu_psnr_db": decibels(mu)}


def panoramas(folder: Path) -> list[Path]:
    """The linear pictures of a folder by name; Rejected (NS0811) where there are none."""
    return protocol_files(
        folder,
        ENDINGS,
        "deblur-v1",
        "panoramas are files ending in",
        "linear panoramas, 512 x 1024",
    )


def moments(files: list[Path], protocol: Protocol) -> Iterator[Moment | Unusable]:
    """The views of panoramas, in order; a motion hangs on the numbers of panorama and view."""
    weights, slots = np.array(protocol["luminance"]), int(protocol["frames"])
    wanted_e = protocol.mid_grey_e
    assert wanted_e is not None
    for index, path in enumerate(files):
        picture = linear(read_picture(path), "linear")
        light = picture @ weights if picture.ndim == 3 else picture
        for number in range(int(protocol["views"])):
            if light.shape != tuple(protocol["panorama"]):
                reason = f"{light.shape}, not {tuple(protocol['panorama'])}"
                yield Unusable(path.name, {"view": number}, reason)
                continue
            drawn = np.random.default_rng((protocol["view_seed"], index, number))
            seen = np.maximum(light, 0.0).astype(np.float32)
            clip = turned(seen, drawn, slots, int(protocol["size"])).astype(np.float64)
            grey = float(np.median(clip.sum(axis=0)))
            if not (np.isfinite(clip).all() and grey > 0):
                yield Unusable(path.name, {"view": number}, "half of it is dark")
                continue
            yield Moment(path, number, clip * (wanted_e / grey), protocol)


def evaluate_deblur(
    name: str, folder: Path, seed: int = 0, codes: str = ""
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The result of a baseline on a folder of panoramas, and its pictures: arrays by name.

    `long`: always open, as it is read out, blur and all; `short`: open in the moment alone; `any`:
    class b on an 8 x 8 tile whose exposures are scattered by a Poisson-disc sampler, or codes as
    `codes_named` takes them, decoded as a clip by the decoder for any code.
    """
    protocol = load_protocol("deblur-v1")
    files = panoramas(folder)
    slots, sensor = int(protocol["frames"]), SensorModel.of_protocol(protocol)
    spec, start = ShutterSpec("b", slots, _TILE), _START
    if codes:
        spec, start = codes_named(codes, protocol, ("any",), name)
    encoder = make_encoder(spec, start, seed)
    if name != "any":
        stop = slots if name == "long" else 1
        encoder.load_codes({"stop": np.full(_TILE, stop)})
    tile = encoder.hard()
    opened = laid(tile, int(protocol["size"]), int(protocol["size"])).numpy().astype(np.float32)

    def decode(scene: Scene, index: int) -> tuple[Picture, float]:
        begin = perf_counter()
        frame = frame_of(scene.light_e, tile, sensor, 1000 * seed + index).numpy()
        if name == "any":
            clip = decoded_clip(Measured.read(frame, opened, sensor))[0].double().numpy()
            made = clip[int(protocol["moment"])] * slots
        else:
            made = frame.astype(np.float64) * (sensor.electrons_per_lsb * slots / stop)
        return made, perf_counter() - begin

    left_out: list[dict[str, Any]] = []
    every = list(scored(moments(files, protocol), decode, left_out))
    spent = 1e3 * sum(each.seconds for each in every) / max(1, len(every))
    settings = {key: values.tolist() for key, values in encoder.codes().items()}
    settings |= {"seed": seed, "shutter": codes or f"b:{_START}" if name == "any" else name}
    subject = Subject(name, settings, decoder_ms=spent)
    return with_arrays(protocol, subject, files, every, left_out)
