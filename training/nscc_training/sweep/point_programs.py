"""Programs, scenes and sensors of points. Programs come from files, from rules for any number of
slots, or are random codes of a class."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from dataclasses import MISSING, replace
from math import ceil, prod
from pathlib import Path
from typing import TYPE_CHECKING

from nscc.chips.load import DEFAULT_NAME, load_target
from nscc.chips.target import SCHEMA, Target
from nscc.limits.families import program_text
from nscc.options import Options
from nscc.pipeline import Compiled, run_passes
from nscc.source import Source
from nscc.syntax.parse import read_source
from nscc.toml.kinds import Axis, Integer, Number, Several, TextKind
from nscc.toml.schema import Key, declared
from nscc_training.code_choices import STARTS
from nscc_training.sweep.point import PointFault, Values

if TYPE_CHECKING:
    from nscc_runtime.scenes import Scene
    from nscc_runtime.sensor import Sensor
    from nscc_training.encoders import Encoder


CLASSES = ("a", "b", "c", "d", "e", "codebook")
SOURCES = ("program", "rule", "class")
"""Keys that define a point's program; a point has exactly one of them."""

_MOST_PLACES = 4096
"""Largest tile in a program's text; a larger tile would need a file beside the program."""
_CHIP = "chip."
_SILENT: dict[str, tuple[str, ...]] = {
    "program": ("slots", "slot_us", "tile", "init", "length", "rows"),
    "rule": ("tile", "init", "length", "rows"),
    "class": (),
}
"""Keys that have no effect, by the source of the program."""


def axis(name: str, kind: object, meaning: str, default: object = MISSING) -> Key:
    """Return a key of a grid that takes a value of this kind, or a list of such values. Without a
    `default` the key may be missing."""
    default_values = default if default is MISSING else (default,)
    return Key("", name, Axis(kind), meaning, default_values)  # type: ignore[arg-type]


def declared_axes(settings: type, *names: str, **defaults: object) -> tuple[Key, ...]:
    """Return keys of a grid for options that fields of the dataclass `settings` declare.

    `names` are the fields whose declared default is kept. `defaults` are further fields, with
    another default than they declare."""
    keys = [declared(settings)[name] for name in (*names, *defaults)]
    return tuple(
        axis(
            key.attribute,
            key.kind,
            key.meaning[:1].lower() + key.meaning[1:],
            defaults.get(key.attribute, key.default),
        )
        for key in keys
    )


def target_keys() -> tuple[Key, ...]:
    """Return the keys of a grid that name a chip, and those that change one of its values
    (`chip.KEY`)."""
    numbers = (
        axis(_CHIP + key.attribute, key.kind, key.meaning)
        for key in SCHEMA.keys
        if key.section not in ("", "registers")
    )
    return (
        axis("target", TextKind(), "the chip, by name or file; empty: the program's own", ""),
        *numbers,
    )


def program_keys() -> tuple[Key, ...]:
    """Return the keys of a grid that name a program (a file, a rule or a class of codes), and how
    it is compiled."""
    return (
        axis("program", TextKind(), "a file of a program"),
        axis("rule", TextKind(), "instead of program: the statements below `frame`"),
        axis("class", TextKind(CLASSES), "instead of program: codes of a class on a tile"),
        axis("slots", Integer(1, 65536), "slots of a frame, for a rule or a class", 16),
        axis("slot_us", Number(1e-3, 1e9), "length of a slot in microseconds", 1000.0),
        axis("tile", Several(Integer(1, 4096), 2), "rows and columns of a class's tile", (8, 8)),
        axis("init", TextKind(STARTS), "the codes of a class", "random"),
        axis(
            "length",
            Integer(1, 65536, automatic=True),
            "slots of a bump of class c; auto: a quarter of the frame",
            None,
        ),
        axis("rows", Integer(1, 4096), "rows of a codebook", 64),
        axis("seed", Integer(0, 2**31 - 1), "seed of all random numbers", 0),
        *declared_axes(Options, "codes", "lowering", "level"),
        axis("max_words", Integer(1, 10**6, unlimited=True), "most words in a slot", None),
        *target_keys(),
    )


def program_fault(values: Values, named: Collection[str]) -> PointFault | None:
    """Return what is wrong with the values of `program_keys`, or None. `named` are the keys that
    the grid states."""
    sources = [name for name in SOURCES if name in values]
    if len(sources) != 1:
        have = " and ".join(sources) or "none of them"
        return PointFault(
            sources[-1] if sources else "",
            f"a point needs one of {', '.join(SOURCES)}, but has {have}",
            'for instance program = "hdr_2x2.nsl", or class = "d"',
        )
    if "class" in values and prod(values["tile"]) > _MOST_PLACES:
        return PointFault("tile", f"a tile has at most {_MOST_PLACES} places", "use a smaller tile")
    return silent(named, _SILENT[sources[0]], sources[0]) or target_fault(values)


def target_fault(values: Values) -> PointFault | None:
    """Return what is wrong with the values of `target_keys`, or None: values of a chip that is not
    named."""
    name = next((name for name in values if name.startswith(_CHIP)), None)
    if name is None or values["target"]:
        return None
    message = f"{name} changes a chip, but target is missing"
    return PointFault(name, message, f'add target = "{DEFAULT_NAME}"')


def silent(named: Collection[str], keys: Sequence[str], point_text: str) -> PointFault | None:
    """Return the error of stating one of the `keys`, or None if the grid states none of them
    (`named`). They have no effect on points with `point_text`, such as "a scene", so that several
    values would give identical points. Of several, the first of `keys` is named."""
    name = next((key for key in keys if key in named), None)
    if name is None:
        return None
    return PointFault(
        name, f"{name} has no effect on a point with {point_text}", f"leave {name} out"
    )


