"""The sheet of a machine: its throws to scale, its curves, and what both rest on."""

from collections.abc import Iterator, Sequence
from functools import partial

from cranktrain.analysis import Result
from cranktrain.language import Listed, Message, Words, _
from cranktrain.layout.speed import SpeedCurve
from cranktrain.panels.parts import DrawnThrows, RulerMark, Sheet, SheetColumn, Stack, ThrowsAtAngle, sheet_of
from cranktrain.panels.sheets.motion.dead_centres import ruler_of
from cranktrain.panels.sheets.motion.panels import panels
from cranktrain.panels.throw_scene import Scene, scene_of
from cranktrain.plans.drawn_throws import drawn_throws
from cranktrain.saying.wording import first_that_holds

_ANGLE = 50.0
"""Crank angle at which the throw is drawn, unless given. [deg]"""


def sheet(
    result: Result, *, at: float = _ANGLE, design: int = 0, piston: str | None = None, scale: float | None = None
) -> Sheet:
    """Collect what the sheet of a machine shows.

    Parameters
    ----------
    result : Result
    at : float
        Crank angle at which the throw is drawn. [deg]
    design : int
        Which of the result's machines.
    piston : str, optional
        Whose throw alone is drawn, by the mechanism's name or its cylinder's; one of each sort unless given.
    scale : float, optional
        Millimetres of metal in one of paper, 4 for 1:4; the largest round one that fits, unless given.

    Returns
    -------
    Sheet
    """
    ruler = ruler_of(result, design, piston)
    curves = Stack(panels(result, design, piston), of_motion=True)
    throws = DrawnThrows(partial(_throws, result, design, ruler.marks, at, piston), scale)
    return sheet_of(result, design, "", SheetColumn(0.48, (throws,)), SheetColumn(0.52, (ruler, curves)))


def drawn_scenes(result: Result, design: int = 0, piston: str | None = None) -> tuple[Scene, ...]:
    """Collect the throws that are drawn.

    Parameters
    ----------
    result : Result
    design : int
        Which of the result's machines.
    piston : str, optional
        Whose throw alone, by the mechanism's name or its cylinder's; unless given, one of each sort.

    Returns
    -------
    tuple of Scene
    """
    machine, speed = result.machines[design], result.get(SpeedCurve) or "constant"
    throws = drawn_throws(machine, piston)
    return tuple(scene_of(machine, throw, is_alone=len(throws) == 1, speed=speed) for throw in throws)


def _throws(
    result: Result,
    design: int,
    found: Sequence[RulerMark],
    at: float,
    piston: str | None,
) -> ThrowsAtAngle:
    """The throws at a crank angle, with their dead positions and what is said of them."""
    scenes = drawn_scenes(result, design, piston)
    for scene in scenes:
        at = scene.closing_angle(at)
    names = [[(member.place.name, member.place.cylinder) for member in scene.members] for scene in scenes]
    dead = tuple(tuple(tuple(mark.angle for mark in found if mark.name in own) for own in each) for each in names)
    return ThrowsAtAngle(scenes, at, dead, tuple(_notes(scenes, at, dead)))


def _notes(scenes: Sequence[Scene], angle: float, dead: Sequence[Sequence[Sequence[float]]]) -> Iterator[Words]:
    """Say what is drawn, at which crank angle, and what of it is to scale."""
    members = [member for scene in scenes for member in scene.members]
    sliders = [slider for scene in scenes for slider in scene.sliders]
    yield _drawn_words(scenes, angle)
    if any(member.turn.points for member in members):
        yield _("marks on a point's curve at every 30° of the crank, filled at φ = 0")
    if scenes[0].assumed:
        yield _("distance of the shafts assumed for the drawing: the file does not give it")
    if any(member.place.is_far for member in members):
        yield _("dashed: side rods, which pass outside the cylinder")
    broken = [member.place.name for member in members if member.cut]
    if broken:
        yield _("rod of {names} broken, its slider drawn nearer to the shaft", names=", ".join(broken))
    shapes = _("pins to scale, shapes schematic")
    pistons = [member for member in sliders if member.place.kind.output.has_chambers]
    if pistons and all(member.bore is not None for member in pistons):
        shapes = _("pins and bores to scale, other shapes schematic")
    if not any(_has_thin(scene, own) for scene, own in zip(scenes, dead, strict=True)):
        yield shapes
        return
    thin = _("thin: volumetric dead centres") if any(scene.pairs for scene in scenes) else _("thin: dead positions")
    yield Listed((shapes, thin), "; ")


def _has_thin(scene: Scene, dead: Sequence[Sequence[float]]) -> bool:
    """Whether of a throw anything is drawn thin in the dead positions of its members."""
    return any(
        bool(angles) and (scene.is_of_few or member.output is not None)
        for member, angles in zip(scene.members, dead, strict=True)
    )


def _drawn_words(scenes: Sequence[Scene], angle: float) -> Words:
    """Say which throws are drawn, of which shafts, and at which crank angle."""
    machine = scenes[0].machine
    n = len(machine.main_shaft.throws)
    places = [member.place for scene in scenes for member in scene.cranks]
    shafts = [shaft for shaft in machine.shafts if shaft in {place.shaft for place in places}]
    throws = sorted({place.throw + 1 for place in places})
    said = [f"{place.shaft} {place.throw + 1}" for place in places] if len(shafts) > 1 else map(str, throws)
    drawn = first_that_holds(
        (len(shafts) > 1 and len(throws) > 1, _("Throws {throws}, drawn at φ = {angle:g}°")),
        (len(throws) > 1, _("Throws {throws} of {n}, drawn at φ = {angle:g}°")),
        (n > 1, _("Throw {throw} of {n}, drawn at φ = {angle:g}°")),
        (True, _("Drawn at φ = {angle:g}°")),
    ).format(throws=", ".join(said), throw=throws[0], n=n, angle=angle)
    if len(machine.shafts) == 1:
        return drawn
    whole: Message = first_that_holds(
        (len(shafts) == len(machine.shafts), _("{drawn}; shafts {shafts}")),
        (len(shafts) > 1, _("{drawn}; shafts {shafts}, no other is drawn")),
        (True, _("{drawn}; of shaft {shaft}, no other is drawn")),
    )
    return whole.format(drawn=drawn, shaft=shafts[0], shafts=", ".join(shafts))
