"""Compile all loops of packages ahead, so that no command has to wait for a compiler.

    python -m nscc_runtime.compile_ahead nscc_runtime nscc_training

This is the last step of an installation and takes half a minute. Loops are in modules whose names
end in `loop` or `loops` (see `nscc_runtime.loop`)."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

from nscc_runtime.loop import object_file


def modules(package: str) -> Iterator[str]:
    """Import `package`, and yield the names of those of its modules that contain loops."""
    (root,) = import_module(package).__path__
    for path in sorted(Path(root).rglob("*.py")):
        if path.stem.endswith(("loop", "loops")):
            yield ".".join((package, *path.relative_to(root).with_suffix("").parts))


if __name__ == "__main__":
    for package in sys.argv[1:]:
        for module in modules(package):
            import_module(module)
            if object_file(module).loops:
                object_file(module).code()
