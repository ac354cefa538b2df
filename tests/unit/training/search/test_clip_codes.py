"""`nscc design --search` of clips: the table of codes, the judge, and the program of the winner."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke

torch = pytest.importorskip("torch")

from training_oracle import small_target  # noqa: E402

from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc.words.container import Container  # noqa: E402
from nscc_training.design.make import Frame  # noqa: E402
from nscc_training.search import clip_codes as searched  # noqa: E402
from nscc_training.search.clip_codes import ClipCode, clip_codes, design_clip  # noqa: E402

SLOTS, ROWS, COLS = 16, 32, 32


def scene(speed: float) -> np.ndarray:
    """A texture that moves to the right by `speed` pixels per slot, in electrons per slot."""
    down, right = np.mgrid[:ROWS, :COLS]
    moved = right - speed * np.arange(SLOTS)[:, None, None]
    wave = np.sin(moved / 2.5) * np.cos(down / 3 + moved / 7)
    return np.asarray((1.1 + wave) * 900, np.float32)


@pytest.fixture
def target(tmp_path: Path) -> str:
    text = invoke(["targets", "scamp5", "--toml"], tmp_path).out
    (tmp_path / "small.toml").write_text(small_target(text, ROWS, COLS))
    return str(tmp_path / "small.toml")


def named(*names: str) -> list[ClipCode]:
    return [code for code in clip_codes(SLOTS) if code.name in names]


@pytest.mark.parametrize("slots", [8, 16, 24])
def test_the_table_has_bumps_mixtures_and_free_bits(slots: int) -> None:
    codes = clip_codes(slots)
    assert len({code.name for code in codes}) == len(codes) > 30
    for code in codes:
        assert code.opened.shape[0] == slots
        always = code.opened.all(axis=0)
        assert not (code.long and always.any())
        # In a mixture, the pixels that close for longer record every slot.
        if "beside" in code.name:
            shortest = code.opened.sum(axis=0) == code.opened.sum(axis=0).min()
            assert code.opened[:, shortest].any(axis=1).all()
    shares = {tuple(np.unique(code.opened.sum(axis=0))) for code in codes if "beside" in code.name}
    assert (slots // 8, slots // 2) in shares
    assert (slots // 4, slots) in shares


def test_a_program_opens_the_shutters_of_its_code(target: str) -> None:
    """For every sixth code, the last readout opens the code's pattern, repeated. A long readout
    beside it is always open."""
    frame = Frame(slots=SLOTS, target=target, level=1)
    for code in clip_codes(SLOTS)[::6]:
        container = code.container(frame)
        shutters = container.table.shutters[container.table.shutter_of_code[container.pixel_codes]]
        repeats = [
            side // period for side, period in zip((ROWS, COLS), code.opened.shape[1:], strict=True)
        ]
        expected = np.tile(code.opened, (1, *repeats))
        np.testing.assert_array_equal(shutters[:, :, -1].transpose(2, 0, 1), expected)
        assert shutters.shape[2] == 1 + code.long
        assert shutters[:, :, 0].all() or not code.long


def test_the_search_prints_the_score_of_its_program(
    tmp_path: Path, target: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The program, exposed and reconstructed by the commands, beside the PSNR that is printed."""
    codes = named(
        "always open, one readout",
        "cyclic, 1/4 of the frame, one readout",
        "cyclic, 1/4 of the frame, two readouts, one always open",
    )
    assert len(codes) == 3
    monkeypatch.setattr(searched, "clip_codes", lambda _slots: codes)
    light = scene(0.4)
    np.savez(tmp_path / "clip.npz", light=light)
    chip = ["--target", target]
    done = invoke(
        ["design", "--search", "--trials", "0", "--scene", "clip.npz", "-o", "p.nsl", *chip],
        tmp_path,
    )
    assert done.status == 0, done.err
    lines = dict(line.split(maxsplit=1) for line in done.out.splitlines()[1:])
    assert lines["code"].endswith("two readouts, one always open")
    assert lines["single"].startswith("cyclic, 1/4 of the frame, one readout: ")
    assert "frame 16 slots of 125us" in (tmp_path / "p.nsl").read_text()
    for line in (
        ["run", "p.nsl", "--scene", "clip.npz", "--effects", "all", "-o", "f.npz", *chip],
        ["reconstruct", "any", "f.npz", "--method", "network", "-o", "o.npz"],
    ):
        step = invoke(line, tmp_path)
        assert step.status == 0, step.err
    result = np.load(tmp_path / "o.npz")["video"]
    peak = np.percentile(light, 99.9)
    truth, shown = (np.clip(part / peak, 0, 1) for part in (light, result))
    truth, shown = (
        np.where(x > 0.0031308, 1.055 * np.maximum(x, 1e-9) ** (1 / 2.4) - 0.055, 12.92 * x)
        for x in (truth, shown)
    )
    psnr_db = -10 * np.log10(np.mean((truth - shown) ** 2))
    assert psnr_db == pytest.approx(float(lines["reached"].split()[0]), abs=0.06)
    assert psnr_db > float(lines["open"].split(": ")[1].split()[0]) + 1


