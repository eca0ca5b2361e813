"""Evenness of running: its table of the machine file, and the parts that it declares."""

from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.design import Designs
from cranktrain.motion import Array
from cranktrain.quantities import (
    Dimension,
    Given,
    NonNegativeInertia,
    PositiveDensity,
    PositiveLength,
    PositiveRatio,
    PositiveVelocity,
    Quantity,
    ShareFromZero,
)
from cranktrain.questions.evenness.rim import RimDemand
from cranktrain.questions.evenness.speed_over_cycle import Mean
from cranktrain.record import record
from cranktrain.spec import Spec

NonNegativeMoment = Annotated[Given, Quantity(Dimension.FLYWHEEL_MOMENT, at_least=0.0)]
Coefficient = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, below=2.0)]


class RimSpec(Spec, frozen=True):
    """Rim of the flywheel, of rectangular section."""

    mean_diameter: PositiveLength = Field(description=N_("Diameter of the middle of the rim's section."))
    width_ratio: PositiveRatio = Field(
        default=Given(1.0, "1"), description=N_("Width of the rim along the shaft over the height of its section.")
    )
    other_share: ShareFromZero = Field(
        default=Given(0.0, "0"),
        description=N_("What arms, disc and hub bring of the flywheel's moment of inertia, as a share of it."),
    )
    density: PositiveDensity = Field(
        default=Given(7200.0, "7200 kg/m³"), description=N_("Density of the rim; that of cast iron unless given.")
    )
    largest_speed: PositiveVelocity = Field(
        default=Given(30.0, "30 m/s"),
        description=N_("Speed that the rim's outside bears; 30 m/s, as cast iron, unless given [machinerys-handbook]."),
    )


class EvennessSpec(Spec, frozen=True):
    """The flywheel of a machine, and how evenly it is to run."""

    elsewhere: ClassVar = {
        **dict.fromkeys(("delta", "δ"), "coefficient"),
        **dict.fromkeys(("j", "i", "inertia"), "flywheel"),
        **dict.fromkeys(("gd2", "gd²"), "flywheel_moment"),
    }

    flywheel: NonNegativeInertia | None = Field(
        default=None,
        description=N_(
            "Moment of inertia of flywheel and rotor: all that turns with the shaft and is not in [masses]."
        ),
    )
    flywheel_moment: NonNegativeMoment | None = Field(
        default=None, description=N_("GD², four times the flywheel's moment of inertia; instead of flywheel.")
    )
    coefficient: Coefficient | None = Field(
        default=None,
        description=N_(
            "Coefficient of fluctuation wanted, largest less smallest speed over the mean: twice the ± value."
        ),
    )
    mean: Literal["time", "extremes"] = Field(
        default="time",
        description=N_("Which mean [shaft.main] speed is: over time, or half the sum of largest and smallest speed."),
    )
    rim: RimSpec | None = Field(default=None, description=N_("Rim of the flywheel, to be given its section."))

    def _problems(self) -> Iterator[Problem]:
        """Find a flywheel given twice, and a rim without a flywheel."""
        if self.flywheel is not None and self.flywheel_moment is not None:
            allowed = _("must not stand beside flywheel; GD² = 4 J says the same")
            yield Problem("flywheel_moment", None, allowed)
        if self.rim is not None and self.inertia is None and self.coefficient is None:
            allowed = _("needs a flywheel: give flywheel or flywheel_moment, or coefficient for the one that it takes")
            yield Problem("rim", None, allowed)

    @property
    def inertia(self) -> Array | None:
        """Moment of inertia of the flywheel, however it is given; None where it is not. [kg·m²]"""
        if self.flywheel is not None:
            return self.flywheel.array
        return None if self.flywheel_moment is None else self.flywheel_moment.array / 4


@record
class Balancing:
    """What balances the mean of the machine and its loads, where no load does: a motor, or a constant torque.

    mean says which mean its speed is.
    """

    needs: ClassVar[str] = N_("[evenness]")

    mean: Mean


@record
class DrivenByMotor:
    """Says that a motor drives the machine: it balances it, and gives it its mean speed."""

    needs: ClassVar[str] = N_("[drive.motor]")


@record
class GivenFlywheel:
    """Moment of inertia of the flywheel that there is, shape (design,). [kg·m²]"""

    needs: ClassVar[str] = N_("[evenness] flywheel or flywheel_moment")

    inertia: Array


@record
class WantedCoefficient:
    """Coefficient of fluctuation wanted, shape (design,). [1]"""

    needs: ClassVar[str] = N_("[evenness] coefficient")

    value: Array


@record
class DeclaredRim:
    """Rim wanted, arrays of shape (design,): what its fields say in `RimSpec`, in SI."""

    needs: ClassVar[str] = N_("[evenness.rim] mean_diameter")

    demand: RimDemand
    largest_speed: Array


def evenness_parts(spec: EvennessSpec, designs: Designs) -> Iterator[object]:
    """Give the parts that the table of all designs declares."""

    def each(number: Array) -> Array:
        return designs.by_design([number])[:, 0]

    yield Balancing(spec.mean)
    if spec.inertia is not None:
        yield GivenFlywheel(each(spec.inertia))
    if spec.coefficient is not None:
        yield WantedCoefficient(each(spec.coefficient.array))
    if spec.rim is not None:
        demand = RimDemand(*(each(getattr(spec.rim, name).array) for name in RimDemand._fields))
        yield DeclaredRim(demand, each(spec.rim.largest_speed.array))
