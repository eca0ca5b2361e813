"""Places: every mechanism of a machine, by name, with its axis, its throw and its geometry."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from cranktrain.engine.specs import BankSpec, ShaftSpec
from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.mechanisms import Kind, MechanismSpec, kind_of
from cranktrain.mechanisms.kind import Master, mirrored


@dataclass(frozen=True)
class Place:
    """One mechanism of a machine.

    Attributes
    ----------
    name, bank : str
        `2L`, and its bank `L`.
    shaft : str
        The shaft that it works on.
    throw : int
        Which throw of the shaft, from 0.
    sense : float
        +1 where its crank turns in the machine's normal sense, −1 where it turns against it: astern, or on a shaft that
        is geared the other way.
    stagger : float
        Of its bank along the shaft, toward the flywheel. [m]
    axis : float
        Direction of the mechanism's x from the first bank's, in the sense of its crank. [rad]
    throw_angle : float
        Of its throw at φ = 0, ahead of where throw 1 of the main shaft stands, in the sense of its crank. [rad]
    phase : float
        Angle of the kernel's crank where φ is 0; a slave's kernel counts from its master's axis. [rad]
    kind : Kind
    spec : MechanismSpec
    geometry : NamedTuple of floats
        Mirrored where its crank turns against the normal sense.
    path : str
        Of the mechanism's table in the machine file.
    lists : mapping of str to str
        Fields of that table which are lists there, and the place in them, `[3]`, that is this mechanism's.
    """

    name: str
    bank: str
    shaft: str
    throw: int
    sense: float
    stagger: float
    axis: float
    throw_angle: float
    phase: float
    kind: Kind
    spec: MechanismSpec
    geometry: Any
    path: str
    lists: Mapping[str, str]

    def path_of(self, field: str) -> str:
        """Path of one of its fields in the machine file."""
        return f"{self.path}.{field}{self.lists.get(field, '')}"

    @property
    def nominal_top(self) -> float:
        """φ at which the crank points along the mechanism's x. [rad]"""
        return self.axis - self.throw_angle


@dataclass(frozen=True)
class _Slot:
    """A place before its geometry is known: bank and throw by index, angle of its axis from Y in the file's sense."""

    name: str
    bank: str
    shaft: str
    throw: int
    stagger: float
    angle: float
    spec: MechanismSpec
    path: str
    lists: Mapping[str, str]


def places_of(
    shafts: Mapping[str, ShaftSpec], banks: Mapping[str, BankSpec], *, astern: bool, prefix: str = "bank."
) -> tuple[tuple[Place, ...], tuple[Problem, ...]]:
    """Arrange a machine's mechanisms.

    Parameters
    ----------
    shafts : mapping of name to ShaftSpec
    banks : mapping of name to BankSpec
        One bank of any name gives places `1`, `2`, …; more give `1L`, `2L`, …
    astern : bool
        The same metal at −φ: all that counts in the sense of rotation or toward +y is mirrored.
    prefix : str
        Of the banks' paths in the file; empty for a bare `[mechanism]`.

    Returns
    -------
    tuple of Place, tuple of Problem
        Places in the order of the file. With problems, no places.
    """
    slots, problems = _slots(shafts, banks, prefix)
    if problems:
        return (), problems
    places: list[Place] = []
    for slot in slots:
        master = _master_of(slot, slots)
        if isinstance(master, Problem):
            problems = (*problems, master)
            continue
        kind = kind_of(slot.spec)
        hung = None
        if master is not None:
            master_kind = kind_of(master.spec)
            hung = Master(master_kind.geometry(master.spec, None), slot.angle - master.angle)
        geometry = kind.geometry(slot.spec, hung)
        kernel_axis = (master or slot).angle - slots[0].angle
        shaft = shafts[slot.shaft]
        throw_angle = shaft.phase.si + shaft.throws[slot.throw].si - shaft.throws[0].si
        # A crank that turns the other way is the same metal seen with y reversed, at the same φ.
        sense = -float(shaft.ratio) if astern else float(shaft.ratio)
        places.append(
            Place(
                name=slot.name,
                bank=slot.bank,
                shaft=slot.shaft,
                throw=slot.throw,
                sense=sense,
                stagger=slot.stagger,
                axis=sense * (slot.angle - slots[0].angle),
                throw_angle=sense * throw_angle,
                phase=sense * (throw_angle - kernel_axis),
                kind=kind,
                spec=slot.spec,
                geometry=mirrored(geometry) if sense < 0 else geometry,
                path=slot.path,
                lists=slot.lists,
            )
        )
    return (() if problems else tuple(places)), tuple(dict.fromkeys(problems))


