"""Forces: in every joint, on every piston, rod, pin and guide, and the torque that each mechanism gives."""

from collections.abc import Iterator, Sequence

from cranktrain.errors import Problem
from cranktrain.language import N_
from cranktrain.layout.bodies import BodySpec, Friction, GravitySpec, GuideSpec
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.guide_tables import guide_problems
from cranktrain.layout.masses import mass_problems, masses_of
from cranktrain.layout.question import Dimension, Parts, Question, Stage, Use
from cranktrain.layout.uses import table
from cranktrain.questions import gas
from cranktrain.questions.forces.crank_pins import crank_pin_loads, crank_pins_of
from cranktrain.questions.forces.events import force_events
from cranktrain.questions.forces.guides import GuideEdges, guide_edges, have_length
from cranktrain.questions.forces.joint_forces import joint_forces
from cranktrain.questions.forces.largest_forces import largest_forces
from cranktrain.questions.forces.loaded import (
    MechanismTorques,
    carriers_of,
    loaded_machine,
    mechanism_torques,
    solved_cycle,
)
from cranktrain.questions.forces.piston_forces import have_direct_rods, piston_force_set
from cranktrain.questions.forces.rod_methods import rod_methods
from cranktrain.questions.forces.unlikely import unlikely_loads
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.questions.motion.rods import on_rods


def _problems(design: Design) -> Iterator[Problem]:
    yield from mass_problems(design.places, design.weighed)
    yield from guide_problems(design.places, design.weighed.guides)


def _parts(designs: Designs, known: Parts) -> Iterator[object | None]:
    yield carriers_of(designs.places[0])
    yield crank_pins_of(designs.mechanisms)
    # There are forces where gas presses, whether anything has a mass or not.
    if designs.first.weighed.bodies or all(part in known for part in gas.PRESSING):
        yield masses_of(designs.places, [design.weighed for design in designs.each])


def _bodies(design: Design) -> Sequence[str]:
    return [f"[{path}]" for path in design.weighed.bodies]


def _guides(design: Design) -> Sequence[str]:
    return [f"[{path}]" for path in design.weighed.guides]


QUESTION = Question(
    "forces",
    tables={"masses": BodySpec, "friction": Friction, "guide": GuideSpec, "gravity": GravitySpec},
    problems=_problems,
    parts=_parts,
    stages=(
        Stage(loaded_machine),
        Stage(solved_cycle),
        Stage(force_events),
        Stage(piston_force_set, applies=on_rods),
        Stage(largest_forces),
        Stage(rod_methods, applies=have_direct_rods),
        Stage(crank_pin_loads),
        Stage(mechanism_torques),
        Stage(joint_forces),
        Stage(guide_edges, applies=have_length),
        Stage(unlikely_loads),
    ),
    dimensions=(
        Dimension("joint", N_("joint")),
        Dimension("guide", N_("guide")),
        Dimension("force_method", N_("method")),
        Dimension("rod_method", N_("method")),
    ),
    headline=("largest_crankpin_load", "largest_joint_force"),
    uses=(
        # Gas that presses on nothing is missed by the forces.
        Use(table("gas"), (GasPressures,), MechanismTorques, N_("forces and torque are of inertia alone")),
        Use(_bodies, (MechanismTorques,)),
        Use(table("friction"), (MechanismTorques,)),
        Use(_guides, (GuideEdges,)),
    ),
)
