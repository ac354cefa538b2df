"""Check an installation of the runtime: compiled loops, serial ports, a C++ compiler."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.util import find_spec

from nscc.installation import ABSENT, GOOD, WRONG, Finding
from nscc_runtime.device.firmware import compiler


def findings() -> Iterator[Finding]:
    """Yield the findings about the runtime: loops, serial ports, C++ compiler. Checking the loops
    may compile them, which takes some seconds. What is missing is a finding, not an error."""
    yield _loops()
    yield _ports()
    compiler_path = compiler()
    if compiler_path is None:
        yield Finding(ABSENT, "C++ compiler: `nscc device serve` compiles the firmware with it")
    else:
        yield Finding(GOOD, f"C++ compiler: {compiler_path} (nscc device serve runs the firmware)")


def _loops() -> Finding:
    """Return the finding whether the compiled loops work on this processor, and whether they are
    kept for the next command; they are compiled if necessary. Without numba they are absent."""
    if find_spec("numba") is None:
        return Finding(ABSENT, "the emulator's loops: numba compiles them")
    from nscc_runtime.emulator.loops import expose_without_effects

    was_compiled = expose_without_effects.is_compiled()
    try:
        expose_without_effects.load()
    except (ImportError, OSError, RuntimeError, AttributeError) as error:
        return Finding(WRONG, f"the emulator's loops do not compile: {error}")
    if not was_compiled and not expose_without_effects.is_kept():
        text = expose_without_effects.compiling("the emulator's loops")
        return Finding(ABSENT, f"the emulator's loops are not kept: {text}")
    return Finding(GOOD, "the emulator's loops are compiled for this processor")


def _ports() -> Finding:
    """Return the finding that lists the serial ports, "none" if there are none. Without pyserial
    the finding is that they are absent."""
    if find_spec("serial") is None:
        return Finding(ABSENT, "serial ports: pyserial lists them")
    from nscc_runtime.device.port import list_ports

    ports = [name + described(text) for name, text in list_ports()]
    return Finding(GOOD, f"serial ports: {', '.join(ports) or 'none'}")


def described(text: str) -> str:
    """Return the description `text` of a port after a space and in parentheses; empty if it is
    empty or "n/a", which pyserial says for none."""
    return f" ({text})" if text not in ("", "n/a") else ""
