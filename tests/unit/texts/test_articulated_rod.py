import mpmath
import numpy as np
import pytest
from tests.machines import as_columns

from cranktrain.mechanisms.articulated_rod import ArticulatedRod
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.numerics.designs import by_design
from cranktrain.texts import articulated_rod, steam_engine
from cranktrain.texts.articulated_rod import SlaveHarmonics

V2 = ArticulatedRod(SliderCrank(0.09, 0.32, 0.0), 0.085, np.radians(67.0), np.radians(60.0), 0.235, 0.0)
# a bank before the master's, with an offset angle beyond any engine's: quadrants and signs
WIDE = ArticulatedRod(SliderCrank(0.03, 0.35, 0.0), 0.1, np.radians(-150.0), np.radians(-120.0), 0.25, 0.0)
ANGLES = np.linspace(0, 2 * np.pi, 73)


def distance(angle, crank_radius, rod):
    """Exact distance of the slave's pin from the shaft, in mpmath numbers."""
    (_, L, _), r, zeta, gamma, l, _ = (
        mpmath.mpf(float(part)) if not isinstance(part, tuple) else [mpmath.mpf(float(number)) for number in part]
        for part in rod
    )
    w = zeta - gamma - mpmath.asin(crank_radius / L * mpmath.sin(angle))
    Q = crank_radius * mpmath.sin(angle - gamma) + r * mpmath.sin(w)
    return crank_radius * mpmath.cos(angle - gamma) + r * mpmath.cos(w) + mpmath.sqrt(l**2 - Q**2)


@pytest.mark.parametrize("rod", [V2, WIDE])
def test_derived_constants_are_the_expansion_of_the_exact_distance_to_second_order_in_the_crank_radius(rod):
    harmonics = articulated_rod.derived(rod)
    found = -articulated_rod.slave_displacement(ANGLES[::6], rod, harmonics, 0.0).value
    with mpmath.workdps(40):
        for angle, value in zip(ANGLES[::6], found, strict=True):
            series = mpmath.taylor(lambda radius, a=angle: distance(mpmath.mpf(float(a)), radius, rod), 0, 2)
            expected = sum(term * mpmath.mpf(rod.master.crank_radius) ** order for order, term in enumerate(series))
            assert value == pytest.approx(float(expected), abs=4e-16)


def test_reconstructed_constants_are_the_derived_ones_to_first_order_in_the_offset_angle():
    straight = V2._replace(articulation_angle=V2.bank_angle)
    for found, expected in zip(articulated_rod.reconstructed(straight), articulated_rod.derived(straight), strict=True):
        assert found == pytest.approx(expected, rel=1e-14)
    # first harmonic: linear in sin ψ, so the difference falls at least with its square
    differences = []
    for offset in (1e-2, 1e-3):
        rod = V2._replace(articulation_angle=V2.bank_angle + offset)
        pair = [articulated_rod.reconstructed(rod), articulated_rod.derived(rod)]
        vectors = [one.first_amplitude * np.exp(1j * one.first_phase) for one in pair]
        differences.append(abs(vectors[0] - vectors[1]))
    assert differences[1] < differences[0] / 90


@pytest.mark.parametrize("constants", [articulated_rod.derived, articulated_rod.reconstructed])
def test_master_bank_without_offset_angle_is_defined(constants):
    # γ = 0: the divided forms of the source fail here
    rod = V2._replace(bank_angle=0.0, articulation_angle=0.0)
    _, first_phase, second_amplitude, second_phase, _ = constants(rod)
    assert first_phase == 0.0
    assert second_phase == 0.0
    assert second_amplitude > 0


@pytest.mark.parametrize("constants", [articulated_rod.derived, articulated_rod.reconstructed])
def test_rods_jointed_on_the_crank_pin_are_a_plain_crank(constants):
    rod = V2._replace(knuckle_radius=0.0, rod_length=V2.master.rod_length)
    harmonics = constants(rod)
    ratio = rod.master.crank_radius / rod.master.rod_length
    assert harmonics.first_amplitude == pytest.approx(1.0, rel=1e-15)
    assert harmonics.second_amplitude == pytest.approx(ratio, rel=1e-15)
    assert harmonics.mean_distance == pytest.approx(rod.rod_length - rod.master.crank_radius * ratio / 4, rel=1e-15)
    top = articulated_rod.own_top_distance(rod, harmonics)
    assert top == pytest.approx(rod.master.crank_radius + rod.rod_length, rel=1e-15)
    found = articulated_rod.slave_displacement(ANGLES, rod, harmonics, top)
    plain = steam_engine.two_harmonics(ANGLES - rod.bank_angle, rod.master.crank_radius, ratio)
    for one, other in zip(found, plain, strict=True):
        np.testing.assert_allclose(one, other, rtol=0, atol=3e-16)


