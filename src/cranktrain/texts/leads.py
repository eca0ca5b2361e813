"""The rule of [bolotin] for the lead of opposed pistons: its ranges, as data, and what is outside them, and why.

Of the exhaust crank: 10–15° in engines that turn one way, 5–10° in those that reverse, because astern the lead Δ is
−Δ: if it is more than the ports' heights give, the scavenge ports open first, and gas blows back into the receiver.
"""

from collections.abc import Iterator, Sequence
from math import isfinite, nan
from typing import NamedTuple

import numpy as np

from cranktrain.grouping import places_of_equal
from cranktrain.language import N_, Listed, Words, _
from cranktrain.motion import Array
from cranktrain.quantities import shown
from cranktrain.saying.wording import number, ranged

SOURCE = "bolotin"
_ROUNDING = np.radians(1e-3)
"""Leads are written in whole or tenths of a degree; those of throws at 51.43° have a little more. [rad]"""
_DECIMALS = 2
"""Of degrees: leads that are alike in these are said once."""


class LeadRange(NamedTuple):
    """Leads that suit some engines [rad], and in words which and how much."""

    least: float
    most: float
    engines: str
    condition: str

    def holds(self, lead: float) -> bool:
        """Tell whether a lead is in the range."""
        return self.least - _ROUNDING <= lead <= self.most + _ROUNDING


ONE_WAY = LeadRange(np.radians(10.0), np.radians(15.0), N_("engines that turn one way"), "10–15°")
REVERSING = LeadRange(np.radians(5.0), np.radians(10.0), N_("engines that reverse"), "5–10°")


def verdict(lead: float) -> Words:
    """Say which engines a lead suits by the source's rule.

    Parameters
    ----------
    lead : float
        Δ of the exhaust crank, in the sense in which the engine runs; less than 0 it is behind, as of an engine that
        reverses and runs astern. [rad]

    Returns
    -------
    Words

    Examples
    --------
    >>> print(verdict(np.radians(12.0)))
    suits engines that turn one way (10–15°), too much for engines that reverse (5–10°)
    """
    said = Listed(tuple(_one_verdict(one, abs(lead)) for one in _ranges(lead)))
    return _("behind, as only astern: {verdict}", verdict=said) if lead < 0 else said


def reasons(lead: float, opens_before: float = nan, closes_before: float = nan) -> Iterator[Words]:
    """Say what a lead does to the ports, as it turns and with the same metal turning the other way.

    Parameters
    ----------
    lead : float
        Δ of the exhaust crank. [rad]
    opens_before, closes_before : float
        By how much the exhaust ports open and close before the scavenge ports; NaN where no ports are known. [rad]

    Yields
    ------
    Words

    Notes
    -----
    The ports' heights alone open the exhaust ports by s sooner, so the lead by s + Δ; the other way by s − Δ, which is
    the closing of the ports read backwards.

    Examples
    --------
    >>> print(list(reasons(*np.radians([12.0, 17.81, 6.19])))[-1])
    The ports' heights alone give the exhaust ports 5.81 deg: a lead of more than that blows back astern.
    """
    if not isfinite(opens_before + closes_before):
        yield from _without_ports(lead)
        return
    yield _("As it turns, the exhaust ports open {gap}.", gap=_gap(opens_before, _("the scavenge ports")))
    yield _(
        "With the same metal turning the other way the lead is {lead}, and they open {gap}.",
        lead=number(0.0 - lead, "deg"),
        gap=_gap(-closes_before, _("them")),
    )
    by_height = lead - closes_before if lead >= 0 else opens_before - lead
    if by_height > 0:
        yield _(
            "The ports' heights alone give the exhaust ports {head}: a lead of more than that blows back astern.",
            head=number(by_height, "deg"),
        )
    else:
        yield _("The ports' heights alone do not open the exhaust ports sooner: any lead blows back astern.")


def _gap(opens_before: float, others: Words) -> Words:
    """Say by how much the exhaust ports open before others, and what follows if they open after them."""
    size = number(abs(opens_before), "deg")
    if opens_before >= 0:
        return _("{angle} before {others}", angle=size, others=others)
    return _("{angle} after {others}: gas blows back into the receiver", angle=size, others=others)


def _without_ports(lead: float) -> Iterator[Words]:
    """Say what holds whatever the ports are."""
    yield _("A lead opens the exhaust ports by as much sooner, so that the pressure has fallen when the others open.")
    if abs(lead) > _ROUNDING:
        yield _(
            "With the same metal turning the other way the lead is {lead}: it opens them by as much later. If the "
            "ports' heights do not make up for that, the scavenge ports open first, and gas blows back into the "
            "receiver.",
            lead=number(-lead, "deg"),
        )
    yield _("With exhaust_port and scavenge_port this is computed.")


def is_unsuited(lead: float) -> bool:
    """Tell whether a lead [rad] is in none of the ranges that the engine may belong to; NaN is no lead."""
    return isfinite(lead) and not any(one.holds(abs(lead)) for one in _ranges(lead))


def _ranges(lead: float) -> tuple[LeadRange, ...]:
    """Ranges that an engine may belong to: one that runs astern reverses."""
    return (REVERSING,) if lead < 0 else (ONE_WAY, REVERSING)


def _one_verdict(one: LeadRange, size: float) -> Words:
    """Say whether a range holds a lead, or what the lead is for it."""
    words = (
        _("suits {engines} ({range})")
        if one.holds(size)
        else _("too little for {engines} ({range})")
        if size < one.least
        else _("too much for {engines} ({range})")
    )
    return words.format(engines=_(one.engines), range=one.condition)


def lead_flags(cylinders: Sequence[str], leads: Array) -> Iterator[Words]:
    """Flag leads [rad], shape (design, cylinder), that are outside the source's ranges; NaN is no lead."""
    columns: list[list[float]] = leads.T.tolist()
    firsts = [next(filter(is_unsuited, column), None) for column in columns]
    alike = places_of_equal(None if lead is None else round(shown(lead, "deg"), _DECIMALS) for lead in firsts)
    for members in alike.values():
        lead = firsts[members[0]]
        if lead is not None:
            yield _(
                "the lead of {cylinders}, {lead}, is outside its source's range: {reason} [{source}]",
                cylinders=ranged(cylinders, members),
                lead=number(lead, "deg"),
                reason=verdict(lead),
                source=SOURCE,
            )
