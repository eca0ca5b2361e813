"""A sweep in a store that is killed, stopped or has no room: whoever resumes it has what nobody stopped would have."""

import random
import resource
import signal
import subprocess
import sys
import time

import pytest
from tests.e2e.conftest import environment, stopped
from tests.swept import same

import cranktrain as ct

zarr = pytest.importorskip("zarr")

VARY, WANTED = {"rod_length": "100..170 mm:400"}, "largest_torque,largest_side_force"
ASKED = ("sweep", "vaz_21213", "--vary", "rod_length=100..170 mm:400", "--wanted", WANTED, "--yes", "-o", "rods.zarr")
SMALL_BLOCKS = """
import sys
from cranktrain.study.sweep import computed
computed._designs_of_block = lambda *_known: 7
computed._WORTH = 0.0
from cranktrain.cli import main
sys.exit(main())
"""


def typed(*more: str) -> list[str]:
    return [sys.executable, "-c", SMALL_BLOCKS, *ASKED, *more]


@pytest.mark.parametrize("processes", ["1", "2"])
def test_killed_at_any_moment(tmp_path, processes):
    """Ten times at random, as long as it is not ready."""
    chosen, n_kills = random.Random(int(processes)), 0
    while n_kills < 10:
        begun = subprocess.Popen(typed("--processes", processes, "--resume"), cwd=tmp_path, env=environment())
        try:
            begun.wait(chosen.uniform(0.8, 1.8))
        except subprocess.TimeoutExpired:
            begun.kill()
            n_kills += 1
        if begun.wait() == 0:
            break
    assert n_kills > 2
    done = subprocess.run(
        typed("--processes", processes, "--resume"), cwd=tmp_path, env=environment(), capture_output=True, check=True
    )
    assert done.stdout == b"written: rods.zarr\n"
    assert b"Traceback" not in done.stderr
    names = WANTED.split(",")
    same(
        ct.sweep("vaz_21213", VARY, names, store=tmp_path / "rods.zarr", resume=True),
        ct.sweep("vaz_21213", VARY, names),
    )
    assert [path.name for path in tmp_path.iterdir() if path.suffix != ".tmp"] == ["rods.zarr"]


def test_ctrl_c_leaves_a_store_and_says_how_to_go_on(tmp_path):
    store = tmp_path / "rods.zarr"
    asked = (*ASKED[:-1], str(store))
    status, said = stopped(tuple(word.replace(":400", ":90000") for word in asked), times=3)
    assert status == 130
    assert b"of 90000 designs are in " in said
    assert b"the same command with --resume goes on with them" in said
    assert b"Traceback" not in said
    done = zarr.open_group(store, mode="r")["status"][:] > 0
    assert 4 <= done.sum() < 90000


def test_asked_to_end(tmp_path):
    begun = subprocess.Popen(typed(), cwd=tmp_path, env=environment(), stderr=subprocess.PIPE, encoding="utf-8")
    while not (tmp_path / "rods.zarr" / "status" / "c").exists() and begun.poll() is None:
        time.sleep(0.01)
    begun.send_signal(signal.SIGTERM)
    assert "stopped" in begun.communicate()[1]
    assert begun.returncode == 143
    assert subprocess.run(typed("--resume"), cwd=tmp_path, env=environment(), check=False).returncode == 0


def test_no_room_for_larger_files(tmp_path):
    done = subprocess.run(
        typed(),
        cwd=tmp_path,
        env=environment(PYTHONDONTWRITEBYTECODE="1"),
        stderr=subprocess.PIPE,
        encoding="utf-8",
        check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)),
    )
    assert done.returncode == 2
    assert done.stderr.startswith("rods.zarr  does not fit: it would be larger than files may be here")
    assert list(tmp_path.iterdir()) == []
