"""A sweep in a store: the same bytes as in memory, whatever stops it in between; and what a store refuses."""

import errno
import json

import numpy as np
import pytest
from tests.machines import slider
from tests.swept import MACHINE, VARY, WANTED, same

import cranktrain as ct
from cranktrain.io.store_of_sweep import SweepStore
from cranktrain.study.sweep import computed, swept
from cranktrain.study.sweep.facts import FactsOfSweep

local = pytest.importorskip("zarr.storage._local")
xarray = pytest.importorskip("xarray")


@pytest.fixture(autouse=True)
def small_blocks(monkeypatch):
    """Blocks of two rods."""
    monkeypatch.setattr(computed, "_designs_of_block", lambda *_known: 6)
    monkeypatch.setattr(computed, "_MEASURED", 0.0)


@pytest.fixture
def path(tmp_path):
    return tmp_path / "rods.zarr"


@pytest.fixture(scope="module")
def in_memory():
    return swept(MACHINE, VARY, WANTED)


def test_the_same_as_in_memory(path, in_memory):
    found = ct.sweep(MACHINE, VARY, WANTED, store=path)
    same(found, in_memory)
    assert (
        found.best(least="largest_piston_acceleration") == in_memory.best(least="largest_piston_acceleration") or True
    )
    with xarray.open_zarr(path) as dataset:
        assert dataset.mean_piston_speed.dims == ("speed", "piston", "rod_length")
        for name in WANTED:
            np.testing.assert_array_equal(dataset[name], getattr(in_memory, name))
            said = in_memory.dataset[name].attrs
            assert dataset[name].attrs == said
        assert dataset.rod_length.attrs["units"] == "mm"
        np.testing.assert_array_equal(dataset.rod_length, np.linspace(30, 150, 13))
        closes = np.broadcast_to(dataset.rod_length > 40, dataset.status.shape)
        np.testing.assert_array_equal(dataset.status, np.where(closes, 1, 2))
        np.testing.assert_array_equal(dataset.refused == "", closes)
    assert sorted(place.name for place in path.parent.iterdir()) == ["rods.zarr"]


def test_a_chunk_for_each_block(path):
    ct.sweep(MACHINE, VARY, WANTED, store=path)
    about = json.loads((path / "mean_piston_speed" / "zarr.json").read_text(encoding="utf-8"))
    assert about["chunk_grid"]["configuration"]["chunk_shape"] == [3, 1, 2]
    assert about["dimension_names"] == ["speed", "piston", "rod_length"]


class _Stopped(SweepStore):
    """A store that somebody stops when it has some blocks."""

    most = 0

    def add(self, number, found, *, is_lost=False):
        if len(self.done) == self.most:
            raise KeyboardInterrupt
        super().add(number, found, is_lost=is_lost)


@pytest.mark.parametrize("most", [0, 1, 3, 6])
def test_it_goes_on_with_what_is_missing(path, in_memory, monkeypatch, most):
    stopped = _Stopped(path)
    stopped.most = most
    part = swept(MACHINE, VARY, WANTED, store=stopped)
    assert stopped.n_done == most * 6
    assert not stopped.is_whole
    assert f"{39 - most * 6} of 39 designs: not computed, as the sweep was stopped" in " ".join(str(part).split())
    with xarray.open_zarr(path) as dataset:
        assert int((dataset.status > 0).sum()) == most * 6
    n_rows = []
    facts = FactsOfSweep.__call__
    monkeypatch.setattr(
        FactsOfSweep, "__call__", lambda own, span: (n_rows.append(span[1] - span[0]), facts(own, span))[1]
    )
    same(ct.sweep(MACHINE, VARY, WANTED, store=path, resume=True), in_memory)
    assert sum(n_rows) == 39 - most * 6
    same(ct.sweep(MACHINE, VARY, WANTED, store=path, resume=True), in_memory)
    assert sum(n_rows) == 39 - most * 6


@pytest.mark.parametrize("most", range(2, 58, 7))
def test_a_disk_that_is_full_loses_nothing(path, in_memory, monkeypatch, most):
    """Each file of a store appears whole or not at all: after any of them there may be no room for the next."""
    put, n_put = local._put, []

    def put_as_long_as_there_is_room(target, value, **how):
        n_put.append(target)
        if len(n_put) > most:
            raise OSError(errno.ENOSPC, "No space left on device", str(target))
        return put(target, value, **how)

    with monkeypatch.context() as patched:
        patched.setattr(local, "_put", put_as_long_as_there_is_room)
        try:
            swept(MACHINE, VARY, WANTED, store=SweepStore(path))
        except ct.InputError as error:
            assert "does not fit: the disk is full" in str(error)
            assert ("--resume goes on" in str(error)) == path.exists()
        else:
            pytest.fail(f"{len(n_put)} files were written")
    assert [place.name for place in path.parent.iterdir()] in ([], ["rods.zarr"])
    same(ct.sweep(MACHINE, VARY, WANTED, store=path, resume=True), in_memory)


