"""The reduced machine against the reactions of all joints, and against how its file is written."""

import numpy as np
import pytest
from tests.validation.test_drive import CAGE, LOSSY, table

import cranktrain as ct
from cranktrain.questions.reduction.at_angles import reduced_at, reduced_of_each
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.questions.reduction.smooth import smooth_pieces

EXAMPLES = ("tilting_table", "pumping_unit_c57", "shaper", "toggle_press", "gas_compressor", "vaz_21213", "kamaz_740")
FACTS = ("cycle_time", "rms_motor_torque", "rms_static_torque", "drive_fluctuation", "motor_power", "half_period_work")


@pytest.mark.parametrize("name", EXAMPLES)
def test_takes_the_torque_that_all_joints_give(name):
    """At a constant speed: the road through links and their reactions, which knows nothing of polynomials."""
    machine = ct.load(name)
    result = ct.run(machine.with_({"drive": {"stage": [{"ratio": 1}]}}))
    at = reduced_at(next(one for one in result.outcomes if isinstance(one, ReducedMachines)).each[0], _phi(result))
    flywheel = 0.0 if machine.evenness is None else float(machine.evenness.inertia or 0.0)
    inertia = np.sum(np.atleast_2d(result.reduced_inertia), axis=0)
    np.testing.assert_allclose(at.inertia - flywheel, inertia, rtol=0, atol=1e-11 * np.max(at.inertia))
    torque = np.sum(np.atleast_2d(result.driving_torque), axis=0)
    taken = at.taken(np.full(torque.shape, machine.main_shaft.speed.si))
    np.testing.assert_allclose(taken, torque, rtol=0, atol=1e-11 * np.max(np.abs(torque)))


@pytest.mark.parametrize(
    ("load", "taken"),
    [
        ({"torque": "100 N*m"}, 100.0),
        ({"torque": "-100 N*m", "sense": "active"}, 100.0),
        ({"force": "400 N", "along": "250 mm"}, 100.0),
    ],
)
def test_load_on_the_crank_itself(load, taken):
    """It turns at the crank's own rate, 1: a moment is a torque on the crank, and a force one by its arm."""
    result = ct.run(ct.load("tilting_table").with_({"load": {"rub": {"on": "crank", **load}}}))
    np.testing.assert_allclose(result.static_torque[-1], taken, rtol=1e-12)


def _phi(result):
    """φ of the grid. [rad]"""
    from cranktrain.analysis.parts import parts_of
    from cranktrain.layout.crank_angle import CrankAngle

    step = float(result.crank_angle[1] - result.crank_angle[0])
    return parts_of([result.machines[0]], step=np.radians(step))[CrankAngle].angle[0, 0]


def facts(machine, **asked):
    result = ct.run(machine, **asked)
    return {name: np.array(getattr(result, name)) for name in FACTS}


def same(one, other, rtol=1e-11):
    for name in FACTS:
        np.testing.assert_allclose(one[name], other[name], rtol=rtol, atol=1e-12, err_msg=name)


def test_the_step_is_no_matter():
    machine = table(motor=CAGE)
    same(facts(machine, step_degrees=1), facts(machine, step_degrees=7.5), rtol=1e-10)


def test_units_are_no_matter():
    inches = {"mechanism.crank_radius": f"{250 / 25.4!r} in", "drive.motor.breakdown_torque": f"{95 / 9.80665!r} kgf*m"}
    same(facts(table(motor=CAGE)), facts(table(motor=CAGE).with_(inches)))


def test_the_order_of_tables_is_no_matter():
    parts = {"wheel": {"on": 1, "inertia": "3 kg*m^2"}, "coupling": {"inertia": "0.05 kg*m^2"}}
    turned = dict(reversed(parts.items()))
    same(facts(table(motor=CAGE, part=parts)), facts(table(part=turned, motor=dict(reversed(CAGE.items())))))


def test_two_wordings_of_one_drive():
    """GD² or J; a stage of the product of ratios and efficiencies or two of them; a rotor or a part beside it."""
    two = [
        {"ratio": 8, "efficiency": 0.94, "efficiency_back": 0.94},
        {"ratio": 5, "efficiency": 0.9, "efficiency_back": 0.9},
    ]
    one = table(motor={**CAGE, "inertia": "0.08 kg*m^2"})
    part = {"coupling": {"flywheel_moment": "0.24 kg*m^2"}}
    other = ct.load("tilting_table").with_({"drive": {"motor": CAGE, "stage": two, "part": part}})
    found, again = facts(one), facts(other)
    for each in (found, again):
        each["rms_static_torque"] = each["rms_static_torque"][[0, -1]]
    same(found, again)


def test_alone_or_among_designs():
    """A design is computed as it is alone."""
    machines = [table(stage={**LOSSY, "ratio": ratio}, motor=CAGE) for ratio in (40, 42, 38)]
    together = facts(machines)
    for design, machine in enumerate(machines):
        alone = facts(machine)
        same(alone, {name: values[design] for name, values in together.items()})


def test_slopes_of_polynomials_have_hardly_more_rounding_than_values():
    """Of sin²φ: the slope's sum over a turn, which has to vanish, is the work that rounding gives a machine."""
    pieces = smooth_pieces(lambda angle: np.sin(angle)[np.newaxis, np.newaxis] ** 2)[0, :, 0]
    places = np.linspace(-1, 1, 21)
    angle = (np.arange(len(pieces))[:, np.newaxis] + (places + 1) / 2) * 2 * np.pi / len(pieces)
    powers = np.arange(1, pieces.shape[1])
    slope = len(pieces) / np.pi * (pieces[:, 1:] * powers) @ places ** (powers - 1)[:, np.newaxis]
    np.testing.assert_allclose(slope, np.sin(2 * angle), rtol=0, atol=1e-12)
    rise = pieces @ (1.0 - (-1.0) ** np.arange(pieces.shape[1]))
    assert abs(np.sum(rise)) < 1e-14


def test_designs_that_differ_in_their_drives_alone_have_one_machine():
    """And the torque of each is what it is of that machine alone."""
    name, ratio, radius = "tilting_table", "drive.stage[0].ratio", "mechanism.crank_radius"
    machine = ct.load(name)
    longer = {radius: f"{1.01 * machine.mechanism.crank_radius.si!r} m"}
    result = ct.run([machine.with_(one) for one in ({ratio: 40}, {ratio: 30}, {ratio: 40, **longer})])
    each = next(one for one in result.outcomes if isinstance(one, ReducedMachines)).each
    assert each[0] is each[1]
    assert each[0] is not each[2]
    angle = np.stack([_phi(result)] * 3)
    together, which = reduced_of_each(each, angle), [0, 0, 2]
    for design, own in enumerate(which):
        alone = reduced_at(each[own], angle[own])
        np.testing.assert_array_equal(together.inertia[design], alone.inertia)
        np.testing.assert_array_equal(together.load[design], alone.load)
