"""No fact depends on the steps of the curves, on units, on the order of tables, on wordings, or on running alone.

Two runs of one machine that are told apart only by how it is said are compared, fact by fact; neither is expected to be
right here, which is what tests/validation is for.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.analysis import Stage
from cranktrain.analysis.run import run
from cranktrain.analysis.stages import every_stage
from cranktrain.io.examples import example_names
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.motion import Array
from cranktrain.quantities import shown
from cranktrain.record import record
from cranktrain.saying.catalogue import entries, quantity
from cranktrain.saying.checks import StageResult

GAS = {
    "kind": "dual",
    "start_pressure": "105 kPa",
    "compression_exponent": 1.36,
    "expansion_exponent": 1.27,
    "pressure_ratio": 1.5,
    "cut_off_ratio": 1.4,
    "inlet_pressure": "100 kPa",
    "exhaust_pressure": "112 kPa",
}


def machines(seed: int) -> dict[str, Any]:
    """A machine file as a mapping, of one of four sorts, with random lengths."""
    rng = np.random.default_rng(seed)

    def mm(low: float, high: float) -> str:
        return f"{round(float(rng.uniform(low, high)), 3)!r} mm"

    radius = round(float(rng.uniform(30, 60)), 3)
    rod = round(radius * float(rng.uniform(3, 5)), 3)
    mechanism = {"kind": "slider_crank", "crank_radius": f"{radius!r} mm", "rod_length": f"{rod!r} mm"}
    masses = {
        "piston": {"mass": f"{rng.uniform(0.3, 2)!r} kg"},
        "rod": {"mass": f"{rng.uniform(0.3, 2)!r} kg", "along": f"{0.3 * rod!r} mm", "inertia": "0.006 kg·m²"},
    }
    evenness = {"flywheel": "1.5 kg·m²", "coefficient": 0.02}
    speed = {"speed": f"{round(float(rng.uniform(300, 3000)))} rpm"}
    engine = {"bore": mm(60, 110), "compression_ratio": round(float(rng.uniform(7, 18)), 3), "cycle": "four-stroke"}
    common = {"masses": masses, "evenness": evenness}
    if seed % 4 == 0:
        # An in-line four whose torque has kinks and jumps between points of any grid.
        throws = ["0 deg", "180 deg", "180 deg", "0 deg"]
        return {
            "shaft": {"main": {"throws": throws, "spacing": "110 mm", **speed}},
            "bank": {"A": {"mechanism": mechanism}},
            "cylinder": {**engine, "firing_order": "1-3-4-2"},
            "gas": GAS,
            **common,
        }
    if seed % 4 == 1:
        slave = {
            "kind": "articulated_rod",
            "master": "L",
            "knuckle_radius": f"{0.3 * rod!r} mm",
            "rod_length": f"{0.72 * rod!r} mm",
            "articulation_angle": "52 deg",
        }
        return {
            "shaft": {"main": speed},
            "bank": {"L": {"angle": "-25 deg", "mechanism": mechanism}, "R": {"angle": "25 deg", "mechanism": slave}},
            "cylinder": {**engine, "firing_order": "1L-1R"},
            "gas": {**GAS, "kind": "otto", "cut_off_ratio": None},
            **common,
        }
    if seed % 4 == 2:
        # Offset, with friction and weight.
        return {
            "shaft": {"main": speed},
            "mechanism": {**mechanism, "offset": mm(2, 12)},
            "masses": masses,
            "friction": {"piston": 0.08},
            "gravity": True,
            "evenness": {"flywheel": "40 kg·m²"},
        }
    return {
        "shaft": {"main": speed},
        "mechanism": {
            "kind": "crank_rocker",
            "crank_radius": f"{radius!r} mm",
            "rod_length": f"{3.3 * radius!r} mm",
            "rocker_length": f"{2.6 * radius!r} mm",
            "ground_length": f"{3.7 * radius!r} mm",
        },
        "masses": {"rocker": {"mass": "3 kg", "along": f"{radius!r} mm", "inertia": "0.02 kg·m²"}},
        "evenness": {"flywheel": "4 kg·m²"},
    }


def without_none(table: Any) -> Any:
    """Leave out what is None."""
    if isinstance(table, Mapping):
        return {key: without_none(value) for key, value in table.items() if value is not None}
    return table


def changed(table: Any, change: Any) -> Any:
    """Apply a change to every text of a table."""
    if isinstance(table, Mapping):
        return {key: changed(value, change) for key, value in table.items()}
    if isinstance(table, list):
        return [changed(value, change) for value in table]
    return change(table) if isinstance(table, str) else table


def other_units(text: str) -> str:
    """The same quantity in another unit, to the last digit that a number holds."""
    factors = {"mm": (1 / 25.4, "in"), "rpm": (np.pi / 30, "rad/s"), "deg": (np.pi / 180, "rad"), "kPa": (0.01, "bar")}
    number, _space, unit = text.partition(" ")
    if unit not in factors:
        return text
    factor, name = factors[unit]
    return f"{float(number) * factor!r} {name}"


def backward(table: Any) -> Any:
    """Tables and keys in the opposite order; banks keep theirs, the first of which has a meaning."""
    if not isinstance(table, Mapping):
        return table
    return {key: value if key == "bank" else backward(value) for key, value in reversed(table.items())}


def by_stroke(table: dict[str, Any]) -> dict[str, Any]:
    """Stroke and λ for crank radius and rod length, where there is no offset."""
    mechanism = table.get("mechanism") or next(iter(table["bank"].values()))["mechanism"]
    if mechanism["kind"] != "slider_crank" or "offset" in mechanism:
        pytest.skip("has no other wording")
    radius = float(mechanism.pop("crank_radius").split()[0])
    mechanism["stroke"] = f"{2 * radius!r} mm"
    return table


def same(one: ct.Result, other: ct.Result, *, design: int | None = None) -> None:
    """Compare all facts: to 1e-9 of their scale, angles of extremes to 1e-6 rad, roots of evenness to 1e-6."""
    assert set(one.facts) == set(other.facts)
    for name, fact in one.facts.items():
        expected, found = fact.value, other.facts[name].value
        found = found if design is None else found[design]
        if name.endswith("_at") or fact.entry.unit == "deg":
            off = np.mod(found - expected + 180, 360) - 180
            assert np.all((np.abs(off) <= np.degrees(1e-6)) | (np.isnan(found) & np.isnan(expected))), name
            continue
        scale = np.max(np.nan_to_num(np.abs(expected)), initial=0.0)
        if "direction" in name:
            scale, limit = 1.0, 1e-6
        else:
            limit = 1e-6 if "flywheel" in name or "fluctuation" in name else 1e-9
        np.testing.assert_allclose(found, expected, rtol=0, atol=limit * scale + 1e-13, err_msg=name)


STEPS = (0.1, 360 / 514, 1, 5, 7.5, 30)
BETWEEN = 7.5
"""No whole number of degrees: curves of this step are computed for it, and then thinned out."""


def steps_of(name):
    """One example at all of them; the others at the one with which everything is done that a step has done."""
    return STEPS if name == "vaz_21213" else (BETWEEN,)


@pytest.mark.parametrize("name", example_names())
def test_examples_do_not_depend_on_the_step(name):
    """Facts of all steps are the same to the last bit."""
    machine = ct.load(name)
    fine = ct.run(machine)
    for step in steps_of(name):
        found = ct.run(machine, step_degrees=step)
        assert found.crank_angle.size == round(shown(found.grid.cycle, "deg") / step)
        for fact, (_entry, expected) in fine.facts.items():
            np.testing.assert_array_equal(found.facts[fact].value, expected, err_msg=f"{fact} at {step}°")


@record
class Seen(StageResult):
    """On what grid a stage was asked: of its fact, and of its curve."""

    n_of_fact: Array = quantity("n", "1", (), "Points", "docs/conventions", "definition")
    n_of_curve: Array = quantity("n", "1", ("crank_angle",), "Points", "docs/conventions", "definition")


def seen(grid: CrankAngle) -> Seen:
    n_points = float(grid.shown.size)
    return Seen(np.array([n_points]), np.full((1, grid.shown.size), n_points))


@pytest.mark.parametrize("step", STEPS)
def test_facts_are_of_one_grid(step):
    """Whatever the stage and the machine, facts come of what a stage gives on the grid of 1°, however curves stand."""
    for name, turns in (("shaper", 1), ("vaz_21213", 2)):
        result = run(ct.load(name), step_degrees=step, stages=[Stage(seen)])
        assert result.n_of_fact == 360 * turns
        every = np.ceil(step)
        assert result.n_of_curve.shape == (round(360 * turns / step),)
        np.testing.assert_array_equal(result.n_of_curve, round(360 * turns * every / step))


@pytest.mark.parametrize("stage", every_stage(), ids=lambda stage: stage.gives.__name__)
def test_no_field_holds_facts_and_curves(stage):
    """A field of curves is taken whole from the curves' grid."""
    facts, curves = (
        {entry.path.partition(".")[0] for entry in entries(stage.gives) if entry.is_fact is is_fact}
        for is_fact in (True, False)
    )
    assert not facts & curves


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("wording", [other_units, backward, by_stroke])
def test_wordings(seed, wording):
    table = without_none(machines(seed))
    said = changed(table, other_units) if wording is other_units else wording(without_none(machines(seed)))
    same(ct.run(ct.Machine(**table)), ct.run(ct.Machine(**said)))


