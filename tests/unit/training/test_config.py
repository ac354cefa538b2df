"""Configurations: defaults, round trips, and every mistake with its place."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest
from nscc_command import invoke

pytest.importorskip("torch")

from nscc.diagnostics.diagnostic import Rejected
from nscc_training.decoders.declared import DECODERS
from nscc_training.settings import RunSettings, config_toml, load_config, settings_of


def test_printed_settings_are_read_back() -> None:
    """The TOML of the defaults and of changed settings gives equal settings when read. With remarks
    no line passes 100 characters."""
    for remarks in (False, True):
        text = config_toml(RunSettings(), remarks=remarks)
        assert settings_of(tomllib.loads(text)) == RunSettings()
        assert max(len(line) for line in text.splitlines()) <= 100
    changed = settings_of({"shutter": {"class": "d", "tile": [2, 3]}, "train": {"rate": 1}})
    assert (changed.shutter.kind, changed.shutter.tile, changed.train.rate) == ("d", (2, 3), 1.0)
    assert settings_of(tomllib.loads(config_toml(changed))) == changed


def test_all_contradictions_are_named_together() -> None:
    values = {
        "decoder": {"lessons": "denoise"},
        "shutter": {"free": True},
        "sensor": {"effects": "all", "noise": False},
    }
    with pytest.raises(Rejected) as caught:
        settings_of(values).check()
    named = [d.message.removeprefix("invalid setting ") for d in caught.value.diagnostics]
    assert {d.code for d in caught.value.diagnostics} == {"NS0815"}
    assert [text.partition(":")[0] for text in named] == [
        "shutter.learn",
        "decoder.lessons",
        "sensor.effects",
        "sensor.effects",
    ]
    settings_of(
        {"decoder": {"lessons": "denoise", "name": "any"}, "shutter": {"learn": False}}
    ).check()


def test_changes_by_set_replace_values_of_the_file(tmp_path: Path) -> None:
    """`train.steps=9` replaces the 7 of the file. Values that it does not name keep the file's
    value."""
    path = tmp_path / "c.toml"
    path.write_text("[train]\nsteps = 7\nbatch = 3\n")
    found = load_config(path, ["train.steps=9", "loss.name=l1", 'data.val=""', "shutter.free=true"])
    assert (found.train.steps, found.train.batch) == (9, 3)
    assert (found.loss.name, found.data.val, found.shutter.free) == ("l1", "", True)


def test_all_mistakes_are_reported_at_once_with_their_places(tmp_path: Path) -> None:
    """A file with four mistakes and two bad changes gives six errors. Misspelt names get a
    proposal, and the file's lines are 1, 4, 5 and 7."""
    path = tmp_path / "c.toml"
    path.write_text("[trian]\nx = 1\n[train]\nstep = 3\nbatch = 0\n[data]\nsaturated = [0.3]\n")
    with pytest.raises(Rejected) as caught:
        load_config(path, ["train.dtype=f16", "nothing"])
    found = caught.value.diagnostics
    assert [d.code for d in found] == ["NS0814", "NS0814", "NS0815", "NS0815", "NS0815", "NS0815"]
    assert "did you mean `train`?" in found[0].helps
    assert "did you mean `steps`?" in found[1].helps
    lines = [d.source.row_column(d.label.span.start)[0] for d in found if d.source and d.label]
    assert lines == [1, 4, 5, 7]


@pytest.mark.parametrize(
    "text",
    [
        "[train]\nsteps = true\n",
        "[train]\nsteps = 1.5\n",
        "[train]\nrate = nan\n",
        "[train]\nrate = inf\n",
        "[train]\nseed = -1\n",
        "[train]\nseed = 99999999999\n",
        "[shutter]\nclass = 3\n",
        "[shutter]\nclass = 'f'\n",
        "[shutter]\ntile = 8\n",
        "[shutter]\ntile = [8, true]\n",
        "[shutter]\nfree = 1\n",
        "train = 3\n",
        "[data]\npatch = 1e400\n",
    ],
)
def test_wrong_values_of_a_configuration_are_refused(text: str, tmp_path: Path) -> None:
    (tmp_path / "c.toml").write_text(text)
    with pytest.raises(Rejected, match="NS0815"):
        load_config(tmp_path / "c.toml")


