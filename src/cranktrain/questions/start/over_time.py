"""Stages over time: from what moves and stops the crank to curves, events and facts; a press runs its own stroke."""

from cranktrain.layout.drive.declared import DeclaredStroke
from cranktrain.layout.question import Stage
from cranktrain.questions.start.asked import MovingParts
from cranktrain.questions.start.facts import start_facts, stroke_facts, stroke_stops
from cranktrain.questions.start.load_forces import have_forces, start_forces
from cranktrain.questions.start.parts import are_strokes_wanted
from cranktrain.questions.start.ready import start_cases
from cranktrain.questions.start.record import start_curves, start_events, start_pressures
from cranktrain.questions.start.starting import start_run
from cranktrain.questions.start.together import ready_starts


def is_no_stroke(stroke: DeclaredStroke | None) -> bool:
    """Whether a start is a run from rest."""
    return stroke is None


STAGES = (
    Stage(MovingParts),
    Stage(start_cases, applies=is_no_stroke),
    Stage(ready_starts, applies=is_no_stroke),
    Stage(start_run),
    Stage(start_curves),
    Stage(start_pressures),
    Stage(start_forces, applies=have_forces),
    Stage(start_events),
    Stage(start_facts),
    Stage(stroke_facts, applies=are_strokes_wanted),
    Stage(stroke_stops, applies=are_strokes_wanted),
)
