"""Gates on boolean arrays, one element a shutter: whether a solution answers its problem.

Shares nothing with the generators: no truth vectors, no table of what a gate is.
"""

from __future__ import annotations

import numpy as np
from lowering_oracle import program_from

from nscc.lower.decoding import problem_of
from nscc.lower.exposure_plan import levels, plan_exposure, timeline


def book(shutters, slots, seed, density=0.5):
    """A table of random rows."""
    return np.random.default_rng(seed).random((shutters, slots)) < density


def asked_of(table, lowering="accumulate"):
    """The demands of a table in one lowering."""
    program = program_from(table)
    opens = levels(program)
    plan = plan_exposure(program, lowering, opens)
    time = timeline(program.frame.slot_us, len(program.buckets), program.target)
    return problem_of(program, plan, time, opens)[0]


def bits(vector, shutters):
    """A truth vector as booleans (shutters,)."""
    return np.array([vector >> i & 1 for i in range(shutters)], dtype=bool)


def words_if_right(asked, machine, solution, seed=0):
    """Runs two frames of the gates over all shutters, one boolean array a register; their words."""
    random = np.random.default_rng(seed)
    noise = lambda: random.random(asked.shutters) < 0.5  # noqa: E731
    code = {f"p{i}": bits(plane, asked.shutters) for i, plane in enumerate(solution.planes)}
    held = {name: plane.copy() for name, plane in code.items()}
    held |= {f"t{i}": noise() for i in range(solution.scratch)}
    assert len(held) <= machine.registers
    assert len(solution.holders) == len(code)
    written = set()
    for _ in range(2):
        words = 0
        for demand, answer in zip(asked.demands, solution.answers, strict=True):
            if not demand.flag_kept:
                held["FLAG"] = noise()
            for gate in (gate for segment in answer for gate in segment):
                sources = [held[name] for name in gate.sources]
                most = machine.where_sources if gate.name == "WHERE" else machine.or_sources
                assert most is None or len(sources) <= most
                any_on = np.any(sources, axis=0) if sources else np.zeros(asked.shutters, bool)
                if gate.name == "WHERE":
                    assert sources
                    assert gate.destination == "FLAG"
                    assert machine.where_reads_flag or "FLAG" not in gate.sources
                else:
                    assert gate.destination in held
                    assert gate.destination != "FLAG"
                    assert len(sources) >= 2 or gate.name in ("NOT", "MOV", "SET", "CLR")
                held[gate.destination] = any_on ^ (gate.name in ("NOR", "NOT", "SET"))
                written.add(gate.destination)
                words += 1 + (gate.destination in gate.sources)
            assert (held["FLAG"] == bits(demand.predicate, asked.shutters)).all()
        assert solution.opening == solution.closing == ()
        assert all((held[name] == plane).all() for name, plane in code.items())
    # One plane at least may live in the register that takes no write without its mask.
    assert not written & set(code)
    return words