def test_invalid_configuration_files_are_refused(tmp_path: Path) -> None:
    """A missing, binary or broken file gives NS0813, a folder without pictures NS0811. No run
    folder is made."""
    (tmp_path / "bytes.toml").write_bytes(b"\xff\xfe\x00")
    (tmp_path / "broken.toml").write_text("[train\nsteps = 1")
    for name, code in (
        ("none.toml", "NS0813"),
        ("bytes.toml", "NS0813"),
        ("broken.toml", "NS0813"),
        (".", "NS0811"),  # a folder without pictures
    ):
        outcome = invoke(["train", name, "--out", "r"], tmp_path)
        assert (outcome.status, outcome.codes) == (2, [code])
    assert not (tmp_path / "r").exists()


def test_the_schema_is_a_configuration(tmp_path: Path) -> None:
    """`nscc train --schema` prints a file that gives the default settings, with the decoders' names
    as a remark."""
    outcome = invoke(["train", "--schema"], tmp_path)
    assert outcome.status == 0
    assert settings_of(tomllib.loads(outcome.out)) == RunSettings()
    remarks = outcome.out.partition("[decoder]")[2].partition("name =")[0]
    assert f"# {', '.join(DECODERS)}, or" in remarks


@pytest.mark.parametrize(
    ("changes", "status", "code"),
    [
        (["shutter.class=e", "shutter.slots=16", "shutter.codes=open"], 1, "NS0412"),
        (["shutter.class=e", "shutter.slots=70"], 2, "NS0815"),
        (["shutter.slot_us=0.3"], 1, "NS0601"),
        (["shutter.require=stop < 0"], 1, "NS0317"),
        (["shutter.require=stop <"], 1, "NS0107"),
        (["shutter.target=scamp6"], 2, "NS0230"),
        (["shutter.class=e", "shutter.slots=8", "shutter.require=true"], 2, "NS0815"),
        (["shutter.class=c", "shutter.slots=4", "shutter.length=5"], 2, "NS0815"),
        (["shutter.tile=[100, 50]"], 2, "NS0815"),
        (["shutter.tile=[300, 300]"], 2, "NS0815"),
        (["shutter.init=none.npz"], 2, "NS0805"),
        (["loss.name=l3"], 2, "NS0815"),
        (["loss.name=no_such:loss"], 2, "NS0812"),
        (["decoder.name=unet3d"], 2, "NS0815"),
        (["decoder.name=unrolled"], 2, "NS0815"),
        (["decoder.name=refined"], 2, "NS0815"),
        (
            ["decoder.name=refined", "decoder.sees_code=false", "data.protocol=video-v1"],
            2,
            "NS0815",
        ),
        (["decoder.name=no_such:net"], 2, "NS0812"),
        (["data.train=none"], 2, "NS0811"),
        (["data.train=."], 2, "NS0811"),
        (["data.protocol=hdr-v2"], 2, "NS0815"),
        (["data.protocol=sci8"], 2, "NS0815"),
        (["shutter.init=no_such_run"], 2, "NS0815"),
        (["train.device=cuda"], 2, "NS0815"),
        (["sensor.file=none.toml"], 2, "NS0751"),
    ],
)
def test_training_refuses_invalid_settings_before_its_first_step(
    changes: list[str], status: int, code: str, tmp_path: Path
) -> None:
    """Infeasible shutters stop with the compiler's own error, the rest with ours."""
    import torch

    if code == "NS0815" and "cuda" in changes[0] and torch.cuda.is_available():
        pytest.skip("there is a CUDA device")
    (tmp_path / "c.toml").write_text("[shutter]\nslots = 16\n[data]\npatch = 32\nscenes = 4\n")
    sets = [part for change in changes for part in ("--set", change)]
    outcome = invoke(["train", "c.toml", "--out", "r", *sets], tmp_path)
    assert code in outcome.codes, outcome.err
    assert outcome.status == status
    assert not (tmp_path / "r" / "metrics.csv").exists()


@pytest.mark.parametrize(
    "text",
    ["panorama", 'a "b" \\ c', "tab\tline\nend", "\x00\x7f", "caf\xe9 \u4e2d", "\U0001f600\ufffd"],
)
def test_any_text_survives_the_file(text: str, tmp_path: Path) -> None:
    """A text with quotes, control characters or any Unicode is equal after it was written and
    read."""
    settings = settings_of({"data": {"train": text}})
    path = tmp_path / "c.toml"
    path.write_text(config_toml(settings), encoding="utf-8")
    assert load_config(path) == settings


@pytest.mark.parametrize("change", ["data.train=\udcff", "train.steps=3\nbatch=5"])
def test_changes_that_are_not_a_single_toml_value_are_refused(change: str) -> None:
    """A lone surrogate, or two lines in one change, give NS0815."""
    with pytest.raises(Rejected) as caught:
        settings_of({}, [change])
    assert [d.code for d in caught.value.diagnostics] == ["NS0815"]
