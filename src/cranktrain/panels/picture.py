"""What can be drawn by a name."""

from collections.abc import Mapping
from dataclasses import field
from typing import Literal

from cranktrain.record import record


@record
class Picture:
    """A picture that a question has: as data alone, so that naming all of them loads nothing that draws.

    Attributes
    ----------
    kind : "plan", "sheet", "file" or "start"
    name : str
        As one asks for it; of a file the ending of its name.
    home : str
        The function that makes it, module:function: a sheet as data, or a drawing.
    over : "angles", "cycle" or "time"
        At crank angles it is made of a machine, with `angles`, `mechanism`, `speed`; over the cycle of a result, with
        `at` for one crank angle, and `piston`; over the time of a start.
    needs : mapping of quantities to sentences
        What its result must have, and what is said where that is not there; {needs} is what the machine lacks.
    quantities : tuple of str, or None
        What of a result suffices for it; None for all.
    refused : mapping of "plan", "sheet", "at", "mechanism", "size", "speed" to sentences
        What cannot be chosen for it, and why.
    source_angles : "shown", "cylinder" or None
        Whether it has the source's twelve positions, and from where their crank angles count: as the machine shows
        them, or from where the crank points along the cylinder.
    takes : tuple of "scale", "letters" and "method"
        What else can be chosen for it.
    follows : str
        The picture of another question behind which it is named; if none, it stands with its own question.
    """

    kind: Literal["plan", "sheet", "file", "start"]
    name: str
    home: str
    over: Literal["angles", "cycle", "time"]
    needs: Mapping[str, str] = field(default_factory=dict[str, str])
    quantities: tuple[str, ...] | None = None
    refused: Mapping[str, str] = field(default_factory=dict[str, str])
    source_angles: Literal["shown", "cylinder"] | None = None
    takes: tuple[Literal["scale", "letters", "method"], ...] = ()
    follows: str = ""
