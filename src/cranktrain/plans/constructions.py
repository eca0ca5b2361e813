"""The sources' drawn constructions of a piston on a slider-crank, or a valve on an eccentric, beside the exact motion.

All are in the mechanism's own axes: x along the line of stroke away from the shaft, y toward +y. The crank angle, which
is the eccentric's, counts from where it points along x, and displacements from the top toward the shaft.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Literal, NamedTuple

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.fluids.indicator.brix import brix_angle
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.mechanisms.slider_crank import SliderCrank, slider_crank
from cranktrain.motion import Array
from cranktrain.plans.placement import frame, plain_crank_called
from cranktrain.plans.positions import plan_angles
from cranktrain.record import record
from cranktrain.texts.plain_cranks import plain_crank
from cranktrain.texts.ranges import RANGES, Range
from cranktrain.texts.steam_engine import brix, infinite_rod, largest_difference

Method = Literal["arc", "projection", "brix", "brix_backward"]

_RANGES = {"projection": "infinite_rod", "brix": "brix", "brix_backward": "brix"}
"""Methods of `cranktrain.texts.ranges` whose range a construction has; the arc has none."""


@record
class Readings:
    """What is read off a construction, and what it draws.

    Attributes
    ----------
    angle, exact_angle : Array, shape (n,)
        Crank angle; read backwards, as constructed and as it is, else both as given. [rad]
    displacement, exact_displacement : Array, shape (n,)
        As constructed and as it is; read backwards, both as given. [m]
    on_circle, foot, piston : Array, shape (2, n)
        What is drawn: where the crank circle is met, the reading on the line of stroke, and the crosshead's pin. [m]
    """

    angle: Array
    exact_angle: Array
    displacement: Array
    exact_displacement: Array
    on_circle: Array
    foot: Array
    piston: Array


class CrankSide(NamedTuple):
    """Positions by arcs from the crank-side dead centre, A_M′ of fig. 146.

    Attributes
    ----------
    on_circle, piston, foot, projected : Array, shape (2, n)
        A′, B′, C′ and D′: crank pin, piston's pin, and what arc and perpendicular from A′ mark on the line. [m]
    displacement, exact_displacement : Array, shape (n,)
        A_M′C′ and B_M′B′, away from the shaft. [m]
    """

    on_circle: Array
    piston: Array
    foot: Array
    projected: Array
    displacement: Array
    exact_displacement: Array


@record
class Construction(Readings):
    """A construction of one mechanism in several positions.

    Attributes
    ----------
    mechanism : str
    method : "arc", "projection", "brix" or "brix_backward"
    is_of_eccentric : bool
        Whether the crank is an eccentric, and the piston a valve.
    geometry : SliderCrank
    pole : float
        x of Brix's pole. [m]
    limits : Range or None
        The source's range; None where it needs none.
    sense : float
        +1 where the crank turns clockwise as seen from the free end, −1 where it turns anticlockwise.
    """

    mechanism: str
    method: Method
    is_of_eccentric: bool
    geometry: SliderCrank
    pole: float
    limits: Range | None
    sense: float

    def seen(self, points: Array) -> Array:
        """Give points as seen from the free end, the line of stroke lying, its end away from the shaft at the right.

        Shapes (2, ...).
        """
        return np.stack([points[0], -self.sense * points[1]])

    @property
    def start(self) -> Array:
        """Where readings of the displacement begin on paper: where the top dead centre is read, shape (2,). [m]"""
        if self.method != "arc":
            return np.array([self.geometry.crank_radius, 0.0])
        return np.array([_end(self.geometry) - self.geometry.rod_length, self.geometry.offset])

    @property
    def projected(self) -> Array:
        """Feet of the perpendiculars from the crank pin onto the line of stroke, D of fig. 146, shape (2, n). [m]

        Of a central mechanism A_M D = R(1 − cos φ) and DC = L(1 − √(1 − λ² sin² φ)), which add up to S.
        """
        return _on_line(self.geometry.crank_radius * np.cos(self.exact_angle), self.geometry)

    @property
    def from_crank_side(self) -> "CrankSide":
        """A′, B′, C′ and D′ of fig. 146: the same angles counted from the crank-side dead centre.

        The source gives A_M′C′ = A_M′D′ − D′C′, (333) with the minus sign; here C′ is where the arc about B′ truly is.
        """
        turned = self.exact_angle + np.pi
        arcs = _arc(self.geometry, turned)
        end = _end(self.geometry, -1.0)
        return CrankSide(
            on_circle=arcs.on_circle,
            piston=arcs.piston,
            foot=arcs.foot,
            projected=_on_line(self.geometry.crank_radius * np.cos(turned), self.geometry),
            displacement=arcs.foot[0] - (end - self.geometry.rod_length),
            exact_displacement=arcs.piston[0] - end,
        )

    @property
    def dead_pins(self) -> tuple[Array, Array]:
        """Crank pin and piston's pin at the top and at the bottom, shape (2, 2) each: point, top and bottom. [m]"""
        radius, rod, offset = self.geometry[:3]
        ends = np.array([_end(self.geometry), _end(self.geometry, -1.0)])
        pistons = np.stack([ends, np.full(2, offset)])
        share = np.array([radius / (rod + radius), -radius / (rod - radius)])
        return share * pistons, pistons

    @property
    def stroke(self) -> float:
        """Exact stroke. [m]"""
        return _stroke(self.geometry)

    @property
    def ratio(self) -> float:
        """λ = R/L."""
        return float(self.geometry.crank_radius / self.geometry.rod_length)


