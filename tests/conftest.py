"""What all tests share: options, hypothesis profiles, and `nscc` without a new process."""

from __future__ import annotations

import gc
import os
import signal
import sys
from collections.abc import Generator, Iterator
from pathlib import Path

import pytest
from checkout import ROOT
from hypothesis import HealthCheck, settings
from nscc_command import RunNscc, invoke

# A shell's background jobs ignore Ctrl-C, and so would the processes that tests interrupt.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# Workers side by side fill the cores: threads of each would only wait for those of the others.
if "PYTEST_XDIST_WORKER" in os.environ:
    os.environ.setdefault("OMP_NUM_THREADS", "1")

# The same examples on every run: a test that fails here fails everywhere.
settings.register_profile(
    "ci",
    max_examples=40,
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture],
)
settings.register_profile(
    "search", parent=settings.get_profile("ci"), max_examples=2000, derandomize=False
)
settings.load_profile("ci")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--update-cases",
        action="store_true",
        help="Record again the expected texts and figures in tests/cases and tests/data.",
    )
    parser.addoption(
        "--record-long",
        action="store_true",
        help="Write the functions whose tests take long to tests/data/long_tests.txt.",
    )


# One function a line; `pytest --record-long` writes them after a run of all tests.
LONG_TESTS = ROOT / "tests/data/long_tests.txt"
_LONG_CASE_S, _LONG_FUNCTION_S = 1.0, 10.0


def _function_of(nodeid: str) -> str:
    """The test function of a test's id, without the case in square brackets."""
    return nodeid.split("[")[0]


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Tests of the functions in `LONG_TESTS` get the marker `long`."""
    functions = set(LONG_TESTS.read_text(encoding="utf-8").split())
    for item in items:
        if _function_of(item.nodeid) in functions:
            item.add_marker("long")


class _LongTests:
    """Adds up the seconds that each test takes, in the process that reports, and writes the
    functions whose tests take 1 s each on average, or 10 s together. Functions that did not run
    stay in the list."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self.seconds[report.nodeid] = self.seconds.get(report.nodeid, 0) + report.duration

    def pytest_sessionfinish(self) -> None:
        cases: dict[str, list[float]] = {}
        for nodeid, seconds in self.seconds.items():
            cases.setdefault(_function_of(nodeid), []).append(seconds)
        long_tests = [
            function
            for function, times in cases.items()
            if sum(times) >= min(_LONG_CASE_S * len(times), _LONG_FUNCTION_S)
        ]
        listed = LONG_TESTS.read_text(encoding="utf-8").split()
        long_tests = sorted(long_tests + [each for each in listed if each not in cases])
        LONG_TESTS.write_text("".join(f"{line}\n" for line in long_tests), encoding="utf-8")


def pytest_configure(config: pytest.Config) -> None:
    """Times are recorded by the process that reports, not by the workers."""
    if config.getoption("--record-long") and "PYTEST_XDIST_WORKER" not in os.environ:
        config.pluginmanager.register(_LongTests())


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """The garbage collector leaves out what ten thousand collected tests keep alive: looking
    through it again and again takes a third of a run."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


@pytest.fixture(autouse=True)
def _same_numbers() -> None:
    """torch's own generator starts alike in every test, whatever ran before."""
    torch = sys.modules.get("torch")
    if torch is not None:
        torch.manual_seed(0)


@pytest.fixture(scope="session", autouse=True)
def _own_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Search results lie in a folder of this run, which its workers share; never the user's."""
    run = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        run = run.parent
    with pytest.MonkeyPatch.context() as patch:
        patch.delenv("NSCC_CACHE", raising=False)
        patch.setenv("NSCC_CACHE_DIR", str(run / "cache"))
        yield


@pytest.fixture
def update_cases(request: pytest.FixtureRequest) -> bool:
    """Whether expected texts are to be rewritten instead of compared."""
    return bool(request.config.getoption("--update-cases"))


@pytest.fixture(scope="session")
def root() -> Path:
    """The checkout."""
    return ROOT


@pytest.fixture(scope="session")
def run_nscc() -> RunNscc:
    """Runs one `nscc` command in this process, as if started in `folder`."""
    return invoke
