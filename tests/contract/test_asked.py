"""A question whose tables a file has not: nothing of it is there, and nothing that is said is lost without its code."""

import os
import subprocess
import sys

import numpy as np
import pytest

import cranktrain as ct
from cranktrain import fluids, mechanisms, motors
from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis import every_stage, run
from cranktrain.analysis.grids import FACTS_STEP
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.stages import lacking, leading_to, missing_results
from cranktrain.io.examples import example_names
from cranktrain.layout.parts import laid_out
from cranktrain.saying.catalogue import entries

every_example = pytest.mark.parametrize("name", example_names())


@every_example
def test_a_question_that_is_not_asked_declares_nothing_and_finds_nothing_wrong(name):
    machine = ct.load(name)
    parts = parts_of((machine,), step=FACTS_STEP)
    designs = laid_out([machine.design], machine.design, cycle=machine.cycle, step=FACTS_STEP)
    for question in (QUESTIONS.named(one) for one in QUESTIONS.names if one not in machine.asks):
        with np.errstate(all="ignore"):
            assert list(question.problems(machine.design)) == [], question.name
        assert [part for part in question.parts(designs, parts) if part is not None] == [], (
            f"{question.name}: name in QUESTIONS of all_questions.py the table that declares it"
        )
        assert [use for use in question.uses if use.tables(machine.design)] == [], question.name


@every_example
def test_what_is_missing_is_the_same_with_all_stages_at_hand(name):
    """Of questions that are not asked a list says what they lack; and none of their stages would have run."""
    result = run(ct.load(name), step_degrees=10)
    parts = parts_of(result.machines, step=FACTS_STEP)
    absent = lacking(every_stage(), parts)
    assert result.missing == missing_results(every_stage(), absent)
    whole = run_stages(every_stage(), parts, absent)
    assert [outcome for outcome in whole if entries(outcome)] == [
        type(one) for one in result.outcomes if entries(type(one))
    ]
    assert flags_of(result.outcomes) == flags_of(whole.values())


@pytest.mark.parametrize("quantity", ["throw_stiffness", "natural_frequency", "largest_bearing_load", "motor_torque"])
def test_a_quantity_that_is_asked_for_lacks_the_same(quantity):
    """Of a question that is not asked, and of one that rests on such a one: torsion of a shaft of unknown sizes."""
    table = {"stiffness": "1 MN*m/rad", "throw_inertia": "0.1 kg*m^2"}
    for machine in (ct.load("textbook_78x78"), ct.load("textbook_78x78").with_({"torsion": table})):
        result = run(machine, quantities=quantity)
        absent = lacking(every_stage(), parts_of((machine,), step=FACTS_STEP))
        (giving,) = (stage for stage in every_stage() if quantity in stage.results)
        chosen = [stage for stage in leading_to(every_stage(), [giving.gives]) if stage.results]
        assert result.missing == missing_results(chosen, absent)


def flags_of(outcomes) -> list[str]:
    return [flag for one in outcomes for name in ("flags", "unlikely") for flag in getattr(one, name, ())]


def loaded_by(code: str) -> set[str]:
    """Modules of the package that a process of its own has imported at its end."""
    shown = f"{code}\nimport sys\nprint(*(name for name in sys.modules if name.startswith('cranktrain.')))"
    done = subprocess.run([sys.executable, "-c", shown], capture_output=True, text=True, check=True)
    return set(done.stdout.splitlines()[-1].split())


def test_only_what_a_file_names_is_imported():
    loaded = loaded_by("import cranktrain as ct; ct.run('textbook_78x78').summary()")
    homes = {
        "questions": {name for name, tables in QUESTIONS.asked_by.items() if tables},
        "mechanisms": set(mechanisms.KINDS.names) - {"slider_crank"},
        "fluids": set(fluids.KINDS.names),
        "motors": set(motors.KINDS.names),
    }
    found = {f"{home}.{name}" for home, names in homes.items() for name in names}
    assert {name for name in found if f"cranktrain.{name}" in loaded} == set()
    assert not {name for name in loaded if name.startswith(("cranktrain.motors", "cranktrain.transient"))}


@pytest.mark.parametrize(("name", "most"), [("3d12", 420), ("textbook_78x78", 320)])
def test_so_many_modules_answer_on_the_screen(name, most):
    code = f"import sys; from cranktrain.cli import main\nsys.argv = ['cranktrain', 'run', '{name}']\nmain()"
    assert len(loaded_by(code)) <= most


@pytest.mark.parametrize(("disabled", "looks"), [(None, False), ("", True)])
def test_the_terminal_loads_nothing_that_looks_for_plugins_of_pydantic(disabled, looks):
    """Unless somebody wants them; what asks installed packages is a thirtieth of a small run."""
    code = (
        "import sys; from cranktrain.cli import main\nsys.argv = ['cranktrain', 'run', 'textbook_78x78']\nmain()\n"
        "print('importlib.metadata' in sys.modules)\n"
        "from pydantic.plugin import _loader; print(_loader.PYDANTIC_ENTRY_POINT_GROUP, list(_loader.get_plugins()))"
    )
    given = {name: value for name, value in os.environ.items() if name != "PYDANTIC_DISABLE_PLUGINS"}
    environment = given if disabled is None else given | {"PYDANTIC_DISABLE_PLUGINS": disabled}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, env=environment)
    # What somebody asks besides is pydantic's own.
    assert done.stdout.splitlines()[-2:] == [str(looks), "pydantic []"]
