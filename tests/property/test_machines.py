"""Identities of random machines: derivatives, mirror, bank rotation, superposition of phases, scale."""

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import cranktrain as ct

FEW = settings(max_examples=40, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
EVEN = {"piston_displacement", "piston_acceleration_coefficient", "displacement_by_method"}
ODD = {"piston_velocity_coefficient", "rod_angle", "rod_acceleration_coefficient"}

SERIES = ("piston_displacement", "piston_velocity_coefficient", "piston_acceleration_coefficient")
SERIES += ("rod_angle", "rod_velocity_coefficient", "rod_acceleration_coefficient")
OF_BANK = ("piston_displacement", "piston_acceleration", "rod_angle", "acceleration_coefficient_by_method")

angles = st.integers(-175, 180)
lengths = st.floats(20, 400).map(lambda length: round(length, 3))


@st.composite
def slider_cranks(draw, radius=None):
    """A crank that turns with a closing margin of 8 % or more, of any radius unless its pin has one."""
    radius = draw(lengths) if radius is None else radius
    offset = round(radius * draw(st.sampled_from([0, 0, -0.4, 0.1, 0.7])), 3)
    rod = round((radius + abs(offset)) * draw(st.floats(1.1, 6)), 3)
    return {"kind": "slider_crank", "crank_radius": radius, "rod_length": rod, "offset": offset}


@st.composite
def engines(draw):
    """One to four throws; one or two banks of slider-cranks, perhaps one of articulated rods on the first."""
    throws = [0, *draw(st.lists(angles, max_size=3))]
    master = draw(slider_cranks())
    banks = {"L": {"angle": draw(angles), "mechanism": master}}
    if draw(st.booleans()):
        banks["Q"] = {"angle": draw(angles), "mechanism": draw(slider_cranks(master["crank_radius"]))}
    if draw(st.booleans()):
        gamma = draw(angles)
        knuckle = round(master["crank_radius"] * draw(st.floats(0.3, 1.1)), 3)
        banks["R"] = {
            "angle": banks["L"]["angle"] + gamma,
            "mechanism": {
                "kind": "articulated_rod",
                "master": "L",
                "knuckle_radius": knuckle,
                "rod_length": round((master["crank_radius"] + knuckle) * draw(st.floats(1.15, 4)), 3),
                "articulation_angle": gamma + draw(st.integers(-15, 15)),
                "offset": draw(st.sampled_from([0, 0, 2])),
            },
        }
    return {"throws": throws, "banks": banks, "running": draw(st.sampled_from(["ahead", "astern"]))}


def machine(engine, *, turned=0.0, mirrored=False, scale=1.0):
    """The engine as a machine: all banks turned, or the same metal drawn as its mirror image, or larger."""
    sign = -1 if mirrored else 1

    def written(name, value):
        if not isinstance(value, int | float):
            return value
        if name == "articulation_angle":
            return f"{sign * value} deg"
        return f"{value * scale * (sign if name == 'offset' else 1)!r} mm"

    return ct.Machine(
        running=engine["running"],
        shaft={"main": {"throws": [f"{sign * angle} deg" for angle in engine["throws"]], "speed": "600 rpm"}},
        bank={
            name: {
                "angle": f"{sign * bank['angle'] + turned!r} deg",
                "mechanism": {field: written(field, value) for field, value in bank["mechanism"].items()},
            }
            for name, bank in engine["banks"].items()
        },
    )


def assert_close(one, other, names, *, rtol=0.0, sign=1.0, reverse=False):
    for name in names:
        left, right = getattr(one, name), sign * getattr(other, name)
        if reverse:
            right = np.roll(right[..., ::-1], 1, axis=-1)
        scale = np.nanmax(np.abs(right)) if np.any(np.isfinite(right)) else 1.0
        np.testing.assert_allclose(left, right, rtol=rtol, atol=2e-11 * max(scale, 1e-4), err_msg=name)


def curves(result):
    return [name for name, entry in result.catalogue.items() if not entry.is_fact]


def facts(result, *units):
    return [name for name, fact in result.facts.items() if fact.entry.unit in units]


@FEW
@given(engines())
def test_derivatives_are_those_of_the_fourier_series(engine):
    """x′ and x″, θ′ and θ″ against series that know no mechanism."""
    result = ct.run(machine(engine), step_degrees=0.5, quantities=SERIES)
    order = 1j * np.fft.rfftfreq(720, 1 / 720)
    order[-1] = 0
    for value, first in (
        ("piston_displacement", "piston_velocity_coefficient"),
        ("piston_velocity_coefficient", "piston_acceleration_coefficient"),
        ("rod_angle", "rod_velocity_coefficient"),
        ("rod_velocity_coefficient", "rod_acceleration_coefficient"),
    ):
        found = np.fft.irfft(order * np.fft.rfft(getattr(result, value), axis=-1), 720, axis=-1)
        expected = getattr(result, first)
        np.testing.assert_allclose(found, expected, atol=1e-9 * np.max(np.abs(expected)), err_msg=first)


@FEW
@given(engines(), st.integers(-200_000, 200_000).map(lambda mills: mills / 1000))
def test_turning_all_banks_changes_nothing(engine, turned):
    """Only angles between banks count: φ begins at the first bank."""
    one, other = (ct.run(machine(engine, turned=angle)) for angle in (0.0, turned))
    assert all(check.passed.all() for result in (one, other) for check in result.checks)
    assert_close(one, other, curves(one))
    assert_close(one, other, facts(one, "m", "m/s", "m/s^2", "1", "rad"))
    for name in facts(one, "deg"):
        difference = np.exp(1j * np.radians(getattr(one, name))) - np.exp(1j * np.radians(getattr(other, name)))
        allowed = 1e-6 if name.endswith("_at") or name == "closing_angle" else 1e-11
        assert np.nanmax(np.abs(difference), initial=0.0) < allowed, name


@FEW
@given(engines())
def test_mirrored_metal_runs_as_the_other_way_round(engine):
    """Drawn as its mirror image, the machine does ahead what the drawing itself does astern."""
    other = engine | {"running": "ahead" if engine["running"] == "astern" else "astern"}
    one, mirror = ct.run(machine(engine)), ct.run(machine(other, mirrored=True))
    assert_close(one, mirror, curves(one))
    assert_close(one, mirror, facts(one, "m", "m/s", "m/s^2", "1", "rad"))


@FEW
@given(engines())
def test_astern_is_the_motion_of_minus_phi(engine):
    ahead, astern = (
        ct.run(machine(engine | {"running": running}), quantities=EVEN | ODD) for running in ("ahead", "astern")
    )
    assert_close(ahead, astern, EVEN, reverse=True)
    assert_close(ahead, astern, ODD, sign=-1.0, reverse=True)


@FEW
@given(engines(), st.sampled_from([0.01, 7.0, 1000.0]))
def test_twice_as_large_moves_twice_as_far(engine, scale):
    """Lengths scale, angles and ratios do not."""
    one, large = ct.run(machine(engine)), ct.run(machine(engine, scale=scale))
    for name, entry in one.catalogue.items():
        if entry.unit.split("/")[0] == "m":
            np.testing.assert_allclose(
                getattr(large, name) / scale,
                getattr(one, name),
                atol=1e-10 * max(1e-3, np.nanmax(np.abs(getattr(one, name)))),
                err_msg=name,
            )
    assert_close(one, large, facts(one, "1", "rad"))


@FEW
@given(engines())
def test_pistons_of_a_bank_are_one_motion_at_other_phases(engine):
    """A throw that stands ahead by whole degrees shifts the curve by as many places of the grid."""
    result = ct.run(machine(engine), quantities=OF_BANK)
    ahead = 1 if engine["running"] == "ahead" else -1
    for bank in engine["banks"]:
        suffix = bank if len(engine["banks"]) > 1 else ""
        for place, angle in enumerate(engine["throws"], start=1):
            for name in OF_BANK:
                of_piston = {
                    piston: getattr(result, name)[..., i, :] for i, piston in enumerate(result.labels["piston"])
                }
                first, other = of_piston[f"1{suffix}"], of_piston[f"{place}{suffix}"]
                scale = np.nanmax(np.abs(first))
                np.testing.assert_allclose(
                    other, np.roll(first, -ahead * angle, axis=-1), atol=1e-11 * scale, err_msg=name
                )
