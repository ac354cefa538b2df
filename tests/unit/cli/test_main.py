"""The command line as such: exit statuses, formats of messages, faults, help."""

from __future__ import annotations

import importlib
import json
import os
import re
import signal
import subprocess
import sys
import zipfile
from concurrent.futures import ThreadPoolExecutor
from contextlib import nullcontext, suppress
from pathlib import Path

import click
import numpy as np
import pytest
from nscc_command import invoke

from nscc import __version__, installation
from nscc_cli.group import COMMANDS, group

GOOD = (
    "nsl 1\nframe 4 slots of 1ms\ncode stop : 1..4\nopen when n < stop\npixels stop = 1 + x % 4\n"
)
WARNS = GOOD.replace("1 + x % 4", "4").replace("1..4", "4..4")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a good program and a bad one."""
    (tmp_path / "ok.nsl").write_text(GOOD)
    (tmp_path / "bad.nsl").write_text(GOOD.replace("n < stop", "n < stopp"))
    return tmp_path


def test_every_option_is_explained() -> None:
    """Options have a help text, and those with a number as default show it."""
    pending: list[tuple[str, click.Command]] = [("nscc", group)]
    while pending:
        name, command = pending.pop()
        context = click.Context(command)
        if isinstance(command, click.Group):
            for part in command.list_commands(context):
                subcommand = command.get_command(context, part)
                assert subcommand is not None
                pending.append((f"{name} {part}", subcommand))
        for option in command.params:
            if isinstance(option, click.Option) and not option.hidden:
                assert option.help, (name, option.opts)
                numeric = type(option.default) in (int, float)
                assert not numeric or option.show_default or "default" in option.help, (
                    name,
                    option.opts,
                )


def test_version_and_help_are_printed(folder: Path) -> None:
    """`--version` prints the version alone. `--help` lists every command with its text."""
    assert invoke(["--version"], folder).out == f"nscc {__version__}\n"
    listed = invoke(["--help"], folder)
    assert listed.status == 0
    assert [name for name, text in COMMANDS.items() if text not in listed.out] == []


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_help_and_common_options(folder: Path, name: str) -> None:
    """`nscc NAME --help` ends with status 0 and names the two options that all commands share."""
    outcome = invoke([name, "--help"], folder)
    assert outcome.status == 0
    assert "--message-format" in outcome.out
    assert "--deny-warnings" in outcome.out


@pytest.mark.parametrize(
    ("arguments", "status", "code", "part"),
    [
        (["check", "ok.nsl"], 0, None, ""),
        (["check", "bad.nsl"], 1, "NS0214", "did you mean"),
        (["check", "none.nsl"], 2, None, "none.nsl"),
        (["check", "ok.nsl", "bad.nsl", "none.nsl"], 2, None, "none.nsl"),
        (["chek", "ok.nsl"], 2, "NS0781", "nscc check"),
        (["ok.nsl"], 2, "NS0781", "nscc check ok.nsl"),
        (["check"], 2, "NS0780", "FILE"),
        (["check", "--deny-warning", "ok.nsl"], 2, "NS0782", "--deny-warnings"),
        (["build", "ok.nsl", "-O", "fast"], 2, "NS0783", "-O"),
        (["build", "ok.nsl", "-o", "ok.nsl/ok.icw"], 2, "NS0784", "ok.nsl/ok.icw"),
        (["--frobnicate"], 2, "NS0782", "--frobnicate"),
        (["run", "ok.nsl", "builtin:hdr"], 2, "NS0780", "did you mean `--scene builtin:hdr`?"),
        (["run", "ok.nsl", "my.png"], 2, "NS0780", "did you mean `--scene my.png`?"),
        (["run", "ok.nsl", "--tolerance", "5", "e"], 2, "NS0780", "in quotation marks"),
        (["run", "ok.nsl", "--scene", "hdr"], 2, "NS0730", "did you mean `builtin:hdr`?"),
        (["run", "ok.nsl", "--repeat", "many"], 2, "NS0783", "'many' is not a whole number"),
        (["run", "ok.nsl", "--fps"], 2, "NS0780", "`nscc run --help` lists"),
        (["run", "ok.nsl", "--scene", "*.png"], 2, "NS0730", "only with --bracket"),
        (["effects", "nine"], 2, "NS0756", "help: name one of them"),
        (["effects", "shot-noise"], 2, "NS0756", "did you mean `shot`?"),
        (["effects", "shot", "--json"], 2, "NS0780", "]: EFFECT, --json"),
        (["metrics", "a.npy", "b.npy"], 2, "NS0780", "--data-range: The peak"),
        (["disasm", "ok.nsl"], 1, "NS0702", "`nscc build ok.nsl`"),
        ([], 2, "NS0780", "--help"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else None,
)
def test_commands_have_the_documented_status_and_message(
    folder: Path, arguments: list[str], status: int, code: str | None, part: str
) -> None:
    outcome = invoke(arguments, folder)
    assert outcome.status == status
    assert part in outcome.err
    assert code is None or code in outcome.codes


@pytest.mark.parametrize(
    ("arguments", "code", "helps"),
    [
        (["plot", "ok.nsl"], "NS0781", "did you mean `nscc view`?"),
        (["compile", "ok.nsl"], "NS0781", "did you mean `nscc build`?"),
        (["help"], "NS0781", "did you mean `nscc --help`?"),
        (["sweep", "grid.toml", "-o", "x"], "NS0782", "did you mean `--out`?"),
        (["check", "-ok.nsl"], "NS0782", "begins with - as ./-NAME"),
        (["device"], "NS0780", "there is: calibrate, capture, info, serve, upload"),
        (["evaluate"], "NS0780", "`nscc evaluate hdr --data DIR --protocol hdr-v1`"),
        (["tradeoff"], "NS0780", "or name a program (FILE.nsl, FILE.icw) or a run: RUN, hdr, clip"),
        (["demo", "ok.nsl"], "NS0780", "`nscc run ok.nsl --scene PHOTO`"),
        (["build", "ok.nsl", "-o", "x.foo"], "NS0786", "name it x.icw"),
        (["build", "ok.nsl", "-o", "x.cpp"], "NS0786", "`--emit cpp -o x.icw`"),
        (["design", "x.nsl"], "NS0780", "-o x.nsl names the one to write"),
        (["reconstruct", "missing.npz", "-o", "o.npz"], "NS0819", "the file does not exist"),
        (["reconstruct", "ok.nsl", "-o", "o.npz"], "NS0819", "`nscc run PROGRAM.nsl --scene SCENE"),
        (["reconstruct", "any", "-o", "o.npz"], "NS0780", "needs FRAME.npz"),
        (["tradeoff", "foo"], "NS0781", "there is: decoder, emulator, images, sensor, synthesis"),
    ],
)
def test_wrong_commands_say_what_to_write(
    folder: Path, arguments: list[str], code: str, helps: str
) -> None:
    ended = invoke(arguments, folder)
    assert ended.status == 2
    assert f"[{code}]" in ended.err
    assert helps in ended.err
    assert "Error:" not in ended.err
    assert not list(folder.glob("x*"))


def test_messages_about_frame_files_suggest_reconstruct_and_a_name_for_its_output(
    folder: Path,
) -> None:
    """A frame file as a scene gives a help with the command that decodes it. An output `f.txt` gets
    the proposal `f.npy`, as `f.npz` is the input."""
    assert invoke(["run", "ok.nsl", "--scene", "builtin:dark", "-o", "f.npz"], folder).status == 0
    as_scene = invoke(["run", "ok.nsl", "--scene", "f.npz"], folder)
    assert "`nscc reconstruct any f.npz -o OUT.png` decodes it" in as_scene.err
    wrong = invoke(["reconstruct", "any", "f.npz", "-o", "f.txt"], folder)
    assert "[NS0786]" in wrong.err
    assert "name it f.npy" in wrong.err  # f.npz is the input


def test_prove_prints_the_same_result_for_a_program_and_its_container(folder: Path) -> None:
    """The lines for the text and for its container differ only in the name of the file."""
    invoke(["build", "ok.nsl", "-o", "named_otherwise"], folder)
    proofs = [invoke(["prove", name], folder) for name in ("ok.nsl", "named_otherwise")]
    assert [proof.status for proof in proofs] == [0, 0]
    program, container = (proof.out.partition(": ")[2] for proof in proofs)
    assert program == container


def test_a_measurement_of_another_camera_needs_no_decoder_name(folder: Path) -> None:
    """A file with `meas` and `mask` is reconstructed without `any` before its name, to the same
    bytes."""
    generator = np.random.default_rng(0)
    mask = generator.integers(0, 2, (16, 16, 4)).astype(np.uint8)
    np.savez(folder / "own.npz", meas=(mask * generator.random(mask.shape)).sum(-1), mask=mask)
    options = ["--method", "gap-tv", "-o"]
    for arguments in (["own.npz"], ["any", "own.npz"]):
        name = f"{len(arguments)}.npy"
        assert invoke(["reconstruct", *arguments, *options, name], folder).status == 0
    assert (folder / "1.npy").read_bytes() == (folder / "2.npy").read_bytes()


@pytest.mark.parametrize("arguments", [["check", "bad.nsl"], ["chek"], ["check", "--what"]])
def test_json_is_one_object_a_line_even_for_wrong_usage(folder: Path, arguments: list[str]) -> None:
    outcome = invoke([*arguments, "--message-format", "json"], folder)
    found = [json.loads(line) for line in outcome.err.splitlines()]
    assert found
    assert {
        "code",
        "name",
        "severity",
        "message",
        "filename",
        "location",
        "end_location",
        "data",
        "fixes",
        "rendered",
    } <= set(found[0])


@pytest.mark.parametrize(
    ("options", "written"),
    [
        ([], {"ok.icw"}),
        (["-o", "a.icw"], {"a.icw"}),
        (["--emit", "asm"], {"ok.asm"}),
        (["--emit", "asm,icw"], {"ok.asm", "ok.icw"}),
        (["--emit", "asm", "-o", "a.icw"], {"a.asm", "a.icw"}),
        (["--emit", "asm=-"], set()),
    ],
)
def test_build_writes_exactly_the_requested_products(
    folder: Path, options: list[str], written: set[str]
) -> None:
    """The container is written beside other products only if `-o` or `icw` asks for it."""
    before = {path.name for path in folder.iterdir()}
    assert invoke(["build", "ok.nsl", *options], folder).status == 0
    assert {path.name for path in folder.iterdir()} - before == written
    told = " ".join(invoke(["build", "--help"], folder).out.split())
    assert "The container is written only with icw or -o." in told
    assert "Also write" not in told


def test_denied_warnings_are_errors_and_write_no_file(folder: Path) -> None:
    """The warning is an error of status 1 with `--deny-warnings`. Without it the build succeeds."""
    (folder / "warns.nsl").write_text(WARNS)
    plain = invoke(["build", "warns.nsl", "-o", "a.icw"], folder)
    assert plain.status == 0
    if "warning[" not in plain.err:
        pytest.fail("the program no longer warns: choose another one")
    denied = invoke(["build", "warns.nsl", "-o", "b.icw", "--deny-warnings"], folder)
    assert denied.status == 1
    assert "error[" in denied.err
    assert not (folder / "b.icw").exists()


def test_messages_have_no_colour_without_a_terminal(folder: Path) -> None:
    assert "\x1b" not in invoke(["check", "bad.nsl"], folder).err


@pytest.mark.parametrize(
    ("error", "status", "code"),
    [
        (ZeroDivisionError("here"), 70, "NS0901"),
        (MemoryError(), 3, "NS0902"),
        (RecursionError(), 1, "NS0903"),
        (PermissionError(13, "Permission denied", "some/file"), 2, "NS0784"),
        (KeyboardInterrupt(), 130, None),
        (BrokenPipeError(32, "Broken pipe"), 0, None),
    ],
    ids=lambda value: type(value).__name__ if isinstance(value, BaseException) else None,
)
def test_exceptions_become_messages_with_an_exit_status(
    folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    error: BaseException,
    status: int,
    code: str | None,
) -> None:
    def fail(*_arguments: object) -> None:
        raise error

    monkeypatch.setattr("nscc.compiler.compile_file", fail)
    monkeypatch.setattr("os.dup2", lambda *_: None)
    outcome = invoke(["check", "ok.nsl"], folder)
    assert outcome.status == status
    assert outcome.codes == ([code] if code else [])
    assert "Traceback" not in outcome.err


def test_a_memory_error_says_how_much_is_missing(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The message gives the 7.45 GiB of numpy's error, and how much memory is free."""

    def fail(*_arguments: object) -> None:
        raise MemoryError("Unable to allocate 7.45 GiB for an array with shape (1000000000,)")

    monkeypatch.setattr("nscc.compiler.compile_file", fail)
    said = invoke(["check", "ok.nsl"], folder).err
    assert re.search(r"one array needs 7.45 GiB, but [\d.]+ of [\d.]+ GiB of memory are free", said)


