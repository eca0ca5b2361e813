"""A sweep by workers of Dask: the same bytes; and a scheduler that goes away takes nothing that is in a store."""

import threading
import time

import pytest
from tests.swept import same

import cranktrain as ct
from cranktrain.study.sweep import computed, swept
from cranktrain.study.sweep.facts import FactsOfSweep

distributed = pytest.importorskip("distributed")

MACHINE, VARY, WANTED = "burning_cylinder", {"mechanism.rod_length": "0.2..0.3 m:300"}, ["largest_torque"]
# Of a cluster that is taken away distributed leaves sockets open, and its own imports are deprecated.
pytestmark = pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::DeprecationWarning")


@pytest.fixture(autouse=True)
def small_blocks(monkeypatch):
    monkeypatch.setattr(computed, "_designs_of_block", lambda *_known: 10)


@pytest.fixture
def cluster():
    """A scheduler and two processes that work."""
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as found:
        yield found


def test_the_same_bytes_by_an_address_and_by_a_client(cluster, tmp_path):
    alone = ct.sweep(MACHINE, VARY, WANTED)
    same(ct.sweep(MACHINE, VARY, WANTED, scheduler=cluster.scheduler_address), alone)
    with distributed.Client(cluster) as client:
        same(ct.sweep(MACHINE, VARY, WANTED, scheduler=client, store=tmp_path / "rods.zarr"), alone)
        assert client.status == "running"


def test_a_scheduler_that_goes_away(cluster, tmp_path):
    pytest.importorskip("zarr")
    path = tmp_path / "rods.zarr"

    def stop():
        while not (path / "status" / "c").exists():
            time.sleep(0.01)
        cluster.close()

    stopping = threading.Thread(target=stop)
    stopping.start()
    vary = {"mechanism.rod_length": "0.2..0.3 m:500"}
    with pytest.raises(ct.InputError, match=r"scheduler = tcp://.*: the scheduler is gone"):
        ct.sweep(MACHINE, vary, WANTED, scheduler=cluster.scheduler_address, store=path)
    stopping.join()
    import zarr

    n_kept = int((zarr.open_group(path, mode="r")["status"][:] > 0).sum())
    assert 10 <= n_kept < 500
    n_rows, facts = [], FactsOfSweep.__call__
    monkey = pytest.MonkeyPatch()
    with monkey.context() as patched:
        patched.setattr(
            FactsOfSweep, "__call__", lambda own, span: (n_rows.append(span[1] - span[0]), facts(own, span))[1]
        )
        found = ct.sweep(MACHINE, vary, WANTED, store=path, resume=True)
    assert sum(n_rows) == 500 - n_kept
    same(found, swept(ct.load(MACHINE), vary, WANTED))


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:1", "nowhere", "127.0.0.1"])
def test_no_scheduler(typed, address):
    answer = typed("sweep", MACHINE, "--vary", "rod_length=0.2..0.3 m:3", "--scheduler", address)
    assert answer.returncode == 2
    assert answer.stderr.startswith(f"--scheduler  {address}: no scheduler answers there; start one with")
    assert answer.stdout == ""
