"""The sheet of forces: gas, the forces of a piston, torque and its orders, and what they rest on."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import Listed, Words, _
from cranktrain.panels.design import OneDesign
from cranktrain.panels.formulas import mathematics
from cranktrain.panels.parts import BarChart, CurveCard, Notes, Part, Polars, Sheet, SheetColumn, Stack, sheet_of
from cranktrain.panels.shapes import Bars
from cranktrain.panels.sheets.forces.at_crank import crank_panels, crank_torques
from cranktrain.panels.sheets.forces.joints import (
    MOST_CURVES,
    JointForce,
    SharedPin,
    joint_diagrams,
    joint_forces,
    joint_panels,
    joint_table,
    mechanism_of,
    pins_shared,
)
from cranktrain.panels.sheets.forces.panels import force_panels, formula_error, has_forces, is_off
from cranktrain.panels.sheets.gas.panels import indicator_panel
from cranktrain.panels.sheets.torque.panels import largest_stars, order_bars, torque_panel
from cranktrain.questions.forces.carriers import carriers_of
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.gas.pressures import GasPressures, PeakPressures
from cranktrain.saying.amounts import Amount
from cranktrain.saying.wording import all_of

_LEAST_POLAR = 46.0
"""Height of the polar diagrams with their words over a table of many joints. [mm]"""


def sheet_forces(result: Result, *, piston: str | None = None, design: int = 0) -> Sheet:
    """Collect the forces of a machine.

    Parameters
    ----------
    result : Result
        Of a machine with a speed, and masses or gas.
    piston : str, optional
        Whose forces; the first with a rod unless given.
    design : int
        Which of the result's machines.

    Returns
    -------
    Sheet

    Raises
    ------
    InputError
        If the result has no forces, or no such piston.
    """
    shown = OneDesign(result, design)
    name = _piston(result, piston)
    has_own = name is not None and has_forces(result, name)
    joints = [] if has_own else joint_forces(shown, mechanism_of(shown, name))
    own = [*joint_panels(shown, joints), *crank_panels(shown)] if joints else []
    left = Stack((*own, *force_panels(result, name, design)))
    right = tuple(_beside(shown, name, joints))
    return sheet_of(result, design, _("Forces"), SheetColumn(0.55, (left,)), SheetColumn(0.45, right))


def _beside(shown: OneDesign, piston: str | None, joints: Sequence[JointForce]) -> Iterator[Part]:
    """The gas over its volume, reactions in joints, orders of the torque, stars, and what all rest on."""
    if piston is not None and shown.has("gas_pressure") and shown.has("chamber_volume"):
        yield CurveCard((indicator_panel(shown, piston),), height=0.36)
    if joints:
        yield Polars(joint_diagrams(shown, joints), height=0.39, least=_LEAST_POLAR)
        yield joint_table(shown, joints)
    bars = order_bars(shown)
    yield BarChart(bars, height=0.28)
    stars = largest_stars(shown, bars)
    if stars is not None:
        yield stars
    yield Notes(tuple(_force_notes(shown, piston, joints, bars)), can_go_on=True)


def _piston(result: Result, wanted: str | None) -> str | None:
    """Find the piston: one that is named, else the first that has forces of its own."""
    names = result.labels.get("piston", ())
    if wanted is not None and wanted not in names:
        allowed = _("must be one of this machine's pistons: {names}", names=", ".join(names) or _("none"))
        raise InputError([Problem("--mechanism", wanted, allowed)])
    if wanted is not None or "piston_force" not in result.catalogue:
        return wanted or next(iter(names), None)
    return next((name for name in names if has_forces(result, name)), next(iter(names), None))


def _force_notes(shown: OneDesign, piston: str | None, joints: Sequence[JointForce], bars: Bars) -> Iterator[Words]:
    """Sentences on what is shown: first what is left out, last what the lines mean."""
    result = shown.result
    masses = result[LoadedMachine].masses
    if (said := result[LoadedMachine].without_mass()) is not None:
        yield said
    if masses.assumed:
        yield _("Rods without a given inertia have that of two masses at their ends.")
    for gas in (result.get(GasPressures), result.get(PeakPressures)):
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
    if np.any(bars.is_filled & (bars.high > 0)):
        yield _("Filled bars: orders in which all cylinders add up.")


def _on_joints(shown: OneDesign, joints: Sequence[JointForce], mechanism: str) -> Iterator[Words]:
    """Say which torque goes into the crank, which comes out of it, whose pins are, and which joints have no curve."""
    torques = zip(crank_torques(shown), (mathematics("M_st"), "½J′ω²"), strict=True)
    said = [symbol for torque, symbol in torques if np.any(torque)]
    if said:
        yield _(
            "{symbols}: into the crank; {torque}: out of it, with the opposite sign.",
            symbols=Listed(said),
            torque=mathematics("T_Σ"),
        )
    yield from _on_shared_pins(list(pins_shared(shown, mechanism)))
    if len(joints) > MOST_CURVES:
        yield _("Curves are of the {n} joints that bear most.", n=MOST_CURVES)


def _on_shared_pins(pins: Sequence[SharedPin]) -> Iterator[Words]:
    """Say whose a pin of several links is taken to be."""
    if len(pins) > 1:
        yield _("Where three links or more meet, the pin is part of the rod of the pair that makes the joint.")
        return
    said = _("{joint} joins {n} links: its pin is part of {owner}, and {others} hang on that.")
    for pin in pins:
        others = all_of(pin.others)
        yield said.format(joint=pin.joint, n=len(pin.others) + 1, owner=pin.owner, others=others)


def _master_of(result: Result, piston: str) -> str | None:
    """Whose rod a piston's hangs on; None for one that hangs on none."""
    carriers = carriers_of(result.machines[0].places)
    names = [place.name for place in result.machines[0].places]
    master = int(carriers.master[names.index(piston)])
    return names[master] if master >= 0 else None


def _on_forces(shown: OneDesign, piston: str) -> Iterator[Words]:
    """Sentences on a piston's forces: whose rod they are of, and by how much the formula is off."""
    master = _master_of(shown.result, piston)
    if master is not None:
        yield _(
            "{piston} hangs on the rod of {master}: {radial}, {tangential} are what the crank pin bears of it.",
            piston=piston,
            master=master,
            radial=mathematics("K_i"),
            tangential=mathematics("T_i"),
        )
        return
    yield _("P, S, N, K, T: by the reactions in the joints, K without the rod's rotating mass.")
    errors = {"N": "side_force_formula_error", "T": "tangential_force_formula_error"}
    said = [
        _(
            "{error} in {symbol}",
            error=Amount(formula_error(shown, piston, name), "%"),
            symbol=symbol,
        )
        for symbol, name in errors.items()
        if is_off(shown, piston, name)
    ]
    if said:
        yield _("f: the textbook's P·f(β), off by up to {errors}.", errors=Listed(said))
