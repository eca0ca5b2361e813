"""What mechanisms have in common that are a crank and one group of two links on its pin: what each of the three bears.

Links, bodies and loads stand in the order of `Dynamics.moving`: the crank, then the group's links.
"""

from cranktrain.linkage.forces import NOTHING, Body, Conditions, Wrench, borne
from cranktrain.motion import ZERO, Array, Link


def force_on_slider(_motion: object, _geometry: object, force: Array) -> tuple[Wrench, ...]:
    """Loads for a force on the last link, a slider on a guide along x: away from the shaft; a gas presses toward it.

    [N]
    """
    return NOTHING, NOTHING, Wrench(force, ZERO, ZERO)


def torque_on_rocker(_motion: object, _geometry: object, torque: Array) -> tuple[Wrench, ...]:
    """Loads for a torque on the last link, in the sense of rotation. [N·m]"""
    return NOTHING, NOTHING, Wrench(ZERO, ZERO, torque)


def each_borne(
    links: tuple[Link, ...], bodies: tuple[Body, ...], loads: tuple[Wrench, ...], conditions: Conditions
) -> tuple[Wrench, Wrench, Wrench]:
    """All that acts on each of the three links but their joints: load, weight, inertia."""
    return (
        borne(links[0], bodies[0], loads[0], conditions),
        borne(links[1], bodies[1], loads[1], conditions),
        borne(links[2], bodies[2], loads[2], conditions),
    )
