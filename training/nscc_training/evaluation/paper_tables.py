"""Tables 2, 3 and 4 of the paper, with our results beside its rows.

`{{TABLE LABEL PSNR SSIM NAME [REMARK]}}` in `tables.md` is a row, with arguments split as in a
shell. PSNR and SSIM are those of the paper, - if it has none. NAME is a result file without .json;
* in it matches the results of several seeds."""

from __future__ import annotations

import re
import shlex
from importlib.resources import files
from pathlib import Path

from nscc.diagnostics.diagnostic import rejected
from nscc.mappings import JsonObject
from nscc_training.evaluation.results import mean_of, read_result
from nscc_training.run_files import WEIGHTS, shipped_evaluations

NOT_RUN = "not run"


def paper_tables(results: Path | None = None) -> tuple[list[JsonObject], str]:
    """Return the rows of the tables as JSON values, and the tables as Markdown.

    `results` is the folder of a sweep, or its folder `results`; None takes the results that come
    with nscc. Raises Rejected (NS0807) for a folder that does not exist."""
    folder = shipped_evaluations() if results is None else results
    if not folder.is_dir():
        hint = "`nscc sweep GRID.toml --out DIR` makes one"
        raise rejected("NS0807", f"'{folder}' is not a folder of results", helps=(hint,))
    folder = folder / "results" if (folder / "results").is_dir() else folder
    rows: list[JsonObject] = []

    def filled(match: re.Match[str]) -> str:
        """Return the Markdown line of the row that `match` is the placeholder of, and append its
        values to `rows`."""
        row, line = _row(folder, *shlex.split(match[1]))
        rows.append(row)
        return line

    page = (files("nscc_training.evaluation") / "tables.md").read_text(encoding="utf-8")
    return rows, re.sub(r"\{\{(.*?)\}\}", filled, page)


def results_named(folder: Path, name: str) -> list[JsonObject]:
    """Read the result files in `folder` whose names without `.json` match the pattern `name`, in
    which * stands for any text; none match gives an empty list. Raise Rejected (NS0807) for a file
    that is no result. Return them in the order of the file names."""
    return [read_result(path) for path in sorted(folder.glob(f"{name}.json"))]


def dagger(folder: Path, name: str) -> str:
    """Return † if a run of this name lacks weights in the folder `runs` beside the results, so that
    it cannot be loaded; else ""."""
    paths = (path.relative_to(folder).with_suffix("") for path in folder.glob(f"{name}.json"))
    places = (
        folder.parent / "runs" / path.as_posix().removeprefix("every-effect/") for path in paths
    )
    runs = [place for place in places if place.is_dir()]
    return "" if all((run / WEIGHTS).is_file() for run in runs) else "†"


def _row(
    folder: Path, table: str, label: str, psnr_db: str, ssim: str, name: str, remark: str = ""
) -> tuple[JsonObject, str]:
    """Return a row as JSON values, and as a line of Markdown with - for missing values.

    `folder` holds the results. `table` is the table's number as text, `label` names the row,
    `psnr_db` and `ssim` are the paper's as text ("-" for none), `name` is the pattern of the result
    files (* for any text), and `remark` is put at the end."""
    results = results_named(folder, name)
    # Several results of one name differ in their seed; the row has their means.
    settings = [result["settings"] for result in results]
    remarks = [NOT_RUN * (not results), remark]
    if any(s.get("moved") for s in settings):
        moved = (f"{s['moved']} of {s['places']}" for s in settings)
        remarks.append(f"places moved: {', '.join(moved)}")
    row: JsonObject = {
        "table": int(table), "row": label,
        "paper_psnr_db": None if psnr_db == "-" else float(psnr_db),
        "paper_ssim": None if ssim == "-" else float(ssim),
        "psnr_db": mean_of(results, "psnr_db"), "ssim": mean_of(results, "ssim"),
        "psnr_by_source_db": mean_of(results, "psnr_db", by_source=True),
        "size": settings[0].get("size", "-") if settings else None,
        "steps": max((s.get("steps", 0) for s in settings), default=None),
        "seeds": sorted({s.get("train_seed", s.get("seed", 0)) for s in settings}),
        "protocol": results[0]["protocol"] if results else None,
        "data": [data_file["file"] for data_file in results[0]["data"]] if results else [],
        "remark": "; ".join(filter(None, remarks)),
    }  # fmt: skip
    own, own_ssim, by_source = (
        "-" if value is None else f"{value:.{digits}f}"
        for value, digits in ((row["psnr_db"], 2), (row["ssim"], 3), (row["psnr_by_source_db"], 2))
    )
    cells = (
        f"{label} {dagger(folder, name)}".strip(),
        f"{psnr_db} / {ssim}",
        f"{own} / {own_ssim}" if results else "-",
        by_source,
        str(row["steps"] or "-"),
        ",".join(map(str, row["seeds"])) or "-",
        row["remark"],
    )
    return row, f"| {' | '.join(cells)} |"
