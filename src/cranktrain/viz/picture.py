"""What can be drawn by a name."""

from collections.abc import Callable, Mapping
from dataclasses import field
from functools import wraps
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal

from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.record import record

if TYPE_CHECKING:
    from cranktrain.machine import Machine


@record
class Picture:
    """A picture that a question has: as data alone, so that naming all of them loads nothing that draws.

    Attributes
    ----------
    kind : "plan", "sheet", "file" or "start"
    name : str
        As one asks for it; of a file the ending of its name.
    home : str
        The function that draws it, module:function.
    over : "angles", "cycle" or "time"
        At crank angles it is drawn of a machine, with `angles`, `mechanism`, `speed`; over the cycle of a result, with
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
    takes : tuple of "scale" and "letters"
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
    takes: tuple[Literal["scale", "letters"], ...] = ()
    follows: str = ""

    @property
    def function(self) -> Callable[..., Any]:
        """What draws it, in the machine's units; first it looks whether the result has what is needed."""
        module, _colon, name = self.home.partition(":")
        draw: Callable[..., Any] = getattr(import_module(module), name)

        @wraps(draw)
        def drawn(of: Any, *arguments: Any, **options: Any) -> Any:
            from cranktrain.io.description import units_of
            from cranktrain.quantities import shown_as_in

            machine: Machine = self._machine_of(of)
            for quantity, sentence in self.needs.items():
                if quantity not in of.catalogue:
                    needs = ", ".join(map(str, of.needs_of(quantity)))
                    raise InputError([Problem("", None, _(sentence, needs=needs))])
            with shown_as_in(units_of(machine)):
                return draw(of, *arguments, **options)

        return drawn

    def _machine_of(self, of: Any) -> "Machine":
        """The machine of what it is drawn of."""
        if self.over == "angles":
            return of
        return of.machine if self.over == "time" else of.machines[0]
