"""Messages that stand in no `_()`: names in words, comments of TOML, docstrings that people are shown."""

from collections.abc import Iterator
from typing import Any, cast

from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis import every_stage
from cranktrain.analysis.behind import first_sentence
from cranktrain.analysis.stages import key_of
from cranktrain.io.schema import machine_schema
from cranktrain.language import in_language
from cranktrain.layout.question import Stage
from cranktrain.mechanisms import KINDS
from cranktrain.plans.acted_links import MASTER
from cranktrain.questions.balance.shaken import BALANCE
from cranktrain.questions.crankshaft.bending.throw_stiffness import THROW_METHODS
from cranktrain.questions.crankshaft.methods import BEARING_METHODS
from cranktrain.questions.evenness.flywheel_inertia import METHODS
from cranktrain.questions.forces.piston_forces import FORCE_METHODS
from cranktrain.questions.forces.rod_masses import ROD_METHODS
from cranktrain.saying.catalogue import entries
from cranktrain.saying.comments import comments_in
from cranktrain.saying.names import spelled
from cranktrain.texts.comparison import FORMS
from cranktrain.texts.example_tables import example_table


def other_messages() -> tuple[str, ...]:
    """Give each of them once, as it is asked for where it is shown."""
    return tuple(dict.fromkeys(filter(None, _all())))


def _all() -> Iterator[str]:
    yield from map(spelled, (*_names(), *_members()))
    yield from map(str.capitalize, QUESTIONS.names)
    for text in _tables():
        yield from comments_in(text)
    for stage in _stages():
        yield from map(first_sentence, (stage.function, *stage.needs.values()))
    with in_language("en"):
        yield from _descriptions(machine_schema())


def _stages() -> Iterator[Stage]:
    """Stages of a cycle, and those over time."""
    yield from every_stage()
    for question in QUESTIONS:
        yield from question.over_time()


def _names() -> Iterator[str]:
    """Results and quantities."""
    for stage in _stages():
        yield key_of(stage.gives)
        yield from (entry.name for entry in entries(stage.gives))


def _members() -> Iterator[str]:
    """Methods, links and joints."""
    yield from (*BALANCE, *METHODS, *FORCE_METHODS, *ROD_METHODS, *FORMS)
    yield from (method.name for method in (*BEARING_METHODS, *THROW_METHODS))
    for kind in KINDS:
        yield from kind.dynamics.moving
        if kind.is_direct:  # others may hang on its rod
            yield from (f"{MASTER}{link}" for link in kind.dynamics.moving)
        yield from (reaction.name.partition("/")[0] for reaction in kind.dynamics.reactions)


def _tables() -> Iterator[str]:
    """Tables with comments that the program writes."""
    for kind in KINDS:
        yield kind.example
        if kind.tables is not None:
            yield kind.tables.read_text(encoding="utf-8")
    yield from map(example_table, ("drive", "throw"))


def _descriptions(schema: Any) -> Iterator[str]:
    """What a schema says of tables."""
    if isinstance(schema, dict):
        whole = cast("dict[str, Any]", schema)
        if "properties" in whole:
            yield whole.get("description", "")
        schema = list(whole.values())
    if isinstance(schema, list):
        for each in cast("list[Any]", schema):
            yield from _descriptions(each)
