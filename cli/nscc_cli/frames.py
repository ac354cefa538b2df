"""Shared code of commands that expose frames: scene, sensor, arrays to keep, and output files."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from nscc.diagnostics.diagnostic import rejected, unknown_name
from nscc.files import Product, refuse_inputs, refuse_same, write_together
from nscc.mappings import NamedValues
from nscc_cli.options import values_given
from nscc_cli.support import progress, refuse_ignored

if TYPE_CHECKING:
    from nscc.chips.target import Target
    from nscc.words.container import Container
    from nscc_runtime.formats import Content
    from nscc_runtime.frame_file import Frame
    from nscc_runtime.light import Light
    from nscc_runtime.response import Response
    from nscc_runtime.scenes import Scene
    from nscc_runtime.sensor import Sensor
    from nscc_runtime.timings import Timings
    from nscc_training.run_files import RunCapture


def scene_of(
    options: Mapping[str, Any], missing: str = "--scene is missing: there is no light to expose"
) -> Scene:
    """Return the scene that the options of a command describe. Raise Rejected (NS0744, with the
    message `missing`) without `--scene`. Files are not read yet."""
    from nscc_runtime.scenes import Scene

    if not options["scene"]:
        raise rejected(
            "NS0744",
            missing,
            helps=("try --scene builtin:hdr, or name a file or a folder of pictures",),
        )
    return Scene(**values_given(Scene, options))


def refuse_swapped(program: Path, scene: str | None) -> None:
    """Raise Rejected (NS0780) if the name `scene` ends in .nsl or .icw: the user has probably
    swapped program and scene. None is no scene."""
    if scene is None or not scene.lower().endswith((".nsl", ".icw")):
        return
    if program.suffix.lower() in (".nsl", ".icw"):
        message, help_text = (
            f"--scene '{scene}' is a program, not a scene",
            "name a file of light: a picture, a clip, an array, or builtin:hdr",
        )
    else:
        message = f"the program and the scene are swapped: '{program}' and --scene '{scene}'"
        help_text = f"write `nscc run {shlex.quote(scene)} --scene {shlex.quote(str(program))}`"
    raise rejected("NS0780", message, helps=(help_text,))


def sensor_of(target: Target, options: Mapping[str, Any]) -> Sensor:
    """Return the sensor of the chip `target`, changed by the file of the option --sensor and then
    by the changes of --sensor-set. Raises Rejected for invalid values."""
    from nscc_runtime.sensor import load_sensor

    return load_sensor(target, options["sensor"], options["sensor_set"])


def run_capture_of(
    like: Path | None, options: NamedValues, program: Path | None = None
) -> RunCapture | None:
    """Return the conditions under which the decoder of the run `like` expects frames; None without
    a run.

    `like` is a run folder or the name of a run that comes with nscc. Where `options` lack a value
    (exposure, transfer, sensor, chip), the run's is put into them. The chip is not for a `program`
    that is compiled already."""
    if like is None:
        return None
    from nscc.containers import is_compiled
    from nscc_training.run_files import run_capture

    run_settings = run_capture(like)
    theirs = {
        "exposure": run_settings.exposure_of(str(options["scene"])),
        "transfer": run_settings.transfer,
        "sensor": run_settings.sensor,
    }
    options |= {name: value for name, value in theirs.items() if options[name] is None}
    has_chip = program is not None and is_compiled(program)
    if options["target"] is None and run_settings.target is not None and not has_chip:
        options["target"] = str(run_settings.target)
    return run_settings


def parse_keep(text: str) -> tuple[str, ...]:
    """Return the names in `text`, the value of `--keep`, which commas separate; empty ones are
    ignored. Raise Rejected (NS0739) for an unknown name."""
    from nscc_runtime.frame_file import KEEP

    names = tuple(name.strip() for name in text.split(",") if name.strip())
    for name in names:
        if name not in KEEP:
            raise unknown_name(
                "NS0739",
                "unknown name '{}' for --keep",
                name,
                KEEP,
                "--keep takes a comma-separated list of: {}",
            )
    return names


def frame_path(program: Path, options: Mapping[str, Any]) -> Path:
    """Return the path of the frame file, for the `options` of a command by name: the option -o, or
    PROGRAM.frame.npz in the current folder.

    Raises Rejected if two outputs have one path (NS0745), if an output would replace an input
    (NS0785), or if an ending is unknown (NS0786)."""
    from nscc_runtime.formats import check_ending, endings

    out: Path = options["out"] or Path(program.stem + ".frame.npz")
    named = [out, *(options[name] for name in ("png", "timings", "plan") if options[name])]
    check_ending(out, endings(), "a frame")
    in_colour = options["color"] and options["png"]
    if out.suffix.lower() not in (".png", ".gif", ".mp4") and not in_colour:
        refuse_ignored("-o does not end in .png, .gif or .mp4", "tone")
    if options["png"]:
        check_ending(options["png"], (".png",), "a picture")
    refuse_inputs(*(path for path in named if path != options["plan"]))
    refuse_same(named, "-o, --png, --timings and --plan")
    return out


class ExposedFrame(NamedTuple):
    """A frame, or repeated frames, with what is written beside them: the `container` that was
    exposed, its `light` (None on a device), the `meta` of the frame file, the `title` above the
    picture, and a function that computes the sensor `response` for the picture."""

    container: Container
    light: Light | None
    frame: Frame
    meta: Mapping[str, Any]
    title: str
    response: Callable[[], Response]


def write_frame(
    out: Path,
    options: Mapping[str, Any],
    keep: Sequence[str],
    exposed: ExposedFrame,
    timings: Timings,
    plan: str | None = None,
) -> list[Path]:
    """Write the frame file `out`, and the picture, plan and timings that the options name. Return
    the paths, without that of the timings.

    `keep` names the arrays of the value of `--keep`. `plan` is the text of the plan's file.
    `timings` receives the time of writing."""
    from nscc.container_proof import replayed
    from nscc_runtime.formats import file_of
    from nscc_runtime.formats.content import frame_content
    from nscc_runtime.frame_file import FrameFile
    from nscc_runtime.response import with_decode_arrays

    container, light, frame, meta, *_ = exposed
    with timings.measure("write_s"):
        shutters = replayed(container) if "shutter" in keep else None
        file = FrameFile.of(container, light, frame, meta, keep, shutters, progress)
        # For a name in .npz, `file_of` returns the `write` of the frame file.
        content = frame_content(
            with_decode_arrays(file, container),
            container,
            light,
            lambda: replayed(container),
            options["tone"],
        )
        products: dict[Path, Product] = {out: file_of(out, content, "a frame")}
        if options["png"]:
            products[options["png"]] = _picture(exposed, content)
        if plan is not None:
            products[options["plan"]] = plan.encode()
        write_together(products)
    if options["timings"]:
        write_together({options["timings"]: timings.json()})
    return [*products]


def _picture(exposed: ExposedFrame, content: Content) -> Product:
    """Return the PNG for `--png`: the light of a capture in colours, else a sheet of readouts and
    light. Of repeated frames it shows the first. `content` is what the frame's file contains."""
    from nscc_runtime.formats.content import content_sheet
    from nscc_runtime.pictures.sheet import png_of
    from nscc_runtime.run_kinds import KINDS

    if content.colour and content.light is not None:
        return png_of(content_sheet, content, exposed.title)
    container, _, frame, _, title, response = exposed
    return png_of(KINDS.of(container).frame_sheet, container, frame.first, response, title)


def summary(
    container: Container, frame: Frame, files: Sequence[Path], *, alike: bool, colours: bool = False
) -> str:
    """Return the text that describes each bucket of the first frame, and names each of `files`, the
    files that were written.

    `alike` says that all frames are identical, `colours` that the frames are those of red, green
    and blue light."""
    from nscc_runtime.run_messages import frame_lines

    lines = frame_lines(container, frame)
    if frame.frame.ndim == 4:  # several frames: (frames, buckets, rows, cols)
        frames_text = (
            "all identical, because no effects are simulated" if alike else "the first is described"
        )
        if colours:
            frames_text = "of red, green and blue light; the red one is described"
        lines.append(f"{len(frame.frame)} frames, {frames_text}")
    return "\n".join([*lines, *(f"wrote {path}" for path in files)])