@pytest.mark.parametrize("seed", range(8))
def test_alone_or_among_many(seed):
    """Beside a machine of the same sort with other lengths, in both places."""
    machine, other = (ct.Machine(**without_none(machines(one))) for one in (seed, seed + 4))
    alone = ct.run(machine)
    same(alone, ct.run([machine, other]), design=0)
    same(alone, ct.run([other, machine]), design=1)


@pytest.mark.parametrize("seed", [0, 2])
def test_the_zero_of_the_crank_angle_moves_angles_only(seed):
    table = without_none(machines(seed))
    moves_angles_only(ct.Machine(**table))


AT_WHOLE_DEGREES = (
    "side_force_formula_error",
    "tangential_force_formula_error",
    "side_force_error",
    "driving_torque_error",
)
"""What a textbook's form is off by, at most, at degrees as they are shown."""
WEIGHED = {path.name: path for path in sorted((Path(__file__).parents[2] / "benchmarks" / "weighed").glob("*.toml"))}
SAID_BY_SHOWN_ANGLES = {
    "40d": "angles of firing",
    "high_slip_press": "the angle of the command to stop",
    "servo_press": "the angles of a rest; forces that jump where it begins are sampled for the shaking",
    "everything.toml": "a load over the crank angle",
    "eccentric.toml": "a speed over the crank angle",
    "slotted_lever.toml": "a load over the crank angle",
    "slider_crank.toml": "angles of firing",
}
"""What is said of these machines by the crank angle that is shown goes with its zero."""


