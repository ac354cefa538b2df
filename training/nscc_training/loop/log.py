"""The log of training: `metrics.csv`, and event files if TensorBoard is installed."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from nscc.diagnostics.rejection import rejected

METRICS = "metrics.csv"
EVENTS = "tensorboard"


class Log:
    """The log of a run in the folder `out`, with a column for each metric of its protocol; `rows`
    are the lines of `metrics.csv`."""

    def __init__(
        self, out: Path, metrics: Sequence[str], rows: Sequence[str] | None = None
    ) -> None:
        self.out = out
        self._columns = ("loss", *metrics, "words_per_slot", "dead_share")
        self.rows = list(rows or [",".join(["step", "split", *self._columns])])
        self._events: Any = None

    @classmethod
    def of_checkpoint(cls, folder: Path, step: int, out: Path, metrics: Sequence[str]) -> Log:
        """Return the log up to the step of a checkpoint; later lines are dropped."""
        path = folder / METRICS
        if not path.is_file():
            return cls(out, metrics)
        try:
            head, *rows = path.read_text(encoding="utf-8").splitlines()
            kept_rows = [row for row in rows if int(row.partition(",")[0]) <= step]
        except ValueError:
            raise rejected(
                "NS0816",
                f"training cannot resume from '{folder}'",
                notes=(f"{path.name} is damaged: its lines do not begin with a step",),
                helps=("without that file the run resumes, and its log starts there",),
            ) from None
        return cls(out, metrics, [head, *kept_rows])

    def add(self, step: int, split: str, **values: float | str | None) -> None:
        """Add a line; missing values stay empty."""
        cells = (values.get(name) for name in self._columns)
        texts = ("" if value is None else repr(float(value)) for value in cells)
        self.rows.append(",".join([str(step), split, *texts]))
        if find_spec("tensorboard") is None:
            return
        # Event files contain times and the host name, so they are not products of the run.
        if self._events is None:
            from torch.utils.tensorboard import SummaryWriter

            self._events = SummaryWriter(str(self.out / EVENTS))
        for name, value in values.items():
            if value is not None:
                self._events.add_scalar(f"{split}/{name}", float(value), step)
        self._events.flush()

    def csv(self) -> bytes:
        """Return `metrics.csv`."""
        return ("\n".join(self.rows) + "\n").encode()

    def close(self) -> None:
        """Close the event file, if there is one."""
        if self._events is not None:
            self._events.close()
