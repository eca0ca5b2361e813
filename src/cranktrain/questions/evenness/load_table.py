"""The table of a machine file that names a load curve: torque over the crank angle."""

from collections.abc import Iterator
from typing import ClassVar, Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.cycle_table import CycleFileSpec, Words
from cranktrain.numerics.polyline import Polyline, polyline_mean
from cranktrain.quantities import Dimension


class LoadCurveSpec(CycleFileSpec, frozen=True):
    """Load torque over the crank angle from a file of two columns; it stands beside what balances the rest.

    Whoever loads a machine file also reads the file that `file` names, and puts what it holds into `text`. Torques
    count positive where they resist.
    """

    of_file: ClassVar[frozenset[str]] = CycleFileSpec.of_file | {"torque_unit"}
    words: ClassVar[Words] = Words(
        N_("a load curve"),
        N_("torque"),
        Dimension.TORQUE,
        "torque_unit",
        (
            N_("the file names no unit of torque"),
            N_('write torque_unit = "N·m" (or {units}), or scale = "balanced"'),
        ),
    )

    scale: Literal["given", "balanced"] = Field(
        default="given",
        description=N_(
            "Whether the torques count as given, and the rest of the mean is balanced besides,"
            " or times one factor, so that they balance it."
        ),
    )
    torque_unit: str | None = Field(
        default=None, description=N_("Unit of the torques, where the header does not say it.")
    )

    @property
    def needs_unit(self) -> bool:
        """Whether torques without a unit say nothing: their factor may be found."""
        return self.scale == "given"

    def _curve_problems(self, curve: Polyline) -> Iterator[Problem]:
        """Find a curve that no factor makes a load."""
        if self.scale == "balanced" and not polyline_mean(curve) > 0:
            allowed = _('has a mean torque of 0 or less, which no factor makes a load; write scale = "given"')
            yield Problem("file", self.file, allowed)
