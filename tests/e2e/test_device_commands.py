"""`nscc run --on PORT` and `nscc device`, over real pseudo-terminals and real processes."""

from __future__ import annotations

import ast
import json
import os
import re
import shutil
import signal
import time
from datetime import datetime
from hashlib import sha256
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from device_server import LIMIT_S, SIZE, serving, start, write_files
from nscc_command import Outcome, invoke

from nscc_runtime.device.firmware import compiler

pytestmark = [
    pytest.mark.xdist_group("firmware"),
    pytest.mark.skipif(compiler() is None, reason="no C++ compiler for the firmware"),
]
ARRAYS = ("frame", "exposure_e", "valid", "saturated", "saturated_by")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a small chip, a program for it, and the frame that the emulator makes."""
    write_files(tmp_path)
    for line in (
        ["build", "small.nsl", "-o", "small.icw"],
        ["run", "small.icw", "--scene", "builtin:hdr", "-o", "emulated.npz"],
    ):
        outcome = invoke(line, tmp_path)
        assert outcome.status == 0, outcome.err
    return tmp_path


def same_frame(folder: Path, name: str) -> dict[str, Any]:
    """Check that a frame file is the emulator's, bit for bit; its meta. Only of a program that the
    device held can it not say what the shutters are."""
    with np.load(folder / "emulated.npz") as expected, np.load(folder / name) as found:
        tables = {key for key in expected.files if key.startswith("decode_")}
        assert tables
        assert {*found.files} | tables == {*expected.files}
        assert not tables & {*found.files} or tables <= {*found.files}
        for key in ARRAYS:
            assert found[key].dtype == expected[key].dtype
            np.testing.assert_array_equal(found[key], expected[key])
        meta: dict[str, Any] = json.loads(str(found["meta"]))
        assert meta.keys() >= json.loads(str(expected["meta"])).keys()
    return meta


def failed(outcome: Outcome, code: str, status: int = 3) -> str:
    """Check that a command failed with this code and says what to do; what it said."""
    assert (outcome.status, outcome.codes) == (status, [code]), outcome.err
    assert "help: " in outcome.err
    return outcome.err


def test_run_on_a_device_writes_the_frame_of_the_emulator(folder: Path) -> None:
    with serving(folder) as device:
        for name in ("small.icw", "small.nsl"):
            outcome = invoke(["run", name, "--on", device.port, "-o", "d.npz"], folder)
            assert outcome.status == 0, outcome.err
            meta = same_frame(folder, "d.npz")
        assert (meta["fidelity"], meta["scene_sha256"]) == ("device", None)
        digest = sha256((folder / "small.icw").read_bytes()).hexdigest()
        assert meta["program_sha256"] == digest
        line = ["run", "small.icw", "--on", device.port, "--repeat", "2", "--png", "p.png"]
        line += ["--timings", "t.json"]
        assert invoke([*line, "-o", "two.npz", "--keep", "shutter,codes"], folder).status == 0
        with np.load(folder / "two.npz") as two, np.load(folder / "d.npz") as one:
            assert two["frame"].shape == (2, 1, SIZE, SIZE)
            np.testing.assert_array_equal(two["exposure_e"][1], one["exposure_e"])
            assert two["shutter_shape"].tolist() == [1, SIZE, SIZE, 8]
        assert (folder / "p.png").read_bytes().startswith(b"\x89PNG")
        assert json.loads((folder / "t.json").read_text())["expose_s"] > 0


def test_a_frame_over_a_faulty_line_equals_one_over_a_good_line(folder: Path) -> None:
    """Bytes are changed and lost, the link breaks and the loader restarts. The frame still equals
    the emulator's."""
    fault = "corrupt=3e-4,drop=1e-4,delay=2ms,disconnect=after:1500,reboot=after:3000,outage=100ms"
    with serving(folder, "--fault", fault) as device:
        outcome = invoke(["run", "small.icw", "--on", device.port, "-o", "d.npz"], folder)
        assert outcome.status == 0, outcome.err
        same_frame(folder, "d.npz")


def test_states_go_on_from_frame_to_frame(folder: Path) -> None:
    (folder / "film.nsl").write_text(
        'nsl 3\ntarget "chip.toml"\nframe 4 slots of 1ms\nopen when true\noutside 1\n'
        "kernel k = [[1, 2, 1]] / 4\nkernel around = [[1, 1, 1], [1, 1, 1], [1, 1, 1]]\n"
        "state s : bit = 0 kept\nplane p = k(exposure) > 20%\nplane all = exposure > 20%\n"
        "next s = any(s, around) or p\nread s\nreport box s\nreport any all\n"
    )
    line = ["run", "film.nsl", "--repeat", "3", "-o"]
    assert invoke([*line, "e.npz", "--scene", "builtin:hdr"], folder).status == 0
    with serving(folder) as device:
        for name in ("d.npz", "again.npz"):
            assert invoke([*line, name, "--on", device.port], folder).status == 0
            with np.load(folder / name) as found, np.load(folder / "e.npz") as wanted:
                for key in ("plane_s", "margin", "report_box_s", "report_any_all"):
                    np.testing.assert_array_equal(found[key], wanted[key])
                sizes = found["margin"].sum(axis=(1, 2))
    assert sizes[0] < sizes[1] < sizes[2], "what is beyond the border spreads"


