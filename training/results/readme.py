"""README.md of this folder from README.template.md: every number comes from a file beside it.

    python training/results/readme.py

`{{WORD ARGUMENTS}}` in the template is one of the functions below, with arguments as a shell would
split them. Results are named as their files in `evaluations`; @ stands for the seeds 0, 1 and 2.
"""

from __future__ import annotations

import csv
import json
import re
import shlex
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from nscc_training.evaluation.looks import LOOKING, rows_text
from nscc_training.evaluation.results import compare, mean_of, read_result

HERE = Path(__file__).resolve().parent
SEEDS = range(3)
CODES = {
    "quad": "2 x 2 pattern (`quad`)",
    "two-phase": "`two-phase`",
    "staggered": "`staggered`",
    "cyclic": "`cyclic`, free bits",
    "random-c": "random, `c`, seed 0",
    "random-d": "random, `d`, seed 0",
    **{
        f"{name}_{seed}": f"{told}, free bits, seed {seed}"
        for seed in SEEDS
        for name, told in (("start", "random"), ("found", "**searched from these**"))
    },
    "found_words": "searched within four words, free bits, seed 0",
    "judge": "the code of seed 2 behind eight stages",
    "tuned": "the same, behind these after they have learned it",
}
"""The rows of `codes`, as `codes.py` names them, and what they are."""
PAPER = {
    "paper_hdr_random": ("2D U-Net, `b` random", "hdr_random_0"),
    "paper_hdr_quad": ("2D U-Net, `b`, 2 x 2 pattern", "hdr_quad_0"),
    "paper_hdr_learned": ("2D U-Net, `b` **learned from random**", ""),
    "on/paper_hdr_quad_on": ("2D U-Net, `b`, 2 x 2 pattern, its run learning on", "hdr_quad_0"),
    "on/paper_hdr_on": (
        "2D U-Net, `b` **learned on from the 2 x 2 pattern's run**",
        "hdr_learned_0",
    ),
    "paper_fc_c": ("FC-net, `c`, 2 x 2 pattern", "fc_c_quad"),
    "paper_fc_e": ("FC-net, `e` random", "fc_e_random"),
    "paper_u3_c": ("3D U-Net, `c`, 2 x 2 pattern", "u3_c_quad"),
    "paper_u3_d": ("3D U-Net, `d` random", "u3_d_random_0"),
}
"""The rows of `paper_size`, by the result's name, whose last part is what `paper_size.py` calls the
run: what they are, and the run with the same codes and a small decoder, if there is one. What
learned on from another of them is in a folder of its own, out of the paper's tables."""


@cache
def result(name: str) -> dict[str, Any]:
    """What `nscc evaluate` said."""
    return read_result(HERE / "evaluations" / f"{name}.json")


def results(name: str) -> list[dict[str, Any]]:
    """Those of all seeds, or the one there is."""
    return [result(name.replace("@", str(seed))) for seed in (SEEDS if "@" in name else range(1))]


def run_of(name: str) -> dict[str, Any]:
    """What a run said of itself."""
    return dict(json.loads((HERE / "runs" / name / "result.json").read_text(encoding="utf-8")))


def mean(name: str, metric: str) -> str:
    """Over items, then seeds: dB with two digits, others with three."""
    return _digits(mean_of(results(name), metric), metric)


def source(name: str, metric: str) -> str:
    """The same, with every file counting once."""
    return _digits(mean_of(results(name), metric, by_source=True), metric)


def gain(first: str, second: str, metric: str) -> str:
    """How much better the second is in pairs, with its interval."""
    return _signed(compared(first, second, metric))


