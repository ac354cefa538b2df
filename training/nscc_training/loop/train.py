"""The loop itself: batches in, a run folder out, and at any time the way back into it."""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from contextlib import nullcontext, suppress
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import torch

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.files import write_together
from nscc_runtime.progress import Progress as Track
from nscc_runtime.progress import unseen
from nscc_training.config import config_toml
from nscc_training.data import Ahead, Batch, Batches, Scenes, load_scenes
from nscc_training.loop.artifacts import artifacts, environment, lines_of
from nscc_training.loop.folder_lock import locked_folder
from nscc_training.loop.ranks import Ranks
from nscc_training.loop.searching import search, within
from nscc_training.loop.setup import Parts, make_parts
from nscc_training.loop.state import CHECKPOINT, Progress, packed, set_tensors, tensors_of, unpack
from nscc_training.loop.steps import decoded, finite_norm, generator_of, loss_of, scored, window
from nscc_training.loop.trials import pull, trial_of
from nscc_training.programs import TARGET_FILE, compiled, program_of, words_per_slot
from nscc_training.settings import Settings

COLUMNS = ("step", "split", "loss", "psnr_db", "ssim", "words_per_slot", "dead_share")
METRICS = "metrics.csv"


@dataclass
class Run:
    """A run while it goes on. `rows` are the lines of metrics.csv, without their ends."""

    parts: Parts
    batches: Batches
    scenes: Scenes
    optimiser: torch.optim.Optimizer
    ranks: Ranks
    progress: Progress
    rows: list[str] = field(default_factory=lambda: [",".join(COLUMNS)])


def train(
    settings: Settings,
    out: Path,
    *,
    resume: str = "auto",
    track: Track = unseen,
    report: Callable[[str], None] = lambda _text: None,
    stop_after: int | None = None,
) -> None:
    """Train, and write the run folder `out`.

    `resume` is auto (go on from a checkpoint in `out` if there is one), never, or a run folder or
    checkpoint to go on from. `track` draws a bar and `report` is told each validation and the end,
    both in the process that writes. With `stop_after` the run ends after that step, as if
    interrupted, but with a checkpoint.
    """
    is_first = os.environ.get("RANK", "0") == "0"  # of several processes the first writes
    with locked_folder(out) if is_first else nullcontext():
        _train(settings, out, resume, track, report, stop_after)


def _train(
    settings: Settings, out: Path, resume: str, track: Track, report: Callable[[str], None],
    stop_after: int | None,
) -> None:  # fmt: skip
    ranks = Ranks()
    try:
        if settings.train.batch < ranks.count:
            raise rejected(
                "NS0815",
                f"train.batch is {settings.train.batch}, and {ranks.count} processes share it",
                notes=("every process takes its part of each batch, a patch at least",),
                helps=("raise [train] batch, or start fewer processes",),
            )
        if ranks.count > 1 and settings.shutter.learn and settings.shutter.relaxation == "search":
            raise rejected(
                "NS0815", f"codes are searched by one process, and here are {ranks.count}",
                notes=("processes would judge other patches, and choose other codes",),
                helps=("start one: `nscc train` without torchrun",),
            )  # fmt: skip
        checkpoint = _checkpoint(out, resume)
        run = _start(settings, checkpoint, ranks)
        if ranks.first:
            # A checkpoint and a log of another folder become this one's: else what is in it would
            # be of two runs, or could not be gone on with.
            own = out / CHECKPOINT
            brought = checkpoint is not None and checkpoint.resolve() != own.resolve()
            out.mkdir(parents=True, exist_ok=True)
            write_together({
                out / "config.resolved.toml": config_toml(settings).encode(),
                out / "split.json": lines_of(run.scenes.split()),
                out / "environment.json": lines_of(environment(run.parts)),
                **{out / name: data for name, data in run.parts.files.items()},
                **(_so_far(run, out) if brought else {}),
            })  # fmt: skip
        _steps(run, out, track if ranks.first else unseen, report, stop_after)
        if ranks.first and run.progress.step >= settings.train.steps:
            _finish(run, out)
            chip = "" if run.parts.chip.file is None else f" --target {out / TARGET_FILE}"
            report(f"{out}: model_card.md says what it is worth; "
                   f"`nscc build {out / 'shutter.nsl'}{chip}` compiles its shutters")  # fmt: skip
        ranks.meet()
    finally:
        ranks.close()


def _start(settings: Settings, checkpoint: Path | None, ranks: Ranks) -> Run:
    """Everything at the first step, or at a checkpoint's."""
    parts = make_parts(settings)
    scenes = load_scenes(settings.data, parts.still, parts.slots, settings.train.seed)
    batches = Batches(
        scenes, settings.data, slots=parts.slots, full_well_e=parts.model.full_e,
        batch=settings.train.batch, seed=settings.train.seed,
    )  # fmt: skip
    run = Run(parts, batches, scenes, _optimiser(parts), ranks, Progress())
    if checkpoint is not None:
        run.progress = unpack(checkpoint, parts, scenes, run.optimiser)
        run.rows = _rows(checkpoint.parent / METRICS, run.progress.step) or run.rows
    return run


