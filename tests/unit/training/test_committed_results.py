"""What is committed of learned shutters: files belong together, programs compile, decoders load."""

from __future__ import annotations

import json
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT

torch = pytest.importorskip("torch")

from nscc.compiler import compile_file  # noqa: E402
from nscc.container_proof import replayed  # noqa: E402
from nscc.pipeline import Options  # noqa: E402
from nscc_training.codes_files import load_codes  # noqa: E402
from nscc_training.loop.setup import make_setup  # noqa: E402
from nscc_training.run_folder import load_run  # noqa: E402
from nscc_training.settings import load_config  # noqa: E402

RESULTS = ROOT / "training" / "results"
SHIPPED = sorted(path.parent for path in (RESULTS / "shipped").rglob("result.json"))
RUNS = SHIPPED + sorted(path.parent for path in (RESULTS / "runs").rglob("result.json"))


def named(run: Path) -> str:
    return run.relative_to(RESULTS).as_posix()


def test_runs_have_weights_where_they_are_shipped() -> None:
    """The repository ships the weights of six runs, and no other result folder has any."""
    assert len(SHIPPED) == 6
    weighed = {path.parent for path in RESULTS.rglob("decoder.safetensors")}
    assert weighed == {*SHIPPED}


@pytest.mark.parametrize("run", RUNS, ids=named)
def test_the_files_of_a_shipped_run_belong_together(run: Path) -> None:
    """The files of a shipped run match its digests, and its program opens the shutters of its
    codes."""
    digests = json.loads((run / "result.json").read_text())["files"]
    present = [name for name in digests if (run / name).is_file()]
    assert "shutter.nsl" in present
    assert ("codes.npz" in present) == ("class-a" not in run.as_posix())
    for name in present:
        assert sha256((run / name).read_bytes()).hexdigest() == digests[name], name
    settings = load_config(run / "config.resolved.toml")
    shutter = settings.shutter
    if "codes.npz" in present:
        shutter = replace(shutter, init=str(run / "codes.npz"))
    # Weights that it began with are of a run that need not be there.
    decoder = replace(settings.decoder, init="")
    encoder = make_setup(replace(settings, shutter=shutter, decoder=decoder)).encoder
    found = compile_file(run / "shutter.nsl", Options(target=settings.shutter.target, level=1))
    container = found.container
    assert container is not None
    assert container.pixel_codes is not None
    opened = replayed(container)
    rows, cols = encoder.spec.tile
    lanes = container.table.shutter_of_code[container.pixel_codes[:rows, :cols]]
    assert np.array_equal(np.moveaxis(opened[:, 0][lanes], -1, 0), encoder.hard().numpy())


@pytest.mark.parametrize("run", SHIPPED, ids=named)
def test_decoders_of_shipped_runs_decode(run: Path) -> None:
    """The shipped weights decode a frame of 48 x 48: finite values of that size, or scores of 8
    classes. The codes file has the encoder's fields."""
    parts = load_run(run).setup
    frame = torch.rand(1, 48, 48, generator=torch.Generator().manual_seed(1))
    with torch.no_grad():
        made = parts.decoder(frame, parts.encoder.hard())
    classes = parts.settings.data.protocol == "class-v1"
    assert made.shape[-2:] == ((1, 8) if classes else (48, 48))
    assert torch.isfinite(made).all()
    assert load_codes(run / "codes.npz").keys() == parts.encoder.codes().keys()


@pytest.mark.parametrize(
    "run",
    [run for run in RUNS if "class-e" in run.as_posix() and "two-bucket" not in run.as_posix()],
    ids=named,
)
def test_runs_of_free_bits_fit_the_smaller_chip(run: Path) -> None:
    """The shutters of class e in results were made for a larger chip. They compile for scamp5 at
    level 1, too."""
    assert compile_file(run / "shutter.nsl", Options(target="scamp5", level=1)).container
