"""C++ for the devkit: compiled against a library of our own that records what it is told.

Words, order, times and code planes of the recording are compared with the container's.
"""

from __future__ import annotations

import json
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from devkit_oracle import (
    CHIP,
    COMPILER,
    Recording,
    check_codes,
    check_frames,
    check_syntax,
    compile_program,
    exposures,
    loaded_planes,
    needs_compiler,
    record,
    run,
)
from marks import slow
from nscc_command import invoke

from nscc.emit.cpp.codes import bitmap, patterns_of
from nscc.words.container import Container, Launch, StoredKernel, with_picture_words
from nscc.words.encoding import decode
from nscc.words.file import read_container
from nscc.words.reach import Reach, reaches_of_frames
from nscc_runtime.emulator import expose
from nscc_runtime.light import Light

EXAMPLES = sorted(
    path
    for path in (ROOT / "examples").glob("*.nsl")
    if not {"nsl 3", "nsl 4"} & {*path.read_text().splitlines()}
)
KINDS = {"class_c", "codebook", "hdr_2x2", "first_light", "two_buckets"}
"""One of each kind of text that C++ is written in: tables, planes, patterns, looks, buckets."""
PUBLISHED = json.loads((ROOT / "tests/data/icw_examples.json").read_text())


def build(folder: Path, text: str, *options: str) -> tuple[Path, Container]:
    """The C++ file and the container of a program, without a search for gates."""
    (folder / "p.nsl").write_text(text)
    options = ("-O1", *options)
    outcome = invoke(["build", "p.nsl", "-o", "p.icw", "--emit", "cpp,icw", *options], folder)
    assert outcome.status == 0, outcome.err
    return folder / "p.cpp", read_container(folder / "p.icw")


def chip_file(folder: Path, rows: int, cols: int, **changes: str) -> str:
    """The name of a target file like scamp5 but for its array and `key = value` changes."""
    text = invoke(["targets", "scamp5", "--toml"], folder).out
    for key, value in {"rows": str(rows), "cols": str(cols), **changes}.items():
        before, line, after = text.partition(f"\n{key} = ")
        assert line, key
        text = before + line + value + after[after.index("\n") :]
    (folder / "chip.toml").write_text(text)
    return "chip.toml"


def checked(folder: Path, text: str, *options: str) -> tuple[Recording, Container, str]:
    """Builds, compiles, runs and compares a program."""
    file, container = build(folder, text, *options)
    recording = record(file, "-std=c++11", CHIP)
    check(recording, container)
    return recording, container, file.read_text()


def check(recording: Recording, container: Container) -> None:
    """Codes, words, their order and times are the container's."""
    check_codes(recording, container)
    check_frames(recording, container)


@needs_compiler
def test_the_recording_library_encodes_the_published_examples(tmp_path: Path) -> None:
    calls = "\n".join(
        f"scamp5_kernel_begin(); {case['op']}({', '.join(case['args'])}); scamp5_kernel_end();"
        for case in PUBLISHED
    )
    text = f"#include <scamp5.hpp>\nint main() {{ vs_init();\n{calls}\n}}\n"
    (tmp_path / "all.cpp").write_text(text)
    compile_program(tmp_path / "all.cpp", tmp_path / "all", "-std=c++11", CHIP)
    lines = run([tmp_path / "all"]).splitlines()
    found = [line.split()[2:] for line in lines if line.startswith("kernel")]
    wanted = [[f"{int(x, 16):x}" for word in case["icw"] for x in word] for case in PUBLISHED]
    assert found == wanted


@needs_compiler
@pytest.mark.parametrize("name", [p.stem if p.stem in KINDS else slow(p.stem) for p in EXAMPLES])
def test_the_cpp_of_every_example_sends_the_words_of_its_container(
    name: str, tmp_path: Path
) -> None:
    checked(tmp_path, (ROOT / f"examples/{name}.nsl").read_text())


@needs_compiler
@pytest.mark.parametrize("standard", ["-std=c++11", "-std=c++14", "-std=c++17"])
@pytest.mark.parametrize("name", [slow("class_c"), slow("class_e"), "hdr_2x2"])
def test_the_cpp_compiles_without_warnings(name: str, standard: str, tmp_path: Path) -> None:
    """Three examples compile in C++11, C++14 and C++17, for the board and for the stub, and with
    optimization."""
    file, _ = build(tmp_path, (ROOT / "examples" / f"{name}.nsl").read_text())
    check_syntax(file, standard)
    check_syntax(file, standard, CHIP)
    check_syntax(file, standard, CHIP, "-DDEVKIT_STUB_TABLE_FUNCTION", "-DREST_US=1000")
    check_syntax(file, standard, CHIP, "-O2")


