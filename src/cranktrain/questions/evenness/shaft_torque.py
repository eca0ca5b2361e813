"""Torque on the shaft: of gas, weight and friction without inertia; and of the loads, which it is to drive."""

from collections.abc import Callable, Iterator, Sequence
from functools import reduce

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.load_laws import ByAngle
from cranktrain.layout.shaft_loads import LoadsOnShafts, TorqueOnShaft
from cranktrain.layout.speed import Speed
from cranktrain.linkage.forces import Drive, Reduced, ReducedInertia, torque_by_work
from cranktrain.motion import ONE, Array
from cranktrain.numerics import in_windows, largest_between
from cranktrain.numerics.periodic import PeriodicCurve, combined, curves_by_design, times
from cranktrain.numerics.polyline import polyline_integral
from cranktrain.questions.evenness.shaft_balance import ShaftBalance, listed, mean_of, power_of, powers_of
from cranktrain.questions.evenness.spec import Balancing
from cranktrain.questions.evenness.speed_law import Power
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.record import record
from cranktrain.references import THEORY_OF_EVENNESS as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Flagged


@record
class AppliedTorque:
    """Torque without inertia.

    Attributes
    ----------
    is_smooth : bool
        Whether nothing but masses and weight acts; gas, friction and loads give the torque kinks.
    """

    is_smooth: bool
    applied_torque: Array = quantity(
        "M_d",
        "N*m",
        ("crank_angle",),
        N_("Torque of gas, weight and friction on the shaft, without inertia"),
        _THEORY,
        "17.16",
    )


def of_steady_running(balancing: Balancing | None, speed: Speed | None) -> bool | str:
    """Whether the machine has a load and runs on as it does; what is asked for at one moment has no load."""
    if speed is not None and speed.curve is not None and speed.curve.moment is not None:
        return N_("steady running, without [shaft.main] acceleration,")
    return Balancing.needs if balancing is None else True


def applied_torque(torques: MechanismTorques, loaded: LoadedMachine, crank_angle: CrankAngle) -> AppliedTorque:
    """Torque that is left without inertia; a file that says nothing of a load has none, nor has one moment.

    Notes
    -----
    The shaft takes M = Jε + ½J′ω² − M_d. Friction that inertia causes stays in M_d as it is at the speed of the run.
    docs/theory/evenness, eq. (17.16).
    """
    drive = loaded.speed.drive(crank_angle.angle)
    equation = Reduced(ReducedInertia(torques.reduced_inertia, torques.reduced_inertia_slope), torques.from_mechanisms)
    applied = torque_by_work(equation, Drive(drive.speed[:, 0], drive.acceleration[:, 0]))
    return AppliedTorque(loaded.gas is None and not loaded.jumps, applied)


@record
class LoadTorque(Flagged):
    """Torque of the loads on the shaft, positive where it resists.

    Attributes
    ----------
    even : Array, shape (design, n)
        What does not depend on the speed. [N·m]
    work : PeriodicCurve or None
        Of that less its mean, from the first point of the grid, exact, (n,), or (design, n); None for none. [J]
    corners : tuple of Array, shape (design, corner)
        Of each load over crank angles, as shown, where its torque has corners. [rad]
    mean, mean_torque : Array, shape (design,)
        Of that; of all loads at the declared speed. [N·m]
    powers : tuple of Power
        What goes with powers of the speed, positive where it resists, shapes (design, 1).
    shape : Power or None
        Of a load that balances the machine and goes with a power of the speed.
    is_scaled : bool
        Whether a load over the crank angle is scaled to balance the machine.
    """

    even: Array
    work: PeriodicCurve | None
    corners: tuple[Array, ...]
    mean: Array
    powers: tuple[Power, ...]
    shape: Power | None
    is_scaled: bool
    mean_torque: Array
    load_torque: Array = quantity(
        "M_r",
        "N*m",
        ("crank_angle",),
        N_("Torque of the loads on the shaft, positive where it resists"),
        _THEORY,
        "17.17",
    )
    load_factor: Array = quantity(
        "c_r",
        "1",
        (),
        N_("What the torques of a load that is listed are multiplied by, to balance the machine"),
        _THEORY,
        "17.17",
    )
    largest_load_torque: Array = quantity(
        "M_r,max", "N*m", (), N_("Largest torque of the loads on the shaft"), _THEORY, "17.17"
    )
    remaining_torque: Array = quantity(
        "M_0",
        "N*m",
        (),
        N_("Mean of the machine's torque that its loads leave; less than 0 where the shaft is driven besides"),
        _THEORY,
        "17.17",
    )


