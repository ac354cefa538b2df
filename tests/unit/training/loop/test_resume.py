"""Runs that stop and go on: no bit changes, and what is another run's is refused."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

torch = pytest.importorskip("torch")

from safetensors.torch import load_file  # noqa: E402
from small_runs import CLIP, FILES, STILL, changed, run  # noqa: E402

from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_training.loop.train import train  # noqa: E402
from nscc_training.settings import settings_of  # noqa: E402


@pytest.mark.parametrize("values", [STILL, CLIP], ids=["still", "clip"])
def test_resuming_changes_no_bit(values: dict[str, Any], tmp_path: Path) -> None:
    """Stopped after any step and gone on with, a run is the run that was never stopped."""
    run(values, tmp_path / "whole")
    for stop in (2, 3):
        out = tmp_path / f"stopped{stop}"
        # a checkpoint lies at every second step: what came after one is done again
        run(changed(values, "train", validate_every=2), out, stop_after=stop)
        assert not (out / "result.json").exists()
        if stop == 3:
            # as a run that was killed there: its last checkpoint is of step 2
            put_back_checkpoint(values, out)
        run(values, out)
        for name in FILES - {"checkpoint.safetensors"}:
            whole, again = ((folder / name).read_bytes() for folder in (tmp_path / "whole", out))
            assert whole == again, name
        first, second = (
            load_file(folder / "checkpoint.safetensors") for folder in (tmp_path / "whole", out)
        )
        assert first.keys() == second.keys()
        assert all(torch.equal(first[key], second[key]) for key in first)


def test_an_interrupt_prints_how_to_resume(tmp_path: Path) -> None:
    settings = settings_of(changed(CLIP, "train", validate_every=2), ())

    def until(last: int):
        def track(items, _label, _total):
            for number, item in enumerate(items):
                if number == last:
                    raise KeyboardInterrupt
                yield item

        return track

    with pytest.raises(KeyboardInterrupt, match="no checkpoint yet; the same command starts again"):
        train(settings, tmp_path / "r", track=until(1))
    with pytest.raises(KeyboardInterrupt, match=r"checkpoint is stored in '.*r'; the same command"):
        train(settings, tmp_path / "r", track=until(3))
    with pytest.raises(KeyboardInterrupt, match="'; --resume auto continues"):
        train(settings, tmp_path / "r", track=until(3), resume="never")


def put_back_checkpoint(values: dict[str, Any], out: Path) -> None:
    """Put back the checkpoint of step 2, but leave the metrics of step 3."""
    other = out.with_name("other")
    run(values, other, stop_after=2)
    (out / "checkpoint.safetensors").write_bytes((other / "checkpoint.safetensors").read_bytes())


@pytest.mark.parametrize("values", [STILL, CLIP], ids=["still", "clip"])
def test_a_run_interrupted_before_its_products_writes_them_when_it_resumes(
    values: dict[str, Any], tmp_path: Path
) -> None:
    """Without result, card and weights, a run that is started again writes them with the same
    bytes."""
    relaxed = changed(values, "shutter", relaxation="sigmoid")
    run(relaxed, tmp_path)
    whole = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    for name in ("result.json", "model_card.md", "decoder.safetensors"):
        (tmp_path / name).unlink()
    run(relaxed, tmp_path)
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == whole


@pytest.mark.parametrize("begun", [None, 2], ids=["into a new folder", "over another run"])
def test_a_run_resumed_in_another_folder_is_complete_there(
    begun: int | None, tmp_path: Path
) -> None:
    """A finished run and an extended run leave equal files in both folders, and both can
    continue."""
    values = changed(STILL, "train", steps=4)
    run(values, tmp_path / "whole")
    wanted = {path.name: path.read_bytes() for path in (tmp_path / "whole").iterdir()}
    if begun is not None:
        other = changed(values, "train", seed=1)
        run(other, tmp_path / "r", stop_after=begun)
    for _ in range(2):  # nothing remains to be trained
        run(values, tmp_path / "r", resume=str(tmp_path / "whole"))
        assert {path.name: path.read_bytes() for path in (tmp_path / "r").iterdir()} == wanted
    run(values, tmp_path / "r")
    assert {path.name: path.read_bytes() for path in (tmp_path / "r").iterdir()} == wanted


def test_a_run_interrupted_after_it_was_brought_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Before its first validation: log and checkpoint are those of the folder that it came from."""
    run(STILL, tmp_path / "begun", stop_after=2)
    run(STILL, tmp_path / "r", stop_after=4)

    def interrupted(*_given: Any) -> float:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr("nscc_training.loop.train.update", interrupted)
        with pytest.raises(KeyboardInterrupt):
            run(STILL, tmp_path / "r", resume=str(tmp_path / "begun"))
    for name in ("metrics.csv", "checkpoint.safetensors"):
        assert (tmp_path / "r" / name).read_bytes() == (tmp_path / "begun" / name).read_bytes()


