"""The pictures of the paper's Figs. 3, 5, 6, 7 and 8, made again from the runs that come with nscc.

A still and a clip are exposed by the emulated chip through a run's shutters and by pixels that are
always open, and decoded by the run. Light is in electrons, over the frame or a slot.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc_runtime.light import Light
from nscc_runtime.pictures.images import Image, image_sheet
from nscc_runtime.pictures.sheet import png_of
from nscc_runtime.pictures.tone import TONES, Tone, fitted
from nscc_runtime.scenes import Scene as Shown
from nscc_runtime.simulate import Request, simulate
from nscc_training.demo import BUILTIN
from nscc_training.demo.expose import RUNS, camera
from nscc_training.emulated import captures_on
from nscc_training.encoders import make_encoder
from nscc_training.evaluation.runs import seen_of
from nscc_training.loop.decoding import container_of, decoded_frame
from nscc_training.metrics import finite_mean, mu_psnr, psnr
from nscc_training.protocol_scenes.files import scenes_in
from nscc_training.protocol_scenes.hdr import ENDINGS
from nscc_training.protocol_scenes.scene import Scene
from nscc_training.protocols import load_protocol
from nscc_training.run_files import run_capture
from nscc_training.run_folder import RunFolder, load_run
from nscc_training.scene_files import CLIPS, files_in

_BUILTIN = dict(zip((True, False), BUILTIN, strict=True))
_MOMENTS = 4
_STOPS = {"low": 1 / 8, "middle": 1.0, "high": 8.0}
"""Exposures of a still, relative to one that shows its median as a middle grey."""
_GREY = 0.18
_ZOOM = 16
"""Pixels a side that a place of a tile is drawn with."""

Field = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class _Taken:
    """What came of a scene: `truth` and `made`, (rows, cols) of a still or (T, rows, cols) of a
    clip; `coded` and `usual`, the coded frame and that of always open pixels as greys, 0..255;
    `usual_light`, the light that the latter tell of, in the shape of the truth."""

    name: str
    truth: Field
    made: Field
    coded: NDArray[np.uint8]
    usual: NDArray[np.uint8]
    usual_light: Field


def figures(data: Path | None = None, effects: str = "auto", seed: int = 0) -> dict[str, bytes]:
    """PNG files by name: fig3_coded_frame, fig5_frames, fig6_shutters, fig7_exposures, fig8_tones.

    `data` holds panoramas and clips, or folders `hdr` and `video` of them: of the first crop of
    each panorama that one is shown whose brightest light is most above its median, and of the first
    window of each clip that in which most moves, but of files that the run has seen none. Without
    it, or where it has none of a kind, the scenes that are built in. `effects` as `nscc run` takes
    them. Raises Rejected: NS0756 for effects that there are not, NS0811 for a folder of neither.
    """
    runs = {still: load_run(path) for still, path in RUNS.items()}
    found = {
        kind: None if data is None else _scene_of(folder, data, kind)
        for kind, folder in runs.items()
    }
    if data is not None and not any(found.values()):
        raise rejected(
            "NS0811",
            f"'{data}' holds nothing to show",
            notes=(
                "what the runs learned from is not shown, nor what is smaller than their array",
            ),
            helps=("name a folder of panoramas and clips, or with folders hdr and video of them",),
        )
    still, clip = (_taken(folder, kind, found[kind], effects, seed)
                   for kind, folder in runs.items())  # fmt: skip
    drawn = {
        "fig3_coded_frame": ([_still_row(still)], f"{still.name}: one coded frame"),
        "fig5_frames": (_clip_rows(clip), f"{clip.name}: several frames from one"),
        "fig6_shutters": (_mosaics(runs, seed), "shutters, a tile of each code"),
        "fig7_exposures": (_exposures(still), f"{still.name}: low and high exposure of one frame"),
        "fig8_tones": (_tones(still), f"{still.name}: tone mapping"),
    }
    return {
        f"{name}.png": png_of(image_sheet, rows, title) for name, (rows, title) in drawn.items()
    }


def _taken(
    folder: RunFolder, still: bool, found: tuple[str, Scene] | None, effects: str, seed: int
) -> _Taken:
    """A scene that was found, or the built-in one: a run's frame and what it makes of that."""
    parts = folder.parts
    if found is None:
        like = run_capture(folder.path)
        target, slot_us = parts.target, (parts.chip.slot_us,) * parts.slots
        [laid] = Shown(_BUILTIN[still], exposure=like.exposure).laid(slot_us, target)
        name, light = _BUILTIN[still], laid.light
    else:
        name, scene = found
        light_e = np.asarray(scene.light_e, np.float32)
        weight = np.full(parts.slots, 1 / parts.slots)
        light = Light.of_still(light_e, weight) if still else Light.of_clip(light_e)
    truth = np.asarray(light.total_e() if still else light.dense(), np.float64)
    on = captures_on(parts.device)
    request = Request.of(effects=effects, seed=seed, device_seed=seed, torch_device=on)
    coded, usual = (
        simulate(container, light, parts.sensor, request).frame
        for container in (container_of(parts), camera(parts.slots, parts.chip.slot_us))
    )
    made = decoded_frame(parts, coded.frame[0], coded.saturated[0])
    flat = usual.frame[0] * parts.model.electrons_per_lsb / (1 if still else parts.slots)
    usual_light = np.broadcast_to(flat, truth.shape)
    codes = fitted("srgb", np.zeros(1), float(parts.model.top_code))
    greys = [codes(frame.frame[0]) for frame in (coded, usual)]
    return _Taken(name, truth, made.astype(np.float64), greys[0], greys[1], usual_light)


