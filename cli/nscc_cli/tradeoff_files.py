"""What the tradeoffs of training share: where their products go, and lists of numbers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import click

from nscc.files import Product, refuse_same, write_together
from nscc_cli.support import done


def some(names: Sequence[str]) -> Callable[[click.Context, click.Parameter, str], list[str]]:
    """Reads an option's value: some of the names, separated by commas; in the order given here."""

    def chosen(context: click.Context, option: click.Parameter, value: str) -> list[str]:
        given = {part.strip() for part in value.split(",")}
        for name in sorted(given.difference(names)):
            raise click.BadParameter(f"{name!r} is none of {', '.join(names)}", context, option)
        return [name for name in names if name in given]

    return chosen


def output_options(function: Callable[..., Any]) -> Callable[..., Any]:
    """Adds `-o`, `--csv` and `--png`."""
    options = (
        click.option(
            "-o", "out", type=click.Path(path_type=Path), metavar="OUT",
            help="Write OUT.csv and OUT.png.",
        ),
        click.option(
            "--csv", "csv_path", type=click.Path(path_type=Path), help="Write the CSV file here."
        ),
        click.option(
            "--png", "png_path", type=click.Path(path_type=Path), help="Write the diagram here."
        ),
    )  # fmt: skip
    for option in reversed(options):
        function = option(function)
    return function


def output_files(
    out: Path | None, csv_path: Path | None, png_path: Path | None
) -> tuple[Path | None, Path | None]:
    """Where the CSV file and the diagram go; NS0745 where that is one place."""
    if out is not None:
        csv_path = csv_path or out.with_name(out.name + ".csv")
        png_path = png_path or out.with_name(out.name + ".png")
    refuse_same([path for path in (csv_path, png_path) if path is not None], "--csv and --png")
    return csv_path, png_path


def write_files(
    files: tuple[Path | None, Path | None], csv: Callable[[], str], png: Callable[[], bytes]
) -> None:
    """Write those products that have a place, and say so."""
    csv_path, png_path = files
    products: dict[Path, Product] = {}
    if csv_path is not None:
        products[csv_path] = csv().encode()
    if png_path is not None:
        products[png_path] = png()
    write_together(products)
    if products:
        done("wrote " + ", ".join(path.as_posix() for path in products))
