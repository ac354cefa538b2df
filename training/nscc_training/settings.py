"""The settings of a training run: tables of a TOML file, every key with a default."""

from __future__ import annotations

from dataclasses import dataclass, field

from nscc.toml.kinds import Flag, Integer, Number, Several, Text
from nscc.toml.schema import Codes, Schema, key, keys_of
from nscc_training.code_choices import RELAXATIONS, STARTS
from nscc_training.decoders.declared import DECODERS, SIZES
from nscc_training.protocols import NAMES

_COUNT = Integer(1, 100_000)


@dataclass(frozen=True)
class ShutterSettings:
    """[shutter]: what is learned on the sensor's side."""

    kind: str = key(
        Text(("a", "b", "c", "d", "e", "codebook", "looks")),
        "the class of shutters; looks: pixels that close at the first look above a level",
        "b",
        name="class",
    )
    slots: int = key(Integer(1, 65536), "slots in a frame", 256)
    slot_us: float = key(Number(1e-3, 1e9), "length of a slot in microseconds", 125.0)
    tile: tuple[int, ...] = key(
        Several(Integer(1, 4096), 2), "rows and columns of the tile of codes", (8, 8)
    )
    free: bool = key(Flag(), "a code for every pixel of the array instead of a tile", False)
    length: int = key(Integer(1, 65536), "slots of a bump of class c", 4)
    rows: int = key(Integer(1, 4096), "shapes of a codebook", 64)
    exposures: int = key(Integer(2, 32), "of a pixel that looks: one more than it has looks", 5)
    init: str = key(
        Text(),
        f"{', '.join(STARTS)}, learned (as quad), a run, or a file: codes, .npz or .mat, or a "
        "program of the class, .nsl", "quad",
    )  # fmt: skip
    learn: bool = key(Flag(), "false keeps the codes as they start", True)
    relaxation: str = key(
        Text(RELAXATIONS),
        "how codes are learned: ways for gradients to pass the quantisation, or a search",
        "straight-through",
    )  # fmt: skip
    temperature: tuple[float, ...] = key(
        Several(Number(1e-6, 1e6), 2), "of a relaxation, at the first step and at the last",
        (1.0, 0.05),
    )  # fmt: skip
    noise: float = key(
        Number(0, 1e6),
        "on parameters at the first step, in slots or for digits in their own unit; 0 at the last",
        0.0,
    )
    tried_share: float = key(
        Number(1e-4, 1), "the part of the pixels that a trial moves, with `tried`", 1.0
    )
    moves: int = key(_COUNT, "codes with places moved together that a step of a search draws", 64)
    judged: int = key(
        _COUNT, "of these, the most promising that the decoder judges on the step's batch", 3
    )
    most_words: float = key(
        Number(0, 1e6), "words a slot that a search stays within, in the mean; 0: any", 0.0
    )
    warm_up: float = key(
        Number(0, 1),
        "the first part of the steps, in which the codes stay as they start and the decoder "
        "learns them", 0.0,
    )  # fmt: skip
    settle: float = key(
        Number(0, 1),
        "the last part of the steps, in which the codes stay as they are and the decoder "
        "learns them", 0.0,
    )  # fmt: skip
    target: str = key(Text(), "the chip: a name or a file, as --target takes it", "scamp5")
    buckets: int = key(
        Integer(1, 2),
        "2: the light that a code leaves out goes to a second bucket, and none is lost (clips)", 1,
    )  # fmt: skip
    require: str = key(Text(), "a condition that legal codes fulfil, as in a program (b, c, d)", "")
    codes: str = key(
        Text(("fixed", "open")), "open: every legal code must compile, not only those learned",
        "fixed",
    )  # fmt: skip
    words_weight: float = key(
        Number(0, 1e6), "of words a slot in the loss: a search's own, else a stand-in for them", 0.0
    )


@dataclass(frozen=True)
class DecoderSettings:
    """[decoder]: what makes pictures of frames."""

    name: str = key(Text(), f"{', '.join(DECODERS)}, or one's own as module:name", "unet2d")
    size: str = key(Text(SIZES), "as in the paper, or at most 0.6 million parameters", "small")
    width: float = key(Number(0.01, 1), "of its layers, as a part of the size's", 1.0)
    sees_code: bool = key(Flag(), "whether the decoder knows the code of each pixel", True)
    guess: str = key(
        Text(("by size", "yes", "no")), "whether a U-Net improves on a first guess; by size: the "
        "small ones do, the paper's begin with nothing", "by size",
    )  # fmt: skip
    init: str = key(
        Text(), "the run, a folder or one that comes with nscc, whose weights it begins with; "
        "empty: drawn from the seed", "",
    )  # fmt: skip
    learn: bool = key(
        Flag(), "false keeps it as it begins; with `any`, codes are judged by what favours none",
        True,
    )  # fmt: skip
    lessons: str = key(
        Text(("", "denoise", "codes", "stills")),
        "what `any` learns from pictures in [data] train: noisy clips, clips behind codes of every "
        "class, stills behind stops; empty: captures through the run's own shutters", "",
    )  # fmt: skip
    films: float = key(Number(0, 1), "the part of lessons `codes` in linear light, as films", 0.0)
    exact: float = key(Number(0, 1), "the part of the other lessons `codes` without noise", 0.5)
    stages: int = key(Integer(1, 64), "stages of a lesson", 8)
    through: int = key(Integer(1, 64), "stages that a gradient passes: an update after each", 4)

    @property
    def sized(self) -> str:
        """The size in words: `small`, or `small x 0.5`."""
        return self.size if self.width == 1 else f"{self.size} x {self.width:g}"


