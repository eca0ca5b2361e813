"""Gears that hand torque on from shaft to shaft, and what their teeth do to the shafts."""

from collections.abc import Iterator, Mapping
from typing import ClassVar, NamedTuple

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.specs import ShaftSpec
from cranktrain.layout.standing import shaft_centres
from cranktrain.motion import Array
from cranktrain.quantities import one_of
from cranktrain.questions.crankshaft.spec import GearSpec
from cranktrain.record import record


class Mesh(NamedTuple):
    """A gear on one shaft.

    Attributes
    ----------
    shaft : int
    drives : bool
        Whether the shaft hands its torque on here; otherwise it is driven.
    z : Array, shape (design,)
        [m]
    toward : Array, shape (design, 2)
        Direction from the shaft's centre to where the teeth mesh, in the machine's axes X, Y.
    """

    shaft: int
    drives: bool
    z: Array
    toward: Array


@record
class Gear:
    """A gear that hands torque on: its meshes, one or two; arrays of shape (design,).

    radius: of the pitch circle [m]; pressure, helix: angles of the teeth [rad].
    """

    name: str
    meshes: tuple[Mesh, ...]
    radius: Array
    pressure: Array
    helix: Array

    def onward(self) -> int | None:
        """To which shaft the torque goes; None where it leaves the machine."""
        return self.meshes[1].shaft if len(self.meshes) > 1 else None


class ToothLoad(NamedTuple):
    """What a gear's teeth do to a shaft: force [N] and first moment [N·m] toward X, Y, torque [N·m], thrust [N].

    Shapes (design, 2, n), and (design, n).
    """

    force: Array
    couple: Array
    torque: Array
    thrust: Array


@record
class DeclaredGears:
    """The gears of the file, each after all those that hand torque to its shaft."""

    needs: ClassVar[str] = N_("[gear.NAME]")

    each: tuple[Gear, ...]

    def handed_on(self, own: Array) -> list[Array]:
        """Torque that goes through each gear, from what every shaft has of its own, shape (design, shaft, n). [N·m]"""
        gathered = own.copy()
        found: list[Array] = []
        for gear in self.each:
            torque = gathered[:, gear.meshes[0].shaft].copy()
            found.append(torque)
            onward = gear.onward()
            if onward is not None:
                gathered[:, onward] += torque
        return found


def tooth_load(gear: Gear, mesh: Mesh, torque: Array, turn: float) -> ToothLoad:
    """What the teeth of a gear do to one shaft.

    Parameters
    ----------
    gear : Gear
    mesh : Mesh
    torque : Array, shape (design, n)
        That goes through, in the sense in which the shaft runs: it slows the driving shaft, and drives the other. [N·m]
    turn : float
        1 where the shaft runs from X toward Y, −1 where it runs clockwise.

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.49) and (24.50).
    """
    sign = -1.0 if mesh.drives else 1.0
    radius, tangent = gear.radius[:, np.newaxis], torque / gear.radius[:, np.newaxis]
    apart = np.abs(tangent) * (np.tan(gear.pressure) / np.cos(gear.helix))[:, np.newaxis]
    toward = mesh.toward[..., np.newaxis]
    ahead = turn * np.stack([-toward[:, 1], toward[:, 0]], axis=1)
    thrust = -sign * tangent * np.tan(gear.helix)[:, np.newaxis]
    return ToothLoad(
        force=sign * tangent[:, np.newaxis] * ahead - apart[:, np.newaxis] * toward,
        couple=-(thrust * radius)[:, np.newaxis] * toward,
        torque=sign * turn * torque,
        thrust=thrust,
    )


