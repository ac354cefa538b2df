"""`nscc calibrate`: every form of input, and every input that no calibration can be made of."""

from __future__ import annotations

import io
import json
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from calibration_frames import DARK_TIMES, FLAT_TIMES, LIGHT, TOP, Chip, taken
from nscc_command import invoke
from PIL import Image
from scipy.io import savemat

from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.calibrate import Stack, calibrated
from nscc_runtime.sensor import load_sensor

CHIP = Chip(shape=(32, 40))


@pytest.fixture(scope="module")
def stacks() -> tuple[list[Stack], list[Stack]]:
    return taken(CHIP, 11, 4, 6)


def written(
    folder: Path, stacks: tuple[list[Stack], list[Stack]], how: str
) -> tuple[list[str], list[str]]:
    """The arguments for the flats and for the darks."""
    names: tuple[list[str], list[str]] = ([], [])
    for side, kind in enumerate(("flat", "dark")):
        for stack in stacks[side]:
            codes = stack.codes.astype(np.uint8)
            us = round(stack.exposure_s * 1e6)
            path = folder / f"{kind}{us}"
            at = f"@{us}us"
            match how:
                case "npy":
                    np.save(path.with_suffix(".npy"), codes)
                    path = path.with_suffix(".npy")
                case "npz":
                    np.savez(path.with_suffix(".npz"), frame=codes, exposure_us=us)
                    path, at = path.with_suffix(".npz"), ""
                case "floats":
                    np.savez(path.with_suffix(".npz"), anything=codes.astype(float))
                    path = path.with_suffix(".npz")
                case "mat":
                    moved = np.moveaxis(codes, 0, 2)
                    savemat(path.with_suffix(".mat"), {"frames": moved, "exposure_us": float(us)})
                    path, at = path.with_suffix(".mat"), ""
                case "png" | "tiff":
                    path.mkdir()
                    for i, frame in enumerate(codes):
                        Image.fromarray(frame).save(path / f"{i}.{how}")
            names[side].append(f"{path.name}{at}")
    return names


@pytest.mark.parametrize("how", ["npy", "npz", "floats", "mat", "png", "tiff"])
def test_every_form_of_frames_gives_the_same_file(
    how: str, stacks: tuple[list[Stack], list[Stack]], tmp_path: Path
) -> None:
    flats, darks = written(tmp_path, stacks, how)
    found = invoke(["calibrate", *flats, "--dark", *darks, "-o", "s.toml", "--json"], tmp_path)
    assert found.status == 0, found.err
    told = json.loads(found.out)
    direct = calibrated(*stacks, TOP)
    for name, quantity in direct.quantities.items():
        assert told["quantities"][name]["value"] == pytest.approx(quantity.value, rel=1e-9), name
        assert told["quantities"][name]["standard_error"] == pytest.approx(quantity.se, rel=1e-6)
    sensor = load_sensor(builtin_target("scamp5"), tmp_path / "s.toml")
    assert sensor.electrons_per_lsb == pytest.approx(20, rel=0.1)
    for name, choice in told["parameters"].items():
        assert getattr(sensor, name) == choice["value"]
    # Where the frames lay and how they were given is not in the product.
    again = tmp_path / "again"
    again.mkdir()
    flats, darks = written(again, stacks, "npy")
    words = ["calibrate", *flats, *(w for d in darks for w in ("--dark", d)), "-o", "s.toml"]
    assert invoke(words, again).status == 0
    assert (again / "s.toml").read_bytes() == (tmp_path / "s.toml").read_bytes()


def test_the_file_says_where_its_values_come_from(
    stacks: tuple[list[Stack], list[Stack]], tmp_path: Path
) -> None:
    """The written sensor file counts the frames, marks each value as measured or not, and holds no
    folder of this machine."""
    flats, darks = written(tmp_path, stacks, "npy")
    found = invoke(["calibrate", *flats, "--dark", *darks, "-o", "s.toml"], tmp_path)
    text = (tmp_path / "s.toml").read_text()
    joined = " ".join(line.removeprefix("# ") for line in text.splitlines())
    assert "from 32 flats of 8 levels and 18 darks of 3, 32 x 40 pixels" in joined
    before = joined.split("electrons_per_lsb = ")[0]
    assert "measured" in before.rsplit("electrons a code", 1)[1]
    assert " +- " in before.rsplit("electrons a code", 1)[1]
    assert "not measured: photon transfer does not tell" in joined
    assert str(tmp_path) not in text
    assert max(map(len, text.splitlines())) <= 100
    assert "system gain K" in found.out
    assert found.err.splitlines()[-1] == "wrote s.toml"


