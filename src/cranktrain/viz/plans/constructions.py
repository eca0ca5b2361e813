"""Sheets of the sources' constructions: arc, orthogonal projection, Brix's ray forward and backward."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.plans.constructions import Construction, Method, construction
from cranktrain.plans.positions import fitting
from cranktrain.plans.vectors import angle_of
from cranktrain.textbook.largest_errors import errors_by_ratio
from cranktrain.textbook.percents import percent
from cranktrain.viz.figures import figure, rounded
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.labels import Wish, placed_labels
from cranktrain.viz.paper.page import Box, Figure, drawing_settings
from cranktrain.viz.paper.sketch import Circle, Line, Sketch, bounds_of
from cranktrain.viz.plans.sheet import centre, plan_page, scale_of, write_beside, write_scales
from cranktrain.viz.plans.sketches import alike

_PARTS = 10
"""Into which the stroke is divided where a construction is read backwards."""

_COLUMNS = (0.20, 0.40, 0.60, 0.82, 1.0)
"""Where the columns of a table of readings end, in parts of its width."""


def plan_arc(
    machine: Machine, angles: int | Sequence[float] = 12, *, mechanism: str | None = None, size: str = "A4"
) -> Figure:
    """Draw a piston's positions by arcs of the rod's length; exact.

    Parameters
    ----------
    machine : Machine
    angles : int or sequence of float
        How many, evenly over a turn, or which crank angles, from where the crank points along the cylinder; 24 at most.
        [deg]
    mechanism : str, optional
        A slider-crank's name; the first one unless given.
    size : "A4" or "A3"

    Returns
    -------
    Figure
        In the mechanism's own axes: the line of stroke lies, the shaft at its left.
    """
    return _sheet(machine, "arc", angles, mechanism, size, _("Positions by arcs of the rod's length"))


def plan_projection(
    machine: Machine, angles: int | Sequence[float] = 12, *, mechanism: str | None = None, size: str = "A4"
) -> Figure:
    """Draw a piston's positions by orthogonal projection of the crank pin (334); parameters as of `plan_arc`."""
    return _sheet(machine, "projection", angles, mechanism, size, _("Positions by orthogonal projection, (334)"))


def plan_brix(
    machine: Machine, angles: int | Sequence[float] = 12, *, mechanism: str | None = None, size: str = "A4"
) -> Figure:
    """Draw a piston's positions by Brix's rays; parameters as of `plan_arc`."""
    return _sheet(machine, "brix", angles, mechanism, size, _("Positions by Brix's construction"))


def plan_brix_backward(
    machine: Machine, angles: int | Sequence[float] = _PARTS, *, mechanism: str | None = None, size: str = "A4"
) -> Figure:
    """Draw crank angles by Brix's rays from displacements, as an indicator diagram is unrolled.

    Parameters as of `plan_arc`, but a number of angles is into how many parts the stroke is divided.
    """
    return _sheet(machine, "brix_backward", angles, mechanism, size, _("Crank angles by Brix's construction"))


@drawing_settings()
def _sheet(
    machine: Machine, method: Method, angles: int | Sequence[float], mechanism: str | None, size: str, title: str
) -> Figure:
    """The construction to scale, beside its readings and the exact ones."""
    found = construction(machine, method, angles, mechanism=mechanism)
    page, box = plan_page(machine, angles, size, title, found.mechanism)
    wide = 0.62 * box.width
    left = Box(box.left, box.bottom + 8.0, wide, box.height - 8.0)
    bounds = np.stack(bounds_of(_sketch(found, 1e-9).outline()), axis=1)
    scale = fitting([1e-3 * bounds], (left.width - 26.0, left.height - 26.0))
    sketch = _sketch(found, 1e3 * scale)
    sketch.add(placed_labels(list(_wishes(found, 1e3 * scale)), [line.points for line in sketch.lines], 1e3 * scale))
    centre(page, sketch, left)
    write_scales(page, box, [scale_of("l", scale, "m")], 1e3 * scale)
    rows = (_backward_table if method == "brix_backward" else _forward_table)(found, scale)
    write_beside(page, box, box.left + wide + 6.0, rows, _notes(found), shares=_COLUMNS, gap=1.0)
    return page.figure


