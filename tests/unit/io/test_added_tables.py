"""Tables put into the text of a machine file, and others behind comment marks."""

import tomllib

import pytest

from cranktrain.io.added_tables import with_tables

NEW = [{"mass": '"2 kg"', "throw": "1"}, {"mass": '"3 kg"', "throw": "2"}]
READ = [{"mass": "2 kg", "throw": 1}, {"mass": "3 kg", "throw": 2}]
OLD = {"mass": "1 kg", "throw": 3}

TEXTS = {
    "nothing of it": ('name = "x"\n', []),
    "no line end": ('name = "x"', []),
    "a table without them": ('[balance]\ncounterweights = "rotating"\n\n[gas]\nkind = "otto"\n', []),
    "sections": ('[[balance.weight]]\nmass = "1 kg"\nthrow = 3\n\n[gas]\nkind = "otto"\n', [OLD]),
    "a list": ('[balance]\nweight = [{ mass = "1 kg", throw = 3 }]\n[gas]\nkind = "otto"\n', [OLD]),
    "a long list": ('[balance]\nweight = [ # old\n  { mass = "1 kg", throw = 3 },\n]\n', [OLD]),
    "an empty list": ("[balance]\nweight = []\n", []),
    "a table in a line": ('balance = { share = 0.5 }\nname = "x"\n', []),
    "a table in a line with them": ('balance = { weight = [{ mass = "1 kg", throw = 3 }] }\n', [OLD]),
    "lines ended by two": ('[balance]\r\nshare = 0.5\r\n', []),
}  # fmt: skip


@pytest.mark.parametrize("name", TEXTS)
def test_added(name):
    text, there = TEXTS[name]
    before, after = tomllib.loads(text), tomllib.loads(with_tables(text, "balance.weight", NEW))
    assert after["balance"].pop("weight") == [*there, *READ]
    before.setdefault("balance", {}).pop("weight", None)
    assert after == before


def test_tables_with_heads_stand_together():
    """Behind what the last of them has in tables of its own, and before what is said of the next table."""
    text = """\
[[balance.weight]]
mass = "1 kg"
[balance.weight.place]
throw = 3 # at last
# of the gas
[gas]
kind = "otto"
"""
    assert (
        with_tables(text, "balance.weight", NEW)
        == """\
[[balance.weight]]
mass = "1 kg"
[balance.weight.place]
throw = 3 # at last

[[balance.weight]]
mass = "2 kg"
throw = 1

[[balance.weight]]
mass = "3 kg"
throw = 2

# of the gas
[gas]
kind = "otto"
"""
    )


@pytest.mark.parametrize("name", [name for name, (_text, there) in TEXTS.items() if there])
def test_in_place_of_what_is_there(name):
    text, _there = TEXTS[name]
    after = tomllib.loads(with_tables(text, "balance.weight", NEW, ["balance.weight[0]"]))
    assert after["balance"]["weight"] == READ


def test_taken_out_lines_stay_to_be_read():
    text = """\
[balance] # of the shaft
counterweights = "rotating" # all
share = 0.5
shafts = [{ order = 2 }]

# the second
[[balance.weight]]
mass = "1 kg"

throw = 3 # at last
[[balance.weight]]
mass = "4 kg"
throw = 4
"""
    taken_out = ["balance.counterweights", "balance.share", "balance.weight[0]"]
    after = with_tables(text, "balance.weight", NEW[:1], taken_out)
    assert after.startswith(
        """\
[balance] # of the shaft
# counterweights = "rotating" # all
# share = 0.5
shafts = [{ order = 2 }]

# the second
# [[balance.weight]]
# mass = "1 kg"

# throw = 3 # at last
[[balance.weight]]
"""
    )
    assert tomllib.loads(after)["balance"] == {
        "shafts": [{"order": 2}],
        "weight": [{"mass": "4 kg", "throw": 4}, READ[0]],
    }


def test_nothing_to_do():
    text, _there = TEXTS["sections"]
    assert with_tables(text, "balance.weight", []) == text