@pytest.mark.parametrize("caught", [True, False])
def test_an_interrupt_hidden_by_another_error_ends_as_an_interrupt(
    caught: bool, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """C code that is being imported may swallow an interrupt and fail with another error."""

    def fail(*_arguments: object) -> None:
        with suppress(KeyboardInterrupt) if caught else nullcontext():
            os.kill(os.getpid(), signal.SIGINT)
        raise RecursionError

    monkeypatch.setattr("nscc.compiler.compile_file", fail)
    before = signal.getsignal(signal.SIGINT)
    for _ in range(2):
        outcome = invoke(["check", "ok.nsl"], folder)
        assert (outcome.status, outcome.codes) == (130, [])
        assert "interrupted" in outcome.err
    assert signal.getsignal(signal.SIGINT) is before
    monkeypatch.undo()
    assert invoke(["check", "ok.nsl"], folder).status == 0


def outcome_of_script(script: str, folder: Path, *arguments: str) -> tuple[int, str]:
    """Exit status and standard error of a Python script that runs `nscc` with these arguments."""
    ended = subprocess.run(
        [sys.executable, "-c", script, *arguments],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
        env={**os.environ, "PYTHONPATH": ":".join(sys.path)},
    )
    return ended.returncode, ended.stderr


TWICE = """
import os, signal, time
import nscc.compiler
from nscc_cli.main import main

def interrupted(*_):
    try:
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(60)
    finally:
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(60)

nscc.compiler.compile_file = interrupted
raise SystemExit(main())
"""


def test_a_second_interrupt_ends_at_once_without_a_traceback(folder: Path) -> None:
    """The second interrupt comes while a command cleans up after the first one."""
    assert outcome_of_script(TWICE, folder, "check", "ok.nsl") == (130, "\ninterrupted\n")


AT_THE_END = """
import os, signal, sys
import nscc.compiler
from nscc_cli.main import main

class Late:
    def __del__(self, kill=os.kill, process=os.getpid(), interrupt=signal.SIGINT):
        kill(process, interrupt)

sys.late = Late()
nscc.compiler.compile_file = lambda *_: os.kill(os.getpid(), signal.SIGINT)
raise SystemExit(main())
"""


def test_an_interrupt_while_python_ends_keeps_the_exit_status(folder: Path) -> None:
    """At that time Python has removed its signal handlers, so the signal would kill the process."""
    assert outcome_of_script(AT_THE_END, folder, "check", "ok.nsl") == (130, "\ninterrupted\n")


AT_IMPORT = """
import os, signal, sys

class Interrupts:
    left = int(sys.argv.pop(1))

    def find_spec(self, *_):
        self.left -= 1
        if self.left == 0:
            os.kill(os.getpid(), signal.SIGINT)

from nscc_cli.__main__ import main
sys.meta_path.insert(0, Interrupts())
raise SystemExit(main())
"""


@pytest.mark.parametrize("number", [1, 2, 3, 5, 8, 13, 21, 34, 55])
def test_an_interrupt_while_modules_are_imported_prints_no_traceback(
    number: int, folder: Path
) -> None:
    """The interrupt comes at the import with this number after the start of `nscc`."""
    assert outcome_of_script(AT_IMPORT, folder, str(number), "check", "ok.nsl") == (
        130,
        "\ninterrupted\n",
    )


def test_a_caller_that_handles_interrupts_keeps_its_handler(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A program's own handler is left in place, and threads have none."""
    came: list[int] = []
    monkeypatch.setattr(
        "nscc.compiler.compile_file", lambda *_: signal.raise_signal(signal.SIGINT) or 1 // 0
    )
    before = signal.signal(signal.SIGINT, lambda number, _frame: came.append(number))
    try:
        # 70 is the status of a fault of nscc.
        assert invoke(["check", "ok.nsl"], folder).status == 70
    finally:
        signal.signal(signal.SIGINT, before)
    assert came == [signal.SIGINT]
    monkeypatch.undo()
    with ThreadPoolExecutor(1) as threads:
        assert threads.submit(invoke, ["check", "ok.nsl"], folder).result().status == 0


def test_long_help_comes_in_sections(folder: Path) -> None:
    """`nscc run --help` has six sections in this order, and each holds the option that belongs to
    it."""
    lines = invoke(["run", "--help"], folder).out.splitlines()
    titles = [line for line in lines if line.endswith(":") and not line.startswith(" ")]
    assert titles == ["Scene:", "Sensor effects:", "Compile:", "Device:", "Output:", "Options:"]
    options = ("--scene", "--effects", "-O", "--on", "--png", "--deny-warnings")
    for option, title, after in zip(options, titles, [*titles[1:], None], strict=True):
        section = lines[lines.index(title) : None if after is None else lines.index(after)]
        assert any(line.startswith(f"  {option} ") for line in section)


def test_a_fault_leaves_a_reproducer(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A ZeroDivisionError in the compiler leaves a zip file. It holds the command, the traceback,
    the versions and both input files."""
    (folder / "book.npz").write_bytes(b"data")
    (folder / "uses.nsl").write_text('nsl 1\nshutters b from "book.npz"\n')
    monkeypatch.setattr("nscc.compiler.compile_file", lambda *_: 1 // 0)
    outcome = invoke(["check", "uses.nsl"], folder)
    [saved] = folder.glob("nscc-fault-*.zip")
    assert saved.name in outcome.err
    with zipfile.ZipFile(saved) as archive:
        names = set(archive.namelist())
        assert archive.read("command.txt") == b"nscc\ncheck\nuses.nsl\n"
        assert b"ZeroDivisionError" in archive.read("traceback.txt")
    assert {"versions.txt", "inputs/0-uses.nsl", "inputs/1-book.npz"} <= names


def test_output_may_be_cut_off(folder: Path) -> None:
    """`nscc explain | head -n 1` ends with status 0 and without a message, though the pipe closes
    early."""
    command = f"{sys.executable} -m nscc_cli explain | head -n 1"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    outcome = subprocess.run(
        ["bash", "-o", "pipefail", "-c", command],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
    )
    assert outcome.stderr == ""
    assert outcome.returncode == 0


def test_doctor_finds_nothing_wrong(folder: Path) -> None:
    """`nscc doctor` ends with status 0, prints the version and no line with WRONG."""
    outcome = invoke(["doctor"], folder)
    assert outcome.status == 0, outcome.out
    assert f"nscc {__version__}" in outcome.out
    assert "WRONG" not in outcome.out


def test_doctor_names_an_extra_that_cannot_be_imported(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def import_module(name: str) -> object:
        # The package is there, but a library that it needs is not.
        if name == "matplotlib":
            raise OSError("libfreetype.so: cannot open\nshared object file")
        return importlib.import_module(name)

    monkeypatch.setattr(installation, "import_module", import_module)
    outcome = invoke(["doctor"], folder)
    lines = [line for line in outcome.out.splitlines() if "matplotlib" in line]
    assert lines
    for line in lines:
        assert line.split()[0] == installation.BROKEN
        assert "(OSError: libfreetype.so: cannot open shared object file)" in line
    assert outcome.status == 0


def test_doctor_says_that_loops_are_compiled_in_every_run(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("numba")
    from nscc_runtime.loop import Loop

    monkeypatch.setattr(Loop, "is_compiled", lambda _loop: False)
    monkeypatch.setattr(Loop, "is_kept", lambda _loop: False)
    monkeypatch.setattr(Loop, "load", lambda _loop: None)
    monkeypatch.setattr("nscc_runtime.machine_code.can_keep", lambda _folders: False)
    outcome = invoke(["doctor"], folder)
    (line,) = [line for line in outcome.out.splitlines() if "loops" in line]
    assert "are not kept: compiling loops: some seconds in every run" in line
    assert "XDG_CACHE_HOME names" in line
    assert outcome.status == 0


def test_loops_that_a_run_says_to_compile_are_compiled(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Loops that the scene does not need are compiled too, so the next run prints no message."""
    pytest.importorskip("numba")
    from nscc_runtime.execution.block_loop import run_blocks
    from nscc_runtime.loop import Loop

    compiled: list[Loop] = []
    monkeypatch.setattr(Loop, "is_compiled", lambda loop: loop in compiled)
    monkeypatch.setattr(Loop, "load", lambda loop: compiled.append(loop))
    (folder / "p.nsl").write_text("nsl 1\nframe 4 slots of 1ms\nopen when n < 2\n")
    line = ["run", "p.nsl", "--scene", "builtin:flat:9000", "--effects", "all", "-o", "f.npz"]
    said = [invoke(line, folder).err.count("compiling the planner's loops") for _ in range(2)]
    assert said == [1, 0]
    assert compiled == [run_blocks]


@pytest.mark.parametrize(
    "names",
    [("HOME", "XDG_CACHE_HOME"), ("NSCC_CACHE_DIR",), ("MPLCONFIGDIR", "XDG_CONFIG_HOME")],
    ids="-".join,
)
def test_folders_that_cannot_be_written_give_at_most_one_line(
    folder: Path, names: tuple[str, ...]
) -> None:
    """Run and draw in a new process, because packages read their folders once."""
    bad = dict.fromkeys(names, "/dev/null/folder")
    nscc = [sys.executable, "-m", "nscc_cli"]
    for arguments, product in (
        (
            ["run", "ok.nsl", "--scene", "builtin:hdr", "--effects", "none", "-o", "frame.npz"],
            "frame.npz",
        ),
        (["view", "ok.nsl", "-o", "ok.png"], "ok.png"),
    ):
        done = subprocess.run(
            [*nscc, *arguments],
            cwd=folder,
            env={**os.environ, **bad},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        assert (folder / product).stat().st_size > 0
        ordinary = ("frame  ", "wrote ")
        others = [line for line in done.stderr.splitlines() if not line.startswith(ordinary)]
        assert len(others) <= 1, done.stderr


def test_messages_quote_names_with_blanks_and_explain_a_leading_dash(folder: Path) -> None:
    """A proposed command quotes a name with a blank. A file `-lead.nsl` looks like an option:
    NS0782 says to write `./`."""
    assert "`nscc check 'my prog.nsl'`" in invoke(["new", "my prog"], folder).err
    assert "`nscc check 'my prog.nsl'`" in invoke(["my prog.nsl"], folder).err
    dashed = invoke(["check", "-lead.nsl"], folder)
    assert dashed.codes == ["NS0782"]
    assert "write a file name that begins with - as ./-NAME" in dashed.err


def test_a_tone_curve_without_a_picture_is_refused(folder: Path) -> None:
    """`--tone` changes only pictures, so with `-o a.npz` it is refused; with `a.png` it is
    accepted."""
    line = ["run", "ok.nsl", "--scene", "builtin:dark", "--tone", "log", "-o"]
    refused = invoke([*line, "a.npz"], folder)
    assert refused.status == 2
    assert "--tone has no effect" in refused.err
    assert invoke([*line, "a.png"], folder).status == 0
