"""Marks of the crank angle on a sheet: the degree ring, and arrows of the sense in which shafts turn."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from cranktrain.motion import Array
from cranktrain.panels.throw_member import DrawnMechanism
from cranktrain.panels.throw_scene import BIG_EYE, SMALL_EYE, Scene
from cranktrain.plans.stroke_lines import unit
from cranktrain.plans.vectors import angle_of
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.sketch import Circle, Label, Line
from cranktrain.viz.throw.cylinders import skirt, wall_end, wall_start

_LEAST_RING = 11.0
"""Radius of a degree ring on paper that has room for all its figures. [mm]"""


def ring_radius(scene: Scene) -> float:
    """Radius of the degree ring: round the crank, and round the big end of a star. [mm]"""
    if not scene.is_star:
        return 1.62 * scene.crank_radius
    knuckle = np.hypot(*scene.slaves[0].turn_pins["C"])
    return float(np.nanmax(knuckle)) + 1.6 * SMALL_EYE * scene.crank_radius


def degree_ring(
    scene: Scene, lines: Sequence[tuple[Array, float]], angle: float, scale: float
) -> Iterator[Line | Circle | Label]:
    """Degree ring, its 0 where the shown crank angle is 0; figures that the links would hide are left out."""
    radius = ring_radius(scene)
    origin = np.zeros(2)
    figures = 30 if radius > _LEAST_RING * scale else 360
    yield Circle(origin, radius, "DIMENSIONS", "thin", 1)
    for degree in range(0, 360, 10):
        along = unit(scene.crank_direction(float(degree), scene.leading))
        tick = (1.6 if degree % 30 == 0 else 0.8) * scale
        yield Line(np.stack([(radius - tick) * along, radius * along], axis=1), "DIMENSIONS", "thin", 1)
        place = (radius + (2.6 + 1.4 * abs(along[0])) * scale) * along
        if (
            degree % figures == 0
            and (degree == 0 or not scene.is_star)
            and (degree == 0 or not _is_covered(scene, lines, place, angle, 2.6 * scale))
        ):
            yield Label(place, f"{degree}", "words" if degree else "name")


def _is_covered(scene: Scene, lines: Sequence[tuple[Array, float]], point: Array, angle: float, margin: float) -> bool:
    """Whether links or cylinders lie over a point."""
    for line, half in lines:
        for start, end in pairwise(line.T):
            part = np.clip(np.dot(point - start, end - start) / np.dot(end - start, end - start), 0.0, 1.0)
            if np.hypot(*(start + part * (end - start) - point)) < half + margin:
                return True
    for member in scene.sliders:
        line = member.stroke_line
        across = float(np.dot(point - line.foot, line.across))
        begin = min(wall_start(scene, member), scene.reach(member, angle) - skirt(scene, member))
        if line.place(point) > begin - margin and abs(across) < 0.5 * member.width + margin:
            return True
    return False


def _free_direction(scene: Scene, shaft: str) -> tuple[float, float]:
    """Direction farthest from all cylinders of a shaft, or from the rocker's pivot, and how far it is. [rad]"""
    taken = [
        angle_of(member.stroke_line.along)
        if member.output is not None
        else np.arctan2(*member.turn_pins[member.turn.fixed[-1]][::-1, 0])
        for member in scene.members
        if member.place.shaft == shaft
    ]
    tried = np.deg2rad(np.arange(0.0, 360.0, 5.0) - 90.0)
    room = [min(abs((angle - one + np.pi) % (2 * np.pi) - np.pi) for one in taken) for angle in tried]
    best = max(room)
    return float(next(angle for angle, free in zip(tried, room, strict=True) if free > best - 1e-9)), float(best)


def rotations(scene: Scene, scale: float) -> Iterator[Line]:
    """Arrows of the sense in which the shafts turn; one that is geared the other way turns against the main one."""
    for member in {member.place.shaft: member for member in scene.cranks}.values():
        radius, middle, half = _arc_of(scene, member, scale)
        yield Line(shapes.arc(member.centre, radius, middle - half, middle + half), "DIMENSIONS", "outline", 5)
        turns = scene.crank_direction(1.0, member) - scene.crank_direction(0.0, member)
        sense = np.sign((turns + np.pi) % (2 * np.pi) - np.pi)
        end = middle + sense * half
        tip = member.centre + radius * unit(end)
        yield shapes.arrowhead(tip, float(end + sense * (np.pi / 2 - 1.1 * scale / radius)), 2.6 * scale)


def _arc_of(scene: Scene, member: DrawnMechanism, scale: float) -> tuple[float, float, float]:
    """Radius, middle and half the width of an arrow round a shaft, clear of all that is drawn there. [mm, rad]"""
    middle, room = _free_direction(scene, member.place.shaft)
    if member.place.shaft != scene.leading.place.shaft:
        radius = scene.crank_radius * (1.0 + 1.12 * BIG_EYE) + 2.5 * scale
        return radius, middle, min(0.6, 9.0 * scale / radius)
    if scene.is_star:
        radius = max(wall_end(scene, slider) for slider in scene.sliders)
        covered = float(np.arcsin(0.5 * max(slider.width for slider in scene.sliders) / radius))
        return radius, middle, room - covered - 3.0 * scale / radius
    # Outside the ring's figures, which reach farther out at its sides than above and below.
    radius = ring_radius(scene) + (6.5 + 2.5 * abs(np.cos(middle))) * scale
    return radius, middle, min(0.42, 11.0 * scale / radius)
