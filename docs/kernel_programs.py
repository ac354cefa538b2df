"""Find the shortest programs of one input for common kernels: the rows of `nscc.neighbours.table`.

    python docs/kernel_programs.py sobel laplace_4      prints their rows
    python docs/kernel_programs.py --words 7            prints all rows of up to seven words
    python docs/kernel_programs.py --all-forms          prints rows for chips that allow all words

The search is exhaustive, word by word. A register contains a kernel, represented by the value of
its polynomial at a random point modulo a prime. A step to a neighbour is a multiplication, and a
halving is a multiplication by 1/2. The search skips equal values, other orders of independent
words, and values with a larger reach, larger weights or more halvings than the kernel. Each result
is checked with exact numbers before it is printed.
"""

from __future__ import annotations

import argparse
from typing import Any

import numba
import numpy as np

from nscc.neighbours.programs import UNIT, kernel_of, program_from_text

PRIME = 2**31 - 1
MOST_REGISTERS, MOST_SOURCES = 6, 4
STEPS = ((0, 0), (0, -1), (1, 0), (0, 1), (-1, 0))
"""Offsets (columns, rows) of the pixel itself and of its north, east, south, west neighbour."""
READ, WRITE = "nNESW", "nSWNE"
"""Sources that read NEWS at each step; destinations that bring the value from there to NEWS."""
PLAIN, NEWS, HALVED, HALF = 0, 1, 2, 3
"""Kinds of words: a register; NEWS; a register and NEWS, both halved; a register, halved."""

KERNELS: dict[str, tuple[list[list[int]], int]] = {
    "forward": ([[0, 1, -1]], 1),
    "difference": ([[1, 0, -1]], 1),
    "difference / 2": ([[1, 0, -1]], 2),
    "both": ([[1, 0, 1]], 1),
    "1 1 1": ([[1, 1, 1]], 1),
    "1 1 1 / 2": ([[1, 1, 1]], 2),
    "1 2 1": ([[1, 2, 1]], 1),
    "1 2 1 / 4": ([[1, 2, 1]], 4),
    "-1 2 -1": ([[-1, 2, -1]], 1),
    "-1 2 -1 / 2": ([[-1, 2, -1]], 2),
    "-1 2 -1 / 4": ([[-1, 2, -1]], 4),
    "1 4 6 4 1": ([[1, 4, 6, 4, 1]], 1),
    "five": ([[1] * 5], 1),
    "diagonal": ([[0, 0, 0], [0, 1, 0], [0, 0, -1]], 1),
    "box 2x2": ([[0, 0, 0], [0, 1, 1], [0, 1, 1]], 1),
    "box 3x3": ([[1] * 3] * 3, 1),
    "cross": ([[0, 1, 0], [1, 1, 1], [0, 1, 0]], 1),
    "four": ([[0, 1, 0], [1, 0, 1], [0, 1, 0]], 1),
    "cross / 4": ([[0, 1, 0], [1, 1, 1], [0, 1, 0]], 4),
    "four / 4": ([[0, 1, 0], [1, 0, 1], [0, 1, 0]], 4),
    "gauss": ([[1, 2, 1], [2, 4, 2], [1, 2, 1]], 16),
    "sobel / 8": ([[1, 0, -1], [2, 0, -2], [1, 0, -1]], 8),
    "sobel": ([[1, 0, -1], [2, 0, -2], [1, 0, -1]], 1),
    "prewitt": ([[1, 0, -1]] * 3, 1),
    "laplace": ([[0, -1, 0], [-1, 4, -1], [0, -1, 0]], 1),
    "laplace / 4": ([[0, -1, 0], [-1, 4, -1], [0, -1, 0]], 4),
    "laplace inverted": ([[0, 1, 0], [1, -4, 1], [0, 1, 0]], 1),
    "sharpen": ([[0, -1, 0], [-1, 5, -1], [0, -1, 0]], 1),
}