@pytest.mark.parametrize("constants", [articulated_rod.derived, articulated_rod.reconstructed])
def test_mirror_image_of_the_bank(constants):
    mirrored = constants(V2._replace(bank_angle=-V2.bank_angle, articulation_angle=-V2.articulation_angle))
    straight = constants(V2)
    assert mirrored.first_phase == pytest.approx(-straight.first_phase, rel=1e-15)
    assert mirrored.second_phase == pytest.approx(-straight.second_phase, rel=1e-15)
    assert mirrored.first_amplitude == pytest.approx(straight.first_amplitude, rel=1e-15)
    assert mirrored.second_amplitude == pytest.approx(straight.second_amplitude, rel=1e-15)
    assert mirrored.mean_distance == pytest.approx(straight.mean_distance, rel=1e-15)


def test_derivatives_of_the_printed_displacement_in_40_digits():
    harmonics = articulated_rod.reconstructed(V2)
    found = articulated_rod.slave_displacement(ANGLES[1::9], V2, harmonics, 0.4)
    with mpmath.workdps(40):
        E, Phi, F, Theta, K = (mpmath.mpf(float(number)) for number in harmonics)
        gamma, R = mpmath.mpf(float(V2.bank_angle)), mpmath.mpf(V2.master.crank_radius)

        def printed(angle):
            own = angle - gamma
            return mpmath.mpf(0.4) - K - R * (E * mpmath.cos(own + Phi) + F / 4 * mpmath.cos(2 * own - Theta))

        for order in range(3):
            expected = [float(mpmath.diff(printed, mpmath.mpf(angle), order)) for angle in ANGLES[1::9]]
            np.testing.assert_allclose(found[order], expected, rtol=0, atol=4e-16)


@pytest.mark.parametrize("ratio", [0.0, 0.1, 0.25, 0.45, 0.6])
def test_own_top_is_the_curves_highest_point_for_every_phase(ratio):
    phase = np.linspace(-np.pi, np.pi, 181)[:, np.newaxis]
    harmonics = SlaveHarmonics(1.1, 0.3, 1.1 * ratio, phase, 0.31)
    found = articulated_rod.own_top_distance(V2, harmonics)
    angle = np.linspace(-np.pi, np.pi, 20001)
    curve = articulated_rod.slave_displacement(angle, V2, harmonics, found).value.min(axis=-1)
    # on a grid of 0.018° the lowest displacement stands at most ½ j (step/2)² above zero
    assert curve.min() > -1e-15
    assert curve.max() < 0.5 * V2.master.crank_radius * 1.1 * (1 + ratio) * (np.pi / 20000) ** 2 + 1e-15


def test_designs_broadcast():
    rods = by_design([as_columns(V2, WIDE)], 2)
    harmonics = articulated_rod.derived(rods)
    together = articulated_rod.slave_displacement(
        ANGLES, rods, harmonics, articulated_rod.own_top_distance(rods, harmonics)
    )
    for design, rod in enumerate((V2, WIDE)):
        own = articulated_rod.derived(rod)
        alone = articulated_rod.slave_displacement(ANGLES, rod, own, articulated_rod.own_top_distance(rod, own))
        for found, expected in zip(together, alone, strict=True):
            assert found.shape == (2, 1, ANGLES.size)
            np.testing.assert_allclose(found[design, 0], expected, rtol=0, atol=3e-16)


def test_constants_of_the_exact_motion_are_its_fourier_constants():
    """By quadrature in 30 digits; docs/theory/textbook-forms has them in six."""
    found = articulated_rod.of_exact_motion(V2)
    with mpmath.workdps(30):

        def harmonic(order):
            samples = [
                distance(2 * mpmath.pi * step / 120, mpmath.mpf(V2.master.crank_radius), V2)
                * mpmath.expjpi(-mpmath.mpf(2) * order * step / 120)
                for step in range(120)  # the sum of a periodic curve converges with every power
            ]
            return sum(samples) / 120

        gamma, radius = mpmath.mpf(V2.bank_angle), mpmath.mpf(V2.master.crank_radius)
        first, second = (2 * harmonic(order) * mpmath.expj(order * gamma) for order in (1, 2))
        expected = SlaveHarmonics(
            abs(first) / radius, mpmath.arg(first), 4 * abs(second) / radius, -mpmath.arg(second), harmonic(0).real
        )
    np.testing.assert_allclose(found, [float(part) for part in expected], rtol=1e-12)
    shown = [found[0], np.degrees(found[1]), found[2], np.degrees(found[3]), 1e3 * found[4]]
    assert [round(float(a), n) for a, n in zip(shown, (6, 4, 6, 3, 3), strict=True)] == [
        1.038943, 1.2938, 0.257358, 20.929, 310.325,
    ]  # fmt: skip
