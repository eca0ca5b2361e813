"""Arguments of the kernels of forces for `test_compiled`: of the angle, of `size`, and of the side."""

import numpy as np

from cranktrain.linkage import (
    Crank,
    CrankAndPivot,
    Ends,
    LinkPoint,
    OnLine,
    Pin,
    Slide,
    Swivel,
    TriadEnds,
    Yoke,
    crank,
    fixed,
    fixed_guide,
    pin,
    point,
    rod_end,
    slide,
    swivel,
)
from cranktrain.linkage.forces import (
    Body,
    Conditions,
    CrossingFriction,
    CrossingLoads,
    Drive,
    Friction,
    Gravity,
    PinLoads,
    Reduced,
    ReducedInertia,
    SlideLoads,
    SwivelLoads,
    TriadFriction,
    TriadLoads,
    Turning,
    Wrench,
)
from cranktrain.linkage.forces.guide import Guided
from cranktrain.linkage.forces.triad import Hold
from cranktrain.linkage.triad import GUIDE, ROD, Leg, Triad
from cranktrain.linkage.vectors import Vector, at_arm, rotated
from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, crank_rocker
from cranktrain.mechanisms.oscillating_cylinder.kinematics import oscillating_cylinder
from cranktrain.mechanisms.scotch_yoke.kinematics import ScotchYoke, scotch_yoke
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.mechanisms.slotted_lever.kinematics import slotted_lever
from cranktrain.questions.forces.pin_load import PinLoad
from cranktrain.questions.forces.piston_formulas import PistonForces
from cranktrain.questions.forces.rod_masses import TwoMasses


def wrench(size):
    return Wrench(size(3.0), size(-2.0), size(0.7))


def moving_wrench(angle, size):
    return Wrench(size(3.0), size(2.0) * np.cos(angle), size(0.7))


def hold(angle, size):
    return Hold(Vector(size(0.2), size(0.1)), moving_wrench(angle, size), wrench(size))


def holds(angle, size):
    """Three forces through points of a circle, a third of a turn apart."""
    arms = [rotated(Vector(size(0.3), 0.0), np.cos(at), np.sin(at)) for at in (0.5, 2.5, 4.5)]
    forces = [Vector(np.cos(angle + at), np.sin(angle + at)) for at in (0.0, 1.3, 2.9)]
    return [Hold(arm, at_arm(arm, force), wrench(size)) for arm, force in zip(arms, forces, strict=True)]


def body(size):
    return Body(size(2.0), size(0.2), size(0.05), size(0.03))


def drive(size):
    return Drive(size(4.0), size(-3.0))


def gravity(size):
    return Gravity(size(0.5), size(-9.0))


def friction(size):
    return Friction(size(0.05), 1.0, size(5.0), size(0.02))


def crossing_friction(size):
    return CrossingFriction(friction(size), friction(size))


def conditions(size):
    """Two things slide in a scotch yoke, one in the others."""
    return Conditions(drive(size), gravity(size), (friction(size), friction(size)))


def crank_pin(angle, size):
    return crank(angle, Crank(size(0.3)))


def group(angle, size, side):
    return slide(crank_pin(angle, size), Slide(size(1.0), size(0.05), side))


def rod_and_rocker(angle, size, side):
    ends = Ends(crank_pin(angle, size), fixed(size(1.1), size(0.05)))
    return pin(ends, Pin(size(1.0), size(0.8), side))


def guide(angle, size):
    return swivel(Ends(crank_pin(angle, size), fixed(size(0.1), size(-0.4))), Swivel(size(0.05), 1.0)).guide


def triad(angle, size):
    """The link need not be where the legs would hold it: the forces only ask where it is."""
    ends = TriadEnds(
        rod_end(crank_pin(angle, size)),
        rod_end(fixed(size(1.2), size(0.6))),
        fixed_guide(size(0.4), size(-0.9), size(0.6)),
    )
    places = [LinkPoint(size(0.3), size(direction)) for direction in (0.5, 2.5, 4.5)]
    legs = Triad(Leg(places[0], size(1.0), ROD), Leg(places[1], size(0.8), ROD), Leg(places[2], size(0.2), GUIDE))
    return group(angle, size, 1.0).rod, ends, legs, TriadLoads(*(wrench(size) for _ in range(4)))


