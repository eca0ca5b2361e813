"""What the gas does: its panels stand on the sheet of forces."""

from cranktrain.panels.picture import Picture

PICTURES: tuple[Picture, ...] = ()
