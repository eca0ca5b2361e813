"""Steady running of machines whose gas and friction come back over the cycle: their own checks hold."""

import numpy as np
import pytest

import cranktrain as ct

SHUNT = {"kind": "shunt", "torque": "50 N*m", "speed": "1500 rpm", "no_load_speed": "1600 rpm"}
GAS = ("3d12", "vaz_21213", "deltic", "kamaz_740", "ls3", "mill_engine", "r_1340")
CRANK = {"along": "10 mm", "mass": "1.5 kg", "inertia": "2e-3 kg*m^2"}
RUBBING = {
    "scotch_yoke": {
        "mechanism": {"kind": "scotch_yoke", "crank_radius": "40 mm"},
        "masses": {
            "piston": {"mass": "1.2 kg"},
            "block": {"mass": "0.2 kg", "along": "0 mm", "inertia": "1e-4 kg*m^2"},
            "crank": CRANK,
        },
        "friction": {"piston": 0.08, "block": 0.08},
        "guide": {"piston": {"length": "70 mm"}},
    },
    "slider_crank": {
        "mechanism": {"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "150 mm"},
        "masses": {
            "piston": {"mass": "1.2 kg"},
            "rod": {"mass": "0.9 kg", "along": "60 mm", "inertia": "4e-3 kg*m^2"},
            "crank": CRANK,
        },
        "friction": {"piston": 0.1},
        "gravity": True,
    },
}


def left_over(machine):
    """What both checks of steady running leave."""
    found = {one.name: float(np.max(one.residual)) for one in ct.run(machine).checks}
    return found["drive_motion"], found["drive_energy"]


@pytest.mark.parametrize("name", GAS)
def test_gas(name):
    motion, energy = left_over(ct.load(name).with_({"drive": {"motor": SHUNT}}))
    assert motion < 1e-10
    assert energy < 1e-12


@pytest.mark.parametrize("kind", RUBBING)
@pytest.mark.parametrize("speed", ["600 rpm", "1550 rpm"])
def test_friction(kind, speed):
    """Its kinks at rest and at the declared speed stand elsewhere than in the running."""
    machine = ct.Machine.model_validate(
        {
            "rotation": "clockwise",
            "shaft": {"main": {"speed": speed}},
            "load": {"seal": {"on": "piston", "force": "60 N"}},
            "drive": {"motor": {**SHUNT, "inertia": "0.02 kg*m^2"}},
            **RUBBING[kind],
        }
    )
    motion, energy = left_over(machine)
    assert motion < 1e-10
    assert energy < 1e-12


def test_designs_among_others():
    """Curves of every design are as they are alone."""
    machine = ct.load("vaz_21213").with_({"drive": {"motor": SHUNT}})
    machines = [machine.with_({"bank.line.mechanism.rod_length": f"{length} mm"}) for length in (130, 140, 155)]
    together = ct.run(machines).cycle_time
    for design, alone in enumerate(machines):
        assert ct.run(alone).cycle_time == together[design]
