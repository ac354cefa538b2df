"""`nscc reconstruct` and `nscc classify`: decode a frame, or name its class."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import click

from nscc.files import refuse_same, write_together
from nscc.requirements import line_for
from nscc_cli.completion import RUN, RUN_OR_ANY
from nscc_cli.options import OUT, PATH, slots_axis_option, tone_option, trust_code_option
from nscc_cli.support import common_command, progress, say, say_done

if TYPE_CHECKING:
    from nscc_training.array_files import Axis
    from nscc_training.reconstruct_any import Method, Reconstruction

_dark_option = click.option(
    "--dark",
    type=PATH,
    metavar="DARK.npz",
    help="A frame file of the same program without light, with many "
    "repeats: it is subtracted from FRAME.",
)


@common_command("reconstruct")
@click.argument("run", type=RUN_OR_ANY, metavar="[any|RUN]")
@click.argument("frame", metavar="FRAME.npz", type=PATH, required=False)
@click.option(
    "-o",
    "out",
    required=True,
    metavar="OUT",
    type=OUT,
    help="The picture or clip: .npz .npy .mat, .hdr .exr .pfm .png, .gif .mp4, .tiff.",
)
@click.option("--png", type=OUT, help="Also write a picture of the result for the screen.")
@tone_option
@_dark_option
@click.option(
    "--as",
    "kind",
    type=click.Choice(("image", "video")),
    help="With any: reconstruct a picture or a clip. Default: a picture if all "
    "shutters open at the start of the frame (class b), else a clip.",
)
@click.option(
    "--method",
    type=click.Choice(("network", "merge", "gap-tv")),
    help="With any: the network (default), or without torch: merge neighbours of a "
    "picture, total variation (GAP-TV) of a clip.",
)
@click.option(
    "--program",
    type=PATH,
    metavar="FILE",
    help="With any: the program that exposed FRAME, for older files without shutters.",
)
@click.option(
    "--mask",
    type=PATH,
    metavar="MASK",
    help="With any and an own measurement: the file of its mask, if FRAME does not contain `mask`.",
)
@slots_axis_option
@click.option(
    "--noise",
    metavar="SD[,GAIN]",
    help="With any and an own measurement: the standard deviation of its "
    "readout, and the amount that one photon adds, in the unit of "
    "`meas` (default: none).",
)
@click.option(
    "--force",
    is_flag=True,
    help="With RUN: only warn if the frame belongs to another program or sensor.",
)
@trust_code_option
def command(
    run: str,
    frame: Path | None,
    out: Path,
    png: Path | None,
    tone: str | None,
    dark: Path | None,
    kind: Literal["image", "video"] | None,
    method: Method | None,
    program: Path | None,
    mask: Path | None,
    slots_axis: Axis | None,
    noise: str | None,
    force: bool,
    trust_code: bool,
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
    if frame is None and run == "any":
        raise click.UsageError("`nscc reconstruct any` needs FRAME.npz, which `nscc run` writes")
    if frame is None:
        from nscc_training.frame_reading import refuse_missing

        refuse_missing(Path(run))
        from nscc_training.reconstruct_any import is_measurement

        # A measurement of another camera belongs to no run: only `any` decodes it.
        if is_measurement(Path(run), mask):
            run, frame = "any", Path(run)
    if run != "any" and (kind or program or method):
        raise click.UsageError(
            "--as, --method and --program are for `nscc reconstruct any`: a run contains them"
        )
    if (method, kind) in (("merge", "video"), ("gap-tv", "image")):
        raise click.UsageError("--method merge makes pictures, gap-tv clips: leave --as out")
    if run != "any" and (mask or noise or slots_axis):
        raise click.UsageError("--mask, --slots-axis and --noise are for `nscc reconstruct any`")
    if run == "any" and frame is not None and force:
        raise click.UsageError("--force applies to runs: `any` accepts every frame")
    from nscc_runtime.formats import FORMATS, Content, check_ending, endings, file_of

    product_name = "a reconstruction"
    ending = check_ending(out, endings(), product_name)
    if png is not None:
        check_ending(png, (".png",), "a picture")
        refuse_same([out, png], "-o and --png")
    if frame is not None:
        from nscc_training.frame_reading import refuse_missing

        refuse_missing(frame)
    if frame is None:
        from nscc_runtime.frame_arrays import image_of
        from nscc_training.frame_reading import frame_arrays
        from nscc_training.reconstruct_any import overexposed

        image = image_of(Path(run))
        say([*overexposed(run, frame_arrays(Path(run)).saturated)])
        content = Content({"image": image}, image)
    elif run == "any":
        from nscc_training.reconstruct_any import reconstruct_any

        reconstruction = _of_measurement(
            frame, mask, slots_axis, noise, method, kind, program, dark
        ) or reconstruct_any(frame, program, kind, dark, method, progress)
        say(reconstruction.messages)
        _say_method(reconstruction, method)
        content = reconstruction.content
    else:
        from nscc_training.reconstruct import reconstruct

        reconstruction = reconstruct(
            Path(run), frame, force=force, dark=dark, trust_code=trust_code
        )
        say(reconstruction.messages)
        content = reconstruction.content
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


def _say_method(reconstruction: Reconstruction, method: Method | None) -> None:
    """Print which method replaced the network, and why. `method` is the value of --method, None if
    it was not given."""
    if reconstruction.reason:
        say_done(reconstruction.reason)
    elif method is None and reconstruction.method != "network":
        method_text = "neighbours were merged" if reconstruction.still else "GAP-TV found the clip"
        say_done(
            f"without torch {method_text} (method {reconstruction.method}); {line_for('torch')} "
            "installs the network"
        )


def _of_measurement(
    path: Path,
    mask: Path | None,
    slots_axis: Axis | None,
    noise: str | None,
    method: Method | None,
    *of_frames: object,
) -> Reconstruction | None:
    """Return the clip that is reconstructed from a measurement file of another camera. Return None
    if `path` is a frame file.

    `mask`, `slots_axis`, `noise` and `method` are values of options. `of_frames` are the values of
    options that only apply to frame files. Raises UsageError for options that do not apply to the
    file, and Rejected for an invalid measurement."""
    from nscc_training.reconstruct_any import (
        NoiseModel,
        is_measurement,
        read_measurement,
        reconstruct_measurement,
    )

    if not is_measurement(path, mask):
        if noise is not None or slots_axis is not None:
            raise click.UsageError(
                "--noise and --slots-axis apply to own measurements: a frame file contains its "
                "noise model and its shutters"
            )
        return None
    if any(of_frames):
        raise click.UsageError("--as, --program and --dark apply to frames of `nscc run`")
    if method == "merge":
        raise click.UsageError("--method merge makes pictures, but own measurements are clips")
    model = NoiseModel.parse(noise or "0")
    measurement = read_measurement(path, mask, slots_axis)
    say_done(f"measurement: {measurement.axes}\nnoise model: {model}")
    return reconstruct_measurement(measurement, model, method, progress)


@common_command("classify")
@click.argument("run", type=RUN, metavar="RUN")
@click.argument("frame", metavar="FRAME.npz", type=PATH)
@click.option("--json", "as_json", is_flag=True, help="Print the likelihoods as JSON.")
@_dark_option
@click.option(
    "--force", is_flag=True, help="Only warn if the frame belongs to another program or sensor."
)
@trust_code_option
def classify(
    run: Path, frame: Path, as_json: bool, dark: Path | None, force: bool, trust_code: bool
) -> None:
    """Name the class of FRAME, which `nscc run` wrote, with the likelihood of each class.

    RUN is the folder of a run that was trained with classes ([data] protocol = "class-v1")."""
    from nscc_training.frame_reading import refuse_missing
    from nscc_training.reconstruct import classify as classified

    refuse_missing(frame)
    classes, messages = classified(run, frame, force=force, dark=dark, trust_code=trust_code)
    say(messages)
    if as_json:
        import json

        click.echo(json.dumps(classes))
        return
    width = max(map(len, classes))
    for name, share in classes.items():
        click.echo(f"{name:{width}}  {share:6.1%}")
