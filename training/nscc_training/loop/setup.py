"""Build the objects that a configuration names, checked by the compiler before training."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
import torch
from torch import Tensor, nn

from nscc.chips.load import load_target, parse_target, read_target
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Rejected
from nscc.npy import check_size
from nscc.pipeline import Compiled
from nscc_runtime.effects import selected
from nscc_runtime.sensor import Sensor, default_sensor, parse_sensor, read_sensor
from nscc_training import programs
from nscc_training.any_code.decode import AnyCode
from nscc_training.code_choices import ARRANGE, LOOKS, SLOPED, STARTS
from nscc_training.codes_files import load_codes
from nscc_training.decoders.declared import DecoderTask
from nscc_training.decoders.decoder_building import make_decoder
from nscc_training.design.chip import most_steps
from nscc_training.emulated import (
    CHIPS,
    EmulatedSensor,
    MeasuredTables,
    emulated_sensor,
)
from nscc_training.encoders import Encoder, ShutterSpec, make_encoder
from nscc_training.encoders.base import Codes
from nscc_training.encoders.bumps import Bump
from nscc_training.import_paths import imported, is_import_path, own_code, own_failed
from nscc_training.losses import LOSSES, Loss
from nscc_training.problems import invalid_setting, one_line
from nscc_training.programs import MOST_LISTED, Chip, begun_with
from nscc_training.protocols import Protocol, load_protocol
from nscc_training.random_streams import DrawStream
from nscc_training.run_files import WEIGHTS, run_path
from nscc_training.search.moves import arranged, candidate
from nscc_training.sensor_model import SensorModel, shared_out
from nscc_training.settings import RunSettings, ShutterSettings

_STARTS = (*STARTS, "learned")
_MEASURED_CODES = 48
"""Number of random codes that a decoder learns under effects."""
_MIXING = 4
"""Exchanges of two places, for each place of a tile, that mix an arrangement well."""
_MOST_DRAWS = 8
"""Most draws of random codes until one compiles."""


@dataclass(frozen=True, eq=False)
class TrainingSetup:
    """The objects that the configuration of a training run (`settings`) names.

    `still` says whether it learns from stills, else from clips, which `protocol` exposes. `encoder`
    (shutters) and `decoder` are on `device`, and `loss` compares light. `chip` and `target`
    describe the chip, `sensor` its full sensor file, and `model` the sensor of training steps.
    `files` are the contents of the user's own chip and sensor files by their names in a run folder.
    `chips` is the number of emulated chips that `tables`, the emulated sensors, are measured on."""

    settings: RunSettings
    protocol: Protocol
    still: bool
    chip: Chip
    target: Target
    sensor: Sensor
    model: SensorModel
    encoder: Encoder
    decoder: nn.Module
    loss: Loss
    device: torch.device
    files: Mapping[str, bytes]
    chips: int = CHIPS
    tables: MeasuredTables = field(default_factory=MeasuredTables)

    @property
    def slots(self) -> int:
        """Number of slots per frame."""
        return self.encoder.spec.slots

    @property
    def unit_e(self) -> float:
        """Electrons, over the frame or per slot, that decoders represent as 1; 1 for classes."""
        if self.classes:
            return 1.0
        return self.model.full_e / (1 if self.still else self.slots)

    @property
    def classes(self) -> tuple[str, ...]:
        """The names of the classes that the decoder distinguishes; empty if it reconstructs
        light."""
        return self.settings.classes

    @property
    def buckets(self) -> int:
        """The number of readouts per exposure: 1, or 2 if pixels sort their light into two
        buckets."""
        return self.encoder.spec.buckets

    @property
    def emulated(self) -> EmulatedSensor | None:
        """The emulated sensor if `[sensor] effects` is set, else None.

        The first access measures it for the present codes, which takes seconds. It changes only
        with `follow_codes`, so it may belong to codes that are some steps old."""
        if self.settings.sensor.effects and self.tables.table is None:
            self.follow_codes()
        return self.tables.table

    def compiled(self, *, every_code: bool = False) -> Compiled:
        """Compile and prove the program of the present codes. With `every_code` it must work for
        every legal code. Raise Rejected if it does not fit the chip."""
        files = programs.program_of(self.encoder, self.chip)
        return programs.compiled(files, self.chip, every_code=every_code)

    def words_per_slot(self) -> float | None:
        """Return the words per slot of the present codes; None if the compiler refuses them."""
        with suppress(Rejected):
            every_code = self.settings.shutter.codes == "open"
            return programs.words_per_slot(self.compiled(every_code=every_code))
        return None

    def start_random(self, *numbers: int, near: Codes | None = None) -> None:
        """Set the encoder to random codes that compile for the chip, drawn with the run's seed and
        `numbers`.

        The first draw moves the codes `near` (None: there are none) at many places; later draws are
        independent of them. With the relaxation `arrange`, all draws give the present codes other
        places. Raises Rejected with the compiler's errors if none of `_MOST_DRAWS` draws compiles.
        The encoder then has the last ones."""
        encoder = self.encoder
        for attempt in range(_MOST_DRAWS):
            seeds = (self.settings.train.seed, DrawStream.RANDOM_CODES, *numbers, attempt)
            generator = np.random.default_rng(seeds)
            try:
                if near is not None and attempt == 0:
                    # No move of a single pixel: these codes shall differ clearly from `near`.
                    codes = candidate(encoder, near, generator, single_share=0.0)
                    encoder.load_codes(codes)
                elif encoder.relaxation == ARRANGE:
                    spec, codes = encoder.spec, encoder.codes()
                    codes = arranged(spec, codes, generator, _MIXING * spec.places)
                    encoder.load_codes(codes)
                else:
                    encoder.start_random(generator)
                self.compiled()
            except (Rejected, ValueError):  # ValueError: `require` forbids the moved codes
                if attempt == _MOST_DRAWS - 1:
                    raise
            else:
                return

    def random_tile(self, number: int) -> Tensor:
        """Return the shutters (N, rows, cols) of random codes number `number`, and use their
        emulated sensor, which stays until `follow_codes`. The encoder keeps its present codes.

        A decoder that learns random codes can judge codes before it is trained for one of them.
        Codes of odd numbers are the present ones after some moves, because a search begins there.
        With effects there are only `_MEASURED_CODES` different codes, because each needs a
        measurement; arrangements of the same shutters need none."""
        present = self.encoder.codes()
        if self.settings.sensor.effects and self.encoder.relaxation != ARRANGE:
            number %= _MEASURED_CODES
        self.start_random(number, near=present if number % 2 else None)
        self.follow_codes()
        tile = self.encoder.hard()
        self.encoder.load_codes(present)
        return tile

    def follow_codes(self) -> None:
        """Measure the emulated sensor of the present codes, if `[sensor] effects` is set and it is
        not known yet.

        A shutter's offset depends on its words: a pixel that opens after slot 0 subtracts a second
        value. A table of other codes is therefore wrong where few electrons matter. A measurement
        takes about a second for a tile of 2 x 2 pixels, and half a minute for hundreds of pixels.
        """
        if not self.settings.sensor.effects:
            return

        def measure() -> EmulatedSensor:
            """Compile the present codes and measure their emulated sensor."""
            container, effects = self.compiled().built, self.settings.sensor.effects
            return emulated_sensor(
                container, self.encoder.spec.tile, self.sensor, effects, self.chips
            )

        tables = self.tables
        follow = tables.arrange if self.encoder.relaxation == ARRANGE else tables.use
        follow(self.encoder.hard(), measure)


def make_setup(settings: RunSettings) -> TrainingSetup:
    """Build the objects of a configuration in their initial state: encoder, decoder, loss, sensor.

    Raises Rejected: NS0815 for settings that contradict each other, NS0812 for import paths, and
    the compiler's errors if the shutters cannot be compiled for the chip."""
    settings.check()
    chosen, network, seed = settings.shutter, settings.decoder, settings.train.seed
    files: dict[str, bytes] = {}
    chip = Chip(chosen.target, chosen.slot_us, chosen.require or None)
    if chip.file is None:
        target = load_target(chip.target, Path())
    else:
        files[programs.TARGET_FILE] = read_target(chip.file, Path())
        target = parse_target(files[programs.TARGET_FILE], chip.file)
        chip = replace(chip, table=target)
    protocol = load_protocol(settings.data.protocol)
    still = protocol.still
    encoder = started_encoder(chosen, chip, target, seed)
    programs.compiled(programs.program_of(encoder, chip), chip, every_code=chosen.codes == "open")
    sensor = default_sensor(target)
    if settings.sensor.file:
        path = Path(settings.sensor.file)
        files[programs.SENSOR_FILE] = read_sensor(path)
        sensor = parse_sensor(target, files[programs.SENSOR_FILE], str(path))
    task = DecoderTask(
        "still" if still else "clip",
        slots=chosen.slots,
        tile=encoder.spec.tile,
        sees_code=network.sees_code,
        buckets=chosen.buckets,
        guess={"by size": None, "yes": True, "no": False}[network.guess],
        classes=settings.classes,
    )
    # The parameters of a decoder come from torch's global generator, so its state is restored.
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        try:
            decoder = make_decoder(network.name, network.size, task, network.width)
            if isinstance(decoder, AnyCode) and network.lessons and not network.init:
                torch.manual_seed(seed)  # making the decoder takes more draws the first time
                decoder.begin_anew()
        except ValueError as error:
            raise invalid_setting("decoder.name", error) from error
    if network.init:
        _begin_with(decoder, network.init)
    decoder.requires_grad_(network.learn)
    learns = any(p.requires_grad for p in decoder.parameters())
    if not learns and not (chosen.learn and any(True for _ in encoder.parameters())):
        raise invalid_setting("shutter.learn", "neither the decoder nor the shutters can learn")
    device_name, has_cuda = settings.train.device, torch.cuda.is_available()
    if device_name == "cuda" and not has_cuda:
        raise invalid_setting("train.device", "CUDA is not available on this machine")
    device = torch.device("cuda" if device_name != "cpu" and has_cuda else "cpu")
    if settings.sensor.effects:
        selected(settings.sensor.effects)  # refuses unknown effects
    # Values of the sensor if a file or effects are named, else those of the protocol,
    # if it has any.
    named_sensor = settings.sensor.file or settings.sensor.effects
    fixed = not named_sensor and "full_well_e" in protocol.values
    model = SensorModel.of_protocol(protocol) if fixed else SensorModel.of(sensor, target)
    model = replace(
        model,
        comparator_noise=sensor.comparator_noise_fraction,
        comparator_offset=sensor.comparator_offset_fraction,
    )
    model = model if settings.sensor.noise else model.noiseless()
    return TrainingSetup(
        settings,
        protocol,
        still,
        chip,
        target,
        sensor,
        replace(model, slope=settings.sensor.slope),
        encoder.to(device),
        decoder.to(device),
        _loss(settings.loss.name),
        device,
        files,
    )


