"""What every machine declares, whatever is asked of it: its mechanisms, shafts, frames and speed as SI arrays."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.axial import axial_places_of
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.frames import frames_of
from cranktrain.layout.mechanisms import Mechanisms, Pistons, Rockers, mechanisms_of
from cranktrain.layout.question import ResultDimension, TableFile
from cranktrain.layout.shafts import shafts_of
from cranktrain.layout.specs import MAIN
from cranktrain.layout.speed import Speed
from cranktrain.layout.speed_curve import speed_at_moment
from cranktrain.layout.speed_table import tabled_speed
from cranktrain.layout.throws import shaft_centres_of, throws_of
from cranktrain.mechanisms import KINDS

_OF_MECHANISMS = "mechanism"

DIMENSIONS = (
    ResultDimension("design", N_("design"), is_number=True),
    ResultDimension("crank_angle", N_("crank angle"), is_number=True),
    *(
        ResultDimension(name, "", family=_OF_MECHANISMS)
        for name in (_OF_MECHANISMS, Pistons.dimension, Rockers.dimension, *(kind.name for kind in KINDS))
    ),
    ResultDimension("throw", N_("throw")),
    ResultDimension("shaft", ""),
    ResultDimension("journal", N_("journal")),
    ResultDimension("order", N_("order"), is_number=True),
)
"""Those that questions share."""

FILES = (TableFile(("shaft", "main", "speed_curve"), None, N_("a speed curve")),)


def laid_out(designs: Sequence[Design], *, cycle: float, step: float) -> Designs:
    """Lay out designs of one machine on a grid of crank angles; cycle and step in radians."""
    n_angles = round(cycle / step)
    grid = CrankAngle(
        shown=np.arange(n_angles, dtype=np.float64) * cycle / n_angles,
        zero=np.array([[[design.zero]] for design in designs]),
        cycle=cycle,
    )
    pistons, rockers = ([design.driving(output) for design in designs] for output in ("slider", "rocker"))
    return Designs(
        each=tuple(designs),
        crank_angle=grid,
        mechanisms=mechanisms_of(Mechanisms, [design.places for design in designs]),
        pistons=mechanisms_of(Pistons, pistons) if any(pistons) else None,
        rockers=mechanisms_of(Rockers, rockers) if any(rockers) else None,
    )


def layout_parts(designs: Designs) -> Iterator[object | None]:
    """Parts of every machine; None stands for what is not declared."""
    places, shafts = designs.places, [design.shafts for design in designs.each]
    yield designs.crank_angle
    yield designs.mechanisms
    yield from (batch.members for batch in designs.mechanisms.batches)
    yield designs.pistons
    yield designs.rockers
    yield axial_places_of(shafts, places)
    yield frames_of(places, [design.orientation for design in designs.each])
    yield throws_of(places[0])
    yield shaft_centres_of(shafts, places)
    yield shafts_of(shafts[0], places[0])
    yield from _speed_parts(designs)


def _speed_parts(designs: Designs) -> Iterator[object | None]:
    """What the file says of how the main shaft turns; None stands for a curve that it has not."""
    shafts = [design.shafts[MAIN] for design in designs.each]
    grid = designs.crank_angle
    speeds = np.array([shaft.speed.si for shaft in shafts if shaft.speed is not None])
    accelerations = np.array([shaft.acceleration.si for shaft in shafts if shaft.acceleration is not None])
    curves = [shaft.speed_curve for shaft in shafts if shaft.speed_curve is not None]
    curve = None
    if accelerations.size:
        curve = speed_at_moment(speeds, accelerations, grid.cycle, zero=grid.zero)
    elif curves:
        curve = tabled_speed(curves, grid.shown.size, grid.cycle, zero=grid.zero)
    if speeds.size:
        yield Speed(speeds[:, np.newaxis, np.newaxis], curve)
    elif curve is not None:
        yield Speed(curve.mean, curve)
    yield curve
