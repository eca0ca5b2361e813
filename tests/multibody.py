"""A planar multibody solver: rigid bodies, joints, Lagrange multipliers; it knows no mechanism and no group.

Every body has its centroid and angle as coordinates. From the bodies' positions alone it finds velocities and
accelerations, which the joints and the crank's motion determine, and the forces in the joints: the multipliers.
"""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from cranktrain.linkage.forces import Body, Wrench
from cranktrain.motion import Link

FRAME = -1


def left_of(vector):
    return np.array([-vector[1], vector[0]])


class Row(NamedTuple):
    """An equation of a joint: of its place along a normal that turns with the carrier, of angles, or of the crank."""

    kind: str
    name: str
    one: int
    other: int
    place: Any = None
    normal: Any = None
    carrier: int = FRAME


@dataclass
class Multibody:
    """Bodies in one position of the crank; a joint's method gives its name to what `solve` finds."""

    masses: list = field(default_factory=list)
    centres: list = field(default_factory=list)
    angles: list = field(default_factory=list)
    loads: np.ndarray = field(default_factory=lambda: np.zeros(0))
    rows: list = field(default_factory=list)

    def body(self, link: Link, body: Body, load: Wrench) -> int:
        """A link's position and mass, and a wrench about its first pin; its number."""
        along = np.array([float(link.cos), float(link.sin)])
        origin = np.array([float(link.origin.x.value), float(link.origin.y.value)])
        arm = body.along * along + body.across * left_of(along)
        self.masses += [body.mass, body.mass, body.inertia]
        self.centres.append(origin + arm)
        self.angles.append(np.arctan2(*along[::-1]))
        force = np.array([load.x, load.y])
        self.loads = np.append(self.loads, [*force, load.moment - (arm[0] * force[1] - arm[1] * force[0])])
        return len(self.centres) - 1

    def _arm(self, body, place):
        return np.zeros(2) if body == FRAME else np.asarray(place) - self.centres[body]

    def force(self, body: int, place, force) -> None:
        """A force on a body at a place."""
        arm = self._arm(body, place)
        self.loads[3 * body : 3 * body + 3] += np.array([*force, arm[0] * force[1] - arm[1] * force[0]])

    def pin(self, name: str, one: int, other: int, place) -> None:
        """A joint at a place: its force is on the first body."""
        for axis in np.eye(2):
            self.rows.append(Row("point", name, one, other, np.asarray(place), axis, FRAME))

    def slot(self, name: str, one: int, other: int, place, direction: float) -> None:
        """A place of the first body stays on a line of the other; its force is on the first body."""
        normal = left_of((np.cos(direction), np.sin(direction)))
        self.rows.append(Row("point", name, one, other, np.asarray(place), normal, other))

    def line(self, name: str, one: int, other: int, place, direction: float) -> None:
        """A slot in which both bodies turn alike; force and couple are on the first body."""
        self.slot(name, one, other, place, direction)
        self.rows.append(Row("angle", name, one, other))

    def weld(self, one: int, other: int) -> None:
        """Two bodies are one; what passes between them has no name and is not compared."""
        self.pin("", one, other, (0, 0))
        self.rows.append(Row("angle", "", one, other))

    def drive(self, crank: int) -> None:
        """The crank turns as given; `solve` gives its torque last."""
        self.rows.append(Row("drive", "", crank, FRAME))

    def _gradient(self, row):
        kind, _, one, other, place, normal, _ = row
        gradient = np.zeros(len(self.masses))
        for body, sign in ((one, 1.0), (other, -1.0)):
            if body == FRAME:
                continue
            at = slice(3 * body, 3 * body + 3)
            if kind == "point":
                gradient[at] = sign * np.array([*normal, normal @ left_of(self._arm(body, place))])
            else:
                gradient[at] = sign * np.array([0.0, 0.0, 1.0])
        return gradient

    def _velocity(self, row, rates, body):
        """Velocity of the joint's place as a point of the body, and its acceleration but for that of coordinates."""
        if body == FRAME:
            return np.zeros(2), np.zeros(2)
        x, y, turn = rates[3 * body : 3 * body + 3]
        arm = self._arm(body, row[4])
        return np.array([x, y]) + turn * left_of(arm), -(turn**2) * arm

    def _bias(self, row, rates):
        """Second derivative of a joint's equation but for the coordinates' own, with the sign changed."""
        kind, _, one, other, _, normal, carrier = row
        if kind != "point":
            return 0.0
        velocity, centripetal = self._velocity(row, rates, one)
        other_velocity, other_centripetal = self._velocity(row, rates, other)
        turn = 0.0 if carrier == FRAME else rates[3 * carrier + 2]
        along = np.array([normal[1], -normal[0]])
        return -(normal @ (centripetal - other_centripetal) - 2 * turn * (along @ (velocity - other_velocity)))

    def solve(self, speed: float, acceleration: float, gravity) -> np.ndarray:
        """Force or couple of each row."""
        assert len(self.masses) == len(self.rows), "the crank alone must decide where everything is"
        gradients = np.array([self._gradient(row) for row in self.rows])
        is_drive = np.array([row.kind == "drive" for row in self.rows])
        rates = np.linalg.solve(gradients, speed * is_drive)
        bias = np.array([self._bias(row, rates) for row in self.rows]) + acceleration * is_drive
        accelerations = np.linalg.solve(gradients, bias)
        weights = np.ravel([[mass * gravity[0], mass * gravity[1], 0.0] for mass in self.masses[::3]])
        needed = np.array(self.masses) * accelerations - weights - self.loads
        return np.linalg.solve(gradients.T, needed)

    def compare(self, joints: dict[str, Wrench], torques, conditions) -> tuple[float, float]:
        """Largest difference of joints and torques from what is found here, and the largest force.

        A row whose name begins with a minus is the joint seen from its other body.
        """
        values = self.solve(*conditions.drive, conditions.gravity)
        apart = [abs(torque - values[-1]) for torque in torques]
        for row, value in zip(self.rows, values, strict=True):
            if not row.name:
                continue
            wrench = joints[row.name.removeprefix("-")]
            got = wrench.moment if row.kind == "angle" else row.normal @ np.array(wrench[:2])
            apart.append(abs((-got if row.name.startswith("-") else got) - value))
        forces = [abs(value) for row, value in zip(self.rows, values, strict=True) if row.kind == "point"]
        return max(apart), max(forces)
