"""Learned shutters: codes mean what the classes say, files keep them, gradients flow."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from nscc_command import invoke
from training_oracle import shutters_of, small_target

torch = pytest.importorskip("torch")

from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_training.code_choices import SLOPED  # noqa: E402
from nscc_training.codes_files import codes_bytes, load_codes, save_codes  # noqa: E402
from nscc_training.encoders import ShutterSpec, make_encoder  # noqa: E402
from nscc_training.programs import Chip, compiled, legal_codes, program_of  # noqa: E402
from nscc_training.sensor_model import SensorModel, differentiable_capture  # noqa: E402

SPECS = [
    ShutterSpec("a", 6, (1, 1)),
    ShutterSpec("b", 32, (4, 4)),
    ShutterSpec("c", 16, (3, 5), length=4),
    ShutterSpec("d", 12, (4, 4)),
    ShutterSpec("e", 13, (4, 2)),
    ShutterSpec("codebook", 24, (4, 4), rows=16),
    ShutterSpec("codebook", 9, (4, 4), rows=5),
]
STARTS = ["random", "uniform", "quad"]
IDEAL = SensorModel(full_well_e=30000.0, electrons_per_lsb=30000.0 / 255)


def name_of(spec: ShutterSpec) -> str:
    return f"{spec.kind}{spec.slots}"


@pytest.mark.parametrize("start", STARTS)
@pytest.mark.parametrize("spec", SPECS, ids=name_of)
def test_shutters_are_those_of_the_codes(spec: ShutterSpec, start: str) -> None:
    encoder = make_encoder(spec, start, seed=3)
    hard = encoder.hard().numpy()
    wanted = shutters_of(spec.kind, spec.slots, encoder.codes(), spec.length)
    assert (hard == wanted).all()
    assert (encoder(torch.Generator()).detach().numpy() == wanted).all()
    again = make_encoder(spec, "uniform")
    again.load_codes(encoder.codes())
    assert torch.equal(again.hard(), encoder.hard())


@pytest.mark.parametrize("spec", SPECS, ids=name_of)
def test_a_program_opens_the_same_shutters(spec: ShutterSpec, tmp_path: Path) -> None:
    """`nscc build` accepts the files, and the words replayed are the encoder's hard pass."""
    encoder = make_encoder(spec, "random", seed=5)
    files = program_of(encoder, Chip())
    (tmp_path / "shutter.nsl").write_text(files.text)
    built = invoke(["build", "shutter.nsl", "-O", "1", "-o", "s.icw"], tmp_path)
    assert built.status == 0, built.err
    assert invoke(["shutters", "s.icw", "-o", "s.npz"], tmp_path).status == 0
    with np.load(tmp_path / "s.npz") as found:
        shape = found["shutter_shape"]
        bits = np.unpackbits(found["shutter"], axis=-1, count=shape[3], bitorder="little")[0]
    rows, cols = spec.tile
    hard = encoder.hard().numpy().transpose(1, 2, 0)
    expected = np.tile(hard, (-(-shape[1] // rows), -(-shape[2] // cols), 1))
    assert (bits == expected[: shape[1], : shape[2]]).all()
    assert program_of(encoder, Chip()) == files


def test_a_tile_of_odd_size_is_listed() -> None:
    encoder = make_encoder(ShutterSpec("b", 32, (40, 50)), "random", seed=1)
    found = compiled(program_of(encoder, Chip()), Chip())
    assert found.program.pixel_codes is not None
    stops = found.program.table.codes[found.program.pixel_codes, 0]
    wanted = np.tile(encoder.codes()["stop"], (7, 6))[:256, :256]
    assert (stops == wanted).all()


def test_a_large_tile_goes_into_a_file_with_its_digest(tmp_path: Path) -> None:
    chip = Chip(target=str(tmp_path / "small.toml"))
    text = invoke(["targets", "scamp5", "--toml"], tmp_path).out
    Path(chip.target).write_text(small_target(text, 64, 72))
    encoder = make_encoder(ShutterSpec("b", 8, (64, 72)), "random", seed=1)
    files = program_of(encoder, chip)
    assert len(files.text) < 400
    found = compiled(files, chip)
    table, pixels = found.program.table, found.program.pixel_codes
    assert (table.codes[pixels, 0] == encoder.codes()["stop"]).all()
    (tmp_path / "shutter.nsl").write_text(files.text)
    (tmp_path / "codes.npz").write_bytes(codes_bytes({"stop": encoder.codes()["stop"] * 0 + 1}))
    damaged = invoke(["check", "shutter.nsl", "--target", "small.toml"], tmp_path)
    assert "NS0315" in damaged.codes


@pytest.mark.parametrize("ending", [".npz", ".mat", ".MAT"])
@pytest.mark.parametrize("spec", SPECS[1:], ids=name_of)
def test_codes_survive_a_file(spec: ShutterSpec, ending: str, tmp_path: Path) -> None:
    encoder = make_encoder(spec, "random", seed=9)
    path = tmp_path / f"codes{ending}"
    save_codes(str(path), encoder.codes())
    other = make_encoder(spec, "quad")
    other.load_codes(load_codes(path))
    assert torch.equal(other.hard(), encoder.hard())


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: save_codes("codes.txt", {}), "is not a format for codes"),
        (lambda: save_codes("codes.npz", []), "takes arrays by the names of fields, not a list"),
        (
            lambda: save_codes("codes.npz", {"stop": np.zeros((0, 2), int)}),
            "'stop' .* is not a code",
        ),
        (lambda: load_codes(3), "takes a path, not 3"),
        (lambda: make_encoder("b"), "spec of type ShutterSpec, not the text 'b'"),
        (lambda: make_encoder(ShutterSpec("b", 8.5, (2, 2))), "slots is a whole number from 1"),
        (lambda: make_encoder(ShutterSpec("b", 8, (2, 2, 2))), "two sides of the tile is"),
        (lambda: make_encoder(ShutterSpec("b", 8, (2, 2), buckets=3)), "buckets is a whole number"),
        (lambda: program_of(None, Chip()), "encoder of type Encoder, not None"),
        (lambda: Chip(slot_us="x"), "slot_us is a finite number"),
        (lambda: Chip(Path("chip.toml")), "target of type str, not a PosixPath"),
    ],
)
def test_wrong_arguments_are_refused(call: Any, words: str) -> None:
    with pytest.raises(Rejected, match=words):
        call()


