"""`nscc import-network`: cells from files of torch and ONNX, and refusals of everything else."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
import pytest
import torch
from nscc_command import invoke

from nscc.diagnostics.diagnostic import Rejected
from nscc_training.cell_programs import cell_files
from nscc_training.cells import PixelCell
from nscc_training.imported_networks import read_cell


def made() -> PixelCell:
    torch.manual_seed(3)
    cell = PixelCell(outputs=2, pool=3, outside=1)
    with torch.no_grad():
        cell.threshold.normal_(0, 4)
    return cell


def reason(path: Path) -> str:
    """Why a file is refused."""
    with pytest.raises(Rejected) as refusal:
        read_cell(path)
    [diagnostic] = refusal.value.diagnostics
    assert diagnostic.code == "NS0851"
    return diagnostic.message


def test_a_state_dict_becomes_a_proved_program(tmp_path: Path) -> None:
    """The command writes the program text and the kernels that Python makes from the cell, and
    prints the cell's size."""
    cell, model, out = made(), tmp_path / "cell.pt", tmp_path / "p.nsl"
    torch.save(cell.state_dict(), model)
    done = invoke(["import-network", "cell.pt", "-o", "p.nsl"], tmp_path)
    assert done.status == 0, done.err
    assert "1 state, 2 outputs, kernels 3 x 3" in done.out + done.err
    files = cell_files(cell, "p.kernels.npz", target="scamp5", remark="Imported from cell.pt.")
    assert out.read_text() == files.text
    assert (tmp_path / "p.kernels.npz").read_bytes() == files.kernels


def test_settings_may_be_left_out(tmp_path: Path) -> None:
    state = {name: PixelCell().state_dict()[name] for name in ("weight", "threshold")}
    torch.save(state, tmp_path / "cell.pt")
    cell = read_cell(tmp_path / "cell.pt")
    assert (cell.update, cell.pool, float(cell.level)) == ("flip", 1, 0.5)


def test_import_network_refuses_files_without_a_valid_cell(tmp_path: Path) -> None:
    good = made().state_dict()
    path = tmp_path / "m.pt"
    for changes, text in (
        ({"decoder.weight": torch.ones(2, 2)}, "not part of a cell: `decoder.weight`"),
        ({"weight": torch.ones(3, 2, 3, 5)}, "`weight` has the shape (3, 2, 3, 5)"),
        ({"weight": torch.ones(1).expand(3, 2, 2**20, 2**20)}, "is not a small dense tensor"),
        ({"weight": torch.full((3, 2, 3, 3), torch.nan)}, "not finite"),
        ({"weight": torch.zeros(3, 2, 3, 3)}, "all weights of gate 0 are 0"),
        ({"threshold": torch.ones(2)}, "`threshold` (2,)"),
        ({"pool_size": torch.tensor(4)}, "pool is 4"),
        ({"outside": torch.ones(2)}, "`outside` has the shape (2,)"),
        ({"flips": torch.tensor(3)}, "`flips` is 3"),
    ):
        torch.save({**good, **changes}, path)
        assert text in reason(path)
    torch.save({"weight": good["weight"]}, path)
    assert "`threshold` is missing" in reason(path)
    torch.save([good["weight"]], path)
    assert "it holds list" in reason(path)
    torch.save(made(), path)
    assert "a pickled object of the class nscc_training.cells.PixelCell" in reason(path)
    path.write_bytes(b"PK\x03\x04" + bytes(100))
    assert "it is cut off or damaged" in reason(path)
    path.write_bytes(bytes(17 << 20))
    assert "more than 16 MiB" in reason(path)
    assert "no such file" in reason(tmp_path / "none.pt")
    assert "does not end in" in reason(tmp_path / "cell.txt")


def test_nothing_is_written_for_a_refused_file(tmp_path: Path) -> None:
    """Weights of a Linear layer give NS0851, which names `bias`. The folder keeps its one file."""
    torch.save(torch.nn.Linear(2, 2).state_dict(), tmp_path / "m.pt")
    done = invoke(["import-network", "m.pt", "-o", "p.nsl"], tmp_path)
    assert done.codes == ["NS0851"]
    assert "`bias`" in done.err
    assert [path.name for path in tmp_path.iterdir()] == ["m.pt"]


def exported(folder: Path, module: torch.nn.Module, states: int = 1) -> Path:
    """An ONNX file of a module for a frame of 12 x 12."""
    pytest.importorskip("onnxscript")
    path = folder / "cell.onnx"
    planes = torch.ones(1, 1, 12, 12), torch.ones(1, states, 12, 12)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        torch.onnx.export(module, planes, path, dynamo=True, verbose=False, external_data=False)
    return path


@pytest.mark.parametrize(
    "settings",
    [
        {},
        {"outputs": 3, "pool": 5, "update": "replace"},
        {"states": 2, "outside": 1, "kernel": 5},
    ],
)
def test_an_export_of_torch_is_the_cell(tmp_path: Path, settings: dict[str, int]) -> None:
    """A cell exported to a file and read again has the same program and kernels, for the default
    and two other shapes."""
    torch.manual_seed(5)
    cell = PixelCell(**settings)  # type: ignore[arg-type]
    found = read_cell(exported(tmp_path, cell, cell.states))
    assert cell_files(found, "k.npz").text == cell_files(cell, "k.npz").text
    np.testing.assert_array_equal(found.kernels(), cell.kernels())


class Other(torch.nn.Module):
    """A cell, and something behind it."""

    def __init__(self, kind: str) -> None:
        super().__init__()
        self.cell, self.kind = made(), kind

    def forward(self, bits: torch.Tensor, state: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
        outputs, state = self.cell(bits, state)
        return (
            (outputs.relu(), state)
            if self.kind == "relu"
            else (outputs, outputs * state[:, :, :4, :4])
        )


def test_other_graphs_are_refused(tmp_path: Path) -> None:
    """A network with a Relu, one that computes other bits, and a file that is no ONNX model are
    refused with that reason."""
    pytest.importorskip("onnx")
    assert "(Relu)" in reason(exported(tmp_path, Other("relu")))
    assert "does not compute the bits" in reason(exported(tmp_path, Other("wrong")))
    (tmp_path / "cell.onnx").write_bytes(b"\x08\x07 no model")
    assert "not a valid ONNX model" in reason(tmp_path / "cell.onnx")


class _Model(torch.nn.Module):
    pass


def test_files_that_are_not_state_dicts_say_what_they_are(tmp_path: Path) -> None:
    cell = tmp_path / "cell.pt"
    torch.save({"weight": torch.zeros(2)}, cell)
    torch.save(_Model(), tmp_path / "model.pt")
    (tmp_path / "cut.pt").write_bytes(cell.read_bytes()[:-60])
    (tmp_path / "lfs.pt").write_text("version https://git-lfs.github.com/spec/v1\noid sha256:0\n")
    torch.save({"module.weight": torch.zeros(2)}, tmp_path / "parallel.pt")
    for name, text in (
        ("model", "a pickled object of the class"),
        ("cut", "it is cut off"),
        ("lfs", "a pointer of Git LFS"),
        ("parallel", "begin with `module.`"),
    ):
        with pytest.raises(Rejected, match=text):
            read_cell(tmp_path / f"{name}.pt")
