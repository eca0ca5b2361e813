"""Methods for the loads of main bearings: which there are, in the order of trust, and which a file has numbers for."""

from cranktrain.language import Words, _
from cranktrain.questions.crankshaft.methods.bearing_method import BearingMethod, TakenBearings
from cranktrain.questions.crankshaft.methods.clearance import CLEARANCE
from cranktrain.questions.crankshaft.methods.crank_frame import ELASTIC_FRAME, RIGID_FRAME
from cranktrain.questions.crankshaft.methods.split import SPLIT
from cranktrain.questions.crankshaft.methods.straight import FIVE_MOMENT, THREE_MOMENT
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts

BEARING_METHODS: tuple[BearingMethod, ...] = tuple(
    sorted((ELASTIC_FRAME, RIGID_FRAME, FIVE_MOMENT, THREE_MOMENT, SPLIT, CLEARANCE), key=lambda method: method.rank)
)
"""A line for each; the most trusted comes first, of one rank as they stand here."""


def methods_for(declared: DeclaredCrankshafts) -> tuple[BearingMethod, ...]:
    """Methods that the file has numbers for, the most trusted first."""
    return tuple(method for method in BEARING_METHODS if method.bearings.are_known(declared))


def most_trusted(bearings: TakenBearings) -> BearingMethod:
    """Of the methods that take bearings for such, the most trusted."""
    return next(method for method in BEARING_METHODS if method.bearings is bearings)


def method_named(name: str) -> BearingMethod:
    """The method that users call so."""
    return next(method for method in BEARING_METHODS if method.name == name)


def title_of(name: str) -> Words:
    """How answers call the method that users call so."""
    return _(method_named(name).title)
