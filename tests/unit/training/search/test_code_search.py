"""Ordered starts, the closed form, moves together, and the search that uses them."""

from __future__ import annotations

import itertools
import json
from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke

torch = pytest.importorskip("torch")

from small_runs import SMALL  # noqa: E402

from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_training.code_choices import ORDERED  # noqa: E402
from nscc_training.data import Batch  # noqa: E402
from nscc_training.design import Frame  # noqa: E402
from nscc_training.encoders import ShutterSpec, make_encoder  # noqa: E402
from nscc_training.loop import searching  # noqa: E402
from nscc_training.loop import train as loop  # noqa: E402
from nscc_training.loop.setup import make_setup  # noqa: E402
from nscc_training.loop.train import train  # noqa: E402
from nscc_training.search.choose import design_motion  # noqa: E402
from nscc_training.search.expected import Motion, speeds_of, texture_of, told_db  # noqa: E402
from nscc_training.search.moves import MOVING, arranged, moved, repeated  # noqa: E402
from nscc_training.settings import settings_of  # noqa: E402

SPECS = {
    "b": ShutterSpec("b", 16, (4, 8)),
    "c": ShutterSpec("c", 16, (4, 8), length=4),
    "d": ShutterSpec("d", 16, (4, 8)),
    "e": ShutterSpec("e", 16, (4, 8)),
    "codebook": ShutterSpec("codebook", 16, (4, 8), rows=16),
}


def opened(kind: str, start: str, seed: int = 0) -> np.ndarray:
    return make_encoder(SPECS[kind], start, seed).hard().numpy()


@pytest.mark.parametrize("kind", ["c", "d", "e", "codebook"])
def test_a_two_phase_start_is_the_quad_pattern_beside_its_copy_in_later_slots(kind: str) -> None:
    """The tile's left half is the pattern `quad`. Its right half opens as long, 4 slots, but at
    later slots."""
    quad, both = opened("c", "quad"), opened(kind, "two-phase")
    assert np.array_equal(both[:, :2, :2], quad[:, :2, :2])
    assert np.array_equal(both[:, 2:, 2:4], quad[:, :2, :2])
    later = both[:, :2, 2:4].argmax(axis=0)
    assert later.tolist() == [[2, 6], [10, 12]]
    assert (both.sum(axis=0) == 4).all()


@pytest.mark.parametrize("kind", ["e", "codebook"])
def test_cyclic_bumps_share_the_frame_evenly(kind: str) -> None:
    """Each of the 16 shutters opens for 4 slots. In each 2 x 2 block, one pixel is open in every
    slot."""
    found = opened(kind, "cyclic")
    assert (found.sum(axis=0) == 4).all()
    assert (found[:, :, :4].sum(axis=(1, 2)) == 4).all()
    # Each 2 x 2 block of the tile sees all of the frame, each place a quarter of it.
    for row, col in ((0, 0), (0, 2), (2, 0), (2, 2)):
        block = found[:, row : row + 2, col : col + 2].sum(axis=(1, 2))
        assert block.tolist() == [1] * 16
    assert len(np.unique(found.reshape(16, -1).T, axis=0)) == 16


def test_staggered_bumps_begin_at_moments_evenly_spread() -> None:
    """The shutters open first at slot 0 and last at 12, with no gap of more than a slot."""
    found = opened("c", "staggered")[:, :, :4].argmax(axis=0).ravel()
    steps = np.diff(np.sort(found))
    assert (found.min(), found.max()) == (0, 12)
    assert set(steps.tolist()) <= {0, 1}


