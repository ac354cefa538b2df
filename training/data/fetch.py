"""Photographs that may be used: `python training/data/fetch.py DIR`.

40 of them, from four packages of Debian 12, which are checked by their digests; 168 MB are fetched
unless the packages already lie in the folder that `--packages` names. Beside each package's
pictures lies its `copyright`, which says who took them. Nothing of this is shipped with nscc.

| package | licences |
|---|---|
| lomiri-wallpapers-16.04, lomiri-wallpapers-20.04 | CC-BY-4.0, CC-BY-SA-4.0, CC0-1.0 |
| mate-backgrounds, plasma-workspace-wallpapers | GPL-2+ |"""

from __future__ import annotations

import argparse
import io
import sys
import tarfile
from collections.abc import Iterator
from dataclasses import dataclass
from fnmatch import fnmatch
from hashlib import sha256
from pathlib import Path, PurePosixPath
from urllib.request import urlopen

POOL = "https://deb.debian.org/debian/pool/main"
_PLASMA = (
    "Autumn",
    "BytheWater",
    "ColdRipple",
    "ColorfulCups",
    "EveningGlow",
    "FallenLeaf",
    "Kite",
    "OneStandsOut",
    "Path",
)


@dataclass(frozen=True)
class Package:
    """A package: its place in the pool, its digest, and which files in it are photographs."""

    place: str
    sha256: str
    photographs: tuple[str, ...]

    @property
    def name(self) -> str:
        """The file name of the package."""
        return PurePosixPath(self.place).name


PACKAGES = (
    Package(
        "l/lomiri-wallpapers/lomiri-wallpapers-16.04_20.04.0-2_all.deb",
        "a99ff6a3bfe451e4cc0682ecb3cc82e71740626d59e4845ae34a0a0e45421eab",
        ("*/backgrounds/*.jpg",),
    ),
    Package(
        "l/lomiri-wallpapers/lomiri-wallpapers-20.04_20.04.0-2_all.deb",
        "d44e89b8473aafe64a5b678f014862dc31335aaaf18665c544d985d854f1a709",
        ("*/Fossa_*.jpg", "*/Infinite-Sea_*.jpg", "*/Kleiber_*.jpg"),
    ),
    Package(
        "m/mate-backgrounds/mate-backgrounds_1.26.0-1_all.deb",
        "7bf4c2209f34b4f61ba6d24c8b58c28b361e82e4b943aae6d42c030169af9e04",
        ("*/nature/*.jpg", "*/Elephants_3840x2160.jpg"),
    ),
    Package(
        "p/plasma-workspace-wallpapers/plasma-workspace-wallpapers_5.27.5-2_all.deb",
        "32cd18b71c8c938a18b3b351f217c02ac590e323caa3cf322fbb875ce8892f8b",
        tuple(f"*/{name}/contents/images/2560x1600.jpg" for name in _PLASMA),
    ),
)


def main() -> int:
    """Fetch the packages, check their digests and unpack the pictures. Return 1 if a package has
    another digest, else 0."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("folder", type=Path, help="where the pictures go")
    parser.add_argument("--packages", type=Path, help="a folder that holds packages already")
    chosen = parser.parse_args()
    for package in PACKAGES:
        data = checked_package(package, chosen.packages) or fetched(package)
        found = sha256(data).hexdigest()
        if found != package.sha256:
            print(f"{package.name} is another file: its SHA-256 is {found}", file=sys.stderr)
            return 1
        into = chosen.folder / package.name.split("_")[0]
        into.mkdir(parents=True, exist_ok=True)
        count = 0
        for path, content in files_of(data):
            if path.endswith("/copyright"):
                (into / "copyright").write_bytes(content)
            elif any(fnmatch(path, wanted) for wanted in package.photographs):
                (into / named(path)).write_bytes(content)
                count += 1
        print(f"{into}: {count} photographs")
    return 0


def checked_package(package: Package, folder: Path | None) -> bytes | None:
    """Return the package from a folder, under its pool name or apt's name; None without it."""
    if folder is None:
        return None
    stem, version, rest = package.name.split("_")
    paths = [*folder.glob(f"{stem}_*{version}_{rest}")]
    return paths[0].read_bytes() if paths else None


def fetched(package: Package) -> bytes:
    """Download the package from Debian's pool."""
    with urlopen(f"{POOL}/{package.place}") as answer:
        data: bytes = answer.read()
    return data


def files_of(data: bytes) -> Iterator[tuple[str, bytes]]:
    """Yield path and content of the files in a .deb, an `ar` archive that contains a `tar`."""
    place = 8
    while place < len(data):
        header = data[place : place + 60]
        name, size = header[:16].decode().strip().rstrip("/"), int(header[48:58])
        if name.startswith("data.tar"):
            with tarfile.open(fileobj=io.BytesIO(data[place + 60 : place + 60 + size])) as archive:
                for member in archive:
                    content = archive.extractfile(member) if member.isfile() else None
                    if content is not None:
                        yield member.name, content.read()
        place += 60 + size + size % 2


def named(path: str) -> str:
    """Return the name of a picture; if its file name is a size, the name of its theme's folder."""
    parts = PurePosixPath(path)
    return f"{parts.parts[-4]}.jpg" if parts.name[0].isdigit() else parts.name


if __name__ == "__main__":
    sys.exit(main())
