"""What the text on articulated rods states of a slave: the constants of (I.13), beside those of the exact motion."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.errors import problems_as
from cranktrain.io.any_machine import MachineLike, source_of
from cranktrain.language import N_, Words, _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.mechanisms.articulated_rod import ArticulatedRod, articulated_rod
from cranktrain.numerics import extremes
from cranktrain.textbook.alike import alike_places, unspoken
from cranktrain.textbook.statements import Statement, Statements, Verdict
from cranktrain.texts.articulated_rod import (
    SlaveHarmonics,
    derived,
    of_exact_motion,
    own_top_distance,
    reconstructed,
)

SOURCE = "bolotin"
EQUATION = "(I.13)"

_SETS = {
    N_("reconstructed"): reconstructed,
    N_("derived anew"): derived,
    N_("first two harmonics of the exact motion"): of_exact_motion,
}
_SYMBOLS = {"E": "1", "Φ": "rad", "F": "1", "Θ": "rad", "K": "m", "H": "m"}
"""Constants in the order of the formula, with their units; H is the distance to the top."""


class AlikeSlaves(NamedTuple):
    """Slaves with one geometry, and their names."""

    of: str
    rod: ArticulatedRod

    @property
    def top_distance(self) -> float:
        """From the shaft to the exact motion's own top. [m]"""
        return float(extremes(lambda angle: articulated_rod(angle, self.rod).slider.value).largest.value[..., 0])

    @property
    def is_central(self) -> bool:
        """Whether both lines of stroke go through the shaft's centre, as the formula has it."""
        return bool(self.rod.offset == self.rod.master.offset == 0.0)


def constants(
    machine: MachineLike,
    *,
    set: "Mapping[str, object] | None" = None,  # noqa: A002 - as the terminal's --set
) -> Statements:
    """Give the constants of (I.13) of [bolotin] for a machine's slaves on articulated rods.

    Parameters
    ----------
    machine : str, path-like, dict or Machine
        As `cranktrain.run` takes it.
    set : mapping of str, optional
        Other values by path.

    Returns
    -------
    Statements
        Of every distinct slave E, F [1], Φ, Θ [rad], K and the curve's own top distance H [m]: `reconstructed`, as the
        text most likely had them, `derived anew`, and of the `first two harmonics of the exact motion`, which are
        `exact` beside the others. H of the `exact motion` is that of its own top, and `exact` beside every H.

    Raises
    ------
    InputError
        With everything that is wrong; where nothing is on an articulated rod.

    Examples
    --------
    >>> found = constants("3d12")
    >>> [(one.name, round(1e3 * one.value, 3)) for one in found if one.symbol == "H"][-2:]
    [('first two harmonics of the exact motion', 410.095), ('exact motion', 410.0)]
    """
    given = source_of(machine, set)
    with problems_as(given.placed):
        slaves = alike_slaves(given.machine.places)
        if not slaves:
            raise unspoken(given.machine.places, _("must have a piston on an articulated rod"))
        return constants_statements(slaves)


def alike_slaves(places: Sequence[PlacedMechanism]) -> tuple[AlikeSlaves, ...]:
    """Put slaves on articulated rods together that have the same geometry."""
    slaves = [place for place in places if place.kind.is_slave]
    groups = alike_places(slaves, [place.geometry for place in slaves])
    return tuple(AlikeSlaves(of, first.geometry) for of, first in groups)


def constants_statements(slaves: Sequence[AlikeSlaves]) -> Statements:
    """Give them of some slaves.

    Parameters
    ----------
    slaves : sequence of AlikeSlaves

    Returns
    -------
    Statements
        As `constants` has them.
    """
    return Statements(
        _("Constants of {equation} [{source}]", equation=EQUATION, source=SOURCE),
        tuple(found for one in slaves for found in _of_slaves(one)),
        np.zeros(0),
        (),
        {_("What they are"): tuple(_explained(slaves))},
    )


def _of_slaves(one: AlikeSlaves) -> Iterator[Statement]:
    """Every set of constants, and the exact motion's own top."""
    top = one.top_distance
    right = {**_numbers(one, of_exact_motion(one.rod)), "H": top}
    for name, of in _SETS.items():
        for symbol, value in _numbers(one, of(one.rod)).items():
            is_own = of is of_exact_motion and symbol != "H"
            said: Verdict = "right" if is_own else "approximate" if one.is_central else "out of range"
            unit, exact = _SYMBOLS[symbol], right[symbol]
            yield Statement(SOURCE, EQUATION, symbol, _(name), one.of, "", value, unit, said, exact)
    yield Statement(SOURCE, EQUATION, "H", _("exact motion"), one.of, "", top, _SYMBOLS["H"], "right", top)


def _numbers(one: AlikeSlaves, harmonics: SlaveHarmonics) -> dict[str, float]:
    """The constants by their symbols."""
    return dict(zip(_SYMBOLS, map(float, (*harmonics, own_top_distance(one.rod, harmonics))), strict=True))


def _explained(slaves: Sequence[AlikeSlaves]) -> Iterator[Words]:
    """Say what the letters stand for, and where the constants are from."""
    yield _(
        "S = H − K − R[E cos(α_l + Φ) + ¼F cos(2α_l − Θ)], with α_l after the crank points along the slave's cylinder. "
        "The source's constants are illegible: reconstructed, and derived anew. H is the distance from the shaft to "
        "the top of each set's own curve; of the exact motion, to where the piston is highest."
    )
    offset = [one.of for one in slaves if not one.is_central]
    if offset:
        yield _("The formula knows no offset, which {pistons} have.", pistons=", ".join(offset))
