"""Stephenson's link motion, to be drawn."""

from dataclasses import replace

from cranktrain.mechanisms.chain.drawing import chain_drawing
from cranktrain.mechanisms.chain.steps import Structure
from cranktrain.mechanisms.drawing import Drawing, DrawnLink
from cranktrain.mechanisms.stephenson.kinematics import Stephenson, stephenson_size
from cranktrain.motion import Array


def stephenson_drawing(structure: Structure, angle: Array, geometry: Stephenson) -> Drawing:
    """As its chain, with the arm on the reverse shaft, and without the slot's centre, where nothing is."""
    drawing = chain_drawing(structure, angle, stephenson_size(structure, geometry))
    links = [
        DrawnLink(link.name, tuple(pin for pin in link.pins if pin != "centre"))
        for link in drawing.links
        if link.name != "slot"
    ]
    n_cranks = len(structure.cranks)
    return replace(
        drawing,
        pins={name: place for name, place in drawing.pins.items() if name != "centre"},
        links=(*links[:n_cranks], DrawnLink("lifting_arm", ("reverse_shaft", "arm_end")), *links[n_cranks:]),
        fixed=tuple(name for name in drawing.fixed if name != "arm_end"),
        paths=tuple(name for name in drawing.paths if name != "centre"),
    )