def test_bad_codes_are_refused(tmp_path: Path) -> None:
    encoder = make_encoder(ShutterSpec("d", 8, (2, 2)), "quad")
    good = encoder.codes()
    for bad, words in (
        ({"start": good["start"]}, "the field 'stop' is missing"),
        ({**good, "stop": good["stop"][:1]}, "tile"),
        ({**good, "stop": good["stop"] + 8}, "outside"),
        ({"start": good["stop"] - 1, "stop": good["stop"] * 0 + 1}, "before it starts"),
    ):
        with pytest.raises(ValueError, match=words):
            encoder.load_codes(bad)
    for number, content in enumerate((b"", b"PK\x03\x04", b"nonsense")):
        path = tmp_path / f"{number}.npz"
        path.write_bytes(content)
        with pytest.raises(Rejected, match="NS0805"):
            load_codes(path)
    np.savez(tmp_path / "half.npz", stop=np.full((2, 2), 0.5))
    with pytest.raises(Rejected, match="not a code"):
        load_codes(tmp_path / "half.npz")
    np.savez(tmp_path / "beyond.npz", bits=np.full((2, 2), 2**64 - 1, np.uint64))
    with pytest.raises(Rejected, match="not a code"):
        load_codes(tmp_path / "beyond.npz")
    with pytest.raises(Rejected, match="NS0805"):
        load_codes(tmp_path / "none.mat")


def test_codes_that_do_not_compile_give_the_error_of_the_compiler() -> None:
    """Sixteen free bits do not fit thirteen registers when every code is wanted."""
    encoder = make_encoder(ShutterSpec("e", 16, (2, 2)), "random")
    compiled(program_of(encoder, Chip()), Chip())
    with pytest.raises(Rejected, match="NS0412") as caught:
        compiled(program_of(encoder, Chip()), Chip(), every_code=True)
    data = caught.value.diagnostics[-1].data
    assert data["resource"]
    with pytest.raises(Rejected, match="NS0601"):
        compiled(program_of(encoder, Chip(slot_us=0.3)), Chip(slot_us=0.3))


