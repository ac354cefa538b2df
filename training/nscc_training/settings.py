"""Settings of a training run, and the configuration files that contain them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.toml.kinds import Flag, Integer, Number, Several, TextKind
from nscc.toml.schema import (
    FileCodes,
    Key,
    KeyValues,
    Schema,
    file_bytes,
    file_text,
    file_values,
    key,
    keys_of,
)
from nscc_training.code_choices import LOOKS, RELAXATIONS, SEARCHED, STARTS
from nscc_training.decoders.declared import DECODERS, SIZES
from nscc_training.import_paths import is_import_path
from nscc_training.made_scenes import DIRECTIONS
from nscc_training.problems import invalid_setting
from nscc_training.protocols import CLASS, PROCEDURAL, TRAINED, load_protocol

_COUNT = Integer(1, 100_000)


@dataclass(frozen=True)
class ShutterSettings:
    """The section [shutter] of a run's configuration: the class of shutters, and how codes are
    learned. The `key` of each field declares its meaning, allowed values and default."""

    kind: str = key(
        TextKind(("a", "b", "c", "d", "e", "codebook", "looks")),
        "the class of shutters; looks: pixels that close at the first look above a level",
        "b",
        name="class",
        checks=(
            lambda run: (
                run.looks
                and not run.still
                and "looks are learned from stills: set [data] protocol to hdr-v1"
            ),
        ),
    )
    slots: int = key(Integer(1, 65536), "slots in a frame", 256)
    slot_us: float = key(Number(1e-3, 1e9), "length of a slot in microseconds", 125.0)
    tile: tuple[int, ...] = key(
        Several(Integer(1, 4096), 2), "rows and columns of the tile of codes", (8, 8)
    )
    free: bool = key(Flag(), "a code for every pixel of the array instead of a tile", False)
    length: int = key(Integer(1, 65536), "slots of a bump of class c", 4)
    rows: int = key(Integer(1, 4096), "rows of a codebook", 64)
    exposures: int = key(
        Integer(2, 32), "exposures of a pixel that looks: the number of looks plus one", 5
    )
    init: str = key(
        TextKind(),
        f"{', '.join(STARTS)}, learned (as quad), a run, or a file: codes, .npz or .mat, or a "
        "program of the class, .nsl",
        "quad",
    )
    learn: bool = key(
        Flag(),
        "false: the codes do not change",
        True,
        checks=(
            lambda run: (
                run.decoder.lessons
                and run.shutter.learn
                and "lessons use codes of every kind, and the run's own codes do not learn: set "
                "it to false"
            ),
        ),
    )
    relaxation: str = key(
        TextKind(RELAXATIONS),
        "how codes are learned: the gradient method for the quantisation, or a search",
        "straight-through",
        checks=(
            lambda run: (
                run.classes
                and run.shutter.learn
                and run.shutter.relaxation == "tried"
                and "trials need the loss of each pixel, and a class has one loss: use "
                "straight-through or search"
            ),
        ),
    )
    temperature: tuple[float, ...] = key(
        Several(Number(1e-6, 1e6), 2),
        "temperature of a relaxation at the first and at the last step",
        (1.0, 0.05),
    )
    noise: float = key(
        Number(0, 1e6),
        "noise on parameters at the first step, in slots (for digits in their own unit); it "
        "falls to 0",
        0.0,
    )
    tried_share: float = key(
        Number(1e-4, 1), "with `tried`: the fraction of the pixels that a trial moves", 1.0
    )
    moves: int = key(_COUNT, "with `search`: the number of candidate codes per step", 256)
    judged: int = key(
        _COUNT,
        "with `search`: the number of best candidates by the gradient, whose loss is measured on "
        "fixed batches",
        3,
    )
    batches: int = key(_COUNT, "with `search`: the number of these fixed batches", 1)
    most_words: float = key(
        Number(0, 1e6),
        "with `search`: the largest mean number of words per slot; 0: any",
        0.0,
        checks=(
            lambda run: (
                run.shutter.most_words
                and run.shutter.relaxation not in SEARCHED
                and "only a search stays within a limit of words: use the relaxation `search`, "
                "or add words to the loss with `words_weight`"
            ),
        ),
    )
    warm_up: float = key(
        Number(0, 1),
        "the first fraction of the steps, in which only the decoder learns; with `search`, from "
        "random codes",
        0.0,
        checks=(
            lambda run: (
                run.shutter.learn
                and run.shutter.warm_up + run.settle_share >= 1
                and "with `shutter.settle` it takes all steps, so codes cannot learn: reduce "
                "it, or set `shutter.learn` to false"
            ),
        ),
    )
    settle: float = key(
        Number(0, 1),
        "the last fraction of the steps, in which the codes are frozen, and the decoder learns "
        "with a new cycle of rates",
        0.5,
    )
    jitter: float = key(
        Number(0, 1e3),
        "standard deviation of random moves of the named initial codes before gradients move "
        "them, in slots (exposure times: quarter stops): equal places would stay equal",
        1.0,
    )
    restarts: int = key(
        Integer(0, 1000),
        "how often codes and decoder begin again, from random codes, in equal parts of the steps "
        "before `settle`; the best validated state settles",
        0,
    )
    target: str = key(TextKind(), "the chip: a name or a file, as --target takes it", "scamp5")
    buckets: int = key(
        Integer(1, 2),
        "2: a second bucket collects the light that the code excludes (clips)",
        1,
        checks=(
            lambda run: (
                run.shutter.buckets > 1
                and run.shutter.kind in ("a", LOOKS)
                and f"class {run.shutter.kind} leaves no light for a second bucket"
            ),
            lambda run: (
                run.shutter.buckets > 1
                and run.still
                and "two buckets need clips: set [data] protocol to two-bucket-v1"
            ),
        ),
    )
    require: str = key(
        TextKind(), "a condition that legal codes fulfil, as in a program (b, c, d)", ""
    )
    codes: str = key(
        TextKind(("fixed", "open")),
        "open: every legal code must compile, not only those learned",
        "fixed",
    )
    words_weight: float = key(
        Number(0, 1e6),
        "weight of words per slot in the loss; a search counts the words, other methods "
        "approximate them",
        0.0,
        checks=(
            lambda run: (
                run.looks
                and run.shutter.words_weight
                and "every look takes the same number of words, so words cannot be weighted"
            ),
        ),
    )


@dataclass(frozen=True)
class DecoderSettings:
    """The section [decoder] of a run's configuration: the network that reconstructs pictures from
    frames. The `key` of each field declares its meaning, allowed values and default."""

    name: str = key(
        TextKind(), f"{', '.join(DECODERS)}, or a custom decoder as module:name", "unet2d"
    )
    size: str = key(
        TextKind(SIZES),
        "paper: as in the paper; small: at most 0.6 million parameters at width 1",
        "small",
    )
    width: float = key(
        Number(0.01, 4), "factor on the width of the decoder's layers of this size", 1.0
    )
    sees_code: bool = key(Flag(), "whether the decoder receives the code of each pixel", True)
    guess: str = key(
        TextKind(("by size", "yes", "no")),
        "whether a U-Net starts from a first guess; by size: yes for the size small, no for the "
        "size paper",
        "by size",
    )
    init: str = key(
        TextKind(),
        "the run (a folder, or one that comes with nscc) whose weights it starts from; "
        "empty: random weights",
        "",
    )
    learn: bool = key(
        Flag(),
        "false: the weights do not change; with `any`, this compares codes with a decoder "
        "that favours no code",
        True,
    )
    lessons: str = key(
        TextKind(("", "denoise", "codes", "stills")),
        "the task that `any` learns from pictures in [data] train: noisy clips, clips with "
        "codes of every class, stills with stops; empty: captures with the run's own "
        "shutters",
        "",
        checks=(
            lambda run: (
                run.decoder.lessons and run.decoder.name != "any" and "they need the decoder `any`"
            ),
        ),
    )
    films: float = key(
        Number(0, 1), "the fraction of lessons `codes` with linear light, as in video-v1", 0.0
    )
    exact: float = key(
        Number(0, 1), "the fraction of the remaining lessons `codes` without noise", 0.5
    )
    still: float = key(Number(0, 1), "the fraction of clips in lessons in which nothing moves", 0.0)
    searched: float = key(
        Number(0, 1),
        "the fraction of lessons with linear light and 16 frames whose code is the searched one",
        0.0,
    )
    stages: int = key(Integer(1, 64), "stages of a lesson", 8)
    through: int = key(
        Integer(1, 64), "number of stages that a gradient passes between two updates", 4
    )

    @property
    def sized(self) -> str:
        """The size in words: `small`, or `small x 0.5`."""
        return self.size if self.width == 1 else f"{self.size} x {self.width:g}"


@dataclass(frozen=True)
class SensorSettings:
    """The section [sensor] of a run's configuration: the sensor that captures the light in
    training."""

    file: str = key(
        TextKind(), "a sensor file (nscc effects --toml); empty: the protocol's sensor", ""
    )
    noise: bool = key(Flag(), "photon noise and readout noise", True)
    effects: str = key(
        TextKind(),
        "sensor effects as in --effects: all, auto, or names; empty: noise, full well and "
        "converter",
        "",
        checks=(
            lambda run: (
                run.sensor.effects
                and run.looks
                and "pixels that look are trained with noise alone: leave out `effects`; "
                "`nscc evaluate RUN --effects all` applies them to the finished run"
            ),
            lambda run: (
                run.sensor.effects
                and run.shutter.buckets > 1
                and "two buckets are trained with noise, full well and converter alone: leave "
                "out `effects`; `nscc evaluate RUN --effects all` applies them to the finished run"
            ),
            lambda run: (
                run.sensor.effects
                and run.shutter.free
                and "a code for every pixel has no tile that can be exposed at all levels: "
                "leave out `free`"
            ),
            lambda run: (
                run.sensor.effects
                and not run.sensor.noise
                and "effects include noise, but `sensor.noise` is false"
            ),
        ),
    )
    slope: float = key(Number(0, 1), "gradient of saturated pixels", 0.1)


@dataclass(frozen=True)
class DataSettings:
    """The section [data] of a run's configuration: the scenes. Training and validation never share
    one. The `key` of each field declares its meaning, allowed values and default."""

    train: str = key(
        TextKind(),
        "a folder, procedural (synthetic scenes), or a custom source as module:name",
        "procedural",
    )
    val: str = key(
        TextKind(), "the same; empty: every fifth file of `train`, or other procedural scenes", ""
    )
    protocol: str = key(
        TextKind(TRAINED), "stills (hdr-v1), clips, or classes of clips (class-v1)", "hdr-v1"
    )
    classes: tuple[str, ...] = key(
        Several(TextKind()),
        "with class-v1: the classes of clips, which are the names of their folders; empty: the "
        "eight directions of procedural scenes",
        (),
        checks=(
            lambda run: (
                run.data.classes and not run.classes and "classes need [data] protocol class-v1"
            ),
            lambda run: (
                run.classes
                and len(set(run.classes)) < max(2, len(run.classes))
                and "name at least two classes, each once"
            ),
            lambda run: (
                run.unknown_classes
                and f"procedural scenes have the classes {', '.join(DIRECTIONS)}, not "
                f"{run.unknown_classes[0][:40]}"
            ),
        ),
    )
    transfer: str = key(
        TextKind(("", "linear", "srgb")),
        "curve of clips: linear or srgb; empty: as the protocol says",
        "",
    )
    patch: int = key(Integer(11, 4096), "rows and columns of a training patch", 64)
    together: int = key(
        _COUNT, "number of patches of a batch that are cut from one exposure of a scene", 1
    )
    scenes: int = key(_COUNT, "procedural scenes for training; a quarter as many to validate", 16)
    frames: int = key(_COUNT, "frames read of a clip", 128)
    paths: int = key(
        _COUNT,
        "number of clips per panorama (with a turning camera) or photograph (with moving parts)",
        4,
    )
    val_items: int = key(
        _COUNT, "number of exposures in a validation, each with `together` patches", 8
    )
    augment: bool = key(
        Flag(),
        "augment: rotate and mirror, change the contrast of stills, reverse clips",
        True,
        checks=(
            lambda run: (
                run.classes
                and run.data.augment
                and "rotated, mirrored and reversed clips may change their class: set it to false"
            ),
        ),
    )
    saturated: tuple[float, ...] = key(
        Several(Number(0.001, 0.9), 2),
        "range of the fraction of a still's pixels that saturate when always open",
        (0.3, 0.3),
    )
    brightness: tuple[float, ...] = key(
        Several(Number(1e-3, 1e3), 2),
        "range of a factor on the light of each exposure, drawn uniformly in the logarithm",
        (1.0, 1.0),
    )


@dataclass(frozen=True)
class LossSettings:
    """The section [loss] of a run's configuration: the function that training minimises."""

    name: str = key(
        TextKind(),
        "l1 (linear), display (sRGB), log, mu-law, pu21, psnr, psnr-mu, psnr-display, "
        "class (cross-entropy, with the protocol class-v1), a custom loss as module:name, or a "
        "sum of losses joined by +",
        "mu-law",
        checks=(
            lambda run: (
                CLASS in run.loss.name.split("+")
                and not run.classes
                and "`class` needs [data] protocol class-v1"
            ),
            lambda run: (
                run.classes
                and run.loss.name != CLASS
                and not is_import_path(run.loss.name)
                and "classes are learned with the loss `class`"
            ),
        ),
    )


