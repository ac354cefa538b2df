"""The table of `nscc evaluate looks`, computed by a sweep."""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path
from typing import Any

from nscc.files import write_together
from nscc.toml.toml_text import written
from nscc_runtime.progress import Progress, unseen
from nscc_training.evaluation.pages import Page
from nscc_training.evaluation.results import read_result
from nscc_training.protocol_scenes.file_scenes import files_of
from nscc_training.protocols import load_protocol
from nscc_training.sweep.grid import read_grid
from nscc_training.sweep.run_sweep import How, sweep


def looks_table(
    data: Path, out: Path, seed: int = 0, track: Progress = unseen
) -> tuple[list[dict[str, Any]], str]:
    """Return the results of hdr-v1 for pixels that look, under all conditions, and a Markdown
    table.

    `out` is the folder of a sweep, which resumes if interrupted. Raises Rejected (NS0811) if `data`
    contains no panoramas."""
    files_of(load_protocol("hdr-v1"), data)
    package = files("nscc_training.sweep")
    text = (package / "looks.toml").read_text(encoding="utf-8")
    text = text.replace(written("DATA"), written(str(data.resolve())))
    out.mkdir(parents=True, exist_ok=True)
    grid = out / "looks.toml"
    write_together({grid: text.replace("seed = 0", f"seed = {seed}").encode()})
    sweep(read_grid(grid), out, How(), track=track)
    page = Page(out / "results")
    shown = page.filled((package / "looks.md").read_text(encoding="utf-8"))
    return [read_result(path) for path in sorted(page.results.glob("*/*.json"))], shown
