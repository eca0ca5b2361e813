"""Journals with clearance against the least energy found by other methods: it is convex, and has one."""

import numpy as np
import pytest
from scipy.optimize import minimize
from tests.crankshafts import drawn_crankshaft
from tests.straight_shafts import forces_on, straight_shaft

from cranktrain.questions.crankshaft.methods import BEARING_METHODS

METHODS = {method.name: method for method in BEARING_METHODS}


def with_supports(shaft, **changes):
    return shaft._replace(supports=shaft.supports._replace(**changes))


def by_displacements(method, shaft, loads):
    """Reactions on the shaft with every bearing at 0, and for a unit displacement of each: from settlements alone."""
    n = shaft.supports.place.shape[1]

    def reactions(settlement, acting):
        return -METHODS[method].loads(with_supports(shaft, settlement=settlement), acting).load[0, :, :, 0].ravel()

    still = np.zeros((1, n, 2))
    unloaded = loads._replace(**{name: 0 * getattr(loads, name) for name in ("force", "couple", "torque", "thrust")})
    columns = [reactions(unit.reshape(1, n, 2), unloaded) for unit in np.eye(2 * n)]
    return reactions(still, loads), np.stack(columns, axis=1)


def loads_of(shaft, loads):
    return METHODS["clearance"].loads(shaft, loads)


@pytest.mark.parametrize("seed", range(6))
def test_least_energy_of_shaft_and_bearings(seed):
    """Displacements of the journals by BFGS, in bearings that give alike in all directions."""
    shaft, loads = drawn_crankshaft(seed, 1, is_isotropic=True)
    found = loads_of(shaft, loads)
    force, stiffness = by_displacements("frame_rigid", shaft, loads)
    bearing = 1 / shaft.supports.compliance[0, :, 0, 0]
    centre, gap = shaft.supports.settlement[0], shaft.supports.clearance[0]
    size, unit = np.max(np.abs(loads.force)), 1e-5

    def energy(at):
        shift = unit * at
        apart = shift.reshape(-1, 2) - centre
        distance = np.hypot(*apart.T)
        pressed = bearing * np.maximum(distance - gap, 0)
        gradient = stiffness @ shift + force + (pressed[:, np.newaxis] * apart / distance[:, np.newaxis]).ravel()
        whole = shift @ stiffness @ shift / 2 + force @ shift + np.sum(pressed**2 / bearing) / 2
        return whole / (size * unit), gradient / size

    start = np.ravel(centre) / unit + np.random.default_rng(seed).normal(size=force.size)
    least = minimize(energy, start, jac=True, method="BFGS", options={"gtol": 1e-9, "maxiter": 20000})
    own = energy(found.displacement[0, :, :, 0].ravel() / unit)
    assert own[0] <= least.fun + 1e-12 * abs(least.fun)
    assert np.max(np.abs(own[1])) < 1e-10
    np.testing.assert_allclose(
        found.displacement[0, :, :, 0].ravel() / unit, least.x, rtol=0, atol=1e-5 * np.max(np.abs(least.x))
    )


@pytest.mark.parametrize("is_rigid", [False, True])
@pytest.mark.parametrize("seed", range(6))
def test_least_energy_within_the_clearance(seed, is_rigid):
    """The journal's place within its bearing, rigid or giving more one way than the other: by SLSQP, on discs."""
    shaft, loads = drawn_crankshaft(seed, 1)
    if is_rigid:
        shaft = with_supports(shaft, compliance=0 * shaft.supports.compliance)
    found = loads_of(shaft, loads)
    force, stiffness = by_displacements("frame_elastic", shaft, loads)
    force = force + stiffness @ shaft.supports.settlement[0].ravel()
    gap, unit = shaft.supports.clearance[0], 1e-5
    scale = np.max(np.abs(loads.force)) * unit

    def energy(at):
        return (unit**2 * at @ stiffness @ at / 2 + unit * force @ at) / scale

    def gradient(at):
        return (unit**2 * stiffness @ at + unit * force) / scale

    def room(at):
        return (gap / unit) ** 2 - np.sum(at.reshape(-1, 2) ** 2, axis=1)

    def slopes(at):
        table = np.zeros((gap.size, at.size))
        for bearing in range(gap.size):
            table[bearing, 2 * bearing : 2 * bearing + 2] = -2 * at[2 * bearing : 2 * bearing + 2]
        return table

    least = minimize(
        energy,
        np.zeros(force.size),
        jac=gradient,
        method="SLSQP",
        constraints={"type": "ineq", "fun": room, "jac": slopes},
        options={"ftol": 1e-14, "maxiter": 1000},
    )
    load = -(force + stiffness @ (unit * least.x))
    np.testing.assert_allclose(found.load[0, :, :, 0].ravel(), load, rtol=0, atol=3e-6 * np.max(np.abs(load)))


@pytest.mark.parametrize("seed", range(6))
def test_without_clearance_it_is_the_frame(seed):
    shaft, loads = drawn_crankshaft(seed, 6)
    shaft = with_supports(shaft, clearance=0 * shaft.supports.clearance)
    rigid = with_supports(shaft, compliance=0 * shaft.supports.compliance)
    for name, own in (("frame_elastic", shaft), ("frame_rigid", rigid)):
        for values, wanted in zip(loads_of(own, loads), METHODS[name].loads(own, loads), strict=True):
            np.testing.assert_allclose(values, wanted, rtol=0, atol=1e-11 * np.max(np.abs(wanted)))


def test_some_bearings_are_rigid_in_one_direction():
    """They give by 1/k toward X and not toward Y: as between bearings that are a millionth as soft toward Y."""
    shaft, loads = drawn_crankshaft(2, 12, is_isotropic=True)
    compliance = shaft.supports.compliance * np.diag([1.0, 0.0])
    found, near = (
        loads_of(with_supports(shaft, compliance=compliance + little * np.eye(2)), loads).load
        for little in (0.0, 1e-15)
    )
    np.testing.assert_allclose(found, near, rtol=0, atol=1e-4 * np.max(np.abs(found)))
    assert np.all(np.isfinite(found))


@pytest.mark.parametrize("give", [0.0, 1e-9])
def test_a_journal_that_does_not_reach_its_bearing(give):
    """A beam of two spans that sags by Pl³/48EI, l = 2, in its middle: less than the clearance there."""
    shaft = straight_shaft([0, 1, 2], compliance=give)
    sag = 3.0 * 2**3 / 48
    for gap, touches in ((1.01 * sag, False), (0.9 * sag, True)):
        supports = shaft.supports._replace(clearance=np.array([[0.0, gap, 0.0]]))
        found = loads_of(shaft._replace(supports=supports), forces_on([1 - 1e-15], [[0.0, -3.0]]))
        # On rigid bearings the middle one bears what keeps it at −gap: 48EI/l³ (sag − gap).
        wanted = 6.0 * (sag - gap) if touches else 0.0
        assert found.load[0, 1, 1, 0] == pytest.approx(-wanted, abs=1e-7 if give else 1e-12)
        assert found.displacement[0, 1, 1, 0] == pytest.approx(-min(sag, gap), rel=1e-7 if give else 1e-12)
