"""The paper's Tables 2, 3 and 4, row by row, with what this installation has measured beside them.

Absolute decibels compare only on the paper's own data, which is not public: differences between
rows are what can be compared.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.files import file_sha256, write_together
from nscc_training.config import load_config
from nscc_training.evaluation.hdr import ENDINGS
from nscc_training.evaluation.result_text import result_json
from nscc_training.evaluation.results import mean_of, read_result
from nscc_training.evaluation.runs import Key, key_of
from nscc_training.evaluation.subjects import evaluate
from nscc_training.protocols import load_protocol
from nscc_training.run_files import shipped_evaluations
from nscc_training.scene_files import CLIPS, files_in
from nscc_training.settings import Settings


@dataclass(frozen=True)
class Row:
    """A row of a table: the paper's PSNR in dB and SSIM, None for rows of our own.

    `baseline` names a subject of `nscc evaluate`, `codes` its shutters if not its own; otherwise
    `key` (decoder, class, codes) says which runs belong here.
    """

    table: int
    name: str
    paper: tuple[float, float] | None
    baseline: str = ""
    codes: str = ""
    key: Key | None = None
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
    Row(2, "2 x 2 pattern, the decoder for any code", None, "any"),
    Row(2, "2 x 2 pattern, U-Net", None, key=("unet2d", "b", "quad")),
    Row(3, "FC-net, c fixed", (27.73, 0.9445), key=("fcnet", "c", "quad"),
        remark="the 2 x 2 pattern"),
    Row(3, "FC-net, c learned", (27.78, 0.9449), key=("fcnet", "c", "learned")),
    Row(3, "FC-net, d fixed", (27.85, 0.9443), key=("fcnet", "d", "quad"),
        remark="the 2 x 2 pattern"),
    Row(3, "FC-net, d learned", (28.16, 0.9449), key=("fcnet", "d", "learned")),
    Row(3, "FC-net, e random", (28.02, 0.9430), key=("fcnet", "e", "random")),
    Row(3, "FC-net, e learned", (28.78, 0.9502), key=("fcnet", "e", "learned")),
    Row(3, "3D U-Net, c fixed", (32.67, 0.9225), key=("unet3d", "c", "quad"),
        remark="the 2 x 2 pattern"),
    Row(3, "3D U-Net, c learned", (32.87, 0.9272), key=("unet3d", "c", "learned")),
    Row(3, "3D U-Net, e random", (32.19, 0.9254), key=("unet3d", "e", "random")),
    Row(3, "3D U-Net, e learned", (33.56, 0.9374), key=("unet3d", "e", "learned"),
        remark="a tile of 64 codes: 6 bits a pixel"),
    Row(3, "3D U-Net, codebook learned", None, key=("unet3d", "codebook", "learned")),
    Row(3, "3D U-Net, codebook, words in the loss", None, key=("unet3d", "codebook", "words")),
    Row(3, "3D U-Net, d random", None, key=("unet3d", "d", "random")),
    Row(3, "3D U-Net, d learned", None, key=("unet3d", "d", "learned")),
    Row(3, "3D U-Net, d, 2 x 2 pattern", None, key=("unet3d", "d", "quad")),
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
    Row(4, "GAP-TV, c, 2 x 2 pattern", None, "gap-tv", "c:quad"),
    Row(4, "the decoder for any code, e random", None, "any"),
    Row(4, "the decoder for any code, c, 2 x 2 pattern", None, "any", "c:quad"),
)  # fmt: skip


def tables(
    data: Path | None = None,
    runs: Path | None = None,
    results: Path | None = None,
    track: Callable[[Sequence[Row]], Any] = lambda rows: rows,
) -> list[dict[str, Any]]:
    """Every row as JSON values: the paper's numbers, ours, and what they were made with.

    `results` holds what `nscc evaluate` wrote; without it and `data` those that come with nscc.
    `data` holds panoramas and clips, or folders `hdr` and `video` of them; on it baselines and
    run folders in `runs` are evaluated that are not among the results, and each is written into
    `results`, if named, as soon as it is done. Results are shown if they are of the data's files
    or, without data, of the files that most are of. Runs of one row are its seeds; where decoders
    of several sizes were run, the row is there once for each. A row that was not run has `psnr_db`
    None and says why in its `remark`. Rejected (NS0811, NS0818, NS0807) for folders that there are
    not.
    """
    if data is not None:
        hint = "name a folder of panoramas and clips, or with folders hdr and video of them"
        _check_folder(data, "NS0811", "data", hint)
    if results is None and data is None:
        results = shipped_evaluations()
    held = _held(results)
    names = ("hdr-v1", "video-v1")
    if data is None:
        places = {name: _Place.of_most(held, name) for name in names}
    else:
        places = {name: _Place.of(data, name) for name in names}
    held = [found for found in held if places[found["protocol"]].digests == _digests(found)]
    known = {_config(found) for found in held}
    fresh = [run for run in _runs(runs) if run.config_sha256 not in known]
    table = _Filled(places, fresh, held, results)
    return [each for row in track(ROWS) for each in table.rows(row)]


@dataclass(frozen=True)
class _Place:
    """A folder with a protocol's scenes, None where there is none, and the digests of its files."""

    folder: Path | None
    digests: frozenset[str]

    @classmethod
    def of(cls, data: Path, protocol: str) -> _Place:
        name, endings = ("hdr", ENDINGS) if protocol == "hdr-v1" else ("video", CLIPS)
        for folder in (data / name, data):
            if files := files_in(folder, endings):
                digests = frozenset(file_sha256(path) for path in files)
                return cls(folder, digests)
        return cls(None, frozenset())

    @classmethod
    def of_most(cls, held: Sequence[dict[str, Any]], protocol: str) -> _Place:
        found = Counter(_digests(each) for each in held if each["protocol"] == protocol)
        return cls(None, found.most_common(1)[0][0] if found else frozenset())


