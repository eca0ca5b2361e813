"""What is asked of a crank-rocker alone: its Grashof class and its transmission angle."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import N_, Listed, _
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, crank_rocker
from cranktrain.mechanisms.kind import Members
from cranktrain.motion import Array
from cranktrain.numerics import extremes
from cranktrain.numerics.ties import first_smallest_along
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANK_ROCKERS as _THEORY
from cranktrain.saying.amounts import Amount
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Check, Checked
from cranktrain.saying.rows import AnswerLine, Telling, worded

_LINKAGE = ("crank_rocker",)

CLASSES = (
    N_("crank-rocker: the crank turns, the rocker swings"),
    N_("double crank: crank and rocker both turn"),
    N_("double rocker: only the rod can turn against the others"),
    N_("rocker-crank: the driven link can turn, the crank only swings"),
    N_("change point: the links come to lie in one line"),
    N_("non-Grashof: no link can turn"),
)
"""Classes of the four-bar linkage by which link is shortest; `grashof_class` counts them from 0."""
_CHANGE_POINT = 4


@record
class CrankRockers(Members[CrankRocker]):
    """The crank-rockers of a machine."""


@record
class Transmission(Checked):
    """Class of the linkage and extremes of the angle between rod and rocker."""

    grashof_class: Array = quantity(
        "",
        "1",
        _LINKAGE,
        N_("Grashof class: 0 crank-rocker, 1 double crank, 2 double rocker, 3 rocker-crank, 4 change point, 5 none"),
        _THEORY,
        "3.4",
    )
    smallest_transmission_angle: Array = quantity(
        "μ_min", "rad", _LINKAGE, N_("Smallest angle between rod and rocker"), _THEORY, "3.8", worst="smallest"
    )
    largest_transmission_angle: Array = quantity(
        "μ_max", "rad", _LINKAGE, N_("Largest angle between rod and rocker"), _THEORY, "3.8", worst="largest"
    )


def transmission(linkages: CrankRockers) -> Transmission:
    """Grashof class and extremes of the transmission angle, refined on the kernel."""
    geometry = linkages.geometry

    def angle(phi: Array) -> Array:
        motion = crank_rocker(phi, geometry)
        cross = motion.rod.cos * motion.rocker.sin - motion.rod.sin * motion.rocker.cos
        return np.arctan2(np.abs(cross), motion.rod.cos * motion.rocker.cos + motion.rod.sin * motion.rocker.sin)

    kind = grashof_class(geometry)
    with np.errstate(invalid="ignore"):
        least, most = extremes(angle)
    # Where links come through change points they lie in line, one way and the other; there the kernel's side ends.
    in_line = kind == _CHANGE_POINT
    least, most = (end._replace(value=np.where(in_line, of, end.value)) for end, of in ((least, 0.0), (most, np.pi)))
    return Transmission(
        grashof_class=kind[..., 0],
        smallest_transmission_angle=least.value[..., 0],
        largest_transmission_angle=most.value[..., 0],
        checks=(_cosine_rule_check(geometry, least.value, most.value),),
    )


def transmission_rows(of: Telling, found: Transmission) -> Iterator[AnswerLine]:
    """Say the least transmission angle, and the class where it is none with a crank and a rocker."""
    most = of.values(found, "largest_transmission_angle")
    largest = Amount(float(np.fmax.reduce(most)), "rad", "largest_transmission_angle")
    words = _("{values} at least, {most} at most", most=largest)
    yield of.row(_("transmission angle"), found, "smallest_transmission_angle", words)
    kinds = sorted({int(value) for value in of.values(found, "grashof_class")} - {0})
    if kinds:
        yield worded(_("linkage"), Listed([_(CLASSES[kind]) for kind in kinds], "; "))


def grashof_class(geometry: CrankRocker) -> Array:
    """Class of each linkage, as an index of `CLASSES`, by its shortest link."""
    links = np.stack(
        np.broadcast_arrays(geometry.crank_radius, geometry.ground_length, geometry.rod_length, geometry.rocker_length)
    )
    shortest = first_smallest_along(np.moveaxis(links, 0, -1))
    slack = np.sum(links, axis=0) - 2 * (np.min(links, axis=0) + np.max(links, axis=0))
    rounding = 4 * np.finfo(float).eps * np.max(links, axis=0)
    return np.where(slack > rounding, shortest, np.where(slack < -rounding, 5, 4)).astype(float)


def _cosine_rule_check(geometry: CrankRocker, least: Array, most: Array) -> Check:
    """Compare the extremes with the cosine rule where the crank lies along the ground line."""
    crank, rod, rocker, ground = geometry[:4]
    cosines = [(rod**2 + rocker**2 - (ground + sign * crank) ** 2) / (2 * rod * rocker) for sign in (-1, 1)]
    residual = np.maximum(np.abs(np.cos(least) - cosines[0]), np.abs(np.cos(most) - cosines[1]))
    # The squares of long links beside short ones take digits from their difference.
    scale = (rod**2 + rocker**2 + (ground + crank) ** 2) / (2 * rod * rocker)
    return Check(
        "transmission_angle",
        _(
            "cosines of the transmission angle's extremes against the cosine rule with the crank along the ground line,"
            " relative to the rule's terms"
        ),
        np.max(residual / scale, axis=(1, 2)),
        1e-12,
    )
