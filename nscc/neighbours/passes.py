"""The compiler pass that adds the words of images and planes after a container's exposure."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product, takewhile
from math import ceil, log2
from typing import Any, NamedTuple

from nscc.cache.results import Results
from nscc.diagnostics.diagnostic import Diagnostic, Label, Severity
from nscc.lower.exposure_plan import RETENTION_SHARE
from nscc.lower.resources import time_text
from nscc.neighbours.alternatives import alternatives
from nscc.neighbours.count_words import MOST_IMAGES
from nscc.neighbours.held import Level, Leveled, LoopWords, PictureRefused
from nscc.neighbours.inlined import with_moves_where_read, without_second_names
from nscc.neighbours.last_use import by_last_use
from nscc.neighbours.loops import kept_ranges
from nscc.neighbours.lower import Lowering
from nscc.neighbours.synthesis import STEPS_OF_LEVEL, Synthesis
from nscc.neighbours.table import WordForms
from nscc.operations import Op
from nscc.program.limits import largest
from nscc.program.program import Program
from nscc.prove.meaning import reaches
from nscc.syntax.parse import declared_at
from nscc.words.container import Container
from nscc.words.encoding import encode
from nscc.words.picture_launches import LaunchLoop, LevelOf, TailLaunch
from nscc.words.pictures import (
    Condition,
    Node,
    Picture,
    PictureCost,
    Pictures,
    Repeated,
    Sum,
    Weights,
    with_operands,
)

_LEVEL_OF_ALTERNATIVES = 2
"""Least optimisation level at which equivalent forms of the images are tried."""
_MOST_RANGES = 6
"""Most ranges of a kept image that are tried one after another, each wider by the values that the
image reached; after these, the range of registers is tried."""
_LEVEL_OF_CHANGES, _STEPS_OF_CHANGES = 1, 4000
"""Highest optimisation level at which an error message tries changes of a program, and the steps of
the searches for all of them."""
_MOST_READS_TRIED = 6
"""Most numbers of images and planes to read out that an error message tries."""


def with_pictures(
    container: Container, program: Program, level: int, results: Results | None = None
) -> tuple[Container, Sequence[Diagnostic]]:
    """Return the container (a compiled program) with the words of the program's images and planes,
    and no errors; or the container unchanged, with one error.

    The errors are: states that fade within a frame (NS0602), too few registers or too little
    instruction store (NS0535), values beyond the range of the registers (NS0540), and images that
    read pixels too far away (NS0541). `level` is that of `-O`; `results` is a cache of earlier
    searches, None without one."""
    pictures = program.pictures
    far = _too_far(pictures, program) or _fading(pictures, program)
    if far is not None:
        return container, [far]
    try:
        lowering = lowered(container, pictures, level, results)
    except PictureRefused as refused:
        return container, [_refusal(refused, container, program, level)]
    sent = grouped(lowering.words, lowering.loops)
    with_words = replace(
        pictures,
        kernels=tuple(tuple(encode(word) for word in kernel) for kernel in sent.kernels),
        launches=sent.launches,
        loops=sent.loops,
        levels_of=sent.levels_of,
        negated=lowering.pictures.negated,
        registers=dict(sorted(lowering.registers.items())),
        costs=_costs_of_text(lowering.costs, pictures),
    )
    complete = replace(container, pictures=with_words)
    most = container.target.store_words
    if complete.words_stored > most:
        full = PictureRefused("store", with_words.costs[-1].name, complete.words_stored, most)
        return container, [_refusal(full, container, program, level)]
    return complete, []


def _costs_of_text(costs: Sequence[PictureCost], pictures: Pictures) -> tuple[PictureCost, ...]:
    """Return the costs of the images and planes of the program text, in its order.

    `costs` are those of all items, in the order in which they were lowered. The words of items that
    the compiler added count for the next image of the text. An image without words of its own has
    zeros."""
    names = [*pictures.expressions]
    cost_of: dict[str, PictureCost] = {}
    shared_words = 0
    for cost in costs:
        if cost.name in names:
            cost_of[cost.name] = replace(cost, words=cost.words + shared_words)
        shared_words = 0 if cost.name in names else shared_words + cost.words
    return tuple(
        cost_of.get(name, PictureCost(name, words=0, peak_gain=0.0, noise_gain=0.0))
        for name in names
    )


def lowered(
    container: Container, pictures: Pictures, level: int, results: Results | None = None
) -> Lowering:
    """Return the words of images and planes after a container's exposure, as a `Lowering` that has
    run.

    `level` is that of `-O`, 0 to 3. From level 2 on, the result is the shortest of several
    alternatives. What does not fit in the order of the text is ordered by last use. `results` is a
    cache of earlier searches, None without one. Raises PictureRefused, with the reason of the first
    attempt, if nothing fits."""
    forms = WordForms.choices(container.target)
    searches = [Synthesis(STEPS_OF_LEVEL[level], form, results) for form in forms]
    return _shortest(container, pictures, level, searches)


def _shortest(
    container: Container, pictures: Pictures, level: int, searches: Sequence[Synthesis]
) -> Lowering:
    """Return the lowering (a way to compute the exposure) with the fewest words among several forms
    of the images and several `searches` for kernels.

    From the level of optimisation `_LEVEL_OF_ALTERNATIVES` on, equivalent forms of the images are
    tried as well. If no form fits the registers, the images are computed in another order. Raises
    PictureRefused, with the reason of the first form, if this does not fit either, or if values
    exceed the range."""
    pictures = replace(
        pictures,
        items=tuple(Picture(item.name, _without_zeros(item.node)) for item in pictures.items),
        states=tuple(replace(s, next=_without_zeros(s.next)) for s in pictures.states),
        kept_images=tuple(replace(s, next=_without_zeros(s.next)) for s in pictures.kept_images),
    )
    if pictures.is_of_version_4:
        pictures = without_second_names(pictures)
    ways = [pictures]
    if level >= _LEVEL_OF_ALTERNATIVES and not (pictures.repeated or pictures.kept_images):
        ways += alternatives(pictures)
    readable = {*pictures.outputs}
    inner = tuple(image.name for image in pictures.kept_images if image.name not in readable)
    if inner:  # a register may hold the negative of a kept image
        ways.append(replace(pictures, negated=inner))
    best, refused = _first_or_best(container, product(searches, ways), first=False)
    # Another order does not change the range of values.
    if best is None and refused is not None and refused.kind != "range":
        orders = product(searches, _with_fewer_registers(pictures))
        best, _ = _first_or_best(container, orders, first=True)
    if best is None:
        assert refused is not None
        raise refused
    return best


def _first_or_best(
    container: Container, ways: Iterable[tuple[Synthesis, Pictures]], *, first: bool
) -> tuple[Lowering | None, PictureRefused | None]:
    """Return the lowering of `ways` with the fewest words, or with `first` the first that fits.

    `ways` are pairs (search for kernels, images and planes). Also return why the first way that
    does not fit is refused. The lowering is None if none fits, the reason None if all that were
    tried fit."""
    best: Lowering | None = None
    refused: PictureRefused | None = None
    for synthesis, way in ways:
        try:
            lowering = _lowered(container, way, synthesis)
        except PictureRefused as error:
            refused = refused or error
            continue
        if best is None or len(lowering.words) < len(best.words):
            best = lowering
        if first:
            break
    return best, refused


def _with_fewer_registers(pictures: Pictures) -> list[Pictures]:
    """Return equivalent forms of the images and planes that may need fewer registers, in the order
    in which they are tried; [] if there are none.

    Repeated items cannot be ordered by last use. Only in programs of version 4 are shifts of images
    written where they are read."""
    ways = [] if pictures.repeated else [by_last_use(pictures), by_last_use(pictures, eager=True)]
    if pictures.is_of_version_4:
        moved = with_moves_where_read(pictures)
        ways += [moved] if moved.repeated else [moved, by_last_use(moved)]
    return ways


def _without_zeros(node: Node) -> Any:
    """Return an expression in which sums have no terms that are multiplied by 0, also sums inside
    it; a sum may then have no terms."""
    if isinstance(node, Sum):
        node = Sum(tuple(term for term in node.terms if term[0]))
    return with_operands(node, _without_zeros)


def _lowered(container: Container, pictures: Pictures, synthesis: Synthesis) -> Lowering:
    """Return the lowering (a way to compute the exposure) of images and planes in their order;
    `synthesis` finds the words of kernels.

    Kept images begin with a range of values that every frame keeps. It is found by widening the
    range until their next values stay inside. Raises PictureRefused if the words do not fit the
    chip."""
    most_e = max(pictures.limits_e.values(), default=0.0)
    ranges = {
        image.name: (min(0.0, image.start_e), max(most_e, image.start_e))
        for image in pictures.kept_images
    }
    widest = container.target.register_min_e, container.target.register_max_e
    history = [ranges]
    # Attempts 0 to `_MOST_RANGES` - 1 each widen the ranges to the values that were reached, the
    # last of them to an estimated limit. Where a range is still too small, that of the registers
    # replaces it; this may widen an image that depends on it, so there is an attempt for each.
    for number in range(_MOST_RANGES + 1 + len(ranges)):
        lowering = _lowered_with(container, pictures, synthesis, ranges)
        wider = kept_ranges(lowering, lowering.next_values)
        if not wider:
            break
        ranges = ranges | wider
        history.append(ranges)
        if number == _MOST_RANGES - 1:  # the limit of ranges that grow by less and less
            last_three = [[ranges_[name] for name in wider] for ranges_ in history[-3:]]
            for name, ends in zip(wider, zip(*last_three, strict=True), strict=True):
                low, high = map(_limit, *ends)
                ranges = ranges | {name: (low, high)}
        elif number >= _MOST_RANGES:
            ranges = ranges | dict.fromkeys(wider, widest)
    return lowering


def _limit(first: float, second: float, third: float) -> float:
    """Return the limit of a sequence whose steps shrink by a constant factor, and a little more, so
    that rounding does not leave it (Aitken).

    The arguments are three consecutive numbers of the sequence. If the steps do not shrink, or the
    last one is 0, return `third`."""
    step, next_step = second - first, third - second
    if not 0 < abs(next_step) < abs(step):
        return third
    return third + next_step**2 / (step - next_step) * (1 + 1e-6)


def _lowered_with(
    container: Container,
    pictures: Pictures,
    synthesis: Synthesis,
    ranges: Mapping[str, tuple[float, float]],
) -> Lowering:
    """Return the lowering (a way to compute the exposure) that counts as many images together as
    registers allow.

    `ranges` gives the (least, largest value) of each kept image before a frame, in electrons.
    Raises PictureRefused if the words do not fit even if every image is counted alone."""
    for most_together in range(MOST_IMAGES, 0, -1):
        lowering = Lowering(pictures, container, synthesis, ranges)
        lowering.most_together = most_together
        try:
            lowering.run()
        except PictureRefused as refused:
            # Fewer images at once need fewer analog registers, and nothing else less.
            if refused.kind != "registers" or not pictures.count_steps or most_together == 1:
                raise
        else:
            break
    return lowering


class _Sent(NamedTuple):
    """Words as the host sends them: the different kernels, the launches, the loops over launches,
    and the levels that follow from parameters."""

    kernels: list[tuple[Op, ...]]
    launches: tuple[TailLaunch, ...]
    loops: tuple[LaunchLoop, ...]
    levels_of: tuple[LevelOf, ...]


def grouped(words: Sequence[Leveled], loops: Sequence[LoopWords] = ()) -> _Sent:
    """Group words into kernels (lists of words), one per value of IN (the level sent to all
    pixels), and store equal kernels once.

    `words` are pairs (word, level): the level is a number of steps of IN, a pair (parameter,
    factor), or None for a word that does not read IN, which joins any group. `loops` refer to words
    by index, and consist of whole groups. Kernels are in the order in which they first run."""
    runs: list[tuple[list[Op], Level]] = []
    ends = {end for loop in loops for end in (loop.begin, loop.end)}
    # The launch at which each loop begins and ends; that of the end of all words is set below.
    launch_at: dict[int, int] = {len(words): 0}
    for index, (word, level) in enumerate(words):
        begins = index in ends
        if not runs or begins or (level is not None and runs[-1][1] not in (None, level)):
            runs.append(([], None))
        if begins:
            launch_at[index] = len(runs) - 1
        run, before = runs[-1]
        run.append(word)
        runs[-1] = run, before if level is None else level
    number: dict[tuple[Op, ...], int] = {}
    launches: list[TailLaunch] = []
    levels_of: list[LevelOf] = []
    for run, level in runs:
        if isinstance(level, tuple):
            levels_of.append(LevelOf(len(launches), *level))
            level = None
        launches.append(TailLaunch(number.setdefault(tuple(run), len(number)), level))
    launch_at[len(words)] = len(launches)
    stored_loops = []
    for loop in loops:
        first, end = launch_at[loop.begin], launch_at[loop.end]
        stored_loops.append(LaunchLoop(first, end - first, loop.times, loop.values))
    return _Sent(list(number), tuple(launches), tuple(stored_loops), tuple(levels_of))


_MORE_HALVINGS = 3
"""Number of divisors tried, from the smallest that could suffice."""


def _with_item_divided(pictures: Pictures, name: str, divisor: int) -> Pictures:
    """Return the images and planes with the image `name` divided by `divisor`, all others
    unchanged.

    Planes and repeated images of this name are not divided."""
    items = []
    for item in pictures.items:
        node = item.node
        if item.name == name and not isinstance(node, Condition | Repeated):
            node = Sum(((Fraction(1, divisor), node),))
        items.append(replace(item, node=node))
    return replace(pictures, items=tuple(items))


def _too_far(pictures: Pictures, program: Program) -> Diagnostic | None:
    """Return the error (NS0541) if an image or plane depends on pixels more than a quarter of the
    array away, else None.

    It is for the first such name; columns are checked before rows."""
    target = program.target
    for name, reach in reaches(pictures, of_a_step=True).items():
        for size, limit, unit in (
            (max(reach.left, reach.right), target.cols // 4, "columns"),
            (max(reach.up, reach.down), target.rows // 4, "rows"),
        ):
            if size > limit:
                return Diagnostic(
                    "NS0541",
                    f"`{name}` depends on pixels {size} {unit} away, but at most {limit} are "
                    f"allowed, a quarter of the array of {target.name}",
                    source=program.source,
                    label=Label(declared_at(program.source, name), "depends on these pixels"),
                    helps=("use smaller convolution kernels, or apply fewer of them in sequence",),
                    data={"resource": "reach", "required": size, "available": limit},
                )
    return None


def _fading(pictures: Pictures, program: Program) -> Diagnostic | None:
    """Return the error (NS0602) if a frame lasts longer than digital registers keep the bits of
    states, else None.

    Readouts of images and buckets count as part of the frame. Only `RETENTION_SHARE` of the chip's
    retention time is used. Without states, nothing fades."""
    target = program.target
    keep_us = RETENTION_SHARE * target.digital_retention_us
    values_read = sum(name not in pictures.planes for name in pictures.reads)
    frame_us = sum(program.frame.slot_us) + values_read * target.readout_us
    if not pictures.states or frame_us <= keep_us:
        return None
    return Diagnostic(
        "NS0602",
        f"digital registers lose their bits within this frame: it lasts {time_text(frame_us)} with "
        f"its readouts; {target.name} keeps them for {time_text(target.digital_retention_us)}",
        source=program.source,
        label=Label(program.frame.span, "too long for a state that is kept"),
        notes=(
            "a state is written once a frame, after the last slot; nscc uses "
            f"{RETENTION_SHARE:.0%} of the retention time",
        ),
        helps=("use shorter slots, or read fewer images",),
        data={"resource": "retention_us", "required": frame_us, "available": keep_us},
    )


def _refusal(
    refused: PictureRefused, container: Container, program: Program, level: int
) -> Diagnostic:
    """Return the error for images that do not fit (NS0535), or whose values leave the range
    (NS0540).

    `refused` says what is lacking; it must not be of the kind "steps" (a search that ran out of
    steps). `level` is the level of optimisation, 0 to 3."""
    name, needed, available = _in_text(program, refused.name), refused.needed, refused.available
    label = Label(declared_at(program.source, name), "computed here")
    if refused.kind == "range":
        return _beyond_range(refused, container, program, level)
    resource = {
        "halvings": "halvings",  # weights are multiples of 1 / UNIT = 2^-40
        "registers": "analog registers",
        "planes": "digital registers",
        "steering": "registers that choose neighbours",
        "store": "words in the store",
    }[refused.kind]
    # The help depends on what is lacking.
    notes, helps = [], [f"divide by at most 2^{available:g} in all"]
    if refused.kind != "halvings":
        helps = _changes_that_fit(program.pictures, _Changes(container, level, refused))
    if refused.kind == "registers":
        holders = (f"{readout.register} holds {readout.bucket}" for readout in container.readouts)
        notes.append(f"exposures also occupy registers: {', '.join(holders)}")
    elif refused.kind in ("planes", "steering") and container.code_registers:
        notes.append(f"pixel codes also occupy registers: {', '.join(container.code_registers)}")
        helps = ["use fewer different pixel codes", *helps]
    if refused.kind == "planes":
        held = [f"`{each}`" for each in program.pictures.held_planes]
        notes += [f"registers keep these from frame to frame: {', '.join(held)}"] if held else []
        last = [_in_text(program, each) for each in program.pictures.steering[-1:]]
        notes += [f"R1 to R4 choose neighbours until `{last[0]}` is computed"] if last else []
    reports = program.pictures.reports
    reported = {report.plane for report in reports if report.kind not in ("sum", "flood")}
    before = takewhile(lambda item: item.name != name, program.pictures.items)
    fitting = len([item for item in before if item.name in reported])
    if refused.kind == "planes" and len(reported) > 1 and fitting:
        helps.append(
            "a reported plane keeps its register until the end of the frame: report at most "
            f"{fitting} of these {len(reported)} planes, or count one plane in several frames, "
            "with a level `param t`"
        )
    return Diagnostic(
        "NS0535",
        f"`{name}` needs {needed:g} {resource} or more, but {available:g} are available",
        source=program.source,
        label=label,
        notes=tuple(notes),
        helps=tuple(helps),
        data={"resource": resource, "required": needed, "available": available, "proved": False},
    )


def _in_text(program: Program, name: str) -> str:
    """Return the name, in the program's text, of the image or plane to which `name` belongs.

    A part comes before its image or plane, and its own name is no name of a program. A bit of a
    state is called by the name of the state, a blank and its number."""
    names, states = [*program.pictures.expressions], program.pictures.stepping
    after = names[names.index(name) :] if name in names and name not in states else []
    return next(filter(str.isidentifier, after), name.partition(" ")[0])


class _Changes:
    """Changes of images and planes that an error message tries; `fits` compiles each with few steps
    for all of them, and `refused` is why the last one without success was refused."""

    def __init__(self, container: Container, level: int, refused: PictureRefused) -> None:
        """Prepare the searches. `level` is the user's level of optimisation; at most
        `_LEVEL_OF_CHANGES` is used, to be fast. `refused` is why the program itself is refused."""
        self._container, self._level = container, min(level, _LEVEL_OF_CHANGES)
        self.refused = refused
        forms = WordForms.choices(container.target)
        self._searches = [Synthesis(STEPS_OF_LEVEL[self._level], form) for form in forms]
        for search in self._searches:
            search.budget = _STEPS_OF_CHANGES

    def fits(self, changed: Pictures) -> bool:
        """Return whether the words of these images and planes fit the registers and the store."""
        try:
            lowering = _shortest(self._container, changed, self._level, self._searches)
        except PictureRefused as refused:
            # A search without steps left tells nothing about the program.
            self.refused = self.refused if refused.kind == "steps" else refused
            return False
        stored = sum(map(len, grouped(lowering.words, lowering.loops).kernels))
        return self._container.words_stored + stored <= self._container.target.store_words

    def fits_with_limit(self, pictures: Pictures, percent: int) -> bool:
        """Return whether images and planes fit if exposures reach `percent` of a full well."""
        limit_e = percent / 100 * self._container.target.full_well_e
        return self.fits(replace(pictures, limits_e=dict.fromkeys(pictures.limits_e, limit_e)))


_LOWER_LIMIT, _LIMIT_TRIED = "limit the exposure: `assume exposure <= {}%` compiles", 50
"""A help, and the limit in percent that is tried where registers run out."""


def _changes_that_fit(pictures: Pictures, changes: _Changes) -> list[str]:
    """Return the helps for images and planes that do not fit: how many of those that are read out
    fit, counted from the first, if nothing else is computed; and the largest part of the kernels
    that fits. What fits was compiled; if nothing does, the help is general."""
    reads, helps = pictures.reads, []

    def with_first(count: int) -> Pictures:
        """Return the first images and planes that are read out, and what they depend on."""
        less, before = replace(pictures, reads=reads[:count]), None
        while less != before:
            less, before = without_second_names(less), less
        return less

    count = largest(
        1, len(reads) - 1, lambda count: changes.fits(with_first(count)), _MOST_READS_TRIED
    )
    if count is not None:
        first = f"the first {count} of {len(reads)} images and planes"
        helps.append(f"compute and read out only {first}: this compiles")
    sides = [max(len(w.rows), len(w.rows[0])) for w in pictures.weights]
    for side in range(max(sides, default=0) - 2, 1, -2):
        if changes.fits(replace(pictures, weights=_middles(pictures.weights, side))):
            helps.append(f"use the middle {side} x {side} weights of larger kernels: this compiles")
            break
    # Of the programs of a kernel, those with few registers may have larger values.
    if not helps and pictures.limits_e and changes.fits_with_limit(pictures, _LIMIT_TRIED):
        helps.append(_LOWER_LIMIT.format(_LIMIT_TRIED))
    return helps or ["read out fewer images and planes, or use smaller convolution kernels"]


def _middles(kernels: Sequence[Weights], side: int) -> tuple[Weights, ...]:
    """Return convolution kernels without what lies outside their middle `side` x `side`, odd."""

    def middle(values: tuple[Any, ...]) -> tuple[Any, ...]:
        """Return the values in the middle, all if there are no more than `side`."""
        beyond = max(0, (len(values) - side) // 2)
        return values[beyond : len(values) - beyond]

    return tuple(
        replace(kernel, rows=tuple(middle(row) for row in middle(kernel.rows)))
        for kernel in kernels
    )


def _beyond_range(
    refused: PictureRefused, container: Container, program: Program, level: int
) -> Diagnostic:
    """Return the error (NS0540) for values that leave the range of registers.

    Its helps are a divisor of the image, and a limit of the exposure; each was compiled and fits.
    If neither was found, there is a general help. `level` is the user's level of optimisation; the
    search for changes uses at most `_LEVEL_OF_CHANGES`, to be fast."""
    pictures, over = program.pictures, refused.needed
    target = container.target
    helps = []
    notes = [
        f"registers of {target.name} hold {target.register_min_e:g} to {target.register_max_e:g} e"
    ]
    changes = _Changes(container, level, refused)
    # The fewest halvings with which the value fits, up to rounding.
    least_halvings = max(1, ceil(log2(over) - 1e-9))
    for halvings in range(least_halvings, least_halvings + _MORE_HALVINGS):
        if changes.fits(_with_item_divided(pictures, refused.name, 2**halvings)):
            helps.append(f"divide `{refused.name}` or its kernels by {2**halvings}: this compiles")
            break
    limit_percent = 100 * max(pictures.limits_e.values()) / target.full_well_e
    # The largest whole limit with which this value fits, up to rounding. If another value does not
    # fit, the limit is halved.
    percent = int(limit_percent / over + 1e-9)
    while percent >= 1:
        if changes.fits_with_limit(pictures, percent):
            helps.append(_LOWER_LIMIT.format(percent))
            break
        percent //= 2
    if not helps:
        helps.append("use smaller factors, or fewer and smaller convolution kernels")
        if changes.refused.kind != "range":
            other = _refusal(changes.refused, container, program, level).message
            notes.append(f"smaller values do not fit either: {other}")
    return Diagnostic(
        "NS0540",
        f"while `{refused.name}` is computed, a value reaches {ceil(over * 1000) / 1000:.4g} times "
        "the range of the registers",
        Severity.ERROR,
        source=program.source,
        label=Label(
            declared_at(program.source, refused.name),
            f"too large for exposures up to {limit_percent:.3g}% of a full well",
        ),
        notes=tuple(notes),
        helps=tuple(helps),
        data={"resource": "range", "required": over, "available": 1.0},
    )
