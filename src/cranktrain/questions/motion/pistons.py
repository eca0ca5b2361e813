"""Motion of pistons: displacement and its derivatives by the crank angle; with the speed, velocities."""

from collections.abc import Callable

import numpy as np

from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Pistons
from cranktrain.layout.speed import Speed, SpeedCurve, rates
from cranktrain.linkage.forces import Drive
from cranktrain.mechanisms.output import OutputPart
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import DERIVATIVES_LIMIT, Extreme, Extremes, derivatives_residual, extremes
from cranktrain.numerics.tops import chosen
from cranktrain.questions.motion.dead_centres import DeadCentres, PistonGrid, PistonTurn, slider_motion
from cranktrain.record import record
from cranktrain.references import THEORY_OF_SLIDER_CRANKS as _THEORY
from cranktrain.saying.catalogue import coefficients, extreme, quantity
from cranktrain.saying.checks import Check, Checked, Flagged, Limit, flagged

_PISTON = ("piston",)
_CURVE = ("piston", "crank_angle")
_ALIKE = 1e-9
"""Speeds of both strokes that differ by less, relative, are one; the one toward the shaft is named."""


@record
class PistonMotion(Checked):
    """Motion of every piston by the crank angle alone; speed enters with `PistonSpeeds`."""

    piston_displacement: Coefficient = coefficients(
        "x",
        "m",
        _CURVE,
        N_("Travel of the piston from its true top toward the shaft"),
        N_("Piston velocity for each rad/s of the crank"),
        N_("Piston acceleration for each (rad/s)² of the crank"),
        _THEORY,
        "2.3 to 2.5",
    )


def piston_motion(grid: PistonGrid, turn: PistonTurn, dead_centres: DeadCentres) -> PistonMotion:
    """Displacement from the true top toward the shaft and its derivatives; docs/theory/slider-crank, eq. (2.5)."""
    slider = grid.value.slider
    travel = dead_centres.top_position[..., np.newaxis] - slider.value
    return PistonMotion(Coefficient(travel, -slider.first, -slider.second), checks=(_derivatives_check(turn),))


def _derivatives_check(turn: PistonTurn) -> Check:
    """Compare x′ and x″ with the derivatives of the Fourier series of x and x′, which know no mechanism formula."""
    pistons = turn.distinct
    residual = derivatives_residual(lambda alpha: slider_motion(pistons.mechanisms, alpha), turn.samples.slider)
    return Check(
        "piston_derivatives",
        _("x′ and x″ against the derivatives of the Fourier series of x and x′, relative to their peaks"),
        np.max(pistons.spread(residual), axis=(1, 2)),
        DERIVATIVES_LIMIT,
    )


# Formula 1 of 2007: 300 cm³ on 98 mm are a stroke of 39.8 mm, at 19000 rpm 25.2 m/s. Top Fuel: 4.5 in at 8400 rpm
# are 32 m/s, for four seconds.
_MEAN_SPEED = Limit(
    30.0, "m/s", N_("A mean piston speed of {value} is more than any piston bears: are speed and stroke right?")
)
_SLIDER_SPEED = Limit(
    _MEAN_SPEED.most, "m/s", N_("A mean speed of {value} is more than sliders bear: are speed and stroke right?")
)


@record
class PistonSpeeds(Flagged):
    """Velocities and accelerations of pistons; outputs: as of `DeadCentres`."""

    outputs: tuple[OutputPart, ...]
    piston_velocity: Array = quantity("v", "m/s", _CURVE, N_("Piston velocity toward the shaft"), _THEORY, "2.5")
    piston_acceleration: Array = quantity(
        "j", "m/s^2", _CURVE, N_("Piston acceleration toward the shaft"), _THEORY, "2.5"
    )
    mean_piston_speed: Array = quantity("c_m", "m/s", _PISTON, N_("Mean piston speed, 2 S n"), _THEORY, "2.13")
    largest_piston_speed: Extreme = extreme(
        "|v|_max",
        "m/s",
        _PISTON,
        N_("Largest piston speed, toward the shaft or away from it"),
        N_("Crank angle of the largest piston speed"),
        _THEORY,
        "2.5",
        worst="largest",
    )
    largest_piston_velocity: Extreme = extreme(
        "v_max",
        "m/s",
        _PISTON,
        N_("Largest piston velocity toward the shaft"),
        N_("Crank angle of the largest velocity toward the shaft"),
        _THEORY,
        "2.5",
        worst="largest",
        of="piston_velocity",
    )
    smallest_piston_velocity: Extreme = extreme(
        "v_min",
        "m/s",
        _PISTON,
        N_("Largest piston velocity away from the shaft, negative"),
        N_("Crank angle of the largest velocity away from the shaft"),
        _THEORY,
        "2.5",
        worst="smallest",
        of="piston_velocity",
    )
    largest_piston_acceleration: Extreme = extreme(
        "j_max",
        "m/s^2",
        _PISTON,
        N_("Largest piston acceleration toward the shaft"),
        N_("Crank angle of the largest acceleration toward the shaft"),
        _THEORY,
        "2.5",
        worst="largest",
        of="piston_acceleration",
    )
    smallest_piston_acceleration: Extreme = extreme(
        "j_min",
        "m/s^2",
        _PISTON,
        N_("Largest piston acceleration away from the shaft, negative"),
        N_("Crank angle of the largest acceleration away from the shaft"),
        _THEORY,
        "2.5",
        worst="smallest",
        of="piston_acceleration",
    )


