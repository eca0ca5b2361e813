"""The reference of Python: a line `% public names of MODULE` in a page stands for all that the module makes public."""

import re
from collections.abc import Iterator
from importlib import import_module

from sphinx.application import Sphinx

_ASKED = re.compile(r"^% public names of (?P<module>[\w.]+)$", re.MULTILINE)


def reference(module: str) -> str:
    """Give the block that documents the public names of a module."""
    return "\n".join(["```{eval-rst}", *_directives(module), "```"])


def _directives(module: str) -> Iterator[str]:
    """Ask autodoc for each name; what is only data says itself what it is."""
    found = import_module(module)
    names = [name for name in found.__all__ if not name.startswith("__")]
    values = {name: getattr(found, name) for name in names}
    for name, value in sorted(values.items(), key=lambda item: (isinstance(item[1], type), item[0])):
        if isinstance(value, type):
            yield from (f".. autoclass:: {module}.{name}", "   :members:", "")
        elif callable(value):
            yield from (f".. autofunction:: {module}.{name}", "")


def _read(app: Sphinx, docname: str, source: list[str]) -> None:
    """Put the reference where a page asks for it."""
    source[0] = _ASKED.sub(lambda asked: reference(asked["module"]), source[0])


def setup(app: Sphinx) -> dict[str, bool]:
    """Join Sphinx."""
    app.connect("source-read", _read)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
