"""Forces: in every joint, on every piston, rod, pin and guide, and the torque that each mechanism gives."""

from collections.abc import Iterator, Sequence

from cranktrain.errors import Problem
from cranktrain.language import N_
from cranktrain.layout.bodies import BodySpec, GravitySpec, GuideSpec
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.masses import mass_problems, masses_of
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage, Use, table
from cranktrain.quantities import Given
from cranktrain.questions import gas
from cranktrain.questions.forces import (
    along_cylinder,
    carriers,
    crank_pins,
    events,
    force_peaks,
    forces_times_arms,
    guides,
    joint_forces,
    largest_forces,
    loaded_machine,
    mechanism_torques,
    piston_forces,
    rod_methods,
    rods_in_pistons,
    rows,
    solved_cycle,
    torque_curves,
    unlikely,
)
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.questions.motion.rods import on_rods


def _problems(design: Design) -> Iterator[Problem]:
    yield from mass_problems(design.places, design.weighed)


def _parts(designs: Designs, known: Parts) -> Iterator[object | None]:
    yield carriers.carriers_of(designs.places)
    # There are forces where gas presses, whether anything has a mass or not.
    weighed = designs.together.weighed
    if designs.together.loads or weighed.bodies or all(part in known for part in gas.PRESSING):
        yield masses_of(designs.places, weighed, designs.n_designs)


def _bodies(design: Design) -> Sequence[str]:
    return [f"[{path}]" for path in design.weighed.bodies]


def _guides(design: Design) -> Sequence[str]:
    return [f"[{path}]" for path in design.weighed.guides]


QUESTION = Question(
    "forces",
    tables={"masses": BodySpec, "friction": Given, "guide": GuideSpec, "gravity": GravitySpec},
    problems=_problems,
    parts=_parts,
    stages=(
        Stage(loaded_machine.LoadedMachine),
        Stage(solved_cycle.solved_cycle),
        Stage(events.force_events),
        Stage(forces_times_arms.forces_times_arms),
        Stage(rods_in_pistons.rods_on_grid),
        Stage(along_cylinder.piston_loads, applies=along_cylinder.are_loaded),
        Stage(along_cylinder.piston_weights, applies=along_cylinder.are_heavy),
        Stage(piston_forces.piston_force_set, applies=on_rods),
        Stage(largest_forces.piston_curves, applies=on_rods),
        Stage(torque_curves.torque_curves),
        Stage(force_peaks.force_peaks, beside=force_peaks.CURVES),
        Stage(largest_forces.largest_forces),
        Stage(rod_methods.rod_methods, applies=piston_forces.have_direct_rods),
        Stage(crank_pins.crank_pin_loads, applies=crank_pins.have_crank_pins),
        Stage(mechanism_torques.mechanism_torques),
        Stage(joint_forces.joint_curves),
        Stage(joint_forces.joint_forces),
        Stage(guides.guide_curves, applies=guides.have_length),
        Stage(guides.guide_edges),
        Stage(unlikely.unlikely_loads),
    ),
    dimensions=(
        ResultDimension("joint", N_("joint")),
        ResultDimension("guide", N_("guide")),
        ResultDimension("force_method", N_("method"), own=0),
        ResultDimension("rod_method", N_("method"), own=0),
    ),
    headline=("largest_crankpin_load", "largest_joint_force"),
    title=N_("Largest forces"),
    rows=(rows.force_rows,),
    offers={
        "joint_force_x": N_("forces and torque"),
        "guide_pressing": N_("edge forces"),
    },
    curve_tables={
        "forces": (
            *("gas_force", "inertia_force", "load_force", "weight_force"),
            *("piston_force", "side_force", "rod_force_at_piston_pin"),
            *("radial_force", "tangential_force", "mechanism_torque"),
        )
    },
    uses=(
        # Gas that presses on nothing is missed by the forces.
        Use(
            table("gas"),
            (GasPressures,),
            MechanismTorques,
            N_("forces and torque are of inertia alone"),
        ),
        Use(_bodies, (MechanismTorques,)),
        Use(table("friction"), (MechanismTorques,)),
        Use(_guides, (guides.GuideEdges,)),
    ),
)
