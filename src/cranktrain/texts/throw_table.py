"""A throw by the symbols of fig. 35 of [crankshaft-reactions], as a small table that a user writes."""

from collections.abc import Iterable, Iterator, Mapping
from typing import Literal, NamedTuple

import numpy as np
from pydantic import ConfigDict

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.quantities import Given, written
from cranktrain.quantities.fields import Force, NonNegativeLength
from cranktrain.questions.crankshaft.methods.throw_reactions import ThrowForces, ThrowLengths, throw_length
from cranktrain.spec import Spec, validated

CHAIN = ("l1", "hL", "l2", "l3", "l4", "l5", "hP", "l6")
"""Lengths whose sum is l, from the left support to the right one."""

Rods = Literal["one", "two", "articulated"]
"""On the pin: one, two side by side, or a master with what hangs on it."""

_OF_SECOND_ROD = ("K2", "T2", "C5")


def symbol_of(name: str) -> str:
    """Give the symbol of a field: c11 is C11, h_l is hL, l_p1 is lP1."""
    head, _mark, rest = name.partition("_")
    is_force = not rest and head[1:].isdigit() and not head.startswith("l")
    return head.upper() if is_force else f"{head}{rest.upper()}"


class ThrowTable(Spec, frozen=True):
    """A throw between two supports: lengths and forces by the source's own symbols; forces left out are 0."""

    model_config = ConfigDict(alias_generator=symbol_of)

    rods: Rods = "one"
    l1: NonNegativeLength
    h_l: NonNegativeLength
    l2: NonNegativeLength
    l3: NonNegativeLength | None = None
    l4: NonNegativeLength | None = None
    l5: NonNegativeLength
    h_p: NonNegativeLength
    l6: NonNegativeLength
    l_p1: NonNegativeLength | None = None
    l_p2: NonNegativeLength | None = None
    c1: Force | None = None
    c2: Force | None = None
    c3: Force | None = None
    c4: Force | None = None
    c5: Force | None = None
    c6: Force | None = None
    c7: Force | None = None
    c8: Force | None = None
    c9: Force | None = None
    c10: Force | None = None
    c11: Force | None = None
    c12: Force | None = None
    c13: Force | None = None
    c14: Force | None = None
    c15: Force | None = None
    k1: Force | None = None
    k2: Force | None = None
    t1: Force | None = None
    t2: Force | None = None

    def _problems(self) -> Iterator[Problem]:
        yield from self._of_rods()
        for length, radial, across in (("lP1", self.c11, self.c10), ("lP2", self.c13, self.c12)):
            if getattr(self, _field(length)) is None and not (radial is None and across is None):
                forces = "C10, C11" if length == "lP1" else "C12, C13"
                allowed = _("is missing: from the support to the external counterweight of {forces}")
                yield Problem(length, None, allowed.format(forces=forces))
        if not float(throw_length(self.lengths)) > 0.0:
            yield Problem("", None, _("must have a length: l = {chain} is 0", chain=" + ".join(CHAIN)))

    def _of_rods(self) -> Iterator[Problem]:
        """Refuse what a throw with so many rods cannot have, and ask for what it must."""
        if self.rods == "two":
            for name in ("l3", "l4"):
                if getattr(self, name) is None:
                    allowed = _("is missing: of two rods side by side, from a rod's axis to the middle of the pin")
                    yield Problem(name, None, allowed)
            return
        reasons = {
            "one": _('must be left out: there is one rod; for two side by side write rods = "two"'),
            "articulated": _(
                "must be left out: an articulated pair loads the pin by one resultant, K1 and T1 on the master's axis"
            ),
        }
        for key in _OF_SECOND_ROD:
            given = getattr(self, _field(key))
            if given is not None:
                yield Problem(key, given.text, reasons[self.rods])

    @property
    def lengths(self) -> ThrowLengths:
        """Lengths by the formulas' names; those that are left out are 0. [m]"""
        return ThrowLengths(*(_number(getattr(self, name)) for name in ThrowLengths._fields))

    @property
    def forces(self) -> ThrowForces:
        """Forces by the formulas' names; those that are left out are 0. [N]"""
        return ThrowForces(*(_number(getattr(self, name)) for name in ThrowForces._fields))


class Throw(NamedTuple):
    """A throw of fig. 35: its lengths [m], its forces [N], and its rods: one, two side by side, or articulated."""

    lengths: ThrowLengths
    forces: ThrowForces
    rods: Rods = "one"


def read_throw(data: Mapping[str, object]) -> Throw:
    """Read a throw's table.

    Parameters
    ----------
    data : mapping
        By the symbols of fig. 35: l1 … l6, hL, hP, lP1, lP2, C1 … C15, K1, T1, K2, T2, each text with its unit; and
        `rods`, which is "one" unless given.

    Returns
    -------
    Throw

    Raises
    ------
    InputError
        With everything that is wrong.

    Examples
    --------
    >>> sizes = {"l1": "14 mm", "hL": "22 mm", "l2": "15 mm", "l5": "15 mm", "hP": "22 mm", "l6": "14 mm"}
    >>> throw = read_throw({**sizes, "K1": "20 kN"})
    >>> float(throw.forces.k1), round(float(throw_length(throw.lengths)), 6)
    (20000.0, 0.102)
    """
    found = list(_no_inputs(data))
    kept = {key: value for key, value in data.items() if key not in _NO_INPUTS}
    try:
        table = validated(ThrowTable, kept)
    except InputError as error:
        raise InputError([*found, *error.problems]) from None
    refuse(found)
    return Throw(table.lengths, table.forces, table.rods)


_NO_INPUTS = ("l", "l7")


def _no_inputs(data: Mapping[str, object]) -> Iterable[Problem]:
    """Refuse lengths of the figure that are no inputs."""
    if "l" in data:
        yield Problem("l", written(data["l"]), _("is no input: it is {chain}", chain=" + ".join(CHAIN)), _("delete it"))
    if "l7" in data:
        yield Problem("l7", written(data["l7"]), _("occurs in none of (44) to (53)"), _("delete it"))


def _field(key: str) -> str:
    """Field of a symbol."""
    return next(name for name in ThrowTable.model_fields if symbol_of(name) == key)


def _number(given: Given | None) -> Array:
    """SI value of a number that may be left out."""
    return np.array(0.0 if given is None else given.si)
