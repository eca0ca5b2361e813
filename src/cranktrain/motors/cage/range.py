"""A range of cage motors from their tables, as `choosing` takes them in place of the small catalogue."""

from collections.abc import Callable, Sequence

import numpy as np

from cranktrain.motion import Array, single
from cranktrain.motors.cage.catalogue import MotorRange
from cranktrain.motors.cage.law import CatalogueValues
from cranktrain.motors.cage.numbers import catalogue_values, rating_of, ratio_of
from cranktrain.motors.cage.spec import CageSpec
from cranktrain.motors.spec import first


def motor_range(specs: Sequence[CageSpec]) -> MotorRange:
    """Motors by rising power, from tables with `curve = "catalogue"`.

    Parameters
    ----------
    specs : sequence of CageSpec
        Each of one design.

    Returns
    -------
    MotorRange
        What a table does not say is NaN, an inertia 0.
    """
    rising = sorted(specs, key=lambda spec: first(rating_of(spec).power))

    def column(number: Callable[[CageSpec], Array]) -> Array:
        return np.array([first(number(spec)) for spec in rising])

    values = [catalogue_values(spec) for spec in rising]
    return MotorRange(
        frame=tuple("" for _spec in rising),
        power=column(lambda spec: rating_of(spec).power),
        values=CatalogueValues(*(np.array([first(number) for number in each]) for each in zip(*values, strict=True))),
        inertia=column(lambda spec: single(0.0) if spec.rotor_inertia is None else spec.rotor_inertia),
        starting_current_ratio=column(lambda spec: ratio_of(spec, "starting_current_ratio")),
        efficiency=column(lambda spec: ratio_of(spec, "efficiency")),
        power_factor=column(lambda spec: ratio_of(spec, "power_factor")),
        is_typical=any(spec.size is not None for spec in rising),
    )
