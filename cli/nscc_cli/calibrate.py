"""`nscc calibrate`: write a sensor file, measured from flat and dark frames."""

from __future__ import annotations

from pathlib import Path

import click

from nscc.chips.load import load_target
from nscc.files import write_whole
from nscc_cli.options import PATH, json_option, out_option, target_option
from nscc_cli.programs import loaded
from nscc_cli.support import CommonCommand, NumberRange, progress, say, say_done

_DARK = "--dark"


class _Calibrate(CommonCommand):
    """The command `calibrate`, whose option `--dark` accepts several files (`--dark a b`), which
    click's options cannot."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Parse `args`, the arguments of the command, after rewriting `--dark a b` as `--dark a
        --dark b`.

        Every argument after `--dark` or `--dark=FILE` counts as a file, up to the next option."""
        spread_args: list[str] = []
        after_dark, has_no_file = False, False
        for arg in args:
            if arg.startswith("-") and arg != "-":
                # A `--dark` without files stays, so that click reports it.
                if after_dark and has_no_file:
                    spread_args.append(_DARK)
                after_dark = has_no_file = arg == _DARK
                if not after_dark:
                    spread_args.append(arg)
                    after_dark = arg.startswith(_DARK + "=")
                continue
            spread_args += [_DARK, arg] if after_dark else [arg]
            has_no_file = False
        lacks_file = after_dark and has_no_file
        return super().parse_args(ctx, [*spread_args, _DARK] if lacks_file else spread_args)


@click.command(name="calibrate", cls=_Calibrate)
@click.argument("flats", nargs=-1, required=True, metavar="FLATS..")
@click.option(
    _DARK,
    "darks",
    multiple=True,
    required=True,
    metavar="DARKS..",
    help="Frames without light: every file up to the next option.",
)
@out_option("The sensor file to write.", "sensor.toml", required=True)
@json_option("Print all results as JSON.")
@click.option(
    "--program",
    type=PATH,
    metavar="FILE.nsl|FILE.icw",
    help="The program that exposed the frames: its reads and words are counted.",
)
@click.option(
    "--crosstalk",
    type=NumberRange(0, 0.2),
    metavar="C",
    help="Take crosstalk as known (0: as EMVA 1288 does) instead of measuring it.",
)
@target_option("The chip: the bits of its ADC, and the defaults.")
def command(
    flats: tuple[str, ...],
    darks: tuple[str, ...],
    out: Path,
    as_json: bool,
    program: Path | None,
    crosstalk: float | None,
    target: str,
) -> None:
    """Measure a sensor by photon transfer, from flat and dark frames at several exposures.

    Each of FLATS and DARKS is one exposure level: two or more frames with the same light and
    exposure time. A level is a frame file (nscc run --repeat K), an array of converter codes
    (rows, cols) or (K, rows, cols) in .npz, .npy or .mat, a picture, or a folder of pictures.
    PATH@TIME, for example flats/3@2ms, gives the exposure time; frame files contain it."""
    from nscc_runtime import calibrate

    chip = load_target(target, Path())
    chain = calibrate.Chain()
    if program is not None:
        chain = calibrate.Chain.of(loaded(program, {}))
    calibration = calibrate.calibrate_files(flats, darks, chip, crosstalk, progress)
    chosen = calibrate.parameters(calibration, chip, chain)
    say(calibrate.messages(calibration))
    shown = calibrate.as_json(calibration, chosen) if as_json else calibrate.as_table(calibration)
    write_whole(out, calibrate.as_toml(calibration, chosen).encode())
    click.echo(shown)
    say_done(f"wrote {out}")
