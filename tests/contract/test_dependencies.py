"""What the package imports is what it declares: no more, so that nothing is installed in vain, and no less."""

import ast
import re
import sys
import tomllib
from itertools import chain
from pathlib import Path

from cranktrain.extras import EXTRAS

ROOT = Path(__file__).parents[2]
CALLED = {"pillow": "PIL"}
"""Distributions whose package has another name."""


def imported() -> set[str]:
    names: set[str] = set()
    for path in ROOT.glob("src/**/*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                names |= {alias.name.partition(".")[0] for alias in node.names}
            elif isinstance(node, ast.ImportFrom):
                names.add((node.module or "").partition(".")[0])
            elif isinstance(node, ast.Call) and getattr(node.func, "id", "") in ("import_module", "imported"):
                names |= {argument.value for argument in node.args[:1] if isinstance(argument, ast.Constant)}
    return names - {"cranktrain", *sys.stdlib_module_names}


PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def packages(needed: list[str]) -> set[str]:
    names = [re.match(r"[\w-]+", each)[0] for each in needed]
    return {CALLED.get(name, name.replace("-", "_")) for name in names}


def test_declared_packages_are_those_imported():
    optional = PROJECT["optional-dependencies"]
    installed_with_pydantic = {"pydantic_core"}
    declared = packages([*PROJECT["dependencies"], *(each for extra in EXTRAS for each in optional[extra])])
    assert declared == imported() - installed_with_pydantic


def test_extras_have_what_users_are_told_of_them():
    optional = PROJECT["optional-dependencies"]
    assert set(optional) - set(EXTRAS) == {"docs", "test", "benchmarks"}  # what the program itself never imports
    assert {extra: set(EXTRAS[extra]) for extra in EXTRAS} == {extra: packages(optional[extra]) for extra in EXTRAS}


def test_what_a_plain_install_has_is_in_no_extra():
    assert packages(PROJECT["dependencies"]).isdisjoint(chain(*EXTRAS.values()))


def test_tests_have_what_a_user_may_have():
    first = PROJECT["optional-dependencies"]["test"][0]
    assert set(EXTRAS) <= set(re.fullmatch(r"cranktrain\[(.*)\]", first)[1].split(","))
