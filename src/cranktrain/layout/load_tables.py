"""Loads: what a machine works against, or what drives it besides the gas; their tables of the machine file."""

from collections.abc import Iterator, Mapping
from typing import Annotated, Literal, TypeAlias

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.quantities import (
    Angle,
    Dimension,
    Force,
    Given,
    Length,
    PositiveLength,
    PositiveSpeed,
    PositiveVelocity,
    Quantity,
)
from cranktrain.spec import Spec

Torque = Annotated[Given, Quantity(Dimension.TORQUE)]
Exponent = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, at_most=10.0)]

_AT = ("along", "across", "radius")


class LoadSpec(Spec, frozen=True):
    """A force on a link or a slider, or a torque on a link.

    A resisting load is always against the motion of its point, as friction or a cut; an active one has a direction of
    its own, as a weight or a spring. Beside `at_speed` the size goes with a power of the speed: exponent 1 is viscous.
    """

    on: str = Field(min_length=1, description=N_("What it acts on: a part of a mechanism, as [masses] names them."))
    force: Force | None = Field(default=None, description=N_("Size of a force, or give a torque."))
    torque: Torque | None = Field(default=None, description=N_("Size of a torque on a link, or give a force."))
    sense: Literal["resisting", "active"] = Field(
        default="resisting", description=N_("Always against the motion, or in a direction of its own.")
    )
    direction: Angle | None = Field(
        default=None,
        description=N_("Of a force, from the mechanism's x in the sense of rotation; of a slider's along its guide."),
    )
    along: Length | None = Field(
        default=None, description=N_("Where a force acts: from the link's first pin toward its second.")
    )
    across: Length | None = Field(default=None, description=N_("Where a force acts: to the left of the line of pins."))
    radius: PositiveLength | None = Field(
        default=None, description=N_("Of a force across a link that turns: its arm about the link's first pin.")
    )
    at_speed: PositiveVelocity | None = Field(
        default=None, description=N_("Speed of its point at which the force has its size.")
    )
    at_turning: PositiveSpeed | None = Field(
        default=None, description=N_("Speed of its link at which the torque has its size.")
    )
    exponent: Exponent | None = Field(
        default=None, description=N_("Of the speed, with which the size goes; 1 unless given: viscous.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find a load of no sort or of two, and what belongs to another."""
        if (self.force is None) == (self.torque is None):
            wrong = _("is missing; give force or torque") if self.force is None else _("must not stand beside torque")
            yield Problem("force", None if self.force is None else self.force.text, wrong)
        foreign = (*_AT, "direction", "at_speed") if self.force is None else ("at_turning",)
        allowed = _("is for a force") if self.force is None else _("is for a torque")
        yield from (Problem(name, None, allowed) for name in foreign if getattr(self, name) is not None)
        if self.radius is not None:
            beside = _("must not stand beside radius, which says where the force acts")
            yield from (Problem(name, None, beside) for name in _AT[:2] if getattr(self, name) is not None)
        size = self.force or self.torque
        if self.sense == "resisting" and size is not None and size.si < 0:
            allowed = _('must be at least 0 of a load that resists; sense = "active" gives it a direction')
            yield Problem("force" if self.force else "torque", size.text, allowed)
        if self.exponent is not None and self.at_speed is None and self.at_turning is None:
            yield Problem("exponent", self.exponent.text, _("needs at_speed, or of a torque at_turning"))


LoadTables: TypeAlias = Mapping[str, Mapping[str, LoadSpec]]
"""Loads by the path of their tables, `load` or `bank.B.load`, and by name."""