@pytest.mark.parametrize("text", [b"", b"\xff\xfe", b"step\nfirst,1\n", b"step\n\n"])
def test_a_damaged_log_is_reported(text: bytes, tmp_path: Path) -> None:
    """An empty log, bytes that are no text and rows without numbers give NS0816."""
    run(STILL, tmp_path, stop_after=2)
    (tmp_path / "metrics.csv").write_bytes(text)
    with pytest.raises(Rejected) as caught:
        run(STILL, tmp_path)
    assert [d.code for d in caught.value.diagnostics] == ["NS0816"]


@pytest.mark.parametrize("about", ["[]", "3", "{}", '{"step": 1}', None, "optimizer", "best"])
def test_checkpoints_of_something_else_are_refused(about: str | None, tmp_path: Path) -> None:
    from safetensors import safe_open
    from safetensors.torch import save_file

    run(STILL, tmp_path, stop_after=2)
    path = tmp_path / "checkpoint.safetensors"
    with safe_open(str(path), framework="pt") as file:
        kept = file.metadata()
    tensors = load_file(path)
    if about in ("optimizer", "best"):
        tensors.pop(next(name for name in tensors if name.startswith(about)))
    else:
        kept = None if about is None else {"nscc": about}
    save_file(tensors, path, metadata=kept)
    with pytest.raises(Rejected) as caught:
        run(STILL, tmp_path)
    assert [d.code for d in caught.value.diagnostics] == ["NS0816"]


