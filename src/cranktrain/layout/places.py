"""Places: every mechanism of a machine, by name, with its axis, its throw and its geometry."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from cranktrain.errors import UNREAD, Problem, UnreadError
from cranktrain.language import _
from cranktrain.layout.gearing import first_axis, lead_problems, opposed_angle, shaft_phases
from cranktrain.layout.specs import BankSpec, OpposedPistonSpec, ShaftSpec, throws_of
from cranktrain.mechanisms import MechanismSpec, kind_of
from cranktrain.mechanisms.kind import AnyGeometry, AnyKind, mirrored
from cranktrain.mechanisms.spec import Master
from cranktrain.motion import Array, plain, single
from cranktrain.numerics.nested import each_changed
from cranktrain.record import record


@record
class _Slot:
    """Where a mechanism works, before its geometry is known.

    Attributes
    ----------
    name, cylinder, bank : str
        `2L`, in cylinder `2L` of bank `L`; of opposed pistons `2L.exhaust`, in cylinder `2L`.
    is_far : bool
        Whether its piston bounds the cylinder from the far side, driven by side rods.
    shaft : str
        The shaft that it works on.
    throw : int
        Which throw of the shaft, from 0.
    stagger : Array
        Of its bank along the shaft, toward the flywheel. [m]
    file_axis : Array
        Direction of the mechanism's x from Y, in the file's sense. [rad]
    spec : MechanismSpec
    path : str
        Of the mechanism's table in the machine file.
    lists : mapping of str to str
        Fields of that table which are lists there, and the place in them, `[3]`, that is this mechanism's.
    """

    name: str
    cylinder: str
    bank: str
    is_far: bool
    shaft: str
    throw: int
    stagger: Array
    file_axis: Array
    spec: MechanismSpec
    path: str
    lists: Mapping[str, str]

    def path_of(self, field: str) -> str:
        """Path of one of its fields in the machine file."""
        return f"{self.path}.{field}{self.lists.get(field, '')}"


@record
class PlacedMechanism(_Slot):
    """One mechanism of a machine: where it works, and how it stands there.

    Attributes
    ----------
    sense : float
        +1 where its crank turns in the machine's normal sense, −1 where it turns against it: astern, or on a shaft that
        is geared the other way.
    axis : Array
        Direction of the mechanism's x from the first bank's, in the sense of its crank. [rad]
    throw_angle : Array
        Of its throw at φ = 0, ahead of where throw 1 of the main shaft stands, in the sense of its crank. [rad]
    phase : Array
        Angle of the kernel's crank where φ is 0; a slave's kernel counts from its master's axis. [rad]
    kind : Kind
    geometry : NamedTuple of numbers
        Mirrored where its crank turns against the normal sense.

    Notes
    -----
    Numbers of one machine; of several designs laid out together they are arrays of shape (design,), or one number where
    all have the same.
    """

    sense: float
    axis: Array
    throw_angle: Array
    phase: Array
    kind: AnyKind
    geometry: AnyGeometry

    @property
    def nominal_top(self) -> Array:
        """φ at which the crank points along the mechanism's x. [rad]"""
        return self.axis - self.throw_angle

    @property
    def inner_dead_centre(self) -> Array:
        """φ at which the crank lies along the cylinder, its piston innermost: of a far piston it points away. [rad]"""
        return self.nominal_top + np.pi if self.is_far else self.nominal_top