def rejected(flats: list[Stack], darks: list[Stack]) -> tuple[str, str]:
    with pytest.raises(Rejected) as caught:
        calibrated(flats, darks, TOP)
    assert caught.value.status == 2
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.helps
    return diagnostic.code, diagnostic.message


def test_a_level_of_one_frame_is_refused(stacks: tuple[list[Stack], list[Stack]]) -> None:
    """Two frames of equal light are needed for a variance, so a flat level of one frame gives
    NS0758."""
    flats, darks = stacks
    code, message = rejected([*flats[:2], replace(flats[2], codes=flats[2].codes[:1])], darks)
    assert code == "NS0758"
    assert "one frame" in message


def test_flats_of_a_single_level_are_refused(stacks: tuple[list[Stack], list[Stack]]) -> None:
    """One flat stack, or two stacks of almost equal mean code, count as 1 level: NS0758."""
    flats, darks = stacks
    code, message = rejected(flats[:1], darks)
    assert (code, message[:8]) == ("NS0758", "1 level ")
    again = replace(flats[0], codes=flats[0].codes[::-1] + np.uint16(0))
    again.codes[:, 0] = again.codes[:, 1]
    code, message = rejected([flats[0], again], darks)
    assert (code, message[:8]) == ("NS0758", "1 level ")


def test_flats_whose_pixels_are_all_clipped_are_refused(
    stacks: tuple[list[Stack], list[Stack]],
) -> None:
    camera = CHIP.made(np.random.default_rng(0))
    white = [replace(camera.stack(0.0, 0.01, 4), codes=np.full((4, 32, 40), 255, np.uint16))] * 3
    code, message = rejected(white, stacks[1])
    assert (code, message[:9]) == ("NS0758", "0 levels ")


def test_frames_of_mixed_sizes_are_refused(stacks: tuple[list[Stack], list[Stack]]) -> None:
    """A flat of 32 x 16 pixels among flats of 32 x 40 gives NS0757, which names both sizes."""
    flats, darks = stacks
    small = replace(flats[0], codes=flats[0].codes[:, :16], valid=flats[0].valid[:16])
    code, message = rejected([*flats[1:], small], darks)
    assert code == "NS0757"
    assert "16 x 40" in message
    assert "32 x 40" in message


def test_exchanged_flats_and_darks_are_refused(stacks: tuple[list[Stack], list[Stack]]) -> None:
    """With darks given as flats and flats as darks, the darks are the brighter ones: NS0759."""
    code, message = rejected(stacks[1], stacks[0][5:])
    assert code == "NS0759"
    assert "not darker" in message


def test_unevenly_lit_flats_are_refused() -> None:
    """Light that rises by a ramp, by waves or by a step across the picture gives NS0759 each."""
    camera = CHIP.made(np.random.default_rng(0))
    darks = [camera.stack(0.0, time, 6) for time in DARK_TIMES]
    y, x = np.mgrid[0:32, 0:40]
    for light in (0.5 + x / 40, 1 + 0.5 * np.sin(x / 2) * np.sin(y / 2), 0.3 + (x > 35)):
        flats = [camera.stack(LIGHT * light, time, 4) for time in FLAT_TIMES[:5]]
        code, message = rejected(flats, darks)
        assert code == "NS0759"
        assert "flat" in message


def test_frames_without_shot_noise_are_refused(stacks: tuple[list[Stack], list[Stack]]) -> None:
    """Flats whose noise is 1.5 codes at every level give NS0759: the variance must increase with
    the light."""
    rng = np.random.default_rng(0)
    flats = [
        replace(stack, codes=np.rint(rng.normal(50 + 20 * i, 1.5, (4, 32, 40))).astype(np.uint16))
        for i, stack in enumerate(stacks[0][:5])
    ]
    code, message = rejected(flats, stacks[1])
    assert code == "NS0759"
    assert "does not increase" in message


def test_a_frame_given_twice_is_refused(stacks: tuple[list[Stack], list[Stack]]) -> None:
    """A stack in which one frame stands twice gives NS0757: the copy would make the noise seem too
    small."""
    flats, darks = stacks
    doubled = replace(flats[1], codes=np.concatenate([flats[1].codes, flats[1].codes[:1]]))
    code, message = rejected([flats[0], doubled, *flats[2:]], darks)
    assert code == "NS0757"
    assert "more than once" in message


