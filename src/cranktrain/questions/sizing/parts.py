"""What machines ask of their motors besides a cycle: the duty, starts, voltage; and a flywheel that is to be found."""

from typing import ClassVar

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.design import Designs
from cranktrain.layout.drive.duty_table import DutySpec, SizedFlywheelSpec
from cranktrain.layout.drive.shafts import shaft_number
from cranktrain.motion import Array
from cranktrain.quantities import Given
from cranktrain.questions.sizing.choosing import duty_factor
from cranktrain.record import record


@record
class DeclaredDuty:
    """The duty, arrays of shape (design,); NaN is not asked for.

    Attributes
    ----------
    is_asked : bool
        Whether the file has the table.
    factor : Array
        By which the torque under load may be above the rated one. [1]
    starts_per_hour, unloaded_starts : Array
        That it has to make, and that the motor alone may. [Hz]
    start_load_factor : Array
        What the load leaves of these. [1]
    longest_start : Array
        [s]
    reserve : Array
        What is left of torques at the lowest voltage. [1]
    inertia_ratio : Array
        Largest one. [1]
    starts_unloaded : bool
        Whether it starts before its loads act.
    holds_valves_open : bool
        Whether it starts with a compressor's suction valves held open.
    """

    needs: ClassVar[str] = N_("[drive]")

    is_asked: bool
    factor: Array
    starts_per_hour: Array
    unloaded_starts: Array
    start_load_factor: Array
    longest_start: Array
    reserve: Array
    inertia_ratio: Array
    starts_unloaded: bool
    holds_valves_open: bool


@record
class WantedFlywheel:
    """A flywheel to be found.

    Attributes
    ----------
    shaft : int
        0 is the motor's, others are those behind stages.
    largest_torque, fluctuation : Array, shape (design,)
        Of the motor and of the crank; NaN is not asked for. [N·m, 1]
    """

    needs: ClassVar[str] = N_("[drive.flywheel]")

    shaft: int
    largest_torque: Array
    fluctuation: Array


def declared_duty(spec: DutySpec | None, designs: Designs, *, holds_valves_open: bool) -> DeclaredDuty:
    """Take what the table says, or running on and on where there is none; and what its start says of valves."""
    own = DutySpec() if spec is None else spec
    factor = duty_factor(
        own.kind,
        share=own.share.array,
        period=own.period.array,
        time_constant=own.thermal_time_constant.array,
        cooling=own.cooling.array,
        constant_share=own.constant_losses.array,
    )
    lowest = own.lowest_voltage.array
    numbers = (
        factor,
        _asked(own.starts_per_hour),
        _asked(own.unloaded_starts),
        own.start_load_factor.array,
        _asked(own.allowed_start_time),
        lowest * lowest,
        _asked(own.largest_inertia_ratio),
    )
    return DeclaredDuty(
        spec is not None,
        *designs.by_design(list(numbers)).T,
        starts_unloaded=own.start == "unloaded",
        holds_valves_open=holds_valves_open,
    )


def wanted_flywheel(spec: SizedFlywheelSpec, designs: Designs) -> WantedFlywheel:
    """Take what the table says."""
    numbers = [_asked(spec.largest_torque), _asked(spec.fluctuation)]
    return WantedFlywheel(shaft_number(spec.on), *designs.by_design(numbers).T)


def _asked(given: Given | None) -> Array:
    return np.asarray(np.nan) if given is None else given.array
