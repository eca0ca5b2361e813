"""GD² of a link instead of its inertia: four times it, in each unit, about the same point."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.errors import InputError

LINKS = {"crank_radius": "100 mm", "rod_length": "300 mm", "rocker_length": "250 mm", "ground_length": "320 mm"}
ROCKER = {"mass": "8 kg", "along": "120 mm"}


def machine(rocker):
    return ct.Machine(mechanism={"kind": "crank_rocker", **LINKS}, masses={"rocker": ROCKER | rocker})


@pytest.mark.parametrize(
    ("given", "inertia"),
    [
        ("0.36 kgf*m^2", 0.09),
        ("0.36 kg*m^2", 0.09),
        ("3.530394 N*m^2", 0.09),  # 0.36 · 9.80665
        ("8.5 lb*ft^2", 8.5 * 0.45359237 * 0.3048**2 / 4),
    ],
)
def test_units(given, inertia):
    by_moment = ct.run(machine({"flywheel_moment": given}))
    by_inertia = ct.run(machine({"inertia": f"{inertia!r} kg*m^2"}))
    assert by_moment.reduced_inertia == pytest.approx(by_inertia.reduced_inertia, rel=1e-14)


def test_both_are_refused_and_none_is_missing():
    with pytest.raises(InputError, match=r"masses\.rocker\.flywheel_moment: must not stand beside inertia"):
        machine({"flywheel_moment": "1 kgf*m^2", "inertia": "1 kg*m^2"})
    with pytest.raises(InputError, match=r"masses\.rocker\.inertia: is missing"):
        machine({})


def test_designs_side_by_side():
    """A column of GD² is laid out as each design alone."""
    designs = [machine({"flywheel_moment": f"{moment} kgf*m^2"}) for moment in (0.2, 0.36, 0.8)]
    alone = np.stack([ct.run(one).reduced_inertia for one in designs])
    swept = ct.sweep(designs[0], {"masses.rocker.flywheel_moment": ["0.2 kgf*m^2", "0.36 kgf*m^2", "0.8 kgf*m^2"]})
    assert swept.reduced_inertia == pytest.approx(alone, rel=1e-14)
