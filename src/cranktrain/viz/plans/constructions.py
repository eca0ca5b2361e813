"""Sheets of the sources' constructions: arc, orthogonal projection, Brix's ray forward and backward."""

from collections.abc import Iterator, Sequence
from functools import cache, partial

import numpy as np

from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.panels.figures import aligned, degrees, rounded, with_unit
from cranktrain.plans.constructions import Construction, Method, construction
from cranktrain.plans.placement import plain_crank_called
from cranktrain.plans.positions import chosen_scale, scale_words
from cranktrain.questions.cylinders.declared import cylinders_of
from cranktrain.saying.percents import percent
from cranktrain.saying.scales import scale_for
from cranktrain.texts.largest_errors import errors_by_ratio
from cranktrain.viz.paper.page import LINE, Box, Figure, drawing_settings
from cranktrain.viz.paper.style import MUTED
from cranktrain.viz.paper.tables import ROW
from cranktrain.viz.plans.construction_sketches import construction_sketch, scheme_sketch
from cranktrain.viz.plans.sheet import (
    centre,
    fitted_scale,
    length_scale,
    plan_page,
    write_beside,
    write_scales,
)

_PARTS = 10
"""Into which the stroke is divided where a construction is read backwards."""

_SOURCE = "steam-engine"

_COLUMNS = (0.20, 0.40, 0.60, 0.82, 1.0)
"""Where the columns of a table of readings end, in parts of its width."""


def plan_arc(
    machine: Machine,
    angles: int | Sequence[float] = 12,
    *,
    mechanism: str | None = None,
    size: str = "A4",
    scale: float | None = None,
) -> Figure:
    """Draw a piston's positions by arcs of the rod's length; exact.

    Parameters
    ----------
    machine : Machine
    angles : int or sequence of float
        How many, evenly over a turn, or which crank angles, from where the crank points along the cylinder; 24 at most.
        [deg]
    mechanism : str, optional
        A slider-crank's or an eccentric's name; the first slider-crank unless given, or else the first eccentric.
    size : "A4" or "A3"
    scale : float, optional
        Of the construction, millimetres of metal in one of paper; the largest round one that fits, unless given.

    Returns
    -------
    Figure
        As seen from the free end, turned so that the line of stroke lies, the shaft at its left.
    """
    return _sheet(machine, "arc", angles, mechanism, size, _("Positions by arcs of the rod's length"), scale)


def plan_projection(
    machine: Machine,
    angles: int | Sequence[float] = 12,
    *,
    mechanism: str | None = None,
    size: str = "A4",
    scale: float | None = None,
) -> Figure:
    """Draw a piston's positions by orthogonal projection of the crank pin (334); parameters as of `plan_arc`."""
    return _sheet(machine, "projection", angles, mechanism, size, _("Positions by orthogonal projection, (334)"), scale)


def plan_brix(
    machine: Machine,
    angles: int | Sequence[float] = 12,
    *,
    mechanism: str | None = None,
    size: str = "A4",
    scale: float | None = None,
) -> Figure:
    """Draw a piston's positions by Brix's rays; parameters as of `plan_arc`."""
    return _sheet(machine, "brix", angles, mechanism, size, _("Positions by Brix's construction"), scale)


def plan_brix_backward(
    machine: Machine,
    angles: int | Sequence[float] = _PARTS,
    *,
    mechanism: str | None = None,
    size: str = "A4",
    scale: float | None = None,
) -> Figure:
    """Draw crank angles by Brix's rays from displacements, as an indicator diagram is unrolled.

    Parameters as of `plan_arc`, but a number of angles is into how many parts the stroke is divided.
    """
    return _sheet(machine, "brix_backward", angles, mechanism, size, _("Crank angles by Brix's construction"), scale)


@drawing_settings()
def _sheet(
    machine: Machine,
    method: Method,
    angles: int | Sequence[float],
    mechanism: str | None,
    size: str,
    title: str,
    scale: float | None,
) -> Figure:
    """The mechanism, and below it the construction on the crank circle to scale, beside its readings and exact ones."""
    found = construction(machine, method, angles, mechanism=mechanism)
    page, box = plan_page(machine, angles, size, title, found.mechanism)
    wide = 0.60 * box.width
    lower = Box(box.left, box.bottom + 7.0, wide, 0.68 * (box.height - 7.0))
    upper = Box(box.left, lower.bottom + lower.height, wide, box.height - 7.0 - lower.height)
    bore = _bore(machine, found)
    radius, rod = 1e3 * found.geometry.crank_radius, 1e3 * found.geometry.rod_length
    room = upper.width - 4.0, upper.height - 12.0
    mechanism_at = cache(partial(scheme_sketch, found, bore=bore))
    small = fitted_scale(mechanism_at, room, float(rod + radius))
    centre(page, mechanism_at(small), upper._replace(height=upper.height - 4.0))
    words = _("The mechanism, scale {scale}", scale=scale_words(small))
    page.text(upper.left, upper.bottom + upper.height - 4.0, words, color=MUTED)
    room = lower.width - 8.0, lower.height - 8.0
    constructed_at = cache(partial(construction_sketch, found))
    least = fitted_scale(constructed_at, room, float(2 * radius))
    metal = 1e3 * chosen_scale(1e-3 * least, scale)
    centre(page, constructed_at(metal), lower)
    write_scales(page, box, [length_scale(1e-3 * metal)], metal)
    rows = list((_backward_table if method == "brix_backward" else _forward_table)(found, 1e-3 * metal))
    notes = list(_notes(found))
    line = min(ROW, (box.height - LINE * len(notes) - 9.0) / len(rows))
    write_beside(page, box, box.left + wide + 8.0, rows, notes, shares=_COLUMNS, gap=1.0, line=line)
    return page.figure


