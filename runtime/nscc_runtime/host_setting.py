"""Values of parameters and bits of input planes that the host sets before a frame."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Array, Bools
from nscc.chips.target import Target
from nscc.diagnostics.arguments import shown
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.files import why_no_file
from nscc.record import Record
from nscc.truth import unpacked_bits
from nscc.words.container import Container
from nscc.words.picture_launches import HostParam
from nscc.words.pictures import InputPlane

_UNITS = ("%", "lsb", "e")


class HostSetting(Record, eq=False):
    """What the host sets before a frame, by name: values of all parameters (a level in steps of IN,
    an integer as it is), and bits (rows, cols) of those input planes that it loads. IN is the level
    sent to all pixels."""

    params: Mapping[str, int]
    inputs: Mapping[str, Bools]

    @classmethod
    def at_start(cls, container: Container) -> HostSetting:
        """Return the setting with the declared starts of all parameters, which loads no input
        plane."""
        return cls({param.name: param.start for param in container.pictures.params}, {})

    def plain(self, container: Container) -> dict[str, float]:
        """Return the values of the parameters that `container` declares, by name, as the meta of a
        frame file stores them: levels in electrons, integers as they are."""
        unit_e = container.target.electrons_per_step
        return {
            param.name: self.params[param.name] * (unit_e if param.kind == "level" else 1)
            for param in container.pictures.params
        }


def host_settings(container: Container, params: Any, inputs: Any) -> tuple[HostSetting, ...]:
    """Return what the host sets before each frame; the last setting holds for all later frames.

    `params` and `inputs`: mappings by name for all frames, or sequences of mappings for one frame
    each; None changes nothing. What a later mapping leaves out keeps its value. Empty if both are
    None. Raises Rejected (NS0546) for unknown names and invalid values."""
    if params is None and inputs is None:
        return ()
    listed = [_mappings("params", params), _mappings("inputs", inputs)]
    settings, count = [HostSetting.at_start(container)], max(map(len, listed))
    for number in range(count):
        of_frame = [mappings[number] if number < len(mappings) else {} for mappings in listed]
        before = settings[-1]
        settings.append(
            HostSetting(
                {**before.params, **_params(container, of_frame[0])},
                {**before.inputs, **_inputs(container, of_frame[1])},
            )
        )
    # The first setting is that before any mapping; it holds if both lists are empty.
    return tuple(settings[1:] or settings)


def _refused(message: str, *helps: str) -> Rejected:
    """Return the error NS0546, for the caller to raise, for values that the host cannot set.
    `helps`: what is allowed."""
    return rejected("NS0546", message, helps=helps)


def _mappings(argument: str, values: Any) -> list[Mapping[str, Any]]:
    """Return `values`, those of the argument called `argument`, as one mapping from names to values
    for each frame: a mapping alone is that of the first frame, None is no mapping. Raises Rejected
    (NS0546) for other types."""
    mappings = [values] if isinstance(values, Mapping) else values
    if mappings is None:
        return []
    is_list = isinstance(mappings, Sequence) and not isinstance(mappings, str)
    if not is_list or not all(isinstance(each, Mapping) for each in mappings):
        raise _refused(
            f"`{argument}` is {shown(values)}, not a mapping from names to values",
            f'write {argument}={{"NAME": VALUE}}, or a list with a mapping for each frame',
        )
    return [*mappings]


def _check_names(kind: str, names: Iterable[object], known: Collection[str]) -> None:
    """Raise Rejected (NS0546) for the first of `names` that is not among the names `known`. `kind`:
    what they should name, with article, such as "a parameter"."""
    for name in names:
        if name not in known:
            listed = ", ".join(f"`{each}`" for each in known) or f"the program declares no {kind}"
            raise _refused(f"{shown(name)} is not the name of {kind}", f"known: {listed}")


def _params(container: Container, values: Mapping[str, Any]) -> dict[str, int]:
    """Return the `values` of parameters as words use them, by name: levels in steps of IN (the
    level sent to all pixels), integers as they are. Raises Rejected (NS0546) for unknown names and
    invalid values."""
    params = {param.name: param for param in container.pictures.params}
    _check_names("a parameter", values, params)
    return {name: _number(params[name], value, container.target) for name, value in values.items()}


def _number(param: HostParam, value: Any, target: Target) -> int:
    """Return `value` for the parameter `param` as words use it: a level rounded to steps of
    `target`, or an integer.

    A level is text such as "4%" or a number of electrons; an integer is an int or decimal text.
    Raises Rejected (NS0546) for anything else and outside the parameter's range."""
    unit_e = target.electrons_per_step if param.kind == "level" else 1.0
    ends = [
        f"{end * unit_e:g}{'e' if param.kind == 'level' else ''}" for end in (param.low, param.high)
    ]
    example = ", such as '4%' or '1200e'" if param.kind == "level" else ""
    helps = (f"`{param.name}` has {param.kind}s from {ends[0]} to {ends[1]}{example}",)
    number: int | None = None
    if param.kind == "level":
        electrons = _electrons(value, target)
        number = None if electrons is None else round(electrons / unit_e)
    else:
        # True is an int for Python, but no number of a user.
        is_integer = isinstance(value, int | np.integer) and not isinstance(value, bool)
        is_text = isinstance(value, str) and value.removeprefix("-").isdecimal()
        number = int(value) if is_integer or is_text else None
    if number is None or not param.low <= number <= param.high:
        what = "outside its range" if number is not None else "not such a value"
        raise _refused(f"`{param.name}` cannot be {shown(value)}: {what}", *helps)
    return number


