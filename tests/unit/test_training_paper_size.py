"""training/results/paper_size.py: it goes on where it stopped, and does nothing twice."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from typing import Any

import pytest

torch = pytest.importorskip("torch")

from small_runs import one_crop, trained  # noqa: E402

SCRIPT = Path(__file__).resolve().parents[2] / "training/results/paper_size.py"


@pytest.fixture
def script(monkeypatch: pytest.MonkeyPatch) -> Any:
    """The script, with one run of six steps that a machine of any size can make."""
    spec = importlib.util.spec_from_file_location("paper_size", SCRIPT)
    assert spec is not None
    assert spec.loader is not None
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    small = {
        "shutter": {"slots": 256, "tile": [2, 2], "learn": False},
        "data": {"patch": 16, "scenes": 2, "val_items": 1},
        "train": {"steps": 6, "batch": 1, "validate_every": 2, "device": "cpu"},
    }
    monkeypatch.setattr(made, "RUNS", {"one": ()})
    monkeypatch.setattr(made, "values_of", lambda *_: small)
    made.small = small
    return made


@pytest.mark.slow
def test_it_goes_on(
    script: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "hdr_test").mkdir()
    one_crop(tmp_path / "hdr_test/p.hdr")
    out = tmp_path / "out"
    monkeypatch.setattr(sys, "argv", ["paper_size.py", str(tmp_path), str(out)])
    left = iter([True, True, False])
    monkeypatch.setattr(script, "time_is_left", lambda *_: next(left, True))
    script.main()
    assert "one: 4 of 6 steps are done" in capsys.readouterr().out
    assert not (out / "one.json").exists()
    script.main()
    score = (out / "one.json").read_bytes()
    whole = trained(tmp_path / "whole", **script.small)
    for name in ("decoder.safetensors", "metrics.csv"):
        assert (out / "one" / name).read_bytes() == (whole / name).read_bytes()
    monkeypatch.setattr(script, "train", None)
    script.main()
    assert (out / "one.json").read_bytes() == score


def test_every_run_is_a_configuration(tmp_path: Path) -> None:
    """Of the paper's size, from files that are there; without bf16 with fewer steps."""
    spec = importlib.util.spec_from_file_location("paper_size", SCRIPT)
    assert spec is not None
    assert spec.loader is not None
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    from nscc_training.config import settings_of

    for name in made.RUNS:
        both = [
            settings_of(made.values_of(name, tmp_path, tmp_path, bf16)) for bf16 in (True, False)
        ]
        assert {each.decoder.size for each in both} == {"paper"}
        assert both[0].train.steps == made.FEWER * both[1].train.steps
        assert (both[0].train.dtype, both[1].train.dtype) == ("bf16", "f32")
