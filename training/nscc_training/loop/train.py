"""The training loop: from batches to a run folder and a log, resumable at any time."""

from __future__ import annotations

import os
import shlex
from collections.abc import Callable, Iterable, Sequence
from contextlib import closing, nullcontext
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import torch
from torch import Tensor, nn
from torch.optim.swa_utils import AveragedModel, get_ema_multi_avg_fn
from torch.utils.data import DataLoader, Dataset

from nscc.diagnostics.diagnostic import rejected
from nscc.files import write_together
from nscc.program.problems import counted
from nscc_runtime.progress import Progress as Track
from nscc_runtime.progress import unseen
from nscc_training.any_code.lessons import Lesson, LessonSet
from nscc_training.code_choices import SEARCHED
from nscc_training.data import Batch, Exposures, ExposureSet, Scenes, cut_batch, load_scenes
from nscc_training.data.moving import shown_picture
from nscc_training.draws import generator_of
from nscc_training.loop.artifacts import artifacts, environment, lines_of
from nscc_training.loop.optimizers import (
    anneal,
    codes_learn,
    cycle_of,
    optimizers_of,
    set_rates,
    settling_step,
)
from nscc_training.loop.ranks import Ranks
from nscc_training.loop.searching import search, within
from nscc_training.loop.setup import TrainingSetup, make_setup
from nscc_training.loop.state import (
    CHECKPOINT,
    TrainingProgress,
    TrainingState,
    locked_folder,
    packed,
    set_tensors,
    tensors_of,
)
from nscc_training.loop.state import unpack as unpacked
from nscc_training.loop.steps import StepLoss, finite_norm, lesson_losses
from nscc_training.loop.validation import validated, validation_scenes
from nscc_training.measures import means_text
from nscc_training.programs import TARGET_FILE, words_per_slot
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene
from nscc_training.random_streams import DrawStream
from nscc_training.settings import RunSettings, config_toml

METRICS = "metrics.csv"
"""The log of a run, a table with a line for each validation."""
EVENTS = "tensorboard"
"""The folder of a run for events of tensorboard."""


class Log:
    """The log of a run in the folder `out`, with a column for each metric of its protocol.

    `rows` are the lines of `metrics.csv`, the header first. With tensorboard installed, events are
    written at once; the file itself is written by the caller."""

    def __init__(
        self, out: Path, metrics: Sequence[str], rows: Sequence[str] | None = None
    ) -> None:
        """Continue a log with the lines `rows` of an earlier one, header first. None begins a log
        that holds only a header.

        `out` is the folder of the run. `metrics` are the names of the protocol's metrics. Their
        columns follow the loss; the last columns are the words per slot and `Encoder.dead_share`.
        """
        self.out = out
        self._columns = ("loss", *metrics, "words_per_slot", "dead_share")
        self.rows = list(rows or [",".join(["step", "split", *self._columns])])
        self._events: Any = None

    @classmethod
    def of_checkpoint(cls, folder: Path, step: int, out: Path, metrics: Sequence[str]) -> Log:
        """Return the log in `folder` up to the step of its checkpoint, to be continued in `out`.
        Later lines are dropped.

        Without a log file, the log begins anew. Raises Rejected (NS0816) for a damaged log."""
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
        """Add a line for a step and a split ("train" or "val"), with `values` by column (names of
        columns; others are not in the table). Missing values and None stay empty.

        With tensorboard installed, an event is written too."""
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
        """Return the content of `metrics.csv`: a header, and a line for each call of `add`."""
        return ("\n".join(self.rows) + "\n").encode()

    def close(self) -> None:
        """Close the event file, if there is one."""
        if self._events is not None:
            self._events.close()


_FOLLOW_EVERY = 50
"""Steps after which the emulated sensor is measured again if the codes have changed."""


