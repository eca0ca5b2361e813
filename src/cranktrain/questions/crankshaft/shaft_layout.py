"""Crankshafts laid out: journals, webs and pins in line, as the machine's mechanisms turn them; and who is on them."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.frames import Frames
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.shafts import Shafts
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import ComplexArray
from cranktrain.questions.crankshaft.bending.equivalent_stiffness import EndSlopes, end_slopes, straight_bending
from cranktrain.questions.crankshaft.metal.pieces_of_throws import ThrowGeometry, pieces_of_throws, webs_of_throws
from cranktrain.questions.crankshaft.metal.sections import Material, round_section, web_section
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft, StraightSpans, Supports
from cranktrain.questions.crankshaft.metal.shoulders import Shoulders, with_shoulders
from cranktrain.questions.crankshaft.parts import DeclaredCrankshaft, DeclaredCrankshafts
from cranktrain.questions.forces.carriers import Carriers
from cranktrain.record import record


class OnPins(NamedTuple):
    """Rods on pins, one of each pair: which mechanism's, and which pin of the shaft, shape (pair,)."""

    mechanism: NDArray[np.intp]
    pin: NDArray[np.intp]


@record
class ShaftLayout:
    """One crankshaft as arrays.

    Attributes
    ----------
    declared : DeclaredCrankshaft
    shaft : Crankshaft
    ends : EndSlopes
        Of all spans.
    pins, journals : array of int, shape (pin,), (pin + 1,)
        Which piece each is, of a journal with shoulders the first; −1 of a journal that there is not.
    webs : array of int, shape (pin, 2)
        From which piece each web of a pin leads on; −1 of a web that there is not.
    rods : OnPins
    first : int
        The mechanism whose pin gives the direction of the axes that turn with the shaft.
    turn : float
        1 where the shaft runs from X toward Y, −1 where it runs clockwise.
    """

    declared: DeclaredCrankshaft
    shaft: Crankshaft
    ends: EndSlopes
    pins: NDArray[np.intp]
    journals: NDArray[np.intp]
    webs: NDArray[np.intp]
    rods: OnPins
    first: int
    turn: float

    @property
    def is_journal(self) -> NDArray[np.bool_]:
        """Which pieces are journals, shape (piece,)."""
        found = np.ones(self.shaft.pieces.radius.shape[1], dtype=np.bool_)
        found[self.pins] = False
        return found

    def journal_at(self, z: float) -> int:
        """Which journal is at a place of the first design, by number from 0."""
        return int(np.sum(self.declared.centres[0] < z))

    def piece_at(self, z: float) -> int:
        """Which piece of a journal is at a place of the first design; at a shoulder that behind it."""
        journal, shoulders = self.journal_at(z), self.declared.shoulders
        return int(self.journals[journal] + np.sum((shoulders.journal == journal) & (shoulders.z[0] <= z)))


@record
class ShaftLayouts:
    """All crankshafts of which the file says so."""

    each: tuple[ShaftLayout, ...]


def with_rods(
    declared: DeclaredCrankshafts | None, shafts: Shafts, mechanisms: Mechanisms, carriers: Carriers
) -> bool | str:
    """Whether on every throw of the declared crankshafts there are rods on a crank pin."""
    if declared is None:
        return DeclaredCrankshafts.needs
    on_crank_pins = have_crank_pins(mechanisms) & (carriers.master < 0)
    for crankshaft in declared.each:
        standing = set(shafts.throw[on_crank_pins & (shafts.shaft == crankshaft.shaft)].tolist())
        if len(standing) < shafts.n_throws[crankshaft.shaft]:
            return N_("a rod on every throw's crank pin")
    return True


def have_crank_pins(mechanisms: Mechanisms) -> NDArray[np.bool_]:
    """Which mechanisms have their rod on a crank pin, shape (mechanism,): valve gears and chains have none."""
    return mechanisms.marked(lambda kind: kind.dynamics.joint("crank_pin") is not None)


def shaft_layouts(
    declared: DeclaredCrankshafts,
    mechanisms: Mechanisms,
    shafts: Shafts,
    frames: Frames,
    carriers: Carriers,
    crank_angle: CrankAngle,
) -> ShaftLayouts:
    """Lay all crankshafts out; docs/theory/crankshaft, eqs. (24.21) to (24.25)."""
    pins, have_pins = pins_at(mechanisms, frames, crank_angle.angle[..., :1])[..., 0], have_crank_pins(mechanisms)
    turn = -1.0 if frames.clockwise else 1.0
    layouts: list[ShaftLayout] = []
    for crankshaft in declared.each:
        carrying = np.flatnonzero((carriers.master < 0) & (shafts.shaft == crankshaft.shaft)).astype(np.intp)
        is_on_pin = shafts.throw[carrying] == crankshaft.throw[:, np.newaxis]
        first = carrying[np.argmax(is_on_pin & have_pins[carrying], axis=1)]
        ahead = direction(pins, turn) - direction(pins[:, first[:1]], turn)
        throws = _throws(crankshaft, np.abs(pins)[:, first], ahead[:, first])
        on_pin, member = np.nonzero(is_on_pin)
        piece = np.full(2 * len(first) + 1, -1, dtype=np.intp)
        shaft, ends, begins = _crankshaft(crankshaft, throws)
        piece[throws.pieces] = begins[:-1]
        webs = _webs(throws)
        layouts.append(
            ShaftLayout(
                crankshaft,
                shaft,
                ends,
                piece[1::2],
                piece[0::2],
                np.where(webs < 0, webs, begins[webs + 1] - 1),
                OnPins(carrying[member], on_pin.astype(np.intp)),
                int(first[0]),
                turn * float(frames.sense[first[0]]),
            )
        )
    return ShaftLayouts(tuple(layouts))


