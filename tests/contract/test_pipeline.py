"""What stages say of themselves: what they give, and of which tables of the machine file their parts are made."""

import inspect
import re
from collections import Counter
from dataclasses import replace
from functools import cache, wraps

import numpy as np
import pytest
from tests.contract.test_columns import MACHINES, STEP, is_same, numbers_of, with_number

import cranktrain as ct
from cranktrain.analysis import every_stage
from cranktrain.analysis.behind import behind
from cranktrain.analysis.grids import FACTS_STEP
from cranktrain.analysis.outcomes import read_only, run_stages
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.stages import lacking, stages_over_time
from cranktrain.layout.question import CALCULATOR, HAND_OVER, RESULT, tables_of
from cranktrain.layout.speed import SteadySpeed
from cranktrain.saying.catalogue import entries
from cranktrain.saying.checks import StageResult

ASKED = {need for stage in every_stage() for need in stage.needs.values()} | {SteadySpeed}
"""What goes on to another stage, or to a second run."""

PARTS = {need for stage in every_stage() for need in stage.needs.values()} - {stage.gives for stage in every_stage()}
"""What stages ask of the machine file."""

HARMLESS = 1e-5
"""A change of a number by so much leaves what kind of machine it is."""


def keys_of(table: str) -> list[str]:
    """Words of a table's name, or of a key above all tables."""
    return table.strip("[]").split(".")


def holds(table: str, path: tuple[object, ...]) -> bool:
    """Whether a number stands in a table, or in one within it; `[masses]` may be a bank's, too."""
    keys, words = keys_of(table), [str(word) for word in path]
    starts = range(len(words) - len(keys) + 1)
    return any(all(key in ("NAME", word) for key, word in zip(keys, words[start:], strict=False)) for start in starts)


@cache
def moved() -> dict[type, set[tuple[object, ...]]]:
    """By which numbers of some forty machines, each changed by itself, what parts hold is another."""
    found: dict[type, set[tuple[object, ...]]] = {}
    for make in MACHINES.values():
        machine = make()
        first = parts_of([machine], step=STEP)
        for path, si in numbers_of(machine):
            changed = with_number(machine, path, si + HARMLESS * (si or 1.0))
            if not changed.places:  # of banks that share throws, which then have no throws in common
                continue
            other = parts_of([changed], step=STEP)
            for part in first:
                if not is_same(first[part], other[part]):
                    found.setdefault(part, set()).add(path)
    return found


def test_numbers_move_parts():
    assert len(moved()) > 25


@pytest.mark.parametrize("part", sorted(PARTS, key=lambda part: part.__name__), ids=lambda part: part.__name__)
def test_a_part_names_the_tables_that_it_reads(part):
    """Where this fails: name the table in the class's `needs`, or in its `reads`."""
    unsaid = {path for path in moved().get(part, ()) if not any(holds(table, path) for table in tables_of(part))}
    assert unsaid == set()
    assert tables_of(part) != ()


FOR_WORDS = {"CrankAngle": {"[cylinder]"}}
"""Tables that are read for what is no number: whether two turns are a cycle."""


def test_a_part_reads_the_tables_that_it_names():
    """Where this fails, a table in a class's `reads` is one too many: no number of it moves what the class holds."""
    moved_by: dict[type, set[tuple[object, ...]]] = {}
    for part, paths in moved().items():
        says = next((one for one in part.__mro__ if "reads" in vars(one)), None)
        if says is not None:
            moved_by.setdefault(says, set()).update(paths)
    idle = {
        part.__name__: unread
        for part, paths in moved_by.items()
        if (unread := {table for table in part.reads if not any(holds(table, path) for path in paths)})
    }
    assert idle == FOR_WORDS


@pytest.mark.parametrize("stage", every_stage(), ids=lambda stage: stage.gives.__name__)
def test_what_a_stage_gives_is_for_people_or_for_stages(stage):
    """A result without quantities is read, and asked by no stage; what people do not read some stage asks for."""
    if stage.word == RESULT:
        assert entries(stage.gives) or (issubclass(stage.gives, StageResult) and stage.gives not in ASKED)
    else:
        assert not entries(stage.gives)
        assert stage.gives in ASKED, "nobody reads it and no stage asks for it: give it quantities, or take it away"