def places_of(
    shafts: Mapping[str, ShaftSpec], banks: Mapping[str, BankSpec], *, astern: bool
) -> tuple[tuple[PlacedMechanism, ...], tuple[Problem, ...]]:
    """Arrange a machine's mechanisms.

    Parameters
    ----------
    shafts : mapping of name to ShaftSpec
    banks : mapping of name to BankSpec
        One bank of any name gives places `1`, `2`, …; more give `1L`, `2L`, …; opposed pistons `1.exhaust`, …. The bank
        of a bare `[mechanism]` has no name.
    astern : bool
        The same metal at −φ: all that counts in the sense of rotation or toward +y is mirrored.

    Returns
    -------
    tuple of PlacedMechanism, tuple of Problem
        Places in the order of the file. With problems, no places.
    """
    slots, problems = _slots(shafts, banks)
    if problems:
        return (), problems
    phases, problems = shaft_phases(shafts, banks)
    problems = problems or tuple(lead_problems(shafts, banks))
    first = first_axis(banks)
    metal = _Metal(slots)
    places: list[PlacedMechanism] = []
    for slot in slots:
        master = _master_of(slot, slots, metal)
        if isinstance(master, Problem):
            problems = (*problems, master)
            continue
        kernel_axis = (master or slot).file_axis - first
        shaft = shafts[slot.shaft]
        throw_angle = phases[slot.shaft] + shaft.throws[slot.throw].array - shaft.throws[0].array
        # A crank that turns the other way is the same metal seen with y reversed, at the same φ.
        sense = -float(shaft.ratio) if astern else float(shaft.ratio)
        places.append(
            PlacedMechanism(
                **vars(slot),
                sense=sense,
                axis=sense * (slot.file_axis - first),
                throw_angle=sense * throw_angle,
                phase=sense * (throw_angle - kernel_axis),
                kind=metal.kind(slot),
                geometry=metal.geometry(slot, master, is_mirrored=sense < 0),
            )
        )
    return (() if problems else tuple(places)), tuple(dict.fromkeys(problems))


def with_table(place: PlacedMechanism, spec: MechanismSpec, places: Sequence[PlacedMechanism]) -> PlacedMechanism:
    """Give a mechanism where it stands with another table; those that it may hang on are among some places."""
    slot = replace(place, spec=spec)
    metal = _Metal((slot, *places))
    master = _master_of(slot, places, metal)
    geometry = UNREAD if isinstance(master, Problem) else metal.geometry(slot, master, is_mirrored=place.sense < 0)
    return replace(slot, geometry=geometry)


class _Metal:
    """What mechanisms are made of, found once for those that stand alike on other throws."""

    def __init__(self, slots: Sequence[_Slot]) -> None:
        specs = {id(slot.spec): slot.spec for slot in slots}
        self._kinds = {key: kind_of(spec) for key, spec in specs.items()}
        self._geometries: dict[object, AnyGeometry] = {}

    def kind(self, slot: _Slot) -> AnyKind:
        """Give the kind of a mechanism."""
        return self._kinds[id(slot.spec)]

    def geometry(self, slot: _Slot, master: _Slot | None, *, is_mirrored: bool) -> AnyGeometry:
        """Give the geometry of a mechanism, which may hang on a master."""
        hangs = () if master is None else (id(master.spec), np.asarray(slot.file_axis - master.file_axis).tobytes())
        key = (id(slot.spec), hangs, is_mirrored)
        if key not in self._geometries:
            try:
                geometry = self._found(slot, master)
            except UnreadError:  # it has its place all the same
                return UNREAD
            self._geometries[key] = mirrored(geometry) if is_mirrored else geometry
        return self._geometries[key]

    def _found(self, slot: _Slot, master: _Slot | None) -> AnyGeometry:
        """Find the geometry of a mechanism that turns in the machine's normal sense."""
        hung = None
        if master is not None:
            hung = Master(self.kind(master).geometry(master.spec, None), slot.file_axis - master.file_axis)
        return each_changed(_plain, self.kind(slot).geometry(slot.spec, hung))


def _plain(value: Array) -> Array:
    """Take what is one number as a number, so that geometries can be compared."""
    return value if getattr(value, "ndim", 0) else single(plain(value))