def direction(vector: ComplexArray, turn: float) -> Array:
    """Direction from X toward Y of vectors in the common axes, turned as `main` runs. [rad]"""
    return np.arctan2(vector.real, -turn * vector.imag)


def pins_at(mechanisms: Mechanisms, frames: Frames, angle: Array) -> ComplexArray:
    """Where all crank pins are in the common axes, shape (design, mechanism, n); 0 of a mechanism that has none. [m]"""
    found = np.zeros((len(angle), len(mechanisms.names), angle.shape[-1]), dtype=np.complex128)
    for batch in mechanisms.batches:
        if batch.kind.dynamics.joint("crank_pin") is not None:
            pin = batch.kind.motion(angle + batch.members.phase, batch.members.geometry).pin
            found[:, batch.index] = frames.common(batch.index, pin.x.value, pin.y.value)
    return found


def _throws(declared: DeclaredCrankshaft, radius: Array, angle: Array) -> ThrowGeometry:
    """Where webs and ends are: a shaft ends at what stands outermost on it, and with a pin that hangs over."""
    outer = np.concatenate([declared.bearings, declared.pulls.z, declared.shoulders.z], axis=1)
    half = declared.pin_length / 2
    begin = np.min(outer, axis=1) if declared.journals[0] else (declared.centres - half)[:, 0]
    end = np.max(outer, axis=1) if declared.journals[-1] else (declared.centres + half)[:, -1]
    begin = np.minimum(begin, (declared.planes[..., 0] - declared.web_thickness[..., 0] / 2)[:, 0])
    end = np.maximum(end, (declared.planes[..., 1] + declared.web_thickness[..., 1] / 2)[:, -1])
    return ThrowGeometry(np.stack([begin, end], axis=1), declared.planes, radius, angle, declared.journals)


def _webs(throws: ThrowGeometry) -> NDArray[np.intp]:
    """From which piece both webs of each pin lead on; one from pin to pin is of both."""
    n = throws.radius.shape[1]
    at = np.full(2 * n, -1, dtype=np.intp)
    at[throws.webs] = np.arange(throws.webs.size)
    for pin in range(1, n):
        if at[2 * pin] < 0:
            at[2 * pin] = at[2 * pin - 1]
    return at.reshape(n, 2)


def _crankshaft(declared: DeclaredCrankshaft, throws: ThrowGeometry) -> tuple[Crankshaft, EndSlopes, NDArray[np.intp]]:
    """Put sections and bearings together, say how the ends of its spans turn, and with which piece each begins."""
    material = Material(*(part[:, np.newaxis] for part in declared.material))
    n_designs, n_spans = len(throws.radius), declared.bearings.shape[1] - 1
    webs = web_section(
        declared.web_width, declared.web_thickness, Material(*(part[..., np.newaxis] for part in material))
    )
    journal, pin = declared.journal, declared.pin
    pieces = pieces_of_throws(
        throws,
        round_section(journal[..., 0], journal[..., 1], material),
        round_section(pin[..., 0], pin[..., 1], material),
    )
    shoulders = declared.shoulders
    journal_end = journal[..., 0].copy()
    for number, on in enumerate(shoulders.journal.tolist()):
        journal_end[:, on] = shoulders.size[:, number, 0]
    cut = with_shoulders(
        pieces,
        webs_of_throws(throws, webs, journal[..., 0], pin[..., 0], declared.rule, journal_end),
        Shoulders(
            np.searchsorted(throws.pieces, 2 * shoulders.journal),
            shoulders.z,
            round_section(shoulders.size[..., 0], shoulders.size[..., 1], material),
        ),
    )
    plain = Crankshaft(
        cut.pieces,
        cut.webs,
        Supports(declared.bearings, declared.compliance, declared.settlement, declared.clearance, declared.thrust),
        StraightSpans(*np.full((2, n_designs, n_spans), np.inf)),
    )
    ends = end_slopes(plain)
    bending = straight_bending(plain, ends) if declared.span_bending is None else declared.span_bending
    straight = StraightSpans(bending, plain.straight.shear)
    return plain._replace(straight=straight), ends, cut.first


def pin_names(layout: ShaftLayout, shafts: Shafts) -> list[str]:
    """Names of a shaft's pins: their numbers; with several shafts, `upper.1`."""
    prefix = "" if len(shafts.names) == 1 else f"{shafts.names[layout.declared.shaft]}."
    return [f"{prefix}{pin}" for pin in range(1, layout.pins.size + 1)]
