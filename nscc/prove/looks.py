"""The proof of programs that look: words against the machine, for every code, state and answer.

From every node in which a frame can start, all outcomes of all comparisons are followed. At each
boundary the program's own comparisons must be made, each once, by a `where` that sums exactly
level - signal, or signal - level; which is answered makes two lanes of each. When the frame ends
every bucket holds the light of the slots in which the program was open, code and states are held as
the container says, and a second frame starts from whatever the first one left behind.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import inf

import numpy as np
from numpy.typing import NDArray

from nscc.operations import Op
from nscc.prove.interpreter import Interpreter
from nscc.prove.noise import Noise
from nscc.prove.pixels import UNKNOWN, Bits, Floats, Lanes
from nscc.words.container import Container
from nscc.words.machine import LIGHT, Machine

TOLERANCE = 1e-9
MOST_LANES = 10**7
"""Most transitions that are followed in a frame."""


class Wrong(Exception):
    """What the words do wrong: in words, and in which bucket or behaviour."""

    def __init__(self, what: str, bucket: str | None = None, behaviour: int | None = None) -> None:
        super().__init__(what)
        self.what, self.bucket, self.behaviour = what, bucket, behaviour


class Looks(Interpreter[Bits]):
    """A container with a machine, its words, and the pixels that run them."""

    def __init__(
        self, container: Container, kernels: Sequence[Sequence[Op]], light: Floats, seed: int
    ) -> None:
        assert container.machine is not None
        self.container, self.kernels, self.light = container, kernels, light
        self.machine: Machine = container.machine
        self.target = container.target
        self.scale = float(light.sum())
        self.noise = Noise(seed)
        self.registers = (*self.target.digital_registers, "FLAG", "SELECT", "bus")
        self.place = {name: i for i, name in enumerate(self.registers)}
        self.analog = {name: i for i, name in enumerate((*self.target.analog_registers, "PIX"))}
        self.reset_level = self._random()
        self.level: int | None = None
        self.now_us = 0.0
        self.written_us = dict.fromkeys(self.registers, 0.0)
        self.loaded = set(self.registers)
        self.boundary = 0
        self.transitions = 0
        self.pending: list[int] = []
        self.lanes = self._first()

    def _random(self) -> float:
        return float(self.noise.levels(1, 1)[0, 0])

    def _first(self) -> Lanes:
        """Every node of stage 0, with the registers that a device loads."""
        nodes = np.arange(self.machine.first[1], dtype=np.int64)
        bits = np.full((len(self.registers), len(nodes)), UNKNOWN, np.int8)
        encoding = self.container.encoding[self.machine.behaviour[nodes]]
        for name in self.container.code_registers:
            column = self.target.digital_registers.index(name)
            bits[self.place[name]] = encoding[:, column]
        for name, values in self._held(nodes, kept=True).items():
            bits[self.place[name]] = values
        return self._started(nodes, bits)

    def _started(self, nodes: NDArray[np.int64], bits: Bits) -> Lanes:
        """Lanes at boundary 0: what analog registers hold is anything."""
        count, buckets = len(nodes), len(self.container.buckets)
        analog = np.array([[self._random()] * count for _ in self.analog])
        return Lanes(
            nodes, np.zeros(count, np.int64), bits, analog,
            np.zeros((len(self.analog), buckets, count)), np.zeros((buckets, count)),
            np.zeros(count), np.ones(count, np.bool_),
        )  # fmt: skip

    def _held(self, nodes: NDArray[np.int64], *, kept: bool) -> dict[str, Bits]:
        """What the registers of states, kept ones only where `kept`, hold at these nodes."""
        found: dict[str, Bits] = {}
        for k, state in enumerate(self.machine.states):
            planes = self.container.state_planes.get(state.name)
            if planes is None or (kept and not state.kept):
                continue
            rows = dict(zip(planes.values, planes.bits, strict=True))
            values = self.machine.values[nodes, k].tolist()
            if not rows.keys() >= set(values):
                raise Wrong(f"no bits stand for some value of the state `{state.name}`")
            bits = np.array([rows[value] for value in values], np.int8).reshape(len(values), -1)
            found |= zip(planes.registers, bits.T, strict=True)
        return found

    def frame(self) -> None:
        """Runs one frame; raises Wrong with the first thing that is."""
        container, machine = self.container, self.machine
        start_us = self.now_us
        boundary_us = np.concatenate(([0.0], np.cumsum(container.slot_us)))
        launches = iter(container.launches)
        launch = next(launches, None)
        stage = 0
        for boundary in range(container.slots + 1):
            self.boundary = boundary
            self.now_us = start_us + float(boundary_us[boundary])
            looks = stage < len(machine.looks) and machine.looks[stage] == boundary
            self.pending = machine.order(boundary) if looks else []
            while launch is not None and launch.instant == boundary:
                self.level = launch.level if launch.level is not None else self.level
                for word in self.kernels[launch.kernel]:
                    self._run(word)
                launch = next(launches, None)
            if self.pending:
                level = machine.at(boundary)[self.pending[0]].level
                raise Wrong(f"nothing is compared with {level} steps of IN at boundary {boundary}")
            if looks:
                self._step()
                stage += 1
            if boundary < container.slots:
                self._fall(boundary)
        self._check_end()
        self._next_frame(start_us + float(boundary_us[-1]))

    def _step(self) -> None:
        """The program's own step: answers lead to the next nodes."""
        lanes = self.lanes
        node = self.machine.steps[lanes.node, lanes.outcome].astype(np.int64)
        lanes = replace(lanes, node=node, outcome=np.zeros_like(node))
        self.lanes = lanes.merged(self._readouts(), self.scale)

    def _readouts(self) -> dict[int, int]:
        return {
            self.analog[readout.register]: self.container.buckets.index(readout.bucket)
            for readout in self.container.readouts
        }

    def _fall(self, slot: int) -> None:
        """The program's resets, and the light of a slot."""
        lanes, light = self.lanes, float(self.light[slot])
        since = np.where(self.machine.resets[lanes.node, slot], 0.0, lanes.since) + light
        due = lanes.due + self.machine.opens[lanes.node, :, slot].T * light
        analog = lanes.analog.copy()
        analog[self.analog["PIX"]] += light
        # What a register holds stays; said by exposures that grow, its rest shrinks.
        self.lanes = replace(lanes, since=since, due=due, analog=analog)

    def _check_end(self) -> None:
        lanes, container = self.lanes, self.container
        rests = lanes.rests()
        for bucket, name in enumerate(container.buckets):
            readout = next((r for r in container.readouts if r.bucket == name), None)
            if readout is None:
                raise Wrong("no register is read out", name)
            register = self.analog[readout.register]
            value = lanes.analog[register] * readout.gain - lanes.due[bucket]
            owes = lanes.owes[register] * readout.gain
            owes[bucket] -= 1.0
            told = (np.abs(owes) <= TOLERANCE).all(axis=0)
            told &= np.abs(rests[register]) <= TOLERANCE * self.scale
            right = np.where(lanes.exact, np.abs(value) <= TOLERANCE * self.scale, told)
            if not right.all():
                worst = int(self.machine.behaviour[lanes.node[int(np.argmin(right))]])
                what = "exposure differs from the sum of light over the open slots"
                raise Wrong(what, name, worst)
        self._check_bits(lanes)

    def _check_bits(self, lanes: Lanes) -> None:
        """The code is what it was, and states are held as the container says."""
        states = self._held(lanes.node, kept=False)
        for name, values in states.items():
            if not np.array_equal(self._read(name), values):
                raise Wrong(f"{name} does not hold its state when the frame ends")
        encoding = self.container.encoding[self.machine.behaviour[lanes.node]]
        for name in self.container.code_registers:
            column = self.target.digital_registers.index(name)
            if name not in states and not np.array_equal(self._read(name), encoding[:, column]):
                raise Wrong("the code registers do not hold their code when the frame ends")

    def _next_frame(self, end_us: float) -> None:
        """Whatever is left behind, and time for the readout; what no word writes fades."""
        machine, lanes = self.machine, self.lanes
        self.now_us = end_us + self.target.readout_us * len(self.container.readouts)
        self.written_us |= dict.fromkeys(self.loaded, -inf)
        kept = [k for k, state in enumerate(machine.states) if state.kept]
        first = range(int(machine.first[1]))
        starts = {
            (int(machine.behaviour[node]), *machine.values[node, kept].tolist()): node
            for node in first
        }
        keys = zip(
            machine.behaviour[lanes.node].tolist(),
            machine.values[lanes.node][:, kept].tolist(),
            strict=True,
        )
        nodes = np.array([starts[behaviour, *values] for behaviour, values in keys], np.int64)
        self.lanes = self._started(nodes, lanes.bits).merged({}, self.scale)

    def _reset(self, word: Op) -> None:
        analog = self.lanes.analog.copy()
        owes = self.lanes.owes.copy()
        pix = self.analog["PIX"]
        here = np.ones(self.lanes.count, np.bool_)
        if self.target.reset_honours_flag != "no":
            flag = self._read("FLAG")
            here = flag == 1
            unsure = flag == UNKNOWN
            if self.target.reset_honours_flag == "unknown":
                unsure = ~here
            analog[pix, unsure] = self._random()
        analog[pix, here] = self.reset_level
        self.lanes = replace(self.lanes, analog=analog, owes=owes)

    def _total(self, word: Op) -> tuple[Floats, Floats]:
        """The sum of a word's sources (lanes,) and what it owes (buckets, lanes)."""
        lanes = self.lanes
        total = np.zeros(lanes.count)
        owes = np.zeros((len(self.container.buckets), lanes.count))
        for name in word.sources:
            if name == "IN":
                if self.level is None:
                    raise Wrong(f"`{word}` reads IN, which nothing has set")
                total = total + self.level * self.target.electrons_per_step / self._electron
                continue
            total = total + lanes.analog[self.analog[name]]
            owes = owes + lanes.owes[self.analog[name]]
        return total, owes

    @property
    def _electron(self) -> float:
        """Electrons of a unit of the random light: a full well is all of it."""
        return self.target.full_well_e / self.scale

    def _bus(self, word: Op) -> None:
        total, owed = self._total(word)
        flag = self._read("FLAG")
        analog, owes = self.lanes.analog.copy(), self.lanes.owes.copy()
        here, unsure = flag == 1, flag == UNKNOWN
        for name in word.destinations:
            place = self.analog[name]
            analog[place, here] = (total / -word.operation.divisor)[here]
            owes[place][:, here] = (owed / -word.operation.divisor)[:, here]
            if unsure.any():
                analog[place, unsure] = self.noise.levels(1, int(unsure.sum()))[0]
                owes[place][:, unsure] = 0.0
        self.lanes = replace(self.lanes, analog=analog, owes=owes)

    def _compare(self, word: Op) -> None:
        """One of the program's comparisons, which both outcomes follow."""
        total, owes = self._total(word)
        if self.target.where_obeys_flag and not (self._read("FLAG") == 1).all():
            raise Wrong(f"`{word}` is masked in some pixels, at boundary {self.boundary}")
        comparisons = self.machine.at(self.boundary)
        for number in self.pending:
            for above in (False, True):
                if self._is(
                    comparisons[number].signal, comparisons[number].level, above, total, owes
                ):
                    self.pending.remove(number)
                    self._split(number, above)
                    return
        raise Wrong(
            f"`{word}` sums something else than a signal and its level, at boundary {self.boundary}"
        )

    def _is(self, signal: int, level: int, above: bool, total: Floats, owes: Floats) -> bool:
        """Whether these sums are exactly signal - level, or level - signal where not `above`."""
        lanes = self.lanes
        sign = 1.0 if above else -1.0
        level_in_light = level * self.target.electrons_per_step / self._electron
        expected = lanes.since if signal == LIGHT else lanes.due[signal]
        close = np.abs(sign * total - (expected - level_in_light)) <= TOLERANCE * self.scale
        rest = sign * owes
        if signal != LIGHT:
            rest = rest.copy()
            rest[signal] -= 1.0
        told = (np.abs(rest) <= TOLERANCE).all(axis=0)
        return bool((close & (told | lanes.exact)).all())

    def _split(self, number: int, above: bool) -> None:
        count = self.lanes.count
        self.transitions += 2 * count
        if self.transitions > MOST_LANES:
            raise Wrong(f"more than {MOST_LANES} transitions are to be followed")
        both = np.tile(np.arange(count), 2)
        lanes = self.lanes.chosen(both)
        answer = np.repeat([0, 1], count)
        self.lanes = replace(lanes, outcome=lanes.outcome | answer << number)
        self._write("FLAG", (answer == above).astype(np.int8))

    def _read(self, name: str) -> Bits:
        """What a digital source gives; unknown once it has decayed."""
        if self.now_us - self.written_us[name] > self.target.digital_retention_us:
            return np.full(self.lanes.count, UNKNOWN, np.int8)
        return np.asarray(self.lanes.bits[self.place[name]])

    def _some(self, word: Op) -> Bits:
        found = np.zeros(self.lanes.count, np.int8)
        for name in word.sources:
            value = self._read(name)
            either = np.maximum(found, value)
            found = np.where((found == 1) | (value == 1), 1, either).astype(np.int8)
        return found

    def _ones(self) -> Bits:
        return np.ones(self.lanes.count, np.int8)

    def _inverse(self, value: Bits) -> Bits:
        return np.where(value == UNKNOWN, UNKNOWN, 1 - value).astype(np.int8)

    def _write_masked(self, name: str, value: Bits) -> None:
        guard = self._read(self.target.mask_register or "")
        if (guard == 1).all():
            self._write(name, value)
            return
        old = self._read(name)
        unsure = np.where(old == value, old, UNKNOWN)
        kept = np.where(guard == 1, value, np.where(guard == 0, old, unsure))
        self._set(name, kept.astype(np.int8))

    def _set(self, name: str, value: Bits) -> None:
        bits = self.lanes.bits.copy()
        bits[self.place[name]] = value
        self.lanes = replace(self.lanes, bits=bits)

    def _write(self, name: str, value: Bits) -> None:
        self._set(name, value)
        self.written_us[name] = self.now_us
        self.loaded.discard(name)