def construction(
    machine: Machine, method: Method, angles: int | Sequence[float] = 12, *, mechanism: str | None = None
) -> Construction:
    """Construct a piston's positions as a source does.

    Parameters
    ----------
    machine : Machine
    method : "arc", "projection", "brix" or "brix_backward"
    angles : int or sequence of float
        How many crank angles, evenly over a turn, or which, from where the crank or the eccentric points along the line
        of stroke [deg].
        Backwards an int is into how many parts the stroke is divided, and angles stand for their exact displacements.
    mechanism : str, optional
        A slider-crank's or an eccentric's name; the first slider-crank unless given, or else the first eccentric.

    Returns
    -------
    Construction

    Raises
    ------
    InputError
        If the mechanism is neither, or cannot be at such an angle.

    Notes
    -----
    Arc: a circle of the rod's length about the piston's pin leads the crank pin to the line of stroke; exact, with an
    offset too. Projection: (334). Brix: a ray from the pole, λR/2 behind the shaft. docs/theory/textbook-forms.

    Examples
    --------
    >>> pump = Machine(mechanism={"kind": "slider_crank", "stroke": "160 mm", "rod_length": "320 mm"})
    >>> found = construction(pump, "brix", [90.0])
    >>> [round(1e3 * float(value[0]), 3) for value in (found.displacement, found.exact_displacement)]
    [90.0, 90.161]
    """
    place = plain_crank_called(machine, mechanism)
    geometry = plain_crank(place.geometry)
    phi = np.deg2rad(plan_angles(angles))
    if method == "brix_backward":
        made = _backward(geometry, angles if isinstance(angles, int) else phi)
    else:
        made = _FORWARD[method](geometry, phi)
    if not np.all(np.isfinite(made.exact_displacement + made.exact_angle)):
        raise InputError([Problem("", place.name, _("the links cannot close at every angle that is to be drawn"))])
    ratio = geometry.crank_radius / geometry.rod_length
    return Construction(
        **vars(made),
        mechanism=place.name,
        method=method,
        is_of_eccentric=place.kind.has_own_pin,
        geometry=geometry,
        pole=-float(largest_difference(geometry.crank_radius, ratio)),
        limits=next((one for one in RANGES if one.method == _RANGES.get(method)), None),
        sense=frame(machine, place).sense,
    )


def exact_crank_angle(displacement: Array, geometry: SliderCrank) -> Array:
    """Crank angle at which the piston is so far from its top, on the way to the shaft.

    Parameters
    ----------
    displacement : Array
        From the true top. [m]
    geometry : SliderCrank, broadcastable with displacement

    Returns
    -------
    Array, of the broadcast shape
        From where the crank points along the cylinder [rad]; NaN outside the stroke.

    Notes
    -----
    The half angle in the triangle of shaft, crank pin and piston pin, from by how much each two of its sides are longer
    than the third: near the dead centres, and of a rod however long, no cosine has to be told from ±1.
    """
    radius, rod, offset = geometry
    end = _end(geometry)
    along = end - displacement
    side = np.hypot(along, offset)  # from the shaft to the piston pin
    around = rod + radius + side
    above = (
        displacement * (2 * end - displacement) / around
    )  # rod and crank together beyond it: (rod + radius)² − side²
    below = 2 * radius - above
    rounding = 8 * np.finfo(float).eps * around
    above, below = (np.where((gap < 0) & (gap > -rounding), 0.0, gap) for gap in (above, below))
    with np.errstate(invalid="ignore"):  # NaN outside the stroke, as said
        half = np.arctan2(np.sqrt((side + rod - radius) * above), np.sqrt(around * below))
    return np.arctan2(offset, along) + 2 * half