@pytest.mark.parametrize(
    ("spec", "name", "reason"),
    [
        (SPECS["c"], "cyclic", "class e or a codebook"),
        (SPECS["d"], "cyclic", "end with the frame"),
        (SPECS["b"], "two-phase", "bumps for clips"),
        (ShutterSpec("c", 16, (2, 2), length=4), "staggered", "multiple"),
        (ShutterSpec("codebook", 16, (4, 4), rows=8), "cyclic", "16 shutters do not fit"),
    ],
)
def test_starts_that_a_class_of_shutters_lacks_are_refused_with_the_reason(
    spec: ShutterSpec, name: str, reason: str
) -> None:
    assert name in ORDERED
    with pytest.raises(ValueError, match=reason):
        make_encoder(spec, name)


def test_the_closed_form_equals_least_squares_by_hand() -> None:
    """The expected value is a least-squares estimate of one pixel, by hand, for still light and for
    light that changes in each slot."""
    shutters = np.zeros((8, 4, 4))
    shutters[:3] = 1
    noise, counts, contrast = 2e-3, 1e-3, 0.5
    variance = noise + counts * 3 / 8
    still = Motion((0.0,), 1e-6, contrast, noise, counts)
    wanted = 10 * np.log10(1 + (3 / 8 * contrast) ** 2 / variance)
    assert told_db(shutters, still) == pytest.approx(wanted, abs=1e-4)
    fast = Motion((1e6,), 1e-6, contrast, noise, counts)
    left = 1 - 3 / 8 / (3 + variance * (8 / contrast) ** 2)
    assert told_db(shutters, fast) == pytest.approx(-10 * np.log10(left), abs=1e-4)


def test_faster_motion_prefers_more_moments() -> None:
    """At 6 pixels a frame the pattern `quad` tells more, at 40 the one of two phases, by over 0.5
    dB."""
    slow, fast = (Motion((speed,)) for speed in (6.0, 40.0))
    codes = {name: opened("c", name) for name in ("quad", "two-phase")}
    assert told_db(codes["quad"], slow) > told_db(codes["two-phase"], slow)
    assert told_db(codes["two-phase"], fast) > told_db(codes["quad"], fast) + 0.5
    # How often the pattern is repeated in a tile does not matter.
    again = np.tile(codes["two-phase"], (1, 2, 1))
    assert told_db(again, fast) == pytest.approx(told_db(codes["two-phase"], fast), abs=1e-9)


@pytest.mark.parametrize("kind", [*MOVING])
def test_moves_of_the_search_give_legal_codes_and_change_few_or_many_places(kind: str) -> None:
    spec = SPECS[kind]
    encoder = make_encoder(spec, "random", 3)
    codes = encoder.codes()
    before = {name: values.copy() for name, values in codes.items()}
    start, many = encoder.hard(), []
    for seed in range(60):
        found = moved(spec, codes, np.random.default_rng(seed))
        encoder.load_codes(found)
        again = encoder.codes()
        assert all(np.array_equal(again[name], found[name]) for name in again)
        assert bool(encoder.hard().any(dim=0).all())
        many.append(int((encoder.hard() != start).any(dim=0).sum()))
    assert all(np.array_equal(before[name], codes[name]) for name in codes)
    assert min(many) <= 2
    assert max(many) >= spec.places // 2


@pytest.mark.parametrize("kind", [*MOVING])
def test_rearranging_codes_keeps_all_shutters_and_moves_the_requested_number(kind: str) -> None:
    """No exchange moves nothing, one moves two places at most, and 200 move half of them or more.
    The shutters themselves stay."""
    spec = SPECS[kind]
    encoder = make_encoder(spec, "random", 3)
    codes = encoder.codes()
    start = columns(encoder.hard())
    for exchanges, least, most in ((0, 0, 0), (1, 0, 2), (200, 16, 32)):
        encoder.load_codes(arranged(spec, codes, np.random.default_rng(5), exchanges))
        found = columns(encoder.hard())
        assert sorted(found) == sorted(start)
        moves = sum(a != b for a, b in zip(found, start, strict=True))
        assert least <= moves <= most


def columns(shutters: torch.Tensor) -> list[tuple[int, ...]]:
    """The slots in which each place is open, as a tuple of 0 and 1, row by row."""
    return [tuple(column) for column in shutters.flatten(1).T.int().tolist()]


