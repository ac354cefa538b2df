"""Options that several commands share."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import MISSING
from math import isinf
from pathlib import Path
from typing import Any, TypeVar

import click
from click import Choice, Context, IntRange, Parameter, argument, option

from nscc.options import Options
from nscc.toml.kinds import LEAST, FilePath, Flag, Kind, Number, TextKind
from nscc.toml.schema import Key
from nscc.toml.schema import declared as keys_by_name
from nscc_cli.completion import EFFECTS as EFFECT_NAMES
from nscc_cli.completion import SCENE as SCENE_NAME
from nscc_cli.completion import SETTING, TARGET
from nscc_cli.support import NumberRange, OutPath, WholeNumber

Command = TypeVar("Command", bound=Callable[..., Any])

PATH = click.Path(path_type=Path)
OUT = OutPath()
LEVEL = IntRange(0, 3)

COUNT = IntRange(1, 1000)
"""A number of scenes or of repeated measurements."""


def together(*options: Callable[[Any], Any]) -> Callable[[Command], Command]:
    """Combine several options into one decorator of a command. `--help` lists them in this
    order."""

    def add(function: Command) -> Command:
        """Add all options to a command, in their order."""
        for decorator in reversed(options):
            function = decorator(function)
        return function

    return add


def section(title: str, *options: Callable[[Any], Any]) -> Callable[[Command], Command]:
    """Combine several options into one decorator of a command. `--help` lists them under the
    heading `title`."""

    def add(function: Command) -> Command:
        """Add the options to the command `function`, and list them below this title in its help."""
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
    """Return a callback of a click option that parses a list of some of `names`, separated by
    commas."""

    def chosen(context: click.Context, option: click.Parameter, value: str) -> tuple[str, ...]:
        """Return the names in the text of the option, in the order of `names`. Raise BadParameter
        for unknown ones."""
        chosen_set = {item.strip() for item in value.split(",")}
        for name in sorted(chosen_set.difference(names)):
            raise click.BadParameter(f"{name!r} is not one of {', '.join(names)}", context, option)
        return tuple(name for name in names if name in chosen_set)

    return chosen


def some_option(
    name: str, names: Sequence[str], metavar: str, text: str, default: str | None = None
) -> Callable[..., Any]:
    """Return the option `name`, whose value is a list of some of `names`, separated by commas.

    `default` is its default; None takes all names. `text` is its help."""
    return option(
        name,
        callback=chosen_names(names),
        metavar=metavar,
        default=default or ",".join(names),
        show_default=True,
        help=text,
    )


program_argument = argument("program", metavar="FILE.nsl|FILE.icw", type=PATH)
pixels_option = section(
    COMPILE,
    option("--pixels", type=PATH, help="The pixels' codes (.npz), or a mask (.npy .npz .mat)."),
)


def declared(
    settings: type, *names: str, show: bool = False, **defaults: Any
) -> Callable[[Command], Command]:
    """Return the options that fields of the dataclass `settings` declare, as one decorator of a
    command.

    `names` are the fields, by default all fields with a declaration. An option that is not given is
    None, so that the dataclass has its default, or False. With `show`, or a value in `defaults`, it
    has a default of its own, which `--help` shows."""
    keys = keys_by_name(settings)
    chosen = [keys[name] for name in (*names, *defaults) or keys]
    if show:
        defaults = {key.attribute: key.default for key in chosen} | defaults
    return together(*(_option(key, defaults) for key in chosen))


def values_given(settings: type, options: Mapping[str, Any]) -> dict[str, Any]:
    """Return the values of a command's options that fields of the dataclass `settings` declare, by
    the names of the fields. Options without a value are left out."""
    named = ((key.attribute, options.get(key.name)) for key in keys_by_name(settings).values())
    return {name: value for name, value in named if value is not None}


_COMPLETED = {"target": TARGET, "effects": EFFECT_NAMES, "name": SCENE_NAME}
"""The click types of options with names that a shell completes."""


def _option(key: Key, defaults: Mapping[str, Any]) -> Callable[..., Any]:
    """Return the click option that the declared field `key` describes. `defaults` are the options'
    own defaults, by the name of the field."""
    kind, name = key.kind, key.attribute
    help_text = key.meaning
    if isinstance(kind, Flag):
        default = key.default if "/" in key.option else None
        about: dict[str, Any] = {"is_flag": True, "default": default}
    else:
        about = {"type": _COMPLETED.get(name) or _click_type(kind), "metavar": key.notation or None}
        if name in defaults:
            about |= {"default": defaults[name], "show_default": True}
        elif default_text := _default_text(key):
            help_text += f" (default: {default_text})"
    return option(key.option, key.name, help=f"{help_text}.", **about)


def _default_text(key: Key) -> str:
    """Return the default of the declared field `key` as text for its help; "" if it has none."""
    if key.default_text is not None:
        return key.default_text
    return "" if key.default in (None, MISSING) else str(key.default)


def _click_type(kind: Kind) -> click.ParamType[Any] | None:
    """Return the click type that accepts the values of `kind`, the declared kind of a field. None
    means that any text is accepted."""
    if isinstance(kind, Number):
        low, high = (None if isinf(limit) else limit for limit in (kind.low, kind.high))
        if kind.is_whole:
            return WholeNumber(low, high)  # type: ignore[arg-type]  # whole numbers
        if low is high is None:
            return click.FLOAT
        return NumberRange(0 if low == LEAST else low, high, min_open=low == LEAST)
    if isinstance(kind, FilePath):
        return PATH
    return Choice(kind.choices) if isinstance(kind, TextKind) and kind.choices else None


build_options = section(COMPILE, declared(Options))
"""Options that control the compiler; `nscc_cli.programs` reads them."""


def _tone(_context: Context, _option: Parameter, name: str | None) -> str | None:
    """Return the tone curve `name`, or None. Raise Rejected if there is no such curve, even if the
    command draws nothing with it."""
    if name is not None:
        from nscc_runtime.pictures.tone import check_tone

        check_tone(name)
    return name


tone_option = section(
    OUTPUT,
    option(
        "--tone",
        metavar="CURVE",
        callback=_tone,
        help="The tone curve of .png, .gif and .mp4: log, reinhard, mu-law, srgb, linear.",
    ),
)


sensor_options = section(
    EFFECTS,
    option("--sensor", type=PATH, help="The sensor parameters (nscc effects --toml)."),
    option(
        "--sensor-set",
        type=SETTING,
        multiple=True,
        metavar="K=V",
        help="Change one of the sensor parameters.",
    ),
)

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
    """Return the option `--repeats`: how often each measurement is repeated. `default` is its
    default."""
    return option(
        "--repeats",
        type=COUNT,
        default=default,
        show_default=True,
        help="How often each setting is timed; the median is used.",
    )


def scenes_option(text: str) -> Callable[..., Any]:
    """Return the option `--scene`, which may be repeated, with the help `text`. The command
    receives a tuple `scenes`."""
    return section(
        SCENE,
        option("--scene", "scenes", type=SCENE_NAME, multiple=True, metavar="SCENE", help=text),
    )


def target_option(text: str) -> Callable[..., Any]:
    """Return the option `--target` for commands that compile no program, with the default chip and
    the help `text`."""
    return option(
        "--target",
        type=TARGET,
        default="scamp5",
        show_default=True,
        metavar="NAME|FILE.toml",
        help=text,
    )


chip_option = target_option("The chip.")

slots_axis_option = option(
    "--slots-axis",
    type=click.Choice(("first", "last")),
    help="The axis of a mask that counts slots, for a mask whose sizes do not tell it.",
)

trust_code_option = option(
    "--trust-code",
    is_flag=True,
    help="Allow the run to execute its custom Python code (module:name).",
)
"""The option of commands that load a run folder."""

made_scenes_option = option(
    "--data",
    type=PATH,
    metavar="DIR",
    help="A folder of clips, panoramas or both, instead of synthetic scenes.",
)
made_seed_option = option(
    "--seed",
    type=IntRange(0, 2**31 - 1),
    default=0,
    show_default=True,
    help="Seed of synthetic scenes, random codes and noise.",
)
