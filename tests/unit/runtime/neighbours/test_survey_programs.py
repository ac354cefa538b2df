"""Further programs of the survey (`tests/laboratory`) beside numpy models, on a small odd array.

Exposures are multiples of a sixteenth of a step of IN, so that no comparison is a tie."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from checkout import ROOT
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation, binary_erosion, binary_propagation, correlate

import nscc
import nscc_runtime
from nscc.chips.load import builtin_target

ROWS, COLS, FRAMES, STEP_E = 61, 47, 20, 30000 / 127
Y, X = np.mgrid[:ROWS, :COLS]
BORDER = (X == 0) | (Y == 0) | (X == COLS - 1) | (Y == ROWS - 1)
CROSS = np.array([[0, 1, 0], [1, 1, 1], [0, 1, 0]])
SQUARE = np.ones((3, 3))
Array = NDArray[Any]
Values = dict[str, Any]
"""Planes and images of a frame by name, and reports by key."""
Model = Callable[[Values, Values, Values], Values]
"""The outputs of a frame, from what the host sets, the exposures, and the last outputs."""


def level(percent: float) -> float:
    """A level of a full well, rounded to a step of IN, in electrons."""
    return round(percent * 300 / STEP_E) * STEP_E


def moved(values: Array, dx: int, dy: int) -> Array:
    """The values of the pixels at an offset; 0 beyond the array."""
    padded = np.pad(values, 64)
    return padded[64 + dy :, 64 + dx :][:ROWS, :COLS]


def steered_shift(host: Values, e: Array, last: Values) -> Values:
    bits, names = e > level(40), ("north", "east", "south", "west")
    for _ in range(host["k"]):
        near = [moved(bits, *step) for step in ((0, -1), (1, 0), (0, 1), (-1, 0))]
        bits = np.select([host[name] for name in names], near, bits)
    return {"carried": bits}


def expand_erode(host: Values, e: Array, last: Values) -> Values:
    grown = bits = e > host["t"]
    if host["k"]:
        grown = binary_dilation(bits, CROSS, host["k"])
    shrunk = binary_erosion(grown, SQUARE, host["m"]) if host["m"] else grown
    return {"grown": grown, "shrunk": shrunk, "count shrunk": shrunk.sum()}


def four_bits(e: Array) -> Iterator[tuple[Array, float]]:
    """Four bits of an exposure and their levels, the largest first."""
    for percent in (50, 25, 12.5, 6.25):
        bit = e > level(percent)
        e = np.where(bit, e - level(percent), e)
        yield bit, level(percent)


def four_bit_shift(host: Values, e: Array, last: Values) -> Values:
    return {"back": sum(moved(bit, host["dx"], host["dy"]) * size for bit, size in four_bits(e))}


def interleaved(host: Values, e: Array, last: Values) -> Values:
    old = [last.get(f"q{number}", np.zeros(e.shape, np.bool_)) for number in (3, 2, 1, 0)]
    bits = [*four_bits(e)]
    shown = sum(bit * size for bit, (_, size) in zip(old, bits, strict=True))
    new = [np.where(host["phase"], bit, past) for past, (bit, _) in zip(old, bits, strict=True)]
    return {"shown": shown, **{f"q{3 - number}": bit for number, bit in enumerate(new)}}


def live_shape(host: Values, e: Array, last: Values) -> Values:
    mask = e > host["t"]
    mask = binary_erosion(mask, CROSS, host["k"]) if host["k"] else mask
    whole = mask & ~binary_propagation(BORDER & mask, CROSS, mask=mask)
    shape = binary_propagation(host["seed"] & whole, CROSS, mask=whole)
    reports = {"count shape": shape.sum(), "any whole": whole.any(), "flood shape": True}
    return {"whole": whole, "shape": shape, **reports}


def skew(host: Values, e: Array, last: Values) -> Values:
    bits, late = e > level(45), Y >= 4
    for _ in range(host["k"]):
        bits = np.where(late, moved(bits, -1, 0), bits)
        e, late = np.where(late, moved(e, -1, 0), e), moved(late, 0, -4)
    return {"skewed": bits, "slanted": e}


def scaled(bits: Array, steps: int, dx: int, dy: int) -> Array:
    """Bits that shrink towards the middle column, if dx is 1, or the middle row, if dy is 1."""
    place = X - COLS // 2 if dx else Y - ROWS // 2
    low, high = place < 0, place > 0
    for _ in range(steps):
        bits = np.select([low, high], [moved(bits, -dx, -dy), moved(bits, dx, dy)], bits)
        low, high = moved(low, 2 * dx, 2 * dy), moved(high, -2 * dx, -2 * dy)
    return bits


def half_of_a_plane(host: Values, e: Array, last: Values) -> Values:
    return {"small": scaled(e > level(45), COLS // 4, 1, 0)}


def scaled_plane(host: Values, e: Array, last: Values) -> Values:
    return {"small": scaled(scaled(e > level(45), host["k"], 1, 0), host["k"], 0, 1)}


def rotated_plane(host: Values, e: Array, last: Values) -> Values:
    bits = e > level(45)
    for place, dx, dy in ((Y - ROWS // 2, 1, 0), (X - COLS // 2, 0, -1)):
        low, high = place < 0, place > 0
        for _ in range(host["k"]):
            bits = np.select([low, high], [moved(bits, -dx, -dy), moved(bits, dx, dy)], bits)
            low, high = moved(low, -3 * dy, 3 * dx), moved(high, 3 * dy, -3 * dx)
    return {"turned": bits}


def odometry(host: Values, e: Array, last: Values) -> Values:
    across = correlate(e, np.outer([1, 2, 1], [1, 0, -1]) / 8, mode="constant")
    along = correlate(e, np.outer([1, 0, -1], [1, 2, 1]) / 8, mode="constant")
    edge = abs(across) + abs(along) > host["t"]
    # Edges at the border are not known, so the report leaves them out.
    count = edge[1:-1, 1:-1].sum()
    return {"scaled": scaled(edge, host["k"], 1, 0), "count edge": count}


def sandcastle(host: Values, e: Array, last: Values) -> Values:
    bits = e > host["t"]
    return {"sand": bits.sum(axis=0) > ROWS - 1 - Y, "count sand": bits.sum()}


def rule_90(host: Values, e: Array, last: Values) -> Values:
    cells = host["start"].copy()
    for row in range(1, host["steps"] + 1):
        beside = np.pad(cells[row - 1], 1)
        cells[row] = beside[:-2] ^ beside[2:]
    return {"ca": cells}


def magnocellular(host: Values, e: Array, last: Values) -> Values:
    blurred = correlate(e, np.outer([1, 2, 1], [1, 2, 1]) / 16, mode="constant")
    slow, slow2 = last.get("slow", 0 * e), last.get("slow2", 0 * e)
    rectified = np.maximum(e - blurred - slow, 0)
    # The states are no outputs: the next frame finds them here.
    nexts = {"slow": slow * 0.75 + (e - blurred) / 4, "slow2": (slow2 + rectified) / 2}
    return {"m": rectified - slow2 > level(1), **nexts}


def perspective(host: Values, e: Array, last: Values) -> Values:
    bits, is_left = e > level(45), X < COLS // 2
    inner = is_left & (X >= Y // 3) | (X > COLS // 2) & (X < COLS - Y // 3)
    for _ in range(12):
        near = np.where(is_left, moved(bits, -1, 0), moved(bits, 1, 0))
        bits, inner = np.where(inner, near, bits), moved(inner, 0, -5)
    return {"bent": bits}


def cones(host: Values, e: Array, last: Values) -> Values:
    left, right = (e - moved(e, dx, 0) > host["t"] for dx in (-3, 3))
    inside = (X >= 6) & (X < COLS - 6) & (Y >= 4) & (Y < ROWS - 4)
    cone = moved(left, -2, 0) & moved(right, 2, 0) & inside
    body = binary_dilation(cone, CROSS, 20, mask=(left | right) & inside)
    return {"body": body, "any cone": cone.any(), "box body": box(body)}


def box(bits: Array) -> tuple[int, ...] | None:
    """The first and last column and row with a bit, or None."""
    rows, cols = np.nonzero(bits)
    return (cols.min(), rows.min(), cols.max(), rows.max()) if bits.any() else None


def signed_bits(host: Values, e: Array, last: Values) -> Values:
    value = correlate(e, np.outer([1, 2, 1], [1, 0, -1]) / 4, mode="constant")
    large = abs(value) > level(20)
    small = abs(value) - large * level(20) > level(10)
    size = large * level(20) + small * level(10)
    return {"b1": large, "b0": small, "back": np.where(value < 0, -size, size)}


def shapes(host: Values, e: Array, last: Values) -> Values:
    done = last.get("done", np.zeros(e.shape, np.bool_))
    rest = host["shapes"] & ~done
    one = binary_propagation(host["seed"] & rest, CROSS, mask=rest)
    reports = {"any rest": rest.any(), "box one": box(one)}
    return {"one": one, "done": done | one, **reports}


def points(host: Values, e: Array, last: Values) -> Values:
    bright = e > host["t"]
    ends = bright & ~np.any([moved(bright, dx, 0) for dx in range(1, 6)], axis=0)
    near = np.any([moved(ends, dx, 0) for dx in range(-5, 6)], axis=0)
    return {"point": ends & ~np.any([moved(near, 0, dy) for dy in range(1, 6)], axis=0)}


def quantised_store(host: Values, e: Array, last: Values) -> Values:
    old = last.get("store", 0 * e)
    middle = sum(bit * size for bit, size in four_bits(old)) + level(3.125)
    return {"store": np.where(host["take"], e, middle)}


def places(host: Values, e: Array, last: Values) -> Values:
    around = np.array([[1, 1, 1], [1, 0, 1], [1, 1, 1]]) / 8
    value = (e - correlate(e, around, mode="constant")) / 4 + level(30)
    bits = last.get("bits", [np.zeros(e.shape, np.bool_)] * 4)
    sizes = [size for _, size in four_bits(e)]
    kept = sum(moved(bit, host["dx"], host["dy"]) * w for bit, w in zip(bits, sizes, strict=True))
    new = [bit for bit, _ in four_bits(value)]
    far = abs(value - kept) * host["particle"]
    bits = [np.where(host["take"], *pair) for pair in zip(new, bits, strict=True)]
    return {"bits": bits, "far": far}


MODELS: dict[str, Model] = {
    model.__name__: model
    for model in (
        *(steered_shift, expand_erode, four_bit_shift, interleaved, live_shape, skew, cones),
        *(half_of_a_plane, sandcastle, rule_90, magnocellular, perspective, signed_bits),
        *(scaled_plane, rotated_plane, odometry, shapes, points, quantised_store, places),
    )
}
MARGINS = {"cones": 0, "live_shape": 0, "rule_90": 0, "signed_bits": 1, "magnocellular": 1}
"""Columns and rows in the margin, where the exposures of neighbours are used."""


def host_values(name: str, rng: np.random.Generator) -> list[Values]:
    """What the host sets before each frame."""
    turn = [rng.integers(0, 5, (ROWS, COLS)) for _ in range(FRAMES)]
    return [
        {
            "k": frame % 10 if name == "steered_shift" else frame % 4,
            "m": frame * 5 % 13,
            "t": {"cones": 13, "odometry": 6}.get(name, 30 + 2 * frame) * STEP_E,
            "dx": int(rng.integers(-20, 21)),
            "dy": int(rng.integers(-20, 21)),
            "steps": 3 * frame,
            "phase": frame % 4 == X % 2 + 2 * (Y % 2),
            "seed": rng.random((ROWS, COLS)) < 0.02,
            "shapes": (X // 5 + Y // 7) % 3 < 2,
            "take": turn[frame] < 2,
            "particle": (Y + frame) % 9 < 6,
            "start": (Y == 0) & (rng.random((ROWS, COLS)) < 0.4),
            **{
                way: turn[frame] == number
                for number, way in enumerate(("north", "east", "south", "west"))
            },
        }
        for frame in range(FRAMES)
    ]


@pytest.mark.parametrize("name", MODELS)
def test_a_program_of_the_survey_computes_what_its_model_does(name: str) -> None:
    target = replace(builtin_target("scamp5"), rows=ROWS, cols=COLS)
    program = nscc.compile(ROOT / "tests" / "laboratory" / f"{name}.nsl", target=target)
    pictures, rng = program.container.pictures, np.random.default_rng(len(name))
    most = 45 if name == "magnocellular" else 100
    lights = np.empty((FRAMES, 4, ROWS, COLS), np.float32)
    for frame in range(FRAMES):
        wave = np.sin((X + 3 * frame) / 7) + np.sin((Y - 2 * frame) / 9) + 2
        # Means divide further, and would meet levels; random parts of a step do not.
        parts = (
            rng.random(wave.shape) * 128 if name == "places" else rng.integers(0, 128, wave.shape)
        )
        noise = parts / 16
        lights[frame] = ((wave / 4 * most).round() + noise + 1 / 32) * STEP_E / 4
    host = host_values(name, rng)
    params = [{p.name: each[p.name] for p in pictures.params} for each in host]
    inputs = [{p.name: each[p.name] for p in pictures.inputs if p.is_open} for each in host]
    film = nscc_runtime.film(program, lights, params=params, inputs=inputs)
    last: Values = {}
    for frame, light in enumerate(lights):
        last = MODELS[name](host[frame], light.astype(np.float64).sum(axis=0), last)
        known = ~film.margin[frame]
        assert {*film.planes, *film.images} <= {*last}
        if name in MARGINS:
            side = MARGINS[name]
            assert known.sum() == (ROWS - 2 * side) * (COLS - 2 * side)
        for key, expected in last.items():
            if key in film.planes:
                np.testing.assert_array_equal(film.planes[key][frame][known], expected[known])
            elif key in film.images:
                found = film.images[key][frame][known]
                np.testing.assert_allclose(found, expected[known], atol=1e-6)
            elif key in film.reports:
                assert film.reports[key][frame] == pytest.approx(expected), key
    noisy = nscc_runtime.film(program, lights[:2], effects="all", params=params[:2])
    assert noisy.margin.shape == (2, ROWS, COLS)
