"""What both edges of the guides press on what slides in them, from the reactions."""

from cranktrain.layout.mechanisms import Batch
from cranktrain.linkage.forces import EdgeForces, edge_forces
from cranktrain.questions.forces.loaded_machine import SolvedBatch


def edges_of(batch: Batch, one: SolvedBatch, place: int) -> EdgeForces:
    """What both edges press of the guides in which one part of a kind slides, broadcastable to (design, member, n)."""
    dynamics = batch.kind.dynamics
    links = dynamics.by_link(dynamics.links(one.motion, batch.members.geometry))
    contact = dynamics.contacts[place]
    link, wrench = links[dynamics.sliding[place]], dynamics.by_joint(one.forces.joints)[contact.joint]
    friction = one.conditions.friction[place]
    normal = contact.way * (link.cos * wrench.y - link.sin * wrench.x)
    return edge_forces(normal, wrench.moment, friction.per_length, friction.middle)
