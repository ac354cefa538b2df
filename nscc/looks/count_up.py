"""Gates that add one to a binary counter in some lanes, by a ripple of carries.

A bit b with the carry c takes five words and four scratch registers: with NOR(b, c), the lanes of
only b and those of only c are one NOR each. The new bit is their OR, and the next carry the NOR of
all three. Wide counters thus need no search for covers, and few registers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import islice

from nscc.logic.problem import Gates, GaveUp
from nscc.looks.boundary_gates import RegisterContents


def counted(contents: RegisterContents, names: Sequence[str], new_values: Mapping[str, int]) -> int:
    """Return the lanes in which the binary counter `names` is to count up by one, as a truth vector
    (an integer with one bit for each lane).

    `names` are its registers, lowest bit first. `new_values` are the truth vectors of the registers
    that change, by name. Return 0 if the counter gets other values in some lane, or if fewer than
    two of its registers change."""
    old = [contents.values[name] for name in names]
    new = [new_values.get(name, v) for name, v in zip(names, old, strict=True)]
    # Counting up inverts the lowest bit, in exactly the lanes that count.
    lanes = carry = old[0] ^ new[0] if len(set(names) & new_values.keys()) > 1 else 0
    for before, after in zip(old, new, strict=True):
        if before ^ carry != after:
            return 0
        carry &= before
    return lanes


def count_up(contents: RegisterContents, names: Sequence[str], lanes: int) -> None:
    """Append gates that add one to the binary counter `names`, lowest bit first, in `lanes`.

    `lanes` is a truth vector (an integer with one bit for each lane), not 0. A counter whose bits
    all are 1 becomes 0. Raises GaveUp if no gates can compute these lanes."""
    carry = _carry_register(contents, names, lanes)
    gates = Gates(contents.machine)
    spare = (name for name in contents.unused_scratch() if name != carry)
    neither, only_bit, only_carry, next_carry = islice(spare, 4)
    # The highest bit that a carry reaches in some lane.
    highest = max(k for k, name in enumerate(names) if lanes & _lanes_of_ones(contents, names, k))
    for name in names[: highest + 1]:
        gates.nor(neither, [name, carry])
        gates.nor(only_carry, [neither, name])
        gates.nor(only_bit, [neither, carry])
        gates.or_(name, [only_bit, only_carry])
        if name != names[highest]:
            gates.nor(next_carry, [neither, only_bit, only_carry])
        carry = next_carry
    # The same addition for the recorded contents: here `lanes` is the carry.
    for name in names:
        lanes, contents.values[name] = lanes & contents.values[name], contents.values[name] ^ lanes
    contents.gates += gates.take()


def _lanes_of_ones(contents: RegisterContents, names: Sequence[str], count: int) -> int:
    """Return the truth vector of the lanes (simulated pixels) in which the `count` lowest bits of a
    counter are all 1; all lanes if `count` is 0.

    `names` are the counter's registers, lowest bit first. A truth vector is an integer with one bit
    for each simulated pixel."""
    lanes = contents.everything
    for name in names[:count]:
        lanes &= contents.values[name]
    return lanes


def _carry_register(contents: RegisterContents, names: Sequence[str], lanes: int) -> str:
    """Return a register that holds the truth vector `lanes` (an integer with one bit for each
    lane), after appending gates that compute it if there is none.

    `names` are the registers of the counter. A counter with a limit counts in the lanes of an
    answer, except where the bits that are 1 in the limit all are 1: three words for each of these
    bits. Raises GaveUp if no gates compute it."""
    carry = next((name for name, v in contents.values.items() if v == lanes), "")
    if carry:
        return carry
    for name, v in contents.values.items():
        for answer in (v, contents.everything & ~v):
            blocked = answer & ~lanes  # true answers that do not count: the counter is at its limit
            ones = [bit for bit in names if blocked and not blocked & ~contents.values[bit]]
            at_limit = contents.everything if ones else 0  # without such bits, nothing is blocked
            for bit in ones:
                at_limit &= contents.values[bit]
            if answer & ~at_limit == lanes:
                return _answer_below_limit(contents, name, answer == v, ones)
    carry = contents.first_unused_scratch()
    sequence = contents.shortest_gates(lanes, carry)
    if sequence is None:
        raise GaveUp("the registers do not tell the lanes that count")
    contents.take(sequence, (carry, lanes))
    return carry


def _answer_below_limit(
    contents: RegisterContents, name: str, positive: bool, ones: Sequence[str]
) -> str:
    """Append gates for the lanes (simulated pixels) in which the register `name` is 1, without
    those where all registers `ones` are 1; return their register.

    If not `positive`, the lanes where `name` is 0 are meant. `ones` may be empty only then: the
    result is the inverse of `name`."""
    # For `positive`, the register `name` itself is the carry.
    assert ones or not positive
    gates = Gates(contents.machine)
    answer, below, bit = islice(contents.unused_scratch(), 3)
    stops = [name]  # the result is the NOR of these registers
    if positive:
        gates.nor(answer, [name])
        stops = [answer]
    for k, one in enumerate(ones):
        gates.nor(bit if k else below, [one])
        if k:
            gates.or_(below, [below, bit])
    if ones:
        gates.nor(bit, [below])  # 1 at the limit: no bit of `ones` is 0
        stops.append(bit)
    gates.nor(answer, stops)
    contents.gates += gates.take()
    return answer
