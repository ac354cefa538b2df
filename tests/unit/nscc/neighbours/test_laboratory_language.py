"""The statements of version 4: what is refused, and what stays a name before it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.ndimage import binary_propagation

import nscc
import nscc_runtime
from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.neighbours.picture_report import pictures_us
from nscc.neighbours.pictures_proof import pictures_fault
from nscc.operations import op
from nscc.pipeline import Options, run_passes
from nscc.record import Record
from nscc.source import Source
from nscc.syntax.format import format_source
from nscc.syntax.parse import parse
from nscc.words.container import Container
from nscc.words.encoding import encode, matching
from nscc.words.file import from_bytes, to_bytes
from nscc.words.legality import picture_words
from nscc.words.picture_launches import LaunchLoop, Times
from nscc_runtime.device.objects import upload_of
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.neighbours.pictured_program import PicturedProgram
from nscc_runtime.sensor import default_sensor

HEAD = "nsl 4 frame 4 slots of 1ms open when true outside 0 "
CROSS = "kernel k = [[0, 1, 0], [1, 1, 1], [0, 1, 0]] "
BRIGHT = "param t : 1% .. 20% = 4% plane p = exposure > t "


def container_of(text: str) -> Container:
    made = run_passes(Source("p.nsl", text), Path(), Options(level=1, cache=False)).container
    assert made is not None
    return made


def refused(text: str) -> list[str]:
    with pytest.raises(Rejected) as caught:
        container_of(HEAD + text)
    return [diagnostic.code for diagnostic in caught.value.diagnostics]


@pytest.mark.parametrize("version", [1, 2, 3])
def test_words_of_version_4_are_names_before_it(version: int) -> None:
    """`param` and `input` are free names in versions 1 to 3."""
    text = f"nsl {version} frame 4 slots of 1ms let param = 1 let input = 2 open when n < param"
    assert parse(Source("p.nsl", text))[1] == ()


def test_repeat_with_flood_count_and_sum_stay_names() -> None:
    text = HEAD + (
        "let with = 2 plane repeat = exposure > 4% plane flood = repeat and x > with "
        "plane sum = flood repeat with repeat read sum"
    )
    assert container_of(text).pictures.loops[0].times == Times(2, 2)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("param t : 1% .. 20% = 30% plane p = exposure > t read p", "NS0545"),
        ("param t : 1% .. 20 = 4% plane p = exposure > t read p", "NS0545"),
        ("param t : 1% .. 900% = 4% plane p = exposure > t read p", "NS0545"),
        ("param m : 0 .. 4 = 2 plane p = exposure > m read p", "NS0533"),
        ("param m : 0 .. 4 = 2 let j = m plane p = x > j read p", "NS0208"),
        ("param m : 0 .. 4 = 2 plane p = x > m read p", "NS0531"),
        (BRIGHT + "plane q = p[t, 0] read q", "NS0545"),
        (BRIGHT + "plane q = p[300, 0] read q", "NS0541"),
        (BRIGHT + "plane q = p repeat (1 - 2) q[1, 0] read q", "NS0531"),
        (BRIGHT + "plane q = p repeat 65537 q[1, 0] read q", "NS0531"),
        ("param m : 0 .. 99999999 = 2 input plane p plane q = p repeat m q[1, 0] read q", "NS0531"),
        (BRIGHT + "plane q = p repeat 2 r read q", "NS0214"),
        (BRIGHT + "plane q = flood(p, p) read q", "NS0531"),
        (BRIGHT + CROSS + "plane q = flood(p, p, k, at most 0) read q", "NS0531"),
        (BRIGHT + CROSS + "plane q = p repeat 2 flood(p, q, k) read q", "NS0539"),
        (BRIGHT + "param m : 0 .. 4 = 2 image v = exposure * m read v", "NS0531"),
        (BRIGHT + "param m : 0 .. 4 = 2 image v = exposure + m read v", "NS0533"),
        (BRIGHT + "image v = exposure + 4 read v", "NS0533"),
        (BRIGHT + "image v = max(exposure, p) read v", "NS0531"),
        (BRIGHT + "plane q = t + 4% > 3% read q", "NS0533"),
        (BRIGHT + "image v = exposure + 90% read v", "NS0540"),
        (BRIGHT + "report any exposure", "NS0214"),
        (BRIGHT + "image v = exposure repeat 30 v + exposure read v", "NS0540"),
        (BRIGHT + "image v = exposure repeat 2 v[1, 0] * 4 / 2 read v", "NS0540"),
        (BRIGHT + "state s : image next s = exposure read p", "NS0543"),
        (BRIGHT + "state s : image kept = 3 next s = exposure read p", "NS0543"),
        (BRIGHT + "state s : image kept next s = s + exposure read p", "NS0540"),
        (BRIGHT + "report sum p", "NS0214"),
        (BRIGHT + "input plane q pixels q = x + 1 read p, q", "NS0301"),
        (BRIGHT + "input plane q pixels q = tile [[0, 1]] read p, q", "NS0545"),
    ],
)
def test_invalid_statements_of_version_4_are_refused(text: str, code: str) -> None:
    assert code in refused(text)


@pytest.mark.parametrize(
    "statement", ["param t : 1% .. 20% = 4%", "input plane p", "state s : image kept = 4%"]
)
def test_values_of_the_host_that_nothing_uses_are_refused(statement: str) -> None:
    """A parameter, an input plane or a kept image that nothing reads gives an error at its
    statement."""
    text = f"nsl 4\nframe 4 slots of 1ms\n{statement}\nopen when true\n"
    with pytest.raises(Rejected, match="reads out and reports nothing") as refusal:
        run_passes(Source("p.nsl", text), Path(), Options(level=1))
    assert f" 3 | {statement}\n   | ^^^^" in str(refusal.value)


@pytest.mark.parametrize(
    ("params", "inputs"),
    [
        ({"u": "4%"}, None),
        ({"t": "30%"}, None),
        ({"t": "4"}, None),
        ({"t": None}, None),
        ({"m": 5}, None),
        ({"m": 1.5}, None),
        ({"m": True}, None),
        ([{"m": 1}, 3], None),
        (3, None),
        (None, {"p": np.zeros((256, 256))}),
        (None, {"q": np.zeros((4, 4), np.bool_)}),
        (None, {"q": np.full((256, 256), 2)}),
        (None, {"q": "no_such.npy"}),
    ],
)
def test_values_of_the_host_are_checked(params: Any, inputs: Any) -> None:
    program = nscc.compile(
        HEAD + BRIGHT + "param m : 0 .. 4 = 2 input plane q plane r = q and p[m, 0] read r"
    )
    with pytest.raises(Rejected) as caught:
        nscc_runtime.capture(program, np.ones((256, 256)), params=params, inputs=inputs)
    assert {each.code for each in caught.value.diagnostics} <= {"NS0546", "NS0313", "NS0789"}


@pytest.mark.parametrize("ending", ["npy", "npz", "png"])
def test_a_file_of_bits_that_does_not_exist_is_named_with_what_to_give(ending: str) -> None:
    """The message is the same for arrays and pictures: the file, that it does not exist, what to
    name instead."""
    program = nscc.compile(HEAD + BRIGHT + "input plane q plane r = q and p read r")
    with pytest.raises(Rejected, match=f"cannot read 'no_such.{ending}': the file does not exist"):
        nscc_runtime.capture(program, np.ones((256, 256)), inputs={"q": f"no_such.{ending}"})


def test_meta_has_the_parameters() -> None:
    """Parameters that a frame does not name keep the value of the frame before. Levels are rounded
    to whole steps."""
    program = nscc.compile(HEAD + BRIGHT + "param m : 0 .. 4 = 2 plane r = p[m, 0] read r")
    lights = np.ones((3, 4, 256, 256))
    film = nscc_runtime.film(program, lights, params=[{"m": 1}, {"t": 2362.2}, {}])
    level = 5 * 30000 / 127
    assert [row["m"] for row in film.meta["params"]] == [1, 1, 1]
    np.testing.assert_allclose(
        [row["t"] for row in film.meta["params"]], [level, 2 * level, 2 * level]
    )


def test_the_format_keeps_the_meaning() -> None:
    text = (
        HEAD
        + BRIGHT
        + CROSS
        + (
            "image v = exposure repeat 64 (v[0, -1] + v[0, -1] if m else v + v + v + v + v) / 8 "
            "with plane m = p repeat m[0, 1] "
            "plane f = flood(p, m, k, at most 20) state s : image kept = -3% next s = v when f "
            "read f, v"
        )
    )
    formatted = format_source(Source("p.nsl", text))
    assert format_source(Source("p.nsl", formatted)) == formatted
    assert "\n    with plane m = p repeat m[0, 1]\n" in formatted


def changed_loops(container: Container, change: Any) -> list[Container]:
    pictures = container.pictures
    return [
        replaced(container, pictures=replaced(pictures, loops=(*pictures.loops[:n], loop, *after)))
        for n in range(len(pictures.loops))
        for after in [pictures.loops[n + 1 :]]
        for loop in [change(pictures.loops[n])]
    ]


def replaced(record: Any, **fields: Any) -> Any:
    from dataclasses import replace

    return replace(record, **fields)


def test_the_proof_notices_wrong_loops() -> None:
    """The changes are one step too many, another register, and another sign."""
    container = container_of(
        HEAD + BRIGHT + "image v = exposure repeat 6 (v[0, -1] if m else v) "
        "with plane m = p repeat m[0, 1] read v, p"
    )
    assert pictures_fault(container) is None
    assert to_bytes(from_bytes(to_bytes(container), "p.icw")) == to_bytes(container)

    def longer(loop: LaunchLoop) -> Record:
        return replaced(loop, times=Times(7, 7))

    def moved(loop: LaunchLoop) -> Record:
        values = tuple(
            replaced(value, register="F" if value.register in "ABCDE" else "R11")
            for value in loop.values
        )
        return replaced(loop, values=values)

    def negated(loop: LaunchLoop) -> Record:
        return replaced(loop, values=tuple(replaced(v, sign=-v.sign) for v in loop.values))

    def shorter(loop: LaunchLoop) -> Record:
        return replaced(loop, values=loop.values[:1])

    for change in (longer, moved, negated, shorter):
        for wrong in changed_loops(container, change):
            assert pictures_fault(wrong) is not None, change.__name__


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("state s : image kept = 4% plane p = exposure - s > 4% read p", "1181.1023622047244 e"),
        ("param m : 0 .. 9999999999 = 2 plane p = exposure > 4% read p", "2147483648"),
    ],
)
def test_programs_beyond_every_loader_are_refused(text: str, why: str) -> None:
    """A level and a range beyond what any loader takes give NS0765 with the number."""
    with pytest.raises(Rejected) as caught:
        upload_of(container_of(HEAD + text), bytes(32))
    assert [each.code for each in caught.value.diagnostics] == ["NS0765"]
    assert why in caught.value.diagnostics[0].message


LEVELS = """
assume exposure <= 40%
state s : image kept = 8%
image v = 0 if exposure - s > t + 3% else exposure - 10% + t
image w = min(v, s) + (exposure + 5%) / 2
next s = max(s - 2%, exposure / 2) + 1%
report sum exposure
read v, w, s
"""


def test_images_add_levels_and_take_the_larger_of_two() -> None:
    program = nscc.compile(HEAD + "param t : 1% .. 20% = 4%" + LEVELS)
    step = 30000 / 127
    rng = np.random.default_rng(3)
    lights = ((rng.integers(0, 48, (20, 1, 256, 256)) + 0.375) * step / 4).repeat(4, axis=1)
    params = [{"t": (4 + frame % 7) * step} for frame in range(20)]
    film = nscc_runtime.film(program, lights, params=params)
    s = np.full((256, 256), 0.08 * 30000)
    for frame, e in enumerate(lights.astype(np.float32).astype(np.float64).sum(axis=1)):
        t = params[frame]["t"]
        v = np.where(e - s > t + 4 * step, 0, e - 13 * step + t)
        w = np.minimum(v, s) + (e + 6 * step) / 2
        s = np.maximum(s - 3 * step, e / 2) + step
        for name, values in (("v", v), ("w", w), ("s", s)):
            np.testing.assert_allclose(film.images[name][frame], values, atol=1e-6)
        assert film.reports["sum exposure"][frame] == pytest.approx(e.sum(), rel=1e-12)


def test_a_chain_of_choices_writes_in_place_when_no_register_is_free() -> None:
    text = (
        "input plane i plane p = exposure > 50% plane q = p[1, 1] if y < 64 else p[-1, 0] "
        "if y < 128 else p[0, 1] if y < 192 else p[0, -1] read i, q"
    )
    words = [op.name for op, _ in picture_words(container_of(HEAD + text))]
    assert "NOR.write" in words


def test_the_error_for_sixteen_counts_names_the_largest_number_that_fits() -> None:
    """Twelve counts fit, sixteen beside a sum do not, and the message says twelve."""

    def counts(number: int) -> str:
        return " ".join(
            f"plane above{k} = exposure > {6 * k + 6}% report count above{k}" for k in range(number)
        )

    assert len(container_of(HEAD + counts(12)).pictures.reports) == 12
    with pytest.raises(Rejected, match="report at most 12 of these 16 planes"):
        container_of(HEAD + "report sum exposure " + counts(16))


def test_an_error_of_registers_names_what_holds_them() -> None:
    """Planes that are kept from frame to frame, R1 to R4, and the plane of the program whose shift
    by a parameter needs one register more."""
    kept = "".join(f"state h{k} : bit = 0 kept next h{k} = exposure > t " for k in range(7))
    text = f"param t : 1% .. 20% = 4% param m : 0 .. 4 = 2 {kept} plane q = h6[m, 0] read q"
    with pytest.raises(Rejected) as caught:
        container_of(HEAD + text)
    notes = caught.value.diagnostics[0].notes
    assert "keep these from frame to frame: `h0`, `h1`, " in notes[0]
    assert notes[1] == "R1 to R4 choose neighbours until `q` is computed"
    assert str(caught.value).startswith("error[NS0535]: `q` needs 9 digital registers")


def test_an_error_of_range_says_why_smaller_values_do_not_fit_either() -> None:
    """Any limit leaves 13 counted planes for 12 registers."""
    counts = "".join(f"plane a{k} = v > {k + 1}% report count a{k} " for k in range(13))
    with pytest.raises(Rejected, match="do not fit either: `a12` needs 13 digital registers"):
        container_of(HEAD + "image v = 2 * exposure " + counts)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("param t : 1% .. 20% = 30% plane p = exposure > t read p", "start 30% is outside 1% .. 2"),
        (
            "param a : 0..2 = 1 param b : 0..2 = 1 " + BRIGHT + "read q plane q = p[a + b, 0]",
            "one i",
        ),
        ("param m : 0 .. 4 = 2 plane p = x == m read p", "declare `input plane NAME`"),
        ("image v = min(exposure) read v", "`min(A, B)` has two images"),
        ("image v = exposure / 2 report count v", "`report sum IMAGE`"),
        (BRIGHT + "report sum p", "names that can be used here: `exposure`"),
        (BRIGHT + "report mean p", "`report count P`"),
        ("read exposure", "`bucket NAME open when ...`"),
    ],
)
def test_an_error_says_what_to_write(text: str, message: str) -> None:
    """There is one error, without others that follow from it."""
    with pytest.raises(Rejected) as caught:
        container_of(HEAD + text)
    assert len(caught.value.diagnostics) == 1
    assert message in str(caught.value)


def test_conditions_over_places_that_follow_each_other_are_one_plane() -> None:
    text = (
        "plane p = exposure > 20% plane q = p and 3 <= x < 9 and y > 4 and (x + y) % 3 == 0 read q"
    )
    program = nscc.compile(HEAD + text)
    assert len(program.container.pictures.inputs) == 1
    y, x = np.mgrid[:256, :256]
    light = np.tile((x % 2) * 3000.0, (4, 1, 1))
    found = nscc_runtime.capture(program, light).planes["q"]
    expected = (x % 2 == 1) & (x >= 3) & (x < 9) & (y > 4) & ((x + y) % 3 == 0)
    np.testing.assert_array_equal(found, expected)


def test_a_program_may_read_one_exposure_and_compute_nothing() -> None:
    text = "nsl 4 frame 4 slots of 1ms bucket a open when n < 1 bucket b open when n > 0 read b"
    light = np.arange(4.0)[:, None, None] * np.ones((256, 256)) * 900
    capture = nscc_runtime.capture(nscc.compile(text), light)
    assert capture.meta["buckets"] == ["b"]
    np.testing.assert_allclose(capture.exposure_e[0], 5400, atol=1e-6)


@pytest.mark.parametrize("sign", ["-", "+"])
def test_a_sum_may_have_more_terms_than_a_word_has_sources(sign: str) -> None:
    levels = (10, 5, 2.5, 1.25, 0.75)
    images = [
        f"image p{k} = {level}% if x % {k + 2} == 0 else 0 " for k, level in enumerate(levels)
    ]
    text = (
        HEAD + "".join(images) + f"image s = {f' {sign} '.join(f'p{k}' for k in range(5))} read s"
    )
    found = nscc_runtime.capture(nscc.compile(text), np.ones((256, 256))).images["s"]
    step_e = 30000 / 127
    parts = [
        round(w * 300 / step_e) * step_e * (np.arange(256) % (k + 2) == 0)
        for k, w in enumerate(levels)
    ]
    expected = parts[0] + (1 if sign == "+" else -1) * sum(parts[1:])
    np.testing.assert_allclose(found, np.broadcast_to(expected, (256, 256)), atol=1e-6)


def test_a_kept_image_may_approach_its_range() -> None:
    text = (
        "assume exposure <= 50% kernel k = [[1, 2, 1], [2, 4, 2], [1, 2, 1]] / 16 state s : image "
        "kept image c = exposure - k(exposure) image d = c - s next s = s / 2 + c / 2 read d"
    )
    cost = {cost.name: cost for cost in container_of(HEAD + text).pictures.costs}
    assert cost["d"].peak_gain == pytest.approx(1.75, abs=1e-3)


def test_a_reused_register_counts_as_another_value() -> None:
    """Three kernels of three absolute values, which are in one register one after the other."""
    sobel = "kernel a = [[1, 0, -1], [2, 0, -2], [1, 0, -1]] / 8 kernel b = [[1, 2, 1], [0, 0, 0], "
    box = "[-1, -2, -1]] / 8 kernel c = [[1, 1, 1], [1, 1, 1], [1, 1, 1]] / 16 "
    images = "image x = c(abs(a(exposure))) image y = c(abs(b(exposure))) "
    both = "image z = c(abs(a(exposure) + b(exposure))) plane p = x > 3% and y > 3% and z > 3% "
    for head in (HEAD, HEAD.replace("nsl 4", "nsl 3")):
        assert pictures_fault(container_of(head + sobel + box + images + both + "read p")) is None


FLOOD = """
kernel cross = [[0, 1, 0], [1, 1, 1], [0, 1, 0]]
plane seed = exposure > 60%
plane mask = exposure > 30%
plane part = flood(seed, mask, cross)
read part
"""


def flooded(pixels: int, light: Any) -> tuple[Any, bool]:
    """The flooded plane, and whether it is complete, if a propagation reaches `pixels`."""
    target = replaced(builtin_target("scamp5"), rows=30, cols=37, propagation_pixels=pixels)
    container = run_passes(
        Source("p.nsl", HEAD + FLOOD), Path(), Options(level=1, cache=False, target=target)
    ).container
    assert container is not None
    propagations = sum(op.name == "PROP.write" for op, _ in picture_words(container))
    assert propagations == (-(-67 // pixels) if pixels else 0)
    run = PicturedProgram(container, default_sensor(target), selected("none"), 1)
    frame = next(run.film([Light.of_clip(light)], 1, 0))
    reference = PicturedProgram(container, default_sensor(target), selected("adc_noise"), 1)
    same = next(reference.film([Light.of_clip(light)], 1, 0)).told["plane_part"]
    np.testing.assert_array_equal(same, frame.told["plane_part"])
    return frame.told["plane_part"], bool(frame.told["flood_complete_part"])


@pytest.mark.parametrize("pixels", [0, 1, 7, 128])
def test_propagation_and_steps_flood_the_same_pixels(pixels: int) -> None:
    """Whether a propagation reaches no pixel (so steps are taken), 1, 7 or 128, the flood is
    scipy's."""
    rng = np.random.default_rng(5)
    light = (rng.integers(0, 4, (1, 30, 37)) * 1600 + 800).astype(np.float32).repeat(4, axis=0)
    exposure = light.sum(axis=0)
    found, complete = flooded(pixels, light)
    cross = np.array([[0, 1, 0], [1, 1, 1], [0, 1, 0]])
    expected = binary_propagation(exposure > 18000, cross, mask=exposure > 9000)
    assert complete
    np.testing.assert_array_equal(found, expected)
    # The flood reaches a part of its mask: neither nothing nor everything would show it.
    assert 0 < expected.sum() < (exposure > 9000).sum()


