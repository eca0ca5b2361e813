"""The table of a machine file that names an indicator diagram, and what it says beside the file."""

from collections.abc import Iterator
from functools import lru_cache
from math import pi
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from cranktrain.columns import n_rows, row_of
from cranktrain.errors import Problem
from cranktrain.fluids.fluid import FluidSpec
from cranktrain.fluids.indicator.card import Card, CardNumbers, Peg
from cranktrain.fluids.indicator.diagram import Interpolation
from cranktrain.fluids.indicator.placing import Sense
from cranktrain.fluids.indicator.reading import AXES, STANDARD_ATMOSPHERE, Axis, Columns, Trace, read_trace
from cranktrain.language import N_, _
from cranktrain.listed import FileColumns, FileText
from cranktrain.number_table import held_text
from cranktrain.quantities import Dimension, Given, PositivePressure, Quantity, TurnedAngle, is_unit, one_of, unit_names
from cranktrain.spec import Spec

Exponent = Annotated[Given, Quantity(Dimension.RATIO, above=1.0, at_most=2.0)]
KnownAngle = Annotated[Given, Quantity(Dimension.ANGLE, example="-180 deg")]
Width = Annotated[Given, Quantity(Dimension.ANGLE, above=0.0, at_most=pi / 12)]


class PegSpec(Spec, frozen=True):
    """How the level of the pressures is found: by one known pressure, or by the exponent of the compression."""

    pressure: PositivePressure | None = Field(
        default=None, description=N_("Known absolute pressure at `angle`, such as the inlet manifold's at the bottom.")
    )
    angle: KnownAngle = Field(
        default=Given(-pi, "-180 deg"), description=N_("Where that pressure is known, from the firing dead centre.")
    )
    exponent: Exponent | None = Field(
        default=None, description=N_("Exponent n of p·Vⁿ = const in the compression, instead of a pressure.")
    )
    start: TurnedAngle = Field(
        default=Given(-100 * pi / 180, "-100 deg"),
        description=N_("Where that piece of the compression begins, from the firing dead centre."),
    )
    end: TurnedAngle = Field(
        default=Given(-65 * pi / 180, "-65 deg"),
        description=N_("Where that piece of the compression ends, from the firing dead centre."),
    )

    def _problems(self) -> Iterator[Problem]:
        """Find both ways together, neither, and a piece that is no compression."""
        if (self.pressure is None) == (self.exponent is None):
            yield Problem("", None, _("must have either pressure or exponent"))
        elif self.exponent is not None and not -pi <= self.start.si < self.end.si <= 0:
            allowed = _("start and end must lie within the compression, -180 deg to 0 deg, one after the other")
            yield Problem("", None, allowed)


class IndicatorSpec(FluidSpec, frozen=True):
    """Indicator diagram from a file of two columns, pressure over crank angle, volume or displacement.

    Whoever loads a machine file also reads the file that `file` names, and puts what it holds into `text`.
    """

    kind: Literal["indicator"] = Field(description=N_("Kind of gas model."))
    file: str = Field(min_length=1, description=N_("File with the diagram, relative to the machine file."))
    text: FileText = None
    columns: FileColumns = Field(
        default=None,
        min_length=2,
        max_length=2,
        description=N_("Columns of axis and pressure, counted from 1; by the header unless given."),
    )
    axis: Axis | None = Field(
        default=None, description=N_("What pressures are given over; by the header unless given.")
    )
    axis_unit: str | None = Field(default=None, description=N_("Unit of the axis, where the header does not say it."))
    pressure_unit: str | None = Field(
        default=None, description=N_("Unit of the pressures, where the header does not say it.")
    )
    pressure: Literal["absolute", "gauge"] | None = Field(
        default=None, description=N_("What pressures count from; by the header unless given, or else absolute.")
    )
    ambient: PositivePressure = Field(
        default=Given(STANDARD_ATMOSPHERE, "101.325 kPa"), description=N_("What gauge pressures count from.")
    )
    firing_angle: TurnedAngle | None = Field(
        default=None, description=N_("The file's angle of the firing dead centre; found by the peak unless given.")
    )
    sense: Sense = Field(
        default="forward",
        description=N_("Whether the file's angles count with the rotation, against it, or as the pressures say."),
    )
    peg: PegSpec | None = Field(default=None, description=N_("How the level is found that the sensor does not know."))
    smoothing: Width | None = Field(
        default=None, description=N_("Width σ over which noise is smoothed; none unless given.")
    )
    interpolation: Interpolation = Field(
        default="limited",
        description=N_(
            "Curve through the samples: cubics whose slopes are limited at corners and plateaus, or the cubic spline,"
            " which rings there."
        ),
    )
    unrolling: Literal["exact", "brix"] = Field(
        default="exact", description=N_("How displacements become crank angles: exactly, or by Brix's construction.")
    )

    def _problems(self) -> list[Problem]:
        """Find units that are none, and what cannot be read as a diagram in the file."""
        wrong = [
            Problem(path, unit, one_of(unit_names(dimension)))
            for path, unit, dimension in (
                ("axis_unit", self.axis_unit, AXES[self.axis or "angle"]),
                ("pressure_unit", self.pressure_unit, Dimension.PRESSURE),
            )
            if unit is not None and not is_unit(unit, dimension)
        ]
        if self.text is not None and not wrong:
            trace_of(self)
        return wrong


@lru_cache(maxsize=8)  # asked for by every chamber
def trace_of(spec: IndicatorSpec) -> Trace:
    """Read the diagram that the spec holds.

    Parameters
    ----------
    spec : IndicatorSpec

    Returns
    -------
    Trace

    Raises
    ------
    InputError
        With what is wrong in the file, at line and column; or if nobody has read it.
    """
    said = Columns(
        columns=None if spec.columns is None else (spec.columns[0], spec.columns[1]),
        axis=spec.axis,
        axis_unit=spec.axis_unit,
        pressure_unit=spec.pressure_unit,
        is_gauge=None if spec.pressure is None else spec.pressure == "gauge",
        ambient=spec.ambient.si,
        is_raw=spec.peg is not None or spec.smoothing is not None,
    )
    return read_trace(held_text(spec.file, spec.text), spec.file, said)


def card_of(spec: IndicatorSpec) -> CardNumbers:
    """Give the card that the table names, in SI: of several designs together one for each."""
    cards = np.empty(n_rows(spec), dtype=np.object_)
    for design in range(cards.size):
        cards[design] = _card(row_of(spec, design))
    return CardNumbers(cards)


def _card(spec: IndicatorSpec) -> Card:
    """Give the card of one design."""
    peg = spec.peg
    return Card(
        trace=trace_of(spec),
        firing_angle=None if spec.firing_angle is None else spec.firing_angle.si,
        sense=spec.sense,
        peg=None
        if peg is None
        else Peg(
            pressure=None if peg.pressure is None else peg.pressure.si,
            angle=peg.angle.si,
            exponent=None if peg.exponent is None else peg.exponent.si,
            start=peg.start.si,
            end=peg.end.si,
        ),
        smoothing=None if spec.smoothing is None else spec.smoothing.si,
        interpolation=spec.interpolation,
        unrolling=spec.unrolling,
    )
