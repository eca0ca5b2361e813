"""Crank angles as they are shown, and mechanisms that differ in more than their phase."""

import numpy as np
import pytest
from tests.machines import ROCKER, V12, banks, slave, slider, throws

import cranktrain as ct
from cranktrain.analysis.parts import parts_of
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Mechanisms, distinct


def mechanisms(*machines):
    return parts_of(machines, step=np.radians(1))[Mechanisms]


def test_angles_are_counted_within_the_period():
    angle = CrankAngle(np.arange(4.0), np.full((1, 1, 1), 0.5), 4 * np.pi)
    given = np.array([0.5, 0.5 - 1e-16, 0.5 + 2 * np.pi, 0.25, -20.0]).reshape(1, -1, 1)
    counted = angle.counted(given)[0, :, 0]
    np.testing.assert_allclose(counted, [0, 0, 0, 2 * np.pi - 0.25, np.mod(-20.5, 2 * np.pi)], atol=1e-14)
    assert np.all(counted < 2 * np.pi)
    np.testing.assert_allclose(angle.counted(given, 4 * np.pi)[0, 2, 0], 2 * np.pi)
    np.testing.assert_allclose(angle.angle, np.arange(4.0).reshape(1, 1, 4) + 0.5)


def test_a_v12_has_two_distinct_mechanisms():
    found = distinct(mechanisms(ct.Machine(**V12)))
    assert found.mechanisms.names == ("1L", "1R")
    assert found.origin.tolist() == [[0] * 6 + [1] * 6]


def test_distinct_mechanisms_of_designs():
    """Equal rods in different designs are one; a bank in another direction from its master is another."""
    machines = [
        ct.Machine(
            shaft=throws(0, 77),
            bank={
                "L": {"mechanism": slider()},
                "R": {"angle": f"{angle} deg", "mechanism": slave("L", articulation_angle=f"{angle} deg")},
                "Q": {"angle": "10 deg", "mechanism": slider(rod_length=f"{rod} mm")},
            },
        )
        for angle, rod in ((60, 180), (55, 170), (60, 180))
    ]
    found = distinct(mechanisms(*machines))
    assert len(found.mechanisms.names) == 4
    by_design = [[len(set(found.origin[design])), *found.origin[design][[0, 4]]] for design in range(3)]
    assert by_design[0] == by_design[2]
    assert found.origin[0][0] == found.origin[0][4]  # 1L and 1Q are alike
    assert found.origin[1][0] != found.origin[1][4]
    assert found.origin[0][0] == found.origin[1][0]
    assert found.origin[0][2] != found.origin[1][2]


def test_values_of_distinct_mechanisms_go_to_all():
    found = distinct(mechanisms(ct.Machine(**V12)))
    assert found.spread(np.array([[1.0, 2.0]])).tolist() == [[1.0] * 6 + [2.0] * 6]
    own = np.array([[[0.1], [0.2]]])
    nominal = np.radians([0, -240, -120, -120, -240, 0, 60, -180, -60, -60, -180, 60])
    np.testing.assert_allclose(found.angle(own)[0, :, 0] - nominal, [0.1] * 6 + [0.2] * 6, atol=1e-15)


def test_every_mechanism_is_evaluated_in_its_place():
    """Kinds are evaluated together and put back in the order of the file."""
    bank = banks(A=0, C=90) | {"B": {"mechanism": ROCKER}}
    found = mechanisms(ct.Machine(bank={name: bank[name] for name in ("A", "B", "C")}))
    assert found.names == ("1A", "1B", "1C")
    assert [(batch.kind.name, batch.index.tolist()) for batch in found.batches] == [
        ("slider_crank", [0, 2]),
        ("crank_rocker", [1]),
    ]
    phi = np.array([0.0, 0.3, 2.0])
    turned = found.evaluated(lambda motion: motion.pin.x, phi)
    np.testing.assert_allclose(turned.value[0, 2], 0.05 * np.cos(phi - np.pi / 2), atol=1e-16)
    own = np.array([0.0, 1.0, 2.0]).reshape(1, 3, 1)
    each = found.evaluated(lambda motion: motion.pin.x, own).value[0, :, 0]
    assert each == pytest.approx([0.05, 0.1 * np.cos(1), 0.05 * np.cos(2 - np.pi / 2)])
