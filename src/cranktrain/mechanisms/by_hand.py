"""What of a mechanism is made by hand on its drawing: pins that are moved, and parts that are added by clicks."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, NamedTuple, TypeAlias

from cranktrain.motion import Array

FINE = 300.0
"""So many steps of a number, or some more, move a pin as far as the mechanism reaches."""


class Handle(NamedTuple):
    """A pin of the drawing, or a place on it, and numbers of the mechanism's table that say where it is.

    Attributes
    ----------
    pin : str
        Its name.
    numbers : tuple of str
        Paths in the table, the first that matters most. Of those that a file has, one or two are changed when the pin
        is moved; a kind of which a number may be given in several ways names all of these.
    at : callable (geometry) → (x, y), of Array of shape (..., 1), optional
        Where it is, in the mechanism's axes, if it is no pin but stands still on what the pin `slides` slides in. [m]
    slides : str
    """

    pin: str
    numbers: tuple[str, ...]
    at: Callable[[Any], tuple[Array, Array]] | None = None
    slides: str = ""


Taken: TypeAlias = Literal["pin", "slider", "link", "ground"]
"""What a click may take: a pin, that of a slider in a fixed guide, a link; the ground stands for any place."""


class Click(NamedTuple):
    """A click that says where a part is to be.

    Attributes
    ----------
    asks : Words
        The sentence that asks for it.
    takes : mapping of Taken to Words
        What it may take, each with what that will be; `{name}` stands for the name of the pin or link.
    begins : bool
        Whether something begins there, to which no line leads from the click before.
    """

    asks: str
    takes: Mapping[Taken, str]
    begins: bool = False


class Clicked(NamedTuple):
    """What a click took: the name of a pin or a link, none of the ground; and where. [m]

    x and y are in the axes of the mechanism's table.
    """

    name: str
    x: float
    y: float


class AddedTable(NamedTuple):
    """What a part that is added has in the mechanism's table: keys of the table at a path, or of a new item there."""

    path: str
    keys: Mapping[str, Any]
    is_item: bool = False


class Addition(NamedTuple):
    """A part that may be added to a mechanism by clicks.

    Attributes
    ----------
    name : str
    title : Words
    clicks : tuple of Click, or of mapping of Taken to Click
        In their order; a mapping where what is asked for depends on what the click before took.
    added : callable (spec, clicked, angle) → AddedTable
        Finds it from the mechanism's table, what the clicks took, one for each, and the angle of the mechanism's crank
        in the axes of that table [rad]. Raises `InputError` where there is no such part.
    """

    name: str
    title: str
    clicks: tuple[Click | Mapping[Taken, Click], ...]
    added: Callable[[Any, Sequence[Clicked], float], AddedTable]
