"""Search for the cubes in nscc/logic/cube_tables.toml, and write the tables anew.

    python tests/benchmarks/search_cubes.py [--steps 1.0] [--continue] [--out FILE]

`nscc.logic.cube_tables` says what the cubes are for. Simulated annealing finds them. The cost is in
words of a frame: inversions of planes, second rise cubes, and a fine for each bump or number that
no code is left for. The same steps always give the same tables; all of them take hours.

With `--continue`, the search starts from the tables in the tree and replaces those for which it
finds a lower cost. The tables in the tree are the cheapest of several such runs.

The search for many groups starts from a few parts of four groups each: in a part, two planes hold
the group of the start in Gray code, two that of the last slot in binary, and the cubes of the parts
were found by the same search. Fewer groups start from the cubes of one group more.
"""

from __future__ import annotations

import argparse
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from math import comb
from pathlib import Path

import numpy as np
from numba import njit

TABLES = Path(__file__).resolve().parents[2] / "nscc/logic/cube_tables.toml"

SECOND = 4.0
"""Words for the second rise cube of a group."""

BUMPS, PARTS, NUMBERS = range(3)
"""What cubes are for: bumps over groups, bumps over parts of several groups, or numbers of which
each has a cube for itself."""

IN_PART = 2
"""Planes for the groups of a part, of each end."""

FULL, LITERALS, SWAPPED = 106, (60, 74, 86, 94), 100
"""Out of FULL changes: up to these counts a literal comes or goes, is inverted, moves to another
plane, or a plane is inverted in several cubes; then two cubes change places; then a second rise
cube comes, goes or becomes the first."""

U64 = np.uint64


@dataclass
class Cubes:
    """Three rows a group: the rise cube, a second one, the fall cube. The last group has no third.

    `read` (rows,) has the planes that a cube reads as a bit mask, `value` (rows,) their values, and
    `used` (rows,) is 0 where there is no second rise cube.
    """

    planes: int
    read: np.ndarray
    value: np.ndarray
    used: np.ndarray

    @property
    def groups(self) -> int:
        """How many groups there are."""
        return (len(self.read) + 1) // 3

    def window(self, first: int, groups: int) -> Cubes:
        """The cubes of `groups` groups from `first` on."""
        rows = slice(3 * first, 3 * (first + groups) - 1)
        parts = (part[rows].copy() for part in (self.read, self.value, self.used))
        return Cubes(self.planes, *parts)

    def upright(self) -> Cubes:
        """The cubes for planes that stand inverted where the first cube asks for a 1."""
        value = self.value.copy()
        for plane in range(self.planes):
            reads = np.flatnonzero(self.used * (self.read >> plane & 1))
            if len(reads) and value[reads[0]] >> plane & 1:
                value ^= self.read & 1 << plane
        return Cubes(self.planes, self.read, value, self.used)

    def text(self) -> str:
        """A line for each group: its rise cubes and, of bumps, a bar and its fall cube."""
        lines = []
        for k in range(self.groups):
            line = " ".join(self._row(r) for r in (3 * k, 3 * k + 1) if self.used[r])
            if self.used[2]:
                line += f" | {self._row(3 * k + 2)}" if k < self.groups - 1 else " |"
            lines.append(line)
        return "\n".join(lines)

    def _row(self, row: int) -> str:
        planes = range(self.planes)
        return "".join(
            str(self.value[row] >> p & 1) if self.read[row] >> p & 1 else "-" for p in planes
        )


@njit(cache=True)
def drawn(state: np.ndarray) -> np.uint64:
    """The next of a sequence of pseudo-random numbers of 53 bits (xorshift64*, S. Vigna, 2016)."""
    x = state[0]
    x ^= x << U64(13)
    x ^= x >> U64(7)
    x ^= x << U64(17)
    state[0] = x
    return (x * U64(2685821657736338717)) >> U64(11)


@njit(cache=True)
def below(state: np.ndarray, end: int) -> int:
    """A pseudo-random number below `end`."""
    return int(drawn(state) % U64(end))


