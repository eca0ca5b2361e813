"""Every sentence for people can be translated."""

import ast
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from string import Formatter
from threading import Barrier
from types import SimpleNamespace

import pytest

import cranktrain as ct
from cranktrain import language

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "src/cranktrain"


def test_no_message_is_put_together_before_it_is_translated():
    # an f-string or a sum in _() is no message that a translator ever sees
    for path in PACKAGE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ("_", "N_"):
                assert not isinstance(node.args[0], ast.JoinedStr | ast.BinOp), (
                    f'{path}:{node.lineno}: write _("… {{x}} …", x=…), so that a translator sees the sentence'
                )


def test_the_pieces_of_a_message_are_those_that_stand_in_it():
    for path in PACKAGE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "_" and node.keywords:
                (message,) = node.args
                given = {keyword.arg for keyword in node.keywords}
                if isinstance(message, ast.Constant) and None not in given:
                    wanted = {name for _text, name, _format, _sign in Formatter().parse(message.value) if name}
                    # A row puts its values where its words have them.
                    assert given in (wanted, wanted - {"values"}), f"{path}:{node.lineno}"


def test_each_thread_has_its_own_language(monkeypatch):
    """Of a server two readers ask at once: neither sees a word of the other."""
    said_in = {"a": "Spitze {x}", "b": "{x} au plus", None: "Peak {x}"}
    monkeypatch.setattr(language, "_catalogue", lambda of: SimpleNamespace(gettext=lambda _message: said_in[of]))
    ready = Barrier(2)

    def said(of):
        with language.in_language(of):
            ready.wait()
            return [str(language._("Peak {x}", x="3 kN")) for _time in range(1000)]

    with ThreadPoolExecutor() as threads:
        first, second = threads.map(said, ["a", "b"])
    assert set(first) == {"Spitze 3 kN"}
    assert set(second) == {"3 kN au plus"}
    assert str(language._("Peak {x}", x="3 kN")) == "Peak 3 kN"


@pytest.mark.parametrize("name", ct.example_names())
def test_labels_are_the_same_in_every_language(monkeypatch, name):
    """They are names of the file or keys: `sel`, the columns of a CSV and a script rest on them."""
    labels = dict(ct.run(name).labels)
    monkeypatch.setattr(language, "_catalogue", lambda _of: SimpleNamespace(gettext=lambda message: f"⟦{message}⟧"))
    result = ct.run(name)
    assert dict(result.labels) == labels
    called = {str(title) for dimension in result.titles for title in result.titles[dimension]}
    assert all(title.startswith("⟦") for title in called.difference(*labels.values()))
