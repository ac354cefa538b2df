"""The demo: expose, reconstruct, draw and write a scene."""

from __future__ import annotations

from pathlib import Path
from shlex import quote
from typing import NamedTuple

from nscc.arrays import Floats32
from nscc.files import Product, write_together
from nscc_runtime.formats import Content, file_of
from nscc_runtime.pictures.sheet import png_of
from nscc_runtime.progress import Progress
from nscc_runtime.scenes import Scene
from nscc_runtime.simulate import Listener
from nscc_training.command_settings import DemoSettings, Method
from nscc_training.demo.expose import DARK_FRAMES, DARK_SEED, Exposed, exposed
from nscc_training.demo.sheet import Shown, demo_sheet, readouts_text
from nscc_training.demo.subject import subject
from nscc_training.reconstruct_any import reconstruct_any
from nscc_training.run_files import run_capture

BUILTIN = ("builtin:hdr", "builtin:motion:0.15")
"""The built-in scenes that are shown if the user names none."""


class Demo(NamedTuple):
    """The results of a demo.

    `files` are the written files, the sheet first. PSNR in dB is given for always open pixels
    (`open_db`), the reconstruction (`psnr_db`), a still with pixels that look (`looked_db`), an
    ordinary camera at its best (`fair_db`: one stop for a still, a burst of `readouts` frames for a
    clip), and a still in an ordinary bracket (`bracket_db`); None where it does not apply.
    `commands` do the same step by step."""

    files: tuple[Path, ...]
    open_db: float
    psnr_db: float
    looked_db: float | None
    fair_db: float | None
    bracket_db: float | None
    readouts: int
    commands: tuple[str, ...]


def demo(
    scene: Scene, out: Path, settings: DemoSettings | None = None, listener: Listener | None = None
) -> Demo:
    """Expose a scene with a shipped run or that of `settings`, reconstruct it, and write both into
    the folder `out`, which is created. `settings` None takes the defaults; `listener` receives
    messages and progress, None ignores them.

    For a still, writes `picture_sheet.png`, `picture.hdr` and `picture.png`; for a clip,
    `clip_sheet.png`, `clip.mp4`, `clip.gif` and its program `clip.nsl`. Both have frame files
    `.._frame.npz` and `.._dark.npz`. Raises Rejected for scenes that cannot be read or are dark."""
    settings, listener = settings or DemoSettings(), listener or Listener()
    # A clip is cut to the slots and the frame time of its run; stills do not use them.
    clips = run_capture(settings.run or Path("clip"))
    scene_subject = subject(scene, clips.slots, clips.slots * clips.slot_us * 1e-6)
    if scene_subject.chosen and listener.say is not None:
        listener.say(f"{Path(scene.name).name}: {scene_subject.chosen}")
    exposed_scene = exposed(scene_subject, settings, listener)
    name = "picture" if exposed_scene.still else "clip"
    out.mkdir(parents=True, exist_ok=True)
    frames = (out / f"{name}_frame.npz", out / f"{name}_dark.npz")
    write_together(
        {path: file.write for path, file in zip(frames, exposed_scene.files(), strict=True)}
    )
    light, decode_s, how = _reconstructed(exposed_scene, frames, settings, listener.progress)
    shown = Shown(
        exposed_scene, scene_subject.transfer == "srgb", settings.tone, light, how, decode_s
    )
    content = Content(
        {"image" if exposed_scene.still else "video": light},
        light,
        not exposed_scene.still,
        len(exposed_scene.laid) > 1,
        tone=shown.curve,
        white=shown.fitted.white,
    )
    paths = [
        out / (name + end)
        for end in ((".hdr", ".png") if exposed_scene.still else (".mp4", ".gif"))
    ]
    products: dict[Path, Product] = {out / f"{name}_sheet.png": png_of(demo_sheet, shown)}
    products |= {path: file_of(path, content, "it") for path in paths}
    if exposed_scene.run is None:
        products[out / f"{name}.nsl"] = exposed_scene.program.read_bytes()
    write_together(products)
    files = (*products, *frames)
    return Demo(
        files,
        shown.open_db,
        shown.psnr_db,
        shown.looked_db,
        shown.fair_db,
        shown.bracket_db,
        exposed_scene.readouts,
        _commands(exposed_scene, settings, files),
    )


def _reconstructed(
    exposed_scene: Exposed, frames: tuple[Path, Path], settings: DemoSettings, progress: Progress
) -> tuple[Floats32, float, str]:
    """Return the reconstructed light in the shape of the truth, the seconds it took, and the name
    of the method.

    `frames` are the files of the coded frame and of its dark frames. The run that exposed the scene
    decodes; without one, the decoder for any code; and if the settings use no network, a method
    without one."""
    if settings.learned and exposed_scene.run is not None:
        from nscc_training.reconstruct import reconstruct

        reconstruction = reconstruct(exposed_scene.run, frames[0], force=False, dark=frames[1])
        how = f"{'U-Net of ' if settings.run is None else ''}run {exposed_scene.run.name}"
    else:
        reconstruction = reconstruct_any(
            frames[0], dark=frames[1], method=_method(exposed_scene, settings), progress=progress
        )
        how = {
            "network": f"{readouts_text(exposed_scene.readouts)}, decoder for any code",
            "merge": "neighbours merged",
            "gap-tv": "total variation (GAP-TV)",
        }[reconstruction.method]
    return reconstruction.light, reconstruction.decode_s, how


def _method(exposed_scene: Exposed, settings: DemoSettings) -> Method:
    """Return the method with which `nscc reconstruct any` reconstructs the scene: the network, or
    if the settings use none, merging for a still and GAP-TV for a clip."""
    if settings.learned:
        return "network"
    return "merge" if exposed_scene.still else "gap-tv"


def _commands(
    exposed_scene: Exposed, settings: DemoSettings, files: tuple[Path, ...]
) -> tuple[str, ...]:
    """Return three commands, with quoted arguments, that do the same as the demo, step by step:
    expose the scene, expose dark frames, reconstruct. `files` are the files that the demo wrote, in
    its order."""
    scene = exposed_scene.scene
    # The program, which is written without a run only, follows the sheet and two products.
    program = (
        quote(files[3].as_posix()) if exposed_scene.run is None else f"--like {exposed_scene.run}"
    )
    options = {
        "--scene": scene.name,
        "--exposure": scene.exposure,
        "--fit": scene.fit,
        "--fps": scene.fps,
        "--first": scene.first or None,
        "--transfer": scene.transfer,
        "--seed": settings.seed or None,
        "--effects": "auto",
    }
    scene_options = [
        f"{name} {quote(str(value))}" for name, value in options.items() if value is not None
    ]
    scene_options += ["--color"] * scene.color + ["--still"] * scene.single
    product, frame, dark = (quote(files[k].as_posix()) for k in (1, -2, -1))
    seed = settings.seed + DARK_SEED
    night = f"--scene builtin:dark --effects auto --repeat {DARK_FRAMES} --seed {seed}"
    expose = f"nscc run {program} {' '.join(scene_options)} -o {frame}"
    darkness = f"nscc run {program} {night} -o {dark}"
    decoder = exposed_scene.run or "any"
    if not settings.learned:
        decoder = f"any --method {_method(exposed_scene, settings)}"
    return expose, darkness, f"nscc reconstruct {decoder} {frame} --dark {dark} -o {product}"
