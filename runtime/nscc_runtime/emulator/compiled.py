"""The machine code of the loops: loaded from a file, or compiled with numba on first use.

    python -m nscc_runtime.emulator.compiled

compiles ahead (an installer's last step): some seconds once. Afterwards a process needs neither
numba nor a compiler, only llvmlite's linker, which costs a twentieth of a second; importing numba
alone would cost more than the whole capture.

The file lies in `__pycache__` beside this module or, where that cannot be written, in the user's
cache folder. Its name is a digest of all that the code depends on. Without any such folder every
process compiles for itself.
"""

from __future__ import annotations

import contextlib
import ctypes
import hashlib
import os
import re
import tempfile
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import Any

ENTRY = "expose_block"
_PARAMETERS = 19
_DIGEST_BYTES = 32
_SOURCES = ("loops.py", "steps.py")


@cache
def entry_point() -> Callable[..., None]:
    """`nscc_runtime.emulator.loops.expose_block` as machine code; takes 19 addresses."""
    return load(object_code(folders()))


def folders() -> tuple[Path, ...]:
    """Where the machine code may lie, best first."""
    user = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    return Path(__file__).parent / "__pycache__", Path(user) / "nscc"


def is_compiled() -> bool:
    """Whether the machine code is there: if not, its first use takes some seconds."""
    return _kept(folders()) is not None


def object_code(places: Sequence[Path]) -> bytes:
    """The object file: read from the first place that has it whole, else compiled and kept."""
    kept = _kept(places)
    if kept is not None:
        return kept
    code = build()
    for place in places:
        try:
            _write(place / _name(), hashlib.sha256(code).digest() + code)
        except OSError:
            continue
        break
    return code


def _name() -> str:
    return f"{ENTRY}-{_key()}.o"


def _kept(places: Sequence[Path]) -> bytes | None:
    for place in places:
        try:
            data = (place / _name()).read_bytes()
        except OSError:
            continue
        if hashlib.sha256(data[_DIGEST_BYTES:]).digest() == data[:_DIGEST_BYTES]:
            return data[_DIGEST_BYTES:]
    return None


def build() -> bytes:
    """Compile the loops to an object file for this machine's processor."""
    import llvmlite.binding as llvm
    import numba

    from nscc_runtime.emulator import loops

    made = numba.cfunc(loops.SIGNATURE, error_model="numpy")(loops.expose_block)
    module = llvm.parse_assembly(made.inspect_llvm().replace(made.native_name, ENTRY))
    # With everything else private, LLVM sees that nothing here can raise, and drops the functions
    # of numba and Python for it: what is left runs without either.
    for function in module.functions:
        if not function.is_declaration and function.name != ENTRY:
            function.linkage = "internal"
    machine = _machine(llvm)
    passes = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=2))
    passes.getModulePassManager().run(module, passes)
    needed = re.findall(r"^declare .*?@([\w.]+)\(", str(module), re.MULTILINE)
    foreign = sorted(name for name in needed if not name.startswith("llvm."))
    if foreign:
        raise RuntimeError(f"the compiled loops call {', '.join(foreign)}")
    return bytes(machine.emit_object(module))


def load(code: bytes) -> Callable[..., None]:
    """Link an object file into this process; the callable takes 19 addresses and drops the GIL."""
    import llvmlite.binding as llvm

    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _machine(llvm))
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    kind = ctypes.CFUNCTYPE(None, *(ctypes.c_void_p,) * _PARAMETERS)
    function = kind(engine.get_function_address(ENTRY))
    function.engine = engine  # type: ignore[attr-defined]  # the code lives as long as its engine
    return function


def _machine(llvm: Any) -> Any:
    """LLVM's view of this machine, for code that is linked while the process runs."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    return llvm.Target.from_default_triple().create_target_machine(
        cpu=llvm.get_host_cpu_name(),
        features=llvm.get_host_cpu_features().flatten(),
        opt=3,
        jit=True,
        codemodel="jitdefault",
    )


def _key() -> str:
    """Digest of the sources, of LLVM and of the processor."""
    import llvmlite
    import llvmlite.binding as llvm

    digest = hashlib.sha256()
    for name in _SOURCES:
        digest.update(Path(__file__).with_name(name).read_bytes())
    for part in (
        llvmlite.__version__,
        llvm.get_process_triple(),
        llvm.get_host_cpu_name(),
        llvm.get_host_cpu_features().flatten(),
    ):
        digest.update(part.encode() + b"\0")
    return digest.hexdigest()[:16]


def _write(path: Path, data: bytes) -> None:
    """Write a file whole or not at all: another process may be reading or writing it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, temporary = tempfile.mkstemp(dir=path.parent)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        os.replace(temporary, path)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(temporary)
        raise


if __name__ == "__main__":
    entry_point()
