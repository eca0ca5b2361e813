"""Rod loads as the file declares them: limits and masses of every piston, and what is wrong with them."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.part_tables import SLIDER, nearest_item
from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Array
from cranktrain.paths import path_text
from cranktrain.quantities import Given
from cranktrain.questions.rod_load.spec import RodSpec, RodTable
from cranktrain.record import record

LIMITS = ("gas_compression", "gas_tension", "compression", "tension")
"""Keys of the frame's limits, in the order in which results have them."""


@record
class DeclaredRodLoads:
    """What the file says of rod loads.

    Attributes
    ----------
    limits : Array, shape (design, limit, piston)
        In the order of `LIMITS`; NaN for none. [N]
    crosshead : Array, shape (design, piston)
        Mass of the crosshead; NaN where it is not told apart. [kg]
    least_arc, least_share : Array, shape (design,)
        What counts as a reversal. [rad, 1]
    is_asked : bool
        Whether the file has the table.
    """

    needs: ClassVar[str] = N_("[rod_load]")

    limits: Array
    crosshead: Array
    least_arc: Array
    least_share: Array
    is_asked: bool


def declared_rod_loads(designs: Designs, *, has_gas: bool) -> DeclaredRodLoads | None:
    """Take the numbers of all designs; with gas alone, and no such table, those that hold unless given."""
    given = designs.together.table(RodSpec)
    if designs.pistons is None or (given is None and not has_gas):
        return None
    spec = given or RodSpec()
    pistons = designs.together.pistons
    # Most pistons have no table of their own: what the common one says is looked up once.
    tables = [tuple(name for name in (place.bank, place.name) if name in spec.overrides) for place in pistons]
    different = dict(zip(tables, pistons, strict=True))

    def each(key: str) -> Array:
        found = {own: nearest(spec, place, key)[1] for own, place in different.items()}
        numbers = {own: np.nan if one is None else one.array for own, one in found.items()}
        return designs.by_design([numbers[own] for own in tables])

    arc, share = designs.by_design([spec.least_arc.array, spec.least_share.array]).T
    return DeclaredRodLoads(
        np.stack([each(key) for key in LIMITS], axis=1), each("crosshead"), arc, share, given is not None
    )


def nearest(spec: RodSpec, place: PlacedMechanism, key: str) -> tuple[str, Given | None]:
    """Give what the nearest table says of a piston: its own, its bank's, the common one; and where that stands."""
    tables: list[tuple[str, RodTable]] = [("rod_load", spec)]
    tables += [
        (path_text(("rod_load", name)), spec.overrides[name])
        for name in (place.bank, place.name)
        if name in spec.overrides
    ]
    found = [(f"{path}.{key}", own) for path, table in tables if (own := getattr(table, key)) is not None]
    return found[-1] if found else (f"rod_load.{key}", None)


def rod_load_problems(design: Design) -> Iterator[Problem]:
    """Find tables of nothing, machines without piston rods, and crossheads heavier than what they are part of."""
    spec = design.table(RodSpec)
    if spec is None:
        return
    pistons = [place for place in design.pistons if place.kind.output.has_chambers and place.kind.has_rod]
    if not pistons:
        yield Problem("rod_load", None, _("is not for this machine, which has no pistons on rods"))
        return
    known = list(dict.fromkeys(name for place in pistons for name in (place.bank, place.name) if name))
    for name in spec.overrides:
        if name not in known:
            allowed = _("is neither a key of [rod_load] nor a bank or cylinder of this machine: {known}")
            yield Problem(path_text(("rod_load", name)), None, allowed.format(known=", ".join(known)))
    yield from dict.fromkeys(problem for place in pistons for problem in _too_heavy(design, spec, place))


def _too_heavy(design: Design, spec: RodSpec, place: PlacedMechanism) -> Iterator[Problem]:
    """Find a crosshead of a piston that has more mass than the piston with it."""
    path, crosshead = nearest(spec, place, "crosshead")
    if crosshead is None:
        return
    piston = nearest_item(place, SLIDER, "masses", design.weighed.bodies)
    if piston is None or piston.mass is None:
        yield Problem(
            path, crosshead.text, _("is part of what the piston weighs, [masses.piston] mass, which is missing")
        )
    elif crosshead.si > piston.mass.si:
        allowed = _("must be no more than what the piston weighs with rod and crosshead, {whole}")
        yield Problem(path, crosshead.text, allowed.format(whole=piston.mass.text))