def _electrons(value: Any, target: Target) -> float | None:
    """Return a level in electrons, from a number of electrons or from text with a unit: "4%" of the
    full well, "12lsb" or "1200e". None for anything else: other units, no number, infinite."""
    unit = "e"
    if isinstance(value, str):
        unit = next((unit for unit in _UNITS if value.endswith(unit)), "")
        value = value.removesuffix(unit) if unit else None
    try:
        number = float(value)
    except (TypeError, ValueError):
        return None
    return target.level_e(number, unit) if np.isfinite(number) else None


def _inputs(container: Container, values: Mapping[str, Any]) -> dict[str, Bools]:
    """Return the bits of input planes, bool (rows, cols), by name. `values`: for each an array of 0
    and 1, the path of a file, or None for its initial bits. Raises Rejected (NS0546) for names of
    no plane that the host may load, and for invalid values."""
    planes = {plane.name: plane for plane in container.pictures.inputs if plane.is_open}
    _check_names("an input plane", values, planes)
    target = container.target
    return {name: _bits(planes[name], value, target) for name, value in values.items()}


def _bits(plane: InputPlane, value: Any, target: Target) -> Bools:
    """Return the bits of an input plane, bool (rows, cols), from an array of 0 and 1, the path of a
    file with one (.npy, .npz or a picture), or None, which stands for the plane's initial bits.

    Raises Rejected (NS0546) for another shape, values other than 0 and 1, and files that cannot be
    read."""
    shape = target.rows, target.cols
    if value is None:
        return unpacked_bits(plane.bits, shape)
    is_path = isinstance(value, str | os.PathLike)
    array = _stored(plane.name, Path(value)) if is_path else np.asarray(value)
    if array.shape != shape:
        raise _refused(
            f"`{plane.name}` is an array of shape {array.shape}, but {target.name} has "
            f"{shape[0]} x {shape[1]} pixels: [row, column]",
            "give bits for every pixel",
        )
    numbers = array.dtype.kind in "biuf"
    if not numbers or not np.isin(array, (0, 1)).all():
        raise _refused(
            f"`{plane.name}` has values other than 0 and 1", "compare the array: `values > 0`"
        )
    return array.astype(np.bool_)


def _stored(name: str, path: Path) -> Array:
    """Return the array in an .npy file or, with the key `name`, in an .npz file, of any shape and
    type. Other files are read as pictures: bool (rows, cols), True where the mean of the colours is
    above half of the range.

    Raises Rejected: NS0546 if the array cannot be read, and as `read_picture` for pictures."""
    if not path.is_file():
        text = f"cannot read '{path}': {why_no_file(path)}"
        raise _refused(text, "name an .npy file, .npz file or picture")
    ending = path.suffix.lower()
    if ending in (".npy", ".npz"):
        from nscc.npy import npy_array, npz_arrays

        try:
            if ending == ".npy":
                return npy_array(path)
            arrays, names = npz_arrays(path, lambda key: key == name)
            if name in arrays:
                return arrays[name]
            raise ValueError(f"it has the arrays {', '.join(names)[:60]}, not `{name}`")
        except (OSError, ValueError) as error:
            text = f"cannot read '{path}': {error}"
            raise _refused(text, "save an array with `numpy.save`") from None
    from nscc_runtime.scenes.picture_files import read_picture

    samples = read_picture(path)
    most = float(np.iinfo(samples.dtype).max) if samples.dtype.kind in "ui" else 1.0
    grey = samples.mean(axis=2) if samples.ndim == 3 else samples
    return np.asarray(grey > most / 2)