def _checkpoint(out: Path, resume: str) -> Path | None:
    if resume == "never":
        return None
    if resume == "auto":
        return out / CHECKPOINT if (out / CHECKPOINT).is_file() else None
    path = Path(resume)
    found = path / CHECKPOINT if path.is_dir() else path
    if not found.is_file():
        raise rejected(
            "NS0816",
            f"there is no checkpoint to go on from: '{resume[:200]}'",
            notes=("--resume takes auto, never, a run folder or a checkpoint",),
            helps=("leave --resume out to begin, or to go on in --out",),
        )
    return found


def _rows(path: Path, step: int) -> list[str]:
    """The lines of metrics.csv up to a step: what came after the checkpoint is done again."""
    if not path.is_file():
        return []
    try:
        head, *rest = path.read_text(encoding="utf-8").splitlines()
        return [head, *(row for row in rest if int(row.partition(",")[0]) <= step)]
    except ValueError:
        raise rejected(
            "NS0816",
            f"training cannot go on from '{path.parent}'",
            notes=(f"{path.name} is damaged: its lines do not begin with a step",),
            helps=("without that file the run goes on, and its log begins there",),
        ) from None


def _optimiser(parts: Parts) -> torch.optim.Optimizer:
    settings = parts.settings
    groups = [(list(parts.decoder.parameters()), settings.train.rate)]
    if settings.shutter.learn:
        spans = {id(p): high - low for p, (low, high) in parts.encoder.ranges()}
        for parameter in parts.encoder.parameters():
            span = spans.get(id(parameter), 1.0)
            groups.append(([parameter], settings.train.code_rate * span))
    else:
        parts.encoder.requires_grad_(False)
    made = [{"params": group, "base": rate, "lr": rate} for group, rate in groups if group]
    return torch.optim.Adam(made, fused=True)


def _steps(
    run: Run, out: Path, track: Track, report: Callable[[str], None],
    stop_after: int | None,
) -> None:  # fmt: skip
    total, every = run.parts.settings.train.steps, run.parts.settings.train.validate_every
    losses: list[float] = []
    with Ahead(partial(batch_of, run), total) as ahead:
        for step in track(range(run.progress.step, total), "training", total - run.progress.step):
            losses.append(_update(run, step, ahead))
            run.progress.step = step + 1
            due = (step + 1) % every == 0 or step + 1 == total or step + 1 == stop_after
            if due and run.ranks.first:
                _validate(run, losses, report)
                write_together(_so_far(run, out))
            if due:
                losses.clear()
            if step + 1 == stop_after:
                return


def _so_far(run: Run, out: Path) -> dict[Path, bytes]:
    """What a run goes on from: its log and its checkpoint, by their files in `out`."""
    return {
        out / METRICS: ("\n".join(run.rows) + "\n").encode(),
        out / CHECKPOINT: packed(run.parts, run.scenes, run.optimiser, run.progress),
    }


def batch_of(run: Run, step: int) -> Batch:
    """This process's part of a step's batch, with what losses need of it."""
    batch = run.batches.train(step).part(*run.ranks.part(run.batches.batch))
    return batch.to(run.parts.device).prepared()


def _update(run: Run, step: int, ahead: Ahead) -> float:
    """One step; returns its loss on this process's part of the batch."""
    parts, settings = run.parts, run.parts.settings
    anneal(parts, step)
    set_rates(run, step)
    seed, size = settings.train.seed, settings.train.batch
    first, last = run.ranks.part(size)
    batch = ahead.take(step)
    parts.decoder.train()
    run.optimiser.zero_grad(set_to_none=True)
    rows, cols = batch.light.shape[-2:]
    place = (seed, 7, step)
    trial = None
    learns = codes_learn(settings, step)
    if parts.encoder.relaxation == "search" and codes_learn(settings, step - 1) and not learns:
        take_best(run)
    if learns and parts.encoder.relaxation == "search":
        ahead.begin(step + 1)
        return search(parts, batch, step)
    if learns and parts.encoder.relaxation == "tried":
        trial = trial_of(parts.encoder, rows, cols, (seed, 6, step, run.ranks.rank), place)
        shutters = trial.shutters[0]
    elif learns:
        # The codes' noise is the same in every process, the sensor's is not.
        shutters = window(parts.encoder(generator_of(seed, 6, step)), rows, cols, place)
    else:
        shutters = window(parts.encoder.hard(), rows, cols, place)
    shutters = shutters.to(parts.device)
    noise = (seed, 10, step, run.ranks.rank)
    prediction = decoded(parts, batch.light, shutters, parts.model, generator_of(*noise))
    loss = loss_of(parts, prediction, batch, shutters)
    if trial is not None:
        loss = loss + pull(parts, batch, trial, prediction, generator_of(*noise))
    # Here and not before: nobody else needs the interpreter while gradients are computed.
    ahead.begin(step + 1)
    if loss.requires_grad:  # or neither the decoder learns nor, in this step, the codes
        loss.backward()  # type: ignore[no-untyped-call]
    learned = [p for group in run.optimiser.param_groups for p in group["params"]]
    run.ranks.average((p.grad for p in learned if p.grad is not None), (last - first) / size)
    norm = finite_norm(loss, parts, batch, step)
    if 0 < settings.train.clip < norm:
        torch.nn.utils.clip_grads_with_norm_(parts.decoder.parameters(), settings.train.clip, norm)
    run.optimiser.step()
    parts.encoder.project()
    return loss.item()


