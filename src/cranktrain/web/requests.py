"""What other programs send to a service, with its limits."""

from collections.abc import Collection, Iterator
from typing import Annotated, TypedDict

from pydantic import BaseModel, Field

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import _, languages
from cranktrain.paths import parts_of
from cranktrain.web.asked import Case, ClickedPart, PageQuestion, Part, SentMachine, SweepQuestion

_MOST_SETTINGS, _LONGEST, _MOST_FILES = 100, 500, 20
_LONGEST_TEXT = 64_000
"""Characters of a machine file."""
_FARTHEST, _MOST_DEGREES, _MOST_CLICKS = 1e4, 1e6, 10
"""Of places that are clicked [m], and of crank angles."""

_FILE_KEY = "file"
"""Of tables of a machine file that name another."""

_Name = Annotated[str, Field(max_length=_LONGEST)]


class MachineAsked(BaseModel):
    """A machine, and numbers set anew."""

    machine: Annotated[
        str,
        Field(
            max_length=_LONGEST,
            description="Name of an example; empty for the served file, or beside `text`.",
            examples=["3d12"],
        ),
    ] = ""
    text: Annotated[
        str | None,
        Field(max_length=_LONGEST_TEXT, description="Text of a machine file, TOML, in place of a name."),
    ] = None
    files: Annotated[
        dict[_Name, str],
        Field(
            max_length=_MOST_FILES,
            description="Texts of the files that `text` names, by these names; nothing is read from a disk.",
        ),
    ] = {}
    settings: Annotated[
        list[_Name],
        Field(
            max_length=_MOST_SETTINGS,
            description="PATH=VALUE, of which the value is a number with its unit, or a word.",
            examples=[["shaft.main.speed=1800 rpm"]],
        ),
    ] = []


class ChoiceAsked(TypedDict, total=False):
    """What is chosen of a machine, as `PageQuestion` has it."""

    tab: str
    piston: str
    key: str
    part_added: ClickedPart | None


class CaseAsked(MachineAsked):
    """A machine, and in which language is said what there is to be said of it."""

    language: Annotated[
        str, Field(max_length=_LONGEST, description="One that there is; that of the service unless given.")
    ] = ""

    @property
    def choice(self) -> ChoiceAsked:
        """What of the machine is asked for."""
        return {}


class ThrowAsked(CaseAsked):
    """A machine, and which of its throws is shown."""

    piston: Annotated[_Name, Field(description="Whose throw and curves; the first's where there is none of it.")] = ""

    @property
    def choice(self) -> ChoiceAsked:
        """What of the machine is asked for."""
        return {"piston": self.piston}


class PageAsked(ThrowAsked):
    """A machine, and which tab is open."""

    tab: Annotated[_Name, Field(description="By its name; the first where there is none of it.")] = ""
    beside: Annotated[MachineAsked | None, Field(description="A saved case that stands beside it.")] = None

    @property
    def choice(self) -> ChoiceAsked:
        """What of the machine is asked for."""
        return {"piston": self.piston, "tab": self.tab}


_Metres = Annotated[float, Field(ge=-_FARTHEST, le=_FARTHEST, allow_inf_nan=False)]


class ClickAsked(BaseModel):
    """A click on the drawing: what it took, and where."""

    name: Annotated[_Name, Field(description="Of the pin or link that it took; empty for the ground.")] = ""
    right: Annotated[_Metres, Field(description="From the main shaft to the right, m.")]
    up: Annotated[_Metres, Field(description="From the main shaft upward, m.")]


class AdditionAsked(BaseModel):
    """A part that is to be added to a mechanism by clicks, of those that `/api/handles` names."""

    mechanism: Annotated[_Name, Field(description="To which it is added, by its name.")]
    name: Annotated[_Name, Field(description="Of the part.", examples=["pair"])]
    angle: Annotated[
        float, Field(ge=-_MOST_DEGREES, le=_MOST_DEGREES, allow_inf_nan=False, description="Crank angle shown, °.")
    ]
    clicks: Annotated[list[ClickAsked], Field(max_length=_MOST_CLICKS)]

    @property
    def part(self) -> ClickedPart:
        """The part as it is handed on."""
        clicks = tuple((one.name, one.right, one.up) for one in self.clicks)
        return ClickedPart(self.mechanism, self.name, self.angle, clicks)


class FileAsked(CaseAsked):
    """A machine file, and whether another table or part is to stand in it."""

    key: Annotated[
        _Name, Field(description="Of one of the tables that are offered to the machine; none unless given.")
    ] = ""
    addition: Annotated[
        AdditionAsked | None, Field(description="A part that is added by clicks; none unless given.")
    ] = None

    @property
    def choice(self) -> ChoiceAsked:
        """What of the machine is asked for."""
        return {"key": self.key, "part_added": None if self.addition is None else self.addition.part}


