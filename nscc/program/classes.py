"""Recognition of the shutter class of a program (as in the paper), with the reason.

Always-open shutters and bumps are recognised from the decode table, independent of the rule's form.
Codebooks and free bits (class e) are recognised from the rule."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from nscc.arrays import Bools
from nscc.program.evaluate import Value, evaluate
from nscc.program.expressions import Checked
from nscc.program.problems import counted
from nscc.program.table import Rules, distinct_rows
from nscc.syntax.tree import Index, Name
from nscc.words.container import DecodeTable


class Recognised(NamedTuple):
    """A recognised class: its `name` (a, b, c, d, e, codebook or general) and a `reason` sentence.

    `cut` is the number of shutters whose bump the end of the frame shortens."""

    name: str
    reason: str
    cut: int = 0


def recognise(rules: Rules, buckets: Sequence[str], table: DecodeTable, basis: str) -> Recognised:
    """Return the shutter class of a program.

    Several buckets must all have the same class; else the class is "general". `buckets` are their
    names, in the order of `rules.rules` and of the table's axis 1, and `basis` describes the codes
    in `table` for the reason, such as "in all codes that the fields allow"."""
    recognised = [
        _recognise_rule(rules, rule, table.shutters[:, k, :], basis)
        for k, rule in enumerate(rules.rules)
    ]
    if len(recognised) == 1:
        return recognised[0]
    cut = sum(f.cut for f in recognised)
    names = {f.name for f in recognised}
    # Letters are written `class a`, other names as they are.
    class_texts = ", ".join(
        f"{bucket} {'class ' * (len(f.name) == 1)}{f.name}"
        for bucket, f in zip(buckets, recognised, strict=True)
    )
    if len(names) == 1:
        return Recognised(recognised[0].name, f"by bucket: {class_texts}", cut)
    return Recognised("general", f"buckets of different classes: {class_texts}", cut)


def _recognise_rule(rules: Rules, rule: Checked, shutters: Bools, basis: str) -> Recognised:
    """Return the shutter class of one rule, with the reason.

    `shutters`, bool (shutters, slots), are those of the rule; `basis` says for the reason of which
    codes. Codebooks and free bits are recognised from the rule, other classes from the shutters."""
    if len(rules.rules) > 1:
        # Shutters of several buckets are distinct together, but perhaps not in this one.
        packed, _ = distinct_rows(np.packbits(shutters, axis=1))
        shutters = np.unpackbits(packed, axis=1, count=rules.slots).view(np.bool_)
    by_shape = _by_shape(shutters, basis)
    if by_shape.name == "a":
        return by_shape
    node = rule.nodes[-1]
    if isinstance(node, Index) and node.base.text in rules.books:
        rows = counted(len(rules.books[node.base.text]), "row")
        reason = f"the rule reads `{node.base.text}`, {rows} of any shape"
        if by_shape.name != "general":
            reason += f" (its shutters alone would be class {by_shape.name})"
        return Recognised("codebook", reason)
    if isinstance(node, Index) and _own_bit_for_each_slot(rules, rule, node):
        with_require = " that `require` allows" if rules.requires else ""
        return Recognised(
            "e", f"every slot reads its own bit of `{node.base.text}`: any pattern{with_require}"
        )
    # Tables are far smaller than 2^32 rows; the bound avoids computing a huge power.
    if by_shape.name == "general" and rules.slots < 32 and len(shutters) == 2**rules.slots:
        return Recognised(
            "e", f"all 2^{rules.slots} patterns of {counted(rules.slots, 'slot')} occur"
        )
    return by_shape


def _own_bit_for_each_slot(rules: Rules, rule: Checked, node: Index) -> bool:
    """Return whether the rule is `bits[I]` with an index I that depends on the slot only and is
    different in every slot.

    Return False if the index depends on a field, has no value in some slot, or repeats."""
    if isinstance(node.index, Name) and node.index.text == "n":
        return True
    fields = {field.name for field in rules.fields}
    index = Checked(rule.nodes[:-1], "integer", rule.constants, rule.variables, frozenset())
    read = {k.text for k in index.nodes if isinstance(k, Name)}
    read |= {k.base.text for k in index.nodes if isinstance(k, Index)}
    if read & fields or not read <= {"n", *rule.constants}:
        return False
    slots = Value(np.arange(rules.slots, dtype=np.int64))
    bit_numbers = evaluate(index, {"n": slots}, {})
    return (
        bit_numbers.faults is None and len(set(np.ravel(bit_numbers.data).tolist())) == rules.slots
    )


def _by_shape(shutters: Bools, basis: str) -> Recognised:
    """Return class a, b, c or d for the distinct `shutters`, at least one, bool (shutters, N); else
    "general".

    Shutters that never open are ignored, except if there are no others. `basis` says of which codes
    they are, for the reason."""
    slots = shutters.shape[1]
    length = np.count_nonzero(shutters, axis=1)
    opens = length > 0
    never = len(shutters) - int(np.count_nonzero(opens))
    if never == len(shutters):
        return Recognised("general", f"no shutter ever opens, {basis}")
    if never == 0 and bool((length == slots).all()):
        return Recognised("a", f"the shutter is open in every slot, {basis}")
    start = shutters.argmax(axis=1)
    # The boundary after the last open slot: the first open one, counted from the end.
    stop = slots - shutters[:, ::-1].argmax(axis=1)
    if not bool((~opens | (stop - start == length)).all()):
        return Recognised("general", f"some shutters open more than once, {basis}")
    also = ", or it never opens" if never else ""
    if len(shutters) == 1:
        shape = f"open in the slots {int(start[0])}..{int(stop[0]) - 1}"
        # Class b opens in slot 0; a single later bump has a fixed length.
        return Recognised("c" if start[0] else "b", f"the one shutter is {shape}, {basis}")
    if not bool(start[opens].any()):
        return Recognised(
            "b", f"every shutter is open from slot 0 up to a stop of its own{also}, {basis}"
        )
    longest = int(length.max())
    full_length = length == longest
    short = opens & ~full_length  # perhaps cut by the start or the end of the frame
    at_an_edge = (start == 0) | (stop == slots)
    slots_text = counted(longest, "slot")
    if not short.any():
        return Recognised("c", f"every shutter is one bump of {slots_text}{also}, {basis}")
    # Two complete bumps show a common length; a single one may be the longest of many.
    if np.count_nonzero(full_length) > 1 and bool(at_an_edge[short].all()):
        cut = int(np.count_nonzero(short))
        return Recognised(
            "c",
            f"every shutter is one bump of {slots_text}{also}, "
            f"{cut} of them cut by the frame's edge, {basis}",
            cut,
        )
    return Recognised(
        "d", f"every shutter is one bump with a start and a stop of its own{also}, {basis}"
    )
