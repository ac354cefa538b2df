"""The paper's Tables 2, 3 and 4, row by row, with what this installation has measured beside them.

Absolute decibels compare only on the paper's own data, which is not public: differences between
rows are what can be compared.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from nscc.diagnostics.model import Rejected
from nscc_training.evaluation.hdr import ENDINGS
from nscc_training.evaluation.subjects import evaluate
from nscc_training.measures import number
from nscc_training.protocols import load_protocol
from nscc_training.run_folder import RunFolder, load_run
from nscc_training.settings import Settings


@dataclass(frozen=True)
class Row:
    """A row of a table: the paper's PSNR in dB and SSIM, None for rows of our own.

    `baseline` names a subject of `nscc evaluate`; otherwise `key` (decoder, class, codes) says
    which runs belong here.
    """

    table: int
    name: str
    paper: tuple[float, float] | None
    baseline: str = ""
    key: tuple[str, str, str] | None = None
    remark: str = ""

    @property
    def protocol(self) -> str:
        """The protocol of its table."""
        return "hdr-v1" if self.table == 2 else "video-v1"


ROWS: tuple[Row, ...] = (
    Row(2, "no coding (LDR)", (13.65, 0.2834), "ldr"),
    Row(2, "random code, convolutional sparse coding", (28.71, 0.6476), "sparse-coding"),
    Row(2, "random code, U-Net", (32.76, 0.8904), key=("unet2d", "b", "random")),
    Row(2, "learned code, U-Net", (35.42, 0.9464), key=("unet2d", "b", "learned")),
    Row(2, "best uniform stop, merged", None, "best-uniform"),
    Row(2, "best uniform stop in mu-law, merged", None, "best-uniform-mu"),
    Row(2, "2 x 2 pattern, merged", None, "quad"),
    Row(2, "2 x 2 pattern, U-Net", None, key=("unet2d", "b", "quad")),
    Row(3, "FC-net, c fixed", (27.73, 0.9445), key=("fcnet", "c", "fixed")),
    Row(3, "FC-net, c learned", (27.78, 0.9449), key=("fcnet", "c", "learned")),
    Row(3, "FC-net, d fixed", (27.85, 0.9443), key=("fcnet", "d", "fixed")),
    Row(3, "FC-net, d learned", (28.16, 0.9449), key=("fcnet", "d", "learned")),
    Row(3, "FC-net, e random", (28.02, 0.9430), key=("fcnet", "e", "random")),
    Row(3, "FC-net, e learned", (28.78, 0.9502), key=("fcnet", "e", "learned")),
    Row(3, "3D U-Net, c fixed", (32.67, 0.9225), key=("unet3d", "c", "fixed")),
    Row(3, "3D U-Net, c learned", (32.87, 0.9272), key=("unet3d", "c", "learned")),
    Row(3, "3D U-Net, e random", (32.19, 0.9254), key=("unet3d", "e", "random")),
    Row(3, "3D U-Net, e learned", (33.56, 0.9374), key=("unet3d", "e", "learned"),
        remark="16 bits, more than its own chip has"),
    Row(3, "3D U-Net, codebook learned", None, key=("unet3d", "codebook", "learned")),
    Row(3, "3D U-Net, codebook, words in the loss", None, key=("unet3d", "codebook", "words")),
    Row(3, "3D U-Net, 2 x 2 pattern", None, key=("unet3d", "c", "quad")),
    Row(3, "2D U-Net, d random", None, key=("unet2d", "d", "random")),
    Row(3, "2D U-Net, d learned", None, key=("unet2d", "d", "learned")),
    Row(3, "2D U-Net, d, 2 x 2 pattern", None, key=("unet2d", "d", "quad")),
    Row(4, "bilinear (sees the truth)", (18.95, 0.4133), "bilinear"),
    Row(4, "thin-out (sees the truth)", (20.65, 0.4556), "thin-out"),
    Row(4, "dictionary, e random", (26.22, 0.7258), "dictionary"),
    Row(4, "FC-net, c learned", (38.14, 0.9555), key=("fcnet", "c", "learned"),
        remark="the paper's Table 3 has 27.78: unexplained, no target"),
    Row(4, "3D U-Net, c learned", (32.40, 0.8118), key=("unet3d", "c", "learned")),
    Row(4, "GAP-TV, e random", None, "gap-tv"),
)  # fmt: skip


def key_of(settings: Settings) -> tuple[str, str, str]:
    """The row that a run belongs to: decoder, class, and what became of its codes."""
    shutter = settings.shutter
    codes = "learned"
    if not shutter.learn:
        codes = shutter.init if shutter.init in ("random", "quad") else "fixed"
    elif shutter.words_weight > 0:
        codes = "words"
    return settings.decoder.name, shutter.kind, codes


def tables(
    data: Path, runs: Path | None, track: Callable[[Sequence[Row]], Any] = lambda rows: rows
) -> list[dict[str, Any]]:
    """Every row as JSON values: the paper's numbers, ours, and what they were made with.

    `data` holds panoramas and clips, or folders `hdr` and `video` of them; `runs` holds run
    folders. Runs of one row are its seeds. What was not run has `psnr_db` None and says why.
    """
    found = _runs(runs)
    done: dict[str, dict[str, Any]] = {}
    return [_row(row, data, found, done) for row in track(ROWS)]


def _runs(folder: Path | None) -> list[RunFolder]:
    if folder is None or not folder.is_dir():
        return []
    places = sorted(p for p in folder.iterdir() if (p / "result.json").is_file())
    return [load_run(place) for place in places]


def _row(
    row: Row, data: Path, runs: list[RunFolder], done: dict[str, dict[str, Any]]
) -> dict[str, Any]:
    made: dict[str, Any] = {
        "table": row.table,
        "row": row.name,
        "paper_psnr_db": row.paper[0] if row.paper else None,
        "paper_ssim": row.paper[1] if row.paper else None,
        "psnr_db": None, "ssim": None, "size": None, "steps": None, "seeds": [],
        "protocol": row.protocol, "data": [], "remark": row.remark,
    }  # fmt: skip
    folder = _folder(data, row.protocol)
    mine = [run for run in runs if belongs(run, row)]
    subjects = [row.baseline] if row.baseline else [str(run.path) for run in mine]
    if not subjects or folder is None:
        reason = "not run: no data" if subjects else "not run"
        made["remark"] = f"{reason}; {row.remark}" if row.remark else reason
        return made
    results = []
    for subject in subjects:
        name = f"{subject} {row.protocol}"
        if name not in done:
            try:
                done[name] = evaluate(subject, folder, row.protocol, 0)[0]
            except Rejected as refused:
                made["remark"] = f"not run: {refused.diagnostics[0].message}"
                return made
        results.append(done[name])
    means = [found["mean"] for found in results if found["mean"] is not None]
    similar = [np.mean([item["ssim"] for item in found["items"]]) for found in results]
    settings = [run.parts.settings for run in mine]
    made["psnr_db"] = float(np.mean([number(mean) for mean in means])) if means else None
    made["ssim"] = float(np.mean(similar))
    made["seeds"] = sorted({s.train.seed for s in settings}) or [0]
    made["size"] = settings[0].decoder.size if settings else "-"
    made["steps"] = max((s.train.steps for s in settings), default=0)
    made["data"] = [entry["file"] for entry in results[0]["data"]]
    made["protocol_sha256"] = results[0]["protocol_sha256"]
    return made


def belongs(run: RunFolder, row: Row) -> bool:
    """Whether a run is one of a row: it has its key, and its protocol's number of slots."""
    protocol = load_protocol(row.protocol)
    slots = protocol["slots" if row.protocol == "hdr-v1" else "frames"]
    parts = run.parts
    return (
        row.key is not None
        and key_of(parts.settings) == row.key
        and parts.still == (row.protocol == "hdr-v1")
        and parts.slots == slots
    )


