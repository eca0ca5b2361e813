"""Letters for pins whose names are too long to stand beside them, as a drawing office gives them."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from cranktrain.mechanisms.drawing import Drawing
from cranktrain.plans.vectors import spoken_name

_LONGEST = 5
"""Letters of a name that stands beside its pin as it is."""

_LETTERS = "ABCDEFGHJKLMNQRSTUVWXYZ"
"""Without O, which is the shaft's, and P, which is the pole's and the instant centres'."""


def pin_letters(drawing: Drawing) -> dict[str, str]:
    """Give a letter to every pin of a drawing that has long names, in its own order; none where all are short.

    Examples
    --------
    >>> from cranktrain.machine import Machine
    >>> pump = Machine(mechanism={"kind": "slider_crank", "stroke": "80 mm", "rod_length": "136 mm"})
    >>> pin_letters(pump.places[0].kind.drawing(0.0, pump.places[0].geometry))
    {}
    """
    spoken = {name: spoken_name(name) for name in drawing.pins if name not in drawing.ends}
    if all(len(said) <= _LONGEST and "_" not in said for said in spoken.values()):
        return {}
    short = {said for said in spoken.values() if len(said) == 1}
    free = [letter for letter in _LETTERS if letter not in short]
    long = [name for name, said in spoken.items() if said not in short]
    return dict(zip(long, free, strict=False))


def renamed(drawing: Drawing, letters: Mapping[str, str]) -> Drawing:
    """Give a drawing with its pins called by their letters."""

    def of(names: Sequence[str]) -> tuple[str, ...]:
        return tuple(letters.get(name, name) for name in names)

    return replace(
        drawing,
        pins=dict(zip(of(tuple(drawing.pins)), drawing.pins.values(), strict=True)),
        links=[link._replace(pins=of(link.pins)) for link in drawing.links],
        guides=[guide._replace(pin=of((guide.pin,))[0]) for guide in drawing.guides],
        fixed=of(drawing.fixed),
        paths=of(drawing.paths),
        blocks=[block._replace(pin=of((block.pin,))[0], link=of(block.link)) for block in drawing.blocks],
        ends=of(drawing.ends),
        points=of(drawing.points),
    )


def lettered(drawing: Drawing) -> Drawing:
    """Give a drawing with letters for long names."""
    return renamed(drawing, pin_letters(drawing))
