"""Tables on paper: columns stand clear of each other, whatever their numbers are."""

import numpy as np
import pytest
from tests.words_on_paper import assert_words_are_readable, words_of

from cranktrain.viz.paper.page import Page, drawing_settings
from cranktrain.viz.paper.tables import write_table


def written(rows, width, shares=()):
    with drawing_settings():
        page = Page(297.0, 210.0)
        write_table(page, rows, (20.0, 190.0, width), shares)
    return page.figure


@pytest.mark.parametrize("wide", range(1, 6))
def test_a_wide_number_has_room(wide):
    """Of a column of small numbers beside others: four figures of 1e-8 take ten signs and a minus."""
    numbers = [["−0.00001234" if column in (wide, wide + 1) else "171.2" for column in range(6)] for _row in range(3)]
    assert_words_are_readable(
        written([["no.", *"abcde"], *([f"{i}", *row[1:]] for i, row in enumerate(numbers))], 80.0)
    )


def test_columns_that_have_room_stay_where_they_are():
    """Ends of evenly spaced columns: 0.1 + 0.9 k/4 of the width."""
    figure = written([["no.", *"abcd"], ["1", "11.00", "22.00", "33.00", "44.00"]], 100.0)
    right = {text: box.x1 / figure.dpi * 25.4 for text, box in words_of(figure)}
    ends = [right[text] for text in ("11.00", "22.00", "33.00", "44.00")]
    assert ends == pytest.approx(20.0 + 100.0 * (0.1 + 0.9 * np.arange(1, 5) / 4), abs=0.3)
