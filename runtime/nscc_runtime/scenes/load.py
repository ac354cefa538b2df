"""`--scene`: from a name to the light on the array."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Diagnostic, Severity
from nscc.diagnostics.rejection import rejected
from nscc.diagnostics.suggest import closest
from nscc_runtime.light import Light
from nscc_runtime.progress import Progress, unseen
from nscc_runtime.scenes import arrays, exposure, timing
from nscc_runtime.scenes.colour import Transfer, linear, luminance
from nscc_runtime.scenes.crop import Window
from nscc_runtime.scenes.errors import refuse_no_light, size
from nscc_runtime.scenes.exposure import Exposure

FramesAre = Literal["integrals", "samples"]

ARRAYS = (".mat", ".npy", ".npz")
_BUILTINS = ("hdr", "motion", "dark")
_TINY_NEGATIVE = 1e-3
"""Samples below 0 by at most this part of a picture's peak are filter ringing: set to 0."""


@dataclass(frozen=True)
class _Request:
    """A scene to load: its name, the program's slots, the array, what was said of the scene (None:
    nothing), and where notes go."""

    name: str
    slot_us: tuple[float, ...]
    window: Window
    exposure: Exposure | None = None
    transfer: Transfer | None = None
    fps: float | None = None
    crop: tuple[int, int] | None = None
    frames_are: FramesAre = "integrals"
    warn: Callable[[Diagnostic], None] = lambda _: None
    progress: Progress = unseen

    @property
    def slots(self) -> int:
        return len(self.slot_us)

    @property
    def slot_s(self) -> NDArray[np.float64]:
        return np.array(self.slot_us, np.float64) * 1e-6


def load_scene(
    spec: str,
    *,
    slot_us: Sequence[float],
    rows: int,
    cols: int,
    exposure: Exposure | None = None,
    transfer: Transfer | None = None,
    fps: float | None = None,
    crop: tuple[int, int] | None = None,
    frames_are: FramesAre = "integrals",
    warn: Callable[[Diagnostic], None] = lambda _: None,
    progress: Progress = unseen,
) -> Light:
    """The light of scene `spec` in slots of `slot_us` on an array of rows x cols.

    `spec` is a file, a folder of pictures or `builtin:NAME`. Raises Rejected with status 2
    (NS0730..NS0739); `warn` is handed what was changed in the scene (NS0740), `progress` the
    frames as they are read.

    `frames_are` "samples" declares that the scene moves within a frame. That motion is an effect of
    the sensor model (`Light.motion`): with effects off a sample stands for its whole frame, as an
    integral does.
    """
    request = _Request(
        spec, tuple(slot_us), Window(rows, cols, crop), exposure, transfer, fps, crop, frames_are,
        warn, progress,
    )  # fmt: skip
    if spec.startswith("builtin:"):
        from nscc_runtime.scenes.builtin import load_builtin

        _refuse(request, "a builtin scene is made for the array", "transfer", "fps", "crop")
        return load_builtin(spec, slot_us=request.slot_us, rows=rows, cols=cols, exposure=exposure)
    return _load_path(request, _existing(spec))


def light_of_array(
    values: NDArray[Any], *, slot_us: Sequence[float], rows: int, cols: int, name: str = "light"
) -> Light:
    """The light of an array: electrons a slot (N, rows, cols), or a second (rows, cols).

    float32 arrays are not copied, and must not be written to while the light is in use. Raises
    Rejected with status 2 (NS0733 .. NS0736) for arrays that do not fit or hold what is no light.
    """
    request = _Request(name, tuple(slot_us), Window(rows, cols))
    values = np.asarray(values)
    arrays.check_type(Path(name), "light", values.dtype)
    _check_light(request, values.shape)
    refuse_no_light(values, name)
    return _electrons(request, np.ascontiguousarray(values, np.float32))


def _existing(spec: str) -> Path:
    path = Path(spec)
    try:
        if path.is_dir() or path.is_file():
            return path
        reason = "it is not a file" if path.exists() else "there is no such file"
    except (OSError, ValueError) as error:
        reason = str(error)
    near = spec if spec in _BUILTINS else closest(spec, _BUILTINS)
    raise rejected(
        "NS0730",
        f"the scene '{spec[:200]}' cannot be opened: {reason}",
        helps=(
            *((f"did you mean builtin:{near}?",) if near and not path.suffix else ()),
            "name a file, a folder of pictures or a builtin scene: builtin:hdr, builtin:motion, "
            "builtin:flat:E, builtin:dark",
        ),
    )


