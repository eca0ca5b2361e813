"""Counterbalance of a pumping unit: the weights that make both peaks of its gearbox torque equal, or its rms least."""

import math
from collections.abc import Iterator
from typing import Annotated, Literal

import numpy as np

from cranktrain.analysis.parts import refuse_wrong
from cranktrain.analysis.run import run
from cranktrain.declared_types import words_of
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import N_, Words, _
from cranktrain.machine import Machine
from cranktrain.paths import path_text
from cranktrain.quantities import Given, unlisted
from cranktrain.questions.pumping.gearbox_torque import GearboxTorque
from cranktrain.synthesis.proposal import Alternative, MachineProposal, Number, found, quantity_text

Aim = Literal["equal_peaks", "least_rms"]

_UNITS = ("N", "kN", "lbf")
_ONE = 1e-9
"""In parts: moments that differ by less are one."""
_AIMS = {
    "equal_peaks": N_("equal peaks of up- and downstroke"),
    "least_rms": N_("the least root mean square of the torque"),
}
_QUANTITIES = ("upstroke_peak", "downstroke_peak")


def counterbalance(
    machine: Machine,
    aim: Annotated[Aim, N_("What the weights are for; equal peaks unless given.")] = "equal_peaks",
) -> MachineProposal:
    """Propose the counterbalance of a pumping unit, at the arm and in the direction that the file declares.

    Parameters
    ----------
    machine : Machine
        With [pumping], its card and its counterbalance.
    aim : str
        `equal_peaks` of up- and downstroke, or `least_rms` of the net torque.

    Returns
    -------
    MachineProposal
        With `force`, `moment`, `upstroke_peak`, `downstroke_peak`, `least`, `mean`, `rms` and `factor`. The
        alternatives are the file as it is, and the other aim.

    Raises
    ------
    InputError
        Where there is no pumping unit, no counterbalance, or none that makes both peaks equal.

    Notes
    -----
    docs/theory/pumping-unit, eqs. (28.8) to (28.10).
    """
    refuse([] if aim in words_of(Aim) else [unlisted("aim", aim, words_of(Aim))])
    refuse_wrong((machine,))
    path, given = _weights(machine)
    unit = _unit_of(given)
    # At no weight at all nothing says how much of it would be best.
    started = machine if given.si != 0.0 else machine.with_({path: f"1 {unit}"})
    start, base = _torques(started), _si(started)
    _refuse_other_weights(machine, start, base)
    forces = {
        "equal_peaks": base * float(start.equal_peaks_moment[0] / start.counterbalance_moment[0]),
        "least_rms": base * float(start.least_rms_moment[0] / start.counterbalance_moment[0]),
    }
    if not np.isfinite(forces[aim]):
        allowed = _("cannot make both peaks equal under this card; ask for the least rms")
        raise InputError([Problem(path.removesuffix(".force"), None, allowed)])
    other = next(name for name in forces if name != aim)
    after, beside = (machine.with_({path: quantity_text(forces[name], unit)}) for name in (aim, other))
    text = found(forces[aim], unit, _("for {aim} under the card", aim=_(_AIMS[aim])))
    return MachineProposal(
        title=_title(machine, aim),
        numbers=tuple(_numbers(after)),
        alternatives=(
            Alternative(_("as the file has it"), tuple(_numbers(machine))),
            Alternative(_("for {aim}", aim=_(_AIMS[other])), tuple(_numbers(beside))),
        ),
        remarks=tuple(_torques(after).flags),
        tables=(),
        machine=after,
        values={path: text},
    )


def _weights(machine: Machine) -> tuple[str, Given]:
    """Path of the counterbalance's force, and what it is."""
    pumping = machine.pumping
    if pumping is None:
        allowed = _("is missing: a counterbalance is of a pumping unit, whose loads it names")
        raise InputError([Problem("pumping", None, allowed)])
    if pumping.counterbalance is None:
        allowed = _("is missing: the name of the load on the crank that is the weights, with its arm and direction")
        raise InputError([Problem("pumping.counterbalance", None, allowed)])
    for home, named in machine.loads.items():
        load = named.get(pumping.counterbalance)
        if load is not None and load.force is not None:
            return f"{home}.{path_text((pumping.counterbalance,))}.force", load.force[0]
    raise InputError([Problem("pumping.counterbalance", pumping.counterbalance, _("must be a force on the crank"))])


def _refuse_other_weights(machine: Machine, start: GearboxTorque, force: float) -> None:
    """Refuse a crank whose own body is a counterbalance, too: no force alone is then the answer."""
    path, _given = _weights(machine)
    named = {name: load for loads in machine.loads.values() for name, load in loads.items()}
    load = named[machine.pumping.counterbalance or ""] if machine.pumping is not None else None
    along, across = (None, None) if load is None else (load.along, load.across)
    own = abs(force) * math.hypot(0.0 if along is None else along.si, 0.0 if across is None else across.si)
    if abs(float(start.counterbalance_moment[0]) - own) > _ONE * own:
        allowed = _("is not all of the counterbalance: [masses.crank] weighs, too; say its moment by the force alone")
        raise InputError([Problem(path, None, allowed)])


def _si(machine: Machine) -> float:
    """Force of the counterbalance. [N]"""
    return _weights(machine)[1].si


def _unit_of(given: Given) -> str:
    """Unit in which it was written, or N."""
    written = given.text.split()[-1]
    return written if written in _UNITS else "N"


def _torques(machine: Machine) -> GearboxTorque:
    """Run a machine for its gearbox torque."""
    result = run(machine, quantities=_QUANTITIES)
    return result[GearboxTorque]


def _title(machine: Machine, aim: str) -> Words:
    """Whose counterbalance, and for what."""
    if machine.name:
        return _("{machine}: counterbalance for {aim}", machine=machine.name, aim=_(_AIMS[aim]))
    return _("Counterbalance for {aim}", aim=_(_AIMS[aim]))


def _numbers(machine: Machine) -> Iterator[Number]:
    """Force and moment, and what the gearbox gives with them."""
    of = _torques(machine)
    least = float(of.least_gearbox_torque.value[0])
    yield Number("force", "F", _si(machine), "N", _("Force of the counterbalance at its arm"))
    yield Number("moment", "M", float(of.counterbalance_moment[0]), "N·m", _("Moment of the counterbalance"))
    yield Number("upstroke_peak", "T_u", float(of.upstroke_peak.value[0]), "N·m", _("Peak torque of the upstroke"))
    yield Number(
        "downstroke_peak", "T_d", float(of.downstroke_peak.value[0]), "N·m", _("Peak torque of the downstroke")
    )
    yield Number("least", "T_min", least, "N·m", _("Least torque; less than 0 it drives the gearbox"))
    yield Number("mean", "T_m", float(of.mean_gearbox_torque[0]), "N·m", _("Mean torque"))
    yield Number("rms", "T_rms", float(of.rms_gearbox_torque[0]), "N·m", _("Root mean square of the torque"))
    yield Number("factor", "CLF", float(of.cyclic_load_factor[0]), "1", _("Cyclic load factor"))
    if np.isfinite(of.torque_share[0]):
        yield Number("share", "T/T_r", float(of.torque_share[0]), "%", _("Largest torque, of the gearbox's rating"))
