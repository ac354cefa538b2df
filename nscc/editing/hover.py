"""Hover texts and inlay hints: descriptions of places in a program, as an editor shows them.

The functions on costs return None if the text has errors or only a longer search can determine the
costs."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from nscc.diagnostics.explain import page
from nscc.editing.document import Document
from nscc.editing.mentions import Mention, declaration, mention_at
from nscc.lower.resources import time_text
from nscc.pipeline import KINDS, Compiled
from nscc.program.names import LOOKS, PREDEFINED
from nscc.program.problems import clipped, counted
from nscc.record import Record
from nscc.source import Span
from nscc.syntax import tree
from nscc.syntax.words import FORMS
from nscc.words.counts import counts_by_name
from nscc.words.pictures import NO_PICTURES, Weights

_MOST_VALUES = 12
"""Most values or boundaries that a description lists."""


class Hover(Record):
    """A place in a program (`span`), and its description in Markdown (`text`)."""

    span: Span
    text: str


def hover(document: Document, offset: int) -> Hover | None:
    """Return the hover text at `offset` (characters); None if there is nothing to say.

    It contains the meaning and values of a name, the form of a statement, the cost of the frame or
    a slot, and the pages of diagnostics. These are joined by rules (`---`). The span is that of the
    first of these."""
    texts: list[str] = []
    span: Span | None = None
    for topic in (_name(document, offset), _frame(document, offset), _word(document, offset)):
        if topic is not None:
            texts.append(topic.text)
            span = span or topic.span
    for diagnostic in document.checked.diagnostics:
        label = diagnostic.label
        if label is not None and label.span.start <= offset <= label.span.end:
            texts.append(page(diagnostic.code))
            span = span or label.span
    return Hover(span, "\n\n---\n\n".join(texts)) if span is not None else None


def _name(document: Document, offset: int) -> Hover | None:
    """Return the hover text of the name at `offset` (characters); None if no known name stands
    there."""
    mention = mention_at(document, offset)
    if mention is None:
        return None
    text = _bucket(document, mention) if mention.kind == "bucket" else _meaning(document, mention)
    return None if text is None else Hover(mention.span, f"`{mention.name}`: {text}")


def _bucket(document: Document, mention: Mention) -> str | None:
    """Return the description of a bucket, or None if the program does not declare it.

    `mention` is a place of its name. If all shutters are known, the description has the range of
    their numbers of open slots."""
    if declaration(document, mention) is None:
        return None
    compiled = document.checked.compiled
    names = [] if compiled is None else [bucket.name for bucket in compiled.program.buckets]
    text = "one of the exposures of a frame"
    if compiled is None or mention.name not in names:
        return text
    if not KINDS.of(compiled.program).shutters_known:
        return text
    shutters = compiled.program.table.shutters[:, names.index(mention.name)]
    opened = shutters.sum(axis=1)
    least, most = int(opened.min()), int(opened.max())
    span = f"{least}" if least == most else f"{least} to {most}"
    slots = counted(shutters.shape[1], "slot")
    return f"{text}. {counted(len(shutters), 'shutter')}, open in {span} of {slots}."


def _meaning(document: Document, mention: Mention) -> str | None:
    """Return what the name at the place `mention` stands for; None for an unknown name.

    The text has the kind of the name and, as far as the program is valid, its value or size."""
    name, declared = mention.name, document.declared
    if name in declared.lets:
        meaning = document.constants.get(name)
        known = meaning is not None and meaning.kind == "constant"
        return f"a constant, {clipped(meaning.value)}" if meaning and known else "a constant"
    if name in declared.codes:
        return _field(document, name)
    if name in declared.books:
        book = document.books.get(name)
        size = "" if book is None else f" of {len(book)} shutters, {book.shape[1]} slots each"
        return f"a codebook{size}"
    if name in declared.senses:
        return _sense(document, name)
    if name in declared.states:
        return _state(document, name)
    picture = _picture(document, name)
    if picture is not None:
        return picture
    if name == LOOKS and document.tokens.version > 1:
        return "the number of boundaries with a sense so far, including this one"
    meaning = document.constants.get(name)
    if name in PREDEFINED and meaning is not None and meaning.kind == "constant":
        return f"{PREDEFINED[name]}: {meaning.value}"
    return PREDEFINED.get(name)


def _picture(document: Document, name: str) -> str | None:
    """Return the description of a name of version 3 of the language; None for other names and in
    older versions. The text has several lines only for kernels.

    Such names are parameters, input planes, convolution kernels (shown as a grid), images, planes
    and buckets. Images and planes have their cost if the program is valid."""
    compiled, declared = document.checked.compiled, document.declared
    if document.tokens.version < 3:
        return None
    # Names are looked up by kind: buckets, values from the host, kernels, then images and planes.
    if any(isinstance(rule, tree.Bucket) and rule.name.text == name for rule in declared.rules):
        return "one of the sums of light that a frame gives"
    container = None if compiled is None else compiled.container
    pictures = NO_PICTURES if container is None else container.pictures
    for names, description in (
        (declared.params, "a parameter: the host sets it before a frame"),
        (declared.inputs, "an input plane: the host loads its bits before a frame"),
        (declared.kept_images, "a kept image: others read its values of the previous frame"),
    ):
        if name in names:
            return description
    if name in declared.kernels:
        weights = pictures.weights_by_name.get(name)
        return "a kernel" if weights is None else f"a kernel\n\n{_grid(weights)}"
    kinds = {picture.name.text: picture for picture in declared.pictures}
    if name not in kinds:
        return None
    is_plane = isinstance(kinds[name], tree.Plane)
    description = (
        "a plane, a bit of every pixel" if is_plane else "an image, a value of every pixel"
    )
    # Costs are known only if the program compiles.
    cost = next((c for c in pictures.costs if c.name == name), None)
    if cost is None:
        return description
    description += f". {counted(cost.words, 'word')}"
    if is_plane:
        return description
    count = counts_by_name(pictures).get(name)
    if count is not None:
        return f"{description}, counts to {count.peak}, noise gain {cost.noise_gain:.3g}"
    return f"{description}, peak gain {cost.peak_gain:.3g}, noise gain {cost.noise_gain:.3g}"


def _grid(weights: Weights) -> str:
    """Return the weights of a convolution kernel as a block of Markdown, one line for each row, the
    top row first. A divisor above 1 stands beside the middle row."""
    width = max(len(str(weight)) for row in weights.rows for weight in row)
    lines = [" ".join(f"{weight:>{width}}" for weight in row) for row in weights.rows]
    if weights.divisor > 1:  # beside the middle row
        lines[len(lines) // 2] += f"   / {weights.divisor}"
    return "\n".join(["```text", *lines, "```"])


def _field(document: Document, name: str) -> str:
    """Return the description of the declared field `name` of the pixel code. It has the range and,
    if the program gives codes, up to `_MOST_VALUES` values in use."""
    field = document.fields.get(name)
    if field is None:
        return "a field of the pixel code"
    kinds = {
        "range": "",
        "bits": f", {field.bits} free bits",
        "row": f", a row of `{field.book}`",
    }
    text = f"a field of the pixel code{kinds[field.kind]}, {field.low}..{field.high}"
    compiled = document.checked.compiled
    if compiled is None or compiled.program.mode != "fixed":
        return text
    table = compiled.program.table
    used = np.unique(table.codes[:, table.fields.index(name)])
    listed = f": {', '.join(map(str, used))}" if len(used) <= _MOST_VALUES else ""
    return f"{text}. {len(used)} of its {field.high - field.low + 1} values in use{listed}."


def _sense(document: Document, name: str) -> str:
    """Return the description of the declared sense `name` (a comparison of the pixel's light with a
    level), with its first `_MOST_VALUES` boundaries."""
    senses = document.looking.senses if document.looking else ()
    sense = next((sense for sense in senses if sense.name == name), None)
    if sense is None:
        return "the light that a pixel compares"
    listed = ", ".join(map(str, sense.at[:_MOST_VALUES])) + ", .." * (len(sense.at) > _MOST_VALUES)
    return (
        "true if the pixel's signal was beyond its level at the latest look, false before "
        "the first look. It looks "
        f"{'once' if len(sense.at) == 1 else f'{len(sense.at)} times'}, at {listed}"
    )


def _state(document: Document, name: str) -> str:
    """Return the description of the declared state `name`: its values, its start, and whether it is
    kept or read out."""
    states = document.looking.states if document.looking else ()
    state = next((state for state in states if state.name == name), None)
    if document.declared.keeps_planes:
        return "a kept plane: images and planes read its bits of the previous frame"
    if state is None:
        return "a value that a pixel remembers"
    values = "a bit" if state.boolean else f"{state.low}..{state.high}"
    kept_text = ", kept from frame to frame" if state.is_kept else ""
    read = ", read out with the frame" if name in document.declared.reads else ""
    return f"a value that a pixel remembers: {values}, {state.start} at the start{kept_text}{read}"


def _frame(document: Document, offset: int) -> Hover | None:
    """Return the hover text with the cost of the frame, or of the listed slot at `offset`
    (characters).

    Return None if `offset` is not in a `frame` statement, or if nothing is known about it."""
    for statement in document.parsed[0].statements:
        if not isinstance(statement, tree.EqualSlots | tree.ListedSlots):
            continue
        if not statement.span.start <= offset <= statement.span.end:
            continue
        if isinstance(statement, tree.ListedSlots):
            for slot, length in enumerate(statement.lengths):
                if length.span.start <= offset <= length.span.end:
                    text = slot_cost(document, slot)
                    return None if text is None else Hover(length.span, text)
        texts = []
        count = document.constants["N"]
        if count.kind == "constant":
            lengths = (
                [statement.length.us] * count.value
                if isinstance(statement, tree.EqualSlots)
                else [length.us for length in statement.lengths]
            )
            all_slots = counted(count.value, "slot")
            texts.append(f"{all_slots}, {time_text(float(sum(lengths)))} in all.")
        cost = frame_cost(document)
        if cost is not None:
            texts.append(cost)
        return Hover(statement.span, " ".join(texts)) if texts else None
    return None


def _word(document: Document, offset: int) -> Hover | None:
    """Return the hover text with the forms of the statement whose first word is at `offset`
    (characters), else None.

    For `open`, the class of the program's shutters comes first if the program is valid."""
    for statement in document.parsed[0].statements:
        start = statement.span.start
        if not start <= offset <= statement.span.end:
            continue
        word = document.text[start : statement.span.end].split(None, 1)[0]
        if offset <= start + len(word) and word in FORMS:
            forms = "\n".join(FORMS[word])
            text = f"```nsl\n{forms}\n```"
            compiled = document.checked.compiled
            if isinstance(statement, tree.Open) and compiled is not None:
                program = compiled.program
                text = f"Class {program.class_name}: {program.class_reason}.\n\n{text}"
            return Hover(Span(start, start + len(word)), text)
    return None


