"""What of a crank's mass turns at its pin: as a mass on the pin beside a crank without it, and by the lever rule."""

import numpy as np
import pytest
from tests.validation.test_crankshaft_arrangements import PLAIN, SECTIONS

import cranktrain as ct

RADIUS, MASS, ALONG, ACROSS, SHARE = 0.05, 6.0, 0.025, 0.004, 0.4
ROD_MASS, ROD_ALONG, ROD_INERTIA = 3.0, 0.04, 0.03


def engine(crank, rod, **more):
    """Two throws whose webs are of four thicknesses, with weights."""
    return ct.Machine(
        shaft={"main": {"throws": ["0 deg", "120 deg"], "spacing": "150 mm", "speed": "750 rpm"}},
        bank={"A": {"mechanism": PLAIN}},
        gravity=True,
        masses={"piston": {"mass": "5 kg"}, "crank": crank, "rod": rod},
        crankshaft={
            **SECTIONS,
            "bearing_distance": "130 mm",
            "bearing_stiffness": "400 kN/mm",
            "web_thickness": ["20 mm", "36 mm", "28 mm", "31 mm"],
        },
        **more,
    )


def body(mass, along, across, inertia):
    return {"mass": f"{mass!r} kg", "along": f"{along!r} m", "across": f"{across!r} m", "inertia": f"{inertia!r} kg·m²"}


CRANK = body(MASS, ALONG, ACROSS, 0.02)


@pytest.mark.parametrize("more", [{}, {"rotation": "anticlockwise"}, {"running": "astern"}], ids=str)
def test_a_mass_on_the_pin(more):
    """The rod's big end is on the pin: what is taken off the crank and put there acts alike, by every method."""
    at_pin, rest = SHARE * MASS, (1 - SHARE) * MASS
    crank = body(rest, (MASS * ALONG - at_pin * RADIUS) / rest, MASS * ACROSS / rest, 0.02)
    heavy = ROD_MASS + at_pin
    along = ROD_MASS * ROD_ALONG / heavy
    inertia = ROD_INERTIA + ROD_MASS * (ROD_ALONG - along) ** 2 + at_pin * along**2
    shared = ct.run(engine({**CRANK, "pin_share": str(SHARE)}, body(ROD_MASS, ROD_ALONG, 0.0, ROD_INERTIA), **more))
    apart = ct.run(engine(crank, body(heavy, along, 0.0, inertia), **more))
    for name in ("main_bearing_load_x", "main_bearing_load_y", "section_torque", "largest_bearing_load"):
        wanted = apart.dataset[name].values
        found = shared.dataset[name].values
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-10 * np.max(np.abs(wanted)), err_msg=name)
    assert all(check.passed for check in shared.checks)


def test_levers_of_pin_and_webs():
    """Of a crank alone between two bearings, webs of 20 and 36 mm: its pin in the middle, webs in theirs."""
    found = {}
    for share in (0.0, SHARE):
        machine = ct.Machine(
            mechanism=PLAIN,
            shaft={"main": {"speed": "750 rpm"}},
            masses={"crank": {**body(MASS, ALONG, 0.0, 0.02), "pin_share": str(share)}},
            crankshaft={**SECTIONS, "bearing_distance": "130 mm", "web_thickness": ["20 mm", "36 mm"]},
        )
        load = ct.run(machine).dataset.largest_bearing_load.sel(bearing_method="split").values
        square = (750 * np.pi / 30) ** 2
        pin, webs = MASS * share * RADIUS * square, MASS * (ALONG - share * RADIUS) * square
        first, last = -(30 + 10), 30 + 18
        to_last = [0.5 * pin + webs / 2 * ((130 + first) + (130 + last)) / 260]
        wanted = np.array([pin + webs - to_last[0], *to_last])
        np.testing.assert_allclose(load, wanted, rtol=1e-12)
        found[share] = load
    assert found[0.0][1] > found[SHARE][1]


def test_what_does_not_load_bearings_stays():
    """Forces, torque and balance have one crank, wherever it acts."""
    rod = body(ROD_MASS, ROD_ALONG, 0.0, ROD_INERTIA)
    with_share, without = (ct.run(engine(crank, rod)).dataset for crank in ({**CRANK, "pin_share": "0.4"}, CRANK))
    for name in ("shaft_torque", "shaking_force_x", "crankpin_load_radial"):
        np.testing.assert_array_equal(with_share[name], without[name])


WRONG = {
    "of a rod": ({"rod": {"pin_share": "0.4"}}, "masses.rod.pin_share = 0.4: is for the crank of rods on a crank pin"),
    "more than all": ({"crank": {"pin_share": "1.2"}}, "masses.crank.pin_share = 1.2: must be at most 1"),
    "less than nothing": ({"crank": {"pin_share": "-0.1"}}, "masses.crank.pin_share = -0.1: must be at least 0"),
    "a mass": ({"crank": {"pin_share": "2 kg"}}, "masses.crank.pin_share = 2 kg: kg measures a mass"),
    "all of a crank that is elsewhere": (
        {"crank": {"pin_share": "1"}},
        "masses.crank.pin_share = 1: must leave the rest of the crank, without what is at the pin, a centroid within"
        " 100 mm from the shaft; all at the pin, 1, is for along = 50 mm, the crank's radius",
    ),
}


@pytest.mark.parametrize("parts, wanted", WRONG.values(), ids=WRONG)
def test_refused(parts, wanted):
    rod = {**body(ROD_MASS, ROD_ALONG, 0.0, ROD_INERTIA), **parts.get("rod", {})}
    with pytest.raises(ct.InputError) as found:
        ct.run(engine({**CRANK, **parts.get("crank", {})}, rod))
    assert wanted in str(found.value)
