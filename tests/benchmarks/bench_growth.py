"""How words and time grow with a program, and where a step of one costs too much.

    python tests/benchmarks/bench_growth.py [--level 2] [--families b,kernel] [--most 256]

Each family is compiled for sizes that double from 16, and for each size plus one. A line for each
size: words of a frame, CPU seconds, peak memory of the process, and the growth of the words from
the size before. The command fails if one more slot, row or bit costs more than 30 %, or doubling
(from 32 on) more than 3 times the words; ALLOWED lists the exceptions with their reason.
"""

from __future__ import annotations

import argparse
import resource
import sys
from collections.abc import Callable
from pathlib import Path
from time import process_time

import numpy as np

from nscc.diagnostics.diagnostic import Rejected
from nscc.options import Options
from nscc.pipeline import run_passes
from nscc.source import Source

STEP, DOUBLING = 1.3, 3.0
ALLOWED = {
    ("d", 64, 128): "128 slots have 8,256 bumps, more than 12 planes distinguish",
    ("states", 32, 33): "33 values need a sixth bit, which counts by a ripple of carries",
    ("and", 256, 257): "257 stops need a ninth plane, which leaves two planes for 4 values of k",
    (
        "codebook of 16 slots",
        128,
        129,
    ): "129 rows need an eighth plane: one inverted plane less",
    ("and or not", 128, 256): "256 stops need 12 planes: no state fits, so numbers are compared",
    ("nested", 128, 256): "256 stops need 12 planes: no state fits, so numbers are compared",
    ("and bits", 256, 512): "512 stops need 12 planes: no state fits, so numbers are compared",
}
"""Exceptions: (family, size, next size), with the reason."""


def frame(slots: int, text: str) -> str:
    """A program of version 1."""
    return f"nsl 1 frame {slots} slots of 500us {text}"


def book(rows: int, slots: int) -> str:
    """A program with pseudo-random shutters."""
    digits = np.random.default_rng(1).integers(0, 2, (rows, slots))
    lines = ", ".join("".join(map(str, row)) for row in digits)
    return frame(slots, f"shutters book [{lines}] code id : row of book open when book[id]")


def kernel(size: int, is_product: bool = False) -> str:
    """A program with a dense square kernel of random weights, of the next odd size; with
    `is_product`, those of a column times those of a row."""
    generator, side = np.random.default_rng(1), size | 1
    weights = generator.integers(-9, 10, (side, side))
    if is_product:
        weights = np.outer(*generator.integers(1, 10, (2, side)))
    divisor = 1 << int(np.abs(weights).sum() - 1).bit_length()
    return (
        f"nsl 3 frame 16 slots of 125us open when true kernel k = {weights.tolist()} / {divisor} "
        "image o = k(exposure) read o"
    )


def chain(kind: str, count: int, is_read_twice: bool = False) -> str:
    """A program with `count` planes or images, each of which is read once after all of them, or
    twice, the second time in reverse."""
    head = "nsl 3 frame 1 slots of 1ms open when true "
    if kind == "planes":
        items = "".join(f"plane v{i} = exposure > {90 * i // count + 5}% " for i in range(count))
        total, join = "plane t", " xor "
    else:
        items = "".join(
            f"kernel k{i} = [[{i % 7 + 1}, 0, -1]] / 8 image v{i} = abs(k{i}(exposure)) "
            for i in range(count)
        )
        total, join = "image t", f" / {1 << (count - 1).bit_length()} + "
    last = join.partition("+")[0].rstrip() if kind == "images" else ""
    names = [f"v{i}" for i in range(count)]
    text = f"{head}{items}{total} = {join.join(names)}{last} "
    if is_read_twice:
        return f"{text}{total[:-1]}u = {join.join(reversed(names))}{last} read t, u"
    return f"{text}read t"


def counter(values: int) -> str:
    """A program whose state counts the looks at which a pixel was bright, to `values` - 1."""
    return (
        f"nsl 2 frame {values} slots of 100us sense bright when light > 50% at n > 0 "
        f"state count : 0..{values - 1} = 0 next count = count + 1 when bright and count < "
        f"{values - 1} open when true read count"
    )