@pytest.mark.parametrize("kind", ["c", "d", "e", "codebook"])
def test_a_tile_of_copies_has_its_block_later_every_time(kind: str) -> None:
    """Each shutter is the full one, rolled around the frame; a bump at the end may be cut off."""
    spec = SPECS[kind]
    encoder = make_encoder(spec, "staggered" if kind in "cd" else "cyclic")
    codes = encoder.codes()
    many = 0
    for seed in range(40):
        encoder.load_codes(repeated(spec, codes, np.random.default_rng(seed)))
        found = encoder.hard().numpy().reshape(spec.slots, -1)
        full = found[:, found.sum(axis=0).argmax()]
        around = np.array([np.roll(full, k) for k in range(spec.slots)])
        assert found.any(axis=0).all()
        # Each is one of those, or less.
        assert (around @ found >= found.sum(axis=0)).any(axis=0).all()
        many += len(np.unique(found.T, axis=0)) > 2
    assert many > 20


def test_repeating_a_start_of_class_b_draws_stops_that_are_powers_of_two() -> None:
    """From stops of 256, forty draws hold each of 1, 2, 4 to 256 and nothing else."""
    spec = ShutterSpec("b", 256, (4, 8))
    stops = np.full(spec.tile, 256)
    found = [repeated(spec, {"stop": stops}, np.random.default_rng(k))["stop"] for k in range(40)]
    assert {int(np.log2(stop)) for one in found for stop in one.ravel()} == set(range(9))
    assert all((np.log2(one) % 1 == 0).all() for one in found)


@pytest.fixture
def no_gradient(monkeypatch: pytest.MonkeyPatch) -> None:
    """Replaces the expected gain of every move by 0."""
    monkeypatch.setattr(searching, "expected_gain", lambda *_: torch.zeros(()))


def test_gains_of_single_slots_in_the_closed_form_equal_measured_changes_of_the_loss() -> None:
    """One place opens or closes in one slot, and the decoder is linear in the frame. The closed
    form has the sign and size of the change of the loss."""
    parts = make_setup(
        settings_of(
            {
                "shutter": {
                    "class": "e",
                    "slots": 6,
                    "tile": [2, 2],
                    "init": "random",
                    "relaxation": "search",
                },
                "decoder": {"name": "unet2d"},
                "loss": {"name": "l1"},
                "data": {"protocol": "video-v1"},
                "sensor": {"noise": False},
            }
        )
    )
    weights = torch.linspace(0.2, 1.0, 6).reshape(1, 6, 1, 1)
    parts.decoder.forward = lambda frame, _: weights * frame.unsqueeze(1)  # type: ignore[assignment]
    generator = np.random.default_rng(3)
    light = torch.from_numpy(generator.uniform(2000, 4000, (3, 6, 8, 8)).astype(np.float32))
    # The truth is brighter than each prediction, so the loss is linear in it.
    batch = Batch(light, torch.full_like(light, 9.0), torch.full((3,), 9.0), ())
    expected = searching.expected_gain(parts, [batch, batch], 0)
    codes = parts.encoder.codes()["bits"]
    first = searching._losses(parts, {"bits": codes}, [batch], 0)
    twice = searching._losses(parts, {"bits": codes}, [batch, batch], 0)
    assert twice.tolist() == pytest.approx([*first, *first])
    for slot in range(6):
        for place in np.ndindex(2, 2):
            flipped = codes.copy()
            flipped[place] ^= 1 << slot
            gain = (first - searching._losses(parts, {"bits": flipped}, [batch], 0)).mean()
            opens = flipped[place] >> slot & 1
            wanted = float(expected[(slot, *place)]) * (1 if opens else -1)
            assert gain == pytest.approx(wanted, rel=0.02), (slot, place)