def _slots(
    shafts: Mapping[str, ShaftSpec], banks: Mapping[str, BankSpec], prefix: str
) -> tuple[tuple[_Slot, ...], tuple[Problem, ...]]:
    """Name every place, throw by throw through the bank's angles; problems where a throw does not exist."""
    slots: list[_Slot] = []
    problems: list[Problem] = []
    for bank, spec in banks.items():
        path = f"{prefix}{bank}." if prefix else ""
        if spec.shaft not in shafts:
            allowed = _("must be one of the shafts: {shafts}").format(shafts=", ".join(shafts))
            problems.append(Problem(f"{path}shaft", spec.shaft, allowed))
            continue
        n_throws = len(shafts[spec.shaft].throws)
        throws = spec.throws or tuple(range(1, n_throws + 1))
        allowed = _("must be one of the shaft's throws, 1 to {n}, each once").format(n=n_throws)
        problems += [
            Problem(f"{path}throws[{i}]", str(throw), allowed)
            for i, throw in enumerate(throws)
            if not 1 <= throw <= n_throws or throw in throws[:i]
        ]
        suffix = bank if len(banks) > 1 else ""
        lists = _lists(spec)
        pairs = [(throw, k) for throw in throws for k in range(len(spec.angle))]
        slots += [
            _Slot(
                name=f"{number}{suffix}",
                bank=bank,
                shaft=spec.shaft,
                throw=throw - 1,
                stagger=spec.stagger.si,
                angle=spec.angle[k].si,
                spec=spec.mechanism[k],
                path=f"{path}mechanism",
                lists=dict.fromkeys(lists, f"[{k}]"),
            )
            for number, (throw, k) in enumerate(pairs, start=1)
        ]
    return tuple(slots), tuple(problems)


def _lists(spec: BankSpec) -> tuple[str, ...]:
    """Fields of the bank's mechanism that differ from one angle to another, and so are lists in the file."""
    first = spec.mechanism[0]
    return tuple(
        field
        for field in type(first).model_fields
        if any(getattr(other, field, None) != getattr(first, field) for other in spec.mechanism)
    )


def _master_of(slot: _Slot, slots: Sequence[_Slot]) -> _Slot | Problem | None:
    """Find the slider-crank on the same throw that a slave hangs on; None for a mechanism that needs none."""
    spec = slot.spec
    field = spec.master_field
    if field is None:
        return None
    name = getattr(spec, field)
    path = f"{slot.path}.{field}{slot.lists.get(field, '')}"
    in_bank = [other for other in slots if other.bank == name]
    if not in_bank:
        banks = ", ".join(dict.fromkeys(other.bank for other in slots if other.bank != slot.bank and other.bank))
        allowed = _("must be the name of a bank of slider-cranks, but there is no other bank")
        if banks:
            allowed = _("must be the name of a bank of slider-cranks; the other banks are: {banks}").format(banks=banks)
        return Problem(path, name, allowed)
    masters = [other for other in in_bank if other.spec.kind == "slider_crank"]
    if not masters:
        return Problem(path, name, _("must be a bank of slider-cranks; a slave rod cannot carry another"))
    on_throw = [other for other in masters if (other.shaft, other.throw) == (slot.shaft, slot.throw)]
    if len(on_throw) != 1:
        allowed = _("must have one slider-crank on throw {throw}, where this rod is; it has {n}")
        return Problem(path, name, allowed.format(throw=slot.throw + 1, n=len(on_throw)))
    return on_throw[0]