def test_the_proof_notices_wrong_propagations() -> None:
    """The changes are a missing direction, no mask, another seed, and one step too many."""
    container = container_of(HEAD + FLOOD)
    pictures = container.pictures
    assert pictures_fault(container) is None
    kernels = [[matching(word) for word in words] for words in pictures.kernels]

    def with_words(change: Any) -> Container:
        words = tuple(tuple(encode(change(op)) for op in kernel) for kernel in kernels)
        return replaced(container, pictures=replaced(pictures, kernels=words))

    changes = {
        "direction": lambda o: op("SET", ["R1", "R2", "R3"]) if len(o.destinations) == 4 else o,
        "mask": lambda o: op("SET", ["R0"]) if o.destinations == ("R0",) else o,
        "seed": lambda o: op("NOT", ["R12"], o.sources) if str(o).startswith("MOV R12") else o,
    }
    for name, change in changes.items():
        assert pictures_fault(with_words(change)) is not None, name
    for wrong in changed_loops(container, lambda loop: replaced(loop, times=Times(5, 5))):
        assert pictures_fault(wrong) is not None


def test_a_kept_image_leaks_and_a_sum_is_exact() -> None:
    program = nscc.compile(
        HEAD + "state s : image kept = 40% image i = exposure / 2 next s = s read s report sum i"
    )
    light = np.full((3, 4, 256, 256), 1000.0)
    exact = nscc_runtime.film(program, light)
    # 40 % of a full well of 30000 electrons.
    assert (exact.images["s"] == 12000).all()
    # Half of four slots of 1000 electrons, in 256 x 256 pixels, in three frames.
    assert exact.reports["sum i"] == [2000.0 * 256 * 256] * 3
    leaking = nscc_runtime.film(program, light, effects="leakage").images["s"].mean(axis=(1, 2))
    assert leaking[0] < 12000
    assert leaking[2] < leaking[1] < leaking[0]


