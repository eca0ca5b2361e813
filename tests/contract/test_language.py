"""Every sentence for people can be translated: the catalogue of messages holds what the code says, and no more."""

import ast
from pathlib import Path

from babel.messages.extract import extract_from_dir
from babel.messages.pofile import read_po

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "src/cranktrain"
TEMPLATE = PACKAGE / "locale/cranktrain.pot"
KEYWORDS = {"_": None, "N_": None}


def said() -> set[str]:
    """Messages marked in the code."""
    found = extract_from_dir(str(PACKAGE), [("**.py", "python")], keywords=KEYWORDS)
    return {message for _file, _line, message, _comments, _context in found if isinstance(message, str)}


def test_template_holds_what_the_code_says():
    # remake it with: pybabel extract -k N_ --no-location --sort-output --project cranktrain --version 0.1.0
    #   --copyright-holder "the cranktrain authors" -o src/cranktrain/locale/cranktrain.pot src
    with TEMPLATE.open(encoding="utf-8") as file:
        template = {message.id for message in read_po(file) if message.id}
    assert sorted(said() - template) == []
    assert sorted(template - said()) == []


def test_no_message_is_put_together_before_it_is_translated():
    # an f-string or a sum in _() is no message that a translator ever sees
    for path in PACKAGE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ("_", "N_"):
                assert not isinstance(node.args[0], ast.JoinedStr | ast.BinOp), f"{path}:{node.lineno}"