def _held(folder: Path | None) -> list[dict[str, Any]]:
    """The results in a folder that are of the protocols of tables, as these are today, exposed by
    the sensor that they fix."""
    if folder is None:
        return []
    _check_folder(folder, "NS0807", "results", "`nscc evaluate ... -o DIR/NAME.json` writes them")
    protocols = {name: load_protocol(name).sha256 for name in ("hdr-v1", "video-v1")}
    every = [read_result(path) for path in sorted(folder.glob("*.json"))]
    return [
        found for found in every
        if found.get("protocol_sha256") == protocols.get(str(found.get("protocol")), "")
        and not found.get("settings", {}).get("effects")
    ]  # fmt: skip


def _digests(found: dict[str, Any]) -> frozenset[str]:
    return frozenset(str(entry["sha256"]) for entry in found.get("data", ()))


def _check_folder(folder: Path, code: str, what: str, hint: str) -> None:
    if not folder.is_dir():
        raise rejected(code, f"'{folder}' is no folder of {what}", helps=(hint,))


def _config(found: dict[str, Any]) -> object:
    return found.get("settings", {}).get("config_sha256")


class _Run(NamedTuple):
    """A run folder that may be evaluated: its configuration and that file's digest."""

    path: Path
    settings: Settings
    config_sha256: str


def _runs(folder: Path | None) -> list[_Run]:
    if folder is None:
        return []
    hint = "name the folder in which the run folders of nscc train are"
    _check_folder(folder, "NS0818", "runs", hint)
    found = []
    for place in sorted(p for p in folder.iterdir() if (p / "result.json").is_file()):
        file = place / "config.resolved.toml"
        found.append(_Run(place, load_config(file), file_sha256(file)))
    return found


@dataclass
class _Filled:
    """Where rows get their results from: `held` ones, and `fresh` runs on the scenes of `places`;
    what is evaluated is held from then on, and kept in the folder `keep` unless that is None."""

    places: Mapping[str, _Place]
    fresh: list[_Run]
    held: list[dict[str, Any]]
    keep: Path | None

    def rows(self, row: Row) -> list[dict[str, Any]]:
        """A row as `tables` has it: once, or once for each size of the decoders that were run."""
        results, refused = self._results(row)
        if not results:
            reason = "not run: " + (refused[0] if refused else self._why_not(row))
            return [_made(row, [], [reason, row.remark])]
        sizes = dict.fromkeys(_size(found) for found in results)
        made = []
        for size in sorted(sizes, key=lambda size: size == "paper"):
            mine = [found for found in results if _size(found) == size]
            made.append(_made(row, mine, [row.remark, _moved(row, mine), *refused]))
        return made

    def _results(self, row: Row) -> tuple[list[dict[str, Any]], list[str]]:
        """The results of a row, and why others of its subjects have none."""
        place = self.places[row.protocol]
        mine = [
            each for each in self.held if each["protocol"] == row.protocol and _is_of(each, row)
        ]
        if place.folder is None:
            return mine, []
        runs = {str(run.path): run for run in self.fresh if _belongs(run.settings, row)}
        refused = []
        for subject in [row.baseline] if row.baseline and not mine else runs:
            try:
                found, _ = evaluate(subject, place.folder, row.protocol, 0, codes=row.codes)
            except Rejected as refusal:
                why = refusal.diagnostics[0]
                refused.append(", ".join([why.message, *why.notes[:1]]))
                continue
            mine.append(found)
            self._hold(found, subject, row)
            if subject in runs:
                self.fresh.remove(runs[subject])
        return mine, refused

    def _hold(self, found: dict[str, Any], subject: str, row: Row) -> None:
        self.held.append(found)
        if self.keep is not None:
            name = "-".join([Path(subject).name, *row.codes.split(":")]).rstrip("-")
            write_together({self.keep / f"{name}.json": result_json(found).encode()})

    def _why_not(self, row: Row) -> str:
        if row.key is not None:
            decoder, kind, codes = row.key
            return f"no run of {decoder}, class {kind}, codes {codes}"
        return "no data" if self.places[row.protocol].folder is None else "no result"


