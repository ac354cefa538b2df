"""Print a page of results: a Markdown template whose numbers are computed from results.

    python docs/result_pages.py training/results/templates/details.md > training/results/details.md

A second argument names another folder of results, such as the output of `nscc sweep`.
`{{WORD ARGUMENTS}}` in a template calls a method of `Page`, with arguments split as in a shell. A
result is named after its file, without .json; * in a name matches the results of several seeds. A
metric may end in /source (each file counts once, however many items it has), in /interval (adds the
95 % interval of a bootstrap over scenes) or in @SHARE (at that fraction of saturated pixels)."""

from __future__ import annotations

import json
import re
import shlex
import sys
from functools import cache, partial
from pathlib import Path
from typing import Any

from nscc_training.evaluation.paper_tables import NOT_RUN, dagger, results_named
from nscc_training.evaluation.results import compare, mean_of
from nscc_training.measures import bootstrap, number

EVALUATIONS = Path(__file__).resolve().parents[1] / "training/results/evaluations"
_WORDS = ("mean", "gain", "value", "validated", "row", "against", "verdict", "columns")
_LABELS = {
    "psnr_db": "PSNR",
    "mu_psnr_db": "PSNR-mu",
    "correct": "right classes",
    "cross_entropy": "cross-entropy",
}
_ITEMS = {"hdr-v1": ("crops", "panoramas"), "deblur-v1": ("views", "panoramas")}
"""What items are, and of which files, by protocol; else windows of clips."""
_SETTINGS = {
    "moved": lambda settings: f"{settings['moved']} of {settings['places']}",
    "steps": lambda settings: str(settings["steps"]),
    "words": lambda settings: f"{settings['words_per_slot']:.1f}",
    "stops": lambda settings: " ".join(str(stop) for row in settings["stops"] for stop in row),
}


