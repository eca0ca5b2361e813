"""The table [crankshaft], put to the throws of the main shaft."""

from collections.abc import Iterator
from itertools import pairwise
from typing import ClassVar

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.axial import throw_positions
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.specs import MAIN
from cranktrain.motion import ZERO, Array
from cranktrain.questions.crankshaft.sections import Material
from cranktrain.questions.crankshaft.spec import CrankshaftSpec
from cranktrain.questions.crankshaft.throw_line import WEB_RULES, WebRule
from cranktrain.record import record


@record
class DeclaredCrankshaft:
    """The crankshaft of the file, arrays of shape (design,) in SI where nothing else is said.

    Attributes
    ----------
    centres : Array, shape (design, throw)
        z of the throws from the first. [m]
    bearings : Array, shape (design, throw + 1)
        z of the main bearings. [m]
    journal, pin : Array, shape (design, 2)
        Diameter and bore. [m]
    pin_length, web_thickness, web_width : Array
        [m]
    rule : WebRule
    compliance : Array
        Of a main bearing, 0 where it is rigid. [m/N]
    clearance : Array
        Radial. [m]
    material : Material
    is_elastic, has_clearance : bool
        Whether the file says so of the bearings.
    """

    needs: ClassVar[str] = N_("[crankshaft]")

    centres: Array
    bearings: Array
    journal: Array
    pin: Array
    pin_length: Array
    web_thickness: Array
    web_width: Array
    rule: WebRule
    compliance: Array
    clearance: Array
    material: Material
    is_elastic: bool
    has_clearance: bool


def declared_crankshaft(designs: Designs) -> DeclaredCrankshaft | None:
    """Put the table to the throws; None where there is none, or nothing says where the throws stand."""
    spec = designs.together.table(CrankshaftSpec)
    centres = throw_positions(designs.together.shafts[MAIN])
    if spec is None or centres is None:
        return None
    beyond = _beyond(spec, centres)
    middles = [(one + other) / 2 for one, other in pairwise(centres)]

    def each(number: Array) -> Array:
        return designs.by_design([number])[:, 0]

    young = spec.young_modulus.array
    stiffness, clearance = spec.bearing_stiffness, spec.bearing_clearance
    return DeclaredCrankshaft(
        centres=designs.by_design(centres),
        bearings=designs.by_design([centres[0] - beyond, *middles, centres[-1] + beyond]),
        journal=designs.by_design([spec.journal_diameter.array, spec.journal_bore.array]),
        pin=designs.by_design([spec.pin_diameter.array, spec.pin_bore.array]),
        pin_length=each(spec.pin_length.array),
        web_thickness=each(spec.web_thickness.array),
        web_width=each(spec.web_width.array),
        rule=next(rule for rule in WEB_RULES if rule.name == spec.web_length),
        compliance=each(ZERO if stiffness is None else 1 / stiffness.array),
        clearance=each(ZERO if clearance is None else clearance.array / 2),
        material=Material(each(young), each(young / (2 * (1 + spec.poisson_ratio.array)))),
        is_elastic=stiffness is not None,
        has_clearance=clearance is not None,
    )


def _beyond(spec: CrankshaftSpec, centres: list[Array]) -> Array:
    """From the end throws to the bearings beyond them. [m]"""
    if spec.bearing_distance is not None:
        return spec.bearing_distance.array
    return (centres[1] - centres[0]) / 2 if len(centres) > 1 else ZERO


def crankshaft_problems(spec: CrankshaftSpec, design: Design) -> Iterator[Problem]:
    """Find throws that leave no room for a journal, and a single one whose bearings are nowhere."""
    centres = throw_positions(design.shafts[MAIN])
    if centres is None:
        return
    if len(centres) == 1 and spec.bearing_distance is None:
        yield Problem("crankshaft.bearing_distance", None, _("is missing: one throw alone does not say it"))
        return
    throw = spec.pin_length.si + 2 * spec.web_thickness.si
    gaps = [float(other - one) for one, other in pairwise(centres)]
    least = min([2 * float(_beyond(spec, centres)), *gaps])
    if throw >= least:
        allowed = _("must leave room for a journal: with two webs {throw:.4g} mm, and there are {least:.4g} mm")
        said = allowed.format(throw=1e3 * throw, least=1e3 * least)
        yield Problem("crankshaft.pin_length", spec.pin_length.text, said)
