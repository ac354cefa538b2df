"""Output files of a tradeoff, and the measurements that are kept until the files are written."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc import __version__
from nscc.cache.digest import content, digest, package_digest
from nscc.experiment_store import ExperimentStore
from nscc.files import refuse_inputs, refuse_same, write_together
from nscc.requirements import installed_version
from nscc_cli.support import progress, say_done

if TYPE_CHECKING:
    from nscc_training.experiments.study import Study, StudyResult

STORE = ".measurements.sqlite"
"""File name ending of the measurements that are kept until the products are written."""
_PLACES = ("out", "csv_path", "png_path")
"""Options that only name where products are written."""
_PACKAGES = ("nscc", "nscc_runtime", "nscc_training")
"""nscc's packages, whose content decides whether stored measurements are used again."""
_DISTRIBUTIONS = ("lark", "networkx", "numba", "scipy", "torch")
"""Packages of others, whose versions decide it, too."""


def output_files(options: Mapping[str, Any], *further_names: str) -> dict[str, Path]:
    """Return the path of each product of a tradeoff by name, for the `options` of its command:
    `csv` and `png` if an option asks for them, and with `-o` also `further_names`, which are other
    diagrams.

    Raises Rejected: NS0745 for equal paths, and NS0786 for a picture that is not a .png."""
    places: dict[str, Path | None] = {"csv": options["csv_path"], "png": options["png_path"]}
    out = options["out"]
    if out is not None:
        ends = {"csv": ".csv", "png": ".png", **{name: f"_{name}.png" for name in further_names}}
        places = {n: places.get(n) or out.with_name(out.name + end) for n, end in ends.items()}
    files = {name: path for name, path in places.items() if path is not None}
    refuse_same(files.values(), "--csv and --png")
    if "png" in files:
        from nscc_runtime.formats import check_ending

        check_ending(files["png"], (".png",), "a picture")
    return files


def kept_rows(files: Mapping[str, Path], options: Mapping[str, Any], *of: str) -> ExperimentStore:
    """Return the store of measurements beside the first of the products `files`; without products,
    a store in memory. Raises Rejected (NS0785) if a product would replace an input.

    A stored row is used again only if these are unchanged: the command's `options`, the contents of
    the files that they name, the texts `of`, the versions of the packages, and the processor."""
    if not files:
        return ExperimentStore()
    from nscc_training.experiments.study import processor_name

    refuse_inputs(*files.values())
    option_values = {
        name: _plain(value) for name, value in sorted(options.items()) if name not in _PLACES
    }
    ours = [package_digest(name) or __version__ for name in _PACKAGES if find_spec(name)]
    versions = [(name, installed_version(name)) for name in _DISTRIBUTIONS]
    key = digest((option_values, list(of), ours, versions, processor_name()))
    first = next(iter(files.values()))
    return ExperimentStore(first.with_name(first.stem + STORE), key, say_done)


def _plain(value: Any) -> Any:
    """Return the value of an option in a form that can be compared: a text or path becomes [text,
    digest of the file of that name]. Tuples become lists; other values stay as they are."""
    if isinstance(value, tuple):
        return [_plain(item) for item in value]
    if isinstance(value, str | Path):
        return [str(value), content(Path(value))]
    return value


def run_study(
    study: Study, files: Mapping[str, Path], options: Mapping[str, Any], *of: str
) -> StudyResult:
    """Measure a study, print its table, write its products into `files`, and return the result.
    Without any point, no product is written.

    Measurements are kept beside the first product until all products are written. `options` and
    `of` decide whether they are used again, together with the packages' versions and the processor.
    """
    from nscc_runtime.pictures.sheet import png_of
    from nscc_training.experiments.study import measure, processor_name
    from nscc_training.experiments.study_table import csv_text

    device = study.device or processor_name()
    with kept_rows(files, options, *of) as store:
        measured = measure(study, store, progress)
        click.echo(study.text(measured))
        refused = measured.refused if study.lists_refused else ()
        if measured.points:
            write_together(
                {
                    path: csv_text(study.csv_of(measured.points), device, refused).encode()
                    if name == "csv"
                    else png_of(study.diagrams[name], measured, device)
                    for name, path in files.items()
                }
            )
        store.remove()
    if files and measured.points:
        say_done("wrote " + ", ".join(path.as_posix() for path in files.values()))
    return measured
