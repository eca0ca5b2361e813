"""Torque of a pumping unit's gearbox over the turn, its peaks, and the counterbalance that would make them least."""

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle, within
from cranktrain.motion import Array
from cranktrain.numerics import Extreme
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.pumping.acting import ActingOnUnit, PumpingUnit, is_crank_weightless, pumping_unit
from cranktrain.questions.pumping.balanced import BalancedUnit, balanced
from cranktrain.questions.pumping.declared import DeclaredPumping
from cranktrain.questions.pumping.turn_pieces import highest, turn_pieces
from cranktrain.record import record
from cranktrain.references import THEORY_OF_PUMPING_UNITS as _THEORY
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import Check, Checked, Flagged
from cranktrain.saying.wording import number

_CURVE = ("crank_angle",)
_POSITION = ("stroke_position",)
_POSITIONS = np.linspace(0.0, 1.0, 21)
_EXACT_LIMIT = 1e-9
_FLAT = 1e-6
"""Torque factors less than this part of the largest are none: there no rod load brings the gearbox to its rating."""
_APART = 0.01
"""Peaks of up- and downstroke that differ by less, in parts of the larger one, are equal."""


@record
class GearboxTorque(Checked, Flagged):
    """Torque of the gearbox, quasi-static: of loads, without inertia and weight of masses."""

    rod_position: Array = quantity(
        "PR", "1", _CURVE, N_("Position of the polished rod, 0 lowest, 1 highest"), _THEORY, "28.1"
    )
    torque_factor: Array = quantity(
        "TF", "m", _CURVE, N_("Torque factor: rise of the polished rod for each radian of the crank"), _THEORY, "28.2"
    )
    polished_rod_load: Array = quantity(
        "W", "N", _CURVE, N_("Pull of the well at the polished rod"), _THEORY, "definition"
    )
    rod_torque: Array = quantity(
        "T_W", "N*m", _CURVE, N_("Torque for the polished rod, less that of the structural unbalance"), _THEORY, "28.5"
    )
    counterbalance_torque: Array = quantity("T_M", "N*m", _CURVE, N_("Torque for the counterbalance"), _THEORY, "28.5")
    gearbox_torque: Array = quantity("T", "N*m", _CURVE, N_("Net torque of the gearbox at the crank"), _THEORY, "28.4")
    permissible_load: Array = quantity(
        "W_p",
        "N",
        _CURVE,
        N_("Rod load that brings the gearbox to its rated torque: a most going up, a least going down"),
        _THEORY,
        "28.12, 28.13",
    )
    upstroke_angle: Array = quantity(
        "φ_u", "deg", _POSITION, N_("Crank angle at a position on the upstroke"), _THEORY, "28.1", is_place=True
    )
    downstroke_angle: Array = quantity(
        "φ_d", "deg", _POSITION, N_("Crank angle at a position on the downstroke"), _THEORY, "28.1", is_place=True
    )
    upstroke_permissible_load: Array = quantity(
        "W_p,u", "N", _POSITION, N_("Most that the rod may pull going up, by the rated torque"), _THEORY, "28.12, 28.13"
    )
    downstroke_permissible_load: Array = quantity(
        "W_p,d",
        "N",
        _POSITION,
        N_("Least that the rod must pull going down, by the rated torque"),
        _THEORY,
        "28.12, 28.13",
    )
    rod_stroke: Array = quantity("S_PR", "m", (), N_("Stroke of the polished rod"), _THEORY, "28.1")
    bottom_angle: Array = quantity(
        "φ_b", "deg", (), N_("Crank angle at which the polished rod is lowest"), _THEORY, "28.2", is_place=True
    )
    top_angle: Array = quantity(
        "φ_t", "deg", (), N_("Crank angle at which the polished rod is highest"), _THEORY, "28.2", is_place=True
    )
    upstroke_peak: Extreme = extreme(
        "T_u", "N*m", (), N_("Largest net torque of the upstroke"), N_("Crank angle of that torque"), _THEORY, "28.4"
    )
    downstroke_peak: Extreme = extreme(
        "T_d", "N*m", (), N_("Largest net torque of the downstroke"), N_("Crank angle of that torque"), _THEORY, "28.4"
    )
    least_gearbox_torque: Extreme = extreme(
        "T_min",
        "N*m",
        (),
        N_("Smallest net torque; less than 0 where the machine drives the gearbox"),
        N_("Crank angle of that torque"),
        _THEORY,
        "28.4",
    )
    mean_gearbox_torque: Array = quantity("T_m", "N*m", (), N_("Mean net torque"), _THEORY, "28.4")
    rms_gearbox_torque: Array = quantity("T_rms", "N*m", (), N_("Root mean square of the net torque"), _THEORY, "28.4")
    cyclic_load_factor: Array = quantity(
        "CLF",
        "1",
        (),
        N_("Cyclic load factor: root mean square of the net torque over its mean"),
        _THEORY,
        "28.7",
        line="{rms_gearbox_torque} / {mean_gearbox_torque}",
    )
    card_work: Array = quantity(
        "W_c", "J", (), N_("Work of a turn at the polished rod: area of its card"), _THEORY, "28.6"
    )
    polished_rod_power: Array = quantity("P_PR", "W", (), N_("Mean power at the polished rod"), _THEORY, "28.14")
    counterbalance_moment: Array = quantity(
        "M", "N*m", (), N_("Largest moment of the counterbalance about the crankshaft"), _THEORY, "28.11"
    )
    weights_phase: Array = quantity(
        "τ", "deg", (), N_("How far the weights are ahead of the line from shaft to crank pin"), _THEORY, "28.11"
    )
    equal_peaks_moment: Array = quantity(
        "M_eq", "N*m", (), N_("Moment of the counterbalance that makes both peaks equal"), _THEORY, "28.9"
    )
    equal_peaks_torque: Array = quantity(
        "T_eq", "N*m", (), N_("Both peaks with that counterbalance"), _THEORY, "28.8, 28.9"
    )
    least_rms_moment: Array = quantity(
        "M_rms", "N*m", (), N_("Moment of the counterbalance that makes the root mean square least"), _THEORY, "28.10"
    )
    least_rms_torque: Array = quantity(
        "T_rms,0", "N*m", (), N_("Root mean square with that counterbalance"), _THEORY, "28.8, 28.10"
    )
    least_rms_peak: Array = quantity(
        "T_rms,max", "N*m", (), N_("Largest torque with that counterbalance"), _THEORY, "28.8, 28.10"
    )
    torque_share: Array = quantity(
        "T/T_r", "1", (), N_("Largest torque of either sign, of the gearbox's rating"), _THEORY, "28.14"
    )
    load_share: Array = quantity(
        "W/W_r", "1", (), N_("Largest pull at the polished rod, of its rating"), _THEORY, "28.14"
    )