class ExportAsked(CaseAsked):
    """A machine, and what is to be taken away of it."""

    tab: Annotated[_Name, Field(description="Of which a sheet is drawn; the machine's where it has none.")] = ""
    suffix: Annotated[_Name, Field(description="How the file's name ends.", examples=[".xlsx"])]

    @property
    def choice(self) -> ChoiceAsked:
        """What of the machine is asked for."""
        return {"tab": self.tab, "key": self.suffix}


class WhenceAsked(CaseAsked):
    """A machine, and a number of it."""

    quantity: Annotated[_Name, Field(description="Its name in results.", examples=["largest_side_force"])]

    @property
    def choice(self) -> ChoiceAsked:
        """What of the machine is asked for."""
        return {"key": self.quantity}


class SweepAsked(CaseAsked):
    """A machine, and what of it is varied."""

    vary: Annotated[
        dict[_Name, _Name],
        Field(
            min_length=1,
            max_length=2,
            description="Paths, each with its values: a range FROM..TO:COUNT, or several with commas between.",
            examples=[{"mechanism.rod_length": "130..160 mm:31"}],
        ),
    ]
    wanted: Annotated[
        list[_Name],
        Field(max_length=4, description="Names of facts; the headlines where there are none.", examples=[["stroke"]]),
    ] = []


class SweepTaken(BaseModel):
    """A sweep that is computed."""

    number: Annotated[str, Field(description="By which it is asked for.")]


class SweepGoing(BaseModel):
    """How far a sweep is."""

    done: int
    designs: Annotated[int, Field(description="0 as long as it has not begun.")]


class ExampleNamed(BaseModel):
    """An example by its name."""

    name: str


def question_of(asked: CaseAsked, part: Part, known: Collection[str], served: str | None) -> PageQuestion:
    """Find what is meant: what is sent never becomes the name of a file.

    Parameters
    ----------
    asked : CaseAsked
    part : str
    known : collection of str
        Names of examples.
    served : str or None
        The machine file that is meant where none is named.

    Returns
    -------
    PageQuestion

    Raises
    ------
    InputError
        Where no machine or language is meant that there is, or a setting would have a file read.
    """
    case, language = _case_of(asked, known, served), _language_of(asked)
    saved = asked.beside if isinstance(asked, PageAsked) else None
    beside = None if saved is None else _case_of(saved, known, served)
    return PageQuestion(case, part, beside=beside, language=language, **asked.choice)


def sweep_of(asked: SweepAsked, known: Collection[str], served: str | None) -> SweepQuestion:
    """Find what is meant; as `question_of`."""
    refuse(_naming_files([f"{path}={values}" for path, values in asked.vary.items()]))
    case, language = _case_of(asked, known, served), _language_of(asked)
    return SweepQuestion(case, tuple(asked.vary.items()), tuple(asked.wanted), language)


def _language_of(asked: CaseAsked) -> str | None:
    """Find a language, if one is named."""
    if asked.language not in ("", *languages()):
        allowed = _("must be one of the languages: {names}", names=", ".join(languages()))
        raise InputError([Problem("language", asked.language, allowed)])
    return asked.language or None


def _case_of(asked: MachineAsked, known: Collection[str], served: str | None) -> Case:
    """Find a machine; as `question_of`."""
    refuse((*_naming_files(asked.settings), *_beside_each_other(asked)))
    if asked.text is not None:
        return Case(SentMachine(asked.text, tuple(sorted(asked.files.items()))), tuple(asked.settings))
    source = asked.machine if asked.machine in known else served if not asked.machine else None
    if source is None:
        allowed = _("must be one of the examples: {names}", names=", ".join(sorted(known)))
        raise InputError([Problem("machine", asked.machine, allowed)])
    return Case(source, tuple(asked.settings))


def _beside_each_other(asked: MachineAsked) -> Iterator[Problem]:
    """Refuse two machines, and files of a machine that was not sent."""
    if asked.text is not None and asked.machine:
        yield Problem("machine", asked.machine, _("must not stand beside the text of another"))
    if asked.text is None and asked.files:
        yield Problem("files", None, _("are for a machine that is sent as text"))


def _naming_files(settings: Collection[str]) -> Iterator[Problem]:
    """Refuse what would have a file read: a key that names one, or a table in which such a key may stand."""
    for setting in settings:
        path, _equals, value = setting.partition("=")
        if _FILE_KEY in parts_of(path.strip()) or "{" in value:
            yield Problem(path, None, _("may be a number or a word here, and no file or table"))
