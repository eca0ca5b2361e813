"""What the gas does: its panels stand on the sheet of forces."""

from cranktrain.viz.picture import Picture

PICTURES: tuple[Picture, ...] = ()
