"""Hard case 34: a sensor file with NaN, infinities, overflowing or absurd numbers is refused."""

from __future__ import annotations

import pytest
from nscc_command import invoke

KEYS = ("full_well_e", "prnu_fraction", "dark_current_e_per_s", "read_noise_e")
BAD = ("nan", "-nan", "inf", "-inf", "1e400", "-1e-9")


@pytest.mark.parametrize("value", BAD)
def test_case_34_bad_values_are_refused_with_their_key_and_line(tmp_path, value) -> None:
    known = invoke(["effects", "--toml"], tmp_path).out
    lines = known.splitlines()
    for key in KEYS:
        (place,) = (i for i, line in enumerate(lines) if line.startswith(f"{key} ="))
        changed = [*lines[:place], f"{key} = {value}", *lines[place + 1 :]]
        (tmp_path / "s.toml").write_text("\n".join(changed) + "\n")
        (tmp_path / "p.nsl").write_text("nsl 1\nframe 4 slots of 1ms\nopen when n < 4\n")
        said = invoke(
            ["run", "p.nsl", "--scene", "builtin:dark", "--sensor", "s.toml", "-o", "f.npz"],
            tmp_path,
        )
        assert said.status == 2, key
        assert key in said.err
        assert f"s.toml:{place + 1}" in said.err
        assert not (tmp_path / "f.npz").exists()
