"""Encodings: contents of the code planes with which a problem's predicates are cheap to compute.

Each function depends only on the predicates. It raises GaveUp if they do not suit the encoding or
if its planes leave too few registers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from nscc.arrays import Indices, Ints
from nscc.logic.cubes import Budget, Cube, Encoding, cover
from nscc.logic.digits import Planes, binary_planes, gray
from nscc.logic.problem import Demand, GaveUp, Machine, Problem
from nscc.truth import members, rows, union


def stored_predicates(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return the encoding with one plane for each distinct predicate (a set of shutters), so that
    every demand takes one word.

    Free bits and thermometer codes of a stop are examples. Raises GaveUp for more predicates than
    registers. The budget is not used. A demand is a set of shutters that FLAG must select at a
    boundary."""
    distinct = list(dict.fromkeys(d.predicate for d in problem.demands))
    if len(distinct) > machine.registers:
        raise GaveUp(f"{len(distinct)} different predicates, {machine.registers} registers")
    plane_of = {predicate: i for i, predicate in enumerate(distinct)}
    cubes = tuple((((plane_of[d.predicate], 1),),) for d in problem.demands)
    first = {d.predicate: describe_demand(d) for d in reversed(problem.demands)}
    planes = [(predicate, first[predicate]) for predicate in distinct]
    return Encoding("one register for each predicate", planes, cubes)


def describe_demand(demand: Demand) -> str:
    """Return a demand (a set of shutters that FLAG must select at a boundary) in words, such as
    `open in slot 3` or `fall at boundary 4`. The bucket is not named. FLAG is the bit that lets a
    pixel act."""
    if demand.edge == "open":
        return f"open in slot {demand.boundary - 1}"
    return f"{demand.edge} at boundary {demand.boundary}"