WIDE = """nsl 1
frame 160 slots of 1ms
code stop : 1..N
open when n < stop
pixels stop = 1 + (21 * (x % 8) + 8 * (y % 8)) % N
"""
"""With all legal codes, its words read more registers than a library call does."""


@needs_compiler
def test_tables_of_words_run_if_the_library_has_a_function_for_them(tmp_path: Path) -> None:
    file, container = build(tmp_path, WIDE, "--codes", "open", "-O", "1")
    assert "_words[][5]" in file.read_text()
    check(record(file, "-std=c++11", CHIP, "-DDEVKIT_STUB_TABLE_FUNCTION"), container)


A = "nsl 1\nframe 4 slots of 1ms\nopen when true\n"
B = "nsl 1\nframe 64 slots of 250us\ncode stop : 1..64\nopen when n < stop\n"
E13 = "nsl 1\nframe 13 slots of 1ms\ncode bits : bit[13]\nopen when bits[n]\n"


@needs_compiler
@pytest.mark.parametrize("lowering", ["accumulate", "latch", "edges"])
def test_cpp_of_every_lowering_does_what_the_words_do(lowering: str, tmp_path: Path) -> None:
    """The recorded words of the C++ are those of the container, which has the lowering asked
    for."""
    text = B + "pixels stop = 1 + (21 * (x % 8) + 8 * (y % 8)) % N\n"
    _, container, _ = checked(tmp_path, text, "--lowering", lowering)
    assert container.notes["lowering"] == lowering


@needs_compiler
@pytest.mark.parametrize("slots", [40, slow(64)])
def test_cpp_writes_code_registers_under_masks(slots: int, tmp_path: Path) -> None:
    """A program of two open codes needs R12, which is written only where the mask is set."""
    text = f"nsl 1\nframe {slots} slots of 1ms\ncode a : 0..N - 1\ncode b : 1..N\n"
    text += "require a < b\nopen when a <= n < b\n"
    text += "pixels a = x % (N / 2)\npixels b = N / 2 + 1 + (3 * y) % (N / 2)\n"
    options = ("--codes", "open", "--lowering", "accumulate")
    _, container, _ = checked(tmp_path, text, *options)
    assert "R12" in container.code_registers


@needs_compiler
@pytest.mark.parametrize("codes", ["fixed", slow("open")])
def test_long_frames_are_a_table_and_not_thousands_of_lines(codes: str, tmp_path: Path) -> None:
    text = (ROOT / "examples" / "class_b_4096.nsl").read_text()
    _, container, written = checked(tmp_path, text, "--codes", codes)
    assert container.slots == 4096
    # A line for each launch would be more than 4096.
    assert len(written.splitlines()) < 1600


@pytest.mark.slow
@needs_compiler
def test_every_slot_of_a_long_frame_is_repetition(tmp_path: Path) -> None:
    text = "nsl 1\nframe 4096 slots of 20us\nopen when n % 2 == 0 or n < 7\n"
    _, container, written = checked(tmp_path, text, "--lowering", "accumulate")
    assert len(container.launches) > 2000
    # Fewer than launches, so repeated ones share lines.
    assert len(written.splitlines()) < 1500


@needs_compiler
@pytest.mark.parametrize("rows", ["fixed", "tile"])
def test_cpp_writes_all_thirteen_registers_the_masked_one_first(rows: str, tmp_path: Path) -> None:
    data = {
        "fixed": "pixels bits = (2917 * x + 4421 * y) % 8192\n",
        "tile": "pixels bits = (2917 * (x % 8) + 4421 * (y % 4)) % 8192\n",
    }[rows]
    recording, container, _ = checked(tmp_path, E13 + data)
    assert container.code_registers[0] == "R12"
    assert container.code_registers[-1] == "R0"
    loaded = [values[0] for name, values in recording.loading if name in ("pattern", "draw")]
    assert loaded[-1] == "R0"
    if rows == "fixed":
        assert [values[0] for name, values in recording.loading if name == "request"]
    else:
        assert not [name for name, _ in recording.loading if name == "request"]
        assert ("draw", "R0") in {(name, v[0]) for name, v in recording.loading if v}


