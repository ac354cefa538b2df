"""The container: a compiled program with everything that device, emulator and proof need."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import TYPE_CHECKING, Annotated

import numpy as np

from nscc.arrays import Array, Bools, Bytes, Floats, Ints, Ints32
from nscc.chips.target import Target
from nscc.mappings import NamedValues
from nscc.operations import Op, Word, op
from nscc.record import Record
from nscc.truth import unpacked_bits
from nscc.words.encoding import encode
from nscc.words.machine import NO_LOOKS, StateMachine, StatePlanes
from nscc.words.picture_launches import SteeredLaunch
from nscc.words.pictures import NO_PICTURES, Pictures

if TYPE_CHECKING:
    from nscc.words.stream import Stream


class StoredKernel(Record):
    """A list of words that is stored once on the controller and run at boundaries.

    `name` is its name in assembly text. A word is five integers of 32 bits."""

    name: str
    words: tuple[Word, ...]


class Launch(Record):
    """The start of a kernel (list of words) at boundary `instant`: 0 is the start of the frame, n
    the boundary before slot n, and N the end of the last slot.

    `kernel` is the kernel's index in the container (a compiled program). IN, the value that all
    pixels receive, is set to `level` steps before; None leaves it unchanged."""

    instant: int
    kernel: int
    level: int | None = None


class Readout(Record):
    """A bucket's readout: after the frame, its exposure in electrons is `register` times `gain`.

    For a chip without logic `register` is a tap, and the exposure is measured at the converter."""

    register: str
    bucket: str
    gain: float = 1.0


class DecodeTable(Record, eq=False):
    """The shutters of all codes of a program.

    `fields` are the names of the code's fields. `codes` int64 (codes, fields) are the field values
    of every code. `shutter_of_code` int32 (codes,) is the index of each code's shutter. `shutters`
    bool (shutters, buckets, slots) are the distinct shutters: whether a bucket is open in a slot. A
    program without fields has one code without fields."""

    fields: tuple[str, ...]
    codes: Annotated[Ints, "codes fields"]
    shutter_of_code: Annotated[Ints32, "codes"]
    shutters: Annotated[Bools, "shutters buckets slots"]

    def __repr__(self) -> str:
        """Return the numbers of codes, shutters, buckets and slots as one line."""
        fields, (shutters, buckets, slots) = ", ".join(self.fields), self.shutters.shape
        return (
            f"DecodeTable({len(self.codes)} codes of ({fields}), {shutters} shutters, "
            f"{buckets} buckets, {slots} slots)"
        )


@dataclass(frozen=True, eq=False, repr=False)
class Container:
    """A compiled shutter program (`.icw`).

    `encoding` bool (shutters, registers of the target) contains, for each shutter, the digital
    registers of a pixel at the start of a frame. `pixel_codes` int32 (rows, cols) is the row of
    `table.codes` at each pixel, None for a program without data. `code_registers` are the digital
    registers that contain code, in the order in which a device must load them (R12 before R0).
    `source_lines` is the program's text for listings. `notes` are texts that the compiler stores
    (lowering, class, open or fixed codes).

    If shutters depend on the light, `machine` is the state machine. Then the rows of `encoding` and
    the shutters of the table belong to its behaviours, and the table has their shutters in the
    dark. `state_planes` are the registers of the states that are read or kept, by name.

    A chip without logic has no words: `stream` is the data that it receives. It follows from table
    and pixel codes (`nscc.stream.passes.with_planes_of_route`), and is None without pixel codes.

    `pictures` are images and planes that are computed after the last slot; their words run after
    all `launches`. `readouts` then name the registers of the exposures before these words. A
    lowering is a way to compute the exposure."""

    target: Target
    slot_us: tuple[float, ...]
    buckets: tuple[str, ...]
    table: DecodeTable
    kernels: tuple[StoredKernel, ...]
    launches: tuple[Launch, ...]
    code_registers: tuple[str, ...]
    encoding: Bools
    pixel_codes: Ints32 | None
    readouts: tuple[Readout, ...]
    source_lines: tuple[str, ...] = ()
    notes: Mapping[str, str] = field(default_factory=dict)
    machine: StateMachine = NO_LOOKS
    state_planes: Mapping[str, StatePlanes] = field(default_factory=dict)
    stream: Stream | None = None
    pictures: Pictures = NO_PICTURES

    def __getstate__(self) -> NamedValues:
        """Return the fields by name for copies and pickles, without the results that properties
        cache."""
        return {field.name: getattr(self, field.name) for field in fields(self)}

    @property
    def slot_s(self) -> Floats:
        """The lengths of the slots (N,) in seconds."""
        return np.array(self.slot_us, np.float64) * 1e-6

    @property
    def slots(self) -> int:
        """The number of slots in the frame."""
        return len(self.slot_us)

    @property
    def reads(self) -> tuple[str, ...]:
        """The names of the buckets, images and planes that are read out with a frame, in order.

        Without images and planes these are all buckets."""
        return self.pictures.reads if self.pictures.outputs else self.buckets

    @property
    def buckets_read(self) -> tuple[str, ...]:
        """The names of the buckets that are read out with a frame, in order; perhaps none, if
        images or planes are read."""
        return tuple(name for name in self.reads if name in self.buckets)

    @property
    def keeps_states(self) -> bool:
        """Whether states go on from frame to frame; a frame then depends on the ones before."""
        return self.machine.keeps or bool(self.pictures.states or self.pictures.kept_images)

    @property
    def words_stored(self) -> int:
        """The number of words in the chip's store, with those of images and planes."""
        after = sum(map(len, self.pictures.kernels))
        return sum(len(kernel.words) for kernel in self.kernels) + after

    @property
    def words_per_frame(self) -> int:
        """The number of words that a frame executes, with those after the last slot; parameters
        have their starts."""
        words = sum(len(self.kernels[launch.kernel].words) for launch in self.launches)
        return words + self.pictures.words

    def __repr__(self) -> str:
        """Return the numbers of codes, slots and words, and the target, as one line."""
        return (
            f"Container({len(self.table.codes)} codes, {self.slots} slots, {self.words_stored} "
            f"words, {self.words_per_frame} a frame, for {self.target.name})"
        )

    @property
    def has_table(self) -> bool:
        """Whether there is a decode table; hand-written words may have none, and then a note
        `table` with the value "none"."""
        return self.notes.get("table") != "none"

    def planes(self) -> dict[str, Bools]:
        """Return the bit planes that the host loads before a frame, bool (rows, cols), by register,
        in loading order.

        They hold the pixel codes and, if the container is one of `with_picture_words`, the input
        planes and starts of states. The result is empty without `pixel_codes`."""
        if self.pixel_codes is None:
            return {}
        inputs = {self.pictures.registers.get(each.name): each for each in self.pictures.inputs}
        shutter = self.table.shutter_of_code.astype(np.intp).take(self.pixel_codes)
        column = {name: i for i, name in enumerate(self.target.digital_registers)}
        shape = self.target.rows, self.target.cols
        return {
            name: unpacked_bits(inputs[name].bits, shape)
            if name in inputs
            else self.encoding[:, column[name]].take(shutter)
            for name in self.code_registers
        }


