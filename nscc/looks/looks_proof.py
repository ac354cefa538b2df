"""The proof of programs with senses: the words implement the state machine, for all codes and
answers.

All outcomes of all comparisons are followed from every initial node. At each boundary the program's
comparisons must be made exactly once, by a `where` whose sum is exactly level - signal, or signal -
level; each lane then splits in two, one for each answer. At the end of the frame, every bucket must
contain the light of the program's open slots, and code and states must be as the container defines.
A second frame starts from the final registers of the first.

An analog value is a number for one random light, and its debt: `owes` times the exposure that each
bucket should contain by now, plus a remainder. Lanes with equal node, bits, debts and remainders
behave equally for any collected exposure, so they are merged; otherwise accumulating programs would
have 2^looks histories. A merged lane has the numbers of one history, and `exact` tells whether all
its histories had equal exposures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from nscc.arrays import Bools, Floats, Indices, Ints
from nscc.operations import Op
from nscc.prove.pixels import TOLERANCE, WRONG_CODE, WRONG_EXPOSURE, Bits, ReplayError, ReplayPixels
from nscc.truth import rows
from nscc.words.container import Container
from nscc.words.machine import LIGHT, StateMachine

MOST_LANES = 10**7
"""Most transitions that are followed in a frame."""

_DIGITS = 1e8
"""Remainders whose difference is below the frame's light divided by this number are equal."""