def codes_learn(settings: Settings, step: int) -> bool:
    """Whether the codes change in a step: first the decoder may have to know them, and last they
    may be settled."""
    shutter, steps = settings.shutter, settings.train.steps
    return shutter.learn and shutter.warm_up * steps <= step < (1 - shutter.settle) * steps


def anneal(parts: Parts, step: int) -> None:
    """Temperature and noise of the codes at a step; both rates follow in the optimiser."""
    settings = parts.settings
    done = step / max(1, settings.train.steps - 1)
    warm, cold = settings.shutter.temperature
    parts.encoder.temperature = warm * (cold / warm) ** done
    parts.encoder.noise = settings.shutter.noise * (1 - done)


def set_rates(run: Run, step: int) -> None:
    """The learning rates of a step."""
    settings = run.parts.settings.train
    cosine = 0.5 * (1 + math.cos(math.pi * step / settings.steps))
    for group in run.optimiser.param_groups:
        group["lr"] = group["base"] * (cosine if settings.schedule == "cosine" else 1.0)


def _validate(run: Run, losses: list[float], report: Callable[[str], None]) -> None:
    """Score the hard shutters, log, and remember the best state whose shutters compile."""
    parts, step = run.parts, run.progress.step
    parts.decoder.eval()
    settings = parts.settings
    dead = parts.encoder.dead_share() if codes_learn(settings, step - 1) else None
    run.rows.append(row(step, "train", sum(losses) / len(losses), None, None, None, dead))
    words = None
    with suppress(Rejected):
        words = words_per_slot(compiled(
            program_of(parts.encoder, parts.chip), parts.chip,
            every_code=settings.shutter.codes == "open",
        ))  # fmt: skip
    found = scored(parts, run.batches.val(), parts.encoder.hard(), parts.model,
                   settings.train.seed)  # fmt: skip
    run.rows.append(row(step, "val", found.loss, found.psnr_db, found.ssim, words, dead))
    report(f"step {step}: loss {found.loss:.5f}, {found.psnr_db:.2f} dB, SSIM {found.ssim:.4f}"
           + (f", {words:.1f} words a slot" if words is not None else ""))  # fmt: skip
    counts = words is not None and within(settings.shutter, words)
    if counts and found.loss < run.progress.best_loss:
        run.progress.best_loss, run.progress.best_step = found.loss, step
        run.progress.best = tensors_of(parts)


def take_best(run: Run) -> None:
    """Go back to the best state that was validated. Rejected where there is none: as the compiler,
    or NS0850 where codes were found that compile, and none within `shutter.most_words`."""
    parts, most = run.parts, run.parts.settings.shutter.most_words
    if run.progress.best is not None:
        set_tensors(parts, run.progress.best)
        return
    words = words_per_slot(compiled(program_of(parts.encoder, parts.chip), parts.chip))
    if not within(parts.settings.shutter, words):
        raise rejected(
            "NS0850", f"the search has found no code of at most {most:g} words a slot",
            notes=(f"it stands at {words:.1f} after {run.progress.step} steps; words_per_slot in "
                   f"{METRICS} says how it came there",),
            helps=("raise [shutter] most_words, or give the search more steps",
                   "begin with `quad` or `uniform`, which take few words"),
        )  # fmt: skip


def row(step: int, split: str, *values: float | None) -> str:
    """A line of metrics.csv; what is not known stays empty."""
    return ",".join([str(step), split, *("" if v is None else repr(float(v)) for v in values)])


def _finish(run: Run, out: Path) -> None:
    """Take the best state and write what it is worth."""
    progress = run.progress
    # A run that was interrupted after its last step makes no step that would do this.
    anneal(run.parts, run.parts.settings.train.steps - 1)
    take_best(run)
    run.parts.decoder.eval()
    made = artifacts(run.parts, run.batches, run.scenes, progress.best_step)
    write_together({out / name: data for name, data in made.items()})
