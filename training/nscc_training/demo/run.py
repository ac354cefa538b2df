"""A scene through a shipped run: fitted to the array, exposed, reconstructed, drawn, written."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from importlib.util import find_spec
from pathlib import Path
from shlex import quote
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.compiler import compile_file, compile_source
from nscc.diagnostics.diagnostic import Rejected
from nscc.files import Product, write_together
from nscc.pipeline import Options
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.effects import selected
from nscc_runtime.formats import Content, file_of
from nscc_runtime.frame_file import FrameFile, meta
from nscc_runtime.pictures.sheet import png_of
from nscc_runtime.pieces import Taken, simulate_scene
from nscc_runtime.scenes import Fit, Laid, Scene
from nscc_runtime.sensor import Sensor, load_sensor
from nscc_runtime.simulate import Listener, Request
from nscc_training.demo.merge import dark_codes, merged_light
from nscc_training.demo.sheet import Shown, demo_sheet
from nscc_training.demo.subject import Subject, subject
from nscc_training.run_files import RunCapture, run_capture

BUILTIN = ("builtin:hdr", "builtin:motion:0.15")
"""What is shown to those who name nothing."""
RUNS = {True: Path("hdr"), False: Path("clip")}
"""The run for stills, and that for clips."""
_DARK_FRAMES, _DARK_SEED = 16, 1 << 20
"""Frames without light, whose mean is taken from every other, and how far their seed is off."""
_BRIGHTER = ("@99", "@100")
"""Where the run's pixel of a scene is dark, one of these is given its electrons."""


@dataclass(frozen=True)
class Settings:
    """How a scene is shown.

    `exposure` is text as `--exposure` takes it (None: the run's), `tone` a curve (None: sRGB for
    what was made for screens, a logarithm for light), `learned` decodes by the run's decoder,
    which needs torch; else frames are merged.
    """

    fit: Fit = "scale"
    color: bool = False
    exposure: str | None = None
    tone: str | None = None
    seed: int = 0
    learned: bool = field(default_factory=lambda: find_spec("torch") is not None)


@dataclass(frozen=True)
class Demo:
    """What a demo left: its `files`, the sheet first, PSNR in dB of the always open pixels and of
    the reconstruction, and the commands that make the same step by step."""

    files: tuple[Path, ...]
    open_db: float
    psnr_db: float
    commands: tuple[str, ...]


def demo(
    scene: Scene, out: Path, settings: Settings | None = None, listener: Listener | None = None
) -> Demo:
    """Expose a scene with a run that comes with nscc under the default sensor; write what became
    of it into folder `out`.

    A still leaves `picture_sheet.png`, `picture.hdr`, `picture.png` and `picture_frame.npz`, a clip
    `clip_sheet.png`, `clip.mp4`, `clip.gif` and `clip_frame.npz`. Raises Rejected for scenes that
    cannot be read or are dark.
    """
    settings, listener = settings or Settings(), listener or Listener()
    # A clip that is taken frame by frame needs to know how many: those of the run for clips.
    clips = run_capture(RUNS[False])
    found = subject(scene, clips.slots, clips.slots * clips.slot_us * 1e-6)
    if found.chosen:
        listener.say(f"{Path(scene.name).name}: {found.chosen}")
    run = RUNS[found.still]
    like = run_capture(run)
    compiled = compile_file(like.program, Options()).container
    assert compiled is not None  # a run's program has compiled before
    sensor = load_sensor(compiled.target, like.sensor)
    laid, exposed = _laid(found, like, compiled, settings, listener)
    request = Request(selected("auto"), seed=settings.seed)
    begin = perf_counter()
    taken = simulate_scene(compiled, laid, sensor, request, listener)
    expose_s = perf_counter() - begin
    camera = _always_open(like)
    usual = simulate_scene(camera, laid, sensor, request, listener)
    dark = {which: _dark(which, sensor, settings, listener) for which in (compiled, camera)}
    out.mkdir(parents=True, exist_ok=True)
    name = "picture" if found.still else "clip"
    frame, dark_frame = out / f"{name}_frame.npz", out / f"{name}_dark.npz"
    keep = ("truth",) if len(laid) == 1 else ()
    write_together({
        frame: _frame_file(taken, keep).write, dark_frame: _frame_file(dark[compiled]).write,
    })  # fmt: skip
    light, decode_s, how = _reconstructed(
        run, (frame, dark_frame), taken, dark[compiled], sensor, settings
    )
    shown = Shown(
        title=Path(found.scene.name.partition(":")[2] or found.scene.name).name,
        still=found.still, display=found.transfer == "srgb", truth=_truth(laid, found.still),
        light=light, frame=_codes(taken, laid), usual=_codes(usual, laid),
        dark=dark_codes(dark[camera]),
        top=2**compiled.target.adc_bits - 1, lsb_e=sensor.electrons_per_lsb,
        white_e=_white_e(found, laid), tone=settings.tone,
        how=how, expose_s=expose_s, decode_s=decode_s,
    )  # fmt: skip
    content = Content(
        {"image" if found.still else "video": light}, light, not found.still, len(laid) > 1,
        tone=shown.curve, white=shown.fitted.white,
    )  # fmt: skip
    endings = (".hdr", ".png") if found.still else (".mp4", ".gif")
    products: dict[Path, Product] = {
        out / f"{name}_sheet.png": png_of(demo_sheet, shown),
        **{out / (name + end): file_of(out / (name + end), content, "it") for end in endings},
    }
    write_together(products)
    files = (*products, frame, dark_frame)
    return Demo(files, shown.open_db, shown.psnr_db, _commands(exposed, run, settings, files))


