"""Torque in every journal and crank pin over the cycle, by each method, with its range."""

from collections.abc import Sequence

import numpy as np

from cranktrain.language import N_, _
from cranktrain.layout.shafts import Shafts
from cranktrain.motion import Array
from cranktrain.numerics import Peak
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.crankshaft.bending.loads_in_spans import SpannedLoads
from cranktrain.questions.crankshaft.bending.shaft_loads import torque_sizes, torques
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts, LoadsOverCycle
from cranktrain.questions.crankshaft.results.main_bearing_loads import MainBearingLoads
from cranktrain.questions.crankshaft.results.shaft_peaks import ShaftPeaks
from cranktrain.questions.crankshaft.results.torque_of_shafts import (
    in_turning_axes,
    torque_in_sections,
    torques_of_loads,
)
from cranktrain.questions.crankshaft.shaft_layout import ShaftLayout
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANKSHAFT as _THEORY
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import Check, Checked

_FACT = ("bearing_method", "section")
_CURVE = (*_FACT, "crank_angle")
_LIMIT = 1e-11
"""Of what all do by their arms: what rounding may leave over."""


@record
class SectionTorques(Checked):
    """Torque that journals and crank pins hand on toward the flywheel; in journals it is the same by every method."""

    section_torque: Array = quantity(
        "M",
        "N*m",
        _CURVE,
        N_("Torque in the journal or crank pin about its own axis, in the sense of rotation"),
        _THEORY,
        "24.37, 24.38",
    )
    largest_section_torque: Peak = extreme(
        "M_max",
        "N*m",
        _FACT,
        N_("Largest torque in the journal or crank pin"),
        N_("Crank angle of the largest torque in the journal or crank pin"),
        _THEORY,
        "24.37, 24.38",
        worst="largest",
        of="section_torque",
    )
    least_section_torque: Peak = extreme(
        "M_min",
        "N*m",
        _FACT,
        N_("Least torque in the journal or crank pin"),
        N_("Crank angle of the least torque in the journal or crank pin"),
        _THEORY,
        "24.37, 24.38",
    )
    section_torque_range: Array = quantity(
        "ΔM",
        "N*m",
        _FACT,
        N_("Range of the torque in the journal or crank pin, largest less least"),
        _THEORY,
        "24.37, 24.38",
        line="{largest_section_torque} − {least_section_torque}",
    )


SECTIONS = ("journal", "pin")
"""How names of sections begin, by whether a piece lies on the shaft's axis."""

SECTION_TITLES = {
    "journal {n}": N_("journal {n}"),
    "pin {n}": N_("pin {n}"),
    "{shaft}.journal {n}": N_("{shaft}.journal {n}"),
    "{shaft}.pin {n}": N_("{shaft}.pin {n}"),
}
"""What people call sections."""


def widest_sections(ranges: Array, sections: Sequence[str]) -> tuple[int, int]:
    """Which journal and which pin have the widest range, of alike ones the first."""

    def widest(kind: str) -> int:
        of_kind = [i for i, name in enumerate(sections) if kind in name]
        return of_kind[first_largest(ranges[of_kind])]

    return widest(SECTIONS[0]), widest(SECTIONS[1])


def section_torques(
    loaded: LoadedShafts,
    bearings: MainBearingLoads,
    over_cycle: LoadsOverCycle,
    solved: SolvedCycle,
    peaks: ShaftPeaks,
) -> SectionTorques:
    """Torque along all shafts over the cycle; largest and least refined on the machine itself.

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.37) and (24.38).
    """
    acting = over_cycle.each
    load = np.stack([bearings.main_bearing_load_x, bearings.main_bearing_load_y], axis=3)
    by_loads, n_methods = torques_of_loads(loaded, acting), load.shape[1]
    borne = (in_turning_axes(load[:, method], acting, loaded) for method in range(n_methods))
    curves = [torque_in_sections(loaded, by_loads, loads) for loads in borne]
    is_journal = np.concatenate([shaft.layout.is_journal for shaft in loaded.each])
    most, least = (Peak(*np.empty((3, len(load), n_methods, is_journal.size))) for _way in range(2))
    for way, ends in enumerate((most, least)):
        for whole, pins, journals in zip(ends, peaks.pin_torque, peaks.journal_torque, strict=True):
            whole[:, :, ~is_journal] = np.split(pins, 2, axis=-1)[way]
            whole[:, :, is_journal] = np.split(journals, 2, axis=-1)[way][:, np.newaxis]
    least = least._replace(value=-least.value)
    return SectionTorques(
        section_torque=np.stack(curves, axis=1),
        largest_section_torque=most,
        least_section_torque=least,
        section_torque_range=most.value - least.value,
        labels={"section": tuple(name for shaft in loaded.each for name in _names(shaft.layout, loaded.shafts))},
        checks=(_check(loaded, acting, solved.driving_torque),),
    )


def _check(loaded: LoadedShafts, acting: Sequence[SpannedLoads], driving: Array) -> Check:
    """Whether rods and cranks turn each shaft by what drives its mechanisms, shape (design, mechanism, n)."""
    worst = np.zeros(len(driving))
    for shaft, spanned in zip(loaded.each, acting, strict=True):
        n_loads = shaft.n_of_mechanisms
        by_forces = shaft.layout.turn * torques(spanned.loads, spanned.turning_force)[:, :n_loads]
        by_joints = np.sum(driving[:, np.unique(shaft.rods.number)], axis=1)
        off = np.max(np.abs(np.sum(by_forces, axis=1) + by_joints), axis=-1)
        # Forces that stand along their cranks turn nothing, but by rounding.
        scale = np.max(np.sum(torque_sizes(spanned.loads)[:, :n_loads], axis=1), axis=-1)
        worst = np.maximum(worst, off / np.where(scale > 0, scale, 1.0))
    sentence = _(
        "Torque of all rods and cranks about the shaft's axis, as its last journal has it, against the joints',"
        " relative to forces times arms"
    )
    return Check("section_torque", sentence, worst, _LIMIT)


def _names(layout: ShaftLayout, shafts: Shafts) -> tuple[str, ...]:
    """Names of a shaft's sections by the numbers of its journals and pins, in their order along it."""
    prefix = f"{shafts.names[layout.declared.shaft]}." if len(shafts.names) > 1 else ""
    named = {
        piece: f"{prefix}{kind} {number}"
        for kind, pieces in zip(SECTIONS, (layout.journals, layout.pins), strict=True)
        for number, piece in enumerate(pieces.tolist(), start=1)
        if piece >= 0
    }
    shoulders = layout.declared.shoulders
    for name, z, journal in zip(shoulders.names, shoulders.z[0].tolist(), shoulders.journal.tolist(), strict=True):
        named[layout.piece_at(z)] = f"{prefix}{SECTIONS[0]} {journal + 1} {name}"
    return tuple(named[piece] for piece in sorted(named))