def test_codes_and_gradients_respect_the_statement_require() -> None:
    chip = Chip(require="(stop - start) % 3 == 0")
    spec = ShutterSpec("d", 12, (4, 4))
    legal = legal_codes(spec, chip)
    assert {tuple(c) for c in legal.tolist()} == {
        (a, b) for a in range(12) for b in range(a + 1, 13) if (b - a) % 3 == 0
    }
    encoder = make_encoder(spec, "random", seed=2)
    encoder.restrict(legal)
    codes = encoder.codes()
    assert ((codes["stop"] - codes["start"]) % 3 == 0).all()
    assert (encoder.hard().numpy() == shutters_of("d", 12, codes)).all()
    compiled(program_of(encoder, chip), chip)
    encoder().sum().backward()
    assert torch.isfinite(encoder.start.grad).all()


def test_random_codes_are_uniform_over_those_that_are_required() -> None:
    spec = ShutterSpec("b", 64, (40, 40))
    legal = legal_codes(spec, Chip(require="stop <= 4"))
    encoder = make_encoder(spec, "random", seed=2)
    encoder.restrict(legal, np.random.default_rng(2))
    counts = np.bincount(encoder.codes()["stop"].ravel(), minlength=5)
    # 1600 pixels, 400 for each of four stops, within five standard deviations.
    assert counts.sum() == counts[1:5].sum() == 1600
    assert np.abs(counts[1:5] - 400).max() < 5 * 400**0.5


@pytest.mark.parametrize("start", ["uniform", "quad", "random"])
def test_codes_obey_requirements_from_the_start_and_after_steps(start: str) -> None:
    """A parameter far from the legal codes would change nothing for thousands of steps."""
    spec = ShutterSpec("d", 16, (4, 4))
    encoder = make_encoder(spec, start, seed=2)
    encoder.restrict(legal_codes(spec, Chip(require="stop <= 4 and start >= 1")))
    codes = encoder.codes()
    for name, parameter in encoder.named_parameters():
        assert (parameter.detach().numpy() == codes[name]).all()
    with torch.no_grad():
        encoder.stop.add_(9.0)
    encoder.project()
    assert encoder.stop.max() <= 4


def test_codes_that_require_forbids_are_not_loaded() -> None:
    spec = ShutterSpec("d", 12, (1, 2))
    encoder = make_encoder(spec)
    encoder.restrict(legal_codes(spec, Chip(require="(stop - start) % 3 == 0")))
    encoder.load_codes({"start": np.array([[0, 1]]), "stop": np.array([[3, 7]])})
    with pytest.raises(ValueError, match="require"):
        encoder.load_codes({"start": np.array([[0, 1]]), "stop": np.array([[3, 6]])})


def test_random_codes_are_uniform_over_the_legal_ones() -> None:
    spec = ShutterSpec("d", 4, (100, 100))
    codes = make_encoder(spec, "random", seed=1).codes()
    pairs, counts = np.unique(
        np.stack([codes["start"].ravel(), codes["stop"].ravel()]), axis=1, return_counts=True
    )
    assert pairs.shape[1] == 10  # N (N + 1) / 2
    assert abs(counts - 1000).max() < 5 * 30
    stops = make_encoder(ShutterSpec("b", 8, (100, 100)), "random", seed=1).codes()["stop"]
    assert (np.bincount(stops.ravel(), minlength=9)[1:] > 1000).all()


def test_the_quad_is_the_two_by_two_pattern() -> None:
    stop = make_encoder(ShutterSpec("b", 256, (4, 4)), "quad").codes()["stop"]
    assert stop.tolist() == [[256, 64, 256, 64], [16, 4, 16, 4]] * 2


@pytest.mark.parametrize("relaxation", SLOPED)
@pytest.mark.parametrize("spec", SPECS[1:], ids=name_of)
def test_projection_keeps_parameters_where_gradients_live(
    spec: ShutterSpec, relaxation: str
) -> None:
    """After three steps of a huge rate the parameters are still in their ranges. The hard shutters
    have changed and are those of the codes."""
    encoder = make_encoder(spec, "random", 0, relaxation)
    generator = torch.Generator().manual_seed(0)
    encoder.noise = 0.1
    optimiser = torch.optim.SGD(encoder.parameters(), lr=1e3)
    before = encoder.hard()
    wish = torch.rand(spec.slots, *spec.tile, generator=generator)
    for _ in range(3):
        optimiser.zero_grad()
        ((encoder(generator) - wish) ** 2).sum().backward()
        optimiser.step()
        encoder.project()
    for parameter, (low, high) in encoder.ranges():
        assert parameter.min() >= low
        assert parameter.max() <= high
    assert not torch.equal(encoder.hard(), before)
    assert (
        encoder.hard().numpy() == shutters_of(spec.kind, spec.slots, encoder.codes(), spec.length)
    ).all()


