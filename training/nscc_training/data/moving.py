"""Synthetic clips made of photographs: layers that pan, rotate, zoom, bend and cross one another.

Few videos have a free licence, but many photographs do. The photographs provide detail. The layers
provide independent motion, with edges that cover and uncover the background."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from nscc.arrays import Bytes, Floats, Floats32
from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.scenes.picture_files import PICTURES, only_picture, open_pages
from nscc_runtime.scenes.picture_light import picture_light
from nscc_training.curves import srgb
from nscc_training.scene_files import folders_of

Picture = Bytes
Generator = np.random.Generator

_SHORT = 1000
"""Photographs are halved until their shorter side is below this number of pixels."""
_LOOKED_AT = 3
"""Number of random places of a picture; the one with most detail is used."""
_SPEEDS = (0.03, 6.0)
"""Slowest and fastest speed in pixels per frame, drawn uniformly in the logarithm."""
_STILL = 0.15
"""Fraction of layers that stand still."""
_BLURRED = 3
"""Number of moments that are averaged for a frame with motion blur."""


def moving(pictures: Sequence[Picture], generator: Generator, frames: int, size: int) -> Floats32:
    """Return a clip (frames, size, size), float32, with values from 0 to 1, composed of parts of
    `pictures`.

    Pictures (rows, cols) have 8 bits and are larger than `size`, in pixels. All draws come from
    `generator`. The background and up to three objects come from randomly chosen pictures. Half of
    the clips have motion blur. The values are in display encoding, changed by a random power and
    range."""
    layers = [_Layer.drawn(pictures, generator, size, background=True)]
    for _ in range(int(generator.integers(0, 4))):
        layers.append(_Layer.drawn(pictures, generator, size, background=False))
    moments = _BLURRED if generator.random() < 0.5 else 1
    clip = np.zeros((frames, size, size), np.float32)
    for frame in range(frames):
        for moment in range(moments):
            # In frames, 0 in the middle of the clip.
            time = frame + moment / moments - frames / 2
            image = layers[0].picture_at(time, size)
            for layer in layers[1:]:  # each covers those before it
                cover = layer.cover_at(time, size)
                if cover.any():
                    image += cover * (layer.picture_at(time, size) - image)
            clip[frame] += image
    clip /= moments * 255
    # Most clips are stretched to the whole range; a dull one is amplified by 10 at most.
    if generator.random() < 0.6:
        low, high = np.percentile(clip[0], (1, 99))
        clip = np.clip((clip - low) / max(high - low, 0.1), 0, 1)
    power = float(np.exp(generator.uniform(np.log(0.7), np.log(2.4))))
    gain, dark = generator.uniform(0.5, 1.0), generator.uniform(0.0, 0.1)
    return np.asarray(dark + (gain - dark) * clip**power, np.float32)


class _Layer(NamedTuple):
    """A moving picture.

    At time t, in frames from the middle of the clip, place p shows `picture` at centre + turn(angle
    + spin t) (p - size / 2 - velocity t) * scale * zoom^t, distorted by waves. Velocity is in
    pixels per frame, angles are in radians. `outline` contains the radii of a polygon around
    `middle`; it is None for a background."""

    picture: Picture
    centre: Floats
    velocity: Floats
    scale: float
    zoom: float
    angle: float
    spin: float
    waves: Floats
    middle: Floats
    outline: Floats | None

    @classmethod
    def drawn(
        cls, pictures: Sequence[Picture], generator: Generator, size: int, *, background: bool
    ) -> _Layer:
        """Return a random layer: a picture with its motion, rotation, zoom, waves and outline.

        `size` is the side of the clip in pixels. A background fills the frame and has no outline.
        Of several random places in a random picture, the layer shows the one with most detail."""
        picture = pictures[int(generator.integers(len(pictures)))]
        speed = np.exp(generator.uniform(*np.log(_SPEEDS))) * (generator.random() > _STILL)
        heading = generator.uniform(0, 2 * np.pi)
        turning = generator.random() < 0.4
        waves = np.zeros(6)
        if generator.random() < 0.3:
            # Height in pixels, cycles a pixel down and across, phases, cycles a frame.
            waves = np.array(
                [
                    generator.uniform(0.3, 3),
                    *generator.uniform(-0.04, 0.04, 2),
                    *generator.uniform(0, 2 * np.pi, 2),
                    generator.uniform(0.01, 0.15),
                ]
            )
        outline = None
        if not background:
            corners = generator.uniform(0.4, 1.0, int(generator.integers(4, 12)))
            # The distance of the farthest corner is 8 to 40 % of the clip's side.
            outline = corners * size * generator.uniform(0.08, 0.4)
        # Away from the borders, beyond which the picture is mirrored.
        points = generator.uniform(0.15, 0.85, (_LOOKED_AT, 2)) * picture.shape

        def detail(point: Floats) -> float:
            """Return the standard deviation of the picture around a place (row, column): a measure
            of its detail."""
            row, col = (int(at) - size // 2 for at in point)
            region = picture[max(0, row) : row + size : 2, max(0, col) : col + size : 2]
            return float(region.std())

        return cls(
            picture=picture,
            centre=np.asarray(max(points, key=detail)),
            velocity=speed * np.array([np.sin(heading), np.cos(heading)]),
            scale=float(np.exp(generator.uniform(np.log(0.6), np.log(1.7)))),
            zoom=float(np.exp(generator.normal(0, 0.01) * turning)),
            angle=float(generator.uniform(0, 2 * np.pi)),
            spin=float(generator.normal(0, 0.03) * turning),
            waves=waves,
            middle=generator.uniform(0.1, 0.9, 2) * size,
            outline=outline,
        )

    def picture_at(self, moment: float, size: int) -> Floats32:
        """Return what the layer shows at time `moment`, in frames from the middle of the clip:
        (size, size), values 0 to 255. Beyond its border the picture is mirrored."""
        import cv2

        rows, cols = np.mgrid[:size, :size].astype(np.float32)
        down = rows - size / 2 - self.velocity[0] * moment
        right = cols - size / 2 - self.velocity[1] * moment
        height, per_row, per_col, phase_down, phase_right, pace = self.waves
        if height:
            phase = 2 * np.pi * (per_row * rows + per_col * cols + pace * moment)
            down, right = (
                down + height * np.sin(phase + phase_down),
                right + height * np.sin(phase + phase_right),
            )
        scale, angle = self.scale * self.zoom**moment, self.angle + self.spin * moment
        sine, cosine = scale * np.sin(angle), scale * np.cos(angle)
        y = self.centre[0] + cosine * down - sine * right
        x = self.centre[1] + sine * down + cosine * right
        warped = cv2.remap(
            self.picture,
            x.astype(np.float32),
            y.astype(np.float32),
            cv2.INTER_LINEAR,
            borderMode=cv2.BORDER_REFLECT_101,
        )
        return np.asarray(warped, np.float32)

    def cover_at(self, moment: float, size: int) -> Floats32:
        """Return the fraction (0 to 1) of each pixel of (size, size) that the object covers at time
        `moment`, in frames from the middle of the clip. Its edge is one pixel wide. The layer must
        not be a background."""
        assert self.outline is not None
        y, x = self.middle + self.velocity * moment
        rows, cols = np.mgrid[:size, :size].astype(np.float32)
        rows, cols = rows - np.float32(y), cols - np.float32(x)
        angles = np.arange(len(self.outline) + 1) * (2 * np.pi / len(self.outline))
        bearing = (np.arctan2(rows, cols) + self.spin * moment) % (2 * np.pi)
        edge = np.interp(bearing, angles, np.append(self.outline, self.outline[0]))
        cover = np.clip(edge - np.hypot(rows, cols) + 0.5, 0, 1)
        return np.asarray(cover, np.float32)


def pictures_below(folder: Path) -> list[Path]:
    """Return the paths of all pictures in a folder (or several, as a pattern names them) and its
    subfolders, sorted, each once. Raise Rejected (NS0811) if there are none."""
    files = sorted(
        {
            path
            for folder_path in folders_of(str(folder))
            for path in folder_path.rglob("*")
            if path.suffix.lower() in PICTURES and path.is_file()
        }
    )
    if not files:
        raise rejected(
            "NS0811",
            f"the folder '{folder}' contains no pictures",
            notes=(f"pictures end in {', '.join(PICTURES)}",),
            helps=("`python training/data/fetch.py DIR` downloads photographs with free licences",),
        )
    return files


def light_of_picture(path: Path) -> Floats32:
    """Return the linear light of the picture file `path`, float32 (rows, cols), halved until its
    shorter side is below `_SHORT` pixels.

    The reduction gives as much detail per pixel as small cameras have."""
    import cv2

    pages = open_pages(path)
    light = picture_light(only_picture(path, pages), pages.colours, str(path)).astype(np.float32)
    while min(light.shape) >= _SHORT:
        half = cv2.resize(light, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA)
        light = np.asarray(half, np.float32)
    return light


def shown_picture(light: Floats32) -> Picture:
    """Return the 8-bit display picture of linear light. White is the 98 % quantile of the light;
    brighter pixels are clipped. `light` is (rows, cols), and the result, uint8, too."""
    level = max(float(np.percentile(light, 98)), 1e-30)
    return np.asarray(np.rint(srgb(np.clip(light / level, 0, 1)) * 255), np.uint8)