@numba.njit(cache=True)
def _search(depth: int, state: Any, limits: Any, tables: Any, words: Any) -> bool:
    """Return whether the kernel can be reached from `state`; write its program to `words`."""
    values, boxes, weights, count, news, unread = state
    goal, box, most_weight, most_halvings, length, budget = limits
    shift, steps, bits, forms = tables
    budget[0] -= 1
    if budget[0] < 0:
        return False
    sums = np.zeros(1 << count, np.int64)
    for i in range(count):
        for mask in range(1 << i):
            sums[mask | 1 << i] = (sums[mask] + values[i]) % PRIME
    last = depth == length - 1
    held, halvings = news[0], news[7]
    for mask in range(1 << count):
        chosen = bits[mask]
        if chosen > MOST_SOURCES:
            continue
        low_x, high_x, low_y, high_y, weight = 99, -99, 99, -99, 0
        for i in range(count):
            if mask >> i & 1:
                low_x, high_x = min(low_x, boxes[i, 0]), max(high_x, boxes[i, 1])
                low_y, high_y = min(low_y, boxes[i, 2]), max(high_y, boxes[i, 3])
                weight += weights[i]
        for read in range(-1, 5):  # step of the NEWS that a word reads besides registers; -1: none
            if (read < 0 and chosen == 0) or (read >= 0 and not news[5]):
                continue
            if chosen > (
                MOST_SOURCES if read < 0 else (MOST_SOURCES if read == 0 else forms[0]) - 1
            ):
                continue
            total, x0, x1, y0, y1, w = sums[mask], low_x, high_x, low_y, high_y, weight
            if read >= 0:
                total = (total + held * shift[read]) % PRIME
                x0, x1 = min(x0, news[1] + steps[read, 0]), max(x1, news[2] + steps[read, 0])
                y0, y1 = min(y0, news[3] + steps[read, 1]), max(y1, news[4] + steps[read, 1])
                w += news[8]
            left = unread & ~mask
            pending = news[6] and read < 0
            for kind in range(4):
                halved = kind >= HALVED
                if halved and (halvings >= most_halvings or chosen + (read >= 0) > 2):
                    continue
                if read >= 0 and (kind == HALVED or (kind == HALF and read > 0 and not forms[1])):
                    continue
                value = (PRIME - total) % PRIME
                if halved:
                    value = value * ((PRIME + 1) // 2) % PRIME
                if last:
                    if kind != NEWS and value == goal and left == 0 and not pending:
                        words[depth, 0], words[depth, 1] = kind, 0
                        words[depth, 2], words[depth, 3] = mask, read
                        return True
                    continue
                if w > most_weight or value == 0 or (NEWS <= kind <= HALVED and pending):
                    continue
                if kind != NEWS and (count >= MOST_REGISTERS or np.any(values[:count] == value)):
                    continue
                if kind == NEWS and (read >= 0 or value == held):
                    continue
                for to in range(5 if kind == NEWS and chosen <= forms[0] else 1):
                    a, b = x0 + steps[to, 0], x1 + steps[to, 0]
                    c, d = y0 + steps[to, 1], y1 + steps[to, 1]
                    if a < box[0] or b > box[1] or c < box[2] or d > box[3]:
                        continue
                    after, open_, more = news.copy(), left, count
                    if NEWS <= kind <= HALVED:
                        after[0] = value * shift[to] % PRIME
                        after[1], after[2], after[3], after[4] = a, b, c, d
                        after[5], after[6], after[8] = 1, 1, w
                    elif read >= 0:
                        after[6] = 0
                    if kind != NEWS:
                        values[count], weights[count] = value, w
                        boxes[count, 0], boxes[count, 1] = x0, x1
                        boxes[count, 2], boxes[count, 3] = y0, y1
                        more = count + 1
                        open_ = left | (0 if kind == HALVED else 1 << count)
                    after[7] = halvings + halved
                    words[depth, 0], words[depth, 1] = kind, to
                    words[depth, 2], words[depth, 3] = mask, read
                    inner = (values, boxes, weights, more, after, open_)
                    if _search(depth + 1, inner, limits, tables, words):
                        return True
    return False


def row_of(
    rows: list[list[int]], divisor: int, most_words: int, budget: int, all_forms: bool
) -> str | None:
    """Return the shortest program of a kernel as text; None if not found in `budget` steps.

    With `all_forms`, a word that reaches a neighbour has up to four sources, and may halve."""
    rng = np.random.default_rng(5)
    across, down = (int(number) for number in rng.integers(2, PRIME - 1, 2))
    back, up = (pow(number, PRIME - 2, PRIME) for number in (across, down))
    height, width = len(rows), len(rows[0])
    goal = 0
    for i, row in enumerate(rows):
        for j, weight in enumerate(row):
            x, y = j - width // 2, i - height // 2
            goal += (
                weight
                * pow(across if x > 0 else back, abs(x), PRIME)
                * pow(down if y > 0 else up, abs(y), PRIME)
            )
    goal = goal * pow(divisor, PRIME - 2, PRIME) % PRIME
    box = np.array([-(width // 2), width // 2, -(height // 2), height // 2])
    tables = (
        np.array([1, up, across, down, back], np.int64),
        np.array(STEPS),
        np.array([mask.bit_count() for mask in range(1 << MOST_REGISTERS)]),
        np.array([MOST_SOURCES if all_forms else 2, all_forms]),
    )
    total = sum(abs(weight) for row in rows for weight in row)
    for length in range(1, most_words + 1):
        values, boxes = np.zeros(32, np.int64), np.zeros((32, 4), np.int64)
        weights, words = np.zeros(32, np.int64), np.zeros((32, 4), np.int64)
        values[0] = weights[0] = 1
        steps = np.array([budget])
        state = (values, boxes, weights, 1, np.zeros(9, np.int64), 0)
        limits = (goal, box, total, divisor.bit_length() - 1, length, steps)
        if _search(0, state, limits, tables, words):
            return _text(words[:length])
        if steps[0] < 0:
            return None
    return None


def _text(words: Any) -> str:
    """Return a program in the form of the table."""
    names, count, found = "xabcdefgh", 1, []
    for kind, to, mask, read in words.tolist():
        sources = [names[i] for i in range(9) if mask >> i & 1] + [READ[read]] * (read >= 0)
        target = WRITE[to] if kind == NEWS else names[count] + ["", "", "n", "2"][kind]
        count += kind != NEWS
        found.append(f"{target}={','.join(sources)}")
    return " ".join(found)


def main() -> None:
    """Print the rows of the named kernels."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("kernels", nargs="*", default=[*KERNELS], metavar="KERNEL")
    parser.add_argument("--words", type=int, default=8, help="most words of a program")
    parser.add_argument("--budget", type=int, default=10**9, help="most steps for each length")
    parser.add_argument("--all-forms", action="store_true", help="use the words of all forms")
    options = parser.parse_args()
    for name in options.kernels:
        rows, divisor = KERNELS[name]
        text = row_of(rows, divisor, options.words, options.budget, options.all_forms)
        if text is None:
            print(f"# {name}: none within the budget")
            continue
        taps = kernel_of(program_from_text(text))
        right, down = len(rows[0]) // 2, len(rows) // 2
        assert all(
            taps.get((j - right, i - down), 0) == weight * UNIT // divisor
            for i, row in enumerate(rows)
            for j, weight in enumerate(row)
        )
        print(f"{text}    # {name}, {len(text.split())} words", flush=True)


if __name__ == "__main__":
    main()