_Top = tuple[float, float]
"""Angle and value."""


class _Facts(NamedTuple):
    """Of one design; angles φ [rad], torques [N·m], share of the counterbalance."""

    up: _Top
    down: _Top
    least: _Top
    mean: float
    rms: float
    work: float
    pull: float
    best: BalancedUnit
    equal_peaks: float
    least_rms: float
    least_rms_peak: float


def gearbox_torque(
    declared: DeclaredPumping, loaded: LoadedMachine, events: ForceEvents, crank_angle: CrankAngle
) -> GearboxTorque:
    """Torque of the gearbox over the turn.

    Notes
    -----
    T = TF (W − B) − M sin(θ + τ), by virtual work of all loads. docs/theory/pumping-unit, eqs. (28.1) to (28.13).
    """
    unit = pumping_unit(declared, loaded)
    n_designs = len(declared.moment)
    angle = np.broadcast_to(crank_angle.angle[:, 0], (n_designs, crank_angle.shown.size))
    on_grid = unit.at(angle)
    lowest, highest = (unit.height(end[:, np.newaxis]) for end in (unit.bottom, unit.top))
    facts = [
        _facts(unit, design, np.broadcast_to(events.whole, (n_designs, events.whole.shape[-1]))[design])
        for design in range(n_designs)
    ]
    up, down = unit.angles_at(_POSITIONS)
    up_load, down_load = (_permissible(unit.at(angles), declared.rated_torque) for angles in (up, down))

    def each(name: str) -> Array:
        return np.array([getattr(one, name) for one in facts])

    def peak(name: str) -> Extreme:
        angle, value = np.array([getattr(one, name) for one in facts]).T
        return Extreme(counted(angle), value)

    def counted(of: Array) -> Array:
        zero = crank_angle.zero[:, 0, 0] if of.ndim == 1 else crank_angle.zero[:, 0]
        return within(of - zero, TURN)

    equal, least_rms = (np.array([getattr(one.best, name) for one in facts]) for name in BalancedUnit._fields)
    mean, rms, work = each("mean"), each("rms"), each("work")
    largest = np.maximum(np.maximum(peak("up").value, peak("down").value), -peak("least").value)
    with np.errstate(all="ignore"):
        found = GearboxTorque(
            rod_position=(on_grid.height - lowest) / (highest - lowest),
            torque_factor=on_grid.factor,
            polished_rod_load=on_grid.load,
            rod_torque=on_grid.rod,
            counterbalance_torque=on_grid.weights,
            gearbox_torque=on_grid.rod + on_grid.weights,
            permissible_load=_permissible(on_grid, declared.rated_torque),
            upstroke_angle=counted(up),
            downstroke_angle=counted(down),
            upstroke_permissible_load=up_load,
            downstroke_permissible_load=down_load,
            rod_stroke=(highest - lowest)[:, 0],
            bottom_angle=counted(unit.bottom),
            top_angle=counted(unit.top),
            upstroke_peak=peak("up"),
            downstroke_peak=peak("down"),
            least_gearbox_torque=peak("least"),
            mean_gearbox_torque=mean,
            rms_gearbox_torque=rms,
            cyclic_load_factor=np.where(mean > 0, rms / mean, np.nan),
            card_work=work,
            polished_rod_power=work * np.broadcast_to(loaded.speed.mean[..., 0], (n_designs, 1))[:, 0] / TURN,
            counterbalance_moment=unit.moment,
            weights_phase=unit.phase,
            equal_peaks_moment=equal * unit.moment,
            equal_peaks_torque=each("equal_peaks"),
            least_rms_moment=least_rms * unit.moment,
            least_rms_torque=each("least_rms"),
            least_rms_peak=each("least_rms_peak"),
            torque_share=largest / declared.rated_torque,
            load_share=each("pull") / declared.rated_load,
            labels={"stroke_position": tuple(f"{position:g}" for position in np.round(_POSITIONS, 2).tolist())},
            checks=tuple(_checks(unit, work)),
        )
    return replace(found, flags=tuple(_flags(found, declared, is_weightless=is_crank_weightless(loaded))))