def test_a_device_is_described_programmed_and_captured(folder: Path) -> None:
    digest = sha256((folder / "small.icw").read_bytes()).hexdigest()
    with serving(folder) as device:
        outcome = invoke(["device", "info", device.port], folder)
        assert "no program (empty)" in outcome.out
        assert f"{SIZE} x {SIZE} pixels" in outcome.out
        held = invoke(["device", "capture", device.port, "-o", "c.npz"], folder)
        # The chip is no built-in one, so nscc has to be told what it is.
        failed(held, "NS0764")
        line = ["device", "capture", device.port, "--target", "chip.toml"]
        failed(invoke([*line, "-o", "c.npz"], folder), "NS0771")
        assert not (folder / "c.npz").exists()

        assert invoke(["device", "upload", device.port, "small.icw"], folder).status == 0
        found = json.loads(invoke(["device", "info", device.port, "--json"], folder).out)
        assert (found["label"], found["rows"], found["status"]["state"]) == (digest, SIZE, 3)
        outcome = invoke([*line, "-o", "c.npz"], folder)
        assert outcome.status == 0, outcome.err
        meta = same_frame(folder, "c.npz")
        assert meta["program_sha256"] == digest

        line = ["device", "capture", device.port, "small.icw", "--to", "many", "--count", "3"]
        for _ in range(2):
            assert invoke(line, folder).status == 0
        names = sorted(path.name for path in (folder / "many").iterdir())
        assert names == [f"frame-{number:06d}.npz" for number in range(1, 7)]
        stamps = []
        for name in names:
            meta = same_frame(folder, f"many/{name}")
            assert (meta["program_sha256"], meta["buckets"]) == (digest, ["frame"])
            stamps.append((datetime.fromisoformat(meta["time_utc"]), meta["device_time_us"]))
        assert stamps == sorted(stamps)
        assert len(set(stamps)) == len(stamps)


def test_the_scene_may_be_named(folder: Path) -> None:
    """A scene beside a device gives the note NS0770. The frame is the device's, and `truth_e` is
    computed from the scene."""
    with serving(folder) as device:
        line = ["run", "small.icw", "--on", device.port, "-o", "d.npz"]
        outcome = invoke([*line, "--scene", "builtin:hdr", "--keep", "truth"], folder)
        assert (outcome.status, outcome.codes) == (0, ["NS0770"])
        emulated = ["run", "small.icw", "--scene", "builtin:hdr", "--keep", "truth"]
        assert invoke([*emulated, "-o", "emulated.npz"], folder).status == 0
        same_frame(folder, "d.npz")
        with np.load(folder / "d.npz") as one, np.load(folder / "emulated.npz") as other:
            np.testing.assert_array_equal(one["truth_e"], other["truth_e"])


def test_options_of_the_emulator_are_refused(folder: Path) -> None:
    for more in (
        ["--effects", "none"],
        ["--seed", "0"],
        ["--fidelity", "reference"],
        ["--audit"],
        ["--exposure", "1000"],
        ["--keep", "light"],
    ):
        outcome = invoke(["run", "small.icw", "--on", "/dev/nowhere", *more], folder)
        assert " ".join(more[:1]) in failed(outcome, "NS0770", 2)


def test_a_port_that_cannot_be_opened_is_refused_without_a_frame_file(folder: Path) -> None:
    """A missing path, a file, a folder and `/dev/null` are no ports: NS0760, and no frame file is
    left."""
    (folder / "file").write_text("no port")
    for port in ("/dev/nowhere", "file", ".", "/dev/null", "file/x", "a\nb"):
        said = failed(invoke(["run", "small.icw", "--on", port], folder), "NS0760")
        assert "Traceback" not in said
    assert not list(folder.glob("*.frame.npz"))


@pytest.mark.skipif(os.geteuid() == 0, reason="the superuser may use every port")
def test_a_port_without_permission_is_refused(folder: Path) -> None:
    """A file of mode 0 gives NS0760, which says that the permission is missing."""
    (folder / "locked").write_text("")
    (folder / "locked").chmod(0)
    said = failed(invoke(["device", "info", "locked"], folder), "NS0760")
    assert "you have no permission to use it" in said


