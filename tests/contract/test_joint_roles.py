"""Joints have roles, by which results find them, whatever a kind calls them."""

from typing import get_args

import pytest

from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.dynamics import Role


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_roles(kind):
    dynamics = kind.dynamics
    own = [reaction.role for reaction in dynamics.reactions if reaction.on in dynamics.moving]
    assert {reaction.role for reaction in dynamics.reactions} <= set(get_args(Role)), (
        "a joint's role is one of `Role` in mechanisms/dynamics.py"
    )
    for role in ("main_bearing", "crank_pin", "knuckle_pin", "piston_pin"):
        assert own.count(role) <= 1, f"give the role {role} to one joint"
    for role in own:
        place = dynamics.joint(role)
        assert place is not None and dynamics.reactions[place].on in dynamics.moving


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind.has_rod], ids=lambda kind: kind.name)
def test_rods(kind):
    """A rod of a piston has a pin there and one at the crank or a master's rod; a slave lends its master a share."""
    dynamics = kind.dynamics
    first = dynamics.joint("knuckle_pin" if dynamics.on_master is not None else "crank_pin")
    assert first is not None and dynamics.reactions[first].on == "rod", (
        "give the joint on which its rod hangs the role crank_pin, of a slave knuckle_pin"
    )
    assert (dynamics.joint("crank_pin", is_own=False) is not None) is (dynamics.on_master is not None)
    if kind.output.is_slider:
        pin, guide = dynamics.joint("piston_pin"), dynamics.joint("guide")
        assert pin is not None and (dynamics.reactions[pin].on, dynamics.reactions[pin].by) == ("slider", "rod")
        assert guide is not None and dynamics.reactions[guide].on == "slider", (
            "give the joint of slider and guide the role guide"
        )
