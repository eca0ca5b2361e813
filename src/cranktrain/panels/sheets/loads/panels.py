"""Curves of the loads: sizes, what they do to the crank, power; over the crank angle, and sizes over the travel.

At an angle where a load may jump a curve has two points, of before and after, so that a jump is a line straight up.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.language import _
from cranktrain.layout.load_laws import ByAngle, ByTravel
from cranktrain.layout.loads import LinkLoad
from cranktrain.layout.shaft_loads import TorqueOnShaft
from cranktrain.motion import Array
from cranktrain.panels.design import OneDesign, closed
from cranktrain.panels.plotted import role_at
from cranktrain.panels.shapes import Curve, Panel, peak
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.loads.load_work import LoadWork
from cranktrain.saying.amounts import UnitLabel

_ASIDE = 1e-6
"""How far before and after an angle at which loads may jump they are looked at. [deg]"""


class CurveOfLoad(NamedTuple):
    """A load over the cycle at the angles of `CurvesOfLoads`, arrays of shape (n,).

    Attributes
    ----------
    name : str
    load : LinkLoad or None
        None of one that is not on a link.
    size : Array
        Along its way, or of a torque in the sense of rotation. [N or N·m]
    travel : Array
        Of its point or link from where it is least; NaN of one that does not go by it. [m or rad]
    on_crank : Array
        Its torque there. [N·m]
    power : Array
        [W]
    """

    name: str
    load: LinkLoad | None
    size: Array
    travel: Array
    on_crank: Array
    power: Array

    @property
    def is_torque(self) -> bool:
        """Whether it is a torque."""
        return self.load is None or self.load.is_torque


class CurvesOfLoads(NamedTuple):
    """Loads over the cycle, and the crank angles as they are shown, from 0 to its end, shape (n,). [deg]"""

    angle: Array
    each: tuple[CurveOfLoad, ...]


def load_curves(shown: OneDesign) -> CurvesOfLoads:
    """Loads of one design at the angles of the grid, and twice at those where one may jump."""
    loaded, cycle = shown.result[LoadedMachine], float(shown.cycle[-1])
    zero = float(np.broadcast_to(shown.result.machines[shown.design].zero, (1,))[0])
    shafts = {load.name: load for load in shown.result[LoadWork].on_shafts}
    kinks = [
        _of_design(load.law.kinks(np.deg2rad(cycle)), shown.design)
        for load in shafts.values()
        if isinstance(load.law, ByAngle)
    ]
    whole = _of_design(shown.result[ForceEvents].whole, shown.design) - zero
    events = np.rad2deg(np.concatenate([whole, *kinks])) % cycle
    at, angle = _angles(shown.cycle, np.unique(np.round(events[np.isfinite(events)], 9)))
    phi = (np.deg2rad(at) + zero)[np.newaxis, np.newaxis]
    links = {load.name: load for load in (() if loaded.loads is None else loaded.loads.each)}
    each = tuple(
        _on_link(loaded, links[name], phi, shown.design)
        if name in links
        else _on_shaft(loaded, shafts[name], phi, (zero, shown.design))
        for name in shown.result.labels["load"]
    )
    return CurvesOfLoads(angle, each)


def _angles(grid: Array, events: Array) -> tuple[Array, Array]:
    """Angles at which to look, and where these are drawn: an event's both sides at the event. [deg]"""
    cycle = float(grid[-1])
    near = np.min(np.abs(grid[:, np.newaxis] - events), axis=1, initial=np.inf) < 10 * _ASIDE
    kept = grid[~near]
    inner = events[(events > 10 * _ASIDE) & (events < cycle - 10 * _ASIDE)]
    ends = np.array([0.0, cycle]) if near[0] or near[-1] else np.empty(0)
    aside = np.array([_ASIDE, cycle - _ASIDE]) if ends.size else ends
    at = np.concatenate(
        [kept[(kept > 0.0) & (kept < cycle)] if ends.size else kept, inner - _ASIDE, inner + _ASIDE, aside]
    )
    drawn = np.concatenate([kept[(kept > 0.0) & (kept < cycle)] if ends.size else kept, inner, inner, ends])
    order = np.argsort(at)
    return at[order], drawn[order]


