"""What pins and webs weigh by their sizes, beside what [masses.crank] says of them."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.masses import Masses
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.shafts import Shafts
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.shaft_layout import ShaftLayout, ShaftLayouts, pin_names
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANKSHAFT as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Flagged
from cranktrain.saying.wording import number

_PIN = ("pin",)
_TOO_MUCH = 1.5
"""Times what sizes say, [masses.crank] is doubtful: less it may well be, with counterweights in it."""


@record
class CrankSizes(Flagged):
    """Masses of pins and webs from the sizes of the crankshaft, in none of the forces: those are of [masses.crank]."""

    pin_mass: Array = quantity("m_p", "kg", _PIN, N_("Mass of the crank pin by its sizes"), _THEORY, "24.51")
    web_mass: Array = quantity(
        "m_w", "kg", _PIN, N_("Mass of the webs of the crank pin by their sizes"), _THEORY, "24.51"
    )
    crank_moment: Array = quantity(
        "u_c", "kg*m", _PIN, N_("Mass of pin and webs times radius of their centroid, by their sizes"), _THEORY, "24.52"
    )


def crank_sizes(layouts: ShaftLayouts, mechanisms: Mechanisms, shafts: Shafts, masses: Masses | None) -> CrankSizes:
    """Weigh pins and webs by their sizes.

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.51) and (24.52).
    """
    by_shaft = [_sizes(layout) for layout in layouts.each]
    pin, web, moment = (np.concatenate(parts, axis=1) for parts in zip(*by_shaft, strict=True))
    given = np.concatenate([_given(layout, mechanisms, shafts, masses) for layout in layouts.each], axis=1)
    radius = np.concatenate([layout.shaft.pieces.radius[:, layout.pins] for layout in layouts.each], axis=1)
    names = tuple(name for layout in layouts.each for name in pin_names(layout, shafts))
    flags = (*_flags(names, moment[0] / radius[0], given[0] / radius[0]), *_narrow(layouts, names))
    return CrankSizes(pin, web, moment, labels={"pin": names}, flags=flags)


class CrankParts(NamedTuple):
    """A crankshaft's pins and webs by their sizes.

    pin: mass of each, shape (design, pin) [kg]; web, web_moment: mass of both webs and its moment about the shaft's
    axis, toward the pin, shape (design, pin, 2) [kg, kg·m].
    """

    pin: Array
    web: Array
    web_moment: Array


def crank_parts(layout: ShaftLayout) -> CrankParts:
    """Weigh a shaft's pins and webs by their sizes; docs/theory/crankshaft, eqs. (24.51) and (24.52)."""
    declared, radius = layout.declared, layout.shaft.pieces.radius[:, layout.pins]
    density = declared.density[:, np.newaxis]
    diameter, bore = declared.pin[..., 0], declared.pin[..., 1]
    pin = density * np.pi / 4 * (diameter**2 - bore**2) * declared.pin_length
    journal = declared.journal[..., 0]
    webs: list[tuple[Array, Array]] = []
    for side in (0, 1):
        is_there = layout.webs[:, side] >= 0
        is_between = _between(layout, side)
        beside = journal[:, side : side + radius.shape[1]]
        height = np.where(np.isnan(declared.web_height), radius + (beside + diameter) / 2, declared.web_height)
        web = density * declared.web_width[..., side] * declared.web_thickness[..., side] * height * is_there
        # A web from pin to pin is halved between them: its middle is the mean of both pins' places.
        lever = web * np.where(is_between, 0.5 * radius, (radius + (diameter - beside) / 2) / 2)
        webs.append((web * np.where(is_between, 0.5, 1.0), lever))
    mass, moment = (np.stack(parts, axis=-1) for parts in zip(*webs, strict=True))
    return CrankParts(pin, mass, moment)


def _sizes(layout: ShaftLayout) -> tuple[Array, Array, Array]:
    """Mass of pins, of their webs, and moment of both, shape (design, pin). [kg, kg, kg·m]"""
    parts = crank_parts(layout)
    moment = parts.pin * layout.shaft.pieces.radius[:, layout.pins] + np.sum(parts.web_moment, axis=-1)
    return parts.pin, np.sum(parts.web, axis=-1), moment


def _between(layout: ShaftLayout, side: int) -> Array:
    """Which pins share the web on that side with the next one."""
    has = layout.declared.journals
    inner = np.concatenate([[False], ~has[1:-1], [False]])
    return inner[side : side + layout.pins.size]


def _given(layout: ShaftLayout, mechanisms: Mechanisms, shafts: Shafts, masses: Masses | None) -> Array:
    """What [masses.crank] has on each pin: mass times radius along the crank; NaN where it has no mass. [kg·m]"""
    n_designs = len(layout.declared.centres)
    moment, mass = (np.zeros((n_designs, len(mechanisms.names))) for _part in range(2))
    for batch, made in zip(mechanisms.batches, masses.batches if masses is not None else (), strict=False):
        body = batch.kind.dynamics.by_link(made.bodies).get("crank")
        if body is not None:
            moment[:, batch.index] = (body.mass * body.along)[..., 0]
            mass[:, batch.index] = body.mass[..., 0]
    on_pin = layout.declared.throw[:, np.newaxis] == np.where(shafts.shaft == layout.declared.shaft, shafts.throw, -1)
    sums = (np.sum(on_pin * part[:, np.newaxis], axis=-1) * layout.declared.share for part in (moment, mass))
    whole, weighs = sums
    return np.where(weighs > 0, whole, np.nan)


def _flags(names: tuple[str, ...], by_sizes: Array, given: Array) -> tuple[Words, ...]:
    """Say where no force holds what the sizes weigh, and where [masses.crank] has more; as at the pin, in kg."""
    flags: list[Words] = []
    bare = np.flatnonzero(np.isnan(given)).tolist()
    if bare:
        said = _("Cranks have no mass without [masses.crank]; by its sizes that of pin {pin} acts like {mass} there.")
        flags.append(said.format(pin=names[bare[0]], mass=number(float(by_sizes[bare[0]]), "kg")))
    with np.errstate(invalid="ignore"):
        doubtful = np.flatnonzero(given > _TOO_MUCH * by_sizes).tolist()
    if doubtful:
        first = doubtful[0]
        said = _("[masses.crank] acts like {given} at pin {pin}, and by their sizes pin and webs like {mass}.")
        sizes = (number(float(of[first]), "kg") for of in (given, by_sizes))
        flags.append(said.format(pin=names[first], **dict(zip(("given", "mass"), sizes, strict=True))))
    return tuple(flags)


def _narrow(layouts: ShaftLayouts, names: tuple[str, ...]) -> tuple[Words, ...]:
    """Say of webs that hardly are any: narrower than the pin that they hold."""
    is_narrow = [
        np.any(layout.declared.web_width[0] < layout.declared.pin[0, :, :1], axis=-1) for layout in layouts.each
    ]
    pins = [name for name, narrow in zip(names, np.concatenate(is_narrow).tolist(), strict=True) if narrow]
    return (_("A web is narrower than the pin that it holds: {pins}.", pins=", ".join(pins)),) if pins else ()
