"""What every machine declares, whatever is asked of it: its mechanisms, shafts, frames and speed as SI arrays."""

from collections.abc import Iterator, Sequence
from typing import TypeVar

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.frames import frames_of
from cranktrain.layout.mechanisms import Mechanisms, Pistons, Rockers, mechanisms_of
from cranktrain.layout.question import ResultDimension, TableFile
from cranktrain.layout.shafts import axial_places_of, shaft_centres_of, shafts_of, throws_of
from cranktrain.layout.specs import MAIN
from cranktrain.layout.speed import Speed, speed_at_moment
from cranktrain.layout.speed_table import tabled_speed
from cranktrain.mechanisms import KINDS
from cranktrain.numerics.designs import by_design

Driving = TypeVar("Driving", bound=Mechanisms)

_OF_MECHANISMS = "mechanism"

DIMENSIONS = (
    ResultDimension("design", N_("design"), is_number=True),
    ResultDimension("crank_angle", N_("crank angle"), is_number=True),
    *(
        ResultDimension(name, "", family=_OF_MECHANISMS)
        for name in (_OF_MECHANISMS, Pistons.dimension, Rockers.dimension, *KINDS.names)
    ),
    ResultDimension("throw", N_("throw")),
    ResultDimension("shaft", ""),
    ResultDimension("journal", N_("journal")),
    ResultDimension("order", N_("order"), is_number=True),
)
"""Those that questions share."""

FILES = (TableFile(("shaft", "main", "speed_curve"), None, N_("a speed curve")),)


def laid_out(each: Sequence[Design], together: Design, *, cycle: float, step: float) -> Designs:
    """Lay out designs of one machine on a grid of crank angles; cycle and step in radians."""
    n_angles, n_designs = round(cycle / step), len(each)
    grid = CrankAngle(
        shown=np.arange(n_angles, dtype=np.float64) * cycle / n_angles,
        zero=by_design([together.zero], n_designs)[..., np.newaxis],
        cycle=cycle,
    )
    mechanisms = mechanisms_of(Mechanisms, together.places, n_designs)
    return Designs(
        each=tuple(each),
        together=together,
        crank_angle=grid,
        mechanisms=mechanisms,
        pistons=_driving(Pistons, together, mechanisms, "slider"),
        rockers=_driving(Rockers, together, mechanisms, "rocker"),
    )


def _driving(result: type[Driving], together: Design, every: Mechanisms, part: str) -> Driving | None:
    """Stack those of the mechanisms that drive a "slider" or a "rocker", mostly all of them; None where none does."""
    places = together.driving(part)
    if not places:
        return None
    if len(places) == len(together.places):
        return result(every.names, every.banks, every.batches, every.nominal_top)
    return mechanisms_of(result, places, len(every.nominal_top))


def layout_parts(designs: Designs) -> Iterator[object | None]:
    """Parts of every machine; None stands for what is not declared."""
    places, shafts, n_designs = designs.places, designs.together.shafts, designs.n_designs
    yield designs.crank_angle
    yield designs.mechanisms
    yield from (batch.members for batch in designs.mechanisms.batches)
    yield designs.pistons
    yield designs.rockers
    yield axial_places_of(shafts, places, n_designs)
    yield frames_of(places, designs.together.orientation, n_designs)
    yield throws_of(places)
    yield shaft_centres_of(shafts, places, n_designs)
    yield shafts_of(shafts, places)
    yield from _speed_parts(designs)


def _speed_parts(designs: Designs) -> Iterator[object | None]:
    """What the file says of how the main shaft turns; None stands for a curve that it has not."""
    main, grid = designs.together.shafts[MAIN], designs.crank_angle
    speed = None if main.speed is None else designs.by_design([main.speed.array])
    curve = None
    if speed is not None and main.acceleration is not None:
        acceleration = designs.by_design([main.acceleration.array])
        curve = speed_at_moment(speed[:, 0], acceleration[:, 0], grid.cycle, zero=grid.zero)
    elif main.speed_curve is not None:
        tables = (design.shafts[MAIN].speed_curve for design in designs.each)
        curves = [table for table in tables if table is not None]
        curve = tabled_speed(curves, grid.shown.size, grid.cycle, zero=grid.zero)
    if main.motion is not None:
        from cranktrain.layout.wish.declared import WantedMotions, wanted_speed, wish_parts  # for whom it is given

        wanted = wish_parts(designs)
        if isinstance(wanted, WantedMotions):
            curve = wanted_speed(wanted, grid.shown.size, grid.cycle, zero=grid.zero)
        yield wanted
    if speed is not None:
        yield Speed(speed[..., np.newaxis], curve)
    elif curve is not None:
        yield Speed(curve.mean, curve)
    yield curve
