"""What holds for the words of every picture of every example: four figures, true minuses, no powers of ten."""

import re
from collections.abc import Iterator
from functools import reduce

import pytest
from matplotlib.text import Text

import cranktrain as ct
from cranktrain import viz
from cranktrain.io.examples import example_names

POWER = re.compile(r"\d[eE][+\-−]?\d")
HYPHEN = re.compile(r"(?<![\w.)\]-])-\s?(?=[\d.])")
NUMBER = re.compile(r"(?<![\w.,/:])\d+\.\d+(?![\w.]|\s?°)")

MORE = {"plan brix-backward", "plan wittenbauer", "plan mertsalov"}
"""Tables with columns of angles, which have two decimals, and with speeds that four figures do not tell apart."""


def pictures_of(name: str) -> Iterator[tuple[str, object]]:
    """Every picture that an example allows, drawn without further options, that of a start too, and its curves."""
    result = ct.run(name)
    yield "plot", result.plot()
    for picture in viz.PICTURES:
        if picture.kind != "file":
            try:
                of = {"angles": lambda: result.machines[0], "cycle": lambda: result, "time": lambda: ct.start(name)}
                yield f"{picture.kind} {picture.name}", picture.function(of[picture.over]())
            except ct.InputError:
                continue


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


@pytest.mark.parametrize("name", example_names())
def test_numbers_of_pictures(name):
    machine, seen = ct.load(name), 0
    for picture, figure in pictures_of(name):
        for said, is_of_scale in words_of(figure):
            words = reduce(lambda left, given: left.replace(given, ""), typed(machine), said)
            seen += bool(re.search(r"\d", words))
            assert not POWER.search(words), (picture, words)
            assert not HYPHEN.search(words), (picture, words)
            if not is_of_scale and picture not in MORE:
                assert all(n_figures(number) <= 4 for number in NUMBER.findall(words)), (picture, words)
    assert seen > 50