@dataclass(frozen=True)
class TrainSettings:
    """The section [train] of a run's configuration: steps, batches, learning rates and device."""

    steps: int = key(Integer(1, 10**9), "updates", 1000)
    batch: int = key(_COUNT, "patches per update", 4)
    seed: int = key(Integer(0, 2**31 - 1), "seed of all random numbers", 0)
    device: str = key(
        TextKind(("auto", "cpu", "cuda")),
        "device of networks and frames of the emulated chip; auto: cuda if available",
        "auto",
    )
    dtype: str = key(
        TextKind(("f32", "bf16")), "data type of the decoder; the sensor model is always f32", "f32"
    )
    rate: float = key(Number(0, 10), "learning rate of the decoder", 1e-3)
    optimizer: str = key(
        TextKind(("adam", "muon")),
        "optimizer of the decoder; muon: Muon for its inner convolutions, Adam elsewhere",
        "adam",
    )
    average: float = key(
        Number(0, 1),
        "decay of the moving average of the decoder's weights; the averaged weights are "
        "stored; 0: no average",
        0.0,
    )
    compile: bool = key(Flag(), "compile the decoder by torch.compile", False)
    workers: int = key(Integer(0, 256), "processes that prepare batches; 0: the main process", 0)
    code_rate: float = key(
        Number(0, 10), "learning rate of the codes, as a fraction of their range", 1e-3
    )
    schedule: str = key(
        TextKind(("cosine", "constant")),
        "schedule of both learning rates in a cycle; they rise in its first steps, at most 20",
        "cosine",
    )
    clip: float = key(Number(0, 1e9), "largest norm of the decoder's gradient; 0: any", 1.0)
    validate_every: int = key(Integer(1, 10**9), "steps between validations and checkpoints", 100)