def _scene_of(folder: RunFolder, data: Path, still: bool) -> tuple[str, Scene] | None:
    """The scene that a figure shows of a folder, and its file's name; None without any."""
    protocol = load_protocol("hdr-v1" if still else "video-v1")
    endings, name = (ENDINGS, "hdr") if still else (CLIPS, "video")
    size = (folder.parts.target.rows, folder.parts.target.cols)
    scenes: list[tuple[float, str, Scene]] = []
    files = files_in(data / name, endings) or files_in(data, endings)
    seen = seen_of(folder, files)
    for path in (path for path in files if path not in seen):
        every = scenes_in([path], protocol)
        scene = next((each for each in every if isinstance(each, Scene)), None)
        if scene is not None and scene.light_e.shape[-2:] == size:
            scenes.append((_worth(scene.light_e), path.name, scene))
    if not scenes:
        return None
    _, shown, scene = max(scenes, key=lambda each: each[0])
    return shown, scene


def _worth(light_e: Field) -> float:
    """How much a scene has to show: the range of a still, the motion of a clip."""
    if light_e.ndim == 3:
        return float(np.abs(np.diff(light_e, axis=0)).mean() / max(light_e.mean(), 1e-9))
    return float(np.percentile(light_e, 99.9) / max(float(np.median(light_e)), 1e-9))


def _still_row(taken: _Taken) -> list[Image]:
    tone = fitted("log", taken.truth)
    return [
        Image(tone(taken.truth), "truth"),
        Image(tone(taken.usual_light), "always open", _mu(taken, taken.usual_light)),
        Image(taken.coded, "coded frame"),
        Image(tone(taken.made), "decoded", _mu(taken, taken.made)),
    ]


def _clip_rows(taken: _Taken) -> list[list[Image]]:
    tone = fitted("srgb", taken.truth)
    moments = np.linspace(0, len(taken.truth) - 1, _MOMENTS).round().astype(int)
    scores = finite_mean(
        psnr(tone(a) / 255.0, tone(b) / 255.0, 1.0)
        for a, b in zip(taken.truth, taken.made, strict=True)
    )
    return [
        [Image(taken.usual, "always open"), Image(taken.coded, "coded frame")],
        [Image(tone(taken.truth[k]), f"truth, frame {k + 1}") for k in moments],
        [
            Image(tone(taken.made[k]), f"decoded, frame {k + 1}",
                  f"PSNR {scores:.1f} dB over all frames" if k == 0 else "")
            for k in moments
        ],
    ]  # fmt: skip


def _mosaics(runs: dict[bool, RunFolder], seed: int) -> list[list[Image]]:
    """Rows of stills and of clips: codes at random, the 2 x 2 pattern, the run's own."""
    rows = []
    for still, folder in runs.items():
        spec, row = folder.parts.encoder.spec, []
        codes = {start: make_encoder(spec, start, seed) for start in ("random", "quad")}
        for name, encoder in {**codes, "run": folder.parts.encoder}.items():
            opened = encoder.hard().double().cpu().numpy()
            share, count = opened.mean(axis=0), np.arange(len(opened)) + 0.5
            when = np.tensordot(count, opened, 1) / np.maximum(opened.sum(axis=0), 1) / len(opened)
            title = {"quad": "2 x 2 pattern", "run": f"run {RUNS[still]}"}.get(name, name)
            # Stops span two decades: their root tells the short ones apart.
            shown = np.sqrt(share / share.max()) if still else when
            note = "bright is long" if still else "dark is early, bright late"
            grey = np.rint(255 * shown).astype(np.uint8)
            row.append(Image(np.kron(grey, np.ones((_ZOOM, _ZOOM), np.uint8)), title, note))
        rows.append(row)
    return rows


def _exposures(taken: _Taken) -> list[list[Image]]:
    """What cameras of three exposures would have made of the truth, of always open pixels' light
    and of the decoded: linear light, cut at white, on a screen."""
    white = max(float(np.median(taken.truth)), 1e-9) / _GREY
    rows = []
    for name, light in _lights(taken):
        tones = {stop: fitted("srgb", taken.truth, white / gain) for stop, gain in _STOPS.items()}
        rows.append(
            [Image(tone(light), f"{name}, {stop} exposure") for stop, tone in tones.items()]
        )
    return rows


def _tones(taken: _Taken) -> list[list[Image]]:
    """The same three by every curve, each fitted to the truth."""
    curves: Sequence[Tone] = [fitted(name, taken.truth) for name in TONES if name != "linear"]
    return [
        [Image(curve(light), f"{name}, {curve.name}") for curve in curves]
        for name, light in _lights(taken)
    ]


def _lights(taken: _Taken) -> tuple[tuple[str, Field], ...]:
    return ("truth", taken.truth), ("always open", taken.usual_light), ("decoded", taken.made)


def _mu(taken: _Taken, light: Field) -> str:
    peak = float(np.percentile(taken.truth, 99.9)) or 1.0
    return f"PSNR-mu {mu_psnr(taken.truth, light, peak):.1f} dB"
