"""Torque: on the shafts, along them, by order."""
