"""Parts: what machines declare, as SI arrays with a leading design axis; stages ask for them by type."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from typing import NamedTuple, cast

from cranktrain.all_questions import QUESTIONS
from cranktrain.columns import in_columns, row_of
from cranktrain.errors import Problem, refuse
from cranktrain.language import _
from cranktrain.layout.design import Design
from cranktrain.layout.parts import laid_out, layout_parts
from cranktrain.layout.question import Parts
from cranktrain.layout.specs import MAIN
from cranktrain.machine import Machine, machine_problems
from cranktrain.quantities import Given
from cranktrain.spec import Spec


def parts_of(machines: Sequence[Machine], *, step: float) -> Parts:
    """Lay out designs of one machine.

    Parameters
    ----------
    machines : sequence of Machine
        With nothing wrong; they differ in numbers alone.
    step : float
        Of the crank-angle grid, a whole part of the cycle. [rad]

    Returns
    -------
    Parts
        By type: those of the layout, then those of every question; what the machines do not declare is left out.
    """
    if len(machines) > 1:
        return parts_together(in_columns(machines), [one.design for one in machines], step=step)
    alone = machines[0]
    return alone.design.once(_Laying(alone.asks, alone.cycle, step))


def parts_together(together: Machine, each: Sequence[Design], *, step: float) -> Parts:
    """Lay out designs that stand together in the columns of one machine; of each what its own files say is taken."""
    return _Laying(together.asks, together.cycle, step).of(together.design, each)


class _Laying(NamedTuple):
    """How designs are laid out: what is asked of them, over which cycle, in which steps [rad]."""

    asks: tuple[str, ...]
    cycle: float
    step: float

    def __call__(self, design: Design) -> Parts:
        """Lay out one."""
        return self.of(design, (design,))

    def of(self, together: Design, each: Sequence[Design]) -> Parts:
        """Lay out some."""
        laid = laid_out(each, together, cycle=self.cycle, step=self.step)
        parts: Parts = {type(part): part for part in layout_parts(laid) if part is not None}
        for question in map(QUESTIONS.named, self.asks):
            parts |= {type(part): part for part in question.parts(laid, parts) if part is not None}
        return parts


def designs_of(together: Machine, n_designs: int) -> list[Design]:
    """Designs that stand together, each by itself; one for all where all that is taken of them stands in columns.

    Of each are taken files of loads, the speed of the shaft by a table or a wanted motion, pulls on a crankshaft.
    """
    main, shaft = together.design.shafts[MAIN], together.crankshaft
    has_files = any(load.file is not None for named in together.design.loads.values() for load in named.values())
    if has_files or main.speed_curve or main.motion or (shaft is not None and shaft.pulls):
        return [row_of(together, place).design for place in range(n_designs)]
    return [row_of(together, 0).design] * n_designs


def refuse_wrong(machines: Sequence[Machine], *, partial: bool = False) -> None:
    """Refuse designs with which anything is wrong.

    Parameters
    ----------
    machines : sequence of Machine
        The same mechanisms in the same places; only numbers differ.
    partial : bool
        Accept links that cannot close over the whole turn: NaN there.

    Raises
    ------
    InputError
        With everything that is wrong with any of them.
    """
    wrong = (problem for machine in machines for problem in machine_problems(machine, partial=partial))
    refuse(dict.fromkeys((*differences(machines), *wrong)))


def differences(machines: Sequence[Machine]) -> Iterator[Problem]:
    """Find where designs differ in more than numbers."""
    first = machines[0]
    allowed = _("must be the same in all designs, which may differ in numbers alone; in design {n} it is another")
    own = {name: getattr(first, name) for name in type(first).model_fields}

    @cache
    def of_first(tables: tuple[str, ...]) -> dict[str, object]:
        return dict(_structure_of(first, tables))

    cycle = first.cycle
    for n, machine in enumerate(machines[1:], start=2):
        # what designs share needs no look
        tables = tuple(name for name, table in own.items() if not _are_alike(table, getattr(machine, name)))
        if not tables and machine.cycle == cycle:
            continue
        one, other = of_first(tables), dict(_structure_of(machine, tables))
        paths = [] if one == other else [path for path in {**one, **other} if one.get(path) != other.get(path)]
        if not paths and machine.cycle != cycle:
            over = _("must go on over one turn in all designs, or over two in all; in design {n} it is otherwise")
            yield Problem("load", None, over.format(n=n))
        if paths:
            yield Problem(re.sub(r"\.mechanism\[\d+\]", ".mechanism", paths[0]), None, allowed.format(n=n))


def _are_alike(one: object, other: object) -> bool:
    """Whether two tables, as they are read, differ in nothing but numbers; if not, it is found where."""
    if one is other or (isinstance(one, Given) and isinstance(other, Given)):
        return True
    if type(one) is not type(other):
        return False
    if isinstance(one, Spec):
        # most fields of most tables are one and the same, or nothing
        own, others = vars(one), vars(other)
        return all(
            own[name] is others[name] or _are_alike(own[name], others[name])
            for name in type(one).model_fields
            if name != "name" and name not in one.of_file
        )
    if isinstance(one, Mapping):
        named, others = cast("Mapping[str, object]", one), cast("Mapping[str, object]", other)
        return named.keys() == others.keys() and all(_are_alike(value, others[name]) for name, value in named.items())
    if isinstance(one, tuple):
        items, others = cast("tuple[object, ...]", one), cast("tuple[object, ...]", other)
        return len(items) == len(others) and all(map(_are_alike, items, others))
    return one == other


def _structure_of(spec: Spec, names: Iterable[str], path: str = "") -> Iterator[tuple[str, object]]:
    """Give the same of some fields of a spec."""
    for name in names:
        if name in spec.of_file:
            if type(spec).model_fields[name].is_required():
                yield f"{path}.{name}", Given
        elif name != "name":
            yield from _structure(getattr(spec, name), f"{path}.{name}".removeprefix("."))


def _structure(declared: object, path: str = "") -> Iterator[tuple[str, object]]:
    """Give what is no number in a spec, by path; of a number, that there is one."""
    if isinstance(declared, Given):
        yield path, Given
    elif isinstance(declared, Spec):
        yield from _structure_of(declared, type(declared).model_fields, path)
    elif isinstance(declared, Mapping):
        for name, value in cast(Mapping[str, object], declared).items():
            yield from _structure(value, f"{path}.{name}")
    elif isinstance(declared, tuple):
        for place, value in enumerate(cast(tuple[object, ...], declared)):
            yield from _structure(value, f"{path}[{place}]")
    elif declared is not None:
        yield path, declared
