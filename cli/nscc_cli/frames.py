"""What commands that expose frames share: what to keep, where files go, and what is said."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nscc.diagnostics.rejection import rejected
from nscc.diagnostics.suggest import closest
from nscc.files import Product, refuse_same

if TYPE_CHECKING:
    from nscc.words.container import Container
    from nscc_runtime.frame_file import Frame


def parse_keep(text: str) -> tuple[str, ...]:
    """The names in `--keep`; NS0739 for one that there is not."""
    from nscc_runtime.frame_file import KEEP

    names = tuple(name.strip() for name in text.split(",") if name.strip())
    for name in names:
        if name not in KEEP:
            near = closest(name, KEEP)
            raise rejected(
                "NS0739",
                f"--keep cannot keep '{name[:60]}'",
                notes=(f"it keeps, comma separated: {', '.join(KEEP)}",),
                helps=(f"did you mean '{near}'?",) if near else (),
            )
    return names


def frame_path(program: Path, options: dict[str, Any]) -> Path:
    """Where the frame goes. Not NAME.npz: that may well be the program's own data.

    NS0745 where two products would be one file.
    """
    out: Path = options["out"] or Path(program.stem + ".frame.npz")
    named = [out, *(options[name] for name in ("png", "timings", "plan") if options[name])]
    refuse_same(named, "-o, --png, --timings and --plan")
    return out


def picture(container: Container, frame: Frame, title: str) -> Product:
    """The picture of `--png`: of the first frame, where there are several."""
    from nscc_runtime.pictures.frames import frame_sheet, readouts
    from nscc_runtime.pictures.sheet import png_of

    first = frame.frame[0] if frame.frame.ndim == 4 else frame.frame
    return png_of(frame_sheet, readouts(container, first), title)


def summary(container: Container, frame: Frame, files: Sequence[Path], *, alike: bool) -> str:
    """A line a bucket, of the first frame, and a line a file; `alike`: no two frames differ."""
    from nscc_runtime.frame_file import frame_lines

    lines = frame_lines(container, frame)
    if frame.frame.ndim == 4:
        which = "all alike: there are no effects" if alike else "the first is described"
        lines.append(f"{len(frame.frame)} frames, {which}")
    return "\n".join([*lines, *(f"wrote {path}" for path in files)])