@needs_compiler
@pytest.mark.parametrize("shape", [(33, 70), slow((256, 64)), (1, 8), slow((100, 256)), (5, 1)])
@pytest.mark.parametrize("data", ["tile", "plane"])
def test_cpp_loads_the_codes_of_arrays_of_any_size(
    shape: tuple[int, int], data: str, tmp_path: Path
) -> None:
    rows, cols = shape
    chip = chip_file(tmp_path, rows, cols)
    pixels = {
        "tile": "pixels stop = 1 + (21 * (x % 4) + 8 * (y % 2)) % N\n",
        "plane": "pixels stop = 1 + (x * x + 3 * y * y + x * y) / 5 % N\n",
    }[data]
    checked(tmp_path, B + pixels, "--target", chip)


@needs_compiler
def test_cpp_loads_images_for_irregular_codes_and_none_for_tiles(tmp_path: Path) -> None:
    recording, container, _ = checked(
        tmp_path, B + "pixels stop = 8 if (x - 128)*(x - 128) + (y - 99)*(y - 99) < 5000 else N\n"
    )
    requests = [values for name, values in recording.loading if name == "request"]
    named = {values[0] for values in requests}
    assert named == {f"p.{register}.bmp" for register in container.code_registers}
    assert named == {path.name for path in tmp_path.glob("*.bmp")}
    assert len(requests) > len(named), "what was not answered in time is asked for again"
    tiled = tmp_path / "tile"
    tiled.mkdir()
    recording, _, _ = checked(
        tiled,
        B
        + "pixels stop = tile [[1, 9, 64], [3, 3, 5]]\n".replace("64]", "64, 7]").replace(
            "5]]", "5, 5]]"
        ),
    )
    assert not [name for name, _ in recording.loading if name == "request"]
    assert not list(tiled.glob("*.bmp"))


@pytest.mark.slow
@needs_compiler
def test_cpp_refreshes_codes_before_they_fade_while_loading(tmp_path: Path) -> None:
    chip = chip_file(tmp_path, 256, 256, digital_retention_us="120000.0")
    text = "nsl 1\nframe 9 slots of 1ms\ncode bits : bit[9]\nopen when bits[n]\n"
    data = "pixels bits = (2917 * x + 4421 * y + x * y) % 512\n"
    recording, _, _ = checked(tmp_path, text + data, "--target", chip)
    rates = [int(values[1]) for name, values in recording.loading if name == "trigger"]
    # The time between triggers is below the retention, less a margin of a tenth.
    assert 1e6 / rates[0] < 0.9 * 120_000


@needs_compiler
def test_several_buckets_are_read_out(tmp_path: Path) -> None:
    """Three buckets are read out and displayed in the order of the program."""
    text = (
        "nsl 1\nframe 12 slots of 1ms\ncode s : 0..11\nbucket p open when n < s\n"
        "bucket q open when n % 3 == s % 3\nbucket r open when s <= n < s + 2 or n == 0\n"
        "pixels s = (x + y) % 12\n"
    )
    recording, container, _ = checked(tmp_path, text)
    assert [r.bucket for r in container.readouts] == ["p", "q", "r"]
    shown = [values[0] for name, values in recording.loading if name == "display"]
    assert shown == ["p", "q", "r"]


@needs_compiler
@pytest.mark.parametrize("frame", ["9 slots of 0.3s", "slots [3s, 1s, 0.7s]", "9 slots of 20.3us"])
def test_cpp_keeps_the_times_of_slow_fast_and_unequal_slots(frame: str, tmp_path: Path) -> None:
    """Slots of 0.3 s, of unequal seconds and of 20.3 us keep their times in the recorded words."""
    checked(tmp_path, f"nsl 1\nframe {frame}\nopen when n == 1 or n == 0\n")


@needs_compiler
def test_cpp_exposes_a_frame_longer_than_its_clock(tmp_path: Path) -> None:
    """32 bits of microseconds are 71 minutes."""
    recording, _, _ = checked(tmp_path, "nsl 1\nframe 2 slots of 5000s\nopen when true\n")
    [started, *_, ended] = [int(v[1]) for name, v in recording.frames[0] if name == "launch"][:-1]
    # Two slots of 5000 s, in nanoseconds.
    assert ended - started >= 10**13