@dataclass(frozen=True)
class SensorSettings:
    """[sensor]: what becomes of the light."""

    file: str = key(Text(), "a sensor's numbers (nscc effects --toml); empty: the protocol's", "")
    noise: bool = key(Flag(), "photon noise and readout noise", True)
    effects: str = key(
        Text(),
        "all that the emulator does to frames, or auto, or names, as --effects takes them; empty: "
        "noise, full well and converter", "",
    )  # fmt: skip
    slope: float = key(Number(0, 1), "stand-in slope of saturated pixels", 0.1)


@dataclass(frozen=True)
class DataSettings:
    """[data]: scenes. Training and validation never share one."""

    train: str = key(Text(), "a folder, procedural, or one's own as module:name", "procedural")
    val: str = key(
        Text(), "the same; empty: every fifth file of `train`, or other procedural scenes", ""
    )
    protocol: str = key(Text(NAMES), "stills (hdr-v1) or clips", "hdr-v1")
    transfer: str = key(
        Text(("", "linear", "srgb")), "curve of clips: linear or srgb; empty: as the protocol says",
        "",
    )  # fmt: skip
    patch: int = key(Integer(11, 4096), "rows and columns of a training patch", 64)
    together: int = key(_COUNT, "patches of a batch that are cut from one exposure of a scene", 1)
    scenes: int = key(_COUNT, "procedural scenes for training; a quarter as many to validate", 16)
    frames: int = key(_COUNT, "frames read of a clip", 128)
    paths: int = key(
        _COUNT, "clips that are made of a panorama, in which a camera turns, or of a photograph, "
        "whose parts move", 4,
    )  # fmt: skip
    val_items: int = key(_COUNT, "exposures in a validation, of `together` patches", 8)
    augment: bool = key(
        Flag(), "turn and mirror; contrast of stills; time of clips backwards", True
    )
    saturated: tuple[float, ...] = key(
        Several(Number(0.001, 0.9), 2),
        "the part of a still's pixels that saturate when always open, from and to", (0.3, 0.3),
    )  # fmt: skip


@dataclass(frozen=True)
class LossSettings:
    """[loss]: what is minimised."""

    name: str = key(
        Text(),
        "l1 (linear), display (sRGB), log, mu-law, pu21, psnr, psnr-mu, psnr-display, one's "
        "own as module:name, or several, joined by + and added", "mu-law",
    )  # fmt: skip


@dataclass(frozen=True)
class TrainSettings:
    """[train]: the loop."""

    steps: int = key(Integer(1, 10**9), "updates", 1000)
    batch: int = key(_COUNT, "patches an update", 4)
    seed: int = key(Integer(0, 2**31 - 1), "of everything random", 0)
    device: str = key(
        Text(("auto", "cpu", "cuda")),
        "of networks and the frames of the emulated chip; auto: cuda where there is one", "auto",
    )  # fmt: skip
    dtype: str = key(
        Text(("f32", "bf16")), "of the decoder; the sensor's physics stays what it is", "f32"
    )
    rate: float = key(Number(0, 10), "learning rate of the decoder", 1e-3)
    optimizer: str = key(
        Text(("adam", "muon")), "of the decoder; muon: for its inner convolutions, Adam elsewhere",
        "adam",
    )  # fmt: skip
    average: float = key(
        Number(0, 1), "decay of the decoder's moving average, which is what is kept; 0: none", 0.0
    )
    compile: bool = key(Flag(), "compile the decoder by torch.compile", False)
    workers: int = key(Integer(0, 256), "processes that draw batches; 0: the run's own", 0)
    code_rate: float = key(
        Number(0, 10), "learning rate of the codes, as a part of their range", 1e-3
    )
    schedule: str = key(Text(("cosine", "constant")), "of both rates over the steps", "cosine")
    clip: float = key(Number(0, 1e9), "largest norm of the decoder's gradient; 0: any", 1.0)
    validate_every: int = key(Integer(1, 10**9), "steps between validations and checkpoints", 100)


@dataclass(frozen=True)
class RunSettings:
    """A whole configuration."""

    shutter: ShutterSettings = field(default_factory=ShutterSettings)
    decoder: DecoderSettings = field(default_factory=DecoderSettings)
    sensor: SensorSettings = field(default_factory=SensorSettings)
    data: DataSettings = field(default_factory=DataSettings)
    loss: LossSettings = field(default_factory=LossSettings)
    train: TrainSettings = field(default_factory=TrainSettings)


SCHEMA = Schema(
    "configuration",
    tuple(
        key for name, section in vars(RunSettings()).items() for key in keys_of(type(section), name)
    ),
    dict.fromkeys(vars(RunSettings()), ""),
    Codes("NS0813", "NS0813", unknown="NS0814", wrong="NS0815", change="NS0815"),
    "`nscc train --schema > config.toml` writes a complete file to start from",
    noun="setting",
    option="--set",
    example="train.steps=100",
)
