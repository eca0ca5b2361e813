"""Stephenson's link motion, to be drawn."""

from dataclasses import replace

from cranktrain.mechanisms.chain.drawing import chain_drawing
from cranktrain.mechanisms.chain.steps import Structure
from cranktrain.mechanisms.kind import Drawing, DrawnLink
from cranktrain.mechanisms.stephenson.kinematics import Stephenson, stephenson_size
from cranktrain.motion import Array


def stephenson_drawing(structure: Structure, angle: Array, geometry: Stephenson) -> Drawing:
    """As its chain, with the arm on the reverse shaft."""
    drawing = chain_drawing(structure, angle, stephenson_size(structure, geometry))
    return replace(drawing, links=(*drawing.links, DrawnLink("lifting_arm", ("reverse_shaft", "arm_end"))))