FAMILIES: dict[str, tuple[Callable[[int], str], int]] = {
    "a": (lambda n: frame(n, "open when true"), 4096),
    "b": (lambda n: frame(n, "code stop : 1..N open when n < stop"), 4096),
    "c": (lambda n: frame(n, "code start : 0..N - 8 open when start <= n < start + 8"), 1024),
    "d": (lambda n: frame(n, "code start : 0..N - 1 code stop : 1..N require start < stop "
                          "open when start <= n < stop"), 128),
    "e": (lambda n: frame(n, f"code bits : bit[{n}] open when bits[n]"), 13),
    "codebook of 64 rows": (lambda n: book(64, n), 128),
    "codebook of 16 slots": (lambda n: book(n, 16), 256),
    "two buckets": (lambda n: frame(n, "code split : 1..N - 1 bucket a open when n < split "
                                    "bucket b open when n >= split"), 1024),
    "and": (lambda n: frame(n, "code stop : 1..N code k : 0..3 "
                            "open when n < stop and n % 4 != k"), 512),
    "or": (lambda n: frame(n, "code stop : 1..N code k : 0..3 "
                           "open when n < stop or n % 4 == k"), 512),
    "xor": (lambda n: frame(n, "code stop : 1..N code k : 0..3 "
                            "open when n < stop xor n % 4 == k"), 512),
    "and or not": (lambda n: frame(n, "code a : 1..N code b : 0..7 code c : 0..1 "
                                   "open when (n < a or n % 8 == b) and not (c == 1 and n > N / 2)"
                                   ), 256),
    "xor range": (lambda n: frame(n, "code a : 1..N code k : 0..7 "
                                  "open when n < a xor n % 8 < k"), 256),
    "window and": (lambda n: frame(n, "code a : 0..N - 8 code k : 0..3 "
                                   "open when a <= n < a + 8 and n % 4 != k"), 256),
    "nested": (lambda n: frame(n, "code a : 1..N code k : 0..3 code j : 0..2 "
                               "open when (n < a and n % 4 != k) or n % 3 == j"), 256),
    "and bits": (lambda n: frame(n, "code a : 1..N code m : bit[3] "
                                 "open when n < a and m[n % 3]"), 512),
    "buckets and": (lambda n: frame(n, "code a : 1..N - 1 code k : 0..3 "
                                    "bucket p open when n < a and n % 4 != k "
                                    "bucket q open when n >= a and n % 4 != k"), 256),
    "looks": (lambda n: f"nsl 2 frame {n} slots of 500us sense bright when light > 50% "
              f"at n % 4 == 0 and n > 0 state seen : 0..{n} = 0 "
              "next seen = looks when bright and seen == 0 open when seen == 0 read seen", 32),
    "states": (counter, 256),
    "kernel": (kernel, 9),
    "product kernel": (lambda n: kernel(n, is_product=True), 9),
    "planes": (lambda n: chain("planes", n), 32),
    "planes read twice": (lambda n: chain("planes", n, is_read_twice=True), 32),
    "images": (lambda n: chain("images", n), 32),
    "images read twice": (lambda n: chain("images", n, is_read_twice=True), 32),
}  # fmt: skip
"""For each family the text of a program of a size, and the largest size."""


def measure(text: str, level: int) -> tuple[int | str, float, float]:
    """Words of a frame or the code of the error, CPU seconds, and peak memory in MB."""
    start = process_time()
    try:
        options = Options(level=level, codes="open", cache=False)
        compiled = run_passes(Source("growth.nsl", text), Path(), options)
    except Rejected as rejected:
        words: int | str = rejected.diagnostics[0].code
    else:
        assert compiled.container is not None
        kernels = compiled.container.kernels
        words = sum(len(kernels[launch.kernel].words) for launch in compiled.container.launches)
        words += compiled.container.pictures.words
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    return words, process_time() - start, memory


def too_much(family: str, sizes: tuple[int, int], words: tuple[int | str, int | str]) -> str:
    """Why the growth between two sizes is too large; empty if it is not. The words `before` are 0
    for the first size of a family, which must compile."""
    (size, larger), (before, after) = sizes, words
    if isinstance(before, str) or (family, size, larger) in ALLOWED:
        return ""
    if isinstance(after, str):
        return f"CLIFF: {after}"
    limit = STEP if larger == size + 1 else DOUBLING if size >= 32 else None
    is_above = before and limit is not None and after > limit * before
    return f"CLIFF: above {limit}" if is_above else ""


def main() -> None:
    """Measures and prints; exits with 1 if a family has a cliff."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--level", type=int, default=2)
    parser.add_argument("--families", default="")
    parser.add_argument("--most", type=int, default=256)
    asked = parser.parse_args()
    cliffs = 0
    print(f"{'family':<22}{'size':>6}{'words':>8}{'a step':>8}{'doubled':>9}{'s':>8}{'MB':>7}")
    for family in asked.families.split(",") if asked.families else FAMILIES:
        program, most = FAMILIES[family]
        known: dict[int, int | str] = {}
        size = 16 if most >= 16 else most // 2
        while size <= min(most, asked.most):
            for now, before in ((size, size // 2), (size + 1, size)):
                if now > most:
                    continue
                known[now], seconds, memory = measure(program(now), asked.level)
                last = known.get(before)
                fault = too_much(family, (before, now), (last or 0, known[now]))
                both = isinstance(last, int) and isinstance(known[now], int)
                growth = f"{known[now] / last:.2f}" if both else ""  # type: ignore[operator]
                columns = f"{growth:>8}{'':>9}" if now == before + 1 else f"{'':>8}{growth:>9}"
                print(
                    f"{family:<22}{now:>6}{known[now]:>8}{columns}{seconds:>8.2f}{memory:>7.0f}"
                    f"  {fault}",
                    flush=True,
                )
                cliffs += bool(fault)
            size *= 2
    sys.exit(cliffs > 0)


if __name__ == "__main__":
    main()
