"""Same input, same bytes: whatever the folder and the hash seed."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from marks import slow

PRODUCTS = "ast,ir,gates,schedule,asm,icw,cpp,report,dot,graphml"
EXAMPLES = ("hdr_2x2", "class_d", "codebook", "two_buckets", "skip_one")
SOONEST = ("codebook", "two_buckets")


@pytest.mark.parametrize("name", [name if name in SOONEST else slow(name) for name in EXAMPLES])
def test_products_do_not_depend_on_folder_or_hash_seed(
    name: str, root: Path, tmp_path: Path
) -> None:
    made = []
    for seed, folder in (("0", "here"), ("1", "there/and/further on"), ("77", "ä")):
        home = tmp_path / folder
        home.mkdir(parents=True)
        shutil.copy(root / "examples" / f"{name}.nsl", home)
        run(["build", f"{name}.nsl", "--emit", PRODUCTS], home, seed)
        run(["run", f"{name}.icw", "--scene", "builtin:motion", "-o", "frame.npz"], home, seed)
        made.append({path.name: path.read_bytes() for path in home.iterdir()})
    assert len(made[0]) > len(PRODUCTS.split(","))
    for other in made[1:]:
        assert sorted(other) == sorted(made[0])
        assert [file for file in made[0] if made[0][file] != other[file]] == []
    for file, data in made[0].items():
        assert str(tmp_path).encode() not in data, file
        assert str(root).encode() not in data, file


def test_pictures_do_not_depend_on_the_hash_seed(root: Path, tmp_path: Path) -> None:
    pictures: list[list[bytes]] = []
    for seed in ("0", "5"):
        home = tmp_path / seed
        home.mkdir()
        shutil.copy(root / "examples" / "hdr_2x2.nsl", home)
        pictures.append([])
        for options in ([], ["--gates"]):
            run(["view", "hdr_2x2.nsl", *options, "-o", "view.png"], home, seed)
            pictures[-1].append((home / "view.png").read_bytes())
    assert pictures[0] == pictures[1]


def test_a_second_run_in_the_same_process_writes_the_same_frame(root: Path, tmp_path: Path) -> None:
    """The same run twice in one process gives frame files of equal bytes: no kept value leaks into
    the second."""
    from nscc_command import invoke

    shutil.copy(root / "examples" / "class_c.nsl", tmp_path)
    frames = []
    for _ in range(2):
        arguments = ["run", "class_c.nsl", "--scene", "builtin:hdr", "-o", "frame.npz"]
        assert invoke(arguments, tmp_path).status == 0
        frames.append((tmp_path / "frame.npz").read_bytes())
    assert frames[0] == frames[1]


def run(arguments: list[str], folder: Path, hash_seed: str) -> None:
    """`nscc` in a process of its own."""
    paths = os.pathsep.join(os.path.abspath(path) for path in sys.path if path)
    outcome = subprocess.run(
        [sys.executable, "-m", "nscc_cli", *arguments],
        cwd=folder,
        env={**os.environ, "PYTHONHASHSEED": hash_seed, "PYTHONPATH": paths},
        capture_output=True,
        text=True,
    )
    assert outcome.returncode == 0, outcome.stderr