def test_codes_are_chosen_by_motion_and_then_by_words(
    target: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """For a still scene the program without a code wins. Among codes of equal PSNR, the one with
    the fewest words wins."""
    codes = named(
        "always open, one readout",
        "quad, 1/4 of the frame, one readout",
        "random bits, one readout",
    )
    monkeypatch.setattr(searched, "clip_codes", lambda _slots: codes)
    frame = Frame(slots=SLOTS, target=target, level=1)
    design = design_clip([scene(0.0)], frame, trials=0)
    assert design.code.name == "always open, one readout"
    assert [code.mean_db for code in design.ranked] == sorted(
        (code.mean_db for code in design.ranked), reverse=True
    )
    monkeypatch.setattr(searched, "_psnr_db", lambda *_: 30.0)
    assert design_clip([scene(0.0)], frame, trials=0).code.name == "always open, one readout"
    monkeypatch.setattr(searched, "clip_codes", lambda _slots: codes[::-1])
    assert design_clip([scene(0.0)], frame, trials=0).code.name == "always open, one readout"


def test_codes_that_do_not_fit_are_left_out(target: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """In slots of 2 us random bits take too long: one code is left. In 0.05 us none is, which is an
    error NS06."""
    codes = named("always open, one readout", "random bits, one readout")
    monkeypatch.setattr(searched, "clip_codes", lambda _slots: codes)
    short = Frame(slots=SLOTS, slot_us=2.0, target=target, level=1)
    assert [code.name for code in design_clip([scene(0.0)], short, trials=0).ranked] == [
        "always open, one readout"
    ]
    with pytest.raises(Rejected) as refusal:
        design_clip([scene(0.0)], replace(short, slot_us=0.05))
    assert refusal.value.diagnostics[0].code.startswith("NS06")


def test_a_changed_code_differs_and_has_a_program_of_its_own(target: str) -> None:
    """Twenty changes in turn, each with at most one shutter more: the program opens the changed
    tile, repeated."""
    frame, generator = Frame(slots=SLOTS, target=target, level=1), np.random.default_rng(1)
    [first] = named("two-phase, 1/4 of the frame, two readouts, one always open")
    code = first
    for _ in range(20):
        before, code = code, code.changed(generator)
        assert not np.array_equal(code.opened, before.opened)
        count, count_before = (len(c.codebook()[1]["book"]) for c in (code, before))
        assert count <= count_before + 1
    assert code.name == f"{first.name}, tuned"
    assert code.long
    assert code.opened.any(axis=0).all()
    container = code.container(frame)
    shutters = container.table.shutters[container.table.shutter_of_code[container.pixel_codes]]
    expected = np.tile(code.opened, (1, ROWS // 4, COLS // 4))
    np.testing.assert_array_equal(shutters[:, :, 1].transpose(2, 0, 1), expected)


def test_changes_of_the_best_code_are_kept_if_they_measure_better(
    target: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The judge here prefers pixels that open late: the changed code is later than the table's."""
    codes = named("always open, one readout", "cyclic, 1/4 of the frame, one readout")

    def lateness(container: Container, *_: object) -> float:
        shutters = container.table.shutters[container.table.shutter_of_code[container.pixel_codes]]
        return float(20 + shutters[:, :, -1].mean(axis=(0, 1)) @ (np.arange(SLOTS) - 7.5))

    monkeypatch.setattr(searched, "clip_codes", lambda _slots: codes)
    monkeypatch.setattr(searched, "_psnr_db", lateness)
    frame = Frame(slots=SLOTS, target=target, level=1)
    design = design_clip([scene(0.0)], frame, trials=12)
    best = design.ranked[0]
    assert design.code.mean_db > best.mean_db + 0.5
    assert design.code.name == f"{best.name}, tuned"
    lines = dict(design.lines)
    assert lines["code"] == design.code.name
    gain_db = float(lines["tuned"].removeprefix("12 changes of the best tried: +").split()[0])
    words = [code.container(frame).words_per_frame for code in (design.code, best)]
    expected_db = design.code.mean_db - best.mean_db - 0.005 * (words[0] - words[1])
    assert gain_db == pytest.approx(expected_db, abs=0.006)
    assert design.compiled.built.words_per_frame == words[0]


def test_design_repeats_a_still_in_all_slots_beside_a_clip(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    scenes = []

    def judge(_container: object, _sensor: object, light: np.ndarray, _number: int) -> float:
        scenes.append(light)
        return 30.0

    monkeypatch.setattr(searched, "_psnr_db", judge)
    monkeypatch.setattr(searched, "clip_codes", lambda _slots: named("always open, one readout"))
    done = invoke(
        [
            "design",
            "--search",
            "--trials",
            "0",
            "--scene",
            "builtin:hdr",
            "--scene",
            "builtin:motion",
            "--exposure",
            "30000",
            "-o",
            "p.nsl",
        ],
        tmp_path,
    )
    assert done.status == 0, done.err
    still, clip = scenes
    assert still.shape == clip.shape == (16, 256, 256)
    np.testing.assert_allclose(still, still[:1].repeat(16, axis=0), rtol=1e-5)
    assert clip.std(axis=0).max() > 0.1 * clip.mean()
