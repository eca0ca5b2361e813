"""The flywheel's diagrams as panels: energy over the crank angle, and over the inertia of the moving parts."""

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import Words, _
from cranktrain.motion import Array
from cranktrain.panels.design import closed
from cranktrain.panels.formulas import formula
from cranktrain.panels.shapes import Curve, Mark, Panel, PanelLine, Role
from cranktrain.plans.evenness_diagrams import mertsalov_diagram, wittenbauer_diagram
from cranktrain.quantities import shown
from cranktrain.saying.amounts import UnitLabel
from cranktrain.texts.flywheel_diagrams import Tangent

_BESIDE, _TALLER, _WHOLE = 0.25, 0.12, 0.08
"""Room beside Wittenbauer's curve and over it, and about the whole with the origin, in parts of what is drawn."""
_MARKED = 12
"""Crank angles that are marked along a cycle."""


def mertsalov_panels(result: Result, design: int = 0) -> tuple[Panel, Panel]:
    """Excess work with the moving parts' energy, and their difference, which the flywheel takes up; over the cycle."""
    found = mertsalov_diagram(result)
    work, carried, left = (
        closed(part[min(design, len(part) - 1)]) for part in (found.work, found.carried_energy, found.flywheel_energy)
    )
    angle = np.append(shown(found.angle, "deg"), shown(result.grid.cycle, "deg"))
    both = Curve(work, "main", "v", "A"), Curve(carried, "carried", "j", r"\frac{1}{2}\omega_a^2 J_v")
    difference = Curve(left, "main", "T", r"A-\frac{1}{2}\omega_a^2 J_v")
    ends = [
        (float(shown(float(one.angle[design, 0]), "deg")) % float(angle[-1]), float(one.value[design, 0]))
        for one in (found.smallest, found.largest)
    ]
    return Panel(_("Energy"), "J", angle, both), Panel(
        _("Energy"),
        "J",
        angle,
        (difference,),
        marks=tuple(Mark(at, value, "ring") for at, value in ends),
        levels=tuple(PanelLine(value, "limit") for _at, value in ends),
        dimension=r"\delta\,\omega_a^2 J_f",
    )


def wittenbauer_panels(result: Result, tangents: tuple[Tangent, Tangent], design: int = 0) -> tuple[Panel, Panel]:
    """Excess work over the inertia of the moving parts [kg·m²], once round the cycle, with the tangents; and the whole.

    The whole has the origin, where the tangents meet.
    """
    found = wittenbauer_diagram(result)
    inertia, work = (closed(part) for part in np.broadcast_arrays(found.inertia[design], found.work[design]))
    # Where there is hardly any work, or hardly any change of inertia, the tangents' slope sets the scale.
    slope = float(tangents[0].slope)
    rise, run = slope * float(np.ptp(inertia)), float(np.ptp(work)) / slope
    reach = _wide(np.append(inertia, np.mean(inertia[:-1]) + run * np.array([-0.05, 0.05])), _BESIDE)
    limits = _wide(np.append(work, np.mean(work[:-1]) + rise * np.array([-0.2, 0.2])), _TALLER)
    cycle = float(shown(result.grid.cycle, "deg"))
    curve = Curve(work, "main", "v", "A")
    unit = UnitLabel("J", float(np.max(np.abs(work))))
    names = (_("tangent at the largest speed"), _("tangent at the smallest"))
    drawn = Panel(
        _("Excess work {symbol}, {unit}", symbol=formula("A"), unit=unit),
        "J",
        inertia,
        (curve, *_tangent_curves(tangents, reach, names)),
        across_unit="kg*m^2",
        over=_("Inertia of the moving parts {symbol}, kg·m²", symbol=formula("J_v")),
        marks=(
            *(Mark(float(one.inertia), float(one.work), "ring") for one in tangents),
            *_marked_angles(inertia, work, cycle),
        ),
        limits=limits,
        reach=reach,
    )
    origin = np.array([found.origin_inertia[design], found.origin_work[design]])
    widths, heights = np.column_stack([np.stack([inertia, work]), origin])
    meeting = (float(origin[0]), float(np.max(inertia)))
    words = _("origin {symbols}", symbols=f"{formula('-J_f')}, {formula('-E_0')}")
    whole = Panel(
        _("{symbol}, {unit}", symbol=formula("A"), unit=unit),
        "J",
        inertia,
        (curve, *_tangent_curves(tangents, meeting, ("", ""))),
        across_unit="kg*m^2",
        over=_("{symbol}, {unit}", symbol=formula("J_v"), unit="kg·m²"),
        marks=(Mark(float(origin[0]), float(origin[1]), "dot", words, 0.16),),
        limits=_wide(heights, _WHOLE),
        reach=_wide(widths, _WHOLE),
    )
    return drawn, whole


def tangents_of(result: Result, design: int) -> tuple[Tangent, Tangent]:
    """Tangents at the largest and the smallest speed of a design."""
    found = wittenbauer_diagram(result)
    upper, lower = (Tangent(*(part[design] for part in one)) for one in (found.upper, found.lower))
    return upper, lower


def _tangent_curves(
    tangents: tuple[Tangent, Tangent], ends: tuple[float, float], names: tuple[Words, Words]
) -> tuple[Curve, ...]:
    """Tangents from one inertia to another."""
    at = np.array(ends)
    roles: tuple[Role, Role] = ("side", "formula")
    each = zip(tangents, roles, names, strict=True)
    return tuple(Curve(one.slope * at + one.intercept, role, "F", name=name, across=at) for one, role, name in each)


def _marked_angles(inertia: Array, work: Array, cycle: float) -> list[Mark]:
    """Crank angles along the curve, every twelfth of the cycle."""
    n = inertia.size - 1
    angle = np.arange(n, dtype=np.float64) * (cycle / n)
    at = np.flatnonzero(np.round(angle, 9) % (round(cycle) // _MARKED) == 0).tolist()
    return [Mark(float(inertia[i]), float(work[i]), "angle", angle=float(angle[i])) for i in at]


def _wide(values: Array, beside: float) -> tuple[float, float]:
    """Range of values with room beside; of one value alone, some about it."""
    low, high = float(np.min(values)), float(np.max(values))
    room = beside * (high - low) or max(abs(high), 1.0) * beside
    return low - room, high + room
