"""`nscc design`: compute a program for given scenes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc.mappings import NamedValues
from nscc.options import Options
from nscc_cli import options as shared
from nscc_cli.frames import scene_of, sensor_of
from nscc_cli.options import out_option
from nscc_cli.runtime_options import fit_option, placing_options
from nscc_cli.support import common_command, progress, refuse_ignored, say, say_done
from nscc_training.command_settings import DesignSettings

if TYPE_CHECKING:
    from nscc.arrays import Floats
    from nscc.chips.target import Target
    from nscc_runtime.scenes.load import PlacedLight
    from nscc_training.design import Design

_SVE_RISK = "sve-risk"
_CLIP_SLOTS, _STILL_SLOTS = 16, 256
_CLIP_PARTS = 16
"""The number of time intervals of a frame in which motion is measured."""


@common_command("design")
@shared.scenes_option(
    "A scene as in nscc run; for several scenes the errors are averaged in decibels."
)
@shared.declared(DesignSettings, show=True)
@shared.chip_option
@shared.declared(Options, "level", show=True)
@placing_options
@fit_option
@shared.sensor_options
@shared.section(
    shared.OUTPUT,
    out_option(
        "The program (default: looks-K.nsl, sve-risk.nsl, searched.nsl or motion-KIND.nsl)."
    ),
)
def command(scenes: tuple[str, ...], out: Path | None, **options: Any) -> None:
    """Compute a program for scenes, write it, and print its expected error.

    --looks: each pixel closes at the first look that finds its light above a level. The times and
    levels minimize the expected error without a decoder, from the light of the scenes and the
    noise, converter, copies and comparators of the sensor. --criterion sve-risk: compares all 2 x
    2 tiles of half stops by the error that an ideal decoder cannot remove. --search: tries
    patterns of one to eight geometric stops on the emulated chip, or for clips bumps, mixtures
    and free bits in one and two readouts, then changes of the best. --motion: compares bumps of
    several lengths and patterns by the information that a frame contains about moving light. The
    program is compiled and proved before it is written."""
    from nscc.chips.load import load_target
    from nscc.files import refuse_inputs, write_together
    from nscc.pipeline import KINDS

    wanted = shared.settings_from(DesignSettings, options)
    name = _file_name(wanted)
    target = load_target(options["target"], Path())
    of_clips = wanted.motion is not None or (wanted.search and _are_clips(scenes, target, options))
    slots = options["slots"] = wanted.slots or (_CLIP_SLOTS if of_clips else _STILL_SLOTS)
    if wanted.looks is not None and wanted.looks > slots:
        message = f"{wanted.looks} exposures need {wanted.looks} boundaries; there are {slots}"
        raise click.UsageError(message)
    path = out or Path(name)
    refuse_inputs(path)
    design = _designed(replace(wanted, slots=slots), of_clips, scenes, target, options)
    say(design.compiled.diagnostics)
    write_together({path: design.text.encode()})
    click.echo(f"wrote {path.as_posix()}")
    for label, text in design.lines:
        click.echo(f"  {label:<9} {text}")
    say_done(KINDS.of(design.compiled.program).cost_text(design.compiled))


def _file_name(wanted: DesignSettings) -> str:
    """Return the file name of the program that `wanted` describes; raise UsageError unless exactly
    one design is chosen, with options that apply to it."""
    tile = wanted.criterion == _SVE_RISK
    names = {
        f"looks-{wanted.looks}.nsl": wanted.looks is not None,
        "sve-risk.nsl": tile,
        "searched.nsl": wanted.search,
        f"motion-{wanted.motion}.nsl": wanted.motion is not None,
    }
    chosen = [name for name, is_chosen in names.items() if is_chosen]
    if len(chosen) != 1:
        raise click.UsageError(
            "name the design: --looks K for pixels that look, --criterion sve-risk for a "
            "fixed 2 x 2 tile, --search for the best of many codes, or --motion slow, fast or "
            "scene for clips"
        )
    if wanted.criterion and wanted.motion:
        raise click.UsageError("--criterion applies to stills: leave it out, or leave out --motion")
    if wanted.criterion and wanted.search:
        raise click.UsageError(
            "--search compares codes by their PSNR: leave --criterion or --search out"
        )
    if wanted.motion is None:
        refuse_ignored("it limits the codes of --motion", "max_words")
    if not wanted.search:
        refuse_ignored("it changes the best candidate of --search", "trials")
    return chosen[0]


def _designed(
    wanted: DesignSettings,
    of_clips: bool,
    scenes: tuple[str, ...],
    target: Target,
    options: NamedValues,
) -> Design:
    """Return the design that `wanted` describes, for the `scenes` (names or paths) and a frame of
    `wanted.slots`; `of_clips` searches a code for clips.

    `options` are those of the command. Raises Rejected (NS0744) without a scene, unless the motion
    is slow or fast."""
    from nscc_training.design import Frame, design_looks, design_pattern, design_tile

    assert wanted.slots is not None
    sensor = sensor_of(target, options)
    frame = Frame(wanted.slots, wanted.slot_us, options["target"], sensor, options["level"])
    searching = partial(progress, label="searching")
    if wanted.motion:
        from nscc_training.search.choose import design_motion

        # `slow` and `fast` need no scene; if one is given, its light and texture are used.
        uses_scene = scenes or wanted.motion == "scene"
        moving = _moving(scenes, target, options, _CLIP_PARTS) if uses_scene else []
        return design_motion(wanted.motion, moving, frame, wanted.max_words)
    if of_clips:
        from nscc_training.search.clip_codes import design_clip

        clips = _moving(scenes, target, options, wanted.slots)
        return design_clip(clips, frame, searching, wanted.trials)
    laid_scenes = _laid(scenes, target, options)
    scene_lights = [laid.placement.cut(laid.light.total_e()) for laid in laid_scenes]
    if wanted.search:
        return design_pattern(scene_lights, frame, searching, wanted.trials)
    if wanted.looks is None:
        return design_tile(scene_lights, frame)
    curve = wanted.criterion or "mu"
    return design_looks(scene_lights, wanted.looks, frame, curve)  # type: ignore[arg-type]  # no sve-risk


def _moving(
    scenes: tuple[str, ...], target: Target, options: NamedValues, parts: int
) -> list[Floats]:
    """Return the light of each of `scenes` (names or paths) in electrons, (intervals, rows, cols):
    the slots of the frame, joined to at most `parts` intervals.

    `options` are those of the command."""
    slots = options["slots"]
    # With fewer slots than parts, several parts begin at the same slot; the set drops them.
    starts = sorted({slots * part // parts for part in range(parts)})
    return [
        laid.placement.cut(laid.light.joined(starts).dense())
        for laid in _laid(scenes, target, options)
    ]


def _are_clips(scenes: tuple[str, ...], target: Target, options: NamedValues) -> bool:
    """Return whether any of the scenes (names or paths) is a clip; stills beside it are clips in
    which nothing moves. `options` are those of the command."""
    options = {**options, "slots": options["slots"] or _CLIP_SLOTS}
    return "clip" in [laid.light.kind for laid in _laid(scenes, target, options, warns=False)]


def _laid(
    scenes: tuple[str, ...], target: Target, options: NamedValues, warns: bool = True
) -> Iterator[PlacedLight]:
    """Yield each of `scenes` (names or paths), placed on the chip's array and divided into the
    slots of the frame. `options` are those of the command.

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
