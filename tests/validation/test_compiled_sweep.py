"""Sweeps of a thousand designs and more, which go by the compiled cycle: against `run`, and what cannot be."""

import os
import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.linkage.kept import fingerprint
from cranktrain.study.sweep import computed
from cranktrain.study.sweep.facts import FactsOfSweep
from cranktrain.study.sweep.varied import combined_designs

SINGLE = Path(__file__).parents[2] / "benchmarks" / "single.toml"


@cache
def cylinder() -> ct.Machine:
    return ct.load(str(SINGLE)).with_({"cylinder.compression_ratio": 14.0})


FACTS = ["largest_torque", "mean_torque", "largest_side_force", "flywheel_inertia", "stroke"]


def test_it_goes_by_the_compiled_cycle_and_gives_what_run_gives():
    designs = combined_designs(cylinder(), {"rod_length": "120..200 mm:50", "speed": "1000..4000 rpm:20"})
    assert FactsOfSweep(cylinder(), designs, tuple(FACTS)).n_together > 1000
    found = ct.sweep(cylinder(), {"rod_length": "120..200 mm:50", "speed": "1000..4000 rpm:20"}, FACTS)
    assert not found.refused
    rows = list(found.designs.rows)
    for place in (0, 1, 333, 777, 999):
        alone = ct.run(cylinder(), set=rows[place], quantities=FACTS)
        for fact in FACTS:
            rtol = 1e-6 if fact == "flywheel_inertia" else 1e-9
            np.testing.assert_allclose(found.found.values[fact][place], getattr(alone, fact), rtol=rtol, err_msg=fact)


def test_fewer_designs_go_by_run():
    few = combined_designs(cylinder(), {"rod_length": "120..200 mm:49", "speed": "1000..4000 rpm:20"})
    assert FactsOfSweep(cylinder(), few, tuple(FACTS)).n_together == 64
    over_time = combined_designs(cylinder(), {"rod_length": "120..200 mm:50", "speed": "1000..4000 rpm:20"})
    assert FactsOfSweep(cylinder(), over_time, tuple(FACTS), over_time=True).n_together == 256


def test_impossible_designs_have_no_number():
    """Of ten thousand rods and offsets all that close have numbers, and no other: l > r + |e|."""
    found = ct.sweep(
        cylinder(),
        {"rod_length": "1..150 mm:100", "mechanism.offset": "-60..60 mm:100"},
        ["largest_torque", "peak_pressure"],
    )
    rod, offset = np.linspace(1, 150, 100), np.linspace(-60, 60, 100)
    closes = rod[:, np.newaxis] > 45 + np.abs(offset)
    torque = found.found.values["largest_torque"].reshape(100, 100)
    pressure = found.found.values["peak_pressure"].reshape(100, 100)
    np.testing.assert_array_equal(np.isfinite(torque), closes)
    np.testing.assert_array_equal(np.isfinite(pressure), closes)
    assert len(found.refused) == np.sum(~closes)
    nearly = [place for place, problem in found.refused.items() if "mechanism" in problem.path]
    assert len(nearly) == len(found.refused)


def test_heat_beyond_the_bottom_dead_centre_is_refused_for_each():
    """What stages refuse, and not tables: a cut-off of more than the compression ratio."""
    found = ct.sweep(
        cylinder(), {"gas.cut_off_ratio": [*np.linspace(1.0, 20.0, 1200).tolist()]}, ["largest_torque"], processes=1
    )
    ratios = np.linspace(1.0, 20.0, 1200)
    np.testing.assert_array_equal(np.isfinite(found.found.values["largest_torque"]), ratios <= 14.0)
    assert all("cut_off_ratio" in problem.path for problem in found.refused.values())


