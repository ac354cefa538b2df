"""Expose a picture of any size on one chip: piece by piece and colour by colour, then join the
frames.

Parts of a picture with images and planes overlap by the reach of the program. Outside the margin,
the joined images and planes are those of a chip whose array has the size of the picture. Reports
refer to the joined planes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice

import numpy as np

from nscc.diagnostics.diagnostic import rejected
from nscc.mappings import JsonObject
from nscc.words.container import Container
from nscc.words.legality import picture_words
from nscc.words.reach import Reach, RegisterReaches, reaches_of_frames
from nscc_runtime.frame_file import Frame, joined
from nscc_runtime.kept_plans import KeptPlans, Turn
from nscc_runtime.light import Light
from nscc_runtime.neighbours.plane_summary import report_of
from nscc_runtime.progress import unseen
from nscc_runtime.request import Request
from nscc_runtime.response import Response, response_of
from nscc_runtime.run_kinds import KINDS
from nscc_runtime.scenes import PlacedLight, Placement
from nscc_runtime.sensor import Sensor
from nscc_runtime.simulate import Listener, Simulated, digest_of, simulate

COLOURS = ("red", "green", "blue")


@dataclass(frozen=True, eq=False)
class Taken:
    """The result of exposing a scene, its pieces joined. Colours are a leading axis of the frames.

    `container`: has a code for every pixel of the picture. `program`: the container (a compiled
    program) for one array. `light`: the scene's light, for a colour capture the red light.
    `meta_entries`: metadata for the frame file. `placement`: how the picture lies on the arrays.
    `pieces`: number of exposures, all colours together. The plan is that of the piece with the
    largest predicted error."""

    simulated: Simulated
    container: Container
    light: Light
    meta_entries: JsonObject
    program: Container
    placement: Placement
    pieces: int

    def response(self, sensor: Sensor) -> Response:
        """Return the response of `sensor` to steady light at every pixel of the picture, also if it
        was exposed in pieces, under the effects that were simulated."""
        response = response_of(self.program, sensor, self.simulated.effects)
        open_s, gain, zero_e = map(
            self.placement.repeated, (response.open_s, response.gain, response.zero_e)
        )
        return replace(response, open_s=open_s, gain=gain, zero_e=zero_e)


def simulate_scene(
    container: Container,
    scene: Sequence[PlacedLight],
    sensor: Sensor,
    request: Request,
    listener: Listener | None = None,
) -> Taken:
    """Expose a scene of one or three colours.

    The pieces are exposed on the same chip, with the same fixed patterns, one frame after the
    other; piece k has the noise seed `request.seed` + k. Pieces with similar light share a plan.
    The plan and audit of the result are those of the piece with the largest predicted error; a
    relative tolerance refers to the whole scene. `scene`: the placed light of each colour. Raises
    Rejected if the program, the light or the plan is unsuitable, and with NS0739 for options that
    support one exposure only."""
    listener = listener or Listener()
    placement, exposed = scene[0].placement, container
    if not (len(scene) == 1 and placement.fits_one_array):
        placement = overlapping(container, placement)
        exposed = with_planes_for_reports(container)
    # One light for each part of a picture and each colour, exposed one after the other.
    lights = [piece for placed in scene for piece in placement.pieces(placed.light)]
    numbered: Iterable[tuple[int, Light]] = enumerate(lights)
    piece_listener = listener
    if len(lights) > 1:
        for name in ("plan", "repeat"):
            if getattr(request, name) is not None:
                raise rejected(
                    "NS0739",
                    f"--{name} supports one exposure, but this scene needs several",
                    notes=("parts of a picture, and its colours, are exposed one after the other",),
                    helps=(f"leave --{name} out, or --fit tiles and --color",),
                )
        request = _for_all(container, lights, sensor, request)
        piece_listener = replace(listener, progress=unseen)
        numbered = listener.progress(numbered, "exposing pieces", len(lights))
    simulated_pieces, plans = [], KeptPlans()
    for number, light in numbered:
        piece_request = request
        if len(lights) > 1:
            turn = Turn(plans, number, frames=1)  # pieces of a scene are rarely similar
            piece_request = replace(request, seed=request.seed + number, turn=turn)
        simulated_pieces.append(simulate(exposed, light, sensor, piece_request, piece_listener))
    # A single exposure is the result itself; several are put together.
    simulated, light = simulated_pieces[0], scene[0].light
    if len(simulated_pieces) > 1 or not placement.fits_one_array:
        simulated = _joined(simulated_pieces, container, placement, len(scene))
    if not placement.fits_one_array:
        light = light.part(*(slice(0, side) for side in placement.size))
    about: JsonObject = {} if placement.fit == "crop" else {"laid": placement.as_json()}
    about |= {} if len(scene) == 1 else {"colours": list(COLOURS)}
    about |= {"scene_notes": list(scene[0].notes)} if scene[0].notes else {}
    whole, count = placement.widened(container), len(simulated_pieces)
    return Taken(
        simulated,
        container=whole,
        light=light,
        meta_entries=about,
        program=container,
        placement=placement,
        pieces=count,
    )


def _joined(
    pieces: Sequence[Simulated], container: Container, placement: Placement, colours: int
) -> Simulated:
    """Return the joined result of all `pieces` of a scene with `colours` colours: all pieces of the
    first colour, then those of the next. Several colours become a leading axis. Plan and audit are
    those of the piece with the largest predicted error, `broken` is that of the first piece that
    has one."""
    frames, piece_count = [piece.frame for piece in pieces], len(pieces) // colours
    frames = [
        joined(frames[k : k + piece_count], placement.joined)
        for k in range(0, len(pieces), piece_count)
    ]
    frames = [with_reports(frame, container, placement) for frame in frames]
    # Without plans all pieces count as equal, and the first is taken.
    worst = max(pieces, key=lambda piece: (piece.plan.predicted_e or 0.0) if piece.plan else 0.0)
    broken = next((piece.broken for piece in pieces if piece.broken), None)
    frame = frames[0] if colours == 1 else joined(frames, np.stack)
    origin = replace(worst.origin, program_sha256=digest_of(container))
    return replace(worst, frame=frame, origin=origin, broken=broken)


def _for_all(
    container: Container, lights: Sequence[Light], sensor: Sensor, request: Request
) -> Request:
    """Return `request` with one tolerance in electrons for all `lights`, which have equal sizes;
    unchanged if nothing is planned.

    A fraction of the noise is converted to electrons only for an audit, because measuring it takes
    as long as a frame. Raises Rejected if a light does not fit the program."""
    if not request.by_plan or KINDS.of(container).without_plan:
        return request
    from nscc_runtime.emulator.capture import check
    from nscc_runtime.planning.planned_scene import PlannedScene
    from nscc_runtime.planning.tolerance import tolerance_of, unit_of

    def pieces() -> Iterator[PlannedScene]:
        """Yield what is planned for each light in turn; only one is in memory."""
        for light in lights:
            check(container, light)
            yield PlannedScene(container, sensor, light, request.device_seed)

    def signal_e() -> float:
        """Return the mean signal of all lights in electrons."""
        return sum(piece.signal_e() for piece in pieces()) / len(lights)

    def noise_e() -> float:
        """Return the root mean square noise of all lights in electrons."""
        return math.sqrt(sum(piece.noise_e() ** 2 for piece in pieces()) / len(lights))

    if unit_of(request.tolerance) == "noise" and not request.audit:
        return request
    return replace(request, tolerance=tolerance_of(request.tolerance, sensor, signal_e, noise_e))


def overlapping(container: Container, placement: Placement) -> Placement:
    """Return `placement` with arrays that overlap by the reach of the program's outputs; unchanged
    for one array, or if outputs depend on no neighbours.

    Raises Rejected (NS0542) if the parts cannot be joined to the images of one large array: if
    codes differ between pixels, or the reach is as large as the array."""
    pictures, codes = container.pictures, container.pixel_codes
    words = (op for op, _ in picture_words(container))
    reaches = RegisterReaches(container.target, words)
    reach = Reach().joined(*(reaches.of(pictures.registers[name]) for name in pictures.outputs))
    overlap = (reach.up, reach.down), (reach.left, reach.right)
    if placement.arrays == (1, 1) or reach == Reach():
        return placement
    reason = ""
    if codes is not None and (codes != codes[0, 0]).any():
        reason = "its pixels have different codes, which must continue across the parts"
    if pictures.inputs:
        reason = "its planes of x and y, or input planes, are those of one array"
    if any(sum(pair) >= side for pair, side in zip(overlap, placement.array, strict=True)):
        reason = "its images depend on pixels as far away as the size of the array"
    if reason:
        raise rejected(
            "NS0542",
            "this program does not support a picture in several parts",
            notes=(reason,),
            helps=("use --fit crop or scale",),
            status=1,
        )
    return replace(placement, overlap=overlap)


def with_planes_for_reports(container: Container) -> Container:
    """Return the program with its reported planes and images read out instead of its reports,
    because reports of pieces cannot be joined; unchanged without reports."""
    pictures = container.pictures
    if not pictures.reports:
        return container
    return replace(container, pictures=replace(pictures, reads=pictures.outputs, reports=()))


def with_reports(frame: Frame, container: Container, placement: Placement) -> Frame:
    """Return the joined `frame` of the program of `with_planes_for_reports` as a frame of
    `container`: with the reports, computed from the joined planes and images without their margin,
    and without those that the program only reports.

    The arrays of the frame have the size of the picture, and repeats a leading axis."""
    pictures = container.pictures
    shape = container.target.rows, container.target.cols
    only_reported = {report.plane for report in pictures.reports}.difference(pictures.reads)
    kinds = "plane", "image", "image_codes", "image_saturated_by"
    hidden = {f"{kind}_{name}" for kind in kinds for name in only_reported}
    told = {key: values for key, values in frame.told.items() if key not in hidden}
    for report in pictures.reports:
        planes = frame.told[f"{'image' if report.kind == 'sum' else 'plane'}_{report.plane}"]
        repeats = planes.reshape(-1, *planes.shape[-2:])
        all_reaches = islice(reaches_of_frames(container), len(repeats))
        arrays = [
            report_of(report, values, placement.repeated(reaches[report.plane].margin(shape)))
            for values, reaches in zip(repeats, all_reaches, strict=True)
        ]
        for key, values in arrays[0].items():
            told[key] = values if planes.ndim == 2 else np.stack([each[key] for each in arrays])
    return replace(frame, told=told)
