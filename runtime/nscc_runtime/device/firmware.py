"""The firmware compiled for this machine, and communication with its process.

The process runs the real core (`runtime/firmware`). The commands to its board arrive here as a job,
word by word, and run on the emulator."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from atexit import register
from collections.abc import Callable, Sequence
from concurrent.futures import Future
from contextlib import suppress
from functools import partial
from hashlib import sha256
from pathlib import Path
from select import select
from struct import Struct
from typing import NamedTuple, Self

from nscc.cache.folder import cache_folder, is_own
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Rejected
from nscc.files import store_files
from nscc_runtime.device.board import (
    BoardJob,
    EmulatedChip,
    ExecutedFrame,
    Recording,
    in_background,
)
from nscc_runtime.device.target_header import target_header

_PACKAGE = Path(__file__).resolve().parents[1]
_INSTALLED = _PACKAGE / "firmware_files"
SOURCES = _INSTALLED if _INSTALLED.is_dir() else _PACKAGE.parent / "firmware"
WARNINGS = ("-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-pedantic")
CORE_FLAGS = ("-std=c++17", "-fno-exceptions", "-fno-rtti")

_PORT = b"P"
"""Kind of the record with the name of the process's terminal."""
_RECORD = Struct("<BI")
"""Head of a record: its kind, a letter, and the number of bytes of data that follow."""
_RESULT = Struct("<IB")
"""Start of the answer to a job: its number, and 1 if the frame was exposed."""
_MOST_READ = 1 << 16
_START_S = 10.0
"""Time for the process to end when its input is closed, in seconds."""


class NotBuilt(Exception):
    """The firmware cannot be compiled here; the text is the reason."""


class NotStarted(NotBuilt):
    """The firmware does not start; the text is the reason."""


class Built(NamedTuple):
    """A compiled loader, its compiler, and its target."""

    path: Path
    compiler: str
    target: Target


def compiler() -> str | None:
    """Return the name of a C++ compiler on this machine: `CXX` if it names one, else g++ or
    clang++; None if there is none."""
    names = [os.environ.get("CXX", ""), "g++", "clang++"]
    return next((name for name in names if name and shutil.which(name)), None)


def built(target: Target, extra: Sequence[str] = ("-O2",), folder: Path | None = None) -> Built:
    """Return the loader for `target`, compiled now or taken from the cache.

    `extra`: further options of the compiler. `folder`: where it is cached; None for nscc's cache
    folder, or a temporary folder without a cache. Raises NotBuilt if it cannot be compiled, or not
    be stored in `folder`."""
    compiler_path = compiler()
    if compiler_path is None:
        raise NotBuilt("no C++ compiler was found")
    command = [compiler_path, *CORE_FLAGS, *WARNINGS, *extra]
    return Built(
        compiled(command, ("core", "emulated", "host"), target, folder), compiler_path, target
    )


def compiled(
    command: Sequence[str], subfolders: Sequence[str], target: Target, folder: Path | None = None
) -> Path:
    """Return the path of the firmware for `target`, compiled or cached.

    `command`: the compiler with its options. `subfolders`: those of the firmware whose sources are
    compiled. `folder`: where it is cached, None for nscc's cache folder or a temporary one. Raises
    NotBuilt if sources are missing, if they do not compile, for a target that the loader does not
    support, or if `folder` cannot be written."""
    sources = [
        path for subfolder in subfolders for path in sorted(SOURCES.glob(f"{subfolder}/*.cpp"))
    ]
    if not sources:
        raise NotBuilt("its sources are not part of this installation")
    try:
        header = target_header(target)
    except ValueError as reason:
        raise NotBuilt(str(reason)) from None
    # All sources, headers (.hpp) and linker scripts (.ld): the name changes with any of them.
    texts = [path.read_bytes() for path in sorted(SOURCES.glob("*/*.[chl][pd]*"))]
    key = sha256(b"\0".join([header.encode(), " ".join(command).encode(), *texts]))
    name = f"loader-{key.hexdigest()[:32]}"
    place = (folder or cached_folder()) / name
    if not is_whole(place):
        includes = [f"-I{SOURCES / subfolder}" for subfolder in subfolders]
        image = _compile([*command, *includes, *map(str, sources)], header)
        try:
            keep(place, image)
        except Rejected as reason:
            if folder is not None:
                raise NotBuilt(reason.diagnostics[0].message) from None
            place = passing_folder() / name  # the cache is full or damaged
            keep(place, image)
    return place