def _bore(machine: Machine, found: Construction) -> float | None:
    """Bore of the mechanism's cylinder, where the file has one. [mm]"""
    place = plain_crank_called(machine, found.mechanism)
    bore = cylinders_of(machine.cylinder, [place])[0].bore if place.kind.output.has_chambers else None
    return None if bore is None else 1e3 * bore.si


def _forward_table(found: Construction, scale: float) -> Iterator[tuple[str, ...]]:
    """Displacements as constructed and as they are."""
    length = scale_for("m", 0.0)
    exact_head = _("exact, {unit}", unit=length.label)
    yield (_("no."), "φ, °", _("paper, mm"), f"S, {length.label}", exact_head, "Δ, %")
    made, exact = found.displacement, found.exact_displacement
    paper, errors = (map(rounded, one.tolist()) for one in (made / scale, 100.0 * (made - exact) / found.stroke))
    written = (aligned(length.of(one)) for one in (made, exact))
    for number, (angle, *cells) in enumerate(zip(found.angle, paper, *written, errors, strict=True)):
        yield (f"{number}", f"{np.rad2deg(angle):g}", *cells)


def _backward_table(found: Construction, scale: float) -> Iterator[tuple[str, ...]]:
    """Crank angles on the way to the shaft, as constructed and as they are."""
    length = scale_for("m", 0.0)
    yield (_("no."), f"S, {length.label}", _("paper, mm"), "φ, °", _("exact, °"), "Δ, °")
    ways = zip(found.displacement, aligned(length.of(found.displacement)), strict=True)
    for number, (made, exact, (way, said)) in enumerate(zip(found.angle, found.exact_angle, ways, strict=True)):
        angle, right = np.rad2deg([made, exact])
        yield (f"{number}", said, rounded(way / scale), *map(degrees, (angle, right, angle - right)))


def _notes(found: Construction) -> Iterator[str]:
    """What is drawn, the source's range, and how the construction is read."""
    arcs = _("Arcs about the piston's pin, AB about B, lead the crank pin A to C")
    if found.is_of_eccentric:
        arcs = _("Arcs about the valve's pin, AB about B, lead the eccentric's A to C")
    how = {
        "arc": (
            arcs,
            _("on the line of stroke: exact, with an offset too."),
            _("A', C', D': φ from the crank-side dead centre."),
        ),
        "brix_backward": (_("On the way to the shaft; on the way back 360° − φ."),),
    }
    yield from how.get(found.method, (_("Bars on the ruler: where the exact readings are."),))
    if found.method.startswith("brix"):
        distance = f"OP = λR/2 = {with_unit(-found.pole, scale_for('m', 0.0))}"
        away = (
            _("{distance}, away from the valve") if found.is_of_eccentric else _("{distance}, away from the cylinder")
        )
        yield away.format(distance=distance)
    yield from _range(found)
    if found.is_of_eccentric:
        yield _("φ from where the eccentric points to the valve, S from its top;")
        yield _("seen from the free end and turned, the valve at the right.")
    else:
        yield _("φ from where the crank points along the cylinder, S from the top;")
        yield _("seen from the free end and turned, the cylinder at the right.")
    yield _("M: dead positions; letters of [{source}].", source=_SOURCE)


def _range(found: Construction) -> Iterator[str]:
    """The source's range, whether this mechanism is inside, and how exact Brix's construction is beside (333)."""
    limits = found.limits
    if limits is None:
        return
    reasons = list(limits.reasons(found.ratio, float(found.geometry.offset)))
    yield _("Range of the source: {condition} [{source}].", condition=_(limits.condition), source=limits.source)
    for reason in reasons:
        yield _("This mechanism is outside: {reason}.", reason=reason)
    if not reasons:
        yield _("This mechanism is inside, λ = {ratio:.4g}.", ratio=found.ratio)
    if found.method == "brix" and found.geometry.offset == 0:
        errors = (errors_by_ratio(method, found.ratio).displacement.value for method in ("brix", "two_harmonics"))
        said = [f"{percent(float(error))} %" for error in errors]
        yield _("Less exact than (333): off by {brix} of the stroke,", brix=said[0])
        yield _("not {harmonics}; arcs are exact.", harmonics=said[1])