def _sketch(found: Construction, scale: float) -> Sketch:
    """Crank circle, line of stroke, what is constructed, dots at both its ends, bars at readings; in mm of metal."""
    is_arc = found.method == "arc"
    foot = found.piston if is_arc else found.foot
    right = float(np.max(found.piston[0]) if is_arc else found.geometry.crank_radius)
    radius, height = 1e3 * float(found.geometry.crank_radius), 1e3 * float(found.geometry.offset)
    ends = np.array([[-radius - 4.0 * scale, 1e3 * right + 4.0 * scale], [height, height]])
    axes = [ends, ends * np.array([[1.0], [0.0]])] if height else [ends]
    sketch = Sketch(scale)
    sketch.add(Line(axis, "GUIDES", "axis", 1) for axis in axes)
    shaft = np.zeros(2)
    sketch.add([Circle(shaft, radius, "PATHS", "rod", 2), Circle(shaft, 0.7 * scale, "LINKS", "outline", 6, "paper")])
    sketch.add(_arcs(found) if is_arc else _projections(found, scale))
    points = 1e3 * np.concatenate([found.on_circle, foot], axis=1)
    sketch.add(Circle(point, 0.6 * scale, "LINKS", "thin", 6, "paper") for point in points.T)
    if found.method != "brix_backward":
        sketch.add(_bars(found, scale))
    return sketch


def _arcs(found: Construction) -> Iterator[Line]:
    """Arcs about the piston's pin from the crank pin to the line of stroke; one position as a line drawing."""
    for pin, piston in zip(found.on_circle.T, found.piston.T, strict=True):
        start = angle_of(pin - piston) % (2 * np.pi)
        points = shapes.arc(1e3 * piston, 1e3 * float(found.geometry.rod_length), start, np.pi)
        yield Line(points, "LINKS", "construction", 3)
    first = min(1, found.piston.shape[1] - 1)
    linkage = np.stack([np.zeros(2), found.on_circle[:, first], found.piston[:, first]], axis=1)
    yield Line(1e3 * linkage, "LINKS", "outline", 4)


def _projections(found: Construction, scale: float) -> Iterator[Line | Circle]:
    """Perpendiculars from the crank circle to the line of stroke; from Brix's pole the rays, too."""
    if found.method != "projection":
        pole = 1e3 * np.array([found.pole, 0.0])
        for point in 1e3 * found.on_circle.T:
            yield Line(np.stack([pole, point], axis=1), "LINKS", "rod", 3)
        yield Circle(pole, 0.7 * scale, "LINKS", "outline", 6, "ink")
    for point, foot in zip(found.on_circle.T, found.foot.T, strict=True):
        yield Line(1e3 * np.stack([point, foot], axis=1), "LINKS", "construction", 3)


def _bars(found: Construction, scale: float) -> Iterator[Line]:
    """Short bars across the line of stroke: at the readings of arcs, else where these should be."""
    exact = found.geometry.crank_radius - found.exact_displacement
    points = found.foot if found.method == "arc" else np.stack([exact, np.zeros_like(exact)])
    for point in 1e3 * points.T:
        ends = point[:, np.newaxis] + 1.6 * scale * np.array([[0.0, 0.0], [-1.0, 1.0]])
        yield Line(ends, "PLAN_V", "outline", 5)


