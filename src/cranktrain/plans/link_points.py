"""Points that the machine file asks to follow, such as a coupler's, as pins of a drawing."""

from collections.abc import Container
from dataclasses import replace

import numpy as np

from cranktrain.layout.places import PlacedMechanism
from cranktrain.linkage import LinkPoint, point
from cranktrain.mechanisms.drawing import Drawing, DrawnLink
from cranktrain.motion import Array, Link, Point


def with_points(drawing: Drawing, place: PlacedMechanism, angle: Array) -> Drawing:
    """Give a drawing with the points on links that its machine file names.

    Parameters
    ----------
    drawing : Drawing
        Of the place, in its own axes, at each angle.
    place : PlacedMechanism
    angle : Array, shape (n,)
        Of the mechanism's crank. [rad]

    Returns
    -------
    Drawing
        Each point is a pin of its link, with a path; one that has a pin's name is called `C_p`.
    """
    if not place.spec.points:
        return drawing
    motion = place.kind.motion(angle, place.geometry)
    links = list(drawing.links)
    found: dict[str, Point] = {}
    for own, spec in place.spec.points.items():
        name = own if own not in drawing.pins else _beside(own)
        link: Link = place.kind.named(motion, spec.link)
        along, across = spec.along.si, place.sense * spec.across.si
        found[name] = point(link, LinkPoint(np.hypot(along, across), np.arctan2(across, along)))
        at = _drawn_as(links, drawing, spec.link, link)
        if at is not None:
            links[at] = links[at]._replace(pins=(*links[at].pins, name))
    return replace(
        drawing,
        pins={**drawing.pins, **found},
        links=tuple(links),
        paths=(*drawing.paths, *found),
        points=(*drawing.points, *found),
    )


def followed_pin(name: str, pins: Container[str]) -> str:
    """Name the pin that a followed point is, of the pins of a drawing that has it."""
    return _beside(name) if _beside(name) in pins else name


def _beside(name: str) -> str:
    """Name the pin of a point that is called as another pin."""
    return f"{name}_p"


def _drawn_as(links: list[DrawnLink], drawing: Drawing, name: str, link: Link) -> int | None:
    """Find the drawn link that is a link of the mechanism: by its name, else by where it begins and points."""
    for i, drawn in enumerate(links):
        if drawn.name == name:
            return i
    for i, drawn in enumerate(links):
        start, end = (_place(drawing.pins[pin]) for pin in drawn.pins[:2])
        far = np.max(np.abs(end - start))
        reach = end - start
        turn = reach[0] * link.sin - reach[1] * link.cos
        if _is_small(start - _place(link.origin), far) and _is_small(turn, far):
            return i
    return None


def _place(pin: Point) -> Array:
    """Where a pin is, shape (2, n)."""
    return np.stack(np.broadcast_arrays(np.atleast_1d(pin.x.value), np.atleast_1d(pin.y.value)))


def _is_small(gap: Array, far: float) -> bool:
    """Whether a distance is nothing beside a length; NaN says nothing."""
    return bool(np.nanmax(np.abs(gap)) < 1e-9 * far)
