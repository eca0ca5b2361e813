"""A detail of the shaft of a throw, where its crank is too small on a sheet to be seen."""

from collections.abc import Sequence

from cranktrain.panels.throw_scene import Scene
from cranktrain.viz.paper.detail import draw_detail, is_too_small
from cranktrain.viz.paper.page import Box, Page
from cranktrain.viz.paper.sketch import Sketch
from cranktrain.viz.throw.angle_marks import ring_radius
from cranktrain.viz.throw.mechanism import mechanism_sketch


def needs_detail(scene: Scene, scale: float) -> bool:
    """Whether the crank is too small at a scale to be seen, and too small for a degree ring."""
    return is_too_small(scene.crank_radius, scale)


def draw_throw_detail(
    page: Page,
    scene: Scene,
    moment: tuple[float, Sequence[Sequence[float]]],
    whole: Sketch,
    origin: tuple[float, float],
    room: Box,
) -> None:
    """Draw the shaft larger; `moment` is angle and dead positions as `mechanism_sketch` takes them. [deg]"""
    angle, dead = moment
    draw_detail(
        page, lambda scale: mechanism_sketch(scene, angle, scale, dead), ring_radius(scene), whole, origin, room
    )
