"""What the groups of a chain make, by name."""

from typing import Any, TypeAlias

from cranktrain.motion import Coefficient, Link, Point

SHAFT = "O"
"""Name of the shaft's centre."""

Part: TypeAlias = Point | Link | Coefficient
"""A point, a link or a slider."""

Made: TypeAlias = dict[str, Any]
"""Each `Part` by its name, which says what it is."""


def pin_of(name: str) -> str:
    """Name of the point that a crank or a slider gives."""
    return f"{name}.pin"


def slot_of(slider: str) -> str:
    """Name of what slides in the slot that drives a slider, or that it drives."""
    return f"{slider}.slot"