@dataclass(frozen=True)
class RunSettings:
    """A complete configuration of a training run: a field for each section of the file."""

    shutter: ShutterSettings = ShutterSettings()
    decoder: DecoderSettings = DecoderSettings()
    sensor: SensorSettings = SensorSettings()
    data: DataSettings = DataSettings()
    loss: LossSettings = LossSettings()
    train: TrainSettings = TrainSettings()

    @property
    def still(self) -> bool:
        """Whether the run learns from stills instead of clips."""
        return load_protocol(self.data.protocol).still

    @property
    def looks(self) -> bool:
        """Whether pixels look at their light."""
        return self.shutter.kind == LOOKS

    @property
    def classes(self) -> tuple[str, ...]:
        """The names of the classes that the decoder distinguishes; empty if it reconstructs
        light."""
        classifies = load_protocol(self.data.protocol).classifies
        return self.data.classes or DIRECTIONS if classifies else ()

    @property
    def settle_share(self) -> float:
        """The fraction of the steps in which the codes are frozen and only the decoder learns: 0 if
        the codes do not learn, or if the decoder has nothing to learn."""
        decoder = DECODERS.get(self.decoder.name)
        can_settle = self.decoder.learn and (decoder is None or decoder.has_weights)
        return self.shutter.settle if self.shutter.learn and can_settle else 0.0

    @property
    def unknown_classes(self) -> tuple[str, ...]:
        """The classes that procedural scenes do not have."""
        procedural = self.data.train == PROCEDURAL
        return tuple(name for name in self.classes if procedural and name not in DIRECTIONS)

    def check(self) -> None:
        """Raise Rejected (NS0815, status 2) with all settings that contradict others. Each key
        declares its own checks."""
        reasons = ((key.path, check(self)) for key in SCHEMA.keys for check in key.checks)
        problems = [invalid_setting(path, reason) for path, reason in reasons if reason]
        if problems:
            raise Rejected([error.diagnostics[0] for error in problems], status=2)