class Page:
    """A page of results: it computes the words of a template from the results in a folder.

    A dagger marks runs without weights in the folder `runs` beside the results."""

    def __init__(self, results: Path) -> None:
        self.results = results / "results" if (results / "results").is_dir() else results
        self._results_of = cache(partial(results_named, self.results))

    def filled(self, template: str) -> str:
        """Return a template with its words replaced; raise ValueError for unknown ones."""
        return re.sub(r"\{\{(.*?)\}\}", lambda match: self._word(*shlex.split(match[1])), template)

    def mean(self, name: str, metric: str) -> str:
        """Return the mean over items, then seeds, as text."""
        results = self._results_of(name)
        metric, _, share = metric.partition("@")
        metric, _, way = metric.partition("/")
        if not results:
            return NOT_RUN
        if share:
            values = [
                entry[f"mean_{metric}"]
                for result in results
                for entry in result["also_saturated"]
                if entry["saturated_fraction"] == float(share)
            ]
            return _digits(sum(values) / len(values), metric)
        if way not in ("", "source", "interval"):
            raise ValueError(f"a metric ends in /source or /interval, not /{way}")
        text = _digits(mean_of(results, metric, by_source=way == "source"), metric)
        items = [item for result in results for item in result["items"] if item[metric] != "inf"]
        if way != "interval" or len({item["file"] for item in items}) < 2:
            return text
        ends = bootstrap([number(i[metric]) for i in items], [str(i["file"]) for i in items])
        return "{} ({} to {})".format(text, *(_digits(end, metric) for end in ends))

    def gain(self, first: str, second: str, metric: str) -> str:
        """Return the gain of the second result over the first with its interval; with /source only
        the gain."""
        first_results, second_results = self._results_of(first), self._results_of(second)
        if not (first_results and second_results):
            return NOT_RUN
        if metric.endswith("/source"):
            metric = metric.removesuffix("/source")
            first_mean, second_mean = (
                mean_of(results, metric, by_source=True) or 0
                for results in (first_results, second_results)
            )
            return f"{second_mean - first_mean:+.2f}"
        comparison = _compared(first_results, second_results, metric)
        digits = _decimals(metric)
        low, high = comparison["ci95"] or (None, None)
        between = "" if low is None else f" ({low:+.{digits}f} to {high:+.{digits}f})"
        return f"{comparison['gain_db']:+.{digits}f}{between}"

    def value(self, name: str, key: str) -> str:
        """Return a property of a result: moved, steps, words, stops, parameters or items."""
        results = self._results_of(name)
        if not results:
            return NOT_RUN
        if key == "items":
            items = results[0]["items"]
            of, files = _ITEMS.get(results[0]["protocol"], ("windows", "clips"))
            return f"{len(items)} {of} from {len({item['file'] for item in items})} {files}"
        if key == "parameters":
            count = results[0]["parameters"]
            return f"{count / 1e6:.2g} million" if count < 1e7 else f"{count / 1e6:.1f} million"
        return ", ".join(_SETTINGS[key](result["settings"]) for result in results)

    def validated(self, run: str) -> str:
        """Return the PSNR of a run on its validation scenes. `run` is a folder beside the
        results."""
        path = self.results.parent / run / "result.json"
        if not path.is_file():
            return NOT_RUN
        return _digits(json.loads(path.read_text())["headline"]["psnr_db"], "psnr_db")

    def row(self, label: str, name: str, *cells: str) -> str:
        """Return a table row of metrics, keys of `value`, gains over NAME (NAME:METRIC), or empty
        cells (=)."""
        texts = [f"{label} {dagger(self.results, name)}".strip()]
        for cell in cells:
            base_name, _, metric = cell.rpartition(":")
            if cell == "=":
                texts.append("")
            elif base_name:
                texts.append(self.gain(base_name, name, metric))
            elif cell in (*_SETTINGS, "parameters", "items"):
                texts.append(self.value(name, cell))
            else:
                texts.append(
                    " / ".join(self.mean(name, metric_name) for metric_name in cell.split("+"))
                )
        return f"| {' | '.join(texts)} |"

    def against(self, label: str, first: str, second: str, *metrics: str) -> str:
        """Return a table row whose cells are the gains of the second result over the first."""
        mark = dagger(self.results, first) or dagger(self.results, second)
        gains = (self.gain(first, second, metric) for metric in metrics)
        return f"| {f'{label} {mark}'.strip()} | {' | '.join(gains)} |"

    def verdict(self, label: str, name: str, metric: str, *others: str) -> str:
        """Compare a learned code with the best of `others`, each LABEL and NAME."""
        unit = _LABELS[metric]
        means = {
            other: mean
            for other, other_name in zip(others[::2], others[1::2], strict=True)
            if (mean := mean_of(self._results_of(other_name), metric)) is not None
        }
        results = self._results_of(name)
        if not (results and means):
            return f"* {label}, {unit}: {NOT_RUN}"
        sign = -1 if metric == "cross_entropy" else 1  # lower is better
        best = max(means, key=lambda other: sign * means[other])
        best_name = others[others.index(best) + 1]
        comparison = _compared(self._results_of(best_name), results, metric)
        low, high = sorted(sign * end for end in comparison["ci95"] or (0.0, 0.0))
        outcome = "better" if low > 0 else "worse" if high < 0 else "not proved better"
        if all(entry["settings"].get("moved") == 0 for entry in results):
            return f"* {label}, {unit}: **not learned**, since no place moved from the start."
        return (
            f"* {label}, {unit}: **{outcome}** than the best code of the table that was "
            f"not learned, {best} ({self.gain(best_name, name, metric)})."
        )

    def columns(self, label: str, metrics: str, *names: str) -> str:
        """Return a table row with a cell for each result, NAME[@SHARE], of `metrics` A+B."""
        cells = []
        for name, at, share in (name.partition("@") for name in names):
            means = (self.mean(name, f"{metric}{at}{share}") for metric in metrics.split("+"))
            cells.append(" / ".join(means))
        return f"| {label} | {' | '.join(cells)} |"

    def _word(self, word: str = "", *arguments: str) -> str:
        if word not in _WORDS:
            raise ValueError(f"unknown placeholder '{word}' in a template")
        try:
            text: str = getattr(self, word)(*arguments)
        except (KeyError, TypeError, ValueError) as error:
            raise ValueError(f"{{{{{word} {shlex.join(arguments)}}}}}: {error}") from error
        return text


def _compared(
    first: list[dict[str, Any]], second: list[dict[str, Any]], metric: str
) -> dict[str, Any]:
    """Compare two methods; the only result of one stands beside all seeds of the other."""
    count = max(len(first), len(second))
    repeated = (results * (count // len(results)) for results in (first, second))
    return compare(list(zip(*repeated, strict=True)), metric)


def _digits(value: float | None, metric: str) -> str:
    if value is None:
        raise ValueError(f"no item has a finite {metric}")
    return f"{value:.{_decimals(metric)}f}"


def _decimals(metric: str) -> int:
    return 2 if metric.endswith("_db") else 3


if __name__ == "__main__":
    template, *folder = map(Path, sys.argv[1:])
    page = Page(*folder or [EVALUATIONS])
    sys.stdout.write(page.filled(template.read_text(encoding="utf-8")))
