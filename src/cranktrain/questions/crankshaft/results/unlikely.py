"""Crankshafts, bearings and widths that hardly any machine has: computed with all the same, and flagged."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.checks import Limit, StageResult, flagged
from cranktrain.language import N_, _
from cranktrain.layout.axial import AxialPlaces
from cranktrain.layout.shafts import Shafts
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_smallest
from cranktrain.questions.crankshaft.parts import DeclaredCrankshaft
from cranktrain.questions.crankshaft.shaft_layout import LaidCrankshafts, LaidShaft, pin_names
from cranktrain.questions.forces.crank_pins import CrankPinLoads
from cranktrain.record import record
from cranktrain.wording import number

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
class UnlikelyCrankshafts(StageResult):
    """Crankshafts and bearings that hardly any machine has."""


class _Stress(NamedTuple):
    """Of the pins, and of the journals beside each, shape (design, pin). [Pa]"""

    pin: Array
    journal: Array


def unlikely_crankshafts(
    laid: LaidCrankshafts | None, shafts: Shafts | None, axial: AxialPlaces | None, loads: CrankPinLoads | None
) -> UnlikelyCrankshafts:
    """Flag what is beyond the limits."""
    found: list[str] = []
    if laid is None or shafts is None or axial is None:
        return UnlikelyCrankshafts()
    for one in laid.each:
        own, pins = one.declared, pin_names(one, shafts)
        found += flagged(_YOUNG, own.material.young)
        found += _bearings(own)
        found += _of_bearing_widths(own)
        found += _of_rod_widths(one, axial.value, pins)
        if loads is not None:
            stress = _stresses(one, loads.largest_crankpin_load.value)
            found += flagged(_PIN_STRESS, stress.pin, whose=pins)
            found += flagged(_JOURNAL_STRESS, stress.journal, whose=pins)
    return UnlikelyCrankshafts(unlikely=tuple(found))


def _bearings(own: DeclaredCrankshaft) -> Iterator[str]:
    """Flag stiffness, clearance and places of main bearings."""
    diameter = own.journal[:, own.standing_on, 0]
    compliance = np.stack([own.compliance[..., axis, axis] for axis in (0, 1)], axis=1)
    by_young = own.material.young[:, np.newaxis] * diameter
    with np.errstate(divide="ignore"):
        stiffness = np.where(compliance > 0, 1 / (compliance * by_young[:, np.newaxis]), np.nan)
    yield from flagged(_STIFFNESS, stiffness, whose=own.bearing_names)
    yield from flagged(_CLEARANCE, 2 * own.clearance / diameter, whose=own.bearing_names)
    apart = np.diff(own.bearings, axis=1)
    close = np.flatnonzero(np.any(apart < _APART * diameter[:, 1:], axis=0)).tolist()
    if close:
        said = _(
            "Bearings {one} and {other} are only {apart} apart, on a journal of {diameter}: are their places right?"
        )
        design, place = first_smallest(apart[:, close[0]]), close[0]
        yield said.format(
            one=own.bearing_names[place],
            other=own.bearing_names[place + 1],
            apart=number(float(apart[design, place]), "mm"),
            diameter=number(float(diameter[design, place + 1]), "mm"),
        )


def _of_bearing_widths(own: DeclaredCrankshaft) -> Iterator[str]:
    """Flag the first bearing that reaches into a web."""
    half = own.web_thickness / 2
    begins = own.planes[:, :, 1] + half[:, :, 1]
    ends = own.planes[:, :, 0] - half[:, :, 0]
    open_end = np.full((len(half), 1), np.inf)
    begin = np.concatenate([-open_end, begins], axis=1)[:, own.standing_on]
    end = np.concatenate([ends, open_end], axis=1)[:, own.standing_on]
    room = 2 * np.minimum(own.bearings - begin, end - own.bearings)
    wide = own.bearing_width > room * (1 + _ROUNDING)
    if np.any(wide):
        design, place = (int(at) for at in np.argwhere(wide)[0])
        said = _(
            "Bearing {bearing} is {width} wide, and its journal has {room} for it between the webs: are width, spacing"
            " and webs right?"
        )
        yield said.format(
            bearing=own.bearing_names[place],
            width=number(float(own.bearing_width[design, place]), "mm"),
            room=number(float(room[design, place]), "mm"),
        )


def _of_rod_widths(one: LaidShaft, z: Array, pins: Sequence[str]) -> Iterator[str]:
    """Flag the first pin on which its rods have no room side by side; those at one place are forked, or one."""
    own, width = one.declared, one.declared.rod_bearing_width
    for pin, name in enumerate(pins):
        places = z[:, one.rods.mechanism[one.rods.pin == pin]]
        apart = np.ptp(places, axis=1)
        steps = np.diff(np.sort(places, axis=1), axis=1) > _ROUNDING * own.pin_length[:, [pin]]
        taken = np.maximum(apart, np.sum(steps, axis=1) * width) + width
        wide = np.flatnonzero(taken > own.pin_length[:, pin] * (1 + _ROUNDING))
        if wide.size:
            said = _("Rods {width} wide take {taken} of pin {pin}, which is {length} long: are both right?")
            design = int(wide[0])
            yield said.format(
                width=number(float(width[design]), "mm"),
                taken=number(float(taken[design]), "mm"),
                pin=name,
                length=number(float(own.pin_length[design, pin]), "mm"),
            )
            return


def _stresses(one: LaidShaft, largest: Array) -> _Stress:
    """Nominal bending stress by the largest load of each pin in the middle of its span, or where it hangs over."""
    own = one.declared
    n_pins = len(own.throw)
    force = np.zeros((len(largest), n_pins))
    for mechanism, pin in zip(one.rods.mechanism, one.rods.pin, strict=True):
        force[:, pin] = np.fmax(force[:, pin], own.share[pin] * largest[:, mechanism])
    away = own.bearings[:, np.newaxis] - own.centres[..., np.newaxis]
    before = np.min(np.where(away < 0, -away, np.inf), axis=-1)
    behind = np.min(np.where(away > 0, away, np.inf), axis=-1)
    span = before + behind
    is_between = np.isfinite(span)
    # A pin that hangs over is held by one web, and its journal bears it by the arm to the first bearing.
    arms = (np.where(is_between, span / 4, over) for over in (own.pin_length / 2, np.minimum(before, behind)))
    beside = np.stack([own.journals[:-1], own.journals[1:]])
    diameters = np.stack([own.journal[:, :-1, 0], own.journal[:, 1:, 0]], axis=1)
    journal = np.min(np.where(beside, diameters, np.inf), axis=1)
    each = zip(arms, (own.pin[..., 0], journal), strict=True)
    return _Stress(*(32 * force * arm / (np.pi * diameter**3) for arm, diameter in each))
