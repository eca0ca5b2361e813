"""Every sentence for people can be translated."""

import ast
from pathlib import Path

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "src/cranktrain"


def test_no_message_is_put_together_before_it_is_translated():
    # an f-string or a sum in _() is no message that a translator ever sees
    for path in PACKAGE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ("_", "N_"):
                assert not isinstance(node.args[0], ast.JoinedStr | ast.BinOp), (
                    f'{path}:{node.lineno}: write _("… {{x}} …").format(x=…), so that a translator sees the sentence'
                )
