"""Torque in every journal and crank pin over the cycle, by each method, with its range."""

from collections.abc import Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from cranktrain.catalogue import extreme, quantity
from cranktrain.checks import Check, StageResult
from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.shafts import Shafts
from cranktrain.motion import Array
from cranktrain.numerics import Curve, Peak
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.crankshaft.acting import LoadedShaft, LoadedShafts
from cranktrain.questions.crankshaft.bearing_method import BearingMethod
from cranktrain.questions.crankshaft.bearings_between_events import bearing_loads_of, methods_for
from cranktrain.questions.crankshaft.loads_over_cycle import LoadsOverCycle
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.crankshaft.shaft_loads import ShaftLoads, torque_sizes, torques
from cranktrain.questions.crankshaft.stages import MainBearingLoads
from cranktrain.questions.crankshaft.torque_along import torque_along
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.mechanism_torques import driving_torques
from cranktrain.questions.forces.peaks import largest_of_machine
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANKSHAFT as _THEORY
from cranktrain.wording import Names, number

_FACT = ("bearing_method", "section")
_CURVE = (*_FACT, "crank_angle")
_LIMIT = 1e-11
"""Of what all do by their arms: what rounding may leave over."""


@record
class SectionTorques(StageResult):
    """Torque that journals and crank pins hand on toward the flywheel; in journals it is the same by every method."""

    section_torque: Array = quantity(
        "M",
        "N*m",
        _CURVE,
        N_("Torque in the journal or crank pin about its own axis, in the sense of rotation"),
        _THEORY,
    )
    largest_section_torque: Peak = extreme(
        "M_max",
        "N*m",
        _FACT,
        N_("Largest torque in the journal or crank pin"),
        N_("Crank angle of the largest torque in the journal or crank pin"),
        _THEORY,
    )
    least_section_torque: Peak = extreme(
        "M_min",
        "N*m",
        _FACT,
        N_("Least torque in the journal or crank pin"),
        N_("Crank angle of the least torque in the journal or crank pin"),
        _THEORY,
    )
    section_torque_range: Array = quantity(
        "ΔM", "N*m", _FACT, N_("Range of the torque in the journal or crank pin, largest less least"), _THEORY
    )

    def answer(self, names: Names, design: int) -> str | None:
        """Say which journal and which pin have the widest range, by the first method."""
        ranges, sections = self.section_torque_range[design, 0], names["section"]
        if not np.all(np.isfinite(ranges)):
            return None
        said = (
            _("{range} in {section}").format(range=number(float(ranges[i]), "N*m"), section=sections[i])
            for i in widest_sections(ranges, sections)
        )
        return _("Widest range of the shaft's torque: {found}.").format(found=", ".join(said))


SECTIONS = ("journal", "pin")
"""How names of sections begin, by whether a piece lies on the shaft's axis."""


def widest_sections(ranges: Array, sections: Sequence[str]) -> tuple[int, int]:
    """Which journal and which pin have the widest range, of alike ones the first."""

    def widest(kind: str) -> int:
        own = [i for i, name in enumerate(sections) if kind in name]
        return own[first_largest(ranges[own])]

    return widest(SECTIONS[0]), widest(SECTIONS[1])


def section_torques(
    loaded: LoadedShafts,
    declared: DeclaredCrankshafts,
    bearings: MainBearingLoads,
    over_cycle: LoadsOverCycle,
    solved: SolvedCycle,
    events: ForceEvents,
    crank_angle: CrankAngle,
) -> SectionTorques:
    """Torque along all shafts over the cycle; largest and least refined on the machine itself.

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.37) and (24.38).
    """
    on_axis = np.concatenate([_on_axis(one) for one in loaded.each])
    acting = over_cycle.each
    load = np.stack([bearings.main_bearing_load_x, bearings.main_bearing_load_y], axis=3)
    methods = methods_for(declared)
    curves = np.stack([_along(loaded, acting, load[:, place]) for place in range(len(methods))], axis=1)
    ends = Peak(*np.empty((3, 2, *curves.shape[:3])))

    def peaks(place: int, which: NDArray[np.bool_], curve: Curve) -> None:
        """Find largest and least of some sections, by a method."""
        own = _both_ways(curves[:, place, which])
        both = largest_of_machine(lambda angle: _both_ways(curve(angle)[:, which]), own, events, crank_angle)
        for whole, part in zip(ends, both, strict=True):
            whole[:, :, place, which] = np.moveaxis(part.reshape(len(part), 2, -1), 1, 0)

    for place, method in enumerate(methods):
        peaks(place, ~on_axis, partial(_by_method, loaded, method))
    # In journals no method matters.
    peaks(0, on_axis, partial(_by_method, loaded, None))
    for whole in ends:
        whole[:, :, :, on_axis] = whole[:, :, :1, on_axis]
    most, least = (Peak(*(part[way] for part in ends)) for way in range(2))
    least = least._replace(value=-least.value)
    return SectionTorques(
        section_torque=curves,
        largest_section_torque=most,
        least_section_torque=least,
        section_torque_range=most.value - least.value,
        labels={"section": tuple(name for one in loaded.each for name in _names(one, loaded.shafts))},
        checks=(_check(loaded, acting, driving_torques(loaded.loaded, solved.batches)),),
    )


