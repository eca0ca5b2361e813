"""Quick tests, by what all took: `pytest -m quick` takes less than a minute, `pytest --measure` measures anew."""

import os
from collections import defaultdict
from tempfile import mkdtemp

import pytest
from tests.beside import start_type_checker
from tests.times import is_quick, read_times, write_times


def pytest_addoption(parser: pytest.Parser) -> None:
    """Let times be measured."""
    parser.addoption("--measure", action="store_true", help="write what tests take to tests/times.txt")


def pytest_configure(config: pytest.Config) -> None:
    """Name the marker."""
    config.addinivalue_line("markers", "quick: most tests, at least one case of nearly each, in less than a minute")
    # What is compiled is kept for all workers of this run, and for no other.
    os.environ.setdefault("CRANKTRAIN_CACHE", mkdtemp(prefix="cranktrain-"))
    if config.option.measure and not hasattr(config, "workerinput"):
        config.pluginmanager.register(_Stopwatch())


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark the quick tests, before `-m` chooses among the marked."""
    times = read_times()
    for item in items:
        if is_quick(item.nodeid, times):
            item.add_marker("quick")


def pytest_collection_finish(session: pytest.Session) -> None:
    """Let the type checker begin with the tests, where they ask for it."""
    if not session.config.option.collectonly and any(item.path.name == "test_types.py" for item in session.items):
        start_type_checker()


class _Stopwatch:
    """Adds up what every test takes, its preparation too."""

    def __init__(self) -> None:
        self.measured: defaultdict[str, float] = defaultdict(float)
        self.prepared: defaultdict[str, float] = defaultdict(float)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Add a part."""
        self.measured[report.nodeid] += report.duration
        if report.when == "setup":
            file = report.nodeid.partition("::")[0]
            self.prepared[file] = max(self.prepared[file], report.duration)

    def pytest_sessionfinish(self) -> None:
        """Write all."""
        write_times(self.measured, self.prepared, read_times())
