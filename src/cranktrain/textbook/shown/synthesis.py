"""What the text on the synthesis makes of its requirements and of others, beside what is right."""

from collections.abc import Iterator, Mapping, Sequence

from cranktrain.grouping import grouped
from cranktrain.language import N_, Words, _
from cranktrain.saying.sections import Column, Decimals, Grid, Part, Rows, ShownSection
from cranktrain.saying.wording import FigureOf, UnitOf
from cranktrain.synthesis.proposal import quantity_text
from cranktrain.textbook.shown.tables import EXACT
from cranktrain.textbook.statements import Statement, Statements
from cranktrain.textbook.synthesis_statements import PLACE, SOURCE, VELOCITY, synthesis
from cranktrain.texts.slider_crank_synthesis import REQUIREMENTS

SOURCE_EXAMPLE = {
    "stroke": quantity_text(REQUIREMENTS.stroke, "mm"),
    "pressure_angle": quantity_text(REQUIREMENTS.pressure_angle, "deg"),
    "mean_speed": f"{REQUIREMENTS.mean_speed} m/s",
}
"""What the source wants, as it would be typed."""

_NEEDED = ("stroke", "mean_speed", "pressure_angle")
_NOT_ITS_OWN = ("offset", "return_pressure_angle")
_SHOWN = {"m": "mm", "rad": "deg"}
_VELOCITIES = N_("Its velocities")


def source_requirements() -> Words:
    """Say what the source's example wants."""
    wanted = _(
        "stroke {stroke}, mean slider speed {speed}, permissible pressure angle {angle}",
        stroke=SOURCE_EXAMPLE["stroke"],
        speed=SOURCE_EXAMPLE["mean_speed"],
        angle=SOURCE_EXAMPLE["pressure_angle"],
    )
    return _("Its example: {requirements}.", requirements=wanted)


def source_velocities() -> ShownSection:
    """Give the source's table of velocities, and the same columns as they should be."""
    found = synthesis()
    by_name = grouped((one.words, one) for one in found if one.symbol == "v" and one.at == "at")
    first = next(iter(by_name.values()))
    values = {**{name: [one.value for one in each] for name, each in by_name.items()}, _(EXACT): _exact(first)}
    columns = [Column(head, each, how=Decimals(3)) for head, each in values.items()]
    parts = (Grid(columns, _angles(first)), "", *found.sentences[_(_VELOCITIES)])
    return ShownSection(_("Its table of slider velocities, m/s"), parts)


def step_sections(typed: Mapping[str, str | bool | None]) -> Iterator[ShownSection]:
    """Give the text's steps with the requirements that are typed, or say why they are not its own."""
    heading = _("Its steps with these requirements [{source}]", source=SOURCE)
    given = {name: value for name in (*_NEEDED, "rod_length") if isinstance(value := typed.get(name), str)}
    if unlike := tuple(_unlike(typed, given)):
        yield ShownSection(heading, unlike)
        return
    found = synthesis(**given)
    yield ShownSection(heading, (_sizes(found),))
    yield ShownSection(_("Place and velocity of the slider"), tuple(_over_the_turn(found)))


def _unlike(typed: Mapping[str, str | bool | None], given: Mapping[str, str]) -> Iterator[Words]:
    """Say of what the text does not speak, and what it needs besides."""
    if lacking := [name for name in _NEEDED if name not in given]:
        yield _(
            "It starts from a stroke, a mean speed and a pressure angle; {options}: not given.",
            options=_options(lacking),
        )
    if others := [name for name in _NOT_ITS_OWN if typed.get(name)]:
        yield _(
            "It has a central slider-crank with one pressure angle both ways, and nothing of {options}.",
            options=_options(others),
        )


def _options(names: Sequence[str]) -> str:
    """Give requirements as they are typed."""
    return ", ".join(f"--{name.replace('_', '-')}" for name in names)


def _sizes(found: Statements) -> Rows:
    """Each number by the text, and what is right where that differs."""
    cells: list[tuple[Words, ...]] = []
    for one in found:
        if one.equation and one.at != "at":
            unit = _SHOWN.get(one.unit, one.unit)
            right = "" if one.verdict == "right" else FigureOf(one.exact, unit)
            cells.append((one.equation, one.words, one.symbol, FigureOf(one.value, unit), right, UnitOf(unit)))
    return Rows(cells, ("", "", "", _("gives"), _("right"), ""), right=(3, 4), is_folded=False)


def _over_the_turn(found: Statements) -> Iterator[Part]:
    """Places and velocities by the text, each beside the exact one."""
    by_symbol = grouped((one.symbol, one) for one in found if one.equation in (PLACE, VELOCITY))
    columns: list[Column] = []
    for symbol, name in (("x", _("x as printed")), ("v", _("v by its formula"))):
        own = by_symbol[symbol]
        columns.append(Column(name, [one.value for one in own], own[0].unit, Decimals(4)))
        columns.append(Column(_("{symbol} exact", symbol=symbol), _exact(own), own[0].unit, Decimals(4)))
    yield Grid(columns, _angles(by_symbol["x"]))
    yield ""
    yield _("{equation} prints no root: an area in numbers of m² is added to a length.", equation=PLACE)
    yield from found.sentences[_(_VELOCITIES)]


def _exact(each: Sequence[Statement]) -> list[float]:
    return [one.exact for one in each]


def _angles(each: Sequence[Statement]) -> list[str]:
    return [f"{one.crank_angle:.0f}°" for one in each]
