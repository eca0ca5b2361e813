"""Forces of the eccentric: those of the slider-crank that it is."""

from cranktrain.linkage.forces import Conditions, Gravity, Reduced
from cranktrain.mechanisms.eccentric.kinematics import Eccentric
from cranktrain.mechanisms.kind import Dynamics
from cranktrain.mechanisms.slider_crank.forces import DYNAMICS as SLIDER_CRANK
from cranktrain.mechanisms.slider_crank.forces import (
    SliderCrankBodies,
    SliderCrankJoints,
    SliderCrankLoads,
    slider_crank_forces,
    slider_crank_links,
    slider_crank_load,
    slider_crank_reduced,
)
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, SliderCrankMotion
from cranktrain.mechanisms.solved import Forces
from cranktrain.motion import Array, Link


def eccentric_links(motion: SliderCrankMotion, geometry: Eccentric) -> tuple[Link, Link, Link]:
    """What moves, as links: sheave, rod and valve."""
    return slider_crank_links(motion, SliderCrank(*geometry[:3]))


def eccentric_load(motion: SliderCrankMotion, geometry: Eccentric, force: Array) -> SliderCrankLoads:
    """Loads for a force on the valve along x, away from the shaft. [N]"""
    return slider_crank_load(motion, SliderCrank(*geometry[:3]), force)


def eccentric_forces(
    motion: SliderCrankMotion,
    geometry: Eccentric,
    bodies: SliderCrankBodies,
    loads: SliderCrankLoads,
    conditions: Conditions,
) -> Forces[SliderCrankJoints]:
    """All forces of an eccentric; parameters as of `slider_crank_forces`, the crank its sheave."""
    return slider_crank_forces(motion, SliderCrank(*geometry[:3]), bodies, loads, conditions)


def eccentric_reduced(
    motion: SliderCrankMotion, geometry: Eccentric, bodies: SliderCrankBodies, loads: SliderCrankLoads, gravity: Gravity
) -> Reduced:
    """What an equation of motion needs; parameters as of `slider_crank_reduced`."""
    return slider_crank_reduced(motion, SliderCrank(*geometry[:3]), bodies, loads, gravity)


DYNAMICS = Dynamics(
    bodies=SliderCrankBodies,
    moving=SLIDER_CRANK.moving,
    reactions=SLIDER_CRANK.reactions,
    sliding=SLIDER_CRANK.sliding,
    contacts=SLIDER_CRANK.contacts,
    groups=SLIDER_CRANK.groups,
    links=eccentric_links,
    load=eccentric_load,
    forces=eccentric_forces,
    reduced=eccentric_reduced,
)