def kept_starts(container: Container) -> dict[int, list[str]]:
    """Return the registers of kept images by the value of IN (the level sent to all pixels), in
    steps, that sets them to their starts; {} if no image is kept.

    A start between two steps becomes the nearest one: see `nscc.words.legality.loader_fault`."""
    pictures, starts = container.pictures, dict[int, list[str]]()
    for image in pictures.kept_images:
        sign = 1 if image.name in pictures.negated else -1  # a bus inverts what it reads
        level = sign * round(image.start_e / container.target.electrons_per_step)
        starts.setdefault(level, []).append(pictures.registers[image.name])
    return starts


def steered_launches(container: Container) -> list[SteeredLaunch | None]:
    """Return for each launch (start of a kernel) of `with_picture_words` how parameters change it;
    None for the launches of the exposure, which they do not change.

    After the exposure come launches that set kept images to their starts. Their `kernel` and
    `level` are not stated (0 and None)."""
    start = SteeredLaunch(0, level=None, level_of=None, times=None, step=0, is_start=True)
    starts, exposing = len(kept_starts(container)), len(container.launches)
    return [*[None] * exposing, *[start] * starts, *container.pictures.steered()]


def starting(registers: Sequence[str]) -> tuple[Op, ...]:
    """Return the words that set analog registers to minus IN (the level sent to all pixels) in all
    pixels."""
    return (op("all"), *(op("bus", [register], ["IN"]) for register in registers))


