"""Forces of the eccentric: those of the slider-crank that it is."""

from cranktrain.linkage.forces import Body, Conditions, Wrench
from cranktrain.mechanisms.dynamics import Dynamics
from cranktrain.mechanisms.eccentric.kinematics import Eccentric
from cranktrain.mechanisms.slider_crank.forces import DYNAMICS as SLIDER_CRANK
from cranktrain.mechanisms.slider_crank.forces import (
    SliderCrankJoints,
    SliderCrankLinks,
    slider_crank_forces,
    slider_crank_links,
    slider_crank_load,
)
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, SliderCrankMotion
from cranktrain.mechanisms.solved import Forces
from cranktrain.motion import Array, Link


def eccentric_links(motion: SliderCrankMotion, geometry: Eccentric) -> SliderCrankLinks[Link]:
    """What moves, as links: sheave, rod and valve."""
    return slider_crank_links(motion, SliderCrank(*geometry[:3]))


def eccentric_load(motion: SliderCrankMotion, geometry: Eccentric, force: Array) -> SliderCrankLinks[Wrench]:
    """Loads for a force on the valve along x, away from the shaft. [N]"""
    return slider_crank_load(motion, SliderCrank(*geometry[:3]), force)


def eccentric_forces(
    motion: SliderCrankMotion,
    geometry: Eccentric,
    bodies: SliderCrankLinks[Body],
    loads: SliderCrankLinks[Wrench],
    conditions: Conditions,
) -> Forces[SliderCrankJoints]:
    """All forces of an eccentric; parameters as of `slider_crank_forces`, the crank its sheave."""
    return slider_crank_forces(motion, SliderCrank(*geometry[:3]), bodies, loads, conditions)


DYNAMICS = Dynamics(
    bodies=SliderCrankLinks[Body],
    moving=SLIDER_CRANK.moving,
    reactions=SLIDER_CRANK.reactions,
    sliding=SLIDER_CRANK.sliding,
    contacts=SLIDER_CRANK.contacts,
    groups=SLIDER_CRANK.groups,
    links=eccentric_links,
    load=eccentric_load,
    forces=eccentric_forces,
)
