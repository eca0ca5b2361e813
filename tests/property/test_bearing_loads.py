"""What holds for bearing loads by any method: balance, superposition, axes, and designs beside each other."""

import numpy as np
import pytest
from tests.crankshafts import drawn_crankshaft

from cranktrain.numerics.nested import leaves
from cranktrain.questions.crankshaft.bending.bearing_loads import resultant, unbalanced
from cranktrain.questions.crankshaft.bending.blocks import turned_by
from cranktrain.questions.crankshaft.bending.loads_in_spans import alike_shafts, spanned_loads, unit_loads
from cranktrain.questions.crankshaft.bending.shaft_loads import on_axis
from cranktrain.questions.crankshaft.methods import BEARING_METHODS
from cranktrain.questions.crankshaft.methods.supported_shaft import in_bearings

EVERY = pytest.mark.parametrize("method", BEARING_METHODS, ids=lambda method: method.name)
LINEAR = pytest.mark.parametrize(
    "method", [one for one in BEARING_METHODS if one.bearings.is_linear], ids=lambda method: method.name
)
SEEDS = pytest.mark.parametrize("seed", range(8))


def without_settlement(shaft):
    supports = shaft.supports
    return shaft._replace(supports=supports._replace(settlement=0 * supports.settlement))


def side_by_side(tuples):
    """Designs beside each other; whole numbers are those of the first."""
    first = tuples[0]
    if isinstance(first, tuple):
        return type(first)(*(side_by_side(parts) for parts in zip(*tuples, strict=True)))
    return np.concatenate(tuples) if isinstance(first, np.ndarray) and first.dtype.kind == "f" else first


def varied(seed, n_designs=4):
    """A shaft and its loads as several designs: other numbers, bearings that give otherwise, a load elsewhere."""
    shaft, loads = drawn_crankshaft(seed, 5)
    draw = np.random.default_rng(seed + 100)
    found = []
    for design in range(n_designs):

        def other(part):
            if isinstance(part, tuple):
                return type(part)(*(other(one) for one in part))
            if isinstance(part, np.ndarray) and part.dtype.kind == "f":
                return part * (1 + 1e-3 * draw.uniform(-1, 1, (part.shape[0], *(1,) * (part.ndim - 1))))
            return part

        one, acting = other(shaft), other(loads)
        if design == 1:
            alike = np.eye(2) * one.supports.compliance[..., :1, :1]
            one = one._replace(supports=one.supports._replace(compliance=alike))
        if design == 3:
            one = one._replace(supports=one.supports._replace(compliance=0 * one.supports.compliance))
        if design == 2:
            z = acting.z.copy()
            z[:, 0] = one.supports.place[:, -1] + 0.01
            acting = acting._replace(z=z)
        found.append((one, acting))
    return found


@EVERY
@SEEDS
def test_bearings_balance_the_loads(method, seed):
    shaft, loads = drawn_crankshaft(seed, 7)
    shaft = without_settlement(shaft)
    of_loads = resultant(shaft.supports, on_axis(loads))
    force, moment = unbalanced(shaft.supports, of_loads, method.loads(shaft, loads).load)
    assert np.max(force / of_loads.largest_force) <= 1e-12
    assert np.max(moment / of_loads.largest_moment) <= 1e-12


@EVERY
@SEEDS
def test_a_design_beside_others_is_as_alone(method, seed):
    designs = varied(seed)
    together = method.loads(*(side_by_side(parts) for parts in zip(*designs, strict=True)))
    for design, (shaft, loads) in enumerate(designs):
        for whole, alone in zip(together, method.loads(shaft, loads), strict=True):
            np.testing.assert_array_equal(whole[design], alone[0])
            assert np.all(np.isfinite(alone))


def bearings(shaft, loads, method):
    """What bearings carry, by the loads as they are and by unit loads where these will do."""
    spanned = spanned_loads(alike_shafts(shaft, loads.places), loads)
    units = [unit_loads(group.of, is_geared=True) for group in spanned.groups]
    (supported,) = in_bearings(method, [shaft.supports], [units])
    return spanned, supported, method.of(shaft.supports, spanned).load


@LINEAR
@SEEDS
def test_unit_loads_add_up_to_what_bearings_carry(method, seed):
    """In any number of designs, of which some have bearings that give otherwise toward X than toward Y."""
    shaft, loads = (side_by_side(parts) for parts in zip(*varied(seed), strict=True))
    spanned, supported, wanted = bearings(without_settlement(shaft), loads, method)
    assert any(by_unit is not None for by_unit in supported.by_unit) != method.is_cut
    size = np.max(np.abs(wanted))
    np.testing.assert_allclose(supported.borne(spanned), wanted, rtol=0, atol=1e-12 * size)
    turned = turned_by(wanted, loads.turned)
    np.testing.assert_allclose(supported.turning(spanned), turned, rtol=0, atol=1e-12 * size)
    for design, (one, own) in enumerate(varied(seed)):
        alone, supported_alone, _wanted = bearings(without_settlement(one), own, method)
        np.testing.assert_array_equal(supported.borne(spanned)[design], supported_alone.borne(alone)[0])


