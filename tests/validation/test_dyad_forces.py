"""Dyads with real links, off-line centroids, gravity, friction and acceleration, by a 60-digit multibody solver.

The same numbers came out of closed forms and of the balance of energy, to 4e-16.
"""

import json

import numpy as np
import pytest
from tests.reference_case import GOLDEN
from tests.virtual_work import torque_of_work

from cranktrain.linkage import Crank, Ends, Pin, PinMotion, crank, fixed, pin
from cranktrain.linkage.forces import (
    Body,
    Conditions,
    Drive,
    Friction,
    Gravity,
    PinLoads,
    Wrench,
    added,
    borne,
    crank_link,
    crank_reactions,
    handed_back,
    pin_reactions,
)
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.on_crank import force_on_slider
from cranktrain.mechanisms.slider_crank.forces import (
    DYNAMICS,
    slider_crank_forces,
)
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank

CASE = json.loads((GOLDEN / "dyad_forces/dyad_forces.json").read_text(encoding="utf-8"))
RRP, RRR = CASE["rrp"]["parameters"], CASE["rrr"]["parameters"]
CLOSE = 2e-15
"""Of the largest force or torque of a row; the numbers have 16 digits."""


def slider_crank_at(phi):
    geometry = SliderCrank(RRP["R"], RRP["L"], RRP["e"])
    bodies = (
        Body(RRP["m_c"], RRP["crk_u"], RRP["crk_w"], RRP["I_c"]),
        Body(RRP["m_r"], RRP["rod_u"], RRP["rod_w"], RRP["I_r"]),
        Body(RRP["m_s"], 0.0, 0.0, 0.0),
    )
    motion = slider_crank(np.deg2rad(phi), geometry)
    return motion, geometry, bodies, force_on_slider(motion, geometry, -RRP["P"])


@pytest.mark.parametrize("row", CASE["rrp"]["rows"], ids=lambda row: f"{row['phi_deg']}, {row['mu']}")
def test_slider_crank(row):
    motion, geometry, bodies, load = slider_crank_at(row["phi_deg"])
    friction = Friction(row["mu"], np.sign(motion.slider.first))
    conditions = Conditions(Drive(CASE["rrp"]["omega"], CASE["rrp"]["epsilon"]), Gravity(*RRP["g"]), (friction,))
    forces = slider_crank_forces(motion, geometry, bodies, load, conditions)
    joints = DYNAMICS.by_joint(forces.joints)
    got = [
        *joints["crank_pin"][:2],
        *joints["wrist_pin"][:2],
        *joints["main_bearing"][:2],
        joints["guide"].y,
        joints["guide"].x,
    ]
    expected = [*row["FA"], *row["FB"], *row["FO"], row["N"], row["f"]]
    np.testing.assert_allclose(got, expected, rtol=0, atol=CLOSE * np.max(np.abs(expected)))
    by_work = torque_of_work(KINDS.named("slider_crank").dynamics, motion, geometry, bodies, load, conditions, forces)
    torques = [forces.driving_torque, by_work]
    np.testing.assert_allclose(torques, row["M"], rtol=CLOSE)


@pytest.mark.parametrize("row", CASE["rrp"]["reduced_inertia"], ids=lambda row: str(row["phi_deg"]))
def test_reduced_inertia(row):
    inertia = DYNAMICS.reduced(*slider_crank_at(row["phi_deg"]), Gravity(0.0, 0.0)).inertia
    np.testing.assert_allclose(inertia.value, row["J"], rtol=CLOSE)
    np.testing.assert_allclose(inertia.first, row["dJ"], rtol=CLOSE, atol=CLOSE * row["J"])


@pytest.mark.parametrize("row", CASE["rrr"]["rows"], ids=lambda row: str(row["phi_deg"]))
def test_rod_and_rocker(row):
    """The pivot lies anywhere."""
    geometry = Pin(RRR["L"], RRR["r1"], float(row["branch_B_side_of_AC"]))
    crank_pin = crank(np.deg2rad(row["phi_deg"]), Crank(RRR["R"]))
    motion: PinMotion = pin(Ends(crank_pin, fixed(*RRR["C"])), geometry)
    conditions = Conditions(Drive(CASE["rrr"]["omega"], CASE["rrr"]["epsilon"]), Gravity(*RRR["g"]), ())
    nothing = Wrench(0.0, 0.0, 0.0)
    on_rod = borne(motion.rod, Body(RRR["m_r"], RRR["rod_u"], RRR["rod_w"], RRR["I_r"]), nothing, conditions)
    rocker = Body(RRR["m_k"], RRR["rk_u"], RRR["rk_w"], RRR["I_k"])
    on_rocker = borne(motion.rocker, rocker, Wrench(0.0, 0.0, RRR["M3"]), conditions)
    found = pin_reactions(motion, geometry, PinLoads(on_rod, on_rocker))
    link = crank_link(crank_pin, Crank(RRR["R"]))
    on_crank = borne(link, Body(RRR["m_c"], RRR["crk_u"], RRR["crk_w"], RRR["I_c"]), nothing, conditions)
    shaft = crank_reactions(added(on_crank, handed_back(link, crank_pin, found.rod)))
    got = [*found.rod[:2], -found.joint.x, -found.joint.y, *found.rocker[:2], *shaft.bearing[:2]]
    expected = [*row["FA"], *row["FB_on_rod"], *row["FC"], *row["FO"]]
    np.testing.assert_allclose(got, expected, rtol=0, atol=CLOSE * np.max(np.abs(expected)))
    np.testing.assert_allclose(
        shaft.driving_torque, row["M"], rtol=CLOSE, atol=CLOSE * RRR["R"] * np.max(np.abs(expected))
    )
