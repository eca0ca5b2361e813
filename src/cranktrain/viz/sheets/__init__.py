"""Pictures of the questions: a folder each, named after its question, whose `PICTURES` say what there is.

These say it as data, so that the terminal can name all pictures without loading what draws them.
"""

from importlib import import_module
from pkgutil import iter_modules

from cranktrain.viz.picture import Picture

PICTURES: tuple[Picture, ...] = tuple(
    picture
    for question in sorted(module.name for module in iter_modules(__path__))
    for picture in import_module(f"{__name__}.{question}").PICTURES
)
"""All pictures, question by question."""