def _folder(data: Path, protocol: str) -> Path | None:
    """The folder with a protocol's scenes; None where there are none."""
    from nscc_runtime.scenes.clips import CLIPS

    name, endings = ("hdr", ENDINGS) if protocol == "hdr-v1" else ("video", (*CLIPS, ".mat"))
    for folder in (data / name, data):
        if folder.is_dir() and any(p.suffix.lower() in endings for p in folder.iterdir()):
            return folder
    return None


def text_of(rows: list[dict[str, Any]]) -> str:
    """The tables as text."""
    lines: list[str] = []
    titles = {2: "HDR stills", 3: "16 frames from one exposure", 4: "the same, other methods"}
    for table, title in titles.items():
        lines += ["", f"Table {table}: {title}"] if lines else [f"Table {table}: {title}"]
        lines.append(
            f"  {'row':42} {'paper':>14}  {'here':>14}  {'size':6} {'steps':>6} {'seeds':7} remark"
        )
        for row in rows:
            if row["table"] == table:
                lines.append(_line(row))
    lines += [
        "", "PSNR in dB / SSIM. The paper's were measured on its own data: compare differences "
        "between rows.",
    ]  # fmt: skip
    return "\n".join(lines) + "\n"


def _line(row: dict[str, Any]) -> str:
    def pair(first: float | None, second: float | None) -> str:
        return "-" if first is None or second is None else f"{first:.2f} / {second:.4f}"

    seeds = ",".join(map(str, row["seeds"])) or "-"
    count = len(row["data"])
    data = f"{count} file{'s' if count > 1 else ''}" if count else ""
    remark = "; ".join(part for part in (data, row["remark"]) if part)
    return (
        f"  {row['row']:42} {pair(row['paper_psnr_db'], row['paper_ssim']):>14}  "
        f"{pair(row['psnr_db'], row['ssim']):>14}  {row['size'] or '-':6} "
        f"{row['steps'] if row['steps'] is not None else '-':>6} {seeds:7} {remark}"
    ).rstrip()
