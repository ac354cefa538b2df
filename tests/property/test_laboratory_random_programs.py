"""Random programs of version 4 beside an interpreter that is written for this test only."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from marks import slow
from numpy.typing import NDArray
from proved_programs import proved_or_refused
from scipy.ndimage import binary_dilation, binary_propagation

from nscc_runtime.effects import selected
from nscc_runtime.host_setting import host_settings
from nscc_runtime.light import Light
from nscc_runtime.neighbours.pictured_program import PicturedProgram
from nscc_runtime.sensor import default_sensor

ROWS, COLS, FRAMES = 40, 36, 3
STEP_E = 30000 / 127
PROGRAMS, CHUNKS = 2000, 100
ALLOWED = {"NS0535", "NS0540", "NS0541"}
"""What such a program may be refused for: it is too large for the chip."""
CROSS = np.array([[0, 1, 0], [1, 1, 1], [0, 1, 0]], np.bool_)
Values = dict[str, NDArray[Any]]
Maker = Callable[[Values, dict[str, int]], NDArray[Any]]


def moved(values: NDArray[Any], dx: int, dy: int) -> NDArray[Any]:
    """The values of the pixels at an offset; 0 beyond the array."""
    result = np.zeros_like(values)
    rows, cols = values.shape
    if abs(dx) < cols and abs(dy) < rows:
        result[max(0, -dy) : min(rows, rows - dy), max(0, -dx) : min(cols, cols - dx)] = values[
            max(0, dy) : min(rows, rows + dy), max(0, dx) : min(cols, cols + dx)
        ]
    return result


class Writer:
    """Writes a random program, with a function on arrays for each name."""

    def __init__(self, seed: int) -> None:
        self.rng = np.random.default_rng(seed)
        self.lines = [
            "nsl 4",
            "frame 2 slots of 1ms",
            "open when true",
            "outside 0",
            "kernel cross = [[0, 1, 0], [1, 1, 1], [0, 1, 0]]",
            "param t : 1% .. 20% = 6%",
            "param s : -4 .. 6 = 2",
            "input plane i",
        ]
        self.images, self.planes = ["exposure", "old"], ["i", "flag"]
        self.makers: list[tuple[str, Maker]] = []

    def image(self) -> tuple[str, Maker]:
        name, other = (str(name) for name in self.rng.choice(self.images, 2))
        dx, dy = (int(step) for step in self.rng.integers(-7, 8, 2))
        plane = str(self.rng.choice(self.planes))
        level = int(self.rng.integers(1, 9))
        match self.rng.integers(8):
            case 5:
                text = f"max({name}, {other}) / 2 - {level * STEP_E:.3f}e"
                return text, lambda v, p: np.maximum(v[name], v[other]) / 2 - level * STEP_E
            case 6:
                return f"min({name}, {other})", lambda v, p: np.minimum(v[name], v[other])
            case 7:
                other = next(each for each in self.images if each != name)
                text = f"t - {level * STEP_E:.3f}e if {name} < {other} + t else {name} / 2"
                return text, lambda v, p: np.where(
                    v[name] < v[other] + p["t"] * STEP_E, (p["t"] - level) * STEP_E, v[name] / 2
                )
            case 0:
                return f"{name}[{dx}, {dy}]", lambda v, p: moved(v[name], dx, dy)
            case 1:
                return f"{name}[s, {dy}]", lambda v, p: moved(v[name], p["s"], dy)
            case 2:
                text = f"{name} if {plane} else {other}"
                return text, lambda v, p: np.where(v[plane], v[name], v[other])
            case 3:
                return f"({name} + {other}) / 2", lambda v, p: (v[name] + v[other]) / 2
        return f"({name} - {other}) / 2", lambda v, p: (v[name] - v[other]) / 2

    def plane(self) -> tuple[str, Maker]:
        image, second = (str(name) for name in self.rng.choice(self.images, 2))
        name, other = (str(name) for name in self.rng.choice(self.planes, 2))
        dx, dy = (int(step) for step in self.rng.integers(-12, 13, 2))
        third = str(self.rng.choice(self.planes))
        match self.rng.integers(12):
            case 10:
                op = "xor" if dx % 2 else "or"
                text = f"{name}[{dx % 3}, {dy % 4}] {op} {other}[{dx % 3}, {dy % 4}]"
                return text, lambda v, p: moved(
                    v[name] ^ v[other] if op == "xor" else v[name] | v[other], dx % 3, dy % 4
                )
            case 6:
                text = f"{name}[0, 1] if {other} else {name}[-1, 0] and not {third}"
                return text, lambda v, p: np.where(
                    v[other], moved(v[name], 0, 1), moved(v[name], -1, 0) & ~v[third]
                )
            case 7:
                text = f"{other} and ({name}[1, 0] or {third}) or {name}[0, -1] and not {other}"
                return text, lambda v, p: np.where(
                    v[other], moved(v[name], 1, 0) | v[third], moved(v[name], 0, -1)
                )
            case 8:
                text = f"flood({name} and {other}, {other}, cross)"
                return text, lambda v, p: binary_propagation(
                    v[name] & v[other], CROSS, mask=v[other]
                )
            case 9:
                text = f"not ({name} or {other}) if {image} > t else {third} and {name}"
                return text, lambda v, p: np.where(
                    v[image] > p["t"] * STEP_E, ~(v[name] | v[other]), v[third] & v[name]
                )
            case 0:
                return f"{image} > t", lambda v, p: v[image] > p["t"] * STEP_E
            case 1:
                text = f"{image} - {second} < -t"
                return text, lambda v, p: v[image] - v[second] < -p["t"] * STEP_E
            case 2:
                return f"{name}[{dx}, {dy}]", lambda v, p: moved(v[name], dx, dy)
            case 3:
                return f"{name}[{dx}, s - 1]", lambda v, p: moved(v[name], dx, p["s"] - 1)
            case 4:
                return f"not {name} and {other}", lambda v, p: ~v[name] & v[other]
            case 5:
                x, _ = np.meshgrid(np.arange(COLS), np.arange(ROWS))
                return f"{name} xor x % 5 == 2", lambda v, p: v[name] ^ (x % 5 == 2)
        text = f"flood({name}, {other}, cross)"
        return text, lambda v, p: binary_propagation(v[name], CROSS, mask=v[name] | v[other])

    def repeated(self, name: str) -> None:
        """A name with a partner, or a plane alone, that steps several times."""
        start, image = str(self.rng.choice(self.planes)), str(self.rng.choice(self.images))
        dx, dy = (int(step) for step in self.rng.integers(-1, 2, 2))
        count = str(self.rng.choice(["s", "(s + 2)", "3", "8"]))

        def steps(params: dict[str, int]) -> int:
            return max(0, eval(count, {"s": params["s"]}))

        kind = self.rng.random()
        if kind < 0.2:

            def fall(v: Values, p: dict[str, int]) -> NDArray[Any]:
                bits = v[start]
                for _ in range(steps(p)):
                    free = moved(bits, dx, 1) & ~v["i"]
                    bits = np.where(bits, moved(bits, 0, -1), free)
                return bits

            text = f"{name}[0, -1] if {name} else {name}[{dx}, 1] and not i"
            self.add(f"plane {name} = {start} repeat {count} ({text})", name, fall, self.planes)
            return
        if kind < 0.6:

            def spread(v: Values, p: dict[str, int]) -> NDArray[Any]:
                bits = v[start]
                for _ in range(steps(p)):
                    bits = moved(bits, dx, dy) | (binary_dilation(bits, CROSS) & v["i"])
                return bits

            text = f"{name}[{dx}, {dy}] or any({name}, cross) and i"
            self.add(f"plane {name} = {start} repeat {count} {text}", name, spread, self.planes)
            return

        def carried(v: Values, p: dict[str, int]) -> NDArray[Any]:
            values, bits = v[image], v[start]
            for _ in range(steps(p)):
                values, bits = np.where(bits, moved(values, dx, dy), values), moved(bits, dy, dx)
            return values

        partner = f"{name}p"
        line = (
            f"image {name} = {image} repeat {count} ({name}[{dx}, {dy}] if {partner} else {name})"
        )
        line += f" with plane {partner} = {start} repeat {partner}[{dy}, {dx}]"
        self.add(line, name, carried, self.images)

    def add(self, line: str, name: str, make: Maker, names: list[str]) -> None:
        self.lines.append(line)
        self.makers.append((name, make))
        names.append(name)

    def write(self) -> str:
        self.lines += ["state old : image kept = 3%", "state flag : bit = 1 kept"]
        self.has_number = bool(self.rng.random() < 0.3)
        if self.has_number:
            self.lines.append("state k : -1..2 = 1 kept")
            low = int(self.rng.integers(0, 3))
            self.add(f"plane high = k >= {low}", "high", lambda v, p: v["k"] >= low, self.planes)
        for number in range(int(self.rng.integers(2, 5))):
            kind = self.rng.integers(3)
            if kind == 0:
                text, make = self.image()
                self.add(f"image n{number} = {text}", f"n{number}", make, self.images)
            elif kind == 1:
                text, make = self.plane()
                self.add(f"plane n{number} = {text}", f"n{number}", make, self.planes)
            else:
                self.repeated(f"n{number}")
        self.next_image = str(self.rng.choice([n for n in self.images if n != "old"]))
        self.when, self.next_bit = (str(name) for name in self.rng.choice(self.planes, 2))
        last = self.makers[-1][0]
        self.lines += [
            f"next old = {self.next_image} when {self.when}",
            f"next flag = {self.next_bit}",
            f"read {last}, old, flag",
            f"report {'sum' if last in self.images else 'count'} {last}",
        ]
        if self.has_number:
            when, bit = self.when, self.next_bit
            text = f"next k = min(k + 1, 2) if {when} else -k if {bit} and k < 2 else -1"
            self.lines += [text, "read k"]
        return "\n".join(self.lines) + "\n"


def agree(writer: Writer, container: Any, seed: int) -> None:
    rng = np.random.default_rng(seed)
    steps = rng.integers(0, 80, (FRAMES, 2, ROWS, COLS)) / 2 + 0.125
    lights = [Light.of_clip((clip * STEP_E).astype(np.float32)) for clip in steps]
    inputs = rng.random((FRAMES, ROWS, COLS)) < 0.5
    params = [
        {"t": float(rng.integers(2, 20)) * STEP_E, "s": int(rng.integers(-4, 7))}
        for _ in range(FRAMES)
    ]
    settings = host_settings(container, params, [{"i": bits} for bits in inputs])
    runner = PicturedProgram(container, default_sensor(container.target), selected("none"), 1)
    kept, bit = np.full((ROWS, COLS), 900.0), np.ones((ROWS, COLS), np.bool_)
    number = np.ones((ROWS, COLS), np.int64)
    for frame, made in enumerate(runner.film(lights, seed, 0, settings)):
        numbers = {"t": round(params[frame]["t"] / STEP_E), "s": int(params[frame]["s"])}
        exposure = (steps[frame] * STEP_E).astype(np.float32).astype(np.float64).sum(axis=0)
        known: Values = {"exposure": exposure, "old": kept, "flag": bit, "i": inputs[frame]}
        known["k"] = number
        for name, make in writer.makers:
            known[name] = make(known, numbers)
        last, sure = writer.makers[-1][0], ~made.told["margin"]
        kept = np.where(known[writer.when], known[writer.next_image], kept)
        bit = known[writer.next_bit]
        down = np.where(bit & (number < 2), -number, -1)
        number = np.where(known[writer.when], np.minimum(number + 1, 2), down)
        if writer.has_number:
            assert np.array_equal(made.told["states_k"], number)
        known |= {"old": kept, "flag": bit}
        for name in (last, "old", "flag"):
            image = f"image_{name}" in made.told
            found = made.told[f"image_{name}" if image else f"plane_{name}"]
            np.testing.assert_allclose(
                found[sure].astype(float),
                known[name][sure].astype(float),
                atol=1e-6,
                err_msg=f"{name} in frame {frame} of seed {seed}",
            )


@pytest.mark.parametrize("chunk", [slow(c) if c >= 2 else c for c in range(CHUNKS)])
def test_words_of_random_version_4_programs_equal_the_interpreter(chunk: int) -> None:
    size, refused = PROGRAMS // CHUNKS, 0
    for seed in range(chunk * size, (chunk + 1) * size):
        writer = Writer(seed)
        container = proved_or_refused(writer.write(), 1, (ROWS, COLS), ALLOWED)
        # The program does not fit the chip.
        if container is None:
            refused += 1
        else:
            agree(writer, container, seed)
    assert refused <= size // 2
