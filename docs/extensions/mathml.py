"""Formulas as MathML, which browsers show by themselves: no script, nothing fetched."""

import html
import re
import unicodedata
from xml.etree import ElementTree

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.application import Sphinx
from sphinx.util import logging
from sphinx.util.math import get_node_equation_number
from sphinx.writers.html5 import HTML5Translator

_LOG = logging.getLogger(__name__)
_WRITTEN_OTHERWISE = (
    (re.compile(r"\\(begin|end)\{aligned\}"), r"\\\1{align*}"),
    (re.compile(r"\\\\\[[\d.]+(?:ex|em|pt)\]"), r"\\\\"),
    (re.compile(r"(?<!\\)\\\n"), r"\\ "),
    (re.compile(r"\\arg(?![a-z])"), r"\\operatorname{arg}"),
    (re.compile(r"(_(?:\w|\{[^{}]*\}))''(?!')"), r"\1^{\\dprime}"),
    (re.compile(r"\\dddot(?![a-z])\s*(\{[^{}]*\}|\w)"), r"\\overset{\\ldots}{\1}"),
)
"""What the converter does not know, or writes so that browsers draw it beside its letter; and what it knows."""
_LARGE_BRACE = re.compile(r">\\([{}])<")
"""As it leaves a brace behind a word for its size."""
_NOT_UNDERSTOOD = ("\\", "<mi>&</mi>", 'linebreak="newline"')
"""What it leaves of commands, of columns and of lines that it does not know."""
_PRIME = re.compile(r"<mi>(&#x0203[234];)</mi>")
"""An operator, by which browsers know how high it stands."""
_ALPHABET = re.compile(r'<mi mathvariant="(bold-italic|bold|script|sans-serif)">(.*?)</mi>')
"""Letters of another alphabet, which browsers know by the letters alone."""

_MATHML = "http://www.w3.org/1998/Math/MathML"
_NAMESPACE = f"{{{_MATHML}}}"
_THIN = "0.17em"
_SCRIPTS = ("msup", "msub", "msubsup", "munder")


def mathml(latex: str, display: str) -> str:
    """Give a formula as MathML; what was not understood is a warning, and so no page."""
    for unknown, known in _WRITTEN_OTHERWISE:
        latex = unknown.sub(known, latex)
    made = _LARGE_BRACE.sub(r">\1<", convert(latex, display=display))
    made = _ALPHABET.sub(_of_alphabet, _PRIME.sub(r"<mo>\1</mo>", made))
    if any(sign in made for sign in _NOT_UNDERSTOOD):
        _LOG.warning("not understood in a formula: %s", latex)
        return made
    return _spaced(made)


def _spaced(formula: str) -> str:
    """Set names of functions off from what stands beside them: R sin φ."""
    ElementTree.register_namespace("", _MATHML)
    tree = ElementTree.fromstring(formula)
    for parent in tree.iter(f"{_NAMESPACE}mrow"):
        before: list[ElementTree.Element] = []
        for child in list(parent):
            if before and _apart(before[-1], child):
                before.append(ElementTree.Element(f"{_NAMESPACE}mspace", width=_THIN))
            before.append(child)
        parent[:] = before
    return ElementTree.tostring(tree, encoding="unicode")


def _apart(left: ElementTree.Element, right: ElementTree.Element) -> bool:
    """Whether one is the name of a function, and the other neither an operator nor a space."""
    beside = {f"{_NAMESPACE}{tag}" for tag in ("mo", "mspace")}
    return (_is_function(left) and right.tag not in beside) or (_is_function(right) and left.tag not in beside)


def _is_function(element: ElementTree.Element) -> bool:
    """Whether an element is a name of several letters, or that with a power or an index."""
    if element.tag in {f"{_NAMESPACE}{tag}" for tag in _SCRIPTS}:
        return _is_function(element[0])
    return element.tag == f"{_NAMESPACE}mi" and len(element.text or "") > 1


def _of_alphabet(found: re.Match[str]) -> str:
    """Write letters with the signs of their alphabet: 𝐫 for a bold r."""
    alphabet = found[1].upper().replace("-I", " I")
    return f"<mi>{''.join(_lettered(letter, alphabet) for letter in html.unescape(found[2]))}</mi>"


def _lettered(letter: str, alphabet: str) -> str:
    """Give a letter of an alphabet; the oldest ones of Unicode are not among the mathematical."""
    name = re.sub("LATIN |GREEK |LETTER ", "", unicodedata.name(letter))
    try:
        return unicodedata.lookup(f"MATHEMATICAL {alphabet} {name}")
    except KeyError:
        return unicodedata.lookup(f"{alphabet} {name}")


def _inline(self: HTML5Translator, node: nodes.math) -> None:
    """Put a formula into a line."""
    self.body.append(mathml(node.astext(), "inline"))
    raise nodes.SkipNode


def _block(self: HTML5Translator, node: nodes.math_block) -> None:
    """Put a formula on lines of its own, with its number."""
    self.body.append(self.starttag(node, "div", CLASS="math"))
    if node["number"]:
        self.body.append(f'<span class="eqno">({get_node_equation_number(self, node)})')
        self.add_permalink_ref(node, "Link to this equation")
        self.body.append("</span>")
    self.body.append(f'<div class="formula">{mathml(node.astext(), "block")}</div></div>')
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, bool]:
    """Join Sphinx."""
    app.add_html_math_renderer("mathml", (_inline, None), (_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
