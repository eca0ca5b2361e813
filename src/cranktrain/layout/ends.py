"""The two pistons of an opposed-piston cylinder, by what they control."""

ENDS = ("exhaust", "scavenge")
"""The exhaust piston first: its crank is the one that leads."""