def _compile(command: list[str], header: str) -> bytes:
    """Return the bytes of the program that a compiler makes of the firmware with `header`, the text
    of `target.hpp`.

    `command` is the compiler with its options and sources. Raises NotBuilt with the first line that
    mentions an error."""
    with tempfile.TemporaryDirectory(prefix="nscc-firmware-") as name:
        folder = Path(name)
        (folder / "target.hpp").write_text(header)
        out = folder / "loader"
        line = [*command, f"-I{folder}", "-o", str(out)]
        result = subprocess.run(line, capture_output=True, text=True)
        if result.returncode:
            lines = result.stderr.strip().splitlines() or [command[0]]
            raise NotBuilt(next((line for line in lines if "error" in line), lines[0]))
        return out.read_bytes()


def _digest_of(place: Path) -> Path:
    """Return the path of the file with the SHA-256 of a cached loader."""
    return place.with_name(f"{place.name}.sha256")


def is_whole(place: Path) -> bool:
    """Return whether the cached loader at `place` is intact (by its stored SHA-256), executable and
    this user's. False if it does not exist."""
    try:
        digest = sha256(place.read_bytes()).hexdigest().encode()
        return (
            is_own(place) and _digest_of(place).read_bytes() == digest and os.access(place, os.X_OK)
        )
    except OSError:
        return False


def keep(place: Path, image: bytes) -> None:
    """Store a compiled loader `image` and its SHA-256 at `place`, executable, in place of an older
    one. Raises Rejected if the folder is not writable."""
    # A file keeps the permissions of the one that it replaces. So a process that stores the same
    # loader a little later never makes it impossible to execute.
    with suppress(OSError):
        os.close(os.open(place, os.O_CREAT | os.O_WRONLY, 0o755))
    store_files({_digest_of(place): sha256(image).hexdigest().encode(), place: image})
    place.chmod(0o755)


def cached_folder() -> Path:
    """Return the cache folder of loaders, which is created, or a temporary folder for this process
    if there is no cache, or it is not this user's or not writable."""
    cache = cache_folder()
    if cache is not None:
        folder = cache / "firmware"
        with suppress(OSError):
            folder.mkdir(0o755, parents=True, exist_ok=True)
            if is_own(folder) and os.access(folder, os.W_OK):
                return folder
    return passing_folder()


def passing_folder() -> Path:
    """Return a temporary folder that is removed when this process ends."""
    folder = tempfile.mkdtemp(prefix="nscc-firmware-")
    register(shutil.rmtree, folder, ignore_errors=True)
    return Path(folder)


