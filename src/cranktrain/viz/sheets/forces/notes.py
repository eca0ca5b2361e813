"""Sentences below the sheet of forces: what it leaves out, and what its curves rest on."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import _
from cranktrain.questions.forces.carriers import carriers_of
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.scales import scale_for
from cranktrain.viz.figures import with_unit
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.paper.page import mathematics
from cranktrain.viz.sheets.forces.at_crank import crank_torques
from cranktrain.viz.sheets.forces.joints import MOST_CURVES, JointForce, SharedPin, mechanism_of, pins_shared
from cranktrain.viz.sheets.forces.panels import formula_error, has_forces, is_off
from cranktrain.viz.sheets.torque.panels import order_bars, torque_panel


def force_notes(shown: OneDesign, piston: str | None, joints: Sequence[JointForce]) -> Iterator[str]:
    """Sentences on what is shown: first what is left out, last what the lines mean."""
    result = shown.result
    masses = result[LoadedMachine].masses
    if (said := result[LoadedMachine].without_mass()) is not None:
        yield said
    if masses.assumed:
        yield _("Rods without a given inertia have that of two masses at their ends.")
    gas = result.get(GasPressures)
    yield from () if gas is None else gas.flags
    if piston is not None and has_forces(result, piston):
        yield from _on_forces(shown, piston)
    if joints:
        yield from _on_joints(shown, joints, mechanism_of(shown, piston))
    several = any(curve.role == "each" for curve in torque_panel(shown).curves)
    yield (
        _("Torque: reactions of rigid links, each mechanism's thin.")
        if several
        else _("Torque: reactions of rigid links.")
    )
    bars = order_bars(shown)
    if np.any(bars.is_major & (bars.amplitude > 0)):
        yield _("Filled bars: orders in which all cylinders add up.")


def _on_joints(shown: OneDesign, joints: Sequence[JointForce], mechanism: str) -> Iterator[str]:
    """Say which torque goes into the crank, which comes out of it, whose pins are, and which joints have no curve."""
    torques = zip(crank_torques(shown), (mathematics("M_st"), "½J′ω²"), strict=True)
    said = [symbol for torque, symbol in torques if np.any(torque)]
    if said:
        yield _("{symbols}: into the crank; {torque}: out of it, with the opposite sign.").format(
            symbols=", ".join(said), torque=mathematics("T_Σ")
        )
    yield from _on_shared_pins(list(pins_shared(shown, mechanism)))
    if len(joints) > MOST_CURVES:
        yield _("Curves are of the {n} joints that bear most.").format(n=MOST_CURVES)


def _on_shared_pins(pins: Sequence[SharedPin]) -> Iterator[str]:
    """Say whose a pin of several links is taken to be."""
    if len(pins) > 1:
        yield _("Where three links or more meet, the pin is part of the rod of the pair that makes the joint.")
        return
    said = _("{joint} joins {n} links: its pin is part of {owner}, and {others} hang on that.")
    for pin in pins:
        others = _(" and ").join(pin.others)
        yield said.format(joint=pin.joint, n=len(pin.others) + 1, owner=pin.owner, others=others)


def _master_of(result: Result, piston: str) -> str | None:
    """Whose rod a piston's hangs on; None for one that hangs on none."""
    carriers = carriers_of(result.machines[0].places)
    names = [place.name for place in result.machines[0].places]
    master = int(carriers.master[names.index(piston)])
    return names[master] if master >= 0 else None


def _on_forces(shown: OneDesign, piston: str) -> Iterator[str]:
    """Sentences on a piston's forces: whose rod they are of, and by how much the formula is off."""
    master = _master_of(shown.result, piston)
    if master is not None:
        yield _(
            "{piston} hangs on the rod of {master}: {radial}, {tangential} are what the crank pin bears of it."
        ).format(piston=piston, master=master, radial=mathematics("K_i"), tangential=mathematics("T_i"))
        return
    yield _("P, S, N, K, T: by the reactions in the joints, K without the rod's rotating mass.")
    errors = {"N": "side_force_formula_error", "T": "tangential_force_formula_error"}
    said = [
        _("{error} in {symbol}").format(
            error=with_unit(formula_error(shown, piston, name), scale_for("%", 1.0)), symbol=symbol
        )
        for symbol, name in errors.items()
        if is_off(shown, piston, name)
    ]
    if said:
        yield _("f: the textbook's P·f(β), off by up to {errors}.").format(errors=", ".join(said))
