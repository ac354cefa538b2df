"""`nscc tradeoff sensor`: PSNR against the shortest slot, for shutters that one memory holds."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import click

from nscc.lower.plan import LOWERINGS
from nscc.tradeoff.points import csv_text, table_text
from nscc_cli import options as shared
from nscc_cli.completion import EFFECTS, TARGET
from nscc_cli.options import COUNT, LEVEL, some_option
from nscc_cli.support import CommonCommand, NumberRange, progress, say_compiling
from nscc_cli.tradeoff_files import kept_rows, output_files, write_files

_CLASSES = ("b", "c", "d", "e", "codebook")
_CODES = ("fixed", "open")
_MOST_SLOTS = 4096
_MOST_EXPOSURES = 32


def _counts(context: click.Context, option: click.Parameter, value: str) -> tuple[int, ...]:
    """Numbers of slots, separated by commas, from few to many."""
    parts = [part.strip() for part in value.split(",")]
    for part in parts:
        if not (part.isdecimal() and 2 <= int(part) <= _MOST_SLOTS):
            message = f"{part[:40]!r} is no number of slots, 2 to {_MOST_SLOTS}"
            raise click.BadParameter(message, context, option)
    return tuple(sorted({int(part) for part in parts}))


def _divisors(context: click.Context, option: click.Parameter, value: str) -> tuple[int, ...]:
    """The same; each must divide the most, which is the number of a clip's frames."""
    found = _counts(context, option, value)
    for count in found:
        if found[-1] % count:
            message = f"{count} does not divide {found[-1]}: all are slots of the same clips"
            raise click.BadParameter(message, context, option)
    return found


def _exposures(context: click.Context, option: click.Parameter, value: str) -> tuple[int, ...]:
    """Numbers of exposures a pixel, separated by commas, or `none`."""
    if value.strip() == "none":
        return ()
    parts = [part.strip() for part in value.split(",")]
    for part in parts:
        if not (part.isdecimal() and 2 <= int(part) <= _MOST_EXPOSURES):
            message = f"{part[:40]!r} is no number of exposures, 2 to {_MOST_EXPOSURES}"
            raise click.BadParameter(message, context, option)
    return tuple(sorted({int(part) for part in parts}))


@click.command("sensor", cls=CommonCommand)
@some_option("--classes", _CLASSES, "CLASS,..", "Classes of shutters for clips.")
@click.option("--slots", callback=_divisors, metavar="N,..", default="8,16", show_default=True,
              help="Slots of a frame, for clips.")  # fmt: skip
@click.option("--stop-slots", callback=_counts, metavar="N,..", default="16,64", show_default=True,
              help="Slots of a frame for stills, which class b exposes.")  # fmt: skip
@click.option("--looks", callback=_exposures, metavar="K,..", default="2,5,9", show_default=True,
              help="Exposures of pixels that look, for stills, or none.")  # fmt: skip
@some_option("--codes", _CODES, "MODE,..", "Compile for the codes in use, for every legal one.")
@some_option("--lowerings", LOWERINGS, "NAME,..", "Lowerings.")
@click.option("--target", type=TARGET, default="scamp5", show_default=True,
              metavar="NAME|FILE.toml",
              help="The chip.")  # fmt: skip
@click.option("-O", "level", type=LEVEL, default=1, show_default=True,
              help="How long to search for fewer words.")  # fmt: skip
@click.option("--slot-us", type=NumberRange(0.01, 1e6), metavar="T", help="Capture with slots of "
              "this length instead of each configuration's shortest.")  # fmt: skip
@click.option("--effects", type=EFFECTS, default="auto", show_default=True, metavar="E",
              help="The sensor's effects, as nscc run takes them.")  # fmt: skip
@shared.made_scenes_option
@click.option("--scenes", "count", type=COUNT, default=1, show_default=True,
              help="How many scenes of a kind.")  # fmt: skip
@shared.made_seed_option
@shared.tradeoff_options
def command(**options: Any) -> int:
    """Measure what slots buy: PSNR against the shortest slot of each shutter, on one chip.

    Every class in every number of slots, for codes in use and open ones, is compiled in each
    lowering; its words say how short a slot can be. The emulated chip captures the scenes with
    them. Clips are decoded by GAP-TV, stills by merging neighbours: nothing is trained. Of pixels
    that look (hdr-v1's rows looks-K, and ones designed for the scenes) an exposure over its time is
    the light: what more looks buy, in words and in the length of a slot. What does
    not fit the chip is a row that says so. Ends with status 1 where nothing fits.
    """
    from nscc_runtime.pictures.sheet import png_of
    from nscc_training.baselines.tv_loop import denoise
    from nscc_training.tradeoff.diagrams import sensor_diagram
    from nscc_training.tradeoff.sensor import Settings, measure, refusals_text

    files = output_files(options)
    named = {field.name for field in fields(Settings)} & options.keys()
    settings = Settings(**{name: options[name] for name in named})
    say_compiling(denoise, "the loop of total variation")
    with kept_rows(files, options) as rows:
        found = measure(settings, lambda todo: progress(todo, "capturing"), rows)
        if found.points:
            names = ("shutters", "slots", "PSNR, dB")
            click.echo(table_text(found.points, names, ("slot, us", 1e3)))
        for line in refusals_text(found.refused):
            click.echo(line)
        if not found.points:
            rows.done()
            return 1
        makers = {
            "csv": lambda: csv_text(found.points, found.target, found.refused).encode(),
            "png": lambda: png_of(sensor_diagram, found, settings.slot_us),
        }
        write_files(files, makers, rows)
    return 0