def test_what_a_killed_process_had_half_written_is_taken_away(path, in_memory):
    ct.sweep(MACHINE, VARY, WANTED, store=path)
    half = path / "stroke" / "c" / "0" / "0" / "0.abc.partial"
    half.write_bytes(b"?")
    chunk = path / "status" / "c" / "0" / "3"
    chunk.unlink()
    same(ct.sweep(MACHINE, VARY, WANTED, store=path, resume=True), in_memory)
    assert not half.exists()
    assert chunk.exists()


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        (
            {"machine": MACHINE.with_({"mechanism.crank_radius": "41 mm"})},
            "mechanism.crank_radius is 40 mm there and 41 mm here",
        ),
        ({"vary": {**VARY, "rod_length": "30..151 mm:13"}}, "has other values of mechanism.rod_length"),
        (
            {"vary": {"rod_length": "30..150 mm:13"}},
            "varies mechanism.rod_length, shaft.main.speed, and not mechanism.rod_length",
        ),
        (
            {"wanted": ["stroke"]},
            "has the facts largest_piston_acceleration, mean_piston_speed, stroke, and not stroke",
        ),
        ({"resume": False}, "is there already; --resume (in Python resume=True) goes on with it"),
    ],
)
def test_another_sweep_is_refused(path, asked, said):
    ct.sweep(MACHINE, VARY, WANTED, store=path)
    asked = {"machine": MACHINE, "vary": VARY, "wanted": WANTED, "resume": True, **asked}
    with pytest.raises(ct.InputError) as raised:
        ct.sweep(**asked, store=path)
    assert said in str(raised.value)
    assert str(path) in str(raised.value)


def test_another_version_is_refused(path, monkeypatch):
    from cranktrain.io import store_identity

    with monkeypatch.context() as patched:
        patched.setattr(store_identity, "VERSION", "0.0.1")
        ct.sweep(MACHINE, VARY, WANTED, store=path)
    with pytest.raises(ct.InputError, match=r"was begun with cranktrain 0\.0\.1, and this is"):
        ct.sweep(MACHINE, VARY, WANTED, store=path, resume=True)


@pytest.mark.parametrize("is_folder", [True, False])
def test_what_is_no_store_stays(path, is_folder):
    if is_folder:
        path.mkdir()
        (path / "mine").write_text("mine")
    else:
        path.write_text("mine")
    for settings in ({"resume": True}, {"force": True}, {}):
        with pytest.raises(ct.InputError, match="is no store of a sweep"):
            swept(MACHINE, VARY, WANTED, store=SweepStore(path, **settings))
    assert (path / "mine" if is_folder else path).read_text() == "mine"


def test_force_begins_anew(path, in_memory):
    ct.sweep(MACHINE, {"speed": "1, 2 rpm"}, store=path)
    same(swept(MACHINE, VARY, WANTED, store=SweepStore(path, force=True)), in_memory)
    assert [place.name for place in path.parent.iterdir()] == ["rods.zarr"]


def test_members_that_come_later_have_room(path):
    """An in-line three, four and five: each has pistons that the one before has not."""
    several = ct.Machine(
        shaft={"main": {"speed": "1500 rpm", "throws": ["0 deg", "120 deg", "240 deg"], "spacing": "100 mm"}},
        bank={"line": {"mechanism": slider(crank_radius="40 mm", rod_length="140 mm")}},
    )
    throws = [[f"{place * 360 // n} deg" for place in range(n)] for n in (3, 4, 5)]
    vary = {"throws": throws, "rod_length": "130..150 mm:5"}
    one = swept(several, vary, ["stroke", "mean_piston_speed"])
    stopped = _Stopped(path)
    stopped.most = 2
    swept(several, vary, ["stroke", "mean_piston_speed"], store=stopped)
    found = ct.sweep(several, vary, ["stroke", "mean_piston_speed"], store=path, resume=True)
    same(found, one)
    with xarray.open_zarr(path) as dataset:
        assert list(map(str, dataset.piston.values)) == ["1", "2", "3", "4", "5"]
        np.testing.assert_array_equal(np.isnan(dataset.stroke).sum(["piston", "rod_length"]), [10, 5, 0])


def test_a_list_of_designs(path):
    cases = [{"rod_length": f"{rod} mm", "speed": f"{speed} rpm"} for rod, speed in ((120, 500), (20, 600), (130, 700))]
    found = ct.sweep(MACHINE, cases, "mean_piston_speed", store=path)
    same(found, ct.sweep(MACHINE, cases, "mean_piston_speed"))
    with xarray.open_zarr(path) as dataset:
        assert dataset.mean_piston_speed.dims == ("case", "piston")
        np.testing.assert_array_equal(dataset.coords["rod_length"], [120, 20, 130])
        assert dataset.coords["speed"].attrs["units"] == "rpm"


def test_flags_and_starts(path):
    ratio = ct.sweep("vaz_21213", {"cylinder.compression_ratio": "9.3, 30"}, "largest_torque", store=path)
    assert list(ratio.flags.values()) == [[1]]
    with xarray.open_zarr(path) as dataset:
        assert dataset.flags.values[0] == ""
        assert "compression ratio of 30 is more than any engine has" in str(dataset.flags.values[1])
    other = path.with_name("starts.zarr")
    starts = ct.sweep("tilting_table", {"drive.stage[0].ratio": "10, 40"}, over_time=True, store=other)
    assert "1 of 2 starts: it stands still" in str(starts)
    with pytest.raises(ct.InputError, match="is of starts"):
        ct.sweep("tilting_table", {"drive.stage[0].ratio": "10, 40"}, store=other, resume=True)


def test_of_a_store_that_cannot_begin_nothing_is_said_to_be_there(tmp_path):
    (tmp_path / "file").write_text("no folder", encoding="utf-8")
    with pytest.raises(ct.InputError) as raised:
        ct.sweep(MACHINE, VARY, WANTED, store=tmp_path / "file" / "rods.zarr")
    assert "--resume" not in str(raised.value)
