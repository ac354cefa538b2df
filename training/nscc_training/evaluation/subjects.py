"""`nscc evaluate NAME --data DIR --protocol P`: who can be evaluated under which protocol."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc.diagnostics.suggest import meant
from nscc_training.evaluation import (
    deblur,
    hdr_baselines,
    hdr_looks,
    several_frames,
    video_baselines,
)
from nscc_training.evaluation.runs import evaluate_run
from nscc_training.protocols import load_protocol
from nscc_training.run_files import run_path
from nscc_training.run_folder import load_run

_OF_PROTOCOL = {
    "hdr-v1": (*hdr_baselines.BASELINES, *hdr_looks.LOOKING),
    "video-v1": video_baselines.BASELINES,
    "deblur-v1": deblur.BASELINES,
    **{protocol: tuple(rows) for protocol, rows in several_frames.ROWS.items()},
}


def evaluate(
    subject: str, data: Path, protocol: str, seed: int, *,
    trust_code: bool = False, skip_seen: bool = False, codes: str = "",
    effects: str = "",
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:  # fmt: skip
    """The result of a baseline or of a run, and the arrays it made, by name.

    A run is a folder or the name of one that comes with nscc. Of it, `trust_code` is as
    `load_run`'s, `skip_seen` and `effects` as `evaluate_run`'s; of a baseline `codes` names other
    shutters than its own, see `codes_named`.
    Raises Rejected: NS0806 for the protocol, NS0810 for a subject that it does not know, NS0840
    for codes that it does not take, NS0841 for effects of what has none, NS0811 for a folder
    without its data, and what `load_run` and `evaluate_run` raise.
    """
    chosen = load_protocol(protocol)
    known = _OF_PROTOCOL.get(chosen.name, ())
    if subject in known:
        if effects:
            raise rejected(
                "NS0841", f"the baseline {subject} has no chip that effects are of",
                notes=("its codes are exposed by the sensor that the protocol fixes",),
                helps=("name a run folder of nscc train, or leave --effects out",),
            )  # fmt: skip
        if chosen.name == "hdr-v1":
            if subject in hdr_looks.LOOKING and not codes:
                return hdr_looks.evaluate_looks(subject, data, seed)
            return hdr_baselines.evaluate_hdr_baseline(subject, data, seed, codes)
        if chosen.name == "deblur-v1":
            return deblur.evaluate_deblur(subject, data, seed, codes)
        if chosen.name in several_frames.ROWS:
            if codes:
                raise rejected(
                    "NS0840", f"{subject} has codes of its own", helps=("leave --shutter out",)
                )
            return several_frames.evaluate_several(chosen.name, subject, data, seed)
        return video_baselines.evaluate_video_baseline(subject, data, seed, codes)
    run = run_path(Path(subject))
    if run.is_dir():
        if codes:
            raise rejected(
                "NS0840", f"the run '{subject[:60]}' has codes of its own",
                notes=("its decoder knows those alone",), helps=("leave --shutter out",),
            )  # fmt: skip
        folder = load_run(run, trust_code=trust_code)
        return evaluate_run(folder, data, chosen, seed, skip_seen=skip_seen, effects=effects)
    raise rejected(
        "NS0810",
        f"there is no '{subject[:60]}' to evaluate under protocol {chosen.name}",
        notes=(f"its baselines are {', '.join(known)}",) if known else (),
        helps=meant(subject, known, "name one of them, or a run folder of nscc train")
        if known
        else ("name a run folder; `nscc evaluate sci8 CLIP.mat` evaluates the baselines",),
    )
