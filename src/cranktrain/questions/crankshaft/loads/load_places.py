"""The crankshafts of a machine, laid out, with all that acts on them at its place."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.frames import Frames
from cranktrain.layout.shaft_loads import LoadsOnShafts
from cranktrain.layout.shafts import AxialPlaces, ShaftCentres, Shafts
from cranktrain.motion import Array
from cranktrain.numerics.designs import by_design
from cranktrain.numerics.ties import first_smallest
from cranktrain.questions.balance.rotating_weights import RotatingWeights
from cranktrain.questions.balance.weights import BalanceWeights
from cranktrain.questions.crankshaft.bending.loads_in_spans import alike_shafts
from cranktrain.questions.crankshaft.bending.shaft_loads import ActingPlaces
from cranktrain.questions.crankshaft.loads.gears import DeclaredGears
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShaft, LoadedShafts, Shares
from cranktrain.questions.crankshaft.shaft_layout import ShaftLayout, ShaftLayouts
from cranktrain.questions.forces.loaded_machine import LoadedMachine

_ON_AXIS = (np.zeros(1), np.zeros(1))
"""Radius and angle of what acts on a journal."""
_ONE_PLACE = 1e-9
"""Shafts whose centres lie nearer are one. [m]"""


def loaded_shafts(
    layouts: ShaftLayouts,
    loaded: LoadedMachine,
    shafts: Shafts,
    frames: Frames,
    axial: AxialPlaces,
    crank_angle: CrankAngle,
    balance: BalanceWeights | None,
    centres: ShaftCentres | None,
    gears: DeclaredGears | None,
    given: LoadsOnShafts | None,
) -> LoadedShafts:
    """Put what acts on the crankshafts to its places; docs/theory/crankshaft, eqs. (24.1) to (24.3)."""
    turn = -1.0 if frames.clockwise else 1.0
    each: list[LoadedShaft] = []
    for layout in layouts.each:
        weights = None if balance is None else _on_shaft(balance.weights, layout, shafts, centres, turn)
        meshes = tuple(
            (number, gear, mesh)
            for number, gear in enumerate(gears.each if gears is not None else ())
            for mesh in gear.meshes
            if mesh.shaft == layout.declared.shaft
        )
        places = _Places(layout)
        rods = places.rods(axial.value, shafts)
        cranks, pins = places.cranks(), places.pins(_have_masses_at_pins(loaded))
        held = places.weights(weights)
        places.on_journals(layout.declared.pulls.z)
        places.on_journals(np.stack([mesh.z for _n, _g, mesh in meshes], axis=1) if meshes else np.zeros((1, 0)))
        together = places.together()
        each.append(
            LoadedShaft(
                layout, weights, together, alike_shafts(layout.shaft, together), rods, cranks, pins, held, meshes
            )
        )
    return LoadedShafts(tuple(each), loaded, frames, shafts, gears, given, crank_angle.zero, turn)


def _have_masses_at_pins(loaded: LoadedMachine) -> NDArray[np.bool_]:
    """Of which mechanisms part of the crank turns at the pin."""
    found = np.zeros(len(loaded.mechanisms.names), dtype=np.bool_)
    for batch, made in zip(loaded.mechanisms.batches, loaded.masses.batches, strict=True):
        found[batch.index] = np.any(made.at_pin != 0, axis=(0, 2))
    return found


def _on_shaft(
    every: RotatingWeights, layout: ShaftLayout, shafts: Shafts, centres: ShaftCentres | None, turn: float
) -> RotatingWeights | None:
    """Weights that turn on a crankshaft itself: as it turns, where its centre is."""
    if layout.declared.shaft == shafts.main:
        centre = np.zeros(1, dtype=np.complex128)
    elif centres is None:
        return None
    else:
        place = centres.value[:, layout.first]
        centre = place.imag - 1j * turn * place.real
    is_own = np.all(
        (every.ratio == layout.turn * turn)
        & (np.abs(every.place - centre[:, np.newaxis]) < _ONE_PLACE)
        & ~np.isnan(every.position),
        axis=0,
    )
    if not np.any(is_own):
        return None
    ratio, moment, angle, z = (part[..., is_own] for part in every[:4])
    return RotatingWeights(ratio, moment, angle, z, every.place[..., is_own])


class _Places:
    """Gathers where loads act on one shaft."""

    def __init__(self, layout: ShaftLayout) -> None:
        self.layout = layout
        self.pieces: list[int] = []
        self.on_web: list[bool] = []
        self.z: list[Array] = []
        self.at: list[tuple[Array, Array]] = []

    def together(self) -> ActingPlaces:
        """All places in order."""
        n_designs = len(self.layout.declared.centres)

        radius, angle = (by_design([place[part] for place in self.at], n_designs) for part in (0, 1))
        pieces, on_web = np.array(self.pieces, dtype=np.intp), np.array(self.on_web, dtype=np.bool_)
        return ActingPlaces(pieces, on_web, by_design(self.z, n_designs), radius, angle)

    def rods(self, along: Array, shafts: Shafts) -> Shares:
        """Rods on pins, beside one another as their banks say."""
        declared, (mechanism, pins) = self.layout.declared, self.layout.rods
        for number, pin in zip(mechanism.tolist(), pins.tolist(), strict=True):
            of_throw = declared.throw == shafts.throw[number]
            aside = along[:, number] - np.mean(declared.centres[:, of_throw], axis=1)
            self._at_pin(pin, declared.centres[:, pin] + aside)
        return Shares(mechanism, declared.share[pins][np.newaxis])

    def _at_pin(self, pin: int, z: Array) -> None:
        piece = int(self.layout.pins[pin])
        pieces = self.layout.shaft.pieces
        self._add(piece, z, (pieces.radius[:, piece], pieces.angle[:, piece]), on_web=False)

    def _at_web(self, pin: int, web: int) -> None:
        """On the middle of one web of a pin."""
        pieces, piece = self.layout.shaft.pieces, int(self.layout.pins[pin])
        place = (pieces.radius[:, piece] / 2, pieces.angle[:, piece])
        self._add(int(self.layout.webs[pin, web]), self.layout.declared.planes[:, pin, web], place, on_web=True)

    def _add(self, piece: int, z: Array, place: tuple[Array, Array], *, on_web: bool) -> None:
        self.pieces.append(piece)
        self.on_web.append(on_web)
        self.z.append(z)
        self.at.append(place)

    def cranks(self) -> Shares:
        """What turns of a mechanism's crank, half on each web, or on the only one."""
        numbers, parts = list[int](), list[float]()
        mechanisms, pins = self.layout.rods
        for number, pin in zip(mechanisms.tolist(), pins.tolist(), strict=True):
            webs = np.flatnonzero(self.layout.webs[pin] >= 0).tolist()
            for web in webs:
                self._at_web(pin, web)
                numbers.append(number)
                parts.append(float(self.layout.declared.share[pin]) / len(webs))
        return Shares(np.array(numbers, dtype=np.intp), np.array(parts)[np.newaxis])

    def pins(self, have_masses: NDArray[np.bool_]) -> Shares:
        """What of a mechanism's crank turns at its pin, in the pin's middle."""
        declared, (mechanism, pin) = self.layout.declared, self.layout.rods
        has_mass = have_masses[mechanism]
        for number in pin[has_mass].tolist():
            self._at_pin(number, declared.centres[:, number])
        return Shares(mechanism[has_mass], declared.share[pin[has_mass]][np.newaxis])

    def weights(self, weights: RotatingWeights | None) -> Shares:
        """Balance weights: between a pin's webs by the lever on both, beyond them on a journal."""
        numbers, parts = list[int](), list[Array]()
        for number, z in enumerate([] if weights is None else weights.position.T):
            for web, part in self._held(z):
                if web is None:
                    self.on_journals(z[:, np.newaxis])
                else:
                    self._at_web(*web)
                numbers.append(number)
                parts.append(part)
        return Shares(np.array(numbers, dtype=np.intp), by_design(parts, len(self.layout.declared.centres)))

    def _held(self, z: Array) -> list[tuple[tuple[int, int] | None, Array]]:
        """Which webs, by pin and side, hold a weight, and which part of it; None for a journal."""
        declared = self.layout.declared
        pin = first_smallest(np.abs(declared.centres[0] - z[0]))
        first, last = declared.planes[:, pin, 0], declared.planes[:, pin, 1]
        half = declared.web_thickness[0, pin] / 2
        is_beyond = not first[0] - half[0] <= z[0] <= last[0] + half[1]
        if is_beyond and declared.journals[self.layout.journal_at(float(z[0]))]:
            return [(None, np.ones_like(z))]
        webs = np.flatnonzero(self.layout.webs[pin] >= 0).tolist()
        if len(webs) == 1:
            return [((pin, webs[0]), np.ones_like(z))]
        lever = (z - first) / (last - first)
        return [((pin, 0), 1 - lever), ((pin, 1), lever)]

    def on_journals(self, z: Array) -> None:
        """On the journals at places, shape (design, n)."""
        for place in z.T:
            self._add(self.layout.piece_at(float(place[0])), place, _ON_AXIS, on_web=False)
