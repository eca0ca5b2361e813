"""Planar machines by Newton's laws alone: positions written down by hand, differentiated with 40 digits, one solve.

It shares nothing with what it judges: no group, no kernel, no reduced inertia.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from mpmath import mp

FRAME = "frame"
mp.dps = 40


class Body(NamedTuple):
    """Where its centre of mass is and how it stands by the crank angle; mass [kg], inertia about it [kg·m²]."""

    centre: Callable[[Any], tuple[Any, Any]]
    angle: Callable[[Any], Any]
    mass: float = 0.0
    inertia: float = 0.0


class Pin(NamedTuple):
    """Two bodies, and the point that both have."""

    first: str
    second: str
    point: Callable[[Any], tuple[Any, Any]]


class Slide(NamedTuple):
    """Two bodies that do not turn about each other: a force at a point across the guide's direction, and a moment."""

    first: str
    second: str
    point: Callable[[Any], tuple[Any, Any]]
    direction: Callable[[Any], Any]


class Load(NamedTuple):
    """On a body a force at a point [N], or a torque [N·m], by the crank angle."""

    body: str
    point: Callable[[Any], tuple[Any, Any]]
    force: Callable[[Any], tuple[float, float]] = lambda _angle: (0.0, 0.0)
    torque: Callable[[Any], float] = lambda _angle: 0.0


class ByHand(NamedTuple):
    """A machine: bodies, of which `crank` is driven, joints by name, loads, and the speed of its crank. [rad/s]"""

    bodies: Mapping[str, Body]
    joints: Mapping[str, Pin | Slide]
    loads: Sequence[Load]
    speed: float

    def inertia(self, angle: Any) -> Any:
        """J = Σ m v² + I ω², each over ω². [kg·m²]"""
        return mp.fsum(
            body.mass * mp.fsum(rate**2 for rate in rates(body.centre, angle))
            + body.inertia * mp.diff(body.angle, angle) ** 2
            for body in self.bodies.values()
        )

    def static_torque(self, angle: Any) -> float:
        """M_st = −Σ F·dr/dφ, by virtual work. [N·m]"""
        return -float(
            mp.fsum(
                mp.fdot(load.force(angle), rates(load.point, angle))
                + load.torque(angle) * mp.diff(self.bodies[load.body].angle, angle)
                for load in self.loads
            )
        )

    def solved(self, angle: Any) -> tuple[dict[str, float], float]:
        """Sizes of the joints' reactions [N] and the torque on the crank [N·m]: three equations a body, one solve."""
        rows = {name: 3 * place for place, name in enumerate(self.bodies)}
        columns: list[np.ndarray] = []
        for joint in self.joints.values():
            x, y = map(float, joint.point(angle))
            if isinstance(joint, Pin):
                wrenches = [(1.0, 0.0, -y), (0.0, 1.0, x)]
            else:
                along = float(joint.direction(angle))
                across = (-np.sin(along), np.cos(along))
                wrenches = [(*across, x * across[1] - y * across[0]), (0.0, 0.0, 1.0)]
            columns += [self._column(rows, joint, wrench) for wrench in wrenches]
        torque = np.zeros(3 * len(rows))
        torque[rows["crank"] + 2] = 1.0
        right = np.concatenate([self._accelerated(body, angle) for body in self.bodies.values()])
        for load in self.loads:
            x, y = map(float, load.point(angle))
            force = load.force(angle)
            right[rows[load.body] :][:3] -= [*force, x * force[1] - y * force[0] + load.torque(angle)]
        found = np.linalg.solve(np.stack([*columns, torque], axis=1), right)
        pairs = zip(self.joints.items(), found[:-1].reshape(-1, 2), strict=True)
        sizes = {
            name: float(np.hypot(*pair)) if isinstance(joint, Pin) else abs(float(pair[0]))
            for (name, joint), pair in pairs
        }
        return sizes, float(found[-1])

    def _column(self, rows: Mapping[str, int], joint: Pin | Slide, wrench: Sequence[float]) -> np.ndarray:
        column = np.zeros(3 * len(rows))
        for body, sign in ((joint.first, 1.0), (joint.second, -1.0)):
            if body != FRAME:
                column[rows[body] :][:3] += sign * np.array(wrench)
        return column

    def _accelerated(self, body: Body, angle: Any) -> np.ndarray:
        square = self.speed**2
        x, y = map(float, body.centre(angle))
        ax, ay = (square * float(rate) for rate in rates(body.centre, angle, 2))
        turning = square * float(mp.diff(body.angle, angle, 2))
        return np.array([body.mass * ax, body.mass * ay, body.inertia * turning + body.mass * (x * ay - y * ax)])


def rates(point: Callable[[Any], tuple[Any, Any]], angle: Any, order: int = 1) -> tuple[Any, Any]:
    """Derivatives of a point's coordinates by the crank angle. [m/rad or m/rad²]"""
    return mp.diff(lambda a: point(a)[0], angle, order), mp.diff(lambda a: point(a)[1], angle, order)


def met(first: tuple[Any, Any], radius: float, second: tuple[Any, Any], other: float, side: int) -> tuple[Any, Any]:
    """Where circles meet about two points, left (1) or right (−1) of the line from the first to the second."""
    dx, dy = second[0] - first[0], second[1] - first[1]
    square = dx * dx + dy * dy
    along = (square + radius**2 - other**2) / (2 * square)
    aside = side * mp.sqrt(radius**2 / square - along**2)
    return first[0] + along * dx - aside * dy, first[1] + along * dy + aside * dx


def direction(start: Callable[[Any], Any], end: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Direction of a link between two points. [rad]"""
    return lambda a: mp.atan2(end(a)[1] - start(a)[1], end(a)[0] - start(a)[0])


def beside(
    start: Callable[[Any], Any], end: Callable[[Any], Any], along: float, across: float = 0.0
) -> Callable[[Any], Any]:
    """A point on a link: so far along it, and to its left. [m]"""

    def point(angle: Any) -> tuple[Any, Any]:
        (x, y), turned = start(angle), direction(start, end)(angle)
        return (
            x + along * mp.cos(turned) - across * mp.sin(turned),
            y + along * mp.sin(turned) + across * mp.cos(turned),
        )

    return point