class RunningFirmware:
    """The process of the loader, in real time behind a non-blocking file descriptor, its line to
    the host. The frames that it requests (jobs) arrive as records and run on `chip`."""

    def __init__(self, command: Sequence[str], target: Target, chip: EmulatedChip) -> None:
        """Start the firmware by `command`, a program and its arguments, as a process with pipes.
        `chip` executes the words that it sends to its board, recorded as words of `target`. Raises
        OSError if it cannot be started."""
        self.chip = chip
        self._process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._in, self._out = self._process.stdin, self._process.stdout
        self._held = bytearray()
        self._recording = Recording(target)
        self._line = -1
        self._unsent = b""
        self._exposing: list[tuple[BoardJob, Future[ExecutedFrame]]] = []

    def __enter__(self) -> Self:
        """Return the process, which ends at the end of the `with` block."""
        return self

    def __exit__(self, *_: object) -> None:
        """End the process."""
        self.close()

    def fileno(self) -> int:
        """Return the file descriptor that becomes readable when records arrive."""
        return self._out.fileno()

    def write_record(self, kind: bytes, data: bytes = b"") -> None:
        """Send a record to the process: its `kind`, one byte, and its `data`. Waits until all is
        written; raises OSError if the process has ended."""
        view = memoryview(_RECORD.pack(kind[0], len(data)) + data)
        while view:
            view = view[os.write(self._in.fileno(), view) :]

    def fill(self) -> None:
        """Wait for bytes of the process and store them for `next`. Raises RuntimeError if the
        process has ended."""
        data = os.read(self.fileno(), _MOST_READ)
        if not data:
            raise RuntimeError(f"the loader's process ended: status {self._process.wait()}")
        self._held += data

    def next(self) -> tuple[bytes, bytes] | None:
        """Return kind (one byte) and data of the next record among the stored bytes, and remove it;
        None if it is not complete yet."""
        if len(self._held) < _RECORD.size:
            return None
        kind, size = _RECORD.unpack_from(self._held)
        end = _RECORD.size + size
        if len(self._held) < end:
            return None
        data = bytes(self._held[_RECORD.size : end])
        del self._held[:end]
        return bytes([kind]), data

    def announce(self) -> None:
        """Restart the loader."""
        self.write_record(b"X")

    def execute(self, job: BoardJob) -> ExecutedFrame:
        """Return the frame of `job`, executed on the chip. Raises what the chip raises."""
        return self.chip.execute(job.program, job.channels)

    def answer(self, job: BoardJob, exposed: Callable[[], ExecutedFrame]) -> None:
        """Send the loader the frame that `exposed` returns, or that the `job` (the frame that it
        requested) failed. An exception of `exposed` is reported to the chip's owner, and not
        raised."""
        try:
            executed = exposed()
        except Exception as error:
            self.chip.report(error)
            self.write_record(b"R", _RESULT.pack(job.number, 0))
        else:
            self._recording.keep(job, executed)
            self.write_record(b"R", _RESULT.pack(job.number, 1) + self.sent(job, executed.frame))

    def sent(self, job: BoardJob, frame: bytes) -> bytes:
        """Return the part of `frame` that is sent with the reply to `job`: all of it. Subclasses
        send less."""
        return frame

    @property
    def busy(self) -> bool:
        """Whether bytes wait for the loader, or a frame is being exposed."""
        return bool(self._unsent) or bool(self._exposing)

    def watched(self) -> list[int]:
        """Return the file descriptors of the line and of the job pipe."""
        return [self._line, self.fileno()]

    def receive(self, data: bytes, now_us: int) -> None:
        """Send `data` of the host to the loader; what its line does not take now is sent at the
        next call. `now_us` is ignored, because the loader has its own clock."""
        self._unsent += data
        with suppress(BlockingIOError):
            self._unsent = self._unsent[os.write(self._line, self._unsent) :]

    def poll(self, now_us: int, room: int) -> bytes:
        """Handle the loader's records and finished frames, and return at most `room` bytes that it
        has sent to the host; empty if there are none. `now_us` is ignored."""
        self.receive(b"", now_us)
        while select([self.fileno()], [], [], 0)[0]:
            self.fill()
        while (record := self.next()) is not None:
            self.follow(*record)
        for pending in [pending for pending in self._exposing if pending[1].done()]:
            self._exposing.remove(pending)
            self.answer(pending[0], pending[1].result)
        try:
            return os.read(self._line, room)
        except BlockingIOError:
            return b""

    def follow(self, kind: bytes, data: bytes) -> None:
        """Handle a record of the loader, by `kind` (one byte) and `data`: a job begins to run in
        the background. Raises ValueError for an unknown kind."""
        job = self._recording.take(kind, data)
        if job is not None:
            self._exposing.append((job, in_background(partial(self.execute, job))))

    def close(self) -> int:
        """Close the line and end the process; return its exit status, not 0 if a sanitizer found an
        error."""
        if self._line >= 0:
            os.close(self._line)
        with suppress(OSError):
            self._in.close()
        try:
            self._process.wait(_START_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._out.close()
        return self._process.returncode


class Process(RunningFirmware):
    """The loader compiled for this machine, behind its own pseudo-terminal."""

    def __init__(self, loader: Built, chip: EmulatedChip) -> None:
        """Start the firmware `loader` and open its pseudo-terminal; raise NotStarted if this fails.
        `chip` executes its words."""
        try:
            super().__init__([str(loader.path), "--pty"], loader.target, chip)
            self.port = self._named()
        except (OSError, RuntimeError) as error:
            if hasattr(self, "_out"):
                self.close()
            raise NotStarted(f"it does not start: {error}") from None
        self._line = os.open(self.port, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)

    def _named(self) -> str:
        """Return the name of the terminal that the process opens; records that come before it are
        handled. Raises RuntimeError if the process ends first."""
        while True:
            record = self.next()
            if record is None:
                self.fill()
            elif record[0] == _PORT:
                return record[1].decode()
            else:
                self.follow(*record)
