"""The sheet of a machine: its throw to scale, its curves, and what both rest on."""

from collections.abc import Iterator, Sequence

from cranktrain.analysis import Result
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.plans.vectors import pair
from cranktrain.viz.paper.head import result_page
from cranktrain.viz.paper.labels import labelled_bounds
from cranktrain.viz.paper.page import Box, Figure, Page, drawing_settings, fitting_scale
from cranktrain.viz.paper.panels import MOTION, draw_panels
from cranktrain.viz.paper.style import MUTED
from cranktrain.viz.paper.words import first_that_holds
from cranktrain.viz.sheets.motion.dead_centres import Mark, ruler_of
from cranktrain.viz.sheets.motion.panels import panels
from cranktrain.viz.sheets.motion.ruler import draw_ruler
from cranktrain.viz.throw.detail import draw_throw_detail, needs_detail
from cranktrain.viz.throw.mechanism import mechanism_sketch
from cranktrain.viz.throw.scene import Scene, scene_of

_NOTE = 4.0
"""Height of a line of notes at the foot. [mm]"""

_ROUGH, _PASSES = 20.0, 3
"""Crank radius on paper to begin with, and how often the scale is corrected: hatches keep their size on paper."""

_ANGLE = 50.0
"""Crank angle at which the throw is drawn, unless given. [deg]"""


@drawing_settings()
def sheet(result: Result, *, size: str = "A4", at: float = _ANGLE, design: int = 0) -> Figure:
    """Draw the sheet of a machine.

    Parameters
    ----------
    result : Result
    size : "A4" or "A3"
        Lying.
    at : float
        Crank angle at which the throw is drawn. [deg]
    design : int
        Which of the result's machines.

    Returns
    -------
    Figure
        In millimetres of paper: the throw is to the scale that the sheet says.
    """
    page, box = result_page(result, design, size)
    ruler = ruler_of(result, design)
    middle = 0.48 * box.width
    _draw_mechanism(page, result.machines[design], ruler.marks, at, box._replace(width=middle - 4.0))
    left, right = box.left + middle + 12.0, box.left + box.width
    below = draw_ruler(page, ruler, left, right, box.bottom + box.height)
    draw_panels(page, panels(result, design), Box(left, box.bottom, right - left, below - box.bottom), MOTION)
    return page.figure


def _draw_mechanism(page: Page, machine: Machine, found: Sequence[Mark], at: float, box: Box) -> None:
    """Draw the throw as large as a round scale allows."""
    scene = scene_of(machine)
    at = scene.closing_angle(at)
    notes = list(_notes(scene, at))
    foot = 6.0 + _NOTE * len(notes)
    room = box._replace(bottom=box.bottom + foot, height=box.height - foot)
    names = [(member.place.name, member.place.cylinder) for member in scene.members]
    dead = [[mark.angle for mark in found if mark.name in own] for own in names]
    sketch = mechanism_sketch(scene, at, scene.crank_radius / _ROUGH, dead)
    for _pass in range(_PASSES):
        low, high = labelled_bounds(sketch)
        scale = fitting_scale(*pair(high - low), (room.width - 1.0, room.height - 6.0))
        sketch = mechanism_sketch(scene, at, scale, dead, has_ring=not needs_detail(scene, scale))
    low, high = (corner / sketch.scale for corner in labelled_bounds(sketch))
    origin = pair(room.middle - (low + high) / 2)
    page.draw(sketch, origin)
    if needs_detail(scene, sketch.scale):
        draw_throw_detail(page, scene, (at, dead), sketch, origin, room)
    page.scale_bar(room.left, room.bottom - 5.0, sketch.scale)
    for number, note in enumerate(reversed(notes)):
        page.text(box.left, box.bottom - 0.4 + _NOTE * number, note, color=MUTED)


def _notes(scene: Scene, angle: float) -> Iterator[str]:
    """Say what is drawn, at which crank angle, and what of it is to scale."""
    yield _drawn_words(scene, angle)
    if scene.assumed:
        yield _("distance of the shafts assumed for the drawing: the file does not give it")
    if any(member.place.is_far for member in scene.members):
        yield _("dashed: side rods, which pass outside the cylinder")
    broken = [member.place.name for member in scene.members if member.cut]
    if broken:
        yield _("rod of {names} broken, its slider drawn nearer to the shaft").format(names=", ".join(broken))
    shapes = _("pins to scale, shapes schematic")
    pistons = [member for member in scene.sliders if member.place.kind.has_chambers]
    if pistons and all(member.bore is not None for member in pistons):
        shapes = _("pins and bores to scale, other shapes schematic")
    thin = _("thin: volumetric dead centres") if scene.pairs else _("thin: dead positions")
    yield f"{shapes}; {thin}"


def _drawn_words(scene: Scene, angle: float) -> str:
    """Say which throws are drawn, of which shafts, and at which crank angle."""
    machine = scene.machine
    n = len(machine.main_shaft.throws)
    places = [member.place for member in scene.cranks]
    shafts = [shaft for shaft in machine.shafts if shaft in {place.shaft for place in places}]
    throws = sorted({place.throw + 1 for place in places})
    said = [f"{place.shaft} {place.throw + 1}" for place in places] if len(shafts) > 1 else map(str, throws)
    drawn = first_that_holds(
        (len(shafts) > 1 and len(throws) > 1, _("Throws {throws}, drawn at φ = {angle:g}°")),
        (len(throws) > 1, _("Throws {throws} of {n}, drawn at φ = {angle:g}°")),
        (n > 1, _("Throw {throw} of {n}, drawn at φ = {angle:g}°")),
        (True, _("Drawn at φ = {angle:g}°")),
    ).format(throws=", ".join(said), throw=throws[0], n=n, angle=angle)
    return first_that_holds(
        (len(machine.shafts) == 1, "{drawn}"),
        (len(shafts) == len(machine.shafts), _("{drawn}; shafts {shafts}")),
        (len(shafts) > 1, _("{drawn}; shafts {shafts}, no other is drawn")),
        (True, _("{drawn}; of shaft {shaft}, no other is drawn")),
    ).format(drawn=drawn, shaft=shafts[0], shafts=", ".join(shafts))
