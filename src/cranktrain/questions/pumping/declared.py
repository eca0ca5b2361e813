"""The pumping unit that machines declare: which of their loads are the well's and the counterbalance's."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.crank_bodies import CRANK
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.load_tables import LoadSpec
from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Array
from cranktrain.questions.pumping.spec import PumpingSpec
from cranktrain.record import record

_ONE_RADIUS = 1e-6
"""By how much two radii may differ that are one, in parts of it."""


@record
class DeclaredPumping:
    """A pumping unit.

    Attributes
    ----------
    card, counterbalance : str
        Names of the loads; no name of a counterbalance that there is not.
    rated_torque, rated_load : Array, shape (design,)
        NaN where none is given. [N·m, N]
    moment : Array, shape (design,)
        Largest moment of the counterbalance, its force times its arm; NaN without one. [N·m]
    phase : Array, shape (design,)
        How far the weights are ahead of the line from shaft to crank pin. [rad]
    sense : float
        −1 of a crank that runs against the machine.
    has_masses : bool
        Whether anything but the crank weighs something.
    """

    needs: ClassVar[str] = N_("[pumping]")
    reads: ClassVar[tuple[str, ...]] = ("[load.NAME]",)

    card: str
    counterbalance: str
    rated_torque: Array
    rated_load: Array
    moment: Array
    phase: Array
    sense: float
    has_masses: bool


def declared_pumping(designs: Designs) -> DeclaredPumping | None:
    """Collect what [pumping] says; None where there is no such table."""
    spec = designs.together.table(PumpingSpec)
    if spec is None:
        return None

    def each(number: Array | float) -> Array:
        return designs.by_design([number])[:, 0]

    loads = _loads(designs.together)
    weights = None if spec.counterbalance is None else loads[spec.counterbalance]
    moment, phase = np.full((2, designs.n_designs), np.nan)
    if weights is not None and weights.force is not None:
        along = each(0.0 if weights.along is None else weights.along.array)
        across = each(0.0 if weights.across is None else weights.across.array)
        force = each(weights.force[0].array)
        moment = np.hypot(along, across) * np.abs(force)
        phase = np.arctan2(across * np.sign(force), along * np.sign(force))
    return DeclaredPumping(
        card=spec.card,
        counterbalance=spec.counterbalance or "",
        rated_torque=each(np.nan if spec.rated_torque is None else spec.rated_torque.array),
        rated_load=each(np.nan if spec.rated_load is None else spec.rated_load.array),
        moment=moment,
        phase=phase,
        sense=float(designs.places[0].sense),
        has_masses=any(part != CRANK for bodies in designs.together.weighed.bodies.values() for part in bodies),
    )


def _loads(design: Design) -> dict[str, LoadSpec]:
    """Loads of a machine of one mechanism by name."""
    return {name: spec for named in design.loads.values() for name, spec in named.items()}


def pumping_problems(design: Design) -> Iterator[Problem]:
    """Find machines that are no pumping unit, and names of loads that are not there or not of the kind."""
    spec = design.table(PumpingSpec)
    if spec is None:
        return
    if len(design.places) != 1 or design.places[0].kind.output.is_slider:
        yield Problem("pumping", None, _("is for a machine of one mechanism with a rocker, a crank_rocker"))
        return
    loads = _loads(design)
    names = [("card", spec.card), *([("counterbalance", spec.counterbalance)] if spec.counterbalance else [])]
    missing = [(key, name) for key, name in names if name not in loads]
    known = ", ".join(loads) or _("none")
    for key, name in missing:
        allowed = _("must be the name of a load, [load.NAME]; there are: {known}", known=known)
        yield Problem(f"pumping.{key}", name, allowed)
    if missing:
        return
    if spec.counterbalance == spec.card:
        yield Problem("pumping.counterbalance", spec.card, _("must not be the load that is the well's"))
        return
    if not _is_rope(loads[spec.card]):
        allowed = _("must be a force on the rocker with radius and direction: a rope off its arc, sense = active")
        yield Problem("pumping.card", spec.card, allowed)
    else:
        yield from _radius_problems(design.places[0], spec.card, loads[spec.card])
    ropes = [
        name
        for name, load in loads.items()
        if name not in (spec.card, spec.counterbalance) and _is_rope(load) and load.over is not None
    ]
    for name in ropes:
        allowed = _("pulls a second rope by a card of its own, {name}; the rod must be the only one")
        yield Problem("pumping.card", spec.card, allowed.format(name=name))
    if spec.counterbalance and not _is_weight(loads[spec.counterbalance]):
        allowed = _("must be one constant force on the crank at along, across, with a direction, sense = active")
        yield Problem("pumping.counterbalance", spec.counterbalance, allowed)


def _radius_problems(place: PlacedMechanism, name: str, card: LoadSpec) -> Iterator[Problem]:
    """Find a rod that hangs off another arc than the load of the mechanism."""
    radius = getattr(place.spec, "load_radius", None)
    if radius is None or card.radius is None:
        return
    if np.any(np.abs(np.abs(card.radius.array) - radius.array) > _ONE_RADIUS * radius.array):
        allowed = _("hangs off an arc of {own}, and load_radius = {other}: the rod has one arc, give it twice alike")
        said = allowed.format(own=card.radius.text, other=radius.text)
        yield Problem("pumping.card", name, said)


def _is_rope(load: LoadSpec) -> bool:
    """Whether a load is a rope off an arc on the rocker."""
    is_force = load.listed.force is not None or load.file is not None
    is_off_arc = load.radius is not None and load.direction is not None
    return load.on == "rocker" and is_force and is_off_arc and load.sense == "active"


def _is_weight(load: LoadSpec) -> bool:
    """Whether a load is a weight on the crank."""
    is_constant = load.over is None and load.file is None and load.at_speed is None and load.force is not None
    return load.on == "crank" and is_constant and load.direction is not None and load.sense == "active"
