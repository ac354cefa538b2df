"""Checks of the installation: packages, grammar, targets, cache."""

from __future__ import annotations

import platform
import warnings
from collections.abc import Iterator
from contextlib import redirect_stderr
from importlib import import_module
from io import StringIO
from pathlib import Path
from typing import NamedTuple

from nscc.cache.folder import cache_folder, refusal
from nscc.cache.store import MOST_BYTES, Store
from nscc.chips.load import load_target, target_names
from nscc.diagnostics.diagnostic import Rejected
from nscc.requirements import extras, install_line, installed_version, module_of
from nscc.source import Source
from nscc.syntax.parse import parse
from nscc.version import __version__

GOOD, ABSENT, BROKEN, WRONG = "ok", "absent", "broken", "WRONG"

_OWN_WORK = ("bench", "test")
"""Extras for developers of nscc."""


class Finding(NamedTuple):
    """The result of a check of the installation.

    `text` is one line for people. `state` is GOOD or WRONG or, for packages that only some commands
    need, ABSENT or BROKEN."""

    state: str
    text: str


def findings() -> Iterator[Finding]:
    """Yield the results of all checks of the compiler's installation: packages, grammar, targets,
    cache."""
    yield Finding(GOOD, f"nscc {__version__}")
    python, system = platform.python_version(), f"{platform.system()} {platform.machine()}"
    yield Finding(GOOD, f"Python {python} on {system}")
    # The required packages and those of every extra.
    extra_of = extras()
    for extra in sorted({*extra_of.values()}.difference(_OWN_WORK)):
        version_of = {
            name: installed_version(name) for name in sorted(extra_of) if extra_of[name] == extra
        }
        label = f"[{extra}] " if extra else ""
        missing = [name for name, version in version_of.items() if not version]
        broken = {
            name: why for name in version_of if version_of[name] and (why := _import_error(name))
        }
        if broken:
            texts = (
                f"{name} {version_of[name]} cannot be imported ({broken[name]})" for name in broken
            )
            yield Finding(BROKEN if extra else WRONG, label + "; ".join(texts))
        if missing:
            state = ABSENT if extra else WRONG
            yield Finding(state, f"{label}{', '.join(missing)}: {install_line(extra)}")
        elif not broken:
            yield Finding(
                GOOD, label + ", ".join(f"{n} {version}" for n, version in version_of.items())
            )
    _tree, problems = parse(Source("doctor.nsl", "nsl 1\nframe 2 slots of 1ms\nopen when n < 1\n"))
    yield Finding(WRONG, "the grammar does not work") if problems else Finding(GOOD, "grammar")
    yield _targets()
    yield _cache()


def _import_error(distribution: str) -> str:
    """Return why the module of `distribution`, an installed package, cannot be imported, in at most
    100 characters, or "" if it can."""
    try:
        with redirect_stderr(StringIO()), warnings.catch_warnings(action="ignore"):
            import_module(module_of(distribution))
    except Exception as error:  # a package may raise anything while it is imported
        return " ".join(f"{type(error).__name__}: {error}".split())[:100]
    return ""


def _targets() -> Finding:
    """Return the finding on all targets, also those of installed packages: their names, or the
    first error in one."""
    try:
        names = [load_target(name, Path()).name for name in target_names()]
    except Rejected as rejected:
        return Finding(WRONG, f"targets: {rejected.diagnostics[0].message}")
    return Finding(GOOD, f"targets: {', '.join(names)}")


def _cache() -> Finding:
    """Return the finding on the cache of search results: its folder and size, or why it is off."""
    folder = cache_folder()
    if folder is None:
        return Finding(ABSENT, f"cache of search results: {refusal() or 'off (NSCC_CACHE=off)'}")
    store = Store(folder)
    title = f"cache of search results: {folder}"
    usage = (
        f"{store.entries()} results, {store.bytes_used() / 1e6:.1f} of {MOST_BYTES / 1e6:.0f} MB"
    )
    return Finding(GOOD, f"{title} ({usage}; remove the folder to clear it)")