def test_a_busy_port_is_refused(folder: Path) -> None:
    import fcntl

    master, slave = os.openpty()
    fcntl.flock(slave, fcntl.LOCK_EX)
    try:
        failed(invoke(["device", "info", os.ttyname(slave)], folder), "NS0761")
    finally:
        os.close(slave)
        os.close(master)


def test_a_silent_port_is_reported_after_the_patience(folder: Path) -> None:
    master, slave = os.openpty()
    line = ["device", "info", os.ttyname(slave), "--patience", "0.5"]
    try:
        assert "says nothing" in failed(invoke(line, folder), "NS0762")
    finally:
        os.close(slave)
        os.close(master)


def test_a_device_that_sends_foreign_bytes_is_refused(folder: Path) -> None:
    """A terminal of another device, whose lines contain no end of a packet."""
    from threading import Timer

    master, slave = os.openpty()
    timer = Timer(0.3, os.write, (master, b"U-Boot 2021.01\r\n"))
    timer.start()
    line = ["device", "info", os.ttyname(slave), "--patience", "1.5"]
    try:
        said = failed(invoke(line, folder), "NS0762")
        assert "sends bytes that are not packets of the loader, beginning with 'U-Boot" in said
    finally:
        timer.join()
        os.close(slave)
        os.close(master)


def test_a_device_refuses_programs_of_another_target_table(folder: Path) -> None:
    """A program for scamp7, and one for the same chip with another clock, give NS0764. The right
    one still runs."""
    with serving(folder) as device:
        line = ["run", "small.nsl", "--target", "scamp7", "--on", device.port]
        failed(invoke(line, folder), "NS0764")
        # A small chip of the same name, with another clock.
        text = (folder / "chip.toml").read_text()
        (folder / "chip.toml").write_text(
            text.replace("digital_word_us = 0.1", "digital_word_us = 0.2")
        )
        said = failed(invoke(["run", "small.nsl", "--on", device.port], folder), "NS0764")
        assert "with another target table" in said
        assert invoke(["run", "small.icw", "--on", device.port], folder).status == 0


def test_a_device_that_stays_away_is_reported_and_nothing_written(folder: Path) -> None:
    """The link is away for 60 s and the patience is 0.5 s: NS0766."""
    fault = "disconnect=after:1000,outage=60s"
    with serving(folder, "--fault", fault) as device:
        line = ["run", "small.icw", "--on", device.port, "--patience", "0.5", "-o", "d.npz"]
        assert "did not return" in failed(invoke(line, folder), "NS0766")
    assert not (folder / "d.npz").exists()


def test_capture_refuses_contradicting_outputs(folder: Path) -> None:
    line = ["device", "capture", "/dev/nowhere"]
    for more in ([], ["-o", "f.npz", "--to", "many"], ["-o", "f.npz", "--count", "2"]):
        failed(invoke([*line, *more], folder), "NS0780", 2)
    failed(invoke([*line, "-o", "f.npz", "--pixels", "codes.npz"], folder), "NS0770", 2)
    failed(invoke([*line, "small.icw", "-o", "f", "--target", "scamp5"], folder), "NS0743", 2)
    (folder / "taken").write_text("")
    with serving(folder) as device:
        line = ["device", "capture", device.port, "small.icw", "--to", "taken/many"]
        failed(invoke(line, folder), "NS0784", 2)


def test_an_unknown_device_command_gets_a_suggestion(folder: Path) -> None:
    """`nscc device sreve` ends with status 2 and proposes `nscc device serve`."""
    assert "`nscc device serve`" in failed(invoke(["device", "sreve"], folder), "NS0781", 2)
    assert invoke(["device", "--help"], folder).status == 0


def test_a_stand_in_refuses_a_frame_if_its_scene_has_too_few_slots(folder: Path) -> None:
    np.savez(folder / "short.npz", light=np.ones((3, SIZE, SIZE), np.float32))
    with serving(folder, scene="short.npz") as device:
        failed(invoke(["run", "small.icw", "--on", device.port], folder), "NS0768")
        assert re.search(r"error\[NS073\d\]", device.stop())


def test_ctrl_c_leaves_the_device_usable(folder: Path) -> None:
    """The interrupted run ends with status 130 and leaves no frame file. The next run on the same
    port succeeds."""
    with serving(folder, "--fault", "delay=200ms") as device:
        running = start(["run", "small.icw", "--on", device.port, "-o", "d.npz"], folder)
        time.sleep(1.5)
        running.send_signal(signal.SIGINT)
        _, said = running.communicate(timeout=LIMIT_S)
        assert (running.returncode, "interrupted" in said) == (130, True), said
        assert [path.name for path in folder.glob("*.npz*")] == ["emulated.npz"]
        outcome = invoke(["run", "small.icw", "--on", device.port, "-o", "d.npz"], folder)
        assert outcome.status == 0, outcome.err
        same_frame(folder, "d.npz")


