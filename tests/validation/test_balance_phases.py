"""At which crank angle an order of the shaking force or couple is largest: by hand, and by the curves."""

import numpy as np
import pytest

import cranktrain as ct

SLIDER = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "150 mm"}


def single(angle, **machine):
    return ct.run(
        ct.Machine(
            bank={"line": {"angle": f"{angle} deg", "mechanism": SLIDER}},
            shaft={"main": {"speed": "1500 rpm"}},
            masses={"piston": {"mass": "1 kg"}},
            **machine,
        )
    )


@pytest.mark.parametrize("angle", [0, 30, 75])
def test_a_single_cylinder_pulls_hardest_where_its_piston_turns_back(angle):
    """Orders 1 and 2 of R(cos φ + λ cos 2φ + …) both pull along the cylinder at its top dead centre."""
    result = single(angle, crank_zero="Y")
    for order in (0, 1):
        assert np.degrees(result.shaking_force_direction[0, order]) == pytest.approx(angle, abs=1e-9)
        assert result.shaking_force_phase[0, order] == pytest.approx(angle, abs=1e-9)


@pytest.mark.parametrize(
    "machine",
    [
        {"rotation": "clockwise"},
        {"rotation": "anticlockwise"},
        {"running": "astern"},
        {"rotation": "anticlockwise", "running": "astern", "crank_zero": "Y"},
    ],
    ids=str,
)
@pytest.mark.parametrize("of", ["force", "couple"])
def test_curves_are_largest_there_in_that_direction(machine, of):
    """A 90° vee on three unlike throws: the order of the curve, at the angle that is told, is its largest size."""
    result = ct.run(
        ct.Machine(
            bank={
                "L": {"angle": "-20 deg", "mechanism": SLIDER},
                "R": {"angle": "70 deg", "mechanism": SLIDER, "stagger": "20 mm"},
            },
            shaft={"main": {"speed": "1500 rpm", "throws": ["0 deg", "100 deg", "250 deg"], "spacing": "100 mm"}},
            masses={"piston": {"mass": "1 kg"}, "rod": {"mass": "1.2 kg", "along": "50 mm"}},
            **machine,
        )
    )
    phi = np.radians(result.crank_angle)
    x, y = (getattr(result, f"shaking_{of}_{axis}")[0] for axis in "xy")
    largest, direction, phase = (
        getattr(result, f"shaking_{of}_{name}")[0] for name in ("largest", "direction", "phase")
    )
    clockwise = -1.0 if machine.get("rotation") == "anticlockwise" else 1.0
    seen = 0
    for place, name in enumerate(result.labels["order"]):
        if not np.isfinite(phase[place]) or largest[place] < 1e-6 * np.max(largest):
            continue
        seen += 1
        order, at = float(name), np.radians(phase[place])
        own = [2 * np.mean(curve * np.exp(-1j * order * phi)) * np.exp(1j * order * at) for curve in (x, y)]
        across, up = own[0].real, own[1].real
        assert np.hypot(across, up) == pytest.approx(largest[place], rel=1e-9)
        told = direction[place]
        assert clockwise * across == pytest.approx(largest[place] * np.sin(told), abs=1e-8 * np.max(largest))
        assert up == pytest.approx(largest[place] * np.cos(told), abs=1e-8 * np.max(largest))
        assert 0 <= phase[place] < 360 / order + 1e-9
    assert seen >= 2
