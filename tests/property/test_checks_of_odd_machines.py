"""Checks of odd but right machines hold, whatever is 0, tiny or huge in them; and each fails for a millionth.

What a check compares with must be what its numbers are made of: forces times arms where the torque is none, what a
motor gives for a part of its speed where nothing takes any work, places where these are far beyond the stroke.
"""

from importlib import import_module
from typing import Any

import numpy as np
import pytest
from tests.gas_engines import DUAL_CYCLE
from tests.machines import ROCKER, banks, slave, slider, throws

import cranktrain as ct

TURNS: dict[str, Any] = {"main": {"speed": "1500 rpm"}}
ENGINE: dict[str, Any] = {
    "cylinder": {"bore": "85 mm", "compression_ratio": 16, "cycle": "four-stroke"},
    "gas": DUAL_CYCLE,
}
SIZES = {"journal_diameter": 60, "pin_diameter": 52, "pin_length": 50, "web_thickness": 20, "web_width": 90}
SHAFT = {name: f"{size} mm" for name, size in SIZES.items()}
ONE_THROW = {**SHAFT, "bearing_distance": "120 mm"}
PISTON = {"piston": {"mass": "0.5 kg"}}
CRANK = {"crank": {"mass": "2 kg", "along": "45 mm", "inertia": "0.004 kg·m²"}}
IN_MIDDLE = {"crank": {"mass": "2 kg", "along": "0 mm", "inertia": "0.004 kg·m²"}}
MOTOR = {
    "motor": {
        "kind": "circuit",
        "phase_voltage": "200 V",
        "stator_resistance": "7 ohm",
        "rotor_resistance": "10 ohm",
        "reactance": "70 ohm",
        "synchronous_speed": "800 rpm",
    }
}
PUSH = {"on": "piston", "force": "1 kN", "sense": "active"}
OSCILLATING = {"kind": "oscillating_cylinder", "crank_radius": "30 mm", "ground_length": "200 mm"}


def long_or_short(ratio: float, **tables: Any) -> dict[str, Any]:
    """λ near 1 and near 0."""
    rod = 50 / ratio
    masses = {**PISTON, "rod": {"mass": "1 kg", "along": f"{rod / 3!r} mm"}}
    return {"shaft": TURNS, "mechanism": slider(rod_length=f"{rod!r} mm"), "masses": masses, **tables}


def scaled(size: float) -> dict[str, Any]:
    lengths = {**SIZES, "bearing_distance": 120}
    return {
        "shaft": {"main": {"speed": f"{1500 / max(size, 1.0)!r} rpm"}},
        "mechanism": slider(crank_radius=f"{50 * size!r} mm", rod_length=f"{180 * size!r} mm"),
        "masses": {
            "piston": {"mass": f"{size**3!r} kg"},
            "rod": {"mass": f"{size**3!r} kg", "along": f"{60 * size!r} mm"},
        },
        "gravity": True,
        "crankshaft": {name: f"{length * size!r} mm" for name, length in lengths.items()},
    }


def simple(**tables: Any) -> dict[str, Any]:
    return {"shaft": TURNS, "mechanism": slider(), **tables}


ODD: dict[str, dict[str, Any]] = {
    **{f"ratio {ratio}": long_or_short(ratio) for ratio in (0.999, 0.9999, 1e-5, 1e-9)},
    **{f"ratio {ratio}, gas": long_or_short(ratio, **ENGINE) for ratio in (0.999, 0.9999, 1e-5, 1e-9)},
    **{f"size {size}": scaled(size) for size in (1e-6, 1e-3, 1e3, 1e5)},
    "crank alone": simple(masses=CRANK, crankshaft=ONE_THROW),
    "crank alone, heavy": simple(masses=CRANK, crankshaft=ONE_THROW, gravity=True),
    "crank alone, driven": simple(masses=CRANK, drive=MOTOR),
    "crank in its middle": simple(masses=IN_MIDDLE, crankshaft=ONE_THROW, drive=MOTOR),
    "crank alone against a load": simple(
        masses=CRANK, load={"brake": {"on": "main", "torque": "1 N·m"}}, drive=MOTOR, crankshaft=ONE_THROW
    ),
    "no masses, a load": simple(load={"push": PUSH}, crankshaft=ONE_THROW),
    "no masses, a load across": simple(load={"push": {**PUSH, "direction": "90 deg"}}, crankshaft=ONE_THROW),
    "no masses, two loads that cancel": simple(load={"push": PUSH, "pull": {**PUSH, "force": "-1 kN"}}),
    "no masses, gas": simple(crankshaft=ONE_THROW, **ENGINE),
    "motored": simple(masses=PISTON, drive=MOTOR, evenness={"flywheel": "1 kg·m²"}),
    "motored, with a flywheel": simple(masses=PISTON, drive=MOTOR, evenness={"flywheel": "1e5 kg·m²"}),
    "motored, of no mass": simple(
        masses={"piston": {"mass": "1e-9 kg"}}, drive=MOTOR, evenness={"flywheel": "1e-3 kg·m²"}
    ),
    "rubbing": simple(
        masses=PISTON,
        friction={"piston": "0.1"},
        gravity=True,
        crankshaft=ONE_THROW,
        evenness={"flywheel": "1 kg·m²"},
    ),
    "cylinder that swings": {
        "shaft": {"main": {"speed": "50 rpm"}},
        "mechanism": OSCILLATING,
        "masses": {"piston": {"mass": "0.9 kg"}},
        "crankshaft": ONE_THROW,
    },
    "cylinder that swings, driven": {
        "shaft": {"main": {"speed": "4000 rpm"}},
        "mechanism": {**OSCILLATING, "crank_radius": "60 mm"},
        "masses": {"crank": {"mass": "30 kg", "along": "-20 mm", "inertia": "0.09 kg·m²"}},
        "drive": MOTOR,
    },
    "yoke": {
        "shaft": TURNS,
        "mechanism": {"kind": "scotch_yoke", "crank_radius": "50 mm"},
        "masses": PISTON,
        "crankshaft": ONE_THROW,
        "gravity": True,
    },
    "rocker whose crank alone weighs": {
        "shaft": TURNS,
        "mechanism": ROCKER,
        "masses": {"crank": {"mass": "1 kg", "along": "0 mm", "inertia": "0 kg·m²"}},
        "gravity": True,
    },
    "boxer": {
        "shaft": throws(0, 180, speed="3000 rpm", spacing="120 mm"),
        "bank": banks(L=-90, R=90),
        "masses": {**PISTON, **CRANK},
        "crankshaft": SHAFT,
        "gravity": True,
    },
    "vee whose cranks alone have mass": {
        "shaft": throws(0, 180, speed="3000 rpm", spacing="120 mm"),
        "bank": banks(L=-45, R=45),
        "masses": CRANK,
        "crankshaft": SHAFT,
    },
    "master and slave without mass": {
        "shaft": throws(0, speed="1500 rpm"),
        "bank": {"L": {"mechanism": slider()}, "R": {"angle": "60 deg", "mechanism": slave("L")}},
        "masses": CRANK,
        "crankshaft": ONE_THROW,
        "gravity": True,
    },
}


