"""`nscc reconstruct` and `nscc classify`: decode a frame, or name its class."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc.files import refuse_same, write_together
from nscc.requirements import line_for
from nscc_cli.completion import RUN, RUN_OR_ANY
from nscc_cli.options import (
    OUT,
    PATH,
    declared,
    json_option,
    out_option,
    settings_from,
    tone_option,
)
from nscc_cli.support import common_command, progress, say, say_done
from nscc_training.command_settings import ReconstructSettings

if TYPE_CHECKING:
    from nscc_runtime.formats import Content
    from nscc_training.reconstruct_any import Reconstruction


@common_command("reconstruct")
@click.argument("run", type=RUN_OR_ANY, metavar="[any|RUN]")
@click.argument("frame", metavar="FRAME.npz", type=PATH, required=False)
@out_option(
    "The picture or clip: .npz .npy .mat, .hdr .exr .pfm .png, .gif .mp4, .tiff.",
    "OUT",
    required=True,
)
@click.option("--png", type=OUT, help="Also write a picture of the result for the screen.")
@tone_option
@declared(ReconstructSettings)
def command(
    run: str, frame: Path | None, out: Path, png: Path | None, tone: str | None, **options: Any
) -> None:
    """Reconstruct a picture or a clip from FRAME, a file that `nscc run` wrote.

    The first argument names the decoder. `any` decodes frames of every program and needs no
    training (write ./any for a folder with that name). RUN is a run folder, whose decoder accepts
    only the shutters of RUN/shutter.nsl, or a run that comes with nscc: hdr, clip. Frames whose
    pixels looked at their light contain the open time of each pixel and need no RUN.

    `any` also decodes measurements of other cameras, in .mat, .npz or .npy files: `meas` (rows,
    cols) or (rows, cols, K) and `mask` (rows, cols, slots) or (slots, rows, cols), with values
    from 0 to 1. The result has the unit of `meas` per slot.

    An .npz output contains `image` (rows, cols) in electrons over the frame, or `video` (T, rows,
    cols) in electrons per slot. These are the units of `truth_e` in frame files."""
    how = settings_from(ReconstructSettings, options)
    if frame is None and run == "any":
        raise click.UsageError("`nscc reconstruct any` needs FRAME.npz, which `nscc run` writes")
    from nscc_training.frame_reading import frame_arrays, refuse_missing

    if frame is None:
        refuse_missing(Path(run))
        from nscc_training.reconstruct_any import is_measurement

        # A measurement of another camera belongs to no run: only `any` decodes it.
        if is_measurement(Path(run), how.mask):
            run, frame = "any", Path(run)
    if run != "any" and (how.kind or how.program or how.method):
        raise click.UsageError(
            "--as, --method and --program are for `nscc reconstruct any`: a run contains them"
        )
    if (how.method, how.kind) in (("merge", "video"), ("gap-tv", "image")):
        raise click.UsageError("--method merge makes pictures, gap-tv clips: leave --as out")
    if run != "any" and (how.mask or how.noise or how.slots_axis):
        raise click.UsageError("--mask, --slots-axis and --noise are for `nscc reconstruct any`")
    if run == "any" and frame is not None and how.force:
        raise click.UsageError("--force applies to runs: `any` accepts every frame")
    from nscc_runtime.formats import FORMATS, Content, check_ending, endings, file_of

    product_name = "a reconstruction"
    ending = check_ending(out, endings(), product_name)
    if png is not None:
        check_ending(png, (".png",), "a picture")
        refuse_same([out, png], "-o and --png")
    if frame is None:
        from nscc_runtime.frame_arrays import image_of
        from nscc_training.reconstruct_any import overexposed

        image = image_of(Path(run))
        say([*overexposed(run, frame_arrays(Path(run)).saturated)])
        content = Content({"image": image}, image)
    else:
        refuse_missing(frame)
        content = _of_frame(run, frame, how)
    content = replace(content, tone=tone)
    named = Path(run).name
    title = named if frame is None else f"{frame.name}  ·  {named}"
    products = {out: file_of(out, content, product_name)}
    if png is not None:
        from nscc_runtime.formats.content import content_sheet
        from nscc_runtime.pictures.sheet import png_of

        products[png] = png_of(content_sheet, content, title)
    write_together(products)
    say_done("\n".join(f"wrote {path.as_posix()}" for path in products))
    if png is not None or FORMATS[ending].shown:
        say_done(f"shown with the {content.tone_text}")


def _of_frame(run: str, frame: Path, how: ReconstructSettings) -> Content:
    """Return what the decoder of a run, or "any", reconstructs from `frame`, after printing which
    method replaced the network, and why."""
    from nscc_training.reconstruct_any import reconstruct_any

    if run == "any":
        reconstruction = _of_measurement(frame, how) or reconstruct_any(
            frame, how.program, how.kind, how.dark, how.method, progress
        )
    else:
        from nscc_training.reconstruct import reconstruct

        reconstruction = reconstruct(
            Path(run), frame, force=how.force, dark=how.dark, trust_code=how.trust_code
        )
    say(reconstruction.messages)
    if reconstruction.reason:
        say_done(reconstruction.reason)
    elif how.method is None and reconstruction.method in ("merge", "gap-tv"):
        found = "neighbours were merged" if reconstruction.still else "GAP-TV found the clip"
        say_done(
            f"without torch {found} (method {reconstruction.method}); {line_for('torch')} "
            "installs the network"
        )
    return reconstruction.content


def _of_measurement(path: Path, how: ReconstructSettings) -> Reconstruction | None:
    """Return the clip that is reconstructed from a measurement file of another camera; None if
    `path` is a frame file. `how` has the options of the command.

    Raises UsageError for options that do not apply to such a file."""
    from nscc_training.reconstruct_any import (
        NoiseModel,
        is_measurement,
        read_measurement,
        reconstruct_measurement,
    )

    if not is_measurement(path, how.mask):
        if how.noise is not None or how.slots_axis is not None:
            raise click.UsageError(
                "--noise and --slots-axis apply to own measurements: a frame file contains its "
                "noise model and its shutters"
            )
        return None
    if how.kind or how.program or how.dark:
        raise click.UsageError("--as, --program and --dark apply to frames of `nscc run`")
    if how.method == "merge":
        raise click.UsageError("--method merge makes pictures, but own measurements are clips")
    model = NoiseModel.parse(how.noise or "0")
    measurement = read_measurement(path, how.mask, how.slots_axis)
    say_done(f"measurement: {measurement.axes}\nnoise model: {model}")
    return reconstruct_measurement(measurement, model, how.method, progress)


@common_command("classify")
@click.argument("run", type=RUN, metavar="RUN")
@click.argument("frame", metavar="FRAME.npz", type=PATH)
@json_option("Print the likelihoods as JSON.")
@declared(ReconstructSettings, "dark", "force", "trust_code")
def classify(run: Path, frame: Path, as_json: bool, **options: Any) -> None:
    """Name the class of FRAME, which `nscc run` wrote, with the likelihood of each class.

    RUN is the folder of a run that was trained with classes ([data] protocol = "class-v1")."""
    from nscc_training.frame_reading import refuse_missing
    from nscc_training.reconstruct import classify as classified

    refuse_missing(frame)
    how = settings_from(ReconstructSettings, options)
    classes, messages = classified(
        run, frame, force=how.force, dark=how.dark, trust_code=how.trust_code
    )
    say(messages)
    if as_json:
        import json

        click.echo(json.dumps(classes))
        return
    width = max(map(len, classes))
    for name, share in classes.items():
        click.echo(f"{name:{width}}  {share:6.1%}")