@needs_compiler
@pytest.mark.slow
def test_cpp_times_do_not_drift_over_4096_slots(tmp_path: Path) -> None:
    """A slot is not a whole number of microseconds long, and each launch takes longer than it
    should."""
    text = "nsl 1\nframe 4096 slots of 20.3us\nopen when n % 2 == 0\n"
    checked(tmp_path, text, "--lowering", "accumulate")


@needs_compiler
@pytest.mark.parametrize("name", ["hdr_2x2", slow("class_c"), slow("class_e")])
def test_cpp_built_for_the_simulator_opens_the_same_shutters(name: str, tmp_path: Path) -> None:
    """Every frame gathers the light of the emulator. The simulated light falls between the
    launches, in proportion to the times of the slots."""
    file, container = build(tmp_path, (ROOT / "examples" / f"{name}.nsl").read_text())
    recording = record(file, "-std=c++11")
    check_codes(recording, container)
    light = Light.of_clip(np.random.default_rng(5).random((container.slots, 256, 256), np.float32))
    wanted = expose(container, light).exposure_e
    for events in exposures(recording, container):
        numbers = [int(values[0]) for name, values in events if name == "launch"]
        run_ = ran(container, recording, numbers)
        np.testing.assert_array_equal(expose(run_, light).exposure_e, wanted)
        fallen = [0]
        for name_, values in events:
            if name_ == "integrate":
                fallen.append(fallen[-1] + int(values[0]))
        over = np.append(0, np.cumsum(container.slot_us)) / sum(container.slot_us)
        instants = sorted({0, container.slots, *(each.instant for each in container.launches)})
        np.testing.assert_allclose(np.array(fallen) / 65535, over[instants], atol=1 / 65535)


def ran(container: Container, recording: Recording, numbers: list[int]) -> Container:
    """The container with the words that a program ran in place of its own."""
    used = sorted(set(numbers))
    kernels = tuple(StoredKernel(f"r{n}", tuple(recording.kernels[n])) for n in used)
    launches = tuple(
        replace(launch, kernel=used.index(number))
        for launch, number in zip(container.launches, numbers, strict=True)
    )
    target = replace(container.target, store_words=1 << 18)
    return replace(container, target=target, kernels=kernels, launches=launches)


@needs_compiler
def test_cpp_for_the_scamp7_uses_its_registers(tmp_path: Path) -> None:
    """Eighteen bits need R13, which only SCAMP-7 has. The text nowhere says scamp5."""
    text = "nsl 1\nframe 18 slots of 1ms\ncode bits : bit[18]\nopen when bits[n]\n"
    data = "pixels bits = (2917 * (x % 8) + 44210 * (y % 4)) % 262144\n"
    file, container = build(tmp_path, text + data, "--target", "scamp7")
    assert "R13" in container.code_registers
    assert "scamp5" not in file.read_text()
    recording = record(file, "-std=c++11", CHIP)
    check(recording, container)


@needs_compiler
def test_kernels_without_library_calls_run_on_the_scamp7(tmp_path: Path) -> None:
    """Some kernels contain words with more than four sources, for which the library has no call."""
    options = ("--target", "scamp7", "--codes", "open", "-O", "1")
    file, container = build(tmp_path, WIDE, *options)
    wide = [k for k in container.kernels if any(len(decode(w).sources) > 4 for w in k.words)]
    assert wide
    recording = record(file, "-std=c++11", CHIP)
    light = Light.of_clip(np.random.default_rng(5).random((container.slots, 256, 256), np.float32))
    [events, _] = exposures(recording, container)
    numbers = [int(values[0]) for name, values in events if name == "launch"]
    found = expose(ran(container, recording, numbers), light).exposure_e
    np.testing.assert_array_equal(found, expose(container, light).exposure_e)


@needs_compiler
@pytest.mark.parametrize("readout", ["full", "half"])
def test_full_and_half_readouts_need_no_words_before_the_converter(
    readout: str, tmp_path: Path
) -> None:
    """`check_readout` looks at black, half and full."""
    chip = chip_file(tmp_path, 256, 256, readout=f'"{readout}"')
    recording, _, written = checked(tmp_path, A, "--target", chip)
    assert "scamp5_load_in" not in written
    assert not [name for name, _ in recording.events if name == "in"]