def test_a_decoder_learns_random_codes_before_a_search() -> None:
    """A new code in every step, under effects one of a few; the run's own codes stay."""
    parts = parts_of(warm_up=0.5)
    own = parts.encoder.codes()["start"]
    tiles = [parts.random_tile(number) for number in (0, 1, 48, 0)]
    assert torch.equal(tiles[0], tiles[3])
    assert not torch.equal(tiles[0], tiles[1])
    assert not torch.equal(tiles[0], tiles[2])
    assert np.array_equal(parts.encoder.codes()["start"], own)
    # Half of the codes are the run's own codes after moves, which leave many places as they are.
    present = parts.encoder.hard()
    kept = np.array(
        [float((parts.random_tile(k) == present).all(dim=0).float().mean()) for k in range(40)]
    )
    assert kept[1::2].mean() > 0.25 > kept[::2].mean()


def test_a_decoder_learns_arrangements_before_they_are_searched() -> None:
    """Even steps see any arrangement of the run's shutters. Odd ones see its own with at most four
    exchanges."""
    parts = parts_of(relaxation="arrange", warm_up=0.5)
    own = columns(parts.encoder.hard())
    found = [columns(parts.random_tile(number)) for number in range(0, 100, 2)]
    assert all(sorted(tile) == sorted(own) for tile in found)
    assert len(set(map(tuple, found))) > 45
    # Half of the arrangements are the run's own after at most four exchanges of two places.
    near = [columns(parts.random_tile(number)) for number in range(1, 40, 2)]
    assert all(sorted(tile) == sorted(own) for tile in near)
    assert all(sum(a != b for a, b in zip(tile, own, strict=True)) <= 8 for tile in near)
    assert columns(parts.encoder.hard()) == own


def parts_of(**shutter: object) -> searching.TrainingSetup:
    search = {"class": "c", "slots": 8, "length": 2, "tile": [4, 4], "init": "random"}
    return make_setup(
        settings_of(
            {
                "shutter": {**search, "relaxation": "search", **shutter},
                "decoder": {"learn": False},
                "data": {"protocol": "video-v1"},
                "train": {"device": "cpu"},
            }
        )
    )


@pytest.mark.usefixtures("no_gradient")
def test_a_search_reduces_losses_in_spite_of_noise(monkeypatch: pytest.MonkeyPatch) -> None:
    """The loss is the mean start of the bumps plus noise; the search must find start 0 for all."""
    parts = parts_of(moves=12, judged=12)
    asked = []

    def losses(_parts: object, codes: dict[str, np.ndarray], *_batch: object) -> np.ndarray:
        asked.append(codes)
        noise = np.random.default_rng(len(asked)).normal(0, 1e-3, 4)
        return codes["start"].mean() + noise

    monkeypatch.setattr(searching, "_losses", losses)
    monkeypatch.setattr(searching, "_words", lambda _parts, _codes: 1.0)
    found = [searching.search(parts, None, step) for step in range(24)]  # type: ignore[arg-type]
    assert parts.encoder.codes()["start"].max() == 0
    assert found[-1] < 0.01


@pytest.mark.usefixtures("no_gradient")
def test_a_search_stays_within_its_limit_of_words(monkeypatch: pytest.MonkeyPatch) -> None:
    """Codes of more words have smaller losses, but the search does not take them."""
    parts = parts_of(moves=12, judged=12, most_words=3.0)
    before = parts.encoder.codes()["start"]
    own = parts.encoder.codes()
    words = {"of others": 3.5}

    def counted(_parts: object, codes: dict[str, np.ndarray]) -> float:
        return 3.0 if np.array_equal(codes["start"], own["start"]) else words["of others"]

    monkeypatch.setattr(
        searching, "_losses", lambda _p, codes, *_: np.full(2, -codes["start"].sum())
    )
    monkeypatch.setattr(searching, "_words", counted)
    searching.search(parts, None, 0)  # type: ignore[arg-type]
    assert np.array_equal(parts.encoder.codes()["start"], before)
    words["of others"] = 3.0
    searching.search(parts, None, 0)  # type: ignore[arg-type]
    assert parts.encoder.codes()["start"].sum() > before.sum()