def _bad_files(folder: Path) -> dict[str, str]:
    codes = np.full((2, 8, 8), 7, np.uint8)
    rng, times = np.random.default_rng(0), {}
    np.save(folder / "ok.npy", codes)
    np.save(folder / "real.npy", codes + 0.25)
    np.save(folder / "nan.npy", np.full((2, 8, 8), np.nan))
    np.save(folder / "high.npy", codes.astype(np.uint16) * 100)
    np.save(folder / "negative.npy", codes.astype(int) - 8)
    np.save(folder / "flags.npy", codes > 3)
    np.save(folder / "line.npy", codes[0, 0])
    np.save(folder / "none.npy", codes[:, :0])
    np.save(folder / "objects.npy", np.array([None, {}], object), allow_pickle=True)
    np.savez(folder / "two.npz", a=codes, b=codes)
    np.savez(folder / "time.npz", frame=codes, exposure_us=-1.0)
    np.savez(folder / "times.npz", frame=codes, exposure_us=[1.0, 2.0])
    (folder / "cut.npz").write_bytes((folder / "two.npz").read_bytes()[:100])
    (folder / "text.npy").write_text("hello")
    (folder / "text.txt").write_text("hello")
    (folder / "empty").mkdir()
    (folder / "red").mkdir()
    Image.fromarray(rng.integers(0, 255, (8, 8, 3), np.uint8)).save(folder / "red/a.png")
    meta = {"schema": "nscc-frame-1", "open_us": None}
    np.savez(folder / "differ.npz", frame=codes[:1], meta=json.dumps(meta))
    np.savez(folder / "buckets.npz", frame=codes, meta=json.dumps(meta))
    for open_us in (
        "NaN",
        "Infinity",
        "-Infinity",
        "-1",
        "true",
        "1e300",
        "1e-300",
        "1" + "0" * 400,
    ):
        text = f'{{"schema": "nscc-frame-1", "open_us": [{open_us}]}}'
        np.savez(folder / f"open{open_us[:9]}.npz", frame=codes[:, None], meta=text)
        times[f"open{open_us[:9]}.npz"] = "invalid exposure time"
    # Headers of what would take gigabytes: none of it is there, so none of it is read.
    for name, shape in (("huge", (60000, 60000)), ("many", (1 << 22, 256, 256))):
        header = io.BytesIO()
        np.lib.format.write_array_header_1_0(
            header, {"descr": "|u1", "fortran_order": False, "shape": shape}
        )
        (folder / f"{name}.npy").write_bytes(header.getvalue())
        with zipfile.ZipFile(folder / f"{name}.npz", "w") as archive:
            archive.writestr("frame.npy", header.getvalue())
        for ending in ("npy", "npz"):
            times[f"{name}.{ending}"] = "at most 16,777,216 pixels" if name == "huge" else "256 GiB"
    return times | {
        "nowhere.npy": "file does not exist",
        "real.npy": "not whole",
        "nan.npy": "not whole",
        "high.npy": "700 to 700",
        "negative.npy": "-1 to -1",
        "flags.npy": "bool",
        "line.npy": "not frames",
        "none.npy": "not frames",
        "objects.npy": "cannot be read",
        "two.npz": "no array",
        "time.npz": "invalid exposure time",
        "times.npz": "invalid exposure time",
        "cut.npz": "cannot be read",
        "text.npy": "cannot be read",
        "text.txt": "is not a format",
        "red": "colour",
        "differ.npz": "different times",
        "buckets.npz": "bucket",
        "ok.npy@1e999s": "invalid exposure time",
    }


def test_too_few_valid_pixels_are_refused(stacks: tuple[list[Stack], list[Stack]]) -> None:
    """Frames with one valid column of 32 pixels give NS0757."""
    cut = [[replace(s, valid=s.valid & (np.arange(40) < 1)) for s in side] for side in stacks]
    code, message = rejected(*cut)
    assert code == "NS0757"
    assert message.startswith("32 pixels")


def test_frame_files_of_one_run_are_one_level(tmp_path: Path) -> None:
    """Other seeds, same light: six files of one frame are a level of six."""
    camera = CHIP.made(np.random.default_rng(5))
    names: dict[str, list[str]] = {"flat": [], "dark": []}
    for kind, light, count in (("flat", LIGHT, 4), ("dark", 0.0, 1)):
        for level in range(count):
            for seed in range(6):
                time_s = 0.004 * (level + 1)
                meta = {
                    "schema": "nscc-frame-1",
                    "program_sha256": f"p{level}",
                    "seed": seed,
                    "scene_sha256": kind,
                    "sensor_sha256": "s",
                    "device_seed": 0,
                    "open_us": [1e6 * time_s],
                }
                name = f"{kind}{level}_{seed}.npz"
                codes = camera.codes(light, time_s, 1)
                valid = np.ones(codes.shape, bool)
                valid[0, 3, 3] = seed != 2
                np.savez(tmp_path / name, frame=codes, valid=valid, meta=json.dumps(meta))
                names[kind].append(name)
    words = ["calibrate", *names["flat"], "--dark", *names["dark"], "-o", "s.toml", "--json"]
    found = invoke(words, tmp_path)
    assert found.status == 0, found.err
    told = json.loads(found.out)
    assert [level["frames"] for level in told["flats"]] == [6] * 4
    assert [level["frames"] for level in told["darks"]] == [6]
    assert [level["exposure_s"] for level in told["flats"]] == [0.004, 0.008, 0.012, 0.016]
    # All but the pixel that one seed calls invalid.
    assert told["pixels"] == 32 * 40 - 1
    assert told["quantities"]["linearity_error"]["known"] == "measured"
    assert found.codes == ["NS0791"]


