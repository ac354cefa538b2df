"""`nscc demo`: expose a photo or a clip, reconstruct it, and write pictures into a folder."""

from __future__ import annotations

import shlex
from pathlib import Path
from typing import Any

import click

from nscc.requirements import line_for
from nscc_cli.options import SCENE, declared, out_option, section, settings_from, tone_option
from nscc_cli.support import common_command, progress, say, say_done
from nscc_runtime.request import Request
from nscc_runtime.scene_settings import Scene
from nscc_runtime.simulate import Listener
from nscc_training.command_settings import DemoSettings


@common_command("demo")
@click.argument("scene", metavar="[PHOTO|CLIP]", required=False)
@out_option("The folder for the pictures (default: NAME_demo, or demo).", "DIR")
@section(SCENE, declared(Scene, fit="scale"), declared(Scene, "color", "exposure", "fps"))
@tone_option
@declared(DemoSettings)
@declared(Request, "seed", show=True)
def command(scene: str | None, out: Path | None, **options: Any) -> None:
    """Expose a photo or a clip with shutters that come with nscc, and reconstruct it.

    Writes a sheet with the ground truth, an ordinary exposure, the readout, the reconstruction and
    its error, and the reconstruction as a separate file. For a photo, the sheet also shows pixels
    that look at their light, which need no decoder, and an ordinary bracket of three readouts. For
    a clip with several readouts, it also shows a burst of the same number of ordinary frames.
    Without PHOTO, a built-in scene is exposed. Without --exposure, the light is scaled as in the
    training of the decoder."""
    if scene is not None and Path(scene).suffix.lower() in (".nsl", ".icw"):
        raise click.UsageError(
            f"'{scene}' is a program, and the demo exposes a photo or a clip with shutters of its "
            f"own: `nscc run {shlex.quote(scene)} --scene PHOTO` exposes with your program"
        )
    from nscc_training.demo import BUILTIN, demo, readouts_text

    named = {name: options[name] for name in ("fit", "exposure", "tone", "seed")}
    settings = settings_from(DemoSettings, options, color=bool(options["color"]), **named)
    if settings.run is not None and (settings.merge or settings.readouts):
        raise click.UsageError(
            "--run has its own decoder and readout: leave out --merge and --readouts"
        )
    if not settings.learned and (settings.readouts or 1) > 1:
        raise click.UsageError(
            "several readouts are joined by a decoder: leave out --merge, or install torch"
        )
    if not (settings.merge or settings.learned):
        say_done(f"without torch the frame is merged; {line_for('torch')} installs the decoder")
    folder = out or Path(f"{Path(scene).stem}_demo" if scene and ":" not in scene else "demo")
    listener = Listener(say_done, lambda diagnostic: say([diagnostic]), progress)
    # Only clips have several readouts.
    for name in (scene,) if scene else BUILTIN[1:] if settings.readouts else BUILTIN:
        result = demo(Scene(name, fps=options["fps"]), folder, settings, listener)
        say_done("\n".join(f"wrote {path.as_posix()}" for path in result.files))
        if result.looked_db is None:
            beside = f" from {readouts_text(result.readouts)}"
            ordinary = "a burst of as many ordinary frames"
        else:
            beside = f", by pixels that look {result.looked_db:.1f} dB"
            ordinary = "an ordinary camera with automatic exposure"
        if result.fair_db is not None:
            beside += f", {ordinary} {result.fair_db:.1f} dB"
        if result.bracket_db is not None:
            beside += f", bracket {result.bracket_db:.1f} dB"
        say_done(
            f"always open {result.open_db:.1f} dB, reconstructed {result.psnr_db:.1f} dB{beside}"
        )
        say_done("step by step:\n" + "\n".join(f"  {line}" for line in result.commands))