@pytest.mark.usefixtures("no_gradient")
def test_random_bits_come_down_to_their_words_and_then_get_better() -> None:
    """The compiler counts the words. The loss falls with the number of open slots, so that without
    the limit every place would open."""
    parts = parts_of(**{"class": "e"}, moves=24, judged=4, most_words=3.0)
    first = searching._words(parts, parts.encoder.codes())
    assert first is not None
    counts, losses = [first], []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(searching, "_losses", lambda p, codes, *_: _closed(p, codes))
        for step in range(16):
            losses.append(searching.search(parts, None, step))  # type: ignore[arg-type]
            counts.append(searching._words(parts, parts.encoder.codes()) or np.inf)
    under = next(k for k, words in enumerate(counts) if words <= 3)
    assert first > 6
    assert all(
        after <= max(3, 0.9 * before) or after == before
        for before, after in itertools.pairwise(counts)
    )
    assert max(counts[under:]) <= 3
    assert losses[-1] < losses[under]


def _closed(parts: searching.TrainingSetup, codes: dict[str, np.ndarray]) -> np.ndarray:
    parts.encoder.load_codes(codes)
    closed = 1 - parts.encoder.hard().numpy().mean(axis=(1, 2))
    return np.full(2, closed.mean())


def moving(speed: float, seed: int = 0) -> np.ndarray:
    """Light (16, 64, 96) of a texture that moves by `speed` pixels over the frame; by shifting its
    phases, so that what is found is not found by what made it."""
    noise = np.random.default_rng(seed).standard_normal((64, 96))
    y, x = np.fft.fftfreq(64)[:, None], np.fft.fftfreq(96)[None]
    smooth = np.fft.fft2(noise) * (y**2 + x**2 + 1e-3) ** -0.7
    steps = np.exp(-2j * np.pi * x * speed / 16 * np.arange(16)[:, None, None])
    clip = np.fft.ifft2(smooth * steps).real
    return np.asarray(1000 * (1 + 0.3 * clip / clip.std()).clip(min=0))


def test_speeds_and_textures_measured_in_a_clip_are_those_of_its_scene() -> None:
    """Speeds of 3, 16 and 48 come back within 15 %. A still scene has none, and a flat one exactly
    0."""
    for speed in (3.0, 16.0, 48.0):
        assert np.median(speeds_of(moving(speed))) == pytest.approx(speed, rel=0.15)
    still = np.broadcast_to(moving(0)[:1], (16, 64, 96))
    assert max(speeds_of(still)) < 0.5
    assert speeds_of(np.ones((4, 8, 8))) == (0.0,) * 5
    fine, coarse = (np.kron(moving(0)[0], np.ones((k, k))) for k in (1, 4))
    assert texture_of(coarse)[0] > 2 * texture_of(fine)[0]
    assert texture_of(np.ones((1, 1))) == (1.0, 0.1)


def test_a_design_for_slow_motion_differs_from_one_for_fast_motion() -> None:
    slow, fast = (
        design_motion("scene", [moving(speed)], Frame(slots=16, level=0)) for speed in (2.0, 96.0)
    )
    assert slow.expected[slow.name] > slow.expected[fast.name]
    assert fast.expected[fast.name] > fast.expected[slow.name]
    assert design_motion("fast", frame=Frame(slots=16, level=0)).name == fast.name
    assert "start <= n < start + len" in fast.text
    many = design_motion("fast", frame=Frame(slots=16, level=0), most_words=40)
    assert many.name == "searched"
    assert many.expected[many.name] > many.expected[fast.name]
    assert "searched" not in design_motion("slow", frame=Frame(slots=12, level=0)).expected
    with pytest.raises(Rejected, match="NS0843"):
        design_motion("fast", frame=Frame(slots=16, level=0), most_words=0.5)


