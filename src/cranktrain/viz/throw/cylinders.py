"""Cylinders on a sheet: their walls, where these begin and end, ports of opposed pistons, crossheads on their bars."""

from collections.abc import Iterator

from cranktrain.panels.crosshead import CrossheadDrawing
from cranktrain.panels.throw_member import DrawnMechanism
from cranktrain.panels.throw_scene import Scene
from cranktrain.plans.stroke_lines import Along
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.sketch import Fill, Line

_BELOW, _BELOW_IN_STAR = 0.34, 0.14
"""Skirt below the piston pin, in parts of the bore; in a star there is no room for long skirts."""

_GAP = 0.05
"""Clearance above the piston at its top, in parts of the bore."""

_GLAND = 0.12
"""How far a gland reaches beyond its piston rod, in parts of the bore."""

_BED = 1.1
"""How far a bed reaches to either side of a ram, in parts of its width."""

_RINGS = (-0.25, 0.0, 0.25)
"""Where the rings of a double-acting piston are, from its middle, in parts of its thickness."""


def wall_start(scene: Scene, member: DrawnMechanism) -> float:
    """Where a cylinder begins, or the slide bars before it, from the shaft. [mm]"""
    if member.crosshead is not None:
        return float(member.crosshead.bars[0])
    lowest = member.travel[0] - skirt(scene, member)
    return min(max(lowest + 0.25 * member.width, scene.clearance * 1.02), member.travel[0] + 0.1 * member.width)


def skirt(scene: Scene, member: DrawnMechanism) -> float:
    """How far the skirt, or a crosshead, reaches below its pin. [mm]"""
    if member.crosshead is not None:
        return 0.5 * float(member.crosshead.shoe[0])
    if member.ram is not None:
        return member.ram.back
    return (_BELOW_IN_STAR if scene.is_star else _BELOW) * member.width


def wall_end(scene: Scene, member: DrawnMechanism) -> float:
    """Where a cylinder ends, from the shaft. [mm]"""
    if member.crosshead is not None:
        return float(member.crosshead.covers[1])
    if member.ram is not None:
        return member.ram.bed
    beyond = _BELOW * member.width if member.place.is_far else scene.above(member) + _GAP * member.width
    return member.travel[1] + beyond


def cylinder(scene: Scene, member: DrawnMechanism, scale: float) -> Iterator[Line]:
    """Centre line and walls; a crosshead runs between guides that are open at the end."""
    line = member.stroke_line
    end = wall_end(scene, member)
    if member.ram is not None:
        end = float(member.ram.ends[0])  # its guides leave the face free
    yield Line(line.path((0.0, 0.0), (wall_end(scene, member) + 2.0 * scale, 0.0)), "GUIDES", "axis", 2)
    if member.crosshead is not None:
        yield from _covered_cylinder(line, member.width, member.crosshead, scale)
        return
    span = wall_start(scene, member), end
    yield from shapes.walls(line, member.width, span, scale, has_head=member.bore is not None)
    if member.ram is not None:
        half = _BED * member.width
        bed = line.path((member.ram.bed, -half), (member.ram.bed, half))
        yield Line(bed, "GUIDES", "outline", 2)
        yield shapes.hatch(bed[:, 0], bed[:, 1], line.along, scale)


def _covered_cylinder(line: Along, bore: float, crosshead: CrossheadDrawing, scale: float) -> Iterator[Line]:
    """Cylinder between two covers, gland of the piston rod in that at the crank end, slide bars of the crosshead."""
    near, far = map(float, crosshead.covers)
    yield from shapes.walls(line, bore, (near, far), scale, has_head=True)
    rod = 0.5 * crosshead.rod_diameter
    box = min(rod + _GLAND * bore, 0.5 * bore)
    gland = crosshead.gland
    bars = tuple(map(float, crosshead.bars))
    for side in (-1.0, 1.0):
        cover = line.path((near, side * rod), (near, side * 0.5 * bore))
        yield Line(cover, "GUIDES", "outline", 2)
        if box < 0.5 * bore:
            yield shapes.hatch(line.at(near, side * box), cover[:, 1], -line.along, scale)
        packing = line.path((gland, side * rod), (near, side * rod), (near, side * box), (gland, side * box))
        yield Line(packing, "GUIDES", "outline", 5, is_closed=True, fill="dark")
        bar = line.path(*((end, side * 0.5 * float(crosshead.shoe[1])) for end in bars))
        yield Line(bar, "GUIDES", "outline", 2)
        yield shapes.hatch(bar[:, 0], bar[:, 1], side * line.across, scale)


def crosshead_parts(line: Along, pin: float, bore: float, crosshead: CrossheadDrawing, fill: Fill) -> Iterator[Line]:
    """Crosshead about its pin, whose place along the line is `pin`; piston rod; piston with its rings."""
    length, height = map(float, crosshead.shoe)
    end = pin + crosshead.rod_length
    yield Line(line.block((pin, end), 0.5 * crosshead.rod_diameter), "LINKS", "rod", 4, True, "paper")
    yield Line(line.block((pin - 0.5 * length, pin + 0.5 * length), 0.5 * height), "LINKS", "outline", 4, True, fill)
    half, across = 0.5 * crosshead.piston, 0.5 * bore * 0.97
    yield Line(line.block((end - half, end + half), across), "LINKS", "outline", 4, True, fill)
    for ring in (end + part * crosshead.piston for part in _RINGS):
        yield Line(line.path((ring, -across), (ring, across)), "LINKS", "thin", 4)


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
