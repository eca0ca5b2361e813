"""A counterweight of a pumping unit as a load and as the body of the crank: one torque of the gearbox."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from tests.sentences import CRANK_WEIGHTLESS
from tests.told import texts_of

import cranktrain as ct
from cranktrain.io.machine_file import read_machine
from cranktrain.synthesis.counterbalance import counterbalance

POUND, G = 0.45359237, 9.80665
FORCE = 5392.002  # lbf: the pounds that weigh so much
BODY = {"mass": f"{FORCE * POUND!r} kg", "along": "32 in", "inertia": "0 kg*m^2"}
NAMES = (
    "gearbox_torque",
    "counterbalance_torque",
    "counterbalance_moment",
    "weights_phase",
    "upstroke_peak",
    "downstroke_peak",
    "equal_peaks_moment",
    "least_rms_moment",
    "mean_gearbox_torque",
    "rms_gearbox_torque",
    "torque_share",
)


def tables(**changes):
    """Those of the example, its counterbalance left out, with others; the order of tables as given."""
    given = read_machine("pumping_unit_c57").machine.model_dump(exclude_unset=True)
    given["load"] = {name: load for name, load in given["load"].items() if name != "counterbalance"}
    given["pumping"] = {key: one for key, one in given["pumping"].items() if key != "counterbalance"}
    return given | changes


def same(one, other, tolerance=1e-12):
    for name in NAMES:
        first, second = (np.asarray(getattr(result, name)) for result in (one, other))
        size = max(float(np.max(np.abs(first))), 1.0 if name == "weights_phase" else 0.0)
        assert_allclose(second, first, rtol=0, atol=tolerance * size, err_msg=name)


def test_a_body_is_the_weight_that_it_has():
    loaded = ct.run("pumping_unit_c57", set={"load.counterbalance.across": "4 in"})
    body = ct.run(ct.Machine(**tables(masses={"crank": BODY | {"across": "4 in"}}, gravity=True)))
    same(loaded, body)
    assert float(np.asarray(body.weights_phase)) == pytest.approx(np.degrees(np.arctan2(4, 32)), rel=1e-12)


def test_in_any_order_of_tables():
    own = tables(masses={"crank": BODY}, gravity=True)
    one, other = (ct.run(ct.Machine(**dict(items))) for items in (own.items(), reversed(own.items())))
    same(one, other, 0.0)


def test_half_as_a_load_and_half_as_a_body():
    half = BODY | {"mass": f"{FORCE / 2 * POUND!r} kg"}
    machine = {"masses.crank": half, "gravity": True, "load.counterbalance.force": f"{FORCE / 2!r} lbf"}
    same(ct.run("pumping_unit_c57"), ct.run("pumping_unit_c57", set=machine))


def test_it_does_no_work():
    """∮T dφ is the card's area whatever the crank weighs, (28.6)."""
    found = ct.run(ct.Machine(**tables(masses={"crank": BODY}, gravity=True)))
    assert_allclose(found.mean_gearbox_torque * 2 * np.pi, found.card_work, rtol=1e-9)


@pytest.mark.parametrize("changes", [{"gravity": False}, {"masses": {"crank": BODY | {"along": "0 in"}}}])
def test_what_does_not_pull_does_not_count(changes):
    plain = ct.run(ct.Machine(**tables()))
    found = ct.run(ct.Machine(**tables(**({"masses": {"crank": BODY}, "gravity": True} | changes))))
    np.testing.assert_array_equal(found.gearbox_torque, plain.gearbox_torque)
    assert np.isnan(np.asarray(found.counterbalance_moment)).all()


def test_two_weights_ahead_and_behind_add_as_vectors():
    """Of 1000 lbf at 90° ahead and 2000 lbf in the pin's line, both at 20 in: √5 · 1000 lbf · 20 in at atan ½."""
    load = {"load.counterbalance.force": "2000 lbf", "load.counterbalance.along": "20 in", "gravity": True}
    body = {"mass": f"{1000 * POUND!r} kg", "along": "0 in", "across": "20 in", "inertia": "0 kg*m^2"}
    found = ct.run("pumping_unit_c57", set=load | {"masses.crank": body})
    moment = np.sqrt(5) * 1000 * POUND * G * 20 * 0.0254
    assert_allclose(found.counterbalance_moment, moment, rtol=1e-12)
    assert_allclose(found.weights_phase, np.degrees(np.arctan2(1, 2)), rtol=1e-12)
    assert_allclose(np.max(np.abs(found.counterbalance_torque)), moment, rtol=2e-4)  # the grid is of 1°


def test_a_force_alone_is_not_sought_beside_a_body():
    with pytest.raises(ct.InputError, match="is not all of the counterbalance"):
        counterbalance(read_machine("pumping_unit_c57").machine.with_({"masses.crank": BODY, "gravity": True}))


@pytest.mark.parametrize("changes", [{}, {"gravity": True}, {"masses": {"crank": BODY | {"along": "0 in"}}}])
def test_a_body_without_gravity_is_told(changes):
    """Not where it has weight, nor where it stands in balance."""
    flags = texts_of(ct.run(ct.Machine(**tables(**({"masses": {"crank": BODY}} | changes)))).flags)
    assert any(CRANK_WEIGHTLESS in flag for flag in flags) == (not changes)
