"""A cage motor's numbers from its table: rated point, synchronous speed, the curve, what its size stands for."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import Words, _
from cranktrain.motion import Array, single
from cranktrain.motors.cage.catalogue import four_pole_motors
from cranktrain.motors.cage.keys import CageKeys
from cranktrain.motors.cage.law import (
    CAGE,
    CageCurrent,
    CageMotor,
    CatalogueValues,
    cage_torque,
    catalogue_curve,
    kloss_curve,
)
from cranktrain.motors.declared import UNKNOWN, DeclaredMotor, Rating
from cranktrain.motors.induction.breakdown_slip import contradiction, full_fit, slip_from_rated
from cranktrain.motors.induction.kloss import slip_of
from cranktrain.motors.spec import first
from cranktrain.numerics.ties import first_smallest_along
from cranktrain.quantities import Given

_MOST_APART = 0.1
"""By which a formula may miss what the plate says without a word."""


class Size(NamedTuple):
    """What a size of the small catalogue stands for, one number or shape (design,), in SI."""

    rating: Rating
    synchronous_speed: Array
    breakdown_ratio: Array
    starting_ratio: Array
    pull_up_ratio: Array
    inertia: Array
    starting_current_ratio: Array
    efficiency: Array
    power_factor: Array


def place_of(size: Given) -> NDArray[np.intp]:
    """Place of a size in the small catalogue, the nearest one."""
    return first_smallest_along(np.abs(four_pole_motors().power - np.expand_dims(size.array, -1)))


def of_size(spec: CageKeys) -> Size:
    """What the size of a table stands for; NaN where it has none."""
    if spec.size is None:
        return Size(Rating(), *(UNKNOWN,) * 8)
    motors, place = four_pole_motors(), place_of(spec.size)
    values = motors.values
    rest = (
        values.synchronous_speed,
        values.breakdown_ratio,
        values.starting_ratio,
        values.pull_up_ratio,
        motors.inertia,
        motors.starting_current_ratio,
        motors.efficiency,
        motors.power_factor,
    )
    return Size(Rating(values.rated_torque[place], values.rated_speed[place]), *(number[place] for number in rest))


def rating_of(spec: CageKeys) -> Rating:
    """Rated point of the table, or of its size."""
    return of_size(spec).rating if spec.size is not None else spec.rating


def synchronous_speed_of(spec: CageKeys) -> Array:
    """Synchronous speed of the table, or of its size. [rad/s]"""
    return of_size(spec).synchronous_speed if spec.size is not None else spec.field_speed


def ratio_of(spec: CageKeys, name: str) -> Array:
    """A ratio of the table, or that of its size; NaN where neither has it."""
    given: Given | None = getattr(spec, name)
    return getattr(of_size(spec), name) if given is None else given.array


def catalogue_values(spec: CageKeys) -> CatalogueValues:
    """Rated point and ratios; where the table has no pull-up torque, it is that at standstill."""
    rating, start, pull_up = rating_of(spec), ratio_of(spec, "starting_ratio"), ratio_of(spec, "pull_up_ratio")
    pull_up = np.where(np.isnan(pull_up), start, np.minimum(pull_up, start))
    breakdown = ratio_of(spec, "breakdown_ratio")
    return CatalogueValues(rating.torque, rating.speed, synchronous_speed_of(spec), breakdown, start, pull_up)


def cage_curve(spec: CageKeys) -> CageMotor:
    """Curve of a table, at the voltage that is there."""
    values = catalogue_values(spec)
    if spec.curve == "catalogue":
        return at_voltage(catalogue_curve(values, spec.pull_up_slip.array), spec.voltage_ratio.array)
    slip, asymmetry = _kloss_slip(spec, values)
    torque = values.breakdown_ratio * values.rated_torque
    torque = torque if spec.breakdown_torque is None else spec.breakdown_torque.array
    return at_voltage(kloss_curve(values.synchronous_speed, torque, slip, asymmetry), spec.voltage_ratio.array)


def _kloss_slip(spec: CageKeys, values: CatalogueValues) -> tuple[Array, Array]:
    """Breakdown slip and asymmetry of Kloss's formula: written, or through the points of the plate."""
    if spec.breakdown_slip is not None:
        return spec.breakdown_slip.array, single(0.0) if spec.asymmetry is None else spec.asymmetry.array
    rated_slip = slip_of(values.rated_speed, values.synchronous_speed)
    breakdown = breakdown_over_rated(spec)
    if spec.curve == "kloss":
        return slip_from_rated(rated_slip, breakdown), single(0.0)
    return full_fit(rated_slip, breakdown, values.starting_ratio)