def started_encoder(chosen: ShutterSettings, chip: Chip, target: Target, seed: int) -> Encoder:
    """Return an encoder with the initial codes that the settings `chosen` name: a start, a run (a
    folder or the name of a shipped one), a file of codes (.npz) or a program (.nsl).

    `seed` is that of random starts. Raises Rejected (NS0815) for invalid settings and for codes
    that do not fit, and the errors of reading a file."""
    array = (target.rows, target.cols)
    tile = array if chosen.free else (chosen.tile[0], chosen.tile[1])
    if chosen.kind == LOOKS:
        tile = (1, chosen.exposures - 1)
    if tile != array and tile[0] * tile[1] > MOST_LISTED:
        raise invalid_setting(
            "shutter.tile",
            f"{tile[0]} x {tile[1]} are more than {MOST_LISTED} places, which only `free`, "
            "a code for every pixel, allows",
        )
    spec = ShutterSpec(
        chosen.kind,
        chosen.slots,
        # Class a has no codes, so its tile is a single pixel.
        (1, 1) if chosen.kind == "a" else tile,
        length=chosen.length if chosen.kind == "c" else None,
        rows=chosen.rows if chosen.kind == "codebook" else None,
        levels=most_steps(target, target.full_well_e) if chosen.kind == LOOKS else None,
        buckets=chosen.buckets,
    )
    named = chosen.init in _STARTS
    start = {"learned": "quad"}.get(chosen.init, chosen.init) if named else "quad"
    try:
        encoder = make_encoder(spec, start, seed, chosen.relaxation)
    except ValueError as error:
        raise invalid_setting("shutter", error) from error
    encoder.tried_share = chosen.tried_share
    if chip.require is not None:
        if not isinstance(encoder, Bump):
            raise invalid_setting("shutter.require", "it applies to the classes b, c and d")
        drawn = np.random.default_rng(seed) if start == "random" else None
        encoder.restrict(programs.legal_codes(spec, chip), drawn)
    if named and start != "random" and chosen.learn and chosen.relaxation in SLOPED:
        encoder.jitter(chosen.jitter, np.random.default_rng((seed, DrawStream.JITTER)))
    if not named:
        try:
            path = run_path(Path(chosen.init))
            path = path / programs.CODES_FILE if path.is_dir() else path
            if not path.suffix and not path.exists():
                starts = ", ".join(_STARTS)
                raise ValueError(f"no file or run has this name, and the starts are {starts}")
            if path.suffix.lower() == ".nsl":
                _begin_as(encoder, path, chip)
            else:
                encoder.load_codes(load_codes(path))
        except ValueError as error:
            reason = f"the codes of '{chosen.init}' do not fit: {error}"
            raise invalid_setting("shutter.init", reason) from error
    return encoder