@needs_compiler
def test_cpp_has_no_spreading_words_if_no_register_is_free(tmp_path: Path) -> None:
    """Six buckets take all registers, so the C++ never calls `scamp5_load_in`."""
    rules = "".join(f"bucket b{n} open when n == {n} + k\n" for n in range(6))
    text = f"nsl 1\nframe 8 slots of 1ms\ncode k : 0..1\n{rules}pixels k = x % 2\n"
    _, container, written = checked(tmp_path, text)
    assert len(container.readouts) == 6
    assert "scamp5_load_in" not in written


@needs_compiler
def test_pixels_that_look_at_several_levels_set_in_for_each(tmp_path: Path) -> None:
    """Three levels of light make at least three settings of the input in each frame."""
    text = (
        "nsl 2\nframe 8 slots of 1ms\nsense a when light > [10%, 60%] at n in [2, 5]\n"
        "sense b when light > 30% at n in [2, 5]\nstate s : 0..3 = 0\n"
        "next s = min(s + 1, 3) when a or b\nopen when s < 2\nread s\n"
    )
    recording, container, written = checked(tmp_path, text)
    assert len({each.level for each in container.launches} - {None}) == 3
    assert [name for name, _ in recording.frames[0]].count("in") >= 3
    assert "// state      s in " in written


@needs_compiler
def test_cpp_computes_images_planes_and_reports(tmp_path: Path) -> None:
    text = (
        "nsl 3\nframe 4 slots of 1ms\noutside 1\nbucket a open when n < 2\n"
        "bucket b open when n >= 2\nkernel k = [[1, 2, 1], [2, 4, 2], [1, 2, 1]] / 16\n"
        "image i = k(a - b)\nplane p = i > 6% or i < -6%\nplane core = all(p, k)\n"
        "read a, i, p\nreport events core at most 9\nreport any core\n"
    )
    file, container = build(tmp_path, text)
    recording = record(file, "-std=c++11", CHIP)
    check_frames(recording, with_picture_words(container))
    (frame, *_) = recording.frames
    assert [name for name, _ in frame].count("post") >= 2
    assert 'report("events core", R' in file.read_text()
    check_syntax(file, "-std=c++17")


@needs_compiler
def test_states_are_loaded_once_and_margins_grow_with_them(tmp_path: Path) -> None:
    text = (
        "nsl 3\nframe 4 slots of 1ms\noutside 1\ncode stop : 3..4\nopen when n < stop\n"
        "pixels stop = 3 + x % 2\nkernel k = [[1, 2, 1]] / 4\nstate s : bit = 1 kept\n"
        "state t : bit = 0 kept\nplane p = k(exposure) > 30%\nnext s = p\nnext t = s[1, 0]\n"
        "read s\nreport box t\n"
    )
    file, container = build(tmp_path, text)
    executed = with_picture_words(container)
    assert {*executed.code_registers} > {*container.code_registers}
    recording = record(file, "-std=c++11", CHIP)
    check(recording, executed)
    # The second frame is the first that knows a plane computed beyond the border.
    assert "margin_0[][4] = {{0, 0, 0, 0}, {0, 2, 0, 0}};" in file.read_text()
    check_syntax(file, "-std=c++17")