@njit(cache=True)
def inversion_words(planes, spare, read, value, used, place):
    """Words that invert planes, and bring them back in the end, as `cubes.Standing` does it.

    With a `spare` register a plane moves into it when it is inverted, which takes one word. The
    rise cubes of a group are read there and back.
    """
    first = np.full(planes, -1, np.int64)
    standing = np.zeros(planes, np.int64)
    for plane in range(planes):
        place[plane] = plane
    free, words = planes, 0
    for step in range(4 * ((len(read) + 1) // 3)):
        group, part = divmod(step, 4)
        row = 3 * group + (0, 1, 0, 2)[part]
        if row >= len(read) or not used[row] or (part == 2 and not used[row + 1]):
            continue
        for plane in range(planes):
            if read[row] >> plane & 1:
                bit = value[row] >> plane & 1
                if first[plane] < 0:
                    first[plane] = bit
                elif standing[plane] != bit:
                    words += 1
                    place[plane], free = free, place[plane]
                standing[plane] = bit
    astray = 0
    for plane in range(planes):
        if first[plane] < 0:
            first[plane] = standing[plane] = 0
        if not spare:
            words += standing[plane] != first[plane]
        elif place[plane] != plane or standing[plane] != first[plane]:
            astray += 1
    if not spare:
        return 2 * words
    while astray:
        chosen = free
        if free == planes:
            chosen = -1
            for plane in range(planes):
                if place[plane] != plane:
                    chosen = plane
                    break
        if chosen < 0:
            for plane in range(planes):
                words += 2 * (standing[plane] != first[plane])
            return words
        words += 1
        standing[chosen] = first[chosen]
        place[chosen], free = free, place[chosen]
        astray -= place[chosen] == chosen
    return words


@njit(cache=True)
def fewest_inversions(planes, read, value, used):
    """How often the plane that is inverted least is inverted: the masked register takes it."""
    fewest = len(read)
    for plane in range(planes):
        first, standing, count = -1, -1, 0
        for row in range(len(read)):
            if used[row] and read[row] >> plane & 1:
                bit = value[row] >> plane & 1
                if first < 0:
                    first = bit
                elif standing != bit:
                    count += 1
                standing = bit
        fewest = min(fewest, count + (standing != first))
    return fewest


@njit(cache=True)
def fill(literals, planes, read, value, out):
    """The codes in a cube, a bit each, into `out` (words,)."""
    out[:] = ~U64(0)
    for plane in range(planes):
        if read >> plane & 1:
            for word in range(len(out)):
                out[word] &= literals[plane, value >> plane & 1, word]


@njit(cache=True)
def fill_group(literals, planes, read, value, used, k, rises, falls):
    """The codes in the cubes of group k."""
    fill(literals, planes, read[3 * k], value[3 * k], rises[k])
    if used[3 * k + 1]:
        more = np.empty_like(rises[k])
        fill(literals, planes, read[3 * k + 1], value[3 * k + 1], more)
        for word in range(len(more)):
            rises[k, word] |= more[word]
    if k < len(falls):
        fill(literals, planes, read[3 * k + 2], value[3 * k + 2], falls[k])


@njit(cache=True)
def codeless(rises, falls, whole, most):
    """Bumps that no code is left for; the count ends above `most`.

    With `whole`, a group stands for several, and a bump that ends in it must be outside its rise
    cube, unless it also starts there.
    """
    groups, words = rises.shape
    outside = np.empty((groups + 1, words), np.uint64)
    outside[groups] = ~U64(0)
    for k in range(groups - 1, -1, -1):
        for word in range(words):
            outside[k, word] = outside[k + 1, word] & ~rises[k, word]
    before = np.full(words, ~U64(0))
    going = np.empty(words, np.uint64)
    count = 0
    for i in range(groups):
        for word in range(words):
            going[word] = before[word] & rises[i, word]
            before[word] &= ~rises[i, word]
        for j in range(i, groups):
            later = j if whole and i < j else j + 1
            left = U64(0)
            for word in range(words):
                codes = going[word] & outside[later, word]
                if j < groups - 1:
                    codes &= falls[j, word]
                    going[word] &= ~falls[j, word]
                left |= codes
            if left == 0:
                count += 1
                if count > most:
                    return count
    return count


@njit(cache=True)
def alike(rises, most):
    """Groups whose rise cube holds no code that is in no other one; the count ends above `most`."""
    groups, words = rises.shape
    once, twice = np.zeros(words, np.uint64), np.zeros(words, np.uint64)
    for k in range(groups):
        for word in range(words):
            twice[word] |= once[word] & rises[k, word]
            once[word] |= rises[k, word]
    count = 0
    for k in range(groups):
        own = U64(0)
        for word in range(words):
            own |= rises[k, word] & ~twice[word]
        count += own == 0
        if count > most:
            break
    return count


@njit(cache=True)
def unmet(rises, falls, task, most):
    """What `task` asks for and the cubes do not give; the count ends above `most`."""
    if task == NUMBERS:
        return alike(rises, most)
    return codeless(rises, falls, task == PARTS, most)


@njit(cache=True)
def change(state, planes, read, value, used, rows):
    """Changes a few rows, whose numbers it writes into `rows`; returns how many, 0 for none."""
    count = len(read)
    kind, row, plane = below(state, FULL), below(state, count), below(state, planes)
    if kind >= SWAPPED:
        row = 3 * below(state, (count + 1) // 3) + 1
        rows[0], rows[1] = row, row - 1
        if used[row]:
            if drawn(state) & U64(1):
                read[row - 1], read[row] = read[row], read[row - 1]
                value[row - 1], value[row] = value[row], value[row - 1]
            if drawn(state) & U64(1):
                used[row] = 0
            return 2
        used[row], read[row], value[row] = 1, read[row - 1], value[row - 1]
        if not read[row] >> plane & 1:
            read[row] |= 1 << plane
            read[row - 1] |= 1 << plane
        value[row] ^= 1 << plane
        return 2
    if not used[row]:
        return 0
    rows[0] = row
    if kind < LITERALS[0]:
        read[row] ^= 1 << plane
        value[row] &= read[row]
        if read[row] >> plane & 1 and drawn(state) & U64(1):
            value[row] |= 1 << plane
        return 1
    if kind < LITERALS[1]:
        value[row] ^= read[row] & 1 << plane
        return 1
    if kind < LITERALS[2]:
        other = below(state, planes)
        if (read[row] >> plane & 1) == (read[row] >> other & 1):
            return 0
        read[row] ^= 1 << plane | 1 << other
        value[row] &= read[row]
        if drawn(state) & U64(1):
            value[row] |= read[row] & (1 << plane | 1 << other)
        return 1
    if kind < LITERALS[3]:
        last = min(count, row + 1 + below(state, 12))
        for k in range(row, last):
            rows[k - row] = k
            value[k] ^= read[k] & 1 << plane
        return last - row
    other = below(state, count)
    if (row - other) % 3 or row == other or row % 3 == 1:
        return 0
    rows[1] = other
    read[row], read[other] = read[other], read[row]
    value[row], value[other] = value[other], value[row]
    return 2


@njit(cache=True)
def annealed(planes, spare, task, second, fine, hot, cold, steps, read, value, used):
    """Changes the cubes for so many steps, and leaves the cheapest that have a code for each bump;
    returns their cost, infinity where there were none.

    The temperature falls from `hot` to `cold` words. `second` is the price of a second rise cube,
    `fine` that of a bump without a code.
    """
    groups = (len(read) + 1) // 3
    literals = np.zeros((planes, 2, max(1, (1 << planes) // 64)), np.uint64)
    for code in range(1 << planes):
        for plane in range(planes):
            literals[plane, code >> plane & 1, code >> 6] |= U64(1) << U64(code & 63)
    rises = np.zeros((groups, literals.shape[2]), np.uint64)
    falls = np.zeros((groups - 1, literals.shape[2]), np.uint64)
    for k in range(groups):
        fill_group(literals, planes, read, value, used, k, rises, falls)
    place, rows = np.zeros(planes, np.int64), np.zeros(12, np.int64)
    state = np.full(1, 88172645463325252, np.uint64)
    cost = inversion_words(planes, spare, read, value, used, place)
    cost += second * used[1::3].sum()
    if task == NUMBERS:
        cost += 4 * fewest_inversions(planes, read, value, used)
    missing = unmet(rises, falls, task, 1 << 30)
    cheapest = cost if missing == 0 else np.inf
    cost += fine * missing
    old = (read.copy(), value.copy(), used.copy())
    best = read.copy(), value.copy(), used.copy()
    for step in range(steps):
        changed = change(state, planes, read, value, used, rows)
        uniform = (float(drawn(state) >> U64(1)) + 1.0) / 4503599627370497.0
        limit = cost - hot * (cold / hot) ** (step / steps) * np.log(uniform)
        words = inversion_words(planes, spare, read, value, used, place)
        words += second * used[1::3].sum()
        if task == NUMBERS:
            words += 4 * fewest_inversions(planes, read, value, used)
        accepted = changed > 0 and words <= limit
        if accepted:
            for k in range(changed):
                if k == 0 or rows[k] // 3 != rows[k - 1] // 3:
                    fill_group(literals, planes, read, value, used, rows[k] // 3, rises, falls)
            lost = unmet(rises, falls, task, int((limit - words) / fine))
            if words + fine * lost <= limit:
                cost = words + fine * lost
                if lost == 0 and words < cheapest:
                    cheapest = words
                    best[0][:], best[1][:], best[2][:] = read, value, used
                for k in range(changed):
                    row = rows[k]
                    old[0][row], old[1][row], old[2][row] = read[row], value[row], used[row]
                continue
        for k in range(changed):
            row = rows[k]
            read[row], value[row], used[row] = old[0][row], old[1][row], old[2][row]
        if accepted:
            for k in range(changed):
                if k == 0 or rows[k] // 3 != rows[k - 1] // 3:
                    fill_group(literals, planes, read, value, used, rows[k] // 3, rises, falls)
    read[:], value[:], used[:] = best
    return cheapest


def searched(cubes, *, spare, steps, hot, cold, fine, task=BUMPS, second=SECOND):
    """The cheapest cubes found from `cubes` on; None if some bump has no code in all of them."""
    found = cubes.window(0, cubes.groups)
    cost = annealed(
        cubes.planes, spare, task, second, fine, hot, cold, int(steps),
        found.read, found.value, found.used,
    )  # fmt: skip
    if task == BUMPS:
        found = in_cheapest_order(found, spare)
    print(f"{cubes.planes} planes, {cubes.groups} groups: {cost} words", flush=True)
    return found if np.isfinite(cost) else None


def in_cheapest_order(cubes: Cubes, spare: bool) -> Cubes:
    """The same cubes; of groups with two rise cubes, the one comes first that saves inversions."""
    place = np.zeros(cubes.planes, np.int64)
    orders = []
    for swapped in product((False, True), repeat=int(cubes.used[1::3].sum())):
        ordered = cubes.window(0, cubes.groups)
        for first in 3 * np.flatnonzero(cubes.used[1::3])[list(swapped)]:
            for values in (ordered.read, ordered.value):
                values[[first, first + 1]] = values[[first + 1, first]]
        orders.append(ordered)
    return min(
        orders,
        key=lambda c: inversion_words(c.planes, spare, c.read, c.value, c.used, place),
    )


def gray_and_binary(planes: int, groups: int) -> Cubes:
    """Half of the planes in Gray code for the start, half in binary for the end: a first guess,
    with too few planes where the groups are many."""
    ends = planes // 2
    starts = (1 << planes - ends) - 1
    numbers = np.arange(groups)
    read, value = np.zeros(3 * groups - 1, np.int64), np.zeros(3 * groups - 1, np.int64)
    read[::3], value[::3] = starts, (numbers ^ numbers >> 1) & starts
    read[2::3] = (~numbers[:-1] & (1 << ends) - 1) << planes - ends
    return Cubes(planes, read, value, (np.arange(3 * groups - 1) % 3 != 1).astype(np.int64))


def in_parts(parts: Cubes) -> Cubes:
    """Every group of `parts` as four groups, in four planes more."""
    size, ones = 1 << IN_PART, (1 << IN_PART) - 1
    groups = parts.groups * size
    cubes = gray_and_binary(parts.planes + 2 * IN_PART, groups)
    for k in range(groups):
        part, place = divmod(k, size)
        # There and back, so that one bit changes from part to part, too.
        turned = place if part % 2 == 0 else ones - place
        gray = turned ^ turned >> 1
        for row in (0, 1):
            cubes.used[3 * k + row] = parts.used[3 * part + row]
            cubes.read[3 * k + row] = parts.read[3 * part + row] | ones << parts.planes
            cubes.value[3 * k + row] = parts.value[3 * part + row] | gray << parts.planes
        if k < groups - 1:
            ends = (~place & ones) << parts.planes + IN_PART
            last = part == parts.groups - 1
            cubes.read[3 * k + 2] = ends if last else parts.read[3 * part + 2] | ends
            cubes.value[3 * k + 2] = 0 if last else parts.value[3 * part + 2]
    return cubes


def cheapest_window(cubes: Cubes, groups: int, spare: bool) -> Cubes:
    """The window of so many groups that inverts least."""
    windows = [cubes.window(first, groups) for first in range(cubes.groups - groups + 1)]
    place = np.zeros(cubes.planes, np.int64)
    return min(
        windows,
        key=lambda w: (
            SECOND * w.used[1::3].sum()
            + inversion_words(w.planes, spare, w.read, w.value, w.used, place)
        ),
    )


def cubes_of(planes: int, rows: list[str]) -> Cubes:
    """The cubes that `Cubes.text` has written."""
    cubes = Cubes(planes, *(np.zeros(3 * len(rows) - 1, np.int64) for _ in range(3)))
    for k, line in enumerate(rows):
        rises, _, fall = line.partition("|")
        for place, text in [*enumerate(rises.split()), *((2, text) for text in fall.split())]:
            row = 3 * k + place
            cubes.used[row] = 1
            for plane, bit in enumerate(text):
                cubes.read[row] |= (bit != "-") << plane
                cubes.value[row] |= (bit == "1") << plane
    return cubes


def continued(kind: str, share: float) -> Iterator[Cubes]:
    """The tables in the tree, each replaced if the search finds cheaper cubes from there on."""
    for table in tomllib.loads(TABLES.read_text())[kind]:
        planes = table["planes"]
        cubes = cubes_of(planes, table["rows"].strip().splitlines())
        found = searched(
            cubes, spare=kind == "numbers" or planes < 9, steps=share * 1e8, hot=1.6, cold=0.3,
            fine=16.0 if kind == "numbers" else 6.0, second=1e9 if kind == "numbers" else SECOND,
            task=NUMBERS if kind == "numbers" else BUMPS,
        )  # fmt: skip
        yield found or cubes


def bump_tables(share: float) -> Iterator[Cubes]:
    """The cubes of bumps, of each count of groups; `share` of the full steps."""
    parts = searched(
        gray_and_binary(5, 7), spare=False, task=PARTS, steps=1e7, hot=10.0, cold=0.6, fine=40.0,
        second=4 * SECOND,
    )  # fmt: skip
    cubes = in_parts(parts)
    for _ in range(2):
        cubes = searched(cubes, spare=False, steps=share * 4e7, hot=1.0, cold=0.25, fine=6.0)
    yield cubes
    chains = (cubes.window(0, 27), False, 17), (gray_and_binary(8, 18), True, 8)
    for cubes, spare, least in chains:
        while cubes.groups >= least:
            steps = share * {27: 6e7, 26: 6e7, 25: 6e7, 18: 1e8}.get(cubes.groups, 3e7)
            found = searched(cubes, spare=spare, steps=steps, hot=1.5, cold=0.3, fine=6.0)
            cubes = found or cubes
            yield cubes
            cubes = cheapest_window(cubes, cubes.groups - 1, spare)


def number_tables(share: float) -> Iterator[Cubes]:
    """The cubes of numbers, of every fourth count."""
    for planes in (4, 5, 6):
        count = 1 << planes
        while count > comb(planes, planes // 2):
            numbers = np.arange(3 * count - 1) // 3
            rise = np.arange(3 * count - 1) % 3 == 0
            read = np.where(rise, (1 << planes) - 1, 0)
            cubes = Cubes(planes, read, (numbers ^ numbers >> 1) & read, rise.astype(np.int64))
            found = searched(
                cubes, spare=True, steps=share * 2e7, hot=8.0, cold=0.4, fine=16.0, task=NUMBERS,
                second=1e9,
            )  # fmt: skip
            if found:
                yield found
            count -= 4


def main() -> None:
    """Writes the tables."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--steps", type=float, default=1.0, help="share of the full steps")
    parser.add_argument("--continue", dest="goes_on", action="store_true")
    parser.add_argument("--out", type=Path, default=TABLES)
    asked = parser.parse_args()
    lines = [
        "# Made by tests/benchmarks/search_cubes.py. A character for each plane that a cube reads.",
        "# A line of bumps is a group: its rise cubes and, after the bar, its fall cube.",
    ]
    for kind, tables in (("bumps", bump_tables), ("numbers", number_tables)):
        for cubes in continued(kind, asked.steps) if asked.goes_on else tables(asked.steps):
            lines += [
                "",
                f"[[{kind}]]",
                f"planes = {cubes.planes}",
                f'rows = """\n{cubes.upright().text()}\n"""',
            ]
    asked.out.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
