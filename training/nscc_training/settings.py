"""The settings of a training run: sections of a TOML file, every key typed and with a default."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from nscc_training.decoders.declared import DECODERS, SIZES
from nscc_training.protocols import NAMES


def setting(
    default: Any, meaning: str, *, choices: tuple[str, ...] = (), low: float | None = None,
    high: float | None = None, key: str = "", count: int | None = None,
) -> Any:  # fmt: skip
    """A field with what a file may say: `choices` of a text, range of numbers, length of a list.

    `key` is its name in files where that is no name in Python.
    """
    about = {
        "meaning": meaning, "choices": choices, "low": low, "high": high, "key": key,
        "count": count,
    }  # fmt: skip
    return field(default=default, metadata=about)


@dataclass(frozen=True)
class ShutterSettings:
    """[shutter]: what is learned on the sensor's side."""

    kind: str = setting("b", "the class of shutters", key="class",
                        choices=("a", "b", "c", "d", "e", "codebook"))  # fmt: skip
    slots: int = setting(256, "slots in a frame", low=1, high=65536)
    slot_us: float = setting(125.0, "length of a slot in microseconds", low=1e-3, high=1e9)
    tile: tuple[int, ...] = setting((8, 8), "rows and columns of the tile of codes", low=1,
                                    high=4096, count=2)  # fmt: skip
    free: bool = setting(False, "a code for every pixel of the array instead of a tile")
    length: int = setting(4, "slots of a bump of class c", low=1, high=65536)
    rows: int = setting(64, "shapes of a codebook", low=1, high=4096)
    init: str = setting("quad", "random, uniform, quad (2 x 2 geometric), learned (as quad), or a "
                        "file of codes, .npz or .mat")  # fmt: skip
    learn: bool = setting(True, "false keeps the codes as they start")
    relaxation: str = setting(
        "straight-through", "how gradients pass the quantisation",
        choices=("straight-through", "sigmoid", "gumbel", "tried"),
    )  # fmt: skip
    temperature: tuple[float, ...] = setting((1.0, 0.05), "of a relaxation, at the first step "
                                             "and at the last", low=1e-6, high=1e6,
                                             count=2)  # fmt: skip
    noise: float = setting(0.0, "on parameters at the first step, in slots or for digits in their "
                           "own unit; 0 at the last", low=0, high=1e6)  # fmt: skip
    tried_share: float = setting(1.0, "the part of the pixels that a trial moves, with `tried`",
                                 low=1e-4, high=1)  # fmt: skip
    warm_up: float = setting(0.0, "the first part of the steps, in which the codes stay as they "
                             "start and the decoder learns them", low=0, high=1)  # fmt: skip
    settle: float = setting(0.0, "the last part of the steps, in which the codes stay as they are "
                            "and the decoder learns them", low=0, high=1)  # fmt: skip
    target: str = setting("scamp5", "the chip: a name or a file, as --target takes it")
    require: str = setting("", "a condition that legal codes fulfil, as in a program (b, c, d)")
    codes: str = setting("fixed", "open: every legal code must compile, not only those learned",
                         choices=("fixed", "open"))  # fmt: skip
    words_weight: float = setting(0.0, "of the stand-in for words a slot in the loss", low=0,
                                  high=1e6)  # fmt: skip


@dataclass(frozen=True)
class DecoderSettings:
    """[decoder]: what makes pictures of frames."""

    name: str = setting("unet2d", f"{', '.join(DECODERS)}, or one's own as module:name")
    size: str = setting("small", "as in the paper, or at most 0.6 million parameters",
                        choices=SIZES)  # fmt: skip
    width: float = setting(1.0, "of its layers, as a part of the size's", low=0.01, high=1)
    sees_code: bool = setting(True, "whether the decoder knows the code of each pixel")

    @property
    def sized(self) -> str:
        """The size in words: `small`, or `small x 0.5`."""
        return self.size if self.width == 1 else f"{self.size} x {self.width:g}"


@dataclass(frozen=True)
class SensorSettings:
    """[sensor]: what becomes of the light."""

    file: str = setting("", "a sensor's numbers (nscc effects --toml); empty: the protocol's")
    noise: bool = setting(True, "photon noise and readout noise")
    slope: float = setting(0.1, "stand-in slope of saturated pixels", low=0, high=1)


@dataclass(frozen=True)
class DataSettings:
    """[data]: scenes. Training and validation never share one."""

    train: str = setting("procedural", "a folder, procedural, or one's own as module:name")
    val: str = setting("procedural", "the same; empty: every fifth file of `train`")
    protocol: str = setting("hdr-v1", "stills (hdr-v1) or clips", choices=NAMES)
    transfer: str = setting("", "curve of clips: linear or srgb; empty: as the protocol says",
                            choices=("", "linear", "srgb"))  # fmt: skip
    patch: int = setting(64, "rows and columns of a training patch", low=11, high=4096)
    together: int = setting(1, "patches of a batch that are cut from one exposure of a scene",
                            low=1, high=100000)  # fmt: skip
    scenes: int = setting(16, "procedural scenes for training; a quarter as many to validate",
                          low=1, high=100000)  # fmt: skip
    frames: int = setting(128, "frames read of a clip", low=1, high=100000)
    paths: int = setting(4, "clips that a camera makes of a panorama, turning inside it", low=1,
                         high=100000)  # fmt: skip
    val_items: int = setting(
        8, "exposures in a validation, of `together` patches", low=1, high=100000
    )
    augment: bool = setting(True, "turn and mirror; contrast of stills; time of clips backwards")
    saturated: tuple[float, ...] = setting((0.3, 0.3), "the part of a still's pixels that "
                                           "saturate when always open, from and to", low=0.001,
                                           high=0.9, count=2)  # fmt: skip


@dataclass(frozen=True)
class LossSettings:
    """[loss]: what is minimised."""

    name: str = setting(
        "mu-law", "l1 (linear), display (sRGB), log, mu-law, pu21, psnr, psnr-mu, psnr-display, "
        "one's own as module:name, or several, joined by + and added",
    )  # fmt: skip


@dataclass(frozen=True)
class TrainSettings:
    """[train]: the loop."""

    steps: int = setting(1000, "updates", low=1, high=10**9)
    batch: int = setting(4, "patches an update", low=1, high=100000)
    seed: int = setting(0, "of everything random", low=0, high=2**31 - 1)
    device: str = setting("auto", "auto: cuda where there is one", choices=("auto", "cpu", "cuda"))
    dtype: str = setting("f32", "of the decoder; the sensor's physics stays what it is",
                         choices=("f32", "bf16"))  # fmt: skip
    rate: float = setting(1e-3, "learning rate of the decoder (Adam)", low=0, high=10)
    code_rate: float = setting(1e-3, "learning rate of the codes, as a part of their range",
                               low=0, high=10)  # fmt: skip
    schedule: str = setting("cosine", "of both rates over the steps",
                            choices=("cosine", "constant"))  # fmt: skip
    clip: float = setting(1.0, "largest norm of the decoder's gradient; 0: any", low=0, high=1e9)
    validate_every: int = setting(100, "steps between validations and checkpoints", low=1,
                                  high=10**9)  # fmt: skip


@dataclass(frozen=True)
class Settings:
    """A whole configuration."""

    shutter: ShutterSettings = field(default_factory=ShutterSettings)
    decoder: DecoderSettings = field(default_factory=DecoderSettings)
    sensor: SensorSettings = field(default_factory=SensorSettings)
    data: DataSettings = field(default_factory=DataSettings)
    loss: LossSettings = field(default_factory=LossSettings)
    train: TrainSettings = field(default_factory=TrainSettings)
