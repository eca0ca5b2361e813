"""Names of the program that people read in words: translators are given them, as no message in the code says them."""

from collections.abc import Iterator

from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis import every_stage
from cranktrain.analysis.stages import key_of
from cranktrain.mechanisms import KINDS
from cranktrain.questions.balance.shaken import BALANCE
from cranktrain.questions.crankshaft.bending.throw_stiffness import THROW_METHODS
from cranktrain.questions.crankshaft.methods import BEARING_METHODS
from cranktrain.questions.evenness.flywheel_inertia import METHODS
from cranktrain.questions.forces.piston_forces import FORCE_METHODS
from cranktrain.questions.forces.rod_masses import ROD_METHODS
from cranktrain.saying.catalogue import entries
from cranktrain.saying.names import spelled
from cranktrain.texts.comparison import FORMS


def said_names() -> Iterator[str]:
    """Give quantities, results, questions as heads, methods, links and joints, each as `said_name` asks for it."""
    yield from map(spelled, dict.fromkeys((*_names(), *_members())))
    yield from map(str.capitalize, QUESTIONS.names)


def _names() -> Iterator[str]:
    for stage in every_stage():
        yield key_of(stage.gives)
        yield from (entry.name for entry in entries(stage.gives))


def _members() -> Iterator[str]:
    yield from (*BALANCE, *METHODS, *FORCE_METHODS, *ROD_METHODS, *FORMS)
    yield from (method.name for method in (*BEARING_METHODS, *THROW_METHODS))
    for kind in KINDS:
        if kind.dynamics is not None:
            yield from kind.dynamics.moving
            yield from (reaction.name.partition("/")[0] for reaction in kind.dynamics.reactions)