def with_picture_words(container: Container) -> Container:
    """Return the container (a compiled program) as a chip executes it.

    Its kernels (lists of words) and launches include the words of images and planes, and before
    them those that set kept images to their starts, which are for the first frame only. Its
    readouts are the registers that the chip converts: first buckets, then images. Its code
    registers include the registers of kept states and input planes, which a device loads with their
    starts before the first frame. Its loops have their largest number of steps
    (`Pictures.steered`). A launch is the start of a kernel, a list of words."""
    pictures, first = container.pictures, len(container.kernels)
    readouts = {readout.bucket: readout for readout in container.readouts}
    readouts |= {name: Readout(register, name) for name, register in pictures.registers.items()}
    starts = {pictures.registers[state.name]: state.start for state in pictures.states}
    kept, after = kept_starts(container), first + len(pictures.kernels)
    encoding = container.encoding.copy()
    # Every shutter's row gets the start of a state, because it does not depend on the code.
    for register, start in starts.items():
        encoding[:, container.target.digital_registers.index(register)] = start
    return replace(
        container,
        encoding=encoding,
        code_registers=(
            *container.code_registers,
            *starts,
            *(pictures.registers[plane.name] for plane in pictures.inputs),
        ),
        kernels=(
            *container.kernels,
            *(StoredKernel(f"image{n}", words) for n, words in enumerate(pictures.kernels)),
            *(
                StoredKernel(f"start{n}", tuple(encode(each) for each in starting(registers)))
                for n, registers in enumerate(kept.values())
            ),
        ),
        launches=(
            *container.launches,
            *(Launch(container.slots, after + n, level) for n, level in enumerate(kept)),
            *(
                Launch(container.slots, first + launch.kernel, launch.level)
                for launch in pictures.steered()
            ),
        ),
        readouts=tuple(readouts[name] for name in (*container.buckets_read, *pictures.images_sent)),
        pictures=replace(pictures, kernels=(), launches=(), loops=(), levels_of=()),
    )


def state_registers(container: Container) -> tuple[str, ...]:
    """Return the digital registers of the states and planes that are read out or reported, each
    once.

    Those of planes come first, in the order of outputs."""
    pictures, digital = container.pictures, container.target.digital_registers
    planes = (pictures.registers.get(name) for name in pictures.outputs)
    read = (state.name for state in container.machine.states if state.read)
    registers = (r for name in read for r in container.state_planes[name].registers)
    return tuple(dict.fromkeys((*(r for r in planes if r in digital), *registers)))


def packed_shutters(container: Container, shutters: Bools) -> tuple[Bytes, Ints]:
    """Return `shutter` and `shutter_shape` of a frame file, for a container (a compiled program)
    with pixel codes.

    `shutters` is bool (distinct shutters, buckets, N), in the order of the decode table. The first
    result is uint8 (buckets, rows, cols, ceil(N / 8)), packed along N with the first slot in the
    lowest bit. The second is (buckets, rows, cols, N). Raises ValueError for a container without
    pixel codes."""
    if container.pixel_codes is None:
        raise ValueError(
            "a program without pixels has no shutters on the array: add a `pixels` statement"
        )
    packed = np.packbits(shutters, axis=-1, bitorder="little")
    at_pixel = container.table.shutter_of_code[container.pixel_codes]
    laid = np.stack([packed[:, b][at_pixel] for b in range(shutters.shape[1])])
    shape = (*laid.shape[:3], shutters.shape[2])
    return laid, np.array(shape, np.int64)


def fields_at_pixels(container: Container) -> dict[str, Ints]:
    """Return the arrays `codes_FIELD` of a frame file by name: int64 (rows, cols), the value of
    each field of the code at every pixel.

    The result is empty without `pixel_codes`."""
    table, pixels = container.table, container.pixel_codes
    if pixels is None:
        return {}
    return {f"codes_{name}": table.codes[:, i][pixels] for i, name in enumerate(table.fields)}


def tile_of(codes: Array) -> tuple[int, int]:
    """Return the size (rows, cols) of the smallest tile that gives the array `codes` when it is
    repeated.

    `codes` has two axes (rows, cols). The last repetitions may be cut. If the array does not
    repeat, this is its own size."""
    rows = _period(codes)
    return rows, _period(codes[:rows].T)


def _period(plane: Array) -> int:
    """Return the smallest number of rows after which `plane`, an array (rows, cols), repeats; all
    rows if it does not."""
    for period in range(1, len(plane)):
        # One row excludes most periods; the whole plane is compared only for the others.
        same = np.array_equal(plane[period], plane[0])
        if same and np.array_equal(plane[period:], plane[:-period]):
            return period
    return len(plane)