class LookingReplay(ReplayPixels):
    """A replay of words for all pixels that the proof of a program with senses distinguishes.

    These pixels are called lanes. Arrays with one row per lane: `node` int64 (lanes,) is the node
    of the state machine. Bit c of `outcome`, int64 (lanes,), is the answer of comparison c of the
    current look. `due` (lanes, buckets) are the exposures that the program requires, and `since`
    (lanes,) is the light since the last reset, in electrons. `exact`, bool (lanes,), tells whether
    all histories that were merged in a lane had equal exposures. `pending` are the indices of the
    comparisons that words still have to make at this boundary."""

    def __init__(self, container: Container, kernels: Sequence[Sequence[Op]]) -> None:
        """Begin with a lane (simulated pixel) for each initial node of the state machine, at the
        start of a frame.

        `kernels` are the container's words as operations. Registers of kept states hold their
        values, because a frame may start with any. Raises ReplayError if such a value has no bits.
        """
        self.machine: StateMachine = container.machine
        self.full_e = container.target.full_well_e
        nodes = np.arange(self.machine.first[1], dtype=np.int64)
        encoding = container.encoding[self.machine.behaviour[nodes]]
        super().__init__(container, kernels, encoding, terms=len(container.buckets))
        self.pending: list[int] = []
        self._start(nodes)
        self.bits |= self._state_bits(kept_only=True)

    def _start(self, nodes: Ints) -> None:
        """Begin a frame with one lane (simulated pixel) for each of `nodes`, indices of nodes of
        the state machine, which may be repeated; without exposure."""
        self.node, self.outcome = nodes, np.zeros_like(nodes)
        self.due = np.zeros((len(nodes), len(self.container.buckets)))
        self.since = np.zeros(len(nodes))
        self.exact = np.ones(len(nodes), np.bool_)

    def choose(self, lanes: Indices) -> None:
        """Replace the lanes (simulated pixels) by those with the indices `lanes`, which may be
        repeated or left out."""
        super().choose(lanes)
        self.node, self.outcome = self.node[lanes], self.outcome[lanes]
        self.due, self.since, self.exact = self.due[lanes], self.since[lanes], self.exact[lanes]

    def _state_bits(self, *, kept_only: bool) -> dict[str, Bits]:
        """Return the bits that the states' registers should hold in the lanes' nodes, by register.

        States without registers in the container (a compiled program) are left out and, with
        `kept_only`, states that are not kept. Raises ReplayError if a state has a value without
        bits."""
        known_registers: dict[str, Bits] = {}
        for k, state in enumerate(self.machine.states):
            planes = self.container.state_planes.get(state.name)
            if planes is None or (kept_only and not state.is_kept):
                continue
            bits = dict(zip(planes.values, planes.bits, strict=True))
            values = self.machine.values[self.node, k].tolist()
            if not bits.keys() >= set(values):
                raise ReplayError(f"no bits represent some value of the state `{state.name}`")
            value_rows = np.array([bits[value] for value in values], np.bool_)
            registers = value_rows.reshape(len(values), -1)
            known_registers |= zip(planes.registers, self.known(registers), strict=True)
        return known_registers

    def prove_frame(self, light: Floats) -> None:
        """Run one frame in `light`, float64 (N,), the light of each slot, and follow both answers
        of every comparison.

        The light is scaled so that its sum is a full well; it must not be 0. Raises ReplayError at
        the first difference from the program."""
        machine, slots = self.machine, self.container.slots
        light_e = light * (self.full_e / light.sum())
        self.start_frame()
        self._merge_lanes({})
        for boundary in range(slots + 1):
            looks = boundary in machine.looks
            self.pending = machine.order(boundary) if looks else []
            self.run_launches(boundary)
            if self.pending:
                level = machine.at(boundary)[self.pending[0]].level
                raise ReplayError(
                    f"no comparison uses the level of {level} steps of IN at boundary {boundary}"
                )
            if looks:
                self.node = machine.steps[self.node, self.outcome].astype(np.int64)
                self.outcome = np.zeros_like(self.node)
                self._merge_lanes(self._readouts())
            if boundary < slots:
                self._add_light(boundary, float(light_e[boundary]))
        self.end_frame()
        self._check_end()
        self._next_frame()

    def _readouts(self) -> dict[str, int]:
        """Return the index of the bucket that each analog register is read out as, by register;
        other registers are left out."""
        buckets = self.container.buckets
        return {r.register: buckets.index(r.bucket) for r in self.container.readouts}

    def _add_light(self, slot: int, light_e: float) -> None:
        """Add the light of the slot with the index `slot`, `light_e` electrons in each pixel, to
        PIX (the photodiode) and to what the program requires.

        The program's resets at the start of the slot come first; words have reset PIX itself."""
        self.since = np.where(self.machine.resets[self.node, slot], 0.0, self.since) + light_e
        # The content of a register stays constant, so its rest shrinks as exposures grow.
        self.due += self.machine.opens[self.node, :, slot] * light_e
        self.analog["PIX"][:, 0] += light_e

    def _check_end(self) -> None:
        """Check every pixel at the end of the frame: exposures, states and code.

        Raises ReplayError if a bucket is not read out, if its register does not hold the exposure,
        if a state's register does not hold the state, or if a code register has changed."""
        gains = {readout.bucket: readout for readout in self.container.readouts}
        for bucket, name in enumerate(self.container.buckets):
            if name not in gains:
                raise ReplayError("no register is read out", name)
            value = self.analog[gains[name].register] * gains[name].gain
            right = self._equals_in_any_light(value, bucket, self.due[:, bucket])
            if not right.all():
                worst = int(self.machine.behaviour[self.node[int(np.argmin(right))]])
                raise ReplayError(WRONG_EXPOSURE, name, worst)
        states = self._state_bits(kept_only=False)
        for register, bits in states.items():
            if self.read(register) != bits:
                raise ReplayError(f"{register} does not hold its state at the end of the frame")
        encoding = self.container.encoding[self.machine.behaviour[self.node]]
        for register, bits in self.code_bits(encoding).items():
            if register not in states and self.read(register) != bits:
                raise ReplayError(WRONG_CODE)

    def _next_frame(self) -> None:
        """Begin the next frame: each lane (simulated pixel) continues at the initial node of the
        state machine with its behaviour and its kept states."""
        machine = self.machine
        kept_states = [k for k, state in enumerate(machine.states) if state.is_kept]
        keys = np.column_stack((machine.behaviour, machine.values[:, kept_states])).tolist()
        # Initial nodes differ in nothing but behaviour and kept states.
        starts = {tuple(key): node for node, key in enumerate(keys[: int(machine.first[1])])}
        self._start(np.array([starts[tuple(keys[node])] for node in self.node], np.int64))

    def compare(self, word: Op) -> Bits:
        """Check that a comparison is one of the program's at this boundary, and split every lane (a
        simulated pixel) in two, one for each answer.

        Return FLAG (the bit that lets a pixel act) of all lanes. Raises ReplayError if the sum that
        `word` tests is not a signal minus its level or the negative of that, or if FLAG excludes
        some pixels from the comparison."""
        if self.target.where_obeys_flag and self.read("FLAG") != (self.everything, 0):
            raise ReplayError(f"FLAG is 0 in some pixels at `{word}`, at boundary {self._boundary}")
        total = self.total(word)
        comparisons = self.machine.at(self._boundary)
        for number in self.pending:
            comparison = comparisons[number]
            level_e = comparison.level * self.target.electrons_per_step
            for above in (False, True):
                if self._is_signal_minus_level(
                    total if above else -total, comparison.signal, level_e
                ):
                    self.pending.remove(number)
                    return self._follow_both(number, above)
        raise ReplayError(
            f"`{word}` tests a sum that is not a signal of the program minus its level, at "
            f"boundary {self._boundary}"
        )

    def _is_signal_minus_level(self, value: Floats, signal: int, level_e: float) -> bool:
        """Return whether a value, float64 (lanes, 1 + buckets), is exactly signal - level in every
        lane (simulated pixel), in any light.

        Column 0 is a number in electrons, the others are how often it contains each exposure.
        `signal` is LIGHT or the index of a bucket, and `level_e` the level in electrons."""
        if signal == LIGHT:
            return bool(
                self._equals_in_any_light(value, bucket=None, expected_e=self.since - level_e).all()
            )
        return bool(self._equals_in_any_light(value, signal, self.due[:, signal] - level_e).all())

    def _equals_in_any_light(self, value: Floats, bucket: int | None, expected_e: Floats) -> Bools:
        """Return for each lane (simulated pixel) whether a value, float64 (lanes, 1 + buckets),
        equals `expected_e` in any light.

        Column 0 is a number in electrons, for one light; the others are how often the value
        contains each exposure. That must be once for `bucket`, an index (None: for no bucket),
        unless the lane is exact. `expected_e` is float64 (lanes,)."""
        owes = value[:, 1:].copy()
        if bucket is not None:
            owes[:, bucket] -= 1.0
        owed_once = (np.abs(owes) <= TOLERANCE).all(axis=1)
        return (np.abs(value[:, 0] - expected_e) <= TOLERANCE * self.full_e) & (
            owed_once | self.exact
        )

    def _follow_both(self, number: int, above: bool) -> Bits:
        """Double the lanes, one for each answer of the comparison with the index `number`, and
        return FLAG (the bit that lets a pixel act).

        FLAG is 1 where the signal is above its level if `above`, else where it is not. Raises
        ReplayError beyond `MOST_LANES` transitions. A lane is a simulated pixel."""
        count = self.lanes
        self.transitions += 2 * count
        if self.transitions > MOST_LANES:
            raise ReplayError(f"the proof needs more than {MOST_LANES} transitions")
        self.choose(np.tile(np.arange(count), 2))
        self.outcome |= np.repeat([0, 1], count) << number
        # The first half of the lanes has the answer no; bits are (lanes with 1, lanes with 0).
        no = (1 << count) - 1
        yes = no << count
        return (yes, no) if above else (no, yes)

    def _merge_lanes(self, readouts: Mapping[str, int]) -> None:
        """Merge lanes (simulated pixels) that behave equally from now on.

        `readouts` has the index of the bucket of each readout register. If all histories of a lane
        have equal exposures, such a register then counts as containing exactly its bucket's
        exposure."""
        for register, bucket in readouts.items():
            self.analog[register][self.exact, 1:] = 0.0
            self.analog[register][self.exact, 1 + bucket] = 1.0
        values = np.stack(list(self.analog.values()), axis=1)
        owes = values[:, :, 1:]
        rests = values[:, :, 0] - (owes * self.due[:, None]).sum(axis=2)
        lights = np.rint(np.column_stack((self.since, rests)) * (_DIGITS / self.full_e))
        # Debts are small multiples of powers of two; 1024 separates them and absorbs rounding.
        terms = np.rint(owes.reshape(self.lanes, -1) * 1024)
        numbers = np.column_stack((self.node, lights, terms)).astype(np.int64)
        bits = rows([vector for bits in self.bits.values() for vector in bits], self.lanes)
        keys = np.hstack((numbers.view(np.uint8), np.packbits(bits, axis=1)))
        # Each row as one value of bytes: lanes with equal bytes are merged.
        keys = np.ascontiguousarray(keys).view(f"V{keys.shape[1]}")[:, 0]
        _, first, group = np.unique(keys, return_index=True, return_inverse=True)
        # Merged lanes stay exact only if all of them had the same exposures.
        same = (np.abs(self.due - self.due[first[group]]) <= self.full_e / _DIGITS).all(axis=1)
        exact = np.ones(len(first), np.bool_)
        np.logical_and.at(exact, group, same & self.exact)
        self.choose(first)
        self.exact = exact
