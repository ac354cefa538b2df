"""Names of files in messages, whatever the locale."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from nscc.diagnostics.diagnostic import Rejected
from nscc_training.codes_files import load_codes


@pytest.mark.parametrize("extra", [{}, {"PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}])
def test_names_beyond_ascii_are_written_in_a_posix_locale(
    tmp_path: Path, extra: dict[str, str]
) -> None:
    """With LC_ALL=POSIX, with and without the UTF-8 mode of Python, the message holds `é.nsl` in
    UTF-8."""
    line = [sys.executable, "-m", "nscc_cli", "check", "é.nsl".encode()]
    environment = {**os.environ, "LC_ALL": "POSIX", **extra}
    outcome = subprocess.run(line, cwd=tmp_path, env=environment, capture_output=True, check=False)
    assert "cannot read 'é.nsl'".encode() in outcome.stderr


@pytest.mark.parametrize("name", ["mask.npz", "mask.npy", "mask.mat", "mask.txt"])
def test_a_mask_given_as_codes_is_named_as_a_mask(tmp_path: Path, name: str) -> None:
    import numpy as np
    from scipy.io import savemat

    mask = np.ones((4, 4, 3))
    path = tmp_path / name
    if path.suffix == ".mat":
        savemat(path, {"mask": mask})
    else:
        with path.open("wb") as file:
            np.savez(file, mask=mask) if path.suffix == ".npz" else np.save(file, mask)
    with pytest.raises(Rejected) as caught:
        load_codes(str(path))
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code == "NS0805"
    text = " ".join([diagnostic.message, *diagnostic.notes, *diagnostic.helps])
    assert "Error" not in text
    assert "attribute" not in text
    assert ("nscc import-mask" in text) == (name != "mask.txt")
