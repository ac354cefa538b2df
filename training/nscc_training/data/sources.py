"""Sources of scenes, and the split into training and validation."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from hashlib import sha256
from itertools import islice
from pathlib import Path
from typing import NamedTuple

import numpy as np

from nscc.arrays import Array, Floats, Floats32
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.files import file_sha256
from nscc_runtime.scene_settings import Transfer
from nscc_runtime.scenes.colour import Colours, linear
from nscc_runtime.scenes.picture_files import (
    DISPLAY,
    LINEAR,
    PICTURES,
    only_picture,
    open_pages,
    read_frames,
)
from nscc_runtime.scenes.picture_light import picture_light
from nscc_training import made_scenes
from nscc_training.curves import srgb
from nscc_training.data.moving import (
    light_of_picture,
    moving,
    pictures_below,
    shown_picture,
)
from nscc_training.import_paths import imported, is_import_path, own_code, own_failed
from nscc_training.protocol_scenes.clips import moving_texture
from nscc_training.protocols import load_protocol
from nscc_training.random_streams import DrawStream
from nscc_training.scene_files import CLIPS, centre_of, class_of, data_files, frames_in, names_of
from nscc_training.settings import DataSettings
from nscc_training.turning_camera import turned

_MOST_SIDE = 512
"""Clips are cut to this many rows and columns around their centre: training takes patches."""
_CAMERA_SIDE = 256
"""Minimum rows and columns of the clips made of a panorama."""
_MOST_LIGHT = 1e32
"""Largest valid light; larger values would overflow in sums over all slots."""
_LIT_SHARE = 0.01
"""Fraction of a clip's pixels, the brightest ones, whose light determines its exposure."""
_VALIDATION = 5
"""Every fifth file is for validation if no folder is named for it."""


class SourceScene(NamedTuple):
    """A scene: linear light (rows, cols) or (T, rows, cols), in an arbitrary unit.

    `name` is that of its file, for messages. White is 1 in clips from display files. `sha256` is
    the digest of the file, or of the array if there is no file. `label` is its class; "" if clips
    are not classified."""

    name: str
    sha256: str
    light: Floats32
    label: str = ""


class Scenes(NamedTuple):
    """The scenes of a training run. `train` and `val` (validation) share no scene."""

    train: tuple[SourceScene, ...]
    val: tuple[SourceScene, ...]

    def split(self) -> dict[str, list[dict[str, str]]]:
        """Return the content of `split.json`: for "train" and "val", a list with the `file` name
        and `sha256` of each scene."""
        return {
            split_name: [{"file": s.name, "sha256": s.sha256} for s in scenes]
            for split_name, scenes in (("train", self.train), ("val", self.val))
        }


def load_scenes(
    settings: DataSettings,
    still: bool,
    slots: int,
    seed: int,
    *,
    pictures: bool = False,
    classes: tuple[str, ...] = (),
    tell: Callable[[str], object] = lambda _text: None,
) -> Scenes:
    """Load the training and validation scenes that a configuration names.

    `still` chooses stills, otherwise clips of at least `slots` frames. `seed` determines procedural
    scenes and camera paths. With `pictures`, the training scenes are the light of all pictures in a
    folder and its subfolders. With `classes`, each scene has one of these classes, the name of its
    file's folder. `tell` is called with messages on the validation split and on changes of a scene.
    Raises Rejected: NS0811 for a folder without suitable scenes, or if training and validation
    would share a scene; NS0812 for an import path."""
    kind = _Kind(settings, still, slots, seed, classes, tell)
    train = (
        [_of_picture(path, kind) for path in pictures_below(Path(settings.train))]
        if pictures
        else _load(settings.train, kind, "train")
    )
    if settings.val or pictures or settings.train == "procedural":
        if pictures and not settings.val:
            tell("validation: procedural scenes, as lessons learn from all pictures of data.train")
        val = _load(settings.val or "procedural", kind, "val")
    else:
        # By file: the clips of one panorama stay together.
        validation_digests = set(
            list(dict.fromkeys(scene.sha256 for scene in train))[::_VALIDATION]
        )
        val = [scene for scene in train if scene.sha256 in validation_digests]
        train = [scene for scene in train if scene.sha256 not in validation_digests]
        kept_back = ", ".join(dict.fromkeys(scene.name.partition(", path ")[0] for scene in val))
        count = len(validation_digests) + len({s.sha256 for s in train})
        tell(
            f"validation: {len(validation_digests)} of {count} scenes of "
            f"'{settings.train}' ({kept_back[:200]}), every fifth; data.val names a folder instead"
        )
    shared = {s.sha256 for s in train} & {s.sha256 for s in val}
    if shared or not train or not val:
        names = sorted(s.name for s in val if s.sha256 in shared)
        raise rejected(
            "NS0811",
            "training and validation share scenes" if shared else "there are too few scenes",
            notes=(f"shared: {', '.join(names[:5])}",) if shared else (),
            helps=(
                "name different folders in [data] train and val, or leave val empty: every "
                "fifth file of train is then used for validation, which needs at least two "
                "files",
            ),
        )
    return Scenes(tuple(train), tuple(val))


