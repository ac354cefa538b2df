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

from nscc.cli.programs import BuildChoice, build_options, load_program
from nscc.cli.support import CommonCommand, Product, done, progress, say, write_together
from nscc.diagnostics.model import Diagnostic, Rejected

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from nscc.words.container import Container
    from nscc_runtime.frame_file import Frame
    from nscc_runtime.light import Light

_UNBUILT = ("tolerance", "audit", "plan", "sensor", "sensor_set")
"""Options of the sensor model, which this version does not have."""
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
@click.option("--effects", default="none", help="Sensor effects; this version has: none.")
@click.option(
    "--seed", type=click.IntRange(0, 2**63 - 1), default=0, help="Seed of a frame's noise."
)
@click.option(
    "--device-seed", type=click.IntRange(0, 2**63 - 1), default=0, help="Seed of fixed patterns."
)
@click.option("--repeat", type=click.IntRange(1, _MOST_REPEATS), help="Expose K frames.")
@click.option("--keep", default="", help="Also keep, comma separated: light,truth,shutter,codes.")
@click.option("--pixels", type=click.Path(path_type=Path), help="The pixels' codes (.npz).")
@click.option("--exposure", metavar="E[@P]", help="Electrons over the frame at percentile P (99).")
@click.option("--transfer", type=click.Choice(["linear", "srgb"]), help="The scene's curve.")
@click.option("--fps", type=float, help="The clip's frames a second, seen in the slots' own time.")
@click.option("--crop", metavar="R,C", help="Top left corner of the array in the scene.")
@click.option(
    "--frames-are",
    type=click.Choice(["integrals", "samples"]),
    default="integrals",
    help="Whether a clip's frames hold all the light of their time, or an instant of it.",
)
@click.option("--on", "place", default="emulator", help="Where to run: emulator.")
@click.option(
    "--fidelity",
    type=click.Choice(["planned", "reference"]),
    default="planned",
    help="The same without effects.",
)
@click.option("--tolerance", hidden=True)
@click.option("--audit", is_flag=True, default=None, hidden=True)
@click.option("--plan", hidden=True)
@click.option("--sensor", hidden=True)
@click.option("--sensor-set", multiple=True, hidden=True)
@click.option(
    "--timings", type=click.Path(path_type=Path), help="Write seconds spent, as JSON, to a file."
)
@build_options
def command(program: Path, **options: Any) -> None:
    """Expose one frame of a scene with a program, and write it as an .npz file."""
    _refuse_unbuilt(options)
    keep = _parse_keep(options["keep"])
    timings = Timings()
    with timings.part("compile_s"):
        container, messages = load_program(program, BuildChoice.of(options))
        container = _with_pixels(container, program, options["pixels"])
    with timings.part("scene_s"):
        light = _scene(container, options, messages)
    with timings.part("expose_s"):
        from nscc_runtime.emulator import expose
        from nscc_runtime.emulator.compiled import is_compiled
        from nscc_runtime.frame_file import read_out

        if not is_compiled():
            done("compiling the emulator's loops for this processor: once, some seconds")
        exposure = expose(container, light, device_seed=options["device_seed"])
        frame = read_out(exposure, container.target)
    # Not NAME.npz: that may well be the program's own data.
    out = options["out"] or Path(program.stem + ".frame.npz")
    _refuse_same(out, options["png"], options["timings"])
    with timings.part("write_s"):
        products = _products(container, light, frame, keep, out, options, program)
        write_together(products)
    if options["timings"]:
        text = json.dumps(timings.seconds, indent=2) + "\n"
        write_together({options["timings"]: text.encode()})
    done(_summary(container, frame, [*products], options))


def _refuse_unbuilt(options: dict[str, Any]) -> None:
    """NS0750 for what the contract names and this version lacks."""
    for name in _UNBUILT:
        if options[name]:
            option = "--" + name.replace("_", "-")
            raise _not_here(f"{option} belongs to the sensor model", f"leave {option} out")
    if options["effects"] != "none":
        raise _not_here(
            f"--effects {options['effects'][:60]} needs the sensor model",
            "use --effects none (the default): words are executed exactly, without noise",
        )
    if options["place"] != "emulator":
        raise _not_here(
            f"--on {options['place'][:60]} needs the link to a device",
            "use --on emulator (the default)",
        )


def _refuse_same(*files: Path | None) -> None:
    """NS0745 where two products would be one file."""
    named = [file for file in files if file is not None]
    if len({file.absolute() for file in named}) < len(named):
        raise Rejected(
            Diagnostic(
                "NS0745",
                f"two products would be written to one file: {', '.join(map(str, named))}",
                helps=("give -o, --png and --timings different names",),
            ),
            status=2,
        )


def _not_here(what: str, instead: str) -> Rejected:
    return Rejected(
        Diagnostic("NS0750", f"{what}, which this version of nscc does not have", helps=(instead,)),
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


def _with_pixels(container: Container, program: Path, pixels: Path | None) -> Container:
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


def _scene(
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
    frame: Frame,
    keep: tuple[str, ...],
    out: Path,
    options: dict[str, Any],
    program: Path,
) -> dict[Path, Product]:
    """The files of this run, by path, each ready to be written."""
    from nscc.words.file import to_bytes
    from nscc_runtime import frame_file

    origin = frame_file.Provenance(
        to_bytes(container), options["seed"], options["device_seed"], options["fidelity"]
    )
    shutters = None
    if "shutter" in keep:
        shutters = _replayed(container)
    kept, slots = frame_file.kept_arrays(container, light, keep, shutters)
    whole = frame_file.repeated(frame, options["repeat"]) if options["repeat"] else frame
    meta = frame_file.meta(container, light, whole, origin)
    products: dict[Path, Product] = {
        out: frame_file.FrameFile(whole, meta, kept, slots, progress).write,
    }
    if options["png"]:
        from nscc_runtime.pictures import frame_png, readouts

        title = f"{program.name}  ·  {options['scene'].rstrip('/').rsplit('/', 1)[-1]}"
        products[options["png"]] = frame_png(readouts(container, frame.frame), title)
    return products


def _replayed(container: Container) -> NDArray[np.bool_]:
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


def _summary(container: Container, frame: Frame, files: list[Path], options: dict[str, Any]) -> str:
    """A line a bucket and a line a file."""
    top = 2**container.target.adc_bits - 1
    width = max(len(name) for name in container.buckets)
    lines = []
    for b, name in enumerate(container.buckets):
        values = frame.exposure_e[b][frame.valid[b]]
        invalid = frame.valid[b].size - values.size
        full = int((frame.frame[b] == top).sum())
        text = f"{name:<{width}}  {full} of {frame.frame[b].size} pixels saturated"
        if values.size:
            text += (
                f", electrons {values.min():.6g} to {values.max():.6g}, mean {values.mean():.6g}"
            )
        lines.append(text + (f", {invalid} invalid" if invalid else ""))
    if options["repeat"]:
        lines.append(f"{options['repeat']} frames, all alike: there are no effects")
    lines += [f"wrote {path}" for path in files]
    return "\n".join(lines)