def _load_path(request: _Request, path: Path) -> Light:
    from nscc_runtime.scenes import clips, picture_files

    suffix = path.suffix.lower()
    if path.is_dir():
        files = picture_files.files_of(path)
        transfer = request.transfer or picture_files.default_transfer(files[0])
        return _clip(request, picture_files.read_folder(files), transfer)
    if suffix in ARRAYS:
        return _array(request, path)
    if suffix in picture_files.PICTURES:
        return _still(request, path)
    if suffix in clips.CLIPS:
        return _clip(request, clips.read_clip(path), request.transfer or "srgb")
    known = ", ".join(sorted(ARRAYS + picture_files.PICTURES + clips.CLIPS))
    raise rejected(
        "NS0731",
        f"'{path}' does not end like a scene",
        notes=(f"scenes end in {known}, or are folders of pictures",),
        helps=("give the file the ending of its format",),
    )


def _refuse(request: _Request, why: str, *names: str) -> None:
    """Raise NS0739 if one of these options is given."""
    for name in names:
        if getattr(request, name) is not None:
            raise rejected(
                "NS0739",
                f"--{name} means nothing for the scene '{request.name}'",
                notes=(why,),
                helps=(f"leave --{name} out",),
            )


def _array(request: _Request, path: Path) -> Light:
    """Light in electrons, or a .mat clip."""
    check = partial(_check_light, request)
    if path.suffix.lower() == ".mat":
        key, found = arrays.read_mat(path, check)
        if key == arrays.MAT_CLIP_KEY:
            frames = (found[:, :, k] for k in range(found.shape[2]))
            return _clip(request, frames, request.transfer or "linear")
    else:
        found = arrays.read_light(path, check, request.progress)
    _refuse(request, "`light` arrays hold electrons, slot by slot, for every pixel", "fps", "crop")
    if request.transfer == "srgb":
        _refuse(request, "`light` arrays hold electrons, which are linear", "transfer")
    return _electrons(request, found)


def _electrons(request: _Request, found: NDArray[np.float32]) -> Light:
    wanted = request.exposure
    if found.ndim == 3:
        clip = Light.of_clip(found)
        if wanted is not None:
            factor = exposure.scale(clip.total_e(), wanted, request.name)
            clip = Light.of_clip(found, factor)
        return timing.with_motion(clip) if request.frames_are == "samples" else clip
    seconds = request.slot_s
    if wanted is not None:
        factor = _still_scale(request, found, wanted)
        return Light.of_still(found, seconds * factor, factor)
    peak = float(found.max()) * float(seconds.max())
    if peak > float(np.finfo(np.float32).max):
        raise rejected(
            "NS0736",
            f"the scene '{request.name}' gives {peak:g} electrons in one slot",
            notes=("a slot's light must stay below 3.4e38 electrons",),
            helps=("a still in a `light` array is in electrons a second: divide it",),
        )
    return Light.of_still(found, seconds)


def _check_light(request: _Request, shape: tuple[int, ...]) -> None:
    """The shape that a `light` array must have for this program."""
    need = (request.window.rows, request.window.cols)
    _refuse_other_axes(request, shape, need)
    if len(shape) not in (2, 3):
        raise rejected(
            "NS0733",
            f"'light' in '{request.name}' has {len(shape)} dimensions: {size(shape)}",
            notes=(f"a still is (rows, cols) = {size(need)}, a clip (slots, rows, cols)",),
            helps=("give the array two or three dimensions",),
        )
    if tuple(shape[-2:]) != need:
        raise rejected(
            "NS0734",
            f"'light' in '{request.name}' is {size(shape[-2:])}, the array is {size(need)}",
            notes=("sizes are rows x columns; light in electrons is neither cropped nor scaled",),
            helps=("cut the array to that size, or use a target of the scene's size",),
            data={"scene": list(shape[-2:]), "array": list(need)},
        )
    if len(shape) == 3 and shape[0] != request.slots:
        raise rejected(
            "NS0735",
            f"'light' in '{request.name}' has {shape[0]} frame{'' if shape[0] == 1 else 's'}, "
            f"the program has {request.slots} slots",
            notes=("a light array holds the electrons of each slot: one frame a slot",),
            helps=("use a program of as many slots, or a still: (rows, cols), electrons a second",),
            data={"frames": shape[0], "needed": request.slots},
        )


