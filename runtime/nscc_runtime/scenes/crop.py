"""Select the part of a picture that is exposed on the array."""

from __future__ import annotations

from dataclasses import dataclass

from nscc.diagnostics.rejection import rejected
from nscc_runtime.scenes.errors import Path_or_name, size


@dataclass(frozen=True)
class Window:
    """The size of the array, and the position (row, column) of its top left corner in pictures. If
    `corner` is None, the array is centred."""

    rows: int
    cols: int
    corner: tuple[int, int] | None = None

    def place(self, have: tuple[int, int], name: Path_or_name) -> tuple[int, int]:
        """Return row and column of the top left corner in a picture of size `have`.

        If the margins of a centred window cannot be equal, the smaller ones are above and to the
        left. Raises Rejected (NS0734) if the window does not fit."""
        need = (self.rows, self.cols)
        if have[0] < need[0] or have[1] < need[1]:
            raise rejected(
                "NS0734",
                f"the scene '{name}' is {size(have)}, smaller than the array of {size(need)}",
                notes=(
                    "sizes are rows x columns; without --fit pictures are cropped but not scaled",
                ),
                helps=("use a larger picture, `--fit scale`, or a target with a smaller array",),
                data={"scene": list(have), "array": list(need)},
            )
        if self.corner is None:
            return (have[0] - need[0]) // 2, (have[1] - need[1]) // 2
        first_row, first_col = self.corner
        if not (0 <= first_row <= have[0] - need[0] and 0 <= first_col <= have[1] - need[1]):
            raise rejected(
                "NS0734",
                f"--crop {first_row},{first_col} puts the array of {size(need)} outside the scene "
                f"'{name}' of {size(have)}",
                notes=("--crop R,C is the row and column of the top left corner",),
                helps=(f"R may be 0 to {have[0] - need[0]} here, C 0 to {have[1] - need[1]}",),
                data={"scene": list(have), "array": list(need), "crop": [first_row, first_col]},
            )
        return first_row, first_col


def parse_crop(text: str) -> tuple[int, int]:
    """Parse `R,C` as two whole numbers. Raises Rejected (NS0739) for other texts."""
    numbers = text.split(",")
    if len(numbers) == 2 and all(p.strip().isdecimal() and len(p.strip()) < 10 for p in numbers):
        return int(numbers[0]), int(numbers[1])
    raise rejected(
        "NS0739",
        f"invalid corner '{text[:60]}' for --crop",
        notes=("--crop R,C: the row and column of the top left corner, from 0",),
        helps=("for instance --crop 120,300",),
    )
