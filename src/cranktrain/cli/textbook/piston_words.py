"""A piston or a valve in words."""

from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism


def called(place: PlacedMechanism) -> str:
    """Name a mechanism's slider: a piston, or the valve that an eccentric drives."""
    return _(place.kind.output.called).format(name=place.name)