def test_stages_that_give_no_quantity_are_of_all_three_words():
    words = {stage.gives.__name__: stage.word for stage in every_stage() if not entries(stage.gives)}
    # The gas is asked for pressures at any crank angle, forces on the grid are arrays, and people are warned.
    known = {"GasInChambers": CALCULATOR, "SolvedCycle": HAND_OVER, "UnlikelyGas": RESULT}
    assert {name: words[name] for name in known} == known


@pytest.mark.parametrize("name", ["3d12", "tilting_table", "gas_compressor", "pumping_unit_c57"])
def test_calculators_are_called_and_hand_overs_are_arrays(name):
    parts = parts_of([ct.load(name)], step=np.pi / 180)
    outcomes = run_stages(every_stage(), parts, lacking(every_stage(), parts))
    for stage in every_stage():
        if stage.gives in outcomes and stage.word != RESULT:
            assert takes_something(outcomes[stage.gives]) == (stage.word == CALCULATOR), stage.gives


def takes_something(outcome: object) -> bool:
    """Whether an attribute of it is a function that has to be given something, other than which design."""
    public = [getattr(outcome, name) for name in dir(outcome) if not name.startswith("_")]
    called = [value for value in public if callable(value) and not isinstance(value, type)]
    return any(set(inspect.signature(value).parameters) - {"design"} for value in called)


def test_citations_are_read_as_they_are_written():
    """Every stage whose docstring cites a page says so, with as many equations as stand there."""
    for stage in every_stage():
        docstring = " ".join((inspect.getdoc(stage.function) or "").split())
        if "docs/theory/" in docstring and entries(stage.gives):
            (found,) = (one for one in behind(entries(stage.gives)[0].name).stages if one.gives == stage.gives.__name__)
            assert set(re.findall(r"docs/theory/[\w-]+", docstring)) == {
                re.match(r"docs/theory/[\w-]+", source)[0] for source in found.sources
            }
            assert set(re.findall(r"\(\d+\.\d+\)", " ".join(found.sources))) <= set(
                re.findall(r"\(\d+\.\d+\)", docstring)
            )


@pytest.mark.parametrize("name", ct.example_names())
def test_no_stage_changes_what_another_gave(name):
    """Results are made read-only when somebody reads them; here all is, as soon as it is there."""
    parts = parts_of((ct.load(name),), step=FACTS_STEP)

    def giving_read_only(stage):
        if isinstance(stage.function, type):  # of what is read-only already
            return stage

        @wraps(stage.function)
        def function(**needs):
            outcome = stage.function(**needs)
            read_only(outcome)
            return outcome

        return replace(stage, function=function)

    for part in parts.values():
        read_only(part)
    stages = [giving_read_only(stage) for stage in every_stage()]
    run_stages(stages, parts, lacking(every_stage(), parts))


WITH_DRIVE = [name for name in ct.example_names() if ct.load(name).drive is not None]


@pytest.mark.parametrize("name", WITH_DRIVE)
def test_stages_over_time_lead_to_a_start(name):
    """Of several that give one thing one is for the machine, and what the file says of a start is behind its curves."""
    machine = ct.load(name)
    stages = stages_over_time(machine, parts_of((machine,), step=FACTS_STEP))
    given = Counter(stage.gives for stage in stages)
    assert [kind.__name__ for kind, n in given.items() if n > 1] == []
    start = ct.start(machine)
    found = start.behind("motor_torque")
    assert found.stages[-1] == "start_curves"
    assert ("ready_strokes" in found.stages) is (machine.drive.stroke is not None)
    assert "drive" in found.tables


def test_behind_a_start_is_no_cycle():
    """`motor_torque` over the crank angle and over the time are two; a start goes by the steady cycle alone."""
    machine = ct.load("shears")
    cycle, start = ct.run(machine).behind("motor_torque"), ct.start(machine).behind("motor_torque")
    assert cycle.stages[-1] == "steady_drive"
    assert set(cycle.stages[:-1]) < set(start.stages)
    assert "steady_drive" not in start.stages
