"""What of training works without torch, and what is said where it does not."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

CODE = (
    "import sys; sys.modules['{package}'] = None; "
    "from nscc_cli.main import main; sys.exit(main(sys.argv[1:]))"
)


def without(package: str, arguments: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    paths = [str(Path(path).resolve()) for path in sys.path if path]
    return subprocess.run(
        [sys.executable, "-c", CODE.format(package=package), *arguments],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
        capture_output=True,
        text=True,
        timeout=100,
    )


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    import numpy as np
    from scipy.io import savemat

    orig, mask = np.full((16, 16, 8), 99.0), np.ones((16, 16, 8))
    savemat(tmp_path / "c.mat", {"orig": orig, "mask": mask, "meas": (orig * mask).sum(2)})
    np.save(tmp_path / "a.npy", orig[..., 0])
    return tmp_path


@pytest.mark.parametrize(
    "arguments",
    [
        ["metrics", "a.npy", "a.npy", "--data-range", "255"],
        ["evaluate", "sci8", "c.mat"],
        ["train", "--schema"],
        ["train", "--help"],
        ["evaluate", "--help"],
        ["tradeoff", "decoder", "--help"],
        ["tradeoff", "sensor", "--help"],
    ],
    ids=" ".join,
)
def test_commands_that_train_nothing_work_without_torch(arguments: list[str], folder: Path) -> None:
    done = without("torch", arguments, folder)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    "arguments",
    [
        ["train", "c.toml", "--out", "r"],
        ["evaluate", "ldr", "--data", ".", "--protocol", "hdr-v1"],
        ["reconstruct", ".", "a.npy", "-o", "o.npz"],
        ["tradeoff", "decoder"],
        ["tradeoff", "sensor"],
    ],
    ids=" ".join,
)
def test_a_missing_torch_is_reported(arguments: list[str], folder: Path) -> None:
    (folder / "c.toml").write_text("[train]\nsteps = 1\n")
    done = without("torch", arguments, folder)
    assert done.returncode == 2
    assert "NS0904" in done.stderr
    assert "nscc[train]" in done.stderr


def test_a_missing_numpy_is_reported(tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text("nsl 1\nframe 4 slots of 1ms\nopen when true\n")
    done = without("numpy", ["run", "p.nsl", "--scene", "builtin:hdr"], tmp_path)
    assert done.returncode == 2
    assert "NS0904" in done.stderr
    assert "'numpy'" in done.stderr


def test_the_package_itself_imports_nothing_heavy() -> None:
    code = (
        "import sys, nscc_training, nscc_training.metrics, nscc_training.measures; "
        "print([m for m in ('torch', 'scipy', 'cv2', 'numba', 'matplotlib') if m in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
    )
    assert done.stdout.strip() == "[]", done.stderr
