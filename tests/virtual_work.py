"""Driving torque by virtual work, which shares with that of the joints' reactions the motion alone."""

from cranktrain.linkage.forces import torque_by_work


def torque_of_work(dynamics, motion, geometry, bodies, loads, conditions, forces):
    """Of a mechanism, by its equation of motion and what friction does; parameters as `Dynamics.forces` takes them."""
    equation = dynamics.reduced(motion, geometry, bodies, loads, conditions.gravity)
    return torque_by_work(equation, conditions.drive) - forces.friction_torque
