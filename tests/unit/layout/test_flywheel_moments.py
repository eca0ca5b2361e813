"""GD² of a link instead of its inertia: four times it, in each unit, about the same point."""

import pytest

import cranktrain as ct
from cranktrain.errors import InputError

LINKS = {"crank_radius": "100 mm", "rod_length": "300 mm", "rocker_length": "250 mm", "ground_length": "320 mm"}
SHAFT = {"main": {"speed": "60 rpm"}}
ROCKER = {"mass": "8 kg", "along": "120 mm"}


def machine(rocker):
    return ct.Machine(mechanism={"kind": "crank_rocker", **LINKS}, masses={"rocker": ROCKER | rocker}, shaft=SHAFT)


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


def test_both_are_refused():
    with pytest.raises(
        InputError, match=r"masses\.rocker\.flywheel_moment = 1 kgf\*m\^2: must not stand beside inertia"
    ):
        machine({"flywheel_moment": "1 kgf*m^2", "inertia": "1 kg*m^2"})