def test_leakage_and_errors_of_copies_are_keys_of_the_target() -> None:
    kept = "state s : image kept = 40% next s = s read s"
    moved = "image s = exposure[1, 0] read s"

    def mean_e(text: str, effect: str, **values: float) -> float:
        target = replaced(builtin_target("scamp5"), rows=32, cols=40, **values)
        light = np.full((2, 4, 32, 40), 2000.0)
        film = nscc_runtime.film(nscc.compile(HEAD + text, target=target), light, effects=effect)
        return float(film.images["s"][1, 1:-1, 1:-1].mean())

    assert mean_e(kept, "leakage", leakage_tau_s=1e6) == pytest.approx(12000, rel=1e-5)
    assert mean_e(kept, "leakage", leakage_tau_s=0.1) < 0.9 * mean_e(kept, "leakage")
    assert mean_e(moved, "analog", analog_move_loss=0.0) > 1.01 * mean_e(
        moved, "analog", analog_move_loss=1.0
    )


def test_every_step_of_a_loop_takes_time() -> None:
    """A loop of 100 steps takes 99 launches and twice 99 digital words longer than one of a single
    step."""
    containers = [
        container_of(HEAD + f"plane p = exposure > 6% plane q = p repeat {steps} q[1, 0] read q")
        for steps in (1, 100)
    ]
    target = containers[0].target
    few_us, many_us = (pictures_us(made.pictures, made.target) for made in containers)
    # The loops differ by 99 steps.
    words_a_step = (containers[1].pictures.words - containers[0].pictures.words) / 99
    step_us = target.launch_us + words_a_step * target.digital_word_us
    assert words_a_step == 2
    assert many_us - few_us == pytest.approx(99 * step_us)


def test_a_plane_xor_itself_is_0_also_after_an_or() -> None:
    """An OR word before it is not taken for the word of an inverse."""
    text = BRIGHT + "input plane i plane q = p or i plane z = q xor q read q, z"
    pictures = container_of(HEAD + text).pictures
    words = [matching(word, ()) for kernel in pictures.kernels for word in kernel]
    assert op("CLR", [pictures.registers["z"]]) in words


def test_an_error_of_registers_proposes_a_lower_limit_that_fits() -> None:
    """A repeated dense kernel with signs fits the registers only if its values are smaller."""
    text = (
        "kernel k = [[0, 1, 5], [9, -9, -8], [6, 8, -4]] / 64 "
        "image p = exposure repeat 4 k(p) read p"
    )
    with pytest.raises(Rejected) as refused:
        container_of(HEAD + text)
    (help_text,) = refused.value.diagnostics[0].helps
    assert help_text == "limit the exposure: `assume exposure <= 50%` compiles"
    assert container_of(HEAD + "assume exposure <= 50% " + text).pictures.words
