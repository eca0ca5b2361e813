"""The crankshaft of a machine as arrays, with all that acts on it."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.layout.axial import AxialPlaces
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.frames import Frames
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.shafts import Shafts
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import phasor
from cranktrain.questions.balance.rotating_weights import RotatingWeights, on_crank
from cranktrain.questions.balance.weights import BalanceWeights
from cranktrain.questions.crankshaft.acting import (
    LoadedShaft,
    acting_places,
    direction,
    nearest_throw,
    of_mechanisms,
)
from cranktrain.questions.crankshaft.equivalent_stiffness import equivalent_stiffness
from cranktrain.questions.crankshaft.parts import DeclaredCrankshaft
from cranktrain.questions.crankshaft.sections import Material, round_section, web_section
from cranktrain.questions.crankshaft.shaft import Crankshaft, StraightSpans, Supports
from cranktrain.questions.crankshaft.throw_line import ThrowGeometry, pieces_of_throws, webs_of_throws
from cranktrain.questions.forces.carriers import Carriers
from cranktrain.questions.forces.loaded_machine import LoadedMachine


def of_one_shaft(
    declared: DeclaredCrankshaft | None, shafts: Shafts, mechanisms: Mechanisms, carriers: Carriers
) -> bool | str:
    """Whether the machine has one crankshaft, and on every throw of it rods on a crank pin."""
    if declared is None:
        return DeclaredCrankshaft.needs
    if len(shafts.names) > 1:
        return N_("one crankshaft")
    have_pins = mechanisms.marked(lambda kind: kind.dynamics.joint("crank_pin") is not None)
    if not np.all(have_pins | (carriers.master >= 0)):
        return N_("rods on crank pins")
    standing = set(shafts.throw[carriers.master < 0].tolist())
    if len(standing) < shafts.n_throws[0] or np.any(np.diff(declared.centres) <= 0):
        return N_("a rod on every throw, and throws that stand apart")
    return True


def loaded_shaft(
    declared: DeclaredCrankshaft,
    loaded: LoadedMachine,
    shafts: Shafts,
    frames: Frames,
    axial: AxialPlaces,
    carriers: Carriers,
    crank_angle: CrankAngle,
    balance: BalanceWeights | None,
) -> LoadedShaft:
    """Lay the shaft out: journals, pins and webs in line, bearings between the throws."""
    carrying = np.flatnonzero(carriers.master < 0).astype(np.intp)
    throw = shafts.throw[carrying]
    turn = -1.0 if frames.clockwise else 1.0
    pins = of_mechanisms(loaded, frames, loaded.solved(crank_angle.angle[..., :1])).pin[:, carrying, 0]
    first = [int(np.flatnonzero(throw == n)[0]) for n in range(shafts.n_throws[0])]
    ahead = direction(pins, turn) - direction(pins[:, :1], turn)
    away = (declared.pin_length + declared.web_thickness) / 2
    planes = declared.centres[..., np.newaxis] + away[:, np.newaxis, np.newaxis] * np.array([-1.0, 1.0])
    shaft = _shaft(declared, planes, np.abs(pins)[:, first], ahead[:, first])
    weights, at = _on_crankshaft(balance, declared.centres)
    places = acting_places(shaft, planes, throw, axial.value[:, carrying], at)
    lever = np.zeros((len(planes), 0))
    if weights is not None:
        lever = (weights.position - planes[:, at, 0]) / (planes[:, at, 1] - planes[:, at, 0])
    return LoadedShaft(shaft, loaded, frames, carrying, weights, places, lever, turn)


def _on_crankshaft(balance: BalanceWeights | None, centres: Array) -> tuple[RotatingWeights | None, NDArray[np.intp]]:
    """Weights that turn on the crankshaft itself, and the throws whose webs carry them."""
    if balance is not None:
        every = balance.weights
        is_own = np.all((every.ratio == 1.0) & (every.place == 0.0), axis=0)
        if np.any(is_own):
            moment, angle, z = (part[:, is_own] for part in (every.moment, every.angle, every.position))
            return on_crank(moment * phasor(angle), z), nearest_throw(centres, z)
    return None, np.empty(0, dtype=np.intp)


def _shaft(declared: DeclaredCrankshaft, planes: Array, radius: Array, angle: Array) -> Crankshaft:
    """Put sections together."""
    n_designs, n_throws = radius.shape
    material = Material(*(part[:, np.newaxis] for part in declared.material))

    def each(value: Array, n: int) -> Array:
        return np.repeat(value[:, np.newaxis], n, axis=1)

    journal, hollow = (each(value, n_throws + 1) for value in declared.journal.T)
    pin, drilled = (each(value, n_throws) for value in declared.pin.T)
    width, thickness = (
        np.repeat(each(value, n_throws)[..., np.newaxis], 2, axis=2)
        for value in (declared.web_width, declared.web_thickness)
    )
    throws = ThrowGeometry(declared.bearings[:, [0, -1]], planes, radius, angle)
    webs = web_section(width, thickness, Material(*(part[..., np.newaxis] for part in material)))
    n_bearings = n_throws + 1
    supports = Supports(
        declared.bearings,
        each(declared.compliance, n_bearings)[..., np.newaxis, np.newaxis] * np.eye(2),
        np.zeros((n_designs, n_bearings, 2)),
        each(declared.clearance, n_bearings),
    )
    plain = Crankshaft(
        pieces_of_throws(throws, round_section(journal, hollow, material), round_section(pin, drilled, material)),
        webs_of_throws(webs, journal, pin, declared.rule),
        supports,
        StraightSpans(*np.full((2, n_designs, n_throws), np.inf)),
    )
    return plain._replace(straight=StraightSpans(_straight(plain, n_throws), plain.straight.shear))


def _straight(shaft: Crankshaft, n_throws: int) -> Array:
    """EI of a straight beam in place of each throw: under a constant moment, the mean of both directions. [N·m²]"""
    each: Sequence[Array] = [
        np.mean(equivalent_stiffness(shaft, span, 2 * span + 1).constant_moment, axis=-1) for span in range(n_throws)
    ]
    return np.stack(each, axis=1)
