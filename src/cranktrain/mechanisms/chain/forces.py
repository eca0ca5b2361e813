"""Forces of a chain: its groups solved from the last backward, each loading what it hangs on."""

from collections.abc import Callable, Mapping
from functools import reduce

from cranktrain.linkage import Crank
from cranktrain.linkage.forces import (
    NOTHING,
    Body,
    Conditions,
    Wrench,
    added,
    block_link,
    borne,
    crank_link,
    crank_reactions,
    handed_back,
    swivel_slider_link,
)
from cranktrain.mechanisms.chain.backward import SOLVED, Acting
from cranktrain.mechanisms.chain.groups import (
    Made,
    anatomy,
    carriers_of,
    chain_contacts,
    chain_moving,
    chain_reactions,
    guide_directions,
    made_names,
    pin_of,
)
from cranktrain.mechanisms.chain.kinematics import ChainMotion
from cranktrain.mechanisms.chain.steps import ChainSize, Step, Structure, SwivelSize, SwivelStep
from cranktrain.mechanisms.dynamics import Dynamics, Forces
from cranktrain.mechanisms.kind import Geometry
from cranktrain.motion import ZERO, Array, Link


def chain_links(structure: Structure, motion: ChainMotion, size: ChainSize) -> dict[str, Link]:
    """All that has mass as links in the file's axes, in the order of `chain_moving`."""
    made = _made(structure, motion)
    links = {
        name: crank_link(made[pin_of(name)], Crank(own.radius))
        for name, own in zip(structure.cranks, size.cranks, strict=True)
    }
    directions = guide_directions(structure, size)
    return links | {
        name: _link(step, name, made, directions) for step in structure.steps for name in anatomy(step).moving
    }


def _made(structure: Structure, motion: ChainMotion) -> Made:
    return dict(zip(made_names(structure), motion.parts, strict=True))


def _link(step: Step, name: str, made: Made, directions: Mapping[str, Array]) -> Link:
    if isinstance(made[name], Link):
        return made[name]
    if isinstance(step, SwivelStep):
        return swivel_slider_link(made[step.pin], made[step.guide])
    return block_link(made[pin_of(name)], directions[name])


def chain_load(structure: Structure, motion: ChainMotion, size: ChainSize, value: Array) -> tuple[Wrench, ...]:
    """Loads for a force along the output slider's coordinate or a torque on the output link. [N or N·m]

    A slider in a guide that swings counts along it: the guide gets the opposite force.
    """
    made = _made(structure, motion)
    links = chain_links(structure, motion, size)
    output = links[structure.output]
    loads = dict.fromkeys(links, NOTHING)
    if isinstance(made[structure.output], Link):
        loads[structure.output] = Wrench(ZERO, ZERO, value)
        return tuple(loads.values())
    force = Wrench(value * output.cos, value * output.sin, ZERO)
    loads[structure.output] = force
    for step, own in zip(structure.steps, size.steps, strict=True):
        if isinstance(step, SwivelStep) and isinstance(own, SwivelSize) and step.slider == structure.output:
            loads[step.guide] = Wrench(-force.x, -force.y, own.offset * value)
    return tuple(loads.values())


def chain_forces(
    structure: Structure,
    motion: ChainMotion,
    size: ChainSize,
    bodies: tuple[Body, ...],
    loads: tuple[Wrench, ...],
    conditions: Conditions,
) -> Forces:
    """All forces of a chain.

    Parameters
    ----------
    structure : Structure
    motion : ChainMotion, shape (..., n)
    size : ChainSize, fields broadcastable to (..., 1)
    bodies : tuple of Body
        In the order of `chain_moving`. A yoke's block and a trammel's have no mass.
    loads : tuple of Wrench, shape (..., n)
        In that order, each about the link's first pin: a crank's the shaft's centre, a slider's its pin.
    conditions : Conditions
        Gravity in the file's axes; friction in the order of `chain_contacts`.

    Returns
    -------
    Forces, shape (..., n)
        Joints in the order of `chain_reactions`, in the file's axes.

    Notes
    -----
    Assur's order: the last group bears only its own loads; solved, it hands its reactions to the links that carry it,
    and so on to the cranks. docs/theory/forces, eq. (13.3).
    """
    made = _made(structure, motion)
    links = chain_links(structure, motion, size)
    carried = zip(links.items(), bodies, loads, strict=True)
    on_links = {name: borne(link, body, load, conditions) for (name, link), body, load in carried}
    friction = dict(zip(chain_contacts(structure), conditions.friction, strict=True))
    carriers = carriers_of(structure)
    passed: dict[str, Wrench] = {}
    friction_torque = ZERO
    groups = [pair for pair in zip(structure.steps, size.steps, strict=True) if type(pair[0]) in SOLVED]
    for step, own in reversed(groups):
        group = anatomy(step)
        joints, drags = SOLVED[type(step)](step, own, Acting(made, on_links, friction))
        for joint, wrench in zip(group.joints, joints, strict=True):
            passed[joint.name] = wrench
            carrier = joint.by or carriers[joint.at]
            if carrier in links and carrier not in group.moving:
                back = handed_back(links[carrier], made[joint.at], wrench)
                on_links[carrier] = added(on_links[carrier], back)
        for name, drag in zip(group.contacts, drags, strict=True):
            friction_torque = friction_torque + drag * made[name].first
    shaft = crank_reactions(reduce(added, (on_links[name] for name in structure.cranks)))
    return Forces(
        (shaft.bearing, *(passed[joint.name] for step in structure.steps for joint in anatomy(step).joints)),
        shaft.driving_torque,
        0.0 * shaft.driving_torque + friction_torque,
    )


def chain_dynamics(structure: Structure, size_of: Callable[[Geometry], ChainSize]) -> Dynamics[ChainMotion, Geometry]:
    """What forces a chain gives.

    Parameters
    ----------
    structure : Structure
    size_of : callable (geometry) → ChainSize
        Of a kind that composes a chain out of numbers of its own.

    Returns
    -------
    Dynamics
    """
    contacts = chain_contacts(structure)
    return Dynamics(
        chain_moving(structure),
        chain_reactions(structure),
        tuple(contacts),
        tuple(contacts.values()),
        # A point is no group.
        tuple(anatomy(step).group for step in structure.steps if anatomy(step).sort),
        lambda motion, geometry: tuple(chain_links(structure, motion, size_of(geometry)).values()),
        lambda motion, geometry, value: chain_load(structure, motion, size_of(geometry), value),
        lambda motion, geometry, bodies, loads, conditions: chain_forces(
            structure, motion, size_of(geometry), bodies, loads, conditions
        ),
    )
