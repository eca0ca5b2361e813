"""Every body of every file is in the machine's inertia, or the file is told that none uses it."""

import numpy as np
import pytest
from tests.unit.test_examples import EXAMPLES
from tests.weighed_machines import WEIGHED

import cranktrain as ct

FILES = [name.removesuffix(".toml") for name in EXAMPLES]
BANKS = {
    bank: {
        "angle": angle,
        "mechanism": {"kind": "slider_crank", "crank_radius": "45 mm", "rod_length": "150 mm"},
    }
    for bank, angle in (("L", "-45 deg"), ("R", "45 deg"))
}
CRANK = {"mass": "2 kg", "along": "45 mm", "inertia": "0.004 kg·m²"}
ROD = {"big_end": "0.45 kg", "small_end": "0.2 kg"}


def inertia_of(machine):
    result = ct.run(machine, step_degrees=30, quantities=["reduced_inertia", "joint_force_x"])
    return result.reduced_inertia, result.flags


def heavier(body):
    """The same body with all its masses twice as large, and its inertia."""
    if body.big_end is not None:
        return {"big_end": f"{2 * body.big_end.si} kg", "small_end": f"{2 * body.small_end.si} kg"}
    found = {"mass": f"{2 * body.mass.si} kg"}
    if body.along is not None:
        found |= {"along": f"{body.along.si} m", "across": f"{body.across.si} m"}
    own = body.own_inertia
    return found if own is None else found | {"inertia": f"{2 * float(own) + 0.001} kg·m²"}


def idle_masses(machine):
    """Bodies that may be anything, and of which nothing is said."""
    tables = {f"{path}.{name}": body for path, own in machine.weighed.bodies.items() for name, body in own.items()}
    base, flags = inertia_of(machine) if tables else (np.zeros(1), ())
    found = []
    for path, body in tables.items():
        is_told = any(f"[{path}]" in flag and "is used by none" in flag for flag in map(str, flags))
        if is_felt(machine, base, {path: heavier(body)}) == is_told:
            found.append(path)
    return found


def is_felt(machine, base, change):
    """Whether a change moves the inertia, or is refused as it contradicts another table."""
    try:
        other, _flags = inertia_of(machine.with_(change))
    except ct.InputError as error:
        return "differs from" in str(error)
    return bool(np.max(np.abs(other - base)) > 1e-9 * np.max(np.abs(base)))


@pytest.mark.parametrize("name", FILES)
def test_of_examples(name):
    assert idle_masses(ct.load(name)) == []


@pytest.mark.parametrize("name", [name for name in WEIGHED if name not in FILES])
def test_of_kinds(name):
    assert idle_masses(WEIGHED[name]) == []


def vee(*, masses=None, left=None, right=None, **tables):
    banks = {name: {**BANKS[name], **({"masses": own} if own else {})} for name, own in (("L", left), ("R", right))}
    main = {"throws": ["0 deg", "180 deg"], "speed": "3000 rpm", "spacing": "120 mm"}
    return ct.Machine(shaft={"main": main}, bank=banks, masses=masses or {}, **tables)


TABLES = [
    {"masses": {"crank": CRANK, "rod": ROD}},
    {"left": {"crank": CRANK}},
    {"right": {"crank": CRANK}},
    {"masses": {"crank": CRANK}, "right": {"crank": {**CRANK, "mass": "3 kg"}}},
    {"masses": {"rod": ROD}, "left": {"rod": ROD}, "right": {"rod": ROD}},
    {"masses": {"crank": CRANK}, "left": {"crank": CRANK}, "right": {"crank": CRANK}},
]


@pytest.mark.parametrize("tables", TABLES)
def test_of_banks(tables):
    assert idle_masses(vee(**tables)) == []
