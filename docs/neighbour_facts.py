"""Measure two unpublished properties of a chip on which programs with images rely.

    python docs/neighbour_facts.py --device /dev/ttyACM0     a chip with nscc's loader
    python docs/neighbour_facts.py --scene builtin:hdr       the emulator, without effects

Halving: compare an exposure that one `bus2` word has halved with the result of the library's `div`
(five words). Reads: write NEWS once, read it from the same neighbour three times in a row, and
compare the three images. The scene must not change, because frames are averaged. Pixels at the
border, and exposures below 10 % or above 90 % of a full well, are left out.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nscc.chips.load import load_target
from nscc.chips.target import Target
from nscc.macros import expand
from nscc.operations import op
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words.container import Container
from nscc.words.encoding import encode
from nscc.words.pictures import Picture, TailLaunch
from nscc.words.pictures import Source as Value
from nscc_runtime.frame_file import Frame

REGISTERS = {"half": "C", "divided": "D", "first": "E", "second": "F", "third": "B"}
"""The register of each image; A holds the exposure."""
WORDS = (
    op("all"),
    op("bus2", ["B", "NEWS"], ["A"]),  # both are minus half of the exposure
    op("bus", ["C"], ["B"]),
    *expand("div", ["D", "E", "F", "A"]),
    op("all"),
    op("bus", ["NEWS"], ["A"]),
    op("bus", ["E"], ["XE"]),
    op("bus", ["F"], ["XE"]),
    op("bus", ["B"], ["XE"]),
)


def experiment(target: Target, slot_us: float) -> Container:
    """Return the program: one exposure, and the five images of REGISTERS."""
    text = (
        f"nsl 3\nframe 1 slots of {slot_us}us\nbucket all_light open when true\n"
        "image half = all_light / 2\nread all_light, half\n"
    )
    options = Options(level=0, target=target, cache=False)
    container = run_passes(Source("facts.nsl", text), Path(), options).container
    assert container is not None
    assert container.pictures is not None
    (bucket,), (readout,) = container.buckets, container.readouts
    assert readout.register == "A"
    return replace(
        container,
        pictures=replace(
            container.pictures,
            items=tuple(Picture(name, Value(bucket)) for name in REGISTERS),
            reads=(bucket, *REGISTERS),
            kernels=(tuple(map(encode, WORDS)),),
            launches=(TailLaunch(0, None),),
            registers={bucket: "A", **REGISTERS},
        ),
    )


@dataclass(frozen=True)
class Ratio:
    """A ratio over pixels, and its standard error."""

    value: float
    error: float

    def __str__(self) -> str:
        return f"{self.value:.4f} +- {self.error:.4f}"


def measured(frames: Sequence[Frame], full_well_e: float) -> dict[str, Ratio]:
    """Return each image's mean ratio to the exposure of the pixel or of its east neighbour."""
    images = {
        name: np.mean([frame.told[f"image_{name}"] for frame in frames], axis=0)
        for name in REGISTERS
    }
    exposure = np.mean([frame.exposure_e[0] for frame in frames], axis=0)
    east = np.roll(exposure, -1, axis=1)
    return {
        name: _ratio(image, exposure if name in ("half", "divided") else east, full_well_e)
        for name, image in images.items()
    }


def _ratio(image: NDArray[np.float64], exposure: NDArray[np.float64], full_well_e: float) -> Ratio:
    used = (exposure > 0.1 * full_well_e) & (exposure < 0.9 * full_well_e)
    used[[0, -1]] = used[:, [0, -1]] = False
    if used.sum() < 100:
        raise SystemExit("too few pixels are between a tenth and nine tenths of a full well")
    ratios = image[used] / exposure[used]
    return Ratio(float(ratios.mean()), float(ratios.std() / np.sqrt(used.sum())))


def verdict(ratios: dict[str, Ratio]) -> list[str]:
    """Return the lines to print: numbers, and the resulting keys of the chip file."""
    lines = [f"{name:8} {ratio}" for name, ratio in ratios.items()]
    first, third = ratios["first"], ratios["third"]
    keeps = abs(third.value - first.value) < 0.02 * abs(first.value)
    lines.append(f"news_read_keeps = {str(keeps).lower()}")
    off = abs(ratios["half"].value - ratios["divided"].value)
    lines.append(f"one bus2 word and `div` differ by {off:.2%} of the exposure")
    return lines


def main() -> None:
    """Take frames and print the verdict."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    place = parser.add_mutually_exclusive_group(required=True)
    place.add_argument("--device", metavar="PORT", help="the serial port of a chip")
    place.add_argument("--scene", help="a scene for the emulator")
    parser.add_argument("--target", default="scamp5", help="the chip's table")
    parser.add_argument("--slot-us", type=float, default=1000.0, help="the exposure")
    parser.add_argument("--frames", type=int, default=8, help="frames that are averaged")
    options = parser.parse_args()
    target = load_target(options.target, Path())
    container = experiment(target, options.slot_us)
    if options.device:
        from nscc_runtime.device.device_chip import DeviceChip
        from nscc_runtime.device.link import SerialLink

        with SerialLink(options.device) as link:
            chip = DeviceChip(link)
            chip.upload(container)
            frames = [chip.capture(container).frame for _ in range(options.frames)]
    else:
        frames = emulated(container, options.scene)
    print("\n".join(verdict(measured(frames, target.full_well_e))))


def emulated(container: Container, scene: str) -> list[Frame]:
    """Return a frame of the emulator, without effects."""
    from nscc_runtime.effects import selected
    from nscc_runtime.neighbours.pictured_program import PicturedProgram
    from nscc_runtime.scenes import Scene, scene_light
    from nscc_runtime.sensor import default_sensor

    light = scene_light(Scene(scene), container.slot_us, container.target)
    program = PicturedProgram(container, default_sensor(container.target), selected("none"))
    return list(program.film([light], 0, 0))


if __name__ == "__main__":
    main()
