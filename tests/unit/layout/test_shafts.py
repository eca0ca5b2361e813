"""More shafts than one: each turns by ratio·φ + phase; all angles of the file count in the normal sense of `main`."""

import numpy as np
import pytest
from tests.machines import slave
from tests.sentences import ONE_OF_SHAFTS

import cranktrain as ct
from cranktrain.layout.frames import frame_of, in_machine_axes
from cranktrain.plans.placement import first_throw

R, L, E = 0.05, 0.18, 0.008
MECHANISM = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm", "offset": "8 mm"}
POINT = {"link": "rod", "along": "60 mm", "across": "20 mm"}


def machine(ratio=1, phase="0 deg", **options):
    return ct.Machine(
        shaft={
            "main": {"throws": ["0 deg", "180 deg"], "speed": "1000 rpm", "spacing": "100 mm"},
            "second": {"throws": ["0 deg", "90 deg"], "ratio": ratio, "phase": phase, "spacing": "70 mm"},
        },
        bank={
            "A": {"angle": "-10 deg", "mechanism": MECHANISM},
            "B": {"angle": "20 deg", "shaft": "second", "mechanism": MECHANISM | {"points": {"p": POINT}}},
        },
        **options,
    )


def by_hand(shown, ratio, phase, sense):
    """Distance from shaft to piston 2B: its crank, in the file's sense, stands at α from the cylinder's axis."""
    alpha = ratio * sense * shown + np.deg2rad(phase + 90 - 0 - (20 - -10))
    return R * np.cos(alpha) + np.sqrt(L**2 - (R * np.sin(alpha) - E) ** 2)


@pytest.mark.parametrize("running", ["ahead", "astern"])
@pytest.mark.parametrize(("ratio", "phase"), [(1, 0), (1, 35), (-1, 0), (-1, -50)])
def test_piston_on_the_second_shaft(ratio, phase, running):
    result = ct.run(machine(ratio, f"{phase} deg", running=running))
    phi = np.deg2rad(result.crank_angle)
    top = np.sqrt((R + L) ** 2 - E**2)
    expected = top - by_hand(phi, ratio, phase, -1.0 if running == "astern" else 1.0)
    np.testing.assert_allclose(result.piston_displacement[3], expected, rtol=0, atol=1e-15)
    slope = np.gradient(expected, phi)
    np.testing.assert_allclose(result.piston_velocity_coefficient[3, 1:-1], slope[1:-1], atol=1e-5)


@pytest.mark.parametrize("running", ["ahead", "astern"])
def test_true_dead_centre_of_a_shaft_that_turns_the_other_way(running):
    """s is largest where sin α = e/(L + R), α as above."""
    sense = -1.0 if running == "astern" else 1.0
    result = ct.run(machine(-1, "35 deg", running=running))
    alpha = np.degrees(np.arcsin(E / (L + R)))
    expected = (alpha - (35 + 90 - 30)) / (-1 * sense) % 360
    assert result.top_dead_centre[3] == pytest.approx(expected, abs=1e-12)
    assert result.top_shift[3] == pytest.approx(-sense * alpha, abs=1e-12)


@pytest.mark.parametrize("ratio", [1, -1])
def test_metal_stands_where_it_stands(ratio):
    """Crank pin and followed point of 1B in machine axes, at φ = 0: clockwise from Y, whichever way the shaft turns."""
    two = machine(ratio, "35 deg", crank_zero="0 deg")
    place = two.places[2]
    frame = frame_of(place, two.orientation)
    motion = place.kind.motion(np.array([place.phase]), place.geometry)
    right, up = in_machine_axes(motion.pin.x.value, motion.pin.y.value, frame)
    direction = np.deg2rad(-10 + 35)
    assert (right[0], up[0]) == pytest.approx((R * np.sin(direction), R * np.cos(direction)), abs=1e-15)
    result = ct.run(two)
    point = in_machine_axes(result.point_x[0, :1], result.point_y[0, :1], frame)
    still = ct.run(machine(1, "35 deg"))
    expected = in_machine_axes(
        still.point_x[0, :1],
        still.point_y[0, :1],
        frame_of(machine(1, "35 deg").places[2], two.orientation),
    )
    np.testing.assert_allclose(point, expected, rtol=0, atol=1e-15)


def test_each_shaft_has_its_own_spacing():
    assert ct.run(machine()).axial_position == pytest.approx([0, 0.1, 0, 0.07])


def test_only_the_main_shaft_is_drawn():
    assert [place.name for place in first_throw(machine())] == ["1A"]


@pytest.mark.parametrize(
    ("shafts", "bank", "path", "said"),
    [
        ({"mian": {}}, {}, "shaft.mian", "carries no bank"),
        ({"b": {"speed": "3 rpm"}}, {"shaft": "b"}, "shaft.b.speed", "must stand in [shaft.main]"),
        ({"main": {"ratio": -1}}, {}, "shaft.main.ratio", "for another shaft"),
        ({"main": {"phase": "3 deg"}}, {}, "shaft.main.phase", "for another shaft"),
        ({"b": {"ratio": 2}}, {"shaft": "b"}, "shaft.b.ratio", "must be one of: 1, -1"),
        ({}, {"shaft": "upper"}, "bank.A.shaft", f"{ONE_OF_SHAFTS}: main"),
    ],
)
def test_refused(shafts, bank, path, said):
    with pytest.raises(ct.InputError) as caught:
        ct.run(ct.Machine(shaft=shafts, bank={"A": {"mechanism": MECHANISM, **bank}}))
    (problem,) = caught.value.problems
    assert problem.path == path
    assert said in str(problem.allowed)


def test_slave_finds_its_master_on_its_own_shaft_only():
    with pytest.raises(ct.InputError) as caught:
        ct.run(
            ct.Machine(
                shaft={"b": {}},
                bank={"A": {"mechanism": MECHANISM}, "B": {"shaft": "b", "mechanism": slave("A")}},
            )
        )
    assert "must have one slider-crank on throw 1" in str(caught.value.problems[0].allowed)
