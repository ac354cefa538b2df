"""`nscc metrics`: how far a reconstruction is from the truth, nothing else."""

from __future__ import annotations

import json
from hashlib import sha256
from pathlib import Path
from typing import Any

import click

from nscc.files import write_whole
from nscc_cli.support import CommonCommand, NumberRange


@click.command("metrics", cls=CommonCommand)
@click.argument("truth", type=click.Path(path_type=Path))
@click.argument("result", metavar="REC", type=click.Path(path_type=Path))
@click.option(
    "--data-range",
    type=float,
    required=True,
    metavar="R",
    help="The peak that errors count against: 255 for 8-bit values, 1 for values on [0, 1].",
)
@click.option("--truth-key", help="Which array of TRUTH, where it holds several.")
@click.option("--rec-key", help="Which array of REC, where it holds several.")
@click.option(
    "--nits",
    type=NumberRange(0.005, 10000.0, min_open=True),
    default=1000.0,
    show_default=True,
    help="The luminance in cd/m2 that R stands for, in PU21-PSNR.",
)
@click.option("--json", "as_json", is_flag=True, help="Print JSON, every frame of a clip too.")
@click.option("-o", "out", type=click.Path(path_type=Path), help="Write the JSON to a file.")
def command(
    truth: Path,
    result: Path,
    data_range: float,
    truth_key: str | None,
    rec_key: str | None,
    nits: float,
    as_json: bool,
    out: Path | None,
) -> None:
    """Compare REC with TRUTH: pictures (rows, cols) or clips (T, rows, cols).

    PSNR, SSIM, mu-law PSNR (5000), PU21-PSNR and, of clips, the temporal error. Values are taken
    as they are stored; mu-law and PU21 clip them to 0..R.
    """
    from nscc_training.array_files import read_picture_or_clip
    from nscc_training.measures import check_data_range, check_pair, measures

    check_data_range(data_range)
    arrays = [
        read_picture_or_clip(path, key) for path, key in ((truth, truth_key), (result, rec_key))
    ]
    check_pair(arrays[0], arrays[1])
    found = {
        "truth": {"file": truth.name, "sha256": sha256(truth.read_bytes()).hexdigest()},
        "result": {"file": result.name, "sha256": sha256(result.read_bytes()).hexdigest()},
        "shape": list(arrays[0].shape),
        "data_range": data_range,
        "nits": nits,
        **measures(arrays[0], arrays[1], data_range, nits),
    }
    text = json.dumps(found, indent=2, allow_nan=False) + "\n"
    if out is not None:
        write_whole(out, text.encode())
    click.echo(text if as_json else _lines(found), nl=False)


def _lines(found: dict[str, Any]) -> str:
    """The numbers, one a line."""
    rows = [
        ("PSNR", "psnr_db", " dB"),
        ("PSNR of the mean error", "psnr_of_mean_mse_db", " dB"),
        ("SSIM", "ssim", ""),
        ("PSNR, mu-law 5000", "mu_psnr_db", " dB"),
        (f"PSNR, PU21, {found['nits']:g} cd/m2", "pu21_psnr_db", " dB"),
        ("temporal error", "temporal_error", ""),
    ]
    lines = [f"data range {found['data_range']:g}, {' x '.join(map(str, found['shape']))}"]
    for name, key, unit in rows:
        value = found[key]
        if value is not None:
            text = value if isinstance(value, str) else f"{value:.4f}"
            lines.append(f"  {name:28}{text}{unit}")
    if found["infinite"]:
        lines.append(f"  {found['infinite']} frames without any error are left out of the mean")
    return "\n".join(lines) + "\n"
