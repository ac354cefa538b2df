"""The kinds of points, and the key of a point: a digest of everything its result depends on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache

from nscc import __version__
from nscc.cache.digest import content, digest, package_digest, version_digest
from nscc.plugins import added, unusable
from nscc.requirements import installed_version
from nscc_training.sweep.compiling import COMPILE, LIMITS
from nscc_training.sweep.designing import DESIGN
from nscc_training.sweep.emulating import EMULATE
from nscc_training.sweep.evaluating import EVALUATE
from nscc_training.sweep.point import GridPoint, PointKind
from nscc_training.sweep.training import TRAIN

SHIPPED = {kind.name: kind for kind in (COMPILE, LIMITS, EMULATE, TRAIN, EVALUATE, DESIGN)}


def _added() -> dict[str, PointKind]:
    """Return the kinds of points that installed packages add (entry points `nscc.measurements`), by
    name. Raise Rejected (NS0905) for an unusable one."""
    kinds: dict[str, PointKind] = added("nscc.measurements", SHIPPED)
    for name, kind in kinds.items():
        if not isinstance(kind, PointKind) or kind.name != name:
            reason = f"it must be a PointKind with the name {name}"
            raise unusable("nscc.measurements", name, reason)
    return kinds


KINDS: Mapping[str, PointKind] = {**SHIPPED, **_added()}

_SCHEMA = "nscc-point-1"


def key_of(point: GridPoint, threads: int) -> str:
    """Return the key of a point, 64 hexadecimal digits: a digest of everything that its result
    depends on.

    These are its values, the content of every file that they name, the sources of the packages that
    compute the point, and the versions of their dependencies. Paths are relative to the current
    folder. If torch computes the point, the key also depends on `threads`, because sums of floats
    do. Missing files are allowed. Raises Rejected for a program that cannot be read."""
    kind = KINDS[point.kind]
    after = [key_of(run_point, threads) for run_point in point.after]
    # 1 and 1.0 are the same value of a key.
    plain_values = {
        name: int(value) if isinstance(value, float) and value.is_integer() else value
        for name, value in sorted(point.values.items())
    }
    return digest(
        (
            _SCHEMA,
            kind.name,
            plain_values,
            [content(path) for path in kind.reads(point.values)],
            versions(kind.packages, kind.distributions),
            threads if "torch" in kind.distributions else 0,
            *after,
        )
    )


@cache
def versions(packages: Sequence[str], distributions: Sequence[str]) -> tuple[str, ...]:
    """Return a digest of the source of each of nscc's `packages`, or its version if it has no
    source, and the versions of other `distributions`."""
    package_versions = (
        version_digest() if name == "nscc" else package_digest(name) for name in packages
    )
    return (
        *(version or __version__ for version in package_versions),
        *map(installed_version, distributions),
    )