@pytest.mark.parametrize("name", [name for name in (*example_names(), *WEIGHED) if name not in SAID_BY_SHOWN_ANGLES])
def test_the_zero_of_the_crank_angle_moves_angles_only_of_examples(name):
    """Neither where the grid's points lie on the machine: no peak hides between them, no mean depends on them."""
    moves_angles_only(ct.load(WEIGHED.get(name, name)))


def moves_angles_only(machine: ct.Machine) -> None:
    plain, moved = ct.run(machine), ct.run(machine.with_({"crank_zero": "37.3 deg"}))
    for name, (entry, values) in plain.facts.items():
        if entry.unit == "deg" or "phase" in name or "direction" in name or name in AT_WHOLE_DEGREES:
            continue
        # Which half period is the first goes with the zero.
        in_order = np.sort if "half_period" in entry.dimensions else np.asarray
        expected, found = in_order(values), in_order(moved.facts[name].value)
        scale = np.max(np.nan_to_num(np.abs(expected)), initial=0.0)
        limit = 1e-6 if any(word in name for word in ("flywheel", "fluctuation", "speed", "excess")) else 1e-9
        # What cancels is measured by what is left of more.
        limit = 1e-7 if name.startswith("shaking_") else limit
        np.testing.assert_allclose(found, expected, rtol=0, atol=limit * scale + 1e-13, err_msg=name)
