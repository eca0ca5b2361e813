"""Stiffness of the crankshaft from throw to throw: as given, and by its sizes, method beside method."""

from collections.abc import Iterator
from dataclasses import field

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest, first_smallest
from cranktrain.questions.crankshaft.bending.throw_stiffness import THROW_METHODS, ShaftInTorsion
from cranktrain.questions.crankshaft.metal.throw_gaps import ThrowSizes, gaps_of, ker_wilson_web
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.crankshaft.shaft_layout import ShaftLayout, ShaftLayouts
from cranktrain.questions.torsion.parts import DeclaredTrain
from cranktrain.record import record
from cranktrain.references import THEORY_OF_TORSION as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Flagged

GIVEN = "given"
"""The name of what the file gives, among the methods."""
_FAR = 2.0
"""By what factor a given stiffness may be off what the sizes give before it is minded."""


@record
class ThrowStiffness(Flagged):
    """Stiffness from throw to throw.

    chosen: int, the method with whose stiffness the shaft vibrates.
    """

    throw_stiffness: Array = quantity(
        "k",
        "N*m/rad",
        ("throw_method", "throw_gap"),
        N_("Stiffness of the crankshaft from the middle of a throw's pin to that of the next"),
        _THEORY,
        "23.13 to 23.21",
    )
    throw_stiffness_spread: Array = quantity(
        "Δk/k",
        "1",
        ("throw_gap",),
        N_("By how much the largest stiffness by any method is above the smallest, relative to this"),
        _THEORY,
        "23.13 to 23.21",
    )
    chosen: int = field(kw_only=True)

    @property
    def chosen_stiffness(self) -> Array:
        """That with which the shaft vibrates, shape (design, gap). [N·m/rad]"""
        return self.throw_stiffness[:, self.chosen]

    def softest(self, design: int) -> int | None:
        """The gap that is softest, the first of several; None where the shaft has no stiffness."""
        own = self.chosen_stiffness[design]
        return first_smallest(own) if np.all(np.isfinite(own)) else None


def of_sized_crankshaft(train: DeclaredTrain, crankshafts: DeclaredCrankshafts | None) -> bool:
    """Whether there are throws to twist against each other, and the file has the crankshaft's sizes."""
    return crankshafts is not None and len(crankshafts.each) == 1 and train.throws.size > 1


def throw_stiffness(declared: DeclaredTrain, layouts: ShaftLayouts) -> ThrowStiffness:
    """Stiffness by all methods, beside what is given; docs/theory/torsion, eqs. (23.13) to (23.21)."""
    shaft = _in_torsion(layouts.each[0])
    by_size = {method.name: method.stiffness(shaft) for method in THROW_METHODS}
    given = declared.stiffness[:, declared.gaps]
    has_given = np.any(np.isfinite(given))
    if has_given and declared.method is not None:
        given = np.where(np.isnan(given), by_size[declared.method], given)
    found = ({GIVEN: given} if has_given else {}) | by_size
    values = np.stack(list(found.values()), axis=1)
    least, most = np.fmin.reduce(values, axis=1), np.fmax.reduce(values, axis=1)
    n_gaps = values.shape[-1]
    return ThrowStiffness(
        throw_stiffness=values,
        throw_stiffness_spread=most / least - 1,
        chosen=0 if has_given or declared.method is None else list(found).index(declared.method),
        labels={
            "throw_method": tuple(found),
            "throw_gap": tuple(f"{throw}-{throw + 1}" for throw in range(1, n_gaps + 1)),
        },
        flags=tuple(_flags(declared, shaft, by_size)),
    )


def title_of(name: str) -> Words:
    """How answers call a method."""
    return _("given") if name == GIVEN else next(_(method.title) for method in THROW_METHODS if method.name == name)


def _in_torsion(layout: ShaftLayout) -> ShaftInTorsion:
    """Put a shaft's sizes together as both frames and rules read them."""
    declared = layout.declared
    of_one_size = ~np.isin(np.arange(declared.journals.size), declared.shoulders.journal)
    there = (declared.journals & of_one_size)[np.newaxis, :, np.newaxis]
    sizes = ThrowSizes(
        declared.planes,
        layout.shaft.pieces.radius[:, layout.pins],
        np.where(there, declared.journal, np.nan),
        declared.pin,
        declared.pin_length,
        declared.web_width,
        declared.web_thickness,
    )
    return ShaftInTorsion(layout.shaft, layout.pins, gaps_of(sizes), declared.material.shear)


def _flags(declared: DeclaredTrain, shaft: ShaftInTorsion, by_size: dict[str, Array]) -> Iterator[Words]:
    """Mind webs that Ker Wilson's rule does not know, a method that has no number, and one far from what is given."""
    if np.any(ker_wilson_web(shaft.gaps) <= 0):
        yield _("Ker Wilson's rule is out of its range: the crank radius is not more than a fifth of both diameters.")
    given, of_frame = declared.stiffness[:, declared.gaps], by_size[THROW_METHODS[0].name]
    if declared.method is not None and np.any(np.isnan(given) & ~np.isfinite(by_size[declared.method])):
        yield _("{method} gives no stiffness between throws that one web joins.", method=title_of(declared.method))
    ratio = np.where(np.isnan(given), 1.0, given / of_frame)
    if np.any(np.maximum(ratio, 1 / ratio) > _FAR):
        yield _(
            "The given stiffness between throws is {ratio} times what the crankshaft's sizes give.",
            ratio=f"{float(ratio.ravel()[first_largest(np.abs(np.log(ratio)))]):.3g}",
        )