def _on_link(loaded: LoadedMachine, load: LinkLoad, phi: Array, design: int) -> CurveOfLoad:
    """One load on a link at φ, shape (1, 1, n). [rad]"""
    way = loaded.load_way(load, phi)
    speed = loaded.speed.drive(phi).speed
    size = loaded.load_value(load, way, phi, speed)
    travel = np.nan
    if isinstance(load.law, ByTravel):
        travel = load.counts * way.place - loaded.travel_starts[load.name]
    parts = (size, travel, size * way.rate, size * way.rate * speed)
    return CurveOfLoad(load.name, load, *(_of_curve(part, design, phi.size) for part in parts))


def _on_shaft(loaded: LoadedMachine, load: TorqueOnShaft, phi: Array, of: tuple[float, int]) -> CurveOfLoad:
    """One load on a shaft at φ, shape (1, 1, n) [rad]; of: φ where the shown angle is 0, and which design."""
    zero, design = of
    speed = loaded.speed.drive(phi).speed
    torque = load.value(phi - zero, speed)
    parts = (torque, np.nan, torque, torque * speed)
    return CurveOfLoad(load.name, None, *(_of_curve(part, design, phi.size) for part in parts))


def _of_curve(values: Array | float, design: int, n: int) -> Array:
    """What one design has of values that broadcast to (design, 1, n)."""
    whole = np.atleast_3d(values) if np.ndim(values) == 3 else np.reshape(values, (1, 1, -1))
    return np.array(np.broadcast_to(whole[min(design, len(whole) - 1), 0], (n,)))


def _of_design(values: Array, design: int) -> Array:
    """What one design has."""
    return values[min(design, len(values) - 1)]


def load_panels(shown: OneDesign, curves: CurvesOfLoads) -> Iterator[Panel]:
    """Collect the curves over the crank angle.

    Yields
    ------
    Panel
        Forces; torques; what all do to the crank together; power of each. A curve's symbol is its load's number in the
        table.
    """
    kinds = ((False, _("Forces of loads"), "N"), (True, _("Torques of loads"), "N*m"))
    for is_torque, title, unit in kinds:
        own = [(i, one) for i, one in enumerate(curves.each) if one.is_torque is is_torque]
        if own:
            yield Panel(title, unit, curves.angle, tuple(_drawn(own, lambda one: one.size, "T" if is_torque else "F")))
    whole = np.sum([one.on_crank for one in curves.each], axis=0)
    title = _("Torque of all loads on the crank")
    yield Panel(title, "N*m", curves.angle, (Curve(whole, "whole", "T"),))
    every = list(enumerate(curves.each))
    yield Panel(_("Power of loads"), "W", curves.angle, tuple(_drawn(every, lambda one: one.power, "T")))


def _drawn(
    own: Sequence[tuple[int, CurveOfLoad]], values: Callable[[CurveOfLoad], Array], letter: str
) -> Iterator[Curve]:
    """Curves of some loads, the first few with their numbers."""
    for place, (i, one) in enumerate(own):
        role = role_at(place)
        yield Curve(values(one), role, letter, "" if role == "each" else f"{i + 1}", one.name)


def travel_panels(curves: CurvesOfLoads) -> Iterator[Panel]:
    """Size over the travel, or the swing, of loads that go by it, once round the cycle."""
    for i, one in enumerate(curves.each):
        if not np.all(np.isfinite(one.travel)):
            continue
        unit, across_unit = ("N*m", "rad") if one.is_torque else ("N", "m")
        title = _("{number}: {size} over swing, {unit}") if one.is_torque else _("{number}: {size} over travel, {unit}")
        said = title.format(
            number=i + 1,
            size=UnitLabel(unit, peak(one.size)),
            unit=UnitLabel(across_unit, float(np.max(one.travel))),
        )
        curve = Curve(closed(one.size), "card", "T" if one.is_torque else "F")
        yield Panel(said, unit, closed(one.travel), (curve,), across_unit=across_unit)
