"""Words that reset some pixels only: planned frames beside those of the reference.

The compiler selects all pixels before it resets them; words by hand need not, on chips whose reset
honours FLAG.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from plan_cases import CASES, moving_light
from reference_programs import sensor_of, target_of

import nscc_runtime
from nscc.compiler import compile_source
from nscc.operations import op
from nscc.pipeline import Options
from nscc.source import Source
from nscc.words.container import Container
from nscc.words.encoding import encode

SHAPE = (12, 16)
EFFECTS = "reset,read,analog,lag,leakage"


def some_reset(name: str) -> Container:
    """A program whose words, after the first kernel, reset only where FLAG is 1."""
    text, lowering = CASES[name]
    target = replace(target_of(SHAPE), reset_honours_flag="yes")
    options = Options(level=1, lowering=lowering, target=target)  # type: ignore[arg-type]
    source = Source("p.nsl", text.format(slots=8, slot="500us"))
    container = compile_source(source, Path(), options).container
    assert container is not None
    everywhere, nothing = (encode(op(word)) for word in ("all", "nop"))
    kernels = [
        replace(kernel, words=tuple(nothing if w == everywhere else w for w in kernel.words))
        for kernel in container.kernels
    ]
    first = container.launches[0].kernel
    kernels[first] = container.kernels[first]
    assert kernels != list(container.kernels)
    return replace(container, kernels=tuple(kernels))


@pytest.mark.parametrize("name", ["b accumulate", "d accumulate"])
def test_planned_frames_equal_the_reference_if_words_reset_only_some_pixels(name: str) -> None:
    container, light = some_reset(name), moving_light((8, *SHAPE), 900.0)
    planned, reference = (
        np.stack(
            [
                nscc_runtime.capture(
                    container,
                    light,
                    effects=EFFECTS,
                    fidelity=fidelity,
                    sensor=sensor_of(container),
                    seed=seed,
                ).exposure_e
                for seed in range(25)
            ]
        )
        for fidelity in ("planned", "reference")
    )
    assert reference[0].std() > 1000.0
    # The simulators draw for themselves: means and standard deviations of pixels are equal.
    # A shutter that stays shut has no noise.
    variance_e2 = (planned.var(axis=0) + reference.var(axis=0)) / len(planned)
    silent = variance_e2 == 0.0
    difference_e = planned.mean(axis=0) - reference.mean(axis=0)
    assert not difference_e[silent].any()
    assert silent.mean() < 0.5
    error = difference_e[~silent] / np.sqrt(variance_e2[~silent])
    assert np.sqrt(np.mean(error**2)) < 1.2
    assert planned.std(axis=0).mean() == pytest.approx(reference.std(axis=0).mean(), rel=0.1)
