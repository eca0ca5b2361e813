"""What holds for the pictures of every example: they are there, and their words are read as numbers of a print are.

Each is drawn once for all that is asked of it.
"""

import html
import re
from collections.abc import Iterator
from functools import reduce
from typing import NamedTuple

import pytest
from matplotlib.text import Text
from tests.example_runs import ran
from tests.words_on_paper import MILLIMETRE, assert_words_are_readable

import cranktrain as ct
from cranktrain import viz
from cranktrain.io.examples import example_names
from cranktrain.viz.pictures import drawing_of

POWER = re.compile(r"\d[eE][+\-−]?\d")
HYPHEN = re.compile(r"(?<![\w.)\]-])-\s?(?=[\d.])")
NUMBER = re.compile(r"(?<![\w.,/:])\d+\.\d+(?![\w.]|\s?°)")

MORE = {"plan brix-backward", "plan wittenbauer", "plan mertsalov"}
"""Tables with columns of angles, which have two decimals, and with speeds that four figures do not tell apart."""


class Drawn(NamedTuple):
    """An example: its result, and its pictures by name."""

    name: str
    result: ct.Result
    pictures: dict[str, object]


def pictures_of(result: ct.Result) -> Iterator[tuple[str, object]]:
    """Every picture that an example allows, drawn without further options, that of a start too, and its curves."""
    yield "plot", result.plot()
    machine = result.machines[0]
    for picture in viz.PICTURES:
        if picture.kind != "file":
            try:
                of = {"angles": lambda: machine, "cycle": lambda: result, "time": lambda: ct.start(machine)}
                yield f"{picture.kind} {picture.name}", drawing_of(picture)(of[picture.over]())
            except ct.InputError:
                continue


@pytest.fixture(scope="module", params=example_names())
def drawn(request):
    """All pictures of one example at a time: together they would fill the memory."""
    result = ran(request.param)
    return Drawn(request.param, result, dict(pictures_of(result)))


def words_of(figure) -> Iterator[tuple[str, bool]]:
    """Words as they are read, and whether they are of a scale; a formula sets its minus itself."""
    scales = [axis for axes in figure.axes for axis in (axes.xaxis, axes.yaxis)]
    ticks = {id(text) for axis in scales for text in axis.get_ticklabels()}
    for axis in scales:  # drawing would say it, and take half of the time
        axis.offsetText.set_text(axis.get_major_formatter().get_offset())
    for text in figure.findobj(Text):
        if text.get_visible():
            yield re.sub(r"\$[^$]*\$", "", text.get_text()), id(text) in ticks


def typed(machine) -> Iterator[str]:
    """What stands as it was typed: the name, and the speed."""
    yield machine.name
    yield from (one.text for one in (machine.main_shaft.speed, machine.main_shaft.acceleration) if one is not None)


def n_figures(number: str) -> int:
    """Figures of a number with decimals: `0.0520` has three, `0.00` none that count."""
    return len(number.replace(".", "").lstrip("0"))


def test_numbers_of_pictures(drawn):
    """Four figures, true minuses, no powers of ten."""
    seen, given = 0, list(typed(drawn.result.machines[0]))
    for picture, figure in drawn.pictures.items():
        for said, is_of_scale in words_of(figure):
            words = reduce(lambda left, one: left.replace(one, ""), given, said)
            seen += bool(re.search(r"\d", words))
            assert not POWER.search(words), (picture, words)
            assert not HYPHEN.search(words), (picture, words)
            if not is_of_scale and picture not in MORE:
                assert all(n_figures(number) <= 4 for number in NUMBER.findall(words)), (picture, words)
    assert seen > 50


def test_sheet_is_readable(drawn):
    sheet = drawn.pictures["sheet machine"]
    assert_words_are_readable(sheet)
    assert tuple(sheet.get_size_inches()) == pytest.approx((297 * MILLIMETRE, 210 * MILLIMETRE))


def curves(axes):
    """Lines over the crank angle, without the one at zero."""
    return [line for line in axes.lines if len(line.get_xdata()) > 2]


def test_every_example_shows_itself(drawn):
    """Its line, its page, its main curves, and beside another machine."""
    result = drawn.result
    assert len(repr(result)) < 200
    assert result.machines[0].name[:20] in html.unescape(result._repr_html_())
    assert all(curves(axes) for axes in drawn.pictures["plot"].axes)
    beside = ct.compare(result, ran("3d12" if drawn.name != "3d12" else "vaz_21213"))
    assert all(len(line) <= 80 for line in str(beside).splitlines())
    assert all(curves(axes) for axes in beside.plot().axes)
