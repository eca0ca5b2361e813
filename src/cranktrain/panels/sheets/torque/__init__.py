"""Which torque comes out: its panels, orders and phase stars stand on the sheet of forces."""

from cranktrain.panels.picture import Picture

PICTURES: tuple[Picture, ...] = ()
