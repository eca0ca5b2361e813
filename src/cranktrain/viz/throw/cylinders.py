"""Cylinders on a sheet: their walls, where these begin and end, ports of opposed pistons."""

from collections.abc import Iterator

from cranktrain.panels.throw_member import DrawnMechanism
from cranktrain.panels.throw_scene import Scene
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.sketch import Line

_BELOW, _BELOW_IN_STAR = 0.34, 0.14
"""Skirt below the piston pin, in parts of the bore; in a star there is no room for long skirts."""

_GAP = 0.05
"""Clearance above the piston at its top, in parts of the bore."""


def wall_start(scene: Scene, member: DrawnMechanism) -> float:
    """Where a cylinder begins, from the shaft. [mm]"""
    lowest = member.travel[0] - skirt(scene, member)
    return min(max(lowest + 0.25 * member.width, scene.clearance * 1.02), member.travel[0] + 0.1 * member.width)


def skirt(scene: Scene, member: DrawnMechanism) -> float:
    """How far the skirt reaches below the piston pin. [mm]"""
    return (_BELOW_IN_STAR if scene.is_star else _BELOW) * member.width


def wall_end(scene: Scene, member: DrawnMechanism) -> float:
    """Where a cylinder ends, from the shaft. [mm]"""
    beyond = _BELOW * member.width if member.place.is_far else scene.above(member) + _GAP * member.width
    return member.travel[1] + beyond


def cylinder(scene: Scene, member: DrawnMechanism, scale: float) -> Iterator[Line]:
    """Centre line and walls; a crosshead runs between guides that are open at the end."""
    line = member.stroke_line
    end = wall_end(scene, member)
    yield Line(line.path((0.0, 0.0), (end + 2.0 * scale, 0.0)), "GUIDES", "axis", 2)
    span = wall_start(scene, member), end
    yield from shapes.walls(line, member.width, span, scale, has_head=member.bore is not None)


def common_cylinder(scene: Scene, pair: tuple[DrawnMechanism, DrawnMechanism], scale: float) -> Iterator[Line]:
    """Centre line, and walls from where one piston's begin to where the other's do, with gaps for the ports."""
    one, other = pair
    line = one.stroke_line
    far = float(line.place(other.centre))

    def along(member: DrawnMechanism, place: float) -> float:
        """Where a place that counts from a member's own shaft is on the line."""
        return place if member.place.shaft == one.place.shaft else far - place

    last = other.travel[1] + skirt(scene, other) if other.place.is_far else wall_start(scene, other)
    span = (wall_start(scene, one), along(other, last - 0.25 * other.width if other.place.is_far else last))
    yield Line(line.path((0.0, 0.0), (max(far, span[1]), 0.0)), "GUIDES", "axis", 2)
    gaps: list[tuple[float, float]] = []
    for member in pair:
        height = scene.ports[one.place.cylinder].get(member.place.name.rpartition(".")[2])
        if height is not None:
            outermost = member.travel[1] if member.place.is_far else member.travel[0]
            crown = outermost + member.toward_chamber * scene.above(member)
            ends = along(member, crown), along(member, crown + member.toward_chamber * height)
            gaps.append((min(ends), max(ends)))
    yield from shapes.walls(line, one.width, span, scale, has_head=False, ports=sorted(gaps))