def piston_speeds(
    pistons: Pistons,
    crank_angle: CrankAngle,
    turn: PistonTurn,
    motion: PistonMotion,
    dead_centres: DeadCentres,
    speed: Speed,
) -> PistonSpeeds:
    """Velocities q′ω, accelerations q″ω² + q′ε, and their extremes; docs/theory/slider-crank, eq. (2.5)."""
    drive = speed.drive(crank_angle.angle)
    velocity, acceleration = rates(motion.piston_displacement, drive)
    if speed.curve is None:
        found = _at_constant_speed(turn, speed.value)
    else:
        found = _over_cycle(pistons, crank_angle, speed.curve, velocity, acceleration)
    period = 2 * np.pi if speed.curve is None else crank_angle.cycle
    slowest, fastest, least, most = (
        Extreme(crank_angle.counted(one.angle, period)[..., 0], one.value[..., 0]) for pair in found for one in pair
    )
    # Without an offset both are alike but for rounding, which must not choose.
    is_away = -slowest.value > fastest.value * (1 + _ALIKE)
    mean_speed = dead_centres.stroke * (speed.mean / np.pi)[..., 0]
    return PistonSpeeds(
        outputs=dead_centres.outputs,
        piston_velocity=velocity,
        piston_acceleration=acceleration,
        mean_piston_speed=mean_speed,
        largest_piston_speed=chosen(is_away, slowest._replace(value=-slowest.value), fastest),
        largest_piston_velocity=fastest,
        smallest_piston_velocity=slowest,
        largest_piston_acceleration=most,
        smallest_piston_acceleration=least,
        unlikely=(
            *flagged(_MEAN_SPEED, mean_speed[:, [one.has_chambers for one in dead_centres.outputs]]),
            *flagged(
                _SLIDER_SPEED,
                mean_speed[:, [one.is_loaded and not one.has_chambers for one in dead_centres.outputs]],
            ),
        ),
    )


def _at_constant_speed(turn: PistonTurn, omega: Array) -> tuple[Extremes, Extremes]:
    """Extremes of velocity and acceleration over a turn, φ and value of shape (design, piston, 1)."""
    different = turn.distinct

    def toward_shaft(order: int, factor: Array) -> Extremes:
        away, toward = (
            Extreme(different.angle(one.angle[order]), -different.spread(one.value[order]) * factor)
            for one in reversed(turn.peaks)
        )
        return Extremes(away, toward)

    return toward_shaft(1, omega), toward_shaft(2, omega**2)


def _over_cycle(
    pistons: Pistons, crank_angle: CrankAngle, curve: SpeedCurve, velocity: Array, acceleration: Array
) -> tuple[Extremes, Extremes]:
    """The same over a cycle, at a speed that varies: like pistons differ, as each has its own phase."""

    def toward_shaft(order: int, drive: Callable[[Array], Drive]) -> Callable[[Array], Array]:
        def rate(shown: Array) -> Array:
            phi = shown + crank_angle.zero
            return -rates(slider_motion(pistons, phi), drive(phi))[order]

        return rate

    def from_zero(found: Extremes) -> Extremes:
        return Extremes(*(Extreme(one.angle + crank_angle.zero, one.value) for one in found))

    grid = crank_angle.shown
    # Of one moment the crank has an acceleration by which the velocity does not change from angle to angle.
    slope = toward_shaft(1, curve.along_angle)
    of_speed = extremes(toward_shaft(0, curve.drive), slope, grid=grid, samples=velocity)
    return from_zero(of_speed), from_zero(extremes(toward_shaft(1, curve.drive), grid=grid, samples=acceleration))
