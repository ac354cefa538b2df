"""Compile all loops of packages ahead, so that no command has to wait for a compiler.

    python -m nscc_runtime.compile_ahead nscc_runtime nscc_training
    python -m nscc_runtime.compile_ahead --wasm loops.wasm      # the emulator's, for web pages

This is the last step of an installation and takes half a minute. Loops must be in modules whose
names end in `loop` or `loops` (see `nscc_runtime.loop`)."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory

from nscc_runtime.loop import object_file
from nscc_runtime.machine_code import link_for_web


def modules(package: str) -> Iterator[str]:
    """Import `package`, and yield the full names of those of its modules whose file names end in
    `loop` or `loops`, in alphabetical order. Raises ModuleNotFoundError for an unknown package."""
    (root,) = import_module(package).__path__
    for path in sorted(Path(root).rglob("*.py")):
        if path.stem.endswith(("loop", "loops")):
            yield ".".join((package, *path.relative_to(root).with_suffix("").parts))


def compile_for_web(out: Path) -> None:
    """Compile the loops of the emulator to the WebAssembly library `out`, a file that is written or
    replaced. Takes a minute and a half."""
    with TemporaryDirectory() as folder:
        objects, entries = [], []
        for module in modules("nscc_runtime"):
            import_module(module)
            file = object_file(module)
            if file.loops:
                objects.append(Path(folder) / f"{module}.o")
                objects[-1].write_bytes(file.build(for_web=True))
                entries += [module_loop.name for module_loop in file.loops]
        link_for_web(objects, entries, out)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--wasm"]:
        compile_for_web(Path(sys.argv[2]))
        sys.exit()
    for package in sys.argv[1:]:
        for module in modules(package):
            import_module(module)
            if object_file(module).loops:
                object_file(module).code()
