"""`nscc run`: expose one frame of a scene with a program."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Any

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc_cli.link_options import link_options
from nscc_cli.programs import BuildChoice, build_options, load_program
from nscc_cli.scene_options import scene_options, sensor_options
from nscc_cli.support import CommonCommand, Product, done, progress, say, write_together

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from nscc.words.container import Container
    from nscc_cli.simulate import Simulated
    from nscc_runtime.effects import Selection
    from nscc_runtime.frame_file import Frame
    from nscc_runtime.light import Light

_MOST_REPEATS = 10000


@dataclass
class Timings:
    """Seconds spent in each part of a run."""

    seconds: dict[str, float] = field(default_factory=dict)

    @contextmanager
    def part(self, name: str) -> Iterator[None]:
        """Add the time of the block to `name`."""
        begin = perf_counter()
        try:
            yield
        finally:
            self.seconds[name] = self.seconds.get(name, 0.0) + perf_counter() - begin

    def json(self) -> bytes:
        """The file of --timings."""
        return (json.dumps(self.seconds, indent=2) + "\n").encode()


@click.command(name="run", cls=CommonCommand)
@click.argument("program", metavar="FILE.nsl|FILE.icw", type=click.Path(path_type=Path))
@click.option(
    "--scene",
    help="A file, a folder of pictures, or builtin:hdr, builtin:motion, builtin:flat:E, "
    "builtin:dark.",
)
@click.option(
    "-o",
    "out",
    type=click.Path(path_type=Path),
    help="The frame file (default: NAME.frame.npz in this folder).",
)
@click.option("--png", type=click.Path(path_type=Path), help="Also write a picture of the frame.")
@click.option(
    "--effects",
    help="Sensor effects: auto, all, none (the default), or names; +NAME forces one on, -NAME off.",
)
@click.option(
    "--seed", type=click.IntRange(0, 2**63 - 1), default=0, help="Seed of a frame's noise."
)
@click.option(
    "--device-seed", type=click.IntRange(0, 2**63 - 1), default=0, help="Seed of fixed patterns."
)
@click.option("--repeat", type=click.IntRange(1, _MOST_REPEATS), help="Expose K frames.")
@click.option("--keep", default="", help="Also keep, comma separated: light,truth,shutter,codes.")
@click.option("--pixels", type=click.Path(path_type=Path), help="The pixels' codes (.npz).")
@scene_options
@click.option(
    "--on",
    "place",
    default="emulator",
    show_default=True,
    metavar="emulator|PORT",
    help="Where to run: a serial port is a device's.",
)
@link_options
@click.option(
    "--fidelity",
    type=click.Choice(["planned", "reference"]),
    default="planned",
    help="reference: effects slot by slot, exactly (slow). planned: to a tolerance.",
)
@click.option(
    "--tolerance", metavar="5e|0.1lsb", help="RMS error that a plan may make (default: 5e)."
)
@click.option("--audit", is_flag=True, help="Compare with the reference; exit 1 if it broke.")
@click.option(
    "--plan", type=click.Path(path_type=Path), help="Use this plan; if there is none, write it."
)
@sensor_options
@click.option(
    "--timings", type=click.Path(path_type=Path), help="Write seconds spent, as JSON, to a file."
)
@build_options
def command(program: Path, **options: Any) -> None:
    """Expose one frame of a scene with a program, and write it as an .npz file.

    With --on PORT a chip exposes it, or `nscc device serve`, its stand-in.
    """
    if options["place"] != "emulator":
        from nscc_cli.on_device import run_on_device

        run_on_device(program, options, _parse_keep(options["keep"]))
        return
    from nscc_cli.simulate import Wanted, simulated

    wanted = Wanted.of(options)
    keep = _parse_keep(options["keep"])
    timings = Timings()
    with timings.part("compile_s"):
        container, messages = load_program(program, BuildChoice.of(options))
        container = with_pixels(container, program, options["pixels"])
    from nscc_runtime.sensor import load_sensor

    sensor = load_sensor(container.target, options["sensor"], options["sensor_set"])
    with timings.part("scene_s"):
        light = scene_light(container, options, messages)
    taken = simulated(container, light, sensor, wanted, timings)
    # Not NAME.npz: that may well be the program's own data.
    out = options["out"] or Path(program.stem + ".frame.npz")
    refuse_same(out, options["png"], options["timings"], options["plan"])
    with timings.part("write_s"):
        products = _products(container, light, taken, keep, out, options, program)
        if taken.plan_file is not None:
            products[options["plan"]] = taken.plan_file.encode()
        write_together(products)
    if options["timings"]:
        write_together({options["timings"]: timings.json()})
    if taken.table:
        done(taken.table + "\n")
    done(summary(container, taken.frame, [*products], wanted.effects))
    if taken.broken is not None:
        raise taken.broken


def refuse_same(*files: Path | None) -> None:
    """NS0745 where two products would be one file."""
    named = [file for file in files if file is not None]
    if len({file.absolute() for file in named}) < len(named):
        raise Rejected(
            Diagnostic(
                "NS0745",
                f"two products would be written to one file: {', '.join(map(str, named))}",
                helps=("give -o, --png, --timings and --plan different names",),
            ),
            status=2,
        )


def _parse_keep(text: str) -> tuple[str, ...]:
    from nscc_runtime.frame_file import KEEP

    names = tuple(name.strip() for name in text.split(",") if name.strip())
    for name in names:
        if name not in KEEP:
            from nscc.diagnostics.suggest import closest

            near = closest(name, KEEP)
            raise Rejected(
                Diagnostic(
                    "NS0739",
                    f"--keep cannot keep '{name[:60]}'",
                    notes=(f"it keeps, comma separated: {', '.join(KEEP)}",),
                    helps=(f"did you mean '{near}'?",) if near else (),
                ),
                status=2,
            )
    return names


def with_pixels(container: Container, program: Path, pixels: Path | None) -> Container:
    """The container with the codes of --pixels, or its own; NS0741 if there are none at all."""
    target = container.target
    if pixels is not None:
        from nscc.program.pixels import codes_from_file

        codes = codes_from_file(pixels, container.table, target.rows, target.cols)
        return replace(container, pixel_codes=codes)
    if container.pixel_codes is not None:
        return container
    fields = container.table.fields
    if not fields:
        import numpy as np

        one = np.zeros((target.rows, target.cols), np.int32)
        return replace(container, pixel_codes=one)
    arrays = ", ".join(f"{name}=..." for name in fields)
    raise Rejected(
        Diagnostic(
            "NS0741",
            f"'{program}' says nothing about its pixels' codes, so there is nothing to expose",
            notes=(f"its code has the fields: {', '.join(fields)}",),
            helps=(
                f"add a statement such as `pixels {fields[0]} = ...` to the program",
                f"or give codes with --pixels CODES.npz, written by np.savez('CODES.npz', "
                f"{arrays}), integers ({target.rows}, {target.cols})",
            ),
        ),
        status=2,
    )


def scene_light(
    container: Container, options: dict[str, Any], messages: tuple[Diagnostic, ...]
) -> Light:
    from nscc_runtime.scenes import load_scene, parse_crop, parse_exposure

    spec, exposure, crop = options["scene"], options["exposure"], options["crop"]
    if not spec:
        raise Rejected(
            Diagnostic(
                "NS0744",
                "no scene to expose: --scene is missing",
                helps=("try --scene builtin:hdr, or name a file or a folder of pictures",),
            ),
            status=2,
        )
    said = list(messages)
    light = load_scene(
        spec,
        slot_us=container.slot_us,
        rows=container.target.rows,
        cols=container.target.cols,
        exposure=None if exposure is None else parse_exposure(exposure),
        transfer=options["transfer"],
        fps=options["fps"],
        crop=None if crop is None else parse_crop(crop),
        frames_are=options["frames_are"],
        warn=said.append,
        progress=progress,
    )
    say(said)
    return light


def _products(
    container: Container,
    light: Light,
    taken: Simulated,
    keep: tuple[str, ...],
    out: Path,
    options: dict[str, Any],
    program: Path,
) -> dict[Path, Product]:
    """The files of this run, by path, each ready to be written."""
    from nscc_runtime import frame_file

    shutters = None
    if "shutter" in keep:
        shutters = replayed(container)
    kept, slots = frame_file.kept_arrays(container, light, keep, shutters)
    frame = taken.frame
    meta = frame_file.meta(container, light, frame, taken.origin)
    products: dict[Path, Product] = {
        out: frame_file.FrameFile(frame, meta, kept, slots, progress).write,
    }
    if options["png"]:
        from nscc_runtime.pictures.frames import frame_sheet, readouts
        from nscc_runtime.pictures.sheet import png_of

        first = frame.frame[0] if options["repeat"] else frame.frame
        title = f"{program.name}  ·  {options['scene'].rstrip('/').rsplit('/', 1)[-1]}"
        products[options["png"]] = png_of(frame_sheet, readouts(container, first), title)
    return products


def replayed(container: Container) -> NDArray[np.bool_]:
    """What the words open (shutters, buckets, N); NS0442 where light counts half or twice."""
    from nscc.prove.replay import shutters
    from nscc.words.legality import decoded

    found = shutters(container, decoded(container))
    if found is None:
        raise Rejected(
            Diagnostic(
                "NS0442",
                "the words of this program open no shutters: some slot's light counts neither once "
                "nor not at all",
                helps=("`nscc prove` says what they do; leave shutter out of --keep",),
            )
        )
    return found


def summary(container: Container, frame: Frame, files: list[Path], chosen: Selection) -> str:
    """A line a bucket, of the first frame, and a line a file."""
    top = 2**container.target.adc_bits - 1
    width = max(len(name) for name in container.buckets)
    repeats = len(frame.frame) if frame.frame.ndim == 4 else 0
    lines = []
    for b, name in enumerate(container.buckets):
        place = (0, b) if repeats else (b,)
        codes, valid = frame.frame[place], frame.valid[place]
        values = frame.exposure_e[place][valid]
        invalid = valid.size - values.size
        full = int((codes == top).sum())
        text = f"{name:<{width}}  {full} of {codes.size} pixels saturated"
        if values.size:
            text += (
                f", electrons {values.min():.6g} to {values.max():.6g}, mean {values.mean():.6g}"
            )
        lines.append(text + (f", {invalid} invalid" if invalid else ""))
    if repeats:
        alike = "all alike: there are no effects" if chosen.noiseless else "the first is described"
        lines.append(f"{repeats} frames, {alike}")
    lines += [f"wrote {path}" for path in files]
    return "\n".join(lines)
