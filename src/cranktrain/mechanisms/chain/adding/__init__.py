"""Parts that are added to a chain by clicks on its drawing: each family says what it asks for, and makes its part."""

from cranktrain.mechanisms.chain.adding.links import LINKS
from cranktrain.mechanisms.chain.adding.points import POINTS
from cranktrain.mechanisms.chain.adding.sliders import SLIDERS
from cranktrain.mechanisms.chain.adding.triads import TRIADS

__all__ = ["ADDITIONS"]

ADDITIONS = (*POINTS, *LINKS, *SLIDERS, *TRIADS)
"""What may be added to a chain, the simplest first."""
