"""Figs. 5, 6 and 7 of the paper, from the runs that come with nscc.

The emulated chip exposes a still and a clip with a run's shutters and with always open pixels, and
the run decodes them. Light is in electrons, over the frame or per slot."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path
from typing import NamedTuple

import numpy as np

from nscc.arrays import Bytes, Floats
from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.pictures.images import Image, image_sheet
from nscc_runtime.pictures.sheet import png_of
from nscc_runtime.pictures.tone import fitted
from nscc_runtime.request import Request
from nscc_runtime.scenes import Scene as Shown
from nscc_runtime.scenes import laid_lights
from nscc_runtime.simulate import simulate
from nscc_training.command_settings import FigureSettings
from nscc_training.demo import BUILTIN
from nscc_training.demo.expose import RUNS
from nscc_training.design.bracket import camera
from nscc_training.emulated import light_on_array
from nscc_training.encoders import make_encoder
from nscc_training.evaluation.runs import seen_of
from nscc_training.loop.decoding import decoded_frame
from nscc_training.metrics import finite_mean, mu_psnr, psnr
from nscc_training.protocol_scenes.file_scenes import readable, scenes_in
from nscc_training.protocol_scenes.panoramas import ENDINGS
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene
from nscc_training.protocols import load_protocol
from nscc_training.run_files import run_capture
from nscc_training.run_folder import RunFolder, load_run
from nscc_training.scene_files import CLIPS, files_in

_BUILTIN = dict(zip((True, False), BUILTIN, strict=True))
_SHOWN = re.compile(r"(?P<light>[a-z]+):(?P<curve>[a-z-]+)(@(?P<gain>[0-9.]+))?(#(?P<frame>\d+))?")
"""A picture in the layout: light, tone curve, gain and frame."""
_GREY = 0.18
"""Relative brightness of the median of a still at an exposure of 1."""
_ZOOM = 16
"""Side in pixels of a place of a tile in mosaics."""


class _Shot(NamedTuple):
    """The images of one scene, called `name` in the titles of figures.

    `light` has three entries: "truth", the scene's light; "open", what always open pixels measure;
    "decoded", the reconstruction. Each is (rows, cols) for a still, in electrons over the frame, or
    (T, rows, cols) for a clip, in electrons per slot. `frames` are the readouts (rows, cols) of the
    coded pixels, "coded", and of always open ones, "always-open", as uint8 for the screen."""

    name: str
    light: Mapping[str, Floats]
    frames: Mapping[str, Bytes]

    def image(self, shown: str) -> Image:
        """Return the picture that a layout in `figures.toml` calls `shown`: the name of a frame, or
        LIGHT:CURVE[@GAIN][#FRAME], which is light, a tone curve, a factor on the light, and the
        number of a frame of a clip (0 is the first; beyond the last, the last). The score stands
        below a still, and below frame 0 of a clip; the truth has none."""
        if shown in self.frames:
            return Image(self.frames[shown], shown.replace("-", " "))
        match = _SHOWN.fullmatch(shown)
        assert match is not None, shown
        truth, light = self.light["truth"], self.light[match["light"]]
        name, white = match["light"].replace("open", "always open"), None
        title = f"{name}, {match['curve']}"
        if match["gain"]:
            white = max(float(np.median(truth)), 1e-9) / _GREY / float(match["gain"])
            title = f"{name}, exposure {match['gain']}"
        tone = fitted(match["curve"], truth, white)
        if not match["frame"]:
            return Image(tone(light), title, "" if light is truth else self._score(light))
        k = min(int(match["frame"]), len(truth) - 1)
        note = "" if light is truth or k else self._score(light)
        return Image(tone(light[k]), f"{name}, frame {k + 1}", note)

    def _score(self, light: Floats) -> str:
        """Return the PSNR of reconstructed light, of the shape of the truth, as text: mu-law PSNR
        for a still, the mean over frames in display encoding for a clip."""
        truth = self.light["truth"]
        if truth.ndim == 2:
            # A picture without light has no peak; any is right.
            peak = float(np.percentile(truth, 99.9)) or 1.0
            return f"PSNR-mu {mu_psnr(truth, light, peak):.1f} dB"
        tone = fitted("srgb", truth)
        pairs = zip(truth, light, strict=True)
        mean = finite_mean(psnr(tone(a) / 255.0, tone(b) / 255.0, 1.0) for a, b in pairs)
        return f"PSNR {mean:.1f} dB over all frames"


def figures(settings: FigureSettings) -> dict[str, bytes]:
    """Return the bytes of PNG files by their file names, the names in `figures.toml` with ".png".

    `data` of `settings` contains panoramas and clips, or folders `hdr` and `video` with them. The
    figures show the first crop with the largest ratio of brightest light to median, and the first
    window with the most motion. Files that the run was trained on are not used. Without `data`, or
    without a suitable file, built-in scenes are shown. Raises Rejected: NS0756 for unknown effects,
    NS0811 for a folder without scenes."""
    data = settings.data
    # Without data of the user, the built-in scenes are shown (None).
    runs = {still: load_run(path) for still, path in RUNS.items()}
    scenes = {
        kind: None if data is None else _scene_of(folder, data, kind)
        for kind, folder in runs.items()
    }
    if data is not None and not any(scenes.values()):
        raise rejected(
            "NS0811",
            f"'{data}' contains no scenes to show",
            notes=(
                "scenes that the runs were trained on, and scenes smaller than their array, "
                "are not shown",
            ),
            helps=("name a folder of panoramas and clips, or with folders hdr and video of them",),
        )
    shots = {
        "still" if kind else "clip": _shot_of(folder, kind, scenes[kind], settings)
        for kind, folder in runs.items()
    }
    layout = files("nscc_training.evaluation") / "figures.toml"
    pngs = {}
    for name, figure in tomllib.loads(layout.read_text(encoding="utf-8")).items():
        if "scene" in figure:
            scene = shots[figure["scene"]]
            rows = [[scene.image(shown) for shown in row.split()] for row in figure["rows"]]
            title = f"{scene.name}: {figure['title']}"
        else:
            rows, title = _mosaics(runs, settings.seed), figure["title"]
        pngs[f"{name}.png"] = png_of(image_sheet, rows, title)
    return pngs


def _shot_of(
    folder: RunFolder,
    still: bool,
    found_scene: tuple[str, ProtocolScene] | None,
    settings: FigureSettings,
) -> _Shot:
    """Expose a scene on the emulated chip twice, with the run's shutters and with always open
    pixels. Reconstruct the first exposure with the run in `folder`, and return all images.

    `found_scene` is the scene's name and the scene itself; None takes the built-in scene. `still`
    says whether it is a still (True) or a clip (False). `settings` are the chip's effects and the
    seed of its noise and fixed patterns."""
    setup = folder.setup
    if found_scene is None:
        like = run_capture(folder.path)
        target, slot_us = setup.target, (setup.chip.slot_us,) * setup.slots
        [laid] = laid_lights(Shown(_BUILTIN[still], exposure=like.exposure), slot_us, target)
        name, light = _BUILTIN[still], laid.light
    else:
        name, scene = found_scene
        light = light_on_array(scene.light_e, setup.slots, setup.target)
    truth = np.asarray(light.total_e() if still else light.dense(), np.float64)
    seed = settings.seed
    request = Request.of(effects=settings.effects, seed=seed, device_seed=seed)
    coded, usual = (
        simulate(container, light, setup.sensor, request).frame
        for container in (setup.compiled().built, camera(setup.slots, setup.chip.slot_us))
    )
    # frame[0], saturated[0]: the only bucket.
    decoded_light = decoded_frame(setup, coded.frame[0], coded.saturated[0])
    # Always open pixels do not tell when light arrived: every slot of a clip gets an equal part.
    flat = usual.frame[0] * setup.model.electrons_per_lsb / (1 if still else setup.slots)
    usual_light = np.broadcast_to(flat, truth.shape)
    # Converter codes are shown with the top code as white; the fitted values (0) do not matter
    # then.
    codes = fitted("srgb", np.zeros(1), float(setup.model.top_code))
    frames = {
        name: codes(frame.frame[0]) for name, frame in (("coded", coded), ("always-open", usual))
    }
    shown = {"truth": truth, "open": usual_light, "decoded": decoded_light.astype(np.float64)}
    return _Shot(name, shown, frames)


def _scene_of(folder: RunFolder, data: Path, still: bool) -> tuple[str, ProtocolScene] | None:
    """Return the file name and the scene that a figure shows: of the first scenes in the files that
    the run has not seen, the most suitable one.

    `still` chooses panoramas instead of clips. Returns None if the folder `data` has no scene of
    the array's size."""
    protocol = load_protocol("hdr-v1" if still else "video-v1")
    endings, name = (ENDINGS, "hdr") if still else (CLIPS, "video")
    size = (folder.setup.target.rows, folder.setup.target.cols)
    scenes: list[tuple[float, str, ProtocolScene]] = []
    paths = files_in(data / name, endings) or files_in(data, endings)
    seen_paths = seen_of(folder, paths)
    for path in (path for path in paths if path not in seen_paths):
        scene = next(readable(scenes_in([path], protocol)), None)
        if scene is not None and scene.light_e.shape[-2:] == size:
            scenes.append((_worth(scene.light_e), path.name, scene))
    if not scenes:
        return None
    _, shown, scene = max(scenes, key=lambda candidate: candidate[0])
    return shown, scene


def _worth(light_e: Floats) -> float:
    """Return how suitable a scene is for a figure: the ratio of the brightest light to the median
    for a still, and the mean change between frames, relative to the mean light, for a clip (T,
    rows, cols). Larger is better."""
    if light_e.ndim == 3:
        return float(np.abs(np.diff(light_e, axis=0)).mean() / max(light_e.mean(), 1e-9))
    return float(np.percentile(light_e, 99.9) / max(float(np.median(light_e)), 1e-9))


def _mosaics(runs: dict[bool, RunFolder], seed: int) -> list[list[Image]]:
    """Return for each of the `runs` (key: whether it decodes stills) a row of pictures of shutters:
    random codes drawn with `seed`, the 2 x 2 tile, and the run's codes. A pixel shows how long or
    when its shutter is open."""
    rows = []
    for still, folder in runs.items():
        spec, row = folder.setup.encoder.spec, []
        codes = {start: make_encoder(spec, start, seed) for start in ("random", "quad")}
        for name, encoder in {**codes, "run": folder.setup.encoder}.items():
            opened = encoder.hard().double().cpu().numpy()
            # The middle of each slot, in slots.
            share, count = opened.mean(axis=0), np.arange(len(opened)) + 0.5
            mean_time = (
                np.tensordot(count, opened, 1) / np.maximum(opened.sum(axis=0), 1) / len(opened)
            )
            title = {"quad": "2 x 2 tile", "run": f"run {RUNS[still]}"}.get(name, name)
            # Stops span two decades: the square root makes short stops distinguishable.
            shown = np.sqrt(share / share.max()) if still else mean_time
            note = "bright is long" if still else "dark is early, bright late"
            grey = np.rint(255 * shown).astype(np.uint8)
            row.append(Image(np.kron(grey, np.ones((_ZOOM, _ZOOM), np.uint8)), title, note))
        rows.append(row)
    return rows
