"""What a page asks of a machine, and what it is given, as processes hand it on: nothing here computes."""

from typing import Literal, NamedTuple, TypeAlias

Part: TypeAlias = Literal["page", "tab", "others", "trust", "members", "handles", "file", "export", "whence", "gallery"]
"""A machine with one tab open, a tab, the other pistons' curves on it, what is to be minded, pins and links and handles
of its drawing, the text of its file, a file to take away, where a number is from; machines to begin with."""

MOST_KEPT = 4
"""Machines of which what was computed is kept for what the same page asks next."""


class SentMachine(NamedTuple):
    """The text of a machine file, and names and texts of the files that it names."""

    text: str
    files: tuple[tuple[str, str], ...] = ()


class Case(NamedTuple):
    """A machine, and numbers set anew as `PATH=VALUE`; one that was not sent by the name of its file or example."""

    machine: str | SentMachine
    settings: tuple[str, ...] = ()


class ClickedPart(NamedTuple):
    """A part that is to be added to a mechanism by clicks on its drawing, as `added_table` takes it.

    Each click: the name of the pin or link that it took, none of the ground; X to the right and Y up. [m]
    """

    mechanism: str
    name: str
    angle: float
    clicks: tuple[tuple[str, float, float], ...]


class PageQuestion(NamedTuple):
    """Which part of a page is asked for, of which machine if of one, on the tab of which name, beside which saved case.

    key: of a table that is to stand in the machine file, too; of a quantity; how the name of a file to take away ends.
    part_added: that is to stand in the machine file, too.
    piston: whose throw and curves are shown. language: that of the surroundings unless given.
    """

    case: Case | None
    part: Part
    tab: str = ""
    beside: Case | None = None
    key: str = ""
    piston: str = ""
    language: str | None = None
    part_added: ClickedPart | None = None


class SweepQuestion(NamedTuple):
    """Facts of a machine over values of its file, as `cranktrain sweep --vary PATH=VALUES --wanted FACT` takes them.

    Attributes
    ----------
    case : Case
    vary : tuple of (str, str)
        Paths, each with its values.
    wanted : tuple of str
        Names of facts; the headlines where there are none.
    language : str or None
        That of the surroundings unless given.
    """

    case: Case
    vary: tuple[tuple[str, str], ...]
    wanted: tuple[str, ...]
    language: str | None = None


class HowFar(NamedTuple):
    """How many designs of a sweep are computed, of how many; 0 of what has not begun."""

    done: int = 0
    designs: int = 0


class Reply(NamedTuple):
    """What a browser is sent: the status of HTTP, what sort of content it is, and this."""

    status: int
    sort: str
    content: bytes
