"""Options that several commands share."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import click
from click import Choice, Context, IntRange, Parameter, argument, option

from nscc_cli.completion import SETTING, TARGET
from nscc_cli.support import NumberRange, OutPath

Command = TypeVar("Command", bound=Callable[..., Any])

PATH = click.Path(path_type=Path)
OUT = OutPath()
LEVEL = IntRange(0, 3)
SEED = IntRange(0, 2**63 - 1)
COUNT = IntRange(1, 1000)
"""A number of scenes or of repeated measurements."""

DEFAULT_BAUD = 3_000_000
DEFAULT_PATIENCE_S = 10.0


def together(*options: Callable[[Any], Any]) -> Callable[[Command], Command]:
    """Combine several options into one decorator; `--help` lists them in this order."""

    def add(function: Command) -> Command:
        for decorator in reversed(options):
            function = decorator(function)
        return function

    return add


def section(title: str, *options: Callable[[Any], Any]) -> Callable[[Command], Command]:
    """Combine several options into one decorator; `--help` lists them under this title."""

    def add(function: Command) -> Command:
        known = list(getattr(function, "__click_params__", ()))
        function = together(*options)(function)
        for parameter in function.__click_params__:  # type: ignore[attr-defined]  # of click
            if parameter not in known:
                parameter.section = title
        return function

    return add


SCENE, EFFECTS, COMPILE, DEVICE, OUTPUT = "Scene", "Sensor effects", "Compile", "Device", "Output"
"""Titles of the option sections, in the order in which commands list them."""


def chosen_names(
    names: Sequence[str],
) -> Callable[[click.Context, click.Parameter, str], tuple[str, ...]]:
    """Return a callback that parses a comma-separated choice of `names`, in their order."""

    def chosen(context: click.Context, option: click.Parameter, value: str) -> tuple[str, ...]:
        chosen_set = {item.strip() for item in value.split(",")}
        for name in sorted(chosen_set.difference(names)):
            raise click.BadParameter(f"{name!r} is not one of {', '.join(names)}", context, option)
        return tuple(name for name in names if name in chosen_set)

    return chosen


def some_option(
    name: str, names: Sequence[str], metavar: str, text: str, default: str | None = None
) -> Callable[..., Any]:
    """Return an option that takes a comma-separated choice of `names`, by default all."""
    return option(
        name, callback=chosen_names(names), metavar=metavar, default=default or ",".join(names),
        show_default=True, help=text,
    )  # fmt: skip


program_argument = argument("program", metavar="FILE.nsl|FILE.icw", type=PATH)
pixels_option = section(COMPILE, option(
    "--pixels", type=PATH, help="The pixels' codes (.npz), or a mask (.npy .npz .mat)."
))  # fmt: skip

build_options = section(
    COMPILE,
    option("-O", "level", type=LEVEL,
           help="Effort of the search for fewer words (default: 2; check: 1)."),
    option("--codes", type=Choice(["fixed", "open"]),
           help="Compile for the codes in use, or for every legal one (default: fixed)."),
    option("--lowering", type=Choice(["auto", "accumulate", "latch", "edges"]),
           help="How the exposure is computed (default: auto, the cheapest)."),
    option("--target", type=TARGET, metavar="NAME|FILE.toml",
           help="The chip, instead of the chip in the program."),
    option("--cache/--no-cache", default=True,
           help="Store search results of -O2 and -O3 and reuse them (default), or search again."),
    option("--max-words-per-slot", metavar="W", type=IntRange(min=1),
           help="Reject programs that execute more words than this in any slot."),
)  # fmt: skip
"""Options that control the compiler; `nscc_cli.programs` reads them."""

link_options = section(
    DEVICE,
    option("--baud", type=IntRange(1200, 12_000_000), default=DEFAULT_BAUD, show_default=True,
           help="Speed of the device's port."),
    option("--patience", type=NumberRange(0.1, 3600), default=DEFAULT_PATIENCE_S,
           show_default=True,
              help="Seconds without an answer after which a device counts as lost."),
)  # fmt: skip
"""Options of commands that open a serial port."""

scene_options = section(
    SCENE,
    option("--exposure", metavar="E[@P]", help="Electrons over the frame at percentile P (99)."),
    option("--transfer", type=Choice(["linear", "srgb", "pq", "hlg"]), help="The scene's curve."),
    option("--white", type=float, metavar="W",
           help="The sample value of white, such as 4095 (default: the largest value of the "
               "type)."),
    option("--skip", is_flag=True, help="Leave out missing frames of a folder."),
    option("--bracket", is_flag=True,
           help="Merge photos with several exposures, a folder or 'DIR/*.jpg', to one still."),
    option("--times", metavar="S,S..",
              help="With --bracket: the exposure times in seconds (default: from EXIF data)."),
    option("--fps", type=float, help="The frame rate of the clip, in the time of the slots."),
    option("--crop", metavar="R,C", help="Top left corner of the array in the scene."),
    option("--frames-are", type=Choice(["integrals", "samples"]), default="integrals",
           help="Whether a clip's frames contain the light of their whole time, or of one "
               "instant."),
)  # fmt: skip
"""Options that place a scene on the array."""


def _tone(_context: Context, _option: Parameter, name: str | None) -> str | None:
    """Check the name of a tone curve, even if nothing is drawn with it."""
    if name is not None:
        from nscc_runtime.pictures.tone import check_tone

        check_tone(name)
    return name


tone_option = section(OUTPUT, option(
    "--tone", metavar="CURVE", callback=_tone,
    help="The tone curve of .png, .gif and .mp4: log, reinhard, mu-law, srgb, linear.",
))  # fmt: skip


def fit_option(default: str) -> Callable[..., Any]:
    """Return the option `--fit`: how to place pictures of another size than the array."""
    return section(SCENE, option(
        "--fit", type=Choice(["crop", "scale", "tiles"]), default=default, show_default=True,
        help="For a picture of another size than the array: expose its middle, all of it "
             "scaled, or all of it in parts.",
    ))  # fmt: skip


first_option = section(SCENE, option(
    "--first", type=IntRange(min=0), default=0, metavar="K", show_default=True,
    help="The first frame of the clip, counted from 0.",
))  # fmt: skip
still_option = section(SCENE, option(
    "--still", "single", is_flag=True, help="Use this frame of a clip as a still."
))  # fmt: skip
color_option = section(SCENE, option(
    "--color", is_flag=True, help="Expose red, green and blue, one after the other."
))  # fmt: skip

sensor_options = section(
    EFFECTS,
    option("--sensor", type=PATH, help="The sensor parameters (nscc effects --toml)."),
    option("--sensor-set", type=SETTING, multiple=True, metavar="K=V",
           help="Change one of the sensor parameters."),
)  # fmt: skip

measured_options = together(
    option("--seed", type=SEED, default=0, show_default=True, help="Seed of the frames' noise."),
    option("--device-seed", type=SEED, default=0, show_default=True,
           help="Seed of fixed patterns."),
    pixels_option, scene_options, sensor_options, build_options,
)  # fmt: skip
"""Options of tradeoffs that measure frames of a program."""

csv_options = section(
    OUTPUT,
    option("--csv", "csv_path", type=OUT, help="Write the CSV file here."),
    option("--png", "png_path", type=OUT, help="Write the diagram here."),
)
tradeoff_options = section(
    OUTPUT,
    option("-o", "out", type=OUT, metavar="OUT", help="Write OUT.csv and OUT.png."),
    csv_options,
)
"""Options for the output files of a tradeoff."""


def repeats_option(default: int) -> Callable[..., Any]:
    """Return the option `--repeats`: how often each measurement is repeated."""
    return option("--repeats", type=COUNT, default=default, show_default=True,
                  help="How often each setting is timed; the median is used.")  # fmt: skip


chip_option = option(
    "--target", type=TARGET, default="scamp5", show_default=True, metavar="NAME|FILE.toml",
    help="The chip.",
)  # fmt: skip

trust_code_option = option(
    "--trust-code", is_flag=True,
    help="Allow the run to execute its custom Python code (module:name).",
)  # fmt: skip
"""The option of commands that load a run folder."""

made_scenes_option = option(
    "--data", type=PATH, metavar="DIR",
    help="A folder of clips, panoramas or both, instead of synthetic scenes.",
)  # fmt: skip
made_seed_option = option(
    "--seed", type=IntRange(0, 2**31 - 1), default=0, show_default=True,
    help="Seed of synthetic scenes, random codes and noise.",
)  # fmt: skip
