"""What only a process of its own can show: exit status, streams, signals, full disks, what is imported."""

import resource
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from tests.e2e.conftest import environment

HEAVY = ("xarray", "matplotlib", "numba", "tree_sitter", "tree_sitter_toml", "pandas", "cranktrain.viz")

IMPORTED = """
import sys
from cranktrain.cli import main
status = main({arguments!r})
print("\\n".join(sys.modules), file=sys.stderr)
sys.exit(status)
"""


@pytest.fixture
def modules(cranktrain, tmp_path):
    def imported(*arguments: str) -> set[str]:
        script = tmp_path / "imported.py"
        script.write_text(IMPORTED.format(arguments=list(arguments)), encoding="utf-8")
        environment = {"PYTHONPATH": ":".join(filter(None, sys.path)), "PYTHONUTF8": "1"}
        done = subprocess.run(
            [sys.executable, script], env=environment, capture_output=True, encoding="utf-8", check=True
        )
        return set(done.stderr.split())

    return imported


def test_run_leaves_heavy_packages_alone(modules):
    assert modules("run", "3d12").isdisjoint((*HEAVY, "scipy"))


def test_compare_leaves_heavy_packages_alone(modules):
    assert modules("compare", "3d12", "kamaz_740").isdisjoint((*HEAVY, "scipy"))


@pytest.mark.parametrize(
    "arguments", [[], ["run", "--help"], ["compare", "--help"], ["list"], ["--version"]], ids=" ".join
)
def test_help_and_list_are_light(modules, arguments):
    assert modules(*arguments).isdisjoint((*HEAVY, "numpy"))


def test_run_says_everything_on_stdout(cranktrain):
    done = cranktrain("run", "3d12")
    assert (done.returncode, done.stderr) == (0, "")
    assert len(done.stdout.splitlines()) <= 45 + 6  # rows of main bearings, which go beyond a screen
    assert all(len(line) <= 80 for line in done.stdout.splitlines())
    assert "\x1b" not in done.stdout
    done = cranktrain("run", "3d12", "--full")
    assert (done.returncode, done.stderr) == (0, "")
    lines = done.stdout.splitlines()
    assert all(len(line) <= 80 for line in lines)
    assert "\x1b" not in done.stdout
    heads = [line for line in lines if line and not line.startswith(" ")]
    for head in ("Results", "Checks", "What this rests on", "To learn more"):
        assert head in heads


def test_errors_go_to_stderr_with_status_2(cranktrain, tmp_path):
    (tmp_path / "bad.toml").write_text('[mechanism]\nkind = "slider_crank"\nstroke = "80 kg"\n', encoding="utf-8")
    done = cranktrain("run", "bad.toml", "-o", "out.csv")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("bad.toml:3:10  mechanism.stroke = 80 kg: kg measures a mass; must be a length")
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "out.csv").exists()


def test_full_disk_leaves_nothing_behind(cranktrain, tmp_path):
    def limited() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))

    (tmp_path / "out.csv").write_text("old\n", encoding="utf-8")
    done = cranktrain("run", "3d12", "-o", "out.csv", "--force", preexec_fn=limited)
    assert done.returncode == 2
    assert done.stderr.startswith("out.csv  does not fit")
    assert len(done.stderr.splitlines()) == 1
    assert [path.name for path in tmp_path.iterdir()] == ["out.csv"]
    assert (tmp_path / "out.csv").read_text(encoding="utf-8") == "old\n"


def test_full_standard_output(cranktrain):
    with Path("/dev/full").open("w", encoding="utf-8") as full:
        done = cranktrain("run", "3d12", stdout=full)
    assert done.returncode == 2
    assert done.stderr == "standard output  cannot be written: No space left on device\n"


def test_closed_pipe_is_quiet(starting):
    program = starting("list", "results")
    program.stdout.close()
    assert program.stderr.read() == ""
    assert program.wait() == 141
    program.stderr.close()


@pytest.mark.parametrize(
    ("number", "status"),
    [(signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)],
    ids=["INT", "TERM", "HUP"],
)
def test_a_signal_stops_without_a_trace(starting, tmp_path, number, status):
    """Every hundredth of a degree of a radial takes seconds."""
    program = starting("run", "r_1340", "--step", "0.01", "-o", "out.csv")
    deadline = time.monotonic() + 20
    while not any(path.suffix == ".tmp" for path in tmp_path.iterdir()):  # the output is begun before the computation
        assert program.poll() is None and time.monotonic() < deadline
        time.sleep(0.02)
    program.send_signal(number)
    output, errors = program.communicate(timeout=20)
    assert (program.returncode, output, errors) == (status, "", "stopped\n")
    assert list(tmp_path.iterdir()) == []


def test_ctrl_c_while_a_class_is_made_has_the_same_status(tmp_path):
    """Dataclasses are made by running text; by itself Python then ends by the signal."""
    program = """
import sys
from cranktrain.cli import app, main

app.task = lambda _arguments: lambda: exec("raise KeyboardInterrupt")
main(["list"])  # loads all that says it, of which classes are made, too
sys.exit(main(["list"]))
"""
    (tmp_path / "interrupted.py").write_text(program, encoding="utf-8")
    command = [sys.executable, "-m", "interrupted"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, encoding="utf-8", check=False)
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "stopped\n" * 2)


@pytest.mark.parametrize(
    ("closed", "arguments", "status"),
    [("1", "run 3d12 -o out.csv", 2), ("1", "--help", 2), ("2", "run nothing", 2), ("2", "list", 0)],
)
def test_closed_streams(tmp_path, closed, arguments, status):
    command = f"exec {sys.executable} -m cranktrain {arguments} {closed}>&-"
    done = subprocess.run(
        ["/bin/sh", "-c", command], cwd=tmp_path, env=environment(), capture_output=True, encoding="utf-8", check=False
    )
    assert done.returncode == status
    assert done.stderr == ("standard output  is closed\n" if closed == "1" else "")
    assert list(tmp_path.iterdir()) == []


def test_full_standard_error(cranktrain, tmp_path):
    command = f"exec {sys.executable} -m cranktrain run nothing 2>/dev/full"
    assert subprocess.run(["/bin/sh", "-c", command], cwd=tmp_path, env=environment(), check=False).returncode == 2


def test_the_plotting_library_keeps_its_words_to_itself(cranktrain, tmp_path):
    homeless = {"HOME": "/nonexistent", "MPLCONFIGDIR": "/proc/nowhere", "TMPDIR": str(tmp_path)}
    done = cranktrain("plot", "pumping_unit_c57", "-o", "unit.svg", env=environment(**homeless))
    assert (done.returncode, done.stdout, done.stderr) == (0, "written: unit.svg\n", "")
