"""Lists of gates, which are split to the machine's fan-in as they are added."""

from __future__ import annotations

from collections.abc import Sequence

from nscc.logic.problem import Gate, Machine


def words_of(sources: int, fan_in: int | None) -> int:
    """Return the words of a NOR or OR of `sources` registers into another register.

    The first word reads `fan_in` sources. Each further pair of words is in place and reads one
    source less, because the partial result is also a source."""
    if fan_in is None or sources <= fan_in:
        return 1
    return 1 + 2 * -(-(sources - fan_in) // (fan_in - 1))


class Gates:
    """A list of gates; gates with more sources than one word accepts are split."""

    def __init__(self, machine: Machine) -> None:
        self._machine = machine
        self._gates: list[Gate] = []

    def take(self) -> tuple[Gate, ...]:
        """Return and remove the collected gates."""
        gates = tuple(self._gates)
        self._gates.clear()
        return gates

    def add(self, gate: Gate) -> None:
        """Add a gate that does not exceed the machine's fan-in."""
        self._gates.append(gate)

    def nor(self, destination: str, sources: Sequence[str], mask: str | None = None) -> None:
        """Add destination := NOR(sources), or 1 without sources; the destination may be a
        source."""
        self._gather("NOR", "NOT", destination, sources, mask)

    def or_(self, destination: str, sources: Sequence[str], mask: str | None = None) -> None:
        """Add destination := OR(sources), or 0 without sources; the destination may be a source."""
        self._gather("OR", "MOV", destination, sources, mask)

    def invert(self, register: str) -> None:
        """Add register := NOT register."""
        self._gates.append(Gate("NOT", register, (register,)))

    def load_flag(self, sources: Sequence[str], scratch: str | None) -> None:
        """Add FLAG := OR(sources); may overwrite `scratch`, even if it is a source."""
        limit = self._machine.where_sources
        if limit is not None and len(sources) > limit:
            if scratch is None:
                raise ValueError("no scratch register to gather the sources of WHERE")
            # If `scratch` is a source, the other sources are ORed into it.
            other_sources = [name for name in sources if name != scratch]
            head = [scratch] if scratch in sources else []
            spill = len(other_sources) - (limit - 1)
            self.or_(scratch, [*head, *other_sources[:spill]])
            sources = [scratch, *other_sources[spill:]]
        self._gates.append(Gate("WHERE", "FLAG", tuple(sources)))

    def _gather(
        self,
        name: str,
        single_name: str,
        destination: str,
        sources: Sequence[str],
        mask: str | None,
    ) -> None:
        if not sources:
            self.add(Gate("SET" if name == "NOR" else "CLR", destination, (), mask))
            return
        limit = self._machine.or_sources
        other_sources = [source for source in sources if source != destination]
        in_place = len(other_sources) < len(sources)
        # OR is associative, so excess sources are first gathered in the destination. NOR is not:
        # only the last gate inverts. In place, the destination is one of the sources.
        if limit is not None:
            room = limit - 1 if in_place else limit
            while len(other_sources) > room:
                head, other_sources = other_sources[:room], other_sources[room:]
                self._append("OR", "MOV", destination, [destination] * in_place + head, mask)
                in_place, room = True, limit - 1
        self._append(name, single_name, destination, [destination] * in_place + other_sources, mask)

    def _append(
        self,
        many_name: str,
        single_name: str,
        destination: str,
        sources: Sequence[str],
        mask: str | None,
    ) -> None:
        name = many_name if len(sources) > 1 else single_name
        self._gates.append(Gate(name, destination, tuple(sources), mask))