def are_on_shafts(loads: LoadsOnShafts | None) -> bool:
    """Whether there are loads on shafts; without them nothing is missing."""
    return loads is not None


def load_torque(
    loads: LoadsOnShafts,
    applied: AppliedTorque,
    balance: ShaftBalance,
    speed: Speed,
    crank_angle: CrankAngle,
) -> LoadTorque:
    """Torque of the loads on the grid, and its exact work, as given or scaled to the machine's mean.

    Notes
    -----
    docs/theory/evenness, eqs. (17.17) and (17.18).
    """
    left = balance.left
    powers, constant = powers_of(loads.given, len(left))
    balanced = loads.balanced
    factor, shape = np.ones_like(left), None
    if balanced is not None:
        is_listed = isinstance(balanced.law, ByAngle)
        factor = np.where(left > 0, left / (mean_of(balanced) if is_listed else 1.0), np.nan)
        shape = None if is_listed else power_of(balanced)
    scaled = [(load, factor if load.is_balanced else np.ones_like(factor)) for load in listed(loads.each)]
    rises = () if shape is None else (shape.times(left / shape.torque(speed.value[:, 0])[:, 0]),)

    def even(shown: Array) -> Array:
        """What does not depend on the speed, shape (design, n)."""
        parts = (own[:, np.newaxis] * -load.value(shown[:, np.newaxis], ONE)[:, 0] for load, own in scaled)
        return sum(parts, constant[:, np.newaxis] + 0.0 * shown)

    def whole(shown: Array) -> Array:
        """All, shape (design, n)."""
        turning = speed.drive(shown[:, np.newaxis] + crank_angle.zero).speed[:, 0]
        return sum((one.torque(turning) for one in (*powers, *rises)), even(shown))

    mean = constant + sum(own * mean_of(load) for load, own in scaled)
    corners = tuple(load.law.kinks(crank_angle.cycle) for load, _factor in scaled if isinstance(load.law, ByAngle))
    grid = np.broadcast_to(crank_angle.shown, (len(left), crank_angle.shown.size))
    return LoadTorque(
        even=even(grid),
        work=_work(scaled, crank_angle),
        corners=corners,
        mean=mean,
        mean_torque=mean + sum(one.torque(speed.value[:, 0])[:, 0] for one in (*powers, *rises)),
        powers=powers,
        shape=shape,
        is_scaled=balanced is not None and shape is None,
        load_torque=whole(grid),
        load_factor=factor if shape is None else np.where(np.isnan(factor), factor, 1.0),
        largest_load_torque=_largest(whole, corners, crank_angle),
        remaining_torque=left if balanced is None else np.where(np.isnan(factor), left, 0.0),
        flags=tuple(_flags(factor, applied.applied_torque)),
    )


def _work(scaled: Sequence[tuple[TorqueOnShaft, Array]], crank_angle: CrankAngle) -> PeriodicCurve | None:
    """Work of those over crank angles, each with its factor, less their means; None where there are none."""
    curves: list[PeriodicCurve] = []
    for load, factor in scaled:
        assert isinstance(load.law, ByAngle)
        each = [polyline_integral(lines, crank_angle.shown.size, crank_angle.cycle) for lines in load.law.polylines]
        curves.append(times(curves_by_design(each), -load.sense * factor))
    return reduce(lambda one, other: combined(one, ONE, other), curves) if curves else None


def _largest(whole: Callable[[Array], Array], corners: Sequence[Array], crank_angle: CrankAngle) -> Array:
    """Largest torque, between the corners of what is listed, shape (design,). [N·m]"""
    samples = whole(np.broadcast_to(crank_angle.shown, (len(crank_angle.zero), crank_angle.shown.size)))

    def curves(which: NDArray[np.intp], shown: Array) -> Array:
        asked, slot = in_windows(which, shown, len(samples))
        found = whole(asked.reshape(len(samples), -1)).reshape(asked.shape)
        return found[which, slot]

    nowhere = np.full((len(samples), 1), np.nan)
    return largest_between(curves, crank_angle.shown, samples, np.concatenate([nowhere, *corners], axis=-1)).value


def _flags(factor: Array, applied: Array) -> Iterator[Words]:
    """Flag a machine to which no load can be scaled."""
    if np.any(np.isnan(factor) & np.all(np.isfinite(applied), axis=-1)):
        yield _(
            'No steady running: a load with scale = "balanced" is for a machine that gives work;'
            ' "given" takes the torques as they are.'
        )