def test_ctrl_c_during_continuous_capture_leaves_only_complete_files(folder: Path) -> None:
    """After an interrupt, each of the four or more files equals the emulator's frame."""
    with serving(folder) as device:
        line = ["device", "capture", device.port, "small.icw", "--to", "many", "--every", "0.02"]
        running = start(line, folder)
        until = time.monotonic() + LIMIT_S
        while len(list(folder.glob("many/*.npz"))) < 4 and time.monotonic() < until:
            time.sleep(0.02)
        running.send_signal(signal.SIGINT)
        running.communicate(timeout=LIMIT_S)
        assert running.returncode == 130
        names = sorted(path.name for path in (folder / "many").iterdir())
        assert len(names) >= 4
        for name in names:
            same_frame(folder, f"many/{name}")


def test_a_stand_in_stops_after_one_session_or_a_given_time(folder: Path) -> None:
    """With `--once` it ends after one session, with `--for 0.1` after that many seconds; both with
    status 0."""
    with serving(folder, "--once") as device:
        assert invoke(["device", "info", device.port], folder).status == 0
        assert device.process.wait(LIMIT_S) == 0
    with serving(folder, "--for", "0.1") as device:
        assert device.process.wait(LIMIT_S) == 0


def test_serve_refuses_invalid_scenes_and_faults(folder: Path) -> None:
    line = ["device", "serve", "--target", "chip.toml"]
    failed(invoke(line, folder), "NS0744", 2)
    failed(invoke([*line, "--scene", "builtin:nothing"], folder), "NS0731", 2)
    failed(invoke([*line, "--scene", "absent.npz"], folder), "NS0730", 2)
    np.save(folder / "other_size.npy", np.ones((2, 3)))
    failed(invoke([*line, "--scene", "other_size.npy"], folder), "NS0734", 2)
    cv2.imwrite(str(folder / "p.png"), np.zeros((300, 300), np.uint8))
    failed(invoke([*line, "--scene", "p.png"], folder), "NS0737", 2)
    outcome = invoke([*line, "--scene", "builtin:hdr", "--fault", "drop=2"], folder)
    failed(outcome, "NS0769", 2)


def test_serving_without_a_compiler_is_refused(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without a compiler on the PATH, `nscc device serve` gives NS0772 with the help to install
    one."""
    monkeypatch.setenv("PATH", "/nowhere")
    line = ["device", "serve", "--target", "chip.toml", "--scene", "builtin:hdr"]
    said = failed(invoke(line, folder), "NS0772", 2)
    assert "install a C++17 compiler" in said


def test_frames_of_the_stand_in_equal_those_of_the_emulator(tmp_path: Path, root: Path) -> None:
    """Two buckets, a codebook, 4096 slots: the same frames as on the emulator."""
    with serving(tmp_path, line=["device", "serve", "--scene", "builtin:motion"]) as device:
        for name in ("two_buckets", "codebook", "class_b_4096"):
            program = str(root / f"examples/{name}.nsl")
            common = ["run", program, "-O", "1", "-o"]
            emulated = invoke([*common, "emulated.npz", "--scene", "builtin:motion"], tmp_path)
            exposed = invoke([*common, "d.npz", "--on", device.port], tmp_path)
            assert (emulated.status, exposed.status) == (0, 0), exposed.err
            same_frame(tmp_path, "d.npz")


@pytest.mark.pages
def test_the_commands_of_the_device_page_work(tmp_path: Path, root: Path) -> None:
    text = (root / "docs/device.md").read_text()
    lines = "".join(re.findall(r"^```sh\n(.*?)^```$", text, re.M | re.S)).splitlines()
    serve = [line.split()[1:] for line in lines if " serve " in line]
    assert len(serve) == 2
    shutil.copytree(root / "examples", tmp_path / "examples")
    (tmp_path / "build").mkdir()
    for arguments in serve:
        with serving(tmp_path, line=arguments) as device:
            for line in lines:
                if " serve " not in line and (" run " in line or arguments is serve[0]):
                    said = line.replace("/dev/pts/4", device.port).split()[1:]
                    outcome = invoke(said, tmp_path)
                    assert outcome.status == 0, outcome.err
    assert len(list((tmp_path / "build/many").iterdir())) == 3


def test_doctor_lists_ports(folder: Path) -> None:
    assert "serial ports: " in invoke(["doctor"], folder).out


def test_only_the_module_port_imports_serial(root: Path) -> None:
    importing = set()
    for path in [*root.glob("nscc/**/*.py"), *root.glob("runtime/**/*.py")]:
        for node in ast.walk(ast.parse(path.read_text())):
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            if any(name.split(".")[0] == "serial" for name in names):
                importing.add(path.relative_to(root).as_posix())
    assert importing == {"runtime/nscc_runtime/device/port.py"}