def _slots(
    shafts: Mapping[str, ShaftSpec], banks: Mapping[str, BankSpec]
) -> tuple[tuple[_Slot, ...], tuple[Problem, ...]]:
    """Name every place, bank by bank; problems where a shaft or throw does not exist."""
    slots: list[_Slot] = []
    problems: list[Problem] = []
    for bank, spec in banks.items():
        home = f"bank.{bank}." if bank else ""
        suffix = bank if len(banks) > 1 else ""
        numbers: dict[str, int] = {}
        for end, side in spec.sides.items():
            path = f"{home}{end}." if end else home
            throws, wrong = _throws(shafts, side, path)
            problems += wrong
            numbers[end] = len(throws)
            slots += [
                _Slot(
                    name=f"{number}{suffix}.{end}" if end else f"{number}{suffix}",
                    cylinder=f"{number}{suffix}",
                    bank=bank,
                    is_far=end in spec.opposed and spec.opposed[end].side_rods,
                    shaft=side.shaft,
                    throw=throw - 1,
                    stagger=spec.stagger.array,
                    file_axis=axis,
                    spec=mechanism,
                    path=f"{path}mechanism",
                    lists=lists,
                )
                for number, (throw, (mechanism, axis, lists)) in enumerate(product(throws, _mechanisms(spec, end)), 1)
            ]
        if not problems and len(set(numbers.values())) > 1:
            allowed = _("must be as many as the exhaust pistons have, {n}: two pistons share a cylinder")
            problems.append(
                Problem(f"{home}scavenge.throws", str(numbers["scavenge"]), allowed.format(n=numbers["exhaust"]))
            )
    return tuple(slots), tuple(problems)


def _throws(
    shafts: Mapping[str, ShaftSpec], side: BankSpec | OpposedPistonSpec, path: str
) -> tuple[Sequence[int], list[Problem]]:
    """Throws on which pistons work, counted from 1: those given, or all of the shaft."""
    if side.shaft not in shafts:
        allowed = _("must be one of the shafts: {shafts}", shafts=", ".join(shafts))
        return (), [Problem(f"{path}shaft", side.shaft, allowed)]
    n_throws = len(shafts[side.shaft].throws)
    throws = throws_of(side, shafts)
    allowed = _("must be one of the shaft's throws, 1 to {n}, each once", n=n_throws)
    return throws, [
        Problem(f"{path}throws[{i}]", str(throw), allowed)
        for i, throw in enumerate(throws)
        if not 1 <= throw <= n_throws or throw in throws[:i]
    ]


def _mechanisms(bank: BankSpec, end: str) -> list[tuple[MechanismSpec, Array, dict[str, str]]]:
    """Mechanisms on each throw, with their axes from Y [rad], and their places in what are lists in the file."""
    if end:
        return [(bank.opposed[end].mechanism, opposed_angle(bank, end), {})]
    first = bank.mechanism[0]
    lists = [
        field
        for field in type(first).model_fields
        if any(getattr(other, field, None) != getattr(first, field) for other in bank.mechanism[1:])
    ]
    return [
        (mechanism, angle.array, dict.fromkeys(lists, f"[{k}]"))
        for k, (mechanism, angle) in enumerate(zip(bank.mechanism, bank.angle, strict=True))
    ]


def _master_of(slot: _Slot, slots: Sequence[_Slot], metal: _Metal) -> _Slot | Problem | None:
    """Find the slider-crank on the same throw that a slave hangs on; None for a mechanism that needs none."""
    spec = slot.spec
    field = spec.master_field
    if field is None:
        return None
    name = getattr(spec, field)
    path = slot.path_of(field)
    in_bank = [other for other in slots if other.bank == name]
    if not in_bank:
        banks = ", ".join(dict.fromkeys(other.bank for other in slots if other.bank != slot.bank and other.bank))
        allowed = (
            _("must be the name of a bank of slider-cranks; the other banks are: {banks}", banks=banks)
            if banks
            else _("must be the name of a bank of slider-cranks, but there is no other bank")
        )
        return Problem(path, name, allowed)
    masters = [other for other in in_bank if metal.kind(other).is_direct]
    if not masters:
        return Problem(path, name, _("must be a bank of slider-cranks; a slave rod cannot carry another"))
    on_throw = [other for other in masters if (other.shaft, other.throw) == (slot.shaft, slot.throw)]
    if len(on_throw) != 1:
        allowed = _("must have one slider-crank on throw {throw}, where this rod is; it has {n}")
        return Problem(path, name, allowed.format(throw=slot.throw + 1, n=len(on_throw)))
    return on_throw[0]
