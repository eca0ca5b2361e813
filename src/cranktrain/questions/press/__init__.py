"""Press: single strokes by clutch and brake, and how many a minute there can be."""

from cranktrain.language import N_
from cranktrain.layout.question import Question, Stage, Use, inner_table
from cranktrain.questions.press import rows
from cranktrain.questions.press.strokes import PressStrokes, press_strokes
from cranktrain.questions.start.parts import are_strokes_wanted


def _over_time() -> tuple[Stage, ...]:
    from cranktrain.questions.press.stroke_start import ready_strokes  # only where a start asks

    return (Stage(ready_strokes, applies=are_strokes_wanted),)


QUESTION = Question(
    "press",
    stages=(Stage(press_strokes, applies=are_strokes_wanted),),
    over_time=_over_time,
    title=N_("Drive"),
    rows=(rows.stroke_rows,),
    uses=(Use(inner_table("drive", "stroke"), (PressStrokes,)),),
)