def test_a_file_whose_name_looks_like_a_time_is_taken_as_a_file(
    stacks: tuple[list[Stack], list[Stack]], tmp_path: Path
) -> None:
    """The file `odd.npy@4ms` exists, so the part after `@` is no time: its suffix is then no format
    for frames."""
    flats, darks = written(tmp_path, stacks, "npy")
    (tmp_path / flats[0].partition("@")[0]).rename(tmp_path / "odd.npy@4ms")
    odd = ["odd.npy@4ms", *flats[1:]]
    found = invoke(["calibrate", *odd, "--dark", *darks, "-o", "s.toml"], tmp_path)
    assert found.status == 2
    assert "is not a format for frames" in found.err


@pytest.mark.parametrize("time", ["1h", "-1ms", "", "2", "1e300s", "1.2.3s"])
def test_an_invalid_exposure_time_is_named(time: str, tmp_path: Path) -> None:
    """A time with a wrong unit, sign or number, or none at all, gives NS0757 with the text as
    written."""
    np.save(tmp_path / "f.npy", np.zeros((2, 4, 4), np.uint8))
    words = ["calibrate", f"f.npy@{time}", "--dark", "f.npy", "-o", "s.toml"]
    found = invoke(words, tmp_path)
    assert found.status == 2
    assert f"error[NS0757]: invalid exposure time of 'f.npy@{time}': '{time}'" in found.err


def test_calibrate_refuses_files_without_valid_frames(tmp_path: Path) -> None:
    """Each bad file gives NS0757 as a flat and as a dark, and no sensor file. An empty folder gives
    NS0735."""
    for name, said in _bad_files(tmp_path).items():
        for words in (
            ["calibrate", name, "--dark", "ok.npy", "-o", "s.toml"],
            ["calibrate", "ok.npy", "--dark", "ok.npy", name, "-o", "s.toml"],
        ):
            found = invoke(words, tmp_path)
            assert found.status == 2, (name, found)
            assert "error[NS0757]" in found.err, (name, found.err)
            assert said in found.err.splitlines()[0], (name, found.err)
            assert not (tmp_path / "s.toml").exists()
    found = invoke(["calibrate", "empty", "--dark", "ok.npy", "-o", "s.toml"], tmp_path)
    assert found.status == 2
    assert "NS0735" in found.err


@pytest.mark.parametrize(
    "words",
    [
        [],
        ["f.npy"],
        ["f.npy", "--dark", "d.npy"],
        ["f.npy", "--dark", "-o", "s.toml"],
        ["--dark", "d.npy", "-o", "s.toml"],
        ["f.npy", "-o", "s.toml", "--dark"],
    ],
)
def test_calibrate_names_missing_arguments(words: list[str], tmp_path: Path) -> None:
    """A command line without flats, darks or output file gives an error NS078x and status 2."""
    found = invoke(["calibrate", *words], tmp_path)
    assert found.status == 2
    assert "error[NS078" in found.err


def test_a_warning_denied_writes_nothing(tmp_path: Path) -> None:
    """Noise added to every second flat gives the warning NS0792. With `--deny-warnings` it is an
    error of status 1."""
    stacks = taken(CHIP, 11, 4, 6)
    rng = np.random.default_rng(0)
    for stack in stacks[0][1:6:2]:
        stack.codes[:] = np.clip(np.rint(stack.codes + rng.normal(0, 3, stack.codes.shape)), 0, TOP)
    flats, darks = written(tmp_path, stacks, "npy")
    words = ["calibrate", *flats, "--dark", *darks, "-o", "s.toml"]
    found = invoke([*words, "--deny-warnings"], tmp_path)
    assert (found.status, (tmp_path / "s.toml").exists()) == (1, False)
    assert "NS0792" in found.err
    assert invoke(words, tmp_path).status == 0
    assert (tmp_path / "s.toml").exists()
