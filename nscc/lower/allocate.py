"""Mapping of virtual registers to the chip's registers, and of gates to words.

The masked register (R12 on SCAMP-5) is written only where its mask (R0) is 1. Masked gates name
both. Without masked gates, the masked register gets code that does not change within the frame. If
every register is needed, it gets the plane with the fewest writes; each of these writes first sets
the mask, which is then a scratch register."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

from nscc.chips.target import Target
from nscc.logic.problem import Gate, Segment, Solution, quietest
from nscc.operations import Op, op, pair


@dataclass(frozen=True)
class Allocation:
    """The chip register of every virtual register, and the registers that contain code and
    states."""

    places: dict[str, str]
    holders: dict[str, str]
    code_registers: tuple[str, ...]
    state_registers: tuple[str, ...]
    mask: str | None
    masked: str | None


def allocate(solution: Solution, target: Target, spared: Collection[str] = ()) -> Allocation:
    """Return the allocation of a solution's virtual registers to registers of `target`. The
    registers `spared` are the last choice for code, and the first for other bits."""
    planes = [f"p{i}" for i in range(len(solution.planes))]
    scratch = [f"t{i}" for i in range(solution.scratch)]
    states = [f"s{i}" for i in range(solution.states)]
    places = _pair_places(solution, target)
    free = [
        register
        for register in sorted(target.digital_registers, key=lambda name: name in spared)
        if register != target.masked_register and register not in places.values()
    ]
    names = [name for name in (*planes, *states, *scratch) if name not in places]
    if target.mask_register in free and len(free) > len(names):
        free.remove(target.mask_register)  # the mask is the last choice for code bits
    codes = len([name for name in names if name in planes])
    after_codes = sorted(free[codes:], key=lambda name: name not in spared)
    places.update(zip(names, (free[:codes] + after_codes)[: len(names)], strict=True))
    holders = {
        **dict(zip(planes, solution.holders, strict=True)),
        **dict.fromkeys(states, "state: open"),
        **dict.fromkeys(scratch, "scratch"),
    }
    by_place = {places[name]: holders[name] for name in (*planes, *states, *scratch)}
    # Code is loaded into the masked register first, while its mask is 1, and into the mask last.
    order: dict[str | None, int] = {r: i for i, r in enumerate(target.digital_registers)}
    order |= {target.masked_register: -1, target.mask_register: len(order)}
    return Allocation(
        places,
        {r: by_place[r] for r in target.digital_registers if r in by_place},
        tuple(sorted((places[name] for name in planes), key=order.__getitem__)),
        tuple(places[name] for name in states),
        target.mask_register,
        target.masked_register,
    )


def _pair_places(solution: Solution, target: Target) -> dict[str, str]:
    """Return the places of the virtual registers in the masked register and in its mask."""
    masked, mask = target.masked_register, target.mask_register
    if masked is None or mask is None:
        return {}
    pair = solution.masked_pair()
    if pair is not None:
        return dict(zip(pair, (masked, mask), strict=True))
    places = {"t0": mask} if solution.scratch else {}
    used = len(solution.planes) + solution.states + solution.scratch
    if used == len(target.digital_registers):
        places[f"p{quietest(solution.writes())}"] = masked
    return places


def words(segment: Segment, allocation: Allocation) -> tuple[Op, ...]:
    """Return the words of a segment."""
    out: list[Op] = []
    for gate in segment:
        writes_masked = allocation.places.get(gate.destination) == allocation.masked is not None
        if writes_masked and gate.mask is None:
            assert allocation.mask is not None
            out.append(op("SET", (allocation.mask,)))
        out.extend(_gate_words(gate, allocation.places))
    return tuple(out)


def _gate_words(gate: Gate, places: dict[str, str]) -> tuple[Op, ...]:
    sources = [places.get(name, name) for name in gate.sources]
    if gate.name == "WHERE":
        return (op("WHERE", (), sources),)
    destination = places[gate.destination]
    if destination in sources:
        kind = {"NOT": "NOR", "NOR": "NOR", "OR": "OR", "MOV": "REFRESH"}[gate.name]
        return pair(kind, destination, sources)
    return (op(gate.name, (destination,), sources),)


def refresh_words(registers: tuple[str, ...], allocation: Allocation) -> tuple[Op, ...]:
    """Return words that rewrite the content of all `registers`.

    They overwrite FLAG if both the masked register and its mask contain code."""
    masked, mask = allocation.masked, allocation.mask
    out: list[Op] = []
    plain = [r for r in registers if r != masked]
    if masked in registers and mask is not None:
        if mask in allocation.code_registers:
            # The mask's code is saved in FLAG; writing it back also refreshes it.
            out += [op("WHERE", (), (mask,)), op("SET", (mask,))]
            out += [*pair("REFRESH", masked, (masked,)), op("MOV", (mask,), ("FLAG",))]
            plain = [r for r in plain if r != mask]
        else:
            out += [op("SET", (mask,)), *pair("REFRESH", masked, (masked,))]
    for register in plain:
        out += pair("REFRESH", register, (register,))
    return tuple(out)
