"""Machines whose links do not close all round: there is no cycle, and so no work, mean, power or part of one."""

import numpy as np
import pytest
from tests.machines import ROCKER

import cranktrain as ct

SIX_BAR = {
    "kind": "chain",
    "output": "lever",
    "fixed": {"C": ["110 mm", "0 mm"]},
    "crank": {"main": {"radius": "60 mm"}},
    "part": [
        {
            "type": "pin",
            "rod": {"name": "rod", "from": "main.pin", "length": "70 mm"},
            "rocker": {"name": "lever", "from": "C", "length": "80 mm"},
            "joint": "B",
            "side": "left",
        }
    ],
}
MACHINES = {
    "slider_crank": ({"kind": "slider_crank", "crank_radius": "60 mm", "rod_length": "50 mm"}, "rod", "piston"),
    "crank_rocker": (ROCKER | {"crank_radius": "250 mm"}, "rod", "rocker"),
    "eccentric": (
        {"kind": "eccentric", "eccentricity": "60 mm", "rod_length": "50 mm", "angle_of_advance": "30 deg"},
        "rod",
        "piston",
    ),
    "chain": (SIX_BAR, "rod", "lever"),
}
OF_THE_MOTOR = {"sized_power", "sized_torque"}


def facts_of(result):
    """Facts that only a cycle has, by name: work, power, means, root mean squares, and parts of the cycle."""
    for name, entry in result.catalogue.items():
        if "crank_angle" in entry.dimensions or name in OF_THE_MOTOR:
            continue
        if entry.unit in ("J", "W") or name.startswith(("mean_", "rms_", "half_period_", "largest_excess")):
            yield name, np.asarray(getattr(result, name), dtype=float)


@pytest.mark.parametrize("kind", MACHINES)
def test_without_a_turn_there_are_no_facts_of_a_cycle(kind):
    mechanism, link, output = MACHINES[kind]
    load = {"pushed": {"on": link, "force": "9 N", "along": "10 mm"}}
    load["brake"] = {"on": output, "force": "9 N"} if output == "piston" else {"on": output, "torque": "9 N*m"}
    machine = {
        "mechanism": mechanism,
        "shaft": {"main": {"speed": "60 rpm"}},
        "masses": {link: {"mass": "1 kg", "along": "35 mm", "inertia": "1e-3 kg*m^2"}},
        "load": load,
        "evenness": {"coefficient": 0.05, "flywheel": "3 kg*m^2"},
        "drive": {"motor": {"kind": "cage", "size": "1.5 kW"}},
    }
    with pytest.raises(ct.InputError, match=r"cannot close|close at no"):
        ct.run(machine)
    result = ct.run(machine, partial=True)
    found = dict(facts_of(result))
    assert {"load_work", "mean_load_power", "mean_torque", "half_period_length"} <= found.keys()
    assert [name for name, values in found.items() if np.any(np.isfinite(values))] == []
    assert "0 J" not in " ".join(str(result).split())


@pytest.mark.parametrize("kind", MACHINES)
def test_a_torque_on_the_shaft_alone_has_no_cycle_either(kind):
    """It is given at every crank angle, and yet does no work where the machine does not get to."""
    mechanism, link, _output = MACHINES[kind]
    machine = {
        "mechanism": mechanism,
        "shaft": {"main": {"speed": "60 rpm"}},
        "masses": {link: {"mass": "1 kg", "along": "35 mm", "inertia": "1e-3 kg*m^2"}},
        "load": {"belt": {"on": "main", "torque": "9 N*m"}},
    }
    result = ct.run(machine, partial=True)
    assert np.all(np.isnan(result.load_work))
    assert np.all(np.isnan(result.mean_load_power))
    torque = np.asarray(result.load_torque_on_crank)[0]
    assert np.array_equal(np.isfinite(torque), np.isfinite(np.asarray(result.reduced_inertia)))
    assert np.all(torque[np.isfinite(torque)] == -9.0)