SCHEMA = Schema(
    "configuration",
    tuple(
        key for name, section in vars(RunSettings()).items() for key in keys_of(type(section), name)
    ),
    dict.fromkeys(vars(RunSettings()), ""),
    FileCodes("NS0813", "NS0813", unknown="NS0814", wrong_value="NS0815", change="NS0815"),
    "`nscc train --schema > config.toml` writes a complete file to start from",
    noun="setting",
    option="--set",
    example="train.steps=100",
)


def load_config(path: Path, changes: Sequence[str] = ()) -> RunSettings:
    """Read the settings in a TOML file, with `changes`, each a text SECTION.KEY=VALUE; a change
    replaces the file's value, and of two changes of a key the last counts. Missing keys have their
    defaults.

    Raises Rejected (status 2) with all errors at once: NS0813 for a file that cannot be read or is
    not TOML, NS0814 for unknown keys, NS0815 for invalid values."""
    values, problems, _ = file_values(SCHEMA, file_bytes(SCHEMA, path), str(path))
    return _settings(values, problems, changes)


def settings_of(values: Mapping[str, Any], changes: Sequence[str] = ()) -> RunSettings:
    """Return the settings in a dictionary of sections (`{"train": {"steps": 100}}`), with `changes`
    as texts SECTION.KEY=VALUE; missing keys have their defaults. Raises Rejected (status 2) with
    all errors at once: NS0814 for unknown keys, NS0815 for invalid values."""
    return _settings(*SCHEMA.read(values), changes)


