"""Machine code of compiled loops: built with numba once, stored in a file, linked when needed.

A process that finds the file needs neither numba nor a compiler, only llvmlite's linker, which
takes a twentieth of a second. The file's name is a digest of everything that the code depends on.
If no folder is writable, every process compiles the loops itself."""

from __future__ import annotations

import ctypes
import hashlib
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from time import perf_counter
from typing import Any

from nscc.cache.folder import cache_folder, is_own
from nscc.diagnostics.diagnostic import Rejected
from nscc.files import store_files

_DIGEST_BYTES = 32
_BESIDE = "__pycache__"
IN_WEB = sys.platform == "emscripten"
"""Whether this is Python in WebAssembly, where nothing is compiled: `WEB_LIBRARY` has all loops."""
WEB_LIBRARY = Path(__file__).with_name("loops.wasm")
"""The library that `python -m nscc_runtime.compile_ahead --wasm` writes for a web page."""
_WEB_TRIPLE = "wasm32-unknown-emscripten"
_COMPILE_S: list[float] = []
"""Seconds that compiling each object file took in this process."""


def working_s() -> float:
    """Return the time in seconds of a clock that stops while loops are compiled; only differences
    have a meaning."""
    return perf_counter() - sum(_COMPILE_S)


def folders(module: str) -> tuple[Path, ...]:
    """Return the folders for the machine code of a module, in order of preference: `__pycache__`
    beside it, then the user's cache folder if there is one. `module`: path of the module's
    file."""
    user = cache_folder()
    return Path(module).parent / _BESIDE, *(() if user is None else (user,))


def can_keep(folders: Sequence[Path]) -> bool:
    """Return whether object files can be stored in at least one of `folders`. A cache folder counts
    as writable without a check; False without folders."""
    return any(
        folder.name != _BESIDE or os.access(folder if folder.exists() else folder.parent, os.W_OK)
        for folder in folders
    )


def object_code(name: str, folders: Sequence[Path], build: Callable[[], bytes]) -> bytes:
    """Return the object code `name`, a file name, from the first of `folders` with an intact copy;
    else `build()` it and store it in the first folder that can be written. If none can, it is not
    stored; that is no error."""
    stored = read_object_file(name, folders)
    if stored is not None:
        return stored
    begin = perf_counter()
    code = build()
    _COMPILE_S.append(perf_counter() - begin)
    for folder in folders:
        try:
            folder.mkdir(0o755, parents=True, exist_ok=True)
            store_files({folder / name: hashlib.sha256(code).digest() + code})
            (folder / name).chmod(0o644)
        except (OSError, Rejected):
            continue
        break
    return code


def read_object_file(name: str, folders: Sequence[Path]) -> bytes | None:
    """Return the object file `name`; None if no folder has it intact.

    A file in the cache must be this user's. The folder beside the module needs no check: whoever
    can write there can also replace Python's own compiled modules."""
    for folder in folders:
        if folder.name != _BESIDE and not (is_own(folder) and is_own(folder / name)):
            continue
        try:
            data = (folder / name).read_bytes()
        except OSError:
            continue
        if hashlib.sha256(data[_DIGEST_BYTES:]).digest() == data[:_DIGEST_BYTES]:
            return data[_DIGEST_BYTES:]
    return None


def build(loops: Iterable[tuple[Callable[..., None], Any]], for_web: bool = False) -> bytes:
    """Compile `loops`, pairs of a function and its numba signature, to one object file for this
    processor, or with `for_web` for WebAssembly, and return its bytes. Entries have the names of
    the functions. Raises RuntimeError, naming them, if they call functions that are not in it."""
    import llvmlite.binding as llvm
    import numba

    linked_module, entries = llvm.parse_assembly(""), set()
    machine = _web_machine(llvm) if for_web else _machine(llvm)
    for function, signature in loops:
        entry = function.__name__
        cfunc = numba.cfunc(signature, error_model="numpy")(function)
        text = _own_root(cfunc.inspect_llvm()).replace(cfunc.native_name, entry)
        if for_web:
            text = _retargeted(text, str(machine.target_data))
        module = llvm.parse_assembly(text)
        # If everything else is private, LLVM recognises that nothing can raise, and removes the
        # error handling of numba and Python: the result runs without either.
        for llvm_function in module.functions:
            if not llvm_function.is_declaration and llvm_function.name != entry:
                llvm_function.linkage = "internal"
        linked_module.link_in(module)
        entries.add(entry)
    passes = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=2))
    passes.getModulePassManager().run(linked_module, passes)
    needed = re.findall(r"^declare .*?@([\w.]+)\(", str(linked_module), re.MULTILINE)
    foreign = sorted(name for name in needed if not name.startswith("llvm."))
    if foreign:
        raise RuntimeError(f"the compiled loops call {', '.join(foreign)}")
    return bytes(machine.emit_object(linked_module))