def test_words_and_numbers():
    """Throws are arrays of the loop: each arrangement has its own facts by one compiled cycle."""
    four = ct.load("vaz_21213")
    throws = [["0 deg", "180 deg", "180 deg", "0 deg"], ["0 deg", "180 deg", "0 deg", "180 deg"]]
    vary = {"shaft.main.throws": throws, "rod_length": "120..160 mm:600"}
    found = ct.sweep(four.with_({"cylinder.firing_order": "1 3 4 2"}), vary, ["largest_torque", "smallest_torque"])
    rows = list(found.designs.rows)
    for place in (0, 599, 600, 1199):
        if place in found.refused:
            continue
        alone = ct.run(four, set=rows[place], quantities=["largest_torque"])
        np.testing.assert_allclose(found.found.values["largest_torque"][place], alone.largest_torque, rtol=1e-9)


def test_a_machine_that_the_loop_does_not_know(monkeypatch):
    monkeypatch.setattr(computed, "_LONG", 1e9)
    shaper = ct.load("shaper")
    vary = combined_designs(shaper, {"shaft.main.speed": "20..60 rpm:1000"})
    assert FactsOfSweep(shaper, vary, ("largest_torque",)).n_together == 64


EDITED = """
import sys
import numpy as np
from cranktrain.fluids.dual import pressure

if sys.argv[1] == "edited":
    def ideal_pressure(state, cycle):
        return 2.0 * cycle.start_pressure + 0.0 * state.volume
    pressure.ideal_pressure.__code__ = ideal_pressure.__code__
from cranktrain.columns import in_columns
from cranktrain.study.cycle.road import facts_of_cycles, way_to
from tests.validation.test_compiled_sweep import cylinder

machine = cylinder()
way = way_to(machine, ["peak_pressure"])
print(float(facts_of_cycles(in_columns([machine] * 2), 2, way).values["peak_pressure"][1, 0]))
"""


def test_an_edited_kernel_is_seen(tmp_path):
    """Numba's own cache, which knows a function by its file, would give the pressure of before."""

    def peak(how: str) -> float:
        environment = {**os.environ, "CRANKTRAIN_CACHE": str(tmp_path), "PYTHONPATH": str(Path(__file__).parents[2])}
        line = [sys.executable, "-c", EDITED, how]
        return float(subprocess.run(line, env=environment, check=True, capture_output=True, text=True).stdout)

    assert peak("as it is") == pytest.approx(1.5e5 * 14**1.36, rel=1e-12)
    assert peak("edited") == pytest.approx(2e5, rel=1e-12)
    assert peak("as it is") == pytest.approx(1.5e5 * 14**1.36, rel=1e-12)


def test_what_cannot_be_read_is_made_anew(tmp_path):
    """Of a version whose classes are gone, of a disk that was full."""

    def peak() -> float:
        environment = {**os.environ, "CRANKTRAIN_CACHE": str(tmp_path), "PYTHONPATH": str(Path(__file__).parents[2])}
        line = [sys.executable, "-c", EDITED, "as it is"]
        return float(subprocess.run(line, env=environment, check=True, capture_output=True, text=True).stdout)

    first = peak()
    kept = [path for path in tmp_path.rglob("*.nb?") if path.is_file()]
    assert len(kept) == 4  # what Python calls alone: two loops, an index and the code of each
    for place, path in enumerate(kept):
        path.write_bytes([b"", b"nonsense", path.read_bytes()[: len(path.read_bytes()) // 2]][place % 3])
    assert peak() == first


def test_fingerprints_know_what_is_called():
    """A function, what it calls, and the numbers that both name; not where they stand."""

    def known(text: str) -> str:
        names: dict[str, object] = {"__name__": "made_up"}
        exec(compile(text, "made_up", "exec"), names)
        return fingerprint([names["outer"]])

    text = "FACTOR = 2.0\ndef inner(x):\n    return FACTOR * x\ndef outer(x):\n    return inner(x) + 1.0\n"
    assert known(text) == known("\n\n" + text)
    assert known(text) != known(text.replace("2.0", "3.0"))
    assert known(text) != known(text.replace("FACTOR * x", "FACTOR + x"))
    assert known(text) != known(text.replace("1.0", "1.5"))