@dataclass
class TrainingRun:
    """A training run in progress.

    `state` are its tensors, `progress` its step and best state, and `log` its scores. `dataset`
    draws the data of a step, `shown` are the exposed validation scenes (in the first process only),
    and `ranks` the processes that train together. `step_loss` computes losses and shares their
    gradients. `begun` are the parameters before the first step, to which restarts return."""

    state: TrainingState
    dataset: Dataset[Any]
    scenes: Scenes
    shown: list[ProtocolScene]
    ranks: Ranks
    progress: TrainingProgress
    log: Log
    step_loss: nn.Module
    begun: dict[str, Tensor]

    @property
    def setup(self) -> TrainingSetup:
        """The objects that the configuration names."""
        return self.state.setup


def train(
    settings: RunSettings,
    out: Path,
    *,
    resume: str = "auto",
    track: Track = unseen,
    report: Callable[[str], None] = lambda _text: None,
    stop_after: int | None = None,
) -> None:
    """Train as `settings` say, and write the run folder `out`, which is locked meanwhile.

    `resume` is auto (continue from a checkpoint in `out` if it has one), never, or a run folder or
    checkpoint. `track` draws a progress bar, and `report` receives a text for each validation and
    at the end; both are used in the first process only. With `stop_after` the run stops after that
    number of steps and writes a checkpoint; None trains to the end. Raises Rejected for invalid
    settings, scenes or checkpoints, and NS0848 for a folder in use. An interrupt raises
    KeyboardInterrupt with a sentence on how to continue."""
    is_first = os.environ.get("RANK", "0") == "0"  # only the first of several processes writes
    with locked_folder(out) if is_first else nullcontext(), closing(Ranks()) as ranks:
        _check_ranks(settings, ranks)
        checkpoint = _checkpoint(out, resume)
        run = start(settings, checkpoint, ranks, out, report)
        if ranks.first:
            # Copy checkpoint and log from another folder: else this folder would mix two runs,
            # or could not be resumed.
            checkpoint_path = out / CHECKPOINT
            brought = checkpoint is not None and checkpoint.resolve() != checkpoint_path.resolve()
            out.mkdir(parents=True, exist_ok=True)
            write_together(
                {
                    out / "config.resolved.toml": config_toml(settings).encode(),
                    out / "split.json": lines_of(run.scenes.split()),
                    out / "environment.json": lines_of(environment(run.setup)),
                    **{out / name: data for name, data in run.setup.files.items()},
                    **(_so_far(run) if brought else {}),
                }
            )
        try:
            _steps(run, track if ranks.first else unseen, report, stop_after)
        except KeyboardInterrupt as stop:
            raise KeyboardInterrupt(_how_to_go_on(out, resume)) from stop
        if ranks.first and run.progress.step >= settings.train.steps:
            # A run interrupted after its last step has no further step that would anneal.
            anneal(run.setup, settings.train.steps - 1)
            take_best(run)
            run.setup.decoder.eval()
            files = artifacts(run.setup, run.shown, run.scenes, run.progress.best_step)
            write_together({out / name: data for name, data in files.items()})
            chip = () if run.setup.chip.file is None else ("--target", str(out / TARGET_FILE))
            build = shlex.join(["nscc", "build", str(out / "shutter.nsl"), *chip])
            report(f"{out}: model_card.md says what it is worth; `{build}` compiles its shutters")
        run.log.close()
        ranks.meet()


def _how_to_go_on(out: Path, resume: str) -> str:
    """Return a sentence on how an interrupted training in `out` continues. `resume` is the value of
    the option --resume."""
    if not (out / CHECKPOINT).is_file():
        return "there is no checkpoint yet; the same command starts again"
    how = "the same command continues" if resume == "auto" else "--resume auto continues"
    return f"the last checkpoint is stored in '{out}'; {how}"