def link_for_web(objects: Sequence[Path], entries: Iterable[str], out: Path) -> None:
    """Link the object files `objects` for WebAssembly to the library `out` with the functions
    `entries` (names), which Python in a web page loads with ctypes. Raises CalledProcessError if
    the linker of the package `ziglang` fails or is not installed."""
    linker = [
        sys.executable,
        "-m",
        "ziglang",
        "wasm-ld",
        "-shared",
        "--experimental-pic",
        "--no-entry",
        "--strip-all",
        "--allow-undefined",
    ]
    exports = [f"--export={entry}" for entry in entries]
    subprocess.run([*linker, *exports, "-o", out, *objects], check=True)


def load_in_web(parameters: Mapping[str, int]) -> dict[str, Callable[..., None]]:
    """Return the functions of the WebAssembly library by name. `parameters`: by name, how many
    addresses each takes. Raises OSError if there is no library, AttributeError if it lacks a
    function."""
    library = ctypes.CDLL(str(WEB_LIBRARY))
    functions: dict[str, Callable[..., None]] = {}
    for entry, count in parameters.items():
        function = library[entry]
        function.argtypes, function.restype = (ctypes.c_void_p,) * count, None
        functions[entry] = function
    return functions


def load(code: bytes, parameters: Mapping[str, int]) -> dict[str, Callable[..., None]]:
    """Link the object file `code` into this process and return its functions by name, which run
    without the GIL. `parameters`: by name, how many addresses each takes."""
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
    """Return the name of an object file: `stem`, and a digest of the `sources` in order, of LLVM's
    version and of the processor."""
    import llvmlite
    import llvmlite.binding as llvm

    digest = hashlib.sha256()
    for digest_input in (
        *sources,
        llvmlite.__version__,
        llvm.get_process_triple(),
        llvm.get_host_cpu_name(),
        llvm.get_host_cpu_features().flatten(),
    ):
        digest.update(digest_input.encode() + b"\0")
    return f"{stem}-{digest.hexdigest()[:16]}.o"


def _own_root(text: str) -> str:
    """Return the LLVM code `text` with calls of the C library's square root replaced by the
    processor's: object files must not need a C library."""
    for name, kind, intrinsic in (("sqrt", "double", "f64"), ("sqrtf", "float", "f32")):
        text, calls = re.subn(rf"^declare {kind} @{name}\(.*\n", "", text, flags=re.MULTILINE)
        declared = f"declare {kind} @llvm.sqrt.{intrinsic}({kind}"
        text = text.replace(f"@{name}(", f"@llvm.sqrt.{intrinsic}(")
        if calls and declared not in text:
            text += f"\n{declared})\n"
    return text


def _machine(llvm: Any) -> Any:
    """Return LLVM's description of this machine, for code that is linked while the process runs."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    return llvm.Target.from_default_triple().create_target_machine(
        cpu=llvm.get_host_cpu_name(),
        features=llvm.get_host_cpu_features().flatten(),
        opt=3,
        jit=True,
        codemodel="jitdefault",
    )


def _web_machine(llvm: Any) -> Any:
    """Return LLVM's description of WebAssembly, for code of a shared library."""
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    return llvm.Target.from_triple(_WEB_TRIPLE).create_target_machine(
        features="+simd128,+bulk-memory,+mutable-globals,+sign-ext", opt=3, reloc="pic"
    )


def _retargeted(text: str, layout: str) -> str:
    """Return numba's LLVM code of this machine as code for WebAssembly with a data `layout`."""
    for pattern, other in (
        (r"^target datalayout = .*$", f'target datalayout = "{layout}"'),
        (r"^target triple = .*$", f'target triple = "{_WEB_TRIPLE}"'),
        (r'"target-(cpu|features)"="[^"]*"', ""),
        (r"= common ", "= internal "),
    ):
        text = re.sub(pattern, other, text, flags=re.MULTILINE)
    return text