class _Kind(NamedTuple):
    """The kind of scenes to load, and how: stills, or clips of at least `slots` frames. `settings`
    is the section [data], `seed` that of procedural scenes and camera paths. `classes` are the
    names of classes, empty without. `tell` receives messages."""

    settings: DataSettings
    still: bool
    slots: int
    seed: int
    classes: tuple[str, ...] = ()
    tell: Callable[[str], object] = lambda _text: None

    def light(self, stored: Array, colours: Transfer | Colours, name: str) -> Floats:
        """Return the light (rows, cols) of a picture `stored` in a file, (rows, cols) or with
        colours last, converted as by `nscc run`. `colours` is its encoding, `name` names it in
        messages; warnings are passed to `tell`."""
        return picture_light(
            stored, colours, name, warn=lambda diagnostic: self.tell(diagnostic.message)
        )


def _of_picture(path: Path, kind: _Kind) -> SourceScene:
    """Return the light of the picture at `path` for lessons. Raise Rejected (NS0811) for a picture
    from which a still of two patches by two cannot be cut."""
    light = light_of_picture(path)
    if kind.still and min(light.shape) < 2 * kind.settings.patch:
        rows, cols = light.shape
        side = 2 * kind.settings.patch
        raise _unusable(path.name, f"it is {rows} x {cols}, but lessons need {side} x {side}")
    return SourceScene(path.name, file_sha256(path), light)


def _load(source: str, kind: _Kind, split_name: str) -> list[SourceScene]:
    """Return the scenes of a source, converted as `kind` says: "procedural", a Python function
    (module:name), or the files in a folder.

    `split_name` is "train" or "val". Raises Rejected (NS0811, NS0812) for scenes that training
    cannot use."""
    if source == "procedural":
        return _procedural_scenes(kind, split_name)
    if is_import_path(source):
        call = imported(source, "data")
        with own_code(source, "data"):
            kind_text = "still" if kind.still else "clip"
            scenes = call(kind=kind_text, part=split_name, slots=kind.slots, seed=kind.seed)
            drawn = [(str(name), np.asarray(light), label) for name, light, *label in scenes]
        for name, _, label in drawn:
            # With classes, every scene needs one of them; without, none may have one.
            if label not in ([[known] for known in kind.classes] or [[]]):
                wanted = f"one of {', '.join(kind.classes)}" if kind.classes else "no class"
                raise own_failed(
                    source,
                    "data",
                    f"scene '{name[:60]}' must have {wanted}, after its name and its light",
                )
        return [
            _scene(name, light, kind)._replace(label="".join(label)) for name, light, label in drawn
        ]
    kind_text = "stills" if kind.still else "clips"
    files = data_files(
        Path(source),
        LINEAR if kind.still else (*CLIPS, *LINEAR, *DISPLAY),
        f"{kind_text} for training",
        f"{kind_text} end in",
        "such files, `procedural`, or a function as module:name",
        by_class=bool(kind.classes),
    )
    return [
        scene._replace(label=class_of(path, kind.classes) if kind.classes else "")
        for path, name in names_of(files).items()
        for scene in _read(path, name.as_posix(), kind)
    ]


