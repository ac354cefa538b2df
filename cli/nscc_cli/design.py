"""`nscc design`: compute a program for given scenes."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc.options import Options
from nscc_cli import options as shared
from nscc_cli.frames import scene_of, sensor_of
from nscc_cli.options import OUT
from nscc_cli.runtime_options import fit_option, placing_options
from nscc_cli.support import (
    NumberRange,
    common_command,
    progress,
    refuse_ignored,
    say,
    say_done,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from nscc.chips.target import Target
    from nscc_runtime.scenes.load import PlacedLight
    from nscc_training.design import Design
    from nscc_training.search.choose import Kind

_SVE_RISK = "sve-risk"
_CLIP_SLOTS, _STILL_SLOTS = 16, 256
_CLIP_PARTS = 16
"""The number of time intervals of a frame in which motion is measured."""


@common_command("design")
@shared.scenes_option(
    "A scene as in nscc run; for several scenes the errors are averaged in decibels."
)
@click.option(
    "--looks",
    type=click.IntRange(2, 32),
    metavar="K",
    help="Design pixels that look: K exposures; the last is the whole frame.",
)
@click.option(
    "--criterion",
    type=click.Choice(["mu", "linear", "log", _SVE_RISK]),
    help="The error to minimise: of the light on a mu-law curve (default), "
    "linear, or of its logarithm; sve-risk designs a fixed 2 x 2 tile "
    "of stops instead.",
)
@click.option(
    "--search",
    is_flag=True,
    help="Search all simple patterns of stops for stills, or "
    "codes for clips, judged by a decoder under every effect.",
)
@click.option(
    "--motion",
    type=click.Choice(["slow", "fast", "scene"]),
    help="Choose a code for clips by their motion: slow, fast, or as in the scenes.",
)
@click.option(
    "--max-words",
    type=NumberRange(0.1, 1000),
    default=4.0,
    show_default=True,
    help="With --motion: the largest mean number of words per slot.",
)
@click.option(
    "--slots",
    type=click.IntRange(2, 4096),
    help=f"Slots of the frame (default: {_STILL_SLOTS}, for clips {_CLIP_SLOTS}).",
)
@click.option(
    "--slot-us",
    type=NumberRange(0.01, 1e6),
    default=125.0,
    show_default=True,
    help="The length of each slot in microseconds.",
)
@shared.chip_option
@shared.declared(Options, "level", show=True)
@placing_options
@fit_option
@shared.sensor_options
@shared.section(
    shared.OUTPUT,
    click.option(
        "-o",
        "out",
        type=OUT,
        help="The program (default: looks-K.nsl, sve-risk.nsl, searched.nsl or motion-KIND.nsl).",
    ),
)
def command(
    scenes: tuple[str, ...],
    looks: int | None,
    criterion: str | None,
    search: bool,
    motion: Kind | None,
    level: int,
    out: Path | None,
    **options: Any,
) -> None:
    """Compute a program for scenes, write it, and print its expected error.

    --looks: each pixel closes at the first look that finds its light above a level. The times and
    levels minimize the expected error without a decoder, from the light of the scenes and the
    noise, converter, copies and comparators of the sensor. --criterion sve-risk: compares all 2 x
    2 tiles of half stops by the error that an ideal decoder cannot remove. --search: tries
    patterns of one to eight geometric stops on the emulated chip, or for clips bumps, mixtures
    and free bits in one and two readouts. --motion: compares bumps of
    several lengths and patterns by the information that a frame contains about moving light. The
    program is compiled and proved before it is written."""
    from nscc.chips.load import load_target
    from nscc.files import refuse_inputs, write_together
    from nscc.pipeline import KINDS
    from nscc_training.design import Frame, design_looks, design_pattern, design_tile

    tile = criterion == _SVE_RISK
    if tile + (looks is not None) + (motion is not None) + search != 1:
        raise click.UsageError(
            "name the design: --looks K for pixels that look, --criterion sve-risk for a "
            "fixed 2 x 2 tile, --search for the best of many codes, or --motion slow, fast or "
            "scene for clips"
        )
    if motion and criterion:
        raise click.UsageError("--criterion applies to stills: leave it out, or leave out --motion")
    if search and criterion:
        raise click.UsageError("--search counts PSNR: leave --criterion out")
    if not motion:
        refuse_ignored("it limits the codes of --motion", "max_words")
    target = load_target(options["target"], Path())
    of_clips = search and _are_clips(scenes, target, options)
    options["slots"] = options["slots"] or (_CLIP_SLOTS if motion or of_clips else _STILL_SLOTS)
    slots, slot_us, name = options["slots"], options["slot_us"], options["target"]
    if looks is not None and looks > slots:
        raise click.UsageError(f"{looks} exposures need {looks} boundaries; there are {slots}")
    default = f"motion-{motion}.nsl" if motion else f"looks-{looks}.nsl"
    path = out or Path("sve-risk.nsl" if tile else "searched.nsl" if search else default)
    sensor = sensor_of(target, options)
    frame = Frame(slots, slot_us, name, sensor, level)
    refuse_inputs(path)
    if motion:
        from nscc_training.search.choose import design_motion

        # `slow` and `fast` need no scene; if one is given, its light and texture are used.
        moving = (
            _moving(scenes, target, options, _CLIP_PARTS) if scenes or motion == "scene" else []
        )
        design: Design = design_motion(motion, moving, frame, options["max_words"])
    elif of_clips:
        from nscc_training.search.clip_codes import design_clip

        moving = _moving(scenes, target, options, slots)
        design = design_clip(moving, frame, lambda todo: progress(todo, "searching"))
    elif search:
        scene_lights = _scene_lights(scenes, target, options)
        design = design_pattern(scene_lights, frame, lambda todo: progress(todo, "searching"))
    elif looks is None:
        design = design_tile(_scene_lights(scenes, target, options), frame)
    else:
        curve = criterion or "mu"
        scene_lights = _scene_lights(scenes, target, options)
        design = design_looks(scene_lights, looks, frame, curve)  # type: ignore[arg-type]  # Choice
    say(design.compiled.diagnostics)
    write_together({path: design.text.encode()})
    click.echo(f"wrote {path.as_posix()}")
    for label, text in design.lines:
        click.echo(f"  {label:<9} {text}")
    say_done(KINDS.of(design.compiled.program).cost_text(design.compiled))


def _scene_lights(
    scenes: tuple[str, ...], target: Target, options: dict[str, Any]
) -> list[NDArray[np.float64]]:
    """Return the light of each scene over the frame in electrons (rows, cols), without the parts of
    the array that a smaller scene does not cover.

    `options` are those of the command."""
    return [laid.placement.cut(laid.light.total_e()) for laid in _laid(scenes, target, options)]


def _moving(
    scenes: tuple[str, ...], target: Target, options: dict[str, Any], parts: int
) -> list[NDArray[np.float64]]:
    """Return the light of each scene in electrons, (intervals, rows, cols): the slots of the frame,
    joined to at most `parts` intervals.

    `options` are those of the command."""
    slots = options["slots"]
    starts = sorted({slots * part // parts for part in range(parts)})
    return [
        laid.placement.cut(laid.light.joined(starts).dense())
        for laid in _laid(scenes, target, options)
    ]


def _are_clips(scenes: tuple[str, ...], target: Target, options: dict[str, Any]) -> bool:
    """Return whether any of the scenes is a clip; stills beside it are clips in which nothing
    moves. `options` are those of the command."""
    options = {**options, "slots": options["slots"] or _CLIP_SLOTS}
    return "clip" in [laid.light.kind for laid in _laid(scenes, target, options, warns=False)]


def _laid(
    scenes: tuple[str, ...], target: Target, options: dict[str, Any], warns: bool = True
) -> Iterator[PlacedLight]:
    """Yield each scene, placed on the chip's array and divided into the slots of the frame.
    `options` are those of the command.

    With `warns` False no warnings are printed, because another pass over the scenes prints them.
    Raises Rejected (NS0744) without a scene."""
    from nscc_runtime.scenes import laid_lights

    slot_us = [options["slot_us"]] * options["slots"]
    for name in scenes or (None,):
        scene = scene_of({**options, "scene": name}, "--scene is missing: a design needs a scene")
        [laid] = laid_lights(
            scene, slot_us, target, lambda diagnostic: say([diagnostic] * warns), progress
        )
        yield laid
