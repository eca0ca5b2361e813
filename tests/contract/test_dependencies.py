"""What the package imports is what it declares: no more, so that nothing is installed in vain, and no less."""

import ast
import re
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]
CALLED = {"pillow": "PIL"}
"""Distributions whose package has another name."""
EXTRAS = ("fast", "cad", "dataset", "xlsx", "store", "cluster")
"""What a user may have besides, and the tests have."""


def imported() -> set[str]:
    names: set[str] = set()
    for path in ROOT.glob("src/**/*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                names |= {alias.name.partition(".")[0] for alias in node.names}
            elif isinstance(node, ast.ImportFrom):
                names.add((node.module or "").partition(".")[0])
            elif isinstance(node, ast.Call) and getattr(node.func, "id", "") == "import_module":
                names |= {argument.value for argument in node.args if isinstance(argument, ast.Constant)}
    return names - {"cranktrain", *sys.stdlib_module_names}


def test_declared_packages_are_those_imported():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    optional = project["optional-dependencies"]
    needed = [*project["dependencies"], *(each for extra in EXTRAS for each in optional[extra])]
    names = [re.match(r"[\w-]+", each)[0] for each in needed]
    installed_with_pydantic = {"pydantic_core"}
    assert {CALLED.get(name, name.replace("-", "_")) for name in names} == imported() - installed_with_pydantic


def test_tests_have_what_a_user_may_have():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    first = project["optional-dependencies"]["test"][0]
    assert set(EXTRAS) <= set(re.fullmatch(r"cranktrain\[(.*)\]", first)[1].split(","))
