"""The log of training: `metrics.csv`, and event files if TensorBoard is installed."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import Any

from nscc.diagnostics.rejection import rejected

COLUMNS = ("step", "split", "loss", "psnr_db", "ssim", "words_per_slot", "dead_share")
METRICS = "metrics.csv"
EVENTS = "tensorboard"


class Log:
    """The log of a run in the folder `out`; `rows` are the lines of `metrics.csv`."""

    def __init__(self, out: Path, rows: list[str] | None = None) -> None:
        self.out = out
        self.rows = rows or [",".join(COLUMNS)]
        self._events: Any = None

    @classmethod
    def of_checkpoint(cls, folder: Path, step: int, out: Path) -> Log:
        """Return the log up to the step of a checkpoint; later lines are dropped."""
        path = folder / METRICS
        if not path.is_file():
            return cls(out)
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
        return cls(out, [head, *kept_rows])

    def add(self, step: int, split: str, **values: float | None) -> None:
        """Add a line; missing values stay empty."""
        cells = (values.get(name) for name in COLUMNS[2:])
        texts = ("" if value is None else repr(float(value)) for value in cells)
        self.rows.append(",".join([str(step), split, *texts]))
        events = self._writer()
        if events is not None:
            for name, value in values.items():
                if value is not None:
                    events.add_scalar(f"{split}/{name}", value, step)
            events.flush()

    def csv(self) -> bytes:
        """Return `metrics.csv`."""
        return ("\n".join(self.rows) + "\n").encode()

    def close(self) -> None:
        """Close the event file, if there is one."""
        if self._events is not None:
            self._events.close()

    def _writer(self) -> Any:
        """Return the TensorBoard writer, made at first use; None if TensorBoard is not installed.

        Event files contain times and the host name, so they are not products of the run."""
        if self._events is None and find_spec("tensorboard") is not None:
            from torch.utils.tensorboard import SummaryWriter

            self._events = SummaryWriter(str(self.out / EVENTS))
        return self._events
