"""`nscc tradeoff sensor`: measure PSNR against the shortest slot, for shutters on one chip."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import click

from nscc.lower.exposure_plan import LOWERINGS
from nscc.options import Options
from nscc_cli import options as shared
from nscc_cli.completion import EFFECTS
from nscc_cli.options import COUNT, some_option
from nscc_cli.support import CommonCommand, NumberRange, say_compiling
from nscc_cli.tradeoff_files import output_files, run_study


def _numbers(
    quantity: str, least: int, most: int, none: bool = True
) -> Callable[..., tuple[int, ...]]:
    """Return a callback for distinct numbers, separated by commas; with `none` also that word."""

    def numbers(context: click.Context, option: click.Parameter, value: str) -> tuple[int, ...]:
        if none and value.strip() == "none":
            return ()
        items = [item.strip() for item in value.split(",")]
        for item in items:
            if not (item.isdecimal() and least <= int(item) <= most):
                message = (
                    f"invalid number of {quantity} {item[:40]!r}: {least} to {most} are allowed"
                )
                raise click.BadParameter(message, context, option)
        return tuple(sorted({int(item) for item in items}))

    return numbers


_counts = _numbers("slots", 2, 4096, none=False)


def _divisors(context: click.Context, option: click.Parameter, value: str) -> tuple[int, ...]:
    """Parse numbers of slots that divide the largest, the number of a clip's frames."""
    counts = _counts(context, option, value)
    for count in counts:
        if counts[-1] % count:
            message = (
                f"{count} does not divide {counts[-1]}: all numbers of slots use the same clips"
            )
            raise click.BadParameter(message, context, option)
    return counts


@click.command("sensor", cls=CommonCommand)
@some_option("--classes", ("b", "c", "d", "e", "codebook"), "CLASS,..",
             "Classes of shutters for clips.")  # fmt: skip
@click.option("--slots", callback=_divisors, metavar="N,..", default="8,16", show_default=True,
              help="Slots of a frame, for clips.")  # fmt: skip
@click.option("--stop-slots", callback=_counts, metavar="N,..", default="16,64", show_default=True,
              help="Slots of a frame for stills, which class b exposes.")  # fmt: skip
@click.option("--looks", callback=_numbers("exposures", 2, 32), metavar="K,..",
              default="2,5,9", show_default=True,
              help="Exposures of pixels that look, for stills, or none.")  # fmt: skip
@click.option("--readouts", callback=_numbers("readouts", 1, 4), metavar="K,..",
              default="1,2,3,4", show_default=True,
              help="Readouts of one exposure, for clips, or none.")  # fmt: skip
@some_option("--codes", ("fixed", "open"), "MODE,..",
             "Compile for the codes in use, for every legal one.")  # fmt: skip
@some_option("--lowerings", LOWERINGS, "NAME,..", "Lowerings.")
@shared.chip_option
@shared.declared(Options, level=1)
@click.option("--slot-us", type=NumberRange(0.01, 1e6), metavar="T", help="Capture with slots of "
              "this length instead of each configuration's shortest.")  # fmt: skip
@click.option("--effects", type=EFFECTS, default="auto", show_default=True, metavar="E",
              help="The sensor's effects, as nscc run takes them.")  # fmt: skip
@shared.made_scenes_option
@click.option("--scenes", "count", type=COUNT, default=1, show_default=True,
              help="Number of scenes of each kind.")  # fmt: skip
@shared.made_seed_option
@shared.tradeoff_options
def command(**options: Any) -> int:
    """Measure PSNR against the shortest possible slot of each shutter class, on one chip.

    Compiles every class with every number of slots, for known and for arbitrary codes, in each
    lowering; the number of words determines the shortest slot. The emulated chip captures the
    scenes. Clips are decoded by GAP-TV and stills by merging neighbours; nothing is trained. For
    pixels that look (looks-K of hdr-v1, and looks designed for the scenes) the light is exposure
    divided by open time, and the words and slot length of further looks are measured. Clips are
    also captured with several readouts of one exposure and compared with a burst of the same
    number of ordinary frames. Settings that do not fit the chip are marked in the table. Exits
    with status 1 if nothing fits."""
    from nscc_training.baselines.tv_loop import denoise
    from nscc_training.tradeoff.sensor import sensor_study

    files = output_files(options)
    study = sensor_study(options)
    say_compiling(denoise, "the loop of total variation")
    measured = run_study(study, files, options)
    return 0 if any(point.case != "readouts" for point in measured.points) else 1
