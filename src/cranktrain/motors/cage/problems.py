"""What is wrong with the table of a cage motor, seen together."""

from collections.abc import Iterator

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import Words, _
from cranktrain.motors.cage.catalogue import four_pole_motors
from cranktrain.motors.cage.keys import CageKeys
from cranktrain.motors.cage.numbers import (
    breakdown_over_rated,
    cage_curve,
    catalogue_values,
    place_of,
    rating_of,
    ratio_of,
)
from cranktrain.motors.induction.breakdown_slip import slip_from_rated
from cranktrain.motors.induction.kloss import slip_of
from cranktrain.motors.spec import first, missing_keys, out_of_place
from cranktrain.quantities import Given, shown
from cranktrain.saying.wording import as_limit

_OF_SIZE = ("power", "torque", "speed", "synchronous_speed", "frequency", "poles")
"""What a size says by itself; torques by their ratios, current and inertia may be the maker's."""
_ROUNDING = 1e-9


def cage_problems(spec: CageKeys) -> Iterator[Problem]:
    """Find what does not go together: first what is missing or too much, then numbers."""
    ways = [*_plate_problems(spec), *_curve_problems(spec)]
    yield from ways
    speeds = [] if spec.size is not None else [*spec.field_problems()]
    yield from speeds
    ratios = [*_ratio_problems(spec)]
    yield from ratios
    if not (ways or speeds or ratios):
        yield from _fit_problems(spec)


def _plate_problems(spec: CageKeys) -> Iterator[Problem]:
    """A size with what it says by itself, or one that the catalogue has not; a plate without its point."""
    if spec.size is not None:
        yield from out_of_place(spec, _OF_SIZE, _("must not stand beside size, which says it"))
        powers = four_pole_motors().power
        power = powers[place_of(spec.size)]
        if abs(power / spec.size.si - 1) > _ROUNDING:
            listed = ", ".join(f"{shown(float(one), 'kW'):g}" for one in powers)
            nearest = _('write "{size} kW"', size=f"{shown(float(power), 'kW'):g}")
            yield Problem("size", spec.size.text, _("must be one of {listed} kW", listed=listed), nearest)
    elif spec.has_no_plate and not _is_by_formula(spec):
        allowed = _('is missing; give power and speed of the plate, or size = "7.5 kW" of a typical motor')
        yield Problem("power", None, allowed)


def _is_by_formula(spec: CageKeys) -> bool:
    """Whether it needs no rated point."""
    return spec.curve != "catalogue" and spec.breakdown_torque is not None and spec.breakdown_slip is not None


def _curve_problems(spec: CageKeys) -> Iterator[Problem]:
    """Keys that another curve is made by, and those that this one needs."""
    if spec.curve == "catalogue":
        of_kloss = ("breakdown_torque", "breakdown_slip", "asymmetry")
        yield from out_of_place(spec, of_kloss, _('is for curve = "kloss" or "kloss_full"'))
        if spec.size is None:
            yield from missing_keys(spec, ("breakdown_ratio", "starting_ratio"))
        return
    yield from out_of_place(spec, ("pull_up_ratio",), _('is for curve = "catalogue"'))
    if spec.curve == "kloss":
        yield from out_of_place(spec, ("asymmetry",), _('is for curve = "kloss_full"'))
    elif (spec.breakdown_slip is None) != (spec.asymmetry is None):
        yield from missing_keys(spec, ("breakdown_slip", "asymmetry"))
    elif spec.breakdown_slip is None and spec.size is None:
        yield from missing_keys(spec, ("starting_ratio",))
    if spec.breakdown_torque is not None:
        yield from out_of_place(spec, ("breakdown_ratio",), _("must not stand beside breakdown_torque"))
    elif spec.size is None:
        yield from missing_keys(spec, ("breakdown_ratio",))


def _ratio_problems(spec: CageKeys) -> Iterator[Problem]:
    """Torques in the wrong order."""
    breakdown, start = first(breakdown_over_rated(spec)), first(ratio_of(spec, "starting_ratio"))
    if spec.breakdown_torque is not None and breakdown <= 1:
        rated = as_limit(first(rating_of(spec).torque), "N·m")
        allowed = _("must be above the rated torque, {rated}", rated=rated)
        yield Problem("breakdown_torque", spec.breakdown_torque.text, allowed)
    if start > breakdown:
        yield Problem("starting_ratio", *_beyond(spec.starting_ratio, start, "breakdown_ratio", breakdown))
    pull_up = spec.pull_up_ratio
    if pull_up is not None and pull_up.si > start:
        yield Problem("pull_up_ratio", *_beyond(pull_up, pull_up.si, "starting_ratio", start))


def _beyond(given: Given | None, size: float, key: str, limit: float) -> tuple[str, Words]:
    """What was given, and that it must not be above another one."""
    allowed = _("must be at most {key} = {limit}", key=key, limit=f"{limit:g}")
    return f"{size:g}" if given is None else given.text, allowed


def _fit_problems(spec: CageKeys) -> Iterator[Problem]:
    """A curve that cannot be: a breakdown beyond the pull-up, a full formula through points that it cannot have."""
    values = catalogue_values(spec)
    if spec.curve == "catalogue":
        rated_slip = slip_of(values.rated_speed, values.synchronous_speed)
        slip = first(slip_from_rated(rated_slip, values.breakdown_ratio))
        if slip >= spec.pull_up_slip.si:
            allowed = _(
                "must be more than the breakdown slip {slip}, which follows from rated point and breakdown_ratio; a "
                'motor of high slip is better given by curve = "kloss"'
            )
            yield Problem("pull_up_slip", spec.pull_up_slip.text, allowed.format(slip=f"{slip:.4g}"))
    elif spec.curve == "kloss_full" and spec.breakdown_slip is None:
        curve = cage_curve(spec)
        asymmetry = first(curve.asymmetry)
        if np.isnan(asymmetry) or asymmetry >= 2:
            allowed = _(
                "cannot pass through rated point and start with an asymmetry below 2, beyond which it has a pole "
                "where the motor generates"
            )
            yield Problem("curve", spec.curve, allowed, _('write curve = "catalogue"'))