@pytest.mark.parametrize("relaxation", ["sigmoid", "gumbel"])
@pytest.mark.parametrize("spec", SPECS[1:], ids=name_of)
def test_a_relaxation_at_a_low_temperature_equals_the_hard_shutters(
    spec: ShutterSpec, relaxation: str
) -> None:
    encoder = make_encoder(spec, "random", 4, relaxation)
    encoder.temperature = 1e-3
    soft = encoder(None).detach()
    assert torch.allclose(soft, encoder.hard(), atol=1e-6)


def test_the_gradient_of_a_stop_is_the_light_of_the_slots_beside_it() -> None:
    """More light is wanted: every stop must rise, by the light of the slots beside it."""
    encoder = make_encoder(ShutterSpec("b", 8, (1, 2)), "uniform")
    encoder.load_codes({"stop": np.array([[3, 5]])})
    light = torch.arange(1.0, 9.0).reshape(1, 8, 1, 1).repeat(1, 1, 1, 2)
    differentiable_capture(light, encoder, IDEAL).exposure_e.sum().backward()
    # At boundary 3 lie slots 2 and 3, with 3 and 4 electrons; an octave has log(2) times the stop.
    np.testing.assert_allclose(encoder.stop.grad, np.log(2) * np.array([[3 * 3.5, 5 * 5.5]]))


def test_a_codebook_with_a_row_for_each_place_represents_any_shutters() -> None:
    wish = np.random.default_rng(6).random((9, 4, 4)) < 0.5
    book = wish.reshape(9, 16).T.astype(np.int64)
    encoder = make_encoder(ShutterSpec("codebook", 9, (4, 4), rows=16), "uniform")
    encoder.load_codes({"id": np.arange(16).reshape(4, 4), "book": book})
    assert (encoder.hard().numpy() == wish).all()
    assert encoder.unused_share() == 0  # type: ignore[operator]


@pytest.mark.parametrize("kind", ["c", "d", "e", "codebook"])
def test_yardsticks_have_two_bumps_each_in_a_part_of_the_frame(kind: str) -> None:
    """Halves of the frame by rows and by places, and rows that overlap: 0..11 and 5..16 of 16."""
    length = {"rows": 8, "checker": 8, "overlapping-rows": 11}
    for name, slots in length.items():
        spec = ShutterSpec(kind, 16, (2, 4), length=slots if kind == "c" else None, rows=2)
        opened = make_encoder(spec, name).hard().numpy() > 0
        y, x = np.mgrid[:2, :4]
        late = (y + x if name == "checker" else y) % 2 == 1
        n = np.arange(16).reshape(-1, 1, 1)
        np.testing.assert_array_equal(opened, np.where(late, n >= 16 - slots, n < slots), name)
    with pytest.raises(ValueError, match="every 2 x 2 places"):
        make_encoder(ShutterSpec("d", 16, (1, 2)), "rows")


def test_exposure_times_are_learned_in_octaves() -> None:
    """Equal steps change all exposure times by the same ratio, up to the limits, whose gradient is
    not lost."""
    encoder = make_encoder(ShutterSpec("b", 100, (1, 3)), "uniform")
    encoder.load_codes({"stop": np.array([[1, 8, 100]])})
    [(parameter, limits)] = encoder.ranges()
    np.testing.assert_allclose(limits, (0, np.log2(100)))
    encoder(None).sum().backward()
    np.testing.assert_allclose(parameter.grad[0, 1], 8 * np.log(2))
    assert (parameter.grad > 0).all()
    with torch.no_grad():
        parameter.add_(1.0)
    encoder.project()
    assert encoder.codes()["stop"].tolist() == [[2, 16, 100]]


@pytest.mark.parametrize("spec", SPECS[1:], ids=name_of)
def test_jitter_makes_equal_places_unequal_and_keeps_codes_legal(spec: ShutterSpec) -> None:
    encoder = make_encoder(spec, "uniform")
    start = encoder.codes()
    encoder.jitter(1.0, np.random.default_rng(1))
    for parameter, (low, high) in encoder.ranges():
        values = parameter.detach()
        assert len(values.unique()) > 1
        assert low <= values.min()
        assert values.max() <= high
    if spec.kind in ("e", "codebook"):  # digits are as they were
        assert all((values == start[name]).all() for name, values in encoder.codes().items())
