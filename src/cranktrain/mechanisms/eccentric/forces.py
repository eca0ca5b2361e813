"""Forces of the eccentric: those of the slider-crank that it is."""

from cranktrain.linkage.forces import Body, Conditions, Wrench
from cranktrain.mechanisms.dynamics import Dynamics
from cranktrain.mechanisms.eccentric.kinematics import Eccentric
from cranktrain.mechanisms.on_crank import force_on_slider
from cranktrain.mechanisms.slider_crank.forces import DYNAMICS as SLIDER_CRANK
from cranktrain.mechanisms.slider_crank.forces import slider_crank_forces, slider_crank_links
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, SliderCrankMotion
from cranktrain.mechanisms.solved import Forces
from cranktrain.motion import Link


def eccentric_links(motion: SliderCrankMotion, geometry: Eccentric) -> tuple[Link, ...]:
    """What moves, as links: sheave, rod and valve."""
    return slider_crank_links(motion, SliderCrank(*geometry[:3]))


def eccentric_forces(
    motion: SliderCrankMotion,
    geometry: Eccentric,
    bodies: tuple[Body, ...],
    loads: tuple[Wrench, ...],
    conditions: Conditions,
) -> Forces:
    """All forces of an eccentric; parameters as of `slider_crank_forces`, the crank its sheave."""
    return slider_crank_forces(motion, SliderCrank(*geometry[:3]), bodies, loads, conditions)


DYNAMICS = Dynamics(
    moving=SLIDER_CRANK.moving,
    reactions=SLIDER_CRANK.reactions,
    sliding=SLIDER_CRANK.sliding,
    contacts=SLIDER_CRANK.contacts,
    groups=SLIDER_CRANK.groups,
    links=eccentric_links,
    load=force_on_slider,
    forces=eccentric_forces,
)
