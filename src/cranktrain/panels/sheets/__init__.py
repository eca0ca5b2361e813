"""Pictures of the questions: a folder each, named after its question, whose `PICTURES` say what there is.

`VECTORS`, where there are any, names what gives vectors for the drawing of a machine. Both say it as data, so that the
terminal can name all pictures without loading what draws them.
"""

from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from typing import Any

from cranktrain.panels.picture import Picture


def pictures_of(question: str) -> tuple[Picture, ...]:
    """Give the pictures of a question, by the name of its folder; none of one that has no folder here."""
    return _found(question, "PICTURES")


def vectors_of(question: str) -> tuple[str, ...]:
    """Name what gives the vectors of a question, `module:function`; none of one that has none."""
    return _found(question, "VECTORS")


@cache
def _found(question: str, name: str) -> tuple[Any, ...]:
    """Give what the folder of a question says; nothing where there is none, or it does not."""
    return tuple(getattr(import_module(f"{__name__}.{question}"), name, ())) if question in _folders() else ()


@cache
def _folders() -> tuple[str, ...]:
    """Names of the questions that have a folder, in their order."""
    return tuple(sorted(module.name for module in iter_modules(__path__)))


def _in_order() -> list[Picture]:
    """All of them by the names of their questions, but one that follows another question's behind that."""
    found = [picture for question in _folders() for picture in pictures_of(question)]
    for picture in [one for one in found if one.follows]:
        found.remove(picture)
        found.insert([one.name for one in found].index(picture.follows) + 1, picture)
    return found


PICTURES: tuple[Picture, ...] = tuple(_in_order())
"""All pictures, question by question."""
