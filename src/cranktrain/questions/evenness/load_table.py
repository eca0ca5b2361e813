"""The table of a machine file that names a load curve, and the file read: torque over the crank angle."""

from functools import lru_cache
from typing import ClassVar, Literal, Self

from pydantic import Field, model_validator

from cranktrain.errors import InputError, Problem
from cranktrain.language import N_, _
from cranktrain.layout.cycle_table import CycleFileSpec, Words, cycle_table, refuse_unit
from cranktrain.numerics.polyline import Polyline, polyline_mean
from cranktrain.quantities import Dimension, read, unit_names

_WORDS = Words(N_("a load curve"), N_("torque"))


class LoadCurveSpec(CycleFileSpec, frozen=True):
    """Load torque over the crank angle from a file of two columns; it stands beside what balances the rest.

    Whoever loads a machine file also reads the file that `file` names, and puts what it holds into `text`.
    """

    of_file: ClassVar[frozenset[str]] = CycleFileSpec.of_file | {"torque_unit"}

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

    @model_validator(mode="after")
    def _readable(self) -> Self:
        """Refuse a unit that is none, and a file that cannot be read as a load curve."""
        refuse_unit("torque_unit", self.torque_unit, Dimension.TORQUE)
        if self.text is not None:
            load_polyline(self)
        return self


@lru_cache(maxsize=8)
def load_polyline(spec: LoadCurveSpec) -> Polyline:
    """Read the load curve that the spec holds.

    Parameters
    ----------
    spec : LoadCurveSpec

    Returns
    -------
    Polyline
        Torque, positive where it resists, over the crank angle as it is shown, with the period of one turn or two.
        [rad, N·m]

    Raises
    ------
    InputError
        With all that is wrong in the file, at line and column; or if nobody has read it.
    """
    table = cycle_table(spec, Dimension.TORQUE, _WORDS)
    problems = [*table.problems]
    torque_unit = spec.torque_unit or table.unit
    if torque_unit is None and spec.scale == "given":
        problems.append(_missing_unit())
    if problems:
        raise InputError(problems)
    factor = 1.0 if torque_unit is None else read(f"1 {torque_unit}", Dimension.TORQUE)
    curve = Polyline(table.angles, table.values * factor, table.period)
    if spec.scale == "balanced" and not polyline_mean(curve) > 0:
        allowed = _('has a mean torque of 0 or less, which no factor makes a load; write scale = "given"')
        raise InputError([Problem("file", spec.file, allowed)])
    return curve


def _missing_unit() -> Problem:
    """Refuse torques without a unit, where they are to count as they are."""
    allowed = _("the file names no unit of torque")
    repair = _('write torque_unit = "N·m" (or {units}), or scale = "balanced"')
    return Problem("torque_unit", None, allowed, repair.format(units=", ".join(unit_names(Dimension.TORQUE))))
