"""What a method takes the bearings for: rigid, elastic, with clearance."""

from collections.abc import Callable

from cranktrain.language import N_
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.record import record


@record
class TakenBearings:
    """Bearings as a method has them; methods of the same bearings share a line of the answer.

    Attributes
    ----------
    title : str
        How answers call a shaft in such bearings, not yet translated.
    needs : str
        What the machine file must say of them, not yet translated; "" for nothing.
    are_known : callable (DeclaredCrankshafts) → bool
        Whether it does.
    is_linear : bool
        Whether what they bear of loads together is the sum of what they bear of each.
    """

    title: str
    needs: str
    are_known: Callable[[DeclaredCrankshafts], bool]
    is_linear: bool = True


RIGID = TakenBearings(N_("on rigid bearings"), "", lambda _declared: True)
ELASTIC = TakenBearings(
    N_("on elastic bearings"), N_("[crankshaft] bearing_stiffness"), lambda declared: declared.is_elastic
)
LOOSE = TakenBearings(
    N_("with clearance"),
    N_("[crankshaft] bearing_clearance"),
    lambda declared: declared.has_clearance,
    is_linear=False,
)
