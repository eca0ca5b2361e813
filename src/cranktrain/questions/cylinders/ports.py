"""Ports of two-stroke cylinders: when the pistons uncover and cover them, and what is left to compress after that."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Pistons
from cranktrain.motion import Array
from cranktrain.numerics import around_zero, bracketed_roots
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.cylinders.firing import Cycle
from cranktrain.questions.cylinders.travel import CylinderPistons, CylinderTravel, reach
from cranktrain.questions.cylinders.volumes import Chambers, ChamberVolumes
from cranktrain.questions.motion.dead_centres import DeadCentres, slider_motion
from cranktrain.record import record
from cranktrain.references import THEORY_OF_OPPOSED_PISTONS as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Flagged
from cranktrain.saying.wording import number, ranged

_CYLINDER = ("cylinder",)


@record
class Ports:
    """Exhaust and scavenge ports of every cylinder.

    Attributes
    ----------
    height : Array, shape (design, cylinder, 2)
        Of the open part, from the edge to where the piston stands at its outer dead centre; of opposed pistons the
        first uncovers the exhaust ports. [m]
    """

    needs: ClassVar[str] = N_("[cylinder] exhaust_port and scavenge_port")

    height: Array


@record
class PortTiming(Flagged):
    """When ports open and close; NaN for a port that is never shut."""

    exhaust_opens: Array = quantity(
        "φ_eo", "deg", _CYLINDER, N_("Crank angle at which the exhaust ports open"), _THEORY, "18.5"
    )
    exhaust_closes: Array = quantity(
        "φ_ec", "deg", _CYLINDER, N_("Crank angle at which the exhaust ports close"), _THEORY, "18.5"
    )
    scavenge_opens: Array = quantity(
        "φ_so", "deg", _CYLINDER, N_("Crank angle at which the scavenge ports open"), _THEORY, "18.5"
    )
    scavenge_closes: Array = quantity(
        "φ_sc", "deg", _CYLINDER, N_("Crank angle at which the scavenge ports close"), _THEORY, "18.5"
    )
    exhaust_opens_before: Array = quantity(
        "δ_o",
        "deg",
        _CYLINDER,
        N_("By how much the exhaust ports open before the scavenge ports; negative: after them"),
        _THEORY,
        "18.6",
    )
    exhaust_closes_before: Array = quantity(
        "δ_c",
        "deg",
        _CYLINDER,
        N_("By how much the exhaust ports close before the scavenge ports; negative: after them"),
        _THEORY,
        "18.6",
    )


def have_ports(ports: Ports | None, cycle: Cycle | None) -> bool:
    """Whether the cylinders have ports, or should: those of a two-stroke that fires."""
    return ports is not None or (cycle is not None and cycle.fires and cycle.length == TURN)


def port_timing(
    ports: Ports,
    cylinders: CylinderPistons,
    pistons: Pistons,
    dead_centres: DeadCentres,
    crank_angle: CrankAngle,
) -> PortTiming:
    """Crank angles at which the pistons' edges pass those of the ports.

    Notes
    -----
    A piston uncovers its port where it is the port's height from its outer dead centre: docs/theory/opposed-pistons,
    eq. (18.5); for a central slider-crank cos α = (x² + R² − L²)/(2Rx), with x the pin's distance from the shaft.
    """
    opens, closes = _events(ports, cylinders, pistons, dead_centres)
    shown_opens, shown_closes = (crank_angle.counted(angles) for angles in (opens, closes))
    before = around_zero(opens[..., 1] - opens[..., 0])
    return PortTiming(
        exhaust_opens=shown_opens[..., 0],
        exhaust_closes=shown_closes[..., 0],
        scavenge_opens=shown_opens[..., 1],
        scavenge_closes=shown_closes[..., 1],
        exhaust_opens_before=before,
        exhaust_closes_before=around_zero(closes[..., 1] - closes[..., 0]),
        flags=tuple(_flags(cylinders.names, before, opens)),
    )


def _events(
    ports: Ports, cylinders: CylinderPistons, pistons: Pistons, dead_centres: DeadCentres
) -> tuple[Array, Array]:
    """Crank angles φ at which the exhaust and the scavenge ports open and close, shape (design, cylinder, 2). [rad]"""
    index, is_far = cylinders.index, cylinders.signs < 0
    nominal = pistons.nominal_top[:, index, 0]
    top = nominal + dead_centres.top_shift[:, index]
    bottom = nominal + np.pi + dead_centres.bottom_shift[:, index]
    inner, outer = np.where(is_far, bottom, top), np.where(is_far, top + 2 * np.pi, bottom)
    edge = np.where(
        is_far,
        dead_centres.top_position[:, index] - ports.height,
        dead_centres.bottom_position[:, index] + ports.height,
    )
    each = np.arange(2)

    def past_edge(angle: Array) -> Array:
        own = np.zeros((len(angle), len(pistons.names), 2))
        own[:, index, each] = angle
        return slider_motion(pistons, own).value[:, index, each] - edge

    return bracketed_roots(past_edge, inner, outer), bracketed_roots(past_edge, outer, inner + 2 * np.pi)


def _flags(names: tuple[str, ...], before: Array, opens: Array) -> Iterator[Words]:
    """Flag what works badly: gas that blows back into the receiver, and ports higher than the stroke."""
    late = np.flatnonzero(np.any(before < 0, axis=0)).tolist()
    if late:
        most = number(float(-np.nanmin(before)), "deg")
        yield _(
            "Scavenge ports of {cylinders} open up to {most} before the exhaust's: gas blows back into the receiver.",
            cylinders=ranged(names, late),
            most=most,
        )
    never = np.flatnonzero(np.any(np.isnan(opens), axis=(0, 2))).tolist()
    if never:
        yield _("A port of {cylinders} is higher than the stroke and never shut.", cylinders=ranged(names, never))


@record
class EffectiveCompression:
    """What is compressed after the last port has closed."""

    effective_compression_ratio: Array = quantity(
        "ε_eff", "1", ("chamber",), N_("Volume where the last port closes over the smallest volume"), _THEORY, "18.7"
    )


def effective_compression(
    timing: PortTiming,
    cylinders: CylinderPistons,
    pistons: Pistons,
    chambers: Chambers,
    travel: CylinderTravel,
    volumes: ChamberVolumes,
    crank_angle: CrankAngle,
) -> EffectiveCompression:
    """Compression ratio from the last port's closing, of the chambers at the heads."""
    last = np.where(timing.exhaust_closes_before > 0, timing.scavenge_closes, timing.exhaust_closes)
    parted = travel.reach - reach(cylinders, pistons, (last + crank_angle.zero[..., 0])[..., np.newaxis]).value[..., 0]
    ratio = 1 + chambers.area * parted[:, chambers.cylinder] / volumes.clearance_volume
    return EffectiveCompression(np.where(chambers.is_head, ratio, np.nan))