def compared(first: str, second: str, metric: str) -> dict[str, Any]:
    """As `nscc evaluate compare`: a result of one seed is compared with all of the other's."""
    one, other = results(first), results(second)
    count = max(len(one), len(other))
    pairs = zip(one * (count // len(one)), other * (count // len(other)), strict=True)
    return compare(list(pairs), metric)


def gain_by_source(first: str, second: str, metric: str) -> str:
    """The difference of what `source` gives."""
    one, other = (mean_of(results(name), metric, by_source=True) for name in (first, second))
    assert one is not None
    assert other is not None
    return f"{other - one:+.2f}"


def stop(name: str) -> str:
    """The stop of a uniform exposure."""
    [[only]] = result(name)["settings"]["stops"]
    return str(only)


def words(name: str) -> str:
    """Words a slot of a run's program."""
    return f"{run_of(name)['words_per_slot']:.1f}"


def moved(name: str) -> str:
    """At how many places of its tile a run's codes left their start."""
    found = [run_of(name.replace("@", str(k)))["codes"] for k in (SEEDS if "@" in name else [0])]
    return ", ".join(f"{codes['moved']}" for codes in found) + f" of {found[0]['places']}"


def words_of(name: str) -> str:
    """Words a slot of the codes of a row of `codes`."""
    return f"{result(f'codes-{name}')['settings']['words_per_slot']:.1f}"


def validated(name: str) -> str:
    """A run's PSNR on its validation patches: with the start's codes, and with those learned."""
    found = run_of(name)
    return f"{found['codes']['start_alone_psnr_db']:.2f} | {found['headline']['psnr_db']:.2f}"


def steps(name: str) -> str:
    """For how many steps a run was trained."""
    return str(result(name)["settings"]["steps"])


def steps_of(name: str) -> str:
    """For how many steps a run without a result of its own was trained."""
    with open(HERE / "runs" / name / "metrics.csv", encoding="utf-8") as lines:
        return list(csv.DictReader(lines))[-1]["step"]


def validation(name: str, step: str) -> str:
    """A run's PSNR on its validation patches at a step."""
    with open(HERE / "runs" / name / "metrics.csv", encoding="utf-8") as lines:
        [row] = [r for r in csv.DictReader(lines) if (r["step"], r["split"]) == (step, "val")]
    return f"{float(row['psnr_db']):.1f}"


def cost(method: str, setting: str) -> str:
    """PSNR, SSIM and milliseconds of a decoder, as cells of a table."""
    with open(HERE / "evaluations" / "decoders.csv", encoding="utf-8") as lines:
        rows = [
            row for row in csv.DictReader(lines)
            if row["method"].endswith(f", {method}") and row["setting"] == setting
        ]  # fmt: skip
    found = {row["error_unit"]: float(row["error"]) for row in rows}
    time_ms = float(rows[0]["time_ms"])
    return f"{found['psnr_db']:.2f} | {found['ssim']:.3f} | {time_ms:.0f}"


def windows(name: str) -> str:
    """How many items there are, and how many of them of the file that has most."""
    files = [item["file"] for item in result(name)["items"]]
    return f"{len(files)} windows, {max(map(files.count, files))} of them of one film"


def without(name: str, what: str) -> str:
    """How many dB a run has more on a sensor that is without something, as `without.py` says."""
    scores = _without(name)["without"]
    return f"{scores[what] - scores['nothing']:+.2f}"


def noise(name: str, effects: str, kind: str) -> str:
    """By how many codes a run's pixels vary, in_time or of_pixels."""
    return f"{_without(name)['noise_lsb'][effects][kind]:.1f}"


def looks() -> str:
    """The table of pixels that look, as `nscc evaluate looks` prints it, of those with results."""
    kept = [name for name in LOOKING if evaluated(name)]
    return rows_text([result(name) for name in kept]).rstrip()


def codes() -> str:
    """The table of codes behind the decoder for any code: a column a source, and what each gains
    over the 2 x 2 pattern."""
    sources = [item["file"] for item in result("codes-quad")["items"]]
    head = ["code", "places moved", "words a slot", *(Path(file).stem for file in sources),
            "mean", "over 2 x 2 (95 %)"]  # fmt: skip
    rows = [head, ["---"] * len(head)]
    for name, told in CODES.items():
        found = result(f"codes-{name}")
        settings = found["settings"]
        left = f"{settings['moved']} of {settings['places']}" if "moved" in settings else ""
        by_file = {item["file"]: item["psnr_db"] for item in found["items"]}
        over = "" if name == "quad" else gain("codes-quad", f"codes-{name}", "psnr_db")
        rows.append([
            told, left, f"{settings['words_per_slot']:.1f}",
            *(f"{by_file[file]:.1f}" for file in sources), mean(f"codes-{name}", "psnr_db"), over,
        ])  # fmt: skip
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)


def paper_size(kind: str) -> str:
    """The table of decoders of the paper's size for `stills` or `clips`: those that were run."""
    still = kind == "stills"
    head = ["", "parameters", "places moved", "steps", "linear PSNR" if still else "PSNR",
            "PSNR-mu" if still else "by source", "SSIM", "over the small one (95 %)"]  # fmt: skip
    rows = [head, ["---"] * len(head)]
    for name, (told, small) in PAPER.items():
        if evaluated(name) and still == (result(name)["protocol"] == "hdr-v1"):
            other = mean(name, "mu_psnr_db") if still else source(name, "psnr_db")
            rows.append([
                told, f"{result(name)['parameters'] / 1e6:.1f} million",
                moved(Path(name).name), steps(name),
                mean(name, "psnr_db"), other, mean(name, "ssim"),
                gain(small, name, "psnr_db") if small else "",
            ])  # fmt: skip
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)


def evaluated(name: str) -> bool:
    """Whether there is a result of that name."""
    return (HERE / "evaluations" / f"{name}.json").is_file()


FUNCTIONS: dict[str, Callable[..., str]] = {
    call.__name__: call
    for call in (
        mean, source, gain, gain_by_source, stop, words, words_of, moved, validated, steps,
        steps_of, validation, cost, windows, without, noise, looks, codes, paper_size,
    )
}  # fmt: skip


def written() -> str:
    """The text of README.md."""

    def filled(match: re.Match[str]) -> str:
        word, *arguments = shlex.split(match[1])
        return FUNCTIONS[word](*arguments)

    template = (HERE / "README.template.md").read_text(encoding="utf-8")
    return re.sub(r"\{\{(.*?)\}\}", filled, template)


def _without(name: str) -> dict[str, Any]:
    path = HERE / "evaluations" / "under" / "without.json"
    return dict(json.loads(path.read_text(encoding="utf-8"))[name])


def _digits(value: float | None, metric: str) -> str:
    assert value is not None, metric
    return f"{value:.{2 if metric.endswith('_db') else 3}f}"


def _signed(found: dict[str, Any]) -> str:
    low, high = found["ci95"]
    return f"{found['gain_db']:+.2f} ({low:+.2f} to {high:+.2f})"


if __name__ == "__main__":
    (HERE / "README.md").write_text(written(), encoding="utf-8")