def mechanism(kernel, geometry, n_links=3):
    """Motion, geometry, bodies and loads of a kind."""

    def made(angle, size, side):
        own = geometry(size, side)
        return (
            kernel(angle, own),
            own,
            n_links * (body(size),),
            n_links * (wrench(size),),
        )

    return made


def slider_crank_geometry(size, side):
    return SliderCrank(size(0.3), size(1.0), size(0.05))


KINDS = {
    "slider_crank": mechanism(slider_crank, slider_crank_geometry),
    "crank_rocker": mechanism(
        crank_rocker,
        lambda size, side: CrankRocker(size(0.3), size(1.0), size(0.8), size(1.1), side),
    ),
    "scotch_yoke": mechanism(scotch_yoke, lambda size, side: ScotchYoke(size(0.3), size(0.1), size(1.2))),
    "oscillating_cylinder": mechanism(
        oscillating_cylinder,
        lambda size, side: CrankAndPivot(size(0.3), size(0.5), size(0.05), 1.0),
    ),
    "slotted_lever": mechanism(
        slotted_lever,
        lambda size, side: CrankAndPivot(size(0.3), size(0.5), size(0.05), 1.0),
    ),
    "articulated_rod": mechanism(
        articulated_rod,
        lambda size, side: ArticulatedRod(
            slider_crank_geometry(size, side), size(0.25), size(1.2), size(1.0), size(0.8), size(0.02)
        ),
        n_links=2,
    ),
}


def of_kind(name, made):
    """The kernels that every kind has."""
    return {
        f"{name}.{name}_forces": lambda angle, size, side: (*made(angle, size, side), conditions(size)),
        f"{name}.{name}_links": lambda angle, size, side: made(angle, size, side)[:2],
    }


def loading(name):
    """Arguments of a kernel that gives the loads of a kind."""
    return lambda angle, size, side: (*KINDS[name](angle, size, side)[:2], size(5.0))


def slider_crank_at(angle, size, side):
    return KINDS["slider_crank"](angle, size, side)[:2]


def rigid_rod(size):
    """A rod with its centroid on its line."""
    return Body(size(2.0), size(0.3), 0.0, size(0.1))


def rod_of_masses(angle, size, side):
    return group(angle, size, side).rod, rigid_rod(size), size(1.0), drive(size), gravity(size)


def of_piston(angle, size, side):
    motion, geometry = slider_crank_at(angle, size, side)
    return size(5.0), motion, geometry


def piston_parts(angle, size, side):
    return (PistonForces(*(size(value) for value in (3.0, 0.5, 3.1, 2.0, 2.4))), *of_piston(angle, size, side)[1:])


def reduced(size):
    return Reduced(ReducedInertia(size(0.3), size(0.1)), size(2.0))