def _facts(unit: PumpingUnit, design: int, events: Array) -> _Facts:
    """What holds over the whole turn of one design."""
    bottom, top = float(unit.bottom[design]), float(unit.top[design])
    top = bottom + (top - bottom) % TURN
    pieces = turn_pieces(np.concatenate([events, [bottom, top]]), TURN)
    own = [
        part[design] for part in unit.at(np.broadcast_to(pieces.cut.angle, (len(unit.bottom), pieces.cut.angle.size)))
    ]
    at = ActingOnUnit(*own)
    torque = at.rod + at.weights
    best = balanced(pieces, at.rod, at.weights, (bottom, top))
    of_best = [at.rod + share * at.weights for share in best]
    tops = pieces.tops(np.stack([torque, -torque, at.load, *of_best]))
    is_up = pieces.within(bottom, top)
    up, down, whole = (highest(tops, chosen) for chosen in (is_up, ~is_up, is_up | ~is_up))
    _torque, least, pull, equal_peaks, least_rms_peak = zip(*whole, strict=True)
    return _Facts(
        up=(up.angle[0], up.value[0]),
        down=(down.angle[0], down.value[0]),
        least=(least[0], -least[1]),
        mean=pieces.mean(torque),
        rms=float(np.sqrt(pieces.mean(torque**2))),
        work=pieces.mean(at.load * at.factor) * TURN,
        pull=pull[1],
        best=best,
        equal_peaks=equal_peaks[1],
        least_rms=float(np.sqrt(pieces.mean(of_best[1] ** 2))),
        least_rms_peak=least_rms_peak[1],
    )


def _permissible(at: ActingOnUnit, rated: Array) -> Array:
    """Rod load that brings the gearbox to its rating; NaN beside the dead centres, where none does. [N]"""
    factor = np.where(np.abs(at.factor) > _FLAT * np.max(np.abs(at.factor), axis=-1, keepdims=True), at.factor, np.nan)
    others = at.rod - at.load * at.factor + at.weights
    return (rated[:, np.newaxis] - others) / factor


def _checks(unit: PumpingUnit, work: Array) -> Iterator[Check]:
    """Work of the polished rod by quadrature over the crank angle against the area of its card by its corners."""
    area = unit.card_area()
    if np.all(np.isfinite(area)):
        scale = np.where(area != 0.0, np.abs(area), np.nan)
        sentence = _("Work of the polished rod, by quadrature over the crank angle, against the area of its card")
        yield Check("card_area", sentence, np.abs(work - area) / scale, _EXACT_LIMIT)


def _flags(found: GearboxTorque, declared: DeclaredPumping, *, is_weightless: bool) -> Iterator[Words]:
    """Flag ratings exceeded, torque that drives the gearbox, weights too heavy or light, and masses left out."""
    if np.any(found.torque_share > 1.0):
        share = number(float(np.nanmax(found.torque_share)), "%")
        yield _("The gearbox is over its rated torque: {share}.", share=share)
    if np.any(found.load_share > 1.0):
        share = number(float(np.nanmax(found.load_share)), "%")
        yield _("The polished rod pulls more than it is rated for: {share}.", share=share)
    least = float(np.min(found.least_gearbox_torque.value))
    if least < 0:
        said = _("The net torque falls to {least}: the machine drives the gearbox there, and its teeth change sides.")
        yield said.format(least=number(least, "N·m"))
    up, down = found.upstroke_peak.value, found.downstroke_peak.value
    if np.any(found.mean_gearbox_torque < -_APART * np.maximum(np.abs(up), np.abs(down))):
        yield _("The card gives work over a turn, as if the well drove the machine: see whether its `counts` is right.")
    apart = (up - down) / np.maximum(np.abs(up), np.abs(down))
    if np.any(np.isfinite(found.counterbalance_moment) & (apart > _APART)):
        yield _("The counterbalance is too light: the peak of the upstroke is the larger one.")
    if np.any(np.isfinite(found.counterbalance_moment) & (apart < -_APART)):
        yield _("The counterbalance is too heavy: the peak of the downstroke is the larger one.")
    if is_weightless:
        said = _(
            "The crank's body weighs nothing without gravity = true: gearbox_torque has nothing of it, and the"
            " counterbalance is that of loads alone."
        )
        yield said
    if declared.has_masses:
        said = _(
            "The gearbox torque is that of loads and the weight of the crank's body alone; weight of other masses, and"
            " inertia, are in driving_torque."
        )
        yield said
