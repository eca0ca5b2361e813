"""Lines of the answer know of which quantities their numbers are: from each there is a way to its equation."""

import re

import pytest

import cranktrain as ct
from cranktrain.language import Said
from cranktrain.saying.amounts import VALUES, filled, measured_in

LEAST = 0.98
"""Of the numbers that are printed; what is counted, as cylinders are, is of no quantity."""


def texts_in(words):
    """What words are made of that is written as it is."""
    if isinstance(words, Said):
        for piece in words.each():
            yield from texts_in(piece)
    elif words != "":
        yield str(words)


def pieces_of(words):
    """What words are made of that is said."""
    if isinstance(words, Said):
        yield words
        for piece in words.each():
            yield from pieces_of(piece)


def numbers_of(result):
    """Of each number of the answer, the line that has it and the quantities that it says it is of."""
    labels = {name for names in result.titles.values() for name in names}
    for _title, rows in result.answer_rows():
        for row in rows:
            if row.values.size:
                yield row, (row.quantity,)
            yield from ((row, tuple(one.quantity.split()) or ("",)) for one in measured_in(row.words))
            # Orders and cylinders are names, one by one or in a list.
            texts = [text for text in texts_in(row.words) if not set(re.split(", |-", text)) - {"…"} <= labels]
            yield from ((row, (row.quantity,)) for text in texts if re.search(r"\d", text))


def test_nearly_all_numbers_of_all_screens_know_their_quantity():
    every = [
        (name, str(row.name), quantity, quantity in result.catalogue)
        for name in ct.example_names()
        for result in [ct.run(name)]
        for row, quantities in numbers_of(result)
        for quantity in quantities
    ]
    unknown = [one[:3] for one in every if not one[3]]
    assert len(every) > 900
    assert len(unknown) <= (1 - LEAST) * len(every), unknown
    assert {line for _name, line, _quantity in unknown} <= {"natural frequencies"}  # and so many more


@pytest.mark.parametrize("name", ["shears", "high_slip_press", "compressor_start"])
def test_all_numbers_of_a_start_know_their_quantity(name):
    start = ct.start(name)
    every = [(str(row.name), one) for row, quantities in numbers_of(start) for one in quantities]
    assert len(every) >= 10
    assert [one for one in every if one[1] not in start.catalogue and one[0] != "mind"] == []
    for row, quantities in numbers_of(start):
        assert all(start.catalogue[one].equation for one in quantities if str(row.name) != "mind")


def test_words_say_where_the_values_of_a_line_stand():
    """So that a translator has the whole sentence, and none begins with a comma."""
    for name in ct.example_names():
        for _title, rows in ct.run(name).rows():
            for row in rows:
                assert not row.words or bool(row.values.size) == (VALUES in set(pieces_of(row.words))), row.name
                assert "{" not in filled(row.words, "4 kN"), row.name


@pytest.mark.parametrize("name", ["3d12", "deltic", "pumping_unit_c57", "servo_press", "tilting_table"])
def test_members_are_those_of_the_quantity(name):
    """Whose an amount is, is called as the quantity's members are."""
    result = ct.run(name)
    named = [one for _title, rows in result.rows() for row in rows for one in measured_in(row.words)]
    for one in named:
        if getattr(one, "member", ()):
            titles = result.titles_of(result.catalogue[one.quantity]).values()
            assert all(str(member) in of for member, of in zip(one.member, titles, strict=True))
    for _title, rows in result.rows():
        for row in rows:
            if len(row.members) > 1:
                *_outer, titles = result.titles_of(result.catalogue[row.quantity]).values()
                assert set(row.members) <= set(titles)


@pytest.mark.parametrize("name", ["3d12", "vaz_21213", "pumping_unit_c57"])
def test_values_of_lines_are_those_of_the_quantity(name):
    """What is told with a sense of its own, or is the larger of two, has the size of one of their values."""
    result = ct.run(name)
    others = {"largest acceleration", "largest pressure angle", "clearance"}
    rows = [row for _title, rows in result.rows() for row in rows if row.values.size and str(row.name) not in others]
    assert rows
    for row in rows:
        entry = result.catalogue[row.quantity]
        held = getattr(result, row.quantity)
        turned = 180 / 3.141592653589793 if entry.unit == "deg" else 1.0
        for value in row.values * turned:
            assert min(abs(abs(value) - abs(one)) for one in held.ravel()) <= 1e-12 * abs(value)
