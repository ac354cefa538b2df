"""`nscc evaluate`: scores under a protocol, and comparisons of them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc.files import Product, write_together
from nscc_cli.completion import EFFECTS, PROTOCOL, RUN_OR_ANY
from nscc_cli.options import OUT, PATH, together, trust_code_option
from nscc_cli.support import (
    CommonCommand,
    NumberRange,
    Subcommands,
    progress,
    say_compiling,
    say_done,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray


class _Evaluations(Subcommands):
    """The subcommands of `nscc evaluate`; any other name is passed to `evaluate of`."""

    def resolve_unknown(
        self, name: str, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """`nscc evaluate of` such a name."""
        return "of", self.commands["of"], args


@click.group("evaluate", cls=_Evaluations)
def command() -> None:
    """Score reconstructions under a frozen protocol, whose digest stands beside every number.

    `nscc evaluate NAME --data DIR --protocol P` is short for `nscc evaluate of NAME ..`.
    """


_outputs = together(
    click.option("--json", "as_json", is_flag=True, help="Print the result as JSON."),
    click.option("-o", "out", type=OUT, help="Write it to a file."),
)
_save_option = click.option("--save", type=OUT, metavar="DIR",
              help="Write reconstructions and truth into this folder.")  # fmt: skip


@command.command("sci8", cls=CommonCommand)
@click.argument("clips", metavar="CLIP.mat...", nargs=-1, required=True, type=PATH)
@click.option("--method", default="gap-tv", show_default=True, metavar="M",
              help="any, the decoder for any code; gap-tv, admm-tv, dictionary, adjoint; or an "
                   "oracle: bilinear, thin-out.")  # fmt: skip
@click.option("--iterations", type=click.IntRange(1, 10000), default=40, show_default=True)
@click.option("--weight", type=NumberRange(0, 10, min_open=True), default=0.1,
              show_default=True, help="Of total variation, for values on [0, 1].")  # fmt: skip
@_save_option
@_outputs
def sci8(
    clips: tuple[Path, ...], method: str, iterations: int, weight: float, **outputs: Any
) -> None:
    """The benchmark of snapshot compressive imaging: eight frames from one measurement.

    The yardsticks see the truth, not the measurement, and say so in the result ("sees").
    """
    from nscc_training.baselines.tv_loop import denoise
    from nscc_training.evaluation.baselines import evaluate_sci8

    names = [path.name for path in clips]
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise click.UsageError(
            f"a clip may be given only once, because results identify it by its name: {twice[0]}"
        )
    if method.endswith("-tv"):
        say_compiling(denoise, "the loop of total variation")
    _of_scenes(*evaluate_sci8(list(clips), method, iterations, weight), **outputs)


@command.command("of", cls=CommonCommand)
@click.argument("subject", type=RUN_OR_ANY, metavar="RUN|BASELINE")
@click.option("--data", type=PATH, metavar="DIR",
              help="The folder of scenes; for class-v1 also `procedural`.")  # fmt: skip
@click.option("--protocol", type=PROTOCOL, metavar="P",
              help="hdr-v1, video-v1, sci8, deblur-v1, two-bucket-v1, staggered-v1, "
              "codes-v1, class-v1.")  # fmt: skip
@click.option("--split", type=click.Choice(["val"]), metavar="val",
              help="Instead of --data and --protocol: the run's validation scenes, evaluated as "
                   "in its metrics.csv.")  # fmt: skip
@click.option(
    "--seed", type=click.IntRange(0, 2**31), default=0, help="Seed of random codes and noise."
)
@click.option("--skip-seen", is_flag=True,
              help="Leave out files that the run was trained or validated on.")  # fmt: skip
@click.option("--shutter", default="", metavar="CLASS[:START]",
              help="The codes of a baseline: c, c:quad, d:random, ... for clips, "
                   "b:quad, b:random for stills, or those of a run; a class alone "
                   "uses random codes.")  # fmt: skip
@click.option("--effects", type=EFFECTS, default="", metavar="E",
              help="Expose with an emulated chip instead of the protocol's sensor: auto, all, "
                   "or names, as in nscc run. For runs and pixels that look.")  # fmt: skip
@trust_code_option
@_save_option
@_outputs
def of(
    subject: str, data: Path | None, protocol: str | None, split: str | None, seed: int,
    skip_seen: bool, shutter: str, effects: str, trust_code: bool, **outputs: Any,
) -> None:  # fmt: skip
    """Score a run folder of `nscc train`, or a baseline, on a folder of scenes.

    A run that has seen one of the files is refused, unless these are skipped. Baselines of hdr-v1:
    ldr (always open), best-uniform (the single stop that is best in hindsight, in linear PSNR),
    best-uniform-mu (the same in mu-law PSNR), quad (2 x 2 geometric exposures), random, all decoded
    by merging neighbours; sparse-coding (random, by convolutional sparse coding); any (quad, by the
    decoder for any code); looks-2, looks-5, looks-9 (pixels that close at the first look above a
    level, without a decoder); designed-2, designed-5 (looks and levels made for each
    crop). Of video-v1: any, gap-tv, admm-tv, dictionary, adjoint on random bits, and the yardsticks
    bilinear and thin-out. With --shutter, those that take codes of any class are scored on others.
    Of deblur-v1: long, short, any. Of two-bucket-v1: flutter, pixel-wise, two-bucket. Of
    staggered-v1: aligned, staggered, staggered-alone. Of codes-v1: any. class-v1 scores runs that
    name classes.
    """
    if (split is None) == (data is None or protocol is None) or (split and (data or protocol)):
        raise click.UsageError("name --data and --protocol, or else --split val")
    if data is None or protocol is None:
        from nscc_training.evaluation.runs import evaluate_validation
        from nscc_training.run_folder import load_run

        folder = load_run(Path(subject), trust_code=trust_code)
        return _of_scenes(*evaluate_validation(folder), **outputs)
    from nscc_training.evaluation.subjects import evaluate

    evaluation = evaluate(
        subject, data, protocol, seed, codes=shutter, effects=effects, skip_seen=skip_seen,
        trust_code=trust_code,
    )  # fmt: skip
    _of_scenes(*evaluation, **outputs)


@command.command("looks", cls=CommonCommand)
@click.option("--data", required=True, type=PATH, metavar="DIR",
              help="The folder of panoramas.")  # fmt: skip
@click.option("--results", required=True, type=OUT, metavar="DIR",
              help="The folder that stores each row as soon as it is complete; existing rows "
                   "are not computed again.")  # fmt: skip
@click.option("--seed", type=click.IntRange(0, 2**31), default=0, help="Of noise.")
@_outputs
def looks(data: Path, results: Path, seed: int, **outputs: Any) -> None:
    """The rows of hdr-v1 whose pixels look, under all conditions, as a table in Markdown.

    looks-2, looks-5, looks-9 and rows that are designed for each crop: with the protocol's noise,
    at 10 and 50 % of saturated pixels, with all effects of the sensor, and with comparators of 1, 2
    and 4 % of noise and offset.
    """
    from nscc_training.sweep.looks_table import looks_table

    rows, text = looks_table(data, results, seed, progress)
    _finish(rows, text, {}, **outputs)


@command.command("tables", cls=CommonCommand)
@click.option("--results", type=PATH, metavar="DIR",
              help="The results of a sweep, DIR/results or DIR (default: those that come with "
              "nscc).")  # fmt: skip
@click.option("--template", type=PATH, metavar="PAGE.md",
              help="Another page than the paper's tables, with the same placeholders.")  # fmt: skip
@_outputs
def tables(results: Path | None, template: Path | None, **outputs: Any) -> None:
    """The paper's Tables 2, 3 and 4 in Markdown: its rows and ours, what was measured here beside
    them.

    Runs and baselines are evaluated by `nscc sweep`. Rows that were not run say so.
    """
    from nscc_training.evaluation.pages import page_of

    try:
        rows, text = page_of(results, template)
    except ValueError as error:
        raise click.UsageError(f"{template}: {error}") from error
    _finish(rows, text, {}, **outputs)


@command.command("figures", cls=CommonCommand)
@click.option("--data", type=PATH, metavar="DIR",
              help="Panoramas and clips, or folders hdr and video of them (default: built-in "
                   "scenes).")  # fmt: skip
@click.option("--effects", type=EFFECTS, default="auto", show_default=True, metavar="E",
              help="Effects of the emulated chip: auto, all, or names, as in nscc "
                   "run.")  # fmt: skip
@click.option(
    "--seed", type=click.IntRange(0, 2**31), default=0, help="Seed of random codes and noise."
)
@click.option("-o", "out", type=OUT, required=True, metavar="DIR",
              help="The folder for the pictures.")  # fmt: skip
def figures(data: Path | None, effects: str, seed: int, out: Path) -> None:
    """The pictures of the paper's Figs. 3, 5, 6, 7 and 8, from the runs that come with nscc.

    A coded frame and what is decoded of it, several frames from one, the shutters as mosaics, a
    still at low and at high exposure, and by several tone curves; beside the truth and pixels that
    are always open.
    """
    from nscc_training.evaluation.figures import figures as drawn

    drawings = drawn(data, effects, seed)
    out.mkdir(parents=True, exist_ok=True)
    files = {out / name: png for name, png in drawings.items()}
    write_together(files)
    say_done("\n".join(f"wrote {path.as_posix()}" for path in files))


@command.command("compare", cls=CommonCommand)
@click.argument("results", metavar="A.json B.json [A.json B.json ...]", nargs=-1, required=True,
                type=PATH)  # fmt: skip
@click.option("--metric", default="psnr_db", show_default=True, metavar="NAME_db",
              help="The metric to compare; hdr-v1 also has mu_psnr_db.")  # fmt: skip
@_outputs
def compare(results: tuple[Path, ...], metric: str, **outputs: Any) -> None:
    """How much better B is than A, in pairs: the same items of the same scenes.

    More pairs are more seeds of the same two: the interval is over scenes, with all seeds.
    """
    if len(results) % 2:
        raise click.UsageError("results are compared in pairs: A.json B.json, for each seed")
    from nscc_training.evaluation.result_text import comparison_text
    from nscc_training.evaluation.results import compare as compared
    from nscc_training.evaluation.results import read_result

    read = [read_result(path) for path in results]
    comparison = compared(list(zip(read[::2], read[1::2], strict=True)), metric)
    _finish(comparison, comparison_text(comparison, metric) + "\n", {}, **outputs)


def _of_scenes(
    evaluation: dict[str, Any], arrays: dict[str, NDArray[Any]], save: Path | None, **outputs: Any
) -> None:
    """Write and print what was scored."""
    from nscc_training.evaluation.result_text import arrays_in, result_text

    products = {} if save is None else arrays_in(save, arrays)
    _finish(evaluation, result_text(evaluation), products, **outputs)


def _finish(
    result: Any, human: str, products: Mapping[Path, Product], as_json: bool, out: Path | None
) -> None:
    """Write and print a result."""
    from nscc_training.evaluation.result_text import result_json

    text = result_json(result)
    write_together({**({out: text.encode()} if out else {}), **products})
    click.echo(text if as_json else human, nl=False)
