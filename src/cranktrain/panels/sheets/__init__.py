"""Pictures of the questions: a folder each, named after its question, whose `PICTURES` say what there is.

These say it as data, so that the terminal can name all pictures without loading what draws them.
"""

from importlib import import_module
from pkgutil import iter_modules

from cranktrain.panels.picture import Picture


def _in_order() -> list[Picture]:
    """All of them by the names of their questions, but one that follows another question's behind that."""
    found: list[Picture] = []
    for question in sorted(module.name for module in iter_modules(__path__)):
        found += import_module(f"{__name__}.{question}").PICTURES
    for picture in [one for one in found if one.follows]:
        found.remove(picture)
        found.insert([one.name for one in found].index(picture.follows) + 1, picture)
    return found


PICTURES: tuple[Picture, ...] = tuple(_in_order())
"""All pictures, question by question."""
