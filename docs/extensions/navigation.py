"""The tree of pages beside every page is made of titles alone; Sphinx copies all sections first, and drops them."""

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any
from unittest import mock

from docutils import nodes
from sphinx.addnodes import toctree
from sphinx.application import Sphinx


def _titles(contents: nodes.bullet_list) -> nodes.bullet_list:
    """Give the contents of a page without its sections, as Sphinx leaves them where titles alone are asked for."""
    found = contents.deepcopy()
    for title in found.children:
        if isinstance(title, nodes.Element) and len(title) > 1:
            below = list(title.findall(toctree))
            if below:
                title[1][:] = below
            else:
                title.pop(1)
    return found


@cache
def _all_titles(app: Sphinx) -> Mapping[str, nodes.bullet_list]:
    """Give them of all pages, when all have been read."""
    return {page: _titles(contents) for page, contents in app.env.tocs.items()}


def _prepared(app: Sphinx, _page: str, _template: str, context: dict[str, Any], _tree: nodes.document | None) -> None:
    """Let the tree be made of titles where a page asks for no more."""
    whole: Callable[..., str] = context["toctree"]

    def tree(**asked: Any) -> str:
        if not asked.get("titles_only"):
            return whole(**asked)
        with mock.patch.object(app.env, "tocs", _all_titles(app)):
            return whole(**asked)

    context["toctree"] = tree


def setup(app: Sphinx) -> dict[str, bool]:
    """Join Sphinx, before the theme asks for the tree."""
    app.connect("html-page-context", _prepared, priority=400)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
