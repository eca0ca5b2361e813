"""The motor of a table, or of the tables of several designs together."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from cranktrain.layout.design import Designs
from cranktrain.motion import Array
from cranktrain.numerics.nested import mapped
from cranktrain.questions.drive.motor_tables.declared import DeclaredMotor
from cranktrain.questions.drive.motor_tables.spec import DrivingMotorSpec


def declared_motor(spec: DrivingMotorSpec, designs: Designs) -> DeclaredMotor:
    """Motor that the table of all designs declares."""
    return motor_of(spec, designs.n_designs)


def motor_of(spec: DrivingMotorSpec, n_designs: int = 1) -> DeclaredMotor:
    """Motor that a table declares.

    Parameters
    ----------
    spec : DrivingMotorSpec
        Of one design, or of several in columns.
    n_designs : int

    Returns
    -------
    DeclaredMotor
        Its numbers of as many designs.
    """
    own = spec.declared()
    each = _by_design(n_designs)
    return replace(
        own,
        numbers=mapped(lambda _name, number: each(number), own.numbers),
        rating=own.rating._make(map(each, own.rating)),
        top_speed=each(own.top_speed),
        inertia=None if own.inertia is None else each(own.inertia),
        current_numbers=mapped(lambda _name, number: each(number), own.current_numbers),
        rated_current=each(own.rated_current),
    )


def _by_design(n_designs: int) -> Callable[[Any], Array]:
    """From one number, shape (design,) or (point, 1 or design), to the last axis of as many designs."""

    def each(number: Any) -> Array:
        found = np.atleast_1d(np.asarray(number, dtype=float))
        return np.broadcast_to(found, (*found.shape[:-1], n_designs))

    return each
