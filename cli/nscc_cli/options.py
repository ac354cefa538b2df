"""Options that several commands share."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import MISSING
from math import isinf
from pathlib import Path
from typing import Any, TypeVar

import click
from click import Choice, Context, Parameter, argument, option

from nscc.mappings import NamedValues
from nscc.options import Options
from nscc.toml.kinds import LEAST, Distinct, FilePath, Flag, Kind, Number, Several, TextKind
from nscc.toml.schema import Key
from nscc.toml.schema import declared as keys_by_name
from nscc_cli.completion import EFFECTS as EFFECT_NAMES
from nscc_cli.completion import PROTOCOL, RUN, SETTING, TARGET
from nscc_cli.completion import SCENE as SCENE_NAME
from nscc_cli.support import NumberRange, OutPath, WholeNumber

Command = TypeVar("Command", bound=Callable[..., Any])
Settings = TypeVar("Settings")

PATH = click.Path(path_type=Path)
OUT = OutPath()


def out_option(
    text: str, metavar: str | None = None, *, required: bool = False
) -> Callable[[Command], Command]:
    """Return the option `-o` for an output file or folder, with the help `text`."""
    return option("-o", "out", type=OUT, metavar=metavar, required=required, help=text)


def flag(name: str, text: str) -> Callable[[Command], Command]:
    """Return the option `name` without a value, with the help `text`."""
    return option(name, is_flag=True, help=text)


def json_option(text: str) -> Callable[[Command], Command]:
    """Return the option `--json`, which the command receives as `as_json`, with the help `text`."""
    return option("--json", "as_json", is_flag=True, help=text)


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

    `names` and the keys of `defaults` are the fields, by default all fields with a declaration. An
    option that is not given is None, so that the dataclass has its default, or False. With `show`,
    or a value in `defaults`, it has a default of its own, which `--help` shows."""
    keys = keys_by_name(settings)
    chosen = [keys[name] for name in (*names, *defaults) or keys]
    if show:
        defaults = {key.attribute: key.default for key in chosen} | defaults
    return together(*(_option(key, defaults.get(key.attribute)) for key in chosen))


def values_given(settings: type, options: Mapping[str, Any]) -> NamedValues:
    """Return the values of a command's options that fields of the dataclass `settings` declare, by
    the names of the fields. `options` are by the names of click's parameters. Options without a
    value (None) are left out."""
    named = ((key.attribute, options.get(key.name)) for key in keys_by_name(settings).values())
    return {name: value for name, value in named if value is not None}


def settings_from(
    settings: Callable[..., Settings], options: Mapping[str, Any], /, **values: Any
) -> Settings:
    """Return the dataclass `settings` with the options of a command, and further `values`.

    Raises BadParameter for the first option that contradicts the others."""
    declaring: type = settings  # type: ignore[assignment]  # a dataclass
    made = settings(**values_given(declaring, options), **values)
    for key in keys_by_name(declaring).values():
        for reason in filter(None, (check(made) for check in key.checks)):
            raise click.BadParameter(f"{key.option}: {reason}")
    return made


_COMPLETED: Mapping[str, click.ParamType[Any]] = {
    "target": TARGET,
    "effects": EFFECT_NAMES,
    "name": SCENE_NAME,
    "protocol": PROTOCOL,
    "run": RUN,
}
"""The click types of options with names that a shell completes."""


class CommaList(click.ParamType):  # type: ignore[type-arg]  # not generic before click 8.3
    """Values of a list, separated by commas; "none" is an empty list if that is allowed."""

    name = "list"

    def __init__(self, kind: Distinct | Several) -> None:
        """Take lists whose values `kind` describes, such as numbers or names."""
        self.kind = kind

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[Any, ...]:
        """Return the values in a text such as "2,4"; raise BadParameter for one that is not
        allowed. Blanks around values are dropped."""
        element, values = self.kind.element, []
        empty = getattr(self.kind, "may_be_empty", False) and value.strip() == "none"
        for item in () if empty else map(str.strip, value.split(",")):
            try:
                values.append(element.read(int(item) if isinstance(element, Number) else item))
            except ValueError:
                self.fail(f"{item[:40]!r} is not {element.in_python}", param, ctx)
        read: tuple[Any, ...] = self.kind.read(values)
        return read


def _option(key: Key, default: Any) -> Callable[..., Any]:
    """Return the click option that a declared key describes, with a `default` that its help
    shows; None for the default of the declaration."""
    kind, help_text = key.kind, key.meaning
    if isinstance(kind, Flag):
        # A pair such as --cache/--no-cache has the declared default; a single flag is off.
        default = key.default if "/" in key.option else None
        about: NamedValues = {"is_flag": True, "default": default}
    else:
        completed = _COMPLETED.get(key.attribute)
        about = {"type": completed or _click_type(kind), "metavar": key.notation or None}
        if default is not None:
            text = ",".join(map(str, default)) if isinstance(default, tuple) else default
            about |= {"default": text, "show_default": text != ""}
        elif default_text := _default_text(key):
            help_text += f" (default: {default_text})"
    return option(key.option, key.name, help=f"{help_text}.", **about)


def _default_text(key: Key) -> str:
    """Return the default of the declared field `key` as text for its help; "" if it has none or
    None."""
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
        # LEAST stands for an excluded 0, which the help shows.
        return NumberRange(0 if low == LEAST else low, high, min_open=low == LEAST)
    if isinstance(kind, FilePath):
        return PATH
    if isinstance(kind, Distinct | Several):
        return CommaList(kind)
    return Choice(kind.choices) if isinstance(kind, TextKind) and kind.choices else None


build_options = section(COMPILE, declared(Options))
"""Options that control the compiler; `nscc_cli.programs` reads them."""


def _tone(_context: Context, _option: Parameter, name: str | None) -> str | None:
    """Return the tone curve `name`, or None. `name` is None if the option is not given. Raise
    Rejected if there is no such curve, even if the command draws nothing with it."""
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


sensor_set_option = option(
    "--sensor-set",
    type=SETTING,
    multiple=True,
    metavar="K=V",
    help="Change one of the sensor parameters.",
)
sensor_options = section(
    EFFECTS,
    option("--sensor", type=PATH, help="The sensor parameters (nscc effects --toml)."),
    sensor_set_option,
)

csv_options = section(
    OUTPUT,
    option("--csv", "csv_path", type=OUT, help="Write the CSV file here."),
    option("--png", "png_path", type=OUT, help="Write the diagram here."),
)
tradeoff_options = section(
    OUTPUT,
    out_option("Write OUT.csv and OUT.png.", "OUT"),
    csv_options,
)
"""Options for the output files of a tradeoff."""


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
