"""`nscc evaluate NAME --data DIR --protocol P`: evaluate a run or a baseline by name."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc.diagnostics.suggest import meant
from nscc_training.evaluation.baselines import BASELINES, evaluate_baseline
from nscc_training.evaluation.looks_rows import LOOKING, evaluate_looks
from nscc_training.evaluation.runs import evaluate_run
from nscc_training.protocols import load_protocol
from nscc_training.run_files import run_path
from nscc_training.run_folder import load_run


def evaluate(
    subject: str, data: Path, protocol: str, seed: int, *,
    trust_code: bool = False, skip_seen: bool = False, codes: str = "",
    effects: str = "", changes: Sequence[str] = (),
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:  # fmt: skip
    """Return the result of a baseline or of a run, and its arrays by name.

    `subject` is a baseline, a run folder, or a run that comes with nscc. `trust_code` is as in
    `load_run`, `skip_seen` as in `evaluate_run`. `effects` and `changes` apply to runs and to
    pixels that look. `codes` names other shutters for a baseline (`named_codes`).

    Raises Rejected: NS0806 for the protocol, NS0810 for an unknown subject, NS0840 for codes and
    NS0841 for effects that the subject does not support, NS0811 for a folder without suitable data,
    and the errors of `load_run` and `evaluate_run`."""
    chosen = load_protocol(protocol)
    known = (*BASELINES.get(chosen.name, ()), *(LOOKING if chosen.still else ()))
    if subject in LOOKING and chosen.still:
        _refuse_codes(codes, subject)
        return evaluate_looks(subject, data, seed, effects, changes)
    if subject in known:
        if effects or changes:
            raise rejected(
                "NS0841", f"the baseline {subject} has no program, so effects of a chip cannot be "
                    "applied",
                notes=("its codes are exposed with the fixed sensor of the protocol",),
                helps=("name a run folder of nscc train, or leave --effects out",),
            )  # fmt: skip
        return evaluate_baseline(chosen, subject, data, seed, codes)
    run = run_path(Path(subject))
    if run.is_dir():
        _refuse_codes(codes, f"the run '{subject[:60]}'")
        folder = load_run(run, trust_code=trust_code)
        return evaluate_run(
            folder, data, chosen, seed, skip_seen=skip_seen, effects=effects, changes=changes
        )
    raise rejected(
        "NS0810",
        f"'{subject[:60]}' cannot be evaluated under protocol {chosen.name}: unknown "
        "baseline or run",
        notes=(f"its baselines are {', '.join(known)}",) if known else (),
        helps=meant(subject, known, "name one of them, or a run folder of nscc train")
        if known
        else ("name a run folder; `nscc evaluate sci8 CLIP.mat` evaluates the baselines",),
    )


def _refuse_codes(codes: str, subject: str) -> None:
    """Raise Rejected (NS0840) if other codes are given for a subject with fixed codes."""
    if codes:
        raise rejected("NS0840", f"{subject} has fixed codes", helps=("leave --shutter out",))
