"""Crankshafts, bearings and widths that hardly any machine has: computed with all the same, and flagged."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.shafts import AxialPlaces, Shafts
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_smallest
from cranktrain.questions.crankshaft.parts import DeclaredCrankshaft
from cranktrain.questions.crankshaft.shaft_layout import ShaftLayout, ShaftLayouts, pin_names
from cranktrain.questions.forces.crank_pins import CrankPinLoads
from cranktrain.record import record
from cranktrain.saying.checks import Flagged, Limit, flagged
from cranktrain.saying.wording import number

# Rubber-like plastics have 3 GPa and diamond 1000: shafts are of aluminium, 70, iron, 100 to 170, steel, 206, carbide.
_YOUNG = Limit(
    500e9, "GPa", N_("Young's modulus of a shaft is {value}, and steel has 206 GPa: is its unit right?"), 50e9
)
# A housing gives about as much as the shaft: k is 0.05 to 0.3 E d. Rubber blocks have 1e-3 of it.
_STIFFNESS = Limit(
    1.0,
    "",
    N_(
        "The stiffness of bearing {whose} is {value} of E times its journal's diameter; built ones have 0.01 to 0.5:"
        " is its unit right?"
    ),
    1e-3,
)
# Plain bearings have 0.5 to 1.5 thousandths, those of models and pumps up to 5.
_CLEARANCE = Limit(
    0.01,
    "%",
    N_(
        "The clearance of bearing {whose} is {value} of its journal's diameter; plain bearings have 0.1 %: is it right?"
    ),
)
# The strongest steels of shafts break at 2 GPa and bear a fifth of it in fatigue.
_PIN_STRESS = Limit(
    1e9,
    "MPa",
    N_(
        "Its largest load bends pin {whose} with a nominal {value}, 32 M/(π d³), M a quarter of load times span:"
        " more than steel bears. Are pin_diameter and loads right?"
    ),
)
_JOURNAL_STRESS = _PIN_STRESS._replace(
    sentence=N_(
        "The largest load beside it bends the journal at pin {whose} with a nominal {value}, 32 M/(π d³), M a quarter"
        " of load times span: more than steel bears. Are journal_diameter and loads right?"
    )
)
_APART = 0.1
"""Of the journal's diameter: bearings that are nearer are one, or their places are in another unit."""
_ROUNDING = 1e-6
"""Of a width: it may be written to some digits."""


@record
class UnlikelyCrankshafts(Flagged):
    """Crankshafts and bearings that hardly any machine has."""


class _Stress(NamedTuple):
    """Of the pins, and of the journals beside each, shape (design, pin). [Pa]"""

    pin: Array
    journal: Array


def unlikely_crankshafts(
    layouts: ShaftLayouts | None, shafts: Shafts | None, axial: AxialPlaces | None, loads: CrankPinLoads | None
) -> UnlikelyCrankshafts:
    """Flag what is beyond the limits."""
    flags: list[Words] = []
    if layouts is None or shafts is None or axial is None:
        return UnlikelyCrankshafts()
    for layout in layouts.each:
        declared, pins = layout.declared, pin_names(layout, shafts)
        flags += flagged(_YOUNG, declared.material.young)
        flags += _bearings(declared)
        flags += _of_bearing_widths(declared)
        flags += _of_rod_widths(layout, axial.value, pins)
        if loads is not None:
            stress = _stresses(layout, loads.largest_crankpin_load.value)
            flags += flagged(_PIN_STRESS, stress.pin, whose=pins)
            flags += flagged(_JOURNAL_STRESS, stress.journal, whose=pins)
    return UnlikelyCrankshafts(unlikely=tuple(flags))


def _of_both_directions(compliance: Array) -> Array:
    """Compliance of bearings in their own directions, those in which loads move them straight on: (design, 2, bearing).

    Of matrices of the shape (design, bearing, 2, 2).
    """
    x, y, both = compliance[..., 0, 0], compliance[..., 1, 1], compliance[..., 0, 1]
    half = (x - y) / 2
    more = np.copysign(np.hypot(half, both), half)
    middle = (x + y) / 2
    turned = both != 0
    return np.stack([np.where(turned, middle + more, x), np.where(turned, middle - more, y)], axis=1)