def test_design_for_a_motion_prints_its_code_and_writes_a_valid_program(tmp_path: Path) -> None:
    """For slow motion the command chooses `quad`. `--motion scene` without a scene, and looks
    beside a motion, are refused."""
    done = invoke(["design", "--motion", "slow", "-O", "1"], tmp_path)
    assert done.status == 0, done.err
    assert "code      quad" in done.out
    assert invoke(["check", "motion-slow.nsl"], tmp_path).status == 0
    assert "NS0744" in invoke(["design", "--motion", "scene"], tmp_path).err
    both = ["design", "--motion", "slow", "--looks", "4", "--scene", "builtin:hdr"]
    assert invoke(both, tmp_path).status == 2


def test_a_searched_run_reports_moved_codes_and_resumes(tmp_path: Path) -> None:
    shutter = {"class": "b", "slots": 8, "tile": [2, 2], "relaxation": "search", "moves": 6}
    values = {**SMALL, "shutter": shutter, "decoder": {"learn": False}}
    values["train"] = values["train"] | {"validate_every": 1}
    train(settings_of(values), tmp_path / "once")
    train(settings_of(values), tmp_path / "twice", stop_after=1)
    train(settings_of(values), tmp_path / "twice")
    once, twice = (tmp_path / name / "result.json" for name in ("once", "twice"))
    assert once.read_bytes() == twice.read_bytes()
    result = json.loads(once.read_text())
    codes, card = result["codes"], (tmp_path / "once/model_card.md").read_text()
    start = make_encoder(ShutterSpec("b", 8, (2, 2)), "quad").codes()["stop"]
    with np.load(tmp_path / "once/codes.npz") as found:
        assert codes["moved"] == int((found["stop"] != start).sum())
    assert isinstance(codes["start_alone_psnr_db"], float)
    alone = result["robustness"][0]["psnr_db"] - codes["start_alone_psnr_db"]
    assert (codes["moved"] == 0) == (alone == 0)
    assert ("start alone" in card) == (codes["moved"] > 0)


def test_only_a_search_accepts_a_limit_of_words_and_its_result_obeys_it(tmp_path: Path) -> None:
    """A limit of 0.25 words that no code keeps gives NS0850 and no result. With another relaxation
    the limit is refused."""
    shutter = {"class": "b", "slots": 8, "tile": [2, 2], "relaxation": "search", "moves": 2}
    values = {**SMALL, "shutter": shutter | {"most_words": 0.25}, "decoder": {"learn": False}}
    with pytest.raises(Rejected, match="NS0850"):
        train(settings_of(values), tmp_path / "never")
    assert not (tmp_path / "never/result.json").exists()
    assert (tmp_path / "never/metrics.csv").exists()
    values["shutter"] = shutter | {"most_words": 0.25, "relaxation": "tried"}
    with pytest.raises(Rejected, match="only a search stays within a limit of words"):
        make_setup(settings_of(values))


def test_settling_begins_with_the_best_validated_codes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The search makes codes worse after its first validation. Then the first codes return, and
    only the decoder learns."""

    def astray(parts: searching.TrainingSetup, *_: object) -> float:
        stop = parts.encoder.codes()["stop"]
        parts.encoder.load_codes({"stop": np.minimum(2 * stop, 8)})
        return 0.0

    monkeypatch.setattr(loop, "search", astray)
    shutter = {"class": "b", "slots": 8, "tile": [2, 2], "relaxation": "search", "settle": 0.5}
    values = {**SMALL, "shutter": shutter}
    values["train"] = {**values["train"], "steps": 4, "validate_every": 1, "rate": 0.0}
    train(settings_of(values), tmp_path / "run")
    lines = (tmp_path / "run/metrics.csv").read_text().splitlines()[1:]
    rows = [line.split(",") for line in lines if ",val," in line]
    first, second, *settled = [float(row[2]) for row in rows]
    assert first < second
    assert settled == [first] * 2
