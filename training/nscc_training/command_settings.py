"""The options of `demo`, `design`, `import-mask`, `reconstruct`, `evaluate`, `tradeoff` and
`sweep`: their kinds, meanings and defaults, without torch, the compiler and the simulators.

The command line and the grids of `nscc sweep` take them from here."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Literal, get_args

from nscc.options import Options
from nscc.toml.kinds import Distinct, FilePath, Flag, Integer, Number, Several, TextKind
from nscc.toml.schema import declared, key
from nscc_runtime.scene_settings import Fit, Scene

if TYPE_CHECKING:
    from nscc.lower.exposure_plan import Lowering
    from nscc.program.program import Codes

_COMPILER = declared(Options)
_LEVEL, _CODES = _COMPILER["level"].kind, _COMPILER["codes"].kind
_LOWERINGS = _COMPILER["lowering"].kind.choices[1:]  # type: ignore[attr-defined]  # a TextKind
"""The lowerings that the option `auto` chooses from."""

Criterion = Literal["mu", "linear", "log", "sve-risk"]
MotionKind = Literal["slow", "fast", "scene"]
Axis = Literal["first", "last"]
"""The axis of a mask that counts slots."""
ResultKind = Literal["image", "video"]
Method = Literal["network", "merge", "gap-tv"]
"""Methods of the decoder for any code."""
Count = Literal["all", "logic"]
"""Which words to count: all words of a frame, or only those that decode codes."""

STAGES = ("compile", "lowering", "slots", "effects", "decoder")
"""The stages of the joint tradeoff of one program, in order."""

# Options of several commands: each is declared once, and a field calls it with its own default.
_slot_us = partial(key, meaning="Length of a slot in microseconds")
_LONG_US = Number(1e-3, 1e9)
_SLOTS_AXIS = (
    TextKind(get_args(Axis)),
    "The axis of a mask that counts slots, for a mask whose sizes do not tell it",
    None,
)
_levels = partial(key, Distinct(_LEVEL), "Levels of -O to compare", notation="0,1,..")
_lowerings = partial(key, Distinct(TextKind(_LOWERINGS)), "Lowerings", notation="NAME,..")
_repeats = partial(key, Integer(1, 1000), "How often each setting is timed; the median is used")
_scenes = partial(key, Integer(1, 1000), "Number of scenes of each kind", name="scenes")
_SEED = Integer(0, 2**31 - 1)
_noise_seed = partial(key, _SEED, "Seed of random codes and noise", 0)
_trust_code = partial(
    key, Flag(), "Allow the run to execute its custom Python code (module:name)", False
)
_effects = partial(
    key,
    TextKind(),
    "Effects of the emulated chip: auto, all, or names, as in nscc run",
    "auto",
    notation="E",
)


@dataclass(frozen=True)
class DesignSettings:
    """What `nscc design` computes: exactly one of `looks`, `search`, `motion` and the criterion
    sve-risk is chosen. The `key` of each field declares its meaning and allowed values."""

    looks: int | None = key(
        Integer(2, 32),
        "Design pixels that look: K exposures; the last is the whole frame",
        None,
        notation="K",
    )
    criterion: Criterion | None = key(
        TextKind(get_args(Criterion)),
        "The error to minimise: of the light on a mu-law curve (default), linear, or of its "
        "logarithm; sve-risk designs a fixed 2 x 2 tile of stops instead",
        None,
    )
    search: bool = key(
        Flag(),
        "Search all simple patterns of stops for stills, or codes for clips, judged by a decoder "
        "under every effect",
        False,
    )
    trials: int = key(
        Integer(0, 10_000),
        "With --search: changes of the best candidate that are tried; each takes about 2 s a clip",
        24,
    )
    motion: MotionKind | None = key(
        TextKind(get_args(MotionKind)),
        "Choose a code for clips by their motion: slow, fast, or as in the scenes",
        None,
    )
    max_words: float = key(
        Number(0.1, 1000), "With --motion: the largest mean number of words per slot", 4.0
    )
    slots: int | None = key(
        Integer(2, 4096), "Slots of the frame", None, default_text="256, for clips 16"
    )
    slot_us: float = _slot_us(Number(0.01, 1e6), default=125.0)


@dataclass(frozen=True)
class DemoSettings:
    """How `nscc demo` exposes a scene and reconstructs it.

    `exposure` is written as for `--exposure`; None uses the run's. `tone` names a tone curve; None
    uses sRGB for display scenes and a logarithm for linear light. `run` exposes and decodes in
    place of the run that comes with nscc. `fit` and `color` are written as for `nscc run`; `seed`
    is that of the noise."""

    merge: bool = key(Flag(), "Reconstruct without the decoder, which needs torch", False)
    readouts: int | None = key(
        Integer(1, 4),
        "Readouts of one exposure of a clip, 1 to 4",
        None,
        notation="K",
        default_text="4",
    )
    run: Path | None = key(
        FilePath(),
        "A run of nscc train, whose shutters and decoder are shown",
        None,
        notation="RUN",
    )
    fit: Fit = "scale"
    color: bool = False
    exposure: str | None = None
    tone: str | None = None
    seed: int = 0

    @property
    def learned(self) -> bool:
        """Whether the run's network reconstructs, which needs torch; otherwise neighbours are
        merged."""
        return not self.merge and find_spec("torch") is not None


@dataclass(frozen=True)
class ImportSettings:
    """How masks and networks of other tools are turned into programs. Masks use the length of a
    slot and the axis of slots, networks the time of a frame."""

    slot_us: float = _slot_us(_LONG_US, default=125.0)
    frame_us: float = key(_LONG_US, "Exposure time of a frame in microseconds", 33_000.0)
    slots_axis: Axis | None = key(*_SLOTS_AXIS)


@dataclass(frozen=True)
class ReconstructSettings:
    """How `nscc reconstruct` and `nscc classify` decode a frame.

    `dark` is a dark frame of the same program. `kind`, `method` and `program` are for frames that
    the decoder for any code reconstructs, `mask`, `slots_axis` and `noise` for own measurements,
    `force` and `trust_code` for runs."""

    dark: Path | None = key(
        FilePath(),
        "A frame file of the same program without light, with many repeats: it is subtracted from "
        "FRAME",
        None,
        notation="DARK.npz",
    )
    kind: ResultKind | None = key(
        TextKind(get_args(ResultKind)),
        "With any: reconstruct a picture or a clip. Default: a picture if all shutters open at the "
        "start of the frame (class b), else a clip",
        None,
        option="--as",
    )
    method: Method | None = key(
        TextKind(get_args(Method)),
        "With any: the network (default), or without torch: merge neighbours of a picture, total "
        "variation (GAP-TV) of a clip",
        None,
    )
    program: Path | None = key(
        FilePath(),
        "With any: the program that exposed FRAME, for older files without shutters",
        None,
        notation="FILE",
    )
    mask: Path | None = key(
        FilePath(),
        "With any and an own measurement: the file of its mask, if FRAME does not contain `mask`",
        None,
        notation="MASK",
    )
    slots_axis: Axis | None = key(*_SLOTS_AXIS)
    noise: str | None = key(
        TextKind(),
        "With any and an own measurement: the standard deviation of its readout, and the amount "
        "that one photon adds, in the unit of `meas`",
        None,
        notation="SD[,GAIN]",
        default_text="none",
    )
    force: bool = key(
        Flag(), "Only warn if the frame belongs to another program or sensor than RUN", False
    )
    trust_code: bool = _trust_code()


@dataclass(frozen=True)
class EvaluationSettings:
    """What `nscc evaluate` scores: the run folder or baseline `subject`, on the scenes in `data`
    under a protocol.

    With `skip_seen`, files that a run was trained or validated on are left out. `shutter` names
    other codes for a baseline. `effects` expose the scenes of runs, and of methods without a
    decoder, on the emulated chip in place of the protocol's sensor; `changes` are values of its
    sensor, as for `nscc run --sensor-set`. `trust_code` allows a run to execute its Python code."""

    subject: str
    data: Path = key(
        FilePath(),
        "The folder of scenes; for class-v1 also `procedural`",
        None,
        notation="DIR",
    )
    protocol: str = key(
        TextKind(),
        "hdr-v1, video-v1, sci8, deblur-v1, two-bucket-v1, staggered-v1, codes-v1, class-v1",
        "",
        notation="P",
    )
    seed: int = _noise_seed()
    skip_seen: bool = key(Flag(), "Leave out files that the run was trained or validated on", False)
    shutter: str = key(
        TextKind(),
        "The codes of a baseline: c, c:quad, d:random, ... for clips, b:quad, b:random for "
        "stills, or those of a run; a class alone uses random codes",
        "",
        notation="CLASS[:START]",
    )
    effects: str = key(
        TextKind(),
        "Expose with an emulated chip instead of the protocol's sensor: auto, all, or names, as "
        "in nscc run. For runs and pixels that look",
        "",
        notation="E",
    )
    trust_code: bool = _trust_code()
    changes: tuple[str, ...] = ()


@dataclass(frozen=True)
class FigureSettings:
    """The scenes of `nscc evaluate figures`, and how they are exposed."""

    data: Path | None = key(
        FilePath(),
        "Panoramas and clips, or folders hdr and video of them",
        None,
        notation="DIR",
        default_text="built-in scenes",
    )
    effects: str = _effects()
    seed: int = _noise_seed()


@dataclass(frozen=True)
class MadeScenes:
    """Scenes of a measurement: those of a folder, or synthetic ones."""

    data: Path | None = key(
        FilePath(),
        "A folder of clips, panoramas or both, instead of synthetic scenes",
        None,
        notation="DIR",
    )
    seed: int = key(_SEED, "Seed of synthetic scenes, random codes and noise", 0)


def _undivided(settings: SensorStudySettings) -> str:
    """Return which number of slots does not divide the largest, "" if all do."""
    most = max(settings.slots, default=1)
    odd = next((count for count in settings.slots if most % count), None)
    return f"{odd} does not divide {most}: all numbers of slots use the same clips" if odd else ""


@dataclass(frozen=True)
class SensorStudySettings(MadeScenes):
    """The grid of `nscc tradeoff sensor`: every combination of the lists is measured, at most
    `count` scenes of each kind. The programs are compiled for `target` with `level`."""

    classes: tuple[str, ...] = key(
        Distinct(TextKind(("b", "c", "d", "e", "codebook"))),
        "Classes of shutters for clips",
        ("b", "c", "d", "e", "codebook"),
        notation="CLASS,..",
    )
    slots: tuple[int, ...] = key(
        Distinct(Integer(2, 4096)),
        "Slots of a frame, for clips",
        (8, 16),
        notation="N,..",
        checks=(_undivided,),
    )
    stop_slots: tuple[int, ...] = key(
        Distinct(Integer(2, 4096)),
        "Slots of a frame for stills, which class b exposes",
        (16, 64),
        notation="N,..",
    )
    looks: tuple[int, ...] = key(
        Distinct(Integer(2, 32), may_be_empty=True),
        "Exposures of pixels that look, for stills, or none",
        (2, 5, 9),
        notation="K,..",
    )
    readouts: tuple[int, ...] = key(
        Distinct(Integer(1, 4), may_be_empty=True),
        "Readouts of one exposure, for clips, or none",
        (1, 2, 3, 4),
        notation="K,..",
    )
    codes: tuple[Codes, ...] = key(
        Distinct(_CODES),
        "Compile for the codes in use, for every legal one",
        ("fixed", "open"),
        notation="MODE,..",
    )
    lowerings: tuple[Lowering, ...] = _lowerings(_LOWERINGS)
    target: str = "scamp5"
    level: int = 1
    slot_us: float | None = key(
        Number(0.01, 1e6),
        "Capture with slots of this length instead of each configuration's shortest",
        None,
        notation="T",
    )
    effects: str = _effects()
    count: int = _scenes(1)


@dataclass(frozen=True)
class DecoderStudySettings(MadeScenes):
    """The scenes of `nscc tradeoff decoder`, at most `count` of each kind, and its repeats."""

    count: int = _scenes(2)
    size: int = key(Integer(32, 512), "Rows and columns of a scene", 128)
    repeats: int = _repeats(3)
    budget_s: float = key(
        Number(0, 1e6),
        "Seconds after which no repeat starts; everything is measured at least once",
        40.0,
        name="budget",
        notation="S",
    )


@dataclass(frozen=True)
class EmulatorStudySettings:
    """The settings of `nscc tradeoff emulator`.

    Percentages of tolerances refer to the mean signal of each scene. Errors are averaged over
    `frames`, more for small scenes, up to 65536 pixels or 64 frames. Times are medians of
    `repeats`. `seed` is that of the noise, `device_seed` that of the chip."""

    tolerances: tuple[str | float, ...] = key(
        Several(TextKind()),
        "Tolerances to plan for: electrons (5e), codes (0.1lsb), or a part of each scene's mean "
        "signal (1%)",
        ("0.5e", "1e", "2e", "5e", "10e", "20e", "50e"),
        notation="T,..",
    )
    budget: str | float = key(
        TextKind(), "The tolerance whose plans are shown effect by effect", "5e", notation="T"
    )
    frames: int = key(
        Integer(2, 1000),
        "Number of frames for measuring errors; more if they have few pixels",
        2,
    )
    repeats: int = _repeats(5)
    seed: int = 0
    device_seed: int = 0


@dataclass(frozen=True)
class SynthesisStudySettings:
    """The grid of `nscc tradeoff synthesis`, every combination of `levels` and `lowerings`, and
    which words it counts."""

    levels: tuple[int, ...] = _levels((0, 1, 2, 3))
    lowerings: tuple[Lowering, ...] = _lowerings(_LOWERINGS)
    repeats: int = _repeats(3)
    count: Count = key(
        TextKind(get_args(Count)),
        "All words of a frame, or only those that decode codes",
        "all",
    )


@dataclass(frozen=True)
class JointRequest:
    """A program, a scene and the largest allowed error: what `nscc tradeoff PROGRAM` measures.

    `target_error` is written as for `--tolerance`. `stages` names the stages to measure. `levels`
    of -O are compared; other stages use the words compiled with `options`. Times are medians of
    `repeats`. `pixels` is a file of codes, `sensor` a sensor file, and `changes` values of the
    sensor (KEY=VALUE); None or empty take the defaults. `seed` is that of the noise, `device_seed`
    that of the chip. `run` is the run folder that the program belongs to, None for other programs;
    `trust_code` allows it to execute its Python code."""

    program: Path
    scene: Scene
    target_error: str = key(
        TextKind(),
        "The largest error that you accept: in percent of the scene's mean signal, in electrons, "
        "in converter codes, or relative to the frame's own noise",
        "1%",
        notation="1%|5e|0.1lsb|1noise",
    )
    stages: tuple[str, ...] = key(
        Distinct(TextKind(STAGES)), "Stages to measure", STAGES, notation="NAME,.."
    )
    options: Options = field(default_factory=Options)
    levels: tuple[int, ...] = _levels((0, 1, 2))
    pixels: Path | None = None
    sensor: Path | None = None
    changes: tuple[str, ...] = ()
    seed: int = 0
    device_seed: int = 0
    repeats: int = _repeats(3)
    run: Path | None = None
    trust_code: bool = _trust_code()


@dataclass(frozen=True)
class SweepSettings:
    """How points of a sweep are computed: by processes here (0: this one) or by the workers of a
    scheduler. Each process uses `threads` threads. `again` repeats those that failed."""

    workers: int | None = key(
        Integer(0, 1024),
        "Processes on this machine",
        None,
        notation="N",
        default_text="one per processor; 0: only this one",
    )
    threads: int = key(
        Integer(1, 1024),
        "Threads of each process: results of training depend on it",
        1,
        notation="T",
    )
    scheduler: str | None = key(
        TextKind(),
        "The workers of a Dask scheduler instead",
        None,
        notation="tcp://HOST:PORT",
    )
    again: bool = key(Flag(), "Compute failed points again", False)


@dataclass(frozen=True)
class TvSettings:
    """How clips are reconstructed by total variation: the number of iterations of the method, and
    the weight of total variation."""

    iterations: int = key(Integer(1, 10000), "Iterations of total variation", 40)
    weight: float = key(
        Number(0, 10, low_excluded=True), "Weight of total variation, for values 0..1", 0.1
    )
