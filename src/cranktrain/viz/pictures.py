"""What draws a picture that has a record: a sheet out of its data, or a drawing of its own."""

from collections.abc import Callable
from functools import wraps
from importlib import import_module
from typing import Any

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.extras import lacking
from cranktrain.io.description import units_of
from cranktrain.language import _
from cranktrain.panels.parts import Sheet
from cranktrain.panels.picture import Picture
from cranktrain.quantities import shown_as_in
from cranktrain.viz.sheets import draw_sheet


def drawing_of(picture: Picture) -> Callable[..., Any]:
    """Give what draws a picture, in the machine's units; first it looks whether the result has what is needed.

    Parameters
    ----------
    picture : Picture

    Returns
    -------
    callable
        Of the machine, the result or the start that it is of, and of what can be chosen for it; `size` of a sheet.
    """
    module, _colon, name = picture.home.partition(":")
    make: Callable[..., Any] = getattr(import_module(module), name)

    @wraps(make)
    def drawn(of: Any, *arguments: Any, size: str = "A4", **options: Any) -> Any:
        if picture.kind != "file":
            refuse(lacking("matplotlib", name))
        for quantity, sentence in picture.needs.items():
            if quantity not in of.catalogue:
                needs = ", ".join(map(str, of.needs_of(quantity)))
                raise InputError([Problem("", None, _(sentence, needs=needs))])
        with shown_as_in(units_of(_machine_of(picture, of))):
            if picture.over == "angles":
                own = {} if picture.kind == "file" else {"size": size}
                return make(of, *arguments, **own, **options)
            made = make(of, *arguments, **options)
            return draw_sheet(made, size) if isinstance(made, Sheet) else made

    return drawn


def _machine_of(picture: Picture, of: Any) -> Any:
    """The machine of what a picture is made of."""
    if picture.over == "angles":
        return of
    return of.machine if picture.over == "time" else of.machines[0]
