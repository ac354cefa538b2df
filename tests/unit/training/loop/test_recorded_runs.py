"""Short runs of every class of shutters and of most decoders, compared with recorded ones.

Other tests say whether a run is right; these notice a run that is another one: its scores after
each step, its result and its program. `pytest --update-cases` records them again.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest
from recorded import compare_with_recorded

pytest.importorskip("torch")

from small_runs import CLIP, STILL, changed, run

SHORT = {"steps": 3, "batch": 2, "validate_every": 2, "code_rate": 0.05, "device": "cpu"}
DATA = {"patch": 16, "scenes": 3, "val_items": 2}


def values(base: dict[str, Any], **sections: dict[str, Any]) -> dict[str, Any]:
    for section, keys in {"train": SHORT, "data": DATA}.items():
        base = changed(base, section, **{**keys, **sections.pop(section, {})})
    for section, keys in sections.items():
        base = changed(base, section, **keys)
    return base


RUNS: Mapping[str, dict[str, Any]] = {
    "stops": values(STILL),
    "bumps of a length": values(
        STILL, shutter={"class": "c", "length": 5, "init": "uniform", "warm_up": 0.5,
                        "settle": 0.0},
        loss={"name": "log"}, data={"saturated": [0.1, 0.4]}, train={"optimizer": "muon"},
    ),
    "bumps": values(
        STILL, shutter={"class": "d", "relaxation": "gumbel", "temperature": [2.0, 0.5]},
        decoder={"sees_code": False}, loss={"name": "mu-law+l1"},
        train={"average": 0.5, "schedule": "constant"},
    ),
    "bits": values(CLIP, shutter={"class": "e", "relaxation": "sigmoid", "words_weight": 0.0}),
    "a codebook": values(CLIP, loss={"name": "display"}, data={"brightness": [0.5, 2.0]}),
    "two buckets": values(
        CLIP, shutter={"buckets": 2, "relaxation": "straight-through"}
    ),
    "codes that are tried": values(
        STILL, shutter={"relaxation": "tried", "tried_share": 0.25}
    ),
    "codes that are searched": values(
        STILL, shutter={"relaxation": "search", "moves": 6, "judged": 2, "words_weight": 0.01}
    ),
    "classes": values(
        CLIP, shutter={"tile": [2, 2]}, decoder={"name": "classifier"}, loss={"name": "class"},
        data={"protocol": "class-v1", "augment": False},
    ),
    "all pixels at once": values(CLIP, decoder={"name": "fcnet"}),
    "unrolled": values(CLIP, decoder={"name": "unrolled"}),
    "looks": values(STILL, shutter={"class": "looks", "exposures": 3, "slots": 16}),
}  # fmt: skip


SKIPPED = ("files", "settings", "environment")


@pytest.mark.parametrize("name", RUNS)
def test_a_short_run_is_the_recorded_one(name: str, tmp_path: Path, update_cases: bool) -> None:
    """Metrics, result and program text are the recorded ones, with numbers within 2 %."""
    run(RUNS[name], tmp_path / "run")
    result = json.loads((tmp_path / "run/result.json").read_text())
    shown = [
        (tmp_path / "run/metrics.csv").read_text(),
        *flat("", result),
        (tmp_path / "run/shutter.nsl").read_text(),
    ]
    # Sums of floats differ a little from machine to machine, and more after every update.
    compare_with_recorded(
        "\n".join(shown), f"runs/{name.replace(' ', '_')}", update_cases, share=2e-2, spare=2e-3
    )


def flat(key: str, value: object) -> Iterator[str]:
    """The figures of a result by key, without digests and times."""
    if isinstance(value, dict):
        for name in sorted(name for name in value if name not in SKIPPED and "sha" not in name):
            yield from flat(f"{key}.{name}", value[name])
    elif isinstance(value, list):
        for number, item in enumerate(value):
            yield from flat(f"{key}.{number}", item)
    else:
        yield f"{key} {value}"
