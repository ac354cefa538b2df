"""`nscc tradeoff images`: programs of words for kernels, their noise and their time."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest
from nscc_command import invoke
from PIL import Image

from nscc.neighbours.picture_report import picture_report
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc_training.experiments.study import measure
from nscc_training.tradeoff.synthesis import images_study

TEXT = (
    "nsl 3\nframe 1 slots of 1ms\nopen when true\n"
    "kernel m = [[0, 0, 0], [-3, 1, 0], [-3, 0, 2]] / 16\nimage net = m(exposure)\nread net\n"
)


def test_the_compiler_takes_the_fewest_words(tmp_path: Path) -> None:
    file = tmp_path / "p.nsl"
    file.write_text(TEXT)
    points = measure(images_study(file, 1)).points
    assert len(points) > 2
    container = run_passes(Source("p.nsl", TEXT), Path(), Options(level=1, cache=False)).container
    assert container is not None
    image = picture_report(container)["images"]["net"]
    fewest = min(points, key=lambda point: point.time_ms)
    assert image["words"] <= 1 + int(fewest.setting.split()[0])
    # A word takes 0.2 us.
    assert fewest.time_ms * 1000 == pytest.approx(int(fewest.setting.split()[0]) * 0.2)
    assert len({point.error for point in points}) > 1


def test_the_command_writes_a_table_a_file_and_a_diagram(tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(TEXT)
    outcome = invoke(["tradeoff", "images", "p.nsl", "-O", "1", "-o", "t"], tmp_path)
    assert outcome.status == 0, outcome.err
    assert "net" in outcome.out
    with (tmp_path / "t.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert {row["method"] for row in rows} == {"net, m"}
    with Image.open(tmp_path / "t.png") as diagram:
        assert diagram.width > 100
    (tmp_path / "q.nsl").write_text("nsl 1\nframe 1 slots of 1ms\nopen when true\n")
    without_kernels = invoke(["tradeoff", "images", "q.nsl"], tmp_path)
    assert (without_kernels.status, without_kernels.out) == (1, "")
    assert "no image of 'q.nsl' has a kernel" in without_kernels.err
