"""`nscc design`: a program made for scenes: where its pixels look, or which stops they have."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc_cli import options as shared
from nscc_cli.completion import SCENE, TARGET
from nscc_cli.frames import scene_of, sensor_of
from nscc_cli.options import LEVEL, OUT
from nscc_cli.support import CommonCommand, NumberRange, done, progress, say

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from nscc.target.target import Target
    from nscc_training.design import Design

_CURVES = ("mu", "linear", "log")
_SVE_RISK = "sve-risk"
_MOST_LOOKS = 32
_MOST_SLOTS = 4096


@click.command("design", cls=CommonCommand)
@click.option("--scene", "scenes", type=SCENE, multiple=True, metavar="SCENE",
              help="A scene as nscc run takes it; of several the mean of the decibels "
              "counts.")  # fmt: skip
@click.option("--looks", type=click.IntRange(2, _MOST_LOOKS), metavar="K",
              help="Design pixels that look: K exposures, the last the whole frame.")  # fmt: skip
@click.option("--criterion", type=click.Choice([*_CURVES, _SVE_RISK]), help="What is least: the "
              "square error of the light on a mu-law curve (default), as it is, of its logarithm; "
              "sve-risk designs a fixed 2 x 2 tile of stops instead.")  # fmt: skip
@click.option("--slots", type=click.IntRange(2, _MOST_SLOTS), default=256, show_default=True,
              help="Slots of the frame.")  # fmt: skip
@click.option("--slot-us", type=NumberRange(0.01, 1e6), default=125.0, show_default=True,
              help="The length of each.")  # fmt: skip
@click.option("--target", type=TARGET, default="scamp5", show_default=True,
              metavar="NAME|FILE.toml", help="The chip.")  # fmt: skip
@click.option("-O", "level", type=LEVEL, default=2, show_default=True,
              help="How long to search for fewer words.")  # fmt: skip
@shared.scene_options
@shared.fit_option("crop")
@shared.sensor_options
@click.option("-o", "out", type=OUT, help="The program (default: looks-K.nsl or sve-risk.nsl in "
              "this folder).")  # fmt: skip
def command(
    scenes: tuple[str, ...], looks: int | None, criterion: str | None, level: int,
    out: Path | None, **options: Any,
) -> None:  # fmt: skip
    """Write a program that is made for scenes, and say what it is expected to do.

    With --looks, pixels close at the first look that finds them above a level. Moments and levels
    are those of the least error that noise, converter, copies and comparators of the sensor let
    expect over the light that the scenes have, without a decoder. With --criterion sve-risk, every
    2 x 2 tile of half stops is tried for what an ideal decoder could not make good. The program is
    compiled and proved before it is written.
    """
    from nscc.emit.summary import cost_text
    from nscc.files import refuse_inputs, write_together
    from nscc.target.load import load_target
    from nscc_training.design import Frame, design_looks, design_tile

    tile = criterion == _SVE_RISK
    if tile == (looks is not None):
        raise click.UsageError(
            "name what to design: --looks K for pixels that look, or --criterion sve-risk for a "
            "fixed 2 x 2 tile"
        )
    slots, slot_us, name = options["slots"], options["slot_us"], options["target"]
    if looks is not None and looks > slots:
        raise click.UsageError(f"{looks} exposures end at as many boundaries; there are {slots}")
    path = out or Path("sve-risk.nsl" if tile else f"looks-{looks}.nsl")
    target = load_target(name, Path())
    sensor = sensor_of(target, options)
    seen = _seen(scenes, target, options)
    refuse_inputs(path)
    frame = Frame(slots, slot_us, name, sensor, level)
    if looks is None:
        made: Design = design_tile(seen, frame)
    else:
        curve = criterion or "mu"
        made = design_looks(seen, looks, frame, curve)  # type: ignore[arg-type]  # Choice
    say(made.compiled.diagnostics)
    write_together({path: made.text.encode()})
    click.echo(f"wrote {path.as_posix()}")
    for label, text in made.lines:
        click.echo(f"  {label:<9} {text}")
    done(cost_text(made.compiled))


def _seen(
    scenes: tuple[str, ...], target: Target, options: dict[str, Any]
) -> list[NDArray[np.float64]]:
    """The light of each scene (rows, cols): electrons over the frame."""
    slot_us = [options["slot_us"]] * options["slots"]
    found = []
    for name in scenes or (None,):
        scene = scene_of({**options, "scene": name}, "no scene to design for: --scene is missing")
        [laid] = scene.laid(slot_us, target, lambda told: say([told]), progress)
        found.append(laid.where.cut(laid.light.total_e()))
    return found
