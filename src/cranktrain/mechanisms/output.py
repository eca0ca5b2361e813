"""What a mechanism's last part is to those who build it: a piston, a ram, a valve, a rocker; and the words for it."""

from dataclasses import replace
from typing import Final, Literal

from cranktrain.language import N_
from cranktrain.record import record


@record
class SliderWords:
    """What is said of a slider's motion; all translated where it is shown.

    Attributes
    ----------
    stroke : str
    top, after_top, bottom : str
        Where it turns back, farthest from the shaft and nearest to it, and from where the angle of that counts.
    mean_speed, largest_speed : str
        Mean speed of what carries a load alone.
    titles : tuple of str
        Of its travel, its velocity and its acceleration over the turn.
    forces : str
        Title of its forces, with {piston}.
    ends : tuple of str
        Marks where it turns back.
    """

    stroke: str
    top: str
    after_top: str
    bottom: str
    mean_speed: str
    largest_speed: str
    titles: tuple[str, str, str]
    forces: str
    ends: tuple[str, str]


@record
class OutputPart:
    """What the last part of a kind's mechanisms is.

    Attributes
    ----------
    part : "slider" or "rocker"
        What load and gas act on, by its name in the motion.
    called : str
        One of them, with {name}; translated where it is shown, as all its words are.
    counted : tuple of str
        One of them, and {n} of them.
    has_chambers : bool
        Whether it can work in a cylinder.
    is_loaded : bool
        Whether it carries a load, so that its mean speed, its acceleration and its rod's slope are asked for.
    words : SliderWords or None
        Of a slider.
    bare : OutputPart or None
        What one that can work in a cylinder is where there is none.
    """

    part: Literal["slider", "rocker"]
    called: str
    counted: tuple[str, str]
    has_chambers: bool = False
    is_loaded: bool = True
    words: SliderWords | None = None
    bare: "OutputPart | None" = None

    @property
    def is_slider(self) -> bool:
        """Whether it goes to and fro on a line, and does not rock."""
        return self.part == "slider"

    @property
    def rank(self) -> tuple[bool, bool, bool]:
        """In what order they are told: sliders first, of these what can work in a cylinder, last what has no load."""
        return not self.is_slider, not self.has_chambers, not self.is_loaded


_OF_RAM = SliderWords(
    stroke=N_("stroke"),
    top=N_("farthest from the shaft"),
    after_top=N_("{values} after the crank on its line"),
    bottom=N_("nearest to the shaft"),
    mean_speed=N_("mean speed"),
    largest_speed=N_("largest speed"),
    titles=(N_("Ram travel"), N_("Ram velocity"), N_("Ram acceleration")),
    forces=N_("Forces at ram {piston}"),
    ends=(N_("farthest"), N_("nearest")),
)

RAM: Final = OutputPart(
    part="slider",
    called=N_("ram {name}"),
    counted=(N_("1 ram"), N_("{n} rams")),
    words=_OF_RAM,
)
"""What works on something outside a cylinder, as a press's."""

PISTON: Final = OutputPart(
    part="slider",
    called=N_("piston {name}"),
    counted=(N_("1 piston"), N_("{n} pistons")),
    has_chambers=True,
    words=SliderWords(
        stroke=N_("stroke"),
        top=N_("true top dead centre"),
        after_top=N_("{values} after the crank on the axis"),
        bottom=N_("true bottom dead centre"),
        mean_speed=N_("mean piston speed"),
        largest_speed=N_("largest piston speed"),
        titles=(N_("Piston travel"), N_("Piston velocity"), N_("Piston acceleration")),
        forces=N_("Forces at piston {piston}"),
        ends=(N_("TDC"), N_("BDC")),
    ),
    bare=RAM,
)

VALVE: Final = OutputPart(
    part="slider",
    called=N_("valve {name}"),
    counted=(N_("1 valve"), N_("{n} valves")),
    is_loaded=False,
    words=replace(
        _OF_RAM,
        stroke=N_("valve travel"),
        largest_speed=N_("largest valve speed"),
        titles=(N_("Valve travel"), N_("Valve velocity"), N_("Valve acceleration")),
        forces=N_("Forces at valve {piston}"),
    ),
)
"""A slide valve or piston valve, which distributes and does not work."""

ROCKER: Final = OutputPart(part="rocker", called=N_("rocker {name}"), counted=(N_("1 rocker"), N_("{n} rockers")))