def _begin_as(encoder: Encoder, path: Path, chip: Chip) -> None:
    """Set the codes of an encoder to those of the program at `path`, compiled for `chip`.

    Raises ValueError if the codes open other slots in the encoder than in the program, and for a
    program that does not fit the encoder."""
    codes, opened = begun_with(path, encoder.spec, chip)
    encoder.load_codes(codes)
    if opened is None:
        return
    hard = encoder.hard()
    mine = shared_out(hard, buckets=2) if len(opened) > 1 else hard[None]
    if not np.array_equal(mine.cpu().numpy() > 0, opened):
        bump = f" of {encoder.spec.length} slots" if encoder.spec.kind == "c" else ""
        raise ValueError(
            f"the program has other shutters of these codes than class {encoder.spec.kind}{bump}"
        )


def _begin_with(decoder: nn.Module, run: str) -> None:
    """Load the weights of a decoder from the folder or name of a `run`. Raise Rejected (NS0815) if
    they do not fit the decoder."""
    from safetensors.torch import load_file

    path = run_path(Path(run)) / WEIGHTS
    try:
        if not path.is_file():
            raise ValueError(f"the run has no {WEIGHTS}")
        check_size(path.stat().st_size)
        decoder.load_state_dict(load_file(str(path)))
    except Exception as error:  # safetensors raises its own type and several others
        reason = f"the weights of '{run[:200]}' do not fit: {one_line(error, 150)}"
        raise invalid_setting("decoder.init", reason) from error


