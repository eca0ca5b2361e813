"""Handles: by which pins of its drawing a mechanism is made another one, and which of its numbers that changes."""

from typing import NamedTuple


class Handle(NamedTuple):
    """A pin of the drawing, and numbers of the mechanism's table that say where it is.

    Attributes
    ----------
    pin : str
    numbers : tuple of str
        Paths in the table, the first that matters most. Of those that a file has, one or two are changed when the pin
        is moved; a kind of which a number may be given in several ways names all of these.
    """

    pin: str
    numbers: tuple[str, ...]