class Hint(Record):
    """A text that an editor shows before the character number `offset`, from 0; the program does
    not contain it."""

    offset: int
    text: str


def hints(document: Document) -> Iterator[Hint]:
    """Yield the texts that an editor shows after statements.

    These are the cost of a frame after `frame`, if the program fits, and the value after each `let`
    that is not a plain number."""
    for statement in document.parsed[0].statements:
        match statement:
            case tree.EqualSlots() | tree.ListedSlots():
                compiled = _compiled(document)
                if compiled is not None and compiled.container is not None:
                    cost = KINDS.of(compiled.program).size_text(compiled.container)
                    shortest = time_text(compiled.shortest_slot_us)
                    text = f"{cost} a frame, shortest slot {shortest}"
                    yield Hint(statement.span.end, text)
            case tree.Let() if not isinstance(statement.value, tree.Int):
                meaning = document.constants.get(statement.name.text)
                if meaning is not None and meaning.kind == "constant":
                    yield Hint(statement.span.end, f"= {clipped(meaning.value)}")


def frame_cost(document: Document) -> str | None:
    """Return a sentence on the words or planes of a frame and the shortest slot that they allow;
    None if the program has errors, or it is unknown whether it fits."""
    compiled = _compiled(document)
    if compiled is None:
        return None
    cost = KINDS.of(compiled.program).frame_text(compiled)
    return f"{cost} leave slots of {time_text(compiled.shortest_slot_us)} and longer possible."


def slot_cost(document: Document, slot: int) -> str | None:
    """Return a sentence on the words or the plane before slot number `slot`, from 0, and their
    share of it. Return None if the program has errors, or it is unknown whether it fits."""
    compiled = _compiled(document)
    if compiled is None:
        return None
    cost = KINDS.of(compiled.program).slot_text(compiled, slot)
    return f"Slot {slot}, {time_text(compiled.program.frame.slot_us[slot])}: {cost}"


def _compiled(document: Document) -> Compiled | None:
    """Return the compiled program; None if it has errors, or it is unknown whether it fits."""
    compiled = document.checked.compiled
    return None if compiled is None or compiled.layout is None else compiled
