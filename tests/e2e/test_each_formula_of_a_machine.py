"""Each row of the texts' pages, of the machine that its command names, against `run` of that machine.

What a form gives is written out in the checks, with lengths that the machine's file has; what is exact is `run`'s.
"""

import shlex

import pytest
from tests.rows_of_texts import crank_drive, opposed_and_articulated, steam_engine, support_reactions, synthesis
from tests.rows_of_texts.kept import CHECKS, rows

TEXTS = (steam_engine, crank_drive, synthesis, opposed_and_articulated, support_reactions)
COMMANDS = dict(rows())


def test_every_row_has_a_command_and_a_check():
    assert len(TEXTS) == len({letter for letter, _number, _place in CHECKS})
    assert set(CHECKS) == set(COMMANDS)
    assert all(COMMANDS.values())


@pytest.mark.parametrize("key", CHECKS, ids=lambda key: " ".join(map(str, key)))
def test_of_a_machine(key, typed):
    CHECKS[key](shlex.split(COMMANDS[key]), typed)