def _loss(names: str) -> Loss:
    """Return the sum of the losses named in the text `names`, separated by "+", such as "l1 +
    psnr": names of `LOSSES`, or module:name. Raise Rejected for an unknown name or import path."""
    losses: list[Loss] = []
    for name in map(str.strip, names.split("+")):
        if not is_import_path(name) and name not in LOSSES:
            raise invalid_setting(
                "loss.name", f"unknown loss '{name[:60]}': the losses are {', '.join(LOSSES)}"
            )
        losses.append(_own_loss(name) if is_import_path(name) else LOSSES[name])
    if len(losses) == 1:
        return losses[0]
    return lambda prediction, truth: torch.stack([loss(prediction, truth) for loss in losses]).sum()


def _own_loss(name: str) -> Loss:
    """Return the loss that the Python function `name` (module:name) computes, in a function that
    checks its result. Raise Rejected (NS0812) if it cannot be imported."""
    call = imported(name, "loss")

    def loss(prediction: Tensor, truth: Tensor) -> Tensor:
        """Return the user's loss of `prediction` and `truth`, tensors of one shape, as a scalar.
        Raise Rejected (NS0822) if the function fails, or returns something else or a number without
        gradient."""
        with own_code(name, "loss"):
            value = call(prediction, truth)
        if not isinstance(value, Tensor) or value.numel() != 1:
            shape = tuple(value.shape) if isinstance(value, Tensor) else type(value).__name__
            raise own_failed(name, "loss", f"it returns {shape}, not a tensor of one number")
        if prediction.requires_grad and not value.requires_grad:
            raise own_failed(name, "loss", "its output has no gradient, so nothing can learn")
        return value.reshape(())

    return loss