def program_files(values: Values) -> Sequence[Path]:
    """Return the files that a program of a point consists of: its text, the files that the text
    names, and the target."""
    files: list[Path] = []
    if "program" in values:
        files += text_files(Path(values["program"]))
    if values["target"].endswith(".toml"):
        files.append(Path(values["target"]))
    return files


def text_files(path: Path) -> list[Path]:
    """Return the file of a program, and the files that it names in quotes, relative to its folder.
    Whether these exist is not checked. Raise Rejected if the program cannot be read."""
    named = re.findall(r'"([^"\n]{1,255})"', read_source(path).text)
    return [path, *(path.parent / name for name in named)]


def target_of(values: Values) -> Target | None:
    """Return the chip that the values of a point name, with their changes (`chip.KEY`). Return None
    if the program's own chip is used."""
    if not values["target"]:
        return None
    changes = {
        name.removeprefix(_CHIP): value for name, value in values.items() if name.startswith(_CHIP)
    }
    return replace(load_target(values["target"], Path()), **changes)


def compiled_of(values: Values) -> Compiled:
    """Compile and prove the program of a point with these `values`, without the cache of searches.
    Raise Rejected if it does not compile, does not fit, or a slot needs more than `max_words`
    words."""
    options = Options(
        level=values["level"],
        codes=values["codes"],
        lowering=values["lowering"],
        target=target_of(values),
        cache=False,
        max_words_per_slot=values["max_words"],
    )
    return run_passes(*_source(values), options)


def _source(values: Values) -> tuple[Source, Path]:
    """Return the text of a point's program, which is a file, a rule, or codes of a class, and the
    folder to which names of files in it are relative."""
    if "program" in values:
        path = Path(values["program"])
        return read_source(path), path.parent
    if "rule" in values:
        slot = f"{values['slot_us']:.6f}".rstrip("0").rstrip(".") + "us"
        return Source("rule.nsl", program_text(values["slots"], slot, values["rule"])), Path()
    from nscc_training.programs import Chip, program_of

    text = program_of(encoder_of(values), Chip(slot_us=values["slot_us"])).text
    return Source(f"class_{values['class']}.nsl", text), Path()


def encoder_of(values: Values) -> Encoder:
    """Return the encoder with the class, slots, tile and initial codes that the values of a point
    name. Without a length, a bump of class c takes a quarter of the frame. Raises ValueError for
    codes that the class does not have."""
    from nscc_training.encoders import ShutterSpec, make_encoder

    kind = values["class"]
    spec = ShutterSpec(
        kind,
        values["slots"],
        values["tile"],
        length=(values["length"] or max(1, values["slots"] // 4)) if kind == "c" else None,
        rows=values["rows"] if kind == "codebook" else None,
    )
    return make_encoder(spec, values["init"], values["seed"])


def whole_ticks(slot_us: float) -> float:
    """Return a slot length in microseconds, rounded up to a multiple of 10 ns (at least 10 ns), so
    that texts of programs are readable."""
    # The 1e-6 keeps multiples of 10 ns, whose quotient may lie just above a whole number.
    return round(max(1, ceil(slot_us / 0.01 - 1e-6)) * 0.01, 6)


_SENSOR, _FILE = "sensor.", "sensor.file"


def scene_keys() -> tuple[Key, ...]:
    """Return the keys of a grid that name a scene, its exposure and its encoding."""
    return (
        axis("scene", TextKind(), "a scene, as nscc run takes it"),
        axis(
            "exposure",
            TextKind(),
            "electrons over the frame, as --exposure; empty: the scene's",
            "",
        ),
        axis(
            "transfer",
            TextKind(("", "linear", "srgb")),
            "the scene's curve; empty: by its file",
            "",
        ),
    )


def sensor_keys() -> tuple[Key, ...]:
    """Return the keys of a grid that name a sensor file, and those that change one of its values
    (`sensor.KEY`)."""
    from nscc_runtime.sensor.file import schema

    numbers = (axis(_SENSOR + key.name, key.kind, key.meaning) for key in schema().keys)
    return (axis(_FILE, TextKind(), "a sensor file (nscc effects --toml)", ""), *numbers)


def light_files(values: Values) -> Sequence[Path]:
    """Return the files of a point's scene and sensor; built-in scenes have none."""
    named = values[_FILE], values.get("scene", "")
    return [Path(name) for name in named if name and not name.startswith("builtin:")]


def scene_of_point(values: Values) -> Scene:
    """Return the scene that the values of a point name, with its exposure and encoding."""
    from nscc_runtime.scenes import Scene

    return Scene(
        values["scene"], exposure=values["exposure"] or None, transfer=values["transfer"] or None
    )


def sensor_file(values: Values) -> Path | None:
    """Return the sensor file of a point, None without one."""
    return Path(values[_FILE]) if values[_FILE] else None


def sensor_changes(values: Values) -> tuple[str, ...]:
    """Return the sensor values that a point changes (`sensor.KEY`) in the form KEY=VALUE of the
    option --sensor-set."""
    changed = [name for name in values if name.startswith(_SENSOR) and name != _FILE]
    return tuple(f"{name.removeprefix(_SENSOR)}={values[name]!r}" for name in changed)


def sensor_of(values: Values, target: Target) -> Sensor:
    """Return the sensor of a point on a chip: its sensor file, or the chip's default sensor, with
    the point's changes."""
    from nscc_runtime.sensor import load_sensor

    return load_sensor(target, sensor_file(values), sensor_changes(values))
