"""What texts of the permitted size take the parser that are made of one piece over and over.

    python tests/benchmarks/bench_syntax.py [--rounds 3]

Milliseconds of the processor, the least of some rounds, for all that `nscc check` says of a text
that is no program; and by what factor they grow from a quarter of the text to the whole, which is 4
where nothing is worse than linear. It exits 1 where one grows more than is asked.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from time import process_time

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests/helpers"))

from syntax_text import PIECES, check, over_and_over, read, tile  # noqa: E402

_SIZE, _PART = 40_000, 4
_MOST = 6.0
_LEAST_MS = 2.0
"""Of a whole text: below it, what is measured is not the text."""


def taken_ms(text: str) -> float:
    """What a text takes."""
    began = process_time()
    check(text)
    return 1e3 * (process_time() - began)


def main() -> int:
    """Measure and print; 1 if one grows too fast."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--rounds", type=int, default=3)
    rounds = range(parser.parse_args().rounds)
    texts = {repr(each): over_and_over(each, _SIZE) for each in PIECES}
    texts |= {f"tile of {cells}": tile(cells, _SIZE) for cells in ("1,", "1+x,")}
    read("nsl 1\n")
    worst = 0.0
    for name, text in texts.items():
        part = text[: len(text) // _PART]
        pairs = [(taken_ms(part), taken_ms(text)) for _ in rounds]
        short_ms, long_ms = (min(side) for side in zip(*pairs, strict=True))
        grown = long_ms / short_ms if long_ms > _LEAST_MS else 0.0
        worst = max(worst, grown)
        print(f"{name:24}{long_ms:8.1f} ms" + (f", {grown:.1f} of a quarter" if grown else ""))
    print(f"the fastest growth: {worst:.1f} of a quarter's time (at most {_MOST:g})")
    return 0 if worst <= _MOST else 1


if __name__ == "__main__":
    sys.exit(main())