def _both_ways(torque: Array) -> Array:
    """Torque of sections, and the same against the rotation, shape (design, 2 · section, n)."""
    return np.concatenate([torque, -torque], axis=1)


def _by_method(loaded: LoadedShafts, method: BearingMethod | None, angle: Array) -> Array:
    """Torque of every section at φ, shape (design, section, n); with no method it is right in journals alone. [N·m]"""
    acting = loaded.loads(angle)
    if method is None:
        n_bearings = sum(one.shaft.supports.place.shape[1] for one in loaded.each)
        return _along(loaded, acting, np.zeros((len(angle), n_bearings, 2, angle.shape[-1])))
    return _along(loaded, acting, bearing_loads_of(loaded, [method], acting)[:, 0])


def _along(loaded: LoadedShafts, acting: Sequence[ShaftLoads], borne: Array) -> Array:
    """Torque of every section in the sense of its shaft's rotation, shape (design, section, n). [N·m]"""
    found: list[Array] = []
    before = 0
    for one, own in zip(loaded.each, acting, strict=True):
        n_bearings = one.shaft.supports.place.shape[1]
        found.append(one.laid.turn * torque_along(one.shaft, own, borne[:, before : before + n_bearings]).begin)
        before += n_bearings
    return np.concatenate(found, axis=1)


def _check(loaded: LoadedShafts, acting: Sequence[ShaftLoads], driving: Array) -> Check:
    """Whether rods and cranks turn each shaft by what drives its mechanisms, shape (design, mechanism, n)."""
    worst = np.zeros(len(driving))
    for one, own in zip(loaded.each, acting, strict=True):
        n_loads = one.rods.number.size + one.cranks.number.size
        by_forces = one.laid.turn * torques(own)[:, :n_loads]
        by_joints = np.sum(driving[:, np.unique(one.rods.number)], axis=1)
        off = np.max(np.abs(np.sum(by_forces, axis=1) + by_joints), axis=-1)
        # Forces that stand along their cranks turn nothing, but by rounding.
        scale = np.max(np.sum(torque_sizes(own)[:, :n_loads], axis=1), axis=-1)
        worst = np.maximum(worst, off / np.where(scale > 0, scale, 1.0))
    sentence = _(
        "Torque of all rods and cranks about the shaft's axis, as its last journal has it, against the joints',"
        " relative to forces times arms"
    )
    return Check("section_torque", sentence, worst, _LIMIT)


def _on_axis(one: LoadedShaft) -> NDArray[np.bool_]:
    """Which pieces of a shaft are journals."""
    found = np.zeros(one.shaft.pieces.radius.shape[1], dtype=np.bool_)
    found[one.laid.journals[one.laid.journals >= 0]] = True
    return found


def _names(one: LoadedShaft, shafts: Shafts) -> tuple[str, ...]:
    """Names of a shaft's sections by the numbers of its journals and pins, in their order along it."""
    prefix = f"{shafts.names[one.laid.declared.shaft]}." if len(shafts.names) > 1 else ""
    named = {
        piece: f"{prefix}{kind} {number}"
        for kind, pieces in zip(SECTIONS, (one.laid.journals, one.laid.pins), strict=True)
        for number, piece in enumerate(pieces.tolist(), start=1)
        if piece >= 0
    }
    return tuple(named[piece] for piece in sorted(named))