def start(
    settings: RunSettings,
    checkpoint: Path | None,
    ranks: Ranks,
    out: Path,
    report: Callable[[str], None] = lambda _text: None,
) -> TrainingRun:
    """Return a run that is ready for its next step: at step 0, or at the step of `checkpoint`, with
    scenes, decoder, shutters and log.

    `out` is the folder of its log. `ranks` are the processes that train together; the first one
    calls `report` with messages about scenes. `checkpoint` None begins anew. Nothing is written.
    Raises Rejected for invalid settings, scenes or checkpoints."""
    setup = make_setup(settings)
    lessons, data, seed = settings.decoder.lessons, settings.data, settings.train.seed
    classes, metrics = setup.classes, setup.protocol.metrics
    tell: Callable[[str], object] = report if ranks.first else str
    scenes = load_scenes(
        data, setup.still, setup.slots, seed, pictures=bool(lessons), classes=classes, tell=tell
    )
    dataset: Dataset[Any]
    if lessons:
        lights = [scene.light for scene in scenes.train]
        pictures = lights if setup.still else [shown_picture(light) for light in lights]
        dataset = LessonSet(pictures, settings)
    else:
        dataset = ExposureSet(
            scenes, data, slots=setup.slots, batch=settings.train.batch, seed=seed, classes=classes
        )
    if settings.train.compile:
        setup.decoder.compile()
    average = None
    if settings.train.average:
        decay = get_ema_multi_avg_fn(settings.train.average)  # type: ignore[no-untyped-call]
        average = AveragedModel(setup.decoder, multi_avg_fn=decay, use_buffers=True)
    state = TrainingState(setup, optimizers_of(setup), average)
    progress, log = TrainingProgress(), Log(out, metrics)
    begun = tensors_of(setup)
    if checkpoint is not None:
        progress = unpacked(checkpoint, state, scenes)
        log = Log.of_checkpoint(checkpoint.parent, progress.step, out, metrics)
    loss = ranks.parallel(StepLoss(setup, ranks))
    shown = validation_scenes(setup, scenes) if ranks.first else []
    return TrainingRun(state, dataset, scenes, shown, ranks, progress, log, loss, begun)


def _check_ranks(settings: RunSettings, ranks: Ranks) -> None:
    """Raise Rejected (NS0815) for settings that several processes do not support: a batch smaller
    than their number, and with more than one process searches, restarts and lessons."""
    if settings.train.batch < ranks.count:
        raise rejected(
            "NS0815",
            f"train.batch is {settings.train.batch}, but {ranks.count} processes share it",
            notes=("every process takes a part of each batch, at least one patch",),
            helps=("raise [train] batch, or start fewer processes",),
        )
    searched = _settles_with_best(settings)
    if ranks.count > 1 and (searched or settings.decoder.lessons):
        activity = "codes are searched" if searched else "lessons are learned"
        raise rejected(
            "NS0815",
            f"{activity} by one process, but {ranks.count} are running",
            helps=("start one: `nscc train` without torchrun",),
        )


def _settles_with_best(settings: RunSettings) -> bool:
    """Return whether the codes settle in the best validated state instead of the last one: in a
    search, and after restarts."""
    shutter = settings.shutter
    return shutter.learn and (shutter.relaxation in SEARCHED or shutter.restarts > 0)


def _checkpoint(out: Path, resume: str) -> Path | None:
    """Return the checkpoint that the option --resume means, or None to begin anew. `out` is the
    folder of the run.

    Raises Rejected (NS0816) if a named checkpoint is missing."""
    if resume == "never":
        return None
    if resume == "auto":
        return out / CHECKPOINT if (out / CHECKPOINT).is_file() else None
    path = Path(resume)
    checkpoint = path / CHECKPOINT if path.is_dir() else path
    if not checkpoint.is_file():
        raise rejected(
            "NS0816",
            f"no checkpoint to resume from: '{resume[:200]}'",
            notes=("--resume takes auto, never, a run folder or a checkpoint",),
            helps=("leave --resume out to start, or to resume the run in --out",),
        )
    return checkpoint


