"""Random words on the emulator and on the oracle: every register agrees, bit for bit."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from emulator_oracle import Chip
from emulator_programs import container_of, target_of
from hypothesis import given, settings
from hypothesis import strategies as st

from nscc.operations import Op, op, pair
from nscc.words.container import Container, Launch, Readout, StoredKernel
from nscc.words.encoding import encode
from nscc_runtime.emulator import expose
from nscc_runtime.light import Light

SHAPES = ((1, 1), (3, 5), (1, 65), (7, 129))
ANALOG = ("A", "B", "C", "D", "E", "F", "NEWS")
DIGITAL = tuple(f"R{i}" for i in range(13))


def _some(names, least, most):
    return st.lists(st.sampled_from(names), min_size=least, max_size=most, unique=True)


@st.composite
def _bus(draw):
    name, outs, most = draw(st.sampled_from([("bus", 1, 4), ("bus2", 2, 2), ("bus3", 3, 1)]))
    destinations = draw(_some(ANALOG, outs, outs))
    rest = [name for name in (*ANALOG, "PIX", "IN") if name not in destinations]
    least = 1 if name == "bus3" else 0
    return [op(name, destinations, draw(_some(rest, least, most)))]


@st.composite
def _digital(draw):
    name = draw(st.sampled_from(["SET", "CLR", "MOV", "NOT", "OR", "NOR"]))
    most = 1 if name in ("MOV", "NOT", "OR", "NOR") else 4
    destinations = draw(_some(DIGITAL, 1, most))
    least, most = {"MOV": (1, 1), "NOT": (1, 1), "OR": (2, 6), "NOR": (2, 6)}.get(name, (0, 0))
    rest = [name for name in (*DIGITAL, "FLAG", "SELECT") if name not in destinations]
    return [op(name, destinations, draw(_some(rest, least, most)))]


@st.composite
def _pair(draw):
    kind = draw(st.sampled_from(["OR", "NOR", "REFRESH"]))
    sources = draw(_some((*DIGITAL, "FLAG"), 1, 1 if kind == "REFRESH" else 5))
    return list(pair(kind, draw(st.sampled_from(DIGITAL)), sources))


def _flag(reads_flag):
    digital = (*DIGITAL, "FLAG") if reads_flag else DIGITAL
    return st.one_of(
        st.just([op("all")]),
        _some((*ANALOG, "PIX"), 1, 3).map(lambda sources: [op("where", (), sources)]),
        _some(digital, 1, 5).map(lambda sources: [op("WHERE", (), sources)]),
    )


def _kernel(reads_flag):
    plain = st.sampled_from([[op("nop")], [op("rpix")]])
    word = st.one_of(_bus(), _bus(), _digital(), _pair(), _flag(reads_flag), plain)
    return st.lists(word, max_size=12).map(lambda words: [w for part in words for w in part])


def _measured(container: Container, light: Light, words: list[Op], readouts, seed) -> np.ndarray:
    """What registers hold in a frame that runs only `words`, at boundary 0."""
    kernel = StoredKernel("probe", tuple(encode(word) for word in words))
    probe = replace(
        container,
        kernels=(kernel,),
        launches=(Launch(0, 0),),
        buckets=tuple(readout.bucket for readout in readouts),
        readouts=tuple(readouts),
        table=replace(
            container.table,
            shutters=np.zeros((len(container.encoding), len(readouts), container.slots), bool),
        ),
    )
    return expose(probe, light, device_seed=seed).exposure_e


@settings(max_examples=150, deadline=None)
@given(st.data())
def test_random_words_act_as_the_oracle_says(data):
    shape = data.draw(st.sampled_from(SHAPES))
    reads_flag = data.draw(st.booleans())
    behaviour = {
        "reset_honours_flag": data.draw(st.sampled_from(["no", "yes", "unknown"])),
        "where_reads_flag": reads_flag,
        "where_obeys_flag": data.draw(st.booleans()),
    }
    kernels = data.draw(st.lists(_kernel(reads_flag), min_size=1, max_size=3))
    slots = data.draw(st.integers(1, 4))
    instants = sorted(data.draw(st.lists(st.integers(0, slots), max_size=6)))
    launches = [(n, data.draw(st.integers(0, len(kernels) - 1))) for n in instants]
    device_seed = data.draw(st.integers(0, 2**63 - 1))
    random = np.random.default_rng(data.draw(st.integers(0, 2**32 - 1)))

    target = target_of(shape, **behaviour)
    planes = {name: random.random(shape) < 0.5 for name in DIGITAL}
    light = Light.of_clip(random.uniform(0, 100, (slots, *shape)).astype(np.float32))
    # Registers that are not read out may be treated with less care.
    shown = ["A", *data.draw(_some(ANALOG[1:], 0, 6))]
    readouts = [Readout(name, name) for name in shown]
    container = container_of(
        target, planes, [[op("all")], *kernels], [(0, 0)], slots, readouts=readouts
    )
    container = replace(
        container, launches=(Launch(0, 0), *(Launch(n, k + 1) for n, k in launches))
    )

    def measured(words, *registers):
        found = [Readout(name, name) for name in registers]
        return _measured(container, light, words, found, device_seed)

    chip = Chip(
        analog=dict(zip(ANALOG, measured([], *ANALOG), strict=True)),
        digital=planes,
        flag=np.ones(shape, bool),
        reset=-measured([op("all"), op("rpix"), op("bus", ["A"], ["PIX"])], "A")[0],
        reset_honours_flag=behaviour["reset_honours_flag"] != "no",
        where_obeys_flag=behaviour["where_obeys_flag"],
    )
    chip.analog["PIX"] = -measured([op("all"), op("bus", ["A"], ["PIX"])], "A")[0]
    chip.analog["IN"] = np.zeros(shape)
    chip.digital["SELECT"] = np.zeros(shape, bool)
    words = [
        [
            (word.name, word.destinations, word.sources)
            for at, kernel in launches
            if at == n
            for word in kernels[kernel]
        ]
        for n in range(slots + 1)
    ]
    chip.expose(words, light.dense())

    found = expose(container, light, device_seed=device_seed)
    for k, name in enumerate(shown):
        np.testing.assert_array_equal(found.exposure_e[k], chip.analog[name], err_msg=name)

    # Digital registers show themselves through FLAG: 1 where the bit is set, 0 elsewhere.
    for name in (*DIGITAL, "FLAG"):
        if name == "FLAG":
            look = [op("MOV", ["R1"], ["FLAG"]), op("all"), op("bus", ["A"])]
            look += [op("bus", ["B"], ["PIX"]), op("WHERE", (), ["R1"]), op("bus", ["A"], ["B"])]
            expected = chip.flag
        else:
            look = [op("all"), op("bus", ["A"]), op("bus", ["B"], ["PIX"])]
            look += [op("WHERE", (), [name]), op("bus", ["A"], ["B"])]
            expected = chip.digital[name]
        kernel = StoredKernel("look", tuple(encode(word) for word in look))
        looked = replace(
            container,
            kernels=(*container.kernels, kernel),
            launches=(*container.launches, Launch(slots, len(container.kernels))),
        )
        value = expose(looked, light, device_seed=device_seed).exposure_e[0]
        np.testing.assert_array_equal(value != 0, expected, err_msg=name)
