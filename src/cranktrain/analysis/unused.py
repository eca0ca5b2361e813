"""Tables of a machine file that are written and not used, with what is missing for them, so that no result misleads."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

from cranktrain.language import N_, _
from cranktrain.machine import Machine
from cranktrain.questions.balance.shaking import ShakingForces
from cranktrain.questions.balance.weights import BalanceWeights
from cranktrain.questions.cylinders.firing import Firing
from cranktrain.questions.cylinders.ports import PortTiming
from cranktrain.questions.cylinders.volumes import ChamberVolumes, SweptVolumes
from cranktrain.questions.evenness.flywheel import FlywheelSize, RimSize
from cranktrain.questions.evenness.load_curve import LoadTorque
from cranktrain.questions.evenness.running_speed import RunningSpeed, ShaftWork
from cranktrain.questions.forces.guides import GuideEdges
from cranktrain.questions.forces.loaded import MechanismTorques
from cranktrain.questions.gas.powers import BrakePowers
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.record import record
from cranktrain.spec import Spec


@record
class Unused:
    """A table of the machine file that no result rests on.

    Attributes
    ----------
    table : str
        As the file has it: "[gas]".
    needs : tuple of str
        What the file would have to say, too.
    consequence : str
        What the results are without it, as a clause; empty where none speaks of it.
    """

    table: str
    needs: tuple[str, ...]
    consequence: str


def sentences(found: Sequence[Unused]) -> list[str]:
    """Say what is not used, and why; tables that lack the same in one sentence."""
    alike: dict[tuple[tuple[str, ...], str], list[str]] = {}
    for one in found:
        alike.setdefault((one.needs, one.consequence), []).append(one.table)
    return [_sentence(tables, needs, consequence) for (needs, consequence), tables in alike.items()]


def _sentence(tables: Sequence[str], needs: Sequence[str], consequence: str) -> str:
    """Say it of some tables."""
    one, more = N_("{tables} is not used: {missing}"), N_("{tables} are not used: {missing}")
    is_one, are_more = N_("{needs} is missing"), N_("{needs} are missing")
    missing = _(is_one if len(needs) == 1 else are_more).format(needs=_listed(needs))
    said = _(one if len(tables) == 1 else more).format(tables=_listed(tables), missing=missing)
    return _("{said}; {consequence}.").format(said=said, consequence=consequence) if consequence else f"{said}."


def _listed(names: Sequence[str]) -> str:
    """Give names as a list in words: `a, b and c`."""
    *first, last = names
    return _("{first} and {last}").format(first=", ".join(first), last=last) if first else last


class Use(NamedTuple):
    """What a table is for: the names that it has in a file, the results that show that it is used, and the clause.

    The clause holds where `instead` is a result.
    """

    tables: Callable[[Machine], Sequence[str]]
    results: tuple[type, ...]
    instead: type | None = None
    consequence: str = ""


def _table(name: str) -> Callable[[Machine], Sequence[str]]:
    """A table of the file that is one thing."""

    def written(machine: Machine) -> Sequence[str]:
        return [f"[{name}]"] if getattr(machine, name) else []

    return written


def _masses(machine: Machine) -> Sequence[str]:
    return [f"[{path}]" for path in machine.weighed.bodies]


def _guides(machine: Machine) -> Sequence[str]:
    return [f"[{path}]" for path in machine.weighed.guides]


def _gravity(machine: Machine) -> Sequence[str]:
    return ["gravity"] if machine.gravity else []


def _evenness(*names: str, is_table: bool = False) -> Callable[[Machine], Sequence[str]]:
    """Keys, or tables, of [evenness]."""

    def written(machine: Machine) -> Sequence[str]:
        spec = machine.evenness
        given = [] if spec is None else [name for name in names if name in spec.model_fields_set]
        return [f"[evenness.{name}]" if is_table else f"[evenness] {name}" for name in given]

    return written


def _cylinder(*names: str) -> Callable[[Machine], Sequence[str]]:
    """Keys of [cylinder], or of the tables of single banks and cylinders in it."""

    def written(machine: Machine) -> Sequence[str]:
        common = machine.cylinder
        tables: Mapping[str, Spec] = {"cylinder": common} | {
            f"cylinder.{key}": own for key, own in common.overrides.items()
        }
        return [
            f"[{path}] {name}" for name in names for path, table in tables.items() if name in table.model_fields_set
        ]

    return written


USES: tuple[Use, ...] = (
    Use(_table("gas"), (GasPressures,), MechanismTorques, N_("forces and torque are of inertia alone")),
    Use(_masses, (MechanismTorques,)),
    Use(_gravity, (MechanismTorques, ShakingForces)),
    Use(_table("friction"), (MechanismTorques,)),
    Use(_guides, (GuideEdges,)),
    Use(_table("balance"), (BalanceWeights,)),
    Use(_table("evenness"), (ShaftWork,)),
    Use(_evenness("load", "flywheel", "flywheel_moment"), (RunningSpeed,)),
    Use(_evenness("motor", is_table=True), (RunningSpeed,)),
    Use(_evenness("load_curve", is_table=True), (LoadTorque,)),
    Use(_evenness("coefficient"), (FlywheelSize,)),
    Use(_evenness("rim", is_table=True), (RimSize,)),
    Use(_cylinder("compression_ratio"), (ChamberVolumes,)),
    Use(_cylinder("chambers", "piston_rod"), (SweptVolumes,)),
    Use(_cylinder("exhaust_port", "scavenge_port"), (PortTiming,)),
    Use(_cylinder("firing_order", "numbers"), (Firing,)),
    Use(_cylinder("mechanical_efficiency", "friction_pressure"), (BrakePowers,)),
)
"""What may stand in a file without being used."""


def unused(machine: Machine, lacking: Mapping[type, tuple[str, ...]]) -> tuple[Unused, ...]:
    """Find the tables that are written and that no result could rest on.

    Parameters
    ----------
    machine : Machine
    lacking : mapping of type to tuple of str
        Results that cannot be had, and what is missing for them.

    Returns
    -------
    tuple of Unused
        A table that is not used at all, and of one that is, its parts that are not.
    """
    found: list[Unused] = []
    for one in _found(machine, lacking):
        if not any(one.table != other.table and one.table.startswith(other.table.rstrip("]")) for other in found):
            found.append(one)
    return tuple(found)


def _found(machine: Machine, lacking: Mapping[type, tuple[str, ...]]) -> Iterator[Unused]:
    """Go through all that may stand in a file."""
    for use in USES:
        needs = dict.fromkeys(need for result in use.results for need in lacking.get(result, ()))
        for table in use.tables(machine):
            # What a table holds is there, though nothing could be made of it.
            others = tuple(need for need in needs if need != table)
            if others:
                has_consequence = use.instead is not None and use.instead not in lacking
                yield Unused(table, others, _(use.consequence) if has_consequence else "")
