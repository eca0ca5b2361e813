"""Kernels of forces: what a group's links bear gives its joints' reactions, and what it hands back to what it hangs on.

Inertia is a load as any other (d'Alembert), so each group is statics: closed form for class II, a linear solve for the
triad. A chain is solved from its last group backward, each handing its reactions to the links that carry it.
"""

from cranktrain.linkage.forces.body import (
    WEIGHTLESS,
    Body,
    Drive,
    Gravity,
    Momentum,
    Reduced,
    ReducedInertia,
    added_reduced,
    applied,
    momentum,
    reduced,
    reduced_inertia,
    reduced_of,
    torque_by_work,
    weight,
)
from cranktrain.linkage.forces.conditions import NO_FRICTION, Conditions, Friction, borne
from cranktrain.linkage.forces.crank import CrankReactions, carrying_crank, crank_link, crank_reactions
from cranktrain.linkage.forces.crossing import (
    CrossingForces,
    CrossingFriction,
    CrossingLoads,
    CrossingReactions,
    Turning,
    crossing_forces,
)
from cranktrain.linkage.forces.guide import EdgeForces, edge_forces
from cranktrain.linkage.forces.pin import PinLoads, PinReactions, pin_reactions
from cranktrain.linkage.forces.rubbing_triad import TriadFriction, triad_reactions_with_friction
from cranktrain.linkage.forces.slide import SlideLoads, SlideReactions, slide_reactions, slider_link
from cranktrain.linkage.forces.swivel import SwivelLoads, SwivelReactions, swivel_reactions, swivel_slider_link
from cranktrain.linkage.forces.trammel import trammel_reactions
from cranktrain.linkage.forces.triad import LegReactions, TriadLoads, TriadReactions, triad_reactions
from cranktrain.linkage.forces.wrench import NOTHING, Wrench, added, handed_back, opposite, turned_wrench, work
from cranktrain.linkage.forces.yoke import block_link, yoke_reactions

__all__ = [
    "NOTHING",
    "NO_FRICTION",
    "WEIGHTLESS",
    "Body",
    "Conditions",
    "CrankReactions",
    "CrossingForces",
    "CrossingFriction",
    "CrossingLoads",
    "CrossingReactions",
    "Drive",
    "EdgeForces",
    "Friction",
    "Gravity",
    "LegReactions",
    "Momentum",
    "PinLoads",
    "PinReactions",
    "Reduced",
    "ReducedInertia",
    "SlideLoads",
    "SlideReactions",
    "SwivelLoads",
    "SwivelReactions",
    "TriadFriction",
    "TriadLoads",
    "TriadReactions",
    "Turning",
    "Wrench",
    "added",
    "added_reduced",
    "applied",
    "block_link",
    "borne",
    "carrying_crank",
    "crank_link",
    "crank_reactions",
    "crossing_forces",
    "edge_forces",
    "handed_back",
    "momentum",
    "opposite",
    "pin_reactions",
    "reduced",
    "reduced_inertia",
    "reduced_of",
    "slide_reactions",
    "slider_link",
    "swivel_reactions",
    "swivel_slider_link",
    "torque_by_work",
    "trammel_reactions",
    "triad_reactions",
    "triad_reactions_with_friction",
    "turned_wrench",
    "weight",
    "work",
    "yoke_reactions",
]