@EVERY
@SEEDS
def test_bearings_that_do_not_stand_in_line_are_found_as_they_are(method, seed):
    shaft, loads = drawn_crankshaft(seed, 5)
    spanned, supported, wanted = bearings(shaft, loads, method)
    assert set(supported.by_unit) == {None}
    np.testing.assert_array_equal(supported.borne(spanned), wanted)


@EVERY
@SEEDS
def test_an_angle_beside_others_is_as_alone(method, seed):
    shaft, loads = drawn_crankshaft(seed, 5)
    together = method.loads(shaft, loads)
    curves = {name: getattr(loads, name)[..., 2:3] for name in ("turned", "force", "couple", "torque", "thrust")}
    for whole, alone in zip(together, method.loads(shaft, loads._replace(**curves)), strict=True):
        np.testing.assert_array_equal(whole[..., 2:3], alone)


@LINEAR
@SEEDS
def test_loads_add_up(method, seed):
    shaft, loads = drawn_crankshaft(seed, 3)
    shaft = without_settlement(shaft)
    draw = np.random.default_rng(seed)
    share = draw.uniform(size=len(loads.piece))[:, np.newaxis]

    def part(factor):
        return loads._replace(
            force=loads.force * factor[..., np.newaxis],
            couple=loads.couple * factor[..., np.newaxis],
            torque=loads.torque * factor,
            thrust=loads.thrust * factor,
        )

    whole, one, other = (method.loads(shaft, part(factor)).load for factor in (0 * share + 1, share, 1 - share))
    np.testing.assert_allclose(one + other, whole, rtol=0, atol=1e-12 * np.max(np.abs(whole)))


@EVERY
@SEEDS
def test_machine_axes_turned(method, seed):
    """The same machine seen with its axes turned by an angle."""
    shaft, loads = drawn_crankshaft(seed, 3)
    by = np.full((1, 1), 0.7)
    supports = shaft.supports
    cos, sin = np.cos(0.7), np.sin(0.7)
    turn = np.array([[cos, sin], [-sin, cos]])
    turned_shaft = shaft._replace(
        supports=supports._replace(
            compliance=turn @ supports.compliance @ turn.T,
            settlement=turned_by(supports.settlement[..., np.newaxis], by)[..., 0],
        )
    )
    turned_loads = loads._replace(
        turned=loads.turned - 0.7, force=turned_by(loads.force, by), couple=turned_by(loads.couple, by)
    )
    one, other = method.loads(shaft, loads), method.loads(turned_shaft, turned_loads)
    for values, wanted in zip(other, one, strict=True):
        np.testing.assert_allclose(values, turned_by(wanted, by), rtol=0, atol=1e-11 * np.max(np.abs(wanted)))


@SEEDS
def test_all_rigid_methods_agree_on_two_bearings(seed):
    shaft, loads = drawn_crankshaft(seed, 5, n_spans=1)
    found = [method.loads(shaft, loads).load for method in BEARING_METHODS]
    for other in found[1:]:
        np.testing.assert_allclose(other, found[0], rtol=0, atol=1e-12 * np.max(np.abs(loads.force)))


@SEEDS
def test_stiff_bearings_are_rigid(seed):
    """With 10⁻⁶ of the compliance, loads differ by as much."""
    shaft, loads = drawn_crankshaft(seed, 3)
    shaft = without_settlement(shaft)
    methods = {method.name: method for method in BEARING_METHODS}
    supports = shaft.supports._replace(compliance=1e-6 * shaft.supports.compliance)
    for elastic, rigid in (("five_moment", "three_moment"), ("frame_elastic", "frame_rigid")):
        one = methods[elastic].loads(shaft._replace(supports=supports), loads).load
        other = methods[rigid].loads(shaft, loads).load
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-3 * np.max(np.abs(other)))


def test_arrays_are_left_alone():
    shaft, loads = drawn_crankshaft(3, 4)
    before = [np.array(values) for values in leaves((shaft, loads))]
    for method in BEARING_METHODS:
        method.loads(shaft, loads)
    for one, other in zip(before, leaves((shaft, loads)), strict=True):
        np.testing.assert_array_equal(one, other)
