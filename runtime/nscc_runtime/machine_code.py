"""Machine code of compiled loops: built with numba once, kept in a file, linked when needed.

A process that finds the file needs neither numba nor a compiler, only llvmlite's linker, which
costs a twentieth of a second. The file's name is a digest of all that the code depends on. Without
any folder to keep it in, every process compiles for itself.
"""

from __future__ import annotations

import contextlib
import ctypes
import hashlib
import os
import re
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from time import perf_counter
from typing import Any

_DIGEST_BYTES = 32
_COMPILE_S: list[float] = []
"""Seconds that each object file took to compile in this process."""


def working_s() -> float:
    """Return a clock in seconds that stands still while loops are compiled."""
    return perf_counter() - sum(_COMPILE_S)


def folders(module: str) -> tuple[Path, ...]:
    """Where the machine code of the module in file `module` may lie, best first."""
    user = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    return Path(module).parent / "__pycache__", Path(user) / "nscc"


def can_keep(places: Sequence[Path]) -> bool:
    """Whether object files can be written to a place, or to a folder made there."""
    for place in places:
        existing = next(path for path in (place, *place.parents) if path.exists())
        if existing.is_dir() and os.access(existing, os.W_OK | os.X_OK):
            return True
    return False


def object_code(name: str, places: Sequence[Path], build: Callable[[], bytes]) -> bytes:
    """The object file `name`: read from the first place that has it whole, else built and kept."""
    found = kept(name, places)
    if found is not None:
        return found
    begin = perf_counter()
    code = build()
    _COMPILE_S.append(perf_counter() - begin)
    for place in places:
        try:
            _write(place / name, hashlib.sha256(code).digest() + code)
        except OSError:
            continue
        break
    return code


def kept(name: str, places: Sequence[Path]) -> bytes | None:
    """The object file `name`, None where no place has it whole."""
    for place in places:
        try:
            data = (place / name).read_bytes()
        except OSError:
            continue
        if hashlib.sha256(data[_DIGEST_BYTES:]).digest() == data[:_DIGEST_BYTES]:
            return data[_DIGEST_BYTES:]
    return None


def build(loops: Iterable[tuple[Callable[..., None], Any]]) -> bytes:
    """Compile functions, each with its numba signature, to one object file for this processor."""
    import llvmlite.binding as llvm
    import numba

    whole, entries = llvm.parse_assembly(""), set()
    for function, signature in loops:
        entry = function.__name__
        made = numba.cfunc(signature, error_model="numpy")(function)
        module = llvm.parse_assembly(
            _own_root(made.inspect_llvm()).replace(made.native_name, entry)
        )
        # With everything else private, LLVM sees that nothing here can raise, and drops the
        # functions of numba and Python for it: what is left runs without either.
        for part in module.functions:
            if not part.is_declaration and part.name != entry:
                part.linkage = "internal"
        whole.link_in(module)
        entries.add(entry)
    machine = _machine(llvm)
    passes = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=2))
    passes.getModulePassManager().run(whole, passes)
    needed = re.findall(r"^declare .*?@([\w.]+)\(", str(whole), re.MULTILINE)
    foreign = sorted(name for name in needed if not name.startswith("llvm."))
    if foreign:
        raise RuntimeError(f"the compiled loops call {', '.join(foreign)}")
    return bytes(machine.emit_object(whole))


def load(code: bytes, parameters: Mapping[str, int]) -> dict[str, Callable[..., None]]:
    """Link an object file into this process.

    `parameters` says how many addresses each entry takes. The callables drop the GIL.
    """
    import llvmlite.binding as llvm

    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _machine(llvm))
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    functions: dict[str, Callable[..., None]] = {}
    for entry, count in parameters.items():
        kind = ctypes.CFUNCTYPE(None, *(ctypes.c_void_p,) * count)
        function = kind(engine.get_function_address(entry))
        function.engine = engine  # type: ignore[attr-defined]  # the code lives as long as its engine
        functions[entry] = function
    return functions


def name(stem: str, sources: Iterable[str]) -> str:
    """The object file's name: a digest of what is compiled, of LLVM and of the processor."""
    import llvmlite
    import llvmlite.binding as llvm

    digest = hashlib.sha256()
    for part in (
        *sources,
        llvmlite.__version__,
        llvm.get_process_triple(),
        llvm.get_host_cpu_name(),
        llvm.get_host_cpu_features().flatten(),
    ):
        digest.update(part.encode() + b"\0")
    return f"{stem}-{digest.hexdigest()[:16]}.o"


def _own_root(text: str) -> str:
    """LLVM code with the processor's square roots, for which numba calls the C library's."""
    for name, kind, intrinsic in (("sqrt", "double", "f64"), ("sqrtf", "float", "f32")):
        text, calls = re.subn(rf"^declare {kind} @{name}\(.*\n", "", text, flags=re.MULTILINE)
        declared = f"declare {kind} @llvm.sqrt.{intrinsic}({kind}"
        text = text.replace(f"@{name}(", f"@llvm.sqrt.{intrinsic}(")
        if calls and declared not in text:
            text += f"\n{declared})\n"
    return text


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