def breakdown_over_rated(spec: CageKeys) -> Array:
    """Breakdown torque in parts of the rated one, whichever way it is given."""
    if spec.breakdown_torque is not None:
        return spec.breakdown_torque.array / rating_of(spec).torque
    return ratio_of(spec, "breakdown_ratio")


def at_voltage(motor: CageMotor, ratio: Array) -> CageMotor:
    """The same motor at another voltage: all torques go with its square. docs/theory/drive, section Starters."""
    part = ratio * ratio
    return motor._replace(
        breakdown_torque=part * motor.breakdown_torque,
        pull_up_torque=part * motor.pull_up_torque,
        starting_torque=part * motor.starting_torque,
    )


def declared_cage(spec: CageKeys) -> DeclaredMotor:
    """Motor of a table, direct on line or by its starter."""
    curve = cage_curve(spec)
    start = ratio_of(spec, "starting_current_ratio") * spec.voltage_ratio.array
    is_known = not np.any(np.isnan(start))
    direct = DeclaredMotor(
        CAGE,
        curve,
        rating_of(spec),
        curve.synchronous_speed,
        spec.rotor_inertia,
        CageCurrent(curve.synchronous_speed, curve.breakdown_slip, start) if is_known else None,
        UNKNOWN if spec.rated_current is None else spec.rated_current.array,
        notes=tuple(cage_notes(spec)),
        flags=tuple(cage_flags(spec)),
    )
    return direct if spec.starter is None else spec.starter.started(direct)


def cage_notes(spec: CageKeys) -> Iterator[Words]:
    """What was taken where the table says nothing; of the first design."""
    if spec.size is not None:
        said = _("{size}: typical values of a four-pole motor at 50 Hz, nobody's catalogue.")
        yield said.format(size=spec.size.text)
    else:
        yield from spec.field_notes()
    if spec.curve == "catalogue" and spec.size is None and spec.pull_up_ratio is None:
        yield _("The pull-up torque is that at standstill.")


def cage_flags(spec: CageKeys) -> Iterator[Words]:
    """Where Kloss's formula contradicts the plate; of the first design."""
    if spec.curve == "kloss" and (said := contradiction_text(spec)):
        yield said
    if spec.curve != "catalogue" and spec.breakdown_slip is not None:
        rating, curve = rating_of(spec), cage_curve(spec)
        torque, rated = (first(number) for number in (cage_torque(rating.speed, curve), rating.torque))
        if abs(torque / rated - 1) > _MOST_APART:
            said = _("Kloss's formula has {torque} N·m at the rated speed, where the plate says {rated} N·m.")
            yield said.format(torque=f"{torque:.4g}", rated=f"{rated:.4g}")


def contradiction_text(spec: CageKeys) -> Words | None:
    """Say how far Kloss's simplified formula is off at standstill, where it passes through the rated point.

    None where the plate does not say both, or they go together within 10 %.
    """
    values = catalogue_values(spec)
    slip = slip_of(values.rated_speed, values.synchronous_speed)
    found = contradiction(slip, breakdown_over_rated(spec), values.starting_ratio)
    by_rated, wanted = first(found.start_by_rated), first(values.starting_ratio)
    if spec.breakdown_slip is not None or not abs(by_rated / wanted - 1) > _MOST_APART:
        return None
    said = _(
        "Kloss's formula through the rated point has {start} times the rated torque at standstill, where the plate "
        'says {wanted}: the bars of real cages are deep. curve = "catalogue" passes through both.'
    )
    return said.format(start=f"{by_rated:.2f}", wanted=f"{wanted:.3g}")