def _wishes(found: Construction, scale: float) -> Iterator[Wish]:
    """Shaft, pole, and numbers of the positions."""
    yield Wish(np.zeros(2), "O", -np.pi / 4)
    if found.method.startswith("brix"):
        yield Wish(1e3 * np.array([found.pole, 0.0]), "P", -3 * np.pi / 4)
    yield from _numbers(1e3 * found.on_circle, scale, None)
    is_apart = np.hypot(*(found.foot - found.on_circle)) > 1e-3 * scale
    yield from _numbers(1e3 * np.where(is_apart, found.foot, np.nan), scale, -np.pi / 2)
    if found.method == "arc":
        yield from _numbers(1e3 * found.piston, scale, np.pi / 2)


def _numbers(points: Array, scale: float, towards: float | None) -> Iterator[Wish]:
    """Numbers beside points, one direction for all or away from the shaft; those that fall together share a place."""
    for together in alike(points, scale):
        point = points[:, together[0]]
        outward = angle_of(point) if towards is None else towards
        yield Wish(point, ",".join(map(str, together)), outward, "number")


def _forward_table(found: Construction, scale: float) -> Iterator[tuple[str, ...]]:
    """Displacements as constructed and as they are."""
    yield (_("no."), "φ, °", _("paper, mm"), "S, mm", _("exact, mm"), "Δ, %")
    for number, (angle, made, exact) in enumerate(
        zip(found.angle, found.displacement, found.exact_displacement, strict=True)
    ):
        error = 100.0 * (made - exact) / found.stroke
        cells = (rounded(made / scale), figure(1e3 * made), figure(1e3 * exact), rounded(error))
        yield (f"{number}", f"{np.rad2deg(angle):g}", *cells)


def _backward_table(found: Construction, scale: float) -> Iterator[tuple[str, ...]]:
    """Crank angles on the way to the shaft, as constructed and as they are."""
    yield (_("no."), "S, mm", _("paper, mm"), "φ, °", _("exact, °"), "Δ, °")
    for number, (made, exact, way) in enumerate(zip(found.angle, found.exact_angle, found.displacement, strict=True)):
        angle, right = np.rad2deg([made, exact])
        yield (f"{number}", figure(1e3 * way), *map(rounded, (way / scale, angle, right, angle - right)))


def _notes(found: Construction) -> Iterator[str]:
    """What is drawn, the source's range, and how the construction is read."""
    arcs = _("Arcs about the piston's pin lead the crank pin to bars on the line")
    how = {
        "arc": (arcs, _("of stroke: exact, with an offset too.")),
        "brix_backward": (_("On the way to the shaft; on the way back 360° − φ."),),
    }
    yield from how.get(found.method, (_("Bars across the line of stroke: where the exact readings are."),))
    if found.method.startswith("brix"):
        distance = f"OP = λR/2 = {figure(-1e3 * found.pole)} mm"
        yield _("{distance}, away from the cylinder").format(distance=distance)
    yield from _range(found)
    yield _("φ from where the crank points along the cylinder, S from the top;")
    yield _("drawn in the mechanism's own axes, the shaft at the left.")


def _range(found: Construction) -> Iterator[str]:
    """The source's range, whether this mechanism is inside, and how exact Brix's construction is beside (333)."""
    limits = found.limits
    if limits is None:
        return
    reasons = list(limits.reasons(found.ratio, float(found.geometry.offset)))
    yield _("Range of the source: {condition} [{source}].").format(condition=_(limits.condition), source=limits.source)
    for reason in reasons:
        yield _("This mechanism is outside: {reason}.").format(reason=reason)
    if not reasons:
        yield _("This mechanism is inside, λ = {ratio:.4g}.").format(ratio=found.ratio)
    if found.method == "brix" and found.geometry.offset == 0:
        errors = (errors_by_ratio(method, found.ratio).displacement.value for method in ("brix", "two_harmonics"))
        said = [f"{percent(float(error))} %" for error in errors]
        yield _("Less exact than (333): off by {brix} of the stroke,").format(brix=said[0])
        yield _("not {harmonics}; arcs are exact.").format(harmonics=said[1])
