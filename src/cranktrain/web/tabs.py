"""What stands on a tab of a page; and tabs beside those of the questions: of what is asked when somebody opens them."""

from collections.abc import Callable
from typing import NamedTuple

from cranktrain.analysis import Result
from cranktrain.errors import InputError
from cranktrain.language import Words
from cranktrain.motion import Array
from cranktrain.panels.parts import Notes
from cranktrain.panels.vectors import VectorsToScale
from cranktrain.record import record
from cranktrain.saying.row_table import WrittenGroup
from cranktrain.web.parts import PagePart, PageTable


@record
class PageSheet:
    """A sheet: its title, none of the only one of its tab, and its columns of parts."""

    title: Words
    columns: tuple[tuple[PagePart, ...], ...]


@record
class PagePace:
    """How fast time passes on a page: how much of it in a second of who looks, and what that is called."""

    rate: float
    words: Words


@record
class CourseWords:
    """Words of what turns the crank over time."""

    drawing: Words
    time: Words
    play: Words
    stop: Words
    back: Words
    on: Words
    keys: Words
    pace: Words


@record
class PageCourse:
    """Time that a tab is over, in which the crank turns.

    Attributes
    ----------
    unit : str
        Of all times, as the panels have it.
    time : Array, shape (n,)
        From the beginning to the end.
    crank_angle : Array, shape (n,)
        As shown, counted on through all turns. [deg]
    step : float
        By which a key goes on, of one figure.
    paces : tuple of PagePace
    at_first : int
        Place of the pace at which it is shown at first.
    words : CourseWords
    """

    unit: str
    time: Array
    crank_angle: Array
    step: float
    paces: tuple[PagePace, ...]
    at_first: int
    words: CourseWords


@record
class OtherCurve:
    """A curve of one or several of the other pistons, as it is seen: no number is read off it.

    Attributes
    ----------
    names : tuple of str
        Whose it is: all these have the same.
    symbol : str
        By which the legend names the chosen piston's; none where that has none.
    values : Array, shape (n,)
        In the unit of its panel.
    across : Array, shape (n,), optional
        Where it stands, unless with the panel.
    """

    names: tuple[str, ...]
    symbol: str
    values: Array
    across: Array | None


@record
class PageOthers:
    """Curves of the other pistons for each panel of each part of a tab that has curves, in their order."""

    parts: tuple[tuple[tuple[OtherCurve, ...], ...], ...]


@record
class TabContent:
    """What stands on a tab.

    Attributes
    ----------
    sentence : Words
        What of its rows says most; none where nothing can be said.
    answer : WrittenGroup
        Its rows.
    sheets : tuple of PageSheet
    beside : PageTable or None
        Its facts beside those of a saved case; None where nothing is beside.
    vectors : tuple of VectorsToScale
        For the drawing.
    course : PageCourse or None
        Time that it is over, in which the crank turns; None of what is over the crank angle.
    has_others : bool
        Whether it has curves of one piston of several, of which the others' may be asked for.
    others : PageOthers or None
        These, where nobody can be asked; None where they are not there.
    rests_on : Words
        What the sentence rests on; none where nothing is said.
    """

    sentence: Words
    answer: WrittenGroup
    sheets: tuple[PageSheet, ...]
    beside: PageTable | None = None
    vectors: tuple[VectorsToScale, ...] = ()
    course: PageCourse | None = None
    has_others: bool = False
    others: PageOthers | None = None
    rests_on: Words = ""


class AskedTab(NamedTuple):
    """A tab of what is no question of the cycle.

    Attributes
    ----------
    name : str
        Its title, not yet translated.
    is_there : callable
        Whether a machine has it, by its result; nothing is computed.
    content : callable
        Computes what stands on it.
    """

    name: str
    is_there: Callable[[Result], bool]
    content: Callable[[Result], TabContent]


def lacking_sheet(error: InputError) -> PageSheet:
    """Give a sheet that says what the file lacks."""
    return PageSheet("", ((Notes(tuple(str(problem) for problem in error.problems)),),))
