"""Load the light on the array from a scene's name (`--scene`)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Array, Floats, Floats32
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Diagnostic, rejected
from nscc.diagnostics.suggest import closest, did_you_mean
from nscc.files import reads, why_no_file
from nscc.toml.schema import declared
from nscc_runtime.light import Light
from nscc_runtime.progress import Progress, unseen
from nscc_runtime.scene_settings import Scene
from nscc_runtime.scenes import exposure, light_arrays, timing
from nscc_runtime.scenes.bracket import bracket_files, merged_bracket, parse_times
from nscc_runtime.scenes.colour import Colours
from nscc_runtime.scenes.errors import Warn, refuse_no_light, unheard
from nscc_runtime.scenes.exposure import ExposureLevel, check_white, parse_exposure
from nscc_runtime.scenes.pages import Edges, Pages
from nscc_runtime.scenes.picture_light import picture_light
from nscc_runtime.scenes.placement import (
    Placement,
    Window,
    changes,
    in_colour,
    parse_crop,
    picture_note,
    placed,
    placement_of,
)
from nscc_runtime.scenes.timing import evenly, from_frame, timed

Stored = tuple[Array, Colours]
"""A picture as stored, and the meaning of its samples."""

ARRAYS = (".mat", ".npy", ".npz")
"""Endings of the files that hold arrays."""
_BUILTINS = ("hdr", "motion", "dark")


@dataclass(frozen=True)
class _Loading:
    """A scene to load, and what it is loaded for.

    `window` is the array and its place in pictures. `slot_us` are the lengths of slots in
    microseconds. `warn` gets notes on changes of the scene (NS0740, NS0773, NS0776), `progress` the
    frames as they are read. `channel`: red, green or blue (0 to 2) of a colour picture; None for
    its luminance. `factor`: electrons per unit of the scene, instead of an exposure; None to use
    the exposure. `notes` collects sentences about how the file was read."""

    scene: Scene
    window: Window
    slot_us: Sequence[float]
    warn: Warn = unheard
    progress: Progress = unseen
    channel: int | None = None
    factor: float | None = None
    notes: list[str] = field(default_factory=list)

    @property
    def name(self) -> str:
        """The name of the scene."""
        return self.scene.name

    @cached_property
    def exposure_level(self) -> ExposureLevel | None:
        """The exposure that the scene asks for, or None."""
        return parse_exposure(self.scene.exposure)

    def check_light(self, shape: tuple[int, ...]) -> None:
        """Raise NS0733 to NS0735 if a `light` array of this `shape` is not (slots, rows, cols) or
        (rows, cols) of the program and the array."""
        light_arrays.check_shape(self.name, shape, self.slots, self.window.array)

    def check_exposure(self) -> None:
        """Raise Rejected (NS0737) if the scene has no exposure and the request no factor to
        electrons. It is called for scenes without a unit only."""
        if self.factor is None and self.exposure_level is None:
            raise rejected(
                "NS0737",
                f"--exposure is missing: the scene '{self.name}' has no scale in electrons",
                notes=(
                    "pictures and clips contain relative light; only `light` arrays contain "
                    "electrons",
                ),
                helps=(
                    "add --exposure 30000: the pixel at percentile 99 then gets 30000 electrons "
                    "over the whole frame, a full well of scamp5",
                ),
            )

    def scale(self, open_sum: Floats, placement: Placement) -> float:
        """Return the factor from the scene's unit to electrons: `factor`, or the factor that gives
        the requested exposure.

        `open_sum` (rows, cols) is the light over the frame in the scene's unit, on all arrays. Only
        its part on the picture counts, which `placement` cuts out. Raises Rejected (NS0738) like
        `exposure.scale`."""
        if self.factor is not None:
            return self.factor
        assert self.exposure_level is not None  # `check_exposure` was called
        return exposure.scale(placement.cut(open_sum), self.exposure_level, self.name)

    @property
    def on_array(self) -> Placement:
        """The placement of a scene that has the size of the array."""
        array = self.window.array
        return Placement("crop", array, array, array)

    @property
    def slots(self) -> int:
        """The number of slots."""
        return len(self.slot_us)


@dataclass(frozen=True, eq=False)
class PlacedLight:
    """Light on the arrays of `placement`.

    `colour`: whether the source is in colour. `notes`: sentences about how the file was read, if
    the user may expect something else."""

    light: Light
    placement: Placement
    colour: bool = False
    notes: tuple[str, ...] = ()


def scene_light(
    scene: Scene,
    slot_us: Sequence[float],
    target: Target,
    warn: Warn = unheard,
    progress: Progress = unseen,
) -> Light:
    """Return the light of `scene` on one array of `target`, in slots of `slot_us` microseconds. The
    scene must not need several arrays or colours: of three lights only red is returned.

    `warn` gets notes on changes of the scene, `progress` the frames as they are read. Raises
    Rejected (status 2) for a scene that cannot be read or does not fit, as `laid_scene` does."""
    return laid_lights(scene, slot_us, target, warn, progress)[0].light


def laid_lights(
    scene: Scene,
    slot_us: Sequence[float],
    target: Target,
    warn: Warn = unheard,
    progress: Progress = unseen,
) -> tuple[PlacedLight, ...]:
    """Return the light of `scene` in slots of `slot_us` microseconds, on as many arrays of `target`
    as it needs.

    It is one light, the luminance, or three lights (red, green, blue) if `scene.color` is set; all
    have the factor that gives the luminance its exposure. A scene without colours gives one light
    and a note (NS0773). `warn` gets notes on changes of the scene, `progress` the frames as they
    are read. Raises Rejected like `laid_scene`."""
    load = partial(
        laid_scene, scene, slot_us=slot_us, rows=target.rows, cols=target.cols, progress=progress
    )
    diagnostics: list[Diagnostic] = []
    grey = load(warn=diagnostics.append)
    in_colours = scene.color and grey.colour
    if scene.color and not grey.colour:
        text = f"'{scene.name}' has no colours, so it is exposed once"
        diagnostics.append(picture_note(text, "leave --color out"))
    for diagnostic in diagnostics:
        if not (in_colours and diagnostic.data.get("grey")):
            warn(diagnostic)
    if not in_colours:
        return (grey,)
    factor = grey.light.exposure_scale_e
    return tuple(load(channel=k, factor=factor) for k in range(3))


def laid_scene(
    scene: Scene, *, slot_us: Sequence[float], rows: int, cols: int, **about: Any
) -> PlacedLight:
    """Load a scene (a file, a folder of pictures or `builtin:NAME`) and lay it on an array of
    `rows` x `cols` pixels.

    `slot_us` are the lengths of the program's slots in microseconds. `about` are further fields of
    `_Loading`: `warn`, `progress`, `channel` and `factor`. Options of the scene that do not apply
    to its kind are refused.

    "samples" as `frames_are` declares that the scene moves within a frame. That motion is an effect
    of the sensor model (`Light.motion`): with effects off a sample stands for its whole frame, as
    an integral.

    Raises Rejected (status 2): NS0730 to NS0739, NS0776 for missing frames, NS0777 for a bracket.
    """
    crop, spec = parse_crop(scene.crop), scene.name
    loading = _Loading(scene, Window((rows, cols), crop), slot_us, **about)
    exposure_level, times = loading.exposure_level, parse_times(scene.times)
    # Options that this kind of scene does not use are refused, not ignored.
    check_white(scene.white)
    if crop is not None and scene.fit != "crop":
        _refuse(loading, f"--fit {scene.fit} exposes the whole picture", "crop")
    if spec.startswith("builtin:"):
        from nscc_runtime.scenes.builtin import load_builtin

        why = "a built-in scene already fits the array and the program's slots"
        _refuse(loading, why, "transfer", "fps", "crop", "first", "white", "bracket", "skip")
        light = load_builtin(spec, slot_us=slot_us, rows=rows, cols=cols, exposure=exposure_level)
        if light.kind != "still":
            _refuse(loading, why, "single")
        return PlacedLight(light, loading.on_array)
    if not scene.bracket:
        _refuse(
            loading,
            "only photos of a bracket have exposure times, and --bracket reads them",
            "times",
        )
    else:
        _refuse(
            loading,
            "a bracket gives one still, without frames to select and without a white level",
            "first",
            "white",
            "skip",
        )
        files = bracket_files(spec)
        transfer, say_notes = loading.scene.transfer, partial(_say_notes, loading)
        return _still(loading, lambda: merged_bracket(files, times, transfer, say_notes))
    return _load_path(loading, _existing(spec))


def light_of_array(
    values: Array, *, slot_us: Sequence[float], rows: int, cols: int, name: str = "light"
) -> Light:
    """Return the light of an array: electrons per slot (N, rows, cols), or per second (rows, cols).

    `slot_us` are the lengths of the N slots in microseconds, `rows` and `cols` the size that is
    needed, and `name` is for messages. float32 arrays in C order are not copied, and must not be
    modified while the light is in use. Raises Rejected (status 2, NS0733 to NS0736) for arrays that
    do not fit or that are not light."""
    loading = _Loading(Scene(name), Window((rows, cols)), slot_us)
    values = np.asarray(values)
    light_arrays.check_type(Path(name), "light", values.dtype)
    loading.check_light(values.shape)
    refuse_no_light(values, name)
    return _electrons(loading, np.ascontiguousarray(values, np.float32))


def _existing(spec: str) -> Path:
    """Return the path of the scene `spec`, a file or a folder. Raises Rejected (NS0730) if there is
    no such file, or it is of another kind; a builtin scene with a similar name is suggested."""
    path = Path(spec)
    try:
        if path.is_dir() or path.is_file():
            return path
        reason = why_no_file(path)
    except (OSError, ValueError) as error:
        reason = str(error)
    suggestion = spec if spec in _BUILTINS else closest(spec, _BUILTINS)
    raise rejected(
        "NS0730",
        f"the scene '{spec[:200]}' cannot be opened: {reason}",
        helps=(
            *(("--scene takes a pattern only with --bracket",) if "*" in spec else ()),
            *((did_you_mean(f"builtin:{suggestion}"),) if suggestion and not path.suffix else ()),
            "name a file, a folder of pictures or a builtin scene: builtin:hdr, builtin:motion, "
            "builtin:flat:E, builtin:dark",
        ),
    )


def _load_path(loading: _Loading, path: Path) -> PlacedLight:
    """Return the light of the file or folder `path` on the array. The ending of a file decides
    whether it is an array or has pictures.

    A file of one picture is a still, unless its format is that of clips; several pictures are a
    clip. Raises Rejected: NS0731 for an unknown ending, NS0739 for options that do not apply, and
    the errors of the reader."""
    from nscc_runtime.scenes.picture_files import CLIPS, PICTURES, open_pages

    reads(path)
    suffix = path.suffix.lower()
    if path.is_dir():
        return _folder(loading, path)
    _refuse(loading, "only a folder of pictures can lack frames", "skip")
    if suffix in ARRAYS:
        return _array(loading, path)
    if suffix not in PICTURES + CLIPS:
        known = ", ".join(sorted(ARRAYS + PICTURES + CLIPS))
        raise rejected(
            "NS0731",
            f"the ending of '{path}' is not a scene format",
            notes=(f"scenes end in {known}, or are folders of pictures",),
            helps=("give the file the ending of its format",),
        )
    pages = open_pages(path, large=True)
    if pages.count == 1 and not pages.is_clip:
        _refuse(loading, "a still is one frame", "first")
        _say_notes(loading, pages)
        return _still(loading, lambda: (next(pages.read()), pages.colours))
    pages = pages if loading.scene.single else timed(pages)
    _say_notes(loading, pages)
    return _clip(loading, ((frame, pages.colours) for frame in pages.read()), pages.edges)


def _folder(loading: _Loading, path: Path) -> PlacedLight:
    """Return the light of the folder `path` as a clip, or of one of its pictures with `--still`.
    Its notes are those of the first file that is read. Raises Rejected like `files_of` and
    `read_folder`."""
    from nscc_runtime.scenes.picture_folders import files_of, read_folder

    files = files_of(path, loading.scene.skip, loading.warn)

    def frames() -> Iterator[Stored]:
        """Yield each picture of the folder with its colours, and send the notes of the first."""
        folder = read_folder(files, loading.scene.skip, loading.warn)
        for number, (picture, pages) in enumerate(folder):
            if number == 0:
                _say_notes(loading, pages)
            yield picture, pages.colours

    return _clip(loading, frames())


def _say_notes(loading: _Loading, pages: Pages) -> None:
    """Send the notes of the file `pages` to `warn`, and add them to the request's notes.

    Notes on its colours are left out if the request sets the transfer curve. A request for a single
    colour sends none, because the request for the luminance did."""
    notes = pages.notes + (pages.stated.notes if loading.scene.transfer is None else ())
    for text, help_text in notes if loading.channel is None else ():
        loading.warn(picture_note(f"'{loading.name}' {text}", help_text))
    loading.notes.extend(f"the scene {text}" for text, _ in notes)


def _refuse(loading: _Loading, why: str, *names: str) -> None:
    """Raise Rejected (NS0739), for the reason `why`, if an option is set that does not apply.
    `names` are fields of `Scene`; one is set if it differs from its default. The first one is
    reported."""
    for name in names:
        if getattr(loading.scene, name) != getattr(Scene, name):
            option = declared(Scene)[name].option
            raise rejected(
                "NS0739",
                f"{option} does not apply to the scene '{loading.name}'",
                notes=(why,),
                helps=(f"leave {option} out",),
            )


def _array(loading: _Loading, path: Path) -> PlacedLight:
    """Return the light of the array file `path`: `light` in electrons, or an `orig` clip of a
    benchmark in a .mat file, which is read like a video.

    Raises Rejected: NS0739 for options that do not apply, and the errors of `read_mat` and
    `read_light`."""
    if path.suffix.lower() == ".mat":
        key, values = light_arrays.read_mat(path, loading.check_light)
        if key == light_arrays.MAT_CLIP_KEY:
            light = Colours.of("linear")
            frames = ((values[:, :, k], light) for k in range(values.shape[2]))
            white = loading.scene.white or light_arrays.clip_white(values)
            return _clip(replace(loading, scene=replace(loading.scene, white=white)), frames)
    else:
        values = light_arrays.read_light(path, loading.check_light)
    why = "`light` arrays hold electrons, slot by slot, for every pixel"
    _refuse(loading, why, "fps", "crop", "first", "white")
    if values.ndim == 3:
        _refuse(loading, why, "single")
    if loading.scene.transfer == "srgb":
        _refuse(loading, "`light` arrays hold electrons, which are linear", "transfer")
    return PlacedLight(_electrons(loading, values), loading.on_array)


def _electrons(loading: _Loading, values: Floats32) -> Light:
    """Return the light of `values`: a clip (slots, rows, cols) in electrons, or a still (rows,
    cols) in electrons per second.

    With an exposure, the light is scaled to it. Raises Rejected: NS0736 above 3.4e38 electrons in
    one slot of a still, NS0738 for an exposure that cannot be reached."""
    exposure_level = loading.exposure_level
    if values.ndim == 3:
        clip = Light.of_clip(values)
        if exposure_level is not None:
            factor = exposure.scale(clip.total_e(), exposure_level, loading.name)
            clip = Light.of_clip(values, factor)
        return timing.with_motion(clip) if loading.scene.frames_are == "samples" else clip
    if exposure_level is not None:
        return timing.still(
            values, loading.slot_us, lambda open_sum: loading.scale(open_sum, loading.on_array)
        )
    seconds = np.array(loading.slot_us, np.float64) * 1e-6
    peak = float(values.max()) * float(seconds.max())
    if peak > float(np.finfo(np.float32).max):
        raise rejected(
            "NS0736",
            f"the scene '{loading.name}' gives {peak:g} electrons in one slot",
            notes=("the light of a slot must be below 3.4e38 electrons",),
            helps=("a still in a `light` array is in electrons per second: divide it",),
        )
    return Light.of_still(values, seconds)


def _still(loading: _Loading, read: Callable[[], Stored]) -> PlacedLight:
    """Return the light of a still picture on the arrays, scaled to the exposure. `read` returns the
    picture as stored and the meaning of its samples; it is called after the options were checked.

    Raises Rejected: NS0739 for `--fps`, NS0737 without an exposure, and the errors of `read`."""
    _refuse(loading, "a still has no frame rate", "fps")
    loading.check_exposure()
    stored, colours = read()
    frame, placement = _light(loading, stored, colours, loading.name)
    colour = _say_changes(loading, stored, colours, placement)
    light = timing.still(
        frame, loading.slot_us, lambda open_sum: loading.scale(open_sum, placement)
    )
    return PlacedLight(light, placement, colour, tuple(loading.notes))


def _clip(loading: _Loading, frames_read: Iterator[Stored], edges: Edges = None) -> PlacedLight:
    """Return the light of a clip: one frame per slot, or frames by `--fps`. With `--still` it is
    the light of one frame as a still.

    `frames_read` yields each frame as stored with the meaning of its samples; it is read as far as
    the slots last. `edges`: the starts of frames that last unequally, and the end, in steps; None
    if every frame lasts one. Raises Rejected: NS0735 for a clip that is too short, NS0737 without
    an exposure."""
    scene = loading.scene
    if scene.single:
        read = partial(timing.only_frame, loading.name, frames_read, scene.first)
        return _still(loading, read)
    loading.check_exposure()
    fps = None if scene.fps is None else timing.check_fps(scene.fps)
    frames_read, edges = (
        islice(frames_read, scene.first, None),
        from_frame(edges, scene.first),
    )
    if fps is None:
        need, frames_read = loading.slots, evenly(frames_read, edges)
    else:
        need = timing.frames_needed(loading.slot_us, fps, edges)
    frames, placement = np.empty((0, 0, 0), np.float32), loading.on_array
    have, colour = 0, False
    for picture, colours in loading.progress(frames_read, "reading frames", need):
        name = f"{loading.name}, frame {scene.first + have}"
        frame, placement = _light(loading, picture, colours, name)
        if have == 0:
            colour = _say_changes(loading, picture, colours, placement)
        if have == len(frames):
            # realloc grows a large block without a copy; the final size is `need`
            frames.resize((min(need, max(64, 2 * have)), *frame.shape), refcheck=False)
        frames[have] = frame
        have += 1
        if have == need:
            break
    if have < need:
        raise timing.too_short(loading.name, have, need, loading.slots, scene.fps, scene.first)
    if fps is None:
        factor = loading.scale(frames.sum(axis=0, dtype=np.float64), placement)
        clip, seconds, rate = Light.of_clip(frames, factor), None, 1.0
    else:
        overlap = timing.overlaps(loading.slot_us, fps, edges)
        clip = timing.spread(frames, overlap, lambda open_sum: loading.scale(open_sum, placement))
        seconds, rate = overlap.seconds, float(fps)
    if scene.frames_are == "samples":
        clip = timing.with_motion(clip, seconds, rate, edges)
    return PlacedLight(clip, placement, colour, tuple(loading.notes))


def _say_changes(loading: _Loading, stored: Array, colours: Colours, placement: Placement) -> bool:
    """Return whether the picture `stored` is in colour. Send notes on its changes to `warn`, if the
    request is for the luminance; `colours` and `placement`: see `changes`."""
    colour = in_colour(stored)
    if loading.channel is None:
        # The first loading, for the luminance, sends the notes for all colours.
        for note in changes(loading.scene, stored, colours, placement, colour):
            loading.warn(note)
    return colour


def _light(
    loading: _Loading, stored: Array, colours: Colours, name: str
) -> tuple[Floats32, Placement]:
    """Return a stored picture as light on the arrays (rows, cols), in units of white, and its
    placement.

    `stored` (R, C) or (R, C, 3) are the samples, `colours` their meaning unless the scene sets the
    curve, and `name` is the picture in messages. Raises Rejected: NS0734 for a picture that is too
    small or too large, NS0736 for values that are not light."""
    colours = Colours.of(loading.scene.transfer or colours)
    placement = placement_of(
        loading.scene.fit, (stored.shape[0], stored.shape[1]), loading.window, name
    )
    window = None
    if placement.fit == "crop":
        window = loading.window.place(placement.picture, loading.name)
    values = picture_light(
        stored,
        colours,
        name,
        channel=loading.channel,
        white=loading.scene.white,
        window=window,
        size=placement.size if placement.fit == "scale" else None,
        warn=loading.warn,
    )
    return placed(values, placement), placement
