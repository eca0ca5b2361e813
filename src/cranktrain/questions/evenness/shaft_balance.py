"""What the machine gives or needs on the mean, what the given loads on its shaft take, and what these leave."""

from collections.abc import Sequence

import numpy as np

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.load_laws import ByAngle, BySpeed
from cranktrain.layout.shaft_loads import LoadsOnShafts, TorqueOnShaft
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.numerics.polyline import polyline_mean
from cranktrain.questions.evenness.spec import DrivenByMotor
from cranktrain.questions.evenness.speed_law import Power
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.questions.torque.sources import TorqueSources
from cranktrain.record import record

_NOTHING = 1e-9
"""A mean torque below this part of the peak is none."""
_NOTEWORTHY = 0.1
"""Of the machine's mean torque: of more that balances it and stands nowhere the answer speaks."""


@record
class ShaftBalance:
    """Mean torques at the declared speed.

    Attributes
    ----------
    machine : Array, shape (design,)
        Of the machine, positive where it gives. [N·m]
    taken : Array, shape (design,)
        Of its given loads on the shaft, positive where they resist. [N·m]
    left : Array, shape (design,)
        What these leave of it. [N·m]
    is_taken : bool
        Whether a motor, or a load of unknown size, takes what is left.
    """

    machine: Array
    taken: Array
    left: Array
    is_taken: bool

    def undeclared(self, design: int) -> float:
        """Constant torque by which the machine and its loads are balanced, where it is much; below 0 it drives. [N·m]

        0 where it is little beside the machine's mean torque, or a motor or a load of unknown size takes it.
        """
        rest = float(self.left[design])
        return rest if not self.is_taken and abs(rest) > _NOTEWORTHY * abs(float(self.machine[design])) else 0.0


def are_balanced(loads: LoadsOnShafts | None, speed: Speed | None) -> bool:
    """Whether there are loads on shafts, over a cycle; at one moment what is left of the torque accelerates."""
    return loads is not None and speed is not None and (speed.curve is None or speed.curve.moment is None)


def shaft_balance(
    loads: LoadsOnShafts,
    driven: DrivenByMotor | None,
    sources: TorqueSources,
    torques: MechanismTorques,
    speed: Speed,
    crank_angle: CrankAngle,
) -> ShaftBalance:
    """Mean torque of the machine and of its given loads, whether or not a file asks for evenness.

    Notes
    -----
    docs/theory/evenness, eq. (17.17).
    """
    machine = np.sum(sources.mean, axis=-1)
    powers, constant = powers_of(loads.given, len(machine))
    rising = sum(one.torque(speed.value[:, 0])[:, 0] for one in powers)
    taken = constant + sum(map(mean_of, listed(loads.given))) + rising
    # A machine that nothing but inertia acts on has a mean torque of rounding.
    peak = np.max(np.abs(torques.from_mechanisms), axis=-1)
    left = np.where(np.abs(machine - taken) <= _NOTHING * peak, 0.0, machine - taken)
    return ShaftBalance(machine, taken, left, driven is not None or loads.balanced is not None)


def listed(loads: Sequence[TorqueOnShaft]) -> list[TorqueOnShaft]:
    """Those over crank angles."""
    return [load for load in loads if isinstance(load.law, ByAngle)]


def mean_of(load: TorqueOnShaft) -> Array:
    """Mean of one over crank angles, positive where it resists, shape (design,). [N·m]"""
    assert isinstance(load.law, ByAngle)
    return -load.sense * np.array([polyline_mean(lines) for lines in load.law.polylines])


def power_of(load: TorqueOnShaft) -> Power:
    """One that goes with a power of the speed, positive where it resists, shape (design, 1)."""
    assert isinstance(load.law, BySpeed)
    size, at, exponent = (part[..., 0] for part in load.law)
    return Power(-load.sense * size / at**exponent, exponent)


def powers_of(loads: Sequence[TorqueOnShaft], n_designs: int) -> tuple[tuple[Power, ...], Array]:
    """Those that depend on the speed, and the sum of those that are constant, shape (design,). [N·m]"""
    every = [power_of(load) for load in loads if isinstance(load.law, BySpeed)]
    constant = sum((np.where(one.exponent == 0, one.coefficient, 0.0)[:, 0] for one in every), np.zeros(n_designs))
    rising = (Power(np.where(one.exponent == 0, 0.0, one.coefficient), one.exponent) for one in every)
    return tuple(one for one in rising if np.any(one.coefficient)), constant
