"""Counterweights and balance shafts: closed forms of known engines, and curves of forces as the judge."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize
from tests.layouts_by_order import Cylinders, inertia_roll, reciprocating_vectors, roll_free_place
from tests.vectors_by_order import largest_length, turned_vectors

from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.numerics.enclosing import smallest_circle
from cranktrain.numerics.plane_vectors import (
    PlaneVectors,
    added,
    curve_vectors,
    hodograph,
    machine_axes,
    reversed_vectors,
    running_axes,
    vector_curve,
)
from cranktrain.questions.balance.counterweights import (
    middle_of,
    share_of,
    two_plane_counterweights,
    two_plane_vectors,
)
from cranktrain.questions.balance.rotating_weights import joined, on_crank, weight_orders, weight_roll, weight_vectors
from cranktrain.questions.balance.shafts import couple_of, lanchester_shafts, two_plane_shafts
from cranktrain.questions.balance.unit_shaking import gross, shaking, with_weights
from cranktrain.questions.torque.rod_harmonics import acceleration_harmonics

FEW = settings(max_examples=40, deadline=None, derandomize=True)

R, RATIO, MASS = 0.05, 0.25, 2.0
UNIT = MASS * R
PHI = np.arange(720) * (2 * np.pi / 720)
AT_CRANK = np.zeros(2, dtype=complex)
PART = st.complex_numbers(max_magnitude=5)


def cylinders_of(throw_deg, axis_deg):
    throw, axis = np.radians(np.broadcast_arrays(np.array(throw_deg, dtype=float), axis_deg))
    one = np.ones_like(throw)
    return Cylinders(throw, axis, MASS * one, R * one, RATIO * one)


def machine(throw_deg, axis_deg, position, highest=8):
    cylinders = cylinders_of(throw_deg, axis_deg)
    vectors = reciprocating_vectors(cylinders, highest)
    z = np.array(position, dtype=float)
    return cylinders, vectors, z, shaking(vectors, z)


def left_over(vectors, position, before, after):
    """What remains, as (what, order), the largest first; none of it is larger than all parts together."""
    arms = (np.ones_like(position), position)
    left = []
    for what, was, now, arm in zip(("force", "couple"), before, after, arms, strict=True):
        scale = gross(vectors, arm)
        assert np.all(hodograph(was).major <= (1 + 1e-12) * scale)
        size = hodograph(now).major
        left += [(what, float(was.order[i])) for i in np.argsort(-size, kind="stable") if size[i] > 1e-9 * scale]
    return left


FOUR = machine([0, 180, 180, 0], 0, [-0.15, -0.05, 0.05, 0.15])
V6 = machine([0, 0, 240, 240, 120, 120], [-45, 45] * 3, [-0.1, -0.1, 0, 0, 0.1, 0.1])


@pytest.mark.parametrize("share", [0.0, 0.3, 0.5, 1.0])
@pytest.mark.parametrize(("throw", "axis"), [(0, 0), (70, 25)])
def test_one_cylinder_with_a_share_of_its_mass(share, throw, axis):
    # semi-axes 1 − κ and κ of m R ω², whatever rotates
    cylinders, vectors, z, _ = machine([throw], [axis], [0.0])
    rotating = 0.03 * np.exp(1j * cylinders.throw_angle)
    weights = on_crank(-share_of(rotating, vectors.forward[..., 1], share), z)
    before = shaking(
        added(vectors, weight_vectors(on_crank(rotating, z), vectors.order)),
        z,
    )
    found = hodograph(with_weights(before, weights).force)
    axes = sorted((found.major[1] / UNIT, found.minor[1] / UNIT))
    assert axes == pytest.approx(sorted((max(1 - share, share), min(1 - share, share))), abs=1e-14)
    assert weights.moment[0] == pytest.approx(0.03 + share * UNIT, rel=1e-14)
    assert weights.angle[0] == pytest.approx(np.radians(throw) - np.pi, abs=1e-14)


@pytest.mark.parametrize("bank", [45, 60, 90, 120])
def test_v_twin_with_a_common_pin(bank):
    # f_1 = 1, b_1 = cos γ, order 2: cos(γ/2) and cos(3γ/2)
    _, vectors, z, before = machine([0, 0], [-bank / 2, bank / 2], [0, 0])
    g = np.radians(bank)
    second = acceleration_harmonics(RATIO, 2)[2]
    assert np.abs(before.force.forward[1:3]) == pytest.approx([UNIT, UNIT * second * abs(np.cos(g / 2))], abs=1e-15)
    assert np.abs(before.force.backward[1:3]) == pytest.approx(
        [UNIT * abs(np.cos(g)), UNIT * second * abs(np.cos(1.5 * g))], abs=1e-15
    )
    weights = on_crank(-share_of(np.zeros(1), before.force.forward[1:2], 0.5), np.zeros(1))
    after = with_weights(before, weights)
    expected = [("force", 2.0), ("force", 4.0), ("force", 6.0)]
    if bank != 90:
        expected.insert(0, ("force", 1.0))
    assert sorted(left_over(vectors, z, before, after))[: len(expected)] == sorted(expected)


def test_lanchester_leaves_the_fourth_order():
    _, vectors, z, before = FOUR
    second = acceleration_harmonics(RATIO, 2)[2]
    weights = lanchester_shafts(before.force, 2, 0.0, AT_CRANK)
    np.testing.assert_allclose(weights.moment, second * UNIT / 2, rtol=1e-14)
    np.testing.assert_array_equal(weights.ratio, [2, -2])
    after = with_weights(before, weights)
    assert left_over(vectors, z, before, before) == [("force", 2.0), ("force", 4.0), ("force", 6.0), ("force", 8.0)]
    assert left_over(vectors, z, before, after) == [("force", 4.0), ("force", 6.0), ("force", 8.0)]


def test_heights_of_lanchesters_shafts():
    # 2.0008 → 0.0008 m R² ω² where the shaft that turns with the crank is higher by R/A_2; the other way up it doubles
    cylinders, _, _, before = FOUR
    roll = inertia_roll(cylinders, 4)
    unit = MASS * R**2
    second = acceleration_harmonics(RATIO, 2)[2]
    assert roll.amplitude[2] / unit == pytest.approx(2.0005205622, abs=1e-9)
    weights = lanchester_shafts(before.force, 2, 0.0, AT_CRANK)
    for height, expected in ((R / second, 0.0005205622), (-R / second, 4.0005205622)):
        placed = weights._replace(place=np.array([height, 0.0]))
        total = roll.sine[2] + weight_roll(placed, roll.order).sine[2]
        assert total / unit == pytest.approx(expected, abs=1e-9)


def test_place_of_the_forward_shaft_that_takes_the_roll_away():
    cylinders, _, _, before = FOUR
    roll = inertia_roll(cylinders, 4)
    weights = lanchester_shafts(before.force, 2, 0.0, AT_CRANK)
    backward = np.array(-0.02 + 0.08j)
    place = roll_free_place(weights, roll, 2, backward)
    height = R / acceleration_harmonics(RATIO, 2)[2] * 1.0002602811
    assert place == pytest.approx(height + backward.real - 0.08j, rel=1e-9)
    placed = weights._replace(place=np.array([place, backward]))
    more = weight_roll(placed, roll.order)
    np.testing.assert_allclose(roll.sine[2] + more.sine[2], 0, atol=1e-16)
    np.testing.assert_allclose(roll.cosine[2] + more.cosine[2], 0, atol=1e-16)


def test_roll_of_weights_is_the_moment_of_their_forces():
    rng = np.random.default_rng(0)
    weights = on_crank(rng.normal(size=4) + 1j * rng.normal(size=4), np.zeros(4))
    weights = weights._replace(
        ratio=np.array([1.0, -1.0, 2.0, -2.0]), place=rng.normal(size=4) + 1j * rng.normal(size=4)
    )
    orders = np.arange(4.0)
    force = vector_curve(weight_vectors(weights, orders), PHI)
    x, y = weights.place.real[:, np.newaxis], weights.place.imag[:, np.newaxis]
    moment = np.sum(x * force.imag - y * force.real, axis=0)
    roll = weight_roll(weights, orders)
    turned = orders * PHI[:, np.newaxis]
    found = np.sum(roll.cosine * np.cos(turned) + roll.sine * np.sin(turned), axis=-1)
    np.testing.assert_allclose(found, moment, atol=1e-13)
    # and each force is u k² in the direction in which its weight stands
    angle = weights.ratio[:, np.newaxis] * PHI + weights.angle[:, np.newaxis]
    np.testing.assert_allclose(
        force, (weights.moment * weights.ratio**2)[:, np.newaxis] * np.exp(1j * angle), atol=1e-13
    )


def test_v6_of_ninety_degrees():
    # √3 of first-order couple, all of it forward: counterweights in two planes take it; shafts at ±2 take the second
    _, vectors, z, before = V6
    force, higher = [("force", 6.0)], [("couple", 2.0), ("couple", 4.0), ("couple", 8.0)]
    assert left_over(vectors, z, before, before) == [*force, ("couple", 1.0), *higher]
    planes = np.array([-0.13, 0.11])
    weights = two_plane_counterweights(*(share_of(0.0, part.forward[1], 0.5) for part in before), planes)
    after = with_weights(before, weights)
    assert left_over(vectors, z, before, after) == [*force, *higher]
    shafts = two_plane_shafts(after, 2, planes, AT_CRANK)
    assert left_over(vectors, z, before, with_weights(after, shafts)) == [*force, *higher[1:]]
    both = with_weights(before, joined(weights, shafts))
    assert left_over(vectors, z, before, both) == [*force, *higher[1:]]
    # a pair of equal and opposite weights on each shaft: couple / distance
    np.testing.assert_allclose(shafts.moment[[0, 2]], shafts.moment[[1, 3]], rtol=1e-12)
    np.testing.assert_allclose(
        shafts.moment[[0, 2]] * 4 * 0.24, [abs(before.couple.forward[2]), abs(before.couple.backward[2])], rtol=1e-12
    )


def test_counterweights_throw_by_throw_do_the_same_on_a_v8_cross():
    throw, axis = [0, 0, 90, 90, 270, 270, 180, 180], [-45, 45] * 4
    position = np.repeat([-0.15, -0.05, 0.05, 0.15], 2)
    _, vectors, z, before = machine(throw, axis, position)
    throws = PlaneVectors(vectors.order, *(part[::2] + part[1::2] for part in vectors[1:]))
    weights = on_crank(-share_of(np.zeros(4), throws.forward[..., 1], 0.5), position[::2])
    after = with_weights(before, weights)
    assert ("couple", 1.0) in left_over(vectors, z, before, before)
    assert ("couple", 1.0) not in left_over(vectors, z, before, after)


def test_couple_alone_and_mid_plane():
    rng = np.random.default_rng(0)
    vectors = reciprocating_vectors(cylinders_of([0, 100], [0, 30]), 4)
    z, mid = np.array([0.1, 0.4]), 0.2
    before = shaking(vectors, z, mid)
    planes = rng.normal(size=2)
    shafts = two_plane_shafts(before, 1, planes, AT_CRANK, mid_plane=mid)
    after = with_weights(before, shafts, mid)
    for vectors_left in (after.force, after.couple):
        assert hodograph(vectors_left).major[1] < 1e-16
    couple_only = with_weights(before, two_plane_shafts(couple_of(before), 1, planes, AT_CRANK, mid_plane=mid), mid)
    assert hodograph(couple_only.couple).major[1] < 1e-16
    np.testing.assert_allclose(couple_only.force.forward[1], before.force.forward[1], atol=1e-16)


@FEW
@given(st.complex_numbers(max_magnitude=9), st.complex_numbers(max_magnitude=9), st.floats(-2, 2), st.floats(0.1, 3))
def test_two_planes_carry_any_force_and_couple(force, couple, first, apart):
    planes = np.array([first, first + apart])
    found = two_plane_vectors(np.array(force), np.array(couple), planes)
    assert np.sum(found) == pytest.approx(-force, abs=1e-11)
    assert np.sum(found * planes) == pytest.approx(-couple, abs=1e-11)


def test_one_plane_carries_no_couple():
    assert np.all(np.isnan(two_plane_vectors(np.array(1j), np.array(1.0 + 0j), np.array([0.2, 0.2]))))


def test_least_largest_force_of_one_order_is_half():
    # without higher orders the best counterweight takes half the mass and leaves a turning ½
    _, vectors, _, _ = machine([40], [0], [0.0], highest=1)
    found = middle_of(vectors)
    np.testing.assert_allclose(found, 0.5 * UNIT * np.exp(1j * np.radians(40)), rtol=1e-9)


@pytest.mark.parametrize(("throws", "axes"), [([0], [0]), ([20], [50]), ([0, 0], [-30, 30]), ([0, 40], [0, 60])])
def test_least_largest_force_against_a_search(throws, axes):
    _, _, _, before = machine(throws, axes, np.zeros(len(throws)))
    points = vector_curve(before.force, PHI) * np.exp(-1j * PHI)

    def largest(vector):
        return np.abs(points + vector[0] + 1j * vector[1]).max()

    best = minimize(largest, [0.0, 0.0], method="Nelder-Mead", options={"xatol": 1e-9, "fatol": 1e-12, "maxiter": 2000})
    after = with_weights(before, on_crank(-np.atleast_1d(middle_of(before.force)), np.zeros(1)))
    reached = largest_length(after.force).value[0]
    # the search sees points 0.5° apart: what it finds is at most so much smaller
    assert best.fun * (1 - 1e-5) <= reached <= best.fun * (1 + 2e-5)


def test_least_largest_force_and_couple_in_two_planes():
    # both vectors are free, so each has its least: against weights a little different
    _, _, _, before = machine([0, 130], [0, 20], [-0.1, 0.1])
    planes = np.array([-0.12, 0.15])
    force, couple = middle_of(before.force), middle_of(before.couple)

    def largest(weights):
        after = with_weights(before, weights)
        return np.array([largest_length(part).value[0] for part in after])

    best = two_plane_counterweights(force, couple, planes)
    for angle in (0.0, 1.0, 2.0, 3.0, 4.0, 5.0):
        aside = 0.01 * np.exp(1j * angle)
        other = largest(two_plane_counterweights(force * (1 + aside), couple * (1 + aside), planes))
        assert np.all(largest(best) < other)


def test_least_largest_vector_of_designs():
    vectors = reciprocating_vectors(cylinders_of([[0], [30]], [[0], [0]]), 4)
    found = middle_of(vectors)
    assert found.shape == (2, 1)
    np.testing.assert_allclose(found[1], found[0] * np.exp(1j * np.radians(30)), rtol=1e-9)


@FEW
@given(st.lists(PART, min_size=4, max_size=4), st.lists(PART, min_size=3, max_size=3))
def test_smallest_circle_of_any_hodograph(forward, backward):
    # it holds the curve, and the points that it touches do not all lie on one side of its centre
    order = np.arange(1.0, 5.0)
    vectors = PlaneVectors(order, np.array(forward) / order**2, np.array([*backward, 0]) / order**2)

    def seen_from_crank(angle):
        return vector_curve(vectors, angle) * np.exp(-1j * angle)

    found = smallest_circle(seen_from_crank)
    rays = seen_from_crank(PHI) - found.centre
    size = found.radius + 1e-9
    assert np.abs(rays).max() <= size * (1 + 1e-8)
    # points half a step beside a touch are short of it by (4·π/720)²·size/2 at most, times the curve's own bend
    touches = np.sort(np.angle(rays[np.abs(rays) >= found.radius * (1 - 2e-3) - 1e-9]))
    gaps = np.diff(np.append(touches, touches[0] + 2 * np.pi))
    assert gaps.max() <= np.pi + 0.1


def test_smallest_circle_of_an_ellipse_and_of_a_triangle():
    ellipse = smallest_circle(lambda phi: (1 + 2j) + 3 * np.cos(phi) + 1j * np.sin(phi))
    assert ellipse.radius == pytest.approx(3, rel=1e-12)
    assert ellipse.centre == pytest.approx(1 + 2j, abs=1e-7)
    # a rounded triangle, whose three tips are at 1.2
    triangle = smallest_circle(lambda phi: np.exp(1j * phi) + 0.2 * np.exp(-2j * phi))
    assert triangle.radius == pytest.approx(1.2, rel=1e-9)
    assert abs(triangle.centre) < 1e-7
    still = smallest_circle(lambda phi: 0 * phi + 2j)
    assert (still.centre, still.radius) == (2j, 0.0)


angles = st.lists(st.tuples(st.floats(-180, 180), st.floats(-180, 180), st.floats(-1, 1)), min_size=1, max_size=5)


@FEW
@given(angles)
def test_running_the_other_way_mirrors_the_vectors(layout):
    # astern is the same metal at −φ: with every angle turned round, F′(φ) is the mirror image of F(−φ)
    throw, axis, z = np.transpose(layout)
    ahead = shaking(reciprocating_vectors(cylinders_of(throw, axis), 4), z)
    astern = shaking(reciprocating_vectors(cylinders_of(-throw, -axis), 4), z)
    for there, back in ((ahead.force, astern.force), (ahead.couple, astern.couple)):
        np.testing.assert_allclose(back.forward, np.conj(there.forward), atol=1e-15)
        np.testing.assert_allclose(back.backward, np.conj(there.backward), atol=1e-15)


@FEW
@given(angles, st.floats(-360, 360))
def test_turning_all_angles_turns_the_forces(layout, turn):
    throw, axis, z = np.transpose(layout)
    found = shaking(reciprocating_vectors(cylinders_of(throw + turn, axis + turn), 4), z).force
    base = shaking(reciprocating_vectors(cylinders_of(throw, axis), 4), z).force
    np.testing.assert_allclose(found.forward, base.forward * np.exp(1j * np.radians(turn)), atol=1e-14)
    np.testing.assert_allclose(found.backward, base.backward * np.exp(1j * np.radians(turn)), atol=1e-14)


@FEW
@given(angles)
def test_layouts_superpose(layout):
    throw, axis, z = np.transpose(layout)
    whole = shaking(reciprocating_vectors(cylinders_of(throw, axis), 4), z)
    ones = [shaking(reciprocating_vectors(cylinders_of([t], [a]), 4), np.array([p])) for t, a, p in layout]
    np.testing.assert_allclose(whole.couple.forward, sum(one.couple.forward for one in ones), atol=1e-14)
    np.testing.assert_allclose(whole.force.backward, sum(one.force.backward for one in ones), atol=1e-14)


@pytest.mark.parametrize("k", [3, 5, 7, 9])
def test_radial_with_plain_rods(k):
    # f_n is there only for n ≡ 1, b_n for n ≡ −1 (mod k); order 1 is k/2 forward
    _, _, _, before = machine(np.zeros(k), np.arange(k) * 360 / k, np.zeros(k))
    unit = UNIT * acceleration_harmonics(RATIO, 8)
    for order in (1, 2, 4, 6, 8):
        assert abs(before.force.forward[order]) == pytest.approx(
            k / 2 * abs(unit[order]) * ((order - 1) % k == 0), abs=1e-15
        )
        assert abs(before.force.backward[order]) == pytest.approx(
            k / 2 * abs(unit[order]) * ((order + 1) % k == 0), abs=1e-15
        )


@pytest.mark.parametrize("knuckle_radius", [1e-9, 0.03])
def test_radial_with_articulated_rods(knuckle_radius):
    # forces by the mechanisms' own kernels: a knuckle in the pin's axis makes plain rods, a real one breaks the rule
    k, rod = 5, R / RATIO
    axes = np.arange(k) * (2 * np.pi / k)
    master = SliderCrank(np.array(R), np.array(rod), np.array(0.0))
    slaves = ArticulatedRod(
        master,
        np.array(knuckle_radius),
        axes[1:, np.newaxis],
        axes[1:, np.newaxis],
        np.array(rod - knuckle_radius),
        0.0,
    )
    sliders = [slider_crank(PHI, master).slider.second, *articulated_rod(PHI, slaves).slider.second]
    force = -MASS * np.array(sliders)
    own_axes = curve_vectors(force, np.zeros_like(force), 6)
    found = shaking(turned_vectors(own_axes, axes), np.zeros(k)).force
    total = vector_curve(curve_vectors(*np.stack([np.cos(axes) @ force, np.sin(axes) @ force]), 6), PHI)
    np.testing.assert_allclose(vector_curve(found, PHI), total, atol=1e-14)
    plain = machine(np.zeros(k), np.degrees(axes), np.zeros(k))[3].force
    apart = np.abs(found.forward - plain.forward[:7]).max() + np.abs(found.backward - plain.backward[:7]).max()
    assert apart < 1e-8 if knuckle_radius < 1e-6 else apart > 1e-3 * UNIT
    # the second order, which plain rods of five cylinders do not have
    assert (hodograph(found).major[2] > 1e-3 * UNIT) == (knuckle_radius > 1e-6)


def test_cylinders_may_differ():
    one = Cylinders(*(np.array([v]) for v in (0.3, 0.1, 2.0, 0.05, 0.25)))
    other = Cylinders(*(np.array([v]) for v in (1.3, 0.7, 1.1, 0.04, 0.31)))
    both = Cylinders(*(np.concatenate(pair) for pair in zip(one, other, strict=True)))
    found = vector_curve(reciprocating_vectors(both, 40), PHI)
    for row, (throw, axis, mass, radius, ratio) in enumerate(np.transpose(both)):
        own = PHI + throw - axis
        root = np.sqrt(1 - (ratio * np.sin(own)) ** 2)
        acceleration = (
            np.cos(own) + ratio * np.cos(2 * own) / root + ratio**3 * (np.sin(own) * np.cos(own)) ** 2 / root**3
        )
        np.testing.assert_allclose(found[row], mass * radius * acceleration * np.exp(1j * axis), atol=1e-15)


@pytest.mark.parametrize("clockwise", [True, False])
def test_running_axes_are_machine_axes_backward(clockwise):
    vector = np.array([1 + 2j, -3j])
    there = machine_axes(vector, clockwise=clockwise)
    # x is Y; y lies to the right, or to the left
    np.testing.assert_array_equal(machine_axes(np.array([1, 1j]), clockwise=clockwise), [1j, 1 if clockwise else -1])
    np.testing.assert_array_equal(running_axes(there, clockwise=clockwise), vector)


def test_vectors_as_a_shaft_that_runs_the_other_way_sees_them():
    vectors = PlaneVectors(np.arange(3.0), np.array([1j, 2, 1 + 1j]), np.array([0, 3j, -2]))
    seen = vector_curve(reversed_vectors(vectors), PHI)
    np.testing.assert_allclose(seen, np.conj(vector_curve(vectors, PHI)), atol=1e-14)


def test_orders_at_which_weights_show():
    weights = on_crank(np.array([1.0, 2.0, 1j]), np.zeros(3))._replace(ratio=np.array([1.0, -2.0, 2.0]))
    np.testing.assert_array_equal(weight_orders(weights), [1, 2])