@needs_compiler
def test_sliders_change_levels_and_numbers_of_launches(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The first frame alone sets the kept image to its start."""
    text = (
        "nsl 4\nframe 4 slots of 1ms\nopen when true\noutside 0\n"
        "param t : 1% .. 20% = 4%\nparam m : -2 .. 5 = 2\nstate s : image kept\n"
        "plane p = exposure - s > t\nplane q = p repeat m q[1, 0]\nnext s = exposure\nread q\n"
    )
    file, container = build(tmp_path, text)
    assert 'vs_gui_add_slider("m", -2, 5, 2, &param_1);' in file.read_text()
    pictures, sent = container.pictures, with_picture_words(container)
    first = len(container.kernels)
    start = Launch(container.slots, first + len(pictures.kernels), 0)
    for t, m in ((5, 2), (1, 5), (25, -1)):
        monkeypatch.setenv("DEVKIT_STUB_SLIDERS", f"{t},{m}")
        recording = record(file, "-std=c++11", CHIP)
        tail = [
            Launch(container.slots, first + launch.kernel, launch.level)
            for launch in pictures.executed({"t": t, "m": m})
        ]
        for frame, starts in zip(recording.frames, ([start], []), strict=True):
            launches = (*container.launches, *starts, *tail)
            check_frames(replace(recording, frames=[frame]), replace(sent, launches=launches))


@needs_compiler
def test_margins_of_reports_follow_the_sliders(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An image beyond the border is unknown as far as two sliders move it."""
    text = (
        "nsl 4\nframe 4 slots of 1ms\nopen when true\noutside 0\nparam t : 1% .. 20% = 4%\n"
        "param m : -1 .. 2 = 1\nparam k : 0 .. 2 = 0\nimage v = exposure[m, 0]\n"
        "image w = v[0, k]\nplane p = w > t\nread p\nreport count p\n"
    )
    file, _ = build(tmp_path, text)
    left_right_top_bottom = [[max(-m, 0), max(m, 0), 0, k] for m in range(-1, 3) for k in range(3)]
    rows = ", ".join(f"{{{', '.join(map(str, row))}}}" for row in left_right_top_bottom)
    assert f"margin_0[][4] = {{{rows}}};" in file.read_text()
    for m, k in ((-1, 0), (2, 2), (0, 1)):
        monkeypatch.setenv("DEVKIT_STUB_SLIDERS", f"5,{m},{k}")
        (frame, *_) = record(file, "-std=c++11", CHIP).frames
        scanned = [int(values[-1]) for name, values in frame if name == "scan_bits"]
        assert scanned == [*range(256 - k)]


@needs_compiler
@pytest.mark.parametrize("combinations", [9, 2500])
def test_margins_cover_every_film_of_values_of_sliders(
    combinations: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A state carries a plane that a slider moved in an earlier frame; another slider moves in
    another direction. The margin is that of this frame's values, after any values before."""
    most = round(combinations**0.5) - 1
    file, container = build(
        tmp_path,
        f"nsl 4\nframe 4 slots of 1ms\nopen when true\noutside 0\nparam m : 0 .. {most} = 1\n"
        f"param k : {-most} .. 0 = 0\nstate s : bit = 0 kept\nkernel g = [[1], [2], [1]] / 4\n"
        "plane q = g(exposure) > 2%\nplane r = q[k, m]\nplane t = s[0, -1] or r\nnext s = q\n"
        "read t\nreport count t\n",
    )
    assert ("all values of the other sliders" in file.read_text()) == (combinations > 1024)
    for m, k in ((0, 0), (2, -1), (most, -most)):
        monkeypatch.setenv("DEVKIT_STUB_SLIDERS", f"{m},{k}")
        (frame, *_) = record(file, "-std=c++11", CHIP).frames
        scanned = [int(values[-1]) for name, values in frame if name == "scan_bits"]
        films = (
            [*reaches_of_frames(container, params=[{"m": before}, {"m": m, "k": k}])][-1]
            for before in range(most + 1)
        )
        reach = Reach().joined(*(film["t"] for film in films))
        assert scanned == [*range(reach.up, 256 - reach.down)]


@needs_compiler
def test_input_planes_are_loaded_at_the_start_and_when_a_slider_moves(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The picture of an open input plane, which the host may replace, is what the plane holds."""
    text = (
        "nsl 4\nframe 4 slots of 1ms\ncode stop : 3..4\nopen when n < stop\noutside 0\n"
        "input plane mask\nplane lit = exposure > 4% and mask\npixels stop = 3 + x % 2\n"
        "pixels mask = x < 9 and y != 4\nread lit\n"
    )
    file, container = build(tmp_path, text)
    executed = with_picture_words(container)
    for slider, loads in (("0", 1), ("1", 2)):
        monkeypatch.setenv("DEVKIT_STUB_SLIDERS", slider)
        recording = record(file, "-std=c++11", CHIP)
        check(recording, executed)
        requests = [values for name, values in recording.loading if name == "request"]
        # The stub does not answer the first request of all.
        assert requests == [["p.input_mask.bmp", "1"]] * (1 + loads)
    other = np.arange(65536).reshape(256, 256) % 7 == 3
    (tmp_path / "p.input_mask.bmp").write_bytes(bitmap(other))
    recording = record(file, "-std=c++11", CHIP)
    planes = loaded_planes(recording, container.target, rest_is_cleared=False)
    assert np.array_equal(planes[container.pictures.registers["mask"]], other)
    check_syntax(file, "-std=c++17")


@needs_compiler
def test_sums_of_images_are_those_of_the_converter_codes(tmp_path: Path) -> None:
    """An image is 0 at code 128. An exposure that is read has all codes for itself, 0 at code 0."""
    text = (
        "nsl 4\nframe 4 slots of 1ms\nbucket a open when true\nkernel k = [[1, 2, 1]] / 4\n"
        "image v = k(a) - 10%\nread a\nreport sum v\nreport sum a\n"
    )
    file, container = build(tmp_path, text)
    recording = record(file, "-std=c++11", CHIP)
    check_frames(recording, with_picture_words(container))
    said = [" ".join(values) for name, values in recording.frames[0] if name == "post"]
    row, col = np.mgrid[0:256, 0:256]
    registers, target = container.pictures.registers, container.target
    for name, margin, zero, wells in (("v", 1, 128, 2), ("a", 0, target.zero_lsb, 1)):
        codes = (3 * row + 5 * col + ord(registers[name])) % 256  # what the stub's scans return
        total = round(float((codes[:, margin : 256 - margin] - zero).sum()))
        step_e = round(wells * target.full_well_e / 255, 3)
        assert f"sum {name} (steps of {step_e:g} e): {total}" in said


def test_reports_whose_margin_grows_for_ever_are_refused(tmp_path: Path) -> None:
    """A state that spreads to its neighbours in every frame has no bounded margin: NS0520."""
    (tmp_path / "p.nsl").write_text(
        "nsl 3\nframe 4 slots of 1ms\noutside 1\nopen when true\n"
        "kernel k = [[1, 2, 1]] / 4\nstate s : bit = 1 kept\nplane p = k(exposure) > 30%\n"
        "next s = p or any(s, k)\nreport box s\n"
    )
    outcome = invoke(["build", "p.nsl", "--emit", "cpp=-"], tmp_path)
    assert (outcome.status, outcome.codes) == (1, ["NS0520"])
    assert "with every frame" in outcome.err


@needs_compiler
@pytest.mark.parametrize("sources", [("4", "3"), ('"any"', '"any"')])
def test_kernels_with_more_sources_than_a_call_takes_are_tables(
    sources: tuple[str, str], tmp_path: Path
) -> None:
    chip = chip_file(tmp_path, 256, 256, or_sources=sources[0], where_sources=sources[1])
    text = B + "pixels stop = 1 + (21 * (x % 8) + 8 * (y % 8)) % N\n"
    _, container, written = checked(tmp_path, text, "--target", chip)
    for number, kernel in enumerate(container.kernels):
        ops = [decode(word) for word in kernel.words]
        beyond = [
            o
            for o in ops
            if len(o.sources) > {"WHERE": 3, "OR.read": 2, "NOR.read": 2}.get(o.name, 4)
        ]
        assert (f"k{number}_words[][5]" in written) == bool(beyond), (number, beyond)


def test_every_kernel_is_written_either_as_calls_or_as_a_table(tmp_path: Path) -> None:
    file, container = build(tmp_path, (ROOT / "examples" / "class_c.nsl").read_text())
    text = file.read_text()
    for number in range(len(container.kernels)):
        _, _, body = text.partition(f"\nvoid k{number}() {{")
        body = body[: body.index("}")]
        assert ("scamp5_kernel_begin()" in body) != (f"k{number}_words" in body)


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("huge", "no devkit has: R23"),
        ("wide", "256 x 257 pixels"),
        ("unmasked", "only where R0 is 1"),
    ],
)
def test_other_chips_are_refused(name: str, reason: str, tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(B + "pixels stop = 1 + x % 64\n")
    target = name
    if name == "wide":
        target = chip_file(tmp_path, 256, 257)
    if name == "huge":
        registers = [f"R{i}" for i in range(24)]
        target = chip_file(tmp_path, 256, 256, digital=json.dumps(registers))
    if name == "unmasked":
        target = chip_file(tmp_path, 256, 256, mask='"none"', masked='"none"')
    arguments = ["build", "p.nsl", "-o", "p.icw", "--emit", "cpp", "--target", target]
    outcome = invoke(arguments, tmp_path)
    assert outcome.status == 1
    assert outcome.codes[-1] == "NS0520"
    assert reason in outcome.err
    assert not (tmp_path / "p.cpp").exists()
    assert not (tmp_path / "p.icw").exists(), "one of several products is not written alone"


def test_programs_without_data_and_a_full_store_are_refused(tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(B)
    outcome = invoke(["build", "p.nsl", "--emit", "cpp=-"], tmp_path)
    assert (outcome.status, outcome.out, outcome.codes) == (1, "", ["NS0520"])
    (tmp_path / "p.nsl").write_text(B + "pixels stop = 1 + (x + 8 * y) % 64\n")
    report = invoke(["build", "p.nsl", "--emit", "report=-"], tmp_path)
    stored = json.loads(report.out)["words_stored"]
    chip = chip_file(tmp_path, 256, 256, words=str(stored + 10))
    outcome = invoke(["build", "p.nsl", "--emit", "cpp=-", "--target", chip], tmp_path)
    assert outcome.status == 1
    assert outcome.out == ""
    assert f"stores {stored + 10}" in outcome.err


@needs_compiler
def test_cpp_states_the_number_of_stored_words(tmp_path: Path) -> None:
    """The words that the refusal counts are those of the kernels that ran."""
    recording, _, written = checked(tmp_path, E13 + "pixels bits = (37 * x + 211 * y) % 8192\n")
    stored, more = (
        int(written.partition("// words")[2].split(part)[0].split()[-1])
        for part in (" stored in", " more load")
    )
    assert sum(map(len, recording.kernels.values())) == stored + more


def test_names_cannot_break_out_of_comments_and_strings(tmp_path: Path) -> None:
    name = 'a"b\\??ü%s'
    (tmp_path / f"{name}.nsl").write_text(
        B + "# \\\npixels stop = min(64, 1 + x * y / 7 % 100) # ??/ é \\\n"
    )
    outcome = invoke(["build", f"{name}.nsl", "--emit", "cpp"], tmp_path)
    assert outcome.status == 0, outcome.err
    text = (tmp_path / f"{name}.cpp").read_text(encoding="ascii")
    for line in text.splitlines():
        assert not line.rstrip().endswith(("\\", "??/"))
    assert "\\042" in text
    assert "\\303\\274" in text
    if COMPILER:
        check_syntax(tmp_path / f"{name}.cpp", "-std=c++11")


def test_cpp_states_its_source_and_cost(tmp_path: Path) -> None:
    file, _ = build(tmp_path, (ROOT / "examples" / "hdr_2x2.nsl").read_text())
    text = file.read_text()
    source = sha256((tmp_path / "p.nsl").read_bytes()).hexdigest()
    for part in (
        "p.nsl",
        "class      b",
        "256 of 125 us",
        "28 stored in 5 kernels",
        source,
        "p.nsl:9: open when n < stop",
        "p.nsl:11: pixels stop",
        "// boundary 64",
    ):
        assert part in text
    assert str(tmp_path) not in text
    assert max(map(len, text.splitlines())) <= 110
    again = invoke(["build", "p.nsl", "--emit", "cpp=-"], tmp_path)
    assert again.out == text


@needs_compiler
def test_the_recording_notices_a_changed_word_wait_or_plane(tmp_path: Path) -> None:
    file, container = build(tmp_path, (ROOT / "examples" / "hdr_2x2.nsl").read_text())
    text = file.read_text()
    changes = {
        "bus(NEWS, A, PIX);": "bus(NEWS, PIX);",
        "{2002, 0, 2, 1}": "{2001, 0, 2, 1}",
        "{8002, 0, 3, 1}": "{8008, 0, 3, 1}",
        "{8002, 0, 3, 1},": "{8002, 0, 4, 1},",
        "scamp5_load_pattern(R2, 1, 1,": "scamp5_load_pattern(R2, 1, 0,",
    }
    for old, new in changes.items():
        assert old in text
        file.write_text(text.replace(old, new, 1))
        recording = record(file, "-std=c++11", CHIP)
        with pytest.raises(AssertionError):
            check(recording, container)


def test_patterns_cover_random_tiles_exactly() -> None:
    random = np.random.default_rng(5)
    row, col = np.mgrid[0:256, 0:256]
    sizes = ((256, 256, 8, 8), (256, 256, 1, 32), (256, 256, 64, 64), (7, 100, 4, 2), (3, 3, 4, 4))
    for rows, cols, height, width in sizes:
        tile = random.random((height, width)) < 0.4
        plane = np.tile(tile, (256, 256))[:rows, :cols]
        found = patterns_of(plane)
        assert found is not None
        union = np.zeros((256, 256), dtype=bool)
        for m in found.matches:
            union |= (((row ^ m.row) & ~m.row_mask & 255) == 0) & (
                ((col ^ m.col) & ~m.col_mask & 255) == 0
            )
        assert np.array_equal((union != found.inverted)[:rows, :cols][:, ::-1], plane)
        assert len(found.matches) <= height * width / 2
    assert patterns_of(random.random((256, 256)) < 0.5) is None