EXAMPLES = {
    **{kernel: example for name, made in KINDS.items() for kernel, example in of_kind(name, made).items()},
    "articulated_rod.articulated_rod_load": loading("articulated_rod"),
    "oscillating_cylinder.oscillating_cylinder_load": loading("oscillating_cylinder"),
    "on_crank.each_borne": lambda angle, size, side: (
        3 * (group(angle, size, side).rod,),
        *KINDS["slider_crank"](angle, size, side)[2:],
        conditions(size),
    ),
    "on_crank.force_on_slider": loading("slider_crank"),
    "on_crank.torque_on_rocker": loading("crank_rocker"),
    "articulated_rod.on_master_rod": lambda angle, size, side: (
        *KINDS["articulated_rod"](angle, size, side)[:2],
        wrench(size),
    ),
    "forces.across_link": lambda angle, size, side: (group(angle, size, side).rod, size(0.4)),
    "forces.added": lambda angle, size, side: (wrench(size), wrench(size)),
    "forces.added_reduced": lambda angle, size, side: (reduced(size), reduced(size)),
    "forces.along_link": lambda angle, size, side: (group(angle, size, side).rod,),
    "forces.applied": lambda angle, size, side: (group(angle, size, side).rod, body(size), drive(size), gravity(size)),
    "forces.off_arc": lambda angle, size, side: (group(angle, size, side).rod, size(0.4), size(1.1)),
    "forces.pushing": lambda angle, size, side: (
        group(angle, size, side).rod,
        Vector(size(0.3), size(-0.1)),
        size(0.7),
    ),
    "forces.turning": lambda angle, size, side: (group(angle, size, side).rod,),
    "forces.with_motion": lambda angle, size, side: (group(angle, size, side).rod, Vector(size(0.3), size(-0.1))),
    "forces.block_link": lambda angle, size, side: (crank_pin(angle, size), size(1.2)),
    "forces.borne": lambda angle, size, side: (
        group(angle, size, side).rod,
        body(size),
        wrench(size),
        conditions(size),
    ),
    "forces.carrying_crank": lambda angle, size, side: (
        group(angle, size, side).rod,
        wrench(size),
        point(group(angle, size, side).rod, LinkPoint(size(0.2), size(0.7))),
        wrench(size),
    ),
    "forces.crank_link": lambda angle, size, side: (crank_pin(angle, size), Crank(size(0.3))),
    "forces.crank_reactions": lambda angle, size, side: (wrench(size),),
    "forces.crossing_forces": lambda angle, size, side: (
        guide(angle, size).cos,
        guide(angle, size).sin,
        wrench(size),
        Turning(size(0.7), size(0.1)),
        crossing_friction(size),
    ),
    "forces.edge_forces": lambda angle, size, side: (size(3.0), size(0.7), size(5.0), size(0.02)),
    "forces.friction_force": lambda angle, size, side: (
        Guided(size(-3.0), size(0.7), size(0.4), size(0.1)),
        friction(size),
    ),
    "forces.handed_back": lambda angle, size, side: (
        group(angle, size, side).rod,
        point(group(angle, size, side).rod, LinkPoint(size(0.2), size(0.7))),
        wrench(size),
    ),
    "forces.hold_of": lambda angle, size, side: (
        triad(angle, size)[0],
        triad(angle, size)[1].third,
        triad(angle, size)[2].third,
        wrench(size),
    ),
    "forces.leg_reactions": lambda angle, size, side: (
        hold(angle, size),
        size(3.0),
        triad(angle, size)[2].third,
        wrench(size),
    ),
    "forces.momentum": lambda angle, size, side: (group(angle, size, side).rod, body(size)),
    "forces.needed_of": lambda angle, size, side: (wrench(size), *(hold(angle, size) for _ in range(3))),
    "forces.opposite": lambda angle, size, side: (wrench(size),),
    "forces.pin_reactions": lambda angle, size, side: (
        rod_and_rocker(angle, size, side),
        Pin(size(1.0), size(0.8), side),
        PinLoads(wrench(size), wrench(size)),
    ),
    "forces.plus": lambda angle, size, side: (wrench(size), size(2.0), moving_wrench(angle, size)),
    "forces.reactions_of": lambda angle, size, side: (
        *holds(angle, size),
        size(0.0),
        triad(angle, size)[2],
        triad(angle, size)[3],
    ),
    "forces.reduced": lambda angle, size, side: (
        group(angle, size, side).rod,
        body(size),
        wrench(size),
        gravity(size),
    ),
    "forces.reduced_inertia": lambda angle, size, side: (group(angle, size, side).rod, body(size)),
    "forces.reduced_of": lambda angle, size, side: (
        tuple(group(angle, size, side).rod for _ in range(3)),
        tuple(body(size) for _ in range(3)),
        tuple(wrench(size) for _ in range(3)),
        gravity(size),
    ),
    "forces.slide_reactions": lambda angle, size, side: (
        group(angle, size, side).rod,
        Slide(size(1.0), size(0.05), side),
        SlideLoads(wrench(size), wrench(size)),
        friction(size),
    ),
    "forces.slider_link": lambda angle, size, side: (group(angle, size, side).slider, size(0.05)),
    "forces.swivel_reactions": lambda angle, size, side: (
        OnLine(guide(angle, size), crank_pin(angle, size)),
        Swivel(size(0.05), 1.0),
        SwivelLoads(wrench(size), wrench(size)),
        friction(size),
    ),
    "forces.swivel_slider_link": lambda angle, size, side: (crank_pin(angle, size), guide(angle, size)),
    "forces.torque_by_work": lambda angle, size, side: (reduced(size), drive(size)),
    "forces.trammel_reactions": lambda angle, size, side: (
        guide(angle, size),
        CrossingLoads(wrench(size), wrench(size)),
        crossing_friction(size),
    ),
    "forces.triad_reactions": lambda angle, size, side: triad(angle, size),
    "forces.triad_reactions_with_friction": lambda angle, size, side: (
        *triad(angle, size),
        TriadFriction(*(friction(size) for _ in range(3))),
    ),
    "forces.triple": lambda angle, size, side: (moving_wrench(angle, size), moving_wrench(angle, size)),
    "forces.turned_wrench": lambda angle, size, side: (wrench(size), size(0.7)),
    "forces.weight": lambda angle, size, side: (group(angle, size, side).rod, body(size), gravity(size)),
    "forces.work": lambda angle, size, side: (group(angle, size, side).rod, wrench(size)),
    "forces.yoke_reactions": lambda angle, size, side: (
        size(0.3),
        Yoke(size(0.1), size(1.2)),
        CrossingLoads(wrench(size), wrench(size)),
        crossing_friction(size),
    ),
    "pin_load.pin_load": lambda angle, size, side: (
        wrench(size),
        fixed_guide(size(0.4), size(-0.9), size(0.6)),
    ),
    "pin_load.rod_bearing_load": lambda angle, size, side: (
        wrench(size),
        fixed_guide(size(0.4), size(-0.9), size(0.6)),
    ),
    "pin_load.with_rotating_mass": lambda angle, size, side: (
        PinLoad(size(3.0), size(-2.0)),
        size(0.4),
        size(0.3),
        drive(size),
    ),
    "piston_formulas.inertia_force": lambda angle, size, side: (
        slider_crank_at(angle, size, side)[0].slider,
        size(0.6),
        drive(size),
    ),
    "piston_formulas.piston_forces": of_piston,
    "piston_formulas.piston_identities": piston_parts,
    "piston_formulas.rod_forces": lambda angle, size, side: (
        group(angle, size, side).rod,
        slider_crank_at(angle, size, side)[0].slider,
        (wrench(size), wrench(size)),
        TwoMasses(size(0.7), size(0.4)),
        drive(size),
        gravity(size),
    ),
    "piston_formulas.two_harmonic_inertia_force": lambda angle, size, side: (
        angle,
        SliderCrank(size(0.3), size(1.0), 0.0),
        size(0.6),
        drive(size),
    ),
    "rod_masses.as_rigid_body": rod_of_masses,
    "rod_masses.by_three_masses": rod_of_masses,
    "rod_masses.by_two_masses": rod_of_masses,
    "rod_masses.by_two_masses_and_couple": rod_of_masses,
    "rod_masses.excess_inertia": lambda angle, size, side: (rigid_rod(size), size(1.0)),
    "rod_masses.three_masses": lambda angle, size, side: (rigid_rod(size), size(1.0)),
    "rod_masses.two_masses": lambda angle, size, side: (rigid_rod(size), size(1.0)),
    "rod_masses.weighed_ends": lambda angle, size, side: (rigid_rod(size), size(1.0)),
}
