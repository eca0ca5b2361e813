"""Curves of the flywheel's diagrams: energy over the crank angle, and over the inertia of the moving parts."""

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import said as _
from cranktrain.plans.evenness_diagrams import mertsalov_diagram, wittenbauer_diagram
from cranktrain.quantities import shown
from cranktrain.viz.panel import Curve, Panel, closed


def mertsalov_panels(result: Result, design: int = 0) -> tuple[Panel, Panel]:
    """Excess work with the moving parts' energy, and their difference, which the flywheel takes up; over the cycle."""
    found = mertsalov_diagram(result)
    work, carried, left = (
        closed(part[min(design, len(part) - 1)]) for part in (found.work, found.carried_energy, found.flywheel_energy)
    )
    angle = np.append(shown(found.angle, "deg"), shown(result.grid.cycle, "deg"))
    both = Curve(work, "main", "v", "A"), Curve(carried, "carried", "j", r"\frac{1}{2}\omega_a^2 J_v")
    difference = Curve(left, "main", "T", r"A-\frac{1}{2}\omega_a^2 J_v")
    return Panel(_("Energy"), "J", angle, both), Panel(_("Energy"), "J", angle, (difference,))


def wittenbauer_panel(result: Result, design: int = 0) -> Panel:
    """Excess work over the inertia of the moving parts [kg·m²], once round the cycle."""
    found = wittenbauer_diagram(result)
    inertia, work = np.broadcast_arrays(found.inertia[design], found.work[design])
    return Panel(_("Excess work"), "J", closed(inertia), (Curve(closed(work), "main", "v", "A"),))