def declared_gears(designs: Designs) -> DeclaredGears | None:
    """Put the gears of all designs to the shafts; None where there is none."""
    tables: Mapping[str, GearSpec] = designs.together.tables.get("gear", {})
    if not tables:
        return None
    names = list(designs.together.shafts)
    sense = 1.0 if designs.together.orientation.is_clockwise else -1.0
    each: list[Gear] = []
    for name in _in_order(tables):
        spec = tables[name]
        radius, pressure, helix = designs.by_design(
            [spec.radius.array, spec.pressure_angle.array, spec.helix_angle.array]
        ).T
        meshes = tuple(
            Mesh(
                names.index(shaft),
                number == 0,
                designs.by_design([spec.z[min(number, len(spec.z) - 1)].array])[:, 0],
                _toward(designs, spec, number, sense),
            )
            for number, shaft in enumerate(spec.shafts)
        )
        each.append(Gear(name, meshes, radius, pressure, helix))
    return DeclaredGears(tuple(each))


def _toward(designs: Designs, spec: GearSpec, number: int, sense: float) -> Array:
    """Direction from a shaft's centre to where its gear meshes, shape (design, 2)."""
    if spec.direction is not None:
        angle = designs.by_design([spec.direction[min(number, len(spec.direction) - 1)].array])[:, 0]
        return np.stack([np.sin(sense * angle), np.cos(angle)], axis=-1)
    centres = shaft_centres(designs.together.shafts)
    one, other = centres[spec.shafts[number]], centres[spec.shafts[1 - number]]
    apart = designs.by_design([other[0] - one[0], other[1] - one[1]])
    return apart / np.hypot(apart[:, :1], apart[:, 1:])


def _in_order(tables: Mapping[str, GearSpec]) -> list[str]:
    """Names of gears, each after all those that hand torque to its first shaft."""
    rest, found = dict(tables), list[str]()
    while rest:
        fed = {spec.shafts[1] for spec in rest.values() if len(spec.shafts) > 1}
        ready = [name for name, spec in rest.items() if spec.shafts[0] not in fed]
        found += ready
        rest = {name: spec for name, spec in rest.items() if name not in ready}
        assert ready
    return found


def gear_problems(tables: Mapping[str, GearSpec], design: Design) -> Iterator[Problem]:
    """Find gears on shafts that there are not, of no direction, and torque that goes two ways or round."""
    first: dict[str, str] = {}
    for name, spec in tables.items():
        where = f"gear.{name}"
        unknown = [shaft for shaft in spec.shafts if shaft not in design.shafts]
        yield from (Problem(f"{where}.shafts", shaft, one_of(design.shafts)) for shaft in unknown)
        if unknown:
            continue
        if spec.shafts[0] in first:
            allowed = _("must not hand on the torque of {shaft}, as [gear.{other}] does")
            said = allowed.format(shaft=spec.shafts[0], other=first[spec.shafts[0]])
            yield Problem(f"{where}.shafts", ", ".join(spec.shafts), said)
        first.setdefault(spec.shafts[0], name)
        if spec.direction is None:
            yield from _centres(where, spec, design.shafts)
    yield from _round(tables, first)


def _centres(where: str, spec: GearSpec, shafts: Mapping[str, ShaftSpec]) -> Iterator[Problem]:
    """Find a direction that no line of centres gives."""
    unplaced = [name for name in spec.shafts if name not in shaft_centres(shafts)]
    if unplaced:
        allowed = _("is missing; only with [shaft.{name}] place is it on the line of both centres")
        yield Problem(f"{where}.direction", None, allowed.format(name=unplaced[0]))
    elif shafts[spec.shafts[0]].ratio == shafts[spec.shafts[1]].ratio:
        allowed = _("is missing: both shafts turn alike, so that there are gears between them; give one for each shaft")
        yield Problem(f"{where}.direction", None, allowed)


def _round(tables: Mapping[str, GearSpec], first: Mapping[str, str]) -> Iterator[Problem]:
    """Find torque that goes round in a ring."""
    for name, spec in tables.items():
        seen, at = [spec.shafts[0]], spec
        while len(at.shafts) > 1 and at.shafts[1] in first:
            if at.shafts[1] == seen[0]:
                yield Problem(f"gear.{name}.shafts", ", ".join(spec.shafts), _("must not hand torque on in a ring"))
                return
            if at.shafts[1] in seen:
                break
            seen.append(at.shafts[1])
            at = tables[first[at.shafts[1]]]