def _made(row: Row, results: Sequence[dict[str, Any]], remarks: Sequence[str]) -> dict[str, Any]:
    """A row of `results` of one size, or of none."""
    made: dict[str, Any] = {
        "table": row.table,
        "row": row.name,
        "paper_psnr_db": row.paper[0] if row.paper else None,
        "paper_ssim": row.paper[1] if row.paper else None,
        "psnr_db": None, "psnr_by_source_db": None, "ssim": None, "size": None, "steps": None,
        "seeds": [], "protocol": row.protocol, "data": [],
        "remark": "; ".join(filter(None, remarks)),
    }  # fmt: skip
    if results:
        settings = [found["settings"] for found in results]
        made["psnr_db"] = mean_of(results, "psnr_db")
        made["psnr_by_source_db"] = mean_of(results, "psnr_db", by_source=True)
        made["ssim"] = mean_of(results, "ssim")
        made["seeds"] = sorted({s.get("train_seed", s.get("seed", 0)) for s in settings})
        made["size"] = _size(results[0])
        made["steps"] = max(s.get("steps", 0) for s in settings)
        made["data"] = [entry["file"] for entry in results[0]["data"]]
        made["protocol_sha256"] = results[0]["protocol_sha256"]
    return made


def _size(found: Mapping[str, Any]) -> str:
    return str(found["settings"].get("size", "-"))


def _moved(row: Row, results: Sequence[dict[str, Any]]) -> str:
    """How many places left their start, for rows of learned codes: where none did, nothing was."""
    settings = [found["settings"] for found in results]
    if row.key is None or row.key[2] not in ("learned", "words"):
        return ""
    moved = [f"{s['moved']} of {s['places']}" for s in settings if s.get("moved") is not None]
    return f"places moved: {', '.join(moved)}" if moved else ""


def _is_of(found: dict[str, Any], row: Row) -> bool:
    if row.key is None:
        same = found["method"] == row.baseline and found["settings"].get("shutter", "") == row.codes
        return _config(found) is None and same
    return tuple(found["settings"].get("row", ())) == row.key


def _belongs(settings: Settings, row: Row) -> bool:
    """Whether a run is one of a row: it has its key, kind of scene and number of slots."""
    protocol = load_protocol(row.protocol)
    slots = protocol["slots" if row.protocol == "hdr-v1" else "frames"]
    return (
        row.key is not None
        and key_of(settings) == row.key
        and (settings.data.protocol == "hdr-v1") == (row.protocol == "hdr-v1")
        and settings.shutter.slots == slots
    )


def text_of(rows: list[dict[str, Any]]) -> str:
    """The tables as text."""
    lines: list[str] = []
    titles = {2: "HDR stills", 3: "16 frames from one exposure", 4: "the same, other methods"}
    for table, title in titles.items():
        lines += ["", f"Table {table}: {title}"] if lines else [f"Table {table}: {title}"]
        lines.append(
            f"  {'row':42} {'paper':>14}  {'here':>14}  {'source':>6}  {'size':6} {'steps':>6} "
            f"{'seeds':7} remark"
        )
        lines += [_line(row) for row in rows if row["table"] == table]
    lines += [
        "", "PSNR in dB / SSIM, means over crops or windows; under `source` the PSNR with every "
        "file counting once.",
        "The paper's were measured on its own data: compare differences between rows.",
    ]  # fmt: skip
    return "\n".join(lines) + "\n"


def _line(row: dict[str, Any]) -> str:
    def pair(first: float | None, second: float | None) -> str:
        return "-" if first is None or second is None else f"{first:.2f} / {second:.4f}"

    seeds = ",".join(map(str, row["seeds"])) or "-"
    count = len(row["data"])
    data = f"{count} file{'s' if count > 1 else ''}" if count else ""
    remark = "; ".join(part for part in (data, row["remark"]) if part)
    source = "-" if row["psnr_by_source_db"] is None else f"{row['psnr_by_source_db']:.2f}"
    return (
        f"  {row['row']:42} {pair(row['paper_psnr_db'], row['paper_ssim']):>14}  "
        f"{pair(row['psnr_db'], row['ssim']):>14}  {source:>6}  "
        f"{row['size'] or '-':6} {row['steps'] if row['steps'] is not None else '-':>6} "
        f"{seeds:7} {remark}"
    ).rstrip()