def loader_of(run: TrainingRun, first: int, last: int) -> Iterable[Any]:
    """Return the data that `run.dataset` draws for the steps from `first` up to, but without,
    `last`, in order. Worker processes compute it ahead, if the settings name some."""
    workers, device = run.setup.settings.train.workers, run.setup.device
    return DataLoader(
        run.dataset,
        batch_size=None,
        sampler=range(first, last),
        num_workers=workers,
        pin_memory=device.type == "cuda",
        multiprocessing_context="spawn" if workers else None,
    )


def _steps(
    run: TrainingRun, track: Track, report: Callable[[str], None], stop_after: int | None
) -> None:
    """Train from the current step to the last, or until `stop_after` steps are done (None: no
    limit). At intervals and at the end, validate, and write log and checkpoint.

    `track` receives the steps, and `report` a text for each validation."""
    total, validate_every = run.setup.settings.train.steps, run.setup.settings.train.validate_every
    losses: list[Tensor] = []
    first = run.progress.step
    loader = loader_of(run, first, total)
    for step, drawn in enumerate(track(loader, "training", total - first), start=first):
        losses.append(update(run, step, drawn))
        run.progress.step = step + 1
        ends = [total, stop_after]
        if _settles_with_best(run.setup.settings):
            ends.append(cycle_of(run.setup.settings, step)[1])
        due = (step + 1) % validate_every == 0 or step + 1 in ends
        if due and run.ranks.first:
            _validate(run, float(torch.stack(losses).mean()), report)
            write_together(_so_far(run))
        if due:
            losses.clear()
        if step + 1 == stop_after:
            return


def _so_far(run: TrainingRun) -> dict[Path, bytes]:
    """Return the contents of log and checkpoint, from which a run can resume, by the paths of their
    files in the folder of the run."""
    return {
        run.log.out / METRICS: run.log.csv(),
        run.log.out / CHECKPOINT: packed(run.state, run.scenes, run.progress),
    }


def batch_of(run: TrainingRun, drawn: Exposures) -> Batch:
    """Return this process's share of the batch of a step, exposed on the run's device. `drawn` are
    the random draws of the step."""
    setup, settings = run.setup, run.setup.settings
    batch = cut_batch(drawn, settings.data, setup.model.full_e, setup.device)
    return batch.patches(*run.ranks.batch_range(settings.train.batch))


def update(run: TrainingRun, step: int, drawn: Any) -> Tensor:
    """Take one step, number `step`, with the data `drawn` for it: random exposures, or a `Lesson`
    for the decoder for any code. Return its mean loss on this process's share of the batch.

    Parameters of decoder and encoder and the learning rates change. At the start of a cycle, the
    codes first restart, or begin to settle with the best ones. A step learns by gradients, by a
    search, or from the updates of a lesson."""
    setup, settings = run.setup, run.setup.settings
    anneal(setup, step)
    set_rates(run.state.optimizers, settings, step)
    setup.decoder.train()
    first, _ = cycle_of(settings, step)
    if 0 < step == first < settling_step(settings):
        _begin_again(run, run.begun)
        setup.start_random(step)
    elif 0 < step == first and _settles_with_best(settings):
        take_best(run)
    learns = codes_learn(settings, step)
    if step % _FOLLOW_EVERY == 0 or step == first or learns != codes_learn(settings, step - 1):
        setup.follow_codes()
    if learns and setup.encoder.relaxation in SEARCHED:
        batches = [batch_of(run, run.dataset[k]) for k in range(settings.shutter.batches)]
        return torch.tensor(search(setup, batches, step))
    if not isinstance(drawn, Lesson):
        return _learn(run, run.step_loss(batch_of(run, drawn), step), drawn.names, step)
    light, mask = drawn.light.to(setup.device), drawn.mask.to(setup.device)
    generator = generator_of(setup.device, settings.train.seed, DrawStream.LESSON_NOISE, step)
    updates = lesson_losses(setup, drawn._replace(light=light, mask=mask), generator)
    return torch.stack([_learn(run, loss, drawn.names, step) for loss in updates]).mean()


