"""The digest of the files that determine generated pages and the outputs of notebooks."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]


def source_digest() -> str:
    """Return the digest of the four packages, the examples, the results, and the generator of the
    site."""
    running = sha256()
    files = [REPOSITORY / "docs/result_pages.py"]
    for folder in ("nscc", "runtime", "training", "cli", "grammars", "examples", "docs/nscc_site"):
        files += sorted((REPOSITORY / folder).rglob("*"))
    for path in files:
        if path.suffix in (".py", ".toml", ".lark", ".nsl", ".md", ".csv", ".json", ".template"):
            running.update(path.relative_to(REPOSITORY).as_posix().encode())
            running.update(path.read_bytes())
    return running.hexdigest()[:16]