def _bearings(declared: DeclaredCrankshaft) -> Iterator[Words]:
    """Flag stiffness, clearance and places of main bearings."""
    diameter = declared.at_bearings
    compliance = _of_both_directions(declared.compliance)
    by_young = declared.material.young[:, np.newaxis] * diameter
    with np.errstate(divide="ignore"):
        stiffness = np.where(compliance > 0, 1 / (compliance * by_young[:, np.newaxis]), np.nan)
    yield from flagged(_STIFFNESS, stiffness, whose=declared.bearing_names)
    yield from flagged(_CLEARANCE, 2 * declared.clearance / diameter, whose=declared.bearing_names)
    apart = np.diff(declared.bearings, axis=1)
    close = np.flatnonzero(np.any(apart < _APART * diameter[:, 1:], axis=0)).tolist()
    if close:
        said = _(
            "Bearings {one} and {other} are only {apart} apart, on a journal of {diameter}: are their places right?"
        )
        design, bearing = first_smallest(apart[:, close[0]]), close[0]
        yield said.format(
            one=declared.bearing_names[bearing],
            other=declared.bearing_names[bearing + 1],
            apart=number(float(apart[design, bearing]), "mm"),
            diameter=number(float(diameter[design, bearing + 1]), "mm"),
        )


def _of_bearing_widths(declared: DeclaredCrankshaft) -> Iterator[Words]:
    """Flag the first bearing that reaches into a web."""
    half = declared.web_thickness / 2
    begins = declared.planes[:, :, 1] + half[:, :, 1]
    ends = declared.planes[:, :, 0] - half[:, :, 0]
    open_end = np.full((len(half), 1), np.inf)
    begin = np.concatenate([-open_end, begins], axis=1)[:, declared.standing_on]
    end = np.concatenate([ends, open_end], axis=1)[:, declared.standing_on]
    room = 2 * np.minimum(declared.bearings - begin, end - declared.bearings)
    wide = declared.bearing_width > room * (1 + _ROUNDING)
    if np.any(wide):
        design, bearing = (int(at) for at in np.argwhere(wide)[0])
        said = _(
            "Bearing {bearing} is {width} wide, and its journal has {room} for it between the webs: are width, spacing"
            " and webs right?"
        )
        yield said.format(
            bearing=declared.bearing_names[bearing],
            width=number(float(declared.bearing_width[design, bearing]), "mm"),
            room=number(float(room[design, bearing]), "mm"),
        )


def _of_rod_widths(layout: ShaftLayout, z: Array, pins: Sequence[str]) -> Iterator[Words]:
    """Flag the first pin on which its rods have no room side by side; those at one place are forked, or one."""
    declared, width = layout.declared, layout.declared.rod_bearing_width
    for pin, name in enumerate(pins):
        places = z[:, layout.rods.mechanism[layout.rods.pin == pin]]
        apart = np.ptp(places, axis=1)
        steps = np.diff(np.sort(places, axis=1), axis=1) > _ROUNDING * declared.pin_length[:, [pin]]
        taken = np.maximum(apart, np.sum(steps, axis=1) * width) + width
        wide = np.flatnonzero(taken > declared.pin_length[:, pin] * (1 + _ROUNDING))
        if wide.size:
            said = _("Rods {width} wide take {taken} of pin {pin}, which is {length} long: are both right?")
            design = int(wide[0])
            yield said.format(
                width=number(float(width[design]), "mm"),
                taken=number(float(taken[design]), "mm"),
                pin=name,
                length=number(float(declared.pin_length[design, pin]), "mm"),
            )
            return


def _stresses(layout: ShaftLayout, largest: Array) -> _Stress:
    """Nominal bending stress by the largest load of each pin in the middle of its span, or where it hangs over."""
    declared = layout.declared
    n_pins = len(declared.throw)
    force = np.zeros((len(largest), n_pins))
    for mechanism, pin in zip(layout.rods.mechanism, layout.rods.pin, strict=True):
        force[:, pin] = np.fmax(force[:, pin], declared.share[pin] * largest[:, mechanism])
    away = declared.bearings[:, np.newaxis] - declared.centres[..., np.newaxis]
    before = np.min(np.where(away < 0, -away, np.inf), axis=-1)
    behind = np.min(np.where(away > 0, away, np.inf), axis=-1)
    span = before + behind
    is_between = np.isfinite(span)
    # A pin that hangs over is held by one web, and its journal bears it by the arm to the first bearing.
    arms = (np.where(is_between, span / 4, over) for over in (declared.pin_length / 2, np.minimum(before, behind)))
    beside = np.stack([declared.journals[:-1], declared.journals[1:]])
    diameters = np.stack([declared.journal[:, :-1, 0], declared.journal[:, 1:, 0]], axis=1)
    journal = np.min(np.where(beside, diameters, np.inf), axis=1)
    sections = zip(arms, (declared.pin[..., 0], journal), strict=True)
    return _Stress(*(32 * force * arm / (np.pi * diameter**3) for arm, diameter in sections))