def _procedural_scenes(kind: _Kind, split_name: str) -> list[SourceScene]:
    """Return the synthetic scenes of the split `split_name`, "train" or "val", determined by the
    seed of `kind`. For validation there are a quarter as many as for training."""
    count, stream = kind.settings.scenes, DrawStream.TRAINING_SCENES
    if split_name != "train":
        count, stream = -(-count // 4), DrawStream.VALIDATION_SCENES
    # Larger than a patch, so that patches can be cut at different places.
    size = max(kind.settings.patch + kind.settings.patch // 2, 32)
    protocol = load_protocol(kind.settings.protocol)
    scenes = []
    for index in range(count):
        generator = np.random.default_rng([kind.seed, stream, index])
        label = ""
        if kind.classes:
            label, light = moving_texture(
                generator, index, kind.classes, kind.slots, size, protocol
            )
        elif kind.still:
            light = made_scenes.still(generator, size)
        else:
            light = made_scenes.clip(generator, kind.slots, size)
        scene = _scene(f"procedural-{split_name}-{index}", light, kind)
        scenes.append(scene._replace(label=label))
    return scenes


def _read(path: Path, name: str, kind: _Kind) -> list[SourceScene]:
    """Return the scenes of the file `path`, called `name`: a still; the first frames of a video; or
    as many clips as the setting `paths`, of a camera that turns in a linear panorama, or whose
    layers are cut from a display photograph.

    The file's digest and the seed determine the motion in such clips."""
    digest = file_sha256(path)
    suffix = path.suffix.lower()
    if suffix not in PICTURES:
        chosen = kind.settings.transfer or ("linear" if suffix == ".mat" else "srgb")
        transfer: Transfer = "linear" if chosen == "linear" else "srgb"
        light = _clip_light(path, frames_in(path), transfer, kind)
        return [_scene(name, light, kind, digest)]
    pages = open_pages(path)
    if pages.count > 1 and not kind.still:
        light = _clip_light(path, read_frames(path), pages.colours, kind)
        return [_scene(name, light, kind, digest)]
    if suffix not in DISPLAY:
        still = kind.light(only_picture(path, pages), pages.colours, str(path))
        if kind.still:
            return [_scene(name, still, kind, digest)]
    size = max(kind.settings.patch, _CAMERA_SIDE)
    curve: Transfer = "linear" if kind.settings.transfer == "linear" else "srgb"
    if suffix in DISPLAY:
        picture = shown_picture(light_of_picture(path))
    scenes = []
    for index in range(kind.settings.paths):
        # A seed takes numbers: the first 32 bits of the digest.
        seeds = (kind.seed, DrawStream.CAMERA_PATHS, int(digest[:8], 16), index)
        generator = np.random.default_rng(seeds)
        # All layers of a clip come from one file, so that training and validation stay separate.
        clip = (
            linear(moving([picture], generator, kind.slots, size), curve)
            if suffix in DISPLAY
            else _turned(still.astype(np.float32), kind, size, generator)
        )
        scenes.append(_scene(f"{name}, path {index}", clip, kind, digest))
    return scenes


def _turned(panorama: Floats32, kind: _Kind, size: int, generator: np.random.Generator) -> Floats32:
    """Return a clip (slots, size, size) of a camera that turns in `panorama` (rows, cols), on a
    path that `generator` draws.

    Light is divided by its 99 % quantile. It is then put in display encoding if the settings treat
    stored values as light, because such runs learn from display values."""
    light = turned(panorama, generator, kind.slots, size)
    light /= np.float32(max(float(np.percentile(light, 99)), 1e-30))
    return srgb(np.clip(light, 0, 1)) if kind.settings.transfer == "linear" else light


def _clip_light(
    path: Path, stored: Iterable[Array], colours: Transfer | Colours, kind: _Kind
) -> Floats32:
    """Return the light of the first of the `stored` frames, (frames, rows, cols), cut to at most
    `_MOST_SIDE` rows and columns in their middle.

    The settings of `kind` limit the number of frames. `colours` is the encoding of the frames, and
    `path` names them in messages. Raises ValueError for frames of different sizes."""
    frames = [
        kind.light(centre_of(np.asarray(frame), _MOST_SIDE), colours, f"{path}, frame {number}")
        for number, frame in enumerate(islice(stored, kind.settings.frames))
    ]
    return np.stack(frames, dtype=np.float32, casting="same_kind")


def _scene(name: str, light: Array, kind: _Kind, digest: str | None = None) -> SourceScene:
    """Return the scene with this name and light, float32. Raise Rejected (NS0811), with the reason,
    if training cannot use it.

    `digest` is that of its file; None takes that of the light. A still whose light is far from 1 is
    divided by its maximum."""
    patch, reason = kind.settings.patch, ""
    if light.dtype.kind not in "uifb":
        reason = f"its light is {light.dtype}, not real numbers"
    elif light.ndim != (2 if kind.still else 3):
        reason = f"its light is {light.shape}"
    elif min(light.shape[-2:]) < patch:
        reason = f"it is {light.shape[-2]} x {light.shape[-1]}, but a patch is {patch} x {patch}"
    elif not kind.still and len(light) < kind.slots:
        reason = f"it has {len(light)} frames, but a window has {kind.slots}"
    elif not (light.min() >= 0 and light.max() <= _MOST_LIGHT):
        reason = (
            f"its light contains values that are negative, not a number, or above {_MOST_LIGHT:g}"
        )
    else:
        share = max(kind.settings.saturated) if kind.still else _LIT_SHARE
        lit = float(np.mean(light > 0 if kind.still else light.any(axis=0)))
        if lit < share:
            reason = (
                f"{lit:.1%} of its pixels have light, but at least {share:.0%} must: it is "
                "dark where it should saturate"
            )
    if reason:
        raise _unusable(name, reason)
    if kind.still and not _MOST_LIGHT**-0.25 < light.max() < _MOST_LIGHT**0.25:
        # Stills have an arbitrary unit; far from 1 their powers and sums overflow float32.
        light = light.astype(np.float64) / (float(light.max()) or 1.0)
    values = np.ascontiguousarray(light, np.float32)
    return SourceScene(name, digest or sha256(values.tobytes()).hexdigest(), values)


def _unusable(name: str, reason: str) -> Rejected:
    """Return the exception (NS0811) for a scene `name` that training cannot use, for a `reason`."""
    return rejected(
        "NS0811",
        f"'{name}' cannot be used as a scene of this configuration",
        notes=(reason,),
        helps=("remove it from the folder, or change [data] patch or [shutter] slots",),
    )
