"""Leads: whether every cylinder of a bank of opposed pistons has the lead that the bank declares."""

from collections.abc import Iterator, Mapping

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.layout.specs import MAIN, BankSpec, ShaftSpec, throws_of
from cranktrain.motion import Array
from cranktrain.numerics import around_zero
from cranktrain.wording import precise, shared

_ALIKE = np.radians(0.02)
"""Throws of seven cylinders are written as 51.43°: leads that differ by less are one. [rad]"""


def lead_problems(shafts: Mapping[str, ShaftSpec], banks: Mapping[str, BankSpec]) -> Iterator[Problem]:
    """Find leads that only the first cylinder of a bank has.

    Parameters
    ----------
    shafts : mapping of name to ShaftSpec
        Whose phases give the first cylinder of every bank its lead.
    banks : mapping of name to BankSpec
        On shafts and throws that there are.

    Yields
    ------
    Problem
        With every cylinder's lead, and what would give all of them the one that is declared.

    Notes
    -----
    Δ_i = Δ + r_e (θ_e,i − θ_e,1) − r_s (θ_s,i − θ_s,1): docs/theory/opposed-pistons, eq. (18.8) of two cylinders.
    """
    for name, bank in banks.items():
        if bank.lead is None:
            continue
        exhaust, scavenge = (_turned(shafts, bank, end) for end in ("exhaust", "scavenge"))
        more = around_zero(exhaust - scavenge)
        if np.any(np.abs(more) > _ALIKE):
            cylinders = [str(i) for i in range(1, more.size + 1)]
            allowed = _("is that of its first cylinder alone: as the throws stand, the leads are {leads}").format(
                leads=shared(cylinders, around_zero(bank.lead.si + more), "deg")
            )
            yield Problem(f"bank.{name}.lead", bank.lead.text, allowed, _repair(shafts, bank))


def _turned(shafts: Mapping[str, ShaftSpec], bank: BankSpec, end: str) -> Array:
    """How far the crank of each cylinder's piston stands ahead of the first one's, in its own sense. [rad]"""
    shaft = shafts[bank.opposed[end].shaft]
    throws = np.array([shaft.throws[throw - 1].si for throw in throws_of(bank.opposed[end], shafts)])
    return shaft.ratio * (throws - throws[0])


def _repair(shafts: Mapping[str, ShaftSpec], bank: BankSpec) -> str:
    """Say which throws of the shaft that is not the main one give all cylinders one lead, or which ratio does."""
    end, other = ("exhaust", "scavenge") if bank.opposed["scavenge"].shaft == MAIN else ("scavenge", "exhaust")
    name = bank.opposed[end].shaft
    shaft, wanted = shafts[name], _turned(shafts, bank, other)
    angles: Array = np.array([throw.si for throw in shaft.throws])
    own = [throw - 1 for throw in throws_of(bank.opposed[end], shafts)]
    angles[own] = np.mod(np.round(angles[own[:1]] + shaft.ratio * wanted, 12), 2 * np.pi)
    listed = ", ".join(f'"{precise(angle, "deg")}"' for angle in angles.tolist())
    repair = _("all have it with shaft.{name}.throws = [{angles}]").format(name=name, angles=listed)
    if np.all(np.abs(around_zero(wanted + _turned(shafts, bank, end))) <= _ALIKE):
        repair = _("{repair}, or with shaft.{name}.ratio = {ratio}").format(
            repair=repair, name=name, ratio=-shaft.ratio
        )
    return repair
