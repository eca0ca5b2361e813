"""What only one kind of mechanism is asked: articulation angles, Grashof's class, transmission angles."""

import numpy as np
import pytest
from tests.machines import RADIUS, ROCKER, ROD, slave, slider
from tests.told import line_of, texts_of

import cranktrain as ct


def rods(master, *slaves):
    bank = {"M": {"mechanism": master}} | {
        f"S{i}": {"angle": f"{angle} deg", "mechanism": table} for i, (angle, table) in enumerate(slaves)
    }
    return ct.run(ct.Machine(bank=bank))


def test_articulation_angles():
    """γ ± asin(λ sin γ), and the offset angle ζ − γ."""
    result = rods(
        slider(), (60, slave("M", articulation_angle="64 deg")), (-40, slave("M", articulation_angle="-45 deg"))
    )
    gamma = np.radians([60, -40])
    shift = np.arcsin(RADIUS / ROD * np.sin(gamma))
    np.testing.assert_allclose(result.offset_angle, np.radians([4, -5]), rtol=1e-13)
    np.testing.assert_allclose(result.articulation_angle_without_top_shift, gamma + shift, rtol=1e-14)
    np.testing.assert_allclose(result.articulation_angle_without_bottom_shift, gamma - shift, rtol=1e-14)
    (check,) = [check for check in result.checks if check.name == "zero_shift"]
    assert str(check.verdict()) == "holds"


def test_articulation_angle_with_an_offset_master():
    """With crank, knuckle radius and slave rod in line: ζ = γ + asin((R sin γ − e)/L) and γ − asin((R sin γ + e)/L)."""
    result = rods(slider(offset="12 mm"), (60, slave("M")))
    for dead, extreme, sign in (("top", np.max, 1), ("bottom", np.min, -1)):
        angle = float(getattr(result, f"articulation_angle_without_{dead}_shift")[0])
        assert angle == pytest.approx(
            np.radians(60) + sign * np.arcsin((RADIUS * np.sin(np.radians(60)) - sign * 0.012) / ROD)
        )
        # By complex numbers: the slave's distance from the shaft has its extreme where the crank lies along its axis.
        alpha = np.radians(60 + (0 if sign == 1 else 180) + np.array([-0.01, 0, 0.01]))
        master = np.exp(1j * np.arcsin((0.012 - RADIUS * np.sin(alpha)) / ROD))
        knuckle = (RADIUS * np.exp(1j * alpha) + 0.045 * master * np.exp(1j * angle)) * np.exp(-1j * np.radians(60))
        position = knuckle.real + np.sqrt(0.135**2 - knuckle.imag**2)
        assert extreme(position) == position[1]


def test_no_articulation_angle_for_a_slave_with_an_offset_of_its_own():
    result = rods(slider(), (60, slave("M")), (90, slave("M", offset="5 mm", articulation_angle="88 deg")))
    assert np.isnan(result.articulation_angle_without_top_shift).tolist() == [False, True]
    assert texts_of(check.verdict() for check in result.checks) == ("holds", "holds")
    alone = rods(slider(), (90, slave("M", offset="5 mm", articulation_angle="88 deg")))
    assert [check.name for check in alone.checks] == ["piston_derivatives"]
    assert np.isnan(alone.articulation_angle_without_top_shift).all()
    assert np.isnan(alone.articulation_angle_without_bottom_shift).all()


@pytest.mark.parametrize(
    ("lengths", "expected"),
    [
        ((100, 360, 280, 400), 0),
        ((280, 330, 320, 100), 1),
        ((300, 100, 280, 320), 2),
        ((300, 360, 100, 400), 3),
        ((100, 300, 300, 500), 4),
        ((300, 350, 280, 400), 5),
    ],
    ids=["crank-rocker", "double crank", "double rocker", "rocker-crank", "change point", "non-Grashof"],
)
def test_grashof_class(lengths, expected):
    """By which link is shortest, and whether shortest and longest together are less than the other two."""
    names = ("crank_radius", "rod_length", "rocker_length", "ground_length")
    table = {"kind": "crank_rocker"} | {name: f"{length} mm" for name, length in zip(names, lengths, strict=True)}
    result = ct.run(ct.Machine(mechanism=table), partial=True)
    assert result.grashof_class[0] == expected


def test_transmission_angle_by_the_cosine_rule():
    result = ct.run(ct.Machine(mechanism=ROCKER))
    for angle, distance in ((result.smallest_transmission_angle, 0.3), (result.largest_transmission_angle, 0.5)):
        assert angle[0] == pytest.approx(np.arccos((0.36**2 + 0.28**2 - distance**2) / (2 * 0.36 * 0.28)), rel=1e-13)
    assert result.grashof_class[0] == 0
    assert line_of(result, "Motion", "transmission angle") == "54.17° at least, 102.02° at most"


def test_class_keeps_its_capitals():
    result = ct.run(ct.Machine(mechanism=ROCKER | {"crank_radius": "300 mm", "rod_length": "350 mm"}), partial=True)
    assert line_of(result, "Motion", "linkage") == "non-Grashof: no link can turn"
