"""Signatures, docstrings and the command line agree with the declarations of options."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any, get_args

import click
import pytest
from nscc_command import invoke

import nscc
import nscc_runtime
from nscc.diagnostics.arguments import WrongArgument
from nscc.lower.exposure_plan import LOWERINGS
from nscc.pipeline import Options
from nscc.program.program import Codes
from nscc.toml.arguments import checked
from nscc.toml.kinds import Flag, Kind, Number, TextKind
from nscc.toml.schema import declared
from nscc_cli import evaluate, reconstruct, tradeoff
from nscc_cli.build import command as build
from nscc_cli.demo import command as demo
from nscc_cli.design import command as design
from nscc_cli.group import group
from nscc_cli.run import command as run
from nscc_cli.sweep import command as sweep
from nscc_runtime.planning.tolerance import DEFAULT
from nscc_runtime.request import Request
from nscc_runtime.scenes import Scene
from nscc_training.command_settings import (
    DecoderStudySettings,
    DemoSettings,
    DesignSettings,
    EmulatorStudySettings,
    EvaluationSettings,
    FigureSettings,
    ImportSettings,
    JointRequest,
    ReconstructSettings,
    SensorStudySettings,
    SweepSettings,
    SynthesisStudySettings,
)

COMMAND_SETTINGS = [
    DecoderStudySettings,
    DemoSettings,
    DesignSettings,
    EmulatorStudySettings,
    EvaluationSettings,
    FigureSettings,
    ImportSettings,
    JointRequest,
    ReconstructSettings,
    SensorStudySettings,
    SweepSettings,
    SynthesisStudySettings,
]
CALLS: list[tuple[Callable[..., Any], type, set[str]]] = [
    (nscc.compile, Options, {"source", "folder"}),
    (nscc_runtime.scene, Scene, set()),
    (nscc_runtime.capture, Request, {"program", "light", "sensor", "turn"}),
    (nscc_runtime.plan, Request, {"program", "light", "sensor"}),
    (nscc_runtime.film, Request, {"program", "lights", "sensor"}),
]
"""Public functions, the declaration of their options, and their parameters that are no options."""
CHOSEN_LATER = {"effects", "tolerance"}
"""Options whose default in Python depends on other options: None, or "auto" for a plan."""
WHOLE = {"compile", "scene", "capture"}
"""Functions that take every declared option."""


def type_text(kind: Kind) -> str | None:
    """The type that a docstring gives for values of a kind; None if the kind is of one option."""
    if isinstance(kind, Flag):
        return "bool"
    if isinstance(kind, Number):
        if kind.is_whole and kind.high < 10:
            return "{" + ", ".join(map(str, range(int(kind.low), int(kind.high) + 1))) + "}"
        return "int" if kind.is_whole else "float"
    if isinstance(kind, TextKind) and kind.choices:
        return "{" + ", ".join(f'"{choice}"' for choice in kind.choices) + "}"
    return None


@pytest.mark.parametrize(
    ("call", "settings", "others"), CALLS, ids=lambda value: getattr(value, "__name__", "")
)
def test_a_signature_has_the_declared_options(
    call: Callable[..., Any], settings: type, others: set[str]
) -> None:
    keys = declared(settings)
    parameters = inspect.signature(call).parameters
    assert parameters.keys() - keys == others
    if call.__name__ in WHOLE:
        assert keys.keys() <= parameters.keys()
    for name in parameters.keys() & keys.keys() - CHOSEN_LATER:
        default = parameters[name].default
        assert default == keys[name].default or keys[name].required, name
    documented = dict(re.findall(r"^ {4}(\w+) : (.+)$", str(call.__doc__), re.MULTILINE))
    for name in parameters.keys() & keys.keys():
        text, optional, _ = documented[name].partition(", optional")
        assert bool(optional) == (parameters[name].default is None), name
        assert type_text(keys[name].kind) in (None, text), name


@pytest.mark.parametrize(
    ("command", "settings", "left_out"),
    [
        (build, Options, set()),
        (run, Options, set()),
        (run, Scene, set()),
        (run, Request, {"threads"}),
        (demo, DemoSettings, set()),
        (design, DesignSettings, set()),
        (sweep, SweepSettings, set()),
        (reconstruct.command, ReconstructSettings, set()),
        (evaluate.of, EvaluationSettings, set()),
        (evaluate.figures, FigureSettings, set()),
        (tradeoff.sensor, SensorStudySettings, set()),
        (tradeoff.decoder, DecoderStudySettings, set()),
        (tradeoff.emulator, EmulatorStudySettings, set()),
        (tradeoff.synthesis, SynthesisStudySettings, set()),
        (tradeoff.joint, JointRequest, set()),
    ],
    ids=lambda value: getattr(value, "__name__", getattr(value, "name", "")),
)
def test_commands_have_the_declared_options(
    command: click.Command, settings: type, left_out: set[str]
) -> None:
    options = {p.name: p for p in command.params if isinstance(p, click.Option)}
    for name, key in declared(settings).items():
        if name not in left_out:
            assert str(options[key.name].help).startswith(key.meaning), name


def test_values_that_declarations_repeat_equal_those_of_compiler_and_planner() -> None:
    """Declarations repeat these values, because they import neither the compiler nor the
    planner."""
    keys = declared(Options)
    assert keys["codes"].kind == TextKind(get_args(Codes))
    assert keys["lowering"].kind == TextKind(("auto", *LOWERINGS))
    assert Request.tolerance == DEFAULT


@pytest.mark.parametrize("settings", [Options, Scene, Request, *COMMAND_SETTINGS])
def test_defaults_are_values_of_their_kinds(settings: type) -> None:
    for name in declared(settings):
        default = getattr(settings, name, None)
        if default not in (None, ""):
            assert checked("call", settings, {name: default}) == {name: default}


OF_EACH_COMMAND = {
    "--budget", "--codes", "--count", "--crop", "--dark", "--data", "--effects", "--json",
    "--looks", "--method", "--on", "--out", "--plan", "--png", "--program", "--readouts", "--run",
    "--scene", "--schema", "--seed", "--sensor", "--slot-us", "--slots", "--target", "--toml", "-o",
}  # fmt: skip
"""Options that mean something else in some commands: files, lists of settings, and seeds."""


def texts_by_option(command: click.Command) -> dict[str, set[str]]:
    """The help of each option of a command and of its subcommands, without the default."""
    texts: dict[str, set[str]] = {}
    for parameter in command.params:
        if isinstance(parameter, click.Option):
            text = str(parameter.help).partition(" (default")[0].rstrip(".")
            texts.setdefault(parameter.opts[-1], set()).add(text)
    if isinstance(command, click.Group):
        context = click.Context(command)
        for name in {*command.commands, *command.list_commands(context)}:
            subcommand = command.get_command(context, name)
            assert subcommand is not None
            for option, found in texts_by_option(subcommand).items():
                texts.setdefault(option, set()).update(found)
    return texts


def test_an_option_of_several_commands_is_described_once() -> None:
    several = {option for option, texts in texts_by_option(group).items() if len(texts) > 1}
    assert several == OF_EACH_COMMAND


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("seed", -1, "call: seed is a whole number from 0, not -1"),
        ("seed", 2**63, "call: seed is a whole number from 0, not 9223372036854775808"),
        ("repeat", 0, "call: repeat is a whole number from 1 to 10000, not 0"),
        ("fidelity", "plannd", "did you mean `planned`"),
        ("audit", None, "call: audit is True or False, not None"),
        ("plan", 3.5, "call: plan is a plan or a plan file, not 3.5"),
        ("effects", 5, "call: effects is text, not 5"),
        ("tolerance", True, "call: tolerance is text or a number, not True"),
    ],
)
def test_invalid_arguments_are_explained(name: str, value: object, words: str) -> None:
    with pytest.raises(WrongArgument, match=re.escape(words)):
        checked("call", Request, {name: value})


def test_numbers_of_numpy_are_numbers() -> None:
    import numpy as np

    values = checked("call", Request, {"seed": np.int64(3), "audit": np.bool_(True)})
    assert values == {"seed": 3, "audit": True}
    assert type(values["seed"]) is int
    assert checked("call", Scene, {"crop": np.array([3, 5]).tolist()}) == {"crop": "3,5"}
    assert checked("call", Scene, {"exposure": np.float32(2.5)}) == {"exposure": "2.5"}


@pytest.mark.parametrize(
    ("option", "words"),
    [
        ("--first=99999999999999999999999", "too large"),
        ("--max-words-per-slot=99999999999999999999999", "too large"),
        ("--seed=9223372036854775808", "not in the range"),
        ("--repeat=0", "not in the range"),
        ("--patience=nan", "not a number"),
        ("--fit=scales", "not one of"),
    ],
)
def test_invalid_options_are_explained(option: str, words: str, tmp_path: Path) -> None:
    outcome = invoke(["run", "p.nsl", "--scene", "builtin:hdr", option], tmp_path)
    assert outcome.status == 2
    assert outcome.codes == ["NS0783"]
    assert words in outcome.err