def config_toml(settings: RunSettings, *, remarks: bool = False) -> str:
    """Return a complete configuration file with these settings. With `remarks`, comments give the
    meaning and the allowed values of each key."""

    def remark(key: Key) -> str:
        """Return the comment on a key: its meaning and its allowed values."""
        return f"{key.meaning} ({key.kind.allowed})" if remarks else ""

    head = (
        "A training run of nscc: `nscc train CONFIG.toml --out RUN`.",
        "Every key has its default here; those that are left out keep it.",
    )
    return file_text(SCHEMA, values_of(settings), remark, head if remarks else ())


def values_of(settings: RunSettings) -> KeyValues:
    """Return the value of each setting by the path of its key, such as `train.steps`."""
    return {key.path: getattr(getattr(settings, key.section), key.attribute) for key in SCHEMA.keys}


def _settings(
    values: KeyValues, problems: Sequence[Diagnostic], changes: Sequence[str]
) -> RunSettings:
    """Return the default settings, replaced by `values` (by path of the key) and then by `changes`,
    texts such as `train.steps=100`.

    Raises Rejected (status 2) with all `problems` together: those that were found while `values`
    were read, and those of `changes`."""
    changed, change_problems = SCHEMA.changed(changes)
    if problems or change_problems:
        raise Rejected([*problems, *change_problems], status=2)
    settings = RunSettings()
    for path, value in (values | changed).items():
        key = SCHEMA.by_path[path]
        section = replace(getattr(settings, key.section), **{key.attribute: value})
        settings = replace(settings, **{key.section: section})
    return settings