def test_a_run_refuses_to_resume_with_other_scenes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Else split.json would forget what the first steps have seen, and evaluations accept it."""
    (tmp_path / "shots.py").write_text(
        "import numpy as np\n"
        "from pathlib import Path\n"
        "def scenes(kind, part, slots, seed):\n"
        "    first = int(Path('first.txt').read_text()) + (part == 'val')\n"
        "    return [(part, np.random.default_rng(first).random((20, 20)))]\n"
    )
    (tmp_path / "first.txt").write_text("1")
    monkeypatch.chdir(tmp_path)
    values = changed(STILL, "data", train="shots:scenes", val="shots:scenes")
    run(values, tmp_path / "run", stop_after=2)
    split = (tmp_path / "run" / "split.json").read_bytes()
    (tmp_path / "first.txt").write_text("3")
    with pytest.raises(Rejected) as caught:
        run(values, tmp_path / "run")
    assert [d.code for d in caught.value.diagnostics] == ["NS0816"]
    assert (tmp_path / "run" / "split.json").read_bytes() == split


def test_a_folder_with_files_of_two_runs_and_an_unfinished_run_are_not_loaded(
    tmp_path: Path,
) -> None:
    from nscc_training.run_folder import load_run

    run(STILL, tmp_path / "r")
    assert load_run(tmp_path / "r").result["protocol"] == "hdr-v1"
    another = changed(STILL, "train", seed=1)
    run(another, tmp_path / "other", stop_after=2)
    run(another, tmp_path / "r", resume="never", stop_after=2)
    for folder in ("r", "other"):
        with pytest.raises(Rejected) as caught:
            load_run(tmp_path / folder)
        assert [d.code for d in caught.value.diagnostics] == ["NS0818"]


@pytest.mark.parametrize("name", ["codes.npz", "shutter.nsl", "split.json", "decoder.safetensors"])
def test_a_run_with_a_missing_or_foreign_file_is_refused(name: str, tmp_path: Path) -> None:
    """Without its codes a run would decode with others."""
    from nscc_training.run_folder import load_run

    run(STILL, tmp_path / "r")
    run(changed(STILL, "train", seed=1), tmp_path / "other")
    (tmp_path / "other" / name).replace(tmp_path / "r" / name)
    for folder in ("r", "other"):
        with pytest.raises(Rejected) as caught:
            load_run(tmp_path / folder)
        assert [d.code for d in caught.value.diagnostics] == ["NS0818"]


def test_a_cuda_run_loads_without_cuda(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The folder's settings say `cuda` and torch finds none: the decoder is loaded to the CPU."""
    from hashlib import sha256

    from nscc_training.run_folder import load_run

    run(changed(STILL, "train", device="cpu"), tmp_path)
    config = tmp_path / "config.resolved.toml"
    config.write_text(config.read_text().replace('device = "cpu"', 'device = "cuda"'))
    result = json.loads((tmp_path / "result.json").read_text())
    result["config_sha256"] = sha256(config.read_bytes()).hexdigest()
    (tmp_path / "result.json").write_text(json.dumps(result))
    monkeypatch.setattr(torch.cuda, "is_available", lambda: False)
    assert load_run(tmp_path).setup.device == torch.device("cpu")


def test_the_same_seed_gives_the_same_bytes(tmp_path: Path) -> None:
    """Two runs write files of equal bytes. Another seed gives other codes."""
    for name in ("a", "b"):
        run(STILL, tmp_path / name)
    run(changed(STILL, "train", seed=1), tmp_path / "c")
    for name in FILES:
        one, two = ((tmp_path / k / name).read_bytes() for k in ("a", "b"))
        assert one == two, name
    codes = [np.load(tmp_path / k / "codes.npz")["stop"] for k in ("a", "c")]
    assert not np.array_equal(*codes)


def test_a_finished_run_resumes_with_more_steps_but_not_with_fewer(tmp_path: Path) -> None:
    from nscc_training.run_folder import load_run

    run(STILL, tmp_path / "r")
    steps = STILL["train"]["steps"]
    log = (tmp_path / "r" / "metrics.csv").read_text().splitlines()
    run(changed(STILL, "train", steps=steps + 2), tmp_path / "r")
    longer = (tmp_path / "r" / "metrics.csv").read_text().splitlines()
    assert longer[: len(log)] == log
    assert int(longer[-1].split(",")[0]) == steps + 2
    assert load_run(tmp_path / "r").setup.settings.train.steps == steps + 2
    with pytest.raises(Rejected, match="NS0816"):
        run(STILL, tmp_path / "r")
    with pytest.raises(Rejected, match="NS0816"):
        run(changed(STILL, "train", steps=steps + 4, rate=0.5), tmp_path / "r")


def test_other_configurations_are_refused_unless_resume_is_never(tmp_path: Path) -> None:
    """Another rate, a missing checkpoint and one of 40 zero bytes each give NS0816. With
    `resume="never"` the run begins anew."""
    run(STILL, tmp_path / "r", stop_after=2)
    with pytest.raises(Rejected, match="NS0816"):
        run(changed(STILL, "train", rate=0.002), tmp_path / "r")
    run(changed(STILL, "train", rate=0.002), tmp_path / "r", resume="never", stop_after=2)
    with pytest.raises(Rejected, match="NS0816"):
        run(STILL, tmp_path / "r", resume=str(tmp_path / "nowhere"))
    (tmp_path / "r" / "checkpoint.safetensors").write_bytes(b"\x00" * 40)
    with pytest.raises(Rejected, match="NS0816"):
        run(STILL, tmp_path / "r")