def _end(geometry: SliderCrank, side: float = 1.0) -> float:
    """Farthest place of the piston's pin along the line of stroke, or the nearest one, where side is −1. [m]"""
    reach = geometry.rod_length + side * geometry.crank_radius
    return float(np.sqrt(reach**2 - geometry.offset**2))


def _stroke(geometry: SliderCrank) -> float:
    """Distance of the two ends: that of their squares, 4 R L, over their sum. [m]"""
    return float(4 * geometry.crank_radius * geometry.rod_length / (_end(geometry) + _end(geometry, -1.0)))


def _on_line(along: Array, geometry: SliderCrank) -> Array:
    """Points of the line of stroke, shape (2, n)."""
    return np.stack([along, np.full_like(along, geometry.offset)])


def _on_circle(angle: Array, geometry: SliderCrank) -> Array:
    return geometry.crank_radius * np.stack([np.cos(angle), np.sin(angle)])


def _exact(phi: Array, geometry: SliderCrank) -> Array:
    """Place of the piston's pin along x. [m]"""
    with np.errstate(all="ignore"):  # what cannot close is NaN, and refused
        return slider_crank(phi, geometry).slider.value


def _arc(geometry: SliderCrank, phi: Array) -> Readings:
    """The arc about the piston's pin through the crank pin meets the line of stroke nearer to the shaft."""
    on_circle, piston = _on_circle(phi, geometry), _on_line(_exact(phi, geometry), geometry)
    foot = piston[0] - np.hypot(*(on_circle - piston))
    start = _end(geometry) - geometry.rod_length
    return Readings(
        angle=phi,
        exact_angle=phi,
        displacement=start - foot,
        exact_displacement=_end(geometry) - piston[0],
        on_circle=on_circle,
        foot=_on_line(foot, geometry),
        piston=piston,
    )


def _read_on_diameter(geometry: SliderCrank, phi: Array, on_circle: Array, displacement: Array) -> Readings:
    """Readings from the end of the crank circle's diameter."""
    piston = _exact(phi, geometry)
    return Readings(
        angle=phi,
        exact_angle=phi,
        displacement=displacement,
        exact_displacement=_end(geometry) - piston,
        on_circle=on_circle,
        foot=np.stack([geometry.crank_radius - displacement, np.zeros_like(phi)]),
        piston=_on_line(piston, geometry),
    )


def _projection(geometry: SliderCrank, phi: Array) -> Readings:
    displacement = infinite_rod(phi, geometry.crank_radius).value
    return _read_on_diameter(geometry, phi, _on_circle(phi, geometry), displacement)


def _brix(geometry: SliderCrank, phi: Array) -> Readings:
    ratio = geometry.crank_radius / geometry.rod_length
    about_centre = phi + np.arcsin(ratio / 2 * np.sin(phi))
    displacement = brix(phi, geometry.crank_radius, ratio).value
    return _read_on_diameter(geometry, phi, _on_circle(about_centre, geometry), displacement)


def _backward(geometry: SliderCrank, chosen: int | Array) -> Readings:
    """From displacements: equal parts of the stroke, or those of crank angles, to angles on the way to the shaft."""
    whole = _stroke(geometry)
    if isinstance(chosen, int):
        displacement = whole * np.arange(chosen + 1) / chosen
        exact = exact_crank_angle(displacement, geometry)
    else:
        exact = np.arccos(np.cos(chosen))
        displacement = _end(geometry) - _exact(exact, geometry)
    read = np.minimum(displacement, 2 * geometry.crank_radius)  # an offset stroke is longer than the diameter
    angle = brix_angle(read, geometry.crank_radius, geometry.crank_radius / geometry.rod_length)
    along = geometry.crank_radius - read
    height = np.sqrt(np.maximum(geometry.crank_radius**2 - along**2, 0.0))
    return Readings(
        angle=angle,
        exact_angle=exact,
        displacement=displacement,
        exact_displacement=displacement,
        on_circle=np.stack([along, height]),
        foot=np.stack([along, np.zeros_like(along)]),
        piston=_on_line(_end(geometry) - displacement, geometry),
    )


_FORWARD: Mapping[str, Callable[[SliderCrank, Array], Readings]] = {
    "arc": _arc,
    "projection": _projection,
    "brix": _brix,
}