def one_hot(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return the encoding with one plane (the content of a code register) for each shutter: a
    predicate is the OR of its shutters' planes. Shutters in no predicate get no plane.

    Raises GaveUp for more shutters than registers. The budget is not used."""
    if problem.shutters > machine.registers:
        raise GaveUp(f"{problem.shutters} shutters, {machine.registers} registers")
    used = union(demand.predicate for demand in problem.demands)
    plane_of = {int(shutter): i for i, shutter in enumerate(members(used, problem.shutters))}
    cubes = tuple(
        tuple(((plane_of[int(m)], 1),) for m in members(d.predicate, problem.shutters))
        for d in problem.demands
    )
    planes = [(1 << shutter, f"shutter {shutter}") for shutter in plane_of]
    return Encoding("one register for each shutter", planes, cubes)


def event_name(edge: str, bucket: int, rank: int, fields: Events) -> str:
    """Return the name of a field of events, such as `fall time`.

    `edge` is "rise", "fall" or "open", `rank` counts the events of one shutter from 0. Rank and
    bucket are named only if `fields` (the result of `event_fields`) has several."""
    rank_text = f" {rank + 1}" if (edge, bucket, 1) in fields else ""
    bucket_text = f" of bucket {bucket}" if len({b for _, b, _ in fields}) > 1 else ""
    return f"{edge} time{rank_text}{bucket_text}"


Events = dict[tuple[str, int, int], list[tuple[int, Indices]]]


def event_fields(problem: Problem, most: int) -> Events:
    """Return for each kind and rank of events the pairs (demand, shutters) in time order.

    A key is (edge, bucket, rank): the first events of the shutters have rank 0, the next 1, and so
    on; keys are sorted. A pair holds the index of a demand and the numbers of the shutters,
    ascending. Demands that FLAG already meets are omitted. Raises GaveUp if there are more than
    `most` fields. A demand is a set of shutters that FLAG must select at a boundary. FLAG is the
    bit that lets a pixel act."""
    event_counts: dict[tuple[str, int], Ints] = {}
    fields: Events = {}
    for i, demand in enumerate(problem.demands):
        if problem.answered(i):
            continue
        kind = (demand.edge, demand.bucket)
        if kind not in event_counts:
            event_counts[kind] = np.zeros(problem.shutters, dtype=np.int64)
        shutters = members(demand.predicate, problem.shutters)
        # The rank of a shutter's event is the number of its events of this kind so far.
        ranks = event_counts[kind][shutters]
        event_counts[kind][shutters] += 1
        for rank in sorted(set(ranks.tolist())):
            fields.setdefault((*kind, rank), []).append((i, shutters[ranks == rank]))
        if len(fields) > most:
            raise GaveUp(f"shutters have events of more than {most} kinds")
    return dict(sorted(fields.items()))


def _index_planes(problem: Problem, machine: Machine) -> Planes:
    """Return planes (contents of code registers) with the Gray code of every shutter's number, as
    few as possible but at least one. Raises GaveUp if no register is left for intermediate results.
    """
    numbers = np.arange(problem.shutters, dtype=np.int64)
    width = max(1, (problem.shutters - 1).bit_length())
    if width > machine.registers - 1:
        raise GaveUp(f"{problem.shutters} shutters leave no register to compute with")
    return binary_planes("shutter number, Gray bit", gray(numbers), width)


def covered_gray_index(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return shutter numbers in Gray code; each predicate is covered by cubes (NORs of registers).

    Raises GaveUp if the planes leave no register for intermediate results, or if the budget is used
    up. A plane is the content of a code register."""
    planes = _index_planes(problem, machine)
    return _covered(problem, "shutter number in Gray code", planes, budget)


def covered_both_polarities(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return the encoding of `covered_gray_index` with both polarities of every bit, without
    inversions.

    Raises GaveUp if both polarities and two scratch registers need more registers than there are,
    or if the budget is used up. A scratch register holds an intermediate result."""
    half = _index_planes(problem, machine)
    if 2 * len(half) > machine.registers - 2:
        raise GaveUp("no room for both polarities and two scratch registers")
    encoding = _covered(problem, "shutter number in Gray code, both polarities", half, budget)
    # Plane 2i holds bit i, 2i + 1 its complement; a NOR reads the complement of each literal, so
    # the literal (i, value) is (2i + value, 0), and alone it is the plane that equals it.
    planes: Planes = []
    for plane, bit in half:
        planes += [(plane, bit), (problem.everything & ~plane, f"{bit}, inverted")]
    cubes = tuple(
        tuple(
            tuple(
                (2 * plane + value, 0) if len(cube) > 1 else (2 * plane + 1 - value, 1)
                for plane, value in cube
            )
            for cube in predicate
        )
        for predicate in encoding.cubes
    )
    return replace(encoding, planes=planes, cubes=cubes)


def covered_fields(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return the values of the code's fields in Gray code; each predicate is covered by cubes (NORs
    of registers).

    Rules are written in fields, so events of one field are equality tests. Shutters that differ
    otherwise, for example those that never open, cost a few cubes at a few boundaries. Raises
    GaveUp for fewer than two fields, if the planes leave no register for intermediate results, if
    the fields do not distinguish the shutters of a predicate, or if the budget is used up. A plane
    is the content of a code register."""
    if len(problem.values) < 2:
        raise GaveUp("one field is as good as the shutters' numbers")
    planes: Planes = []
    for name, values in problem.values.items():
        _, rank = np.unique(values, return_inverse=True)
        planes += binary_planes(f"{name}, Gray bit", gray(rank), int(rank.max()).bit_length())
    if len(planes) > machine.registers - 1:
        raise GaveUp(f"{len(planes)} bits of fields leave no register to compute with")
    return _covered(problem, "fields in Gray code", planes, budget)


def covered_levels(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return the encoding whose planes are the shutters open in slots; all predicates are covered
    by cubes of them.

    All different levels are stored if they leave a register for intermediate results. Otherwise a
    few are stored that distinguish the shutters, which suits shutters without structure. Raises
    GaveUp if there are no such levels, if the levels do not distinguish the shutters of a
    predicate, or if the budget is used up."""
    distinct = dict.fromkeys(level for bucket in problem.opens for level in bucket)
    levels = [level for level in distinct if level not in (0, problem.everything)]
    if len(levels) > machine.registers - 1:
        levels = _separating(levels[:_MOST_COMPARED], problem.shutters, machine.registers - 1)
    planes = [(level, f"level {i}") for i, level in enumerate(levels)]
    return _covered(problem, "open slots, edges made from them", planes, budget)


# Levels from which those to store are chosen. Shutters without structure differ in any of them.
_MOST_COMPARED = 64


def _separating(levels: list[int], shutters: int, most: int) -> list[int]:
    """Return a few of `levels` (truth vectors) that distinguish all `shutters`, each time the one
    that leaves the fewest pairs of equal shutters. Raises GaveUp if `most` levels do not suffice.

    >>> [f"{level:04b}" for level in _separating([0b0001, 0b0011, 0b0101], 4, most=2)]
    ['0011', '0101']
    """
    bits = rows(levels, shutters).astype(np.int64)
    kinds = np.zeros(shutters, dtype=np.int64)
    chosen: list[int] = []
    while kinds.max() + 1 < shutters:
        if kinds.max() + 1 << most - len(chosen) < shutters:
            raise GaveUp(f"{most} levels do not distinguish {shutters} shutters")
        # How many shutters of each kind are closed and open in each level.
        open_ = np.zeros((kinds.max() + 1, len(levels)), dtype=np.int64)
        np.add.at(open_, kinds, bits)
        closed = np.bincount(kinds)[:, None] - open_
        best = int((open_**2 + closed**2).sum(axis=0).argmin())
        chosen.append(levels[best])
        kinds = np.unique(2 * kinds + bits[:, best], return_inverse=True)[1].reshape(-1)
    return chosen


def _covered(problem: Problem, name: str, planes: Planes, budget: Budget) -> Encoding:
    """Return the encoding that stores `planes` and computes each predicate by the cheaper cover.

    The complement of a predicate is covered instead if this saves more than the gate that inverts
    the result. Raises GaveUp if the planes do not distinguish the shutters of a predicate from the
    others, or if the budget is used up. A plane is the content of a code register."""
    predicates = [demand.predicate for demand in problem.demands]
    vectors = [plane for plane, _ in planes]
    covers: dict[int, tuple[tuple[Cube, ...], bool]] = {}
    for predicate in dict.fromkeys(predicates):
        direct = cover(predicate, vectors, problem.everything, budget)
        covers[predicate] = tuple(direct), False
        if len(direct) > 1:
            # The complement costs one more gate.
            complement = problem.everything & ~predicate
            of_complement = cover(complement, vectors, problem.everything, budget)
            if len(of_complement) + 1 < len(direct):
                covers[predicate] = tuple(of_complement), True
    cubes, inverted = zip(*(covers[predicate] for predicate in predicates), strict=True)
    return Encoding(name, planes, cubes, inverted)