def _begin_again(run: TrainingRun, tensors: dict[str, Tensor]) -> None:
    """Set encoder and decoder to `tensors`, and clear the state of the optimizers and the running
    average."""
    set_tensors(run.setup, tensors)
    for optimizer in run.state.optimizers:
        optimizer.state.clear()
    if run.state.average is not None:
        run.state.average.n_averaged.zero_()


def _learn(run: TrainingRun, loss: Tensor, names: tuple[str, ...], step: int) -> Tensor:
    """Update the parameters by the gradient of a loss, whose norm for the decoder is limited to the
    setting `clip` (0: no limit), and return the loss without the weight of this process.

    `names` are the scenes of the batch and `step` its number, for the error (NS0817) if the loss or
    a gradient is not finite."""
    setup, clip, state = run.setup, run.setup.settings.train.clip, run.state
    for optimizer in state.optimizers:
        optimizer.zero_grad(set_to_none=True)
    setup.encoder.zero_grad(set_to_none=True)
    setup.decoder.zero_grad(set_to_none=True)
    if loss.requires_grad:  # False if neither decoder nor codes learn in this step
        loss.backward()  # type: ignore[no-untyped-call]
    norm = finite_norm(loss, setup, names, step)
    if 0 < clip < norm:
        torch.nn.utils.clip_grads_with_norm_(setup.decoder.parameters(), clip, norm)
    for optimizer in state.optimizers:
        optimizer.step()
    setup.encoder.project()
    if state.average is not None:
        state.average.update_parameters(setup.decoder)
    return loss.detach() / run.ranks.weight(setup.settings.train.batch)


def _validate(run: TrainingRun, loss: float, report: Callable[[str], None]) -> None:
    """Score hard shutters and decoder on the validation scenes, log and report the scores, and keep
    the state in `run.progress` if it is the best.

    The running average replaces the decoder's weights meanwhile, if there is one. Codes that do not
    compile, or take too many words, are never the best; of equal losses the earlier state stays,
    and NaN is never the best. `loss` is the mean loss since the last validation."""
    setup, step = run.setup, run.progress.step
    settings = setup.settings
    dead = setup.encoder.dead_share() if codes_learn(settings, step - 1) else None
    run.log.add(step, "train", loss=loss, dead_share=dead)
    words = setup.words_per_slot()
    learned = tensors_of(setup) if run.state.average is not None else None
    if run.state.average is not None:
        setup.decoder.load_state_dict(run.state.average.module.state_dict())
    setup.decoder.eval()
    scores = validated(setup, run.shown)
    run.log.add(
        step, "val", loss=scores.loss, words_per_slot=words, dead_share=dead, **scores.means
    )
    report(
        f"step {step}: loss {scores.loss:.5f}, {means_text(scores.means)} "
        f"({setup.protocol.name}, {counted(len(run.shown), 'validation scene')})"
        + (f", {words:.1f} words a slot" if words is not None else "")
    )
    counts = words is not None and within(settings.shutter, words)
    if counts and scores.loss < run.progress.best_loss:
        run.progress.best_loss, run.progress.best_step = scores.loss, step
        run.progress.best = tensors_of(setup)
    # Validation used the averaged weights; training goes on with the learned ones.
    if learned is not None:
        set_tensors(setup, learned)


def take_best(run: TrainingRun) -> None:
    """Restore the best validated state of the run, with fresh optimizers.

    If no validation counted, the present state stays, after a check: Raises Rejected with the
    compiler's errors, or NS0850 for too many words."""
    setup, most = run.setup, run.setup.settings.shutter.most_words
    if run.progress.best is not None:
        _begin_again(run, run.progress.best)
        return
    words = words_per_slot(setup.compiled())
    if not within(setup.settings.shutter, words):
        raise rejected(
            "NS0850",
            f"the search found no code with at most {most:g} words per slot",
            notes=(
                f"it has {words:.1f} after {run.progress.step} steps; words_per_slot in "
                f"{METRICS} shows the progress",
            ),
            helps=(
                "raise [shutter] most_words, or give the search more steps",
                "start with `quad` or `uniform`, which need few words",
            ),
        )
