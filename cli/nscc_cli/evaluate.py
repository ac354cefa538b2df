"""`nscc evaluate`: scores under a protocol, and comparisons; `nscc metrics`: those of two files."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc.files import Product, write_together, write_whole
from nscc_cli.completion import RUN_OR_ANY
from nscc_cli.options import OUT, PATH, declared, json_option, out_option, settings_from, together
from nscc_cli.support import (
    NumberRange,
    Subcommands,
    common_command,
    progress,
    refuse_ignored,
    say_compiling,
    say_done,
    show,
)
from nscc_cli.tradeoff_files import kept_rows
from nscc_training.command_settings import EvaluationSettings, FigureSettings, TvSettings

if TYPE_CHECKING:
    from nscc_training.evaluation.results import Evaluated


class _Evaluations(Subcommands):
    """The subcommands of `nscc evaluate`; any other name is passed to `evaluate of`."""

    others = ("or name a run or a baseline: `nscc evaluate hdr --data DIR --protocol hdr-v1`",)

    def accepts(self, name: str) -> bool:
        """Return True: every name may be a run or a baseline."""
        return True


@click.group("evaluate", cls=_Evaluations)
def command() -> None:
    """Score reconstructions under a fixed protocol; each result contains the protocol's digest.

    `nscc evaluate NAME --data DIR --protocol P` is short for `nscc evaluate of NAME ..`."""


_outputs = together(
    json_option("Print the result as JSON."),
    out_option("Write it to a file."),
)
_save_option = click.option(
    "--save", type=OUT, metavar="DIR", help="Write reconstructions and truth into this folder."
)


@command.command("sci8")
@click.argument("clips", metavar="CLIP.mat...", nargs=-1, required=True, type=PATH)
@click.option(
    "--method",
    default="gap-tv",
    show_default=True,
    metavar="M",
    help="any, the decoder for any code; gap-tv, admm-tv, dictionary, adjoint; or an "
    "oracle: bilinear, thin-out.",
)
@declared(TvSettings, show=True)
@_save_option
@_outputs
def sci8(
    clips: tuple[Path, ...], method: str, iterations: int, weight: float, **outputs: Any
) -> int:
    """Run the benchmark of snapshot compressive imaging: eight frames from one measurement.

    The result marks reference methods that use the ground truth instead of the measurement
    ("sees")."""
    from nscc_training.baselines.tv_loop import denoise
    from nscc_training.evaluation.baselines import evaluate_sci8

    names = [path.name for path in clips]
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise click.UsageError(
            f"a clip may be given only once, because results identify it by its name: {twice[0]}"
        )
    if method.endswith("-tv"):
        say_compiling(denoise, "the loop of total variation")
    else:
        refuse_ignored(f"{method[:60]} has no total variation", "iterations", "weight")
    known = {"clips": clips, "method": method, "iterations": iterations, "weight": weight}
    evaluate = partial(evaluate_sci8, list(clips), method, iterations, weight)
    return _of_scenes(evaluate, known, **outputs)


@command.command("of")
@click.argument("subject", type=RUN_OR_ANY, metavar="RUN|BASELINE")
@declared(EvaluationSettings, "data", "protocol")
@click.option(
    "--split",
    type=click.Choice(["val"]),
    metavar="val",
    help="Instead of --data and --protocol: the run's validation scenes, evaluated as "
    "in its metrics.csv.",
)
@declared(EvaluationSettings, "seed", "skip_seen", "shutter", "effects", "trust_code", show=True)
@_save_option
@_outputs
def of(
    subject: str,
    split: str | None,
    save: Path | None,
    as_json: bool,
    out: Path | None,
    **options: Any,
) -> int:
    """Score a run folder of `nscc train`, or a baseline, on a folder of scenes.

    A run that was trained on one of the files is refused; --skip-seen leaves these files out.

    Baselines of hdr-v1: ldr (always open), best-uniform (the single stop with the best linear
    PSNR, chosen with the ground truth), best-uniform-mu (the same for mu-law PSNR), quad (2 x 2
    geometric exposures) and random, all decoded by merging neighbours; sparse-coding (random,
    decoded by convolutional sparse coding); any (quad, with the decoder for any code); looks-2,
    looks-5, looks-9 (pixels that close at the first look above a level, without a decoder);
    designed-2, designed-5 (looks and levels designed for each crop); bracket (three readouts in one
    exposure time, merged).

    Baselines of video-v1: any, gap-tv, admm-tv, dictionary, adjoint on random bits, and the
    reference methods bilinear and thin-out. --shutter chooses other codes for methods that accept
    any class.

    Baselines of deblur-v1: long, short, any. Of two-bucket-v1: flutter, pixel-wise, two-bucket. Of
    staggered-v1: aligned, staggered, staggered-alone. Of codes-v1: any. class-v1 scores runs that
    predict classes."""
    data, protocol = options["data"], options["protocol"]
    # Both --data and --protocol, or --split alone.
    if (split is None) == (data is None or protocol is None) or (split and (data or protocol)):
        raise click.UsageError("name --data and --protocol, both, or --split val alone")
    wanted = settings_from(EvaluationSettings, options, subject=subject)
    if split is not None:
        from nscc_training.evaluation.runs import evaluate_validation
        from nscc_training.run_folder import load_run

        folder = load_run(Path(subject), trust_code=wanted.trust_code)
        evaluate = partial(evaluate_validation, folder)
    else:
        from nscc_training.evaluation.runs import evaluate as evaluate_subject

        evaluate = partial(evaluate_subject, wanted)
    known = {**options, "subject": subject, "split": split}
    return _of_scenes(evaluate, known, save, as_json=as_json, out=out)


@command.command("tables")
@click.option(
    "--results",
    type=PATH,
    metavar="DIR",
    help="The results of a sweep, DIR/results or DIR (default: those that come with nscc).",
)
@_outputs
def tables(results: Path | None, **outputs: Any) -> None:
    """Print Tables 2, 3 and 4 of the paper in Markdown, with our measurements beside them.

    `nscc sweep` evaluates the runs and baselines. Rows without a result are marked."""
    from nscc_training.evaluation.paper_tables import paper_tables

    rows, text = paper_tables(results)
    _finish(rows, text, products={}, **outputs)


@command.command("figures")
@declared(FigureSettings, show=True)
@out_option("The folder for the pictures.", "DIR", required=True)
def figures(out: Path, **options: Any) -> None:
    """Draw Figures 5, 6 and 7 of the paper, from the runs that come with nscc.

    The figures show coded frames and their reconstructions, several frames decoded from one,
    shutters as mosaics, a still at low and at high exposure, and several tone curves. Each is
    shown beside the ground truth and an exposure with pixels that are always open."""
    from nscc_training.evaluation.figures import figures as drawn

    drawings = drawn(settings_from(FigureSettings, options))
    out.mkdir(parents=True, exist_ok=True)
    files = {out / name: png for name, png in drawings.items()}
    write_together(files)
    say_done("\n".join(f"wrote {path.as_posix()}" for path in files))


@command.command("compare")
@click.argument(
    "results", metavar="A.json B.json [A.json B.json ...]", nargs=-1, required=True, type=PATH
)
@click.option(
    "--metric",
    default="psnr_db",
    show_default=True,
    metavar="NAME_db",
    help="The metric to compare; hdr-v1 also has mu_psnr_db.",
)
@_outputs
def compare(results: tuple[Path, ...], metric: str, **outputs: Any) -> None:
    """Print by how much B is better than A, in pairs: the same items of the same scenes.

    Further pairs are other seeds of the same two methods. The confidence interval is over scenes,
    with all seeds together."""
    if len(results) % 2:
        raise click.UsageError(
            f"results are compared in pairs, not {len(results)}: name A.json B.json for each seed"
        )
    from nscc_training.evaluation import results as saved

    read = [saved.read_result(path) for path in results]
    comparison = saved.compare(list(zip(read[::2], read[1::2], strict=True)), metric)
    _finish(comparison, saved.comparison_text(comparison, metric) + "\n", products={}, **outputs)


def _of_scenes(
    evaluate: Callable[..., Evaluated],
    known: Mapping[str, Any],
    save: Path | None,
    **outputs: Any,
) -> int:
    """Score scenes by `evaluate`, which takes a `scorer` and returns the result (JSON values) and
    arrays by name; print and write the result. Return the exit status: 1 if a file could not be
    read, else 0.

    With `-o` the scores are kept beside the file until it is written, so that the same command
    continues after an interrupt. They are kept for the options `known`. Reconstructions, which go
    to the folder `save`, are not kept. `outputs` are the options of `_finish`."""
    from nscc_training.evaluation.results import Scorer, arrays_in, damaged_files, result_text

    out = outputs["out"]
    files = {} if out is None or save is not None else {"json": out}
    with Scorer(partial(kept_rows, files, known), progress) as scorer:
        result, arrays = evaluate(scorer=scorer)
        products = {} if save is None else arrays_in(save, arrays)
        _finish(result, result_text(result), products, **outputs)
        scorer.store.remove()
    damaged = damaged_files(result)
    show(damaged)
    return 1 if damaged else 0


def _finish(
    result: Any, human: str, products: Mapping[Path, Product], as_json: bool, out: Path | None
) -> None:
    """Write `result` as JSON to the file `out`, if given, together with the files in `products`.
    Print it as JSON (`as_json`), or as the text `human`."""
    from nscc_training.evaluation.results import result_json

    text = result_json(result)
    write_together({**({out: text.encode()} if out else {}), **products})
    click.echo(text if as_json else human, nl=False)


@common_command("metrics")
@click.argument("truth", type=PATH)
@click.argument("result", metavar="REC", type=PATH)
@click.option(
    "--data-range",
    type=float,
    required=True,
    metavar="R",
    help="The peak value that errors are compared with: 255 for 8-bit "
    "values, 1 for values on [0, 1].",
)
@click.option("--truth-key", help="The array of TRUTH, if it contains several.")
@click.option("--rec-key", "result_key", help="The array of REC, if it contains several.")
@click.option(
    "--nits",
    type=NumberRange(0.005, 10000.0, min_open=True),
    default=1000.0,
    show_default=True,
    help="The luminance in cd/m2 that the data range R represents, for PU21-PSNR.",
)
@json_option("Print JSON, with every frame of a clip.")
@out_option("Write the JSON to a file.")
def metrics(as_json: bool, out: Path | None, **pair: Any) -> None:
    """Compare REC with TRUTH: pictures (rows, cols) or clips (T, rows, cols).

    Prints PSNR, SSIM, mu-law PSNR (mu = 5000), PU21-PSNR and, for clips, the temporal error.
    Values are compared as stored; mu-law and PU21 clip them to 0..R."""
    from nscc_training.measures import measure_files, measures_text

    scores = measure_files(**pair)
    text = json.dumps(scores, indent=2, allow_nan=False) + "\n"
    if out is not None:
        write_whole(out, text.encode())
    click.echo(text if as_json else measures_text(scores), nl=False)
