"""The emulator's loops as WebAssembly, run by wasmtime: what a web page gets, without a browser."""

from __future__ import annotations

import ctypes
import math
from pathlib import Path
from typing import Any

import numpy as np

from nscc_runtime.loop import Loop

_STACK, _DATA, _ARRAYS = 1 << 20, 2 << 20, 4 << 20
"""Where the stack ends, where the library's own data is, and where arguments are."""
_PAGES = 16_000


class WebLoops:
    """An instance of the library. It stands in for `Loop.__call__`: arguments are copied to its
    memory, and written arrays back."""

    def __init__(self, library: Path) -> None:
        import wasmtime as w

        self.store = w.Store(w.Engine())
        module = w.Module.from_file(self.store.engine, str(library))
        self.memory = w.Memory(self.store, w.MemoryType(w.Limits(_PAGES, None)))
        table = w.Table(self.store, w.TableType(w.ValType.funcref(), w.Limits(1000, None)), None)
        i32, number = w.ValType.i32(), w.ValType.f64()

        def place(value: int, mutable: bool = False) -> Any:
            return w.Global(self.store, w.GlobalType(i32, mutable), w.Val.i32(value))

        known = {
            "memory": self.memory,
            "__indirect_function_table": table,
            "__memory_base": place(_DATA),
            "__table_base": place(1),
            "__stack_pointer": place(_STACK, True),
        }
        imports = [
            known.get(each.name)
            or w.Func(self.store, w.FuncType([number], [number]), getattr(math, each.name))
            for each in module.imports
        ]
        self.exports = w.Instance(self.store, module, imports).exports(self.store)
        if "__wasm_call_ctors" in self.exports:
            self.exports["__wasm_call_ctors"](self.store)
        self.calls: set[str] = set()

    def run(self, name: str, arguments: list[bytes], written: list[bool]) -> list[bytes]:
        """Return the bytes of the written arguments after the loop `name` has run."""
        addresses, place = [], _ARRAYS
        for data in arguments:
            self.memory.write(self.store, data, place)
            addresses.append(place)
            place += -(-len(data) // 64) * 64 + 64
        self.exports[name](self.store, *addresses)
        self.calls.add(name)
        ends = zip(addresses, arguments, written, strict=True)
        return [bytes(self.memory.read(self.store, at, at + len(d))) for at, d, w in ends if w]

    def call(self, loop: Loop[Any], **values: Any) -> None:
        """As `Loop.__call__`, checks included."""
        arguments = []
        loop.checks(values)
        for name, parameter in loop.parameters.items():
            value = values[name]
            arguments += zip(
                parameter.arrays,
                [value] if len(parameter.arrays) == 1 and not isinstance(value, tuple) else value,
                strict=True,
            )
        written = [parameter.written for parameter, _ in arguments]
        results = iter(self.run(loop.name, [bytes_of(value) for _, value in arguments], written))
        for parameter, value in arguments:
            if parameter.written:
                value.reshape(-1).view(np.uint8)[:] = np.frombuffer(next(results), np.uint8)


def bytes_of(value: Any) -> bytes:
    """Return the bytes of a record or an array."""
    return bytes(value) if isinstance(value, ctypes.Structure) else value.tobytes()