def _laid(
    found: Subject, like: RunCapture, container: Container, settings: Settings, listener: Listener
) -> tuple[tuple[Laid, ...], Scene]:
    """The scene's light, and the scene with the exposure that it was given."""
    scene = replace(found.scene, fit=settings.fit, color=settings.color)
    electrons, _, _ = like.exposure.partition("@")
    asked = (settings.exposure,) if settings.exposure else (
        like.exposure, *(electrons + brighter for brighter in _BRIGHTER))  # fmt: skip
    for exposure in asked:
        exposed = scene if found.in_electrons else replace(scene, exposure=exposure)
        try:
            laid = exposed.laid(
                container.slot_us, container.target, listener.warn, listener.progress
            )
        except Rejected as rejected:
            if exposure == asked[-1] or rejected.diagnostics[0].code != "NS0738":
                raise
            continue
        return laid, exposed
    raise AssertionError("there is an exposure to ask for")


def _always_open(like: RunCapture) -> Container:
    """An ordinary camera with the run's frame."""
    text = f"nsl 1\nframe {like.slots} slots of {like.slot_us:g}us\nopen when true\n"
    target = None if like.target is None else str(like.target)
    made = compile_source(Source("always_open.nsl", text), Path(), Options(level=1, target=target))
    assert made.container is not None  # one shutter fits wherever any does
    return made.container


def _truth(laid: Sequence[Laid], still: bool) -> NDArray[Any]:
    """Electrons over the frame (rows, cols), or a slot (T, rows, cols); colours last."""
    cut = [one.where.cut(one.light.total_e() if still else one.light.dense()) for one in laid]
    return cut[0] if len(cut) == 1 else np.stack(cut, axis=-1)


def _codes(taken: Taken, laid: Sequence[Laid]) -> NDArray[np.uint8]:
    """The frame's codes (rows, cols), or (rows, cols, 3) in colours."""
    codes = taken.simulated.frame.frame[..., 0, :, :]
    return codes if len(laid) == 1 else np.moveaxis(codes, 0, -1)


def _white_e(found: Subject, laid: Sequence[Laid]) -> float | None:
    """The light that a picture made for screens shows as white; None for others."""
    light = laid[0].light
    if found.transfer != "srgb":
        return None
    return float(light.weight.sum()) / (1 if found.still else light.slots)


def _dark(container: Container, sensor: Sensor, settings: Settings, listener: Listener) -> Taken:
    """Frames without light, with other noise than the scene's."""
    night = Scene("builtin:dark").laid(container.slot_us, container.target)
    seed = settings.seed + _DARK_SEED
    request = Request(selected("auto"), seed=seed, repeat=_DARK_FRAMES)
    return simulate_scene(container, night, sensor, request, listener)


def _frame_file(taken: Taken, keep: Sequence[str] = ()) -> FrameFile:
    simulated, light = taken.simulated, taken.light
    about = meta(taken.container, light, simulated.frame, simulated.origin) | taken.laid
    return FrameFile.of(taken.container, light, simulated.frame, about, keep)


def _reconstructed(
    run: Path,
    files: tuple[Path, Path],
    taken: Taken,
    dark: Taken,
    sensor: Sensor,
    settings: Settings,
) -> tuple[NDArray[np.float32], float, str]:
    """The light, in the shape of the truth; the seconds that it took; by what."""
    if settings.learned:
        from nscc_training.reconstruct import reconstruct

        frame, dark_frame = files
        made = reconstruct(run, frame, force=False, dark=dark_frame)
        return made.light, made.decode_s, "U-Net of run " + run.name
    begin = perf_counter()
    light, how = merged_light(taken, dark_codes(dark), sensor)
    return light, perf_counter() - begin, how


def _commands(
    scene: Scene, run: Path, settings: Settings, files: Sequence[Path]
) -> tuple[str, ...]:
    """What does the same step by step."""
    options = {
        "--scene": scene.name, "--exposure": scene.exposure, "--fit": scene.fit,
        "--fps": scene.fps, "--first": scene.first or None, "--transfer": scene.transfer,
        "--seed": settings.seed or None, "--effects": "auto",
    }  # fmt: skip
    said = [f"{name} {quote(str(value))}" for name, value in options.items() if value is not None]
    said += ["--color"] * scene.color
    product, frame, dark = (quote(files[k].as_posix()) for k in (1, -2, -1))
    seed = settings.seed + _DARK_SEED
    night = f"--scene builtin:dark --effects auto --repeat {_DARK_FRAMES} --seed {seed}"
    expose = f"nscc run --like {run} {' '.join(said)} -o {frame}"
    darkness = f"nscc run --like {run} {night} -o {dark}"
    decode = f"nscc reconstruct {run} {frame} --dark {dark} -o {product}"
    return (expose, darkness, decode) if settings.learned else (expose, darkness)
