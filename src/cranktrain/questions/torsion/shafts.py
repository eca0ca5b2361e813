"""A piece of shaft between two discs: its stiffness as a number, or by its length, its diameter and its metal."""

from collections.abc import Iterator

import numpy as np
from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.listed import OneOrMany
from cranktrain.motion import ZERO, Array
from cranktrain.quantities import Given, NonNegativeLength, PositiveLength, PositivePressure, PositiveTorsionalStiffness
from cranktrain.saying.wording import as_limit
from cranktrain.spec import Spec

STEEL = Given(206e9 / 2.6, "79.23 GPa")
"""Shear modulus of steel: of 206 GPa and Poisson's ratio 0.3."""
_ALIKE = 0.01
"""By how much a stiffness that is given may be off that of the sizes beside it: makers round theirs."""
_SIZES = ("length", "diameter")


class ShaftPieceSpec(Spec, frozen=True):
    """A shaft that twists: by its stiffness, or by length and diameter, of one part or of several in a row."""

    stiffness: PositiveTorsionalStiffness | None = Field(
        default=None, description=N_("Torque by twist of the shaft; or give its length and diameter.")
    )
    length: OneOrMany[PositiveLength] | None = Field(
        default=None, description=N_("Length of the shaft that twists; of a stepped one a list, part by part.")
    )
    diameter: OneOrMany[PositiveLength] | None = Field(
        default=None, description=N_("Diameter of the shaft; of a stepped one a list, part by part.")
    )
    bore: OneOrMany[NonNegativeLength] | None = Field(
        default=None, description=N_("Bore of the shaft, one or one for each part; none unless given.")
    )
    shear_modulus: PositivePressure | None = Field(
        default=None, description=N_("Shear modulus of the shaft; that of steel, 79.23 GPa, unless given.")
    )

    @property
    def is_elastic(self) -> bool:
        """Whether it says how it twists."""
        return self.stiffness is not None or self.length is not None

    @property
    def torsional_stiffness(self) -> Array:
        """Stiffness as given, or by its sizes, πG/32Λ; docs/theory/torsion, eq. (23.21). [N·m/rad]"""
        return self._by_sizes if self.stiffness is None else self.stiffness.array

    @property
    def _by_sizes(self) -> Array:
        lengths, diameters = self.length or (), self.diameter or ()
        bores = self.bore or ()
        n = max(len(lengths), len(diameters), len(bores))
        parts = zip(*(_each(values, n) for values in (lengths, diameters, bores or (None,))), strict=True)
        reduced = sum((one / (outer**4 - inner**4) for one, outer, inner in parts), start=ZERO)
        return np.pi / 32 * (self.shear_modulus or STEEL).array / reduced

    def _problems(self) -> Iterator[Problem]:
        """Find a shaft of no length or no diameter, lists that do not go together, and two stiffnesses."""
        given = [name for name in (*_SIZES, "bore", "shear_modulus") if getattr(self, name) is not None]
        missing = [name for name in _SIZES if name not in given]
        if given and missing:
            allowed = _("is missing; a shaft twists by its length and its diameter")
            yield from (Problem(name, None, allowed) for name in missing)
        elif given:
            yield from self._list_problems() or self._size_problems()

    def _list_problems(self) -> list[Problem]:
        """Find lists that are not as long as others."""
        listed = {name: len(getattr(self, name) or (None,)) for name in (*_SIZES, "bore")}
        longest = max(listed.values())
        allowed = _("must be one value, or one for each of {n} parts", n=longest)
        short = [name for name, n in listed.items() if n not in (1, longest)]
        if listed["length"] == 1 < longest:
            short.append("length")
            allowed = _("must be one for each of {n} parts: {n} lengths one behind another", n=longest)
        return [Problem(name, _("a list of {n}", n=listed[name]), allowed) for name in short]

    def _size_problems(self) -> Iterator[Problem]:
        """Find bores that leave nothing, and a stiffness that is not that of the sizes."""
        n = len(self.length or ())
        for outer, inner in zip(_each(self.diameter or (), n), _each(self.bore or (None,), n), strict=True):
            if inner >= outer:
                allowed = _("must be less than the diameter, {diameter}", diameter=as_limit(float(outer)))
                yield Problem("bore", as_limit(float(inner)), allowed)
                return
        if self.stiffness is not None and abs(self.stiffness.si / float(self._by_sizes) - 1) > _ALIKE:
            allowed = _("must be that of its length and diameter, {stiffness} N·m/rad; keep one of the two")
            said = allowed.format(stiffness=f"{float(self._by_sizes):.4g}")
            yield Problem("stiffness", self.stiffness.text, said)


def _each(values: tuple[Given, ...] | tuple[None], n: int) -> list[Array]:
    """As many numbers as there are parts; 0 of what is not given."""
    found = [ZERO if one is None else one.array for one in values]
    return found * n if len(found) == 1 else found
