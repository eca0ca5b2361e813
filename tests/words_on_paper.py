"""The words of a picture: where they are, and that they can be read."""

from functools import cache
from weakref import WeakKeyDictionary

import numpy as np
from matplotlib.backends.backend_agg import RendererAgg
from matplotlib.text import Text

MILLIMETRE = 1 / 25.4

_LAID_OUT = WeakKeyDictionary()


@cache
def _measuring(dots_per_inch):
    """What measures the words of all pictures, and keeps what each of them takes."""
    return RendererAgg(16, 16, dots_per_inch)


def words_of(figure):
    """All words of a picture with their boxes in dots: it is laid out once, and nothing is painted."""
    return laid_out(figure)[0]


def laid_out(figure):
    """Those words, and the smallest size of letters. [points]"""
    if figure not in _LAID_OUT:
        measuring = _measuring(figure.dpi)
        lay_out(figure, measuring)
        beyond = set(map(id, labels_beyond(figure)))
        texts = [text for text in figure.findobj(Text) if text.get_text()]
        found = [text for text in texts if text.get_visible() and text.get_text().strip() and id(text) not in beyond]
        words = [(text.get_text(), text.get_window_extent(measuring)) for text in found]
        _LAID_OUT[figure] = words, min(text.get_fontsize() for text in texts)
    return _LAID_OUT[figure]


def lay_out(figure, measuring):
    """Give words their places as drawing does: on our paper those of scales alone have none before."""
    if figure.get_layout_engine() is not None:
        figure.draw_without_rendering()
        return
    assert not figure.legends
    for axes in figure.axes:
        assert axes.get_legend() is None and not axes.get_title() and axes.get_aspect() == "auto"
        for axis in (axes.xaxis, axes.yaxis) if axes.axison else ():
            axis.get_tightbbox(measuring)


def labels_beyond(figure):
    """Labels of ticks that are not on their axis, which are not drawn."""
    return [
        label
        for axes in figure.axes
        if axes.axison
        for labels, (low, high), i in (
            (axes.get_xticklabels(), axes.get_xlim(), 0),
            (axes.get_yticklabels(), axes.get_ylim(), 1),
        )
        for label in labels
        if not low <= label.get_position()[i] <= high
    ]


def assert_words_are_readable(figure):
    """No words over others, none outside the paper, none smaller than 8 points."""
    words, smallest = laid_out(figure)
    width, height = figure.get_size_inches() * figure.dpi
    x0, y0, x1, y1 = np.array([box.extents for _text, box in words]).T
    inside = (x0 > 0) & (y0 > 0) & (x1 < width) & (y1 < height)
    assert [words[i][0] for i in np.flatnonzero(~inside)] == [], "leave the paper"
    common_x = np.minimum.outer(x1, x1) - np.maximum.outer(x0, x0)
    common_y = np.minimum.outer(y1, y1) - np.maximum.outer(y0, y0)
    dot = 0.3 * MILLIMETRE * figure.dpi
    over = np.argwhere(np.triu((common_x > dot) & (common_y > dot), k=1))
    assert [(words[one][0], words[other][0]) for one, other in over] == []
    assert smallest >= 8.0