def _refuse_other_axes(request: _Request, shape: tuple[int, ...], need: tuple[int, int]) -> None:
    """NS0733 for light whose axes are those of other tools: time or colour last."""
    count = shape[-1] if len(shape) in (3, 4) else 0
    if shape[-3:-1] != need or tuple(shape[-2:]) == need:
        return
    found = f"'light' in '{request.name}' is {size(shape)}"
    grey = "light has no colour: `a @ [0.2126, 0.7152, 0.0722]` makes luminance of red, green, blue"
    ahead = "time comes first: `np.moveaxis(a, -1, 0)`"
    if count in (3, 4):
        message = f"{found}: a colour picture, it seems, and light is one number a pixel"
        helps = (grey, ahead) if len(shape) == 3 and count == request.slots else (grey,)
    elif len(shape) == 3:
        message, helps = f"{found}: (rows, cols, slots), it seems", (ahead,)
    else:
        return
    raise rejected(
        "NS0733",
        message,
        notes=(f"a still is (rows, cols) = {size(need)}, a clip (slots, rows, cols)",),
        helps=helps,
    )


def _still(request: _Request, path: Path) -> Light:
    from nscc_runtime.scenes import picture_files

    _refuse(request, "a still has no frame rate", "fps")
    wanted = request.exposure or exposure.needed(request.name)
    transfer = request.transfer or picture_files.default_transfer(path)
    frame = _luminance(request, picture_files.read_picture(path), transfer, str(path))
    factor = _still_scale(request, frame, wanted)
    return Light.of_still(frame, request.slot_s * factor, factor)


def _still_scale(request: _Request, frame: NDArray[np.float32], wanted: Exposure) -> float:
    """Electrons a second for one unit of a still."""
    return exposure.scale(
        frame.astype(np.float64) * float(request.slot_s.sum()), wanted, request.name
    )


def _clip(request: _Request, stored: Iterator[NDArray[Any]], transfer: Transfer) -> Light:
    """The first frames of a clip: one a slot, or as `--fps` lays them under the slots."""
    wanted = request.exposure or exposure.needed(request.name)
    fps = None if request.fps is None else timing.check_fps(request.fps)
    need = request.slots if fps is None else timing.frames_needed(request.slot_us, fps)
    frames = np.empty((0, request.window.rows, request.window.cols), np.float32)
    have = 0
    for picture in request.progress(stored, "reading frames", need):
        frame = _luminance(request, picture, transfer, f"{request.name}, frame {have}")
        if have == len(frames):
            # realloc grows a large block without a copy; the final size is exactly `need`
            frames.resize((min(need, max(64, 2 * have)), *frame.shape), refcheck=False)
        frames[have] = frame
        have += 1
        if have == need:
            break
    if have < need:
        raise timing.too_short(request.name, have, need, request.slots, request.fps)
    if fps is None:
        factor = exposure.scale(frames.sum(axis=0, dtype=np.float64), wanted, request.name)
        clip, seconds, rate = Light.of_clip(frames, factor), None, 1.0
    else:
        parts = timing.overlaps(request.slot_us, fps)
        clip = timing.spread(frames, parts, wanted, request.name)
        seconds, rate = parts.seconds, float(fps)
    return timing.with_motion(clip, seconds, rate) if request.frames_are == "samples" else clip


def _luminance(
    request: _Request, stored: NDArray[Any], transfer: Transfer, name: str
) -> NDArray[np.float32]:
    """The part of a stored picture on the array as luminance; NS0736 for what is not light."""
    with np.errstate(invalid="ignore", over="ignore"):  # the census says what is no light
        peak = float(stored.max()) if stored.dtype.kind == "f" else 0.0
        part = linear(request.window.of(stored, request.name), transfer)
        values = luminance(part) if part.ndim == 3 else part
        low = float(values.min())
    if low < 0 and low >= -_TINY_NEGATIVE * peak:
        count = int(np.count_nonzero(values < 0))
        values = np.maximum(values, 0.0)
        request.warn(_clamped(name, count, values.size, low))
    refuse_no_light(values, name)
    return values.astype(np.float32)


def _clamped(name: str, count: int, total: int, low: float) -> Diagnostic:
    return Diagnostic(
        "NS0740",
        f"{count} of {total} pixels of '{name}' were negative and are taken as dark",
        severity=Severity.WARNING,
        notes=(f"the lowest is {low:.3g}; so little below zero is left by filters, not by light",),
        helps=("nothing needs to be done; clip the picture at 0 to be rid of this message",),
        data={"count": count},
    )
