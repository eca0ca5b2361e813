"""Bodies and joints of a chain by name: what moves and what slides, which body carries a point, who acts on whom."""

from cranktrain.mechanisms.chain.groups import anatomy
from cranktrain.mechanisms.chain.made import SHAFT, pin_of
from cranktrain.mechanisms.chain.steps import Structure
from cranktrain.mechanisms.dynamics import FRAME, Contact, Reaction


def chain_moving(structure: Structure) -> tuple[str, ...]:
    """Names of what has mass: cranks, then links and sliders in the order of the file."""
    return (*structure.cranks, *(name for step in structure.steps for name in anatomy(step).moving))


def chain_contacts(structure: Structure) -> dict[str, Contact]:
    """Where what may have friction slides: sliders in their guides, and blocks in slots, by the slider of the slot."""
    return {name: contact for step in structure.steps for name, contact in anatomy(step).contacts.items()}


def chain_reactions(structure: Structure) -> tuple[Reaction, ...]:
    """Joints of a chain: the bearing of its cranks, then each part's, named `point/link` by where and on what."""
    carriers = carriers_of(structure)
    joints = (joint for step in structure.steps for joint in anatomy(step).joints)
    parts = (Reaction(joint.name, joint.on, joint.by or carriers[joint.at], joint.role) for joint in joints)
    return (Reaction("main_bearing", structure.cranks[0], FRAME, "main_bearing"), *parts)


def carriers_of(structure: Structure) -> dict[str, str]:
    """Which body carries each point."""
    still = dict.fromkeys((SHAFT, *structure.fixed), FRAME) | {pin_of(name): name for name in structure.cranks}
    made = (item for step in structure.steps for item in anatomy(step).made.items())
    return still | {name: own.carrier for name, own in made if own.carrier}