def told(result: ct.Result) -> dict[str, str]:
    return {check.name: str(check.verdict()) for check in result.checks if not check.passed[0]}


@pytest.mark.parametrize("name", ODD)
def test_checks_hold(name):
    beyond = {"is beyond the digits of a Fourier series", "has nothing to compare: the work of a cycle is rounding"}
    found = {
        check: said
        for check, said in told(ct.run(ct.Machine(**ODD[name]))).items()
        if not said.startswith(tuple(beyond))
    }
    assert found == {}


def test_a_motion_sharper_than_its_series_is_not_called_wrong():
    """At 10⁻⁷ of locking rounding leaves 10⁻⁸ of the second derivative."""
    assert set(told(ct.run(ct.Machine(**long_or_short(0.9999999)))).values()) <= {
        "is beyond the digits of a Fourier series"
    }


WHOLE = simple(
    masses={**PISTON, **CRANK, "rod": {"mass": "1 kg", "along": "60 mm"}}, crankshaft=ONE_THROW, gravity=True
)
DRIVEN = simple(masses=PISTON, load={"brake": {"on": "main", "torque": "1 N·m"}}, drive=MOTOR)
OFF = 1 + 1e-6


@pytest.mark.parametrize(
    ("check", "machine", "where", "kernel", "part"),
    [
        ("piston_forces", WHOLE, "forces.piston_forces", "piston_forces", "radial"),
        ("piston_forces", WHOLE, "forces.piston_forces", "piston_forces", "tangential"),
        ("rod_forces", WHOLE, "forces.rods_in_pistons", "rod_forces", 1),
        ("piston_pins", WHOLE, "forces.rods_in_pistons", "inertia_force", None),
        ("torque", WHOLE, "forces.mechanism_torques", "torque_by_work", None),
        ("work", {**WHOLE, **ENGINE}, "forces.solved_cycle", "driving_torques", None),
        (
            "load_work",
            simple(load={"push": {"on": "piston", "force": "1 kN"}}),
            "torque.sources",
            "driving_torques",
            None,
        ),
        ("section_torque", WHOLE, "forces.solved_cycle", "driving_torques", None),
        ("bearing_loads", WHOLE, "crankshaft.results.main_bearing_loads", "on_axis", "force"),
        ("momentum", WHOLE, "balance.frame_forces", "momentum", "x"),
        ("drive_energy", DRIVEN, "drive.steady_drive", "overall_ratio", None),
    ],
)
def test_a_kernel_that_is_a_millionth_off_is_found(monkeypatch, check, machine, where, kernel, part):
    module = import_module(f"cranktrain.questions.{where}")
    true = getattr(module, kernel)

    def wrong(*given: Any, **named: Any) -> Any:
        found = true(*given, **named)
        if part is None:
            return np.multiply(found, OFF)
        if isinstance(part, int):
            return tuple(one * OFF if place == part else one for place, one in enumerate(found))
        return found._replace(**{part: getattr(found, part) * OFF})

    assert check not in told(ct.run(ct.Machine(**machine)))
    monkeypatch.setattr(module, kernel, wrong)
    assert told(ct.run(ct.Machine(**machine)))[check] == "does not hold"
